"""Figures of a timeline that was changed by hand: valid plotly, with the numbers of the edit in them."""

from __future__ import annotations

import numpy as np
import plotly.graph_objects as go

from laplace_core import Settings, figures, load_world, study
from laplace_core.study.edited import Edit, edit


def test_values_and_gamma_space_before_and_after():
    shown = study(load_world("two_branch"), Settings(thetas=30, steps=6))
    found = edit(shown, Edit(horizon=2.0))
    values = figures.edited_values(found, shown.horizons, ("a<b>", "b"))
    space = figures.edited_gamma_space(found, ("a", "b"))
    for figure in (values, space):
        go.Figure(figure)  # raises on any property or value that plotly does not know
        assert [trace["showlegend"] for trace in figure["data"]] == [False, True] * 2
    assert values["data"][0]["name"] == "a&lt;b&gt;"
    np.testing.assert_array_equal(values["data"][1]["y"], found.new_values[0])
    np.testing.assert_array_equal(values["data"][2]["y"], found.values[1])
    after = found.after
    share = (1.0 - after.gammas) * (after.differences @ after.bin_values)
    np.testing.assert_allclose(space["data"][3]["y"], share[1])
