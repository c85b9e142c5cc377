"""The verb ``sweep``: one state at many alphas."""

from __future__ import annotations

import argparse
import json

import numpy as np

from laplace_core.cli.options import checked_number
from laplace_core.cli.subject import add_subject, study_of_options
from laplace_core.study.sweep import AlphaSweep, sweep_alpha


def add_sweep(verbs: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """The parser of the verb ``sweep``."""
    sweep = verbs.add_parser(
        "sweep",
        help="one state of a world at many alphas",
        description="What each alpha fits, what every selector makes of it, and how far it is from the truth. "
        "Options are those of decode; without --alpha, discounts are weighted as for a selector.",
    )
    add_subject(sweep)
    sweep.add_argument("--points", metavar="N", help="rows of the table, 2 to 1,000 (default: 25; of --json 200)")
    sweep.add_argument("--json", action="store_true", help="print JSON")
    sweep.set_defaults(run=run_sweep)


def run_sweep(options: argparse.Namespace) -> None:
    """Print the table of one sweep."""
    if options.alpha is None and options.selector is None:
        options.selector = "auto"
    points = None if options.points is None else checked_number("points", options.points, int, 2, high=1_000)
    if options.json:
        found = sweep_alpha(study_of_options(options), points)
        s = found.study.settings
        print(json.dumps({"settings": {**vars(s), "params": dict(s.params)}, **found.as_dict()}, indent=1))
    else:
        print(report(sweep_alpha(study_of_options(options)), points or 25))


def report(found: AlphaSweep, points: int) -> str:
    """The table of a sweep, with the smallest value of each column marked, and what every selector chooses."""
    s, alphas = found.study.settings, found.alphas
    rows = np.unique(np.rint(np.linspace(0, len(alphas) - 1, min(points, len(alphas)))).astype(int))
    columns = {"residual": found.residual, "size": found.size, "dof": found.degrees, **found.curves}
    if found.time_error is not None and found.value_error is not None:
        columns |= {"W1": found.time_error, "error of V": found.value_error}
    lines = [
        f"{s.world}, state {s.state or 0}: solver {s.solver}, {len(alphas)} alphas in singular values of the "
        f"transform, rows weighted {'alike' if s.weighting == 'equal' else 'by the deviation of their error'}",
        f"{'alpha':>9} " + " ".join(f"{name:>11}" for name in columns),
    ]
    for row in rows:
        cells = [f"{values[row]:11.4g}" if np.isfinite(values[row]) else f"{'-':>11}" for values in columns.values()]
        lines.append(f"{alphas[row]:9.3g} " + " ".join(cells))
    record = found.record
    lines.append(f"auto          {record.value:.4g} by {record.criterion}")
    lines += [f"{name:13} {value:.4g}" for name, value in record.others.items()]
    if found.time_error is not None and found.value_error is not None:
        for name, values in (("W1", found.time_error), ("error of V", found.value_error)):
            best = int(np.argmin(values))
            lines.append(f"least {name:7} {values[best]:.4g} at alpha {alphas[best]:.4g}")
    return "\n".join(lines)
