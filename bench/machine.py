"""What about this machine moves the figures."""

from __future__ import annotations

import importlib.util
import os
import platform

import numpy as np
import scipy

_THREADS = ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS")


def machine() -> dict[str, object]:
    """Versions, BLAS, threads, cores and how busy they are; also the BLAS kernel where it is forced by hand."""
    name, threads = _blas()
    facts: dict[str, object] = {
        "python": platform.python_version(),
        "numpy": np.__version__,
        "scipy": scipy.__version__,
        "blas": name,
        "blas_threads": threads,
        "cores": os.cpu_count(),
        "processor": platform.machine(),
    }
    if hasattr(os, "getloadavg"):
        facts["load"] = round(os.getloadavg()[0], 2)
    if "OPENBLAS_CORETYPE" in os.environ:
        facts["OPENBLAS_CORETYPE"] = os.environ["OPENBLAS_CORETYPE"]
    return facts


def line(facts: dict[str, object]) -> str:
    return ", ".join(f"{name.replace('_', ' ') if name.islower() else name} {fact}" for name, fact in facts.items())


def _blas() -> tuple[str, str]:
    """Name and version of numpy's BLAS, and how many threads it uses."""
    if importlib.util.find_spec("threadpoolctl"):
        from threadpoolctl import threadpool_info

        for pool in threadpool_info():
            if pool["user_api"] == "blas":
                name = f"{pool['internal_api']} {pool['version']} ({pool.get('architecture', '?')} kernel)"
                return name, str(pool["num_threads"])
    built = np.show_config(mode="dicts")["Build Dependencies"]["blas"]
    threads = next((f"{os.environ[name]} ({name})" for name in _THREADS if name in os.environ), "not limited")
    return f"{built['name']} {built['version']}", threads
