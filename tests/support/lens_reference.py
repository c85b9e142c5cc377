"""What the lens has to draw: the library's own line, on what the browser is handed, under a state of the controls."""

from __future__ import annotations

import json
import struct
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from laplace_core import GammaSpace, Study
from laplace_core.code.encoding import reward_distance
from laplace_core.code.gamma_space import encode, softened, with_noise
from laplace_core.code.ties import greedy_action
from laplace_core.inverse.bands import reward_gain
from laplace_core.inverse.solvers import is_linear, selecting
from laplace_core.payloads.lens import LEVELS
from laplace_core.study.horizon import regret
from laplace_core.study.kernels import averaging_kernel_of, discount_kernel_of
from laplace_core.study.pipeline import decoder, read_study, rows_decoded
from laplace_core.study.settings import Resolved


def unpacked(data: bytes) -> tuple[dict[str, Any], dict[str, np.ndarray]]:
    """Header and arrays of :func:`laplace_core.payloads.lens.payload`."""
    (length,) = struct.unpack_from("<I", data)
    header, arrays = json.loads(data[4 : 4 + length]), {}
    for name, (kind, at, shape) in header["arrays"].items():
        count = int(np.prod(shape))
        arrays[name] = np.frombuffer(data, f"<{kind}", count, 4 + length + at).reshape(shape)
    return header, arrays


def seen(
    data: bytes, state: Mapping[str, Any], tau: int = 0, rounding: float = 0.0, *, solved: Resolved | None = None
) -> dict[str, np.ndarray]:
    """Arrays of a payload under a state of the controls; actions first.

    Args:
        solved: settings whose solver, weights and filter are meant; default: Tikhonov, with discounts that count alike.
        tau: the row whose averaging kernel is wanted.
        rounding: relative error to give to gamma-space, to see which numbers hold under it.
    """
    header, arrays = unpacked(data)
    space, settings = _space(header, arrays, state), _settings(header, state)
    if solved is not None:
        names = ("solver", "weighting", "filter", "filter_window", "filter_order")
        settings = replace(settings, **{name: getattr(solved, name) for name in names})
    if rounding:
        space = _shaken(space, rounding)
    study = Study(settings, tuple(header["actions"]), space, space.bin_values, read_study(space, settings))
    read, left = study.reading(study.row)
    decoded, rows = study.decoded, rows_decoded(settings, read)
    # What is drawn of the kernels of a solver that has none are those of Tikhonov.
    linear = replace(study, settings=replace(settings, solver=selecting(settings.solver)))
    found = {
        "gammas": space.gammas,
        "thetas": space.thetas,
        "theta_midpoints": space.bin_values,
        "horizons": study.horizons,
        "gamma_space": space.values,
        "constant_channel": space.constant,
        "differences": space.differences,
        "tau_space": decoded.tau_space[:, :rows],
        "survival": decoded.survival[:, :rows],
        "expected_reward": decoded.expected_reward[:, :rows],
        "horizon_values": decoded.horizon_values,
        "read_row": np.array(read),
        "chosen": greedy_action(decoded.horizon_values[:, read], scale=decoded.scale),
        "discount_kernel": discount_kernel_of(linear),
        "averaging_kernel": averaging_kernel_of(linear, tau),
    }
    if header.get("simulated", {}).get("action") == state["action"]:
        found["distance"] = _distance(arrays, found["tau_space"][state["action"]], space, settings.time_step)
    linear_rows = state["normalise"] == "none" and not state["shift"] and is_linear(settings.solver)
    if state["noise"] > 0 and linear_rows and "decoded" not in arrays:
        matrix = decoder(space.gammas, settings, rows if state["fold"] else None)
        deviations = state["noise"] / (1.0 - space.gammas)
        found["reward_noise"] = reward_gain(space) * np.sqrt(matrix**2 @ deviations**2)
    if "optimum" in arrays:
        found["regret"] = regret(arrays["optimum"][:, [left]], np.array([found["chosen"]]))[0]
    return found


def _settings(header: Mapping[str, Any], state: Mapping[str, Any]) -> Resolved:
    same = ("alpha", "horizon", "softness", "value_gamma", "noise", "noise_seed", "normalise", "fold", "used", "shift")
    return Resolved(
        world="seen.npz",
        steps=header["steps"],
        time_step=header["time_step"],
        acting_gamma=header["acting_gamma"],
        deadline="constant" if state["constant"] else "time_to_go",
        solver="tikhonov",
        selector="typed",
        weighting="equal",
        filter="none",
        filter_window=5,
        filter_order=2,
        slope_share=1.0,
        **{name: state[name] for name in same},
    )


def _space(header: Mapping[str, Any], arrays: Mapping[str, np.ndarray], state: Mapping[str, Any]) -> GammaSpace:
    """The gamma-space of all actions, with its noise."""
    prefix = "paper_" if state["paper_grid"] and "paper_gammas" in arrays else ""
    gammas, thetas = arrays[f"{prefix}gammas"], arrays["thetas"]
    if "differences" in arrays:
        tails = np.cumsum(arrays["differences"][..., ::-1], axis=-1)[..., ::-1]
        if "bin_values" in arrays:
            values = tails[..., 1:]
        else:
            last = arrays["above"] if "above" in arrays else np.zeros(tails.shape[:-1])
            values = np.concatenate([tails, np.zeros((*tails.shape[:-1], 1))], axis=-1) + last[..., None]
        space = GammaSpace(
            values, arrays["constant"], gammas, thetas, "bin_values" in arrays, arrays.get("places")
        )  # fmt: skip
        space = softened(space, state["slope_share"]) if "places" in arrays else space
    else:
        mixed = state["mixed"] and f"{prefix}per_gamma" in arrays
        if state["clip"] and "clipped_thetas" in arrays:
            thetas = arrays["clipped_thetas"]
        basis = arrays[f"{prefix}{'per_gamma' if mixed else 'shared'}"]
        space = encode(basis, arrays["rewards"], gammas, thetas, state["slope"])
    return with_noise(space, state["noise"], state["noise_seed"])


def _shaken(space: GammaSpace, rounding: float) -> GammaSpace:
    """Errors that alternate along the sensitivities; with the other sign every difference moves the other way."""
    signs = np.random.default_rng(0).choice([-rounding, rounding], size=space.constant.shape)
    values = space.values * (1.0 + signs[..., None] * (-1.0) ** np.arange(space.thetas.size))
    return replace(space, values=values, constant=space.constant * (1.0 + signs))


def _distance(arrays: Mapping[str, np.ndarray], tau_space: np.ndarray, space: GammaSpace, dt: float) -> np.ndarray:
    """W1 distance of each simulated step to the row at its time, as far as there is one; else NaN."""
    tails = arrays["simulated_tails"] / LEVELS
    rows = np.rint(np.arange(len(tails)) / dt).astype(int)
    there = (np.abs(rows * dt - np.arange(len(tails))) < 1e-9) & (rows < len(tau_space))
    found, thetas = np.full(len(tails), np.nan), space.thetas
    if space.open_ends:  # what lies beyond a sensitivity counts at it
        thetas = np.concatenate([thetas[:1], thetas, thetas[-1:]])
    found[there] = reward_distance(tau_space[rows[there]] / dt, tails[there], thetas)
    return found
