"""Searches over settings: those that ship and those that were run here, each with its table and Optuna's pictures."""

from __future__ import annotations

from pathlib import Path

import streamlit as st

from app.catalogue import training_runs
from app.components.chart import chart
from app.components.copy import copy_button
from app.components.waiting import attempt
from app.components.widgets import download
from laplace_core.caching import cached
from laplace_core.experiments.search.results import SearchResult, kept, read, table
from laplace_core.figures import searches as figures
from laplace_core.figures.theme import Figure

COMMITTED = Path(__file__).resolve().parents[2] / "docs" / "searches"


def searches() -> None:
    """The section of the page, closed at first."""
    box = st.expander("Searches over settings", key="searches", on_change="rerun")
    if not box.open:
        return
    with box:
        files = attempt(lambda: kept(COMMITTED, training_runs.folder()))
        if not files:
            st.info("There is no search yet. The command `laplace search` makes one.")
            return
        path = files[st.selectbox("Search", list(files), key="search")]
        looked = attempt(lambda: _look(path, path.stat().st_mtime_ns))
        if looked is not None:
            _draw(path, *looked)


@cached(16)
def _look(path: Path, _written: int) -> tuple[SearchResult, list[Figure]]:
    search = read(path)
    study = figures.study_of(search)
    made = (figures.history(study), figures.importances(study), figures.slices(study))
    return search, [figure for figure in made if figure is not None]


def _draw(path: Path, search: SearchResult, drawn: list[Figure]) -> None:
    places = [*st.columns(len(drawn) - 1), st.container()]  # single settings side by side need a row of their own
    for place, figure in zip(places, drawn, strict=True):
        title = figure["layout"]["title"]["text"]
        chart(figure, f"search {title}", f"{title}: {path.stem}", revision=str(path), place=place)
    if len(search["trials"]) < figures.LEAST_FOR_IMPORTANCES:
        st.caption(f"Importances need {figures.LEAST_FOR_IMPORTANCES} trials; this search has {len(search['trials'])}.")
    st.code(table(search["trials"], one_at_a_time=search["one_at_a_time"]), language=None)
    with st.container(horizontal=True, gap="small"):
        copy_button("Copy the command", search["command"], "command of the search")
        download("Search (JSON)", path.read_bytes, f"{path.stem}.json")
