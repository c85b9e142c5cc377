"""Figures of simulated and decoded timelines: valid for plotly, and holding the numbers they are given."""

from __future__ import annotations

import json

import numpy as np
import plotly.graph_objects as go
import pytest

from laplace_core.acting.continuations import Calibration
from laplace_core.acting.simulated_truth import Confronted, Empirical
from laplace_core.figures import calibration_plot, simulated_timeline, to_json


@pytest.fixture
def found() -> Confronted:
    line = np.linspace(1.0, 0.0, 50)
    bins = Calibration(np.array([0.1, 0.9]), np.array([0.0, 1.0]), np.array([0.0, 0.1]), np.array([400, 3]))
    simulated = Empirical(9, np.zeros((50, 3)), line, line / 10, line / 2, line / 20, line / 30)
    return Confronted(simulated, line + 0.1, line / 2, line**2, bins)


@pytest.mark.parametrize("draw", [simulated_timeline, calibration_plot])
def test_plotly_takes_the_figure(found, draw):
    go.Figure(draw(found))
    json.loads(to_json(draw(found)))


def test_bands_are_two_standard_errors_wide(found):
    band = simulated_timeline(found)["data"][0]["y"]
    np.testing.assert_allclose(band[:50] - band[50:][::-1], 4 * found.simulated.reward_error)


def test_a_bin_stands_where_it_was_said_and_came(found):
    points = calibration_plot(found)["data"][1]
    np.testing.assert_array_equal(points["x"], [0.1, 0.9])
    np.testing.assert_array_equal(points["error_y"]["array"], [0.0, 0.2])
