"""A study whose alpha a selector chooses, whose solver is another one, or whose discounts are weighted or filtered."""

import json
from dataclasses import replace

import numpy as np
import pytest

from laplace_core import InputError, Settings, load_world, study
from laplace_core.code.gamma_space import shifted
from laplace_core.inverse import (
    LINEAR,
    SELECTORS,
    SOLVERS,
    Solution,
    Solver,
    choose_alpha,
    decode_matrix,
    problem_of,
    solve,
    solvers,
)  # fmt: skip
from laplace_core.inverse.smoothing import filtered
from laplace_core.study.artefacts import find_artefacts
from laplace_core.study.npz import study_arrays
from laplace_core.study.pipeline import decode_and_read, rewards_of, study_of_gamma_space
from laplace_core.study.sweep import sweep_alpha, time_distance
from laplace_core.study.trials import Remedy
from laplace_core.study.verdict import judge

NOISY = Settings(world="fig6_chain", noise=1e-3, thetas=40, gammas=15)


def noisy(**changes):
    return study(load_world("fig6_chain"), replace(NOISY, **changes))


# --- the line from settings to a picture ---


@pytest.mark.parametrize("solver", LINEAR)
def test_a_study_decodes_by_the_matrix_of_its_solver(solver):
    found = noisy(solver=solver, weighting="deviation", alpha=0.3)
    space, s = found.gamma_space, found.settings
    D = decode_matrix(space.gammas, s.steps, 0.3, solver=solver, deviations=1.0 / (1.0 - space.gammas))
    np.testing.assert_allclose(found.decoded.tau_space, D @ space.differences, atol=1e-10)
    np.testing.assert_allclose(found.decoded.survival, space.constant @ D.T, atol=1e-10)
    np.testing.assert_allclose(rewards_of(space, s), found.decoded.expected_reward, atol=1e-9)


def test_settings_that_say_nothing_decode_as_before():
    found = noisy()
    D = decode_matrix(found.gamma_space.gammas, found.settings.steps, found.settings.alpha)
    np.testing.assert_array_equal(found.decoded.tau_space, D @ found.gamma_space.differences)
    assert found.alpha_record.rule == "typed"
    assert (found.alpha_record.value, found.alpha_record.alphas) == (found.settings.alpha, ())


@pytest.mark.parametrize("selector", ["auto", *SELECTORS])
def test_a_selector_decides_and_leaves_its_record(selector):
    found = noisy(selector=selector, noise_level=1e-3)
    space, s = found.gamma_space, found.settings
    deviations = 1e-3 / (1.0 - space.gammas)
    record = choose_alpha(problem_of(space, s.steps, 1.0, deviations), "tikhonov", selector, noise=deviations)
    assert found.alpha_record == record
    assert s.alpha == record.value
    typed = noisy(alpha=record.value, weighting="deviation")
    np.testing.assert_allclose(typed.decoded.tau_space, found.decoded.tau_space, atol=1e-9)


def test_a_solver_without_alpha_leaves_a_rule_nothing_to_choose():
    # The neural inverse ships for 15 discounts and 200 rows.
    typed, ruled = noisy(solver="neural", steps=60), noisy(solver="neural", steps=60, selector="auto")
    np.testing.assert_array_equal(ruled.decoded.tau_space, typed.decoded.tau_space)
    assert ruled.automatic is None


def test_selectors_weigh_the_discounts_and_a_typed_alpha_does_not():
    assert noisy().settings.weighting == "equal"
    assert noisy(alpha=0.1).settings.weighting == "equal"
    assert noisy(selector="auto").settings.weighting == "deviation"
    assert noisy(noise_level=0.01).settings.weighting == "deviation"
    assert noisy(selector="auto", weighting="equal").settings.weighting == "equal"


