"""Garbage collection that skips the objects which stay for ever.

Streamlit would collect in full after every answer (``postScriptGC`` in ``.streamlit/config.toml``). That walks over
all that the imported packages hold and took four fifths of the server's time. Python collects by itself instead.
"""

from __future__ import annotations

import gc
from functools import cache


@cache
def settle(page: str) -> None:
    """Exclude the loaded modules from garbage collection, after the first answer of ``page``."""
    gc.collect()
    gc.freeze()
