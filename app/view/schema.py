"""What the links of all pages with a lens may hold beside the settings of the study."""

from __future__ import annotations

from app.session.url import Old
from laplace_core.parameters import Parameter

ACTION = Parameter("action", None, help="Action whose spaces are shown.", kind=str)
LOOK = Parameter("look", "heatmap", help="How the spaces are drawn.", choices=("heatmap", "surface"))

YES_NO = {"yes": "true", "no": "false"}


OLD_SWITCHES = tuple(Old(name, name, YES_NO) for name in ("fold", "shift", "clip", "paper_grid"))
"""Switches of the lens, of which version 0.2 said yes and no."""
