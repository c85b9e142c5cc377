"""What the person has set on a page: kept in the session, written to and read from the URL.

Only values that were set by hand (or by a link, a remedy, a preset view) are kept; everything else follows the
world. So a link holds what matters, and a changed world brings its own defaults along.
"""

from __future__ import annotations

from collections.abc import Mapping

import streamlit as st

from laplace_core import PRESETS, InputError, Settings, World, load_world
from laplace_core.parameters import Parameter, as_text, parse_named
from laplace_core.pipeline import grids
from laplace_core.settings import BY_NAME, resolve
from laplace_core.worlds import TOY_TEXT, parameters_of

OPENING = {"world": "two_branch", "normalise": "paper"}
"""The paper's Fig. 4c: what a visitor without a link sees."""

WORLDS = (*PRESETS, *(f"gym:{name}" for name in TOY_TEXT))

VIEW = (
    Parameter("action", None, 0, 0, "Action whose spaces are shown.", str),
    Parameter("horizon", None, 1e-3, 2000, "Deadline T, in steps of the world.", float),
    Parameter("look", "heatmap", 0, 0, "How the spaces are drawn.", str, ("heatmap", "surface")),
)
"""What is looked at, beside the settings of the study."""

_KEPT_ACROSS_WORLDS = {"normalise", "policy", "softness", "look"}
_PARAM = "p."  # prefix of world parameters, in the session and in the URL


def chosen() -> dict[str, object]:
    """Values set by hand, by name; ``p.NAME`` for a parameter of the world."""
    return st.session_state.setdefault("_chosen", {})


def world_name() -> str:
    return chosen().get("world", OPENING["world"])


def settings() -> Settings:
    """The study settings that were set by hand; the rest is None."""
    values = {name: value for name, value in chosen().items() if name in BY_NAME}
    return Settings(world=world_name(), params=tuple(sorted(world_params().items())), **values)


def world_params() -> dict[str, object]:
    return {name.removeprefix(_PARAM): value for name, value in chosen().items() if name.startswith(_PARAM)}


def keep(name: str) -> None:
    """Callback of the widget with key ``name``: its value is now set by hand."""
    chosen()[name] = st.session_state[name]
    _touch()


def choose(name: str, value: object) -> None:
    """Set a value by hand that no widget of that name holds."""
    chosen()[name] = value
    _touch()


def _touch() -> None:
    """A widget, not the browser's Back, is behind this run: what the URL says may be a moment old."""
    st.session_state["_touched"] = True


def choose_world() -> None:
    """Callback of the world widget: what belonged to the old world is dropped."""
    kept = {name: value for name, value in chosen().items() if name in _KEPT_ACROSS_WORLDS}
    st.session_state["_chosen"] = {"world": st.session_state["world"], **kept}
    _touch()


def apply_changes(changes: Mapping[str, object]) -> None:
    """Callback of a remedy: set fields, ``param:NAME`` for a parameter of the world."""
    for name, value in changes.items():
        chosen()[name.replace("param:", _PARAM)] = value
    st.session_state["_sidebar_stale"] = True
    _touch()


def sidebar_is_stale() -> bool:
    """Whether something that the sidebar shows was changed from the main area."""
    return st.session_state.get("_sidebar_stale", False)


def settled() -> None:
    """The whole page is drawn anew: nothing is stale."""
    st.session_state["_sidebar_stale"] = False


def reset() -> None:
    """Callback: back to the world's own settings."""
    st.session_state["_chosen"] = {"world": world_name()}
    _touch()


def show(name: str, value: object) -> str:
    """Put into the widget ``name`` what holds now: the value set by hand, else ``value``. Returns the key."""
    st.session_state[name] = chosen().get(name, value)
    return name


def load_url() -> None:
    """Take the state from the URL when the page is opened and when the browser goes back or forward."""
    query = {name: st.query_params[name] for name in st.query_params}
    opened = "_chosen" not in st.session_state
    moved = query != st.session_state.get("_written") and not st.session_state.get("_touched", False)
    if opened or moved:
        found, notes = parse_query(query) if query else (dict(OPENING), [])
        st.session_state["_chosen"], st.session_state["_notes"] = found, notes


def drop_missing(world: World) -> None:
    """Forget a state or action that the world, changed since, no longer has."""
    for name, members in (("state", world.states), ("action", world.actions)):
        if name in chosen() and chosen()[name] not in members:
            st.toast(f"The world has no {name} {chosen().pop(name)!r} any more.")


def parse_query(query: Mapping[str, str]) -> tuple[dict[str, object], list[str]]:
    """State and notes from URL values; the values are checked as strictly as those of the command line."""
    found: dict[str, object] = {}
    notes: list[str] = []
    world = query.get("world", OPENING["world"])
    if world not in WORLDS:
        notes.append(f"The link asks for an unknown world, {world[:40]!r}; this is the opening view instead.")
        return dict(OPENING), notes
    found["world"] = world
    known = {**BY_NAME, **{parameter.name: parameter for parameter in VIEW}}
    for name, text in query.items():
        try:
            if name.startswith(_PARAM):
                bare = name.removeprefix(_PARAM)
                found[name] = parse_named(world, parameters_of(world), {bare: text})[bare]
            elif name in known:
                found[name] = known[name].parse(text)
            elif name != "world":
                notes.append(f"The link has an entry {name[:40]!r} that means nothing here.")
        except InputError as error:
            notes.append(f"Left out of the link: {error}")
    params = {name.removeprefix(_PARAM): value for name, value in found.items() if name.startswith(_PARAM)}
    try:
        built = load_world(world, params)
    except InputError as error:
        notes.append(f"Left out of the link: {error}")
        found = {name: value for name, value in found.items() if not name.startswith(_PARAM)}
        built = load_world(world, {})
    for name, members in (("state", built.states), ("action", built.actions)):
        if name in found and found[name] not in members:
            notes.append(f"Left out of the link: {name} {str(found.pop(name))[:40]!r} is not in {world}.")
    try:
        values = {name: value for name, value in found.items() if name in BY_NAME}
        grids(resolve(Settings(world=world, **values), built))
    except InputError as error:
        notes.append(f"Left out of the link: {error}")
        found = {name: value for name, value in found.items() if not name.startswith(("gamma", "theta"))}
    return found, notes


def notes() -> list[str]:
    return st.session_state.get("_notes", [])


def write_url() -> None:
    """Make the address bar a link to what is seen."""
    query = {name: as_text(value) for name, value in chosen().items()}
    if dict(st.query_params) != query:
        st.query_params.from_dict(query)
    st.session_state["_written"], st.session_state["_touched"] = query, False
