"""The kernels of a reading: the discount kernel of its value, and the averaging kernel of a row.

Both are rows of F^T times weights over the discounts: what the values of gamma-space are multiplied by.
"""

from __future__ import annotations

import numpy as np

from laplace_core.study.horizon import deadline_weights, discount_kernel
from laplace_core.study.pipeline import Study, decoder, rows_decoded


def target_of(study: Study) -> np.ndarray:
    """d(tau), ``(K,)``: what the value that is read should weigh each row with."""
    s = study.settings
    row = study.reading(study.row)[0]
    taus = np.arange(s.steps) * s.time_step
    if s.softness:
        return deadline_weights(float(study.horizons[row]), s.steps, s.softness, s.time_step) * s.value_gamma**taus
    return (np.arange(s.steps) <= row) * s.value_gamma**taus


def weights_of(study: Study, target: np.ndarray) -> np.ndarray:
    """Weights over the discounts, ``(G,)``, with which gamma-space gives the sum of target times rows.

    Args:
        target: ``(K,)``; what it has beyond the rows that are decoded does not count.
    """
    s, gammas = study.settings, study.gamma_space.gammas
    rows = rows_decoded(s, study.reading(study.row)[0])
    weights = target[:rows] @ decoder(gammas, s, rows)
    # Decoding values that are shifted by one is decoding by weights that are shifted back.
    return np.append(weights[1:], 0.0) if s.shift else weights


def discount_kernel_of(study: Study) -> np.ndarray:
    """The effective weight of each future step at this alpha and T, ``(K,)``."""
    s = study.settings
    return discount_kernel(study.gamma_space.gammas, weights_of(study, target_of(study)), s.steps, s.time_step)


def averaging_kernel_of(study: Study, row: int) -> np.ndarray:
    """Through which window of the true timeline a row is seen, ``(K,)``; 0 for a row that is not decoded."""
    s = study.settings
    if row >= rows_decoded(s, study.reading(study.row)[0]):
        return np.zeros(s.steps)
    return discount_kernel(study.gamma_space.gammas, weights_of(study, np.eye(s.steps)[row]), s.steps, s.time_step)
