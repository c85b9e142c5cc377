"""Text values of a link: parsing as strict as the command line's, and long texts packed into one word."""

from __future__ import annotations

import base64
import binascii
import zlib
from collections.abc import Mapping
from functools import lru_cache
from typing import Any

from laplace_core import InputError
from laplace_core.parameters import Parameter

LONGEST = 7_000
"""Characters of a link's values; proxies and chat programs cut much longer ones off."""
_MOST = 2_000_000  # characters that a packed text may unfold to


def pack(text: str) -> str:
    """A text as one word for a URL."""
    return base64.urlsafe_b64encode(zlib.compress(text.encode(), 9)).decode().rstrip("=")


@lru_cache(maxsize=64)
def unpack(word: str) -> str:
    """The text of :func:`pack`; a short word that unfolds without end is stopped.

    Raises:
        InputError: not such a word.
    """
    try:
        data = base64.b64decode(word + "=" * (-len(word) % 4), altchars=b"-_", validate=True)
        unfolding = zlib.decompressobj()
        text = unfolding.decompress(data, _MOST)
        if not unfolding.eof:
            raise InputError("the link holds a text that is cut off or far too long; copy it again in full.")
        return text.decode()
    except (binascii.Error, ValueError, zlib.error):
        raise InputError("the link holds a text that was damaged on its way; copy it again in full.") from None


def fits(query: Mapping[str, str]) -> bool:
    return sum(map(len, query.values())) <= LONGEST


_OLD_SWITCHES = ("fold", "shift", "clip", "paper_grid")


def translated(query: Mapping[str, str]) -> dict[str, str]:
    """A link as it is written today: those of version 0.2 say yes and no of some switches."""
    words = {"yes": "true", "no": "false"}
    return {name: words.get(text, text) if name in _OLD_SWITCHES else text for name, text in query.items()}


def read_values(
    query: Mapping[str, str], known: Mapping[str, Parameter], read: tuple[str, ...] = ()
) -> tuple[dict[str, Any], list[str]]:
    """Values of the entries that a page knows, and a note about every other one.

    Args:
        read: entries that were dealt with before.
    """
    found, notes = {}, []
    for name, text in query.items():
        if name in read:
            continue
        if name not in known:
            notes.append(f"The link has an entry {name[:40]!r} that means nothing here.")
            continue
        try:
            found[name] = known[name].parse(text)
        except InputError as error:
            notes.append(f"Left out of the link: {error}")
    return found, notes
