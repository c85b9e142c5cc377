"""Run folders that version 0.2.0 has left, one finished and one stopped midway, are listed, opened and resumed."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest

from app.catalogue import checkpoints, training_runs
from laplace_core.cli import main
from laplace_core.inverse.neural import read_network
from laplace_core.tabular import read_learned
from laplace_core.training.checkpoint import load_checkpoint
from laplace_core.training.progress import read_progress
from laplace_core.training.queue import FINISHED, STOPPED, Queue
from laplace_core.training.run_folder import read_metrics
from tests.support.pages import charts, handed, labels, link, opened
from tests.support.quick_runs import states
from tests.support.train_page import words

OLD = Path(__file__).resolve().parents[2] / "data" / "runs_of_0_2"
DONE, HALF = "laplace_two_branch_0", "laplace_two_branch_1"


@pytest.fixture
def old_runs(tmp_path, monkeypatch) -> Queue:
    """The queue of the page on a copy of the old folders."""
    shutil.copytree(OLD, tmp_path / "runs")
    monkeypatch.setenv(training_runs.VARIABLE, str(tmp_path / "runs"))
    return training_runs.queue()


def test_old_runs_are_listed_with_their_curves(old_runs):
    assert states(old_runs) == {DONE: FINISHED, HALF: STOPPED}
    page = opened(screen="train")
    assert "finished" in words(page)
    assert "400 of 400 steps" in words(page)
    assert "stopped" in words(page)
    assert "208 of 800 steps" in words(page)
    assert not [note for note in page.error if note.value]
    assert labels(page).count("Resume") == 1
    both = charts(opened(screen="train", run=DONE, beside=HALF))["training"]["data"]
    assert len([trace for trace in both if trace.get("showlegend")]) == 2


def test_an_old_run_that_finished_opens_on_the_page_of_trained_agents(old_runs):
    page = opened(screen="agents", checkpoint=f"{checkpoints.RUN}{DONE}")
    assert not page.warning
    assert not page.error
    assert link(page)["checkpoint"] == f"{checkpoints.RUN}{DONE}"
    assert handed(page)[1]  # the lens has its gamma-space


def test_an_old_run_that_was_stopped_is_resumed_to_its_end_by_the_command(old_runs, capsys):
    folder = old_runs.folder / HALF
    before = [line for line in read_metrics(folder) if line["step"] <= 200]
    assert main(["train", "--resume", str(folder)]) == 0
    assert old_runs.get(HALF).state == FINISHED
    after = read_metrics(folder)
    assert after[: len(before)] == before
    steps = [line["step"] for line in after]
    assert steps == sorted(steps)
    assert [line["step"] // 100 for line in after if line["event"] == "Evaluation"] == list(range(1, 9))
    assert load_checkpoint(folder / "last.safetensors").step >= 800
    assert not (folder / "process.json").exists()
    assert read_progress(folder).step >= 800


def test_what_is_kept_here_is_what_0_2_wrote_and_is_small():
    assert sum(path.stat().st_size for path in OLD.rglob("*")) < 200_000
    for name in (DONE, HALF):
        assert set(json.loads((OLD / name / "job.json").read_text())) == {"wanted", "ticket", "begun", "error"}


def test_every_file_that_ships_opens(subtests):
    for path in sorted(checkpoints.SHIPPED.rglob("*.safetensors")):
        with subtests.test(path.stem):
            if path.stem.endswith("_td"):
                assert read_learned(path).finished
            elif path.parent.name == "inverse":
                assert read_network(path).about["updates"] > 0
            else:
                assert load_checkpoint(path).step > 0
