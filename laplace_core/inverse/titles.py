"""Titles of solvers and rules for alpha on pages, by their names in ``SOLVERS`` and ``ALPHA_CHOICES``."""

from __future__ import annotations

from collections.abc import Mapping

from laplace_core.inverse.selectors import SELECTORS, TYPED
from laplace_core.inverse.solvers import SOLVERS

SOLVER_TITLES: Mapping[str, str] = {
    "tikhonov": "Tikhonov",
    "tikhonov1": "Tikhonov, first differences",
    "tikhonov2": "Tikhonov, second differences",
    "tsvd": "Truncated SVD",
    "dsvd": "Damped SVD",
    "iterative": "Iterative",
    "nonnegative": "Non-negative",
    "feasible": "Feasible timeline",
    "neural": "Neural network",
}
RULE_TITLES: Mapping[str, str] = {
    TYPED: "By hand",
    "auto": "Automatic",
    "gcv": "GCV",
    "rgcv": "Robust GCV",
    "loo": "Leave one out",
    "aic": "AIC",
    "bic": "BIC",
    "lcurve": "L-curve bend",
    "corner": "L-curve corner",
    "discrepancy": "Discrepancy",
    "ncp": "White residual",
    "quasiopt": "Quasi-optimality",
    "fitted": "Fitted network",
}
assert SOLVER_TITLES.keys() == SOLVERS.keys()
assert RULE_TITLES.keys() == {TYPED, "auto", *SELECTORS}
