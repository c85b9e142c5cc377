"""The neural inverse: inputs and rows by hand, feasible timelines, files from anybody, and the networks that ship."""

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from laplace_core import InputError
from laplace_core.code.encoding import discount_grid
from laplace_core.files.tensor_file import read_tensors, write_tensors
from laplace_core.inverse import decode
from laplace_core.inverse.distances import mean_time_distance
from laplace_core.inverse.neural import (
    ASSUMED_NOISE,
    NOISE_RANGE,
    SHIPPED,
    NeuralInverse,
    inputs_of,
    noise_of,
    onto_rows,
    read_network,
    save_network,
    scaled_factors,
    shapes,
    shipped_network,
    solve,
)
from laplace_core.inverse.problem import Problem
from laplace_core.inverse.timelines import draw_timelines

GAMMAS = discount_grid(5, "log", 0.2, 0.9)


def random_network(seed: int = 0, gammas: np.ndarray = GAMMAS, steps: int = 12) -> NeuralInverse:
    rng = np.random.default_rng(seed)
    weights = {
        name: (rng.normal(size=shape) / np.sqrt(shape[-1])).astype(np.float32).astype(float)
        for name, shape in shapes(len(gammas), steps).items()
    }
    return NeuralInverse(gammas, steps, weights, {"seed": seed})


# --- rows ---


def test_the_nearest_row_by_hand():
    rows = np.array([[0.5, 0.2, -0.3], [0.9, 0.5, 0.0], [0.1, 0.1, 0.1], [1.0, 2.0, 3.0]])
    # (.5, .2) lack .3 of 1, shared evenly, and -.3 + .15 stays below 0; .4 too much is taken from two; .9 is lacking.
    found = onto_rows(rows, np.array([1.0, 1.0, 1.2, 0.0]))
    np.testing.assert_allclose(found, [[0.65, 0.35, 0], [0.7, 0.3, 0], [0.4, 0.4, 0.4], [0, 0, 0]], atol=1e-15)


@given(st.integers(0, 10_000))
def test_rows_are_the_nearest_of_all(seed):
    """Feasible, and no step towards another feasible row leads nearer: (x - p) (q - p) <= 0 for every corner q."""
    rng = np.random.default_rng(seed)
    rows, sums = rng.normal(size=(4, 6)), rng.uniform(size=4)
    found = onto_rows(rows, sums)
    assert found.min() >= 0.0
    np.testing.assert_allclose(found.sum(axis=-1), sums, atol=1e-12)
    for row, p, total in zip(rows, found, sums, strict=True):
        assert np.max((total * np.eye(6) - p) @ (row - p)) <= 1e-12


# --- inputs ---


def test_inputs_are_those_of_a_bin_whatever_its_size():
    masses = draw_timelines(np.random.default_rng(1), 3, 12, 4).transformed(GAMMAS)
    one, twice = (inputs_of(size * masses, GAMMAS, 12, size * 1e-3) for size in (1.0, 0.5))
    np.testing.assert_allclose(one.bins[..., :-1], twice.bins[..., :-1], rtol=1e-9)  # all but the size itself
    np.testing.assert_allclose(one.linear, twice.linear, rtol=1e-9)
    np.testing.assert_allclose(one.scale, 2.0 * twice.scale)


def test_without_noise_the_linear_part_has_the_values():
    masses = draw_timelines(np.random.default_rng(1), 3, 12, 4).transformed(GAMMAS)
    seen = inputs_of(masses, GAMMAS, 12, 1e-12)
    _, _, Vt = scaled_factors(GAMMAS.tobytes(), 12)
    timeline = np.swapaxes(seen.scale * (seen.linear @ Vt), -1, -2)
    np.testing.assert_allclose(GAMMAS[:, None] ** np.arange(12) @ timeline, masses, atol=1e-9)


def test_noise_is_that_of_the_problem():
    problem = Problem(np.zeros((5, 3)), GAMMAS, 12)
    assert noise_of(problem) == ASSUMED_NOISE
    for noise, expected in [(0.01, 0.01), (1e-12, NOISE_RANGE[0]), (1.0, NOISE_RANGE[1])]:
        assert noise_of(replace(problem, deviations=noise / (1.0 - GAMMAS))) == pytest.approx(expected)


