"""The controls of the inverse: solver, rule for alpha, and the assumed noise."""

from __future__ import annotations

from dataclasses import dataclass

import streamlit as st

from app import session
from app.components.widgets import field, select
from app.session import store
from laplace_core.inverse import ALPHA_CHOICES, SOLVERS
from laplace_core.inverse.selectors import TYPED
from laplace_core.inverse.titles import RULE_TITLES, SOLVER_TITLES
from laplace_core.study.settings import BY_NAME, Resolved


@dataclass
class _Shown:
    """The alpha that a rule chose for the page: setting alpha by hand begins there.

    Attributes:
        weighting: None where the page has one that does not depend on the rule.
    """

    alpha: float | None = None
    weighting: str | None = None


def shows(settings: Resolved, *, weighting: bool = True) -> None:
    """Note the settings of a study that is drawn.

    Args:
        weighting: whether the weights of the discounts follow the rule on this page.
    """
    shown = session.part(_Shown)
    shown.alpha, shown.weighting = settings.alpha, settings.weighting if weighting else None


def solver_and_rule(settings: Resolved) -> None:
    """Two boxes: the solver, and the rule that chooses its alpha."""
    s = settings
    select(
        "Solver", list(SOLVER_TITLES), store.show("solver", s.solver), SOLVER_TITLES, keep=_solved,
        help=BY_NAME["solver"].help,
    )  # fmt: skip
    rules = [name for name in ALPHA_CHOICES if name != "discrepancy" or s.noise_level or s.noise_levels]
    select(
        "Alpha rule", rules, store.show("selector", s.selector), RULE_TITLES, keep=_ruled,
        disabled=not SOLVERS[s.solver].has_alpha,
        help="Rule that chooses alpha. Drag alpha in a picture to set it by hand. Discrepancy needs a noise level.",
    )  # fmt: skip


def noise_and_weights(settings: Resolved) -> None:
    """The assumed noise, the weights of the discounts, and the filter over them."""
    s = settings
    field(BY_NAME["noise_level"], s.noise_level, "Assumed noise level")
    select(
        "Weights of the discounts", ("deviation", "equal"), store.show("weighting", s.weighting),
        {"deviation": "by their error", "equal": "alike"}, help=BY_NAME["weighting"].help,
    )  # fmt: skip


def discount_filter(settings: Resolved) -> None:
    """The filter over the discounts, and its window."""
    s = settings
    field(BY_NAME["filter"], s.filter, "Filter over the discounts", titles={"none": "none", "savgol": "Savitzky-Golay"})
    if s.filter != "none":
        left, right = st.columns(2)
        field(BY_NAME["filter_window"], s.filter_window, "Window", place=left)
        field(BY_NAME["filter_order"], s.filter_order, "Order", place=right)


def _solved(key: str) -> None:
    """Callback of the solver: a solver without alpha needs no rule."""
    if not SOLVERS[st.session_state[key]].has_alpha and store.chosen().get("selector", TYPED) != TYPED:
        by_hand()
    store.keep(key)


def _ruled(key: str) -> None:
    """Callback of the rule: it takes the place of an alpha that was set by hand; by hand, alpha stays where it is."""
    if st.session_state[key] == TYPED:
        by_hand()
    else:
        store.choose("alpha", None)
        store.choose("selector", st.session_state[key])


def by_hand(alpha: float | None = None) -> None:
    """Set alpha by hand, by default where the page shows it; the weights of the discounts stay as they are."""
    shown = session.part(_Shown)
    if alpha is None and "alpha" not in store.chosen() and shown.alpha is not None:
        alpha = float(f"{shown.alpha:.4g}")
    if alpha is not None:
        store.choose("alpha", alpha)
    store.choose("selector", TYPED)
    if shown.weighting not in (None, "equal"):
        store.choose("weighting", shown.weighting)
