"""The environments that agents are trained in: a fixed list, side by side, and their inner state for a resume point.

gymnasium resets an environment on the step AFTER its episode ended and ignores that step's action. Such a step is no
transition: :class:`Environments` marks it, and hands out the true final observation of an episode before it.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import gymnasium
import numpy as np
from gymnasium.spaces import Box, Discrete
from gymnasium.vector import AutoresetMode, SyncVectorEnv
from gymnasium.wrappers import TimeLimit

from laplace_core.agents.settings import ENVIRONMENTS, GYMNASIUM_ENVIRONMENTS
from laplace_core.errors import InputError
from laplace_core.worlds import load_world, toy_text_limit
from laplace_core.worlds.env import TabularEnv

WORLD_TIME_LIMIT = 200
"""Steps after which an episode in a preset world is truncated, and in one of gymnasium's that sets no limit itself."""

_POLE = ("state", "steps_beyond_terminated")
_INNER = {"CartPole-v1": _POLE, "CartPole-v0": _POLE, "Acrobot-v1": ("state",), "MountainCar-v0": ("state",)}
"""Attributes that are all of an environment's inner state besides its random numbers and its time."""


class OneHot(gymnasium.ObservationWrapper):
    """State indices as one-hot vectors."""

    def __init__(self, env: gymnasium.Env):
        super().__init__(env)
        assert isinstance(env.observation_space, Discrete)
        self.observation_space = Box(0.0, 1.0, (int(env.observation_space.n),), np.float32)
        self._size = int(env.observation_space.n)

    def observation(self, observation: int) -> np.ndarray:
        vector = np.zeros(self._size, np.float32)
        vector[observation] = 1.0
        return vector


class Spec(NamedTuple):
    """What a network must know of an environment: numbers in an observation, actions, steps to truncation."""

    observation: int
    actions: int
    time_limit: int | None


def make(name: str, *, pictures: bool = False, limited: bool = True) -> gymnasium.Env:
    """One environment of the list.

    Args:
        pictures: whether it is asked for them by ``render()``; a tabular world has none.
        limited: whether episodes are cut off at the environment's time limit.

    Raises:
        InputError: a name that is not on it, or one whose physics is not installed.
    """
    _check_listed(name)
    if name not in GYMNASIUM_ENVIRONMENTS:
        world = OneHot(TabularEnv(load_world(name)))
        return TimeLimit(world, _world_limit(name)) if limited else world
    mode = "rgb_array" if pictures else None
    try:
        return gymnasium.make(
            name, disable_env_checker=True, render_mode=mode, max_episode_steps=None if limited else -1
        )
    except gymnasium.error.DependencyNotInstalled:
        raise InputError(f"{name} needs packages that are not installed: pip install 'gymnasium[box2d]'.") from None


_SPECS = {
    "CartPole-v1": Spec(observation=4, actions=2, time_limit=500),
    "Acrobot-v1": Spec(observation=6, actions=3, time_limit=500),
    "LunarLander-v3": Spec(observation=8, actions=4, time_limit=1000),
    "MountainCar-v0": Spec(observation=2, actions=3, time_limit=200),
    "CartPole-v0": Spec(observation=4, actions=2, time_limit=200),
}  # written down, so that a checkpoint can be opened where the physics is not installed


def spec(name: str) -> Spec:
    """Sizes of an environment of the list, without building it."""
    _check_listed(name)
    if name in _SPECS:
        return _SPECS[name]
    world = load_world(name)
    return Spec(world.n_states, world.n_actions, _world_limit(name))


def _world_limit(name: str) -> int:
    """Steps to truncation in a tabular world: gymnasium's own where there is one."""
    return (toy_text_limit(name.removeprefix("gym:")) if name.startswith("gym:") else None) or WORLD_TIME_LIMIT


def chance(name: str) -> bool:
    """Whether the same action in the same state may lead to different things."""
    _check_listed(name)
    return name not in _INNER


def _check_listed(name: str) -> None:
    if name not in ENVIRONMENTS:
        raise InputError(f"environment {str(name)[:40]!r} is none of {', '.join(ENVIRONMENTS)}.")


