"""The page of trained agents: opening, looking, and what a hostile file or link says."""

from __future__ import annotations

import json
import struct

import numpy as np
import pytest
from streamlit.testing.v1 import AppTest

from app.agents import schema
from app.catalogue import checkpoints
from app.session import KEY, crowd
from app.view import compute
from laplace_core import InputError, Settings
from laplace_core.acting import estimates
from laplace_core.acting.continuations import continue_from
from laplace_core.acting.cost import StepCost
from laplace_core.acting.flags import flag_steps
from laplace_core.acting.rollout import roll_out
from laplace_core.agents import ENVIRONMENTS, LaplaceSettings
from laplace_core.code.encoding import softening
from laplace_core.code.interpolation import with_added
from laplace_core.environments import environment_of, vector
from laplace_core.experiments import shipped_agents
from laplace_core.study.settings import resolve_for_gamma_space
from laplace_core.trained import observations, truths
from laplace_core.training.checkpoint import load_checkpoint, new_agent, save_checkpoint
from tests.support.lens_reference import unpacked
from tests.support.pages import MAIN, PATIENCE, charts, link, run, wait


@pytest.fixture
def shipped(tmp_path, monkeypatch):
    """Two untrained agents in place of those that ship."""
    for environment in ("CartPole-v1", "two_branch"):
        agent = new_agent(LaplaceSettings(environment=environment, hidden=8, features=4, theta_max=12.0))
        save_checkpoint(tmp_path / f"laplace_{environment}.safetensors", agent, 100, 21.5, episodes=20)
    monkeypatch.setattr(checkpoints, "SHIPPED", tmp_path)
    shipped_agents.forget()
    yield tmp_path
    shipped_agents.forget()


def opened(**query: str) -> AppTest:
    page = AppTest.from_file(MAIN, default_timeout=PATIENCE)
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
    shipped_agents.forget()
    page = opened()
    shipped_agents.forget()
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
    scene = environment_of("CartPole-v1")
    view = observations.view_of(loaded, scene, {"o.0": 0.5, "o.3": -1.0, "action": "push right"})
    found = compute.study_for(view)
    wanted = loaded.agent.gamma_space(np.array([0.5, 0.0, 0.0, -1.0]))
    np.testing.assert_array_equal(found.gamma_space.values, wanted.values)
    assert found.action_names == scene.actions
    assert view.action == 1


def test_a_tabular_agent_is_asked_about_a_state(shipped):
    page = opened(checkpoint="laplace_two_branch", state="long 1")
    assert next(box for box in page.selectbox if box.label == "State").value == "long 1"
    scene = environment_of("two_branch")
    assert observations.observation_of(scene, {"state": "long 1"}) == tuple(np.eye(3)[scene.states.index("long 1")])
    # The timeline of a world that is over after three steps has no more rows, as on the page of worlds.
    loaded = load_checkpoint(shipped / "laplace_two_branch.safetensors")
    assert observations.view_of(loaded, scene, {}).settings.steps == 3


def test_a_bad_link_opens_with_a_note(subtests, shipped):
    for query in [
        {"checkpoint": "laplace_pong"},
        {"checkpoint": "../../etc/passwd"},
        {"o.2": "9e9"},
        {"o.2": "nan"},
        {"o.77": "0"},
        {"alpha": "-1"},
        {"gammas": "3"},
        {"state": "long 1"},
        {"nonsense": "1"},
        {"added": "9"},
        {"added": "0.5"},
        {"slope_share": "0"},
        {"slope_share": "2"},
    ]:
        with subtests.test(query=query):
            page = opened(**query)
            assert page.warning
            assert not page.error


@pytest.mark.parametrize("data", [b"", b"\x80\x04pickle", b"PK\x03\x04" + b"\0" * 90, b"\xff" * 200])
def test_a_file_that_is_no_checkpoint_is_refused_in_one_sentence(data):
    with pytest.raises(InputError) as refused:
        checkpoints.open_checkpoint("mine.safetensors", data)
    assert "mine.safetensors" in str(refused.value)


def test_every_environment_has_its_words(subtests):
    for environment in ENVIRONMENTS:
        with subtests.test(environment):
            scene, spec = environment_of(environment), vector.spec(environment)
            assert len(scene.actions) == spec.actions
            assert len(scene.states or scene.components) == spec.observation
            for part in scene.components:
                assert part.low <= part.start <= part.high


def rolled_out(**query: str) -> AppTest:
    """The page once its rollout is there."""
    page = opened(**query)
    return wait(page, lambda page: not page.get("progress"))


