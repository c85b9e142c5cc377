"""Long texts as one word, which a link can hold."""

from __future__ import annotations

import base64
import binascii
import zlib

from laplace_core.caching import cached
from laplace_core.errors import InputError

MOST = 2_000_000
"""Bytes that a packed text may unfold to."""


def pack(text: str) -> str:
    """A text as one word for a URL."""
    return base64.urlsafe_b64encode(zlib.compress(text.encode(), 9)).decode().rstrip("=")


@cached(64)
def unpack(word: str) -> str:
    """The text of :func:`pack`; a short word that unfolds without end is stopped.

    Raises:
        InputError: not such a word.
    """
    try:
        data = base64.b64decode(word + "=" * (-len(word) % 4), altchars=b"-_", validate=True)
        unfolding = zlib.decompressobj()
        text = unfolding.decompress(data, MOST)
        if not unfolding.eof:
            raise InputError("the link holds a text that is cut off or far too long; copy it again in full.")
        return text.decode()
    except (binascii.Error, ValueError, zlib.error):
        raise InputError("the link holds a text that was damaged on its way; copy it again in full.") from None
