"""One episode of an agent, step by step: observations, actions, rewards, and predicted returns.

Definitions, at the acting discount gamma, with Q the agent's values there:

- ``received``: the observed return, G_t = r_t + gamma G_(t+1). After a termination nothing follows; a truncated
  episode is bootstrapped from the best value of the last observation.
- ``surprise``: the TD error r_t + gamma max_a Q(s_(t+1), a) - Q(s_t, a_t), 0 after a termination in
  place of the maximum (Sutton & Barto 2018, Eq. 6.11). It is local: an accident surprises once, where it happens.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace

import numpy as np
import torch

from laplace_core.acting.frames import picture_of
from laplace_core.acting.rules import RULES, Judge, Options, rules_of, title_of
from laplace_core.agents.agent import Agent
from laplace_core.agents.capabilities import HasDiscounts, HasGammaSpace, HasTimeToGo
from laplace_core.code.gamma_space import GammaSpace
from laplace_core.code.ties import greedy_action
from laplace_core.environments import vector
from laplace_core.errors import InputError

RANDOM = "random"
MOST_STEPS = 2_000
MOST_BYTES = 64_000_000
"""Most that the gamma-spaces of one rollout may take; pictures take some 3 kB each, everything else is small."""
MOST_SEED = 2**31 - 1
_USUAL = Options()
_AT_ONCE = 100  # observations in one pass through the network


@dataclass(frozen=True, eq=False)
class Rollout:
    """N steps with A actions, and for an agent with a gamma-space G discounts and H sensitivities.

    Attributes:
        seed, rule, horizon, gamma: as given to :func:`roll_out`; ``horizon`` is T, ``gamma`` that of ``greedy``.
        acting_gamma: discount of ``received``, ``surprise`` and ``greedy_values``.
        observations: ``(N + 1, O)``, float32; the last one is that after the last step.
        actions, rewards: ``(N,)``.
        values, greedy_values: ``(N, A)``: of all actions under the rule, and at the acting discount. An episode of
            random actions has the same in both.
        predicted, received, surprise: ``(N,)``, in units of reward, discounted.
        terminated: whether the episode terminated; else it was truncated.
        spaces, constants: gamma-space ``(N, A, G, H)`` and its constant channel ``(N, A, G)``, float32; None for an
            agent that has none.
        thetas, gammas: their axes.
        places: ``(H,)``, of the thetas on the axis of the activation; see :class:`GammaSpace`.
        frames: ``(N + 1,)`` JPEG files; empty if there are none.
    """

    environment: str
    seed: int
    rule: str
    horizon: int | None
    gamma: float | None
    acting_gamma: float
    observations: np.ndarray
    actions: np.ndarray
    rewards: np.ndarray
    values: np.ndarray
    greedy_values: np.ndarray
    predicted: np.ndarray
    received: np.ndarray
    surprise: np.ndarray
    terminated: bool
    spaces: np.ndarray | None = None
    constants: np.ndarray | None = None
    gammas: np.ndarray | None = None
    thetas: np.ndarray | None = None
    places: np.ndarray | None = None
    frames: tuple[bytes, ...] = ()

    def __len__(self) -> int:
        return len(self.actions)

    @property
    def of_the_values(self) -> bool:
        """Whether the episode followed the policy of the values: greedy at the acting discount."""
        return self.rule == "greedy" and self.gamma in (None, self.acting_gamma)

    @property
    def differs(self) -> np.ndarray:
        """``(N,)``: where the action taken is not the greedy one."""
        return self.actions != greedy_action(self.greedy_values)

    def space(self, step: int) -> GammaSpace:
        """Gamma-space of the observation before a step, ready to be decoded."""
        if self.spaces is None or self.constants is None or self.gammas is None or self.thetas is None:
            raise InputError("this agent has no gamma-space.")
        values, constant = self.spaces[step].astype(float), self.constants[step].astype(float)
        return GammaSpace(values, constant, self.gammas, self.thetas, open_ends=True, places=self.places)


def longest(agent: Agent) -> int:
    """Steps of a rollout of this agent whose gamma-spaces fit into ``MOST_BYTES``, at most ``MOST_STEPS``."""
    if not isinstance(agent, HasGammaSpace):
        return MOST_STEPS
    one = 4 * agent.n_actions * len(agent.gammas) * (len(agent.thetas) + 1)
    return min(MOST_STEPS, MOST_BYTES // one)


def roll_out(
    agent: Agent, environment: str, seed: int, *, rule: str = "greedy", horizon: int | None = None,
    gamma: float | None = None, options: Options = _USUAL, pictures: bool = False, limited: bool = True,
    spaces: bool = True, progress: Callable[[int, int], None] | None = None,
) -> Rollout:  # fmt: skip
    """Act for one episode, from the start that a seed gives.

    Args:
        seed: also of random actions.
        rule: a name in :data:`laplace_core.acting.rules.RULES`, or ``random``.
        horizon: T; the episode is stopped after so many steps. None leaves it to the environment's own limit.
        gamma: a discount for ``greedy``; the nearest one that was trained is taken. None is the acting discount.
        pictures: whether to keep a frame of every step.
        limited: whether the environment's own time limit truncates the episode.
        spaces: whether to keep gamma-spaces, which an agent must have.
        progress: called with (done, total) in steps; an exception that it raises cancels the rollout.

    Raises:
        InputError: arguments that do not fit, or a rule that the agent has not learned enough for.
    """
    spec, most = vector.spec(environment), longest(agent)
    if spec.observation != agent.n_observations or spec.actions != agent.n_actions:
        raise InputError(f"this agent was not trained for {environment}: its observations or actions differ.")
    if rule != RANDOM and rule not in RULES:
        raise InputError(f"rule {rule[:40]!r} is not one of {', '.join((*RULES, RANDOM))}.")
    if not 0 <= seed <= MOST_SEED:
        raise InputError(f"the seed is {seed}; it must be from 0 to {MOST_SEED}.")
    if horizon is not None and not 1 <= horizon <= most:
        raise InputError(f"the horizon is {horizon}; it must be from 1 to {most} steps.")
    length = length_of(agent, environment, horizon)
    judge, gamma = judge_of(agent, rule, length, gamma=gamma, options=options)
    acting = acting_gamma(agent)
    with one_thread():
        observations, values, actions, rewards, terminated, frames = _act(
            agent,
            environment,
            seed,
            judge,
            length=length,
            pictures=pictures,
            limited=limited,
            progress=progress or (lambda done, of: None),
        )
        greedy_values = _in_parts(lambda some: agent.action_values(some, agent.acting_head), observations)
        gamma_space = _spaces(agent, observations[:-1]) if spaces else _NONE
        predicted, received, surprise = _returns_and_td_errors(
            greedy_values, actions, rewards, terminated=terminated, gamma=acting
        )
    return Rollout(
        environment, seed, rule, horizon, gamma, acting, observations, actions, rewards,
        greedy_values[:-1] if judge is None else values, greedy_values[:-1],
        predicted, received, surprise, terminated, *gamma_space, frames,
    )  # fmt: skip


def length_of(agent: Agent, environment: str, horizon: int | None) -> int:
    """T of an episode: the horizon, or the environment's own limit as far as :func:`longest` allows it."""
    most = longest(agent)
    return horizon or min(most, vector.spec(environment).time_limit or most)


