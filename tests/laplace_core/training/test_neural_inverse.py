"""Training the neural inverse: torch and NumPy compute the same, and what is learned is nearer than what was given."""

import numpy as np
import pytest
import torch

from laplace_core import InputError
from laplace_core.code.encoding import discount_grid
from laplace_core.inverse.distances import mean_time_distance
from laplace_core.inverse.neural import NOISE_RANGE, NeuralInverse, inputs_of, onto_rows, scaled_factors
from laplace_core.inverse.timelines import draw_timelines
from laplace_core.training import neural_inverse
from laplace_core.training.neural_inverse import Progress, train

GAMMAS, STEPS = discount_grid(6, "log", 0.3, 0.9), 20


@pytest.fixture(scope="module")
def learned() -> tuple[NeuralInverse, list[Progress]]:
    seen: list[Progress] = []
    network = train(GAMMAS, STEPS, updates=120, samples=400, batch=16, report=seen.append)
    return network, seen


def test_rows_are_those_of_numpy():
    rng = np.random.default_rng(0)
    rows, sums = rng.normal(size=(3, 5, 6)), rng.uniform(size=(3, 5))
    found = neural_inverse.onto_rows(torch.from_numpy(rows), torch.from_numpy(sums))
    np.testing.assert_allclose(found.numpy(), onto_rows(rows, sums), atol=1e-12)


def test_the_loss_is_the_distance_of_what_numpy_finds(learned):
    """In float64: the distance of each bin, rows weighted by 1 / (tau + 2), of rows, free masses and survival."""
    network, _ = learned
    pool = draw_timelines(np.random.default_rng(9), 12, STEPS, 5)
    masses = pool.transformed(GAMMAS)
    seen = inputs_of(masses, GAMMAS, STEPS, 1e-3)
    weights = {name: torch.from_numpy(array) for name, array in network.weights.items()}
    Vt = scaled_factors(GAMMAS.tobytes(), STEPS)[2]
    importance = 1.0 / (np.arange(STEPS) + 2.0)
    loss = neural_inverse._loss(
        weights, [torch.from_numpy(part.copy()) for part in seen], torch.from_numpy(pool.masses),
        torch.from_numpy(Vt.copy()), importance=torch.from_numpy(importance),
    )  # fmt: skip
    rows = network.timeline(masses, 1e-3)
    free = np.swapaxes(seen.scale * (seen.linear @ Vt + network._network(seen.bins, "bins")), -1, -2)
    expected = 0.0
    for n in range(12):
        for k in range(STEPS):
            expected += importance[k] * abs(rows[n, k].sum() - pool.masses[n, k].sum()) / 12
            for b in range(5):
                expected += importance[k] * abs((rows[n, : k + 1, b] - pool.masses[n, : k + 1, b]).sum()) / 12
                expected += 0.2 * importance[k] * abs((free[n, : k + 1, b] - pool.masses[n, : k + 1, b]).sum()) / 12
    # Single precision in between: torch keeps its first row of survival in float32.
    assert float(loss) == pytest.approx(expected, rel=1e-5)


def test_what_was_learned_is_nearer_than_at_first(learned):
    network, seen = learned
    assert [each.update for each in seen] == [100, 120]
    assert seen[1].loss < seen[0].loss
    first = train(GAMMAS, STEPS, updates=1, samples=400, batch=16)
    fresh = draw_timelines(np.random.default_rng(5), 50, STEPS, 5)
    values = fresh.transformed(GAMMAS)
    before, after = (mean_time_distance(each.timeline(values, 1e-3), fresh.masses).mean() for each in (first, network))
    assert after < 0.5 * before


def test_the_same_seed_gives_the_same_network():
    first, again, other = (train(GAMMAS, STEPS, updates=3, samples=100, batch=8, seed=seed) for seed in (0, 0, 1))
    for name, array in first.weights.items():
        np.testing.assert_array_equal(again.weights[name], array)
    assert np.any(other.weights["bins.0.weight"] != first.weights["bins.0.weight"])


def test_noise_is_that_of_tails_and_of_the_size_that_is_told():
    """Neighbouring masses share an error with opposite signs: correlation -1/2; together they have the constant's."""
    values = np.zeros((4000, 3, 5))
    gammas = np.array([0.2, 0.5, 0.9])
    noisy, _, _, noise = neural_inverse._noisy(np.random.default_rng(0), values, gammas, 10)
    assert np.log(noise).min() > np.log(NOISE_RANGE[0])
    assert np.log(noise).max() < np.log(NOISE_RANGE[1])
    errors = noisy * (1.0 - gammas)[:, None] / noise[:, None, None]
    assert np.sqrt((errors[..., :-1] ** 2).mean()) == pytest.approx(np.sqrt(2.0), rel=0.02)
    assert (errors[..., 0] * errors[..., 1]).mean() == pytest.approx(-1.0, rel=0.1)
    assert np.sqrt((errors.sum(axis=-1) ** 2).mean()) == pytest.approx(1.0, rel=0.02)


def test_what_cannot_be_trained_is_refused(subtests):
    for gammas, steps, named in [
        (np.array([0.5, 1.0]), 10, "discounts"),
        (np.array([0.5]), 10, "2 to 500"),
        (np.array([0.9, 0.5]), 10, "increasing"),
        (GAMMAS, 1, "steps"),
        (GAMMAS, 501, "steps"),
    ]:
        with subtests.test(named=named), pytest.raises(InputError, match=named):
            train(gammas, steps)
