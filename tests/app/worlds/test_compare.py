"""A pinned view beside the present one, and the tables and texts that a view is taken along as."""

from __future__ import annotations

import io
import shlex

import numpy as np
import pytest

from app.worlds import learners
from laplace_core import Settings, load_world, study
from laplace_core.cli import main
from laplace_core.files.packed_text import pack
from laplace_core.study.compare import difference
from laplace_core.study.episodes import episode_regret_of
from laplace_core.study.npz import study_arrays
from laplace_core.study.tables import gamma_space_csv, rewards_csv, tau_space_csv, values_csv
from laplace_core.tabular import study_of
from tests.app.worlds.test_learning import QUICK, finished, learn, learned_here
from tests.support.hostile import assert_one_sentence
from tests.support.malformed_saved import with_arrays
from tests.support.malformed_worlds import TEXT
from tests.support.pages import (
    assert_shows,
    choose,
    copied,
    downloads,
    labels,
    link,
    numbers,
    opened,
    pictures,
    pin,
    press,
    run,
    runs_of,
    seen_on,
    shown,
    tau_space,
    upload,
    verdict,
    wait,
)

MAPS = ("compare A", "compare B", "compare B - A")


def maps(page) -> list[np.ndarray]:
    found = pictures(page)
    return [numbers(found[name]["data"][0]["z"]) for name in MAPS]


def changed(page, alpha: float):
    return choose(page, alpha=alpha)


def test_pinned_and_changed_the_maps_are_a_b_and_their_difference():
    page = changed(pin(opened(world="two_branch")), 0.01)
    a, b = (study(load_world("two_branch"), Settings(alpha=alpha)) for alpha in (0.2, 0.01))
    found = difference(a, b, 0, 0)
    for drawn, expected in zip(maps(page), (found.a, found.b, found.difference), strict=True):
        np.testing.assert_allclose(drawn, expected, rtol=1e-5, atol=1e-6)
    assert any("largest change of the tau-space" in caption.value for caption in page.caption)


def test_before_anything_changes_there_is_no_difference():
    page = pin(opened(world="two_branch"))
    assert not maps(page)[2].any()
    assert any("same tau-space" in caption.value for caption in page.caption)


def test_gamma_spaces_are_compared_too():
    page = pin(opened(world="two_branch", compare="gamma-space"))
    page.number_input(key="p.r2").set_value(8.0)
    run(page)
    a, b = (study(load_world("two_branch", params), Settings()) for params in ({}, {"r2": 8.0}))
    assert pictures(page)["compare A"]["layout"]["yaxis"]["title"]["text"] == "discount gamma"
    found = difference(a, b, 0, 0, what="gamma_space")
    np.testing.assert_allclose(maps(page)[2], found.difference, rtol=1e-4, atol=1e-5)


def test_a_pin_is_kept_from_world_to_world_and_unpinned():
    page = pin(opened(world="two_branch"))
    page.selectbox(key="world").set_value("two_decisions")
    run(page)
    assert not page.exception
    assert "pin" in link(page)
    a = study(load_world("two_branch"), Settings())
    b = study(load_world("two_decisions"), Settings())
    np.testing.assert_allclose(maps(page)[0], difference(a, b, 0, 0).a, rtol=1e-5, atol=1e-6)
    press(page, "Unpin")
    assert "pin" not in link(page)
    assert not set(MAPS) & set(pictures(page))


def test_each_side_shows_its_own_action():
    page = pin(opened(world="two_branch"))
    choose(page, action="long")
    found = study(load_world("two_branch"), Settings())
    np.testing.assert_allclose(maps(page)[0], found.decoded.tau_space[0], rtol=1e-5, atol=1e-6)
    np.testing.assert_allclose(maps(page)[1], found.decoded.tau_space[1], rtol=1e-5, atol=1e-6)


def test_pinning_again_pins_what_is_seen_now():
    page = changed(pin(opened(world="two_branch")), 0.01)
    assert maps(page)[2].any()
    assert not maps(pin(page))[2].any()


