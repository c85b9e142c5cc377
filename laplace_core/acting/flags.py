"""The artefacts of each step of a rollout, in the tau-space of the action that was taken."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from laplace_core.acting.rollout import Rollout
from laplace_core.code.interpolation import with_added
from laplace_core.study.artefacts import LISTED, find_artefacts
from laplace_core.study.pipeline import study_of_gamma_space
from laplace_core.study.settings import Settings


@dataclass(frozen=True, eq=False)
class Flags:
    """Artefacts by name, each with the steps that have it.

    Attributes:
        names: of the artefacts that any step has, the gravest kinds first.
        marks: bool ``(N, len(names))``.
    """

    names: tuple[str, ...]
    marks: np.ndarray

    @property
    def begins(self) -> np.ndarray:
        """``(N,)``: steps with an artefact that the step before has not."""
        before = np.vstack([np.zeros_like(self.marks[:1]), self.marks[:-1]])
        return (self.marks & ~before).any(axis=1)


def flag_steps(
    rollout: Rollout, settings: Settings, added: int = 0, progress: Callable[[int, int], None] | None = None
) -> Flags:  # fmt: skip
    """Search for artefacts at every step, by the same measures and levels as in a study of a world.

    A network has no truth beside it: only artefacts that show in the data alone are listed.

    Args:
        settings: of the inverse and the reading.
        added: interpolated discounts in every gap.
        progress: called with (done, total) in steps; an exception that it raises cancels the search.

    Raises:
        InputError: the agent has no gamma-space, or the settings do not fit it.
    """
    marks = np.zeros((len(rollout), len(LISTED)), dtype=bool)
    order = {name: i for i, name in enumerate(LISTED)}
    for step, action in enumerate(rollout.actions):
        space = rollout.space(step)
        # The inverse treats every action by itself.
        alone = replace(space, values=space.values[[action]], constant=space.constant[[action]])
        study = study_of_gamma_space(with_added(alone, added), settings, own_convention=False)
        for artefact in find_artefacts(study, 0, searching=False):
            if artefact.name in order:  # what stands in place of them is none
                marks[step, order[artefact.name]] = True
        if progress is not None:
            progress(step + 1, len(rollout))
    there = np.asarray(marks.any(axis=0))
    return Flags(tuple(name for name, seen in zip(LISTED, there, strict=True) if seen), marks[:, there])
