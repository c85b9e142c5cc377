"""Rolling out on the page of trained agents: the form, the progress, the player, and the downloads."""

from __future__ import annotations

from typing import Any

import streamlit as st

from app.agents import jobs
from app.agents.jobs import Rolling
from app.components.player import player
from app.components.waiting import offer, progress
from app.components.widgets import discount, download, field, select
from app.session import store
from app.session.jobs import Wish
from app.view import compute
from laplace_core.acting.frames import animation
from laplace_core.acting.rollout import Rollout, titles_of
from laplace_core.acting.rollout_file import rollout_npz
from laplace_core.agents.capabilities import HasDiscounts
from laplace_core.environments import Environment, environment_of
from laplace_core.exchange.messages import name_of
from laplace_core.subjects import View
from laplace_core.trained import rollouts
from laplace_core.trained.observations import OBSERVED
from laplace_core.trained.rollouts import AT, GAMMA, HORIZON, PARAMETERS, RULE, SEED, SHOWN, Control, RolledOut
from laplace_core.training.checkpoint import Loaded

_SLOWEST = 0.05  # seconds for a step on the screen, where life is faster


def form(loaded: Loaded) -> None:
    """The settings of a rollout; a change counts at once while a rollout is shown."""
    control, titles = _control(loaded), titles_of(loaded.agent)
    select("Control rule", list(titles), store.put(RULE, control.rule), titles, keep=_keep)
    left, right = st.columns(2, gap="small")
    field(PARAMETERS[SEED], control.seed, "Start seed", keep=_keep, place=left, help=None)
    if control.horizon is not None:
        key = store.put(HORIZON, control.horizon)
        right.number_input("T (steps)", 1, rollouts.limit_of(loaded), step=1, key=key, on_change=_keep, args=(key,))
    elif control.rule == "greedy" and isinstance(loaded.agent, HasDiscounts):
        gammas = loaded.agent.gammas
        with right:
            discount("Discount", gammas, GAMMA, control.gamma or gammas[loaded.agent.acting_head], keep=_keep)
    if not rollouts.shown(store.chosen()):
        st.button("Roll out", type="primary", width="stretch", on_click=_begin, args=(jobs.rolling(loaded, control),))


def _keep(key: str) -> None:
    """Callback: another episode begins at its first step."""
    store.choose(AT, None)
    store.keep(key)


def _begin(wish: Wish[RolledOut]) -> None:
    """Callback."""
    wish.begin()
    store.choose(SHOWN, "yes")
    store.choose(AT, None)


def _close() -> None:
    for name in (SHOWN, AT):
        store.choose(name, None)
    store.refresh_sidebar()


def asked(loaded: Loaded) -> Wish[RolledOut] | None:
    """The rollout that the page shows, if it shows one."""
    return jobs.rolling(loaded, _control(loaded)) if rollouts.shown(store.chosen()) else None


def _control(loaded: Loaded) -> Control:
    return rollouts.control_of(store.chosen(), rollouts.limit_of(loaded), next(iter(titles_of(loaded.agent))))


def beside(rolling: Rolling | None, scene: Environment) -> None:
    """In the sidebar, while a rollout is shown: its files, a button to edit the state and one to close it."""
    if rolling is not None and rolling.worked:
        rollout = rolling.result().rollout
        _files(rollout)
        if not scene.states:
            st.button(
                "Edit the state under the cursor", width="stretch", on_click=_edit, args=(rollout, scene),
                help="Copies this state to the sliders, so that you can change it by hand.",
            )  # fmt: skip
    st.button("Close the rollout", width="stretch", on_click=_close)


def _files(rollout: Rollout) -> None:
    name = f"{rollout.environment}_seed_{rollout.seed}_{rollout.rule}"
    seconds = environment_of(rollout.environment).seconds
    left, right = st.columns(2, gap="small")
    npz, gif = (lambda: rollout_npz(rollout)), (lambda: animation(rollout.frames, seconds))
    contents = "Every step's observation, action, reward, values and, if there is one, gamma-space."
    download("NPZ", npz, f"{name}.npz", place=left, width="stretch", help=contents)
    if rollout.frames:
        download("GIF", gif, f"{name}.gif", place=right, width="stretch", help="The episode as an animated GIF.")


def _edit(rollout: Rollout, scene: Environment) -> None:
    """Callback: copy the observation under the cursor to the sliders, within their range."""
    observation = rollouts.observation_at(rollout, rollouts.step_of(store.chosen(), rollout))
    for i, (value, part) in enumerate(zip(observation, scene.components, strict=True)):
        store.choose(f"{OBSERVED}{i}", min(part.high, max(part.low, value)))
    _close()


def under_way(wish: Wish[RolledOut], rolling: Rolling | None) -> None:
    """Progress with a Cancel button; or a button to begin, if the rollout takes long and nobody has begun it."""

    def cancel() -> None:
        wish.cancel()
        _close()

    if rolling is None:
        words, button = st.columns([4.2, 1.2], vertical_alignment="center")
        offer(wish, "Roll out", key="begin rollout", place=words, button_place=button, primary=True)
        return
    progress(rolling, "Rolling out: step {done:,} of at most {of:,}", cancel, key="cancel rollout")


def show(rolled: RolledOut, scene: Environment, view: View | None = None) -> None:
    """The player, with the artefacts of every step under the settings of a view as soon as they are known.

    Without a view there is nothing decoded that artefacts could be in.
    """
    rollout, at = rolled.rollout, rollouts.step_of(store.chosen(), rolled.rollout)
    flags: dict[str, Any] | None = {"alpha": 0.0, "names": [], "marks": []}
    if view is not None:
        search = jobs.artefacts(rolled, view).look()
        flags = (
            None
            if search is None or search.going
            else rollouts.marks_of(search.result(), compute.study_for(view).settings.alpha)
        )
    player(
        rolled.packed, at, store.page_name(), [(part.name, part.unit) for part in scene.components],
        action_names=scene.actions, on_step=lambda step: store.choose(AT, min(step, len(rollout) - 1)),
        seconds=max(_SLOWEST, environment_of(rollout.environment).seconds), flags=flags,
    )  # fmt: skip


def lead(rolled: RolledOut, step: int) -> dict[str, Any]:
    """The episode and the step that the lens follows."""
    return {"id": name_of(rolled.packed), "step": step}
