"""Two studies side by side: where their pictures differ, and where their choices do.

A is the pinned study, B the current one; every difference is B - A, on the grid of B.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from laplace_core.errors import InputError
from laplace_core.study.pipeline import Study

Space = Literal["tau_space", "gamma_space"]
SAME = 1e-9
"""Relative tolerance within which two grid points are one."""


@dataclass(frozen=True, eq=False)
class Difference:
    """One action's tau-space or gamma-space in two studies; K rows, M columns.

    Attributes:
        rows: tau in steps of the world, or gamma, ``(K,)``.
        columns: what the bins of tau-space count as, or sensitivities of gamma-space, in reward, ``(M,)``.
        a, b: both on these rows and columns, ``(K, M)``; a tau-space as the probability per step of the world and bin.
        note: how A was brought to the grid of B, for people to read; empty where nothing had to be done.
    """

    what: Space
    rows: np.ndarray
    columns: np.ndarray
    a: np.ndarray
    b: np.ndarray
    note: str = ""

    @property
    def difference(self) -> np.ndarray:
        """B - A, ``(K, M)``."""
        return self.b - self.a


@dataclass(frozen=True, eq=False)
class ValueDifference:
    """Horizon values of one action in two studies, and what each study chooses, over the N horizons of both.

    ``chosen_a`` and ``chosen_b`` are names: the studies may have different actions.
    """

    horizons: np.ndarray
    a: np.ndarray
    b: np.ndarray
    chosen_a: tuple[str, ...]
    chosen_b: tuple[str, ...]

    @property
    def difference(self) -> np.ndarray:
        """B - A, ``(N,)``."""
        return self.b - self.a


def difference(
    a: Study, b: Study, action_a: str | int, action_b: str | int, *, what: Space = "tau_space"
) -> Difference:
    """B - A for one action of each, on the grid of B.

    Where tau-spaces have other sensitivities or time steps, A's probability is moved to the bins of B: what lies in a
    bin is spread over it evenly, and none is lost inside the range of B, nor beyond it if B has open ends. Rows that
    only one has are left out.
    Where gamma-spaces have other sensitivities, A is linear between its own (the same as moving probability); where
    they have other discounts, (1 - gamma) Q is linear in the logarithm of the time constant; never beyond A's ends.

    Raises:
        InputError: an unknown action, or grids that have nothing in common.
    """
    first, second = _action(a, action_a, "A"), _action(b, action_b, "B")
    if what == "gamma_space":
        return _gamma_difference(a, b, first, second)
    return _tau_difference(a, b, first, second)


def value_difference(a: Study, b: Study, action_a: str | int, action_b: str | int) -> ValueDifference:
    """Horizon values of one action of each over the horizons of B that A reaches as well.

    With another time step the values of A are linear between its own horizons, and its choice is the nearest one's.

    Raises:
        InputError: an unknown action, or no horizon in common.
    """
    first, second = _action(a, action_a, "A"), _action(b, action_b, "B")
    common = (b.horizons >= a.horizons[0] - SAME) & (b.horizons <= a.horizons[-1] + SAME)
    if not common.any():
        raise InputError(
            f"A has horizons from {a.horizons[0]:g} to {a.horizons[-1]:g} and B from {b.horizons[0]:g} to "
            f"{b.horizons[-1]:g}: give them more steps to compare values."
        )
    horizons = b.horizons[common]
    values = a.decoded.horizon_values[first]
    nearest = [a.row_at(horizon) for horizon in horizons]
    chosen_a, chosen_b = a.decoded.actions[nearest], b.decoded.actions[common]
    return ValueDifference(
        horizons,
        values[nearest] if _same(a.horizons[nearest], horizons) else np.interp(horizons, a.horizons, values),
        b.decoded.horizon_values[second][common],
        tuple(a.action_names[i] for i in chosen_a),
        tuple(b.action_names[i] for i in chosen_b),
    )


def summary(difference: Difference | None, values: ValueDifference) -> str:
    """One sentence: the largest difference with its place and unit, and over which horizons the choices differ."""
    parts = [] if difference is None else [_largest(difference)]
    parts.append(_choices(values))
    text = "; ".join(parts)
    return f"{text[0].upper()}{text[1:]}."


def rebinned(masses: np.ndarray, edges: np.ndarray, new_edges: np.ndarray) -> np.ndarray:
    """Masses ``(..., M)`` between ``edges`` ``(M+1,)`` moved to those between ``new_edges`` ``(N+1,)``: ``(..., N)``.

    The mass of a bin is spread over it evenly, so that its cumulative sum is linear inside; what lies outside the
    new edges is left out.
    """
    place = np.searchsorted(edges, new_edges, side="right") - 1
    inside = np.clip(place, 0, len(edges) - 2)
    share = np.clip((new_edges - edges[inside]) / (edges[inside + 1] - edges[inside]), 0.0, 1.0)
    cumulative = np.concatenate([np.zeros((*masses.shape[:-1], 1)), np.cumsum(masses, axis=-1)], axis=-1)
    return np.diff(cumulative[..., inside] + share * masses[..., inside], axis=-1)


def _action(study: Study, action: str | int, which: str) -> int:
    if isinstance(action, str) and action in study.action_names:
        return study.action_names.index(action)
    if isinstance(action, str) or not 0 <= action < len(study.action_names):
        names = ", ".join(study.action_names[:6]) + (", ..." if len(study.action_names) > 6 else "")
        raise InputError(f"{which} has no action {str(action)[:40]!r}; choose one of {names}.")
    return int(action)


def _same(one: np.ndarray, other: np.ndarray) -> bool:
    return one.shape == other.shape and np.allclose(one, other, rtol=SAME, atol=SAME * np.ptp(other))


def _tau_difference(a: Study, b: Study, action_a: int, action_b: int) -> Difference:
    step_a, step_b = a.settings.time_step, b.settings.time_step
    masses, notes = a.decoded.tau_space[action_a], []
    edges_a, edges_b = a.gamma_space.bin_edges, b.gamma_space.bin_edges
    if not _same(edges_a, edges_b):
        _check_overlap("sensitivities", a.gamma_space.thetas, b.gamma_space.thetas)
        if b.gamma_space.open_ends:  # whatever lies beyond the sensitivities of B lies in its open ends
            edges_b = edges_b.copy()
            edges_b[0], edges_b[-1] = min(edges_b[0], edges_a[0]), max(edges_b[-1], edges_a[-1])
        total = np.abs(masses).sum()
        inside = rebinned(np.abs(masses), edges_a, edges_b).sum()
        masses = rebinned(masses, edges_a, edges_b)
        notes.append("A's probability was moved to the sensitivities of B")
        if inside < 0.995 * total:
            notes.append(f"{1 - inside / total:.0%} of A lies beyond them and is not shown")
    if step_a != step_b:
        # Row k stands for the time from (k - 1/2) to (k + 1/2) time steps.
        edges = [(np.arange(s.settings.steps + 1) - 0.5) * s.settings.time_step for s in (a, b)]
        rows = int(np.searchsorted(edges[1], edges[0][-1] + SAME, side="right")) - 1
        if rows < 1:
            raise InputError(f"A ends before the first row of B, {step_b:g} steps wide: give A more steps.")
        rows = min(rows, b.settings.steps)
        masses = rebinned(masses.T, edges[0], edges[1][: rows + 1]).T
        notes.append(f"A's rows, {step_a:g} apart in time, were moved to those of B, {step_b:g} apart")
    rows = min(len(masses), b.settings.steps)
    if rows < max(b.settings.steps, a.settings.steps if step_a == step_b else 0):
        notes.append(f"only the {rows} rows are shown that both have")
    return Difference(
        "tau_space",
        b.taus[:rows],
        b.midpoints,
        masses[:rows] / step_b,
        b.decoded.tau_space[action_b, :rows] / step_b,
        _sentence(notes),
    )


def _gamma_difference(a: Study, b: Study, action_a: int, action_b: int) -> Difference:
    one, other, notes = a.gamma_space, b.gamma_space, []
    values = one.values[action_a]
    rows, columns = np.full(other.gammas.size, True), np.full(other.thetas.size, True)
    if not _same(one.thetas, other.thetas):
        columns = _common("sensitivities", one.thetas, other.thetas)
        values = _interpolated(values, one.thetas, other.thetas[columns])
        notes.append("A was interpolated to the sensitivities of B that lie in its range")
    if not _same(one.gammas, other.gammas):
        order = np.argsort(one.gammas)  # a saved gamma-space may have its discounts in any order
        rows = _common("discounts", one.gammas[order], other.gammas)
        gammas = other.gammas[rows]
        scaled = (1.0 - one.gammas[order]) * values[order].T
        values = (_interpolated(scaled, *(np.log(-1.0 / np.log(g)) for g in (one.gammas[order], gammas)))).T
        values = values / (1.0 - gammas)[:, None]
        notes.append("A was interpolated, over the logarithm of the time constant, to the discounts of B in its range")
    return Difference(
        "gamma_space",
        other.gammas[rows],
        other.thetas[columns],
        values,
        other.values[action_b][rows][:, columns],
        _sentence(notes),
    )


def _check_overlap(what: str, one: np.ndarray, other: np.ndarray) -> None:
    if one.max() <= other.min() or one.min() >= other.max():
        raise InputError(
            f"the {what} of A, {one.min():g} to {one.max():g}, and of B, {other.min():g} to {other.max():g}, do not "
            "overlap, so there is no difference map."
        )


def _common(what: str, one: np.ndarray, other: np.ndarray) -> np.ndarray:
    """Which points of ``other`` lie within the range of ``one``, as a mask."""
    slack = SAME * np.ptp(one)
    common = (other >= one.min() - slack) & (other <= one.max() + slack)
    if not common.any():
        raise InputError(
            f"none of the {what} of B, {other.min():g} to {other.max():g}, lies within those of A, {one.min():g} to "
            f"{one.max():g}, so there is no difference map."
        )
    return common


def _interpolated(values: np.ndarray, points: np.ndarray, wanted: np.ndarray) -> np.ndarray:
    """Linear interpolation along the last axis: ``(..., M)`` at ``points`` to ``(..., N)``."""
    left = np.clip(np.searchsorted(points, wanted, side="right") - 1, 0, len(points) - 2)
    share = np.clip((wanted - points[left]) / (points[left + 1] - points[left]), 0.0, 1.0)
    return (1.0 - share) * values[..., left] + share * values[..., left + 1]


def _sentence(notes: list[str]) -> str:
    text = "; ".join(notes)
    return f"{text[0].upper()}{text[1:]}." if text else ""


def _largest(difference: Difference) -> str:
    name = difference.what.replace("_", "-")
    change = difference.difference
    row, column = np.unravel_index(np.argmax(np.abs(change)), change.shape)
    largest, scale = change[row, column], max(1.0, float(np.abs(difference.b).max()))
    if abs(largest) <= SAME * scale:
        return f"A and B show the same {name}"
    if difference.what == "tau_space":
        place, unit = f"tau = {difference.rows[row]:g}, reward {difference.columns[column]:.3g}", "in probability"
    else:
        place = f"gamma = {difference.rows[row]:.3g}, theta = {difference.columns[column]:.3g}"
        unit = "rewards above theta, discounted"
    values = f"A {difference.a[row, column]:.3g}, B {difference.b[row, column]:.3g}"
    return f"the largest change of the {name} is {largest:+.3g} {unit}, at {place} ({values})"


def _choices(values: ValueDifference, most: int = 3) -> str:
    """Where the chosen names differ, as runs of horizons."""
    pairs = list(zip(values.chosen_a, values.chosen_b, strict=True))
    runs: list[tuple[int, int]] = []
    for i, pair in enumerate(pairs):
        if runs and pair == pairs[runs[-1][0]]:
            runs[-1] = (runs[-1][0], i)
        else:
            runs.append((i, i))
    apart = [run for run in runs if pairs[run[0]][0] != pairs[run[0]][1]]
    if not apart:
        return f"both choose the same action at {_span(values.horizons, 0, len(pairs) - 1)}"
    parts = [
        f"at {_span(values.horizons, *run)} A chooses {pairs[run[0]][0]}, B {pairs[run[0]][1]}" for run in apart[:most]
    ]
    return ", ".join(parts) + (", and so on" if len(apart) > most else "")


def _span(horizons: np.ndarray, first: int, last: int) -> str:
    until = f"-{horizons[last]:g}" if last > first else ""
    return f"T = {horizons[first]:g}{until}"
