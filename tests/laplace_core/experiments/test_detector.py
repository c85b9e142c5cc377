"""The test of the detector: its cases, its ground truth on cases worked out by hand, and its score."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import pytest

from laplace_core import InputError, Settings
from laplace_core.cli import main
from laplace_core.experiments.cases import EXCLUSIVE, KINDS, SWITCHES, Case, draw_case
from laplace_core.experiments.detector import Compared, compare, score, table, wilson
from laplace_core.experiments.labels import LABELS, Effects
from laplace_core.study.artefacts import MEASURES, VISIBLE, find_artefacts
from laplace_core.study.pipeline import study
from laplace_core.study.settings import resolve
from laplace_core.worlds import END, Outcome, World

NEVER = dict.fromkeys(SWITCHES, 0.0)


def chain(*rewards: float) -> World:
    """One sure reward after the other, then the end."""
    following = [*range(1, len(rewards)), END]
    rows = [Outcome(i, 0, 1.0, following[i], float(r)) for i, r in enumerate(rewards)]
    return World.from_outcomes("chain", [f"s{i}" for i in range(len(rewards))], ["go"], rows)


def effects(world: World, **settings) -> dict[str, float]:
    chosen = resolve(Settings(world=world.name, **{"gammas": 25, "alpha": 1e-9, "thetas": 80} | settings), world)
    return Effects(Case(world, 0, chosen, chosen, ())).all()


# --- the base configuration ---


def test_the_base_has_no_artefact_by_either_account(subtests):
    for number in range(25):
        with subtests.test(number=number):
            case = draw_case(np.random.default_rng([3, number]), NEVER)
            assert case.settings == case.base
            assert find_artefacts(study(case.world, case.settings), case.action) == []
            assert max(Effects(case).all().values()) < 1e-2


def test_the_base_of_a_lasting_world_has_what_no_setting_avoids(subtests):
    """After the last row everything is folded, a long timeline that is sharp rings, and survival rings with it."""
    for number in range(8):
        with subtests.test(number=number):
            case = draw_case(np.random.default_rng([3, number]), NEVER, "lasting")
            assert case.settings == case.base
            found = find_artefacts(study(case.world, case.settings), case.action, searching=False)
            there = {name for name, effect in Effects(case).all().items() if effect > VISIBLE}
            assert {artefact.name for artefact in found} - {"survival above 1"} == there <= {"folding", "negative mass"}


def test_lasting_worlds_have_cycles_hundreds_of_steps_and_no_end():
    cases = [draw_case(np.random.default_rng([3, number]), NEVER, "lasting") for number in range(80)]
    assert {case.world.name for case in cases} == {"cycles", "long chain", "grid", "continuing", "idling"}
    assert {case.settings.time_step for case in cases} == {1.0, 0.5, 0.25}
    lengths = [case.settings.steps * case.settings.time_step for case in cases]
    assert min(lengths) < 5
    assert 150 < max(lengths) <= 200
    for case in cases:
        ends = np.any(case.world.next_state == END)
        assert ends == (case.world.name != "continuing")
        if case.world.name == "idling":  # the policy stays although it need not
            rewards = Effects(replace_steps(case, 50)).timeline @ case.world.reward_values
            assert np.all(rewards[10:] == 0.0)
            assert Effects(replace_steps(case, 50)).timeline.sum(axis=1) == pytest.approx(1.0)


def replace_steps(case: Case, steps: int) -> Case:
    settings = replace(case.settings, steps=steps, time_step=1.0)
    return Case(case.world, 0, settings, settings, ())


def test_exclusive_switches_are_never_thrown_together():
    always = dict.fromkeys(SWITCHES, 1.0)
    seen = set()
    for number in range(20):
        case = draw_case(np.random.default_rng([3, number]), always)
        thrown = set(case.switched)
        assert all(len(thrown & set(pair)) == 1 for pair in EXCLUSIVE)
        seen |= thrown
    assert seen == set(SWITCHES)


# --- the ground truth, worked out by hand ---


def test_rescaling_invents_a_step_for_every_row_after_the_end():
    # The chain of two ends before rows 2, 3 and 4. At alpha .2 there is a residue in two of them; the last is negative.
    world = chain(1, 2)
    gammas = study(world, resolve(Settings(world="chain", gammas=25), world)).gamma_space.gammas
    F = gammas[:, None] ** np.arange(5)
    rows = np.linalg.solve(F.T @ F + 0.04 * np.eye(5), F.T @ F[:, :2])  # of the rewards 1 at tau 0 and 2 at tau 1
    above = np.clip(rows, 0.0, None)
    mass = above.sum(axis=1, keepdims=True)
    assert mass[4] == 0.0
    more = above / np.where(mass > 0.0, mass, 1.0) - np.eye(5, 2)
    invented = np.clip(more, 0, None).sum(axis=1) - np.clip(rows - np.eye(5, 2), 0, None).sum(axis=1)
    sizes = effects(world, normalise="paper", steps=5, alpha=0.2)
    assert sizes["repeated reward"] == pytest.approx(np.clip(invented, 0, None).sum(), abs=2e-3)
    assert invented[2:4].min() > 0.5
    assert effects(world, normalise="paper", steps=2)["repeated reward"] == pytest.approx(0, abs=1e-9)


def test_a_row_of_rounding_invents_nothing():
    # Four rows at alpha 1e-9 are exact to 1e-10: what lies after the end is no residue but rounding.
    assert effects(chain(1), normalise="paper", steps=4)["repeated reward"] == pytest.approx(0.0, abs=1e-6)


def test_rewards_given_survival_are_as_if_sure():
    # A 1 at every step and an end with 1/2: given survival V_3 = 1 + .9 + .81, truly 1 + .45 + .2025.
    rows = [Outcome(0, 0, 0.5, 0, 1.0), Outcome(0, 0, 0.5, END, 1.0)]
    world = World.from_outcomes("coin", ["s"], ["go"], rows)
    kept = {"steps": 3, "acting_gamma": 0.9, "alpha": 1e-9, "gammas": 25}
    ended = [Outcome(t, 0, 0.5, t + 1 if t < 2 else END, 1.0) for t in range(3)]
    ended += [Outcome(t, 0, 0.5, END, 1.0) for t in range(3)]
    three = World.from_outcomes("three coins", ["s", "t", "u"], ["go"], ended)
    sizes = effects(three, normalise="survival", **kept)
    assert sizes["conditional rewards"] == pytest.approx((2.71 - 1.6525) / 1.6525, abs=1e-3)
    assert effects(three, **kept)["conditional rewards"] == 0.0
    assert Effects(Case(world, 0, *2 * (resolve(Settings(world="coin", **kept), world),), ())).timeline[
        :, 0
    ] == pytest.approx([1.0, 0.5, 0.25])


def test_the_end_is_what_folding_is_held_against_in_a_world_without_one():
    # A 1 for ever leaves 1 / (1 - gamma), which one row fits by its mean; it should hold 1.
    world = World.from_outcomes("for ever", ["s"], ["stay"], [Outcome(0, 0, 1.0, 0, 1.0)])
    gammas = study(world, resolve(Settings(world="for ever", gammas=25), world)).gamma_space.gammas
    expected = 0.5 * (np.mean(1.0 / (1.0 - gammas)) - 1.0)
    assert effects(world, steps=1)["folding"] == pytest.approx(expected, rel=1e-6)


def test_a_constant_horizon_misses_what_the_time_to_go_takes():
    # The 2 can be had at the second step, in place of a 10 at the fourth. With T = 3 kept up, the 10 seems to lie
    # within the horizon at the second step, and the episode of three steps ends with nothing: 2 gamma of 10 gamma^3.
    rows = [Outcome(0, a, 1.0, 1, 0.0) for a in (0, 1)] + [Outcome(1, 0, 1.0, END, 2.0), Outcome(1, 1, 1.0, 2, 0.0)]
    rows += [Outcome(2, a, 1.0, 3, 0.0) for a in (0, 1)] + [Outcome(3, a, 1.0, END, 10.0) for a in (0, 1)]
    world = World.from_outcomes("wait", ["a", "b", "c", "d"], ["take", "wait"], rows)
    kept = {"steps": 4, "acting_gamma": 0.9, "deadline": "constant"}
    assert effects(world, **kept)["constant horizon"] == pytest.approx(0.2 / 0.81, rel=1e-6)
    assert effects(world, **kept, time_step=0.5)["constant horizon"] == 0.0  # four rows end at T = 2.25


def test_folding_by_least_squares_on_one_row():
    # A single row is fitted to 1 + gamma: it holds 1 + mean(gamma) in place of 1; half of what moves is counted.
    world = chain(1, 1)
    settings = resolve(Settings(world="chain", gammas=25), world)
    gammas = study(world, settings).gamma_space.gammas
    assert effects(world, steps=1)["folding"] == pytest.approx(0.5 * gammas.mean(), rel=1e-6)
    assert effects(world, steps=2)["folding"] == pytest.approx(0.0, abs=1e-9)


def test_an_edge_on_a_reward_clips_half_of_it():
    assert effects(chain(1, 3), theta_min=1.0, theta_max=5.0)["edge clipping"] == pytest.approx(0.5, abs=1e-3)
    assert effects(chain(1, 3))["edge clipping"] == pytest.approx(0.0, abs=1e-3)


def test_blur_is_the_logistic_tail_beyond_the_middle():
    # Half the gap is 1: sigmoid(-2) = .119 of either reward passes it.
    assert effects(chain(1, 3), slope=2.0, theta_min=-5, theta_max=9, thetas=400)["slope blur"] == pytest.approx(
        1 / (1 + np.exp(2.0)), abs=5e-3
    )


def test_a_steep_slope_rounds_a_reward_to_the_midpoint():
    # Thresholds at 0, 1, 2, 3: a reward of 1.2 becomes 1.5; one of 1.5 stays.
    grid = {"thetas": 4, "theta_min": 0.0, "theta_max": 3.0, "slope": 200.0}
    assert effects(chain(1.2), **grid)["reward quantisation"] == pytest.approx(0.3, abs=1e-2)
    assert effects(chain(1.5), **grid)["reward quantisation"] == pytest.approx(0.0, abs=1e-2)


def test_a_soft_deadline_of_one_step():
    # T = 1: sigmoid((1 - 1/2) / 1) = .622 of a reward of 4 counts; the hard deadline counts all of it.
    assert effects(chain(4), softness=1.0, steps=1)["soft deadline"] == pytest.approx(1 - 1 / (1 + np.exp(-0.5)))


# --- the score ---


def test_wilson_s_interval():
    # 9 of 10: (.9 + 1.92073/10 +- 1.96 sqrt(.09/10 + .96036/100)) / 1.384146 ... by hand: .596 to .982.
    assert wilson(9, 10) == pytest.approx((0.5958, 0.9821), abs=1e-4)
    assert wilson(10, 10)[1] == 1.0
    assert wilson(0, 0) == (0.0, 1.0)


def test_a_score_counts_what_is_there_and_what_is_listed():
    case = draw_case(np.random.default_rng(0), NEVER)

    def one(effect: float, size: float) -> Compared:
        return Compared(case, dict.fromkeys(MEASURES, effect), dict.fromkeys(MEASURES, size))

    for found in score([one(0.5, 0.4), one(0.5, 0.4), one(0.5, 0.4), one(0.5, 0.0), one(0.0, 0.3), one(0.01, 0.0)]):
        counts = (found.true_positive, found.false_positive, found.false_negative, found.true_negative)
        assert counts == (3, 1, 1, 1)
        assert (found.precision, found.recall) == (0.75, 0.75)
        assert (found.thrown, found.unseen, found.unthrown) == (0, 0, 4)


def test_every_artefact_has_its_switch():
    assert list(LABELS) == list(MEASURES)
    assert {label.switch for label in LABELS.values()} == set(SWITCHES)


def test_further_switches_leave_all_else_of_a_case_as_it_is():
    def dear(rng, world, settings):
        return {"value_gamma": float(rng.uniform(0.2, 0.6))}

    thrown = 0
    for number in range(10):
        case, more = (draw_case(np.random.default_rng([3, number]), more=each) for each in (None, {"dear": dear}))
        thrown += "dear" in more.switched
        assert case.switched == tuple(name for name in more.switched if name != "dear")
        assert (case.world.name, case.action, case.base) == (more.world.name, more.action, more.base)
        assert case.settings == replace(more.settings, value_gamma=case.settings.value_gamma)
        assert (more.settings.value_gamma < 0.6) == ("dear" in more.switched)
    assert 0 < thrown < 10


@pytest.mark.parametrize(
    ("kind", "cases"),
    [
        ("short", 12), pytest.param("short", 25, marks=pytest.mark.long),
        ("lasting", 4), pytest.param("lasting", 8, marks=pytest.mark.long),
    ],
)  # fmt: skip
def test_precision_and_recall(kind, cases):
    scores = score(list(compare(cases, 4, kind)))
    wrong = sum(one.false_positive + one.false_negative for one in scores)
    there = sum(one.on for one in scores)
    assert wrong <= 0.02 * there, table(scores, cases, 4, kind)
    # Enough is there, and enough is not, for that to mean something.
    assert there > 2 * cases
    assert sum(one.off for one in scores) > 4 * cases


def test_the_same_seed_gives_the_same_cases():
    first, again = list(compare(2, 5, "lasting")), list(compare(2, 5, "lasting"))
    assert [one.effects for one in first] == [one.effects for one in again]
    assert [one.sizes for one in first] == [one.sizes for one in again]
    assert next(compare(1, 6, "lasting")).case.settings != first[0].case.settings


def test_too_many_cases_are_refused():
    with pytest.raises(InputError, match="cases is 0"):
        next(compare(0, 1))


def test_the_report_of_the_command_line(capsys):
    assert main(["report", "detectors", "--cases", "1", "--seed", "4", "--json"]) == 0
    printed = json.loads(capsys.readouterr().out)
    assert (printed["cases"], printed["seed"]) == (1, 4)
    assert [one["name"] for one in printed["artefacts"]] == list(MEASURES)
    assert main(["report", "detectors", "--cases", "1", "--seed", "4"]) == 0
    assert [one["on"] + one["off"] for one in printed["artefacts"]] == [2] * len(MEASURES)
    for kind in KINDS:
        assert [one["on"] + one["off"] for one in printed["kinds"][kind]] == [1] * len(MEASURES)
    assert capsys.readouterr().out.count("conditional rewards") == 3  # each kind, and all
    assert main(["report", "detectors", "--seed=-1"]) == 2
