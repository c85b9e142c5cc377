"""The entries of a lens in a link: the settings of a study that can be drawn, the action, and the look."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from laplace_core.errors import InputError
from laplace_core.exchange.links import Known, Old
from laplace_core.parameters import Parameter
from laplace_core.study.horizon import row_horizons
from laplace_core.study.settings import BY_NAME, Resolved

ACTION = Parameter("action", None, help="Action whose spaces are shown.", kind=str)
LOOK = Parameter("look", "heatmap", help="How the spaces are drawn.", choices=("heatmap", "surface"))

DRAWN: Known = BY_NAME
"""Settings of a study that a page can show: all of them."""

PARAM = "p."
"""Prefix of the parameters of a world, in the session and in the URL."""

Values = Mapping[str, Any]

YES_NO = {"yes": "true", "no": "false"}


OLD_SWITCHES = tuple(Old(name, name, YES_NO) for name in ("fold", "shift", "clip", "paper_grid"))
"""Switches of the lens, of which version 0.2 said yes and no."""


def check_reached(name: str, values: Mapping[str, Any], settings: Resolved) -> None:
    """Refuse a horizon, or steps used of one, that the timeline of a view is too short for.

    Raises:
        InputError: it is.
    """
    last = float(row_horizons(settings.steps, settings.time_step)[-1])
    if float(values[name]) > last:
        raise InputError(f"{name} {values[name]:g} lies beyond the end of the timeline, {last:g}: raise steps.")
