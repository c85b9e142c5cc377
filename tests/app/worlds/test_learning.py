"""Learning on the page: it starts, moves the pictures, ends or is cancelled, and a link or a file brings it back."""

from __future__ import annotations

import io
import shlex

import numpy as np
import pytest

from app.catalogue import tabular
from app.worlds import learners
from app.worlds.schema import LINK
from laplace_core import Settings, load_world, study
from laplace_core.cli import main
from laplace_core.files.packed_text import pack
from laplace_core.study.episodes import episode_regret_of
from laplace_core.tabular import (
    Learned,
    Learning,
    LearnSettings,
    learned_bytes,
    parse_learned,
    return_distributions,
    study_of,
)
from laplace_core.tabular import shipped as shipped_learners
from laplace_core.worlds import parse_world
from tests.support.hostile import assert_one_sentence
from tests.support.malformed_learned import cases
from tests.support.malformed_worlds import TEXT
from tests.support.pages import (
    assert_shows,
    choose,
    copied,
    downloads,
    edit,
    labels,
    link,
    numbers,
    opened,
    pictures,
    press,
    run,
    runs_of,
    tau_space,
    upload,
    verdict,
    wait,
)
from tests.support.quick_runs import until

QUICK = {"world": "two_branch", "source": "learned", "l.episodes": "60"}
ENDLESS = {"world": "two_branch", "p.slip": "0.1", "source": "learned", "l.episodes": "1000000"}


def learned_here(world: str = "two_branch", params: dict | None = None, **settings) -> Learned:
    learning = Learning(load_world(world, params or {}), LearnSettings(**settings))
    for _ in learning:
        pass
    return learning.snapshot()


def finished(page) -> bool:
    return any(button.label == "Download agent" for button in page.download_button)


def strip(page) -> str:
    """What is said about learning above the pictures."""
    bars = [bar.proto.text for bar in page.get("progress")]
    return " ".join([*bars, *(info.value for info in page.info), *(caption.value for caption in page.caption)])


def learn(**query: str):
    page = press(opened(**QUICK | query), "Learn")
    return wait(page, finished)


def test_before_learning_the_pictures_are_exact_and_say_so():
    page = opened(**QUICK)
    assert "exact" in strip(page)
    np.testing.assert_array_equal(tau_space(page), tau_space(opened(world="two_branch")))
    assert "curve" not in pictures(page)


def test_what_is_learned_is_what_the_library_learns_with_the_same_seed():
    page = learn(**{"l.seed": "7", "p.slip": "0.2"})
    expected = learned_here(params={"slip": 0.2}, episodes=60, seed=7)
    assert_shows(page, study_of(expected, Settings()))
    curve = pictures(page)["curve"]["data"][0]
    np.testing.assert_allclose(numbers(curve["y"])[-1], 100 * expected.curves[0]["error"][-1], rtol=1e-5)
    assert "60 of 60 episodes" in strip(page)


def test_another_session_with_the_link_learns_the_same():
    page = learn(**{"p.slip": "0.2"})
    assert "run" in link(page)
    learners._jobs.clear()  # of another server
    again = wait(opened(**link(page)), finished)
    assert pictures(again) == pictures(page)
    assert verdict(again) == verdict(page)


def test_a_link_to_long_learning_says_what_it_costs_and_leaves_it_to_a_button(monkeypatch):
    monkeypatch.setattr(learners, "_seconds", lambda world, settings: 240.0)
    query = link(press(opened(**ENDLESS), "Learn"))
    learners._jobs.clear()
    page = opened(**query)
    assert "run" in link(page)
    assert "Learning takes about 4 minutes." in strip(page)
    assert "Cancel" not in labels(page)
    assert runs_of(page) == {}


def test_learning_that_takes_longer_than_the_server_allows_cannot_be_begun(monkeypatch):
    monkeypatch.setattr(learners, "_seconds", lambda world, settings: 36_000.0)
    page = opened(**ENDLESS)
    assert "This takes about 10 hours, and this server allows 10 minutes: lower the number of episodes" in strip(page)
    assert [button.disabled for button in page.button if button.label.startswith("Learn")] == [True, True]


def test_a_file_of_a_run_that_was_cancelled_says_how_much_was_learned(tmp_path, monkeypatch):
    saved = downloads(monkeypatch)
    page = press(opened(**ENDLESS), "Learn")
    wait(page, lambda page: "curve" in pictures(page))
    press(page, "Cancel")
    file = saved["two_branch_td.safetensors"]
    done = parse_learned(file).episodes[0]
    assert 0 < done < 1_000_000
    again = upload(opened("bring"), "mine.safetensors", file)
    assert f"Learned in {done:,} of 1,000,000 episodes by one learner" in strip(again)


