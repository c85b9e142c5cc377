"""The search over settings: what it trains, what it costs, and that it goes on where it was."""

from __future__ import annotations

import itertools
import json
import statistics
from pathlib import Path

import pytest

from laplace_core.agents.settings import SETTINGS
from laplace_core.cli import main
from laplace_core.experiments.search import objectives, search
from laplace_core.experiments.search.results import read
from laplace_core.training.defaults import settings_of

KEPT = sorted((Path(__file__).parents[3] / "docs" / "searches").glob("*.json"))
QUICK = ["--set", "steps=200", "--set", "learning_starts=100", "--set", "hidden=8", "--set", "features=4",
         "--set", "evaluate_every=200"]  # fmt: skip


def run(folder, *more: str) -> int:
    return main(["search", "laplace", "two_branch", *QUICK, "--seeds", "2", "--runs", str(folder), *more])


def test_combinations_and_one_at_a_time():
    varied = {"a": ["1", "2"], "b": ["3"]}
    assert search.trials(varied, one_at_a_time=False) == [{"a": "1", "b": "3"}, {"a": "2", "b": "3"}]
    assert search.trials(varied, one_at_a_time=True) == [{}, {"a": "1"}, {"a": "2"}, {"b": "3"}]


def test_a_search_ranks_and_is_not_repeated(tmp_path, capsys, monkeypatch):
    monkeypatch.setattr(objectives, "EPISODES", 3)
    vary = ("--vary", "learning_rate=0.001,0.01", "--one-at-a-time")
    assert run(tmp_path, *vary, "--budget") == 0
    assert "6 trainings, 0 of them finished already; at most 1,200 steps" in capsys.readouterr().out
    assert not list(tmp_path.iterdir())
    assert run(tmp_path, *vary) == 0
    out = capsys.readouterr().out
    assert "as in the file" in out
    assert "learning_rate 0.01" in out
    kept = json.loads((tmp_path / search.RESULTS).read_text())
    assert [row["trial"] for row in kept["trials"]] == [{}, {"learning_rate": 0.001}, {"learning_rate": 0.01}]
    assert all(len(row["scores"]) == 2 for row in kept["trials"])
    assert all(row["seconds"] > 0 for row in kept["trials"])
    words = " ".join(QUICK)
    expected = f"search laplace two_branch {words} {' '.join(vary)} --seeds 2"
    assert kept["command"] == f"python -m laplace_core {expected}"
    monkeypatch.setattr(objectives, "train", lambda *args, **kwargs: pytest.fail("trained again"))
    monkeypatch.setattr(objectives, "evaluated", lambda *args, **kwargs: pytest.fail("evaluated again"))
    assert run(tmp_path, *vary, "--json") == 0
    assert json.loads(capsys.readouterr().out) == kept["trials"]
    # The storage is lost: the runs and their scores are there.
    assert run(tmp_path, *vary, "--json", "--storage", str(tmp_path / "other.db")) == 0
    assert json.loads(capsys.readouterr().out) == kept["trials"]


@pytest.mark.parametrize(
    "damage",
    [
        b"{",
        b"[]",
        b"{}",
        b'{"episodes": 99, "start_seed": 500000, "score": 1e9}',
        b'{"episodes": 3, "start_seed": 500000, "score": "x", "value_error": 0}',
    ],
)
def test_a_kept_score_of_other_episodes_or_a_damaged_one_is_made_anew(damage, tmp_path, capsys, monkeypatch):
    monkeypatch.setattr(objectives, "EPISODES", 3)
    found = []
    for name in ("first.db", "second.db"):
        assert run(tmp_path, "--json", "--storage", str(tmp_path / name)) == 0
        found.append(json.loads(capsys.readouterr().out))
        for kept in tmp_path.glob(f"*/{objectives.SCORE_FILE}"):
            kept.write_bytes(damage)
    assert found[0] == found[1]


def test_several_at_once_find_the_same_and_train_nothing_twice(tmp_path, capsys):
    usual = settings_of("laplace", "two_branch", {}).learning_rate
    vary = (
        "--one-at-a-time",
        "--vary",
        f"learning_rate={usual},0.01",
        "--set",
        "evaluate_episodes=2",
        "--seeds",
        "1",
        "--json",
    )
    found = []
    for jobs in ("1", "2"):
        assert run(tmp_path / jobs, *vary, "--jobs", jobs) == 0
        found.append([(row["trial"], row["scores"]) for row in json.loads(capsys.readouterr().out)])
        assert len(list((tmp_path / jobs).glob("laplace_*"))) == 2  # the unchanged settings and another rate
    assert found[0] == found[1]
    assert len(found[0]) == 3
    assert found[0][0][1] == found[0][1][1]


