"""Exports of a view: how to read it, the command and the Python code that make it, its arrays and tables."""

from __future__ import annotations

import re
from dataclasses import replace
from functools import partial

import streamlit as st
from streamlit.delta_generator import DeltaGenerator

from app.components.widgets import download
from app.view import compute
from app.view.explain import explain
from laplace_core import Study
from laplace_core.study.npz import npz_bytes
from laplace_core.study.tables import gamma_space_csv, rewards_csv, tau_space_csv, values_csv
from laplace_core.subjects import View

MOST_LINES = 1_000_000
"""Of a table; spreadsheets open little more."""
_TABLES = {
    "tau-space": tau_space_csv,
    "gamma-space": gamma_space_csv,
    "values over T": values_csv,
    "rewards and survival": rewards_csv,
}


def agent_footer(view: View) -> None:
    """The same for a trained agent, whose gamma-space no command can compute again."""
    _, words, download = st.columns([3.8, 1, 0.9], vertical_alignment="center")
    explain(words)
    downloads(download, view)


def downloads(place: DeltaGenerator, view: View) -> None:
    box = place.popover("Download", width="stretch", on_change="rerun", key="downloading")
    if not box.open:
        return
    settings, shown = view.settings_on_disk, compute.study_for(view)

    def study() -> Study:
        """Looked up when it is wanted, so that a button keeps no arrays."""
        study = compute.study_for(view)
        return replace(study, settings=replace(settings, alpha=study.settings.alpha))

    name = re.sub(r"[^A-Za-z0-9_.-]+", "_", re.sub(r"\.(json|npz|safetensors)$", "", settings.world))
    with box:
        download("NPZ: every array and the settings", lambda: npz_bytes(study()), f"{name}.npz", width="stretch")
        lines = {"tau-space": shown.decoded.tau_space.size, "gamma-space": shown.gamma_space.values.size}
        for title, csv in _TABLES.items():
            if lines.get(title, 0) > MOST_LINES:
                st.caption(f"CSV: {title} would have {lines[title]:,} lines, more than a spreadsheet opens: use NPZ.")
                continue
            file = f"{name}_{title.replace(' ', '_')}.csv"
            download(f"CSV: {title}", partial(lambda csv: csv(study()), csv), file, width="stretch")
        st.caption("PNG, SVG, CSV and HTML of the lens: the buttons under it.")
