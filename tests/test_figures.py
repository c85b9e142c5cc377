"""Every figure of the page: valid plotly, arrays intact on the way, and the numbers of the study in it."""

from __future__ import annotations

import base64
import json

import numpy as np
import plotly.graph_objects as go
import pytest

from app import compute, figures
from app.sources import WORLDS, View
from laplace_core import Settings, load_world, study

NAMES = ("world", "gamma-space", "tau-space", "values", "rewards")


def drawn(
    name: str, world: str = "two_branch", action: int = 0, row: int = 0, surface: bool = False, **settings
) -> dict:
    found = study(load_world(world), Settings(world=world, **settings))
    view = View(found.world, found.settings, action, float(found.horizons[row]))
    return json.loads(compute.figure(name, view, surface))


@pytest.mark.parametrize("surface", [False, True])
@pytest.mark.parametrize("world", WORLDS)
@pytest.mark.parametrize("name", NAMES)
def test_plotly_accepts_every_figure(name, world, surface):
    go.Figure(drawn(name, world, surface=surface))  # raises on any property or value that plotly does not know


def unpacked(packed: dict | list) -> np.ndarray:
    if isinstance(packed, list):
        return np.array(packed)
    flat = np.frombuffer(base64.b64decode(packed["bdata"]), dtype="<f4")
    return flat.reshape([int(n) for n in packed["shape"].split(",")]) if "shape" in packed else flat


@pytest.mark.parametrize(("action", "normalise"), [(0, "paper"), (1, "none")])
def test_the_heatmaps_hold_the_study(action, normalise):
    found = study(load_world("two_branch"), Settings(normalise=normalise, time_step=0.5))
    z = unpacked(drawn("tau-space", action=action, normalise=normalise, time_step=0.5)["data"][0]["z"])
    np.testing.assert_allclose(z, found.decoded.tau_space[action] / 0.5, rtol=1e-6, atol=1e-7)
    z = unpacked(drawn("gamma-space", action=action)["data"][0]["z"])
    np.testing.assert_allclose(z, found.gamma_space.differences[action], rtol=1e-6, atol=1e-7)


def test_colour_limits_do_not_move_with_alpha_horizon_or_normalisation():
    limits = {
        (figure["data"][0]["zmin"], figure["data"][0]["zmax"])
        for settings in ({}, {"alpha": 5.0}, {"alpha": 1e-6}, {"normalise": "paper"}, {"normalise": "survival"})
        for figure in [drawn("tau-space", **settings)]
    }
    assert len(limits) == 1


def test_the_truth_is_outlined_where_it_is():
    # Action 0 pays 5 at tau 0 and nothing later: one box, in row 0, around 5.
    outline = drawn("tau-space")["data"][2]
    x, y = [v for v in outline["x"] if v is not None], [v for v in outline["y"] if v is not None]
    assert min(y) > -0.5
    assert max(y) < 0.5
    assert min(x) < 5 < max(x)
    assert max(x) - min(x) < 1


def test_the_strip_compares_chosen_and_best():
    strip = drawn("values", normalise="paper")["data"][-1]
    assert strip["y"] == ["best", "chosen"]
    assert strip["customdata"] == [["short", "short", "long"], ["short", "short", "short"]]


def test_rounding_is_not_blown_up_into_a_picture():
    # The rewards of the chain cancel: what is left, 1e-16, is drawn as zero.
    low, high = drawn("rewards", "fig6_chain")["layout"]["yaxis"]["range"]
    assert low < -1e-3
    assert high > 1e-3


def test_large_worlds_are_drawn_in_part_and_say_so():
    figure = drawn("world", "gym:Taxi-v4")
    nodes = next(trace for trace in figure["data"] if "customdata" in trace)
    assert len(nodes["x"]) <= 26
    assert "not drawn" in figure["layout"]["title"]["text"]


def test_small_and_large_arrays_survive_the_way():
    large = np.linspace(-3, 3, 400).reshape(20, 20)
    back = json.loads(figures.to_json({"data": [{"z": large, "x": np.arange(3), "n": np.float64(1.5)}], "layout": {}}))
    np.testing.assert_allclose(unpacked(back["data"][0]["z"]), large, rtol=1e-6)
    assert back["data"][0]["x"] == [0, 1, 2]
    assert back["data"][0]["n"] == 1.5
    with pytest.raises(ValueError, match="not JSON compliant"):
        figures.to_json({"data": [np.float64("nan")]})
