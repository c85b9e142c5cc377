"""The page of the deadline race: opening it, its words, the picture of many races, and what a bad link says."""

from __future__ import annotations

import json
import struct
import time
from pathlib import Path

import numpy as np
import plotly.graph_objects as go
import pytest
from streamlit.testing.v1 import AppTest

from app.catalogue import checkpoints
from app.components.track import COLOURS
from app.race import jobs
from laplace_core import figures
from laplace_core.acting import estimates
from laplace_core.acting.cost import StepCost
from laplace_core.acting.race import Entrant, Races, race
from laplace_core.acting.race import races as races_of
from laplace_core.agents import SETTINGS, LaplaceSettings
from laplace_core.experiments import shipped_agents
from laplace_core.figures.race import piles
from laplace_core.payloads.track import payload
from laplace_core.trained import races as trained
from laplace_core.trained.races import Control
from laplace_core.training.checkpoint import Loaded, load_checkpoint, new_agent, save_checkpoint
from tests.support.pages import MAIN, PATIENCE, charts, link, press, run, wait


def saved(path: Path, settings) -> None:
    save_checkpoint(path, new_agent(settings), 100, 21.5, episodes=20)


@pytest.fixture
def shipped(tmp_path, monkeypatch):
    """Two untrained agents in place of those that ship."""
    for environment in ("CartPole-v1", "two_branch"):
        small = LaplaceSettings(environment=environment, hidden=8, features=4, gammas=5, thetas=9, theta_max=12.0)
        saved(tmp_path / f"laplace_{environment}.safetensors", small)
    monkeypatch.setattr(checkpoints, "SHIPPED", tmp_path)
    shipped_agents.forget()
    yield tmp_path
    shipped_agents.forget()


def settled(page: AppTest) -> AppTest:
    """The page once nothing is under way."""
    return wait(run(page), lambda page: not page.get("progress"))


def opened(**query: str) -> AppTest:
    page = AppTest.from_file(MAIN, default_timeout=PATIENCE)
    page.switch_page("screens/race.py")
    for name, value in query.items():
        page.query_params[name.replace("_", ".", 1) if name.startswith("d_") else name] = value
    return settled(page)


def verdicts(page: AppTest) -> list[str]:
    return [html.proto.body for html in page.get("html") if "race-verdict" in html.proto.body]


def told(page: AppTest) -> tuple[dict, bytes]:
    found = next(one.proto.bytes for one in page.get("bidi_component") if "track" in one.proto.component_name)
    (size,) = struct.unpack("<I", found[:4])
    return json.loads(found[4 : 4 + size]), found[4 + size :]


def test_without_an_agent_the_page_says_how_to_get_one(tmp_path, monkeypatch):
    monkeypatch.setattr(checkpoints, "SHIPPED", tmp_path)
    shipped_agents.forget()
    page = opened()
    shipped_agents.forget()
    assert "train one" in page.info[0].value


def test_it_opens_on_a_race_that_is_the_library_s(shipped):
    page = opened(checkpoint="laplace_CartPole-v1", d_start="4", d_T="30")
    agent = load_checkpoint(shipped / "laplace_CartPole-v1.safetensors").agent
    wanted = race("CartPole-v1", Entrant(agent), Entrant(agent, "fading"), 4, horizon=30, pictures=True)
    shown, packed = told(page)
    assert shown["names"] == ["greedy", "fading deadline"]
    assert shown["at"] == max(len(wanted.left), len(wanted.right))
    assert packed == payload(wanted)
    assert f"{wanted.right.rewards.sum():.1f}" in verdicts(page)[0]


def test_a_change_of_the_deadline_is_another_race_shown_at_its_end(shipped):
    page = opened(checkpoint="laplace_CartPole-v1", d_T="30", d_at="3")
    assert told(page)[0]["at"] == 3
    page.select_slider[0].set_value(5)
    settled(page)
    assert link(page)["d.T"] == "5"
    assert "d.at" not in link(page)
    assert "Within 5 steps" in verdicts(page)[0]


def test_a_step_beyond_the_end_of_both_is_the_last_one_and_named(shipped):
    page = opened(checkpoint="laplace_CartPole-v1", d_T="30", d_at="900")
    (note,) = (warning.value for warning in page.warning)
    assert "900, which is beyond the end" in note
    assert 0 < int(link(page)["d.at"]) <= 30


def test_many_starts_are_raced_over_on_a_click_and_lead_to_one(shipped):
    page = opened(checkpoint="laplace_CartPole-v1", d_T="60", d_starts="12")
    press(page, "Race over 12 starts")
    settled(page)
    agent = load_checkpoint(shipped / "laplace_CartPole-v1.safetensors").agent
    wanted = races_of("CartPole-v1", Entrant(agent), Entrant(agent, "fading"), 60, count=12)
    assert (wanted.differences != 0).any()
    assert "Over 12 starts" in verdicts(page)[1]
    dots = charts(page)["differences"]["data"][2]
    np.testing.assert_allclose(dots["x"], wanted.differences)
    press(page, "best")
    settled(page)
    assert link(page)["d.start"] == str(wanted.notable()["best"])
    assert f"from start {wanted.notable()['best']}" in verdicts(page)[0]
    assert page.number_input[0].value == wanted.notable()["best"]


