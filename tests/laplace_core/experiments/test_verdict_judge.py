"""The independent judge of verdicts: numbers derived by hand, the library as a second account, and the counting."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from laplace_core import Settings, load_world
from laplace_core.cli import main
from laplace_core.experiments import views
from laplace_core.experiments.judge import (
    ALPHAS,
    FRESH_SEEDS,
    Judge,
    _normalised,
    discounts,
    every_single_setting,
    grade,
    judge_view,
    repairs,
    sensitivities,
    single_settings,
)
from laplace_core.experiments.verdicts import CRITERIA, Answer, Examined, examine, rows_of, table
from laplace_core.experiments.views import MOST_ROWS, View, draw_view
from laplace_core.study.pipeline import grids, study
from laplace_core.study.settings import resolve
from laplace_core.worlds import END, Outcome, World

FIG4 = Settings(
    world="two_branch", gammas=15, spacing="inverse-log", gamma_min=0.01, gamma_max=0.99, alpha=0.2, steps=3,
    thetas=150, theta_min=-2.0, theta_max=12.0, slope=25.0,
)  # fmt: skip


def view_of(world: World, row: int, action: int | None = None, **settings) -> View:
    return View(world, resolve(Settings(world=world.source or world.name, **settings), world), row, action)


def fig4(**settings) -> View:
    world = load_world("two_branch")
    return View(world, resolve(replace(FIG4, **settings), world), 2)


def chain(*rewards: float) -> World:
    """One sure reward after the other, then the end."""
    following = [*range(1, len(rewards)), END]
    rows = [Outcome(i, 0, 1.0, following[i], float(r)) for i, r in enumerate(rewards)]
    return World.from_outcomes("sure", [f"s{i}" for i in range(len(rewards))], ["go"], rows)


# --- Fig. 4 of the paper: short pays 5 and ends, long pays 0, 0, 10; gamma .99, so that it is worth 9.801 ---


def test_rescaled_rows_choose_the_short_branch():
    """Every row of short becomes a sure 5: 5 + 4.95 + 4.9005 = 14.85, above 9.74; the error is 14.8505 - 5."""
    judge = Judge(fig4(normalise="paper"))
    rows, _ = judge.rows(judge.view.settings)
    rewards = rows @ (sensitivities(judge.view.settings)[:-1] + 7.0 / 149.0)
    np.testing.assert_allclose(rewards[0], 5.0, atol=0.01)
    np.testing.assert_allclose(rewards @ 0.99 ** np.arange(3), [14.85, 9.74], atol=0.02)
    assert (judge.judged.choice, judge.judged.chosen, judge.judged.best) == ("wrong", 0, 1)
    assert judge.judged.error == pytest.approx(9.85, abs=0.02)
    assert judge.judged.value_error == pytest.approx(9.85 / 9.801, abs=0.003)


def test_rows_left_alone_choose_the_long_branch():
    judge = Judge(fig4())
    rows, survival = judge.rows(judge.view.settings)
    rewards = rows @ (sensitivities(judge.view.settings)[:-1] + 7.0 / 149.0)
    np.testing.assert_allclose(rewards[0], [4.81, 0.16, 0.04], atol=0.006)
    np.testing.assert_allclose(survival[0], [0.96, 0.03, 0.01], atol=0.006)
    np.testing.assert_allclose(rewards @ 0.99 ** np.arange(3), [5.00, 9.70], atol=0.006)
    assert (judge.judged.choice, judge.judged.chosen) == ("right", 1)
    assert judge.judged.error == pytest.approx(9.801 - 9.70, abs=0.006)


def test_what_repairs_fig4():
    """Survival kept, or the paper's auxiliary states: each alone. More rows only repeat the reward more often."""
    view = fig4(normalise="paper")
    assert repairs(view, {"normalise": "none"})
    assert repairs(view, {"param:auxiliary": True})
    assert not repairs(view, {"steps": 6})
    found = every_single_setting(view)
    assert found[("normalise", "none"),]
    assert found[("param:auxiliary", True),]
    assert not any(held for change, held in found.items() if change[0][0] in ("steps", "slope", "theta_max"))
    assert len(every_single_setting(view, until_one=True)) == 1  # normalise is the first


