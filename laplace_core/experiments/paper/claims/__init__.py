"""The catalogue of the paper: every figure, table and claim of it, and what our results say of each."""

from __future__ import annotations

from laplace_core.experiments.paper.claims.curves import FIG3
from laplace_core.experiments.paper.claims.deadlines import ACTING, TABLE1
from laplace_core.experiments.paper.claims.entry import MISSING, STATES, Entry, Found, look
from laplace_core.experiments.paper.claims.readings import INTERPOLATION, TERMINATION
from laplace_core.experiments.paper.claims.searches import SEARCH
from laplace_core.experiments.paper.claims.trainings import (
    AUXILIARY,
    FIG7,
    MULTIPLEXER,
    NEW_AGENTS,
    PAPER_AGENT,
    TABLE2,
)
from laplace_core.experiments.paper.claims.worlds import ALIASING, FIG1_5, FIG4, FIG6, TIMESCALES

__all__ = ["ENTRIES", "MISSING", "STATES", "Entry", "Found", "look"]

ENTRIES: tuple[Entry, ...] = (
    FIG1_5, FIG3, FIG4, FIG6, FIG7, TABLE1, TABLE2, AUXILIARY, TIMESCALES, MULTIPLEXER, INTERPOLATION, PAPER_AGENT,
    TERMINATION, ALIASING, ACTING, SEARCH, NEW_AGENTS,
)  # fmt: skip
"""Figures first, then tables, then what the text claims, in the order of the paper, and what is beyond it."""
