"""Links of the page of the inverse, and what they show."""

from __future__ import annotations

import io

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.inverse import compute, subjects
from app.inverse.schema import LINK
from app.inverse.subjects import OPENING, STUDIED, view_of
from app.view.compute import study_for
from laplace_core import InputError, load_world
from laplace_core.exchange.links import query_of

NAMES = [*STUDIED, "world", "agent", "data", "action", "axis", "p.r1", "p.", "other"]
WORDS = st.text(max_size=40) | st.sampled_from(
    ["two_branch", "cliff_grid", "feasible", "auto", "typed", "0.01", "-1", "1e308", "nan", "9" * 400, "<b>", "\x00"]
)


def test_a_link_reads_what_it_writes():
    values = {"world": "fig6_chain", "noise": 0.01, "noise_seed": 3, "solver": "tikhonov1", "selector": "gcv",
              "gammas": 20, "thetas": 40, "steps": 8, "axis": "gamma", "horizon": 3.0}  # fmt: skip
    assert LINK.read(query_of(values)) == (values, [])


@given(st.dictionaries(st.sampled_from(NAMES), WORDS, max_size=5))
def test_whatever_a_link_says_the_page_has_a_view(query):
    values, notes = LINK.read(query)
    view_of(values)
    assert all(note.strip() for note in notes)


@pytest.mark.parametrize(
    ("query", "note"),
    [
        ({"world": "nowhere"}, "unknown world"),
        ({"data": "0123456789ab"}, "open the file again"),
        ({"agent": "laplace_nothing"}, "no shipped agent"),
        ({"world": "two_branch", "state": "nowhere"}, "is not in two_branch"),
        ({"world": "two_branch", "solver": "magic"}, "solver must be one of"),
        ({"world": "two_branch", "gamma_min": "0.9", "gamma_max": "0.5"}, "gamma"),
    ],
)
def test_what_does_not_hold_is_said(query, note):
    values, notes = LINK.read(query)
    assert any(note in each for each in notes), notes
    view_of(values)


def test_an_alpha_in_a_link_is_set_by_hand_and_without_one_the_rule_chooses():
    assert study_for(view_of({**OPENING, "alpha": 0.3})).settings.alpha == 0.3
    assert study_for(view_of(OPENING)).alpha_record.criterion == "fitted"


def test_alpha_by_hand_and_by_a_rule_are_of_one_problem():
    by_rule, by_hand = (study_for(view_of({**OPENING, **more})).settings for more in ({}, {"alpha": 0.3}))
    assert compute.structure(by_rule) == compute.structure(by_hand)


def test_noise_is_known_where_it_was_put_in():
    assert view_of(OPENING).settings.noise_level == OPENING["noise"]
    assert view_of({"world": "two_branch"}).settings.noise_level is None
    assert view_of({**OPENING, "noise_level": 0.05}).settings.noise_level == 0.05


def test_the_start_state_of_a_shipped_agent_is_a_subject():
    name = subjects.agents()[0]
    view = view_of({"agent": name})
    assert view.world is None
    assert view.settings.noise_level == subjects.NETWORK_NOISE
    assert compute.shown(view).course.time_error is None


def test_a_file_is_a_subject_while_it_is_open(monkeypatch):
    space = study_for(view_of({"world": "two_branch"})).gamma_space
    file = io.BytesIO()
    np.savez(file, gamma_space=space.values, constant_channel=space.constant, gammas=space.gammas, thetas=space.thetas)
    held = {}
    monkeypatch.setattr(
        subjects.session, "keep_opened", lambda file, data: held.setdefault("0123456789ab", file) and "0123456789ab"
    )
    monkeypatch.setattr(subjects.session, "opened", lambda kind: held)
    digest = subjects.open_file("own.npz", file.getvalue())
    view = view_of({"data": digest, "steps": 5, "gammas": 3})
    assert view.settings.steps == 5
    assert view.settings.world == "own.npz"
    with pytest.raises(InputError, match="open the file again"):
        view_of({"data": "ba9876543210"})


def test_payload_of_a_drag_stays_the_same():
    views = [view_of({**OPENING, **more}) for more in ({}, {"alpha": 0.3}, {"alpha": 0.3, "horizon": 2.0})]
    assert len({compute.shown(view).data for view in views}) == 1


def test_a_payload_that_is_too_large_is_refused(monkeypatch):
    monkeypatch.setattr(compute, "MOST_PAYLOAD", 0.001)
    with pytest.raises(InputError, match="lower thetas"):
        compute.shown(view_of({**OPENING, "noise_seed": 77}))


def test_the_choice_over_alpha_and_horizon_is_that_of_studies():
    view = view_of({"world": "two_decisions", "noise": 0.002})
    found = compute.shown(view).course
    at = 40
    own = study_for(view_of({"world": "two_decisions", "noise": 0.002, "alpha": float(found.alphas[at])}))
    np.testing.assert_array_equal(found.chosen[at], own.decoded.actions)
    assert load_world("two_decisions").n_actions == 2
