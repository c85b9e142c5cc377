"""One action of a study, decomposed into the contribution of each stage to its rows.

The inverse is linear, so that before any rescaling the picture is a sum,

    rows = truth + (D F - 1) truth + D (what comes after the last row) + D (other policies) + D (noise),

with D the decode matrix and F the transform. Each artefact of the inverse is measured on its own summand, and by
reward: midpoints are gathered at the world's nearest reward, so that the measures do not depend on how finely
rewards are resolved, and noise that averages out between neighbouring thresholds does not count. Rows that
are compared with the truth are added up by whole step as well: a world pays at whole steps, however many rows lie
around each.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from laplace_core.code.encoding import read_at_midpoints, smeared
from laplace_core.code.gamma_space import shifted
from laplace_core.inverse import normalise_rows
from laplace_core.study.artefacts.model import VISIBLE, Artefact
from laplace_core.study.horizon import deadline_weights, row_horizons
from laplace_core.study.pipeline import Study, WorldStudy, basis_of, decoder, rows_decoded, timeline_of


@dataclass(frozen=True, eq=False)
class Drawn:
    """The drawn rows of one action: tau-space ``(n, B)``, survival ``(n,)`` and expected reward ``(n,)``."""

    tau_space: np.ndarray
    survival: np.ndarray
    expected_reward: np.ndarray


class Look:
    """The parts of one action's picture, each computed when first asked for and then cached.

    ``alpha`` and ``steps`` default to those of the picture everywhere, which under ``fold`` has as many rows as the
    horizon.
    """

    def __init__(self, study: Study, action: int, horizon: float | None = None, *, searching: bool = True):
        self.study, self.action, self.horizon, self.settings = study, action, horizon, study.settings
        self.searching = searching
        self.gammas = study.gamma_space.gammas
        row = study.row if horizon is None else study.row_at(horizon)
        self.steps = rows_decoded(self.settings, study.reading(row)[0])
        self._decoded = study.at(row)
        self._errors: dict[float, float] = {}

    @property
    def has_truth(self) -> bool:
        return isinstance(self.study, WorldStudy)

    @property
    def of_world(self) -> WorldStudy:
        """The study as one of a world; check :attr:`has_truth` first."""
        assert isinstance(self.study, WorldStudy)
        return self.study

    @cached_property
    def _groups(self) -> tuple[np.ndarray, np.ndarray]:
        """Which rewards have midpoints nearest to them, and the first midpoint of each; both increase."""
        rewards = self.of_world.world.reward_values
        nearest = np.searchsorted((rewards[1:] + rewards[:-1]) / 2.0, self.study.midpoints)
        first = np.flatnonzero(np.diff(nearest, prepend=-1))
        return nearest[first], first

    def by_reward(self, bins: np.ndarray) -> np.ndarray:
        """Midpoints ``(..., H-1)`` gathered at the nearest reward, ``(..., V)``; without a world they stay apart.

        Sums over neighbours, so that no matrix of midpoints by rewards, or rewards by rewards, is ever made.
        """
        if not self.has_truth:
            return bins
        rewards, first = self._groups
        gathered = np.zeros((*bins.shape[:-1], self.of_world.world.reward_values.size))
        gathered[..., rewards] = np.add.reduceat(bins, first, axis=-1)
        return gathered

    def by_step(self, rows: np.ndarray) -> np.ndarray:
        """Rows as probability ``(K, n)`` gathered at the nearest whole step, as probability of the step, ``(N, n)``."""
        dt = self.settings.time_step
        step = np.floor(np.arange(len(rows)) * dt + 0.5 + 1e-9).astype(int)
        return dt * np.add.reduceat(rows, np.flatnonzero(np.diff(step, prepend=-1)), axis=0)

    @cached_property
    def drawn(self) -> Drawn:
        """The rows of this action that are drawn."""
        decoded, rows = self._decoded, slice(self.steps)
        return Drawn(
            decoded.tau_space[self.action, rows],
            decoded.survival[self.action, rows],
            decoded.expected_reward[self.action, rows],
        )

    @cached_property
    def differences(self) -> np.ndarray:
        """Z of this action by reward, as it is there, noise and all, ``(G, V)``."""
        return self.by_reward(self.study.gamma_space.differences[self.action])

    def smeared(self, weights: np.ndarray) -> np.ndarray:
        """The weighted rewards smeared over the midpoints: ``(..., V)`` to ``(..., H-1)``."""
        study = self.of_world
        return smeared(weights, study.world.reward_values, study.gamma_space.thetas, study.settings.slope)

    @cached_property
    def at_midpoints(self) -> tuple[np.ndarray, np.ndarray]:
        """Mass of each distinct reward that lies at midpoints, and the sum of masses times midpoints, ``(V,)`` each."""
        study = self.of_world
        return read_at_midpoints(study.world.reward_values, study.gamma_space.thetas, study.settings.slope)

    def basis(self, policy: str | None = None) -> np.ndarray:
        """The exact reward-indicator basis of this action, ``(G, V)``."""
        return basis_of(self.of_world, policy)[self.action]

    def exact(self, policy: str | None = None) -> np.ndarray:
        """Exact Z by reward under the study's own target policy or another one, ``(G, V)``."""
        return self.by_reward(self.smeared(self.basis(policy)))

    def timeline(self, steps: int | None = None) -> np.ndarray:
        """True P(r_tau = v, alive) at the whole steps that ``steps`` rows hold, ``(N, V)``."""
        dt, steps = self.settings.time_step, steps or self.steps
        # Row k stands for half a time_step on either side of k * time_step.
        whole = int(np.floor((steps - 0.5) * dt + 1e-9)) + 1
        return timeline_of(self.of_world, whole)[self.action]

    def decode(self, values: np.ndarray, alpha: float | None = None, steps: int | None = None) -> np.ndarray:
        """D @ values for ``(G, n)``, as probability a row, ``(steps, n)``."""
        s = self.settings
        values = shifted(values) if s.shift else values
        return decoder(self.gammas, s, steps or self.steps, alpha) @ values / s.time_step

    def decode_matrix(self, alpha: float | None = None) -> np.ndarray:
        """D, as probability a row, ``(K, G)``."""
        s = self.settings
        matrix = decoder(self.gammas, s, self.steps, alpha) / s.time_step
        return np.append(matrix[:, 1:], np.zeros((len(matrix), 1)), axis=1) if s.shift else matrix

    def rows(self, alpha: float) -> np.ndarray:
        """The picture by reward at an alpha, rescaled as the study's, as probability, ``(K, V)``."""
        s, rows = self.settings, self.decode(self.differences, alpha)
        if s.normalise == "none":
            return rows
        survival = self.decode(self.study.gamma_space.constant[self.action][:, None], alpha)[:, 0]
        return normalise_rows(rows, survival, s.normalise)

    @cached_property
    def true_steps(self) -> np.ndarray:
        """True P(r_tau = v, alive) at every whole step that a row is nearest to, ``(N, V)``.

        A step beyond the last row is not held by the rows before it: it is 0 here.
        """
        dt, held = self.settings.time_step, self.timeline()
        last = int(np.floor((self.steps - 1) * dt + 0.5 + 1e-9))
        return np.pad(held, ((0, max(0, last + 1 - len(held))), (0, 0)))

    def true_values(self, softness: float) -> np.ndarray:
        """True V_T of the action at the horizon of every row, ``(K,)``, under a deadline of this softness."""
        s, timeline = self.settings, self.timeline()
        steps = np.arange(len(timeline))
        discounted = (timeline @ self.of_world.world.reward_values) * s.value_gamma**steps
        if softness == 0:
            return np.array([discounted[steps <= k * s.time_step + 1e-9].sum() for k in range(self.steps)])
        horizons = row_horizons(self.steps, s.time_step)
        return np.array([deadline_weights(T, steps.size, softness) @ discounted for T in horizons])

    def error(self, alpha: float | None = None) -> float:
        """Timeline error at an alpha, before rescaling: total variation from the truth, as a share of the truth."""
        alpha = self.settings.alpha if alpha is None else alpha
        if alpha not in self._errors:
            true = self.by_reward(self.smeared(self.true_steps))
            off = np.abs(self.by_step(self.decode(self.differences, alpha)) - true).sum()
            # Hardly anything may be left inside the sensitivities.
            self._errors[alpha] = float(off / (2.0 * max(true.sum(), VISIBLE)))
        return self._errors[alpha]


Measure = Callable[[Look], Artefact | None]
"""Finds one artefact in the picture of an action; None where it is not there."""


def largest_change(rows: np.ndarray) -> float:
    """The most probability that a change ``(K, n)`` of the rows moves in one of them: half the absolute sum."""
    return 0.5 * float(np.abs(rows).sum(axis=-1).max())


def of_a_row(size: float) -> str:
    """An amount of probability against that of one row, which the terms of a linear inverse may exceed."""
    return f"{size:.2f} of a row's probability" if size <= 1.0 else f"{size:.3g} times a row's whole probability"
