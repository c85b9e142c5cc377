"""Numbers and their spread as the catalogue words them."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np


def number(value: float) -> str:
    """One digit behind the point from 10 on, two below; whole numbers of thousands with a comma."""
    digits = 1 if abs(value) >= 9.995 else 2
    text = f"{value:,.{digits}f}"
    return text if float(text.replace(",", "")) else text.lstrip("-")


def fraction(value: float) -> str:
    """A small error or distance, to four places."""
    return f"{value:.4f}".rstrip("0").rstrip(".") or "0"


def spread(values: Sequence[float], seeds: str = "seeds") -> str:
    """The mean of seeds, the lowest and the highest, and how many they are."""
    if len(values) == 1:
        return f"{number(values[0])} (1 {seeds.removesuffix('s')})"
    return f"{number(float(np.mean(values)))} ({number(min(values))} to {number(max(values))}, {len(values)} {seeds})"


def within(mean: float, interval: Sequence[float]) -> str:
    """A mean and its 95% interval."""
    low, high = interval
    return f"{number(mean)} ({number(low)} to {number(high)})"


def listed(words: Sequence[str]) -> str:
    """``a``, ``a and b``, ``a, b and c``."""
    return words[0] if len(words) == 1 else f"{', '.join(words[:-1])} and {words[-1]}"
