"""The view of an agent without a gamma-space: in place of the lens, what it has learned of the return of one state."""

from __future__ import annotations

import numpy as np
import streamlit as st

from app.agents import returns, rollout_form
from app.components.chart import chart
from app.session import store
from laplace_core import figures
from laplace_core.acting.return_laws import return_laws, return_quantiles
from laplace_core.acting.rollout import Rollout, acting_gamma
from laplace_core.agents.capabilities import HasTimeToGo
from laplace_core.environments import Environment
from laplace_core.figures.theme import Figure
from laplace_core.trained import rollouts
from laplace_core.trained.observations import action_of, observation_of
from laplace_core.trained.rollouts import RolledOut
from laplace_core.training.checkpoint import Loaded


def view(loaded: Loaded, scene: Environment, rolled: RolledOut | None) -> None:
    """Everything under the navigation: the player, the pictures of the state, the codes side by side."""
    rollout, at = None, 0
    with st.container():  # what is below keeps its place without the player, too
        if rolled is not None:
            rollout, at = rolled.rollout, rollouts.step_of(store.chosen(), rolled.rollout)
            rollout_form.show(rolled, scene)
    seen = observation_of(scene, store.chosen()) if rollout is None else rollouts.observation_at(rollout, at)
    taken = None if rollout is None else int(rollout.actions[at])
    action = _action(scene, taken)
    picture, alt = _of_state(loaded, scene, seen, action, rollout=rollout, at=at)
    left, right = st.columns(2, gap="small")
    chart(picture, "state", alt, revision=loaded.algorithm, place=left)
    with right:
        if rolled is None or rollout is None:
            st.html('<h2 class="panel-title">Return along an episode</h2>')
            st.caption("Roll out to see what was predicted at every step, and what was observed.")
        else:
            quantiles, gamma = return_quantiles(rolled.along, rollout.actions), rollout.acting_gamma
            figure = figures.returns_over_episode(
                rollout.received, rollout.predicted, quantiles, at, gamma=gamma, truncated=not rollout.terminated
            )
            chart(figure, "episode", "Predicted and observed return over the rollouts.")
    returns.section(loaded, seen, action, scene.actions[action], alpha=None, rollout=rollout, step=at)


def _action(scene: Environment, taken: int | None) -> int:
    """The action that is shown: chosen here, or the one that was taken at the step."""
    if taken is None:
        key, options, now = "action", scene.actions, scene.actions[action_of(scene, store.chosen())]
    else:
        key, options = rollouts.ACTION, (rollouts.TAKEN, *scene.actions)
        wanted = store.chosen().get(key)
        now = wanted if wanted in options else rollouts.TAKEN
    st.segmented_control(
        "Action shown", options, key=store.put(key, now), on_change=store.keep, args=(key,), required=True,
        help="Its line is thicker here, and it is the first action of the comparison below.",
    )  # fmt: skip
    return taken if taken is not None and now == rollouts.TAKEN else scene.actions.index(now)


def _of_state(
    loaded: Loaded, scene: Environment, seen: tuple[float, ...], action: int, *, rollout: Rollout | None, at: int
) -> tuple[Figure, str]:
    """What the agent knows of this state, and what the picture shows."""
    agent, gamma, observation = loaded.agent, acting_gamma(loaded.agent), np.array(seen)
    if isinstance(agent, HasTimeToGo):
        left = None if rollout is None else min(agent.horizon, (rollout.horizon or agent.horizon + at) - at)
        values = agent.action_values(observation[None])[0]
        return figures.values_over_time_to_go(values, scene.actions, gamma, left), "Value over T of each action."
    laws = return_laws(agent, observation)
    if len(laws[0].locations) == 1:
        values = np.array([law.mean for law in laws])
        return figures.values_of_actions(values, scene.actions, gamma, action), "Value of every action."
    return figures.returns_of_actions(laws, scene.actions, action), "Distribution of the return of every action."
