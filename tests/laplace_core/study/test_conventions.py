"""Gamma-spaces of one's own: no exact or noisy one is refused, and those of another convention are, by their name."""

from __future__ import annotations

import io

import numpy as np
import pytest

from laplace_core import GammaSpace, Settings, study_of_gamma_space
from laplace_core.errors import InputError
from laplace_core.study.conventions import check_convention
from laplace_core.study.npz import read_gamma_space
from tests.support.hostile import assert_one_sentence
from tests.support.random_gamma_spaces import noisy, random_space

CDF, SCALED, AXES, LARGE, BELOW = "P(r < theta)", "times (1 - gamma)", "axes", "above 1 / (1 - gamma)", "lies below"


def refusal_of(values, constant, gammas, thetas) -> str:
    try:
        check_convention(values, constant, gammas, thetas)
    except InputError as error:
        assert_one_sentence(f"laplace: {error}")
        return str(error)
    return ""


@pytest.mark.parametrize("count", [80, pytest.param(250, marks=pytest.mark.long)])
def test_no_gamma_space_is_refused_for_being_what_it_is(count):
    refused = []
    for seed in range(count):
        rng = np.random.default_rng([3, seed])
        exact = random_space(rng)
        for noise in (0.0, 0.005, 0.02):
            space = noisy(exact, noise, rng)
            for constant in (space.constant, None):
                said = refusal_of(space.values, constant, space.gammas, space.thetas)
                if said:
                    refused.append((seed, noise, constant is None, said))
    assert refused == []


def test_a_gamma_space_that_is_handed_over_in_python_is_held_against_conventions_too():
    space = random_space(np.random.default_rng([3, 0]))
    below = space.constant[..., None] - space.values  # P(r < theta)
    study_of_gamma_space(GammaSpace(space.values, space.constant, space.gammas, space.thetas), Settings())
    with pytest.raises(InputError, match="P\\(r < theta\\)"):
        study_of_gamma_space(GammaSpace(below, space.constant, space.gammas, space.thetas), Settings())


def test_neither_a_beginning_learner_nor_impossible_actions_are_refused():
    """A table that has moved half of the way from 0; and one whose second action never happens."""
    for seed in range(60):
        rng = np.random.default_rng([4, seed])
        space = random_space(rng, (4, 8), "shared")
        for share in (0.5, 0.9, 0.97):
            assert not refusal_of(share * space.values, share * space.constant, space.gammas, space.thetas)
        values, constant = (np.concatenate([x, np.zeros_like(x)]) for x in (space.values, space.constant))
        assert not refusal_of(values, constant, space.gammas, space.thetas)
        assert not refusal_of(0.0 * values, 0.0 * constant, space.gammas, space.thetas)


def near_misses(seed: int):
    """(what is wrong, values, constant, gammas, thetas) that the same data would be in other conventions.

    Left out is what cannot be told by anybody: where hardly any reward lies between the thetas nothing rises, and where
    nothing changes from step to step (1 - gamma) Q is Q of a single step.
    """
    rng = np.random.default_rng([5, seed])
    space = noisy(random_space(rng, (6, 10), "shared"), float(rng.choice([0.0, 0.0, 0.002])), rng)
    values, constant, gammas, thetas = space.values, space.constant, space.gammas, space.thetas
    sizes = 1.0 - gammas
    q = values * sizes[:, None]
    inside = float((q[..., 0] - q[..., -1]).mean())
    if inside > 0.1:
        below = constant[..., None] - values
        yield CDF, below, constant, gammas, thetas
        yield CDF, below, None, gammas, thetas
        yield CDF, 1.0 / sizes[:, None] - values, None, gammas, thetas
        yield "reverse its last axis", values[..., ::-1], constant, gammas, thetas
        square = np.linspace(thetas[0], thetas[-1], gammas.size)
        sampled = np.stack([[np.interp(square, thetas, row) for row in action] for action in values])
        yield AXES, sampled.transpose(0, 2, 1), constant, gammas, square
        yield LARGE, 3.0 * values / sizes[:, None], None, gammas, thetas
        if ((q[..., 0] - constant * sizes**2).mean()) > 0.1:
            yield BELOW, values, constant * sizes, gammas, thetas
    if np.ptp(constant * sizes, axis=1).max() > 0.2:
        yield SCALED, q, constant * sizes, gammas, thetas
    if inside > 0.1 and np.ptp(q[..., 0], axis=1).min() > 0.2 and (np.diff(q[..., 0], axis=1) < -1e-3).all():
        yield SCALED, q, None, gammas, thetas


def test_near_misses_are_refused_by_the_name_of_their_convention():
    found, wrong = {}, []
    for seed in range(60):
        for named, *arrays in near_misses(seed):
            found[named] = found.get(named, 0) + 1
            said = refusal_of(*arrays)
            if named not in said:
                wrong.append((seed, named, said))
    assert wrong == []
    assert sum(found.values()) >= 200
    assert min(found.values()) >= 15, found


def npz(**arrays) -> bytes:
    file = io.BytesIO()
    np.savez(file, **arrays)
    return file.getvalue()


def test_shapes_tell_exchanged_axes():
    rng = np.random.default_rng(0)
    space = random_space(rng, (6, 10))
    gammas, thetas = space.gammas[:5], space.thetas[:8]
    values = np.concatenate([space.values[:, :5, :8]] * 3)[:3]
    for order, axes in (
        ((0, 2, 1), "(actions, thetas, gammas)"), ((1, 0, 2), "(gammas, actions, thetas)"),
        ((2, 1, 0), "(thetas, gammas, actions)"), ((1, 2, 0), "(gammas, thetas, actions)"),
        ((2, 0, 1), "(thetas, actions, gammas)"),
    ):  # fmt: skip
        with pytest.raises(InputError, match="axes seem to be") as refused:
            read_gamma_space(npz(gamma_space=values.transpose(order), gammas=gammas, thetas=thetas))
        assert axes in str(refused.value)
    with pytest.raises(InputError, match=r"\(thetas, gammas\)"):
        read_gamma_space(npz(gamma_space=values[0].T, gammas=gammas, thetas=thetas))


def test_descending_thetas_are_told_how_to_be_mended_and_descending_discounts_work():
    space = random_space(np.random.default_rng(1), (6, 10))
    with pytest.raises(InputError, match=r"reverse 'thetas' and the last axis of 'gamma_space'"):
        read_gamma_space(npz(gamma_space=space.values[..., ::-1], gammas=space.gammas, thetas=space.thetas[::-1]))
    found = read_gamma_space(npz(gamma_space=space.values[:, ::-1], gammas=space.gammas[::-1], thetas=space.thetas))
    np.testing.assert_array_equal(found.values, space.values[:, ::-1])


def test_rows_against_the_discounts_are_refused():
    space = random_space(np.random.default_rng(8), (6, 10), "shared")
    with pytest.raises(InputError, match="reverse order of 'gammas'"):
        read_gamma_space(npz(gamma_space=space.values[:, ::-1], gammas=space.gammas, thetas=space.thetas))
