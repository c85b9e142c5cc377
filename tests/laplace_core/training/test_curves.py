"""Curves of a run, read while it is written: the same numbers in whatever pieces, few points, and no trust."""

from __future__ import annotations

import csv
import io
import json
import math
import os
from dataclasses import asdict
from pathlib import Path

import numpy as np
import pytest

from laplace_core.training import curves
from laplace_core.training.curves import MOST_EVALUATIONS, MOST_POINTS, Curves, Reader, metrics_csv
from laplace_core.training.events import Checkpoint, Episode, Evaluation, Resumed


def line(event) -> str:
    return json.dumps({"event": type(event).__name__, **asdict(event)}) + "\n"


def episode(number: int, total: float) -> str:
    return line(Episode(10 * number, number, 0, total, 10, False, 0.1, None, 1.0))


def evaluation(step: int, score: float, *by_discount) -> str:
    return line(Evaluation(step, score, 0.5, 20, False, 1.0, *(by_discount or ((1.0, 2.0), (1.5, 2.5), (0.1, 0.2)))))


@pytest.fixture
def file(tmp_path) -> Path:
    return tmp_path / "metrics.jsonl"


def looked(path: Path) -> Curves:
    """All of a file, in as many looks as it takes."""
    reader = Reader(path)
    found = reader.look()
    while reader.behind:
        found = reader.look()
    return found


def assert_same(one: Curves, other: Curves) -> None:
    for name, value in vars(one).items():
        np.testing.assert_array_equal(value, getattr(other, name), err_msg=name)


STORY = "".join(
    [episode(1, 3.0), episode(2, 5.0), evaluation(25, 4.0), line(Checkpoint(25, "best.safetensors", 1.0)),
     episode(3, 10.0), line(Resumed(30, False, "new", 0.0)), evaluation(50, 9.0), evaluation(75, 9.0), episode(4, 2.0)]
)  # fmt: skip


def test_what_is_drawn_is_what_was_told(file):
    file.write_text(STORY)
    found = looked(file)
    assert found.episode_steps.tolist() == [10, 20, 30, 40]
    assert found.returns.tolist() == [3, 5, 10, 2]
    assert found.smooth.tolist() == [5, 5, 5, 5]  # four episodes lie within the window of all
    assert found.steps.tolist() == [25, 50, 75]
    assert found.scores.tolist() == [4, 9, 9]
    assert found.errors.tolist() == [0.5] * 3
    assert found.values.tolist() == [[1, 2]] * 3
    assert found.discounted.tolist() == [[1.5, 2.5]] * 3
    assert found.discounted_errors.tolist() == [[0.1, 0.2]] * 3
    assert found.episodes == 4
    assert found.best == 2  # the later of two that are equally good, as the checkpoint


def test_the_moving_average_is_that_of_a_naive_loop(file):
    returns = np.random.default_rng(0).normal(size=900)
    file.write_text("".join(episode(i + 1, total) for i, total in enumerate(returns)))
    around = round(0.02 * 900)
    naive = [returns[max(0, i - around) : i + around + 1].mean() for i in range(900)]
    np.testing.assert_allclose(looked(file).smooth, naive)


def test_any_pieces_give_the_same_and_a_line_in_the_making_waits(file, monkeypatch):
    file.write_text("")
    reader = Reader(file)
    for i in range(0, len(STORY), 37):
        with file.open("a") as end:
            end.write(STORY[i : i + 37])
        found = reader.look()
    whole = Reader(file).look()
    assert_same(found, whole)
    assert reader.look() is found  # nothing is new
    monkeypatch.setattr(curves, "_AT_ONCE", 400)
    assert_same(looked(file), whole)


def test_a_file_of_any_length_gives_few_points_that_keep_the_mean(file):
    count = 7 * MOST_POINTS + 5
    returns = np.random.default_rng(1).normal(size=count)
    file.write_text("".join(episode(i + 1, total) for i, total in enumerate(returns)))
    found = looked(file)
    assert MOST_POINTS / 2 <= len(found.returns) <= MOST_POINTS
    assert found.episodes == count
    assert np.all(np.diff(found.episode_steps) > 0)
    assert found.episode_steps[-1] == 10 * count
    np.testing.assert_allclose(found.returns[:3], returns[:24].reshape(3, 8).mean(axis=1))


def test_many_evaluations_are_thinned_but_for_the_best_and_the_last(file):
    scores = np.random.default_rng(2).permutation(3 * MOST_EVALUATIONS).astype(float)
    file.write_text("".join(evaluation(i, score) for i, score in enumerate(scores)))
    found = looked(file)
    assert len(found.steps) <= MOST_EVALUATIONS
    assert found.scores.max() == scores.max()
    assert found.steps[-1] == len(scores) - 1


