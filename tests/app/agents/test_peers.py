"""The page of trained agents with agents that have no gamma-space, and returns in different codes side by side."""

from __future__ import annotations

import time
from functools import partial

import numpy as np
import pytest
from streamlit.testing.v1 import AppTest

from app.catalogue import checkpoints
from laplace_core import InputError
from laplace_core.acting.return_laws import return_laws, simulate_returns
from laplace_core.acting.rollout import roll_out
from laplace_core.agents.settings import SETTINGS, algorithm_title
from laplace_core.experiments import shipped_agents
from laplace_core.experiments.shipping import TrainingCurve
from laplace_core.training.checkpoint import load_checkpoint, new_agent, save_checkpoint
from tests.app.agents.test_page import opened, rolled_out, told, words
from tests.support.pages import charts, numbers, wait

WORLD = "two_branch"
PEERS = ("c51", "qrdqn", "expectile", "dqn", "fixed_horizon")


def made(folder, algorithm, environment=WORLD):
    extra = {"features": 4, "theta_max": 12.0} if algorithm == "laplace" else {}
    agent = new_agent(SETTINGS[algorithm](environment=environment, hidden=8, **extra))
    path = folder / f"{algorithm}_{environment}.safetensors"
    save_checkpoint(path, agent, 100, 21.5, episodes=20)
    return path


@pytest.fixture
def shipped(tmp_path, monkeypatch):
    """Untrained agents of every algorithm in place of those that ship."""
    for algorithm in SETTINGS:
        made(tmp_path, algorithm)
    made(tmp_path, "laplace", "CartPole-v1")
    made(tmp_path, "qrdqn", "CartPole-v1")
    (tmp_path / "a_td.safetensors").write_bytes(b"opens on the page of worlds")
    monkeypatch.setattr(checkpoints, "SHIPPED", tmp_path)
    shipped_agents.forget()
    yield tmp_path
    shipped_agents.forget()


def simulated(page: AppTest) -> AppTest:
    """The page once the observed returns are there."""
    page.button(key="simulate returns").click().run()
    return wait(page, lambda page: "Shaded: W1" in words(page))


def test_all_that_ships_is_listed_those_with_many_discounts_first(shipped):
    assert checkpoints.shipped() == (
        "laplace_CartPole-v1", "laplace_two_branch", "qrdqn_CartPole-v1",
        *(f"{name}_two_branch" for name in PEERS),
    )  # fmt: skip
    page = opened()
    assert page.selectbox(key="checkpoint").options[:3] == [
        "CartPole · Laplace DQN", "two_branch · Laplace DQN", "CartPole · QR-DQN",
    ]  # fmt: skip
    assert page.selectbox(key="checkpoint").options[-1] == "two_branch · Fixed-horizon DQN"


@pytest.mark.parametrize("algorithm", PEERS)
def test_a_peer_has_its_card_its_player_and_what_it_has_learned(shipped, algorithm):
    page = rolled_out(checkpoint=f"{algorithm}_{WORLD}", **{"r.shown": "yes", "r.seed": "2"})
    assert not page.error
    assert not page.warning
    assert algorithm_title(algorithm) in words(page)
    assert "21.5 over 20 episodes" in words(page)
    assert told(page, "player")["at"] == 0
    drawn = charts(page)
    agent = load_checkpoint(shipped / f"{algorithm}_{WORLD}.safetensors").agent
    seen = roll_out(agent, WORLD, 2, rule="own" if algorithm == "fixed_horizon" else "greedy").observations[0]
    if algorithm == "fixed_horizon":
        np.testing.assert_allclose(
            numbers(drawn["state"]["data"][1]["y"]), agent.action_values(seen[None])[0][:, 1], rtol=1e-6
        )
        assert page.selectbox(key="r.rule").options[0].startswith("for T")
    elif algorithm == "dqn":
        values = [bar["x"][0] for bar in drawn["state"]["data"]]
        np.testing.assert_allclose(values, agent.action_values(seen[None], 0)[0], rtol=1e-6)
    else:
        assert len(drawn["state"]["data"]) == 4  # a law and a mean for each of two actions
        assert [trace["name"] for trace in drawn["episode"]["data"]][:2] == ["80%", "50%"]
    assert {"state", "episode", "codes"} <= set(drawn)
    # The four that say more than a mean, and the opened one where it says anything of the whole return.
    panels = [note["text"] for note in drawn["codes"]["layout"]["annotations"]]
    assert len(panels) == (5 if algorithm == "dqn" else 4)
    assert "<b>Laplace DQN, if steps were independent</b>" in panels
    assert "<b>Expectile DQN, imputed</b>" in panels


