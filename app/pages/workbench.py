"""The tabular workbench: one state of a world, from its gamma-space to the action of every horizon."""

from __future__ import annotations

from html import escape

import numpy as np
import streamlit as st

from app import compute, controls, explain, state
from app.chart import chart
from app.copy import copy_button
from app.figures.theme import HEIGHT
from laplace_core import InputError, Settings, Study, World, load_world
from laplace_core.settings import resolve

TONES = {"right": ("ok", "Right"), "lucky": ("warn", "Right, for the wrong reason"), "wrong": ("bad", "Wrong"),
         "unknown": ("warn", "No truth to compare with")}  # fmt: skip


def page() -> None:
    state.load_url()
    state.settled()
    for note in state.notes():
        st.warning(note)
    with st.sidebar:
        st.html('<div class="brand">Laplace code workbench</div>')
        controls.world_group()
        st.button("Reset to the world's own settings", on_click=state.reset, width="stretch")
        try:
            world = load_world(state.world_name(), state.world_params())
            state.drop_missing(world)
            wanted = resolve(state.settings(), world)
        except InputError as error:
            st.error(str(error))
            return
        controls.look_group(world, wanted, world.actions[_action(world)])
        learning = st.expander("Learning: discounts, sensitivities, policy", key="learning", on_change="rerun")
        if learning.open:
            with learning:
                controls.grid_group(wanted)
    _view()


@st.fragment
def _view() -> None:
    """The main area. Its own controls rerun only this, and leave the sidebar alone."""
    if state.sidebar_is_stale():
        st.rerun()
    state.write_url()
    world = load_world(state.world_name(), state.world_params())
    wanted = resolve(state.settings(), world)
    try:
        found = compute.study_for(wanted)
    except InputError as error:
        st.error(str(error))
        return
    row = _row(found, state.chosen().get("horizon"))
    above = st.container()
    _panels(found, wanted, _action(world), row)  # first, so that the pictures move before the words
    with above:
        _verdict(wanted, row)
    controls.live_group(found, float(found.horizons[row]))
    _footer(wanted, float(found.horizons[row]))


def _action(world: World) -> int:
    name = state.chosen().get("action")
    return world.actions.index(name) if name in world.actions else 0


def _row(found: Study, horizon: float | None) -> int:
    return len(found.horizons) - 1 if horizon is None else found.row_at(horizon)


def _verdict(settings: Settings, row: int) -> None:
    verdict = compute.verdict_for(settings, row)
    tone, word = TONES[verdict.kind]
    text, *buttons = st.columns([3.8, *[1.0] * len(verdict.remedies)], vertical_alignment="center")
    text.html(f'<div class="verdict {tone}" role="status"><p><b>{word}.</b> {escape(verdict.sentence)}</p></div>')
    for column, remedy in zip(buttons, verdict.remedies, strict=True):
        column.button(
            remedy.label, key=f"verdict {remedy.label}", on_click=state.apply_changes, args=(remedy.changes,),
            width="stretch", type="primary",
        )  # fmt: skip


def _panels(found: Study, settings: Settings, action: int, row: int) -> None:
    look = state.chosen().get("look", "heatmap")
    same = f"{settings.world} {settings.state} {action} {settings.steps} {look}"  # while it holds, zoom is kept
    drawn = {"settings": settings, "action": action, "row": row, "surface": look == "surface"}
    name = found.action_names[action]
    top, bottom = st.columns(3, gap="small"), st.columns(3, gap="small")
    with top[0]:
        alt = f"Graph of the world {settings.world}, state {settings.state} and action {name} lit up."
        picked = _chart("world", alt, f"{settings.world} {found.world.n_states}", _picked, **drawn)
        _pick_state(found, picked)
    with top[1]:
        _chart("gamma-space", f"Gamma-space of {name}: sensitivity across, discount up.", same, **drawn)
    with top[2]:
        _chart("tau-space", f"Tau-space of {name}: reward across, future step up, the truth outlined.", same, **drawn)
    with bottom[0]:
        _chart("values", "Value of each action over the horizon; a strip with the chosen and best one.", same, **drawn)
    with bottom[1]:
        _chart("rewards", f"Expected reward and survival of {name} over future steps, decoded and true.", same, **drawn)
    with bottom[2]:
        _artefacts(settings, action, name)


def _chart(name: str, alt: str, revision: str, on_click=None, **drawn):
    return chart(compute.figure(name, **drawn), name, alt, HEIGHT, revision, on_click)


def _picked() -> None:
    """A click on the graph is answered in the same run, by ``_pick_state``."""


def _pick_state(found: Study, picked: object) -> None:
    if isinstance(picked, int | float) and 0 <= picked < found.world.n_states:
        name = found.world.states[int(picked)]
        if name != found.settings.state:
            state.apply_changes({"state": name})
            st.rerun()


def _artefacts(settings: Settings, action: int, name: str) -> None:
    st.html(f'<div class="panel-title">artefacts in the tau-space of {escape(name)}</div>')
    found = compute.artefacts_for(settings, action)
    others = compute.artefacts_elsewhere(settings, action)
    if not found:
        st.html(f'<div class="artefact">None found for this action. {escape(others)}</div>')
    with st.container(key="artefacts"):
        for artefact in found:
            text, button = st.columns([2.0, 1], vertical_alignment="center")
            text.html(
                f'<div class="artefact"><b>{escape(artefact.name)}</b> · {escape(artefact.shown)}<br>'
                f"<span>{escape(artefact.sentence)}</span></div>"
            )
            for remedy in artefact.remedies[:1]:
                button.button(
                    remedy.label, key=f"fix {artefact.name}", on_click=state.apply_changes, args=(remedy.changes,),
                    width="stretch", wrap=True,
                )  # fmt: skip
        if found and others:
            st.html(f'<div class="artefact">{escape(others)}</div>')


def _footer(settings: Settings, horizon: float) -> None:
    look, regret, reading, command, download = st.columns([1, 2.0, 1, 1, 1], vertical_alignment="center")
    with look:
        key = state.show("look", "heatmap")
        st.segmented_control(
            "Drawing",
            state.VIEW[2].choices,
            key=key,
            on_change=state.keep,
            args=(key,),
            label_visibility="collapsed",
            required=True,
        )
    lost = compute.episode_regrets(settings)
    if lost is not None and len(lost):
        whole = int(np.clip(round(horizon), 1, len(lost)))
        loss = lost[whole - 1] if lost[whole - 1] > 1e-6 else 0.0  # below that it is a near tie
        length = f"{whole} step" + ("s" if whole > 1 else "")
        regret.caption(f"Acting by these values for an episode of {length} loses {loss:.3g} against the best.")
    # What lies in a closed popover is left out: formulas bring a large script along.
    words = reading.popover("How to read this", width="stretch", on_change="rerun", key="reading")
    if words.open:
        words.markdown(explain.READING)
    with command:
        copy_button("Copy as command", settings.to_command("view.npz"), "command")
    download.download_button(
        "Download NPZ", lambda: compute.npz_bytes(settings), file_name=f"{settings.world.replace(':', '_')}.npz",
        mime="application/octet-stream", width="stretch", on_click="ignore",
    )  # fmt: skip


page()
