"""Whatever is switched in the lens: study, command, Python, NPZ and CSV give the numbers of the picture."""

from __future__ import annotations

import contextlib
import csv
import io
import shlex

import numpy as np
import pytest

from laplace_core import GammaSpace, Settings, load_world, study, study_of_gamma_space
from laplace_core.cli import main
from laplace_core.payloads.lens import payload, structure
from laplace_core.payloads.state import state_of
from laplace_core.study.npz import save_study
from laplace_core.study.tables import rewards_csv, tau_space_csv, values_csv
from tests.support.lens_reference import seen

WORLDS = ("two_branch", "two_decisions", "fig6_chain", "discounting_chain", "double_chain")
SAME = ("tau_space", "survival", "expected_reward", "horizon_values")


def random_settings(rng: np.random.Generator, **own) -> dict[str, object]:
    """Every switch on, but for one or two left to chance; T anywhere."""
    time_step = float(rng.choice([1.0, 1.0, 0.5]))
    steps = int(rng.integers(4, 16))
    values = {
        "steps": steps,
        "time_step": time_step,
        "alpha": float(10 ** rng.uniform(-4, 0)),
        "normalise": str(rng.choice(["none", "survival", "paper"])),
        "softness": float(rng.choice([0.0, 0.2])),
        "noise": float(rng.choice([0.0, 1e-3])),
        "noise_seed": int(rng.integers(1000)),
        "deadline": str(rng.choice(["time_to_go", "constant"])),
        "horizon": float(rng.uniform(1.0, steps * time_step)),
        "used": float(rng.integers(1, 4)),
        "value_gamma": float(rng.uniform(0.5, 0.99)),
        "fold": bool(rng.random() < 0.8),
        "shift": bool(rng.random() < 0.8),
    }
    return values | own


def of_a_world(rng: np.random.Generator):
    world = load_world(str(rng.choice(WORLDS)))
    more = {"thetas": int(rng.integers(20, 40)), "policy": str(rng.choice(["shared", "per_gamma"]))}
    more |= {"clip": bool(rng.random() < 0.8), "paper_grid": bool(rng.random() < 0.8)}
    settings = Settings(world=world.source, **random_settings(rng, **more))
    return world, study(world, settings)


def of_a_network(rng: np.random.Generator):
    """A gamma-space as of a trained agent: open ends, and a slope that is known."""
    space = study(load_world("two_branch"), Settings(thetas=30, theta_min=-4.0, theta_max=14.0, slope=4.0)).gamma_space
    places = np.asarray(4.0 * space.thetas)
    space = GammaSpace(space.values, space.constant, space.gammas, space.thetas, open_ends=True, places=places)
    settings = Settings(world="network.npz", **random_settings(rng, slope_share=float(rng.uniform(0.3, 1.0))))
    return space, study_of_gamma_space(space, settings)


def picture(subject, found) -> dict[str, np.ndarray]:
    """What the lens draws of it, from what the browser is handed."""
    s = found.settings
    plain = structure(s, found.world)
    if found.world is None:
        data = payload(study_of_gamma_space(subject, plain.chosen()), places=subject.places)[0]
    else:
        data = payload(study(subject, plain))[0]
    return seen(data, state_of(s, float(found.horizons[found.row])))


def held(shown: dict[str, np.ndarray], rows: int, **others: np.ndarray) -> None:
    """Numbers against those of the picture, to 1e-9 of the largest; rows that are not decoded are 0."""
    for name, array in others.items():
        wanted = shown[name]
        if name != "horizon_values":
            assert not np.any(array[:, rows:])
            array = array[:, :rows]
        np.testing.assert_allclose(array, wanted, rtol=0, atol=1e-9 * max(1.0, np.abs(wanted).max()))


@pytest.mark.parametrize(
    ("made", "count"),
    [
        (of_a_world, 40), pytest.param(of_a_world, 160, marks=pytest.mark.long),
        (of_a_network, 12), pytest.param(of_a_network, 40, marks=pytest.mark.long),
    ],
)  # fmt: skip
def test_everything_gives_the_numbers_of_the_picture(made, count, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    switched = 0
    for seed in range(count):
        rng = np.random.default_rng([count, seed])
        subject, found = made(rng)
        s, shown = found.settings, picture(subject, found)
        rows = shown["tau_space"].shape[1]
        switched += s.fold and s.shift
        held(shown, rows, **{name: getattr(found.decoded, name) for name in SAME})

        if found.world is None:  # its file is what a command and a script read
            save_study(study_of_gamma_space(subject, structure(s, None).chosen()), "network.npz")
        with contextlib.redirect_stdout(io.StringIO()):
            main(shlex.split(s.to_command("view.npz"))[3:])
        file = np.load("view.npz")
        held(shown, rows, **{name: file[name] for name in SAME})
        for name in ("discount_kernel", "averaging_kernel", "gamma_space"):
            np.testing.assert_allclose(file[name], shown[name], rtol=0, atol=1e-9 * max(1, np.abs(shown[name]).max()))
        assert file["read_row"] == shown["read_row"]

        names: dict[str, object] = {}
        exec(compile(s.to_python(), "script", "exec"), names)
        held(shown, rows, **{name: getattr(names["result"].decoded, name) for name in SAME})

        held(shown, rows, **from_csv(found))
    assert switched > count / 3


def from_csv(found) -> dict[str, np.ndarray]:
    """The arrays of a study from its tables."""
    actions, step = len(found.action_names), found.settings.time_step
    tau = column(tau_space_csv(found), "probability").reshape(found.decoded.tau_space.shape) * step
    rewards = rewards_csv(found)
    return {
        "tau_space": tau,
        "expected_reward": column(rewards, "expected_reward").reshape(actions, -1) * step,
        "survival": column(rewards, "survival").reshape(actions, -1) * step,
        "horizon_values": column(values_csv(found), "value").reshape(actions, -1),
    }


def column(text: str, name: str) -> np.ndarray:
    return np.array([float(line[name]) for line in csv.DictReader(io.StringIO(text))])
