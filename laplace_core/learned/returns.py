"""Distributions of the return: bounds, a distance, and what a tau-space would say if its steps were independent."""

from __future__ import annotations

import numpy as np

from laplace_core.worlds import END, World


def return_bounds(world: World, policy: np.ndarray, gamma: float, sweeps: int = 2_000) -> tuple[float, float]:
    """Least and greatest discounted return, by any luck, after any state and action, in units of reward.

    The policy, int ``(S,)``, decides after the first action: these are the bounds that codes of its return need, and
    they are far closer than those of the worst policy. low(s) = min over outcomes of r + gamma low(s'), and high(s)
    likewise; what may still come after ``sweeps`` is added. Equal bounds are set one unit apart.
    """
    possible = world.probability > 0
    state, action, following, reward = (
        column[possible] for column in (world.state, world.action, world.next_state, world.reward)
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

    A tau-space holds the marginals of the steps and not how they hang together, so that the true law of the return
    does not follow from it. Masses below 0 count as 0, a row above 1 is rescaled to 1, and what a row lacks
    to 1 pays nothing. One step after the other is added exactly; beyond ``most`` locations the near ones are replaced
    by their mean, which keeps the mean of the whole.

    Args:
        tau_space: of one action, ``(K, H-1)``.
        midpoints: reward of each column, ``(H-1,)``.
        discounts: weight of each row, ``(K,)``; 0 leaves a row out.

    Returns:
        locations, increasing, and masses, at most ``most`` each.
    """
    locations, masses = np.zeros(1), np.ones(1)
    for row, discount in zip(tau_space, discounts, strict=True):
        chances = np.where(row > 1e-9, row, 0.0)
        chances /= max(1.0, chances.sum())
        kept = chances > 0
        if not kept.any() or discount == 0:
            continue
        paid = np.append(0.0, discount * midpoints[kept])
        chances = np.append(max(0.0, 1.0 - chances.sum()), chances[kept])
        added = (locations[:, None] + paid).ravel()
        locations, masses = _merged(added, np.outer(masses, chances).ravel(), most)
    return locations, masses


def _merged(locations: np.ndarray, masses: np.ndarray, most: int) -> tuple[np.ndarray, np.ndarray]:
    """At most ``most`` locations, in order: those that share a cell are replaced by their mean."""
    span = float(np.ptp(locations))
    cell = max(span / (most - 1), 1e-300)
    if locations.size <= most:  # equal but for rounding
        cell = max(1e-12 * span, 1e-300)
        cells = np.unique(np.floor((locations - locations.min()) / cell + 0.5), return_inverse=True)[1]
    else:
        cells = np.floor((locations - locations.min()) / cell + 0.5).astype(np.int64)
    totals = np.bincount(cells, masses)
    kept = totals > 0
    return np.bincount(cells, masses * locations)[kept] / totals[kept], totals[kept]
