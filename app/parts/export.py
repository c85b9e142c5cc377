"""Taking a view along: how to read it, the command and the Python that make it, its arrays and tables."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace
from functools import partial

import numpy as np
import streamlit as st
from streamlit.delta_generator import DeltaGenerator

from app import compute, explain, link, sources, state
from app.copy import copy_button
from app.sources import View
from app.url import query_of
from app.world_actions import world_name
from laplace_core.saved import npz_bytes
from laplace_core.settings import Resolved
from laplace_core.tables import gamma_space_csv, rewards_csv, tau_space_csv, values_csv

_BYTES = "application/octet-stream"
TOO_LONG = "This view is too long for a link; download the world to keep it."
_TABLES = {
    "tau-space": tau_space_csv,
    "gamma-space": gamma_space_csv,
    "values over T": values_csv,
    "rewards and survival": rewards_csv,
}


def footer(view: View) -> None:
    regret, reading, copying, download = st.columns([3, 1, 0.8, 0.9], vertical_alignment="center")
    regret.caption(_loss(view) if link.fits(query_of(state.chosen())) else TOO_LONG)
    _reading(reading)
    _copying(copying, view)
    _downloads(download, view)


def agent_footer(view: View) -> None:
    """The same for a trained agent, whose gamma-space no command computes anew."""
    _, reading, download = st.columns([3.8, 1, 0.9], vertical_alignment="center")
    _reading(reading)
    _downloads(download, view)


def _reading(place: DeltaGenerator) -> None:
    """What lies in a closed popover is left out: formulas bring a large script along."""
    words = place.popover("How to read this", width="stretch", on_change="rerun", key="reading")
    if words.open:
        words.markdown(explain.READING)


def _loss(view: View) -> str:
    lost = compute.episode_regrets(view)
    if lost is None or not len(lost):
        return ""
    found = compute.study_for(view)
    whole = int(np.clip(round(float(found.horizons[compute.row_of(view)])), 1, len(lost)))
    loss = lost[whole - 1] if lost[whole - 1] > 1e-6 else 0.0  # below that it is a near tie
    length = f"{whole} step" + ("s" if whole > 1 else "")
    free = " (without the noise)" if view.settings.noise else ""
    constant = " with T at every step" if view.settings.deadline == "constant" else ""
    return f"Acting by these values{free}{constant} for an episode of {length} loses {loss:.3g} against the best."


def _copying(place: DeltaGenerator, view: View) -> None:
    box = place.popover("Copy", width="stretch", on_change="rerun", key="copying")
    if not box.open:
        return
    with box:
        file = settings_on_disk(view).world
        copy_button("Copy as command", settings_on_disk(view).to_command("view.npz"), "command")
        copy_button("Copy as Python", python_of(view), "python")
        if view.learner is not None:
            mean = " The command shows the first learner, not the mean of all." if view.learner.index is None else ""
            st.caption(f"Both read {file}: Download agent saves it.{mean}")
        elif world_name() in sources.BROUGHT:
            st.caption(f"Both read {file}, so download or keep that file beside them.")


def settings_on_disk(view: View) -> Resolved:
    """The settings by which the command line repeats a view: what was learned is read from its file."""
    if view.learner is None:
        return view.settings
    shown = view.learner.index
    file = f"{sources.plain_name(view.learner.world)}_td.safetensors"
    return replace(view.settings, world=file, params=() if shown is None else (("seed_index", shown),))


def python_of(view: View) -> str:
    """A script that repeats a view."""
    if view.learner is None:
        brought = world_name() in sources.BROUGHT and view.world is not None
        return view.settings.to_python(f'read_world("{view.settings.world}")' if brought else None)
    settings = view.settings.to_python().partition("settings = Settings(")[2]
    imports, found = "Settings", f"found = study_of(learned, settings, {view.learner.index})"
    if view.learner.index is None:
        imports = "Settings, study"
        found = (
            "tables = learned.basis[:, learned.world.state_index(settings.state)]  # a table a seed\n"
            "found = study(learned.world, settings, learned=tables.astype(float).mean(axis=0))"
        )
    return "\n".join(
        [
            f"from laplace_core import {imports}",
            f"from laplace_core.learned import read_learned{'' if view.learner.index is None else ', study_of'}",
            "",
            f'learned = read_learned("{settings_on_disk(view).world}")',
            "settings = Settings(" + settings.replace("found = study(world, settings)", found),
        ]
    )


def _downloads(place: DeltaGenerator, view: View) -> None:
    box = place.popover("Download", width="stretch", on_change="rerun", key="downloading")
    if not box.open:
        return
    settings = settings_on_disk(view)
    found = replace(compute.study_for(view), settings=settings)
    name = re.sub(r"[^A-Za-z0-9_.-]+", "_", re.sub(r"\.(json|npz|safetensors)$", "", settings.world))
    with box:
        _file("NPZ: every array and the settings", lambda: npz_bytes(found), f"{name}.npz", _BYTES)
        for title, csv in _TABLES.items():
            _file(f"CSV: {title}", partial(csv, found), f"{name}_{title.replace(' ', '_')}.csv", "text/csv")
        st.caption("PNG, SVG, CSV and HTML of the lens: the buttons under it.")


def _file(label: str, data: Callable[[], str | bytes], file_name: str, mime: str) -> None:
    st.download_button(label, data, file_name=file_name, mime=mime, width="stretch", on_click="ignore")
