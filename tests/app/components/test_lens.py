"""Messages of the lens to the browser, and its reports."""

from __future__ import annotations

import re

from app.components.lens import standalone
from app.worlds.presets import PRESETS, presets_for
from app.worlds.schema import LINK
from app.worlds.sources import view_of
from laplace_core import Settings, load_world, study
from laplace_core.payloads.lens import payload, structure
from laplace_core.payloads.state import state_of


def made(name="two_decisions", **values):
    world = load_world(name)
    settings = study(world, Settings(world=name, **values)).settings
    return study(world, settings), study(world, structure(settings, world))


def test_every_preset_is_a_view():
    view = view_of(LINK.read({"world": "two_branch"})[0])
    found = {preset.name: preset for preset in presets_for(view)}
    assert list(found) == list(PRESETS)
    assert found["Fig. 4c"].here
    assert found["Fig. 4c"].state["normalise"] == "paper"
    assert not found["Fig. 6"].here


def test_the_file_of_its_own_asks_for_nothing():
    found, plain = made("two_branch")
    state = state_of(found.settings, 3.0)
    page = standalone(payload(plain)[0], {**state, "look": "</script>"})
    assert page.count("</script>") == 2  # what it holds, and its modules as one
    assert not re.search(r"^\s*(import|export) ", page, flags=re.MULTILINE)
    addresses = set(re.findall(r"(?:https?:)?//[\w.]+\.\w+[^\s\"'`]*", page))
    assert addresses <= {"http://www.w3.org/2000/svg"}