def test_a_file_that_was_cut_back_and_went_on_otherwise_is_read_anew(file):
    file.write_text(STORY)
    reader = Reader(file)
    reader.look()
    other = episode(1, 3.0) + "".join(episode(i, 77.0) for i in range(2, 30))
    file.write_text(other)
    assert_same(reader.look(), looked(file))
    file.write_text(episode(1, 3.0))
    assert reader.look().episodes == 1
    file.unlink()
    assert reader.look().episodes == 0


def test_metrics_of_an_earlier_version_and_of_one_discount_are_read(file):
    old = json.loads(evaluation(25, 4.0))
    del old["values"], old["discounted"], old["discounted_errors"]
    file.write_text(json.dumps(old) + "\n" + evaluation(50, 5.0, None, None, None))
    found = looked(file)
    assert found.scores.tolist() == [4, 5]
    assert found.values.shape == (2, 0)
    with file.open("a") as end:
        end.write(evaluation(75, 6.0))
    found = looked(file)
    assert found.values.shape == (3, 2)
    assert math.isnan(found.values[0, 0])
    assert found.values[2].tolist() == [1, 2]


HOSTILE = (
    *(b"\n", b"{}\n", b"[]\n", b"7\n", b'"Episode"\n', b"\xff\xfe\n", b"[" * 50_000 + b"\n", b"9" * 9000 + b"\n"),
    b'{"event": "Episode", "step": 1}\n',
    b'{"event": "Episode", "step": NaN, "episode_return": 1}\n',
    b'{"event": "Episode", "step": 1, "episode_return": 1e999}\n',
    b'{"event": "Episode", "step": 1, "episode_return": "12"}\n',
    b'{"event": "Episode", "step": true, "episode_return": 1}\n',
    b'{"event": "Evaluation", "step": 1, "score": null, "standard_error": 0}\n',
    b'{"event": "Evaluation", "step": 1, "score": 1, "standard_error": 0, "values": 3, "discounted": [1]}\n',
    b'{"event": "Evaluation", "step": 1, "score": 1, "standard_error": 0, "values": ["x"], "discounted": [1]}\n',
)


def test_lines_that_no_run_writes_are_left_out(subtests, file):
    for junk in HOSTILE:
        with subtests.test(junk=junk):
            file.write_bytes(STORY.encode())
            clean = looked(file)
            file.write_bytes(junk + STORY.encode() + junk)
            assert_same(looked(file), clean)


def test_a_line_without_end_is_passed_over_and_costs_bounded_memory(file, monkeypatch):
    monkeypatch.setattr(curves, "_AT_ONCE", 300_000)
    file.write_bytes(b"x" * 2_000_000 + b"\n" + STORY.encode())
    assert looked(file).episodes == 4


def test_what_is_no_plain_file_is_not_opened(file, tmp_path):
    (tmp_path / "other").write_text(STORY)
    file.symlink_to(tmp_path / "other")
    assert looked(file).episodes == 0
    file.unlink()
    os.mkfifo(file)
    assert looked(file).episodes == 0
    assert looked(tmp_path).episodes == 0


def test_a_table_holds_every_episode_and_evaluation(file):
    file.write_bytes(STORY.encode() + b"junk\n")
    rows = list(csv.DictReader(io.StringIO(metrics_csv(file).decode())))
    assert [row["event"] for row in rows] == ["Episode"] * 2 + ["Evaluation", "Episode"] + ["Evaluation"] * 2 + [
        "Episode"
    ]
    assert [float(row["episode_return"]) for row in rows if row["episode_return"]] == [3, 5, 10, 2]
    assert rows[2]["score"] == "4.0"
    assert rows[2]["length"] == ""


def test_a_table_is_written_byte_by_byte_as_ever_and_text_with_a_comma_is_one_cell(file):
    file.write_text(
        episode(1, 3.0) + evaluation(10, 4.0) + '{"event": "Episode", "step": 1e-7, "loss": "a,b", "length": [1, 2]}\n'
    )
    assert metrics_csv(file) == (
        b"event,step,episode,head,episode_return,length,truncated,epsilon,loss,score,standard_error,episodes,best,seconds\n"
        b"Episode,10,1,0,3.0,10,False,0.1,,,,,,1.0\n"
        b"Evaluation,10,,,,,,,,4.0,0.5,20,False,1.0\n"
        b'Episode,1e-07,,,,"[1, 2]",,,"a,b",,,,,\n'
    )
