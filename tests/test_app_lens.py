"""The page of the lens: what it hands to the browser is the library's, and it shows what the page of worlds shows."""

from __future__ import annotations

import json
import struct

import numpy as np
import pytest
from streamlit.testing.v1 import AppTest

from app.lens import payload, structure
from laplace_core import Settings, load_world, study
from laplace_core.settings import resolve
from tests.pages import MAIN


def opened(**query: str) -> AppTest:
    page = AppTest.from_file(MAIN, default_timeout=60)
    page.switch_page("screens/lens.py")
    for name, value in query.items():
        page.query_params[name] = value
    page.run()
    assert not page.exception
    return page


def handed(page: AppTest) -> tuple[dict, bytes]:
    """What the lens is told, and its payload."""
    sent = next(block.proto for block in page.get("bidi_component") if "lens" in block.proto.component_name)
    message = sent.bytes
    size = struct.unpack("<I", message[:4])[0]
    return json.loads(message[4 : 4 + size]), message[4 + size :]


@pytest.mark.parametrize("world", ["two_branch", "rise_and_fade", "gym:FrozenLake-v1"])
def test_the_payload_is_the_library_s(world):
    told, data = handed(opened(world=world, alpha="0.05"))
    built = load_world(world)
    settings = resolve(Settings(world=world, alpha=0.05), built)
    assert data == payload(study(built, structure(settings, built)))[0]
    assert told["state"]["alpha"] == 0.05
    assert told["state"]["horizon"] == study(built, settings).horizons[-1]


def test_a_learned_agent_is_seen_through_its_own_table():
    page = opened(world="fig6_chain", source="learned", agent="fig6_chain_td", learner="2")
    _, exact = handed(opened(world="fig6_chain"))
    _, learned = handed(page)
    assert learned != exact


def test_the_page_of_worlds_and_the_lens_look_at_the_same():
    page = opened(world="double_chain", alpha="0.003", clip="yes")
    page.switch_page("screens/workbench.py")
    page.run()
    assert not page.exception
    assert page.query_params["world"] in ("double_chain", ["double_chain"])
    assert page.query_params["alpha"] in ("0.003", ["0.003"])


@pytest.mark.parametrize("query", [{"clip": "maybe"}, {"value_gamma": "2"}, {"used": "-1"}, {"fold": "1"}])
def test_bad_values_of_the_lens_in_a_link_are_noted(query):
    page = opened(world="two_branch", **query)
    assert page.warning
    told, _ = handed(page)
    assert not told["state"]["clip"]
    assert np.isclose(told["state"]["value_gamma"], 0.99)