def test_only_what_is_broken_is_repaired():
    view = fig4(alpha=1e-6, gammas=30, spacing="log")
    assert judge_view(view).choice == "right"
    assert judge_view(view).grades == ("sound", "sound")
    assert not repairs(view, {"alpha": 1e-9})
    assert Judge(view).harm({"alpha": 1e-9}) is None
    assert Judge(view).harm({"alpha": 5.0}) is not None


def test_the_single_settings_of_fig4():
    """Rewards 0, 5, 10 in -2 to 12: a fifth of 10 overhangs already. Spacing 14/149 wants a slope of 25.01, and
    9 / 5 = 1.8 is gentler than 25: neither sensitivities nor slope are changed. Two more numbers than it has of each
    end of the discounts, three other spacings, twice and four times the discounts, 59 alphas beside its own, which is
    one of the 60, and twice, four times and so on as many rows, up to 2,000."""
    tried = list(single_settings(fig4(normalise="paper")))
    assert tried[:2] == [{"normalise": "none"}, {"param:auxiliary": True}]
    assert tried[2:5] == [{"spacing": name} for name in ("log", "linear", "paper")]
    assert tried[5:7] == [{"gammas": 30}, {"gammas": 60}]
    assert tried[7:11] == [{"gamma_min": 0.1}, {"gamma_min": 0.3}, {"gamma_max": 0.995}, {"gamma_max": 0.999}]
    assert len(ALPHAS) == 60
    assert [change["alpha"] for change in tried[11:70]] == [alpha for alpha in ALPHAS if alpha != 0.2]
    assert tried[70:] == [{"steps": n} for n in (6, 12, 24, 48, 96, 192, 384, 768, 1536, 2000)]


def test_every_other_single_setting():
    """Rewards 0 and 4. A fifth of their range is .8, but 8 / slope = 1.6 is more: -1.6 to 5.6. At the spacing of
    4 / 39 that is 39 * 7.2 / 4 = 70.2 spacings, rounded up 71, so 72 sensitivities. The gap of 4 wants no slope
    steeper than 2.25. Half steps: 5 rows reach T = 2.75, so 3 whole ones are needed. 900 rows reach 2,000 soon."""
    world = chain(0.0, 4.0)
    settings = {"thetas": 40, "theta_min": 0.0, "theta_max": 4.0, "slope": 5.0, "time_step": 0.5, "steps": 5}
    view = view_of(
        world, 0, **settings, policy="per_gamma", noise=1e-3, softness=0.1, spacing="paper", normalise="survival"
    )  # fmt: skip
    tried = [change for change in single_settings(view) if "alpha" not in change]
    assert tried[:4] == [{"normalise": "none"}, {"policy": "shared"}, {"noise": 0.0}, {"softness": 0.0}]
    assert tried[4] == {"theta_min": pytest.approx(-1.6), "theta_max": pytest.approx(5.6), "thetas": 72}
    assert tried[5:8] == [{"spacing": name} for name in ("inverse-log", "log", "linear")]
    assert tried[8] == {"time_step": 1.0, "steps": 3}
    assert tried[9:] == [{"steps": n} for n in (10, 20, 40, 80, 160, 320, 640, 1280, 2000)]

    long = view_of(world, 0, **settings | {"steps": 900}, theta_spacing="asinh")
    tried = list(single_settings(long))
    assert [change["steps"] for change in tried if list(change) == ["steps"]] == [1800, 2000]
    assert {"theta_spacing": "uniform"} in tried

    # 9 / 4 = 2.25 is steeper than 1 and needs 4 * 2.25 / 2.35 = 3.8 spacings, which 40 sensitivities hold.
    gentle = view_of(world, 0, **settings | {"slope": 1.0})
    assert {"slope": 2.25, "thetas": 40} in list(single_settings(gentle))
    # The spacing of 4 / 39 wants 22.9; 30 is more than a tenth above it.
    steep = view_of(world, 0, **settings | {"slope": 30.0})
    assert {"slope": pytest.approx(2.35 * 39 / 4)} in list(single_settings(steep))


# --- one row: F is a column of ones, so that a row comes back as G / (G + alpha^2) of what it is ---


