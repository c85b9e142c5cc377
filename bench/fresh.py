"""One world, solved in a process of its own: cold caches and a peak of memory that belongs to nobody else.

The measuring process is ``python -m bench.fresh JSON``; :func:`fresh_study` starts it and reads its one line.
"""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path
from time import perf_counter

from laplace_core import Settings, load_world, study

ROOT = Path(__file__).resolve().parents[1]


def fresh_study(world: str, params: Mapping[str, object], gammas: int, thetas: int) -> dict[str, float]:
    """Seconds and megabytes of one study in a fresh process; the fields are those of :func:`_measure`."""
    asked = json.dumps({"world": world, "params": params, "gammas": gammas, "thetas": thetas})
    command = [sys.executable, "-m", "bench.fresh", asked]
    return json.loads(subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True).stdout)


def _measure(world: str, params: Mapping[str, object], gammas: int, thetas: int) -> dict[str, float]:
    imported = _peak_megabytes()
    started = perf_counter()
    built = load_world(world, params)
    loaded = perf_counter()
    study(built, Settings(world=world, gammas=gammas, thetas=thetas))
    return {
        "states": built.n_states,
        "build": loaded - started,
        "study": perf_counter() - loaded,
        "imported_mb": imported,
        "peak_mb": _peak_megabytes(),
    }


def _peak_megabytes() -> float:
    """Largest resident memory of this process so far, in 10^6 bytes.

    Linux hands ``ru_maxrss`` of the PARENT on through fork and exec, so that a child of a large process
    looks large; VmHWM is the child's own.
    """
    status = Path("/proc/self/status")
    if status.exists():
        words = status.read_text().split()
        return int(words[words.index("VmHWM:") + 1]) * 1024 / 1e6
    import resource

    unit = 1 if sys.platform == "darwin" else 1024
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * unit / 1e6


if __name__ == "__main__":
    print(json.dumps(_measure(**json.loads(sys.argv[1]))))
