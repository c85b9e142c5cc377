"""The state of the lens: what its controls hold, as values of a page and back."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from laplace_core import Study
from laplace_core.interpolation import MOST_ADDED
from laplace_core.parameters import Parameter
from laplace_core.settings import Resolved

VIEW = (
    Parameter("value_gamma", None, 1e-6, 0.999999, "Discount of the values that are compared.", float),
    Parameter("used", 0.0, 0, 2000, "Steps of the episode that are over."),
    Parameter("fold", "no", 0, 0, "Whether only as many rows are decoded as the horizon has.", str, ("no", "yes")),
    Parameter("paper_grid", "no", 0, 0, "Whether the paper's 15 discounts are used.", str, ("no", "yes")),
    Parameter("clip", "no", 0, 0, "Whether the sensitivities begin at a reward that occurs.", str, ("no", "yes")),
    Parameter("shift", "no", 0, 0, "Whether rows are stored one index too high.", str, ("no", "yes")),
)
"""What the lens adds to the values of a page; the rest of its state are settings of the study."""

NETWORK = (
    Parameter("slope_share", 1.0, 0.05, 1, "Slope of the activation, as a share of the one that was trained."),
    Parameter("added", 0, 0, MOST_ADDED, "Interpolated discounts between any two that were trained."),
)
"""What it adds on a network's gamma-space: what a world has exactly is there a linear map of what was learned."""

_SETTINGS = ("alpha", "slope", "softness", "noise", "noise_seed", "normalise")
_OWN = ("value_gamma", "used", "slope_share", "added")
LIVE = (*_SETTINGS, "horizon", "policy", "deadline", *(parameter.name for parameter in (*VIEW, *NETWORK)))
"""Values of a page that the lens sets, and that its Reset takes back."""


def opening_state(study_settings: Resolved, horizon: float, action: int = 0, look: str = "heatmap") -> dict:
    """The state that shows resolved settings as they are."""
    s = study_settings
    return {
        "alpha": s.alpha,
        "slope": s.slope or 1.0,
        "horizon": horizon,
        "softness": s.softness,
        "value_gamma": s.acting_gamma,
        "noise": s.noise,
        "noise_seed": s.noise_seed,
        "normalise": s.normalise,
        "fold": False,
        "mixed": s.policy == "per_gamma",
        "paper_grid": False,
        "clip": False,
        "constant": s.deadline == "constant",
        "used": 0.0,
        "shift": False,
        "slope_share": 1.0,
        "added": 0,
        "action": action,
        "look": look,
    }


def state_of(values: Mapping[str, Any], settings: Resolved, horizon: float, action: int) -> dict:
    """The state for the values of a page, whose settings are resolved."""
    state = opening_state(settings, horizon, action, str(values.get("look", "heatmap")))
    state |= {name: values[name] for name in _OWN if values.get(name) is not None}
    return state | {name: values.get(name) == "yes" for name in ("fold", "paper_grid", "clip", "shift")}


def values_of(state: Mapping[str, Any], before: Mapping[str, Any], actions: tuple[str, ...]) -> dict[str, Any]:
    """The values of a page that a released state changes against the state before; None takes one back."""
    new = {name: state[name] for name in state if state[name] != before.get(name)}
    values = {name: new[name] for name in (*_SETTINGS, "horizon", *_OWN, "look") if name in new}
    values |= {name: "yes" if new[name] else None for name in ("fold", "paper_grid", "clip", "shift") if name in new}
    if "action" in new:
        values["action"] = actions[new["action"]]
    if "mixed" in new:
        values["policy"] = "per_gamma" if new["mixed"] else "shared"
    if "constant" in new:
        values["deadline"] = "constant" if new["constant"] else "time_to_go"
    return values


def checked(heard: object, study: Study) -> dict[str, Any]:
    """A state from the browser, every value of its kind and in its range; what is not is taken from the study."""
    found = opening_state(study.settings, float(study.horizons[-1]))
    if not isinstance(heard, Mapping):
        return found
    last, actions = float(study.horizons[-1]), len(study.action_names)
    limits = {
        "alpha": (0, 1e6),
        "slope": (1e-12, 1e12),
        "horizon": (0, last),
        "softness": (0, 10),
        "used": (0, last),
        "value_gamma": (1e-6, 0.999999),
        "noise": (0, 1),
        "noise_seed": (0, 2**31 - 1),
        "slope_share": (0.05, 1),
        "added": (0, MOST_ADDED),
        "action": (0, actions - 1),
    }
    words = {"normalise": ("none", "survival", "paper"), "look": ("heatmap", "surface")}
    for name, value in heard.items():
        if name in limits and isinstance(value, int | float) and not isinstance(value, bool):
            low, high = limits[name]
            if low <= value <= high:
                found[name] = int(value) if name in ("noise_seed", "action", "added") else float(value)
        elif (name in words and value in words[name]) or (
            name in found and isinstance(found[name], bool) and isinstance(value, bool)
        ):
            found[name] = value
    return found
