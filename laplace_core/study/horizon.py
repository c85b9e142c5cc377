"""Reading a tau-space (or, by readout weights, a gamma-space) for a horizon.

V_T(s, a) = sum_{tau < T} gamma^tau E[r_tau] (paper, Eq. 7, cut at T). Time is counted in steps of the world. Row k
of a tau-space lies at k * time_step and stands for the time around it, as step n stands for n - 1/2 to n + 1/2; so a
deadline of T steps falls at T - 1/2, and the first k + 1 rows are the horizon T = k * time_step + (1 + time_step) / 2.
"""

from __future__ import annotations

import numpy as np

from laplace_core.caching import cached
from laplace_core.code.encoding import sigmoid
from laplace_core.code.ties import greedy_action
from laplace_core.errors import InputError
from laplace_core.inverse.linear import filter_factors
from laplace_core.inverse.transform import transform_factors, transform_matrix


def expected_rewards(tau_space: np.ndarray, midpoints: np.ndarray) -> np.ndarray:
    """E[r_tau] = sum_h theta_mid[h] P[tau, h], shape ``(..., K)`` (paper, above Eq. 9)."""
    return tau_space @ midpoints


def deadline_weights(
    horizon: float | np.ndarray, steps: int, softness: float = 0.0, time_step: float = 1.0
) -> np.ndarray:
    """The weight of each row under a deadline, in [0, 1]: ``(steps,)``, or ``(n, steps)`` of horizons ``(n, 1)``.

    sigmoid((T - 1/2 - tau) / width) with width = softness * T; softness 0 is the hard deadline, tau < T - 1/2,
    and a row right on it counts half.

    Raises:
        InputError: negative or non-finite softness or horizon.
    """
    if not (np.isfinite(softness) and softness >= 0):
        raise InputError(f"softness is {softness:g}; it must be zero or a positive number.")
    if not np.all(np.isfinite(horizon) & (np.asarray(horizon) > 0)):
        raise InputError(f"the horizon is {np.min(horizon):g}; it must be a positive number of steps.")
    tau = np.arange(steps) * time_step
    if softness < 1e-9:  # narrower than any step: the limit, before the division overflows
        return np.heaviside(np.round(horizon - 0.5 - tau, 9), 0.5)
    return sigmoid((horizon - 0.5 - tau) / (softness * horizon))


def row_horizons(steps: int, time_step: float = 1.0) -> np.ndarray:
    """T of each column of the horizon values, in steps of the world, ``(steps,)``: 1, 2, ... at ``time_step`` 1."""
    return np.arange(steps) * time_step + (1.0 + time_step) / 2.0


def horizon_values(rewards: np.ndarray, gamma: float, softness: float = 0.0, time_step: float = 1.0) -> np.ndarray:
    """V_T for every horizon at once: ``(..., K)`` expected rewards to ``(..., K)`` values.

    Column k is the horizon ``row_horizons(K, time_step)[k]``.
    """
    steps = rewards.shape[-1]
    discounted = rewards * gamma ** (np.arange(steps) * time_step)
    if softness == 0:
        return np.cumsum(discounted, axis=-1)
    return discounted @ _deadlines_of_rows(steps, softness, time_step).T


@cached(8)
def _deadlines_of_rows(steps: int, softness: float, time_step: float) -> np.ndarray:
    """:func:`deadline_weights` of the horizon of every row, ``(K, K)``; computed once, as every view needs it."""
    weights = deadline_weights(row_horizons(steps, time_step)[:, None], steps, softness, time_step)
    weights.setflags(write=False)
    return weights


def target_discounts(
    horizon: float, steps: int, gamma: float, softness: float = 0.0, time_step: float = 1.0
) -> np.ndarray:
    """d(tau) = gamma^tau * deadline weight, shape ``(steps,)``: what a value for horizon T should weigh."""
    weights = deadline_weights(horizon, steps, softness, time_step)
    return weights * gamma ** (np.arange(steps) * time_step)


def readout_weights(gammas: np.ndarray, target: np.ndarray, alpha: float, time_step: float = 1.0) -> np.ndarray:
    """w = (F F^T + alpha^2 I)^-1 F d, shape ``(..., G)``: V = sum_g w_g Q_g without a tau-space.

    Equal to decoding and summing with the same steps and alpha. |w| is the noise gain.

    Args:
        target: the discount function d(tau) wanted, shape ``(..., K)``.
    """
    steps = target.shape[-1]
    U, s, Vt = transform_factors(gammas, steps, time_step)
    return (target @ Vt.T * filter_factors(s, alpha, max(len(gammas), steps))) @ U.T


def discount_kernel(gammas: np.ndarray, weights: np.ndarray, steps: int, time_step: float = 1.0) -> np.ndarray:
    """F^T w, shape ``(..., steps)``: what a readout REALLY weighs each future step with."""
    return weights @ transform_matrix(gammas, steps, time_step)


def choose_actions(values: np.ndarray, scale: float | None = None) -> np.ndarray:
    """The action chosen at each horizon, int ``(K,)``, from ``(A, K)`` values; ties go to the lowest index.

    Args:
        scale: size of the terms that the values are sums of; see :func:`laplace_core.code.ties.greedy_action`.
    """
    return greedy_action(values, axis=0, scale=scale)


def scale_of_values(rewards: np.ndarray, midpoints: np.ndarray) -> float:
    """Size of the terms that horizon values are sums of, in units of reward.

    From expected rewards ``(A, K)``: max_a sum_k |E[r_k]|. Each of these is itself a sum over midpoints ``(B,)``, of
    which the largest is left where all rewards cancel.
    """
    return max(float(np.abs(rewards).sum(axis=-1).max()), float(np.abs(midpoints).max()))


def regret(optimum: np.ndarray, actions: np.ndarray) -> np.ndarray:
    """max_a Q*_T(a) - Q*_T(chosen), shape ``(K,)``, >= 0, for ``(A, K)`` optimal values and ``(K,)`` actions."""
    return optimum.max(axis=0) - np.take_along_axis(optimum, actions[None], axis=0)[0]
