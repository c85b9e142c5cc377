"""The test of the detector: its cases, its ground truth on cases worked out by hand, and its score."""

from __future__ import annotations

import json

import numpy as np
import pytest

from laplace_core import InputError, Settings
from laplace_core.artifacts import MEASURES, find_artefacts
from laplace_core.cli import main
from laplace_core.experiments.cases import SWITCHES, Case, draw_case
from laplace_core.experiments.detector import SWITCHES_OF, Compared, compare, score, table, wilson
from laplace_core.experiments.labels import Effects
from laplace_core.pipeline import study
from laplace_core.settings import resolve
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


@pytest.mark.parametrize("number", range(25))
def test_the_base_has_no_artefact_by_either_account(number):
    case = draw_case(np.random.default_rng([3, number]), NEVER)
    assert case.settings == case.base
    assert find_artefacts(study(case.world, case.settings), case.action) == []
    assert max(Effects(case).all().values()) < 1e-2


def test_exclusive_switches_are_never_thrown_together():
    always = dict.fromkeys(SWITCHES, 1.0)
    seen = set()
    for number in range(20):
        case = draw_case(np.random.default_rng([3, number]), always)
        thrown = set(case.switched)
        assert len(thrown & {"blur", "quantisation"}) == len(thrown & {"smearing", "ringing"}) == 1
        seen |= thrown
    assert seen == set(SWITCHES)


# --- the ground truth, worked out by hand ---


def test_rescaling_invents_a_step_for_every_row_after_the_end():
    # The chain of two ends before rows 2, 3 and 4; at alpha .2 every one of them holds a residue to rescale.
    assert effects(chain(1, 2), normalise="paper", steps=5, alpha=0.2)["repeated reward"] == pytest.approx(3, abs=1e-9)
    assert effects(chain(1, 2), normalise="paper", steps=2)["repeated reward"] == pytest.approx(0, abs=1e-9)


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
    assert set(SWITCHES_OF) == set(MEASURES)
    assert set().union(*SWITCHES_OF.values()) == set(SWITCHES)


def test_precision_and_recall_on_sixty_cases():
    compared = list(compare(60, 4))
    scores = score(compared)
    for one in scores:
        if one.true_positive + one.false_positive >= 5:
            assert one.precision >= 0.9, table(scores, 60, 4)
        if one.on >= 5:
            assert one.recall >= 0.9, table(scores, 60, 4)
    # Enough of each is there, and enough is not, for that to mean something.
    assert sum(one.on for one in scores) > 100
    assert all(one.off >= 20 for one in scores)


def test_the_same_seed_gives_the_same_cases():
    first, again = list(compare(3, 5)), list(compare(3, 5))
    assert [one.effects for one in first] == [one.effects for one in again]
    assert [one.sizes for one in first] == [one.sizes for one in again]
    assert [one.case.settings for one in list(compare(3, 6))] != [one.case.settings for one in first]


def test_too_many_cases_are_refused():
    with pytest.raises(InputError, match="cases is 0"):
        next(compare(0, 1))


def test_the_report_of_the_command_line(capsys):
    assert main(["report", "detectors", "--cases", "2", "--seed", "4", "--json"]) == 0
    printed = json.loads(capsys.readouterr().out)
    assert (printed["cases"], printed["seed"]) == (2, 4)
    assert [one["name"] for one in printed["artefacts"]] == list(MEASURES)
    assert main(["report", "detectors", "--cases", "2", "--seed", "4"]) == 0
    assert "repeated reward" in capsys.readouterr().out
    assert main(["report", "detectors", "--seed=-1"]) == 2
