"""From gamma-space to tau-space."""

from laplace_core.inverse.linear import (
    LINEAR,
    decode,
    decode_matrix,
    filter_factors,
    iterations_of,
    resolution_matrix,
    rounding_of_rows,
)
from laplace_core.inverse.normalise import NORMALISATIONS, SURVIVAL_FLOOR, normalise_rows
from laplace_core.inverse.problem import Problem, Solution, problem_of
from laplace_core.inverse.selectors import ALPHA_CHOICES, AUTO, SELECTORS, AlphaRecord, choose_alpha
from laplace_core.inverse.solvers import SOLVERS, Solver, is_linear, solve
from laplace_core.inverse.transform import MAX_STEPS, transform_factors, transform_matrix

__all__ = [
    "ALPHA_CHOICES",
    "AUTO",
    "LINEAR",
    "MAX_STEPS",
    "NORMALISATIONS",
    "SELECTORS",
    "SOLVERS",
    "SURVIVAL_FLOOR",
    "AlphaRecord",
    "Problem",
    "Solution",
    "Solver",
    "choose_alpha",
    "decode",
    "decode_matrix",
    "filter_factors",
    "is_linear",
    "iterations_of",
    "normalise_rows",
    "problem_of",
    "resolution_matrix",
    "rounding_of_rows",
    "solve",
    "transform_factors",
    "transform_matrix",
]
