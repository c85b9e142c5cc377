"""Rolling out on the page of trained agents: the form, the progress, the player, and what can be taken along."""

from __future__ import annotations

from typing import Any

import streamlit as st

from app import rolled, rollouts, state
from app.flagging import flagging, for_player
from app.message import name_of
from app.observations import Scene
from app.player import player
from app.rolled import AT, GAMMA, HORIZON, PARAMETERS, RULE, SEED, SHOWN
from app.rollouts import Rolling
from app.sources import View
from app.trained import OBSERVED
from laplace_core import InputError
from laplace_core.agents.capabilities import HasDiscounts
from laplace_core.environments import environment_of
from laplace_core.training import environments
from laplace_core.training.checkpoint import Loaded
from laplace_core.training.frames import animation
from laplace_core.training.rollout import MOST_SEED, Rollout
from laplace_core.training.rollout_file import rollout_npz

LOOK_EVERY = 0.4  # seconds between two looks at a rollout in the making
_SLOWEST = 0.05  # seconds for a step on the screen, where life is faster


def limit_of(loaded: Loaded) -> int:
    """Steps after which an episode ends at the latest."""
    most = rollouts.most_steps(loaded)
    return min(most, environments.spec(loaded.environment).time_limit or most)


def form(loaded: Loaded) -> None:
    """What is rolled out; a change counts at once while a rollout is shown."""
    values, limit = state.chosen(), limit_of(loaded)
    shown = rolled.shown(values)
    rules = rolled.rules_of(loaded.agent)
    key = state.show(RULE, next(iter(rules)))
    st.selectbox(
        "Control rule",
        list(rules),
        key=key,
        format_func=lambda name: rules.get(name, name),
        on_change=_keep,
        args=(key,),
    )
    left, right = st.columns(2, gap="small")
    key = state.show(SEED, PARAMETERS[SEED].default)
    left.number_input("Start seed", 0, MOST_SEED, step=1, key=key, on_change=_keep, args=(key,))
    rule = values.get(RULE, next(iter(rules)))
    with right:
        if rolled.for_deadline(rule):
            key = state.put(HORIZON, min(limit, int(values.get(HORIZON) or limit)))
            st.number_input("T (steps)", 1, limit, step=1, key=key, on_change=_keep, args=(key,))
        elif rule == "greedy" and isinstance(loaded.agent, HasDiscounts):
            gammas = [float(gamma) for gamma in loaded.agent.gammas]
            at = values.get(GAMMA) or gammas[loaded.agent.acting_head]
            key = state.put(GAMMA, min(gammas, key=lambda gamma: abs(gamma - at)))
            st.selectbox("Discount", gammas, key=key, format_func="{:.4g}".format, on_change=_keep, args=(key,))
    if not shown:
        st.button("Roll out", type="primary", width="stretch", on_click=_begin)


def _keep(key: str) -> None:
    """Callback: another episode begins at its first step."""
    state.choose(AT, None)
    state.keep(key)


def _begin() -> None:
    state.choose(SHOWN, "yes")
    state.choose(AT, None)


def _close() -> None:
    for name in (SHOWN, AT):
        state.choose(name, None)
    state.refresh_sidebar()


def asked(loaded: Loaded) -> Rolling | None:
    """The rollout that the page shows, under way or done."""
    values = state.chosen()
    if not rolled.shown(values):
        return None
    return rollouts.rolling(
        loaded, rolled.control_of(values, limit_of(loaded), next(iter(rolled.rules_of(loaded.agent))))
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
    found = rolled.observation_at(rollout, rolled.step_of(state.chosen(), rollout))
    for i, (value, part) in enumerate(zip(found, scene.components, strict=True)):
        state.choose(f"{OBSERVED}{i}", min(part.high, max(part.low, value)))
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
    at = rolled.step_of(state.chosen(), rollout)
    flags: dict[str, Any] | None = {"alpha": 0.0, "names": [], "marks": []}
    if view is not None:
        search = flagging(rolling, view)
        flags = None if search.going else for_player(search.result(), view.settings.alpha)

    def heard(step: int) -> None:
        state.choose(AT, min(step, len(rollout) - 1))

    names = [(part.name, part.unit) for part in scene.components]
    seconds = max(_SLOWEST, environment_of(rollout.environment).seconds)
    player(
        rolling.packed(),
        at,
        state.page_name(),
        names,
        action_names=scene.actions,
        on_step=heard,
        seconds=seconds,
        flags=flags,
    )


def lead(rolling: Rolling, step: int) -> dict[str, Any]:
    """The episode and the step that the lens is told of."""
    return {"id": name_of(rolling.packed()), "step": step}
