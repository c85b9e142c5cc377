"""A gamma-space checks itself when it is built, and counts its bins as its owner does."""

from __future__ import annotations

import copy
import io
import pickle

import numpy as np
import pytest

from laplace_core import GammaSpace, Settings, load_world, study, study_of_gamma_space
from laplace_core.code.encoding import softening
from laplace_core.code.interpolation import with_added
from laplace_core.errors import InputError
from laplace_core.study.compare import difference
from laplace_core.study.npz import npz_bytes, read_gamma_space
from laplace_core.study.tables import gamma_space_csv, tau_space_csv
from tests.support.hostile import assert_one_sentence

GAMMAS, THETAS = np.array([0.5, 0.9]), np.array([-1.0, 0.0, 2.0])
# One step at a time: 4 happen at gamma .9; of 2 at gamma .5 one pays below -1, .5 in (-1, 0), .25 in (0, 2), .25 above.
VALUES, CONSTANT = np.array([[[1.0, 0.5, 0.25], [3.0, 2.0, 0.5]]]), np.array([[2.0, 4.0]])


def space(**changes) -> GammaSpace:
    arrays = {"values": VALUES, "constant": CONSTANT, "gammas": GAMMAS, "thetas": THETAS}
    return GammaSpace(**(arrays | changes))


def test_bins_of_closed_and_of_open_ends_by_hand():
    closed, opened = space(), space(open_ends=True)
    np.testing.assert_array_equal(closed.differences, [[[0.5, 0.25], [1.0, 1.5]]])
    np.testing.assert_array_equal(closed.bin_values, [-0.5, 1.0])
    np.testing.assert_array_equal(closed.bin_edges, THETAS)
    np.testing.assert_array_equal(opened.differences, [[[1.0, 0.5, 0.25, 0.25], [1.0, 1.0, 1.5, 0.5]]])
    np.testing.assert_array_equal(opened.bin_values, [-1.0, -0.5, 1.0, 2.0])
    np.testing.assert_array_equal(opened.bin_edges, [-2.0, -1.0, 0.0, 2.0, 4.0])
    np.testing.assert_array_equal(opened.differences.sum(axis=-1), CONSTANT)  # every step is in some bin


def test_what_no_gamma_space_holds_is_refused_when_it_is_built(subtests):
    for changes, named in [
        ({"values": VALUES[0]}, "'gamma_space'"),
        ({"values": VALUES[..., :2]}, "'gamma_space'"),
        ({"values": np.where(VALUES == 2.0, np.nan, VALUES)}, "'gamma_space'"),
        ({"values": np.where(VALUES == 2.0, np.inf, VALUES)}, "'gamma_space'"),
        ({"values": VALUES + 1j}, "'gamma_space'"),
        ({"values": [["a"]]}, "'gamma_space'"),
        ({"values": [[1.0], [1.0, 2.0]]}, "'gamma_space'"),
        ({"values": np.zeros((0, 2, 3)), "constant": np.zeros((0, 2))}, "'gamma_space'"),
        ({"constant": CONSTANT[0]}, "'constant_channel'"),
        ({"constant": CONSTANT * np.nan}, "'constant_channel'"),
        ({"gammas": [0.5, 0.5]}, "'gammas'"),
        ({"gammas": [0.0, 0.5]}, "'gammas'"),
        ({"gammas": [0.5, 1.0]}, "'gammas'"),
        ({"gammas": [0.5, np.nan]}, "'gammas'"),
        ({"gammas": [[0.5, 0.9]]}, "'gammas'"),
        ({"gammas": None}, "'gammas'"),
        ({"thetas": [2.0, 0.0, -1.0]}, "reverse 'thetas'"),
        ({"thetas": [0.0, 0.0, 1.0]}, "'thetas'"),
        ({"thetas": [0.0, np.inf, 1.0]}, "'thetas'"),
        ({"thetas": [0.0]}, "'thetas'"),
    ]:
        with subtests.test(named, changes=changes):
            with pytest.raises(InputError) as refused:
                space(**changes)
            assert_one_sentence(f"laplace: {refused.value}", named)


@pytest.mark.parametrize("open_ends", [False, True])
def test_it_is_pickled_and_copied_whole(open_ends):
    first = space(open_ends=open_ends)
    for again in (pickle.loads(pickle.dumps(first)), copy.deepcopy(first)):  # noqa: S301 - our own bytes
        np.testing.assert_array_equal(again.differences, first.differences)
        np.testing.assert_array_equal(again.bin_values, first.bin_values)


def test_lists_and_single_floats_become_doubles():
    found = space(values=VALUES.tolist(), gammas=GAMMAS.tolist(), constant=CONSTANT.astype(np.float32))
    assert {x.dtype for x in (found.values, found.constant, found.gammas, found.thetas)} == {np.dtype(float)}