def test_worlds_without_a_common_range_say_so_and_draw_nothing():
    page = pin(opened(world="two_branch"))
    page.session_state["learning"] = True
    run(page)
    page.number_input(key="theta_max").set_value(90.0)
    run(page)
    page.number_input(key="theta_min").set_value(50.0)
    run(page)
    assert not set(MAPS) & set(pictures(page))
    assert any("do not overlap" in caption.value for caption in page.caption)


def test_a_link_reproduces_both_sides():
    page = changed(pin(opened(world="own", own=pack(TEXT))), 0.5)
    page.selectbox(key="world").set_value("two_branch")
    run(page)
    again = opened(**link(page))
    assert not again.warning
    assert pictures(again) == pictures(page)


def at_work(page) -> bool:
    return any(run.running for run in runs_of(page).values())


def test_a_learned_view_is_pinned_as_it_was_learned():
    page = pin(learn(**{"p.slip": "0.2"}))
    seen = tau_space(page)
    page.segmented_control(key="source").set_value("exact")
    run(page)
    exact = study(load_world("two_branch", {"slip": 0.2}), Settings())
    learned = study_of(learned_here(params={"slip": 0.2}, episodes=60), Settings())
    np.testing.assert_allclose(maps(page)[0], seen, rtol=1e-6, atol=1e-9)  # a picture holds single floats
    found = difference(learned, exact, 0, 0)
    for drawn, expected in zip(maps(page), (found.a, found.b, found.difference), strict=True):
        np.testing.assert_allclose(drawn, expected, rtol=1e-5, atol=1e-6)
    # A link to it learns A again, from its seed, if the server has it no more.
    learners._jobs.clear()
    again = wait(opened(**link(page)), lambda page: set(MAPS) <= set(pictures(page)))
    wait(again, lambda page: not at_work(page))
    assert pictures(run(again)) == pictures(page)


@pytest.mark.long
def test_a_pinned_run_is_not_stopped_by_what_is_learned_beside_it():
    pinned = link(pin(learn(**{"p.slip": "0.2"})))["pin"]
    page = opened(pin=pinned, **QUICK | {"l.seed": "5"})
    press(wait(page, lambda page: not at_work(page)), "Learn")
    wait(page, finished)
    a, b = (
        study_of(learned_here(params=params, episodes=60, seed=seed), Settings())
        for params, seed in (({"slip": 0.2}, 0), ({}, 5))
    )
    np.testing.assert_allclose(maps(page)[2], difference(a, b, 0, 0).difference, rtol=1e-4, atol=1e-5)


def test_a_pinned_gamma_space_is_gone_with_its_file_and_says_so():
    page = pin(upload(opened("bring"), "mine.npz", with_arrays()))
    assert set(MAPS) <= set(pictures(page))
    page.selectbox(key="world").set_value("two_branch")
    run(page)
    assert not page.exception
    again = opened(**link(page))
    assert any("can no longer be shown" in warning.value for warning in again.warning)
    for warning in again.warning:
        assert_one_sentence(warning.value)


@pytest.mark.parametrize(
    "pin", ["", "abc", pack("[1]"), pack('{"world": "nope"}'), pack('{"world": "own", "own": "x"}')]
)
def test_a_damaged_pin_is_noted_and_the_view_opens(pin):
    page = opened(world="two_branch", pin=pin)
    assert len(page.warning) == 1
    assert "Unpin" not in labels(page)
    assert "choose long" in verdict(page)


# --- taken along ---

VIEWS = [
    {"world": "two_branch", "normalise": "paper", "alpha": "0.05", "action": "long"},
    {"world": "rise_and_fade", "noise": "0.001", "noise_seed": "3", "time_step": "0.5"},
    {"world": "own", "own": pack(TEXT), "state": "long"},
    {"world": "gym:FrozenLake-v1", "policy": "per_gamma", "deadline": "constant"},
]


