"""Reading learned tables: one learner's tau-space, bands over all, and its return beside the other codes."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from laplace_core.caching import cached
from laplace_core.code.gamma_space import GammaSpace, encode
from laplace_core.errors import InputError
from laplace_core.study.pipeline import WorldStudy, grids, policies_of, study
from laplace_core.study.settings import ResolvedForWorld, Settings
from laplace_core.study.size import check_size
from laplace_core.tabular.model import Learned
from laplace_core.tabular.peers import ReturnDistribution, impute, return_distribution
from laplace_core.tabular.returns import independent_steps_return, return_bounds, wasserstein
from laplace_core.tabular.settings import DECIDED_NAMES, ResolvedLearning
from laplace_core.worlds import World

QUANTILE_LEVELS = (0.1, 0.25, 0.5, 0.75, 0.9)
CODES = ("laplace", "independent_steps", "categorical", "quantile", "expectile", "plain")
"""Codes that are compared with the true distribution of the return. ``independent_steps`` is no code of its own: it is
the distribution that the Laplace code's tau-space gives IF STEPS WERE INDEPENDENT, and has to be labelled so."""


def study_settings(learning: ResolvedLearning, settings: Settings | None = None) -> Settings:
    """Settings of a study, with the learner's own discounts, target policy and acting gamma in place of theirs."""
    decided = {name: getattr(learning, name) for name in DECIDED_NAMES}
    return replace(settings or Settings(), **decided)


def study_of(learned: Learned, settings: Settings | None = None, seed_index: int = 0) -> WorldStudy:
    """One state through the table of one learner, the exact truth beside it.

    Args:
        settings: the state, the sensitivities and how to decode; what the learner has decided (``DECIDED_NAMES``) is
            replaced by its own.

    Raises:
        InputError: settings that do not fit the world, or no such learner.
    """
    index = learned.seed_index(seed_index)
    settings = study_settings(learned.settings, settings)
    return study(learned.world, settings, learned=_basis(learned, index, settings.state))


def _basis(learned: Learned, index: int, state: str | None) -> np.ndarray:
    world = learned.world
    at = int(np.argmax(world.start)) if state is None else world.state_index(state)
    return learned.basis[index, at].astype(np.float64)


SAME = 1e-9
"""Standard deviations of (1 - gamma) Q up to this are rounding: the seeds have learned the same."""
LEAST_SHARE = 1e-3
"""Of the largest standard deviation: no discount is trusted more than a thousand times as much as another."""


def noise_over_seeds(learned: Learned, settings: ResolvedForWorld) -> np.ndarray:
    """Standard deviation of (1 - gamma) Q of one seed at each discount, ``(G,)``, from the spread of all seeds.

    The variance over the seeds (by N - 1) is averaged over actions and sensitivities. What all seeds have in common,
    such as that they have not learned for long enough, is no part of it.

    Args:
        settings: the state and the sensitivities.

    Raises:
        InputError: a single seed, or seeds that have learned the same.
    """
    if len(learned.basis) < 2:
        raise InputError("the noise is measured from several seeds: learn at least 2.")
    values = np.stack([each.values for each in _encoded(learned, settings)])
    spread = (1.0 - learned.gammas) * np.sqrt(values.var(axis=0, ddof=1).mean(axis=(0, 2)))
    if spread.max() <= SAME:
        raise InputError("all seeds have learned the same values: there is no noise to measure.")
    return np.maximum(spread, LEAST_SHARE * spread.max())


def reward_gain_over_seeds(learned: Learned, settings: ResolvedForWorld) -> float:
    """Standard deviation of the expected reward at a discount over that of one value there, as the seeds show it.

    Root mean square over the discounts; :func:`laplace_core.inverse.bands.reward_gain` is the same of errors that are
    independent, or one, which those of a learner are not.

    Raises:
        InputError: as :func:`noise_over_seeds`.
    """
    rewards = np.stack([each.differences @ each.bin_values for each in _encoded(learned, settings)])
    spread = (1.0 - learned.gammas) * np.sqrt(rewards.var(axis=0, ddof=1).mean(axis=0))
    return float(np.sqrt(np.mean((spread / noise_over_seeds(learned, settings)) ** 2)))


def _encoded(learned: Learned, settings: ResolvedForWorld) -> list[GammaSpace]:
    """The gamma-space of the state of the settings through the table of each seed."""
    world, (_, thetas) = learned.world, grids(settings)
    tables = learned.basis[:, world.state_index(settings.state)].astype(np.float64)
    return [encode(each, world.reward_values, learned.gammas, thetas, settings.slope) for each in tables]


def noise_settings(learned: Learned, settings: ResolvedForWorld) -> dict[str, Any]:
    """Values of ``noise_level`` and ``noise_levels`` that state the measured noise; the first is its root mean square.

    Raises:
        InputError: as :func:`noise_over_seeds`.
    """
    spread = noise_over_seeds(learned, settings)
    mean = float(np.sqrt(np.mean(spread**2)))
    return {"noise_level": float(f"{mean:.4g}"), "noise_levels": ",".join(f"{level:.4g}" for level in spread.tolist())}


