"""Every figure of the page: valid plotly, arrays intact on the way, and the numbers of the study in it."""

from __future__ import annotations

import json
from dataclasses import replace
from functools import cache

import numpy as np
import plotly.graph_objects as go
import pytest

from app.view import compute
from app.worlds.sources import WORLDS
from laplace_core import Settings, figures, load_world, study
from laplace_core.study.compare import difference
from laplace_core.study.settings import resolve
from laplace_core.subjects import Exact, Learner, View
from laplace_core.tabular import Learning, LearnSettings, bands, return_distributions, study_of
from laplace_core.tabular.reading import study_settings
from tests.support.unpacking import unpacked

LEARNING = ("curve", "probabilities", "returns")
OVER_SEEDS = ("values", "rewards")


def test_plotly_accepts_the_graph_of_every_world(subtests):
    for world in WORLDS:
        with subtests.test(world=world):
            found = study(load_world(world), Settings(world=world))
            view = View(Exact(found.world), found.settings, 0)
            go.Figure(
                json.loads(compute.world_figure(view))
            )  # raises on any property or value that plotly does not know


@cache
def learner_of(world: str, seeds: int, episodes: int = 3) -> Learner:
    learning = Learning(
        load_world(world), LearnSettings(episodes=episodes, seeds=seeds, peers=True, max_steps=30, gammas=8)
    )
    for _ in learning:
        pass
    learned = learning.snapshot()
    return Learner(learned.world, learned, None if seeds > 1 else 0)


def learned_view(world: str = "two_branch", seeds: int = 1, action: int = 0, episodes: int = 3) -> View:
    learner = learner_of(world, seeds, episodes)
    settings = resolve(study_settings(learner.learned.settings, Settings(world=world, thetas=40)), learner.world)
    return View(learner, settings, action)


def test_plotly_accepts_every_figure_of_a_learner(subtests):
    for seeds in [1, 3]:
        for world in WORLDS:
            with subtests.test(seeds=seeds, world=world):
                view = learned_view(world, seeds)
                go.Figure(json.loads(compute.world_figure(view)))
                for name in LEARNING + (OVER_SEEDS if seeds > 1 else ()):
                    go.Figure(json.loads(compute.learning_figure(name, view)))


def test_plotly_accepts_every_map_of_a_comparison(subtests):
    for what in ["tau_space", "gamma_space"]:
        for world in WORLDS:
            with subtests.test(what=what, world=world):
                built = load_world(world)
                a, b = (
                    View(Exact(built), resolve(Settings(world=world, alpha=alpha), built), 0) for alpha in (0.1, 1.0)
                )
                sentence, maps = compute.comparison(a, b, what)
                assert sentence
                assert list(maps) == ["A", "B", "B - A"]
                for figure in maps.values():
                    go.Figure(json.loads(figure))


def test_large_worlds_are_drawn_in_part_and_say_so():
    found = study(load_world("gym:Taxi-v4"), Settings(world="gym:Taxi-v4"))
    figure = json.loads(compute.world_figure(View(Exact(found.world), found.settings, 0)))
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


def test_the_curve_holds_what_was_noted_while_learning():
    view = learned_view(seeds=3, episodes=20)
    drawn = json.loads(compute.learning_figure("curve", view))["data"]
    for i, curve in enumerate(view.learned.curves):
        errors, returns = (unpacked(trace["y"]) for trace in drawn[2 * i : 2 * i + 2])
        np.testing.assert_allclose(errors, 100 * np.maximum(curve["error"], 1e-6), rtol=1e-6)
        np.testing.assert_allclose(returns, curve["return"], rtol=1e-6)


def test_the_bands_hold_every_learner_and_the_truth_is_exact():
    view = learned_view(seeds=3, action=1, episodes=20)
    each = [study_of(view.learned, view.settings, seed) for seed in range(3)]
    traces = json.loads(compute.learning_figure("probabilities", view))["data"]
    edge, mean, true = (unpacked(trace["y"]) for trace in traces[-3:])
    last = np.abs(each[0].midpoints[:, None] - view.world.reward_values).argmin(axis=1) == 2  # the reward 10
    rows = np.stack([study.decoded.tau_space[1][:, last].sum(axis=-1) for study in each])
    np.testing.assert_allclose(edge, [*rows.max(axis=0), *rows.min(axis=0)[::-1]], atol=1e-6)
    np.testing.assert_allclose(mean, rows.mean(axis=0), atol=1e-6)
    np.testing.assert_allclose(true, each[0].truth.tau_space[1][:, last].sum(axis=-1), atol=1e-6)


