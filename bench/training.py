"""The trainer: updates and whole runs against a well-known QR-DQN, growth with the grids."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from importlib.util import find_spec
from pathlib import Path
from tempfile import TemporaryDirectory
from time import perf_counter

import gymnasium
import numpy as np
import torch

from bench import runs
from bench.report import Figure, Goal
from bench.timing import interleaved, spread
from laplace_core.agents import SETTINGS, LaplaceSettings, LoopSettings
from laplace_core.agents.agent import Agent
from laplace_core.agents.registry import AGENTS
from laplace_core.training.events import Episode
from laplace_core.training.loop import train
from laplace_core.training.replay import Replay

OBSERVATION, ACTIONS, BATCH, QUANTILES = 8, 4, 128, 170
STANDARD = LaplaceSettings(
    environment="LunarLander-v3", gammas=15, thetas=100, theta_spacing="asinh", theta_min=-135.0, theta_max=135.0
)
SUBJECT = "Training"


def figures() -> Iterator[Figure]:
    torch.set_num_threads(1)
    yield from _against_quantiles()
    yield from _growth()
    yield from _variants()
    yield from _experience()


def agent(settings: LoopSettings) -> Agent:
    return AGENTS[settings.ALGORITHM](settings, OBSERVATION, ACTIONS, 1000)


def one_update(settings: LoopSettings) -> Callable[[], object]:
    """Drawing a batch and learning from it: loss, gradient, optimiser and averaging."""
    learner, random = agent(settings), np.random.default_rng(0)
    own = settings.own_experience
    replay = Replay(2_000, settings.rings, OBSERVATION, own=own)
    for i in range(2_000 // settings.rings):
        _add(replay, i, random)
    return lambda: learner.update(replay.sample(settings.batch, random)[0], 0.0)


def _add(replay: Replay, time: int, random: np.random.Generator) -> None:
    n = replay.rings
    replay.add(
        np.ones(n, bool),
        random.normal(size=(n, OBSERVATION)),
        random.integers(ACTIONS, size=n),
        random.normal(size=n),
        next_observations=random.normal(size=(n, OBSERVATION)),
        terminated=np.full(n, time % 100 == 99),
        truncated=np.zeros(n, bool),
        elapsed=np.full(n, time % 100 + 1),
    )


class Noise(gymnasium.Env):
    """Random observations of the size of LunarLander's, for an update that needs none better."""

    observation_space = gymnasium.spaces.Box(-10.0, 10.0, (OBSERVATION,), np.float32)
    action_space = gymnasium.spaces.Discrete(ACTIONS)

    def reset(self, *, seed=None, options=None):
        super().reset(seed=seed)
        return self._draw(), {}

    def step(self, action):
        return self._draw(), float(self.np_random.normal()), bool(self.np_random.random() < 0.01), False, {}

    def _draw(self) -> np.ndarray:
        return self.np_random.normal(size=OBSERVATION).astype(np.float32)


def quantile_update() -> Callable[[], object]:
    """One update of sb3-contrib's QR-DQN, its batch drawn from its own buffer."""
    from sb3_contrib import QRDQN

    model = QRDQN(
        "MlpPolicy", Noise(), batch_size=BATCH, learning_starts=2_000, buffer_size=2_000, device="cpu", seed=0,
        policy_kwargs={"net_arch": [256, 256], "n_quantiles": QUANTILES},
    )  # fmt: skip
    model.learn(1_999)
    torch.set_num_threads(1)
    return lambda: model.train(gradient_steps=1, batch_size=BATCH)


def _against_quantiles() -> Iterator[Figure]:
    if find_spec("sb3_contrib") is None:
        print("  sb3-contrib is not installed: no comparison with QR-DQN")
        return
    ours = one_update(STANDARD)
    peer = one_update(SETTINGS["qrdqn"](environment="LunarLander-v3", quantiles=QUANTILES, batch=BATCH, hidden=256))
    timed = {"laplace": (ours, 3), "quantiles": (quantile_update(), 1), "peer": (peer, 3), "again": (ours, 3)}
    seconds = interleaved(timed, rounds=41)
    sizes = f"15 discounts x 100 sensitivities, {QUANTILES} quantiles, batch {BATCH}, hidden 256 x 256"
    yield Figure(
        SUBJECT, "one update / one of sb3-contrib's QR-DQN", spread(seconds["laplace"] / seconds["quantiles"]), "x",
        sizes, Goal("<=", 0.5), "drawing the batch, loss, gradient, optimiser; ours also averages the target network",
    )  # fmt: skip
    yield Figure(
        SUBJECT, "one update of our QR-DQN / one of sb3-contrib's", spread(seconds["peer"] / seconds["quantiles"]), "x",
        f"{QUANTILES} quantiles, batch {BATCH}, hidden 256 x 256", Goal("<=", 0.6),
        "ours also averages the target network and, with double targets, chooses by the online one",
    )  # fmt: skip
    yield Figure(
        SUBJECT, "one update / itself", spread(seconds["again"] / seconds["laplace"]), "x", sizes,
        note="the same update timed twice a round: what noise alone makes",
    )  # fmt: skip
    yield Figure(SUBJECT, "one update", spread(1e3 * seconds["laplace"]), "ms", sizes)
    yield from _whole_runs()


