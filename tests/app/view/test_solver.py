"""Solver, rule for alpha and assumed noise on the pages that show a lens: what is drawn, linked, copied and saved."""

from __future__ import annotations

import io
import json

import numpy as np
import pytest

from app.session import crowd
from app.view import compute
from app.worlds.sources import view_of
from laplace_core import Settings, load_world, study
from laplace_core.inverse import SOLVERS
from laplace_core.inverse.titles import RULE_TITLES, SOLVER_TITLES
from laplace_core.study.npz import npz_bytes
from tests.support.lens_reference import seen, unpacked
from tests.support.pages import copied, handed, link, opened, run

HERE = {"world": "two_branch", "thetas": "30", "noise": "0.003"}


def box(page, label):
    return next(each for each in page.selectbox if each.label == label)


@pytest.fixture(autouse=True)
def busy(monkeypatch):
    """Somebody else is at work: pages do not wait for the search for causes, which another process makes."""
    monkeypatch.setattr(crowd, "alone", lambda: False)


@pytest.mark.parametrize("solver", [name for name in SOLVERS if name != "neural"])
def test_a_solver_that_is_chosen_is_drawn_as_the_library_decodes_it(solver):
    page = opened(**HERE, alpha="0.05")
    box(page, "Solver").select(solver)
    told, data = handed(run(page))
    assert link(page).get("solver", "tikhonov") == solver
    expected = study(load_world("two_branch"), Settings(thetas=30, noise=0.003, alpha=0.05, solver=solver))
    shown = seen(data, told["state"], solved=expected.settings)
    np.testing.assert_allclose(shown["tau_space"], expected.decoded.tau_space, atol=1e-9)
    assert unpacked(data)[0]["solver"] == solver
    if solver == "feasible":  # which the server runs
        np.testing.assert_allclose(unpacked(data)[1]["decoded"], expected.decoded.tau_space, atol=1e-12)


def test_every_solver_and_every_rule_that_needs_no_noise_level_can_be_chosen():
    page = opened(**HERE)
    assert box(page, "Solver").options == [SOLVER_TITLES[name] for name in SOLVERS]
    rules = box(page, "Alpha rule").options
    assert "Discrepancy" not in rules
    assert rules == [title for name, title in RULE_TITLES.items() if name != "discrepancy"]
    assert "Discrepancy" in box(opened(**HERE, noise_level="0.003"), "Alpha rule").options


def test_a_rule_chooses_the_alpha_that_the_lens_shows_with_its_name():
    page = opened(**HERE)
    box(page, "Alpha rule").select("gcv")
    told, _ = handed(run(page))
    expected = study(load_world("two_branch"), Settings(thetas=30, noise=0.003, selector="gcv"))
    assert told["state"]["alpha"] == expected.settings.alpha != 0.01
    assert (told["state"]["selector"], told["rule"]) == ("gcv", "GCV")
    assert (link(page)["selector"], "alpha" in link(page)) == ("gcv", False)
    assert told["said"]["state"] == told["state"]  # and the verdict is of this alpha


def test_by_hand_alpha_stays_where_the_rule_put_it_and_so_does_the_picture():
    page = opened(**HERE, selector="gcv")
    told, data = handed(page)
    box(page, "Alpha rule").select("typed")
    after, same = handed(run(page))
    assert np.isclose(after["state"]["alpha"], told["state"]["alpha"], rtol=1e-3)
    assert after["state"]["selector"] == "typed"
    assert same == data  # weights that came with the rule stay
    assert link(page)["weighting"] == "deviation"


def test_a_link_to_a_solver_and_a_rule_shows_the_same_picture():
    first, data = handed(opened(**HERE, solver="nonnegative", selector="lcurve", noise_level="0.003"))
    again, same = handed(opened(**HERE, solver="nonnegative", selector="lcurve", noise_level="0.003"))
    assert (first["state"], data) == (again["state"], same)


def test_a_solver_without_alpha_takes_none_from_a_rule():
    page = opened(**HERE, gammas="15", spacing="inverse-log", selector="gcv")
    box(page, "Solver").select("neural")
    told, _ = handed(run(page))
    assert not page.error
    assert told["state"]["selector"] == "typed"
    assert box(page, "Alpha rule").disabled


def test_what_is_copied_and_saved_repeats_solver_rule_and_the_alpha_that_was_chosen():
    values = {**HERE, "solver": "tikhonov2", "selector": "gcv", "noise_level": "0.003"}
    page = opened("copying", "downloading", **values)
    command = copied(page, "command")
    assert "--solver tikhonov2" in command
    assert "--alpha gcv" in command
    assert "--noise-level 0.003" in command
    python = copied(page, "python")
    assert 'solver="tikhonov2"' in python
    assert 'selector="gcv"' in python
    shown = compute.study_for(view_of({**HERE, **values, "thetas": 30, "noise": 0.003, "noise_level": 0.003}))
    arrays = np.load(io.BytesIO(npz_bytes(shown)))
    record = json.loads(str(arrays["alpha_record"]))
    assert (record["rule"], record["value"]) == ("gcv", float(arrays["alpha"]))
    assert float(arrays["alpha"]) == handed(page)[0]["state"]["alpha"]
    assert arrays["band"].shape == shown.decoded.expected_reward.shape
