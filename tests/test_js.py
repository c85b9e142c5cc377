"""The JavaScript shows what the library computes: ``node --test tests/js`` on fixtures that are written here."""

from __future__ import annotations

import base64
import json
import os
import re
import subprocess
import sysconfig
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from laplace_core import GammaSpace, Settings, load_world, study, study_of_gamma_space
from laplace_core.acting.return_laws import ReturnLaw
from laplace_core.acting.rollout import Rollout
from laplace_core.code.gamma_space import bin_differences
from laplace_core.code.interpolation import left_out
from laplace_core.code.noise import normal_noise
from laplace_core.figures import returns_of_actions
from laplace_core.payloads.lens import payload as lens_payload
from laplace_core.payloads.lens import structure
from laplace_core.payloads.player import payload as player_payload
from laplace_core.payloads.player import rounded
from laplace_core.payloads.state import state_of
from laplace_core.trained.rollouts import followed
from tests.support.inverse_agreement import fixture as inverse
from tests.support.lens_agreement import fixture, network, packed, payloads, random_cases, solved, verdicts
from tests.support.lens_reference import seen, unpacked

ROOT = Path(__file__).resolve().parent.parent
NODE = Path(sysconfig.get_path("scripts")) / "node"
VIEWS = int(os.environ.get("LENS_VIEWS", "20"))
"""`make verify` asks for 1,000."""


@pytest.fixture(scope="module")
def spaces():
    return payloads(small=True), network()


def agreement(spaces) -> dict[str, Any]:
    """Every kind of payload under states over the whole range of every control."""
    held, of_network = spaces
    return fixture(held | of_network, random_cases(held, 72, 7) + random_cases(of_network, 18, 7))


def algebra() -> dict[str, Any]:
    rng = np.random.default_rng(3)
    a, b = rng.normal(size=(4, 5)), rng.normal(size=(5, 3))
    noise = [
        {"seed": seed, "skip": skip, "values": packed(normal_noise(seed, (40,), skip))}
        for seed, skip in ((0, 0), (7, 3), (2**31 - 1, 1000))
    ]
    return {"a": packed(a), "b": packed(b), "product": packed(a @ b), "transposed": packed(a.T), "noise": noise}


def interpolation(spaces) -> dict[str, Any]:
    """The player hands the lens the trained discounts only; and the error of each that is left out."""
    data = spaces[1]["network"][0]
    header, arrays = unpacked(data)
    every = header["added"] + 1
    trained = arrays["differences"][:, ::every]
    tails = np.cumsum(trained[1][:, ::-1], axis=-1)[:, ::-1]
    return {
        "payload": base64.b64encode(data).decode(),
        "trained": {"differences": packed(trained), "constant": packed(arrays["constant"][:, ::every])},
        "filled": {name: packed(arrays[name]) for name in ("differences", "constant")},
        "left_out": packed(left_out(tails, arrays["gammas"][::every]).max(axis=-1)),
    }


def reel() -> dict[str, Any]:
    """An episode of made-up numbers: N = 6 steps, A = 2 actions, G = 5 discounts, H = 9 sensitivities."""
    rng, N = np.random.default_rng(5), 6
    gammas, thetas = np.linspace(0.5, 0.95, 5), np.linspace(-3.0, 12.0, 9)
    tails = np.sort(rng.random((N, 2, 5, 10)), axis=-1)[..., ::-1].astype(np.float32)
    episode = Rollout(
        "made-up", 1, "greedy", None, None, 0.97,
        observations=rng.normal(size=(N + 1, 3)).astype(np.float32),
        actions=rng.integers(0, 2, N), rewards=rng.normal(size=N), values=rng.normal(size=(N, 2)),
        greedy_values=rng.normal(size=(N, 2)), predicted=rng.normal(size=N), received=rng.normal(size=N),
        surprise=rng.normal(size=N), terminated=True, spaces=tails[..., 1:], constants=tails[..., 0], gammas=gammas,
        thetas=thetas, frames=tuple(bytes([step] * (step + 2)) for step in range(N + 1)),
    )  # fmt: skip
    levels, scales = rounded(bin_differences(episode.spaces, episode.constants, open_ends=True))
    space = GammaSpace(episode.spaces[0].astype(float), episode.constants[0].astype(float), gammas, thetas, True)
    base = study_of_gamma_space(space, structure(Settings(world="network", steps=8), None))
    return {
        "payload": base64.b64encode(player_payload(episode)).decode(),
        "lens": base64.b64encode(lens_payload(base)[0]).decode(),
        "blocks": {
            name: packed(getattr(episode, name))
            for name in ("rewards", "values", "greedy_values", "predicted", "received", "surprise", "observations")
        },
        "taken": episode.actions.tolist(),
        "differs": packed(episode.differs),
        "differences": [packed(levels[step] * scales[:, None]) for step in range(N)],
        "constant": [packed(episode.constants[step]) for step in range(N)],
        "frames": [base64.b64encode(frame).decode() for frame in episode.frames],
        "followed": [followed(episode, step) for step in range(N)],
        "by_surprise": np.argsort(-np.abs(episode.surprise), kind="stable").tolist(),
    }