def test_cancel_leads_back_to_the_button(shipped, monkeypatch):
    real = trained.races

    def slow(*given, progress, **named):
        while True:
            time.sleep(0.02)
            progress(1, 100)

    monkeypatch.setattr(trained, "races", slow)
    page = run(opened(checkpoint="laplace_two_branch", d_starts="3"))
    press(page, "Race over 3 starts")
    assert page.get("progress")
    press(page, "Cancel")
    assert "Race over 3 starts" in [button.label for button in page.button]
    assert "d.many" not in link(page)
    monkeypatch.setattr(trained, "races", real)
    press(page, "Race over 3 starts")
    settled(page)
    assert "Over 3 starts" in verdicts(page)[1]


def test_another_agent_can_be_the_left_side(shipped):
    other = LaplaceSettings(environment="CartPole-v1", hidden=8, features=4, gammas=3, thetas=5, theta_max=3.0, seed=1)
    saved(shipped / "laplace_CartPole-v1_other.safetensors", other)
    shipped_agents.forget()
    page = opened(checkpoint="laplace_CartPole-v1", d_T="30", d_gamma="0.5", d_at="2")
    gammas = load_checkpoint(shipped / "laplace_CartPole-v1.safetensors").agent.gammas
    assert told(page)[0]["names"][0] == f"greedy (γ {gammas[abs(gammas - 0.5).argmin()]:.3g})"
    box = next(box for box in page.selectbox if box.label == "Agent of the left side")
    assert box.options == ["the same agent", "CartPole-v1_other · Laplace DQN"]
    box.set_value("laplace_CartPole-v1_other")
    settled(page)
    assert link(page) == {"checkpoint": "laplace_CartPole-v1", "d.T": "30", "d.against": "laplace_CartPole-v1_other"}
    left, right = (load_checkpoint(shipped / f"laplace_CartPole-v1{end}.safetensors").agent for end in ("_other", ""))
    wanted = race("CartPole-v1", Entrant(left), Entrant(right, "fading"), 0, horizon=30, pictures=True)
    assert told(page)[1] == payload(wanted)
    assert "greedy, other agent" in told(page)[0]["names"]


@pytest.mark.parametrize("algorithm", ["c51", "fixed_horizon"])
def test_an_agent_without_a_gamma_space_races_on_either_side(shipped, algorithm):
    saved(shipped / f"{algorithm}_CartPole-v1.safetensors", SETTINGS[algorithm](hidden=8))
    shipped_agents.forget()
    name, rule = {"c51": ("C51", "greedy"), "fixed_horizon": ("Fixed-horizon DQN", "own")}[algorithm]
    page = opened(checkpoint="laplace_CartPole-v1", d_T="9", d_against=f"{algorithm}_CartPole-v1", d_left=rule)
    words = {"greedy": "greedy", "own": "learned values"}[rule]
    assert told(page)[0]["names"] == [f"{name}: {words}", "Laplace DQN: fading deadline"]
    left, right = (load_checkpoint(shipped / f"{one}_CartPole-v1.safetensors").agent for one in (algorithm, "laplace"))
    wanted = race("CartPole-v1", Entrant(left, rule), Entrant(right, "fading"), 0, horizon=9, pictures=True)
    assert told(page)[1] == payload(wanted)
    page = opened(checkpoint=f"{algorithm}_CartPole-v1", d_T="9", d_against="laplace_CartPole-v1")
    assert told(page)[0]["names"] == ["Laplace DQN: greedy", f"{name}: {words}"]


def test_an_agent_of_a_world_races_as_far_as_suits_it(shipped):
    """two_branch is over after at most 3 steps: T goes to 4 times that, and no picture is drawn."""
    page = opened(checkpoint="laplace_two_branch")
    assert "Within 3 steps" in verdicts(page)[0]
    assert page.select_slider[0].options[-1] == "12"
    assert "GIF" not in [button.label for button in page.get("download_button")]


def test_a_bad_link_opens_with_a_note(subtests, shipped):
    for query in [
        {"checkpoint": "laplace_pong"}, {"d_T": "0"}, {"d_T": "9999"}, {"d_start": "-1"}, {"d_left": "best"},
        {"d_right": "own"}, {"d_gamma": "2"}, {"d_starts": "1"}, {"d_at": "x"}, {"d_many": "perhaps"},
        {"d_against": "laplace_two_branch"}, {"nonsense": "1"},
    ]:  # fmt: skip
        with subtests.test(query=query):
            page = opened(**{"checkpoint": "laplace_CartPole-v1"} | query)
            assert page.warning
            assert not page.error
            assert verdicts(page)


def loaded(tmp_path, name: str, settings) -> Loaded:
    saved(tmp_path / name, settings)
    return load_checkpoint(tmp_path / name)


@pytest.fixture
def control(tmp_path) -> Control:
    one = loaded(tmp_path, "a.safetensors", LaplaceSettings(environment="two_branch", hidden=4, features=4, gammas=3))
    return Control(one, "greedy", None, one, "fading", 3)


