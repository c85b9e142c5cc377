"""The state of the lens: what its controls hold, as values of a page and back."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from laplace_core import Study
from laplace_core.code.interpolation import MOST_ADDED
from laplace_core.inverse.selectors import TYPED
from laplace_core.parameters import Parameter
from laplace_core.study.settings import BY_NAME, Resolved

ADDED = Parameter("added", 0, 0, MOST_ADDED, "Interpolated discounts between any two that were trained.")
"""What the page of trained agents adds to the settings of the study."""

_SAME = (
    "alpha", "selector", "slope", "softness", "noise", "noise_seed", "normalise", "value_gamma", "used", "fold",
    "shift", "clip", "paper_grid", "slope_share",
)  # fmt: skip
"""Settings that a state holds by their own name."""
LIVE = (*_SAME, "horizon", "policy", "deadline", "added")
"""Values of a page that the lens sets, and that its Reset takes back."""


def state_of(
    settings: Resolved, horizon: float, *, action: int = 0, look: str = "heatmap", added: int = 0
) -> dict[str, Any]:  # fmt: skip
    """The state that shows resolved settings as they are."""
    state = {name: getattr(settings, name) for name in _SAME}
    state |= {"slope": settings.slope or 1.0, "paper_grid": bool(settings.paper_grid), "clip": bool(settings.clip)}
    state |= {"mixed": settings.policy == "per_gamma", "constant": settings.deadline == "constant"}
    return state | {"horizon": horizon, "added": added, "action": action, "look": look}


def values_of(state: Mapping[str, Any], before: Mapping[str, Any], actions: tuple[str, ...]) -> dict[str, Any]:
    """The values of a page that a released state changes against the state before; None takes one back."""
    new = {name: state[name] for name in state if state[name] != before.get(name)}
    values = {name: new[name] for name in (*_SAME, "horizon", "added", "look") if name in new}
    values |= {name: None for name, value in values.items() if value is False}
    if state["selector"] != TYPED:
        values |= {"alpha": None} if "alpha" in values else {}  # whatever the rule makes of it
    elif "selector" in new:
        values |= {"selector": None, "alpha": state["alpha"]}
    if "action" in new:
        values["action"] = actions[new["action"]]
    if "mixed" in new:
        values["policy"] = "per_gamma" if new["mixed"] else "shared"
    if "constant" in new:
        values["deadline"] = "constant" if new["constant"] else "time_to_go"
    return values


def checked(reported: object, study: Study) -> dict[str, Any]:
    """A state from the browser, every value of its kind and in its range; what is not is taken from the study."""
    state = state_of(study.settings, float(study.horizons[-1]))
    if not isinstance(reported, Mapping):
        return state
    last, actions = float(study.horizons[-1]), len(study.action_names)
    limits = {name: BY_NAME[name].bounds for name in _SAME if BY_NAME[name].type in (int, float)}
    limits |= {"horizon": (0, last), "used": (0, last), "added": (0, MOST_ADDED), "action": (0, actions - 1)}
    words = {name: BY_NAME[name].choices for name in ("normalise", "selector")} | {"look": ("heatmap", "surface")}
    for name, value in reported.items():
        if name in state and isinstance(state[name], bool):
            state[name] = value if isinstance(value, bool) else state[name]
        elif name in limits and isinstance(value, int | float) and not isinstance(value, bool):
            low, high = limits[name]
            if low <= value <= high:
                state[name] = int(value) if name in ("noise_seed", "action", "added") else float(value)
        elif name in words and value in words[name]:
            state[name] = value
    return state
