"""The verb ``reproduce``: small experiments through the real command, and the plans of the real ones."""

from __future__ import annotations

import json
import os
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

from laplace_core.cli import main, reproduce
from laplace_core.experiments.paper import EXPERIMENTS, results
from laplace_core.experiments.paper.experiment import Cell, Experiment, run_name, shortened
from laplace_core.experiments.paper.runs import once_each, trainings_of
from laplace_core.training.defaults import command_of, settings_of
from laplace_core.training.run_folder import read_config, read_metrics
from tests.support.hostile import assert_refused

STEPS = 400
QUICK = {"hidden": 8, "features": 4}
BRIEF = {**QUICK, "steps": 3000, "evaluate_every": 3000, "batch": 16, "updates": 1, "learning_starts": 200}
SMALL = {
    "first": Experiment("first", "The first", "Does it run?", [
        Cell("plain", "laplace", "two_branch", QUICK, seeds=(0, 1)),
        Cell("accumulated", "laplace", "two_branch", {**QUICK, "parametrisation": "accumulated"}, seeds=(0,)),
    ]),
    "second": Experiment("second", "The second", "Is it shared?", [
        Cell("the same", "laplace", "two_branch", QUICK, seeds=(1,)),
        Cell("CartPole", "laplace", "CartPole-v1", QUICK, seeds=(0,)),
    ]),
}  # fmt: skip


@pytest.fixture
def small(monkeypatch):
    """Two experiments of a few trainings each in the place of the paper's, scored over three episodes."""
    for name in list(EXPERIMENTS):
        monkeypatch.delitem(EXPERIMENTS, name)
    for name, experiment in SMALL.items():
        monkeypatch.setitem(EXPERIMENTS, name, experiment)
    monkeypatch.setattr(results, "EPISODES", 3)
    monkeypatch.setattr(reproduce, "MEASUREMENTS", ())


def words(folder: Path, *more: str) -> list[str]:
    return ["reproduce", *more, "--steps", str(STEPS), "--runs", str(folder / "runs"), "--out", str(folder / "out")]


def listed(folder: Path, capsys) -> dict[str, dict]:
    capsys.readouterr()
    assert main(words(folder, "--list", "--json")) == 0
    return {each["name"]: each for each in json.loads(capsys.readouterr().out)}


def budget(folder: Path, capsys) -> dict:
    capsys.readouterr()
    assert main(words(folder, "--budget", "--json")) == 0
    return json.loads(capsys.readouterr().out)


def test_an_experiment_is_trained_listed_and_kept(small, tmp_path, capsys):
    before = listed(tmp_path, capsys)
    assert [each["state"] for each in before.values()] == ["missing", "missing"]
    assert [each["result"] for each in before.values()] == [None, None]
    assert budget(tmp_path, capsys)["together"]["trainings"] == 4  # one of the five is needed twice
    assert not list(tmp_path.iterdir())

    assert main(words(tmp_path, "first")) == 0
    assert "plain, seed 1: " in capsys.readouterr().out
    after = listed(tmp_path, capsys)
    assert after["first"]["state"] == "finished"
    assert [each["state"] for each in after["second"]["trainings"]] == ["finished", "missing"]
    assert after["second"]["state"] == "part"
    left = budget(tmp_path, capsys)
    assert left["experiments"]["first"] == {
        "trainings": 3, "finished": 3, "steps": 0, "hours": 0.0, "rough_speed": 0, "unknown_speed": 0,
    }  # fmt: skip
    # No run of CartPole exists, so that its speed is unknown.
    assert left["together"]["steps"] == STEPS
    assert left["together"]["unknown_speed"] == 1

    found = json.loads((tmp_path / "out" / "first.json").read_text())
    assert (found["finished"], found["planned"]) == (3, 3)
    assert found["command"] == "python -m laplace_core reproduce first"
    assert [cell["label"] for cell in found["cells"]] == ["plain", "accumulated"]
    assert found["cells"][1]["settings"]["parametrisation"] == "accumulated"
    for cell in found["cells"]:
        assert cell["seeds"] == [row["seed"] for row in cell["trainings"]]
        for row in cell["trainings"]:
            check_row(row, tmp_path / "runs" / row["run"])
    assert not (tmp_path / "out" / "second.json").exists()


