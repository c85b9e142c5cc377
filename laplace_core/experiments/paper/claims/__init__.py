"""The catalogue of the paper: every figure, table and claim of it, and what our results say of each."""

from __future__ import annotations

from laplace_core.experiments.paper.claims.deadlines import ACTING, TABLE1
from laplace_core.experiments.paper.claims.entry import STATES, Entry, Found, look
from laplace_core.experiments.paper.claims.trainings import (
    AUXILIARY,
    FIG3,
    FIG7,
    INTERPOLATION,
    MULTIPLEXER,
    NEW_AGENTS,
    PAPER_AGENT,
    TABLE2,
    TERMINATION,
)
from laplace_core.experiments.paper.claims.worlds import ALIASING, FIG1_5, FIG4, FIG6

__all__ = ["ENTRIES", "STATES", "Entry", "Found", "look"]

ENTRIES: tuple[Entry, ...] = (
    FIG1_5, FIG3, FIG4, FIG6, FIG7, TABLE1, TABLE2, AUXILIARY, MULTIPLEXER, INTERPOLATION, PAPER_AGENT, TERMINATION,
    ALIASING, ACTING, NEW_AGENTS,
)  # fmt: skip
"""Figures first, then tables, then what the text claims, in the order of the paper, and what is beyond it."""
