"""Many races: the button, the progress, the picture of all differences, and buttons for notable starts."""

from __future__ import annotations

from functools import partial
from html import escape
from typing import Any

import streamlit as st

from app.catalogue import checkpoints
from app.components.chart import chart
from app.components.copy import copy_button
from app.components.track import COLOURS
from app.components.waiting import attempt, offer, progress
from app.components.widgets import download
from app.race import form, jobs
from app.race.schema import AGAINST, AGENT
from app.session import store
from laplace_core import figures
from laplace_core.acting.race import Races
from laplace_core.acting.race_file import races_csv, races_npz
from laplace_core.trained.races import AT, COUNT, MANY, START, USUAL_COUNT, Control, command, field_verdict, sides

_KEY = "differences"


def section(control: Control) -> None:
    """A button; then progress; then the picture."""
    values = store.chosen()
    count = int(values.get(COUNT, USUAL_COUNT))
    st.html('<h2 class="panel-title">The same race from many starts</h2>')
    wish = jobs.field(control, count)
    job = wish.look() if values.get(MANY) == "yes" else None
    if job is None:
        caption, button = st.columns([4.2, 1.2], vertical_alignment="center")
        words = f"One start shows little. Run the same race from the starts 0 to {count - 1}, without pictures."
        offer(wish, f"Race over {count} starts", key="begin field", words=words, place=caption, button_place=button,
              primary=True, then=partial(store.choose, MANY, "yes"))  # fmt: skip
        return

    def cancel() -> None:
        wish.cancel()
        store.choose(MANY, None)

    if job.going and not job.wait(0.3):
        progress(job, form.RACING, cancel, key="cancel field")
        return
    many = attempt(job.result)
    if many is not None:
        _shown(control, *many)


def _shown(control: Control, races: Races, summary: dict[str, Any]) -> None:
    form.verdict(*field_verdict(summary, control))
    if summary["equal"] == 1.0:  # a hundred dots in one place
        with st.columns([1, 2.4])[0]:
            _files(control, races)
        return
    left, right = st.columns([2.4, 1], gap="medium")
    with left:
        _picture(races, summary, sides(control))
    with right:
        _facts(control, summary)
        _starts(races)
        _files(control, races)


def _picture(races: Races, summary: dict[str, Any], names: tuple[str, str]) -> None:
    mean, interval = float(summary["difference"]), tuple(summary["interval"])
    figure = figures.differences(races, mean, interval, int(store.chosen().get(START, 0)), colours=COLOURS, names=names)
    alt = f"Difference of return from {len(races.starts)} starts, on average {mean:.1f}; one dot for each start."
    same = f"{races.environment} {races.horizon}"
    chart(figure, _KEY, alt, revision=same, on_click=lambda: _clicked(races))


def _clicked(races: Races) -> None:
    """Callback: a dot was clicked."""
    start = st.session_state[f"chart {_KEY}"].clicked
    if isinstance(start, int | float) and start in races.starts:
        _open(int(start))


def _open(start: int) -> None:
    """Callback: the race from this start is shown above."""
    store.choose(START, start)
    store.choose(AT, None)


def _facts(control: Control, summary: dict[str, Any]) -> None:
    left, right = map(escape, sides(control))
    low, high = summary["interval"]
    rows = [
        (f'<i style="background:{COLOURS[0]}"></i>{left}', f"{summary['left']:.1f}"),
        (f'<i style="background:{COLOURS[1]}"></i>{right}', f"{summary['right']:.1f}"),
        ("difference", f"{summary['difference']:+.1f} ± {summary['standard_error']:.1f}"),
        ("95% interval", f"{low:+.1f} to {high:+.1f}"),
        (f"{right} ahead", f"{summary['better']:.0%}"),
        ("level", f"{summary['equal']:.0%}"),
        (f"{left} ahead", f"{summary['worse']:.0%}"),
    ]
    cells = "".join(f"<tr><td>{name}</td><td>{value}</td></tr>" for name, value in rows)
    hint = "Mean returns, ± one standard error; the interval is a bootstrap over starts."
    st.html(f'<table class="race-facts" title="{hint}">{cells}</table>')


def _starts(races: Races) -> None:
    with st.container(horizontal=True, gap="small"):
        for name, start in races.notable().items():
            st.button(
                name, key=f"open {name}", on_click=_open, args=(start,),
                help=f"Show the race from start {start}, the {name} for the right side.",
            )  # fmt: skip


def _files(control: Control, races: Races) -> None:
    file = f"races_{races.environment}_T_{races.horizon}"
    settings = {"left": control.left_rule, "right": control.right_rule, "gamma": control.gamma}
    with st.container(horizontal=True, gap="small"):
        columns = "One row for each start: start seed, returns, difference, steps."
        contents = "The same data as NumPy arrays, with the settings that produced them."
        download("CSV", lambda: races_csv(races, *sides(control)), f"{file}.csv", help=columns)
        download("NPZ", lambda: races_npz(races, settings), f"{file}.npz", help=contents)
    copy_button("Copy as command", _command(control, len(races.starts)), "race command")


def _command(control: Control, count: int) -> str:
    values = store.chosen()
    file, other = (checkpoints.file_of(str(values[name])) if name in values else None for name in (AGENT, AGAINST))
    return command(control, count, str(file), other)
