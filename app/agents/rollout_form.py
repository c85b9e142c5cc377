"""Rolling out on the page of trained agents: the form, the progress, the player, and what can be taken along."""

from __future__ import annotations

from typing import Any

import streamlit as st

from app.agents import episode, rollout_jobs
from app.agents.artefact_jobs import flagging, for_player
from app.agents.episode import AT, GAMMA, HORIZON, PARAMETERS, RULE, SEED, SHOWN
from app.agents.rollout_jobs import Rolling
from app.agents.schema import OBSERVED
from app.catalogue import rules
from app.catalogue.scenes import Scene
from app.components.player import player
from app.session import store
from app.session.message import name_of
from app.view.subjects import View
from laplace_core import InputError
from laplace_core.acting.frames import animation
from laplace_core.acting.rollout import MOST_SEED, Rollout
from laplace_core.acting.rollout_file import rollout_npz
from laplace_core.agents.capabilities import HasDiscounts
from laplace_core.environments import environment_of, vector
from laplace_core.training.checkpoint import Loaded

LOOK_EVERY = 0.4  # seconds between two looks at a rollout in the making
_SLOWEST = 0.05  # seconds for a step on the screen, where life is faster


def limit_of(loaded: Loaded) -> int:
    """Steps after which an episode ends at the latest."""
    most = rollout_jobs.most_steps(loaded)
    return min(most, vector.spec(loaded.environment).time_limit or most)


def form(loaded: Loaded) -> None:
    """What is rolled out; a change counts at once while a rollout is shown."""
    values, limit = store.chosen(), limit_of(loaded)
    shown = episode.shown(values)
    titles = rules.rules_of(loaded.agent)
    key = store.show(RULE, next(iter(titles)))
    st.selectbox(
        "Control rule",
        list(titles),
        key=key,
        format_func=lambda name: titles.get(name, name),
        on_change=_keep,
        args=(key,),
    )
    left, right = st.columns(2, gap="small")
    key = store.show(SEED, PARAMETERS[SEED].default)
    left.number_input("Start seed", 0, MOST_SEED, step=1, key=key, on_change=_keep, args=(key,))
    rule = values.get(RULE, next(iter(titles)))
    with right:
        if rules.for_deadline(rule):
            key = store.put(HORIZON, min(limit, int(values.get(HORIZON) or limit)))
            st.number_input("T (steps)", 1, limit, step=1, key=key, on_change=_keep, args=(key,))
        elif rule == "greedy" and isinstance(loaded.agent, HasDiscounts):
            gammas = [float(gamma) for gamma in loaded.agent.gammas]
            at = values.get(GAMMA) or gammas[loaded.agent.acting_head]
            key = store.put(GAMMA, min(gammas, key=lambda gamma: abs(gamma - at)))
            st.selectbox("Discount", gammas, key=key, format_func="{:.4g}".format, on_change=_keep, args=(key,))
    if not shown:
        st.button("Roll out", type="primary", width="stretch", on_click=_begin)


def _keep(key: str) -> None:
    """Callback: another episode begins at its first step."""
    store.choose(AT, None)
    store.keep(key)


def _begin() -> None:
    store.choose(SHOWN, "yes")
    store.choose(AT, None)


def _close() -> None:
    for name in (SHOWN, AT):
        store.choose(name, None)
    store.refresh_sidebar()


def asked(loaded: Loaded) -> Rolling | None:
    """The rollout that the page shows, under way or done."""
    values = store.chosen()
    if not episode.shown(values):
        return None
    return rollout_jobs.rolling(
        loaded, episode.control_of(values, limit_of(loaded), next(iter(rules.rules_of(loaded.agent))))
    )


def beside(rolling: Rolling, scene: Scene) -> None:
    """In the sidebar, while a rollout is shown: its files, and two ways on."""
    if not rolling.going:
        try:
            rollout = rolling.rollout()
        except InputError:
            rollout = None
        if rollout is not None:
            _files(rollout)
            if not scene.states:
                st.button(
                    "Edit the state under the cursor", width="stretch", on_click=_edit, args=(rollout, scene),
                    help="Its numbers go to sliders, and the spaces follow them.",
                )  # fmt: skip
    st.button("Close the rollout", width="stretch", on_click=_close)


def _files(rollout: Rollout) -> None:
    name = f"{rollout.environment}_seed_{rollout.seed}_{rollout.rule}"
    left, right = st.columns(2, gap="small")
    left.download_button(
        "NPZ", lambda: rollout_npz(rollout), file_name=f"{name}.npz", mime="application/octet-stream", width="stretch",
        on_click="ignore", help="Every step's observation, action, reward, values and, if there is one, gamma-space.",
    )  # fmt: skip
    if rollout.frames:
        right.download_button(
            "GIF", lambda: animation(rollout.frames, environment_of(rollout.environment).seconds),
            file_name=f"{name}.gif", mime="image/gif", width="stretch", on_click="ignore", help="The episode, moving.",
        )  # fmt: skip


def _edit(rollout: Rollout, scene: Scene) -> None:
    """Callback: the sliders take over what is under the cursor, within their range."""
    found = episode.observation_at(rollout, episode.step_of(store.chosen(), rollout))
    for i, (value, part) in enumerate(zip(found, scene.components, strict=True)):
        store.choose(f"{OBSERVED}{i}", min(part.high, max(part.low, value)))
    _close()


def progress(rolling: Rolling) -> None:
    """How far it is, and a way out; the page is drawn anew when it is done."""
    if not rolling.going:
        st.rerun()
    share = rolling.done / rolling.of if rolling.of else 0.0
    words = f"step {rolling.done:,} of at most {rolling.of:,}" if rolling.of else "waits for the rollout before it"
    left, right = st.columns([6, 1], vertical_alignment="center")
    left.progress(min(1.0, share), f"Rolling out: {words}")
    right.button("Cancel", width="stretch", on_click=_cancel, args=(rolling,))


def _cancel(rolling: Rolling) -> None:
    rolling.cancel()
    _close()


def show(rolling: Rolling, scene: Scene, view: View | None = None) -> None:
    """The player, with the artefacts of every step under the settings of a view as soon as they are known.

    Without a view there is nothing decoded that artefacts could be in.
    """
    rollout = rolling.rollout()
    at = episode.step_of(store.chosen(), rollout)
    flags: dict[str, Any] | None = {"alpha": 0.0, "names": [], "marks": []}
    if view is not None:
        search = flagging(rolling, view)
        flags = None if search.going else for_player(search.result(), view.settings.alpha)

    def heard(step: int) -> None:
        store.choose(AT, min(step, len(rollout) - 1))

    names = [(part.name, part.unit) for part in scene.components]
    seconds = max(_SLOWEST, environment_of(rollout.environment).seconds)
    player(
        rolling.packed(),
        at,
        store.page_name(),
        names,
        action_names=scene.actions,
        on_step=heard,
        seconds=seconds,
        flags=flags,
    )


def lead(rolling: Rolling, step: int) -> dict[str, Any]:
    """The episode and the step that the lens is told of."""
    return {"id": name_of(rolling.packed()), "step": step}
