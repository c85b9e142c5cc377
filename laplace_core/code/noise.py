"""Normal noise by counting: the same numbers from a few lines in any language.

The browser adds the noise that the library adds, so the n-th number of a seed is a function of both and no generator
is passed along: two 32-bit hashes make two uniform numbers, and Box and Muller's transform makes them normal.
"""

from __future__ import annotations

import numpy as np

_SALT = np.uint32(0x9E3779B9)


def _hashed(x: np.ndarray) -> np.ndarray:
    """A bijection of the 32-bit integers that scatters neighbours (Wellons' lowbias32)."""
    x = x ^ (x >> np.uint32(16))
    x = x * np.uint32(0x7FEB352D)
    x = x ^ (x >> np.uint32(15))
    x = x * np.uint32(0x846CA68B)
    return x ^ (x >> np.uint32(16))


def normal_noise(seed: int, shape: tuple[int, ...], skip: int = 0) -> np.ndarray:
    """Independent standard normal numbers, the ones from number ``skip`` on of a seed's stream, in row-major order."""
    count = int(np.prod(shape))
    first = _hashed(np.array([seed & 0xFFFFFFFF], dtype=np.uint32) ^ _SALT)
    numbers = (np.arange(skip, skip + count, dtype=np.uint64) & np.uint64(0x7FFFFFFF)).astype(np.uint32) * np.uint32(2)
    radius, angle = _hashed(first + numbers), _hashed(first + numbers + np.uint32(1))
    # Half a step keeps the logarithm finite.
    lengths = np.sqrt(-2.0 * np.log((radius + 0.5) / 2.0**32))
    return (lengths * np.cos(2.0 * np.pi * angle / 2.0**32)).reshape(shape)