@pytest.mark.parametrize(("alpha", "back"), [(2.0, 0.5), (0.9, 4.0 / 4.81), (0.5, 4.0 / 4.25)])
def test_one_row_shrinks_by_the_regularisation(alpha, back):
    """Four discounts. The value is off by 1 - back of itself, the timeline by half of that."""
    view = view_of(chain(1.0), 0, gammas=4, alpha=alpha, steps=1)
    judged = judge_view(view)
    assert judged.value_error == pytest.approx(1.0 - back, abs=2e-3)  # the proxy of the midpoints is not exact
    assert judged.timeline_errors[0] == pytest.approx((1.0 - back) / 2.0, abs=1e-6)
    assert judged.choice == ("off" if back < 0.9 else "right")
    assert judged.grades == ("smeared" if alpha == 2.0 else "sound",)


def test_grades_include_their_upper_ends():
    assert [grade(x) for x in (0.0, 0.1, 0.1001, 1.0 / 3.0, 0.334)] == [
        "sound",
        "sound",
        "smeared",
        "smeared",
        "ruined",
    ]


def test_a_remedy_for_noisy_values_has_to_hold_on_nine_of_ten_seeds():
    """With alpha near 0 one row is the mean over four discounts. A value is then off by a normal error: the error of
    threshold h counts theta_mid[h] - theta_mid[h-1], at the ends the first and the last midpoint itself."""
    shares = {}
    for wanted in (0.5, 0.999):
        view = view_of(chain(1.0), 0, gammas=4, alpha=2.0, steps=1, thetas=20, noise=1e-3, noise_seed=3)
        gammas, thetas = grids(view.settings)
        middles = (thetas[1:] + thetas[:-1]) / 2.0
        of_one = np.sqrt(middles[0] ** 2 + (np.diff(middles) ** 2).sum() + middles[-1] ** 2)
        one = of_one * np.sqrt((1.0 / (4.0 * (1.0 - gammas)) ** 2).sum())
        deviation = 0.1 / {0.5: 0.67449, 0.999: 3.2905}[wanted]  # normal quantiles of (1 + wanted) / 2
        view = replace(view, settings=replace(view.settings, noise=float(deviation / one)))
        judge = Judge(view)
        assert judge.judged.choice == "off"
        shares[wanted] = judge.share_held({"alpha": 1e-6}, 300)
        if wanted == 0.5:
            assert not judge.repairs({"alpha": 1e-6})
        else:
            seeds = [replace(view.settings, alpha=1e-6, noise_seed=seed) for seed in (3, *FRESH_SEEDS)]
            assert all(judge_view(replace(view, settings=one)).value_error <= 0.1 for one in seeds)
            assert judge.repairs({"alpha": 1e-6})
    assert shares[0.5] == pytest.approx(0.5, abs=4 * 0.5 / math.sqrt(300))
    assert shares[0.999] >= 0.98


# --- the lens's switches, by hand: one chain, four discounts, and alpha near 0 ---

FOUR = {"gammas": 4, "gamma_min": 0.2, "gamma_max": 0.8, "spacing": "linear", "alpha": 1e-9, "acting_gamma": 0.9}


def test_with_steps_used_the_steps_that_are_left_are_judged():
    """Rewards 1, 2, 3. At T = 3 with one step used two are left: 1 + .9 * 2 = 2.8. An agent with a constant horizon
    reads all three, and is off by .81 * 3."""
    left = judge_view(view_of(chain(1.0, 2.0, 3.0), 2, steps=3, used=1.0, **FOUR))
    assert left == judge_view(view_of(chain(1.0, 2.0, 3.0), 1, steps=3, **FOUR))
    assert left.choice == "right"
    view = view_of(chain(1.0, 2.0, 3.0), 2, steps=3, used=1.0, deadline="constant", **FOUR)
    assert judge_view(view).value_error == pytest.approx(0.81 * 3.0 / 2.8, abs=2e-3)
    assert {"deadline": "time_to_go"} in list(single_settings(view))
    assert repairs(view, {"deadline": "time_to_go"})


def test_the_discount_of_the_values_weighs_both_sides_but_not_the_best_action():
    """At .5 the values are 1 + 1 + .75, decoded and true; at the acting discount of .9 they would be 5.23."""
    judged = judge_view(view_of(chain(1.0, 2.0, 3.0), 2, steps=3, value_gamma=0.5, **FOUR))
    assert judged.value_error == pytest.approx(0.0, abs=2e-3)
    assert judged.error == pytest.approx(5.23 - 2.75, abs=5e-3)


