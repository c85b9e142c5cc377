"""The error of an agent's values at each of fifteen discounts, also if only every other one was trained.

The truth is the observed discounted return from every step of greedy episodes on: all discounts evaluate the policy of
the acting one, and the environments' steps are not random. An error is that of (1 - gamma) Q, in reward a step, so that
discounts compare. Where an episode was truncated, a step counts while what lies behind the end weighs less than
``NEGLIGIBLE``.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from laplace_core.acting.rollout import Rollout, roll_out
from laplace_core.agents.laplace import LaplaceAgent
from laplace_core.code.gamma_space import bin_differences, bin_values
from laplace_core.code.interpolation import mixing
from laplace_core.errors import InputError
from laplace_core.experiments.paper.result_files import BEST
from laplace_core.training.checkpoint import load_checkpoint

EPISODES, FIRST_START = 20, 700_000
"""Start seeds of the episodes, which no training, search or report uses."""
NEGLIGIBLE = 0.01


def value_errors(folder: Path, count: int) -> dict[str, Any]:
    """Mean absolute error at each discount, by the network itself and on straight lines between trained neighbours.

    Args:
        folder: of the run.
        count: discounts of the whole grid, of which the agent trained all or some.

    Returns:
        ``gammas``, ``trained``, ``network``, ``line`` and ``states``, a list each, of ``count`` discounts: an error is
        a mean over so many ``states``, and ``line`` is None where a discount was trained.

    Raises:
        InputError: no agent whose network takes the discount as an input.
    """
    loaded = load_checkpoint(folder / BEST)
    agent = loaded.agent
    if not isinstance(agent, LaplaceAgent):
        raise InputError(f"{folder} holds no Laplace DQN, which has values at many discounts.")
    gammas = replace(agent.settings, gammas=count).discounts()
    trained = np.isclose(gammas[:, None], agent.gammas, rtol=1e-9).any(axis=1)
    rollouts = [
        roll_out(agent, loaded.environment, seed, spaces=False) for seed in range(FIRST_START, FIRST_START + EPISODES)
    ]
    truth = np.concatenate([discounted_returns(each, gammas) for each in rollouts])
    known = np.concatenate([_known(each, gammas) for each in rollouts])
    by_network = np.concatenate([_values(agent, each, gammas) for each in rollouts])
    own = np.concatenate([_values(agent, each, agent.gammas) for each in rollouts])
    by_line = own @ mixing(agent.gammas, gammas).T
    errors = {
        name: [
            float(np.abs(values[known[:, g], g] - truth[known[:, g], g]).mean() * (1.0 - gammas[g]))
            for g in range(gammas.size)
        ]
        for name, values in (("network", by_network), ("line", by_line))
    }
    return {
        "gammas": gammas.tolist(),
        "trained": trained.tolist(),
        "network": np.round(errors["network"], 6).tolist(),
        "line": [None if each else round(error, 6) for each, error in zip(trained, errors["line"], strict=True)],
        "states": known.sum(axis=0).tolist(),
    }


def discounted_returns(rollout: Rollout, gammas: np.ndarray) -> np.ndarray:
    """G_t = r_t + gamma G_(t+1) from every step to the end of the episode, ``(N, G)``."""
    returns = np.zeros((len(rollout) + 1, gammas.size))
    for t in reversed(range(len(rollout))):
        returns[t] = rollout.rewards[t] + gammas * returns[t + 1]
    return returns[:-1]


def _known(rollout: Rollout, gammas: np.ndarray) -> np.ndarray:
    """Steps whose return is known: all of an episode that terminated, the early ones of one that was truncated."""
    left = np.arange(len(rollout), 0, -1)[:, None]
    return gammas**left <= (1.0 if rollout.terminated else NEGLIGIBLE)


def _values(agent: LaplaceAgent, rollout: Rollout, gammas: np.ndarray) -> np.ndarray:
    """Q of the actions that were taken, ``(N, G)``."""
    values, constant = agent.gamma_spaces(rollout.observations[:-1], gammas)
    q = bin_differences(values, constant, open_ends=True) @ bin_values(agent.thetas, open_ends=True)
    return q[np.arange(len(rollout)), rollout.actions]
