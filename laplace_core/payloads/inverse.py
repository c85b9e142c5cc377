"""The payload of the page Inverse for one action of a study: everything that a drag of alpha moves.

The library makes every array. The browser filters components by alpha and multiplies; what alpha does not move comes as
it is drawn.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from laplace_core import Study
from laplace_core.inverse import LINEAR, is_linear
from laplace_core.inverse.bands import bands, bands_by_draws, bins_of, reward_gain
from laplace_core.inverse.components import Sweep, reached, sweep_of
from laplace_core.inverse.feasible import reduced_system
from laplace_core.inverse.selectors import chosen_index, curves_of
from laplace_core.inverse.transform import transform_matrix
from laplace_core.payloads.packing import pack, packed_blocks
from laplace_core.study.course import Course
from laplace_core.study.pipeline import noise_of, problem_for, solver_of

FOLLOWS = "nonnegative"
"""The solver that is not linear and follows a drag in the browser; the others answer when alpha is released."""

LEAST_DRAWN = 1e-7
"""Of the largest singular value: alphas from which on pictures begin."""


def sweep_for(study: Study) -> Sweep:
    """The sweep of a study's solver, or of the linear one that alpha is chosen by."""
    s = study.settings
    problem = problem_for(study.gamma_space, s)
    return sweep_of(problem, s.solver, noise=noise_of(s, study.gamma_space.gammas))


@dataclass(frozen=True, eq=False)
class Swept:
    """A study's sweep, the curve of every rule, ``(a,)``, and which alpha each of them takes."""

    sweep: Sweep
    curves: dict[str, np.ndarray]
    chosen: dict[str, int]

    @property
    def first(self) -> int:
        """The first alpha that is drawn: smaller ones fit everything, unless a rule takes one of them."""
        least = np.argmax(self.sweep.alphas >= LEAST_DRAWN * self.sweep.spectrum.largest)
        return min(int(least), *self.chosen.values())


def swept(study: Study) -> Swept:
    """The sweep of a study with all that is read from it."""
    sweep = sweep_for(study)
    curves = curves_of(sweep)
    chosen = {name: int(chosen_index(name, curve)[0]) for name, curve in curves.items()}
    return Swept(sweep, {name: curve[0] for name, curve in curves.items()}, chosen)


class Band(NamedTuple):
    """The band of a solver that is not linear: at which alpha, and standard deviation and bias of each row."""

    alpha: float
    noise: list[float]
    bias: list[float]