def test_the_discount_of_the_values_may_choose_wrongly():
    """Leave for 2, or go on for nothing and then 3: at .5 that is worth 1.5, at .9 it is 2.7."""
    rows = [Outcome(0, 0, 1.0, END, 2.0), Outcome(0, 1, 1.0, 1, 0.0)]
    rows += [Outcome(1, action, 1.0, END, 3.0) for action in range(2)]
    world = World.from_outcomes("wait", ["s", "later"], ["leave", "wait"], rows)
    view = view_of(world, 1, steps=2, value_gamma=0.5, **FOUR)
    assert (judge_view(view).choice, judge_view(view).chosen, judge_view(view).best) == ("wrong", 0, 1)
    assert repairs(view, {"value_gamma": 0.9})


def test_folded_into_one_row_what_comes_later_counts_now():
    """Rewards 1, 0, 3. One row is the mean over the discounts of 1 + 3 gamma^2: .2, .4, .6 and .8 squared are .3 in the
    mean, of reward 3. Of reward 0 the row holds the mean of gamma, .5; and two steps are not drawn at all."""
    view = view_of(chain(1.0, 0.0, 3.0), 0, steps=3, fold=True, **FOUR)
    judged = judge_view(view)
    assert judged.value_error == pytest.approx(0.9, abs=5e-3)
    assert judged.timeline_errors[0] == pytest.approx((0.5 + 0.3 + 1.0 + 1.0) / 2.0 / 3.0, abs=5e-3)
    assert repairs(view, {"fold": False})
    tried = list(single_settings(view))
    assert {"fold": False} in tried
    assert not any("steps" in change for change in tried)  # each horizon has its own number of rows


def test_shifted_by_one_the_first_discount_holds_nothing():
    """One row is the mean of 0, 1, 1 and 1."""
    view = view_of(chain(1.0), 0, steps=1, shift=True, **FOUR)
    assert judge_view(view).value_error == pytest.approx(0.25, abs=2e-3)
    assert repairs(view, {"shift": False})


def test_clipped_sensitivities_begin_at_the_lowest_reward_that_occurs():
    """Half of its probability lies below them. The third reward comes after the last horizon, and is not looked for."""
    view = view_of(chain(4.0, 2.0, -5.0), 0, steps=2, clip=True, theta_min=-6.0, theta_max=6.0, slope=50.0, **FOUR)
    judge = Judge(view)
    assert judge._thetas(view.world, view.settings)[[0, -1]].tolist() == [2.0, 6.0]
    _, by_reward = judge._decoded(view.world, 0, view.settings)[0]
    np.testing.assert_allclose(by_reward.sum(axis=1), [1.0, 0.5], atol=5e-3)
    assert {"clip": False} in list(single_settings(view))
    short = view_of(chain(4.0, 2.0), 1, steps=2, clip=True, theta_min=-6.0, theta_max=6.0, **FOUR)
    assert judge_view(short).value_error == pytest.approx(0.5 * 0.9 * 2.0 / 5.8, abs=0.01)
    assert repairs(short, {"clip": False})
    outside = view_of(chain(4.0, 2.0), 0, steps=2, clip=True, theta_min=3.0, theta_max=6.0, **FOUR)
    assert Judge(outside)._thetas(outside.world, outside.settings)[0] == 3.0


def test_the_paper_s_grid_takes_the_place_of_the_discounts_and_is_left_only():
    view = view_of(chain(1.0), 0, steps=1, paper_grid=True, **FOUR)
    assert discounts(view.settings) == discounts(replace(view.settings, spacing="paper"))
    tried = [
        change for change in single_settings(view) if set(change) & {"paper_grid", "spacing", "gammas", "gamma_min"}
    ]
    assert tried == [{"paper_grid": False}]


# --- truth ---


