"""What ships is what its manifest says, and the seed that ships is the one in the middle."""

from __future__ import annotations

import hashlib
from pathlib import Path

import pytest

from laplace_core import InputError
from laplace_core.experiments.shipping import MOST_BYTES, MOST_TOGETHER, curves_of, manifest, ship
from laplace_core.training.checkpoint import load_checkpoint
from laplace_core.training.defaults import settings_of
from laplace_core.training.loop import train

SHIPPED = Path(__file__).resolve().parents[3] / "checkpoints"


def test_every_shipped_checkpoint_is_what_the_manifest_says(subtests):
    for entry in manifest(SHIPPED):
        with subtests.test(entry["file"]):
            path = SHIPPED / entry["file"]
            data = path.read_bytes()
            assert hashlib.sha256(data).hexdigest() == entry["sha256"]
            assert len(data) <= MOST_BYTES
            loaded = load_checkpoint(path)
            assert entry["command"].endswith(f"train {loaded.algorithm} {loaded.environment} --seed {loaded.seed}")
            assert loaded.settings == settings_of(loaded.algorithm, loaded.environment, {"seed": loaded.seed})
            scores = entry["scores"]
            assert entry["score"] == scores[entry["seed"]] == sorted(scores)[(len(scores) - 1) // 2]
            curves = curves_of(SHIPPED, entry)
            if "curve" in entry:
                assert [curve.seed for curve in curves] == list(range(len(scores)))
                best = max(zip(curves[entry["seed"]].scores, curves[entry["seed"]].steps, strict=True))
                assert loaded.step in curves[entry["seed"]].steps
                assert loaded.score == pytest.approx(best[0], abs=1e-3)  # the checkpoint is that of the best evaluation


def test_nothing_ships_that_the_manifest_does_not_name_and_all_of_it_is_small():
    files = {path.name: path.stat().st_size for path in SHIPPED.glob("*.safetensors")}
    tabular = {name for name in files if name.endswith("_td.safetensors")}
    assert set(files) - tabular == {entry["file"] for entry in manifest(SHIPPED)}
    everything = [path.stat().st_size for path in SHIPPED.rglob("*.safetensors")]
    assert sum(everything) <= MOST_TOGETHER
    assert max(everything) <= MOST_BYTES


def test_the_agents_of_the_horizon_report_are_one_family():
    agents = [
        load_checkpoint(path) for path in sorted((SHIPPED / "seeds").glob("laplace_LunarLander-v3_*.safetensors"))
    ]
    assert [agent.seed for agent in agents] == [0, 1, 2, 3, 4]
    wanted = [settings_of("laplace", "LunarLander-v3", {"seed": seed}) for seed in range(5)]
    assert [agent.settings for agent in agents] == wanted


def test_the_median_of_three_runs_ships(tmp_path, monkeypatch):
    from laplace_core.experiments import shipping, training

    quick = {"steps": 200, "learning_starts": 100, "evaluate_every": 200, "hidden": 8, "features": 4}
    for module in (shipping, training):
        monkeypatch.setattr(module, "settings_of", lambda a, e, given: settings_of(a, e, quick | given))
    monkeypatch.setattr(training, "EPISODES", 4)
    for seed in range(3):
        for _ in train(
            settings_of("laplace", "two_branch", quick | {"seed": seed}), tmp_path / f"laplace_two_branch_{seed}"
        ):
            pass
    folder = tmp_path / "out"
    folder.mkdir()
    entry = ship("laplace", "two_branch", 3, tmp_path, folder=folder)
    assert manifest(folder) == [entry]
    # A run of 200 steps that is evaluated every 200 has one evaluation, at the end of the episode under way.
    curves = curves_of(folder, entry)
    assert [(curve.seed, len(curve.steps), len(curve.scores)) for curve in curves] == [
        (seed, 1, 1) for seed in range(3)
    ]
    assert all(200 <= curve.steps[0] < 210 for curve in curves)
    assert curves_of(folder, {"file": "one from before there were curves"}) == ()
    written = folder / entry["curve"]["file"]
    data = written.read_bytes()
    for spoiled in (data[:-3], b"", data + b" " * 300_000):
        written.write_bytes(spoiled)
        with pytest.raises(InputError, match="training curve"):
            curves_of(folder, entry)
    uneven = b'[{"seed": 0, "steps": [1], "scores": [], "errors": []}]'
    for content in (b'[{"seed": 0}]', uneven, b'["a"]', b"[1]", b"1"):
        written.write_bytes(content)
        told = entry["curve"] | {"sha256": hashlib.sha256(content).hexdigest()}
        with pytest.raises(InputError, match="training curve"):
            curves_of(folder, entry | {"curve": told})
    assert entry["score"] == sorted(entry["scores"])[1]
    assert load_checkpoint(folder / entry["file"]).seed == entry["seed"]
    with pytest.raises(InputError, match="not finished"):
        ship("laplace", "two_branch", 4, tmp_path, folder=folder)