def titles_of(agent: Agent) -> dict[str, str]:
    """Rules that an agent can act by with nothing given, the first one by default, and what a form calls them."""
    suitable = (name for name in rules_of(agent) if not RULES[name].needs)
    titles = {name: title_of(name) for name in (*suitable, RANDOM)}
    if isinstance(agent, HasTimeToGo):
        titles["greedy"] = "greedy for the longest T"
    elif not isinstance(agent, HasDiscounts):
        titles["greedy"] = "greedy"
    return titles


def judge_of(
    agent: Agent, rule: str, length: int, *, gamma: float | None = None, options: Options = _USUAL
) -> tuple[Judge | None, float | None]:
    """Function that values actions at every step, None for random actions; and the discount nearest to ``gamma``.

    Raises:
        InputError: a rule that the agent has not learned enough for, or a discount that does not fit.
    """
    head, gamma = nearest_head(agent, rule, gamma)
    return (None if rule == RANDOM else RULES[rule].values(agent, length, replace(options, head=head))), gamma


@contextmanager
def one_thread() -> Iterator[None]:
    """Let torch use one thread: products of one observation are too small to be worth sharing."""
    before = torch.get_num_threads()
    torch.set_num_threads(1)
    try:
        yield
    finally:
        torch.set_num_threads(before)