def test_true_rows_lie_where_the_transform_puts_them():
    """Rewards 1, 2, 3 at steps 0, 1, 2. At a time step of .5 they lie on rows 0, 2 and 4; at .4, step 1 lies at 2.5
    and is shared by rows 2 and 3, and step 2 lies on row 5. Column k counts rows 0 to k."""
    world = chain(1.0, 2.0, 3.0)
    rows = {}
    for time_step in (0.5, 0.4):
        view = view_of(world, 0, gammas=5, steps=6, time_step=time_step, acting_gamma=0.9)
        rows[time_step] = Judge(view)._true_rows(world, 0, view.settings)[0] @ [1.0, 2.0, 3.0]
    np.testing.assert_allclose(rows[0.5], [1, 0, 2, 0, 3, 0])
    np.testing.assert_allclose(rows[0.4], [1, 0, 1, 1, 0, 3])
    # T = .75 + .5 * 3 = 2.25: two whole steps, 1 + .9 * 2.
    view = view_of(world, 3, gammas=40, spacing="log", alpha=1e-9, steps=6, time_step=0.5, acting_gamma=0.9)
    judge = Judge(view)
    assert judge._optimum(world, 0, 0.9, 2) == pytest.approx(2.8)


def test_ringing_between_whole_steps_is_no_error_of_the_timeline():
    """Twice the rows for the same episode: what a step is spread over counts for that step."""
    settings = {"gammas": 40, "spacing": "log", "gamma_min": 0.01, "gamma_max": 0.99, "alpha": 1e-7}
    whole = judge_view(view_of(chain(1.0, 0.0, 3.0), 2, steps=4, **settings))
    halves = judge_view(view_of(chain(1.0, 0.0, 3.0), 4, steps=8, time_step=0.5, **settings))
    assert whole.grades == ("sound",)
    assert halves.timeline_errors[0] < 0.5  # row by row, half of each step's probability would lie elsewhere


@pytest.mark.parametrize("ring", [1, 3])
def test_idling_for_ever_is_the_end(ring):
    """Short pays 5 and idles, long pays 0 and then 10 and idles: with T = 2 long is worth .9 * 10."""
    idle = [2 + i for i in range(ring)]
    rows = [Outcome(0, 0, 1.0, 2, 5.0), Outcome(0, 1, 1.0, 1, 0.0)]
    rows += [Outcome(1, a, 1.0, 2, 10.0) for a in range(2)]
    rows += [Outcome(s, a, 1.0, idle[(i + 1 + a) % ring], 0.0) for i, s in enumerate(idle) for a in range(2)]
    world = World.from_outcomes("idle", [f"s{i}" for i in range(2 + ring)], ["short", "long"], rows)
    view = view_of(world, 1, gammas=20, spacing="log", alpha=1e-6, steps=4, acting_gamma=0.9)
    judge = Judge(view)
    rows = judge._true_rows(world, 0, view.settings)
    np.testing.assert_allclose(rows.sum(axis=2), [[1, 0, 0, 0], [1, 1, 0, 0]])
    np.testing.assert_allclose(judge._optimum(world, 0, 0.9, 2), [5.0, 9.0])
    assert judge.judged.choice == "right"


def test_idling_that_may_be_left_is_no_end():
    rows = [Outcome(0, 0, 1.0, 1, 5.0), Outcome(1, 0, 0.5, 1, 0.0), Outcome(1, 0, 0.5, END, 0.0)]
    world = World.from_outcomes("waits", ["s", "idle"], ["go"], rows)
    view = view_of(world, 0, steps=4)
    survival = Judge(view)._true_rows(world, 0, view.settings)[0].sum(axis=1)
    np.testing.assert_allclose(survival, [1.0, 1.0, 0.5, 0.25])


def test_rows_of_rounding_are_not_rescaled():
    """A mass of 2e-13 of what a row could hold by Cauchy and Schwarz is rounding; 1e-11 is a residue of something."""
    settings = resolve(Settings(normalise="paper", steps=2), load_world("two_branch"))
    inverse = np.array([[1.0, 0.0], [1.0, 0.0], [1.0, 0.0]])
    for left, rescaled in ((2e-13, 0.0), (1e-11, 1.0)):
        differences = np.array([[left, 0.0], [3.0, 1.0]])
        found = _normalised(inverse, differences * [[0.25], [0.25]], np.ones(3), settings)
        np.testing.assert_allclose(found.sum(axis=1), rescaled)


