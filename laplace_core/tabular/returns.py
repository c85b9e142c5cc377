"""Distributions of the return: bounds, a distance, and the return of a tau-space if its steps were independent."""

from __future__ import annotations

import numpy as np

from laplace_core.tabular.marginals import marginals
from laplace_core.worlds import END, World


def return_bounds(world: World, policy: np.ndarray, gamma: float, sweeps: int = 2_000) -> tuple[float, float]:
    """Least and greatest discounted return, by any luck, after any state and action, in units of reward.

    The policy, int ``(S,)``, decides after the first action: these are the bounds that codes of its return need, and
    they are far closer than those of the worst policy. low(s) = min over outcomes of r + gamma low(s'), and high(s)
    likewise; what may still come after ``sweeps`` is added. Equal bounds are set one unit apart.
    """
    possible = world.probability > 0
    state, action, following, reward = (
        column[possible] for column in (world.state, world.action, world.following, world.reward)
    )
    firsts = np.searchsorted(state * world.n_actions + action, np.arange(world.n_states * world.n_actions))
    alive, chosen = following != END, np.arange(world.n_states) * world.n_actions + policy
    scale = float(np.abs(reward).max())
    bounds = []
    for worse, sign in ((np.minimum, -1.0), (np.maximum, 1.0)):
        values, left = np.zeros(world.n_states * world.n_actions), scale / (1.0 - gamma)
        for _ in range(sweeps):
            later = np.where(alive, values[chosen][following], 0.0)
            new, left = worse.reduceat(reward + gamma * later, firsts), left * gamma
            settled, values = np.array_equal(new, values), new
            if settled or left < 1e-9 * scale:
                break
        bounds.append(float(worse.reduce(values)) + (0.0 if settled else sign * left))
    low, high = bounds
    return (low, high) if high - low > 1e-9 * max(1.0, abs(low)) else (low - 0.5, high + 0.5)


def wasserstein(first: tuple[np.ndarray, np.ndarray], second: tuple[np.ndarray, np.ndarray]) -> float:
    """Wasserstein-1 distance of two distributions (locations, masses): the area between their cumulated masses."""
    locations = np.concatenate([first[0], second[0]])
    masses = np.concatenate([first[1] / np.sum(first[1]), -second[1] / np.sum(second[1])])
    order = np.argsort(locations)
    return float(np.abs(np.cumsum(masses[order])[:-1]) @ np.diff(locations[order]))


def independent_steps_return(
    tau_space: np.ndarray, midpoints: np.ndarray, discounts: np.ndarray, most: int = 2_000
) -> tuple[np.ndarray, np.ndarray]:
    """The law of sum_tau discounts[tau] r_tau IF the rewards of different steps were independent.

    A tau-space holds the marginals of the steps and not their dependence, so that the true law of the return
    does not follow from it. Masses below 0 are repaired as in :func:`.marginals.marginals`, which keeps the means of
    the steps, and what a row lacks to 1 pays nothing. One step after the other is added exactly; where that makes more
    than ``most`` locations, all is done on a grid instead, which keeps the mean of the whole and its variance within a
    percent.

    Args:
        tau_space: of one action, ``(K, H-1)``.
        midpoints: reward of each column, ``(H-1,)``.
        discounts: weight of each row, ``(K,)``; 0 leaves a row out.

    Returns:
        locations, increasing, and masses, at most ``most`` each.
    """
    chances = marginals(tau_space[discounts != 0], midpoints)
    discounts = discounts[discounts != 0]
    locations, masses = np.zeros(1), np.ones(1)
    for row, discount in zip(chances, discounts, strict=True):
        positive = row > 0
        if not positive.any():
            continue
        paid = np.append(0.0, discount * midpoints[positive])
        row = np.append(max(0.0, 1.0 - row.sum()), row[positive])
        locations, masses = _merged((locations[:, None] + paid).ravel(), np.outer(masses, row).ravel())
        if locations.size > most:
            return _merged(*_summed_on_a_grid(chances, discounts[:, None] * midpoints), most)
    return locations, masses


_CELLS, _WIDE, _ROWS = 8192, 10.0, 64


def _summed_on_a_grid(chances: np.ndarray, paid: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The law of a sum of independent rewards, each row of ``paid`` ``(K, M)`` with its ``chances``, else 0.

    A reward between two points of the grid is shared by both, which keeps its mean and adds at most a quarter of a
    squared cell to its variance; the laws are multiplied as Fourier transforms. The grid is ten standard deviations
    wide to both sides, and the largest single reward besides: what lies beyond comes in again at the other end.
    """
    means = (chances * paid).sum(axis=1)
    spread = np.sqrt(max(0.0, float(((chances * paid**2).sum(axis=1) - means**2).sum())))
    cell = 2.0 * (_WIDE * spread + np.abs(paid).max()) / _CELLS
    product = np.ones(_CELLS // 2 + 1, dtype=complex)
    for start in range(0, len(paid), _ROWS):
        rows, place = chances[start : start + _ROWS], paid[start : start + _ROWS] / cell
        left = np.floor(place)
        upper = rows * (place - left)
        base = (np.arange(len(rows)) * _CELLS)[:, None]
        index = left.astype(np.int64)
        law = np.bincount((base + index % _CELLS).ravel(), (rows - upper).ravel(), len(rows) * _CELLS)
        law += np.bincount((base + (index + 1) % _CELLS).ravel(), upper.ravel(), len(rows) * _CELLS)
        law = law.reshape(len(rows), _CELLS)
        law[:, 0] += 1.0 - rows.sum(axis=1)
        product *= np.fft.rfft(law, axis=1).prod(axis=0)
    masses, first = np.fft.irfft(product, _CELLS), round(float(means.sum()) / cell) - _CELLS // 2
    masses = np.roll(masses, -(first % _CELLS))
    positive = masses > 1e-12
    return cell * (first + np.arange(_CELLS))[positive], masses[positive] / masses[positive].sum()


def _merged(locations: np.ndarray, masses: np.ndarray, most: int | None = None) -> tuple[np.ndarray, np.ndarray]:
    """Locations in order, those equal but for rounding as one; at most ``most``: those of a cell become their mean."""
    span, low = float(np.ptp(locations)), locations.min()
    cells = np.unique(np.floor((locations - low) / max(1e-12 * span, 1e-300) + 0.5), return_inverse=True)[1]
    if most is not None and cells.max() >= most:
        cells = np.floor((locations - low) * ((most - 1) / span) + 0.5).astype(np.int64)
    totals = np.bincount(cells, masses)
    positive = totals > 0
    return np.bincount(cells, masses * locations)[positive] / totals[positive], totals[positive]