def laws() -> dict[str, Any]:
    """What an agent says of the return, as the player gets it, and as the figure at rest draws it."""
    rng, N, A, M = np.random.default_rng(9), 4, 3, 21
    locations = np.sort(rng.normal(size=(N, A, M)), axis=-1).astype(np.float32)
    masses = rng.dirichlet(np.ones(M), size=(N, A)).astype(np.float32)
    drawn = []
    for step in range(N):
        each = [
            ReturnLaw("learned", 0.9, locations[step, a].astype(float), masses[step, a].astype(float)) for a in range(A)
        ]
        figure = returns_of_actions(each, ("a", "b", "c"), 0)
        drawn.append({
            "x": [np.asarray(trace["x"]).tolist() for trace in figure["data"]],
            "y": [np.asarray(trace["y"]).tolist() for trace in figure["data"]],
            "range": list(figure["layout"]["xaxis"]["range"]),
        })  # fmt: skip
    return {"locations": packed(locations), "masses": packed(masses), "steps": N, "actions": A, "drawn": drawn}


def table(spaces) -> dict[str, Any]:
    """A state and the columns of the table that is saved of it."""
    data, settings = spaces[0]["two_branch"]
    state = state_of(settings, 3.0, action=1) | {"normalise": "paper"}
    header, arrays = unpacked(data)
    shown, a = seen(data, state), state["action"]
    names = header["actions"]
    columns = {
        "tau": np.arange(settings.steps) * settings.time_step,
        "reward": shown["expected_reward"][a],
        "survival": shown["survival"][a],
        "horizon": shown["horizons"],
        **{f"value of {name}": line for name, line in zip(names, shown["horizon_values"], strict=True)},
    }
    return {
        "payload": base64.b64encode(data).decode(),
        "state": state,
        "columns": {name: packed(column) for name, column in columns.items()},
        "tau_space": packed(shown["tau_space"][a]),
        "best": [names[best] for best in arrays["optimum"].argmax(axis=0)],
    }


def truth() -> list[dict[str, Any]]:
    """Views of a world whose steps fall on rows, between them, and under a soft deadline."""
    world, views = load_world("two_decisions"), []
    for values in ({}, {"time_step": 0.4}, {"time_step": 0.3, "softness": 0.2, "value_gamma": 0.9}):
        shown = study(world, Settings(world="two_decisions", thetas=20, **values))
        views.append({
            "payload": base64.b64encode(lens_payload(study(world, structure(shown.settings, world)))[0]).decode(),
            "state": state_of(shown.settings, float(shown.horizons[-1])),
            "rewards": packed(shown.truth.expected_reward),
            "survival": packed(shown.truth.survival),
            "values": packed(shown.truth.horizon_values),
            "optimum": packed(shown.truth.optimum),
        })  # fmt: skip
    return views


def test_the_javascript_shows_what_the_library_computes(spaces, tmp_path):
    assert NODE.is_file(), "no node in the environment: pip install -r requirements-dev.txt brings it"
    for name, content in {
        "agreement": agreement(spaces),
        "solvers": fixture(*solved(16)),
        "verdicts": verdicts(VIEWS),
        "algebra": algebra(),
        "interpolation": interpolation(spaces),
        "reel": reel(),
        "laws": laws(),
        "table": table(spaces),
        "truth": truth(),
        "inverse": inverse(),
    }.items():
        (tmp_path / f"{name}.json").write_text(json.dumps(content))
    run = subprocess.run(
        [NODE, "--test", "--test-reporter=spec", "tests/js/*.test.js"], cwd=ROOT, capture_output=True, text=True,
        check=False, env=os.environ | {"LAPLACE_FIXTURES": str(tmp_path)},
    )  # fmt: skip
    said = run.stdout + run.stderr
    assert run.returncode == 0, said[said.find("failing tests") :]
    assert int(re.search(r"pass (\d+)", said)[1]) >= 30, said  # and they were there
