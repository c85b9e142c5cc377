"""Filtering of a gamma-space over its discounts, before the inverse."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from laplace_core.code.gamma_space import GammaSpace
from laplace_core.errors import InputError

DISCOUNT_FILTERS = ("none", "savgol")


def savgol_matrix(discounts: int, window: int = 5, order: int = 2) -> np.ndarray:
    """S, ``(G, G)``: S @ values is their Savitzky-Golay filter over the discounts.

    The filter runs over the *index* of a discount in the grid: it fits a polynomial to each window of neighbours as if
    they were evenly spaced. On the ``inverse-log`` grid that is so in 1 / log(gamma), on ``log`` in the logarithm of
    the time constant, on ``linear`` in gamma. The first and last half of a window are read off the polynomial of the
    outermost window.

    Args:
        window: neighbours that a polynomial is fitted to, odd.
        order: of the polynomial, below ``window``; values that are such a polynomial stay as they are.

    Raises:
        InputError: a window that is even or longer than the grid, or an order that fills it.
    """
    if window % 2 == 0 or not 1 <= window <= discounts:
        raise InputError(f"--filter-window is {window}; it must be an odd number of at most {discounts} discounts.")
    if not 0 <= order < window:
        raise InputError(f"--filter-order is {order}; it must be from 0 to {window - 1}, below --filter-window.")
    from scipy.signal import savgol_filter  # takes longer to load than the library itself

    matrix: np.ndarray = savgol_filter(np.eye(discounts), window, order, axis=0, mode="interp")
    return matrix


def filtered(gamma_space: GammaSpace, window: int = 5, order: int = 2) -> GammaSpace:
    """A gamma-space after a Savitzky-Golay filter over its discounts (:func:`savgol_matrix`).

    Values and the constant channel are taken times 1 - gamma, a probability, so that what is fitted does not grow with
    the discount.

    Raises:
        InputError: as :func:`savgol_matrix`.
    """
    matrix = probability_filter(gamma_space.gammas, window, order)
    constant = (matrix @ gamma_space.constant[..., None])[..., 0]
    return replace(gamma_space, values=matrix @ gamma_space.values, constant=constant)


def probability_filter(gammas: np.ndarray, window: int, order: int) -> np.ndarray:
    """:func:`savgol_matrix` for values that are not yet taken times 1 - gamma, ``(G, G)``.

    Discounts in any order: neighbours are those next to each other when sorted.
    """
    places, chances = np.argsort(gammas), 1.0 - gammas
    matrix = np.empty((gammas.size, gammas.size))
    matrix[np.ix_(places, places)] = savgol_matrix(gammas.size, window, order)
    return matrix * chances / chances[:, None]
