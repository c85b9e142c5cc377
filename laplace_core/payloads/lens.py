"""The payload of the lens for a study, sent once per world, grid and policy, in double precision.

Everything that is inverted stays in doubles; single floats would ruin a small alpha before the product. The truth is
only looked at and is packed in single floats.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from laplace_core import Study, World
from laplace_core.code.encoding import PAPER_GAMMAS
from laplace_core.inverse import LINEAR, SOLVERS, Problem, is_linear
from laplace_core.inverse.components import reached
from laplace_core.inverse.feasible import reduced_system
from laplace_core.inverse.smoothing import probability_filter
from laplace_core.inverse.solvers import selecting
from laplace_core.inverse.spectrum import Spectrum, spectrum_of
from laplace_core.inverse.transform import transform_matrix
from laplace_core.payloads.inverse import FOLLOWS
from laplace_core.payloads.packing import pack, packed_blocks
from laplace_core.payloads.state import state_of
from laplace_core.planning import reward_indicator_basis
from laplace_core.study.horizon import row_horizons
from laplace_core.study.pipeline import (
    WorldStudy,
    basis_of,
    clipped_sensitivities,
    decode_and_read,
    decoder,
    deviations_of,
    policies_of,
    row_read,
    rows_decoded,
    timeline_of,
)
from laplace_core.study.settings import Resolved

if TYPE_CHECKING:  # it brings torch along, which no world needs
    from laplace_core.acting.simulated_truth import Empirical

MOST_REWARDS = 64
"""With more distinct rewards the differences at one slope are smaller than the basis of all slopes."""

LIVE: dict[str, Any] = {
    "alpha": 1.0,
    "selector": "typed",
    "noise_level": None,
    "softness": 0.0,
    "noise": 0.0,
    "noise_seed": 0,
    "normalise": "none",
    "deadline": "constant",
    "horizon": None,
    "used": 0.0,
    "fold": False,
    "shift": False,
    "slope_share": 1.0,
}
"""Settings that move in the browser: a payload does not depend on them."""


LEVELS = 65_535
"""Of the simulated tails, which are probabilities."""


@dataclass(frozen=True, eq=False)
class Simulated:
    """Simulated continuations of the observation that begin with an action: the truth if there is no world."""

    action: int
    outcome: Empirical


_DECODES = ("noise", "noise_seed", "shift", "fold", "slope_share", "slope", "mixed", "clip", "paper_grid")
"""Entries of the state of a lens that change what is decoded, beside alpha."""
_READS = ("normalise", "softness", "value_gamma", "horizon", "used", "constant")
"""Those that change the values of all horizons; they count if every horizon has its own inverse."""


def follows(settings: Resolved) -> bool:
    """Whether the browser decodes by these settings itself; of all others the server sends what it has decoded.

    Where only the rows of a horizon are decoded, each horizon has its own components: the browser grows those of plain
    Tikhonov row by row.
    """
    s = settings
    if s.fold:
        return s.solver == "tikhonov" and s.weighting == "equal" and s.filter == "none"
    return is_linear(s.solver) or s.solver == FOLLOWS


def decoding(settings: Resolved) -> Resolved:
    """Settings with everything set aside that does not change what the server decodes; equal ones decode the same."""
    s = settings.at_alpha(settings.alpha)
    if s.fold:
        return s
    return replace(s, normalise="none", softness=0.0, value_gamma=s.acting_gamma, horizon=None, used=0.0)


def structure(settings: Resolved, world: World | None) -> Resolved:
    """Settings with everything set aside that moves in the browser: equal ones have the same payload."""
    free = world is not None and world.reward_values.size <= MOST_REWARDS
    of_world = {"slope": 1.0, "policy": "shared", "clip": False, "paper_grid": False} if free else {}
    return replace(settings, **(LIVE | {"value_gamma": settings.acting_gamma} | of_world))


def payload(
    study: Study,
    simulated: Simulated | None = None,
    places: np.ndarray | None = None,
    *,
    added: int = 0,
    shown: Study | None = None,
) -> tuple[bytes, dict[str, Any]]:
    """Arrays and their header, as one block of bytes, and the header once more for Python.

    The study's settings are those of :func:`structure`: its gamma-space is free of noise.

    Args:
        places: of a network's sensitivities on the axis of its activation, ``(H,)``, as in
            :func:`laplace_core.code.encoding.softening`.
        added: how many of the discounts between two that were trained are interpolated.
        shown: the study that is seen, where the browser cannot decode by its settings (:func:`follows`).

    Arrays by name, with A actions, G discounts, V distinct rewards, K rows, r usable singular values:
        ``shared``, ``per_gamma``, ``paper_shared``, ``paper_per_gamma``: reward-indicator coefficients ``(A, G, V)``
            on the study's grid and on the paper's; or, without them, ``differences`` ``(A, G, B)`` and
            ``constant`` ``(A, G)``.
        ``gammas``, ``U`` ``(G, r)``, ``s`` ``(r - free,)``, ``V`` ``(K, r)``, and the same with ``paper_``: the
            transform in the components of the linear solver, the free ones first; ``weights`` ``(G,)`` where discounts
            do not count alike, ``smoothing`` ``(G, G)`` where they are filtered.
        ``reduced`` ``(q, K)``, ``turned`` ``(q, G)``, and the same with ``paper_``: the non-negative solver's system
            and what turns masses over the discounts into its data; ``above`` ``(A, G)``: the last tail, where it needs
            it.
        ``decoded`` ``(A, K, B)``, ``decoded_survival`` ``(A, K)``: of ``shown``, before rows are rescaled; under
            ``fold`` also ``decoded_values`` ``(A, K)``. ``matrix`` ``(n, G)``: the decode matrix whose kernels are
            drawn.
        ``bin_values`` ``(B,)``, ``bin_edges`` ``(B+1,)``: of a gamma-space with open ends; elsewhere the B = H-1 bins
            lie between the sensitivities and count as their midpoints.
        ``thetas``, ``clipped_thetas``: sensitivities, and those that begin at the lowest reward that occurs.
        ``rewards``, ``timeline`` ``(A, N, V)``, ``optimum`` ``(A, K)``: the truth, where there is a world.
        ``simulated_tails`` ``(N, B+1)``, at the edges of the bins, in 65,535ths, and ``simulated_lines`` ``(5, N)``:
            reward, survival, each with its standard error, and the W1 distance that chance alone makes; of the first N
            whole steps.
        ``places``: as given.
    """
    s, space = study.settings, study.gamma_space
    arrays = {"thetas": space.thetas, **_transform("", space.gammas, s)}
    if space.open_ends:
        arrays |= {"bin_values": space.bin_values, "bin_edges": space.bin_edges}
    if isinstance(study, WorldStudy):
        arrays |= _of_world(study)
    else:
        arrays |= {"differences": space.differences, "constant": space.constant}
    if s.solver == FOLLOWS and "differences" in arrays and not space.open_ends:
        arrays["above"] = space.values[..., -1]
    if places is not None:
        arrays["places"] = places
    header: dict[str, Any] = {
        "added": added,
        "world": s.world,
        "state": s.state or "",
        "actions": list(study.action_names),
        "steps": s.steps,
        "time_step": s.time_step,
        "acting_gamma": s.acting_gamma,
        "learned": study.learned is not None,
        "solver": s.solver,
        "filter": LINEAR[selecting(s.solver)].filter,
        "free": _spectrum(space.gammas, s).free,
        "follows": is_linear(s.solver) or s.solver == FOLLOWS,
        "decoded_for": None,
    }
    if shown is not None:
        arrays |= _decoded(shown)
        header["decoded_for"] = decoded_for(shown.settings)
    if simulated is not None:
        outcome = simulated.outcome
        header["simulated"] = {"action": simulated.action, "count": outcome.count}
        lines = (outcome.reward, outcome.reward_error, outcome.survival, outcome.survival_error, outcome.chance)
        tails = outcome.open_tails if space.open_ends else outcome.tails
        arrays["simulated_tails"] = np.rint(LEVELS * np.clip(tails, 0.0, 1.0)).astype(np.uint16)
        arrays["simulated_lines"] = np.array(lines, dtype=np.float32)
    return _packed(header, arrays), header


def _of_world(study: WorldStudy) -> dict[str, np.ndarray]:
    s, world, space = study.settings, study.world, study.gamma_space
    length = int(np.ceil(study.horizons[-1] - 1e-9))
    timeline = timeline_of(study, length)
    arrays: dict[str, np.ndarray] = {
        "rewards": world.reward_values,
        "timeline": timeline,
        "optimum": study.truth.optimum,
    }
    clipped = clipped_sensitivities(s, world, timeline)
    if clipped is not None:
        arrays["clipped_thetas"] = clipped
    if world.reward_values.size > MOST_REWARDS:
        return arrays | {"differences": space.differences, "constant": space.constant}
    if study.learned is not None:
        return arrays | {"shared": study.learned}
    arrays |= {kind: basis_of(study, kind) for kind in ("shared", "per_gamma")}
    if s.spacing != "paper":
        grid = np.array(PAPER_GAMMAS)
        arrays |= _transform("paper_", grid, s)
        arrays |= {f"paper_{kind}": _basis(study, world, grid, kind) for kind in ("shared", "per_gamma")}
    # One process whichever discount decides: nothing to mix, and nothing to send twice.
    for name in ("", "paper_"):
        if f"{name}per_gamma" in arrays and np.array_equal(arrays[f"{name}shared"], arrays[f"{name}per_gamma"]):
            del arrays[f"{name}per_gamma"]
    return arrays


def _basis(study: WorldStudy, world: World, gammas: np.ndarray, kind: str) -> np.ndarray:
    if study.policy is not None:
        return reward_indicator_basis(world, study.state, gammas, [study.policy] * gammas.size)
    policies = policies_of(world, gammas, kind, study.settings.acting_gamma)
    return reward_indicator_basis(world, study.state, gammas, policies)


def decoded_for(settings: Resolved) -> dict[str, Any]:
    """The entries of the state of a lens that a timeline which the server has decoded belongs to."""
    s = settings
    names = (*(["alpha"] if SOLVERS[s.solver].has_alpha else []), *_DECODES, *(_READS if s.fold else ()))
    state = state_of(s, float(row_horizons(s.steps, s.time_step)[-1]) if s.horizon is None else s.horizon)
    return {name: state[name] for name in names}


def _decoded(shown: Study) -> dict[str, np.ndarray]:
    """The timeline that the server has decoded, before rescaling, and under ``fold`` the values of all horizons."""
    s = shown.settings
    made = shown.decoded
    if s.normalise != "none":
        made = decode_and_read(shown.gamma_space, replace(s, normalise="none"), row_read(s))
    linear = replace(s, solver=selecting(s.solver))
    matrix = decoder(shown.gamma_space.gammas, linear, rows_decoded(s, row_read(s)))
    arrays = {"decoded": made.tau_space, "decoded_survival": made.survival, "matrix": matrix}
    return arrays | ({"decoded_values": shown.decoded.horizon_values} if s.fold else {})


def _spectrum(gammas: np.ndarray, settings: Resolved) -> Spectrum:
    """The components of the settings' solver, or of the linear one that alpha is chosen by."""
    s = settings
    return spectrum_of(gammas, s.steps, s.time_step, LINEAR[selecting(s.solver)].order, deviations_of(s, gammas))


