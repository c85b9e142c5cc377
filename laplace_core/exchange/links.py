"""A page's link: one way to state what it may hold, one reader, one writer.

A page hands over a :class:`Schema`. Its steps are taken in their order; each of them either takes entries out of the
link (:class:`Entries`) or tests the values read so far (:class:`Check`). So a later step may depend on an earlier
one: the checkpoint decides which components an observation has, and an agent that cannot be opened ends the reading.
Nothing in a link is trusted: what does not hold is left out, with one sentence that says so.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from fnmatch import fnmatchcase
from typing import Any

from laplace_core.errors import InputError
from laplace_core.parameters import Parameter, as_text, parse_named

Values = dict[str, Any]
"""What is set by hand on a page, by name. What is not among them follows the world or the agent."""
Known = Mapping[str, Parameter]

LEFT_OUT = "Left out of the link: "
_UNKNOWN = "The link has an entry {!r} that this page does not know."
LONGEST = 7_000
"""Characters of a link's values; proxies and chat programs cut much longer ones off."""
_MOST_QUOTED = 40  # characters of a name that a note repeats


def by_name(*parameters: Parameter) -> dict[str, Parameter]:
    return {parameter.name: parameter for parameter in parameters}


@dataclass(frozen=True)
class Old:
    """An entry as an older version wrote it.

    Attributes:
        now: its name today; None if it never did anything.
        words: the words of today by those of then; a word that is not among them is the same.
    """

    name: str
    now: str | None
    words: Mapping[str, str] = field(default_factory=dict)


@dataclass(frozen=True)
class Entries:
    """Entries that a link may hold.

    Attributes:
        known: their parameters, by the name without the prefix; a function where they depend on what was read before.
        prefix: what their names begin with, such as ``p.``.
        owner: whose they are. A name with the prefix that is not among them is then said to be no parameter of its
            owner; without an owner it means nothing on this page.
    """

    known: Known | Callable[[Values], Known]
    prefix: str = ""
    owner: Callable[[Values], str] | None = None

    def take(self, query: Mapping[str, str], values: Values) -> tuple[Values, list[str], set[str]]:
        """Values of the entries that are known here, notes about those that do not hold, and the names of both."""
        known = self.known(values) if callable(self.known) else self.known
        taken, notes, names = {}, [], set()
        for name, text in query.items():
            bare = name.removeprefix(self.prefix)
            if not name.startswith(self.prefix) or (self.owner is None and bare not in known):
                continue
            names.add(name)
            try:
                if self.owner is not None:
                    taken[name] = parse_named(self.owner(values), tuple(known.values()), {bare: text})[bare]
                else:
                    taken[name] = known[bare].parse(text)
            except InputError as error:
                notes.append(f"{LEFT_OUT}{error}")
        return taken, notes, names


@dataclass(frozen=True)
class Check:
    """Something that has to hold of the values that were read so far.

    Attributes:
        test: raises InputError, with one sentence, where it does not hold.
        drops: names that are left out then, ``p.*`` for all that begin so. Without any, the whole link is given up and
            the page shows its opening view.
        lead: what the sentence of a note begins with.
    """

    test: Callable[[Values], object]
    drops: tuple[str, ...] = ()
    lead: str = LEFT_OUT


def check_of(name: str, test: Callable[[str], object], drops: tuple[str, ...] = (), lead: str = LEFT_OUT) -> Check:
    """A check of one value, where there is one."""
    return Check(lambda values: test(str(values[name])) if name in values else None, drops, lead)


@dataclass(frozen=True)
class Schema:
    """The entries that the link of a page may hold.

    Attributes:
        opening: the values of the page without a link.
        steps: of the reading, in their order.
        assumed: values that a link means if it does not name them; by default those of the opening view.
        old: how older versions wrote some entries.
    """

    opening: Callable[[], Mapping[str, Any]]
    steps: tuple[Entries | Check, ...]
    assumed: Callable[[], Mapping[str, Any]] | None = None
    old: tuple[Old, ...] = ()

    def read(self, query: Mapping[str, str]) -> tuple[Values, list[str]]:
        """The values that hold, in the order of the link, and a note about every entry that does not."""
        query = self._translated(query)
        values, left = dict((self.assumed or self.opening)()), dict(query)
        notes: list[str] = []
        last = max(place for place, step in enumerate(self.steps) if isinstance(step, Entries))
        for place, step in enumerate(self.steps):
            if isinstance(step, Entries):
                taken, refused, names = step.take(left, values)
                left = {name: text for name, text in left.items() if name not in names}
                values |= taken
                notes += refused
                if place == last:
                    notes += [_UNKNOWN.format(name[:_MOST_QUOTED]) for name in left]
                continue
            try:
                step.test(values)
            except InputError as error:
                notes.append(f"{step.lead}{error}")
                if not step.drops:
                    return dict(self.opening()), notes
                for pattern in step.drops:
                    values = {name: value for name, value in values.items() if not fnmatchcase(name, pattern)}
        order = {name: place for place, name in enumerate(query)}
        return {name: values[name] for name in sorted(values, key=lambda name: order.get(name, -1))}, notes

    def _translated(self, query: Mapping[str, str]) -> dict[str, str]:
        """A link as it is written today; where it has an entry under both names, that of today counts."""
        translated, old = {}, {each.name: each for each in self.old}
        for name, text in query.items():
            each = old.get(name, Old(name, name))
            if each.now is not None and (each.now == name or each.now not in query):
                translated[each.now] = each.words.get(text, text)
        return translated


def query_of(values: Mapping[str, Any]) -> dict[str, str]:
    """Values as a link writes them; :meth:`Schema.read` reads them back."""
    return {name: as_text(value) for name, value in values.items()}


def fits(query: Mapping[str, str]) -> bool:
    """Whether a link can hold these entries."""
    return sum(map(len, query.values())) <= LONGEST