def test_what_a_study_says_of_itself_repeats_it():
    for changes in ({"selector": "gcv"}, {"noise_level": 0.01, "alpha": 0.2}, {"solver": "tikhonov2", "alpha": 0.5},
                    {"selector": "discrepancy", "noise_level": 1e-3, "weighting": "equal"},
                    {"filter": "savgol", "filter_window": 7}):  # fmt: skip
        found = noisy(**changes)
        names: dict = {}
        exec(found.settings.to_python(), names)
        np.testing.assert_array_equal(names["result"].decoded.tau_space, found.decoded.tau_space)
        assert names["result"].settings == found.settings
        assert ("--alpha gcv" in found.settings.to_command()) == (changes == {"selector": "gcv"})


def test_another_view_chooses_anew_and_a_remedy_types_its_alpha():
    found = noisy(selector="aic")
    louder = found.under(replace(found.settings, solver="tikhonov1"))
    assert louder.alpha_record.solver == "tikhonov1"
    assert louder.settings.alpha == louder.alpha_record.value
    mended = found.under(Remedy("", {"alpha": 0.5}).apply(found.settings))
    assert (mended.settings.alpha, mended.settings.selector) == (0.5, "typed")
    assert mended.alpha_record.rule == "typed"


def test_a_filter_comes_before_the_inverse():
    found = noisy(filter="savgol", alpha=0.2)
    space = noisy(alpha=0.2).gamma_space
    np.testing.assert_array_equal(found.gamma_space.values, space.values)  # what was learned stays as it is
    smooth = decode_and_read(filtered(space), noisy(alpha=0.2).settings)
    np.testing.assert_allclose(found.decoded.tau_space, smooth.tau_space, atol=1e-9)
    np.testing.assert_allclose(found.decoded.survival, smooth.survival, atol=1e-9)
    unfiltered = noisy(selector="gcv")
    assert noisy(selector="gcv", filter="savgol").settings.alpha == unfiltered.settings.alpha


def test_shifted_values_are_what_a_selector_sees():
    found = noisy(selector="gcv", shift=True)
    space, s = found.gamma_space, found.settings
    problem = problem_of(space, s.steps, 1.0, 1.0 / (1.0 - space.gammas))
    record = choose_alpha(replace(problem, masses=shifted(problem.masses)), "tikhonov", "gcv")
    assert s.alpha == pytest.approx(record.value)


def test_kernels_and_artefacts_are_those_of_the_solver(subtests):
    for changes in ({"solver": "tikhonov2"}, {"weighting": "deviation"}, {"filter": "savgol"}, {"selector": "bic"}):
        with subtests.test(changes=changes):
            found = noisy(**changes)
            arrays = study_arrays(found)
            # What V_T really weighs each step with: of the true timeline it makes the decoded V_T.
            quiet = study(
                load_world("fig6_chain"),
                replace(found.settings.chosen(), noise=0.0, alpha=found.settings.alpha, selector="typed"),
            )
            weighed = quiet.truth.expected_reward @ arrays["discount_kernel"]
            np.testing.assert_allclose(weighed, quiet.decoded.horizon_values[:, -1], atol=0.02)
            listed = find_artefacts(found, 0, searching=False)
            assert "shifted index" not in {each.name for each in listed}
            assert judge(found, found.row, explain=changes == {"selector": "bic"}).sentence


def test_a_saved_study_holds_its_alpha_and_how_it_was_chosen():
    arrays = study_arrays(noisy(selector="gcv"))
    record = json.loads(str(arrays["alpha_record"]))
    assert record["rule"] == record["criterion"] == "gcv"
    assert float(arrays["alpha"]) == record["value"]
    assert len(record["curve"]) == len(record["alphas"]) == 200
    assert json.loads(str(study_arrays(noisy())["alpha_record"]))["rule"] == "typed"


def test_a_gamma_space_of_ones_own_is_decoded_by_a_selector():
    space = noisy().gamma_space
    found = study_of_gamma_space(space, Settings(world="own.npz", selector="auto", solver="tikhonov1"))
    assert found.alpha_record.solver == "tikhonov1"
    assert np.isfinite(found.decoded.tau_space).all()