def test_equal_values_choose_the_lowest_action_however_small_they_are():
    rows = [Outcome(0, 0, 1.0, END, 1e-7), Outcome(0, 1, 1.0, END, 1e-7), Outcome(0, 2, 1.0, END, 1.00001e-7)]
    world = World.from_outcomes("small", ["s"], ["a", "b", "c"], rows)
    judged = judge_view(view_of(world, 0, gammas=4, alpha=1e-9, steps=1, slope=1e10, theta_min=0.0, theta_max=1e-6))
    assert judged.best == 2
    assert judged.choice == ("right" if judged.chosen == 2 else "wrong")


def test_values_that_differ_by_rounding_of_their_terms_are_equal(monkeypatch):
    """Nothing is paid within T = 1, and both actions come out at -9e-4, 1.5e-11 apart: sums over midpoints of up to 66,
    of which 1e-12 is rounding."""
    monkeypatch.setattr(views, "SWITCHED", 1.0)
    view = draw_view(np.random.default_rng([5252, 106]))
    assert sensitivities(view.settings)[-1] == 66.0
    assert judge_view(view).chosen == 0


# --- the library as a second account ---


def ended(world: World, judge: Judge) -> World:
    """The world with END in place of the states that idle for ever, as the judge moves through it."""
    dense = judge._dense(world)
    rows = []
    for state in range(world.n_states):
        for action in range(world.n_actions):
            for row in world.outcomes(state, action):
                over = row.next_state == END or dense.moves[action, state, row.next_state] == 0.0
                rows.append(row._replace(next_state=END) if over else row)
    return World.from_outcomes(world.name, world.states, world.actions, rows, start=world.start)


@pytest.mark.parametrize("first", [0, *(pytest.param(first, marks=pytest.mark.long) for first in (50, 100, 150))])
def test_the_library_gives_the_same_numbers(first):
    """At whole time steps; to 1e-6, of which nearly all is the rounding that a small alpha magnifies."""
    compared, number = 0, 100 * first
    while compared < 50:
        view = draw_view(np.random.default_rng([31, number]))
        number += 1
        s = view.settings
        if s.time_step < 1.0:
            continue
        compared += 1
        judge = Judge(view)
        found = study(ended(view.world, judge), s)
        world, state = view.world, view.world.state_index(s.state)
        (gammas, _), thetas, decoded = grids(s), found.gamma_space.thetas, found.at(view.row)
        read, left = found.reading(view.row)
        np.testing.assert_allclose(discounts(s), gammas, rtol=1e-12)
        np.testing.assert_allclose(judge._thetas(world, s), thetas, rtol=1e-9, atol=1e-12 * np.abs(thetas).max())
        values, constant = judge.gamma_space(s)
        close(values, found.gamma_space.values)
        close(constant, found.gamma_space.constant)
        rows, survival = judge.rows(s)
        if s.normalise == "paper":  # a row of little mass is rescaled, and its rounding with it
            mass = np.maximum(judge.rows(replace(s, normalise="none"))[0], 0.0).sum(axis=2)
            most = np.linalg.norm(judge.decode_matrix(s, rows.shape[1]), axis=1)
            held = mass > 1e-9 * most * np.linalg.norm(values, axis=(1, 2))[:, None]
        else:
            held = np.ones(rows.shape[:2], dtype=bool)
        close(rows[held], decoded.tau_space[:, : rows.shape[1]][held])
        close(survival, decoded.survival[:, : rows.shape[1]])
        assert not decoded.tau_space[:, rows.shape[1] :].any()
        by_step = judge._true_rows(world, state, s) @ found.world.reward_values
        close(by_step, found.truth.expected_reward)
        true = by_step @ weights_at(left, s)
        close(true, found.truth.horizon_values[:, left])
        optimum = judge._optimum(world, state, s.acting_gamma, left + 1)
        close(optimum, found.truth.optimum[:, left])
        if held.all():
            rewards = np.array([one[0] for one in judge._decoded(world, state, s, rows.shape[1])])
            least = 1e-6 * np.abs(rows).sum(axis=2).max() * np.abs(thetas).max()
            np.testing.assert_allclose(rewards, decoded.expected_reward, rtol=0, atol=least)
            values = decoded.horizon_values[:, read]
            scale = max(np.abs(true).max(), 1e-2 * np.abs(world.reward).max())
            assert judge.judged.value_error == pytest.approx(np.abs(values - true).max() / scale, rel=1e-4, abs=1e-4)
            truth = np.abs(found.truth.optimum[:, left])
            if np.abs(values - values.max())[values < values.max()].min(initial=1.0) > 1e-5:
                chosen = int(values.argmax())
                assert judge.judged.chosen == chosen
                lost = found.truth.optimum[:, left].max() - found.truth.optimum[chosen, left]
                assert (judge.judged.choice == "wrong") == (lost > 1e-9 * truth.max())


