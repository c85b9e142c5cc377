"""The lens on the page of worlds: what it hands to the browser is the library's."""

from __future__ import annotations

import numpy as np
import pytest

from app.session import crowd
from app.view import compute, panels
from laplace_core import InputError, Settings, load_world, study
from laplace_core.payloads.lens import payload, structure
from laplace_core.study.settings import resolve
from tests.support.pages import choose, handed, link, opened, pin, press, run, shown


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


@pytest.mark.parametrize("query", [{"clip": "maybe"}, {"value_gamma": "2"}, {"used": "-1"}, {"fold": "2"}])
def test_bad_values_of_the_lens_in_a_link_are_noted(query):
    page = opened(world="two_branch", **query)
    assert page.warning
    told, _ = handed(page)
    assert not told["state"]["clip"]
    assert np.isclose(told["state"]["value_gamma"], 0.99)


def test_the_verdict_speaks_of_the_state_that_is_handed_over():
    told, _ = handed(opened(world="two_branch", normalise="paper", alpha="0.1"))
    assert told["said"]["tone"] == "bad"
    assert told["said"]["state"] == told["state"]
    assert told["said"]["remedies"][:2] == ["Keep survival", "Add auxiliary states"]


def test_reset_leads_to_the_world_s_own_settings():
    told, _ = handed(opened(world="two_branch", **{"p.r2": "7"}, alpha="0.01", normalise="paper", fold="yes", used="1"))
    plain, _ = handed(opened(world="two_branch", **{"p.r2": "7"}))
    assert told["base"] == plain["state"]
    assert told["state"] != plain["state"]


def test_a_view_pinned_on_the_same_payload_is_drawn_in_the_lens():
    page = choose(pin(opened(world="two_branch")), alpha=0.01)
    told, _ = handed(page)
    assert (told["pinned"], told["pin"]["alpha"], told["state"]["alpha"]) == (True, 0.2, 0.01)
    told, _ = handed(choose(page, thetas=60))
    assert (told["pinned"], told["pin"]) == (True, None)
    assert not handed(choose(page, pin=None))[0]["pinned"]


def test_the_graph_of_the_world_is_handed_over():
    told, _ = handed(opened(world="two_decisions", state="branch"))
    assert "state branch" in told["world"]["alt"]


def test_a_search_that_another_visitor_ends_meanwhile_is_shown(monkeypatch):
    """The other one's search ends after the lens has said that the cause is being searched for."""
    compute.forget()
    monkeypatch.setattr(compute, "AT_ONCE", 0.0)  # every search takes long
    drawn, told = panels.artefacts, []

    def ended_elsewhere(view, coming):
        drawn(view)
        told.append(compute.is_explained(view))
        compute.verdict_for(view)

    monkeypatch.setattr(panels, "artefacts", ended_elsewhere)
    said = handed(opened(world="two_branch", normalise="paper"))[0]["said"]
    assert told[:2] == [False, True]
    assert "Cause: repeated reward" in said["sentence"]
    assert "being searched" not in said["sentence"]


def test_a_cause_that_was_forgotten_is_found_again(monkeypatch):
    monkeypatch.setattr(compute, "AT_ONCE", 0.0)
    query = {"world": "two_branch", "normalise": "paper"}
    for forgotten in (compute.forget, compute._explained.cache_clear):
        forgotten()
        assert "Cause: repeated reward" in handed(opened(**query))[0]["said"]["sentence"]


def test_while_others_are_at_work_the_pictures_come_first(monkeypatch):
    compute.forget()
    monkeypatch.setattr(crowd, "_seen", {})
    with monkeypatch.context() as other:
        other.setattr(crowd, "session_id", lambda: "another")
        crowd.alone()
    page = opened(world="two_branch", alpha="0.02", horizon="1", shift="yes", thetas="20")
    assert handed(page)[0]["said"]["sentence"].endswith("The cause is being searched for.")
    assert "fix shifted index Undo the shift of the index" not in [button.key for button in page.button]
    assert compute.is_searched(shown(page), wait=60)
    page = run(page)
    assert "Cause: shifted index" in handed(page)[0]["said"]["sentence"]
    assert "fix shifted index Undo the shift of the index" in [button.key for button in page.button]


def test_a_search_that_fails_leaves_its_reason():
    """The verdict stays, and nobody waits for a cause."""
    compute.forget()
    view = shown(opened(world="two_branch", normalise="paper"))
    compute._explained.cache_clear()
    compute._lost(view, InputError("the process of this search died 3 times."))
    sentence = handed(opened(world="two_branch", normalise="paper"))[0]["said"]["sentence"]
    compute._explained.cache_clear()  # no other test is to find it
    assert sentence.endswith("Its cause was not found: the process of this search died 3 times.")


def test_a_remedy_leaves_no_switch_that_is_off_in_the_link():
    page = opened(world="two_branch", shift="yes", alpha="0.01", horizon="1")
    assert "Cause: shifted index" in handed(page)[0]["said"]["sentence"]
    assert link(press(page, "Undo the shift of the index")) == {
        "world": "two_branch", "alpha": "0.01", "horizon": "1"
    }  # fmt: skip