def test_without_a_rollout_a_state_is_edited(shipped):
    page = opened(checkpoint="qrdqn_CartPole-v1", **{"o.2": "0.1", "action": "push right"})
    agent = load_checkpoint(shipped / "qrdqn_CartPole-v1.safetensors").agent
    law = return_laws(agent, np.array([0, 0, 0.1, 0]))[1]
    assert charts(page)["state"]["data"][3]["x"] == pytest.approx([law.mean])
    assert "Roll out" in words(page)
    assert "simulate returns" not in [button.key for button in page.button]


def test_what_comes_stands_beside_what_was_learned(shipped, monkeypatch):
    seven = partial(simulate_returns, count=7)
    monkeypatch.setattr("laplace_core.acting.return_laws.simulate_returns", seven)
    page = rolled_out(checkpoint=f"c51_{WORLD}", **{"r.shown": "yes", "r.action": "long"})
    heights = charts(page)["codes"]["layout"]["height"]
    page = simulated(page)
    drawn = charts(page)["codes"]
    assert drawn["layout"]["height"] == heights
    loaded = load_checkpoint(shipped / f"c51_{WORLD}.safetensors")
    wanted = simulate_returns(loaded.agent, roll_out(loaded.agent, WORLD, 0), 0, 1, count=7)
    law = return_laws(loaded.agent, roll_out(loaded.agent, WORLD, 0).observations[0], [1])[0]
    notes = [note["text"] for note in drawn["layout"]["annotations"]]
    assert notes[:2] == ["<b>C51</b>", f"W1 {wanted.distance(law):.3g}"]
    assert len(notes) == 8
    table = next(html.proto.body for html in page.get("html") if "by chance" in html.proto.body)
    assert f"{wanted.mean[0]:.4g} ± {wanted.mean[1]:.2g}" in table


def test_the_action_taken_follows_the_cursor_until_another_is_chosen(shipped):
    loaded = load_checkpoint(shipped / "qrdqn_CartPole-v1.safetensors")
    rollout, link = roll_out(loaded.agent, "CartPole-v1", 5, rule="random"), {"r.shown": "yes", "r.seed": "5"}
    first, other = 0, int(np.flatnonzero(rollout.actions != rollout.actions[0])[0])
    for at in (first, other):
        page = rolled_out(checkpoint="qrdqn_CartPole-v1", **link, **{"r.rule": "random", "r.at": str(at)})
        heavy = [trace["line"]["width"] for trace in charts(page)["state"]["data"][:2]]
        assert int(np.argmax(heavy)) == rollout.actions[at]
    page.get("button_group")[0].set_value("push left").run()
    assert page.query_params["r.action"] in ("push left", ["push left"])
    assert charts(page)["state"]["data"][0]["line"]["width"] == 3


def test_where_nothing_is_by_chance_one_line_says_all(shipped):
    page = rolled_out(checkpoint="qrdqn_CartPole-v1", **{"r.shown": "yes", "r.seed": "5", "r.at": "4"})
    assert "once, because nothing here is random" in words(page)
    drawn = charts(simulated(page))["codes"]
    assert "observed (always)" in [trace.get("name") for trace in drawn["data"]]