def test_the_payload_holds_both_sides_and_where_their_pictures_end(tmp_path):
    one = loaded(tmp_path, "a.safetensors", LaplaceSettings(hidden=8, features=4, gammas=3, theta_max=3.0))
    found = race("CartPole-v1", Entrant(one.agent), Entrant(one.agent, "fading"), 1, horizon=9, pictures=True)
    data = payload(found)
    (size,) = struct.unpack("<I", data[:4])
    head, pictures = json.loads(data[4 : 4 + size]), data[4 + size :]
    left, right = head["sides"]
    assert (left["rewards"], right["actions"]) == (found.left.rewards.tolist(), found.right.actions.tolist())
    assert pictures[left["ends"][3] : left["ends"][4]] == found.left.frames[4]
    assert pictures[left["ends"][-1] : right["ends"][0]] == found.right.frames[0]
    assert right["ends"][-1] == len(pictures)


def many(left, right) -> Races:
    steps = np.full(len(left), 5)
    return Races("CartPole-v1", 5, np.arange(len(left)), np.array(left), np.array(right), steps, steps)


@pytest.mark.parametrize("returns", [([1.0, 2.0, 3.0], [4.0, 2.0, 2.5]), ([1.0, 1.0], [1.0, 1.0])])
def test_plotly_takes_the_picture_of_many_races(returns):
    found = many(*returns)
    figure = figures.differences(found, 0.5, (-0.5, 1.5), 1, colours=COLOURS, names=("greedy", "fading"))
    go.Figure(figure)
    figures.to_json(figure)
    assert [row[0] for row in figure["data"][2]["customdata"]] == found.starts.tolist()


def test_dots_of_one_bin_are_piled_up_in_their_order():
    """Bins are 1/36 wide from 0 to 1: 0, .01 and .02 lie in the first, 1 in the last."""
    height, reach = piles(np.array([0.02, 0.0, 1.0, 0.01]))
    assert height.tolist() == [3.0, 1.0, 1.0, 2.0]
    assert reach == 3


def slow_steps(monkeypatch, seconds: float) -> None:
    """Every step takes so long, as far as estimates go."""
    monkeypatch.setattr(estimates, "cost_of", lambda *given, **more: StepCost(0.0, 0.0, seconds))


def captions(page: AppTest) -> str:
    return " ".join(caption.value for caption in page.caption)


def test_a_link_starts_no_long_race_and_says_what_its_races_cost(shipped, monkeypatch):
    """A race of 2 x 30 steps of .5 s takes 30 s; 6 of them 3 minutes."""
    slow_steps(monkeypatch, 0.5)
    page = opened(checkpoint="laplace_CartPole-v1", d_T="30", d_start="41", d_many="yes", d_starts="6")
    assert not page.get("progress")
    assert not page.get("bidi_component")
    assert "This takes about 30 seconds." in captions(page)
    assert "This takes about 3 minutes." in captions(page)
    settled(press(page, "Race"))
    assert "from start 41" in verdicts(page)[0]
    settled(press(page, "Race over 6 starts"))
    assert "Over 6 starts" in verdicts(page)[1]


def test_races_that_take_longer_than_the_server_allows_are_refused_with_what_to_lower(shipped, monkeypatch):
    """500 starts of 2 x 500 steps of .06 s: 30,000 s, some 8 hours in the one thread there was."""
    slow_steps(monkeypatch, 0.06)
    page = opened(checkpoint="laplace_CartPole-v1", d_T="500", d_start="42", d_many="yes", d_starts="500")
    said = "This takes about 8 hours, and this server allows 10 minutes: lower T or the number of starts, or choose"
    assert [warning.value.startswith(said) for warning in page.warning] == [True]
    assert [button.disabled for button in page.button if button.label == "Race over 500 starts"] == [True]
    assert [button.disabled for button in page.button if button.label == "Race"] == [False]


def test_the_estimate_counts_both_sides_and_groups_of_a_hundred(control, monkeypatch):
    """T = 3. One race: 2 x 3 steps of 1 + 2 + 10. Of 250 starts: groups of 100, 100 and 50; 2 x 3 x (3 + 250 x 12)."""
    monkeypatch.setattr(estimates, "cost_of", lambda *given, pictures=False: StepCost(1.0, 2.0, 10.0))
    assert jobs.racing(control, 0).estimate() == 2 * 3 * 13
    assert jobs.field(control, 250).estimate() == 2 * 3 * (3 + 250 * 12)


def test_twenty_races_of_as_many_sessions_all_finish(control):
    """More than are kept: each used to drive out the one before it."""
    wishes = [jobs.racing(control, start) for start in range(20)]
    asked = [wish.kind.take(wish.key, wish.make, 20.0, f"session {start}") for start, wish in enumerate(wishes)]
    assert [job.result()[0].start for job in asked] == list(range(20))


def test_a_command_names_where_an_agent_lies(shipped):
    names = ("run:mine", "laplace_two_branch", "0123456789ab")
    files = ["runs/mine/best.safetensors", "checkpoints/laplace_two_branch.safetensors", "opened.safetensors"]
    assert [checkpoints.file_of(name) for name in names] == files
