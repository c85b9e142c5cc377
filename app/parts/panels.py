"""The verdict, the pictures of a view and the list of artefacts."""

from __future__ import annotations

from html import escape

import streamlit as st

from app import compute, state
from app.chart import chart
from app.figures.theme import HEIGHT
from app.sources import View

TONES = {"right": ("ok", "Right"), "lucky": ("warn", "Right, for the wrong reason"), "wrong": ("bad", "Wrong"),
         "unknown": ("warn", "No truth to compare with")}  # fmt: skip


def verdict(view: View) -> None:
    found = compute.verdict_for(view)
    tone, word = TONES[found.kind]
    text, *buttons = st.columns([3.8, *[1.0] * len(found.remedies)], vertical_alignment="center")
    text.html(f'<div class="verdict {tone}" role="status"><p><b>{word}.</b> {escape(found.sentence)}</p></div>')
    for column, remedy in zip(buttons, found.remedies, strict=True):
        column.button(
            remedy.label, key=f"verdict {remedy.label}", on_click=state.apply_changes, args=(remedy.changes,),
            width="stretch", type="primary",
        )  # fmt: skip


def panels(view: View) -> None:
    look, settings = state.chosen().get("look", "heatmap"), view.settings
    name = compute.study_for(view).action_names[view.action]
    # While this holds, zoom and camera are kept.
    same = f"{settings.world} {settings.state} {view.action} {settings.steps} {look}"

    def picture(kind: str, alt: str, revision: str = same, on_click=None) -> object:
        return chart(compute.figure(kind, view, look == "surface"), kind, alt, HEIGHT, revision, on_click)

    top, bottom = st.columns(3, gap="small"), st.columns(3, gap="small")
    with top[0]:
        if view.world is None:
            picture("fit", f"Value of {name} at each discount, as learned and as the decoded timeline gives it back.")
        else:
            alt = f"Graph of the world {settings.world}, state {settings.state} and action {name} lit up."
            picked = picture("world", alt, f"{settings.world} {view.world.n_states}", _picked)
            _pick_state(view, picked)
    with top[1]:
        picture("gamma-space", f"Gamma-space of {name}: sensitivity across, discount up.")
    with top[2]:
        picture("tau-space", f"Tau-space of {name}: reward across, future step up, the truth outlined.")
    with bottom[0]:
        picture("values", "Value of each action over the horizon; a strip with the chosen and best one.")
    with bottom[1]:
        picture("rewards", f"Expected reward and survival of {name} over future steps, decoded and true.")
    with bottom[2]:
        _artefacts(view, name)


def _picked() -> None:
    """A click on the graph is answered in the same run, by ``_pick_state``."""


def _pick_state(view: View, picked: object) -> None:
    if isinstance(picked, int | float) and 0 <= picked < view.world.n_states:
        name = view.world.states[int(picked)]
        if name != view.settings.state:
            state.apply_changes({"state": name})
            st.rerun()


def _artefacts(view: View, name: str) -> None:
    st.html(f'<div class="panel-title">artefacts in the tau-space of {escape(name)}</div>')
    found = compute.artefacts_for(view)
    others = compute.artefacts_elsewhere(view)
    if not found:
        st.html(f'<div class="artefact">None found for this action. {escape(others)}</div>')
    with st.container(key="artefacts"):
        for artefact in found:
            text, button = st.columns([2.0, 1], vertical_alignment="center")
            text.html(
                f'<div class="artefact"><b>{escape(artefact.name)}</b> · {escape(artefact.shown)}<br>'
                f"<span>{escape(artefact.sentence)}</span></div>"
            )
            for remedy in artefact.remedies[:2]:
                button.button(
                    remedy.label, key=f"fix {artefact.name} {remedy.label}", on_click=state.apply_changes,
                    args=(remedy.changes,), width="stretch", wrap=True,
                )  # fmt: skip
        if found and others:
            st.html(f'<div class="artefact">{escape(others)}</div>')
