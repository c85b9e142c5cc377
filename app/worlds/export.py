"""Exports of a view of a world: its loss, the command and the Python code that make it, its arrays and tables."""

from __future__ import annotations

import numpy as np
import streamlit as st
from streamlit.delta_generator import DeltaGenerator

from app.components.copy import copy_button
from app.session import store
from app.session.typed import in_markdown
from app.view import compute
from app.view.explain import explain
from app.view.export import downloads
from app.worlds import sources
from app.worlds.actions import world_name
from laplace_core.subjects import View

TOO_LONG = "This view is too long for a link; download the world to keep it."
FILE_ONLY = "The link of this view does not hold your file: keep the file."


def footer(view: View) -> None:
    regret, words, copying, download = st.columns([3, 1, 0.8, 0.9], vertical_alignment="center")
    lacking = FILE_ONLY if view.world is None else TOO_LONG
    regret.caption(_loss(view) if sources.in_link(store.chosen()) else lacking)
    explain(words)
    _copying(copying, view)
    downloads(download, view)


def _loss(view: View) -> str:
    lost = compute.episode_regrets(view)
    if lost is None or not len(lost):
        return ""
    whole = int(np.clip(round(compute.horizon_of(view)), 1, len(lost)))
    loss = lost[whole - 1] if lost[whole - 1] > 1e-6 else 0.0  # below that it is a near tie
    length = f"{whole} step" + ("s" if whole > 1 else "")
    free = " (without the noise)" if view.settings.noise else ""
    constant = " with T at every step" if view.settings.deadline == "constant" else ""
    return f"An episode of {length} by these values{free}{constant} loses {loss:.3g} against the best."


def _copying(place: DeltaGenerator, view: View) -> None:
    box = place.popover("Copy", width="stretch", on_change="rerun", key="copying")
    if not box.open:
        return
    with box:
        file = view.settings_on_disk.world
        copy_button("Copy as command", view.settings_on_disk.to_command("view.npz"), "command")
        brought = world_name() in sources.BROUGHT and view.world is not None
        copy_button("Copy as Python", view.to_python(from_file=brought), "python")
        if view.learner is not None:
            mean = " The command shows the first learner, not the mean of all." if view.learner.index is None else ""
            st.caption(f"Both read {in_markdown(file)}: the button Download agent saves it.{mean}")
        elif world_name() in sources.BROUGHT:
            st.caption(f"Both read {in_markdown(file)}, so download or keep that file beside them.")
