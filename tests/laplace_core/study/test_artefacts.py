"""Artefacts: present when switched on, absent when not, gone after the remedy."""

from __future__ import annotations

import re
import tracemalloc

import numpy as np
import pytest

from laplace_core import GammaSpace, Settings, load_world, study, study_of_gamma_space
from laplace_core.study import episodes
from laplace_core.study.artefacts import MEASURES, VISIBLE, Remedy, find_artefacts
from laplace_core.study.artefacts.look import Look
from laplace_core.study.episodes import constant_horizon_loss
from laplace_core.study.verdict import judge
from laplace_core.worlds import END, Outcome, World

CALM = {"alpha": 1e-6}  # a decode so sharp that nothing is wrong with it


def look(world: str, action: int = 0, **settings):
    found = study(load_world(world, settings.pop("params", {})), Settings(world=world, **settings))
    return found, {artefact.name: artefact for artefact in find_artefacts(found, action)}


# name: (world, action, settings that switch it on, settings that leave it out)
CASES = {
    "repeated reward": ("two_branch", 0, {"normalise": "paper"}, {}),
    "conditional rewards": ("discounting_chain", 2, {"normalise": "survival"}, {}),
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
        if "solver" in remedy.changes:
            assert study(load_world(settings.world), settings).decoded.tau_space.min() >= 0.0
            continue
        repaired = study(load_world(settings.world, dict(settings.params)), settings)
        assert name not in {artefact.name for artefact in find_artefacts(repaired, action)}


def test_repeated_reward_counts_the_invented_steps():
    # The episode is over after one step of three, and rows 1 and 2 show the residue of the 5 as a certain 5: 1 less the
    # residue is invented in each. Decoding 1 = gamma^0 by the normal equations gives the residue.
    found, artefacts = look("two_branch", 0, normalise="paper", alpha=0.2)
    F = found.gamma_space.gammas[:, None] ** np.arange(3)
    residue = np.linalg.solve(F.T @ F + 0.04 * np.eye(3), F.T @ np.ones(15))[1:]
    assert np.all(residue > 0)
    assert artefacts["repeated reward"].size == pytest.approx(2.0 - residue.sum(), abs=1e-3)


IDLES = [Outcome(0, 0, 1.0, 1, 5.0), Outcome(0, 1, 1.0, 1, -2.0)]
COSTS = [Outcome(state, 1, 1.0, END, -2.0) for state in (1, 2)]
FOR_EVER = {
    "to and fro": [Outcome(1, 0, 1.0, 2, 0.0), Outcome(2, 0, 1.0, 1, 0.0), *COSTS],
    "waiting": [Outcome(1, 0, 1.0, 1, 0.0), Outcome(2, 0, 1.0, 1, 0.0), *COSTS],
}


@pytest.mark.parametrize("how", FOR_EVER)
def test_a_reward_is_repeated_where_an_episode_idles_for_ever_too(how):
    """A 5 and then zeros, as all else costs: survival is 1 in truth, so that no row has more mass than it should."""
    world = World.from_outcomes("idle", ["s", "here", "there"], ["a", "b"], IDLES + FOR_EVER[how])
    found = study(world, Settings(world="idle", normalise="paper", steps=10, alpha=0.2))
    # Reward 5 leaves 1 in gamma-space, the zeros gamma / (1 - gamma). The clipped rows are shared out between the two.
    gammas = found.gamma_space.gammas
    F = gammas[:, None] ** np.arange(10)
    rows = np.linalg.solve(F.T @ F + 0.04 * np.eye(10), F.T @ np.array([np.ones(15), gammas / (1.0 - gammas)]).T)
    rescaled = np.clip(rows, 0, None) / np.clip(rows, 0, None).sum(axis=1, keepdims=True)
    true = np.array([[1.0, 0.0]] + 9 * [[0.0, 1.0]])
    more = np.clip(rescaled - true, 0, None).sum(axis=1) - np.clip(rows - true, 0, None).sum(axis=1)
    assert rescaled[1:4, 0].min() > 0.99  # a certain 5 at tau 1, 2 and 3
    artefact = {each.name: each for each in find_artefacts(found, 0, searching=False)}["repeated reward"]
    assert artefact.size == pytest.approx(np.clip(more, 0, None).sum(), abs=0.02)
    assert artefact.size > 3.0


def survival_conditional():
    """Safe pays 3 and ends; risky pays 1 a step and goes on with a chance of 1/2."""
    rows = [Outcome(0, 0, 1.0, END, 3.0), Outcome(0, 1, 0.5, 1, 1.0), Outcome(0, 1, 0.5, END, 1.0)]
    rows += [Outcome(1, a, 0.5, goal, 1.0) for a in (0, 1) for goal in (1, END)]
    return World.from_outcomes("risk", ["start", "risky"], ["safe", "risky"], rows)


def test_conditional_rewards_are_summed_as_if_sure():
    """Survival is 1/2^k, above .05 for k < 5: the rows given survival are worth sum_{k<5} .99^k, truly sum .495^k."""
    found = study(survival_conditional(), Settings(world="risk", normalise="survival"))
    given = np.array([sum(0.99**k for k in range(min(T, 5))) for T in range(1, found.settings.steps + 1)])
    true = np.array([sum(0.495**k for k in range(T)) for T in range(1, found.settings.steps + 1)])
    np.testing.assert_allclose(found.decoded.horizon_values[1], given, atol=0.03)
    artefact = {each.name: each for each in find_artefacts(found, 1)}["conditional rewards"]
    assert artefact.size == pytest.approx(np.abs(given - true).max() / true.max(), abs=0.03)
    assert "the largest true one is 1.98" in artefact.shown
    safe = {each.name for each in find_artefacts(found, 0)}
    assert "conditional rewards" not in safe  # sure while it lasts


def test_conditional_rewards_of_data_without_a_world():
    space = study(survival_conditional(), Settings(world="risk")).gamma_space
    data = GammaSpace(space.values, space.constant, space.gammas, space.thetas)
    found = study_of_gamma_space(data, Settings(world="mine.npz", normalise="survival", steps=10))
    artefact = {each.name: each for each in find_artefacts(found, 1)}["conditional rewards"]
    assert artefact.size == pytest.approx((sum(0.99**k for k in range(5)) - 1.92) / 1.98, abs=0.05)
    alone = study_of_gamma_space(data, Settings(world="mine.npz", steps=10))
    assert "conditional rewards" not in {each.name for each in find_artefacts(alone, 1)}


def test_repeated_reward_of_data_without_a_world_is_what_exceeds_the_decoded_survival():
    settings = {"alpha": 0.2, "steps": 3, "normalise": "paper"}
    known = look("two_branch", 0, **settings)[0]
    space = known.gamma_space
    data = GammaSpace(space.values, space.constant, space.gammas, space.thetas)
    found = study_of_gamma_space(data, Settings(world="mine.npz", **settings))
    artefact = {each.name: each for each in find_artefacts(found, 0)}["repeated reward"]
    assert artefact.size == pytest.approx(3.0 - known.decoded.survival[0].sum(), abs=1e-6)


def test_a_constant_horizon_where_no_whole_step_lies_within_the_horizons():
    # One row half a step long ends at T = .75: no episode of a whole step can be acted.
    found, artefacts = look("two_branch", 0, steps=1, time_step=0.5, deadline="constant")
    assert found.horizons.tolist() == [0.75]
    assert "constant horizon" not in artefacts
    assert judge(found, 0).sentence


def test_no_size_above_one_is_called_a_probability():
    # One row has to hold the two zeros and the 10 that come after it, at all discounts.
    amounts = []
    for world in ("two_branch", "rise_and_fade", "discounting_chain"):
        for settings in ({"steps": 2, "alpha": 1e-3}, {"noise": 0.1, "alpha": 1e-4}, {"alpha": 1e-8}):
            amounts += [each for each in look(world, 0, **settings)[1].values() if "probability" in each.shown]
    assert any(each.size > 1.0 for each in amounts)
    for each in amounts:
        share = re.search(r"([\d.]+) of a row's probability", each.shown)
        assert ("times a row's whole probability" in each.shown) == (each.size > 1.0)
        assert share is None or float(share[1]) <= 1.0


def test_a_timeline_is_held_against_whole_steps_where_rows_are_closer():
    """At time_step 1/4 the row at 0 holds step 0 and the row at 1 step 1; the four rows around 1 count for it."""
    found = look("two_branch", 1, time_step=0.25, alpha=0.01)[0]
    middles, rows = found.midpoints, found.decoded.tau_space[1]
    near_zero = middles < 2.5  # rewards are 0, 5 and 10
    masses = np.stack([rows[:, near_zero].sum(axis=1), rows[:, (middles > 2.5) & (middles < 7.5)].sum(axis=1),
                       rows[:, middles > 7.5].sum(axis=1)], axis=1)  # fmt: skip
    step = np.array([0, 0] + 4 * [1] + 4 * [2] + 4 * [3])[: len(rows)]
    gathered = np.array([masses[step == n].sum(axis=0) for n in range(step[-1] + 1)])
    true = np.zeros_like(gathered)
    true[:3] = [[1, 0, 0], [1, 0, 0], [0, 0, 1]]
    assert Look(found, 1).error() == pytest.approx(np.abs(gathered - true).sum() / (2 * true.sum()), abs=1e-3)


def test_a_smaller_alpha_that_helps_is_found_though_much_smaller_ones_do_harm():
    # Two rows of fifteen steps: a little below alpha 1 folding undoes some smearing, and from half of it on it wins.
    found, artefacts = look("rise_and_fade", steps=2, alpha=1.0)
    here, little, half_a_decade = (Look(found, 0).error(alpha) for alpha in (1.0, 0.63, 0.316))
    assert little < here < half_a_decade
    assert artefacts["over-smoothing"].size == pytest.approx(here - little, abs=1e-3)


def test_thousands_of_rewards_need_no_matrix_of_rewards_by_rewards():
    rewards = 4_000
    rows = [Outcome(0, 0, 1.0 / rewards, 1, n / 8.0) for n in range(rewards)] + [Outcome(1, 0, 1.0, END, 0.0)]
    world = World.from_outcomes("many", ["a", "b"], ["go"], rows)
    found = study(world, Settings(world="many", steps=4))
    tracemalloc.start()
    find_artefacts(found, 0, searching=False)
    most = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert most < 60e6 < 8 * rewards**2  # bytes


def test_edge_clipping_measures_the_lost_half():
    # theta_min equal to a reward loses half of its probability: sigmoid(0) = 1/2.
    artefacts = look("two_branch", 1, theta_min=0.0)[1]
    assert artefacts["edge clipping"].size == pytest.approx(0.5, abs=0.01)


def test_a_remedy_changes_only_what_it_names():
    before = Settings(world="two_branch", params=(("r1", 4.0),), alpha=0.3)
    after = Remedy("x", {"param:auxiliary": True, "normalise": "none"}).apply(before)
    assert dict(after.params) == {"r1": 4.0, "auxiliary": True}
    assert (after.normalise, after.alpha) == ("none", 0.3)


def test_survival_above_one_offers_the_feasible_solver_which_has_none():
    # At noise .01 and alpha .01 the decoded survival of the long branch swings far above 1.
    found, artefacts = look("two_branch", 1, noise=0.01, alpha=0.01)
    above = artefacts["survival above 1"]
    assert above.size == pytest.approx(found.decoded.survival[1].max() - 1.0)
    (remedy,) = above.remedies
    assert remedy.changes == {"solver": "feasible"}
    repaired = study(load_world("two_branch"), remedy.apply(found.settings))
    assert repaired.decoded.survival.max() <= 1.0 + 1e-6
    assert "survival above 1" not in {each.name for each in find_artefacts(repaired, 1)}
    assert "survival above 1" not in look("two_branch", 1, alpha=0.2)[1]


def test_it_is_offered_before_any_search_and_beside_a_solver_that_is_not_linear():
    found = study(load_world("two_branch"), Settings(noise=0.01, alpha=0.01, solver="nonnegative"))
    assert found.decoded.survival[1].max() > 1.05
    for searching in (True, False):
        names = [each.name for each in find_artefacts(found, 1, searching=searching)]
        assert names == ["survival above 1", "not taken apart"]


def test_ringing_has_no_remedy_that_smears():
    # At alpha .01 the chain of 15 rewards rings, and every calmer alpha smears more: then there is no button.
    _, artefacts = look("rise_and_fade", alpha=0.01)
    assert [remedy.changes for remedy in artefacts["negative mass"].remedies] == [{"solver": "nonnegative"}]
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
    monkeypatch.setattr(episodes, "MAX_WORK", 10)
    assert "constant horizon" not in look("cliff_grid", deadline="constant", alpha=0.0123)[1]


def test_what_is_folded_is_what_comes_after_the_last_row():
    # One row for the long branch: 10 at tau = 2 is fitted by one number, sum gamma^2 / (G + alpha^2); 0 stays 0.
    found, artefacts = look("two_branch", 1, steps=1)
    gammas, alpha = found.gamma_space.gammas, found.settings.alpha
    share = 1.0 / (gammas.size + alpha**2)
    late, zeros = np.sum(gammas**2) * share, np.sum(gammas) * share  # tau = 1 pays another 0
    assert artefacts["folding"].size == pytest.approx((late + zeros) / 2.0, rel=2e-3)


def test_no_more_than_all_of_a_row_is_missing():
    # No reward lies within 100 to 200. The inverse overshoots, but more than everything cannot be gone.
    clipped = look("two_branch", 1, theta_min=100.0, theta_max=200.0)[1]["edge clipping"]
    assert clipped.size == 1.0
    assert clipped.shown == "up to 1.00 of a row's probability is missing"
