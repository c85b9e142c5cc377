"""The user's own data: files to open, the world as a table, a timeline drawn by hand."""

from __future__ import annotations

from dataclasses import dataclass, field

import streamlit as st
from streamlit.delta_generator import DeltaGenerator

from app import session
from app.catalogue import tabular
from app.components.widgets import download, left_out, upload
from app.session import store
from app.session.typed import in_markdown
from app.worlds import sources
from app.worlds.actions import edit_world, go_to, world_name
from laplace_core import InputError, World
from laplace_core.subjects import View
from laplace_core.worlds import (
    dump_world,
    parse_world_bytes,
    rescaled,
    timeline_world,
    world_rows,
)
from laplace_core.worlds.table import as_cells, from_cells, with_rows
from laplace_core.worlds.timeline import FIRST_TIMELINE, packed_timeline, timeline_rows_of

MOST_ROWS = 2_000
_CONTENTS = (
    "A world file (see Your own world in the Guide); arrays gamma_space (actions, discounts, thetas), gammas, thetas; "
    "or an agent that was saved by Download agent."
)


def open_group(world: World | None) -> None:
    """In the sidebar: a file of one's own, or the present world as a table."""
    box = st.expander("Bring your own", key="bring", on_change="rerun")
    if not box.open:
        return
    with box:
        kinds = "World (.json), gamma-space (.npz) or learned agent (.safetensors)"
        upload(kinds, ("json", "npz", "safetensors"), "upload", _open, help=_CONTENTS)
        agents = tabular.learners()
        for name in (name for name, refusal in agents.items() if refusal is None):
            title = in_markdown(name.removesuffix("_td").replace("_", " "))
            st.button(f"Open the learned {title}", on_click=_open_agent, args=(name,), width="stretch")
        left_out([refusal for refusal in agents.values() if refusal is not None])
        if world is not None and world_name() not in sources.BROUGHT:
            st.button("Edit this world as a table", on_click=edit_world, args=(world,), width="stretch")
        if world_name() != sources.TIMELINE:
            drawn = {"world": sources.TIMELINE, "timeline": FIRST_TIMELINE, "edit": "yes"}
            st.button("Draw a timeline", on_click=go_to, kwargs=drawn, width="stretch")


def _open_agent(name: str) -> None:
    go_to(**sources.world_values(tabular.agent(name).world), source="learned", agent=name)


def _open(name: str, data: bytes) -> None:
    """An uploaded file replaces the view."""
    ending = name.lower().rpartition(".")[2]
    if ending == "json":
        go_to(world=sources.OWN, own=sources.word_of(parse_world_bytes(data, name)))
    elif ending == "safetensors":
        _open_agent(tabular.open_agent(name, data))
    else:
        go_to(world=sources.DATA, data=sources.open_gamma_space(name, data), normalise="none")


def editor(view: View) -> None:
    """Under the pictures: the world or the timeline as a table, if it is open."""
    name = world_name()
    if view.world is None:
        return
    if name == sources.OWN:
        _world_table(view.world)
    elif name == sources.TIMELINE:
        _timeline_table(view.world)


@dataclass
class _Table:
    """One table: the packed rows that it holds, those that it was opened with, and how often it was opened."""

    word: str | None = None
    base: str = ""
    version: int = 0


@dataclass
class _Tables:
    """All of a session, by what they show."""

    by_kind: dict[str, _Table] = field(default_factory=dict)


def _table(kind: str) -> _Table:
    return session.part(_Tables).by_kind.setdefault(kind, _Table())


def _version(word: str, kind: str) -> str:
    """Key of a table's widget: a new one when its content was changed from elsewhere, else the same.

    A table keeps its edits relative to the rows that it was opened with, so those rows must stay; a table that was
    off the page has lost its edits, and begins with the rows as they are now.
    """
    table = _table(kind)
    if table.word != word or f"{kind} table {table.version}" not in st.session_state:
        table.word, table.base, table.version = word, word, table.version + 1
    return f"{kind} table {table.version}"


def _edited(kind: str, word: str, new: str) -> None:
    """Apply a change that was made in the table itself."""
    if new != word:
        _table(kind).word = new
        store.choose(kind, new)
        st.rerun()


def _world_table(world: World) -> None:
    word = str(store.chosen()[sources.OWN])
    st.html('<h2 class="panel-title">The world as a table: each row is one possible outcome of an action</h2>')
    if world.state.size > MOST_ROWS:
        st.caption(f"{world.state.size:,} outcomes are too many for a table: download the file, edit and open it.")
        _download(world)
        return
    key = _version(word, sources.OWN)
    base = sources.own_world(_table(sources.OWN).base)
    rows = st.data_editor(
        as_cells(world_rows(base)), key=key, num_rows="dynamic", height=260, width="stretch", hide_index=True,
        column_config={
            "probability": st.column_config.TextColumn(default="1"),
            "reward": st.column_config.TextColumn(default="0"),
            "next": st.column_config.TextColumn("next state", help="END terminates the episode.", default="END"),
        },
    )  # fmt: skip
    left, right, _ = st.columns([1, 1, 3])
    with left:
        _download(world)
    try:
        made = with_rows(base, rows)
    except InputError as error:
        st.warning(f"Not applied yet: {in_markdown(error)}")
        _offer_rescale(right, rows, base)
        return
    _edited(sources.OWN, word, sources.word_of(made))


def _offer_rescale(place: DeltaGenerator, rows: list[dict], base: World) -> None:
    """A button for the most common mistake: probabilities that do not sum to 1."""
    try:
        made = with_rows(base, rescaled(rows))
    except InputError:
        return
    place.button("Rescale probabilities to 1", on_click=_take_over, args=(sources.word_of(made),))


def _take_over(word: str) -> None:
    """Callback: show these rows, even if they make the same world."""
    _table(sources.OWN).word = None
    store.choose(sources.OWN, word)


def _download(world: World) -> None:
    download("Download world", lambda: dump_world(world), sources.file_name(world), width="stretch")


def _timeline_table(world: World) -> None:
    word = str(store.chosen()[sources.TIMELINE])
    st.html('<h2 class="panel-title">Your timeline: each row is a reward with its future step and probability</h2>')
    key = _version(word, sources.TIMELINE)
    base, rest = timeline_rows_of(_table(sources.TIMELINE).base)
    table, beside = st.columns([3, 1.2])
    with beside:
        _download(world)
        words = {"zero": "pays 0 and continues", "ended": "ends the episode"}
        chosen_rest = st.radio("The remaining probability of a step", list(words), list(words).index(rest),
                               format_func=words.get, key=f"{key} rest")  # fmt: skip
        st.caption("One row for each possible reward. Add rows at the bottom of the table.")
    with table:
        rows = st.data_editor(
            as_cells(base), key=key, num_rows="dynamic", height=230, width="stretch", hide_index=True,
            column_config={
                "action": st.column_config.TextColumn(default="now"),
                "tau": st.column_config.TextColumn("tau (steps)", default="0"),
                "reward": st.column_config.TextColumn(default="1"),
                "probability": st.column_config.TextColumn(default="1"),
            },
        )  # fmt: skip
    try:
        timeline_world(rows, chosen_rest)
    except InputError as error:
        beside.warning(f"Not applied yet: {in_markdown(error)}")
        return
    _edited(sources.TIMELINE, word, packed_timeline([from_cells(row) for row in rows], chosen_rest))