def check_row(row: dict, run: Path) -> None:
    """A row of an experiment's file is complete, and says what the run's own metrics and files say."""
    assert {"torch", "numpy", "gymnasium", "python"} <= set(row["versions"])
    assert time.strptime(row["date"], "%Y-%m-%d")
    events = read_metrics(run)
    told = [event for event in events if event["event"] == "Evaluation"]
    assert row["evaluations"]["steps"] == [event["step"] for event in told]
    np.testing.assert_allclose(row["evaluations"]["scores"], [event["score"] for event in told], atol=1e-3)
    assert row["last"]["step"] == told[-1]["step"] >= STEPS
    assert row["last"]["score"] == pytest.approx(told[-1]["score"], abs=1e-3)
    assert row["seconds"] == pytest.approx(events[-1]["seconds"], abs=0.1)
    ended = [event for event in events if event["event"] == "Episode"]
    assert row["episodes"] == len(ended)
    best = row["best"]
    assert best["episodes"] == len(best["returns"]) == 3
    assert best["start_seed"] == 500_000 + row["seed"]
    assert best["score"] == pytest.approx(np.mean(best["returns"]), abs=0.01)
    assert isinstance(best["value_error"], float)
    # The settings of the command that it names are those of the run.
    given = row["command"].split()
    assert given[:3] == ["python", "-m", "laplace_core"]
    settings = read_config(run / "config.json")
    assert given[3:-2] == command_of(settings, "")[:-2]
    for axis, places in (("by_episode", "episodes"), ("by_step", "steps")):
        assert 0 < len(row[axis][places]) == len(row[axis]["returns"]) <= 300


def test_what_is_finished_is_not_trained_or_scored_again(small, tmp_path, capsys, monkeypatch):
    assert main(words(tmp_path, "second")) == 0
    first = (tmp_path / "out" / "second.json").read_bytes()
    assert main(words(tmp_path, "second")) == 0
    assert (tmp_path / "out" / "second.json").read_bytes() == first
    # The results come back from the runs alone, and the runs of other folders stay in the results.
    (tmp_path / "out" / "second.json").unlink()
    assert main(words(tmp_path, "second", "--collect")) == 0
    assert (tmp_path / "out" / "second.json").read_bytes() == first
    (tmp_path / "out" / "second.json").unlink()
    times = {path: path.stat().st_mtime_ns for path in (tmp_path / "runs").rglob("*")}
    assert main(words(tmp_path, "second")) == 0
    assert (tmp_path / "out" / "second.json").read_bytes() == first
    assert {path: path.stat().st_mtime_ns for path in (tmp_path / "runs").rglob("*")} == times
    capsys.readouterr()
    elsewhere = ["--runs", str(tmp_path / "empty"), "--out", str(tmp_path / "out")]
    assert main(["reproduce", "--budget", "--steps", str(STEPS), *elsewhere]) == 0
    told = capsys.readouterr().out
    assert "first: 3 trainings, 1 of them finished; 800 steps to go" in told
    assert "second: 2 trainings, 2 of them finished; 0 steps to go\n" in told