def _transform(prefix: str, gammas: np.ndarray, settings: Resolved) -> dict[str, np.ndarray]:
    """The components of a transform, cut where the library drops them as rounding, and what else its solver needs."""
    s, spectrum = settings, _spectrum(gammas, settings)
    used = reached(spectrum)
    factors = {
        "gammas": gammas,
        "U": spectrum.U[:, used],
        "s": spectrum.s[spectrum.usable],
        "V": spectrum.rows[:, used],
    }
    if spectrum.weights is not None:
        factors["weights"] = spectrum.weights
    if s.filter != "none":
        factors["smoothing"] = probability_filter(gammas, s.filter_window, s.filter_order)
    if s.solver == FOLLOWS:
        weights = Problem(np.zeros((gammas.size, 1)), gammas, s.steps, s.time_step, deviations_of(s, gammas)).weights
        turn, factors["reduced"] = reduced_system(weights[:, None] * transform_matrix(gammas, s.steps, s.time_step))
        factors["turned"] = turn.T * weights
    return {prefix + name: array for name, array in factors.items()}


def _packed(header: dict[str, Any], arrays: dict[str, np.ndarray]) -> bytes:
    """A length, the header as JSON, and the arrays, each on a multiple of 8 bytes after the header."""
    kinds = {name: {np.float32: "f4", np.uint16: "u2"}.get(array.dtype.type, "f8") for name, array in arrays.items()}
    header["arrays"], data = packed_blocks(
        (name, kinds[name], np.ascontiguousarray(array, dtype=f"<{kinds[name]}").tobytes(), list(array.shape))
        for name, array in arrays.items()
    )
    return pack(header, data)