def test_alpha_moves_what_was_learned_without_learning_anew():
    page = learn(**{"p.slip": "0.2"})
    before = link(page)["run"]
    choose(page, alpha=0.01)
    assert link(page)["run"] == before
    assert_shows(page, study_of(learned_here(params={"slip": 0.2}, episodes=60), Settings(alpha=0.01)))


def test_other_settings_of_learning_show_no_stale_run():
    page = learn()
    page.session_state["how"] = True
    run(page)
    page.number_input(key="l.episodes").set_value(50)
    run(page)
    assert "exact" in strip(page)
    assert "curve" not in pictures(page)
    page.number_input(key="l.episodes").set_value(60)  # the run is still there
    assert "curve" in pictures(run(page))


def test_cancel_ends_the_process_and_keeps_what_was_learned():
    page = press(opened(**ENDLESS), "Learn")
    wait(page, lambda page: "curve" in pictures(page))
    watched = runs_of(page)[link(page)["run"]]
    assert watched.running
    until(lambda: watched._work._run)  # the curve may be that of a run before it, which ends first
    process = watched._work._run
    press(page, "Cancel")
    assert not watched.running
    assert process.finished
    assert "cancelled at" in strip(page)
    assert "Cancel" not in labels(page)
    assert "curve" in pictures(page)
    kept = tau_space(page)
    np.testing.assert_array_equal(tau_space(run(page)), kept)


def test_seeds_are_drawn_as_bands_and_can_be_looked_at_one_by_one():
    page = learn(**{"l.seeds": "3", "p.slip": "0.2"})
    learned = learned_here(params={"slip": 0.2}, episodes=60, seeds=3)
    state = learned.world.state_index("start")
    mean = study(learned.world, Settings(), learned=learned.basis[:, state].astype(float).mean(axis=0))
    assert_shows(page, mean)
    assert sum(trace.get("fill") == "toself" for trace in pictures(page)["rewards"]["data"]) == 2
    names = {trace.get("name") for trace in pictures(page)["curve"]["data"]}
    assert {"seed 0", "seed 1", "seed 2"} <= names
    for seed in range(3):
        page.selectbox(key="learner").set_value(str(seed))
        run(page)
        assert_shows(page, study_of(learned, Settings(), seed))
    assert pictures(opened_again(page)) == pictures(page)


def opened_again(page):
    return wait(opened(**link(page)), finished)


def test_the_other_codes_learn_too_and_stand_beside_the_true_return():
    page = learn()
    assert "returns" not in pictures(page)
    press(page, "Learn them too")
    wait(page, lambda page: "returns" in pictures(page) and finished(page))
    learned = learned_here(episodes=60, peers=True)
    expected = return_distributions(learned, "start", 0, seed_index=0, settings=Settings(alpha=0.2))
    legend = [trace["name"] for trace in pictures(page)["returns"]["data"]]
    for name, code in (("categorical", "categorical"), ("quantile", "quantile"), ("expectile, imputed", "expectile")):
        assert f"{name} ({expected.distances[code]:.2g})" in legend


def test_settings_that_contradict_each_other_are_said_beside_them_and_the_page_stays():
    page = opened("how", **QUICK)
    before = pictures(page)
    page.number_input(key="l.rate_first").set_value(0.5)
    page.number_input(key="l.rate_floor").set_value(0.9)
    run(page)
    assert len(page.error) == 1
    assert_one_sentence(page.error[0].value)
    assert pictures(page) == before
    page.number_input(key="l.rate_floor").set_value(0.1)
    assert not run(page).error


def test_every_setting_of_learning_can_be_set_and_travels_in_the_link():
    page = opened("how", **QUICK)
    page.selectbox(key="l.starts").set_value("world")
    page.number_input(key="l.seeds").set_value(2)
    page.checkbox(key="l.peers").set_value(True)
    page.number_input(key="l.epsilon_first").set_value(0.5)
    run(page)
    assert {**link(page), **QUICK} == link(page)
    assert {name: link(page)[name] for name in ("l.starts", "l.seeds", "l.peers", "l.epsilon_first")} == {
        "l.starts": "world", "l.seeds": "2", "l.peers": "true", "l.epsilon_first": "0.5",
    }  # fmt: skip
    assert LINK.read(link(page))[1] == []


def test_another_world_drops_the_run():
    page = learn()
    page.selectbox(key="world").set_value("two_decisions")
    run(page)
    assert set(link(page)) == {"world", "source"}
    assert "exact" in strip(page)


def test_a_world_of_one_s_own_is_learned():
    page = press(opened(world="own", own=pack(TEXT), source="learned", **{"l.episodes": "80"}), "Learn")
    wait(page, finished)
    learning = Learning(parse_world(TEXT), LearnSettings(episodes=80))
    for _ in learning:
        pass
    assert_shows(page, study_of(learning.snapshot(), Settings()))
    edit(page, {0: {"reward": 1.0}})
    assert not page.warning
    assert "exact" in strip(page)  # another world, nothing learned of it yet


