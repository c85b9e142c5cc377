"""How far a decoded timeline is from the true one, and what that costs.

A timeline is an array of masses ``(..., K, B)``; a single column, such as survival or expected reward, is one with
B = 1. Every measure is 0 for the truth itself.
"""

from __future__ import annotations

import numpy as np

from laplace_core.code.ties import greedy_action


def time_distance(timeline: np.ndarray, truth: np.ndarray, time_step: float = 1.0) -> np.ndarray:
    """Wasserstein-1 distance over time of each column, ``(..., B)``, in steps times mass.

    W = time_step * sum_k |C_k|, with C_k what the timeline holds up to row k more than the truth: mass that lies n
    steps too early or too late costs n times its size. Mass that is missing, or too much, costs as if it lay right
    after the last row. Of expected reward it is the sum over all horizons T of the error of V_T, not discounted; and it
    is a distance for any two arrays, also with negative entries.
    """
    return time_step * np.abs(np.cumsum(timeline - truth, axis=-2)).sum(axis=-2)


def mean_time_distance(timeline: np.ndarray, truth: np.ndarray, time_step: float = 1.0) -> np.ndarray:
    """How many steps a unit of mass lies off on average, ``(...)``: the distances of all bins by the true mass.

    Bins are compared one by one: mass in a wrong bin is missing in one and too much in the other.
    """
    return _share(time_distance(timeline, truth, time_step).sum(axis=-1), np.abs(truth).sum(axis=(-2, -1)))


def relative_error(timeline: np.ndarray, truth: np.ndarray) -> np.ndarray:
    """Root of the sum of squares of all errors by that of the truth, ``(...)``."""
    return _share(np.linalg.norm(timeline - truth, axis=(-2, -1)), np.linalg.norm(truth, axis=(-2, -1)))


def total_variation(timeline: np.ndarray, truth: np.ndarray) -> np.ndarray:
    """Half the sum of the sizes of all errors by the true mass, ``(...)``: 1 if all mass lies elsewhere."""
    return _share(np.abs(timeline - truth).sum(axis=(-2, -1)) / 2.0, np.abs(truth).sum(axis=(-2, -1)))


def value_range(values: np.ndarray) -> float:
    """From the smallest to the largest V_T of any action at any horizon, ``(A, K)``; 1 where all are 0.

    Where they are all equal and not 0, it is their size.
    """
    return float(np.ptp(values)) or float(np.abs(values).max()) or 1.0


def value_error(values: np.ndarray, truth: np.ndarray) -> float:
    """Mean error of V_T over actions and horizons, by the range of its true values; both ``(A, K)``."""
    return float(np.abs(values - truth).mean()) / value_range(truth)


def choice_regret(values: np.ndarray, truth: np.ndarray) -> float:
    """Mean over horizons of what the action of largest value loses, by the range of the true values; both ``(A, K)``.

    Ties go to the lowest action, as everywhere (:func:`laplace_core.code.ties.greedy_action`).
    """
    chosen = greedy_action(values, axis=0, scale=float(np.abs(values).max()))
    lost = truth.max(axis=0) - np.take_along_axis(truth, chosen[None], axis=0)[0]
    return float(lost.mean()) / value_range(truth)


def _share(part: np.ndarray, whole: np.ndarray) -> np.ndarray:
    """part / whole; where the whole is 0, part itself."""
    return part / np.where(whole > 0.0, whole, 1.0)
