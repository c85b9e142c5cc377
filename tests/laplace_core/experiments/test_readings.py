"""What experiments read of finished trainings: values at held-out discounts, returns by rows; where it is kept."""

from __future__ import annotations

import json
import shutil
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from laplace_core.acting.rollout import roll_out
from laplace_core.cli import main, reproduce
from laplace_core.errors import InputError
from laplace_core.experiments.paper import EXPERIMENTS, held_out, results, rows_read
from laplace_core.experiments.paper.experiment import Cell, Experiment
from laplace_core.training.checkpoint import load_checkpoint
from laplace_core.training.defaults import settings_of
from laplace_core.training.loop import train

QUICK = {"hidden": 8, "features": 4}
STEPS = 400


def trained(folder: Path, environment: str = "CartPole-v1", steps: int = STEPS, **changed) -> Path:
    settings = replace(settings_of("laplace", environment, changed), steps=steps, evaluate_every=steps)
    for _ in train(settings, folder):
        pass
    return folder


# ---- discounts that are held out


@pytest.mark.parametrize("name", ["CartPole", "LunarLander"])
def test_every_other_discount_is_held_out(name):
    cells = {cell.label: cell for cell in EXPERIMENTS["interpolation"].cells}
    for network in ("network", "multiplexer"):
        all_of_them, kept = (
            cells[f"{name}, {network}, {which}"].trainings()[0] for which in ("all fifteen", "every other")
        )
        np.testing.assert_allclose(kept.discounts(), all_of_them.discounts()[::2], rtol=1e-12)
        assert replace(kept, gammas=all_of_them.gammas) == all_of_them


