"""A world as a gymnasium environment, the way back from :mod:`laplace_core.worlds.toy_text`."""

from __future__ import annotations

from typing import Any

import gymnasium
import numpy as np
from gymnasium.spaces import Discrete

from laplace_core.worlds.model import END, World


class TabularEnv(gymnasium.Env):
    """Samples a :class:`World`; observations are state indices.

    Entering an absorbing state terminates. A step to END returns the state it left as its observation, since END is
    not a state.
    There is no time limit: wrap in ``gymnasium.wrappers.TimeLimit`` where the world may run for ever.
    """

    metadata: dict[str, Any] = {  # noqa: RUF012 - gymnasium declares it so
        "render_modes": ["ansi"],
        "render_fps": 4,
    }

    def __init__(self, world: World, render_mode: str | None = None):
        if render_mode not in (None, "ansi"):
            raise ValueError(f"render_mode {render_mode!r} is not None or 'ansi'")
        self.world = world
        self.render_mode = render_mode
        self.observation_space = Discrete(world.n_states)
        self.action_space = Discrete(world.n_actions)
        self._state: int | None = None
        # Outcome rows of a pair are contiguous: bounds and cumulated probabilities make a draw one search.
        pairs = np.arange(world.n_states * world.n_actions + 1)
        self._bounds = np.searchsorted(world.state * world.n_actions + world.action, pairs)

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[int, dict[str, Any]]:
        """Draw a first state; ``options={"state": name_or_index}`` starts from a given one."""
        super().reset(seed=seed)
        given = (options or {}).get("state")
        world = self.world
        self._state = (
            int(self.np_random.choice(world.n_states, p=world.start)) if given is None else world.state_index(given)
        )
        return self._state, {}

    def step(self, action: int) -> tuple[int, float, bool, bool, dict[str, Any]]:
        if self._state is None:
            raise gymnasium.error.ResetNeeded("call reset() before step(): no episode is running")
        if not self.action_space.contains(action):
            raise ValueError(f"action {action!r} is not in {self.action_space}")
        world, pair = self.world, self._state * self.world.n_actions + int(action)
        first, last = self._bounds[pair], self._bounds[pair + 1]
        draw = np.searchsorted(np.cumsum(world.probability[first:last]), self.np_random.random(), side="right")
        row = first + min(int(draw), last - first - 1)  # the sum of the probabilities may round below 1
        reward, successor = float(world.reward[row]), int(world.next_state[row])
        terminated = bool(world.following[row] == END)
        observation = self._state if successor == END else successor
        self._state = None if terminated else successor
        return observation, reward, terminated, False, {}

    def render(self) -> str | None:
        if self.render_mode != "ansi":
            return None
        return "END" if self._state is None else self.world.states[self._state]
