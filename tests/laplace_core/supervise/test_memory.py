"""Freed memory is kept between two updates: seen by how often the system has to hand out a page."""

from __future__ import annotations

import os
import platform
import subprocess
import sys

import pytest

_PROGRAM = """
import resource, sys
import torch
from laplace_core.supervise import memory
if sys.argv[1] == "kept":
    memory.keep()
for _ in range(2):
    [torch.ones(1 << 20) for _ in range(10)]
before = resource.getrusage(resource.RUSAGE_SELF).ru_minflt
for _ in range(5):
    [torch.ones(1 << 20) for _ in range(10)]
print(resource.getrusage(resource.RUSAGE_SELF).ru_minflt - before)
"""


_LIMITS = {"MALLOC_MMAP_THRESHOLD_": "131072", "MALLOC_TRIM_THRESHOLD_": "131072"}
"""Those that glibc begins with. Held fast, or it may raise them by itself, and keeps memory in some processes."""


def _pages(how: str) -> int:
    done = subprocess.run(
        [sys.executable, "-c", _PROGRAM, how], capture_output=True, text=True, check=True, env=os.environ | _LIMITS
    )
    return int(done.stdout)


@pytest.mark.long
@pytest.mark.skipif(platform.libc_ver()[0] != "glibc", reason="only glibc is told how to keep memory")
def test_tensors_are_made_of_the_pages_of_the_last_ones():
    """Fifty tensors of 4 MiB, of 1,024 pages each: all are fetched unless they are kept, and then at most a few."""
    assert _pages("kept") < 5 * 1_024
    assert _pages("by default") >= 40 * 1_024
