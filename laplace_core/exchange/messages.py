"""Messages to a component in the browser: a small JSON with every answer, and each payload once.

What is seen has two owners, the server and the hand in the browser, and this is how they keep from undoing each other:

1. **Payloads.** A message names its payload, and carries it only where the browser does not hold it. The browser keeps
   the last few (``HELD`` in ``lens/models.js`` and ``cursor/cursor.js``), and :attr:`Channel.held` mirrors which. Where
   the two differ, after a reload say, the browser answers ``missing``; then Python forgets what it believed and sends
   the payload with its next message. Streamlit keeps only the last answer that the server has not read yet, so this
   one repeats the released state of rule 3.
2. **Revisions.** A message has a revision. A component takes over the state of a message only if the revision differs
   from that of the last message; otherwise it keeps the state on its screen, which the user may have changed since.
3. **Releases.** When a control is released, the browser reports the state. Python takes it over
   (:meth:`Channel.release`) and does not raise the revision for it: the browser has it already. A state that Python
   itself sets (a remedy, Back, another step) differs from what was released or sent last, and raises the revision.
   A release names the revision that the browser was at. Where Python has raised it meanwhile, the hand has changed a
   state that it did not see yet: Python takes over what the hand changed, leaves the rest, and sends the result.
4. **Mounting again.** A component may be taken off a page and put back with its last message. The lens
   therefore remembers in the browser the last released state with its revision (``released`` in ``lens/entry.js``),
   whatever its payload, so that its message need not change with a release (:meth:`Channel.show`). The message of a
   cursor always holds the step that Python knows (:meth:`Channel.place`); a step that it does not know yet is
   remembered under the same payload and revision (``latest`` in ``cursor/cursor.js``).
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

_DIGITS = 16
_REVISIONS = 8  # to which a release may still belong


def name_of(data: bytes) -> str:
    """The name of a payload in the browser."""
    return hashlib.sha256(data).hexdigest()[:_DIGITS]


@dataclass
class Channel:
    """Python's record of one component in one browser, by the protocol of :mod:`laplace_core.exchange.messages`.

    Attributes:
        revision: of the last message.
        held: names of the payloads that the browser holds, the last one used first.
        payload: name of the payload of the last message.
        sent: the state of the last message.
        shown: what the browser showed last at the latest revisions before this one, by revision.
        released: the state that a person has released since; None if there is none, or the server has set another one
            after it.
    """

    revision: int = 0
    held: list[str] = field(default_factory=list)
    payload: str | None = None
    sent: Any = None
    shown: dict[int, Any] = field(default_factory=dict)
    released: Any = None

    def show(self, payload: str, state: Mapping[str, Any]) -> dict[str, Any]:
        """The state to send to the lens, which keeps its place beside another payload: only a state moves it."""
        if self._on_screen != dict(state):
            self._raise()
        if payload != self.payload or self.released is None:
            self.payload, self.sent = payload, dict(state)
        sent: dict[str, Any] = self.sent
        return sent

    def place(self, payload: str, step: int) -> None:
        """This step is sent to a cursor, which another payload puts there as well."""
        if payload != self.payload or step != self._on_screen:
            self._raise()
        self.payload, self.sent, self.released = payload, step, None

    def release(self, state: Any, revision: object) -> Any:
        """A control was released at this state; returns the state that this leads to.

        Args:
            revision: that the browser was at, by its answer.
        """
        if revision == self.revision:
            self.released = state
            return state
        self.released = None  # the browser shows what it was sent, and not what this leads to
        if not isinstance(self.sent, Mapping) or not isinstance(state, Mapping):
            return state
        before = (self.shown.get(revision) if isinstance(revision, int) else None) or {}
        by_hand = {name: value for name, value in state.items() if name not in before or value != before[name]}
        return {**self.sent, **by_hand}

    @property
    def _on_screen(self) -> Any:
        return self.sent if self.released is None else self.released

    def _raise(self) -> None:
        self.shown[self.revision] = self._on_screen
        self.shown.pop(self.revision - _REVISIONS, None)
        self.revision, self.released = self.revision + 1, None

    def answered(self, answer: Mapping[str, Any], most: int) -> bool:
        """Note which payload the browser holds, by its answer; whether it holds the one that it was sent last.

        Args:
            answer: with the ``id`` of the payload that it is about, which may be older than the last message, or with
                the ``missing`` one.
            most: payloads that the browser keeps.
        """
        if "missing" in answer:
            self.held = []
            return False
        name = answer.get("id")
        if isinstance(name, str) and len(name) == _DIGITS:
            self.held = [name, *(each for each in self.held if each != name)][:most]
        return True

    def due(self, name: str, data: bytes) -> bytes:
        """The payload, if it has to be sent."""
        return b"" if name in self.held else data