# --- solving ---


@given(st.integers(0, 10_000))
def test_every_timeline_is_feasible_whatever_the_weights_and_the_masses(seed):
    rng = np.random.default_rng(seed)
    problem = Problem(rng.normal(size=(2, 5, 4)) * 10.0 ** rng.uniform(-6, 6), GAMMAS, 9)
    solution = random_network(seed % 7).solve(problem)
    assert solution.masses.shape == (2, 9, 4)
    assert solution.masses.min() >= 0.0
    np.testing.assert_allclose(solution.survival[:, 0], 1.0)
    assert np.diff(solution.survival, axis=-1).max() <= 1e-12
    np.testing.assert_allclose(problem.transform @ solution.masses + solution.residual, problem.masses)
    assert solution.active is not None
    np.testing.assert_array_equal(solution.active, solution.masses == 0.0)
    assert np.isnan(solution.degrees_of_freedom).all()


def test_bins_may_change_places():
    rng = np.random.default_rng(0)
    masses, order = rng.uniform(size=(1, 5, 4)), [2, 0, 3, 1]
    network = random_network()
    there = network.solve(Problem(masses[..., order], GAMMAS, 12)).masses
    np.testing.assert_allclose(there, network.solve(Problem(masses, GAMMAS, 12)).masses[..., order], atol=1e-12)


def test_problems_of_another_kind_are_refused(subtests):
    network, masses = random_network(), np.zeros((1, 5, 4))
    for problem, named in [
        (Problem(masses, GAMMAS * 0.99, 12), "train-inverse"),
        (Problem(masses[:, :4], GAMMAS[:4], 12), "train-inverse"),
        (Problem(masses, GAMMAS, 13), "12 rows and not 13"),
        (Problem(masses, GAMMAS, 12, time_step=0.5), "time-step"),
        (Problem(masses, GAMMAS, 12, starts_alive=False), "terminal"),
    ]:
        with subtests.test(named=named), pytest.raises(InputError, match=named):
            network.solve(problem)


# --- files ---


def test_a_file_gives_back_its_network(tmp_path):
    network = random_network()
    save_network(network, tmp_path / "a.safetensors")
    found = read_network(tmp_path / "a.safetensors")
    assert found.about == network.about
    problem = Problem(np.random.default_rng(1).uniform(size=(1, 5, 3)), GAMMAS, 12)
    np.testing.assert_array_equal(found.solve(problem).masses, network.solve(problem).masses)


def test_spoiled_files_are_refused_in_one_sentence(subtests, tmp_path):
    save_network(random_network(), tmp_path / "good.safetensors")
    arrays, about = read_tensors(tmp_path / "good.safetensors", 10**7)
    path = tmp_path / "bad.safetensors"
    first = "bins.0.weight"

    def changed(name: str, change) -> dict:
        return arrays | {name: change(arrays[name].copy())}

    def spoiled(array: np.ndarray, value: float) -> np.ndarray:
        array.flat[3] = value
        return array

    for what, some, entries, named in [
        ("kind", arrays, about | {"kind": "other"}, "train-inverse"),
        ("version", arrays, about | {"version": 2}, "train-inverse"),
        ("hidden", arrays, about | {"hidden": 10**9}, "metadata"),
        ("more", arrays, about | {"more": 1}, "metadata"),
        ("steps of text", arrays, about | {"steps": "12"}, "'steps'"),
        ("many steps", arrays, about | {"steps": 10**9}, "'steps'"),
        ("other steps", arrays, about | {"steps": 13}, "bins.2.weight"),
        ("trained", arrays, about | {"trained": {"seed": "x"}}, "'trained'"),
        ("no gammas", {k: v for k, v in arrays.items() if k != "gammas"}, about, "'gammas'"),
        ("falling gammas", changed("gammas", lambda g: g[::-1].copy()), about, "increasing"),
        ("gammas above 1", changed("gammas", lambda g: g + 0.5), about, "increasing"),
        ("nan in gammas", changed("gammas", lambda g: spoiled(g, np.nan)), about, "increasing"),
        ("float32 gammas", changed("gammas", lambda g: g.astype(np.float32)), about, "'gammas'"),
        ("one more", arrays | {"x": np.zeros(1, np.float32)}, about, "other tensors"),
        ("one less", {k: v for k, v in arrays.items() if k != first}, about, "other tensors"),
        ("turned", changed(first, lambda w: w.T.copy()), about, first),
        ("float64", changed(first, lambda w: w.astype(float)), about, first),
        ("nan", changed(first, lambda w: spoiled(w, np.nan)), about, "too large"),
        ("huge", changed(first, lambda w: spoiled(w, 1e30)), about, "too large"),
    ]:
        write_tensors(path, some, entries)
        with subtests.test(what), pytest.raises(InputError, match=named) as refusal:
            read_network(path)
        assert "\n" not in str(refusal.value)
    path.write_bytes(b"\x80\x04pickle")
    with pytest.raises(InputError, match="safetensors"):
        read_network(path)


