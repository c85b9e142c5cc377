"""What the lens is sent of a study, and that what it shows of it is what the study shows."""

from __future__ import annotations

import json
import struct
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from laplace_core import PRESETS as WORLDS
from laplace_core import Settings, load_world, study, study_of_gamma_space
from laplace_core.code.encoding import PAPER_GAMMAS, reward_distance, softening
from laplace_core.inverse import decode_matrix, transform_matrix
from laplace_core.payloads.lens import Simulated, payload, structure
from laplace_core.payloads.packing import pack
from laplace_core.payloads.state import state_of
from tests.support.lens_reference import seen, unpacked

FULL = {"gammas": 100, "thetas": 250, "steps": 200}


def made(name="two_decisions", **values):
    world = load_world(name)
    settings = study(world, Settings(world=name, **values)).settings
    return study(world, settings), study(world, structure(settings, world))


@pytest.mark.parametrize("name", WORLDS)
def test_a_payload_is_small(name):
    _, plain = made(name, **FULL)
    assert len(payload(plain)[0]) <= 200_000


def test_a_payload_holds_what_the_library_holds():
    found, plain = made(gammas=20)
    header, arrays = unpacked(payload(plain)[0])
    assert header["actions"] == list(found.action_names)
    np.testing.assert_array_equal(arrays["thetas"], found.gamma_space.thetas)
    F = transform_matrix(arrays["gammas"], header["steps"])
    np.testing.assert_allclose((arrays["U"] * arrays["s"]) @ arrays["V"].T, F, atol=1e-12)
    F = transform_matrix(np.array(PAPER_GAMMAS), header["steps"])
    np.testing.assert_allclose((arrays["paper_U"] * arrays["paper_s"]) @ arrays["paper_V"].T, F, atol=1e-12)
    np.testing.assert_allclose(arrays["shared"].sum(axis=-1), found.gamma_space.constant, rtol=1e-12)
    assert not np.allclose(arrays["shared"], arrays["per_gamma"])
    np.testing.assert_array_equal(arrays["optimum"], found.truth.optimum)
    assert arrays["timeline"].dtype == np.float64
    assert all(array.dtype == np.float64 for name, array in arrays.items() if name != "timeline")
    assert arrays["clipped_thetas"][0] == 0.0


@pytest.fixture
def simulated():
    """Of a gamma-space without a world, and what 50 continuations of 30 steps may have come to after action 1."""
    space = study(load_world("two_branch"), Settings(thetas=40)).gamma_space
    found = study_of_gamma_space(space, structure(Settings(world="own.npz", steps=20), None))
    rng = np.random.default_rng(0)
    tails = -np.sort(-rng.random((30, 40)), axis=1)
    lines = rng.normal(size=(5, 30))
    return found, Simulated(1, SimpleNamespace(
        count=50, tails=tails, reward=lines[0], reward_error=lines[1], survival=lines[2], survival_error=lines[3],
        chance=lines[4],
    ))  # fmt: skip


def test_what_is_simulated_goes_with_the_payload(simulated):
    plain, (data, _) = payload(simulated[0])[0], payload(*simulated)
    header, arrays = unpacked(data)
    assert header["simulated"] == {"action": 1, "count": 50}
    np.testing.assert_allclose(arrays["simulated_tails"] / 65_535, simulated[1].outcome.tails, atol=0.5001 / 65_535)
    np.testing.assert_allclose(arrays["simulated_lines"][4], simulated[1].outcome.chance, rtol=1e-6)
    assert "simulated" not in unpacked(plain)[0]


@pytest.mark.parametrize("values", [{}, {"fold": True, "horizon": 7.0}, {"normalise": "paper"}, {"alpha": 1e-4}])
def test_the_distance_is_that_of_the_rows_that_are_shown(simulated, values):
    data = payload(*simulated)[0]
    state = state_of(simulated[0].settings, 20.0, action=1) | values
    shown = seen(data, state)
    rows = len(shown["tau_space"][1])
    assert rows == (7 if values.get("fold") else 20)
    wanted = reward_distance(shown["tau_space"][1], simulated[1].outcome.tails[:rows], shown["thetas"])
    np.testing.assert_allclose(shown["distance"][:rows], wanted, atol=1e-3)
    assert np.isnan(shown["distance"][rows:]).all()
    assert "distance" not in seen(data, {**state, "action": 0})


