"""The page of training: form, refusals, link, and where its runs are."""

from __future__ import annotations

from dataclasses import replace

from streamlit.testing.v1 import AppTest

from app.catalogue import checkpoints, training_runs
from app.train.schema import LINK, wanted
from laplace_core.agents.settings import ENVIRONMENTS, SETTINGS
from laplace_core.files import folders
from laplace_core.tabular import work
from laplace_core.training.checkpoint import new_agent, save_checkpoint
from laplace_core.training.defaults import fields, settings_of
from laplace_core.training.queue import Queue
from laplace_core.training.run_folder import read_config
from tests.support import pages
from tests.support.hostile import assert_one_sentence
from tests.support.pages import MAIN, PATIENCE, labels, link, press, run, wait
from tests.support.quick_runs import SMALL, stand_in, states
from tests.support.train_page import FORM, NAME, opened, words


def test_with_no_run_one_button_starts_the_small_default(runs):
    page = opened()
    assert "There is no run yet" in page.info[0].value
    press(page, "Train Laplace DQN on CartPole")
    wait(page, lambda page: "training" in states(runs).values())
    assert runs.get("laplace_CartPole-v1_0").settings.environment == "CartPole-v1"
    assert "CartPole-v1 · seed 0" in words(page)
    assert "Cancel" in labels(page)


def test_what_is_set_is_what_is_trained(runs):
    page = press(opened(**FORM), "Start training")
    settings = runs.get(NAME).settings
    expected = settings_of("laplace", "two_branch", {"steps": 600, "hidden": 8, "seed": 3})
    assert settings == replace(expected, evaluate_every=30)  # twenty evaluations
    assert link(page)["run"] == NAME
    assert read_config(runs.folder / NAME / "config.json") == settings


def test_several_seeds_start_at_once_and_the_third_waits(runs):
    page = press(opened(count="3", **FORM), "Start training")
    wait(page, lambda page: list(states(runs).values()).count("training") == 2)
    run(page)
    assert "waiting, place 1" in words(page)
    assert [one.settings.seed for one in runs.runs()] == [5, 4, 3]


def test_a_bad_combination_is_refused_at_once(runs):
    page = opened(**FORM | {"t.theta_min": "1"})
    assert_one_sentence(page.error[0].value, "theta_min")
    assert next(button for button in page.button if button.label == "Start training").disabled
    press(page, "Reset to the recommended settings")
    assert not page.error
    assert "t.theta_min" not in link(page)


def test_what_no_agent_can_be_made_of_is_refused_by_the_button(runs):
    page = press(opened(**FORM | {"t.hidden": "1024", "t.features": "512", "t.gammas": "100", "t.thetas": "1000"}),
                 "Start training")  # fmt: skip
    assert_one_sentence(page.error[0].value, "weights")
    assert runs.runs() == []


def test_the_same_run_twice_is_refused(runs):
    page = press(opened(**FORM), "Start training")
    press(page, "Start training")
    assert_one_sentence(page.error[0].value, NAME)
    assert len(runs.runs()) == 1


def test_the_link_holds_the_form(runs):
    page = opened("train_all", **FORM)
    page.number_input(key="t.batch").set_value(32)
    page.selectbox(key="t.network").set_value("multiplexer")
    run(page)
    assert link(page) == FORM | {"t.batch": "32", "t.network": "multiplexer"}
    again = opened("train_all", **link(page))
    assert again.number_input(key="t.batch").value == 32
    assert link(again) == link(page)


def test_another_environment_brings_its_own_settings_and_keeps_the_seed(runs):
    page = opened(**FORM)
    page.selectbox(key="environment").set_value("CartPole-v1")
    run(page)
    assert link(page) == {"environment": "CartPole-v1", "algorithm": "laplace", "t.seed": "3"} or link(page) == {
        "environment": "CartPole-v1", "t.seed": "3"}  # fmt: skip
    assert page.number_input(key="t.steps").value == settings_of("laplace", "CartPole-v1", {}).steps


