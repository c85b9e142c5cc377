"""What ``import laplace_core`` adds to numpy and scipy, in fresh interpreters."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Iterator

import numpy as np

from bench.fresh import ROOT
from bench.report import Figure, Goal
from bench.timing import interleaved, spread

SUBJECT = "Importing in a fresh interpreter"
STATEMENTS = {
    "base": "import numpy, scipy",
    "submodules": "import numpy, scipy, scipy.sparse.linalg, scipy.special",
    "library": "import numpy, scipy; import laplace_core",
}


def figures(rounds: int = 7) -> Iterator[Figure]:
    processor: dict[str, list[float]] = {name: [] for name in STATEMENTS}
    seconds = interleaved(
        {name: (lambda n=name, s=text: processor[n].append(_run(s)), 1) for name, text in STATEMENTS.items()}, rounds
    )
    base, submodules, library = (seconds[name] for name in STATEMENTS)
    used = {name: np.array(values[1:]) for name, values in processor.items()}  # the first call warms up
    sizes = "whole processes, differences round by round"
    yield Figure(
        SUBJECT, "import laplace_core over numpy and scipy", spread(library - base), "s", sizes, Goal("<", 0.6),
        f"{STATEMENTS['library']!r} less {STATEMENTS['base']!r}",
    )  # fmt: skip
    yield Figure(
        SUBJECT, "the same in processor time", spread(used["library"] - used["base"]), "s", sizes,
        note="what is left of it where other work on the machine is not counted",
    )  # fmt: skip
    yield Figure(
        SUBJECT, "of it scipy's own submodules", spread(submodules - base), "s", sizes,
        note=f"{STATEMENTS['submodules']!r} less {STATEMENTS['base']!r}",
    )  # fmt: skip
    yield Figure(SUBJECT, "of it the library itself", spread(library - submodules), "s", sizes)


def _run(statement: str) -> float:
    """Processor seconds of a fresh interpreter that runs one statement, with bytecode kept as it is by default."""
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
    before = os.times()
    subprocess.run([sys.executable, "-c", statement], cwd=ROOT, env=environment, check=True)
    after = os.times()
    return sum(after[2:4]) - sum(before[2:4])