@dataclass(frozen=True, eq=False)
class Band:
    """One array over the seeds; each field has its shape, ``quantiles`` (Q, ...) by ``QUANTILE_LEVELS``."""

    mean: np.ndarray
    low: np.ndarray
    high: np.ndarray
    quantiles: np.ndarray


@dataclass(frozen=True, eq=False)
class Bands:
    """Studies of one state by all learners, and the spread over them.

    Attributes:
        tau_space: over ``(A, K, H-1)``; survival, expected_reward, horizon_values over ``(A, K)``.
        action_share: share of the learners that choose each action at each horizon, ``(A, K)``.
        studies: one a learner; the truth is in each.
    """

    tau_space: Band
    survival: Band
    expected_reward: Band
    horizon_values: Band
    action_share: np.ndarray
    studies: tuple[WorldStudy, ...]


def bands(learned: Learned, settings: Settings | None = None) -> Bands:
    """Decode one state from every learner's table and take the spread over the learners.

    Raises:
        InputError: the studies of all learners together are too large.
    """
    first = study_of(learned, settings, 0)
    actions, discounts, thetas = first.gamma_space.values.shape
    seeds = len(learned.basis)
    check_size(actions, discounts, thetas, first.settings.steps, learners=seeds)
    studies = (first, *(study_of(learned, settings, i) for i in range(1, seeds)))
    chosen = np.stack([each.decoded.actions for each in studies])
    share = np.stack([(chosen == a).mean(axis=0) for a in range(learned.world.n_actions)])
    decoded = [each.decoded for each in studies]
    return Bands(
        _band([each.tau_space for each in decoded]),
        _band([each.survival for each in decoded]),
        _band([each.expected_reward for each in decoded]),
        _band([each.horizon_values for each in decoded]),
        share,
        studies,
    )


def _band(arrays: list[np.ndarray]) -> Band:
    stacked = np.stack(arrays)
    quantiles = np.quantile(stacked, QUANTILE_LEVELS, axis=0)
    return Band(stacked.mean(axis=0), stacked.min(axis=0), stacked.max(axis=0), quantiles)


@dataclass(frozen=True, eq=False)
class Returns:
    """The return after one state and action, at ``gamma``: the truth and every code of it.

    Attributes:
        truth: (locations, masses), under the policy that is best at the acting gamma; ``truth_error`` bounds its
            Wasserstein-1 distance from the exact law.
        codes: (locations, masses) by the names in ``CODES``.
        distances: Wasserstein-1 distance of each from the truth, in units of reward.
    """

    gamma: float
    truth: tuple[np.ndarray, np.ndarray]
    truth_error: float
    codes: dict[str, tuple[np.ndarray, np.ndarray]]
    distances: dict[str, float]


def return_distributions(
    learned: Learned, state: str | int, action: int, *, seed_index: int = 0, settings: Settings | None = None
) -> Returns:
    """The codes of one return beside the true one; ``settings`` decode the tau-space of ``independent_steps``.

    Raises:
        InputError: the peers were not learned, or no such state, action or learner.
    """
    peers, s, world = learned.peers, learned.settings, learned.world
    if peers is None:
        raise InputError("these learners have no peers: learn again with peers on.")
    index, at = learned.seed_index(seed_index), world.state_index(state)
    if not 0 <= action < world.n_actions:
        raise InputError(f"action {action} is not there: use 0 to {world.n_actions - 1}.")
    pair = index, at, action
    result = study_of(learned, replace(settings or Settings(), state=str(at)), index)
    tau_space = result.decoded.tau_space[action]
    quantiles, expectiles = (table[pair].astype(float) for table in (peers.quantile, peers.expectile))
    levels = np.arange(1, expectiles.size + 1) / (expectiles.size + 1)
    codes = {
        "laplace": _point(peers.laplace_values[pair]),
        "independent_steps": independent_steps_return(tau_space, result.midpoints, s.peer_gamma**result.taus),
        "categorical": (peers.atoms, peers.categorical[pair].astype(float)),
        "quantile": (np.sort(quantiles), np.full(quantiles.size, 1.0 / quantiles.size)),
        "expectile": impute(expectiles, levels, peers.low, peers.high),
        "plain": _point(peers.plain[pair]),
    }
    truth = _true_return(world, at, action, s.acting_gamma, gamma=s.peer_gamma)
    law = truth.locations, truth.masses
    distances = {name: wasserstein(code, law) for name, code in codes.items()}
    return Returns(s.peer_gamma, law, truth.error, codes, distances)


def _point(value: float) -> tuple[np.ndarray, np.ndarray]:
    return np.array([float(value)]), np.ones(1)


@cached(16)
def _true_return(world: World, state: int, action: int, acting_gamma: float, *, gamma: float) -> ReturnDistribution:
    return return_distribution(world, state, action, _best_policy(world, acting_gamma), gamma=gamma)


def bounds_of(world: World, learning: ResolvedLearning) -> tuple[float, float]:
    """The range of the peers' atoms: bounds of the return under the policy that is best at the acting gamma."""
    return return_bounds(world, _best_policy(world, learning.acting_gamma), learning.peer_gamma)


def _best_policy(world: World, acting_gamma: float) -> np.ndarray:
    return policies_of(world, np.array([acting_gamma]), "shared", acting_gamma)[0]
