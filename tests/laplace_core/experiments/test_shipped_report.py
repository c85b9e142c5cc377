"""The report on what ships: its figures, and files that are not those of the manifest."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path

import pytest

from laplace_core.cli import main

SHIPPED = Path(__file__).resolve().parents[3] / "checkpoints"


def digest(data: bytes) -> str:
    return hashlib.sha256(data).hexdigest()


@pytest.fixture
def folder(tmp_path):
    """One agent of two seeds; the file itself is never opened, only its sha256 is taken."""
    curves = json.dumps(
        [
            # Seeds may lie in any order. Second halves: from the third of four evaluations, and of five.
            {"seed": 1, "steps": [1, 2, 3, 4, 5], "scores": [-9, 0, 50, 30, 40], "errors": [0] * 5},
            {"seed": 0, "steps": [1, 2, 3, 4], "scores": [1, 2, 60, 58], "errors": [0] * 4},
        ]
    ).encode()
    entry = {
        "file": "fixed_horizon_Lake-v1.safetensors", "sha256": digest(b"agent"), "seed": 1, "picked": "by hand",
        "episodes": 7, "scores": [61.25, 51.0],
        "curve": {"file": "fixed_horizon_Lake-v1.curve.json", "sha256": digest(curves)},
    }  # fmt: skip
    (tmp_path / "fixed_horizon_Lake-v1.safetensors").write_bytes(b"agent")
    (tmp_path / "fixed_horizon_Lake-v1.curve.json").write_bytes(curves)
    (tmp_path / "manifest.json").write_text(json.dumps([entry]))
    return tmp_path


def test_scores_last_and_lowest_of_every_seed(folder, capsys):
    assert main(["report", "shipped", "--folder", str(folder), "--json"]) == 0
    (row,) = json.loads(capsys.readouterr().out)
    assert (row["algorithm"], row["environment"], row["seed"]) == ("fixed_horizon", "Lake-v1", 1)
    assert row["scores"] == [61.25, 51.0]
    assert row["last"] == [58, 40]
    assert row["lowest"] == [58, 30]
    assert main(["report", "shipped", "--folder", str(folder)]) == 0
    words = capsys.readouterr().out
    assert "fixed_horizon Lake-v1: median 56.1, lowest 51.0; seed 1 ships (by hand)" in words
    assert "best checkpoint, 7 episodes" in words
    assert "evaluate fixed_horizon_Lake-v1.safetensors --seed 1" in words


def test_what_ships_is_told_whole(capsys):
    assert main(["report", "shipped", "--folder", str(SHIPPED), "--json"]) == 0
    rows = json.loads(capsys.readouterr().out)
    assert [row["file"] for row in rows] == [
        each["file"] for each in json.loads((SHIPPED / "manifest.json").read_text())
    ]
    assert all(len(row["scores"]) == len(row["last"]) == len(row["lowest"]) for row in rows)


def spoil(folder: Path, what: str) -> None:
    agent, path = folder / "fixed_horizon_Lake-v1.safetensors", folder / "manifest.json"
    (entry,) = json.loads(path.read_text())
    if what == "another agent":
        agent.write_bytes(b"another")
    elif what == "no agent":
        agent.unlink()
    elif what == "no manifest":
        path.unlink()
    elif what == "empty scores":
        path.write_text(json.dumps([entry | {"scores": []}]))
    elif what == "no scores":
        path.write_text(json.dumps([{name: entry[name] for name in entry if name != "scores"}]))
    else:
        path.write_text(json.dumps([entry | {"file": "../" * 3 + "etc/passwd"}]))


@pytest.mark.parametrize(
    "what", ["another agent", "no agent", "no manifest", "no scores", "empty scores", "another folder"]
)
def test_what_is_not_as_the_manifest_says_is_one_sentence(what, folder, capsys):
    spoil(folder, what)
    assert main(["report", "shipped", "--folder", str(folder)]) == 2
    told = capsys.readouterr().err
    assert told.count("\n") == 1
    assert "manifest.json" in told or "cannot be read" in told
