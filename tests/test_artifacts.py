"""Artefacts and the verdict: present when switched on, absent when not, gone after the remedy."""

from __future__ import annotations

import numpy as np
import pytest

from laplace_core import Settings, load_world, study
from laplace_core.artifacts import Remedy, find_artefacts
from laplace_core.verdict import judge

CALM = {"alpha": 1e-6}  # a decode so sharp that nothing is wrong with it


def look(world: str, action: int = 0, **settings):
    found = study(load_world(world, settings.pop("params", {})), Settings(world=world, **settings))
    return found, {artefact.name: artefact for artefact in find_artefacts(found, action)}


# name: (world, action, settings that switch it on, settings that leave it out)
CASES = {
    "repeated reward": ("two_branch", 0, {"normalise": "paper"}, {}),
    "mixed policies": ("two_decisions", 1, {"policy": "per_gamma", "alpha": 1e-6}, CALM),
    "folding": ("rise_and_fade", 0, {"steps": 5}, {"steps": 20}),
    "edge clipping": ("two_branch", 1, {"theta_min": 0.0}, {"theta_min": -2.0}),
    "slope blur": ("two_branch", 0, {"slope": 0.5, "params": {"slip": 0.2}}, {"slope": 25.0, "params": {"slip": 0.2}}),
    "reward quantisation": ("fig6_chain", 0, {"slope": 1000.0, "thetas": 60}, {"slope": 63.0}),
    "over-smoothing": ("rise_and_fade", 0, {"alpha": 2.0}, CALM),
    "negative mass": ("double_chain", 0, {"alpha": 1e-4}, {"alpha": 8.0}),
    "soft deadline": ("two_branch", 0, {"softness": 1.0}, {}),
}


@pytest.mark.parametrize("name", CASES)
def test_present_when_switched_on_and_absent_when_not(name):
    world, action, on, off = CASES[name]
    assert name in look(world, action, **on)[1]
    assert name not in look(world, action, **off)[1]


@pytest.mark.parametrize("name", CASES)
def test_its_remedy_removes_it(name):
    world, action, on, _ = CASES[name]
    found, artefacts = look(world, action, **on)
    assert artefacts[name].remedies
    for remedy in artefacts[name].remedies:
        settings = remedy.apply(found.settings)
        repaired = study(load_world(settings.world, dict(settings.params)), settings)
        assert name not in {artefact.name for artefact in find_artefacts(repaired, action)}


def test_repeated_reward_counts_the_invented_steps():
    # The episode is over after one step of three: rows 1 and 2 are invented, but for what alpha smears there.
    artefacts = look("two_branch", 0, normalise="paper", alpha=1e-6)[1]
    assert artefacts["repeated reward"].size == pytest.approx(2.0, abs=0.01)


def test_edge_clipping_measures_the_lost_half():
    # theta_min equal to a reward loses half of its probability: sigmoid(0) = 1/2.
    artefacts = look("two_branch", 1, theta_min=0.0)[1]
    assert artefacts["edge clipping"].size == pytest.approx(0.5, abs=0.01)


def test_a_remedy_changes_only_what_it_names():
    before = Settings(world="two_branch", params=(("r1", 4.0),), alpha=0.3)
    after = Remedy("x", {"param:auxiliary": True, "normalise": "none"}).apply(before)
    assert dict(after.params) == {"r1": 4.0, "auxiliary": True}
    assert (after.normalise, after.alpha) == ("none", 0.3)


def test_the_verdict_on_the_paper_s_figure_and_its_two_remedies():
    found, _ = look("two_branch", normalise="paper")
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
    found, _ = look("two_decisions", alpha=1e-9)
    assert np.argmax(found.truth.horizon_values[:, 1]) == 0
    verdict = judge(found, 1)
    assert (verdict.kind, verdict.cause) == ("wrong", None)
    assert "No artefact of the inverse" in verdict.sentence


def test_right_for_the_wrong_reason_is_told_apart():
    found, _ = look("double_chain", normalise="paper")
    verdict = judge(found, 7)
    assert verdict.kind == "lucky"
    assert verdict.cause.name == "repeated reward"


def test_ringing_has_no_remedy_that_smears():
    # At alpha .01 the chain of 15 rewards rings, and every calmer alpha smears more: then there is no button.
    _, artefacts = look("rise_and_fade", alpha=0.01)
    assert artefacts["negative mass"].remedies == ()
    assert "more smearing" in artefacts["negative mass"].sentence


def test_softness_is_not_blamed_on_the_inverse():
    # With a deadline as wide as itself, decoded and true values are read in the same soft way and agree.
    found, _ = look("two_branch", softness=1.0)
    verdict = judge(found, 2)
    assert verdict.kind in ("right", "wrong")
    # Read with the hard deadline the same values would be 5.0 and 9.8: more than a third away.
    np.testing.assert_allclose(found.decoded.horizon_values[:, 2], found.truth.horizon_values[:, 2], rtol=0.12)
    assert np.all(found.truth.horizon_values[:, 2] < 0.75 * np.array([5.0, 9.8]))


def test_the_verdict_names_the_other_horizons_that_go_wrong():
    found, _ = look("discounting_chain")
    wrong = found.truth.optimum.max(axis=0) - found.truth.optimum[found.decoded.actions, np.arange(110)] > 1e-9
    assert wrong.any()
    verdict = judge(found, 109)
    first = found.horizons[np.flatnonzero(wrong)[0]]
    assert f"The choice is wrong at T = {first:g}" in verdict.sentence


def test_the_cause_names_its_action():
    found, _ = look("two_branch", steps=1)
    verdict = judge(found, 0)  # one row has to hold the reward at tau 2 as well: folding, in the other action
    assert verdict.cause.name == "folding"
    assert "folding, in long" in verdict.sentence
