"""A timeline, changed by hand and transformed back to gamma-space (the memory extension of the paper, section 6).

A timeline is what :class:`laplace_core.inverse.problem.Solution` holds as ``masses``: ``(..., K, B)``, the probability
of each of the B = H + 1 bins at each row, outer bins included, so that a row sums to survival. Every manipulation
returns another timeline, so they can follow each other; :func:`transformed` brings the last one back to gamma-space,
where all that reads a gamma-space reads it as well, and :func:`values_of` reads it for every horizon.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from laplace_core.code.gamma_space import GammaSpace, bin_differences, bin_values
from laplace_core.errors import InputError
from laplace_core.inverse.transform import transform_matrix
from laplace_core.study.horizon import choose_actions, deadline_weights, horizon_values, scale_of_values

DISTORTIONS = ("cvar", "power")


def cut(masses: np.ndarray, horizon: float, softness: float = 0.0, time_step: float = 1.0) -> np.ndarray:
    """The timeline of an episode that is stopped after ``horizon`` steps, ``(..., K, B)``.

    Args:
        softness: width of the deadline as a share of the horizon; see
            :func:`laplace_core.study.horizon.deadline_weights`.
    """
    return masses * deadline_weights(horizon, masses.shape[-2], softness, time_step)[:, None]


def rediscounted(masses: np.ndarray, gamma: float, time_step: float = 1.0) -> np.ndarray:
    """The timeline with row tau times gamma^tau, ``(..., K, B)``.

    Its transform at a discount g is that of the old timeline at g * gamma: an episode that also ends with a chance of
    1 - gamma after each step.

    Raises:
        InputError: gamma outside (0, 1].
    """
    if not 0.0 < gamma <= 1.0:
        raise InputError(f"the discount is {gamma:g}; it must be above 0 and at most 1.")
    return masses * gamma ** (np.arange(masses.shape[-2]) * time_step)[:, None]


def shifted(masses: np.ndarray, delay: float, time_step: float = 1.0) -> np.ndarray:
    """The timeline ``delay`` steps later, ``(..., K, B)``; earlier where ``delay`` is below 0.

    What is moved before the first row or after the last one is lost. Nothing is in the rows that become free: a
    transform is multiplied by gamma^delay, but for what is lost.

    Raises:
        InputError: a delay that is no whole number of rows.
    """
    rows = round(delay / time_step) if np.isfinite(delay) else 0
    if abs(rows * time_step - delay) > 1e-9 or not np.isfinite(delay):
        raise InputError(f"a shift of {delay:g} steps is no whole number of rows: the rows lie {time_step:g} apart.")
    steps = masses.shape[-2]
    moved = np.zeros_like(masses)
    if abs(rows) < steps:
        moved[..., max(rows, 0) : steps + min(rows, 0), :] = masses[..., max(-rows, 0) : steps - max(rows, 0), :]
    return moved


def distorted(
    masses: np.ndarray, values: np.ndarray, how: str, level: float, *, time_step: float = 1.0
) -> np.ndarray:  # fmt: skip
    """The timeline as an agent that is averse to risk, or seeks it, weighs each step, ``(..., K, B)``.

    The reward of a step has a distribution: the masses of its row, and a reward of 0 with what they lack of 1, the
    chance that the episode is over. Its distribution function F is replaced by that of a distortion (Dabney et al.,
    2018, 'Implicit quantile networks', section 3.1), with eta the ``level``:

    - ``cvar``: min(F / eta, 1), the mean of the worst share eta in (0, 1]; 1 changes nothing.
    - ``power``: 1 - (1 - F)^(1 + |eta|) for eta below 0, averse; F^(1 + eta) above 0, seeking; 0 changes nothing.

    A row that is no distribution, as a linear inverse makes them, is first made one: negative masses become 0, and a
    row above 1 is divided by its sum. Each step is distorted by itself: what a tau-space says of several steps together
    is not known.

    Args:
        values: what a reward in each bin counts as, increasing, ``(B,)``.

    Raises:
        InputError: another word, a level out of its range, or values that do not fit the masses.
    """
    distortion = _distortion(how, level)
    values = np.asarray(values, dtype=float)
    if values.shape != masses.shape[-1:] or not np.all(np.diff(values) >= 0):
        raise InputError(f"values must be {masses.shape[-1]} increasing numbers, one for each bin.")
    alive = np.maximum(masses, 0.0) / time_step
    alive = alive / np.maximum(alive.sum(axis=-1, keepdims=True), 1.0)
    over = 1.0 - alive.sum(axis=-1, keepdims=True)
    place = int(np.searchsorted(values, 0.0))  # an episode that is over pays 0: among the bins at its place
    sorted_masses = np.concatenate([alive[..., :place], over, alive[..., place:]], axis=-1)
    share = distortion(np.clip(np.cumsum(sorted_masses, axis=-1), 0.0, 1.0))
    weighed = np.diff(share, axis=-1, prepend=0.0)
    return np.delete(weighed, place, axis=-1) * time_step


def _distortion(how: str, level: float) -> Callable[[np.ndarray], np.ndarray]:
    if how not in DISTORTIONS:
        raise InputError(f"the distortion {how!r} is not one of {', '.join(DISTORTIONS)}.")
    if how == "cvar":
        if not 0.0 < level <= 1.0:
            raise InputError(f"the level of cvar is {level:g}; it is a share, above 0 and at most 1.")
        return lambda F: np.minimum(F / level, 1.0)
    if not abs(level) <= 100.0:
        raise InputError(f"the level of power is {level:g}; it must be from -100 to 100.")
    if level < 0.0:
        return lambda F: 1.0 - (1.0 - F) ** (1.0 - level)
    return lambda F: F ** (1.0 + level)


def transformed(
    masses: np.ndarray, gammas: np.ndarray, thetas: np.ndarray, time_step: float = 1.0
) -> GammaSpace:  # fmt: skip
    """The gamma-space of a timeline ``(A, K, H+1)``: what would have been learned if this were what happens.

    Any discounts will do, those that were learned or others.

    Raises:
        InputError: masses that are not one row of H + 1 bins a step, or grids that make no sense.
    """
    thetas = np.asarray(thetas, dtype=float)
    if masses.ndim != 3 or masses.shape[-1] != thetas.size + 1:
        raise InputError(
            f"masses of shape {masses.shape} are no timeline over {thetas.size} thetas: they must be "
            f"(actions, steps, {thetas.size + 1}), the open ends included."
        )
    discounted = transform_matrix(gammas, masses.shape[-2], time_step) @ masses
    tails = np.cumsum(discounted[..., ::-1], axis=-1)[..., ::-1]
    return GammaSpace(tails[..., 1:], tails[..., 0], np.asarray(gammas, dtype=float), thetas, open_ends=True)


@dataclass(frozen=True)
class Loss:
    """The change of one action's values in a round trip from gamma-space to a timeline and back.

    Attributes:
        relative: norm of the difference of all masses over the discounts, by their own norm.
        largest: largest error of (1 - gamma) Q, a probability, and the discount that has it.
    """

    relative: float
    largest: float
    gamma: float


def round_trip_losses(gamma_space: GammaSpace, masses: np.ndarray, time_step: float = 1.0) -> list[Loss]:
    """How far the timeline ``(A, K, H+1)`` of a gamma-space is from having its values, one loss an action.

    A timeline that was not changed should lose little; one that was cut or distorted loses what was taken away.
    """
    back = transformed(masses, gamma_space.gammas, gamma_space.thetas, time_step)
    here, there = (bin_differences(each.values, each.constant, open_ends=True) for each in (gamma_space, back))
    tails, constant = np.abs(back.values - gamma_space.values), np.abs(back.constant - gamma_space.constant)
    errors = np.maximum(tails.max(axis=-1), constant) * (1.0 - gamma_space.gammas)
    losses = []
    for a in range(len(here)):
        g, size = int(np.argmax(errors[a])), float(np.linalg.norm(here[a]))
        lost = float(np.linalg.norm(there[a] - here[a]))
        losses.append(Loss(lost / size if size else float(lost > 0), float(errors[a, g]), float(gamma_space.gammas[g])))
    return losses


def values_of(
    masses: np.ndarray, thetas: np.ndarray, gamma: float, *, softness: float = 0.0, time_step: float = 1.0
) -> tuple[np.ndarray, np.ndarray]:
    """The values of a timeline ``(A, K, H+1)`` for every horizon, and the action that is chosen for each.

    Returns:
        Values ``(A, K)`` in units of reward, and actions, int ``(K,)``; the last column is the whole timeline.
    """
    worth = bin_values(np.asarray(thetas, dtype=float), open_ends=True)
    if masses.ndim != 3 or masses.shape[-1] != worth.size:
        raise InputError(f"masses of shape {masses.shape} do not have {worth.size} bins on their last axis.")
    rewards = masses @ worth
    values = horizon_values(rewards, gamma, softness, time_step)
    return values, choose_actions(values, scale_of_values(rewards, worth))
