"""One card for each run: its progress, its score, and its buttons."""

from __future__ import annotations

import shlex
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from html import escape
from pathlib import Path

import streamlit as st
from streamlit.delta_generator import DeltaGenerator

from app import session
from app.catalogue import training_runs
from app.components.copy import copy_button
from app.components.waiting import attempt
from app.components.widgets import download
from app.session import store
from app.session.typed import in_markdown
from app.train import form
from app.train.pictures import colour_of
from laplace_core import InputError
from laplace_core.figures.theme import NEUTRAL
from laplace_core.supervise.limits import limits
from laplace_core.training import words
from laplace_core.training.curves import Curves, metrics_csv
from laplace_core.training.defaults import command_of
from laplace_core.training.progress import read_progress
from laplace_core.training.queue import FAILED, STOPPED, STOPPING, Run
from laplace_core.words import capital

SHOWN = 12
"""Cards before the button for all."""
_MOST_DOWNLOAD = 200_000_000  # bytes


@dataclass
class _Cards:
    """The state of the cards in a session.

    Attributes:
        everything: whether all runs have a card.
        to_open: name of the run that is to be opened on the other page.
        to_remove: names of the runs that are removed at the next, second, word.
        placed: the run whose card was drawn last in each column and row, and whether in the second of its places.
    """

    everything: bool = False
    to_open: str | None = None
    to_remove: set[str] = field(default_factory=set)
    placed: dict[int, tuple[str, bool]] = field(default_factory=dict)


def cards(runs: Sequence[Run], looked: Run | None) -> None:
    """Draw all cards, two in a row."""
    shown = runs if session.part(_Cards).everything else runs[:SHOWN]
    for first in range(0, len(shown), 2):
        pairs = zip(st.columns(2, gap="small"), shown[first : first + 2], strict=False)
        for at, (column, run) in enumerate(pairs, first):
            with _place(column, at, run.name):
                _card(runs, run, looked=run == looked)
    if len(runs) > len(shown):
        st.button(f"Show all {len(runs)} runs", on_click=_show_all)


@contextmanager
def _place(column: DeltaGenerator, at: int, name: str) -> Iterator[None]:
    """The place of a run's card, which is one of two: where another run had the last one, its card is not drawn over.

    The browser would keep that one's buttons in the new card until their turn comes, and a click on one run would reach
    another.
    """
    placed = session.part(_Cards).placed
    last, second = placed.get(at, (name, False))
    second ^= last != name
    placed[at] = name, second
    if second:
        column.empty()
    with column.container(border=True, key=f"run_{name}"):
        yield
    if not second:
        column.empty()


def _show_all() -> None:
    session.part(_Cards).everything = True


def _card(runs: Sequence[Run], run: Run, *, looked: bool) -> None:
    mine = training_runs.may_change(run)
    if run.settings is None:
        _head(run, run.name, NEUTRAL, looked=False)
        st.html(f'<div class="run-error">{escape(capital(run.error or "it failed."))}</div>')
        if mine:
            _more(run, None)
        return
    settings, curves, progress = run.settings, training_runs.curves(run), read_progress(run.folder)
    _head(run, words.title(settings), colour_of(runs, run), looked=looked)
    st.progress(*words.progress(run, progress, curves, limits().trainings))
    st.html(f'<div class="run-note">{escape(curves.in_words)}<br>{escape(words.set_by_hand(settings))}</div>')
    if run.error:
        st.html(f'<div class="run-error">{escape(capital(run.error or "it failed."))}</div>')
    with st.container(horizontal=True, gap="small"):
        if not mine:
            st.caption("Read only." if limits().read_only else "Started in another browser.")
        elif run.state == STOPPING:
            st.button("End at once", key=f"end {run.name}", on_click=_do, args=("end_at_once", run.name),
                      help="Ends it without saving. What it learned since its last resume point is lost.")  # fmt: skip
        elif run.going:
            st.button("Cancel", key=f"cancel {run.name}", on_click=_do, args=("stop", run.name))
        elif run.state in (STOPPED, FAILED):
            st.button("Resume", key=f"resume {run.name}", on_click=_do, args=("resume", run.name))
        st.button("Show", key=f"show {run.name}", on_click=form.show, args=(run.name,), disabled=looked)
        _open(run)
        if mine:
            _more(run, curves)


def _head(run: Run, title: str, colour: str, *, looked: bool) -> None:
    shown = " shown" if looked else ""
    st.html(
        f'<div class="run-head{shown}"><i style="background:{colour}"></i><b>{escape(title)}</b>'
        f'<span class="run-state {run.state}">{escape(words.state(run))}</span></div>'
    )


def _do(what: str, name: str) -> None:
    """Callback: stop, resume or remove a run."""
    try:
        training_runs.change(what, name)
    except InputError as error:
        st.toast(in_markdown(error))


def _open(run: Run) -> None:
    """The other page, on the best checkpoint so far."""
    why = None if run.best else "After the first evaluation."
    st.button(
        "Open in Trained agents", key=f"open {run.name}", disabled=why is not None, help=why, on_click=_wish_to_open,
        args=(run.name,),
    )  # fmt: skip
    if session.part(_Cards).to_open == run.name:
        session.part(_Cards).to_open = None
        st.switch_page("screens/agents.py", query_params={"checkpoint": f"run:{run.name}"})


def _wish_to_open(name: str) -> None:
    """Callback. The wish is kept until a run of the page sees it: one that polls may come between click and answer."""
    session.part(_Cards).to_open = name


def _more(run: Run, curves: Curves | None) -> None:
    box = st.popover("More", on_change="rerun", key=f"more_{run.name}")
    if not box.open:
        return
    with box:
        if curves is not None:
            metrics, (left, right) = run.folder / "metrics.jsonl", st.columns(2, gap="small")
            with left:
                _file("Best checkpoint", run.folder / "best.safetensors", f"{run.name}.safetensors")
                _file("Settings (JSON)", run.folder / "config.json", f"{run.name}.json")
            with right:
                _file("Metrics (JSONL)", metrics, f"{run.name}.jsonl")
                _file("Metrics (CSV)", metrics, f"{run.name}.csv", metrics_csv)
            made = attempt(lambda: command_of(words.settings_of(run), f"runs/{run.name}_again"))
            if made is not None:
                command = shlex.join(["python", "-m", "laplace_core", *made])
                copy_button("Copy the command", command, f"command {run.name}")
        st.caption(f"In {in_markdown(run.folder)}")
        if run.name in session.part(_Cards).to_remove:
            sure = f"Yes, remove {in_markdown(run.name)} for good"
            st.button(sure, key=f"yes {run.name}", type="primary", width="stretch", on_click=_remove, args=(run.name,))
        else:
            st.button("Remove ...", key=f"remove {run.name}", width="stretch", on_click=_ask, args=(run.name,))


def _ask(name: str) -> None:
    session.part(_Cards).to_remove.add(name)


def _remove(name: str) -> None:
    session.part(_Cards).to_remove.discard(name)
    if store.chosen().get("run") == name:
        store.choose("run", None)
    _do("remove", name)


def _file(label: str, path: Path, name: str, read: Callable[[Path], bytes] = Path.read_bytes) -> None:
    """A download of a file of a run, if it exists and is not too large."""
    if path.is_file() and not path.is_symlink() and path.stat().st_size <= _MOST_DOWNLOAD:
        download(label, lambda: read(path), name, width="stretch", key=f"file {name}")