def weights_at(column: int, s: Settings) -> np.ndarray:
    """Discount times deadline of every whole step."""
    weights = s.value_gamma ** np.arange(s.steps)
    return weights * soft(column + 1, s) if s.softness else weights * (np.arange(s.steps) <= column)


def soft(horizon: float, s: Settings) -> np.ndarray:
    """The logistic deadline at T - 1/2, by a hyperbolic tangent."""
    return 0.5 + 0.5 * np.tanh((horizon - 0.5 - np.arange(s.steps)) / (2.0 * s.softness * horizon))


def close(found: np.ndarray, expected: np.ndarray) -> None:
    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-6 * max(float(np.abs(expected).max()), 1e-9))


# --- the views ---


def thrown(s: Settings) -> set[str]:
    """The switches of the lens that are not as they are by default."""
    found = {name for name in ("used", "fold", "shift", "clip", "paper_grid") if getattr(s, name)}
    found |= {"value_gamma"} if s.value_gamma != s.acting_gamma else set()
    return found | ({"horizon"} if s.horizon is not None else set())


def test_without_a_switch_a_view_of_a_seed_is_what_it_was_before_there_were_switches(monkeypatch):
    """Switches are drawn last, so that numbers of views that were written down still mean the same."""
    every = [draw_view(np.random.default_rng([33, number])) for number in range(40)]
    monkeypatch.setattr(views, "SWITCHED", 0.0)
    for number, view in enumerate(every):
        before = draw_view(np.random.default_rng([33, number]))
        assert (before.row, before.action, before.world.name) == (view.row, view.action, view.world.name)
        plain = {name: getattr(before.settings, name) for name in thrown(view.settings)}
        assert replace(view.settings, **plain) == before.settings
        assert not thrown(before.settings)


def test_views_are_of_every_kind():
    seen, choices, switched = set(), {}, 0
    for number in range(200):
        view = draw_view(np.random.default_rng([33, number]))
        s, world = view.settings, view.world
        assert 1 <= s.steps <= MOST_ROWS
        assert 0 <= view.row < s.steps
        assert 20 <= s.thetas <= 160
        assert 5 <= s.gammas <= 40
        seen |= {s.normalise, s.policy, s.spacing, s.theta_spacing, round(s.time_step, 2), world.name, s.noise > 0}
        seen |= {("softness", s.softness > 0), ("actions", world.n_actions), ("source", bool(world.source))}
        seen |= thrown(s)
        switched += bool(thrown(s))
        choice = judge_view(view).choice
        choices[choice] = choices.get(choice, 0) + 1
    assert {"none", "paper", "survival", "shared", "per_gamma", "inverse-log", "log", "linear"} <= seen
    assert {"uniform", "gaussian", "asinh", 1.0, 0.5, 0.25, 0.33, False} <= seen
    assert {"layers", "tree", "cycles", "continuing", "long way", "decisions", "idle", "two_branch"} <= seen
    assert {("actions", n) for n in (1, 2, 3, 4)} <= seen
    assert {"used", "value_gamma", "fold", "shift", "clip", "paper_grid", "horizon"} <= seen
    assert 0.15 <= switched / 200 <= 0.35
    assert choices["wrong"] >= 20
    assert 0.4 <= (choices["wrong"] + choices["off"]) / 200 <= 0.7


# --- the counting ---


def truthful(view: View) -> Answer:
    """Says what the judge finds, names the first setting that repairs, and offers it twice."""
    judge = Judge(view)
    held = judge.every_single_setting(until_one=True) if judge.judged.needs_repair(judge.action) else {}
    cause = next((dict(change) for change, repaired in held.items() if repaired), None)
    choice = {"off": "lucky"}.get(judge.judged.choice, judge.judged.choice)
    offered = (cause,) if cause and "alpha" not in cause else ()
    return Answer(
        choice, judge.judged.chosen, judge.judged.grades[judge.action], cause, offered, offered,
        bool(held) and cause is None, True,
    )  # fmt: skip


