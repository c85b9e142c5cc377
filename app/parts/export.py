"""Taking a view along: how to read it, the command and the Python that make it, its arrays and tables."""

from __future__ import annotations

import numpy as np
import streamlit as st

from app import compute, explain, sources, state
from app.copy import copy_button
from app.parts.compare import pin_button
from app.query import VIEW
from app.sources import View
from laplace_core.saved import npz_bytes
from laplace_core.tables import gamma_space_csv, rewards_csv, tau_space_csv, values_csv

_LOOKS = next(parameter for parameter in VIEW if parameter.name == "look").choices
_TABLES = {
    "tau-space": tau_space_csv,
    "gamma-space": gamma_space_csv,
    "values over T": values_csv,
    "rewards and survival": rewards_csv,
}


def footer(view: View) -> None:
    look, regret, pin, reading, copying, download = st.columns([1.2, 2, 0.8, 1, 0.8, 0.9], vertical_alignment="center")
    with look:
        key = state.show("look", "heatmap")
        st.segmented_control(
            "Drawing", _LOOKS, key=key, on_change=state.keep, args=(key,), label_visibility="collapsed", required=True
        )
    regret.caption(_loss(view))
    # What lies in a closed popover is left out: formulas bring a large script along.
    words = reading.popover("How to read this", width="stretch", on_change="rerun", key="reading")
    if words.open:
        words.markdown(explain.READING)
    with pin:
        pin_button()
    _copying(copying, view)
    _downloads(download, view)


def _loss(view: View) -> str:
    lost = compute.episode_regrets(view)
    if lost is None or not len(lost):
        return ""
    found = compute.study_for(view)
    whole = int(np.clip(round(float(found.horizons[compute.row_of(view)])), 1, len(lost)))
    loss = lost[whole - 1] if lost[whole - 1] > 1e-6 else 0.0  # below that it is a near tie
    length = f"{whole} step" + ("s" if whole > 1 else "")
    return f"Acting by these values for an episode of {length} loses {loss:.3g} against the best."


def _copying(place, view: View) -> None:
    box = place.popover("Copy", width="stretch", on_change="rerun", key="copying")
    if not box.open:
        return
    with box:
        brought = state.world_name() in sources.BROUGHT
        read = None
        if brought and view.world is not None:
            read = f"read_world({view.settings.world!r})"
        copy_button("Copy as command", view.settings.to_command("view.npz"), "command")
        copy_button("Copy as Python", view.settings.to_python(read), "python")
        if brought:
            st.caption(f"Both read {view.settings.world}, so download or keep that file beside them.")


def _downloads(place, view: View) -> None:
    box = place.popover("Download", width="stretch", on_change="rerun", key="downloading")
    if not box.open:
        return
    found, name = compute.study_for(view), view.settings.world.removesuffix(".json").replace(":", "_")
    with box:
        _file("NPZ: every array and the settings", lambda: npz_bytes(found), f"{name}.npz", "application/octet-stream")
        for title, csv in _TABLES.items():
            _file(f"CSV: {title}", lambda csv=csv: csv(found), f"{name}_{title.replace(' ', '_')}.csv", "text/csv")
        st.caption("PNG and SVG: the buttons in the corner of each picture.")


def _file(label: str, data, file_name: str, mime: str) -> None:
    st.download_button(label, data, file_name=file_name, mime=mime, width="stretch", on_click="ignore")