def told(page: AppTest, component: str) -> dict:
    found = next(one.proto.bytes for one in page.get("bidi_component") if component in one.proto.component_name)
    (size,) = struct.unpack("<I", found[:4])
    return json.loads(found[4 : 4 + size])


def test_a_rollout_by_its_link_shows_the_exact_space_of_the_step(shipped):
    page = rolled_out(checkpoint="laplace_CartPole-v1", **{"r.shown": "yes", "r.seed": "5", "r.at": "4"})
    loaded = load_checkpoint(shipped / "laplace_CartPole-v1.safetensors")
    wanted = roll_out(loaded.agent, "CartPole-v1", 5)
    assert told(page, "player")["at"] == 4
    lens = told(page, "laplace_lens")
    assert lens["lead"] == {"id": told(page, "player")["id"], "step": 4}
    assert lens["followed"]["rewards"] == wanted.rewards[4:].tolist()
    _, arrays = lens_arrays(page)
    space = loaded.agent.gamma_space(wanted.observations[4])
    np.testing.assert_array_equal(arrays["differences"], space.differences)
    assert not [slider for slider in page.slider if "pole angle" in slider.label]


def test_the_button_rolls_out_and_the_way_back_leads_to_sliders(shipped):
    page = opened(checkpoint="laplace_CartPole-v1")
    next(button for button in page.button if button.label == "Roll out").click().run()
    wait(page, lambda page: "player" in str([one.proto.component_name for one in page.get("bidi_component")]))
    assert page.query_params["r.shown"] in ("yes", ["yes"])
    next(button for button in page.button if button.label.startswith("Edit the state")).click().run()
    assert not page.exception
    assert next(slider for slider in page.slider if "pole velocity" in slider.label).value != 0.0
    assert "r.shown" not in page.query_params


def test_a_bad_link_to_a_rollout_opens_with_a_note(subtests, shipped):
    for query in [
        {"r.seed": "-1"}, {"r.rule": "own"}, {"r.rule": "best"}, {"r.horizon": "0"}, {"r.at": "1e9"},
        {"r.gamma": "2"}, {"r.shown": "perhaps"}, {"r.after": "always"},
    ]:  # fmt: skip
        with subtests.test(query=query):
            page = rolled_out(**{"r.shown": "yes"} | query)
            assert page.warning
            assert not page.error


def test_a_step_beyond_the_end_is_the_last_one_and_named(shipped):
    page = rolled_out(checkpoint="laplace_two_branch", **{"r.shown": "yes", "r.at": "900", "r.rule": "random"})
    last = told(page, "player")["at"]
    assert 0 < last < 10
    assert link(page)["r.at"] == str(last)
    (note,) = (warning.value for warning in page.warning)
    assert "900, which is beyond the end" in note
    assert not page.exception
    (again,) = (warning.value for warning in run(page).warning)
    assert again == note


@pytest.mark.parametrize(
    ("query", "said"),
    [
        ({"horizon": "60", "steps": "20"}, "horizon 60 lies beyond the end of the timeline, 20"),
        ({"used": "70", "steps": "20"}, "used 70 lies beyond the end of the timeline, 20"),
        ({"r.horizon": "900", "r.rule": "readout"}, "r.horizon 900 is longer than any episode, 500"),
    ],
)
def test_a_value_that_could_only_be_clamped_is_named_and_left_out(shipped, query, said):
    values, notes = schema.LINK.read({"checkpoint": "laplace_CartPole-v1", **query})
    (note,) = notes
    assert said in note
    assert next(iter(query)) not in values


@pytest.fixture
def few(monkeypatch):
    """Simulations of a moment."""
    for bound, small in (("COUNT", 2), ("EPISODES", 2), ("EACH", 3), ("STEPS", 20)):
        monkeypatch.setattr(truths, bound, small)


def simulated(page: AppTest) -> AppTest:
    next(button for button in page.button if button.label == "Simulate").click().run()
    return wait(page, lambda page: "calibration" in charts(page))


def lens_arrays(page: AppTest) -> tuple[dict, dict]:
    message = next(one.proto.bytes for one in page.get("bidi_component") if "laplace_lens" in one.proto.component_name)
    (size,) = struct.unpack("<I", message[:4])
    return unpacked(message[4 + size :])


def test_without_chance_truth_is_that_of_many_states(shipped, few):
    page = rolled_out(checkpoint="laplace_CartPole-v1", **{"r.shown": "yes", "r.seed": "5"})
    assert "is deterministic" in words(page)
    page = simulated(page)
    assert {"simulated", "calibration"} <= set(charts(page))
    assert "simulated" not in lens_arrays(page)[0]


