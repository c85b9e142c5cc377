"""How well an agent acts: whole episodes from start seeds that no training run ever uses."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from laplace_core.agents.agent import Agent
from laplace_core.errors import InputError
from laplace_core.horizon import readout_weights, target_discounts
from laplace_core.pipeline import GammaSpace, decode_and_read
from laplace_core.settings import Settings
from laplace_core.ties import greedy_action
from laplace_core.training import environments

RULES = ("greedy", "readout", "decoded")
FIRST_SEED = 2 * 10**12
"""Start seeds of :func:`evaluate`; training starts below 10^9, and evaluations while training at half of this."""
_AT_ONCE = 100  # episodes side by side


@dataclass(frozen=True, eq=False)
class Scores:
    """What came of N episodes.

    Attributes:
        returns, lengths: ``(N,)``.
        running: ``(N,)``, whether each was still running at its end.
        starts: ``(N, O)``, the first observations.
        discounted: ``(N, G)``, returns at the discounts that were asked for.
    """

    returns: np.ndarray
    lengths: np.ndarray
    running: np.ndarray
    starts: np.ndarray
    discounted: np.ndarray

    @property
    def mean(self) -> float:
        return float(self.returns.mean())

    @property
    def standard_error(self) -> float:
        return float(_standard_error(self.returns))

    @property
    def discounted_errors(self) -> np.ndarray:
        """Standard error of the mean at every discount, ``(G,)``."""
        return _standard_error(self.discounted)


def _standard_error(values: np.ndarray) -> np.ndarray:
    """Of the mean over the first axis; 0 for one value, of which nothing is known."""
    count = len(values)
    return values.std(axis=0, ddof=1) / np.sqrt(count) if count > 1 else np.zeros(values.shape[1:])


def evaluate(
    agent: Agent, environment: str, episodes: int = 100, seed: int = 0, horizon: int | None = None,
    softness: float = 0.2, rule: str = "greedy", alpha: float = 1.0, steps: int = 1000, first_seed: int = FIRST_SEED,
    discounts: np.ndarray | None = None,
) -> Scores:  # fmt: skip
    """Act without exploration and add up rewards.

    ``greedy`` takes the best action at the acting discount. ``readout`` weighs the values of all discounts for the
    time to go, T - t at step t, by :func:`laplace_core.horizon.readout_weights`; ``decoded`` reaches the same through
    the tau-space, slowly.

    Args:
        horizon: T; the episode is stopped after so many steps. None leaves it to the environment's own limit.
        softness: width of the deadline as a fraction of the time to go.
        alpha, steps: regularisation and length of the inverse, for the last two rules.
        discounts: ``(G,)``, for the discounted returns.

    Raises:
        InputError: arguments that do not fit, or a rule that the agent has no discounts for.
    """
    spec = environments.spec(environment)
    if spec.observation != agent.n_observations or spec.actions != agent.n_actions:
        raise InputError(f"this agent was not trained for {environment}: its observations or actions differ.")
    if rule not in RULES:
        raise InputError(f"rule {rule[:40]!r} is not one of {', '.join(RULES)}.")
    if not 1 <= episodes <= 100_000 or not 0 <= seed <= 10**6:
        raise InputError("episodes must be from 1 to 100,000, and the seed from 0 to 1,000,000.")
    length = horizon or spec.time_limit
    if horizon is not None and not 1 <= horizon <= 10_000:
        raise InputError(f"the horizon is {horizon}; it must be from 1 to 10,000 steps.")
    choose = _chooser(agent, rule, length, softness, alpha, steps)
    starts = [first_seed + seed * 100_000 + i for i in range(episodes)]
    gammas = np.zeros(0) if discounts is None else np.asarray(discounts, dtype=float)
    parts = [
        _episodes(choose, environment, starts[i : i + _AT_ONCE], length, gammas) for i in range(0, episodes, _AT_ONCE)
    ]
    return Scores(*(np.concatenate(column) for column in zip(*parts, strict=True)))


def _episodes(choose, environment: str, starts: list[int], length: int | None, gammas: np.ndarray):
    """The columns of :class:`Scores`, of one episode from each start seed, all in step."""
    envs = [environments.make(environment) for _ in starts]
    observations = np.array([env.reset(seed=start)[0].ravel() for env, start in zip(envs, starts, strict=True)])
    first = observations.copy()
    returns, lengths, discounted = (
        np.zeros(len(envs)),
        np.zeros(len(envs), dtype=int),
        np.zeros((len(envs), gammas.size)),
    )
    terminated, going = np.zeros(len(envs), bool), np.arange(len(envs))
    time = 0
    while going.size and (length is None or time < length):
        actions, still = choose(observations[going], time), []
        for i, action in zip(going, actions, strict=True):
            observation, reward, terminated[i], truncated, _ = envs[i].step(int(action))
            observations[i] = observation.ravel()
            returns[i] += reward
            discounted[i] += gammas**time * reward
            lengths[i] += 1
            if not (terminated[i] or truncated):
                still.append(i)
        going, time = np.array(still, dtype=int), time + 1
    for env in envs:
        env.close()
    return returns, lengths, ~terminated, first, discounted


def _chooser(agent: Agent, rule: str, length: int | None, softness: float, alpha: float, steps: int):
    """A function from observations ``(B, O)`` and the step t to actions ``(B,)``."""
    if rule == "greedy":
        return lambda observations, time: agent.greedy(observations)
    if not hasattr(agent, "gammas"):
        raise InputError(f"rule {rule!r} needs an agent with many discounts.")
    if length is None:
        raise InputError(f"rule {rule!r} needs a horizon here: the environment has no time limit.")
    gammas, acting = agent.gammas, float(agent.gammas[agent.acting_head])
    if rule == "readout":
        # Row T - 1 of the table is for T steps to go.
        wanted = [target_discounts(T, max(steps, length), acting, softness) for T in range(1, length + 1)]
        weights = readout_weights(gammas, np.array(wanted), alpha)
        return lambda observations, time: greedy_action(
            np.einsum("bga,g->ba", agent.action_values(observations), weights[length - time - 1])
        )
    settings = Settings(
        alpha=alpha, steps=max(steps, length), time_step=1.0, normalise="none", acting_gamma=acting, softness=softness
    )

    def decoded(observations: np.ndarray, time: int) -> np.ndarray:
        found = zip(*agent.gamma_spaces(observations), strict=True)
        values = [
            decode_and_read(GammaSpace(*one, gammas, agent.thetas), settings).horizon_values[:, length - time - 1]
            for one in found
        ]
        return greedy_action(np.array(values))

    return decoded