def test_the_loss_is_that_of_acting_by_what_was_learned():
    page = learn(**{"p.slip": "0.3", "l.episodes": "8"})
    learned = learned_here(params={"slip": 0.3}, episodes=8)
    loss = episode_regret_of(
        learned.world, study_of(learned, Settings()).settings, learned=learned.basis[0].astype(float)
    )
    whole = study_of(learned, Settings()).settings.steps
    expected = loss[whole - 1, learned.world.state_index("start")]
    assert f"loses {expected if expected > 1e-6 else 0.0:.3g} against the best" in strip(page)


# --- agents from files ---


@pytest.fixture(scope="module")
def agent() -> Learned:
    return learned_here(params={"slip": 0.1}, episodes=40, seeds=2, peers=True)


@pytest.fixture
def shipped(agent, tmp_path, monkeypatch):
    (tmp_path / "toy_world_td.safetensors").write_bytes(learned_bytes(agent))
    monkeypatch.setattr(tabular, "SHIPPED", tmp_path)
    shipped_learners.forget()
    yield "toy_world_td"
    shipped_learners.forget()


def test_an_agent_that_ships_is_opened_with_its_world_and_a_link_to_it(shipped, agent):
    page = press(opened("bring"), "Open the learned toy world")
    assert not page.error
    assert link(page)["agent"] == shipped
    page.selectbox(key="learner").set_value("1")
    assert_shows(choose(page, normalise="none"), study_of(agent, Settings(), 1))
    assert pictures(opened(**link(page))) == pictures(page)


def test_a_downloaded_agent_is_opened_again(monkeypatch):
    saved = downloads(monkeypatch)
    page = learn(**{"p.slip": "0.2"})
    again = upload(opened("bring", normalise="none"), "mine.safetensors", saved["two_branch_td.safetensors"])
    assert not again.error
    np.testing.assert_array_equal(tau_space(again), tau_space(page))
    assert "Learned in 60 episodes" in strip(again)
    missing = opened(**link(again))  # a link does not carry the file
    assert missing.warning
    assert "14.85" in verdict(missing) or "exact" in strip(missing)


def test_an_agent_s_world_changes_and_the_agent_is_closed(shipped):
    page = press(opened("bring"), "Open the learned toy world")
    page.number_input(key="p.slip").set_value(0.3)
    run(page)
    assert "agent" not in link(page)
    assert "exact" in strip(page)


def test_hostile_agents_are_one_sentence_and_the_view_stays(agent, tmp_path):
    page = opened("bring", alpha="0.5")
    before, words = pictures(page), link(page)
    every = list(cases(learned_bytes(agent), str(tmp_path / "trap")))
    for _, content, _ in every[:: max(1, len(every) // 10)]:
        upload(page, "bad.safetensors", content)
        assert len(page.error) == 1
        assert_one_sentence(page.error[0].value)
        assert pictures(page) == before
        assert link(page) == words
    assert not (tmp_path / "trap").exists()


@pytest.mark.parametrize("learner", ["mean", "1"])
def test_the_python_of_a_learned_view_repeats_it(shipped, agent, learner, tmp_path, monkeypatch):
    saved = downloads(monkeypatch)
    page = press(opened("bring", "copying", "downloading"), "Open the learned toy world")
    page.selectbox(key="learner").set_value(learner)
    choose(page, alpha=0.05)
    name = "two_branch_td.safetensors"
    (tmp_path / name).write_bytes(saved[name])
    np.testing.assert_array_equal(parse_learned(saved[name]).basis, agent.basis)
    monkeypatch.chdir(tmp_path)
    namespace: dict = {}
    exec(compile(copied(page, "python"), "script", "exec"), namespace)
    assert_shows(page, namespace["result"])


def test_the_command_of_a_learned_view_repeats_it(shipped, tmp_path, monkeypatch):
    saved = downloads(monkeypatch)
    page = press(opened("bring", "copying", "downloading"), "Open the learned toy world")
    page.selectbox(key="learner").set_value("1")
    run(page)
    (tmp_path / "two_branch_td.safetensors").write_bytes(saved["two_branch_td.safetensors"])
    monkeypatch.chdir(tmp_path)
    assert main(shlex.split(copied(page, "command"))[3:]) == 0
    told, seen = np.load(tmp_path / "view.npz"), np.load(io.BytesIO(saved["two_branch_td.npz"]))
    assert set(told.files) == set(seen.files)
    for name in told.files:
        if name != "settings":
            np.testing.assert_array_equal(told[name], seen[name])
