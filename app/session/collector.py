"""Python's collector of garbage, kept from what stays for ever.

Streamlit would collect in full after every answer (``postScriptGC`` in ``.streamlit/config.toml``). That walks over
all that the imported packages hold and took four fifths of the server's time. Python collects by itself instead.
"""

from __future__ import annotations

import gc
from functools import cache


@cache
def settle(page: str) -> None:
    """After the first answer of ``page``, whose modules are loaded by now: no collection looks at them again."""
    gc.collect()
    gc.freeze()
