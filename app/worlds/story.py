"""The guided story: five views of the toy, from its code to the repair, and a sixth that leads to an own world."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any
from urllib.parse import urlencode

from app.session import store
from laplace_core.exchange.links import query_of
from laplace_core.parameters import Parameter

_TOY: dict[str, Any] = {"world": "two_branch"}
_STEPS: tuple[tuple[str, str, dict[str, Any], str], ...] = (
    ("The toy", "world", {"action": "short"},
     "An agent at 'start' chooses once: 'short' pays 5 now and ends, 'long' pays 10 after three steps. With 3 steps to "
     "go 'long' is best; with fewer, 'short'."),
    ("Its code", "gamma-space", {"action": "long", "alpha": 0.001},
     "The agent learns no timeline. It learns values at many discounts γ (up) and reward thresholds θ (across): "
     "gamma-space. The 10 of 'long' is strong where γ is large, since it comes late."),
    ("The inverse", "tau-space", {"action": "long", "alpha": 0.001},
     "An inverse turns discounts into future steps: tau-space. The white boxes are the truth. Drag α: a small one is "
     "sharp and lets noise through, a large one smears the reward over the steps."),
    ("The artefact", "tau-space", {"action": "short", "normalise": "paper"},
     "'short' pays 5 once, but tau-space shows 5 at every step: each row was rescaled to probability 1, even after the "
     "end. So 'short' seems worth 15, and the choice is wrong."),
    ("The repair", "tau-space", {"action": "short"},
     "Without rescaling, rows after the end are nearly empty: 'short' is worth about 5 and 'long' is chosen. The agent "
     "learned nothing new; only the reading changed."),
    ("Now your own", "tau-space", {},
     "Choose another world in the sidebar, or open 'Bring your own' there: a world file, a table, a timeline drawn by "
     "hand, or a gamma-space that you computed."),
)  # fmt: skip
"""Name, the picture that it is about, what the view sets beside the toy, and what is to be seen."""

STORY = Parameter("story", 0, 0, len(_STEPS), "Step of the guided story; 0 shows none.")


def values_of(step: int) -> dict[str, Any]:
    """Values of the page that show a step."""
    return _TOY | _STEPS[step - 1][2] | {STORY.name: step}


def story(chosen: Mapping[str, Any]) -> dict[str, Any]:
    """The story as the lens shows it: the number of the step, 0 for none, and all steps with their links."""
    steps = [
        {"name": name, "panel": panel, "words": words, "href": f"?{urlencode(query_of(values_of(step)))}"}
        for step, (name, panel, _, words) in enumerate(_STEPS, start=1)
    ]
    return {"at": int(chosen.get(STORY.name, 0)), "steps": steps}


def show(step: int) -> None:
    """Callback: another step, or with 0 the end of the story, which leaves the view as it is."""
    if not 1 <= step <= len(_STEPS):
        store.choose(STORY.name, None)
        return
    store.replace_all(values_of(step))
    store.refresh_sidebar()