def test_a_laplace_agent_has_the_codes_under_its_lens(shipped):
    page = rolled_out(checkpoint="laplace_CartPole-v1", **{"r.shown": "yes", "alpha": "0.1"})
    panels = [note["text"] for note in charts(page)["codes"]["layout"]["annotations"]]
    assert panels == ["<b>Laplace DQN, if steps were independent</b>", "<b>QR-DQN</b>"]
    assert "at α 0.1" in words(page)


def test_a_file_of_a_peer_is_opened_and_stands_beside_what_ships(shipped, tmp_path):
    other = tmp_path / "other"
    other.mkdir()
    agent = new_agent(SETTINGS["qrdqn"](environment="CartPole-v1", hidden=9))
    save_checkpoint(other / "mine.safetensors", agent, 7, None)
    page = opened(checkpoint="qrdqn_CartPole-v1")
    page.file_uploader[0].upload("mine.safetensors", (other / "mine.safetensors").read_bytes(), "application/x").run()
    assert not page.exception
    assert page.selectbox(key="checkpoint").options[-1] == "opened file: CartPole · QR-DQN"
    assert "not evaluated" in words(page)
    panels = [note["text"] for note in charts(page)["codes"]["layout"]["annotations"]]
    assert panels == ["<b>QR-DQN (opened)</b>", "<b>Laplace DQN, if steps were independent</b>", "<b>QR-DQN</b>"]


@pytest.mark.parametrize(
    "spoil", [lambda data: data[:-40], lambda data: data.replace(b"qrdqn", b"drdqn"), lambda data: b""]
)
def test_a_spoiled_file_of_a_peer_is_one_sentence(shipped, spoil):
    data = (shipped / "qrdqn_CartPole-v1.safetensors").read_bytes()
    with pytest.raises(InputError) as refused:
        checkpoints.open_checkpoint("mine.safetensors", spoil(data))
    assert "\n" not in str(refused.value)


@pytest.mark.parametrize("query", [{"r.gamma": "0.9"}, {"r.rule": "fading"}, {"r.rule": "own"}, {"r.action": "up"}])
def test_a_bad_link_to_a_peer_opens(shipped, query):
    page = rolled_out(checkpoint="qrdqn_CartPole-v1", **{"r.shown": "yes"} | query)
    assert not page.error
    assert bool(page.warning) == ("r.action" not in query)


def test_the_card_draws_how_the_score_came_about(shipped, monkeypatch):
    told = (TrainingCurve(1, (50.0, 100.0), (3.0, 21.5), (1.0, 1.0)), TrainingCurve(0, (50.0,), (2.0,), (1.0,)))
    monkeypatch.setattr(shipped_agents, "curves", lambda folder, name: told if name == f"c51_{WORLD}" else ())
    monkeypatch.setattr(shipped_agents.curves, "cache_clear", lambda: None, raising=False)
    drawn = charts(opened(checkpoint=f"c51_{WORLD}"))["card"]["data"]
    assert [trace["x"] for trace in drawn] == [[50.0], [50.0, 100.0], [100]]  # the shown seed over the others
    assert "card" not in charts(opened(checkpoint=f"dqn_{WORLD}"))


def test_what_ships_has_its_curves():
    for name in checkpoints.shipped():
        curves = checkpoints.curves(name)
        if curves:
            loaded = checkpoints.checkpoint(name)
            assert curves[0].seed == loaded.seed
            assert loaded.step in curves[0].steps


def test_a_cancelled_simulation_is_asked_for_anew(shipped, monkeypatch):
    def slow(agent, rollout, step, action, *, progress):
        for i in range(10_000):
            progress(i, 10_000)
            time.sleep(0.01)

    monkeypatch.setattr("laplace_core.acting.return_laws.simulate_returns", slow)
    page = rolled_out(checkpoint=f"c51_{WORLD}", **{"r.shown": "yes"})
    page.button(key="simulate returns").click().run()
    page.button(key="cancel returns").click().run()
    wait(page, lambda page: any(button.key == "simulate returns" for button in page.button))
    assert "Simulated: " in words(page)