def test_with_chance_the_lens_gets_what_continuations_came_to(shipped, few):
    """Untold, of another rule than greedy, they are what tau-space predicts; and by wish, under that rule."""
    query = {"r.shown": "yes", "r.seed": "5", "r.rule": "random"}
    page = simulated(rolled_out(checkpoint="laplace_two_branch", **query))
    page = wait(page, lambda page: "2 continuations of 20 steps" in words(page))
    assert "greedy at γ" in words(page)
    assert "another policy" not in words(page)
    assert "simulated" not in charts(page)  # the lens shows it
    loaded = load_checkpoint(shipped / "laplace_two_branch.safetensors")
    rollout = roll_out(loaded.agent, "two_branch", 5, rule="random")
    header, arrays = lens_arrays(page)
    taken = int(rollout.actions[0])  # the lens looks at it, until another one is chosen
    found = continue_from(loaded.agent, rollout, 0, action=taken, count=2, steps=20)
    assert header["simulated"] == {"action": taken, "count": 2}
    np.testing.assert_allclose(arrays["simulated_lines"][0], found.rewards.mean(axis=0), rtol=1e-6)

    next(box for box in page.selectbox if box.label.startswith("Policy of the simulation")).set_value("rule").run()
    assert not page.exception
    assert page.query_params["r.after"] in ("rule", ["rule"])
    assert "then random. Tau-space predicts greedy at γ" in words(page)
    assert "simulated" not in lens_arrays(page)[0]  # of another process, and not begun


def test_what_is_simulated_is_of_its_state_and_action_only(shipped, few):
    query = {"r.shown": "yes", "r.seed": "6", "checkpoint": "laplace_two_branch"}
    wait(simulated(rolled_out(**query)), lambda page: "simulated" in lens_arrays(page)[0])
    assert "simulated" in lens_arrays(rolled_out(**query))[0]  # of the same state again, nothing is to be waited for
    assert "simulated" not in lens_arrays(rolled_out(**query, **{"r.at": "1"}))[0]
    rollout = roll_out(load_checkpoint(shipped / "laplace_two_branch.safetensors").agent, "two_branch", 6)
    other = ("long", "short")[int(rollout.actions[0])]  # actions are short and long
    assert "simulated" not in lens_arrays(rolled_out(**query, action=other))[0]


def test_the_link_adds_discounts_and_softens_the_slope(shipped):
    page = opened(checkpoint="laplace_CartPole-v1", added="2", slope_share="0.5")
    loaded = load_checkpoint(shipped / "laplace_CartPole-v1.safetensors")
    header, arrays = unpacked(payload_of(page))
    assert told(page, "laplace_lens")["state"]["slope_share"] == 0.5
    assert header["added"] == 2
    at = np.array(observations.observation_of(environment_of("CartPole-v1"), {}))
    space = with_added(loaded.agent.gamma_space(at), 2)
    np.testing.assert_array_equal(arrays["gammas"], space.gammas)
    np.testing.assert_array_equal(arrays["differences"], space.differences)
    np.testing.assert_array_equal(arrays["places"], loaded.agent.sensitivities.places)
    # What stands under the lens is of the softer slope, too.
    scene = environment_of("CartPole-v1")
    view = observations.view_of(loaded, scene, {"added": 2, "slope_share": 0.5})
    found = compute.study_for(view)
    soft = space.differences @ softening(loaded.agent.sensitivities.places, 0.5, open_ends=True)
    np.testing.assert_allclose(found.gamma_space.differences, soft, rtol=1e-9, atol=1e-9)
    listed = " ".join(each.proto.body for each in page.get("html"))
    assert all(artefact.sentence in listed for artefact in compute.artefacts_for(view))
    assert "noise does more than it shows" in words(page)


def payload_of(page: AppTest) -> bytes:
    message = next(one.proto.bytes for one in page.get("bidi_component") if "laplace_lens" in one.proto.component_name)
    return message[4 + struct.unpack_from("<I", message)[0] :]


def test_other_data_beside_the_same_state_leave_the_hand_its_last_word(shipped):
    """The lens is moved by another state only: a key pressed while the answer to a step is on its way stays."""
    page = rolled_out(checkpoint="laplace_CartPole-v1", **{"r.shown": "yes", "r.at": "1"})
    before = told(page, "laplace_lens")
    page.session_state["r.at"] = 2
    page.query_params["r.at"] = "2"
    page.run()
    after = told(page, "laplace_lens")
    assert after["id"] != before["id"]
    assert after["revision"] == before["revision"]


