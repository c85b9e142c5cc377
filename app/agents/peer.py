"""An agent without a gamma-space: in place of the lens, what it has learned of the return from the state at hand."""

from __future__ import annotations

import numpy as np
import streamlit as st

from app.agents import episode, returns, rollout_form
from app.agents.rollout_jobs import Rolling
from app.agents.schema import action_of, observation_of
from app.catalogue.scenes import Scene
from app.components.chart import chart
from app.session import store
from laplace_core import InputError, figures
from laplace_core.acting.return_laws import return_laws, return_quantiles
from laplace_core.acting.rollout import Rollout, acting_gamma
from laplace_core.agents.capabilities import HasTimeToGo
from laplace_core.figures.theme import HEIGHT, Figure
from laplace_core.training.checkpoint import Loaded


def view(loaded: Loaded, scene: Scene, asked: Rolling | None) -> None:
    """Everything under the navigation: the player, the pictures of the state, the codes side by side."""
    rollout, said, at, above = None, {}, 0, st.container()  # what is below keeps its place without the player, too
    try:
        if asked is not None:
            rollout, said = asked.rollout(), asked.said()
            with above:
                rollout_form.show(asked, scene)
            at = episode.step_of(store.chosen(), rollout)
    except InputError as error:
        st.error(str(error))
        return
    seen = observation_of(scene, store.chosen()) if rollout is None else episode.observation_at(rollout, at)
    taken = None if rollout is None else int(rollout.actions[at])
    action = _action(scene, taken)
    picture, alt = _of_state(loaded, scene, seen, action, rollout=rollout, at=at)
    left, right = st.columns(2, gap="small")
    with left:
        chart(figures.to_json(picture), "state", alt, HEIGHT, revision=loaded.algorithm)
    with right:
        if rollout is None:
            st.html('<div class="panel-title">along an episode</div>')
            st.caption("Roll out to see what was expected of every step, and what came.")
        else:
            figure = figures.returns_over_episode(
                rollout.received,
                rollout.predicted,
                return_quantiles(said, rollout.actions),
                at,
                gamma=rollout.acting_gamma,
                truncated=not rollout.terminated,
            )
            chart(figures.to_json(figure), "episode", "Expected and real return over the episode.", HEIGHT)
    returns.section(loaded, seen, action, scene.actions[action], alpha=None, rollout=rollout, step=at)


def _action(scene: Scene, taken: int | None) -> int:
    """The action that is shown: chosen here, or the one that was taken at the step."""
    if taken is None:
        key, options, now = "action", scene.actions, scene.actions[action_of(scene, store.chosen())]
    else:
        key, options = episode.ACTION, (episode.TAKEN, *scene.actions)
        wanted = store.chosen().get(key)
        now = wanted if wanted in options else episode.TAKEN
    st.segmented_control(
        "Action shown", options, key=store.put(key, now), on_change=store.keep, args=(key,), required=True,
        help="Drawn heavier here, and taken first in the comparison below.",
    )  # fmt: skip
    return taken if taken is not None and now == episode.TAKEN else scene.actions.index(now)


def _of_state(
    loaded: Loaded, scene: Scene, seen: tuple[float, ...], action: int, *, rollout: Rollout | None, at: int
) -> tuple[Figure, str]:
    """What the agent knows of this state, and what the picture shows."""
    agent, gamma, observation = loaded.agent, acting_gamma(loaded.agent), np.array(seen)
    if isinstance(agent, HasTimeToGo):
        left = None if rollout is None else min(agent.horizon, (rollout.horizon or agent.horizon + at) - at)
        values = agent.action_values(observation[None])[0]
        return figures.values_over_time_to_go(values, scene.actions, gamma, left), "Value over T, a line an action."
    laws = return_laws(agent, observation)
    if len(laws[0].locations) == 1:
        values = np.array([law.mean for law in laws])
        return figures.values_of_actions(values, scene.actions, gamma, action), "Value of every action."
    return figures.returns_of_actions(laws, scene.actions, action), "Distribution of the return of every action."
