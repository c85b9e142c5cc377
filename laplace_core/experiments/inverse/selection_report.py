"""The table of a study of the inverse, summed up: how near each selector comes to the best alpha, and what it costs."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np

from laplace_core.experiments.inverse.selection import NO_SELECTOR

NEAR = 1.3
"""A selector is near the best alpha where its distance is at most this times the least."""
NOTHING = 1e-6
"""Distances below this, in steps, count as this: ratios of two perfect pictures mean nothing."""


def summed(rows: Iterable[Mapping[str, str]], by: Sequence[str] = ("solver", "selector")) -> list[dict[str, Any]]:
    """One entry for each solver and selector, or by other columns as well, in the order in which they come.

    Returns:
        how many ``cases``; ``ratio``, distance over that of the best alpha, and ``excess``, regret over that of the
        best alpha, with median and nine tenths; ``near``, the share of cases with a ratio of at most ``NEAR``;
        ``distance`` and ``regret``, medians and nine tenths themselves.
    """
    groups: dict[tuple[str, ...], list[Mapping[str, str]]] = {}
    for row in rows:
        groups.setdefault(tuple(row[name] for name in by), []).append(row)
    entries = []
    for group, members in groups.items():
        distance, least, regret, at_least = (
            np.array([float(row[name]) for row in members])
            for name in ("distance", "least", "regret", "regret_at_least")
        )
        ratio = np.maximum(distance, NOTHING) / np.maximum(least, NOTHING)
        spread = {"ratio": ratio, "excess": regret - at_least, "distance": distance, "regret": regret}
        entries.append(
            dict(zip(by, group, strict=True))
            | {"cases": len(members), "near": float(np.mean(ratio <= NEAR))}
            | {name: {"median": float(np.median(each)), "nine tenths": float(np.quantile(each, 0.9)),
                      "mean": float(each.mean())} for name, each in spread.items()}
        )  # fmt: skip
    return entries


def table(entries: Sequence[Mapping[str, Any]], by: Sequence[str] = ("solver", "selector")) -> str:
    """The entries of :func:`summed` as text: medians, and in brackets nine tenths."""
    widths = [max(len(name), *(len(str(entry[name])) for entry in entries)) for name in by]
    names = "  ".join(f"{name:{width}}" for name, width in zip(by, widths, strict=True))
    lines = [f"{names}  {'cases':>6} {'of the least distance':>22} {f'within {NEAR}':>11} {'excess regret':>18} "
             f"{'distance':>16} {'regret':>18}"]  # fmt: skip
    for entry in entries:
        words = "  ".join(f"{entry[name]!s:{width}}" for name, width in zip(by, widths, strict=True))
        cells = {
            name: f"{entry[name]['median']:.3g} ({entry[name]['nine tenths']:.3g})"
            for name in ("ratio", "excess", "distance", "regret")
        }
        near = "" if entry.get("selector") == NO_SELECTOR else f"{entry['near']:.1%}"
        lines.append(
            f"{words}  {entry['cases']:6} {cells['ratio']:>22} {near:>11} {cells['excess']:>18} "
            f"{cells['distance']:>16} {cells['regret']:>18}"
        )
    return "\n".join(lines)
