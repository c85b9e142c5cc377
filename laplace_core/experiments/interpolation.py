"""The error of interpolated discounts, and their effect on the decoded timeline.

First on a trained network: every discount but the outermost two is left out in turn, drawn from its neighbours and
compared with the network's own, at every step of one greedy episode and for every action. Then on worlds that are known
exactly, where the decoded timeline is compared with the true one: from the learned discounts alone, with as many more
again that are learned, too, and with as many more that are interpolated.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from scipy.interpolate import CubicSpline, PchipInterpolator

from laplace_core.acting.rollout import roll_out
from laplace_core.code.gamma_space import GammaSpace, encode, with_noise
from laplace_core.code.interpolation import left_out, log_times, mixing, with_between
from laplace_core.errors import InputError
from laplace_core.inverse import decode
from laplace_core.planning import greedy_policy, reward_indicator_basis
from laplace_core.study.pipeline import WorldStudy, study
from laplace_core.study.settings import Settings
from laplace_core.training.checkpoint import load_checkpoint
from laplace_core.worlds import load_world

WORLDS = ("two_decisions", "discounting_chain", "fig6_chain")
ALPHAS, NOISES, SEEDS = (1.0, 0.1, 0.01), (0.0, 0.003), 8

Between = Callable[[np.ndarray, np.ndarray, np.ndarray], np.ndarray]


def line(values: np.ndarray, gammas: np.ndarray, wanted: np.ndarray) -> np.ndarray:
    """Q ``(..., G, n)`` at other discounts, ``(..., W, n)``: what the library does."""
    return mixing(gammas, wanted) @ values


def monotone(values: np.ndarray, gammas: np.ndarray, wanted: np.ndarray) -> np.ndarray:
    """The same by a monotone cubic (Fritsch & Carlson 1980)."""
    return _by(PchipInterpolator, values, gammas, wanted)


def spline(values: np.ndarray, gammas: np.ndarray, wanted: np.ndarray) -> np.ndarray:
    """The same by a cubic spline."""
    return _by(CubicSpline, values, gammas, wanted)


def _by(kind: type, values: np.ndarray, gammas: np.ndarray, wanted: np.ndarray) -> np.ndarray:
    drawn = kind(log_times(gammas), values * (1.0 - gammas)[:, None], axis=-2)
    return drawn(log_times(wanted)) / (1.0 - wanted)[:, None]


KINDS: dict[str, Between] = {"line": line, "monotone cubic": monotone, "cubic spline": spline}


def report(path: Path, seed: int) -> tuple[dict[str, Any], str]:
    """Numbers and their tables; ``seed`` is that of the episode's start.

    Raises:
        InputError: no checkpoint with values at three discounts or more.
    """
    network, worlds = of_network(path, seed), [row for name in WORLDS for row in of_world(name)]
    return {"network": network, "worlds": worlds}, f"{_network_table(network)}\n\n{_world_table(worlds)}"


def of_network(path: Path, seed: int) -> dict[str, Any]:
    """Errors of (1 - gamma) Q, a probability each; of every space the worst sensitivity."""
    loaded = load_checkpoint(path)
    rollout = roll_out(loaded.agent, loaded.environment, seed)
    if rollout.spaces is None or rollout.gammas is None or len(rollout.gammas) < 3:
        raise InputError(f"{path.name}: to leave a discount out needs an agent with values at three or more.")
    gammas, values = rollout.gammas, rollout.spaces[:: max(1, len(rollout) // 200)].astype(float)
    errors = {}
    for name, kind in KINDS.items():
        off = left_out(values, gammas) if kind is line else _left_out(values, gammas, kind)
        worst = off.max(axis=-1)
        errors[name] = {
            "mean": float(off.mean()),
            "median": float(np.median(worst)),
            "95%": float(np.quantile(worst, 0.95)),
            "worst": float(worst.max()),
            "by discount": np.median(worst, axis=(0, 1)).tolist(),
        }
    report = {"agent": path.name, "environment": loaded.environment, "seed": seed, "spaces": len(values)}
    return {**report, "gammas": gammas.tolist(), "kinds": errors}


def _left_out(values: np.ndarray, gammas: np.ndarray, kind: Between) -> np.ndarray:
    off = []
    for i in range(1, gammas.size - 1):
        others = np.delete(np.arange(gammas.size), i)
        drawn = kind(values[..., others, :], gammas[others], gammas[i : i + 1])
        off.append(np.abs(drawn - values[..., [i], :]) * (1.0 - gammas[i]))
    return np.concatenate(off, axis=-2)


def of_world(name: str) -> list[dict[str, Any]]:
    """Error of the decoded timeline: total variation from the true one, as a share of it; noise: a mean of seeds."""
    settings = Settings(world=name, gammas=15, spacing="log", gamma_min=0.3678794412, gamma_max=0.99, thetas=13)
    result = study(load_world(name), settings)
    rows, noiseless = [], _exact(result, result.gamma_space.gammas)
    more = with_between(noiseless.gammas, 1)
    for noise in NOISES:
        for alpha in ALPHAS:
            errors: dict[str, list[float]] = {"learned": [], "as many learned": [], **{kind: [] for kind in KINDS}}
            for seed in range(SEEDS if noise else 1):
                learned = with_noise(noiseless, noise, seed)
                errors["learned"].append(_error(result, learned, alpha))
                errors["as many learned"].append(_error(result, with_noise(_exact(result, more), noise, seed), alpha))
                for kind, between in KINDS.items():
                    values = between(learned.values, learned.gammas, more)
                    drawn = GammaSpace(values, values[..., 0], more, learned.thetas)  # of rewards alone
                    errors[kind].append(_error(result, drawn, alpha))
            means = {kind: float(np.mean(each)) for kind, each in errors.items()}
            rows.append({"world": name, "noise": noise, "alpha": alpha, **means})
    return rows


def _exact(result: WorldStudy, gammas: np.ndarray) -> GammaSpace:
    policy = greedy_policy(result.world, result.settings.acting_gamma)
    basis = reward_indicator_basis(result.world, result.state, gammas, [policy] * gammas.size)
    return encode(basis, result.world.reward_values, gammas, result.gamma_space.thetas, result.settings.slope)


def _error(result: WorldStudy, space: GammaSpace, alpha: float) -> float:
    true = result.truth.tau_space
    off = decode(space.differences, space.gammas, result.settings.steps, alpha, result.settings.time_step) - true
    return float(np.abs(off).sum() / (2.0 * true.sum()))


def _network_table(network: dict[str, Any]) -> str:
    kinds = network["kinds"]
    lines = [
        f"{network['agent']}: each inner discount left out, {network['spaces']} spaces of a greedy episode from "
        f"start seed {network['seed']}; error of a probability",
        f"{'':15} {'mean':>8} {'worst theta: median':>20} {'95%':>8} {'largest':>8}",
    ]  # fmt: skip
    for name, each in kinds.items():
        lines.append(f"{name:15} {each['mean']:8.5f} {each['median']:20.5f} {each['95%']:8.4f} {each['worst']:8.4f}")
    inner = zip(network["gammas"][1:-1], kinds["line"]["by discount"], strict=True)
    return "\n".join([*lines, "by discount, line: " + ", ".join(f"{gamma:.3g} {off:.4f}" for gamma, off in inner)])


def _world_table(rows: list[dict[str, Any]]) -> str:
    names = ["learned", "as many learned", *KINDS]
    lines = [
        "worlds, 15 discounts and 14 more between: error of the decoded timeline, as a share of it",
        f"{'':18} {'noise':>6} {'alpha':>6} " + " ".join(f"{name:>15}" for name in names),
    ]
    for row in rows:
        numbers = " ".join(f"{row[name]:15.4f}" for name in names)
        lines.append(f"{row['world']:18} {row['noise']:6g} {row['alpha']:6g} {numbers}")
    return "\n".join(lines)