# --- what ships ---

GRIDS = {
    "inverse-log": discount_grid(15),
    "paper": discount_grid(15, "paper"),
    "log": discount_grid(15, "log", float(np.exp(-1.0)), 0.99),
}
"""The default of worlds, the paper's, and that of the agents that ship."""


def test_a_network_ships_for_every_standard_grid():
    assert {path.stem for path in SHIPPED.glob("*.safetensors")} == set(GRIDS)
    for name, gammas in GRIDS.items():
        assert (SHIPPED / f"{name}.safetensors").stat().st_size < 1_000_000
        assert shipped_network(gammas).steps == 200
    with pytest.raises(InputError, match="train-inverse"):
        shipped_network(discount_grid(14))


def test_the_agents_have_the_grid_that_it_ships_for():
    for name in ("LunarLander-v3", "CartPole-v1", "Acrobot-v1"):
        content = (SHIPPED.parent / f"laplace_{name}.safetensors").read_bytes()
        header = json.loads(content[8 : 8 + int.from_bytes(content[:8], "little")])
        settings = json.loads(header["__metadata__"]["laplace"])["settings"]
        own = discount_grid(settings["gammas"], settings["spacing"], settings["gamma_min"], settings["gamma_max"])
        assert shipped_network(own).about["updates"] > 0


@pytest.mark.parametrize("name", GRIDS)
def test_two_rewards_in_noise_are_placed_better_than_with_any_alpha(name):
    """An episode of 8 steps that pays in bin 3 at the third and in bin 1 at the last, and in bin 0 otherwise."""
    gammas, noise = GRIDS[name], 1e-3
    truth = np.zeros((1, 200, 6))
    truth[0, :8, 0] = 1.0
    truth[0, 2], truth[0, 7] = np.eye(6)[3], np.eye(6)[1]
    # The constant channel and every tail have an error of their own; 16 times.
    errors = np.random.default_rng(0).normal(size=(16, 15, 6)) * noise / (1.0 - gammas)[:, None]
    masses = gammas[:, None] ** np.arange(200) @ truth
    masses = masses + errors - np.pad(errors[..., 1:], [(0, 0), (0, 0), (0, 1)])
    found = solve(Problem(masses, gammas, 200, deviations=noise / (1.0 - gammas))).masses
    linear = [decode(masses, gammas, 200, alpha) for alpha in np.geomspace(1e-5, 10.0, 13)]
    distances = [mean_time_distance(each, truth).mean() for each in linear]
    assert mean_time_distance(found, truth).mean() < 0.5 * min(distances)
    for column, time in ((3, 2), (1, 7)):
        times = found[..., column].mean(axis=0)
        assert times.sum() == pytest.approx(1.0, abs=0.2)
        assert times @ np.arange(200) / times.sum() == pytest.approx(time, abs=2.5)


def test_no_network_library_is_loaded_to_solve():
    source = Path(shipped_network.__code__.co_filename).read_text()
    assert "import torch" not in source
