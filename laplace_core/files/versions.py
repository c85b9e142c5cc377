"""Versions of what decides the numbers of a result."""

from __future__ import annotations

import contextlib
import platform
import sys
from importlib.metadata import PackageNotFoundError, version

PACKAGES = ("torch", "numpy", "gymnasium", "laplace-core")


def versions() -> dict[str, str]:
    """Versions of Python, of the machine and of the packages that decide the numbers."""
    listed = {"python": platform.python_version(), "machine": f"{sys.platform} {platform.machine()}"}
    for name in PACKAGES:
        with contextlib.suppress(PackageNotFoundError):
            listed[name] = version(name)
    return listed
