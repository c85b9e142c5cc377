"""Changes of the values of the page Worlds: another world, an own copy of the world, Reset."""

from __future__ import annotations

import streamlit as st

from app.session import store
from app.session.typed import in_markdown
from app.worlds import sources
from app.worlds.schema import OPENING
from laplace_core import World, load_world
from laplace_core.study.settings import BY_NAME
from laplace_core.worlds.timeline import FIRST_TIMELINE

_KEPT_ACROSS_WORLDS = {"normalise", "policy", "softness", "look", "pin", "compare", "deadline", "source"}
_BROUGHT_ALONG = ("own", "timeline", "data", "pin")  # what Reset leaves: it cannot be had again


def world_name() -> str:
    return store.chosen().get("world", OPENING["world"])


def go_to(**values: object) -> None:
    """Look at another world; values that make sense in any world stay, but for those of the opening view.

    Its rescaled rows show an artefact of the paper: a world of one's own opens as it was decoded.
    """
    kept = {name: value for name, value in store.chosen().items() if name in _KEPT_ACROSS_WORLDS}
    store.replace_all({name: value for name, value in kept.items() if OPENING.get(name) != value} | values)
    store.refresh_sidebar()


def choose_world(key: str = "world") -> None:
    """Callback of the world widget: drop the settings of the old world."""
    name = st.session_state[key]
    if name == sources.OWN:
        # A gamma-space from a file has no world to begin with.
        edit_world(sources.world_of(store.chosen()) or load_world(sources.FIRST_WORLD))
    elif name == sources.TIMELINE:
        go_to(world=name, timeline=store.chosen().get("timeline", FIRST_TIMELINE), edit="yes")
    else:
        go_to(world=name)


def edit_world(world: World) -> None:
    """Make a world the person's own and open it as a table; settings that suited it stay with it."""
    suited = {name: value for name, value in world.suggested.items() if name in BY_NAME}
    stays = {name: value for name, value in store.chosen().items() if name in BY_NAME or name in ("action", "horizon")}
    stays = {name: value for name, value in stays.items() if OPENING.get(name) != value}
    go_to(**suited, **stays, world=sources.OWN, own=sources.word_of(world), edit="yes")


def drop_missing(world: World) -> None:
    """Forget a state or action that the world, changed since, no longer has."""
    chosen = store.chosen()
    for name, members in (("state", world.states), ("action", world.actions)):
        if name in chosen and chosen[name] not in members:
            st.toast(in_markdown(f"The world no longer has the {name} {chosen.pop(name)!r}."))


def reset() -> None:
    """Callback: back to the world's own settings."""
    kept = {name: value for name, value in store.chosen().items() if name in _BROUGHT_ALONG}
    store.replace_all({"world": world_name(), **kept})