def payload(
    study: Study, action: int, found: Swept, course: Course | None = None, *, independent: bool = True,
    gain: float | None = None,
) -> bytes:  # fmt: skip
    """A length, a header as JSON, and arrays, as :func:`laplace_core.payloads.packing.packed_blocks` lays them out.

    With G discounts, K rows, B bins, r components, a alphas, R rules and c alphas of the course:
        ``gammas`` ``(G,)``; ``U`` ``(G, r)``, ``s`` ``(r - free,)``, ``rows`` ``(K, r)``, ``weights`` ``(G,)``: the
            weighted transform of the linear solver in its components, the free ones first.
        ``masses`` ``(G, B)``, ``bin_edges`` ``(B + 1,)``, ``bin_values`` ``(B,)``: the data of the action.
        ``alphas``, ``residual``, ``size``, ``degrees`` ``(a,)``, ``curves`` ``(R, a)``, ``energy`` ``(r,)``: the sweep.
        ``course_alphas`` ``(c,)``, ``choices`` ``(c, K)``, ``time_error`` ``(c,)``: what is chosen, and how far off the
            timeline is, where that is known.
        ``truth`` ``(K, B)``, ``true_rewards`` ``(K,)``, ``true_choice`` ``(K,)``: where there is a world.
        ``deviations`` ``(G,)``: where the noise is known; of a linear solver then also the timeline that its bias is
            counted from, ``reference`` ``(K,)``, and what that leaves at the discounts, ``reference_values`` ``(G,)``.
        ``reduced`` ``(q, K)``, ``targets`` ``(B, q)``: the non-negative solver's system and data.
        ``decoded`` ``(K, B)``: the timeline of a solver that does not follow a drag.

    Args:
        independent: whether errors of different sensitivities are, as in :func:`laplace_core.inverse.bands.bands`.
        gain: standard deviation of the expected reward at a discount over that of one value there, where it was
            measured; else it follows from ``independent``.
    """
    s, space, sweep = study.settings, study.gamma_space, found.sweep
    spectrum, used = sweep.spectrum, reached(sweep.spectrum)
    problem = problem_for(space, s)
    shown = problem.masses[action] if space.open_ends else problem.masses[action][:, 1:-1]
    arrays: dict[str, np.ndarray] = {
        "gammas": space.gammas,
        "U": spectrum.U[:, used],
        "s": spectrum.s[spectrum.usable],
        "rows": spectrum.rows[:, used],
        "weights": np.ones(len(space.gammas)) if spectrum.weights is None else spectrum.weights,
        "masses": shown,
        "bin_edges": space.bin_edges if space.open_ends else space.thetas,
        "bin_values": space.bin_values,
        "alphas": sweep.alphas,
        "residual": np.sqrt(sweep.residual[0]),
        "size": np.sqrt(sweep.size[0]),
        "degrees": sweep.degrees,
        "curves": np.array(list(found.curves.values())),
        "energy": sweep.energy[0],
    }
    if course is not None:
        arrays |= {"course_alphas": course.alphas, "choices": course.chosen}
        if course.time_error is not None:
            arrays["time_error"] = course.time_error
    truth = study.truth
    if truth is not None:
        arrays |= {"truth": truth.tau_space[action], "true_rewards": truth.expected_reward[action]}
        arrays["true_choice"] = truth.optimal_action
    deviations = noise_of(s, space.gammas)
    if deviations is not None:
        gain, arrays["deviations"] = gain or reward_gain(space, independent=independent), deviations
    if deviations is not None and is_linear(s.solver):
        around = bands(space, s.steps, 1.0, deviations, time_step=s.time_step, independent=independent)
        assert around.values is not None  # those of a linear inverse have them
        arrays |= {"reference": around.reference[action], "reference_values": around.values[action]}
    if s.solver == FOLLOWS:
        system = problem.weights[:, None] * transform_matrix(space.gammas, s.steps, s.time_step)
        turn, arrays["reduced"] = reduced_system(system)
        arrays["targets"] = (problem.weights[:, None] * shown).T @ turn
    elif not is_linear(s.solver):
        arrays["decoded"] = study.decoded.tau_space[action]
    header: dict[str, Any] = {
        "solver": s.solver,
        "linear": sweep.solver,
        "filter": LINEAR[sweep.solver].filter,
        "free": spectrum.free,
        "outside": float(np.trace(sweep.outside[0])),
        "columns": sweep.columns,
        "rules": list(found.curves),
        "chosen": [found.chosen[name] for name in found.curves],
        "steps": s.steps,
        "time_step": s.time_step,
        "mapped": None if course is None else course.solver,
        "first": found.first,
        "open": space.open_ends,
        "actions": list(study.action_names),
        "action": action,
        "gain": gain or 0.0,
        "decoded_at": s.alpha if "decoded" in arrays else None,
    }
    return _packed(header, arrays)


DRAWS = 30
"""Of the noise, for the band of a solver that is not linear: its standard deviation is then known within 13%."""
SECONDS_A_DRAW = {"nonnegative": 1e-7, "feasible": 2e-6}
"""By discounts times rows times bins, about."""


def band(study: Study, action: int, *, independent: bool, progress: Callable[[int, int], None]) -> Band | None:
    """The errors of an action's expected rewards at the alpha of a study whose solver is not linear.

    Returns:
        None where the size of the noise is not known, or the browser has the band from the payload.
    """
    s, space = study.settings, study.gamma_space
    deviations = noise_of(s, space.gammas)
    if deviations is None or is_linear(s.solver):
        return None
    bins = bins_of(space, s.steps, deviations, time_step=s.time_step, independent=independent).of_action(action)
    found = bands_by_draws(solver_of(s), bins, s.alpha, draws=DRAWS, progress=progress)
    return Band(s.alpha, found.noise[0].tolist(), found.bias[0].tolist())


def seconds_to_draw(study: Study) -> float:
    """An estimate of how long :func:`band` takes."""
    s = study.settings
    size = len(study.gamma_space.gammas) * s.steps * (len(study.gamma_space.thetas) + 1)
    fit = 2.0 * size * SECONDS_A_DRAW["feasible"]
    return 1.0 + fit + DRAWS * (0.02 + size * SECONDS_A_DRAW.get(s.solver, 0.0))


_FLOATS, _COUNTS = ("truth", "decoded"), ("choices", "true_choice")


def _packed(header: dict[str, Any], arrays: dict[str, np.ndarray]) -> bytes:
    """In doubles, except arrays that are only drawn (single floats) and actions (two bytes)."""
    kinds = {name: "f4" if name in _FLOATS else "u2" if name in _COUNTS else "f8" for name in arrays}
    header["arrays"], data = packed_blocks(
        (name, kinds[name], np.ascontiguousarray(array, dtype=f"<{kinds[name]}").tobytes(), list(array.shape))
        for name, array in arrays.items()
    )
    return pack(header, data)