def test_the_strip_of_several_learners_shows_their_shares():
    view = learned_view(seeds=3, episodes=2)
    found = bands(view.learned, view.settings)
    drawn = json.loads(compute.learning_figure("values", view))["data"]
    shares = [unpacked(trace["y"]) for trace in drawn if trace.get("yaxis") == "y3"]
    np.testing.assert_allclose(shares, found.action_share, atol=1e-6)
    np.testing.assert_allclose(np.sum(shares, axis=0), 1.0, atol=1e-6)


def test_the_laws_of_the_return_rise_to_one_and_the_true_one_is_exact():
    view = learned_view(episodes=20)
    found = return_distributions(view.learned, view.settings.state, 0, seed_index=0, settings=view.settings)
    traces = [t for t in json.loads(compute.learning_figure("returns", view))["data"] if t["mode"] == "lines"]
    for trace in traces:
        heights = unpacked(trace["y"])
        assert heights[-1] == 1.0
        assert np.all(np.diff(heights) >= -1e-6)
    locations, masses = found.truth
    true = next(trace for trace in traces if trace["name"] == "true")
    np.testing.assert_allclose(unpacked(true["x"])[1:-1], np.sort(locations), rtol=1e-6)
    np.testing.assert_allclose(unpacked(true["y"])[1:-1], np.cumsum(masses[np.argsort(locations)]), rtol=1e-6)


@pytest.mark.parametrize("step", [1.0, 0.5])
def test_the_maps_of_a_comparison_share_a_scale_and_hold_the_difference(step):
    world = load_world("two_branch")
    a, b = (View(Exact(world), resolve(Settings(alpha=alpha, time_step=step), world), 0) for alpha in (0.2, 0.01))
    found = difference(compute.study_for(a), compute.study_for(b), 0, 0)
    maps = {name: json.loads(figure)["data"][0] for name, figure in compute.comparison(a, b, "tau_space")[1].items()}
    for name, values in (("A", found.a), ("B", found.b), ("B - A", found.difference)):
        np.testing.assert_allclose(unpacked(maps[name]["z"]), values, rtol=1e-5, atol=1e-6)
    assert (maps["A"]["zmin"], maps["A"]["zmax"]) == (maps["B"]["zmin"], maps["B"]["zmax"])
    assert maps["B - A"]["zmin"] == -maps["B - A"]["zmax"]


def test_columns_of_a_comparison_are_equally_wide_and_labelled_by_their_reward():
    """Whole numbers are places; a label lies where its reward is between them, and none on another."""
    world = load_world("two_branch")
    uneven = Settings(theta_spacing="asinh", theta_min=-100.0, theta_max=100.0, thetas=61)
    a, b = (View(Exact(world), resolve(replace(uneven, alpha=alpha), world), 0) for alpha in (0.2, 0.01))
    figure = json.loads(compute.comparison(a, b, "tau_space")[1]["A"])
    heat, across = figure["data"][0], figure["layout"]["xaxis"]
    np.testing.assert_array_equal(unpacked(heat["x"]), np.arange(60))
    columns = difference(compute.study_for(a), compute.study_for(b), 0, 0).columns
    labelled = dict(zip(across["ticktext"], unpacked(across["tickvals"]), strict=True))
    assert {"-10", "0", "10"} <= set(labelled)
    for text, at in labelled.items():
        assert np.interp(at, np.arange(60), columns) == pytest.approx(float(text), abs=1e-4)
    assert np.all(np.diff(list(labelled.values())) > 6)
    theta = unpacked(heat["customdata"])[0, :, 1]
    np.testing.assert_allclose(theta, columns, rtol=1e-5, atol=1e-5)