def nearest_head(agent: Agent, rule: str, gamma: float | None) -> tuple[int | None, float | None]:
    """The head whose discount is nearest, and that discount; None for both where none is asked for.

    Raises:
        InputError: a discount that is none, or for a rule or an agent that has no choice of it.
    """
    if gamma is None:
        return None, None
    if rule != "greedy" or not isinstance(agent, HasDiscounts):
        raise InputError("a discount can be chosen only for the rule 'greedy' of an agent with many discounts.")
    if not 0.0 < gamma < 1.0:
        raise InputError(f"the discount is {gamma}; it must lie between 0 and 1.")
    head = int(np.abs(agent.gammas - gamma).argmin())
    return head, float(agent.gammas[head])


def acting_gamma(agent: Agent) -> float:
    """The discount of the values that an agent is meant to act by."""
    return float(agent.gammas[agent.acting_head] if isinstance(agent, HasDiscounts) else agent.settings.gamma)


def _act(
    agent: Agent, environment: str, seed: int, judge: Judge | None, *, length: int, pictures: bool,
    limited: bool, progress: Callable[[int, int], None],
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, bool, tuple[bytes, ...]]:  # fmt: skip
    """Observations ``(N + 1, O)``, values, actions, rewards, whether it terminated, and frames."""
    env, random = vector.make(environment, pictures=pictures, limited=limited), np.random.default_rng(seed)
    try:
        seen = [env.reset(seed=seed)[0].ravel()]
        values: list[np.ndarray] = []
        actions: list[int] = []
        rewards: list[float] = []
        frames = [picture_of(env)] if pictures else []
        over = terminated = False
        while not over and len(actions) < length:
            if judge is None:
                action = int(random.integers(agent.n_actions))
            else:
                values.append(judge(seen[-1][None], len(actions))[0])
                action = int(greedy_action(values[-1]))
            observation, reward, terminated, truncated, _ = env.step(action)
            seen.append(observation.ravel())
            actions.append(action)
            rewards.append(float(reward))
            if pictures:
                frames.append(picture_of(env))
            over = terminated or truncated
            progress(len(actions), length)
    finally:
        env.close()
    pictured = tuple(frame for frame in frames if frame is not None)
    arrays = np.array(seen, dtype=np.float32), np.array(values), np.array(actions), np.array(rewards)
    return *arrays, bool(terminated), pictured if len(pictured) == len(frames) else ()


def _returns_and_td_errors(
    greedy_values: np.ndarray, actions: np.ndarray, rewards: np.ndarray, *, terminated: bool, gamma: float
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Predicted returns, observed returns (``received``) and TD errors (``surprise``); values ``(N + 1, A)``."""
    predicted = greedy_values[np.arange(len(actions)), actions]
    following = greedy_values[1:].max(axis=1)
    if terminated:
        following[-1] = 0.0
    received, later = np.zeros(len(actions)), following[-1]
    for t in reversed(range(len(actions))):
        received[t] = later = rewards[t] + gamma * later
    return predicted, received, rewards + gamma * following - predicted


_GammaSpaceArrays = tuple[np.ndarray | None, np.ndarray | None, np.ndarray | None, np.ndarray | None, np.ndarray | None]
_NONE: _GammaSpaceArrays = (None, None, None, None, None)


def _spaces(agent: Agent, observations: np.ndarray) -> _GammaSpaceArrays:
    """``spaces``, ``constants`` and their axes; the network computes in single precision: nothing is lost."""
    if not isinstance(agent, HasGammaSpace):
        return _NONE
    parts = [
        [each.astype(np.float32) for each in agent.gamma_spaces(observations[i : i + _AT_ONCE])]
        for i in range(0, len(observations), _AT_ONCE)
    ]
    spaces, constants = (np.concatenate(column) for column in zip(*parts, strict=True))
    return spaces, constants, np.asarray(agent.gammas), np.asarray(agent.thetas), agent.sensitivities.places


def _in_parts(read: Callable[[np.ndarray], np.ndarray], observations: np.ndarray) -> np.ndarray:
    return np.concatenate([read(observations[i : i + _AT_ONCE]) for i in range(0, len(observations), _AT_ONCE)])
