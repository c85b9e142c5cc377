"""The environments that agents are trained in, stepped side by side, and their inner state for a resume point.

The list of environments is in :mod:`laplace_core.environments`.

gymnasium resets an environment on the step AFTER its episode ended and ignores that step's action. Such a step is no
transition: :class:`Environments` marks it, and hands out the true final observation of an episode before it.
"""

from __future__ import annotations

import importlib
from collections.abc import Callable
from typing import Any, NamedTuple

import gymnasium
import numpy as np
from gymnasium.envs.registration import load_env_creator
from gymnasium.spaces import Box, Discrete
from gymnasium.vector import AutoresetMode, SyncVectorEnv
from gymnasium.wrappers import TimeLimit

from laplace_core.environments import GYMNASIUM, environment_of
from laplace_core.errors import InputError
from laplace_core.worlds import load_world
from laplace_core.worlds.env import TabularEnv


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
    """Sizes of an environment that a network needs: numbers in an observation, actions, steps to truncation."""

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
    listed = environment_of(name)
    if name not in GYMNASIUM:
        world: gymnasium.Env = OneHot(TabularEnv(load_world(name)))
        return TimeLimit(world, listed.time_limit) if limited and listed.time_limit else world
    try:
        if listed.module:
            importlib.import_module(listed.module)
        # An environment that draws nothing need not know the word render_mode.
        drawing = {"render_mode": "rgb_array"} if pictures and _draws(name) else {}
        most = (limited and listed.time_limit) or -1  # gymnasium's word for no limit
        return gymnasium.make(name, disable_env_checker=True, max_episode_steps=most, **drawing)
    except gymnasium.error.DependencyNotInstalled:
        how = "see the instructions of its package" if listed.module else "pip install 'gymnasium[box2d]'"
        raise InputError(f"{name} needs packages that are not installed: {how}.") from None
    except ModuleNotFoundError as missing:
        raise InputError(f"{name} needs a package that is not installed: {missing.name}.") from None


def _draws(name: str) -> bool:
    """Whether an environment of gymnasium makes pictures; one that does not declare it makes none."""
    entry = gymnasium.spec(name).entry_point
    creator = load_env_creator(entry) if isinstance(entry, str) else entry
    metadata = getattr(creator, "metadata", None)
    return isinstance(metadata, dict) and "rgb_array" in metadata.get("render_modes", ())


def spec(name: str) -> Spec:
    """Sizes of an environment of the list, without building it: its physics need not be installed."""
    listed = environment_of(name)
    return Spec(len(listed.states or listed.components), len(listed.actions), listed.time_limit)


def chance(name: str) -> bool:
    """Whether the environment is stochastic after its start."""
    return environment_of(name).chance


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
        """Whether the inner state of these environments can be saved."""
        return all(_savable(env) for env in self._vector.envs)

    def state(self) -> dict[str, Any]:
        """The whole state of the environments, for JSON."""
        return {
            "over": self._over.tolist(),
            "elapsed": self._elapsed.tolist(),
            "fresh": self.fresh.tolist(),
            "observations": self.observations.tolist(),
            "inner": [_inner_state(env) for env in self._vector.envs],
        }

    def restore(self, state: dict[str, Any]) -> None:
        """Return the environments to a state that :meth:`state` gave."""
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
    return isinstance(env.unwrapped, TabularEnv) or _inner_names(env) is not None


def _inner_names(env: gymnasium.Env) -> tuple[str, ...] | None:
    """Attributes that are all of the inner state of one of gymnasium's environments; None where there is more to it."""
    return GYMNASIUM[env.spec.id].inner if env.spec is not None and env.spec.id in GYMNASIUM else None


def _time_limit(env: gymnasium.Env) -> TimeLimit | None:
    while isinstance(env, gymnasium.Wrapper):
        if isinstance(env, TimeLimit):
            return env
        env = env.env
    return None


def _inner_state(env: gymnasium.Env) -> dict[str, Any]:
    inner, limit = env.unwrapped, _time_limit(env)
    state: dict[str, Any] = {"random": inner.np_random.bit_generator.state}
    if limit is not None:
        state["steps"] = limit._elapsed_steps
    if isinstance(inner, TabularEnv):
        return state | {"_state": inner._state}
    values = {name: getattr(inner, name) for name in _inner_names(env) or ()}
    return state | {
        name: {"dtype": str(value.dtype), "values": value.tolist()} if isinstance(value, np.ndarray) else value
        for name, value in values.items()
    }


def _restore_inner(env: gymnasium.Env, state: dict[str, Any]) -> None:
    inner, limit = env.unwrapped, _time_limit(env)
    inner.np_random.bit_generator.state = state["random"]
    if limit is not None:
        limit._elapsed_steps = state["steps"]
    for name, value in state.items():
        if name not in ("random", "steps"):
            array = isinstance(value, dict)
            setattr(inner, name, np.array(value["values"], dtype=value["dtype"]) if array else value)
