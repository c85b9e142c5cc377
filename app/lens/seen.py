"""What the lens shows, computed by the library: for files to take along, and to hold the browser against."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from app.lens.payload import LEVELS, unpacked
from laplace_core import GammaSpace
from laplace_core.encoding import reward_distance, softening
from laplace_core.gamma_space import encode, with_noise
from laplace_core.horizon import (
    deadline_weights,
    discount_kernel,
    expected_rewards,
    readout_weights,
    regret,
    row_horizons,
    scale_of_values,
    target_discounts,
)
from laplace_core.inverse import decode, normalise_rows, resolution_matrix, rounding_of_rows
from laplace_core.ties import greedy_action


def seen(data: bytes, state: Mapping[str, Any], tau: int = 0, rounding: float = 0.0) -> dict[str, np.ndarray]:
    """Arrays of a payload under a state of the controls; actions first.

    Args:
        tau: the row whose averaging kernel is wanted.
        rounding: relative error to give to gamma-space, to see which numbers hold under it.
    """
    header, arrays = unpacked(data)
    space = _space(header, arrays, state)
    if rounding:
        space = _shaken(space, rounding)
    K, dt = header["steps"], header["time_step"]
    horizons = row_horizons(K, dt)
    left = max(0.0, state["horizon"] - state["used"])
    read_row = _row(horizons, state["horizon"] if state["constant"] else left)
    rows = read_row + 1 if state["fold"] else K
    tau_space, survival = _decoded(space, state, rows, dt)
    values = np.array(
        [
            _values(space, state, row, K, dt) if state["fold"] else _value(tau_space, space, state, row, K, dt)
            for row in range(K)
        ]
    ).T
    rewards = expected_rewards(tau_space, space.bin_values)
    found = {
        "gammas": space.gammas,
        "thetas": space.thetas,
        "theta_midpoints": space.bin_values,
        "horizons": horizons,
        "gamma_space": space.values,
        "constant_channel": space.constant,
        "differences": space.differences,
        "tau_space": tau_space,
        "survival": survival,
        "expected_reward": rewards,
        "horizon_values": values,
        "read_row": np.array(read_row),
        "chosen": greedy_action(values[:, read_row], scale=scale_of_values(rewards, space.bin_values)),
        "discount_kernel": _kernel(space.gammas, state, horizons[read_row], rows, K, dt),
        "averaging_kernel": _averaging(space.gammas, state, tau, rows, K, dt),
    }
    if space.open_ends:
        found["open_ends"] = np.array(1)
    if header.get("simulated", {}).get("action") == state["action"]:
        found["distance"] = _distance(arrays, tau_space[state["action"]], space, dt)
    if "optimum" in arrays:
        optimum = arrays["optimum"][:, [_row(horizons, left)]]
        found["regret"] = regret(optimum, np.array([found["chosen"]]))[0]
    return found


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


def _row(horizons: np.ndarray, horizon: float) -> int:
    return int(np.argmin(np.abs(horizons - horizon)))


def _space(header: Mapping[str, Any], arrays: Mapping[str, np.ndarray], state: Mapping[str, Any]) -> GammaSpace:
    """The gamma-space of all actions, with its noise."""
    prefix = "paper_" if state["paper_grid"] and "paper_gammas" in arrays else ""
    gammas, thetas = arrays[f"{prefix}gammas"], arrays["thetas"]
    if "differences" in arrays:
        differences, open_ends = arrays["differences"], "bin_values" in arrays
        if "places" in arrays:
            differences = differences @ softening(arrays["places"], state["slope_share"], open_ends)
        tails = np.cumsum(differences[..., ::-1], axis=-1)[..., ::-1]
        if open_ends:
            space = GammaSpace(tails[..., 1:], arrays["constant"], gammas, thetas, open_ends)
        else:
            values = np.concatenate([tails, np.zeros((*tails.shape[:-1], 1))], axis=-1)
            space = GammaSpace(values, arrays["constant"], gammas, thetas)
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


def _decoded(space: GammaSpace, state: Mapping[str, Any], rows: int, dt: float) -> tuple[np.ndarray, np.ndarray]:
    """Tau-space and survival on the first ``rows`` rows, moved by one where the index is."""
    tau_space = decode(space.differences, space.gammas, rows, state["alpha"], dt)
    survival = decode(space.constant[..., None], space.gammas, rows, state["alpha"], dt)[..., 0]
    if state["shift"]:
        tau_space, survival = np.roll(tau_space, 1, axis=1), np.roll(survival, 1, axis=1)
        tau_space[:, 0], survival[:, 0] = 0.0, 0.0
    rounding = rounding_of_rows(space.differences, space.gammas, rows, state["alpha"], dt)
    return normalise_rows(tau_space, survival, state["normalise"], dt, rounding), survival


def _weights(state: Mapping[str, Any], row: int, steps: int, dt: float) -> np.ndarray:
    """d(tau) of the horizon that a row stands for."""
    horizon = float(row_horizons(steps, dt)[row])
    if not state["softness"]:
        return (np.arange(steps) <= row) * state["value_gamma"] ** (np.arange(steps) * dt)
    return deadline_weights(horizon, steps, state["softness"], dt) * state["value_gamma"] ** (np.arange(steps) * dt)


def _value(
    tau_space: np.ndarray, space: GammaSpace, state: Mapping[str, Any], row: int, steps: int, dt: float
) -> np.ndarray:
    rewards = expected_rewards(tau_space, space.bin_values)
    return rewards @ _weights(state, row, steps, dt)[: rewards.shape[1]]


def _values(space: GammaSpace, state: Mapping[str, Any], row: int, steps: int, dt: float) -> np.ndarray:
    """V of one horizon, decoded with as many rows as it has."""
    return _value(_decoded(space, state, row + 1, dt)[0], space, state, row, steps, dt)


def _kernel(
    gammas: np.ndarray, state: Mapping[str, Any], horizon: float, rows: int, steps: int, dt: float
) -> np.ndarray:
    target = target_discounts(horizon, steps, state["value_gamma"], state["softness"], dt)
    if not state["softness"]:
        target = _weights(state, _row(row_horizons(steps, dt), horizon), steps, dt)
    target = target[:rows]
    if state["shift"]:
        target = np.append(target[1:], 0.0)
    return discount_kernel(gammas, readout_weights(gammas, target, state["alpha"], dt), steps, dt)


def _averaging(gammas: np.ndarray, state: Mapping[str, Any], tau: int, rows: int, steps: int, dt: float):
    at = tau - 1 if state["shift"] else tau
    if not 0 <= at < rows:
        return np.zeros(steps)
    if rows == steps:
        return resolution_matrix(gammas, steps, state["alpha"], dt)[at]
    return discount_kernel(gammas, readout_weights(gammas, np.eye(rows)[at], state["alpha"], dt), steps, dt)
