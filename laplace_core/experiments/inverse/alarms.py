"""Alarm rates of the test of consistency: on consistent gamma-spaces, and on three inconsistent kinds."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np

from laplace_core.code.gamma_space import GammaSpace
from laplace_core.experiments.inverse.spaces import NOISES, Space, draw_space, one_action, seeds_of
from laplace_core.inverse.consistency import LEVEL, Consistency, check_noise, check_seeds
from laplace_core.study.pipeline import encoded_under
from laplace_core.supervise.parallel import in_order

KINDS = ("consistent", "mixed policies", "one wrong discount", "values times 1.2")
SEEDS = 8
WRONG = 1.1
"""What the values of one discount are multiplied by to be wrong."""
MOST_FALSE = 0.07


def report(cases: int, seed: int, jobs: int = 1) -> tuple[dict[str, Any], str]:
    """Numbers and text: the share of alarms of each kind, with noise known and estimated from eight seeds.

    Args:
        jobs: processes at a time; the numbers do not depend on them.
    """
    rows: list[dict[str, Any]] = []
    for kind in KINDS:
        count = cases if kind == "consistent" else max(1, cases // 10)
        for known in (True, False):
            found = list(in_order(partial(_case, kind, seed, known=known), range(count), jobs))
            for noise in NOISES:
                p_values, blamed = zip(*[(p, b) for at, p, b in found if at == noise], strict=True)
                rows.append(
                    {
                        "kind": kind, "noise_known": known, "noise": noise, "cases": len(p_values),
                        "alarms": int((np.array(p_values) <= LEVEL).sum()), "blamed": int(sum(blamed)),
                    }
                )  # fmt: skip
    lines = [
        f"Alarms of the test of consistency at the {LEVEL:.0%} level, random worlds (seed {seed})",
        f"{'':20} {'noise':>14} {'at 1e-4':>14} {'at 1e-3':>14} {'at 1e-2':>14} {'all':>14}",
    ]
    for kind in KINDS:
        for known in (True, False):
            mine = [r for r in rows if r["kind"] == kind and r["noise_known"] == known]
            cells = [f"{r['alarms']}/{r['cases']} {r['alarms'] / max(1, r['cases']):.1%}" for r in [*mine, _sum(mine)]]
            lines.append(
                f"{kind:20} {'known' if known else f'from {SEEDS} seeds':>14}" + "".join(f" {c:>14}" for c in cells)
            )
            if kind == "one wrong discount":
                right = sum(r["blamed"] for r in mine)
                lines.append(
                    f"{'':20} {'':>14} the wrong one is blamed first in {right} of {_sum(mine)['alarms']} alarms"
                )
    return {"seed": seed, "rows": rows}, "\n".join(lines)


def _sum(rows: list[dict[str, Any]]) -> dict[str, Any]:
    return {name: sum(r[name] for r in rows) for name in ("alarms", "cases")}


def shortfalls(numbers: dict[str, Any]) -> list[str]:
    """Missed goals: too many false alarms, by how the noise was known."""
    missed = []
    for known in (True, False):
        total = _sum([r for r in numbers["rows"] if r["kind"] == "consistent" and r["noise_known"] == known])
        if total["alarms"] > MOST_FALSE * total["cases"]:
            missed.append(f"false alarms, noise {'known' if known else 'estimated'}")
    return missed


def _case(kind: str, seed: int, number: int, *, known: bool) -> tuple[float, float, bool]:
    """The noise, the p-value, and whether the alarm blames the discount that is wrong before all others."""
    rng = np.random.default_rng([seed, 2, known, number])
    space = draw_space(rng)
    action, at = int(rng.integers(space.world.n_actions)), int(rng.integers(len(space.exact.gammas)))
    values = _spoilt(space, kind, action, at)
    noise = float(rng.choice(NOISES))
    found = _tested(values, space.deviations(noise), rng, number, known=known)
    blamed = found.blamed()
    first = bool(blamed.size) and blamed[0] == values.gammas[at] and kind == "one wrong discount"
    return noise, found.p_value, first


def _spoilt(space: Space, kind: str, action: int, at: int) -> GammaSpace:
    if kind == "mixed policies":
        return one_action(encoded_under(space.study, "per_gamma"), action)
    values = one_action(space.exact, action)
    if kind == "consistent":
        return values
    factor = np.ones(len(values.gammas))
    factor[slice(None) if kind == "values times 1.2" else at] = 1.2 if kind == "values times 1.2" else WRONG
    return replace(values, values=values.values * factor[:, None], constant=values.constant * factor)


def _tested(
    space: GammaSpace, deviations: np.ndarray, rng: np.random.Generator, number: int, *, known: bool
) -> Consistency:
    values, constant = seeds_of(space, deviations, 1 if known else SEEDS, rng)
    if known:
        return check_noise(replace(space, values=values[0], constant=constant[0]), deviations, seed=number)
    return check_seeds(values, constant, space, seed=number)
