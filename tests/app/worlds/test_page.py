"""The pages through Streamlit's AppTest: what opens, what the controls do, what a bad link says."""

from __future__ import annotations

import numpy as np
import pytest

from app.view.compute import study_for
from app.worlds.schema import LINK
from app.worlds.sources import WORLDS, view_of
from laplace_core import study
from laplace_core.payloads.lens import payload, structure
from tests.support.lens_reference import unpacked
from tests.support.pages import choose, handed, link, opened, press, verdict


def test_it_opens_on_the_paper_s_figure_with_the_verdict_red():
    text = verdict(opened())
    assert text.startswith("bad")
    assert "choose short (14.85 v 9.74); the best is long" in text
    assert "repeated reward" in text


def test_a_remedy_that_decodes_more_rows_keeps_the_horizon_it_was_tried_at():
    # Up to T = 0.75 only the reward at tau = 0 counts: 5 for short, nothing for long. One row of half a step makes it
    # 8.75 for long, as it takes up what comes later; more rows put it right. Eight rows reach T = 4.25, where long is
    # best: the view must not move there, and so answer another question than the one that was asked.
    page = opened(world="two_branch", steps="1", time_step="0.5", deadline="constant", action="long")
    assert verdict(page).startswith("bad: ")
    assert "At T = 0.75 the decoded values choose long" in verdict(page)
    press(page, "Decode 8 rows")
    assert "At T = 0.75 the decoded values choose short" in verdict(page)
    assert link(page)["horizon"] == "0.75"


@pytest.mark.parametrize("remedy", ["Keep survival", "Add auxiliary states"])
def test_each_remedy_turns_the_verdict_green_by_flipping_the_action(remedy):
    text = verdict(press(opened(), remedy))
    assert text.startswith("ok")
    assert "choose long" in text


@pytest.mark.parametrize(
    "world", [world if world in ("fig6_chain", "cliff_grid") else pytest.param(world, marks=pytest.mark.long)
              for world in WORLDS],
)  # fmt: skip
def test_every_world_opens(world):
    page = opened(world=world)
    assert verdict(page)
    assert not page.error
    assert not page.warning


def test_every_world_is_decoded_for_its_page(subtests):
    """What a page of it shows, without the page."""
    for world in WORLDS:
        with subtests.test(world):
            values, notes = LINK.read({"world": world})
            assert (values, notes) == ({"world": world}, [])
            view = view_of(values)
            found = study_for(view)
            assert np.isfinite(found.decoded.horizon_values).all()
            plain = study(view.world, structure(found.settings, view.world))
            assert unpacked(payload(plain)[0])[0]["actions"] == list(found.action_names)


def test_the_link_follows_the_controls_and_reproduces_the_view():
    page = opened()
    choose(page, alpha=0.05, horizon=2.0, normalise="survival")
    page.number_input(key="p.r2").set_value(7.5)
    page.run()
    link = dict(page.query_params)
    assert link == {
        "world": "two_branch", "alpha": "0.05", "horizon": "2", "normalise": "survival", "p.r2": "7.5",
    }  # fmt: skip
    again = opened(**link)
    assert verdict(again) == verdict(page)
    assert handed(again)[0]["state"]["alpha"] == 0.05


def test_a_bad_link_opens_with_a_note_and_the_defaults():
    page = opened(world="two_branch", alpha="-3", steps="many")
    assert len(page.warning) == 2
    assert handed(page)[0]["state"]["alpha"] == 0.2


def test_settings_that_contradict_each_other_are_one_sentence_and_no_trace():
    page = opened("learning", world="two_branch", gamma_max="0.5")
    page.number_input(key="gamma_min").set_value(0.9)
    page.run()
    assert not page.exception
    assert len(page.error) == 1
    assert "gamma-min" in page.error[0].value


def test_another_world_brings_its_own_settings_but_keeps_the_normalisation():
    page = opened("learning", normalise="survival")
    page.selectbox(key="world").set_value("fig6_chain")
    page.run()
    assert page.number_input(key="gammas").value == 100
    assert handed(page)[0]["state"]["normalise"] == "survival"
    assert page.number_input(key="theta_min").value == pytest.approx(-2.8)


@pytest.mark.parametrize("button", ["", "Edit this world as a table", "Draw a timeline", "Open the learned fig6 chain"])
def test_what_follows_the_opening_view_is_as_decoded_without_its_artefact(button):
    page = opened("bring")
    assert handed(page)[0]["state"]["normalise"] == "paper"
    if button:
        press(page, button)
    else:
        page.selectbox(key="world").set_value("fig6_chain").run()
    assert handed(page)[0]["state"]["normalise"] == "none"


def test_what_was_not_set_by_hand_follows_the_world():
    page = opened("learning")
    page.number_input(key="p.r2").set_value(20.0)
    page.run()
    assert page.number_input(key="theta_max").value == pytest.approx(24.0)


def test_reset_returns_to_the_world_s_own_settings():
    page = press(opened(alpha="5", normalise="paper"), "Reset world and settings")
    assert handed(page)[0]["state"]["alpha"] == 0.2
    assert dict(page.query_params) == {"world": "two_branch"}


def test_the_command_shown_reproduces_the_view():
    page = opened("copying", alpha="0.05")
    sent = next(block.proto for block in page.get("bidi_component") if "Copy as" in str(block.proto))
    assert "python -m laplace_core decode two_branch" in str(sent)
    assert "--alpha 0.05" in str(sent)


@pytest.mark.parametrize(
    "query",
    [
        {"horizon": "50"},
        {"world": "cliff_grid", "horizon": "500"},
        {"thetas": "2"},
        {"steps": "1", "time_step": "0.1"},
        {"steps": "1"},
        {"alpha": "0"},
        {"softness": "10"},
        {"gammas": "2", "thetas": "2000"},
        {"time_step": "0.1", "normalise": "paper"},
        {"world": "two_branch", "p.length": "200", "normalise": "paper"},
    ],
)
def test_views_at_the_edge_open(query):
    page = opened(**query)
    assert not page.error
    assert verdict(page)


def test_a_world_that_shrinks_takes_the_horizon_and_the_state_along():
    page = opened(state="long 2", horizon="3")
    page.number_input(key="p.length").set_value(2)
    page.run()
    assert not page.exception
    assert handed(page)[0]["state"]["horizon"] == 2.0
    assert page.selectbox(key="state").value == "start"