def _whole_runs() -> Iterator[Figure]:
    """CartPole at the settings of the RL zoo: an update for every two transitions, of 64, and 10 quantiles."""
    settings = SETTINGS["qrdqn"](
        steps=4_000, envs=8, learning_starts=500, hidden=256, batch=64, quantiles=10, update_every=8, updates=4,
        double=False, exploration=0.16, epsilon_final=0.04, evaluate_every=10**6, evaluate_episodes=1,
        checkpoint_every=10**6,
    )  # fmt: skip
    pairs = [(_steps_per_second(settings), _library_steps_per_second(2_560)) for _ in range(7)]
    sizes = "10 quantiles, batch 64, an update every 2 transitions, hidden 256 x 256"
    yield Figure(
        SUBJECT, "CartPole with our QR-DQN / with sb3-contrib's, steps/s", spread([one / two for one, two in pairs]),
        "x", sizes, Goal(">=", 1.5), "the whole loop, without double targets; ours steps 8 environments side by side",
    )  # fmt: skip
    yield Figure(SUBJECT, "CartPole with our QR-DQN", spread([one for one, _ in pairs]), "steps/s", sizes)


def _library_steps_per_second(steps: int) -> float:
    """Of sb3-contrib's QR-DQN once it learns; ``steps`` is a multiple of 256, after which it has 128 updates."""
    from sb3_contrib import QRDQN

    model = QRDQN(
        "MlpPolicy", "CartPole-v1", learning_rate=2.3e-3, batch_size=64, learning_starts=500, target_update_interval=10,
        train_freq=256, gradient_steps=128, exploration_fraction=0.16, exploration_final_eps=0.04, device="cpu", seed=0,
        buffer_size=50_000, policy_kwargs={"net_arch": [256, 256], "n_quantiles": 10},
    )  # fmt: skip
    model.learn(512)
    torch.set_num_threads(1)
    began = perf_counter()
    model.learn(steps, reset_num_timesteps=False)
    return steps / (perf_counter() - began)


def _growth() -> Iterator[Figure]:
    discounts = {count: one_update(replace(STANDARD, gammas=count)) for count in (1, 5, 15, 45)}
    seconds = interleaved({str(count): (update, 2) for count, update in discounts.items()}, rounds=15)
    for count in (5, 15, 45):
        goal = Goal("<", count) if count == 45 else None
        yield Figure(
            SUBJECT, f"one update at {count} discounts / at 1", spread(seconds[str(count)] / seconds["1"]), "x",
            f"100 sensitivities, batch {BATCH}", goal, "sublinear in discounts" if goal else "",
        )  # fmt: skip
    thetas = {count: one_update(replace(STANDARD, thetas=count)) for count in (25, 100, 400)}
    seconds = interleaved({str(count): (update, 2) for count, update in thetas.items()}, rounds=15)
    for count in (100, 400):
        yield Figure(
            SUBJECT, f"one update at {count} sensitivities / at 25", spread(seconds[str(count)] / seconds["25"]), "x",
            f"15 discounts, batch {BATCH}",
        )  # fmt: skip


def _variants() -> Iterator[Figure]:
    changes = {
        "trunk": {}, "network": {"network": "network"}, "multiplexer": {"network": "multiplexer"},
        "accumulated": {"parametrisation": "accumulated"}, "per_gamma": {"target_policy": "per_gamma"},
    }  # fmt: skip
    updates = {name: (one_update(replace(STANDARD, **change)), 1) for name, change in changes.items()}
    seconds = interleaved(updates, rounds=11)
    for name in list(changes)[1:]:
        yield Figure(
            SUBJECT, f"one update with {name} / the standard one", spread(seconds[name] / seconds["trunk"]), "x",
            f"15 discounts x 100 sensitivities, batch {BATCH}",
        )  # fmt: skip


def _experience() -> Iterator[Figure]:
    common = {
        "steps": 3_000, "learning_starts": 500, "evaluate_every": 10**6, "evaluate_episodes": 1,
        "checkpoint_every": 10**6, "hidden": 128, "features": 32, "exploration": 0.5,
    }  # fmt: skip
    for experience, batch in (("shared", 64), ("per_discount", 64), ("per_discount", 5)):
        settings = LaplaceSettings(**common, experience=experience, batch=batch)
        rates = [_steps_per_second(settings) for _ in range(3)]
        rows = batch * (15 if experience == "per_discount" else 1)
        yield Figure(
            SUBJECT, f"CartPole, experience {experience}, {rows} transitions in an update", spread(rates), "steps/s",
            f"15 discounts x {settings.thetas} sensitivities, 4 updates every 8 transitions", note="the whole loop",
        )  # fmt: skip


def _steps_per_second(settings: LaplaceSettings) -> float:
    """Of the part of a run in which the agent learns."""
    with TemporaryDirectory() as folder:
        first = None
        for event in train(settings, Path(folder) / "run"):
            if first is None and event.step >= settings.learning_starts:
                first = event.step, perf_counter()
            if isinstance(event, Episode):
                last = event.step, perf_counter()
    return (last[0] - first[0]) / (last[1] - first[1])


def main() -> Iterator[Figure]:
    yield from figures()
    yield from runs.figures()
