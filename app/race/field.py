"""Many races: the button, the progress, the picture of all differences, and ways to the starts that stand out."""

from __future__ import annotations

from html import escape
from typing import Any

import streamlit as st

from app.components.chart import chart
from app.components.copy import copy_button
from app.components.track import COLOURS
from app.race import form, jobs, schema, words
from app.race.jobs import Control
from app.race.schema import AT, COUNT, MANY, START
from app.session import store
from laplace_core import figures
from laplace_core.acting.race import Races
from laplace_core.acting.race_file import races_csv, races_npz
from laplace_core.figures.theme import HEIGHT

_KEY = "differences"


def section(control: Control) -> None:
    """A button; then progress; then the picture."""
    values = store.chosen()
    count = int(values.get(COUNT, schema.USUAL_COUNT))
    st.html('<div class="panel-title">from many starts</div>')
    if values.get(MANY) != "yes":
        words, button = st.columns([4.2, 1.2], vertical_alignment="center")
        words.caption(f"One start is an anecdote. The same race from the starts 0 to {count - 1}, without pictures.")
        button.button(f"Race over {count} starts", type="primary", width="stretch", on_click=_begin)
        return
    found = jobs.field(control, count)
    form.only("field", found)
    if found.going and not found.wait(0.3):
        st.fragment(_progress, run_every=form.LOOK_EVERY)(found)
        return
    if not form.refused(found):
        _shown(control, *found.result())


def _begin() -> None:
    store.choose(MANY, "yes")


def _progress(found: jobs.Field) -> None:
    bar, button = st.columns([4.2, 1.2], vertical_alignment="center")
    with bar:
        form.progress(found, "Racing")
    button.button("Cancel", key="cancel field", width="stretch", on_click=_cancel, args=(found,))


def _cancel(found: jobs.Field) -> None:
    found.cancel()
    store.choose(MANY, None)


def _shown(control: Control, found: Races, summary: dict[str, Any]) -> None:
    form.said(*words.field_verdict(summary, control))
    if summary["equal"] == 1.0:  # a hundred dots in one place
        with st.columns([1, 2.4])[0]:
            _files(control, found)
        return
    left, right = st.columns([2.4, 1], gap="medium")
    with left:
        _picture(found, summary, words.sides(control))
    with right:
        _facts(control, summary)
        _starts(found)
        _files(control, found)


def _picture(found: Races, summary: dict[str, Any], names: tuple[str, str]) -> None:
    mean, interval = float(summary["difference"]), tuple(summary["interval"])
    figure = figures.differences(found, mean, interval, int(store.chosen().get(START, 0)), colours=COLOURS, names=names)
    alt = f"Difference of return from {len(found.starts)} starts, on average {mean:.1f}, one dot a start."
    same = f"{found.environment} {found.horizon}"
    chart(figures.to_json(figure), _KEY, alt, HEIGHT, revision=same, on_click=lambda: _clicked(found))


def _clicked(found: Races) -> None:
    """Callback: a dot was clicked."""
    start = st.session_state[f"chart {_KEY}"].clicked
    if isinstance(start, int | float) and start in found.starts:
        _open(int(start))


def _open(start: int) -> None:
    """Callback: the race from this start is shown above."""
    store.choose(START, start)
    store.choose(AT, None)


def _facts(control: Control, summary: dict[str, Any]) -> None:
    left, right = map(escape, words.sides(control))
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
    told = "Mean returns; after ± one standard error; the interval by a bootstrap over starts."
    st.html(f'<table class="race-facts" title="{told}">{cells}</table>')


def _starts(found: Races) -> None:
    with st.container(horizontal=True, gap="small"):
        for name, start in found.notable().items():
            st.button(
                name, key=f"open {name}", on_click=_open, args=(start,),
                help=f"Show the race from start {start}, the {name} for the right side.",
            )  # fmt: skip


def _files(control: Control, found: Races) -> None:
    file = f"races_{found.environment}_T_{found.horizon}"
    told = {"left": control.left_rule, "right": control.right_rule, "gamma": control.gamma}
    with st.container(horizontal=True, gap="small"):
        st.download_button(
            "CSV", lambda: races_csv(found, *words.sides(control)), file_name=f"{file}.csv", mime="text/csv",
            on_click="ignore", help="A row a start: start seed, returns, difference, steps.",
        )  # fmt: skip
        st.download_button(
            "NPZ", lambda: races_npz(found, told), file_name=f"{file}.npz", mime="application/octet-stream",
            on_click="ignore", help="The same as arrays, and how they came about.",
        )  # fmt: skip
    copy_button("Copy as command", words.command(store.chosen(), control, len(found.starts)), "race command")
