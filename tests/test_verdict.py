"""The verdict: right or wrong, and the cause, which is named only if its remedy was tried and helped."""

from __future__ import annotations

import numpy as np
import pytest

from laplace_core import Settings, load_world, study
from laplace_core.pipeline import basis_of
from laplace_core.verdict import judge


def look(world: str, **settings):
    return study(load_world(world, settings.pop("params", {})), Settings(world=world, **settings))


def test_the_verdict_on_the_paper_s_figure_and_its_two_remedies():
    found = look("two_branch", normalise="paper")
    verdict = judge(found, 2)
    assert (verdict.kind, verdict.chosen, verdict.best) == ("wrong", 0, 1)
    assert "14.85 v 9.74" in verdict.sentence
    assert verdict.cause.name == "repeated reward"
    # What the wrong choice costs: .99^2 * 10 - 5.
    assert verdict.regret == pytest.approx(0.99**2 * 10 - 5)
    assert [remedy.label for remedy in verdict.remedies] == ["Keep survival", "Add auxiliary states"]
    for remedy in verdict.remedies:
        settings = remedy.apply(found.settings)
        repaired = judge(study(load_world(settings.world, dict(settings.params)), settings), 2)
        assert (repaired.kind, repaired.chosen) == ("right", 1)


def test_the_verdict_blames_the_policy_where_the_truth_itself_misleads():
    # At T = 2 the best is to go on and take r1, but the policy for gamma .99 waits for r2, which T = 2 cuts off:
    # the exact values under that policy are 4 and 0, and choose to leave.
    found = look("two_decisions", alpha=1e-9)
    assert np.argmax(found.truth.horizon_values[:, 1]) == 0
    verdict = judge(found, 1)
    assert (verdict.kind, verdict.cause) == ("wrong", None)
    assert "No artefact of the inverse" in verdict.sentence


def test_right_for_the_wrong_reason_is_told_apart():
    found = look("double_chain", normalise="paper")
    verdict = judge(found, 7)
    assert verdict.kind == "lucky"
    assert verdict.cause.name == "repeated reward"


def test_softness_is_not_blamed_on_the_inverse():
    # With a deadline as wide as itself, decoded and true values are read in the same soft way and agree.
    found = look("two_branch", softness=1.0)
    verdict = judge(found, 2)
    assert verdict.kind in ("right", "wrong")
    # Read with the hard deadline the same values would be 5.0 and 9.8: more than a third away.
    np.testing.assert_allclose(found.decoded.horizon_values[:, 2], found.truth.horizon_values[:, 2], rtol=0.12)
    assert np.all(found.truth.horizon_values[:, 2] < 0.75 * np.array([5.0, 9.8]))


def test_the_verdict_names_the_other_horizons_that_go_wrong():
    found = look("discounting_chain")
    wrong = found.truth.optimum.max(axis=0) - found.truth.optimum[found.decoded.actions, np.arange(110)] > 1e-9
    assert wrong.any()
    verdict = judge(found, 109)
    first = found.horizons[np.flatnonzero(wrong)[0]]
    assert f"The choice is wrong at T = {first:g}" in verdict.sentence


def test_the_cause_names_its_action():
    found = look("two_branch", steps=1)
    verdict = judge(found, 0)  # one row has to hold the reward at tau 2 as well: folding, in the other action
    assert verdict.cause.name == "folding"
    assert "folding, in long" in verdict.sentence


def test_noise_is_the_cause_where_less_of_it_puts_the_values_right():
    found = look("cliff_grid", noise=1e-3)
    verdict = judge(found, 39)
    assert verdict.kind == "wrong"
    assert verdict.cause.name == "noise amplification"
    repaired = [judge(study(found.world, remedy.apply(found.settings)), 39) for remedy in verdict.remedies]
    assert any(one.kind != "wrong" for one in repaired)


def test_a_constant_horizon_is_blamed_for_what_the_episode_loses_after_a_right_choice():
    found = look("cliff_grid", deadline="constant", alpha=1e-4)
    row = next(r for r in range(40) if judge(found, r).cause and judge(found, r).cause.name == "constant horizon")
    verdict = judge(found, row)
    assert (verdict.kind, verdict.chosen) == ("lucky", verdict.best)
    assert "with the same T at every step" in verdict.sentence
    repaired = judge(study(found.world, verdict.remedies[0].apply(found.settings)), row)
    assert repaired.kind == "right"


def test_a_constant_horizon_that_costs_nothing_is_not_mentioned():
    verdict = judge(look("two_branch", deadline="constant"), 2)
    assert verdict.kind == "right"
    assert "same T" not in verdict.sentence


def test_a_remedy_keeps_what_was_learned():
    # Taking another alpha does not turn a wrong basis into the exact one: nothing here puts the choice right.
    world = load_world("two_branch")
    settings = Settings(world="two_branch")
    exact = basis_of(study(world, settings))
    wrong = study(world, settings, learned=exact[::-1])  # the two actions exchanged
    verdict = judge(wrong, 2)
    assert (verdict.kind, verdict.cause) == ("wrong", None)
