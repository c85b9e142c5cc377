"""Rollouts in the making and those made last: one cache for all sessions of this server."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from app.components.player.payload import payload
from app.session.background import Told, Work
from app.session.shelf import Shelf
from laplace_core.acting.return_laws import outputs_along
from laplace_core.acting.rollout import Rollout, longest, roll_out
from laplace_core.environments import GYMNASIUM_ENVIRONMENTS
from laplace_core.training.checkpoint import Loaded

MOST_KEPT, MOST_BYTES = 16, 200_000_000
"""Rollouts, and their memory together; the one that is asked for stays whatever its size, some 90 MB at the most."""


@dataclass(frozen=True)
class Control:
    """How an episode is acted; see :func:`laplace_core.acting.rollout.roll_out`."""

    seed: int = 0
    rule: str = "greedy"
    horizon: int | None = None
    gamma: float | None = None


class Rolling(Work[tuple[Rollout, bytes, dict[str, np.ndarray]]]):
    """One rollout, the same packed for the player, and what a peer said on its way."""

    def __init__(self, loaded: Loaded, control: Control):
        pictures = loaded.environment in GYMNASIUM_ENVIRONMENTS
        c = self.control = control

        def make(told: Told) -> tuple[Rollout, bytes, dict[str, np.ndarray]]:
            found = roll_out(
                loaded.agent,
                loaded.environment,
                c.seed,
                rule=c.rule,
                horizon=c.horizon,
                gamma=c.gamma,
                pictures=pictures,
                progress=told,
            )
            said = {} if found.spaces is not None else outputs_along(loaded.agent, found)
            return found, payload(found, said), said

        super().__init__(make)

    def rollout(self) -> Rollout:
        """What came of it.

        Raises:
            InputError: as of :meth:`result`.
        """
        return self.result()[0]

    def packed(self) -> bytes:
        return self.result()[1]

    def said(self) -> dict[str, np.ndarray]:
        """See :func:`laplace_core.acting.return_laws.outputs_along`."""
        return self.result()[2]

    @property
    def bytes(self) -> int:
        """Memory that it holds; nothing before it is done."""
        if not self.worked:
            return 0
        return self.rollout().bytes + len(self.packed()) + sum(array.nbytes for array in self.said().values())


def _too_large(kept: list[Rolling]) -> bool:
    return sum(one.bytes for one in kept) > MOST_BYTES


_kept: Shelf[Rolling] = Shelf(MOST_KEPT, _too_large)


def rolling(loaded: Loaded, control: Control) -> Rolling:
    """The rollout of an agent under a control: the one there is, or a new one; the oldest makes room."""
    return _kept.take((loaded.agent, control), lambda: Rolling(loaded, control))


def most_steps(loaded: Loaded) -> int:
    """The longest horizon that can be asked for."""
    return longest(loaded.agent)
