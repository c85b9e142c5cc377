"""Figures of returns: valid for plotly, and holding the numbers they are given."""

from __future__ import annotations

import json

import numpy as np
import plotly.graph_objects as go
import pytest

from laplace_core.acting.return_laws import ReturnLaw, SimulatedReturns
from laplace_core.experiments.shipping import TrainingCurve
from laplace_core.figures import (
    ReturnRow,
    returns_of_actions,
    returns_over_episode,
    returns_side_by_side,
    to_json,
    values_of_actions,
    values_over_time_to_go,
)
from laplace_core.figures.theme import staircase
from laplace_core.figures.training import score_curve

LAW = ReturnLaw("learned", 0.9, np.array([-1.0, 0.0, 2.0]), np.array([0.25, 0.25, 0.5]))
CAME = SimulatedReturns(np.array([3.0, 1.0]), 0.9, 51, 0.0, 0.0)
NAMES = ("left", "right")


@pytest.mark.parametrize(
    "figure",
    [
        returns_side_by_side([ReturnRow("one", LAW), ReturnRow("two", LAW)]),
        returns_side_by_side([ReturnRow("one", LAW, CAME), ReturnRow("two", LAW, CAME), ReturnRow("three", LAW, CAME)]),
        returns_of_actions([LAW, LAW], NAMES, 1),
        values_of_actions(np.array([-3.0, 4.0]), NAMES, 0.99, 0),
        values_of_actions(np.zeros(2), NAMES, 0.99, 0),
        values_over_time_to_go(np.arange(10.0).reshape(5, 2), NAMES, 0.99, 3),
        returns_over_episode(np.arange(4.0), np.ones(4), np.ones((4, 5)), 2, gamma=0.99, truncated=True),
        returns_over_episode(np.arange(4.0), np.ones(4), None, 2, gamma=0.99, truncated=False),
        score_curve([TrainingCurve(1, (1.0, 5.0), (2.0, 3.0), (0.1, 0.1)), TrainingCurve(0, (), (), ())], 5),
    ],
)
def test_plotly_takes_the_figure(figure):
    go.Figure(figure)
    json.loads(to_json(figure))


def test_a_staircase_holds_the_share_at_most_each_place():
    """Of -1, 0 and 2 with masses 1/4, 1/4 and 1/2, a quarter lies below the window (-.5, 3), half at its 0."""
    x, y = staircase(LAW.locations[::-1], LAW.masses[::-1], -0.5, 3.0)
    np.testing.assert_array_equal(x, [-0.5, 0.0, 2.0, 3.0])
    np.testing.assert_array_equal(y, [0.25, 0.5, 1.0, 1.0])
    assert staircase(np.array([5.0]), np.ones(1), 0.0, 1.0)[1].tolist() == [0.0, 0.0]


def test_the_shaded_area_between_learned_and_came_is_w1():
    """Areas of each panel, from the drawn corners alone; W1 by hand: quantile against quantile, 1/4 |1 + 1| +
    1/4 |1 - 0| + 1/2 |3 - 2| = 1.25."""
    figure = returns_side_by_side([ReturnRow("one", LAW, CAME)])
    came = next(trace for trace in figure["data"] if str(trace.get("name", "")).startswith("observed"))
    learned = figure["data"][figure["data"].index(came) + 1]
    assert learned["fill"] == "tonexty"
    grid = np.unique(np.concatenate([came["x"], learned["x"]]))
    at = [np.asarray(t["y"])[np.searchsorted(t["x"], grid[:-1], side="right") - 1] for t in (came, learned)]
    assert np.abs(at[0] - at[1]) @ np.diff(grid) == pytest.approx(1.25)
    assert "W1 1.25" in [note["text"] for note in figure["layout"]["annotations"]]


def test_the_axis_leaves_the_last_thousandths_out():
    wide = ReturnLaw("learned", 0.9, np.array([-1e6, 0.0, 1.0]), np.array([1e-4, 0.5, 0.5]))
    low, high = returns_side_by_side([ReturnRow("one", wide)])["layout"]["xaxis"]["range"]
    assert -0.1 < low < 0.0
    assert 1.0 < high < 1.1


def test_what_an_agent_puts_in_for_itself_is_told_apart():
    """.5^4 = .0625 is above .05 and .5^5 is not: of six steps the last four are too close to the cut."""
    received = np.arange(6.0)
    came, own = returns_over_episode(received, received, None, 0, gamma=0.5, truncated=True)["data"][1:]
    assert (came["name"], own["name"]) == ("observed", "observed, then bootstrap")
    np.testing.assert_array_equal((came["x"], came["y"]), [[0, 1], [0.0, 1.0]])
    np.testing.assert_array_equal((own["x"], own["y"]), [[2, 3, 4, 5], [2.0, 3.0, 4.0, 5.0]])
    names = [
        trace["name"] for trace in returns_over_episode(received, received, None, 0, gamma=0.5, truncated=False)["data"]
    ]
    assert names == ["predicted", "observed"]
