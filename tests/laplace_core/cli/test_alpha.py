"""``--alpha`` by name, other solvers, weights and filters on the command line, and the verb ``sweep``."""

import json
import shlex

import numpy as np
import pytest

from laplace_core.cli import main
from laplace_core.inverse import LINEAR, SELECTORS
from tests.laplace_core.cli.test_verbs import arrays_of, printed, strict_json
from tests.support.hostile import assert_nothing_written, assert_refused

NOISY = "two_branch --noise 1e-3 --thetas 30"


@pytest.mark.parametrize("name", ["auto", *SELECTORS])
def test_alpha_by_name(capsys, tmp_path, name):
    out = tmp_path / "out.npz"
    printed(capsys, f"decode {NOISY} --alpha {name} --noise-level 1e-3 --out {out}")
    arrays = arrays_of(out)
    record, settings = strict_json(str(arrays["alpha_record"])), strict_json(str(arrays["settings"]))
    assert record["rule"] == name
    assert record["value"] == float(arrays["alpha"]) == settings["alpha"]
    assert settings["selector"] == name
    assert f"--alpha {name}" in settings["command"]
    # The command that the file holds makes the same file.
    again = tmp_path / "again.npz"
    assert main([*shlex.split(settings["command"])[3:], "--out", str(again)]) == 0
    np.testing.assert_array_equal(arrays_of(again)["tau_space"], arrays["tau_space"])


def test_a_typed_alpha_is_recorded_as_typed(capsys, tmp_path):
    out = tmp_path / "out.npz"
    printed(capsys, f"decode {NOISY} --alpha .3 --out {out}")
    record = strict_json(str(arrays_of(out)["alpha_record"]))
    assert (record["rule"], record["value"], record["criterion"]) == ("typed", 0.3, None)
    assert strict_json(printed(capsys, f"decode {NOISY} --alpha .3 --json"))["alpha_record"] == record


def test_the_report_says_what_is_not_the_usual(capsys):
    first = printed(capsys, f"decode {NOISY} --alpha gcv --solver tikhonov1 --filter savgol").splitlines()[0]
    for words in (" by gcv", "solver tikhonov1", "discounts weighed by their deviation", "filter savgol"):
        assert words in first
    assert "alpha 0.3, 3 steps, normalise none" in printed(capsys, f"decode {NOISY} --alpha .3")


@pytest.mark.parametrize("solver", LINEAR)
def test_every_solver_reads_values(capsys, solver):
    found = strict_json(printed(capsys, f"decode two_branch --solver {solver} --alpha 1e-3 --json"))
    # Three steps through 15 discounts: hardly smoothed, each solver finds the true values 5 and 9.801.
    values = np.array(found["horizon_values"])[:, -1]
    if solver != "dsvd":  # which takes the share alpha / (s + alpha) even of strong components
        np.testing.assert_allclose(values, [5.0, 9.801], atol=0.02)
    assert found["settings"]["solver"] == solver


def test_a_saved_gamma_space_is_decoded_by_name(capsys, tmp_path):
    saved = tmp_path / "saved.npz"
    printed(capsys, f"decode {NOISY} --out {saved}")
    found = strict_json(printed(capsys, f"decode {saved} --alpha auto --solver tikhonov2 --steps 3 --json"))
    assert found["alpha_record"]["solver"] == "tikhonov2"


def test_options_that_do_not_fit_are_refused(capsys, tmp_path, subtests):
    for words, named in [
        ("--alpha discrepancy", "give --noise-level"),
        ("--alpha ncp --gammas 3", "at least 4 discounts"),
        ("--alpha best", "alpha must be a number from 0 to 1e+06, not 'best'"),
        ("--alpha GCV", "not 'GCV'"),
        ("--alpha gcv --selector aic", "--alpha gcv and --selector aic differ"),
        ("--alpha .1 --selector aic", "--alpha 0.1 changes nothing beside --selector aic"),
        ("--selector best", "selector must be one of typed, auto, gcv"),
        ("--solver ridge", "solver must be one of tikhonov, tikhonov1"),
        ("--noise-level 0", "noise_level must be a number from 1e-12 to 1"),
        ("--noise-level .1 --weighting equal", "--noise-level changes nothing beside --weighting equal"),
        ("--weighting some", "weighting must be one of equal, deviation"),
        ("--filter mean", "filter must be one of none, savgol"),
        ("--filter-window 5", "change nothing without --filter savgol"),
        ("--filter savgol --filter-window 4", "--filter-window is 4; it must be an odd number of at most 15"),
        ("--filter savgol --filter-window 3 --filter-order 3", "--filter-order is 3; it must be from 0 to 2"),
    ]:
        with subtests.test(words=words):
            assert_nothing_written(capsys, ["decode", "two_branch", *words.split()], tmp_path, named)
            if "equal" not in words:  # a sweep shows discrepancy, which a noise level is for
                assert_refused(capsys, ["sweep", "two_branch", *words.split()], named)
    assert_refused(capsys, ["sweep", "two_branch", "--points", "1"], "points must be a whole number from 2 to 1000")


def test_the_same_word_twice_is_no_conflict(capsys):
    assert printed(capsys, f"decode {NOISY} --alpha gcv --selector gcv") == printed(
        capsys, f"decode {NOISY} --alpha gcv"
    )


# --- sweep ---


def test_sweep_prints_a_table(capsys):
    lines = printed(capsys, f"sweep {NOISY} --points 7 --noise-level 1e-3").splitlines()
    head = lines[1].split()
    assert head[:4] == ["alpha", "residual", "size", "dof"]
    assert head[4:-4] == list(SELECTORS)
    assert " ".join(head[-4:]) == "W1 error of V"
    rows = [line.split() for line in lines[2:9]]
    assert all(len(row) == 4 + len(SELECTORS) + 2 for row in rows)
    alphas = [float(row[0]) for row in rows]
    assert alphas == sorted(alphas)
    said = {line.split()[0] for line in lines[9:]}
    assert said == {"auto", "least", *SELECTORS} - {lines[9].split()[-1]}


def test_sweep_as_json_holds_every_curve(capsys):
    found = strict_json(printed(capsys, f"sweep {NOISY} --json"))
    assert len(found["alpha"]) == 200
    for name in ("residual_norm", "solution_norm", "degrees_of_freedom", "w1", "value_error"):
        assert len(found[name]) == 200
    assert set(found["curves"]) == set(found["chosen"]) == set(SELECTORS) - {"discrepancy"}
    for rule, value in found["chosen"].items():
        decoded = strict_json(printed(capsys, f"decode {NOISY} --alpha {rule} --json"))
        assert decoded["settings"]["alpha"] == value


def test_a_sweep_of_ones_own_values_knows_no_truth(capsys, tmp_path):
    saved = tmp_path / "saved.npz"
    printed(capsys, f"decode {NOISY} --out {saved}")
    found = strict_json(printed(capsys, f"sweep {saved} --steps 3 --points 5 --json"))
    assert len(found["alpha"]) == 5
    assert "w1" not in found
    assert "W1" not in printed(capsys, f"sweep {saved} --steps 3 --points 5")


def test_truncation_has_a_row_for_each_number_of_components(capsys):
    found = json.loads(printed(capsys, "sweep two_branch --solver tsvd --json"))
    np.testing.assert_allclose(found["degrees_of_freedom"], [3, 2, 1], atol=1e-9)
