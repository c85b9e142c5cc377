"""How ``auto`` is fitted: the networks, the sums, and the shares that the report prints."""

from __future__ import annotations

import json

import numpy as np
import pytest

from laplace_core.cli import main
from laplace_core.experiments.inverse import auto_fit
from laplace_core.experiments.inverse.auto_fit import (
    Example,
    as_file,
    examples_of,
    fitted_network,
    fitted_sum,
    near,
    report,
)
from laplace_core.inverse import LINEAR
from laplace_core.inverse.auto import COEFFICIENTS, FEATURES, network_of, summed

ALPHAS = np.geomspace(1e-6, 100.0, 56)


def planted(count: int, rng: np.random.Generator) -> list[Example]:
    """Examples whose best log alpha is -2 + 1.5 x + sin(2 y) of two features; the distance grows by 1 a factor of e."""
    examples = []
    for world in range(count):
        features = rng.normal(size=len(FEATURES))
        best = -2.0 + 1.5 * features[1] + np.sin(2.0 * features[2])
        examples.append(Example(world, "tikhonov", "weighted", features, ALPHAS, 1.0 + np.abs(np.log(ALPHAS) - best)))
    return examples


def test_a_network_learns_a_planted_rule_and_a_constant_does_not(monkeypatch):
    monkeypatch.setattr(auto_fit, "EPOCHS", 60)
    rng = np.random.default_rng(0)
    seen, unseen = planted(1500, rng), planted(300, rng)
    network = fitted_network(seen)
    chosen = network.log_alpha(np.array([each.features for each in unseen]))
    assert near(unseen, chosen) > 0.6  # within .3 of the best log alpha, which varies by 1.7
    assert near(unseen, np.full(300, -2.0)) < 0.3


def test_a_sum_finds_weights_that_are_all_there_is():
    """Good alphas lie within .2 of a linear function of the first features, so that the fit must be near it."""
    rng = np.random.default_rng(1)
    network = fitted_network(planted(8, rng))
    weights = rng.normal(size=9) / 3.0
    examples = []
    for world in range(200):
        features = np.append(1.0, rng.normal(size=len(FEATURES) - 1))
        best = float(summed(features, network) @ weights)
        examples.append(Example(world, "feasible", "equal", features, ALPHAS, 1.0 + np.abs(np.log(ALPHAS) - best)))
    found = summed(np.array([each.features for each in examples]), network) @ fitted_sum(examples, network)
    wanted = np.array([summed(each.features, network) @ weights for each in examples])
    assert np.abs(found - wanted).max() < 0.4


def test_near_counts_ratios_of_at_most_1_3():
    """Distances 1, 2, 3 at alphas e^0, e^1, e^2, between them linear in the logarithm: 2^.37 = 1.292, 2^.39 = 1.310."""
    alphas, distances = np.exp(np.arange(3.0)), np.array([1.0, 2.0, 3.0])
    examples = [Example(0, "tikhonov", "equal", np.zeros(len(FEATURES)), alphas, distances)] * 4
    assert near(examples, np.array([0.0, np.log(1.0), 0.37, 0.39])) == 0.75


@pytest.fixture(scope="module")
def fitted():
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(auto_fit, "EPOCHS", 3)
        patch.setattr(auto_fit, "PROBLEMS", 1)
        patch.setattr(auto_fit, "SLOW_WORLDS", 2)
        patch.setattr(auto_fit, "FEW_ALPHAS", np.geomspace(1e-2, 10.0, 3))
        patch.setattr(auto_fit, "SOME_ALPHAS", np.geomspace(1e-2, 10.0, 3))
        told: list[tuple[int, int]] = []
        numbers, text = report(2, 1, lambda done, of: told.append((done, of)))
    return numbers, text, told


def test_the_report_has_a_line_for_each_solver_and_a_file_that_can_be_read(fitted):
    numbers, text, told = fitted
    assert told == [(1, 2), (2, 2)]
    held = json.loads(as_file(numbers))
    assert list(held["networks"]) == [*LINEAR, "nonnegative"]
    assert list(held["coefficients"]) == list(auto_fit.SLOW)
    for sets in held["networks"].values():
        for weighting in auto_fit.WEIGHTINGS:
            assert np.isfinite(network_of(sets[weighting]).log_alpha(np.zeros(len(FEATURES))))
    assert all(len(sets["equal"]) == 9 for sets in held["coefficients"].values())
    assert [line.split()[0] for line in text.splitlines()[2:]] == [*LINEAR, "nonnegative", *auto_fit.SLOW]
    assert all(0.0 <= share <= 1.0 for sets in numbers["near"].values() for share in sets.values())


def test_examples_have_the_distance_of_every_alpha(monkeypatch):
    monkeypatch.setattr(auto_fit, "PROBLEMS", 1)
    monkeypatch.setattr(auto_fit, "SLOW_WORLDS", 0)
    examples = examples_of(3)
    assert [(each.weighting, each.solver) for each in examples] == [
        (weighting, solver) for weighting in auto_fit.WEIGHTINGS for solver in (*LINEAR, "nonnegative")
    ]
    for each in examples:
        assert each.distances.shape == each.alphas.shape
        assert each.distances.min() > 0.0
        assert each.features.shape == (len(FEATURES),)


def test_some_solvers_are_fitted_and_the_others_stay_as_they_are(fitted, monkeypatch):
    monkeypatch.setattr(auto_fit, "EPOCHS", 3)
    monkeypatch.setattr(auto_fit, "PROBLEMS", 1)
    monkeypatch.setattr(auto_fit, "SOME_ALPHAS", np.geomspace(1e-2, 10.0, 3))
    whole = json.loads(as_file(fitted[0]))
    shipped = json.loads(COEFFICIENTS.read_text())
    numbers, text = report(2, 1, solvers=("nonnegative",))
    held = json.loads(as_file(numbers))
    assert held["networks"].pop("nonnegative") == whole["networks"]["nonnegative"], "the same examples and the same fit"
    assert held["networks"] == {name: sets for name, sets in shipped["networks"].items() if name != "nonnegative"}
    assert held["coefficients"] == {"feasible": shipped["coefficients"]["feasible"]}
    assert held["commands"]["nonnegative"].endswith("--worlds 2 --solvers nonnegative")
    assert held["commands"]["tikhonov"] == shipped["commands"]["tikhonov"]
    assert [line.split()[0] for line in text.splitlines()[2:]] == ["nonnegative"]


@pytest.mark.parametrize(
    ("names", "words"),
    [("tikonov", "solver 'tikonov' is not one of tikhonov"), ("feasible", "name tikhonov as well"), ("", "solver ''")],
)
def test_solvers_that_cannot_be_fitted_are_refused(names, words, capsys):
    assert main(["report", "auto", "--worlds", "2", "--solvers", names]) == 2
    assert words in capsys.readouterr().err
