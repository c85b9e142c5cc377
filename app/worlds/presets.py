"""Example views, one click away; some need another world."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import Any

from app.components.lens import Preset
from app.worlds.sources import view_of
from laplace_core.payloads.lens import structure
from laplace_core.payloads.state import state_of
from laplace_core.subjects import View

PRESETS: dict[str, dict[str, Any]] = {
    "Fig. 4b": {"world": "two_branch", "normalise": "paper", "action": "long"},
    "Fig. 4c": {"world": "two_branch", "normalise": "paper", "action": "short"},
    "Fig. 4d": {"world": "two_branch", "p.auxiliary": True, "normalise": "paper", "action": "short"},
    "Fig. 6": {"world": "fig6_chain"},
    "mixed policies": {"world": "two_decisions", "policy": "per_gamma", "action": "go on / long"},
    "what alpha hides": {"world": "double_chain", "alpha": 0.3},
    "deadline flips the choice": {
        "world": "discounting_chain",
        "alpha": 1e-4,
        "horizon": 100.0,
        "action": "pays after 100",
    },
}
"""Values of a page by the name of the view."""


@cache
def _views() -> dict[str, tuple[object, Mapping[str, Any]]]:
    """By name: what of the view does not move in the browser, and the state of its lens; the same for everybody."""
    views: dict[str, tuple[object, Mapping[str, Any]]] = {}
    for name, values in PRESETS.items():
        view = view_of(values)
        s = view.settings
        horizon = s.horizon or s.steps * s.time_step + (1.0 - s.time_step) / 2.0
        state = state_of(s, horizon, action=view.action, look=str(values.get("look", "heatmap")))
        views[name] = structure(s, view.world), state
    return views


def presets_for(view: View) -> list[Preset]:
    exact = view.world is not None and view.learned is None
    here = structure(view.settings, view.world) if exact else None
    return [Preset(name, PRESETS[name], exact and here == there, state) for name, (there, state) in _views().items()]
