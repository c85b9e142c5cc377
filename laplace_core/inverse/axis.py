"""The time axis of a feasible timeline: the rows of tau-space, and windows for all that comes after the last of them.

A timeline of K rows ends there, and the world need not: at a discount of .99 an endless world keeps 13 of its 100
discounted steps after row 200. A solver that must explain all values by K rows would push those steps into them, or
find no timeline at all. So the axis goes on in windows whose length grows with their distance, the last of them without
end. In each the probability of a step is constant. Windows, and not exponentials of several time constants: a mixture
of exponentials falls from the first step on and cannot hold back a reward that waits.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from laplace_core.inverse.transform import transform_matrix

GROWTH = 0.05
"""Length of a window over its distance. Averaging over a window changes (1 - gamma) Q by at most GROWTH^2 / 8 * u^2
exp(-u), 1.7e-4, with u the distance in time constants: so much if a reward comes in every step of its first half and in
none of the second. A single step is spread by 1e-6 at gamma .99."""
GROWTHS = (0.015, 0.15)
"""Smallest and largest growth that :func:`growth_for` chooses."""
FORGOTTEN = 1e-6
"""The last window, without end, begins where the largest discount leaves this share of a reward."""


class Axis(NamedTuple):
    """C columns, the K rows and then J windows, over N = units + J stretches of whole steps.

    Attributes:
        transform: ``(G, C)``, what one unit of probability a step in each column leaves at each discount.
        first: ``(N,)``, the first column of each stretch; the columns of a stretch add up to the survival of its steps.
        steps: ``(N,)``, the first step of each stretch.
        lengths: ``(N,)``, whole steps in each stretch; the last one is infinite.
        size: ``(C,)``, what a column counts in |x|^2: 1 for a row; for a window its steps, faded by the largest
            discount.
        rows: K.
    """

    transform: np.ndarray
    first: np.ndarray
    steps: np.ndarray
    lengths: np.ndarray
    size: np.ndarray
    rows: int

    def survival(self, columns: np.ndarray) -> np.ndarray:
        """Sums over the columns of each stretch, ``(..., C)`` to ``(..., N)``."""
        return columns if len(self.first) == len(self.size) else np.add.reduceat(columns, self.first, axis=-1)

    def spread(self, stretches: np.ndarray) -> np.ndarray:
        """What each stretch gives to its columns, ``(..., N)`` to ``(..., C)``: the transpose of :meth:`survival`."""
        counts = np.diff(self.first, append=len(self.size))
        return stretches if len(self.first) == len(self.size) else np.repeat(stretches, counts, axis=-1)


def axis_of(gammas: np.ndarray, rows: int, time_step: float = 1.0, growth: float = GROWTH) -> Axis:
    """The axis of a problem with ``rows`` rows.

    Step n of the world lies at time n, on the row n / ``time_step`` or between two rows. So the rows from n - 1/2 to
    n + 1/2 are one stretch, whose sum is the survival of step n. Rows after the last whole step belong to it as well.

    Raises:
        InputError: as :func:`laplace_core.inverse.transform_matrix`.
    """
    transform = transform_matrix(gammas, rows, time_step)
    whole = int((rows - 1) * time_step + 1e-9) + 1  # steps 0 .. whole - 1 lie on the rows or between them
    unit = np.minimum((np.arange(rows) * time_step + 0.5 + 1e-9).astype(int), whole - 1)
    last = np.log(FORGOTTEN) / np.log(gammas.max())
    starts = [whole]
    while starts[-1] < last:
        starts.append(starts[-1] + max(1, round(growth * starts[-1])))
    begins, ends = np.array(starts, dtype=float), np.append(starts[1:], np.inf)
    powers = gammas[:, None]
    windows = (powers**begins - powers**ends) / (1.0 - powers)
    faded = (1.0 - gammas.max() ** (ends - begins)) / (1.0 - gammas.max())
    return Axis(
        transform=np.concatenate([transform, windows], axis=1),
        first=np.concatenate([np.searchsorted(unit, np.arange(whole)), rows + np.arange(len(starts))]),
        steps=np.concatenate([np.arange(whole, dtype=float), begins]),
        lengths=np.concatenate([np.ones(whole), ends - begins]),
        size=np.concatenate([np.ones(rows), faded]),
        rows=rows,
    )


def growth_for(deviations: np.ndarray, gammas: np.ndarray) -> float:
    """The growth of windows at which their averaging stays within the noise, for tests of what fits within it.

    GROWTH^2 / 8 * .54 is then a deviation of (1 - gamma) Q, unless that is below 1.5e-5: there the windows would be too
    many.
    """
    level = float(((1.0 - gammas) * deviations).min())
    return float(np.clip(4.0 * np.sqrt(level), *GROWTHS))
