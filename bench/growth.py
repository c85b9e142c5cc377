"""Solving in fresh processes: one known world within its bounds, and growth with the number of states."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from bench.fresh import fresh_study
from bench.report import Figure, Goal
from bench.timing import spread

SIDES = (10, 20, 40, 60)
TAXI = "Exact solve of gym:Taxi in a fresh process"
GROWTH = "Growth over cliff_grid, slip 0.1, in fresh processes"


def figures() -> Iterator[Figure]:
    yield from _taxi()
    yield from _growth()


def _taxi(rounds: int = 5) -> Iterator[Figure]:
    runs = [fresh_study("gym:Taxi", {}, 100, 250) for _ in range(rounds)]
    build, study, peak, imported = _columns(runs, "build", "study", "peak_mb", "imported_mb")
    sizes = f"{runs[0]['states']} states, 6 actions, 100 discounts x 250 sensitivities, one state shown"
    split = f"building the world (imports gymnasium) {np.median(build):.2f} s, study {np.median(study):.2f} s "
    split += "(policy, basis, encoding, truth, decoding, reading)"
    yield Figure(TAXI, "Taxi: seconds, world and study", spread(build + study), "s", sizes, Goal("<", 3), split)
    yield Figure(TAXI, "Taxi: peak memory of the process", spread(peak), "MB", sizes, Goal("<", 400))
    yield Figure(TAXI, "Taxi: of it above the interpreter with imports", spread(peak - imported), "MB", sizes)


def _growth(rounds: int = 3) -> Iterator[Figure]:
    turns = [[fresh_study("cliff_grid", _square(side), 30, 150) for side in SIDES] for _ in range(rounds)]
    for side, runs in zip(SIDES, zip(*turns, strict=True), strict=True):
        build, study, peak = _columns(runs, "build", "study", "peak_mb")
        sizes = f"{runs[0]['states']:,} states, 4 actions, 30 discounts x 150 sensitivities"
        note = f"building the world {np.median(build):.3f} s, study {np.median(study):.3f} s; "
        note += f"peak memory {np.median(peak):.0f} MB"
        yield Figure(GROWTH, f"{side} x {side}: seconds, world and study", spread(build + study), "s", sizes, note=note)
    states = np.array([run["states"] for run in turns[0]])
    over = f"{states[0]:,} to {states[-1]:,} states"
    for name in ("build", "study"):
        seconds = np.array([[run[name] for run in turn] for turn in turns])
        fitted = [exponent(states, row) for row in seconds]
        last = np.median([exponent(states[-2:], row[-2:]) for row in seconds])
        note = f"{last:.2f} between the two largest, where fixed costs count least"
        yield Figure(GROWTH, f"exponent of {name} time in states", spread(fitted), "", over, note=note)


def exponent(sizes: np.ndarray, seconds: np.ndarray) -> float:
    """p of the least-squares fit seconds = c * sizes^p."""
    return float(np.polyfit(np.log(sizes), np.log(seconds), 1)[0])


def _square(side: int) -> dict[str, object]:
    return {"width": side, "height": side, "slip": 0.1}


def _columns(runs, *names: str) -> list[np.ndarray]:
    return [np.array([run[name] for run in runs]) for name in names]