@pytest.mark.parametrize(
    "more",
    [
        ("--vary", "learning_rat=1"),
        ("--vary", "learning_rate=fast"),
        ("--vary", "learning_rate"),
        ("--vary", "seed=1,2"),
        ("--seeds", "0"),
        ("--jobs", "0"),
        ("--vary", "epsilon_final=2"),
    ],
)
def test_bad_input_is_one_sentence_and_nothing_is_trained(more, tmp_path, capsys):
    assert run(tmp_path, *more) == 2
    assert len(capsys.readouterr().err.splitlines()) == 1
    assert not list(tmp_path.iterdir())


def test_what_was_found_is_reported_from_its_file(tmp_path, capsys):
    """Change is against the first row; 2 rows x 2 seeds x 200 steps are 800; 1,800 and 5,400 seconds are 2 hours."""
    found = {
        "command": "python -m laplace_core search dqn CartPole-v1", "settings": {"steps": 200}, "one_at_a_time": True,
        "seeds": 2,
        "trials": [
            {"trial": {}, "scores": [10.0, 20.0], "value_errors": [1.0, -3.0], "median": 15.0, "seconds": 1800.0},
            {"trial": {"n_step": "3"}, "scores": [30.0, 11.0], "value_errors": [None, 2.0], "median": 20.5,
             "seconds": 5400.0},
        ],
    }  # fmt: skip
    path = tmp_path / "found.json"
    path.write_text(json.dumps(found))
    assert main(["report", "searches", str(path)]) == 0
    command, cost, head, best, base = capsys.readouterr().out.splitlines()
    assert command == found["command"]
    assert cost == "4 trainings, 800 steps, 2.0 hours of one core"
    assert head.split() == ["median", "change", "every", "seed", "value", "off", "settings"]
    assert best.split() == ["20.5", "+5.5", "30.0", "11.0", "+2.0", "n_step", "3"]
    assert base.split() == ["15.0", "+0.0", "10.0", "20.0", "-3.0", "as", "in", "the", "file"]
    assert main(["report", "searches", str(path), "--json"]) == 0
    assert json.loads(capsys.readouterr().out) == [found]


def test_a_file_that_is_no_search_is_refused(subtests, tmp_path, capsys):
    for text in [
            "{", "[]", "{}", '{"trials": 3}',
            '{"command": "", "settings": {"steps": 1}, "one_at_a_time": true, "seeds": 1, "trials": []}',
            '{"command": "", "settings": {"steps": 1}, "one_at_a_time": true, "seeds": 2, "trials": '
            '[{"trial": {}, "scores": [1.0], "value_errors": [1.0], "median": 1.0, "seconds": 1.0}]}',
            '{"command": "", "settings": {"steps": 1}, "one_at_a_time": true, "seeds": 1, "trials": '
            '[{"trial": {"steps": "x"}, "scores": [1.0], "value_errors": [1.0], "median": 1.0, "seconds": 1.0}]}',
            '{"command": "", "settings": {"steps": 1}, "one_at_a_time": true, "seeds": 1, "trials": '
            '[{"trial": {}, "scores": [1' + "0" * 400 + '], "value_errors": [1.0], "median": 1.0, "seconds": 1.0}]}',
            None,
        ]:  # fmt: skip
        with subtests.test(text=text):
            path = tmp_path / "found.json"
            path.unlink(missing_ok=True)
            if text is not None:
                path.write_text(text)
            assert main(["report", "searches", str(path)]) == 2
            assert len(capsys.readouterr().err.splitlines()) == 1


def test_a_kept_search_is_of_the_settings_that_there_are(subtests):
    """Of today's file, or it would tell what other settings than those that ship are worth."""
    for path in KEPT:
        with subtests.test(path.stem):
            kept = read(path)
            _, _, _, verb, algorithm, environment, *options = kept["command"].split()
            assert main([verb, algorithm, environment, *options, "--budget"]) == 0
            common = dict(word.split("=") for flag, word in itertools.pairwise(options) if flag == "--set")
            # A setting that came later than the search is at its default, as it was without it.
            assert SETTINGS[algorithm].parse(kept["settings"]) == settings_of(
                algorithm, environment, {**common, "seed": 0}
            )
            for row in kept["trials"]:
                assert len(row["scores"]) == kept["seeds"]
                assert row["median"] == pytest.approx(statistics.median(row["scores"]))
