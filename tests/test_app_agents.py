"""The page of trained agents: opening, looking, and what a hostile file or link says."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from streamlit.testing.v1 import AppTest

from app import checkpoints, compute, trained
from app.observations import scene_of
from laplace_core import InputError
from laplace_core.agents import ENVIRONMENTS, LaplaceSettings
from laplace_core.training import environments
from laplace_core.training.checkpoint import load_checkpoint, new_agent, save_checkpoint

MAIN = str(Path(__file__).resolve().parent.parent / "app" / "main.py")


@pytest.fixture
def shipped(tmp_path, monkeypatch):
    """Two untrained agents in place of those that ship."""
    for environment in ("CartPole-v1", "two_branch"):
        agent = new_agent(LaplaceSettings(environment=environment, hidden=8, features=4, theta_max=12.0))
        save_checkpoint(tmp_path / f"laplace_{environment}.safetensors", agent, 100, 21.5, 20)
    monkeypatch.setattr(checkpoints, "SHIPPED", tmp_path)
    checkpoints.shipped.cache_clear()
    checkpoints._shipped.cache_clear()
    yield tmp_path
    checkpoints.shipped.cache_clear()
    checkpoints._shipped.cache_clear()


def opened(**query: str) -> AppTest:
    page = AppTest.from_file(MAIN, default_timeout=60)
    page.switch_page("screens/agents.py")
    for name, value in query.items():
        page.query_params[name] = value
    page.run()
    assert not page.exception
    return page


def words(page: AppTest) -> str:
    return " ".join(caption.value for caption in page.caption)


def test_without_an_agent_the_page_says_how_to_get_one(tmp_path, monkeypatch):
    monkeypatch.setattr(checkpoints, "SHIPPED", tmp_path)
    checkpoints.shipped.cache_clear()
    page = opened()
    checkpoints.shipped.cache_clear()
    assert "train one" in page.info[0].value


def test_the_card_tells_what_the_checkpoint_says_of_itself(shipped):
    told = words(opened())
    assert "100 steps" in told
    assert "21.5 over 20 episodes" in told


def test_a_slider_changes_what_is_seen_and_the_link(shipped):
    page = opened()
    next(slider for slider in page.slider if "pole angle" in slider.label).set_value(0.1).run()
    assert not page.exception
    assert page.query_params["o.2"] in ("0.1", ["0.1"])


def test_what_is_shown_is_what_the_agent_holds(shipped):
    loaded = load_checkpoint(shipped / "laplace_CartPole-v1.safetensors")
    scene = scene_of("CartPole-v1")
    view = trained.view_of(loaded, scene, {"o.0": 0.5, "o.3": -1.0, "action": "push right"})
    found = compute.study_for(view)
    wanted = loaded.agent.gamma_space(np.array([0.5, 0.0, 0.0, -1.0]))
    np.testing.assert_array_equal(found.gamma_space.values, wanted.values)
    assert found.action_names == scene.actions
    assert view.action == 1


def test_a_tabular_agent_is_asked_about_a_state(shipped):
    page = opened(checkpoint="laplace_two_branch", state="long 1")
    assert next(box for box in page.selectbox if box.label == "State").value == "long 1"
    scene = scene_of("two_branch")
    assert trained.observation_of(scene, {"state": "long 1"}) == tuple(np.eye(3)[scene.states.index("long 1")])


@pytest.mark.parametrize(
    "query",
    [
        {"checkpoint": "laplace_pong"},
        {"checkpoint": "../../etc/passwd"},
        {"o.2": "9e9"},
        {"o.2": "nan"},
        {"o.77": "0"},
        {"alpha": "-1"},
        {"gammas": "3"},
        {"state": "long 1"},
        {"nonsense": "1"},
    ],
)
def test_a_bad_link_opens_with_a_note(shipped, query):
    page = opened(**query)
    assert page.warning
    assert not page.error


@pytest.mark.parametrize("data", [b"", b"\x80\x04pickle", b"PK\x03\x04" + b"\0" * 90, b"\xff" * 200])
def test_a_file_that_is_no_checkpoint_is_refused_in_one_sentence(data):
    with pytest.raises(InputError) as refused:
        checkpoints.open_checkpoint("mine.safetensors", data)
    assert "mine.safetensors" in str(refused.value)


@pytest.mark.parametrize("environment", ENVIRONMENTS)
def test_every_environment_has_its_words(environment):
    scene, spec = scene_of(environment), environments.spec(environment)
    assert len(scene.actions) == spec.actions
    assert len(scene.states or scene.components) == spec.observation
    for part in scene.components:
        assert part.low <= part.start <= part.high
