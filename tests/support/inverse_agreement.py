"""Cases on which the page Inverse is compared with the library: payloads, alphas, and the pictures at them."""

from __future__ import annotations

import base64
from typing import Any

import numpy as np
from scipy.optimize import nnls

from laplace_core import Settings, Study, load_world, study
from laplace_core.inverse import LINEAR, decode_matrix, is_linear, transform_matrix
from laplace_core.inverse.bands import bands
from laplace_core.inverse.components import sweep_of
from laplace_core.inverse.feasible import reduced_system
from laplace_core.inverse.solvers import selecting
from laplace_core.payloads.inverse import FOLLOWS, payload, swept
from laplace_core.study.course import course
from laplace_core.study.pipeline import deviations_of, noise_of, problem_for
from tests.support.lens_agreement import packed

EACH = 20
"""Alphas a payload."""


def studies() -> dict[str, Study]:
    """Every linear solver and the non-negative one, on worlds of several kinds, discounts weighed alike and not."""
    world = {"tikhonov": "discounting_chain", "tikhonov2": "two_branch", "iterative": "cliff_grid"}
    found = {}
    for place, solver in enumerate((*LINEAR, FOLLOWS, FOLLOWS, "tikhonov", "tikhonov1")):
        name = world.get(solver, "rise_and_fade")
        settings = Settings(
            world=name, solver=solver, noise=0.003, noise_level=0.003, thetas=25, gammas=12, steps=18,
            weighting=("deviation", "equal")[place % 2], time_step=0.5 if place == 8 else 1.0, noise_seed=place,
        )  # fmt: skip
        found[f"{place} {solver}"] = study(load_world(name), settings)
    return found


def fixture() -> dict[str, Any]:
    """Payloads, and random alphas with what the library makes of them."""
    rng, held, cases = np.random.default_rng(21), {}, []
    for name, shown in studies().items():
        action = int(rng.integers(len(shown.action_names)))
        found = swept(shown)
        along = course(shown, np.geomspace(1e-3, 10.0, 7))
        held[name] = base64.b64encode(payload(shown, action, found, along)).decode()
        for _ in range(EACH):
            alpha = float(f"{10 ** rng.uniform(-8.0 if FOLLOWS in name else -3.5, 1.5):.4g}")
            cases.append({"payload": name, "alpha": alpha, **expected(shown, action, alpha, int(rng.integers(18)))})
    return {
        "payloads": held,
        "cases": cases,
        "columns": [columns(shown) for shown in studies().values() if _follows(shown)],
    }


def columns(shown: Study) -> dict[str, Any]:
    """The first action's bins of a non-negative problem, and what ``scipy.optimize.nnls`` makes of them, with alpha as
    further rows, from large alphas to tiny ones."""
    problem = problem_for(shown.gamma_space, shown.settings)
    turn, system = reduced_system(problem.weights[:, None] * problem.transform)
    targets = (problem.weights[:, None] * problem.masses[0]).T @ turn
    found, rows = [], system.shape[1]
    for share in 10.0 ** -np.arange(10):
        alpha = float(share * np.linalg.norm(system, 2))
        stacked = np.vstack([system, alpha * np.eye(rows)])
        masses = [nnls(stacked, np.append(z, np.zeros(rows)), maxiter=50 * rows)[0] for z in targets]
        found.append({"alpha": alpha, "masses": packed(np.array(masses).T)})
    return {"system": packed(system), "targets": packed(targets), "rows": rows, "found": found}


def _follows(shown: Study) -> bool:
    return shown.settings.solver == FOLLOWS


def expected(shown: Study, action: int, alpha: float, row: int) -> dict[str, Any]:
    """What is drawn of a study at an alpha; ``row`` is that of the averaging kernel."""
    s, space = shown.settings, shown.gamma_space
    decoded = shown.under(s.at_alpha(alpha)).decoded
    rewards = decoded.expected_reward[action]
    transform = transform_matrix(space.gammas, s.steps, s.time_step)
    linear, deviations = selecting(s.solver), deviations_of(s, space.gammas)
    matrix = decode_matrix(space.gammas, s.steps, alpha, s.time_step, solver=linear, deviations=deviations)
    sweep = sweep_of(problem_for(space, s), s.solver, alphas=np.array([alpha]))
    arrays = {
        "tau": decoded.tau_space[action],
        "rewards": rewards,
        "back": transform @ rewards,
        "kernel": (matrix @ transform)[row],
    }
    noise = noise_of(s, space.gammas)
    if is_linear(s.solver) and noise is not None:
        around = bands(space, s.steps, alpha, noise, time_step=s.time_step, matrix=matrix)
        arrays |= {"noise": around.noise[action], "bias": around.bias[action]}
    return {
        "row": row,
        "residual": float(np.sqrt(sweep.residual[0, 0])),
        "size": float(np.sqrt(sweep.size[0, 0])),
        "degrees": float(sweep.degrees[0]),
        "arrays": {name: packed(array) for name, array in arrays.items()},
    }
