"""The benchmark measures what it says it measures; no test looks at a clock's value."""

import json
import subprocess
import sys

import numpy as np
import pytest

from bench import __main__ as command
from bench.decoding import product_loop, solve_loop
from bench.fresh import ROOT, fresh_study
from bench.growth import exponent
from bench.report import Figure, Goal, tally
from bench.solving import full_solve
from bench.timing import Spread, interleaved, spread
from laplace_core import Settings, load_world, study
from laplace_core.inverse import decode


def _figure(median: float, goal: Goal | None, name: str = "decode / product") -> Figure:
    return Figure("Decoding", name, Spread(median, median - 0.1, median + 0.1, 7), "x", "(4, 100, 499)", goal)


@pytest.fixture(scope="module")
def found():
    return study(load_world("cliff_grid"), Settings(world="cliff_grid", gammas=12, thetas=20, steps=30, alpha=0.05))


@pytest.mark.parametrize("loop", [solve_loop, product_loop])
def test_the_loops_and_the_cached_operator_agree(found, loop):
    arguments = found.gamma_space.differences, found.gamma_space.gammas, 30, 0.05
    decoded = decode(*arguments)
    assert np.abs(decoded).max() > 0.1
    np.testing.assert_allclose(loop(*arguments), decoded, rtol=0, atol=1e-9)


def test_the_uncached_solve_is_the_solve_of_the_study(found):
    solved = full_solve(found.world, found.settings)
    np.testing.assert_array_equal(solved.values, found.gamma_space.values)
    np.testing.assert_array_equal(solved.constant, found.gamma_space.constant)


def test_a_figure_says_whether_its_goal_is_met(subtests):
    for median, goal, verdict in [
        (1.02, Goal("<=", 1.3), "1.02 x, quartiles 0.920 to 1.12, n = 7   goal <= 1.3 x: met"),
        (1.3, Goal("<=", 1.3), "goal <= 1.3 x: met"),
        (1.31, Goal("<=", 1.3), "goal <= 1.3 x: NOT met"),
        (99.9, Goal(">=", 100), "goal >= 100 x: NOT met"),
        (100.0, Goal(">=", 100), "goal >= 100 x: met"),
        (3.0, Goal("<", 3), "goal < 3 x: NOT met"),
    ]:
        with subtests.test(median=median, goal=goal, verdict=verdict):
            figure = _figure(median, goal)
            assert verdict in figure.text()
            assert figure.met is ("NOT" not in verdict)
            assert "(4, 100, 499)" in figure.text()


def test_a_figure_without_a_goal_has_no_verdict():
    figure = _figure(5.0, None)
    assert "goal" not in figure.text()
    assert figure.met is None
    assert "met" not in figure.text()


def test_the_tally_counts_goals_and_names_those_not_met():
    figures = [_figure(1.0, Goal("<=", 1.3)), _figure(2.0, Goal("<=", 1.3), "late"), _figure(9.0, None, "free")]
    assert tally(figures[:1]) == "1 of 1 goals met"
    assert tally(figures) == "1 of 2 goals met; NOT met: late"


def test_figures_survive_json():
    entry = json.loads(json.dumps(_figure(2.0, Goal("<=", 1.3)).as_json()))
    assert entry["value"] == {"median": 2.0, "low": 1.9, "high": 2.1, "samples": 7}
    assert entry["goal"] == {"relation": "<=", "bound": 1.3}
    assert entry["met"] is False


def test_tasks_take_turns_and_every_second_round_runs_backwards():
    ran: list[str] = []
    seconds = interleaved({"a": (lambda: ran.append("a"), 2), "b": (lambda: ran.append("b"), 1)}, rounds=3)
    assert "".join(ran) == "ab" + "aab" + "baa" + "aab"
    assert {name: values.shape for name, values in seconds.items()} == {"a": (3,), "b": (3,)}


def test_spread_is_median_and_quartiles():
    assert spread([4.0, 0.0, 1.0, 3.0, 2.0]) == Spread(2.0, 1.0, 3.0, 5)


def test_the_exponent_of_a_power_law():
    sizes = np.array([91, 381, 1561])
    assert exponent(sizes, 1e-4 * sizes**1.5) == pytest.approx(1.5)


def test_a_fresh_process_reports_its_own_memory():
    ballast = np.ones(25_000_000)  # 200 MB that belong to this process alone
    run = fresh_study("two_branch", {}, 5, 10)
    assert run["states"] == 3
    assert 0 < run["imported_mb"] <= run["peak_mb"] < ballast.nbytes / 1e6


def test_the_command_prints_writes_and_plugs_parts_in(monkeypatch, capsys, tmp_path):
    class Part:
        main = staticmethod(lambda: iter([_figure(1.0, Goal("<=", 1.3))]))

    class OwnPrinting:
        main = staticmethod(lambda: {"open": [1.0, 2.0]})

    monkeypatch.setattr(command, "PARTS", ("core", "browser"))
    monkeypatch.setattr(command, "import_module", {"bench.core": Part, "bench.browser": OwnPrinting}.__getitem__)
    monkeypatch.setattr(command, "find_spec", lambda name: name)
    target = tmp_path / "figures.json"
    monkeypatch.setattr(sys, "argv", ["bench", "--json", str(target)])
    command.main()
    printed = capsys.readouterr().out
    assert "numpy" in printed.splitlines()[0]
    assert "goal <= 1.3 x: met" in printed
    assert printed.endswith("1 of 1 goals met\n")
    written = json.loads(target.read_text())
    assert written["figures"][0]["name"] == "decode / product"
    assert written["samples"] == {"open": [1.0, 2.0]}
    assert written["machine"]["numpy"] == np.__version__


def test_an_absent_part_is_refused(monkeypatch, capsys):
    monkeypatch.setattr(command, "find_spec", lambda name: None)
    monkeypatch.setattr(sys, "argv", ["bench", "--only", "browser"])
    with pytest.raises(SystemExit, match="2"):
        command.main()
    assert "no browser part" in capsys.readouterr().err


def test_help_runs_as_a_module():
    shown = subprocess.run([sys.executable, "-m", "bench", "--help"], cwd=ROOT, capture_output=True, text=True)
    assert shown.returncode == 0
    assert "--only" in shown.stdout
