"""Whether a decoded timeline explains the gamma-space that it came from."""

from __future__ import annotations

import numpy as np

from app.figures.theme import NEUTRAL, Figure, action_colour, axis, build
from laplace_core import Study
from laplace_core.inverse import transform_matrix


def fit(study: Study, action: int) -> Figure:
    """The value at each discount as it was learned, and as the decoded timeline gives it back.

    Both are (1 - gamma) Q by the midpoint proxy: a mean reward per step over the time constant of the discount.
    """
    gammas, settings = study.gamma_space.gammas, study.settings
    order = np.argsort(gammas)
    weights = (1.0 - gammas)[order]
    given = weights * (study.gamma_space.differences[action] @ study.midpoints)[order]
    back = (
        weights
        * (transform_matrix(gammas, settings.steps, settings.time_step) @ study.decoded.expected_reward[action])[order]
    )
    constants = -1.0 / np.log(gammas[order])
    hover = "gamma %{customdata:.3f}<br>%{y:.3g} a step<extra></extra>"
    common = {"type": "scatter", "x": constants, "customdata": gammas[order], "hovertemplate": hover}
    marker = {"color": NEUTRAL, "size": 7, "symbol": "circle-open"}
    return build(
        "value over the discounts: does the timeline explain it?",
        [
            {**common, "y": given, "name": "as learned", "mode": "markers", "marker": marker},
            {**common, "y": back, "name": "from tau-space", "line": {"color": action_colour(action), "width": 2}},
        ],
        margin={"t": 58, "l": 56},
        xaxis=axis("time constant of gamma (steps)", type="log"),
        yaxis=axis("(1 - gamma) value", zeroline=True),
    )