def test_a_result_holds_without_its_run(small, tmp_path, capsys):
    """Results are committed and runs are not: on another machine only the former are there."""
    assert main(words(tmp_path, "second")) == 0
    shutil.rmtree(tmp_path / "runs")
    second = (tmp_path / "out" / "second.json").read_bytes()
    assert listed(tmp_path, capsys)["second"]["state"] == "finished"
    assert main(words(tmp_path, "second")) == 0
    assert (tmp_path / "out" / "second.json").read_bytes() == second
    assert not (tmp_path / "runs").exists()
    # The first experiment needs one of them, too, and trains only the other two.
    assert main(words(tmp_path, "first")) == 0
    shared = run_name(shortened(settings_of("laplace", "two_branch", {**QUICK, "seed": 1}), STEPS))
    assert sorted(path.name for path in (tmp_path / "runs").iterdir()) == sorted(
        row["run"] for cell in json.loads((tmp_path / "out" / "first.json").read_text())["cells"]
        for row in cell["trainings"] if row["run"] != shared
    )  # fmt: skip
    assert json.loads((tmp_path / "out" / "first.json").read_text())["finished"] == 3


def test_collecting_trains_nothing(small, tmp_path, capsys):
    settings = shortened(settings_of("laplace", "two_branch", {**QUICK, "seed": 1}), STEPS)
    assert main(command_of(settings, str(tmp_path / "runs" / run_name(settings)))) == 0
    capsys.readouterr()
    assert main(words(tmp_path, "all", "--collect")) == 0
    assert "plain, seed 1: " in capsys.readouterr().out
    assert [path.name for path in (tmp_path / "runs").iterdir()] == [run_name(settings)]
    for name, cell in (("first", 0), ("second", 0)):
        found = json.loads((tmp_path / "out" / f"{name}.json").read_text())
        assert found["finished"] == 1
        assert [row["seed"] for row in found["cells"][cell]["trainings"]] == [1]


def without_times(row: dict) -> dict:
    return {name: value for name, value in row.items() if name not in ("seconds", "date", "command")}


@pytest.mark.long
def test_an_interrupted_training_goes_on_to_the_same_result(tmp_path, monkeypatch):
    """SIGTERM to the command in the middle of a training of CartPole, whose state can be saved."""
    cell = Cell("CartPole", "laplace", "CartPole-v1", BRIEF, seeds=(0,))
    monkeypatch.setattr(results, "EPISODES", 3)
    monkeypatch.setitem(EXPERIMENTS, "stopped", Experiment("stopped", "Stopped", "Does it go on?", [cell]))
    script = (
        "import sys\nfrom laplace_core.cli import main\n"
        "from laplace_core.experiments.paper import EXPERIMENTS\n"
        "from laplace_core.experiments.paper.experiment import Cell, Experiment\n"
        f"cell = Cell('CartPole', 'laplace', 'CartPole-v1', {dict(cell.settings)!r}, seeds=(0,))\n"
        "EXPERIMENTS['stopped'] = Experiment('stopped', 'Stopped', 'Does it go on?', [cell])\n"
        "sys.exit(main(sys.argv[1:]))\n"
    )
    where = ["reproduce", "stopped", "--runs", str(tmp_path / "runs"), "--out", str(tmp_path / "out")]
    process = subprocess.Popen([sys.executable, "-c", script, *where], stderr=subprocess.PIPE, text=True,
                               env=os.environ | {"PYTHONPATH": str(Path(__file__).parents[3])})  # fmt: skip
    (training,) = trainings_of([EXPERIMENTS["stopped"]], tmp_path / "runs")["stopped"]
    limit = time.monotonic() + 120
    while training.step < 500 and process.poll() is None and time.monotonic() < limit:
        time.sleep(0.02)
    process.send_signal(signal.SIGTERM)
    _, told = process.communicate(timeout=120)
    assert process.returncode == 128 + signal.SIGTERM
    assert "goes on from there" in told
    assert training.state == "part"
    assert 500 <= training.step < 3000

    assert main(where) == 0
    assert training.state == "finished"
    whole = ["--runs", str(tmp_path / "others"), "--out", str(tmp_path / "beside")]
    assert main(["reproduce", "stopped", *whole]) == 0
    rows = [
        json.loads((tmp_path / name / "stopped.json").read_text())["cells"][0]["trainings"][0]
        for name in ("out", "beside")
    ]
    assert without_times(rows[0]) == without_times(rows[1])


