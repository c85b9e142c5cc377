"""Small parts of sentences that are put together from numbers and names."""

from __future__ import annotations


def capital(words: str) -> str:
    """Words as the beginning of a sentence."""
    return words[:1].upper() + words[1:]


def steps(count: int) -> str:
    """A number of steps, in words."""
    return f"{count} step" + ("" if count == 1 else "s")