def test_open_ends_come_back_from_a_file_and_count_in_values():
    """At alpha -> 0 the values at any discount are the differences times what each bin counts as."""
    first = study_of_gamma_space(
        space(open_ends=True), Settings(world="own.npz", steps=400, acting_gamma=0.9, alpha=1e-6)
    )
    again = read_gamma_space(npz_bytes(first))
    assert again.open_ends
    np.testing.assert_array_equal(again.differences, first.gamma_space.differences)
    # 1 * -1 + 1 * -.5 + 1.5 * 1 + .5 * 2 = 1
    assert first.decoded.horizon_values[0, -1] == pytest.approx(1.0, abs=1e-4)
    closed = study_of_gamma_space(space(), first.settings)
    assert closed.decoded.horizon_values[0, -1] == pytest.approx(1.0, abs=1e-4)  # -.5 + 1.5, by chance as much
    assert first.decoded.horizon_values[0, 0] != pytest.approx(closed.decoded.horizon_values[0, 0], abs=1e-3)
    with pytest.raises(InputError, match="'open_ends' must be 1 or 0"):
        read_gamma_space(_with(npz_bytes(first), open_ends=np.array(2.0)))
    with pytest.raises(InputError, match="'open_ends' needs a 'constant_channel'"):
        read_gamma_space(_with(npz_bytes(first), constant_channel=None))


def _with(content: bytes, **changes) -> bytes:
    with np.load(io.BytesIO(content)) as file:
        arrays = {name: file[name] for name in file.files} | changes
    out = io.BytesIO()
    np.savez(out, **{name: array for name, array in arrays.items() if array is not None})
    return out.getvalue()


def test_a_world_writes_and_shows_no_open_ends():
    found = study(load_world("two_branch"), Settings(thetas=10))
    assert not found.gamma_space.open_ends
    assert not read_gamma_space(npz_bytes(found)).open_ends
    assert found.midpoints.shape == (9,)


def test_tables_name_the_open_ends():
    found = study_of_gamma_space(space(open_ends=True), Settings(world="own.npz", steps=2))
    rows = [line.split(",") for line in tau_space_csv(found).splitlines()[1:5]]
    assert [(float(low), float(high)) for _, _, low, high, _ in rows] == [
        (-np.inf, -1.0), (-1.0, 0.0), (0.0, 2.0), (2.0, np.inf)
    ]  # fmt: skip
    assert "action 0,0.5,-inf,2.0" in gamma_space_csv(found).splitlines()


def test_comparing_open_with_closed_ends_loses_nothing_inside():
    opened = study_of_gamma_space(space(open_ends=True), Settings(world="own.npz", steps=3))
    closed = study_of_gamma_space(space(), opened.settings)
    there = difference(opened, closed, 0, 0)
    np.testing.assert_allclose(there.a, opened.decoded.tau_space[0][:, 1:-1])
    back = difference(closed, opened, 0, 0)
    np.testing.assert_allclose(back.a[:, 1:-1], closed.decoded.tau_space[0])
    assert not back.a[:, [0, -1]].any()


def test_interpolation_keeps_open_ends():
    found = with_added(space(open_ends=True), 1)
    assert found.open_ends
    np.testing.assert_array_equal(found.differences[:, ::2], space(open_ends=True).differences)


@pytest.mark.parametrize("share", [0.1, 0.5, 0.9, 1.0])
def test_softening_loses_nothing_over_open_ends(share):
    places = 2.5 * np.arange(12.0)
    found = softening(places, share, open_ends=True)
    assert found.shape == (13, 13)
    np.testing.assert_allclose(found.sum(axis=1), 1.0)
    # Inside, it is the same map as without them: what left over an edge now lies in the outermost bin.
    np.testing.assert_allclose(found[1:-1, 1:-1], softening(places, share))
    if share == 1.0:
        np.testing.assert_array_equal(found, np.eye(13))


@pytest.mark.parametrize("share", [0.3, 0.6])
def test_a_softened_reward_is_that_of_the_softer_network_with_open_ends(share):
    """Against the sigmoid itself, inside and at the edges: the blurring is off by some hundredths."""
    places = 2.5 * np.arange(20.0)

    def masses(reward, slope):
        tails = np.concatenate([[1.0], 1.0 / (1.0 + np.exp(-slope * (reward - places))), [0.0]])
        return -np.diff(tails)

    for reward in (places[0], places[3] + 1.0, places[10], places[-1]):
        off = masses(reward, 1.0) @ softening(places, share, open_ends=True) - masses(reward, share)
        assert np.abs(np.cumsum(off)).max() < 0.05