@pytest.mark.parametrize("network", ["network", "multiplexer"])
def test_errors_are_those_of_every_step_one_by_one(tmp_path, monkeypatch, network):
    monkeypatch.setattr(held_out, "EPISODES", 2)
    folder = trained(tmp_path / "run", network=network, gammas=8, hidden=8)
    read = held_out.value_errors(folder, 15)
    agent = load_checkpoint(folder / "best.safetensors").agent
    gammas = np.array(read["gammas"])
    assert np.flatnonzero(read["trained"]).tolist() == list(range(0, 15, 2))
    errors, counts = np.zeros(15), np.zeros(15, dtype=int)
    lines = np.zeros(15)
    for seed in range(held_out.FIRST_START, held_out.FIRST_START + 2):
        episode = roll_out(agent, "CartPole-v1", seed)
        for t, (observation, action) in enumerate(zip(episode.observations, episode.actions, strict=False)):
            own = [agent.action_values(observation[None], head)[0, action] for head in range(8)]
            later = episode.rewards[t:]
            for g, gamma in enumerate(gammas):
                if not episode.terminated and gamma ** len(later) > held_out.NEGLIGIBLE:
                    continue
                truth = sum(gamma**n * reward for n, reward in enumerate(later))
                space = agent.gamma_space(observation, gammas[g : g + 1])
                value = float(space.differences[action, 0] @ space.bin_values)
                if g % 2 == 0:
                    assert value == pytest.approx(own[g // 2], rel=1e-3, abs=1e-3)  # the heads are in single precision
                else:  # the middle of two neighbours in log time
                    scaled = [own[i] * (1.0 - agent.gammas[i]) for i in (g // 2, g // 2 + 1)]
                    lines[g] += abs(np.mean(scaled) - truth * (1.0 - gamma))
                errors[g] += abs(value - truth) * (1.0 - gamma)
                counts[g] += 1
    assert read["states"] == counts.tolist()
    np.testing.assert_allclose(read["network"], errors / counts, atol=2e-6)
    for g in range(15):
        assert read["line"][g] == (None if g % 2 == 0 else pytest.approx(lines[g] / counts[g], abs=1e-4))


def test_a_trunk_has_no_values_between_its_own(tmp_path):
    with pytest.raises(InputError, match="trunk"):
        held_out.value_errors(trained(tmp_path / "run", gammas=8, **QUICK), 15)


# ---- rescaled rows


# The toy MDP of figure 4: action 0 pays 5 and ends, action 1 pays 10 at the third step. Rows that are rescaled repeat
# the 5 for 15 in all; rows that keep the survival, and rescaled ones behind auxiliary states, do not.
@pytest.mark.long
@pytest.mark.parametrize(("termination", "rescaled"), [("plain", 5.0), ("auxiliary", 10.0)])
def test_rescaled_rows_repeat_a_reward_unless_there_are_auxiliary_states(tmp_path, monkeypatch, termination, rescaled):
    for name in ("EPISODES", "TUNED"):
        monkeypatch.setattr(rows_read, name, 3)
    monkeypatch.setattr(rows_read, "ALPHAS", (0.2,))
    folder = trained(tmp_path / "run", "two_branch", 6000, termination=termination)
    read = rows_read.returns_by_rows(folder, (3,))
    assert read["T 3"]["rescaled"] == {"alpha": 0.2, "returns": [rescaled] * 3}
    assert read["T 3"]["left alone"] == {"alpha": 0.2, "returns": [10.0] * 3}
    assert read["T 3"]["greedy"]["returns"] == [10.0] * 3


# ---- where a reading is kept


def seed_read(folder: Path) -> dict:
    return {"seed": load_checkpoint(folder / "best.safetensors").agent.settings.seed}


@pytest.fixture
def small(monkeypatch):
    """Two experiments that share a training, of which the first reads it."""
    cells = [Cell("plain", "laplace", "two_branch", QUICK, seeds=(1,))]
    for name in list(EXPERIMENTS):
        monkeypatch.delitem(EXPERIMENTS, name)
    monkeypatch.setitem(EXPERIMENTS, "reads", Experiment("reads", "Reads", "Reads?", cells, seed_read))
    monkeypatch.setitem(EXPERIMENTS, "other", Experiment("other", "Other", "Not?", cells))
    monkeypatch.setattr(results, "EPISODES", 3)
    monkeypatch.setattr(reproduce, "MEASUREMENTS", ())


def words(folder: Path, name: str, *more: str) -> list[str]:
    return [
        "reproduce",
        name,
        *more,
        "--steps",
        str(STEPS),
        "--runs",
        str(folder / "runs"),
        "--out",
        str(folder / "out"),
    ]


def rows(folder: Path, name: str) -> list[dict]:
    return json.loads((folder / "out" / f"{name}.json").read_text())["cells"][0]["trainings"]


def test_a_reading_is_in_the_file_of_its_experiment_alone(small, tmp_path):
    assert main(words(tmp_path, "other")) == 0
    assert main(words(tmp_path, "reads")) == 0
    assert [row["reading"] for row in rows(tmp_path, "reads")] == [{"seed": 1}]
    (tmp_path / "out" / "other.json").unlink()
    assert main(words(tmp_path, "other")) == 0
    assert not any("reading" in row for row in rows(tmp_path, "other"))


def test_a_reading_holds_without_its_run_and_is_not_measured_again(small, tmp_path, monkeypatch, capsys):
    assert main(words(tmp_path, "reads")) == 0
    before = (tmp_path / "out" / "reads.json").read_bytes()
    shutil.rmtree(tmp_path / "runs")
    assert main(words(tmp_path, "reads")) == 0
    assert (tmp_path / "out" / "reads.json").read_bytes() == before


def test_a_result_without_its_reading_says_that_the_run_is_gone(small, tmp_path, capsys):
    assert main(words(tmp_path, "other")) == 0
    shutil.rmtree(tmp_path / "runs")
    assert main(words(tmp_path, "reads")) == 2
    assert "reads needs the run folder" in capsys.readouterr().err
    assert [row["seed"] for row in rows(tmp_path, "reads")] == [1]


def test_rows_of_an_earlier_version_get_their_episodes_from_the_run(small, tmp_path):
    assert main(words(tmp_path, "other")) == 0
    whole = rows(tmp_path, "other")
    for row in whole:
        path = tmp_path / "runs" / row["run"] / results.RESULT
        path.write_text(json.dumps({name: value for name, value in row.items() if name != "each_episode"}))
    assert main(words(tmp_path, "other", "--collect")) == 0
    assert rows(tmp_path, "other") == whole
    for row in whole:
        each = row["each_episode"]
        assert len(each["episodes"]) == len(each["steps"]) == len(each["returns"]) > 5
        assert each["episodes"] == sorted(set(each["episodes"]))
        assert each["episodes"][-1] <= row["episodes"]
