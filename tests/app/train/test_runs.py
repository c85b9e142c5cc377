"""The page of training: cards and pictures of runs, their files, and the way to the other pages."""

from __future__ import annotations

import json
import shlex
from dataclasses import replace

import numpy as np

from app.catalogue import checkpoints
from app.train import schema
from laplace_core.agents.settings import SETTINGS, LoopSettings
from laplace_core.cli import main
from laplace_core.training.defaults import settings_of
from laplace_core.training.queue import Queue
from laplace_core.training.run_folder import new_run, read_config
from tests.laplace_core.training.test_curves import STORY
from tests.support.hostile import assert_one_sentence
from tests.support.pages import charts, copied, downloads, labels, link, numbers, press, run, wait
from tests.support.quick_runs import SMALL, states, tell
from tests.support.train_page import FORM, NAME, made, opened, with_cookie, words


def shown(figure: dict) -> list[str]:
    """What its legend names."""
    return [trace["name"] for trace in figure["data"] if trace.get("showlegend")]


def test_what_ships_is_there_before_and_behind_own_runs(runs):
    page = opened(environment="LunarLander-v3")
    algorithms = ("Laplace DQN", "C51", "QR-DQN", "DQN")
    assert shown(charts(page)["shipped"]) == [f"{name}, 5 seeds" for name in algorithms]
    medians = [trace for trace in charts(page)["shipped"]["data"] if trace.get("showlegend")]
    assert {trace["line"]["dash"] for trace in medians} == {"solid"}
    curves = checkpoints.shipped_curves("LunarLander-v3")["dqn"]
    np.testing.assert_allclose(
        numbers(medians[3]["y"])[-1], np.median([curve.scores[-1] for curve in curves]), rtol=0.02
    )
    assert "shipped" not in charts(opened(environment="two_branch"))  # nothing ships for it
    made(runs, "own", settings=settings_of("qrdqn", "Acrobot-v1", {}))
    assert shown(charts(opened())["training"]) == ["shipped QR-DQN, 5 seeds", "QR-DQN, seed 0 (own)"]
    made(runs, "toy")
    assert shown(charts(opened(run="toy"))["training"]) == ["Laplace DQN, seed 0 (toy)"]


def test_a_card_tells_how_far_and_how_good(runs):
    made(runs, "one")
    told = words(opened())
    assert "Laplace DQN" in told
    assert "seed 0" in told
    assert "stopped" in told
    assert "75 of 600 steps" in told
    assert "return now 5 over 4 episodes" in told
    assert "best evaluation 9 ± 0.5 at step 75" in told
    assert "steps 600" in told  # not what suits the world


def test_cancel_and_resume(runs):
    page = press(opened(**FORM), "Start training")
    wait(page, lambda page: states(runs)[NAME] == "training")
    press(run(page), "Cancel")
    assert "stopped" in words(page)
    press(page, "Resume")
    wait(page, lambda page: states(runs)[NAME] == "training")
    run(page)
    tell(runs, NAME, "finish")
    wait(page, lambda page: "finished" in words(page))
    assert "Resume" not in labels(page)


def test_another_tab_of_the_browser_has_the_same_runs(runs, monkeypatch):
    with_cookie(monkeypatch, "a" * 43)
    press(opened(**FORM), "Start training")
    assert NAME in {one.name for one in runs.runs()}
    other = opened()
    assert "seed 3" in words(other)
    press(wait(other, lambda page: "Cancel" in labels(page)), "Cancel")
    assert "stopped" in words(opened())


def test_runs_that_another_server_has_left_in_line_begin_while_the_page_is_looked_at(runs, monkeypatch):
    page = opened()
    with monkeypatch.context() as other:
        other.setattr(Queue, "wake", lambda self: None)
        name = Queue(runs.folder).add(SMALL)
    wait(run(page), lambda page: states(runs)[name] == "training")
    assert states(runs) == {name: "training"}


def test_a_crash_is_one_sentence(runs):
    page = press(opened(**FORM), "Start training")
    wait(page, lambda page: states(runs)[NAME] == "training")
    tell(runs, NAME, "crash")
    wait(page, lambda page: "failed" in words(page))
    assert "Training broke off: the lamp went out" in words(page)
    assert "Traceback" not in words(page)


def test_curves_of_runs_of_one_environment_stand_side_by_side(runs):
    other = settings_of("laplace", "CartPole-v1", {})
    for name, settings in (("one", SMALL), ("two", replace(SMALL, seed=1)), ("pole", other)):
        made(runs, name, settings=settings)
    page = opened(run="one")
    drawn = charts(page)["training"]["data"]
    assert len(drawn) == 6  # three traces of two runs
    assert numbers(drawn[4]["y"]).tolist() == [4, 9, 9]
    page.button(key="show pole").click()
    assert len(charts(run(page))["training"]["data"]) == 5  # and two of what ships
    assert link(page)["run"] == "pole"


def test_runs_beside_it_are_picked_and_in_the_link(runs):
    for seed in range(3):
        made(runs, f"run_{seed}", settings=replace(SMALL, seed=seed))
    page = opened(run="run_0", beside="run_2")
    assert len(charts(page)["training"]["data"]) == 6
    page.get("button_group")[0].set_value([])
    run(page)
    assert link(page)["beside"] == schema.NOTHING
    assert len(charts(page)["training"]["data"]) == 3
    assert len(charts(opened(**link(page)))["training"]["data"]) == 3