def test_a_run_made_by_train_is_adopted_whole(small, tmp_path, capsys):
    settings = shortened(settings_of("laplace", "two_branch", {**QUICK, "seed": 1}), STEPS)
    made, name = tmp_path / "made", run_name(settings)
    assert main(command_of(settings, str(made))) == 0
    assert main(words(tmp_path, "--adopt", str(made))) == 0
    copy = tmp_path / "runs" / name
    assert [path.name for path in (tmp_path / "runs").iterdir()] == [name]
    for file in ("config.json", "metrics.jsonl", "best.safetensors", "last.safetensors"):
        assert (copy / file).read_bytes() == (made / file).read_bytes()
        assert (copy / file).stat().st_mtime == (made / file).stat().st_mtime
    assert listed(tmp_path, capsys)["second"]["trainings"][0]["state"] == "finished"
    assert_refused(capsys, words(tmp_path, "--adopt", str(made)), name, "there already")
    other = tmp_path / "other"
    assert main(command_of(shortened(settings, STEPS // 2), str(other))) == 0
    assert_refused(capsys, words(tmp_path, "--adopt", str(other)), "no experiment needs", "other")
    assert_refused(capsys, words(tmp_path, "--adopt", str(tmp_path / "nowhere")), "config.json")
    assert [path.name for path in (tmp_path / "runs").iterdir()] == [name]


def test_a_training_that_cannot_be_scored_keeps_no_other_from_its_result(small, tmp_path, capsys):
    assert main(words(tmp_path, "second")) == 0
    shutil.rmtree(tmp_path / "out")
    training = trainings_of([SMALL["second"]], tmp_path / "runs", STEPS)["second"][0]
    (training.folder / results.RESULT).unlink()
    (training.folder / "best.safetensors").write_bytes(b"not a checkpoint")
    capsys.readouterr()
    assert main(words(tmp_path, "second")) == 2
    out, err = capsys.readouterr()
    assert "CartPole, seed 0: " in out
    assert "the same, seed 1: " in err
    assert err.rstrip().splitlines()[-1].startswith("laplace: 1 of the trainings have no result")
    cells = json.loads((tmp_path / "out" / "second.json").read_text())["cells"]
    assert [len(cell["trainings"]) for cell in cells] == [0, 1]


@pytest.mark.parametrize(
    ("given", "named"),
    [
        (["reproduce", "fig77"], ("'fig77'", "fig7")),
        (["reproduce"], ("name the experiment", "fig7")),
        (["reproduce", "fig7", "--list", "--budget"], ("--list", "--budget")),
        (["reproduce", "fig7", "--steps", "300"], ("--steps", "--out")),
        (["reproduce", "fig7", "--steps", "0", "--out", "x"], ("steps",)),
    ],
)
def test_what_cannot_be_done_is_refused(capsys, given, named, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert_refused(capsys, given, *named)
    assert not list(tmp_path.iterdir())


def test_a_file_that_is_no_result_is_not_written_over(small, capsys, tmp_path):
    (tmp_path / "out").mkdir()
    file = tmp_path / "out" / "first.json"
    file.write_text("[1, 2]")
    assert_refused(capsys, words(tmp_path, "first"), "first.json")
    assert file.read_text() == "[1, 2]"
    assert not (tmp_path / "runs").exists()


def test_curves_are_means_over_neighbours_at_even_places():
    # Five episodes are smoothed over five on either side, which is all of them: their mean, 3, everywhere.
    found = results.curves([1.0, 2.0, 3.0, 4.0, 5.0], [10, 20, 30, 40, 50])
    assert found["by_episode"] == {"episodes": [1, 2, 3, 4, 5], "returns": [3.0] * 5}
    assert found["by_step"] == {"steps": [10, 20, 30, 40, 50], "returns": [3.0] * 5}
    # A straight line stays one away from its ends, in episodes and, these being of one length, in steps.
    found = results.curves(list(range(5000)), list(range(7, 35007, 7)))
    episodes, returns = (np.array(found["by_episode"][name]) for name in ("episodes", "returns"))
    assert len(episodes) == 300
    assert found["smoothing"] == 201  # a fiftieth of 5000 on either side
    inner = (episodes > 101) & (episodes < 4900)
    np.testing.assert_allclose(returns[inner], episodes[inner] - 1, atol=0.01)
    steps, along = (np.array(found["by_step"][name]) for name in ("steps", "returns"))
    inner = (steps > 800) & (steps < 34000)
    np.testing.assert_allclose(along[inner], steps[inner] / 7 - 1, atol=0.2)  # places are whole steps
    assert results.curves([], [])["by_step"] == {"steps": [], "returns": []}


def test_the_plans_share_what_they_can():
    """The unchanged lander is one training a seed in four experiments, CartPole's file in three."""
    planned = trainings_of(list(EXPERIMENTS.values()), Path("runs"))
    shared = {experiment: {each.name for each in several} for experiment, several in planned.items()}
    lander = shared["multiplexer"] & shared["table2"] & shared["auxiliary"] & shared["termination"]
    assert len(lander) == 3
    assert len(shared["fig7"] & shared["auxiliary"] & shared["fig3"]) == 5
    assert len(shared["interpolation"] & shared["multiplexer"]) == 6
    assert len(once_each(planned)) == sum(map(len, planned.values())) - 3 * 3 - 2 * 5 - 6
    for several in planned.values():
        for each in several:
            assert each.settings == settings_of(each.cell.algorithm, each.cell.environment,
                                                {**each.cell.settings, "seed": each.settings.seed})  # fmt: skip


def test_the_recipe_of_the_paper_is_what_it_says():
    cartpole, lander = (cell.trainings()[0] for cell in EXPERIMENTS["paper_agent"].cells)
    for settings, thetas, low, high in ((cartpole, 100, -1.0, 2.0), (lander, 500, -120.0, 120.0)):
        assert (settings.n_discounts, settings.rings, settings.thetas) == (15, 15, thetas)
        slope = settings.slope_times_spacing * (thetas - 1) / (high - low)
        assert slope == pytest.approx(25.0, rel=1e-4)
        assert settings.steps % 15 == settings.update_every % 15 == 0


BRIEFLY = Experiment("briefly", "Briefly", "Does it run beside others?", [
    Cell("plain", "laplace", "two_branch", BRIEF, seeds=(0, 1, 2)),
])  # fmt: skip


def test_trainings_side_by_side_are_those_one_by_one_and_stop_together(tmp_path):
    """Two at a time: the first result asks all others to stop, which leaves what they have to be gone on with."""
    found, asked = [], []
    for runs, processes in (("one", 1), ("two", 2)):
        trainings = trainings_of([BRIEFLY], tmp_path / runs, STEPS)
        out, rows = tmp_path / f"{runs}_out", []
        if processes == 2:
            for done in reproduce_all([BRIEFLY], trainings, out, lambda: asked, processes=2):
                assert done.trouble is None
                asked.append(done)
            assert 1 <= len(asked) <= 3
            assert not list((tmp_path / runs).glob(".stop_*"))
        for done in reproduce_all([BRIEFLY], trainings, out, lambda: False, processes=processes):
            rows.append(done.row)
        assert [each.state for each in once_each(trainings)] == ["finished"] * 3
        found.append({row["run"]: (row["best"]["returns"], row["evaluations"]) for row in rows})
        assert json.loads((out / "briefly.json").read_text())["finished"] == 3
    assert found[0] == found[1]


def reproduce_all(*given, processes: int):
    from laplace_core.experiments.paper.reproduce import reproduce

    yield from reproduce(*given, begins=lambda training: None, processes=processes)
