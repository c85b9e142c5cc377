"""The coefficients of the selector ``auto``, fitted to random worlds of known truth.

Every world is decoded from several grids of discounts, with noise of several sizes, by every linear solver and the
non-negative one with many alphas. A network learns the logarithm of alpha of each of these solvers by descent on the
distance itself: first on its logarithm, then more and more on whether it is at most ``NEAR`` times the least. For the
slow solver, the feasible one, alphas whose distance is at most ``GOOD`` times the least are good, and the weights of a
sum are those whose alphas lie in or nearest to these intervals, in the logarithm, by least absolute deviations.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from functools import partial
from typing import Any, NamedTuple

import numpy as np
import torch

from laplace_core.code.encoding import PAPER_GAMMAS, discount_grid
from laplace_core.experiments.inverse.random_cases import random_case
from laplace_core.files.plain_json import as_json
from laplace_core.inverse import LINEAR, solve
from laplace_core.inverse.auto import COEFFICIENTS, FARTHEST, FEATURES, Network, features, summed
from laplace_core.inverse.components import sweep_of
from laplace_core.inverse.distances import mean_time_distance
from laplace_core.inverse.problem import Problem
from laplace_core.supervise.parallel import in_parallel

SEED = 1000
"""Of the worlds that are fitted; studies use others."""
PROBLEMS = 4
"""Of each world, each with a grid and a noise of its own."""
ALPHAS, SOME_ALPHAS, FEW_ALPHAS = (
    np.geomspace(1e-6, 100.0, 56),
    np.geomspace(1e-6, 30.0, 23),
    np.geomspace(1e-4, 100.0, 13),
)
"""Of a linear solver, of the non-negative one, and of a slow one."""
LEARNED = (*LINEAR, "nonnegative")
"""Solvers whose alpha a network gives."""
SLOW, SLOW_WORLDS, SLOW_PROBLEMS = ("feasible",), 120, 1
"""Slow solvers, whose alpha a sum gives, and how many worlds and problems of each they are fitted to."""
GOOD, NEAR = 1.2, 1.3
NOTHING = 1e-6
WEIGHTINGS = ("weighted", "equal")
HIDDEN = 24
"""Numbers of each hidden layer."""
EPOCHS, BATCH, RATE, DECAY = 600, 512, 3e-3, 1e-3
_FARTHEST_RATIO, _SHARP, _SMOOTH = 2.0, 0.08, 0.1  # of log ratios: cut there; width of the step at NEAR; share kept
_ROUNDS, _LEAST_DEVIATION, _RIDGE = 60, 0.3, 1e-2


class Example(NamedTuple):
    """One problem and one solver: its features ``(32,)``, and the distance at each of ``alphas``."""

    world: int
    solver: str
    weighting: str
    features: np.ndarray
    alphas: np.ndarray
    distances: np.ndarray


def examples_of(world: int, solvers: Sequence[str] = (*LEARNED, *SLOW)) -> list[Example]:
    """All examples of one random world; they do not depend on which other solvers there are."""
    rng = np.random.default_rng([SEED, world, 1])
    case = random_case(np.random.default_rng([SEED, world]))
    examples = []
    for number in range(PROBLEMS):
        noise, gammas = 10.0 ** rng.uniform(-5.0, -1.3), _gammas(rng)
        weighted = case.problem(noise, seed=int(rng.integers(10**6)), gammas=gammas)
        equal = Problem(weighted.masses, weighted.gammas, weighted.steps, weighted.time_step)
        slow = SLOW if world < SLOW_WORLDS and number < SLOW_PROBLEMS else ()
        for weighting, problem in zip(WEIGHTINGS, (weighted, equal), strict=True):
            for solver in [each for each in solvers if each in LEARNED or each in slow]:
                alphas = ALPHAS if solver in LINEAR else FEW_ALPHAS if solver in SLOW else SOME_ALPHAS
                distances = [
                    mean_time_distance(
                        solve(problem, solver, alpha).masses, case.masses, case.settings.time_step
                    ).mean()
                    for alpha in alphas
                ]  # fmt: skip
                found = features(sweep_of(problem, solver))
                examples.append(Example(world, solver, weighting, found, alphas, np.maximum(distances, NOTHING)))
    return examples


def _gammas(rng: np.random.Generator) -> np.ndarray:
    if rng.random() < 0.25:
        return np.array(PAPER_GAMMAS)
    count, spacing = int(rng.choice([8, 12, 15, 20, 30, 60])), str(rng.choice(["inverse-log", "log", "linear"]))
    low, high = float(rng.choice([0.01, 0.05, 0.3])), float(rng.choice([0.9, 0.95, 0.99, 0.99, 0.995]))
    return discount_grid(count, spacing, low, high)


def fitted_sum(examples: list[Example], tikhonov: Network) -> np.ndarray:
    """Weights ``(9,)`` of a sum, by iteratively reweighted least squares to the nearest good alpha.

    Args:
        tikhonov: the network of Tikhonov, fitted to the same worlds.
    """
    good = [np.log(each.alphas[each.distances <= GOOD * each.distances.min()]) for each in examples]
    low, high = (np.array([alphas[end] for alphas in good]) for end in (0, -1))
    X = summed(np.array([each.features for each in examples]), tikhonov)
    weights = np.linalg.lstsq(X, (low + high) / 2.0, rcond=None)[0]
    for _ in range(_ROUNDS):
        wanted = np.clip(X @ weights, low, high)
        root = np.sqrt(1.0 / np.maximum(_LEAST_DEVIATION, np.abs(X @ weights - wanted)))
        system = np.vstack([root[:, None] * X, _RIDGE * np.eye(X.shape[1])])
        weights = np.linalg.lstsq(system, np.append(root * wanted, _RIDGE * weights), rcond=None)[0]
    return weights


def fitted_network(examples: list[Example], seed: int = 0) -> Network:
    """A network for one solver, from examples with the same alphas."""
    torch.manual_seed(seed)
    X = np.array([each.features for each in examples])
    mean, scale = X.mean(axis=0), np.maximum(X.std(axis=0), 1e-6)
    seen = torch.as_tensor(np.clip((X - mean) / scale, -FARTHEST, FARTHEST), dtype=torch.float32)
    places = np.log(examples[0].alphas)
    distances = np.array([each.distances for each in examples])
    ratios = np.minimum(np.log(distances / distances.min(axis=1, keepdims=True)), _FARTHEST_RATIO)
    curves, best = torch.as_tensor(ratios, dtype=torch.float32), places[distances.argmin(axis=1)]
    layers = [torch.nn.Linear(len(FEATURES), HIDDEN), torch.nn.Linear(HIDDEN, HIDDEN), torch.nn.Linear(HIDDEN, 1)]
    with torch.no_grad():
        layers[-1].bias.fill_(float(np.median(best)))
    network = torch.nn.Sequential(layers[0], torch.nn.Tanh(), layers[1], torch.nn.Tanh(), layers[2])
    descent = torch.optim.AdamW(network.parameters(), RATE, weight_decay=DECAY)
    slower = torch.optim.lr_scheduler.CosineAnnealingLR(descent, EPOCHS)
    for epoch in range(EPOCHS):
        share = min(1.0, 2.0 * epoch / EPOCHS)  # of the step at NEAR in what is made small
        for batch in torch.randperm(len(seen)).split(BATCH):
            log_ratio = _read(curves[batch], network(seen[batch])[:, 0], places)
            step = torch.sigmoid((log_ratio - float(np.log(NEAR))) / _SHARP) + _SMOOTH * log_ratio
            loss = ((1.0 - share) * log_ratio + share * step).mean()
            descent.zero_grad()
            loss.backward()
            descent.step()
        slower.step()
    held = tuple((each.weight.detach().double().numpy(), each.bias.detach().double().numpy()) for each in layers)
    return Network(mean, scale, held)


def _read(curves: torch.Tensor, log_alpha: torch.Tensor, places: np.ndarray) -> torch.Tensor:
    """Curves ``(n, a)`` at an alpha each, ``(n,)``, linear between the places, which are evenly spaced."""
    at = ((log_alpha - places[0]) / (places[1] - places[0])).clamp(0.0, len(places) - 1.001)
    before = at.floor().long()
    part = at - before
    low, high = (curves.gather(1, (before + i)[:, None])[:, 0] for i in (0, 1))
    return low * (1.0 - part) + high * part


def near(examples: list[Example], chosen: np.ndarray) -> float:
    """Share of the examples whose distance at the chosen log alphas is at most ``NEAR`` times the least."""
    ratios = [
        np.exp(np.interp(log_alpha, np.log(each.alphas), np.log(each.distances))) / each.distances.min()
        for each, log_alpha in zip(examples, chosen, strict=True)
    ]
    return float(np.mean(np.array(ratios) <= NEAR))


def report(
    worlds: int, processes: int, progress: Callable[[int, int], None] = lambda done, of: None,
    solvers: Sequence[str] = (*LEARNED, *SLOW),
) -> tuple[dict[str, Any], str]:  # fmt: skip
    """The file of coefficients, and a table: how near a fit to half of the worlds comes on the other half.

    Args:
        solvers: that are fitted. A sum goes over what the network of Tikhonov says, so that a slow solver needs it as
            well. Of the others the file keeps what it has (:data:`laplace_core.inverse.auto.COEFFICIENTS`).
    """
    examples: list[Example] = []
    for done, (_, several) in enumerate(in_parallel(partial(examples_of, solvers=solvers), range(worlds), processes)):
        examples += several
        progress(done + 1, worlds)
    examples.sort(key=lambda each: each.world)
    lines = [
        f"{worlds} worlds of seed {SEED}, {PROBLEMS} problems each; within {NEAR} of the least distance on the half "
        "that was not fitted",
        f"{'solver':11} " + " ".join(f"{name:>10}" for name in WEIGHTINGS),
    ]
    held = {} if set(solvers) >= {*LEARNED, *SLOW} else json.loads(COEFFICIENTS.read_text(encoding="utf-8"))
    networks: dict[str, dict[str, Any]] = {
        solver: {} if solver in solvers else held["networks"][solver] for solver in LEARNED
    }
    coefficients: dict[str, dict[str, list[float]]] = {
        solver: {} if solver in solvers else held["coefficients"][solver] for solver in SLOW
    }
    shares: dict[str, dict[str, float]] = {solver: {} for solver in solvers}
    for weighting in WEIGHTINGS:
        own = [each for each in examples if each.weighting == weighting]
        whole, chosen = _fit(own), [_chosen(_fit(_half(own, half)), _half(own, 1 - half)) for half in (0, 1)]
        for solver, fit in whole.items():
            if isinstance(fit, Network):
                networks[solver][weighting] = _listed(fit)
            else:
                coefficients[solver][weighting] = np.round(fit, 5).tolist()
            shares[solver][weighting] = float(
                np.mean([near(*each[solver]) if each[solver][0] else np.nan for each in chosen])
            )
    for solver, each in shares.items():
        lines.append(f"{solver:11} " + " ".join(f"{each[name]:10.1%}" for name in WEIGHTINGS))
    chosen_solvers = "" if not held else f" --solvers {','.join(solvers)}"
    command = f"python -m laplace_core report auto --worlds {worlds}{chosen_solvers}"
    commands = {**held.get("commands", {}), **dict.fromkeys(solvers, command)}
    numbers = {
        "commands": commands, "features": list(FEATURES), "networks": networks, "coefficients": coefficients,
        "near": shares,
    }  # fmt: skip
    return numbers, "\n".join(lines)


def _half(examples: list[Example], half: int) -> list[Example]:
    """The examples of every second world."""
    return [each for each in examples if each.world % 2 == half]


def _fit(examples: list[Example]) -> dict[str, Network | np.ndarray]:
    """By solver: a network of the linear ones, the weights of a sum of the slow ones; nothing from no examples."""
    own = {solver: [each for each in examples if each.solver == solver] for solver in (*LEARNED, *SLOW)}
    networks = {solver: fitted_network(own[solver]) for solver in LEARNED if own[solver]}
    sums = {solver: fitted_sum(own[solver], networks["tikhonov"]) for solver in SLOW if own[solver]}
    return {**networks, **sums}


def _chosen(
    fits: dict[str, Network | np.ndarray], examples: list[Example]
) -> dict[str, tuple[list[Example], np.ndarray]]:
    """The examples of each solver, and the log alphas that the fits choose for them."""
    chosen = {}
    for solver, fit in fits.items():
        own = [each for each in examples if each.solver == solver]
        numbers = np.array([each.features for each in own]).reshape(len(own), len(FEATURES))
        if isinstance(fit, Network):
            alphas = fit.log_alpha(numbers)
        else:
            tikhonov = fits["tikhonov"]
            assert isinstance(tikhonov, Network)  # it is linear
            alphas = summed(numbers, tikhonov) @ fit
        chosen[solver] = own, alphas
    return chosen


def _listed(network: Network) -> dict[str, Any]:
    """A network as plain lists, with digits enough for an alpha to four of its own."""
    layers = [[np.round(weights, 5).tolist(), np.round(biases, 5).tolist()] for weights, biases in network.layers]
    return {"mean": np.round(network.mean, 6).tolist(), "scale": np.round(network.scale, 6).tolist(), "layers": layers}


def as_file(numbers: dict[str, Any]) -> bytes:
    """The file of coefficients as JSON."""
    return as_json({name: numbers[name] for name in ("commands", "features", "networks", "coefficients")})