def test_agents_that_ship_are_picked_and_in_the_link(runs):
    made(runs, "own", settings=settings_of("qrdqn", "Acrobot-v1", {}))
    page = opened()
    page.get("button_group")[0].set_value(["c51", "laplace"])
    run(page)
    assert link(page)["ships"] == "c51,laplace"
    wanted = ["shipped Laplace DQN, 5 seeds", "shipped C51, 5 seeds", "QR-DQN, seed 0 (own)"]
    assert shown(charts(page)["training"]) == wanted
    assert shown(charts(opened(**link(page)))["training"]) == wanted
    assert len({trace["line"]["color"] for trace in charts(page)["training"]["data"] if trace.get("showlegend")}) == 3
    page.get("button_group")[0].set_value([])
    run(page)
    assert link(page)["ships"] == schema.NOTHING
    assert shown(charts(page)["training"]) == wanted[2:]


def test_values_of_every_discount_stand_against_what_came(runs):
    told = json.loads(STORY.splitlines()[2])
    told |= {"values": [1.0, 2.0, 3.0, 4.0], "discounted": [1.0, 2.5, 3.0, 8.0], "discounted_errors": [0.0] * 4}
    made(runs, "one", story=STORY.splitlines()[0] + "\n" + json.dumps(told) + "\n")
    drawn = charts(opened())
    assert len(drawn["discounts"]["data"]) == 5  # four discounts and their colours
    assert [trace["y"] for trace in drawn["value at the start"]["data"]] == [told["discounted"], told["values"]]


def test_the_values_of_a_peer_stand_against_what_came_at_its_one_discount(runs):
    told = json.loads(STORY.splitlines()[2])
    told |= {"values": [7.0], "discounted": [3.0], "discounted_errors": [0.0]}
    story = STORY.splitlines()[0] + "\n" + json.dumps(told) + "\n"
    made(runs, "one", settings=settings_of("dqn", "Acrobot-v1", {}), story=story)
    drawn = charts(opened())
    assert set(drawn) == {"training", "discounts"}
    (line,) = drawn["discounts"]["data"]
    np.testing.assert_allclose(numbers(line["y"]), [0.01 * (7.0 - 3.0)])
    assert "gamma 0.99" in drawn["discounts"]["layout"]["title"]["text"]
    made(runs, "other", settings=settings_of("fixed_horizon", "Acrobot-v1", {}))
    assert set(charts(opened(run="other"))) == {"training"}


def test_an_algorithm_without_many_discounts_has_one_picture_and_opens_as_well(runs, monkeypatch):
    class PlainSettings(LoopSettings):
        ALGORITHM = "plain"
        TITLE = "Plain"

    monkeypatch.setitem(SETTINGS, "plain", PlainSettings)
    made(runs, "one", settings=PlainSettings())
    (runs.folder / "one" / "best.safetensors").write_bytes(b"")
    page = opened()
    assert set(charts(page)) == {"training"}
    assert not page.button(key="open one").disabled
    assert checkpoints.trained() == ("run:one",)


def test_the_best_checkpoint_opens_in_the_other_page(runs):
    made(runs, "one", checkpoint=True)
    page = opened()
    page.button(key="open one").click()
    run(page)
    assert link(page)["checkpoint"] == "run:one"
    assert "9.0 over 20 episodes" in " ".join(caption.value for caption in page.caption)
    assert page.selectbox(key="checkpoint").value == "run:one"


def test_a_checkpoint_of_a_run_that_is_gone_is_one_sentence(runs):
    folder = made(runs, "one", checkpoint=True)
    page = opened(screen="agents", checkpoint="run:one")
    assert not page.warning
    (folder / "best.safetensors").unlink()
    assert_one_sentence(run(page).error[0].value, "one")
    assert_one_sentence(opened(screen="agents", checkpoint="run:one").warning[0].value, "one")
    assert_one_sentence(opened(screen="agents", checkpoint="run:../one").warning[0].value, "one")


def test_files_of_a_run_are_taken_along(runs, monkeypatch):
    saved = downloads(monkeypatch)
    folder = made(runs, "one", checkpoint=True)
    opened("more_one")
    assert saved["one.safetensors"] == (folder / "best.safetensors").read_bytes()
    assert saved["one.jsonl"].decode() == STORY
    assert saved["one.csv"].startswith(b"event,step,")
    assert json.loads(saved["one.json"])["settings"]["hidden"] == 8


def test_the_copied_command_repeats_the_run(runs, tmp_path, monkeypatch, capsys):
    folder = made(runs, "one")
    told = shlex.split(copied(opened("more_one"), "command one"))
    assert told[:3] == ["python", "-m", "laplace_core"]
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("laplace_core.training.loop.train", lambda settings, path, **_: new_run(path, settings) or ())
    assert main(told[3:]) == 0
    assert read_config(tmp_path / "runs" / "one_again" / "config.json") == read_config(folder / "config.json")


def test_a_run_is_removed_only_when_asked_twice(runs):
    folder = made(runs, "one")
    page = opened("more_one")
    press(page, "Remove ...")
    assert folder.exists()
    press(page, "Yes, remove one for good")
    assert not folder.exists()
    assert "There is no run yet" in page.info[0].value


def test_a_folder_of_junk_opens_and_broken_runs_may_be_removed(runs):
    (runs.folder / "bad").mkdir()
    (runs.folder / "bad" / "config.json").write_bytes(b"\xff<script>")
    made(runs, "one", story="\x00" * 1000)
    page = opened("more_bad")
    assert "Its settings cannot be read" in words(page)
    press(page, "Remove ...")
    press(page, "Yes, remove bad for good")
    assert [one.name for one in runs.runs()] == ["one"]


def test_many_runs_are_shown_a_few_at_a_time(runs):
    for seed in range(15):
        made(runs, f"run_{seed}", settings=replace(SMALL, seed=seed))
    page = opened()
    assert labels(page).count("Resume") == 12
    press(page, "Show all 15 runs")
    assert labels(page).count("Resume") == 15
