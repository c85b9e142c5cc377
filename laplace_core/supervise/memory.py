"""Memory settings of the C library, of a training and of a server, and the return of free memory to the system.

While training, an update makes dozens of tensors of about a megabyte. By default the C library may fetch each from the
system and hand it back, to be cleared page by page the next time. Kept instead, they leave gaps, as batches have groups
of another size at every update: a run of 300,000 steps on LunarLander grew by more than a gigabyte. So they are kept
between two calls of :func:`give_back`, and a run stays at its size.
"""

from __future__ import annotations

import contextlib
import ctypes
from functools import cache

EVERY = 2_000
"""Transitions between two calls of :func:`give_back`; one takes a few milliseconds."""
_TRIM_THRESHOLD, _MMAP_THRESHOLD = -1, -3  # names of glibc's malloc.h
_LARGEST = 32 << 20  # what glibc takes at most
_OWN_PAGES = 1_000_000


def keep() -> None:
    """Serve tensors of up to 32 MiB from memory that has been freed; nothing where the C library is not glibc."""
    with contextlib.suppress(OSError, AttributeError, TypeError):
        library = ctypes.CDLL(None)
        library.mallopt(_MMAP_THRESHOLD, _LARGEST)
        library.mallopt(_TRIM_THRESHOLD, 1 << 30)


def give_back() -> None:
    """Return free memory to the system; nothing happens where the C library is not glibc."""
    with contextlib.suppress(OSError, AttributeError, TypeError):
        ctypes.CDLL(None).malloc_trim(0)


@cache
def return_large() -> None:
    """Let arrays of a megabyte and more go back to the system when they are dropped.

    The C library would raise that size to 32 MB by itself, and keep what is freed below it in a heap of each thread:
    a server then holds twice what its caches count.
    """
    with contextlib.suppress(OSError, AttributeError, TypeError):
        ctypes.CDLL(None).mallopt(_MMAP_THRESHOLD, _OWN_PAGES)