def test_every_pair_has_a_form_that_may_be_started_as_it_is(subtests):
    for environment in ENVIRONMENTS:
        for algorithm in SETTINGS:
            with subtests.test(environment=environment, algorithm=algorithm):
                assert wanted({"algorithm": algorithm, "environment": environment}).environment == environment
                first, others = fields(algorithm)
                named = [parameter.name for parameter in (*first, *others)]
                assert sorted([*named, "seed", "environment"]) == sorted(p.name for p in SETTINGS[algorithm].SCHEMA)
                assert {"steps", "learning_rate"} < {parameter.name for parameter in first}


def test_a_bad_link_opens_with_a_note(subtests, runs):
    for query in [
        {"algorithm": "dreamer"},
        {"environment": "Pong-v5"},
        {"t.steps": "0"},
        {"t.steps": "nan"},
        {"t.nothing": "1"},
        {"t.environment": "CartPole-v1"},
        {"count": "99"},
        {"run": "../../etc"},
        {"beside": "a,../b"},
        {"ships": "c51,best"},
        {"nonsense": "1"},
    ]:
        with subtests.test(query=query):
            page = opened(**query)
            assert page.warning
            assert not page.error
            assert link(page) == {}


def test_settings_of_the_algorithm_are_known_whatever_the_order_of_the_link():
    found, notes = LINK.read({"t.gammas": "9", "environment": "two_branch", "algorithm": "laplace"})
    assert notes == []
    assert found == {"t.gammas": 9, "environment": "two_branch", "algorithm": "laplace"}


def test_runs_of_a_stopped_server_go_on_whichever_page_is_opened(tmp_path, monkeypatch):
    stand_in(monkeypatch)
    before = Queue(tmp_path / "left")
    monkeypatch.setattr(Queue, "wake", lambda self: None)
    name = before.add(SMALL)
    monkeypatch.undo()
    stand_in(monkeypatch)
    monkeypatch.setenv(training_runs.VARIABLE, str(tmp_path / "left"))
    page = run(AppTest.from_file(MAIN, default_timeout=PATIENCE))
    wait(page, lambda page: states(before)[name] == "training")
    assert states(training_runs.queue()) == {name: "training"}  # the page's own queue sees the same
    training_runs.queue().stop(name)


def test_where_nothing_can_be_written_the_runs_go_to_a_temporary_folder(tmp_path, monkeypatch):
    monkeypatch.delenv(training_runs.VARIABLE)
    monkeypatch.setattr(training_runs, "_ROOT", tmp_path)
    assert training_runs.folder() == tmp_path / "runs"
    monkeypatch.setattr("os.access", lambda path, mode: False)
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    folders.temporary.cache_clear()
    found = training_runs.folder()
    assert found.parent == tmp_path
    assert found.is_dir()
    assert training_runs.folder() == found
    folders.temporary.cache_clear()


def test_without_any_folder_that_can_be_written_every_page_opens(tmp_path, monkeypatch):
    """As on a read-only file system without a temporary folder. No subtests: they take one themselves."""
    save_checkpoint(tmp_path / "mine.safetensors", new_agent(SMALL), 50, 9.0)
    monkeypatch.delenv(training_runs.VARIABLE)
    monkeypatch.setattr("os.access", lambda path, mode: False)
    work._room.cache_clear()
    folders.temporary.cache_clear()
    with monkeypatch.context() as bare:
        bare.setattr("tempfile.tempdir", None)
        bare.setattr("tempfile._candidate_tempdir_list", lambda: [str(tmp_path / "nowhere")])
        for screen in (None, "agents", "race"):
            assert not pages.opened(screen=screen).error, screen
        assert_one_sentence(opened().error[0].value, training_runs.VARIABLE)
        page = press(pages.opened(world="two_branch", source="learned"), "Learn now")
        assert_one_sentence(page.error[0].value, "temporary")
        assert checkpoints.parse_checkpoint((tmp_path / "mine.safetensors").read_bytes(), "mine").step == 50


def test_no_folder_for_runs_is_one_sentence(tmp_path, monkeypatch):
    (tmp_path / "file").touch()
    monkeypatch.setenv(training_runs.VARIABLE, str(tmp_path / "file"))
    page = opened()
    assert_one_sentence(page.error[0].value, "file")
