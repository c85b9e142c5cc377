"""The parts of the page: a list of the states, and a section for each figure and table of the paper."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape
from pathlib import Path

import streamlit as st

from app.components.chart import chart
from app.components.widgets import download
from laplace_core.experiments.paper.claims import MISSING, STATES, Found
from laplace_core.experiments.paper.pictures import CANNOT_DRAW, Picture, picture

_FEW = 12
"""Lines of a table that are shown beside the picture; longer tables unfold."""


def overview(found: Sequence[Found]) -> None:
    """The state of each entry, one line each, with a link to its section."""
    rows = "".join(
        f'<li><a href="#paper-{each.entry.name}">{_pill(each.state)}<span><b>{escape(each.entry.place)}</b> '
        f"{escape(each.entry.title)}{escape(_so_far(each))}</span></a></li>"
        for each in found
    )
    st.html(f'<ul class="paper-states">{rows}</ul>')
    used = {each.state for each in found}
    st.caption("; ".join(f"**{state}**: {words}" for state, words in STATES.items() if state in used) + ".")


def contents(found: Sequence[Found]) -> None:
    """The table of contents, in the sidebar."""
    rows = "".join(f'<li><a href="#paper-{each.entry.name}">{escape(each.entry.place)}</a></li>' for each in found)
    st.html(f'<ul class="paper-contents">{rows}</ul>')


def section(found: Found) -> None:
    """One figure, table or section of the paper."""
    entry = found.entry
    with st.container(key=f"paper_{entry.name}"):
        st.html(
            f'<h2 class="paper-title" id="paper-{entry.name}">{escape(entry.place)}: {escape(entry.title)} '
            f"{_pill(found.state)}</h2>{_claims(found)}"
        )
        drawn = _picture(found)
        numbers, place = st.columns([1, 1], gap="medium") if drawn else (st.container(), None)
        with numbers:
            _numbers(found)
        if drawn and place is not None:
            height = int(drawn.figure["layout"]["height"])
            with place:
                chart(drawn.figure, f"paper {entry.name}", drawn.alt, height, revision=entry.name)
        st.code(entry.makes, language="bash", wrap_lines=True)
        with st.container(horizontal=True, vertical_alignment="center"):
            _take_along(found)


def _pill(state: str) -> str:
    return f'<i class="paper-state {state.replace(" ", "-")}">{state}</i>'


def _so_far(found: Found) -> str:
    return "" if found.results.complete or found.results.planned is None else f" ({found.results.progress})"


def _claims(found: Found) -> str:
    """The claims of the paper, and under each one our numbers."""
    if found.trouble is not None:
        return f'<p class="paper-trouble">{escape(found.trouble)}</p>'
    rows = []
    if found.state == MISSING:  # said once for all claims
        said = "".join(f"<q>{escape(claim.says)}</q>" for claim in found.entry.claims)
        return f'<ul class="paper-claims"><li>{said}{escape(found.sentence(0))}</li></ul>'
    for index, (claim, finding) in enumerate(zip(found.entry.claims, found.findings, strict=True)):
        state = "" if finding is None else finding.state
        told = f"<b>{state.capitalize()}.</b> " if state else ""
        told += escape(found.sentence(index))
        rows.append(f'<li class="{state.replace(" ", "-")}"><q>{escape(claim.says)}</q> {told}</li>')
    return f'<ul class="paper-claims">{"".join(rows)}</ul>'


def _picture(found: Found) -> Picture | None:
    try:
        return picture(found)
    except CANNOT_DRAW:
        st.warning(f"{found.results.path.name} cannot be drawn: the file does not hold results.")
        return None


def _numbers(found: Found) -> None:
    if not found.lines:
        return
    st.html(_table(found, 0, _FEW))
    if len(found.lines) > _FEW:
        with st.expander(f"{len(found.lines) - _FEW} more lines"):
            st.html(_table(found, _FEW, len(found.lines)))


def _table(found: Found, first: int, last: int) -> str:
    rows = "".join(
        f"<tr><td>{escape(line.what)}</td><td>{escape(line.paper) or '-'}</td>"
        f"<td>{escape(line.ours) or 'not measured'}</td></tr>"
        for line in found.lines[first:last]
    )
    head = "<tr><th>what</th><th>the paper</th><th>ours</th></tr>"
    return f'<div class="paper-numbers"><table class="numbers">{head}{rows}</table></div>'


def _take_along(found: Found) -> None:
    """The raw results as a file, and the view of the workbench."""
    path, view = found.results.path, found.entry.view
    if found.results.there and path.exists():
        name = f"{path.stem}.json"
        download(f"Raw results ({name})", lambda: _content(path), name, key=f"raw_{found.entry.name}")
    if view is not None:
        st.page_link(
            f"screens/{view.page}.py", label="Open in the workbench", icon=":material/open_in_new:",
            query_params=dict(view.values),
        )  # fmt: skip


def _content(path: Path) -> bytes:
    """The content of a file, read on the click, or a list of the files in a folder; empty if it no longer exists."""
    try:
        if path.is_dir():
            return b"[" + b",".join(each.read_bytes() for each in sorted(path.glob("*.json"))) + b"]"
        return path.read_bytes()
    except OSError:
        return b""