class Stepped(NamedTuple):
    """One step of all environments.

    Attributes:
        real: ``(N,)``; False where the step was a reset, and its reward, ends and observation belong to no transition.
        observations: ``(N, O)``, after the step; the final one where an episode has ended.
        elapsed: ``(N,)``, steps of the episode so far.
    """

    real: np.ndarray
    observations: np.ndarray
    rewards: np.ndarray
    terminated: np.ndarray
    truncated: np.ndarray
    elapsed: np.ndarray


class Environments:
    """N environments side by side.

    Attributes:
        observations: ``(N, O)``, float32: what to act on.
        fresh: ``(N,)``; True where an episode begins with the next step.
    """

    def __init__(self, makers: list[Callable[[], gymnasium.Env]], seeds: list[int]):
        self._vector = SyncVectorEnv(makers, autoreset_mode=AutoresetMode.NEXT_STEP)
        self.count = len(makers)
        self._over = np.zeros(self.count, dtype=bool)
        self._elapsed = np.zeros(self.count, dtype=np.int64)
        self.fresh = np.ones(self.count, dtype=bool)
        self.observations = self._flat(self._vector.reset(seed=list(seeds))[0])

    def _flat(self, observations: np.ndarray) -> np.ndarray:
        return np.asarray(observations, dtype=np.float32).reshape(self.count, -1)

    def step(self, actions: np.ndarray) -> Stepped:
        real = ~self._over
        observations, rewards, terminated, truncated, _ = self._vector.step(actions)
        self.observations = self._flat(observations)
        self._elapsed = np.where(real, self._elapsed + 1, 0)
        self.fresh = ~real
        self._over = terminated | truncated
        return Stepped(real, self.observations, rewards, terminated, truncated, self._elapsed)

    @property
    def saves(self) -> bool:
        """Whether the inner state of these environments can be written down."""
        return all(_savable(env) for env in self._vector.envs)

    def state(self) -> dict[str, Any]:
        """All that decides what the environments do next, for JSON."""
        return {
            "over": self._over.tolist(),
            "elapsed": self._elapsed.tolist(),
            "fresh": self.fresh.tolist(),
            "observations": self.observations.tolist(),
            "inner": [_inner_state(env) for env in self._vector.envs],
        }

    def restore(self, state: dict[str, Any]) -> None:
        """Undo everything that has happened since :meth:`state`."""
        self._over = np.array(state["over"], dtype=bool)
        self._elapsed = np.array(state["elapsed"], dtype=np.int64)
        self.fresh = np.array(state["fresh"], dtype=bool)
        self.observations = np.array(state["observations"], dtype=np.float32)
        self._vector._autoreset_envs[:] = self._over
        for env, inner in zip(self._vector.envs, state["inner"], strict=True):
            _restore_inner(env, inner)

    def close(self) -> None:
        self._vector.close()


def _savable(env: gymnasium.Env) -> bool:
    return isinstance(env.unwrapped, TabularEnv) or (env.spec is not None and env.spec.id in _INNER)


def _time_limit(env: gymnasium.Env) -> TimeLimit | None:
    while isinstance(env, gymnasium.Wrapper):
        if isinstance(env, TimeLimit):
            return env
        env = env.env
    return None


def _inner_state(env: gymnasium.Env) -> dict[str, Any]:
    inner, limit = env.unwrapped, _time_limit(env)
    kept: dict[str, Any] = {"random": inner.np_random.bit_generator.state}
    if limit is not None:
        kept["steps"] = limit._elapsed_steps
    if isinstance(inner, TabularEnv):
        return kept | {"_state": inner._state}
    values = {name: getattr(inner, name) for name in _INNER[env.spec.id if env.spec else ""]}
    return kept | {
        name: {"dtype": str(value.dtype), "values": value.tolist()} if isinstance(value, np.ndarray) else value
        for name, value in values.items()
    }


def _restore_inner(env: gymnasium.Env, kept: dict[str, Any]) -> None:
    inner, limit = env.unwrapped, _time_limit(env)
    inner.np_random.bit_generator.state = kept["random"]
    if limit is not None:
        limit._elapsed_steps = kept["steps"]
    for name, value in kept.items():
        if name not in ("random", "steps"):
            array = isinstance(value, dict)
            setattr(inner, name, np.array(value["values"], dtype=value["dtype"]) if array else value)