def test_live_settings_share_one_payload():
    world, first = load_world("two_branch"), made("two_branch")[0].settings
    for change in ({"alpha": 3.0}, {"slope": 7.0}, {"noise": 0.1}, {"normalise": "paper"}, {"policy": "per_gamma"}):
        assert structure(replace(first, **change), world) == structure(first, world)
    assert structure(replace(first, gammas=30), world) != structure(first, world)


@pytest.mark.parametrize("values", [
    {}, {"normalise": "paper"}, {"normalise": "survival", "softness": 0.3}, {"policy": "per_gamma"},
    {"noise": 1e-3, "noise_seed": 5}, {"time_step": 0.5}, {"slope": 3.0, "alpha": 1e-5},
])  # fmt: skip
def test_what_the_lens_shows_is_what_the_study_shows(values):
    found, plain = made(**values)
    shown = seen(payload(plain)[0], state_of(found.settings, float(found.horizons[-1])))
    for name in ("tau_space", "survival", "expected_reward", "horizon_values"):
        np.testing.assert_allclose(shown[name], getattr(found.decoded, name), rtol=1e-9, atol=1e-9)
    assert shown["chosen"] == found.decoded.actions[-1]


def test_what_the_switches_do():
    found, plain = made("discounting_chain", steps=30)
    data = payload(plain)[0]
    state = state_of(found.settings, 5.0, action=1)
    whole, folded = seen(data, state), seen(data, {**state, "fold": True})
    assert folded["tau_space"].shape[1] == 5
    assert np.abs(folded["tau_space"] - whole["tau_space"][:, :5]).max() > 1e-3
    # Each discount goes through the column of D that is the next one's.
    moved, D = seen(data, {**state, "shift": True}), decode_matrix(found.gamma_space.gammas, 30, state["alpha"])
    wanted = np.einsum("kg,agh->akh", D[:, 1:], found.gamma_space.differences[:, :-1])
    np.testing.assert_allclose(moved["tau_space"], wanted, atol=1e-12)
    late = seen(data, {**state, "used": 3.0})
    assert late["read_row"] == 1
    assert seen(data, {**state, "used": 3.0, "constant": True})["read_row"] == 4
    clipped = seen(data, {**state, "clip": True})
    assert whole["tau_space"][1, 0].sum() - clipped["tau_space"][1, 0].sum() > 0.3


def test_a_gamma_space_without_a_world():
    found, _ = made("two_branch")
    own = study_of_gamma_space(found.gamma_space, structure(Settings(world="mine.npz", steps=3, alpha=0.2), None))
    data, header = payload(own)
    assert "timeline" not in header["arrays"]
    state = state_of(replace(own.settings, alpha=0.2), 3.0)
    np.testing.assert_allclose(seen(data, state)["tau_space"], found.decoded.tau_space, atol=1e-9)


def test_a_learned_basis_is_what_is_sent():
    world = load_world("two_branch")
    settings = study(world, Settings()).settings
    learned = 0.9 * np.asarray(study(world, settings).gamma_space.constant)[..., None] * np.array([0.2, 0.5, 0.3])
    found = study(world, structure(settings, world), learned=learned)
    arrays = unpacked(payload(found)[0])[1]
    np.testing.assert_array_equal(arrays["shared"], learned)
    assert "per_gamma" not in arrays
    assert "paper_shared" not in arrays


def test_a_network_s_slope_is_softened_by_a_map_over_theta():
    found, _ = made("two_branch", thetas=20)
    own = study_of_gamma_space(found.gamma_space, structure(Settings(world="mine.npz", steps=3), None))
    places = 2.5 * np.arange(20)
    data = payload(own, places=places)[0]
    state = state_of(own.settings, 3.0)
    soft, plain = seen(data, {**state, "slope_share": 0.4}), seen(data, state)
    np.testing.assert_allclose(soft["tau_space"], plain["tau_space"] @ softening(places, 0.4), atol=1e-12)
    np.testing.assert_array_equal(soft["survival"], plain["survival"])
    np.testing.assert_allclose(plain["differences"], found.gamma_space.differences, atol=1e-12)


def test_a_message_begins_on_a_multiple_of_eight():
    message = pack({"state": {"x": 1}}, b"12345678")
    (length,) = struct.unpack_from("<I", message)
    assert (4 + length) % 8 == 0
    assert json.loads(message[4 : 4 + length]) == {"state": {"x": 1}}
