"""What the person has set on a page: kept in the session, written to and read from the URL.

Only values that were set by hand (or by a link, a remedy, a preset view) are kept; everything else follows the
world. So a link holds what matters, and a changed world brings its own defaults along.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import streamlit as st

from app import link, sources
from app.query import OPENING, query_of
from app.sources import PARAM
from laplace_core import World, load_world
from laplace_core.settings import BY_NAME, SWITCHES
from laplace_core.worlds import dump_world

Parse = Callable[[Mapping[str, str]], tuple[dict[str, Any], list[str]]]
"""From the values of a URL to values set by hand and notes about what did not hold."""

_KEPT_ACROSS_WORLDS = {"normalise", "policy", "softness", "look", "pin", "compare", "deadline", "source"}


def _page() -> dict[str, Any]:
    """What is kept of the page that is shown; each page has its own."""
    kept = st.session_state.setdefault("_pages", {})
    return kept.setdefault(st.session_state.get("_page", ""), {"chosen": {}, "notes": [], "written": None})


def page_name() -> str:
    return st.session_state.get("_page", "")


def without(*names: str) -> dict[str, Any]:
    """Values set by hand, but for some."""
    return {name: value for name, value in chosen().items() if name not in names}


def chosen() -> dict[str, Any]:
    """Values set by hand, by name; ``p.NAME`` for a parameter of the world."""
    _take()
    return _page()["chosen"]


def world_name() -> str:
    return chosen().get("world", OPENING["world"])


def keep(name: str) -> None:
    """Callback of the widget with key ``name``: its value is now set by hand."""
    st.session_state.setdefault("_heard", []).append((name, st.session_state[name]))
    _touch()


def _take() -> None:
    """Take over what widgets have reported, but for echoes.

    A browser reports all its widgets with each event, as it has them. One that the server has changed or replaced
    since (a remedy, Back, another world) comes back with what it showed before, and looks as if it was touched.
    """
    heard, shown = st.session_state.pop("_heard", ()), st.session_state.setdefault("_shown", {})
    values = _page()["chosen"]
    touched = [(name, value) for name, value in heard if name in values or value != shown.get(name, (None, None))[0]]
    for name, value in touched:
        if len(touched) > 1 and value == shown.get(name, (None, None))[1]:
            continue  # what it showed before the server changed it
        values[name] = value
        shown[name] = value, None  # the change was the person's: going back to what was before is no echo


def choose(name: str, value: object) -> None:
    """Set a value by hand that no widget of that name holds; None takes it back."""
    if value is None:
        chosen().pop(name, None)
    else:
        chosen()[name] = value
    _touch()


def _touch() -> None:
    """A widget, not the browser's Back, is behind this run: what the URL says may be a moment old."""
    st.session_state["_touched"] = True


def choose_world() -> None:
    """Callback of the world widget: what belonged to the old world is dropped."""
    name = st.session_state["world"]
    if name == sources.OWN:
        # A gamma-space from a file has no world to begin with.
        edit_world(sources.world_of(chosen()) or load_world(sources.FIRST_WORLD))
    elif name == sources.TIMELINE:
        go_to(world=name, timeline=chosen().get("timeline", sources.FIRST_TIMELINE), edit="yes")
    else:
        go_to(world=name)


def go_to(**values: object) -> None:
    """Look at another world; values that make sense in any world stay."""
    kept = {name: value for name, value in chosen().items() if name in _KEPT_ACROSS_WORLDS}
    _page()["chosen"] = {**kept, **values}
    st.session_state["_sidebar_stale"] = True
    _touch()


def replace_all(values: Mapping[str, Any]) -> None:
    """Look at something else altogether."""
    _page()["chosen"] = dict(values)
    _touch()


def edit_world(world: World) -> None:
    """Make a world the person's own and open it as a table; settings that suited it stay with it."""
    suited = {name: value for name, value in world.suggested.items() if name in BY_NAME}
    stays = {name: value for name, value in chosen().items() if name in BY_NAME or name in ("action", "horizon")}
    go_to(**suited, **stays, world=sources.OWN, own=link.pack(dump_world(world)), edit="yes")


def apply_changes(changes: Mapping[str, Any]) -> None:
    """Callback of a remedy: set fields, ``param:NAME`` for a parameter of the world; a switch turned off is let go."""
    for name, value in changes.items():
        if name in SWITCHES and value == BY_NAME[name].default:
            chosen().pop(name, None)
        else:
            chosen()[name.replace("param:", PARAM)] = value
    st.session_state["_sidebar_stale"] = True
    _touch()


def worked() -> None:
    """What is set now can be shown: it is what :func:`undo` returns to."""
    _page()["worked"] = dict(chosen())


def undo() -> None:
    """Callback: back to the last settings that could be shown."""
    _page()["chosen"] = dict(_page().get("worked", OPENING))
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
    kept = {name: chosen()[name] for name in ("own", "timeline", "data", "pin") if name in chosen()}
    _page()["chosen"] = {"world": world_name(), **kept}
    _touch()


def show(name: str, value: object) -> str:
    """Put into the widget ``name`` what holds now: the value set by hand, else ``value``. Returns the key."""
    return put(name, chosen().get(name, value))


def put(name: str, value: object) -> str:
    """Put a value into the widget ``name``, and remember what it shows and showed before. Returns the key."""
    st.session_state[name] = value
    shown = st.session_state.setdefault("_shown", {})
    now, _ = shown.get(name, (None, None))
    if name not in shown or value != now:
        shown[name] = value, now
    return name


def load_url(page: str, opening: Mapping[str, Any], parse: Parse) -> None:
    """Take the state from the URL when a page is opened by a link and when the browser goes back or forward.

    A page that is come back to from another one is as it was left.
    """
    query = {name: st.query_params[name] for name in st.query_params}
    arrived = st.session_state.get("_page") != page
    new = page not in st.session_state.get("_pages", {})
    st.session_state["_page"] = page
    if arrived:
        st.session_state.pop("_heard", None)  # widgets of the page that was left
    kept = _page()
    moved = not arrived and query != kept["written"] and not st.session_state.get("_touched", False)
    if new or moved or (arrived and query):
        kept["chosen"], kept["notes"] = parse(query) if query else (dict(opening), [])


def drop_missing(world: World) -> None:
    """Forget a state or action that the world, changed since, no longer has."""
    for name, members in (("state", world.states), ("action", world.actions)):
        if name in chosen() and chosen()[name] not in members:
            st.toast(f"The world has no {name} {chosen().pop(name)!r} any more.")


def notes() -> list[str]:
    return _page()["notes"]


def write_url() -> None:
    """Make the address bar a link to what is seen, or leave it empty where that would be too long for a link."""
    query = query_of(chosen())
    if not link.fits(query):
        query = {}
    if dict(st.query_params) != query:
        st.query_params.from_dict(query)
    _page()["written"], st.session_state["_touched"] = query, False
