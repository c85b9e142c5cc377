"""From gamma-space to tau-space."""

from laplace_core.inverse.normalise import NORMALISATIONS, SURVIVAL_FLOOR, normalise_rows
from laplace_core.inverse.tikhonov import (
    decode,
    decode_matrix,
    filter_factors,
    resolution_matrix,
    rounding_of_rows,
)
from laplace_core.inverse.transform import MAX_STEPS, transform_factors, transform_matrix

__all__ = [
    "MAX_STEPS",
    "NORMALISATIONS",
    "SURVIVAL_FLOOR",
    "decode",
    "decode_matrix",
    "filter_factors",
    "normalise_rows",
    "resolution_matrix",
    "rounding_of_rows",
    "transform_factors",
    "transform_matrix",
]