@pytest.mark.parametrize("query", VIEWS, ids=lambda query: query["world"])
def test_the_downloads_hold_the_library_s_numbers(query, monkeypatch):
    saved = downloads(monkeypatch)
    page = opened("downloading", **query)
    view = shown(page)
    found = study(view.world, view.settings)
    (everything,) = (content for name, content in saved.items() if name.endswith(".npz"))
    with np.load(io.BytesIO(everything)) as file:
        for name, array in study_arrays(found).items():
            np.testing.assert_array_equal(file[name], array)
        drawn = seen_on(page)  # what the lens draws
        drawn.pop("reward_noise", None)  # its band: the downloaded one is of the noise that is assumed
        for name, array in drawn.items():
            np.testing.assert_allclose(file[name], array, rtol=0, atol=1e-9 * max(1.0, np.abs(array).max()))
    csvs = {content for name, content in saved.items() if name.endswith(".csv")}
    assert csvs == {csv(found) for csv in (tau_space_csv, gamma_space_csv, values_csv, rewards_csv)}
    for name in saved:
        assert not set(name) & set(' :/\\"')


@pytest.mark.parametrize("query", VIEWS, ids=lambda query: query["world"])
def test_the_python_and_the_command_repeat_the_view(query, monkeypatch, tmp_path):
    saved = downloads(monkeypatch)
    page = opened("copying", **query)
    for name, content in saved.items():
        if name.endswith(".json"):
            (tmp_path / name).write_text(content)
    monkeypatch.chdir(tmp_path)
    namespace: dict = {}
    exec(compile(copied(page, "python"), "script", "exec"), namespace)
    assert_shows(page, namespace["result"], shown(page).action)
    assert main(shlex.split(copied(page, "command"))[3:]) == 0
    told = np.load(tmp_path / "view.npz")
    for name, array in study_arrays(namespace["result"]).items():
        if name != "settings":
            np.testing.assert_array_equal(told[name], array)


def test_the_python_of_a_gamma_space_from_a_file_repeats_it(tmp_path, monkeypatch):
    (tmp_path / "mine.npz").write_bytes(with_arrays())
    page = upload(opened("bring", "copying"), "mine.npz", with_arrays())
    monkeypatch.chdir(tmp_path)
    namespace: dict = {}
    exec(compile(copied(page, "python"), "script", "exec"), namespace)
    assert_shows(page, namespace["result"])
    assert main(shlex.split(copied(page, "command"))[3:]) == 0


# --- noise, and acting by a constant horizon ---


def test_noise_moves_the_picture_and_its_seed_brings_it_back():
    page = opened(world="rise_and_fade")
    before = tau_space(page)
    choose(page, noise=1e-3)
    noisy = tau_space(page)
    assert np.abs(noisy - before).max() > 0.01
    assert_shows(page, study(load_world("rise_and_fade"), Settings(noise=1e-3)))
    choose(page, noise_seed=1)
    assert_shows(page, study(load_world("rise_and_fade"), Settings(noise=1e-3, noise_seed=1)))
    np.testing.assert_array_equal(tau_space(choose(page, noise_seed=0)), noisy)
    np.testing.assert_array_equal(tau_space(choose(page, noise=0.0)), before)


def test_acting_with_a_constant_horizon_loses_more_and_is_named():
    page = opened(world="cliff_grid", horizon="12")
    choose(page, deadline="constant")
    constant = next(caption.value for caption in page.caption if "loses" in caption.value)
    choose(page, deadline="time_to_go")
    to_go = next(caption.value for caption in page.caption if "loses" in caption.value)
    world = load_world("cliff_grid")
    for text, deadline in ((constant, "constant"), (to_go, "time_to_go")):
        found = study(world, Settings(deadline=deadline))
        loss = episode_regret_of(world, found.settings)[11, found.state]
        assert f"loses {loss if loss > 1e-6 else 0.0:.3g} " in text
    assert constant != to_go
