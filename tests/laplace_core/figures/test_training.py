"""Figures of training: valid plotly, the numbers of the run in them, and words where there is nothing yet."""

from __future__ import annotations

import json

import numpy as np
import plotly.graph_objects as go

from laplace_core.experiments.shipping import TrainingCurve
from laplace_core.figures import to_json
from laplace_core.figures.training import (
    Band,
    Line,
    discount_errors,
    learning_curves,
    shipped_curves,
    values_by_discount,
)
from laplace_core.training.curves import Curves
from tests.support.pages import numbers

GAMMAS = np.array([0.5, 0.9, 0.99])
NONE = np.zeros(0)


def curves(evaluations: int = 4, episodes: int = 50, heads: int = 3) -> Curves:
    random = np.random.default_rng(0)
    return Curves(
        np.arange(1.0, episodes + 1), random.normal(size=episodes), random.normal(size=episodes),
        100 * np.arange(1, evaluations + 1), random.normal(size=evaluations), random.random(evaluations),
        *random.normal(size=(3, evaluations, heads)), episodes, evaluations - 1 if evaluations else None,
    )  # fmt: skip


def drawn(figure: dict) -> dict:
    sent = json.loads(to_json(figure))
    go.Figure(sent)  # raises on any property or value that plotly does not know
    return sent


def test_plotly_accepts_every_figure(subtests):
    for heads in [0, 3]:
        for episodes in [0, 1, 50]:
            for evaluations in [0, 1, 40]:
                with subtests.test(heads=heads, episodes=episodes, evaluations=evaluations):
                    found = curves(evaluations, episodes, heads)
                    drawn(
                        learning_curves("title", [Line("one", "#0072B2", found), Line("two", "#E69F00", found)], 4000)
                    )
                    drawn(discount_errors(found, GAMMAS, 4000, 100))
                    drawn(values_by_discount(found, GAMMAS, "#0072B2", 100))


def test_each_run_has_its_returns_their_average_and_its_scores():
    one, two = curves(), curves(2, 7)
    traces = drawn(learning_curves("title", [Line("one", "#0072B2", one), Line("two", "#E69F00", two)], 4000))["data"]
    wanted = [one.returns, two.returns, one.smooth, two.smooth, one.scores, two.scores]
    for trace, values in zip(traces, wanted, strict=True):
        np.testing.assert_allclose(numbers(trace["y"]), values, rtol=1e-6)
    assert [trace["name"] for trace in traces if trace["showlegend"]] == ["one", "two"]
    np.testing.assert_allclose(traces[4]["error_y"]["array"], one.errors)


def test_seeds_are_drawn_as_their_median_between_the_lowest_and_the_highest():
    """Three seeds, read at the steps of the one that ends first, 10 and 20. The last is there at 30: halfway at 20."""
    seeds = [
        TrainingCurve(0, (10.0, 20.0), (1.0, 5.0), (0.0, 0.0)),
        TrainingCurve(1, (10.0, 30.0), (3.0, 7.0), (0.0, 0.0)),
        TrainingCurve(2, (10.0, 20.0, 30.0), (2.0, 9.0, 0.0), (0.0,) * 3),
    ]
    band = Band.of("shipped", "#8a8f98", seeds)
    wanted = {"steps": [10, 20], "lowest": [1, 5], "median": [2, 5], "highest": [3, 9]}
    for name, values in wanted.items():
        np.testing.assert_allclose(getattr(band, name), values)
    line = Line("one", "#0072B2", curves())
    area, median, *rest = drawn(learning_curves("title", [line], 40, [band]))["data"]
    np.testing.assert_allclose(numbers(area["x"]), [10, 20, 20, 10])  # once around
    np.testing.assert_allclose(numbers(area["y"]), [1, 5, 9, 3])
    np.testing.assert_allclose(numbers(median["y"]), [2, 5])
    assert len(rest) == len(drawn(learning_curves("title", [line], 40))["data"])
    both = drawn(shipped_curves("title", [band, Band.of("other", "#0072B2", seeds[:1])]))["data"]
    assert [trace["name"] for trace in both if trace["showlegend"]] == ["shipped", "other"]


def test_each_discount_has_a_line_of_its_error_in_reward_a_step():
    found = curves()
    traces = drawn(discount_errors(found, GAMMAS, 4000, 100))["data"]
    for index, gamma in enumerate(GAMMAS):
        wanted = (1 - gamma) * (found.values[:, index] - found.discounted[:, index])
        np.testing.assert_allclose(numbers(traces[index]["y"]), wanted, rtol=1e-6)
    assert traces[-1]["marker"]["colorbar"]["ticktext"] == ["0.5", "0.9", "0.99"]
    assert len({trace["line"]["color"] for trace in traces[:-1]}) == 3


def test_evaluations_that_told_no_values_are_left_out():
    found = curves()
    found.values[0] = np.nan
    traces = drawn(discount_errors(found, GAMMAS, 4000, 100))["data"]
    assert traces[0]["x"] == [200, 300, 400]


def test_the_last_evaluation_is_drawn_over_the_discounts():
    found = curves()
    came, expected = drawn(values_by_discount(found, GAMMAS, "#0072B2", 100))["data"]
    np.testing.assert_allclose(came["y"], found.discounted[-1])
    np.testing.assert_allclose(expected["y"], found.values[-1])
    np.testing.assert_allclose(came["x"], [2, 10, 100])
    np.testing.assert_allclose(came["error_y"]["array"], found.discounted_errors[-1])


def test_before_the_first_evaluation_the_picture_says_when_it_comes():
    for figure in (
        discount_errors(curves(0), GAMMAS, 4000, 100),
        values_by_discount(curves(0), GAMMAS, "#0072B2", 100),
    ):
        assert "step 100" in drawn(figure)["layout"]["annotations"][0]["text"]
    old = drawn(discount_errors(curves(heads=0), GAMMAS, 4000, 100))  # of an earlier version
    assert "no values" in old["layout"]["annotations"][0]["text"]
