"""Arrays of a figure as plotly.js reads them."""

from __future__ import annotations

import base64

import numpy as np


def unpacked(packed: dict | list) -> np.ndarray:
    """An array of a figure in JSON: a list, or single floats as base64."""
    if isinstance(packed, list):
        return np.array(packed)
    flat = np.frombuffer(base64.b64decode(packed["bdata"]), dtype="<f4")
    return flat.reshape([int(n) for n in packed["shape"].split(",")]) if "shape" in packed else flat
