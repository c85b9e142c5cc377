"""Views worth seeing, one click away; some need another world."""

from __future__ import annotations

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


def presets_for(view: View) -> list[Preset]:
    presets = []
    for name, values in PRESETS.items():
        other = view_of(values)
        last = other.settings.steps * other.settings.time_step
        horizon = other.settings.horizon or last + (1.0 - other.settings.time_step) / 2.0
        exact = view.world is not None and view.learned is None
        same = exact and structure(view.settings, view.world) == structure(other.settings, other.world)
        state = state_of(other.settings, horizon, action=other.action, look=str(values.get("look", "heatmap")))
        presets.append(Preset(name, values, same, state))
    return presets