def test_the_artefacts_of_every_step_reach_the_player(shipped):
    page = rolled_out(checkpoint="laplace_CartPole-v1", alpha="0.001", **{"r.shown": "yes", "r.seed": "5"})
    wait(page, lambda page: told(page, "player")["flags"])
    rollout = roll_out(load_checkpoint(shipped / "laplace_CartPole-v1.safetensors").agent, "CartPole-v1", 5)
    settings = resolve_for_gamma_space(Settings(world="CartPole-v1", alpha=0.001), rollout.gammas)
    wanted, found = flag_steps(rollout, settings), told(page, "player")["flags"]
    assert found["alpha"] == 0.001
    assert found["names"] == list(wanted.names)
    assert [[bool(mark >> i & 1) for i in range(len(wanted.names))] for mark in found["marks"]] == wanted.marks.tolist()


def test_where_no_rollout_is_shown_nothing_is_simulated(shipped):
    assert "Simulate" not in [button.label for button in opened().button]


def test_added_discounts_leave_what_was_simulated_in_its_place(shipped, few):
    """Calibration used to fail with '+ 1 in each gap': the gamma-space has more discounts than the agent then."""
    page = simulated(rolled_out(checkpoint="laplace_two_branch", **{"r.shown": "yes", "r.seed": "5"}))
    page.session_state[KEY].shown_page.chosen["added"] = 1
    page.session_state[KEY].touched = True
    page.run()
    assert not page.exception
    assert not page.error
    assert unpacked(payload_of(page))[0]["added"] == 1
    assert "calibration" in charts(page)
    assert "simulated" in lens_arrays(page)[0]


def test_a_link_to_a_rollout_that_takes_long_says_how_long_and_waits_for_a_button(shipped, monkeypatch):
    monkeypatch.setattr(estimates, "cost_of", lambda *given, **more: StepCost(0.0, 0.0, 0.3))  # 500 steps: 150 seconds
    page = opened(checkpoint="laplace_CartPole-v1", **{"r.shown": "yes", "r.seed": "77"})
    assert "This takes about 2 minutes." in words(page)
    assert not page.get("progress")
    assert not any("player" in one.proto.component_name for one in page.get("bidi_component"))
    page.button(key="begin rollout").click().run()
    page = wait(page, lambda page: any("player" in one.proto.component_name for one in page.get("bidi_component")))
    assert told(page, "player")["at"] == 0


def test_a_rollout_that_takes_longer_than_the_server_allows_cannot_be_begun(shipped, monkeypatch):
    monkeypatch.setattr(estimates, "cost_of", lambda *given, **more: StepCost(0.0, 0.0, 60.0))  # 500 minutes
    page = opened(checkpoint="laplace_CartPole-v1", **{"r.shown": "yes", "r.seed": "78"})
    said = "This takes about 8 hours, and this server allows 10 minutes: lower T or choose a quicker rule."
    assert said in [warning.value for warning in page.warning]
    assert page.button(key="begin rollout").disabled


def test_an_action_that_the_agent_has_not_is_named_and_left_out(shipped):
    page = opened(checkpoint="laplace_CartPole-v1", action="nowhere")
    (note,) = page.warning
    assert "action 'nowhere' must be one of left, right" in note.value.replace("push ", "")


def test_solver_rule_and_noise_level_are_settings_of_an_agent_too(shipped, monkeypatch):
    monkeypatch.setattr(crowd, "alone", lambda: False)  # so that nothing waits for the test of the values
    page = opened(checkpoint="laplace_two_branch", solver="nonnegative", selector="lcurve", noise_level="0.01")
    assert not page.warning
    message = next(block.proto.bytes for block in page.get("bidi_component") if "lens" in block.proto.component_name)
    (size,) = struct.unpack("<I", message[:4])
    told, header = json.loads(message[4 : 4 + size]), unpacked(message[4 + size :])[0]
    assert (header["solver"], told["rule"], told["state"]["selector"]) == ("nonnegative", "L-curve bend", "lcurve")
    assert told["state"]["alpha"] != 1.0
    box = next(each for each in page.selectbox if each.label == "Alpha rule")
    box.select("typed")
    run(page)
    assert float(link(page)["alpha"]) == pytest.approx(told["state"]["alpha"], rel=1e-3)
    assert link(page)["weighting"] == "deviation"
