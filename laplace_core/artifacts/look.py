"""One action of a study, taken apart: what each stage adds to its rows.

The inverse is linear, so that before any rescaling the picture is a sum,

    rows = truth + (D F - 1) truth + D (what comes after the last row) + D (other policies) + D (noise),

with D the decode matrix and F the transform. Each artefact of the inverse is measured on its own summand, and by
reward: midpoints are gathered at the world's nearest reward, so that the measures do not depend on how finely
rewards are resolved, and noise that averages out between neighbouring thresholds does not count.
"""

from __future__ import annotations

from functools import cached_property

import numpy as np

from laplace_core.artifacts.model import VISIBLE
from laplace_core.encoding import bin_masses
from laplace_core.inverse import decode, decode_matrix, normalise_rows
from laplace_core.pipeline import Study, basis_of, timeline_of


class Look:
    """The parts of one action's picture, each computed when first asked for and then kept.

    ``alpha`` and ``steps`` default to those of the study everywhere.
    """

    def __init__(self, study: Study, action: int, horizon: float | None = None, searching: bool = True):
        self.study, self.action, self.horizon, self.settings = study, action, horizon, study.settings
        self.searching = searching
        self.gammas = study.gamma_space.gammas
        self._errors: dict[float, float] = {}

    @property
    def has_truth(self) -> bool:
        return self.study.truth is not None

    @cached_property
    def nearest(self) -> np.ndarray:
        """Which reward each midpoint is nearest to, one-hot ``(H-1, V)``; without a world each stands for itself."""
        if self.study.world is None:
            return np.eye(self.study.midpoints.size)
        rewards = self.study.world.reward_values
        which = np.searchsorted((rewards[1:] + rewards[:-1]) / 2.0, self.study.midpoints)
        return (which[:, None] == np.arange(rewards.size)).astype(float)

    @cached_property
    def differences(self) -> np.ndarray:
        """Z of this action by reward, as it is there, noise and all, ``(G, V)``."""
        return self.study.gamma_space.differences[self.action] @ self.nearest

    @cached_property
    def masses(self) -> np.ndarray:
        """What each distinct reward leaves at each midpoint, ``(V, H-1)``."""
        return bin_masses(self.study.world.reward_values, self.study.gamma_space.thetas, self.settings.slope)

    def basis(self, policy: str | None = None) -> np.ndarray:
        """The exact reward-indicator basis of this action, ``(G, V)``."""
        return basis_of(self.study, policy)[self.action]

    def exact(self, policy: str | None = None) -> np.ndarray:
        """Exact Z by reward under the study's own target policy or another one, ``(G, V)``."""
        return self.basis(policy) @ (self.masses @ self.nearest)

    def timeline(self, steps: int | None = None) -> np.ndarray:
        """True P(r_tau = v, alive) at the whole steps that ``steps`` rows hold, ``(N, V)``."""
        dt, steps = self.settings.time_step, steps or self.settings.steps
        # Row k stands for half a time_step on either side of k * time_step.
        whole = int(np.floor((steps - 0.5) * dt + 1e-9)) + 1
        return timeline_of(self.study, whole)[self.action]

    def decode(self, values: np.ndarray, alpha: float | None = None, steps: int | None = None) -> np.ndarray:
        """D @ values for ``(G, n)``, as probability a row, ``(steps, n)``."""
        s = self.settings
        alpha = s.alpha if alpha is None else alpha
        return decode(values, self.gammas, steps or s.steps, alpha, s.time_step) / s.time_step

    def decode_matrix(self, alpha: float | None = None) -> np.ndarray:
        """D, as probability a row, ``(K, G)``."""
        s = self.settings
        return decode_matrix(self.gammas, s.steps, s.alpha if alpha is None else alpha, s.time_step) / s.time_step

    def rows(self, alpha: float) -> np.ndarray:
        """The picture by reward at an alpha, rescaled as the study's, as probability, ``(K, V)``."""
        s, rows = self.settings, self.decode(self.differences, alpha)
        if s.normalise == "none":
            return rows
        survival = self.decode(self.study.gamma_space.constant[self.action][:, None], alpha)[:, 0]
        return normalise_rows(rows, survival, s.normalise)

    @cached_property
    def _true_rows(self) -> np.ndarray:
        return self.study.truth.tau_space[self.action] @ self.nearest / self.settings.time_step

    def error(self, alpha: float | None = None) -> float:
        """Timeline error at an alpha, before rescaling: total variation from the truth, as a share of the truth."""
        alpha = self.settings.alpha if alpha is None else alpha
        if alpha not in self._errors:
            true = self._true_rows
            off = np.abs(self.decode(self.differences, alpha) - true).sum()
            # Hardly anything may be left inside the sensitivities.
            self._errors[alpha] = float(off / (2.0 * max(true.sum(), VISIBLE)))
        return self._errors[alpha]


def largest_change(rows: np.ndarray) -> float:
    """The most probability that a change ``(K, n)`` of the rows moves in one of them: half the absolute sum."""
    return 0.5 * float(np.abs(rows).sum(axis=-1).max())