def test_selectors_that_cannot_choose_are_refused(subtests):
    for changes, named in [
        ({"selector": "discrepancy"}, "give --noise-level"),
        ({"selector": "ncp", "gammas": 3}, "at least 4 discounts"),
        ({"filter": "savgol", "filter_window": 4}, "--filter-window is 4"),
        ({"filter": "savgol", "filter_window": 99}, "at most 15 discounts"),
        ({"filter": "savgol", "filter_order": 5}, "--filter-order is 5"),
    ]:
        with subtests.test(changes=changes), pytest.raises(InputError, match=named):
            noisy(**changes)


def test_a_solver_that_is_not_linear_goes_the_same_way(monkeypatch):
    def clipped(problem, alpha):
        found = solve(problem, "tikhonov", alpha)
        return Solution(np.maximum(found.masses, 0.0), found.residual, found.degrees_of_freedom)

    monkeypatch.setattr(solvers, "SOLVERS", {**SOLVERS, "clipped": Solver(clipped)})
    linear = noisy(alpha=0.2, horizon=4.0)
    settings = replace(linear.settings)
    object.__setattr__(settings, "solver", "clipped")  # the choices of a setting are fixed when it is declared
    found = linear.under(settings)
    np.testing.assert_allclose(found.decoded.tau_space, np.maximum(linear.decoded.tau_space, 0.0), atol=1e-12)
    midpoints = found.gamma_space.bin_values
    np.testing.assert_allclose(found.decoded.expected_reward, found.decoded.tau_space @ midpoints)
    np.testing.assert_allclose(rewards_of(found.gamma_space, settings), found.decoded.expected_reward)
    sentences = [each.sentence for each in find_artefacts(found, 0)]
    assert sum("Only the picture of a linear solver is a sum of parts" in each for each in sentences) == 1
    assert "discount_kernel" not in study_arrays(found)
    with pytest.raises(InputError, match="a sweep needs a linear solver, which clipped is not"):
        sweep_alpha(found)


# --- the sweep ---


def test_carrying_probability_along_time():
    # .5 of a bin carried by 3 steps: 1.5. Another bin has it a step early: .25. A mass of .1 that is not there at all
    # counts to the end of the rows: 4 of them from row 2 on, .4. With half steps everything is half as far.
    true = np.zeros((6, 3))
    decoded = np.zeros((6, 3))
    true[1, 0], decoded[4, 0] = 0.5, 0.5
    true[3, 1], decoded[2, 1] = 0.25, 0.25
    decoded[2, 2] = 0.1
    assert time_distance(decoded, true) == pytest.approx(1.5 + 0.25 + 0.4)
    assert time_distance(np.stack([decoded, true]), true, 0.5) == pytest.approx([(1.5 + 0.25 + 0.4) / 2, 0.0])


def test_a_sweep_holds_what_each_alpha_gives(subtests):
    found = sweep_alpha(noisy(selector="auto", horizon=4.0), 9)
    assert found.alphas.size == 9
    for i, alpha in enumerate(found.alphas):
        with subtests.test(alpha=alpha):
            one = noisy(alpha=float(alpha), weighting="deviation", horizon=4.0)
            assert found.time_error[i] == pytest.approx(
                time_distance(one.decoded.tau_space, one.truth.tau_space).mean()
            )
            off = np.abs(one.decoded.horizon_values - one.truth.horizon_values)[:, one.row].max()
            assert found.value_error[i] == pytest.approx(off)
    assert set(found.curves) == set(SELECTORS) - {"discrepancy"}
    plain = json.loads(json.dumps(found.as_dict(), allow_nan=False))
    assert plain["alpha"] == found.alphas.tolist()
    assert set(plain["chosen"]) == set(found.curves)


def test_what_a_sweep_chooses_is_what_decode_chooses():
    found = sweep_alpha(noisy(selector="auto"))
    chosen = found.as_dict()["chosen"]
    for rule in chosen:
        assert chosen[rule] == noisy(selector=rule).settings.alpha
