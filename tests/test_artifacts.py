"""Artefacts: present when switched on, absent when not, gone after the remedy."""

from __future__ import annotations

import numpy as np
import pytest

from laplace_core import Settings, control, load_world, study
from laplace_core.artifacts import MEASURES, VISIBLE, Remedy, find_artefacts
from laplace_core.control import constant_horizon_loss

CALM = {"alpha": 1e-6}  # a decode so sharp that nothing is wrong with it


def look(world: str, action: int = 0, **settings):
    found = study(load_world(world, settings.pop("params", {})), Settings(world=world, **settings))
    return found, {artefact.name: artefact for artefact in find_artefacts(found, action)}


# name: (world, action, settings that switch it on, settings that leave it out)
CASES = {
    "repeated reward": ("two_branch", 0, {"normalise": "paper"}, {}),
    "mixed policies": ("two_decisions", 1, {"policy": "per_gamma", "alpha": 1e-6}, CALM),
    "folding": ("two_branch", 1, {"steps": 1}, {"steps": 3}),
    "edge clipping": ("two_branch", 1, {"theta_min": 0.0, "alpha": 1e-4}, {"theta_min": -2.0}),
    "slope blur": ("two_branch", 0, {"slope": 0.5, "params": {"slip": 0.2}}, {"slope": 25.0, "params": {"slip": 0.2}}),
    "reward quantisation": ("fig6_chain", 0, {"slope": 1000.0, "thetas": 60}, {"slope": 63.0}),
    "over-smoothing": ("fig6_chain", 0, {"alpha": 2.0}, CALM),
    "negative mass": ("fig6_chain", 0, {"alpha": 0.1}, {"alpha": 5e-3}),
    "soft deadline": ("two_branch", 0, {"softness": 1.0}, {}),
    "noise amplification": ("fig6_chain", 0, {"noise": 1e-3, "alpha": 1e-4}, {"alpha": 1e-4}),
    "constant horizon": ("cliff_grid", 0, {"deadline": "constant"}, {"deadline": "time_to_go"}),
}


def test_every_artefact_has_a_case():
    assert set(CASES) == set(MEASURES)


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
    # The episode is over after one step of three, and rows 1 and 2 show the residue of the 5 as a certain 5.
    artefacts = look("two_branch", 0, normalise="paper", alpha=0.2)[1]
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


def test_ringing_has_no_remedy_that_smears():
    # At alpha .01 the chain of 15 rewards rings, and every calmer alpha smears more: then there is no button.
    _, artefacts = look("rise_and_fade", alpha=0.01)
    assert artefacts["negative mass"].remedies == ()
    assert "more smearing" in artefacts["negative mass"].sentence


def test_the_tail_of_a_large_reward_beyond_the_edge_is_no_rounding():
    # 6.6 / slope inside the edge .0014 of the reward is lost; times 100 that would be .27 of the spacing.
    grid = {"thetas": 31, "theta_min": 86.1, "theta_max": 101.1, "slope": 6.0, "steps": 3}
    assert "reward quantisation" not in look("two_branch", 0, params={"r1": 100.0, "r2": 100.0}, **grid)[1]


def test_a_constant_horizon_is_judged_at_the_horizon_that_is_asked_for():
    found, artefacts = look("cliff_grid", deadline="constant", alpha=1e-4)
    loss, best = constant_horizon_loss(found.world, found.settings)
    loss = loss[:, found.state] / np.abs(best[:, found.state]).max()
    assert artefacts["constant horizon"].size == pytest.approx(loss.max())
    sizes = {}
    for horizon in range(1, 41):
        listed = {artefact.name: artefact for artefact in find_artefacts(found, 0, horizon)}
        sizes[horizon] = listed["constant horizon"].size if "constant horizon" in listed else 0.0
    np.testing.assert_allclose(list(sizes.values()), np.where(loss >= VISIBLE, loss, 0.0))


def test_a_constant_horizon_in_too_large_a_world_is_left_out(monkeypatch):
    monkeypatch.setattr(control, "MAX_WORK", 10)
    assert "constant horizon" not in look("cliff_grid", deadline="constant", alpha=0.0123)[1]


def test_what_is_folded_is_what_comes_after_the_last_row():
    # One row for the long branch: 10 at tau = 2 is fitted by one number, sum gamma^2 / (G + alpha^2); 0 stays 0.
    found, artefacts = look("two_branch", 1, steps=1)
    gammas, alpha = found.gamma_space.gammas, found.settings.alpha
    share = 1.0 / (gammas.size + alpha**2)
    late, zeros = np.sum(gammas**2) * share, np.sum(gammas) * share  # tau = 1 pays another 0
    assert artefacts["folding"].size == pytest.approx((late + zeros) / 2.0, rel=2e-3)