IMPOSSIBLE = {"gamma_min": 0.9999}
"""Refused, or under the paper's spacing without any effect."""


def lying(view: View) -> Answer:
    """Turns everything round, and suggests two alphas, whatever alpha there is."""
    alphas = ({"alpha": 500.0}, {"alpha": 600.0})
    if view.settings.alpha >= 500.0:
        return Answer("right", 0, None, None, (), alphas, False, False)
    said = truthful(view)
    choice, timeline = "right" if said.choice == "wrong" else "wrong", "ruined" if said.timeline == "sound" else "sound"
    exhausted = said.cause is not None
    return replace(
        said, choice=choice, timeline=timeline, cause=IMPOSSIBLE, remedies=(IMPOSSIBLE,), listed=alphas,
        exhausted=exhausted,
    )  # fmt: skip


VIEWS = range(14)


def test_who_tells_the_truth_misses_nothing():
    examined = [examine(number, 32, truthful) for number in VIEWS]
    rows = {row["name"]: row for row in rows_of(examined)}
    assert rows["choice"]["of"] == rows["timeline"]["of"] == len(VIEWS)
    assert rows["cause"]["of"] == rows["named"]["of"] > 3
    assert rows["exhausted"]["of"] > 1
    assert all(row["held"] == row["of"] for name, row in rows.items() if name != "alpha kept")
    assert [name for one in examined for name, _ in one.disagreements if name != "alpha kept"] == []


@pytest.mark.long
def test_who_lies_is_found_out_in_everything():
    examined = [examine(number, 32, lying) for number in VIEWS]
    rows = {row["name"]: row for row in rows_of(examined)}
    told = {name: (row["held"], row["of"]) for name, row in rows.items()}
    assert told["choice"] == told["timeline"] == told["cause"] == told["one alpha"] == (0, len(VIEWS))
    assert told["alpha kept"] == (0, 2 * len(VIEWS))
    # A remedy where nothing is to be repaired is counted apart.
    needed = sum(one.judged.choice != "right" or one.grade != "sound" for one in examined)
    assert told["remedy"] == (0, needed)
    # It claims that nothing helps exactly where something does.
    honest = [one for one in VIEWS if any(name == "cause" for name, _ in examine(one, 32, truthful).counts)]
    assert told["exhausted"] == (0, len(honest))
    text = table(examined, 32)
    assert text.count(" choice: ") == text.count(" timeline: ") == len(VIEWS)
    assert "MISSED" in text


def test_the_table_counts_and_gives_intervals():
    """8 of 10: Wilson's interval is .490 to .943, as any table of it says."""
    judged = judge_view(fig4(normalise="paper"))
    good = Examined(0, judged, "ruined", True, (("cause", True),), ())
    bad = Examined(7, judged, "ruined", False, (("cause", False),), (("cause", "why"),))
    rows = {row["name"]: row for row in rows_of([good] * 8 + [bad] * 2)}
    assert list(rows) == list(CRITERIA)
    assert (rows["cause"]["held"], rows["cause"]["of"], rows["cause"]["met"]) == (8, 10, False)
    assert rows["cause"]["interval"] == pytest.approx((0.490, 0.943), abs=5e-4)
    assert (rows["named"]["of"], rows["named"]["share"], rows["named"]["met"]) == (0, None, True)
    text = table([good] * 8 + [bad] * 2, 5)
    assert "10 random views, seed 5" in text
    assert "10 choose wrongly" in text
    assert "in 2 no setting was tried" in text
    assert "0.8000 (0.490-0.943)" in text
    assert text.endswith("     7 cause: why\n     7 cause: why")


@pytest.mark.parametrize(
    "option", [("--cases", "0"), ("--seed", "-1"), ("--jobs", "0"), ("--only", "x"), ("--cases", "2.5")]
)
def test_bad_options_are_one_line(option, capsys):
    assert main(["report", "verdicts", *option]) == 2
    error = capsys.readouterr().err
    assert option[0].removeprefix("--") in error
    assert error.count("\n") == 1
