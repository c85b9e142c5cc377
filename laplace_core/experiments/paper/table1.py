"""Table 1: returns of LunarLander where an episode ends after T steps, and what the paper's way of decoding costs.

Peers act greedily, as in the paper. Laplace DQN acts greedily, by the rules of the library, and *as the paper decoded
it*, with six faults at once: each is then mended alone, and one after another. Alpha is chosen for each way on starts
of its own (``TUNED``), and the return is reported on others. The shipped agents have one target policy for all
discounts, so that mixed policies, a seventh fault, are not in this table.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from laplace_core.acting.bootstrap import interval, mean_interval
from laplace_core.acting.evaluation import FIRST_SEED, evaluate, played
from laplace_core.acting.rules import Choose
from laplace_core.agents.capabilities import HasGammaSpace
from laplace_core.code.gamma_space import bin_differences, bin_values
from laplace_core.code.interpolation import mixing
from laplace_core.code.ties import greedy_action
from laplace_core.environments import vector
from laplace_core.experiments.paper.measurement import Measurement, Options, Result, Row
from laplace_core.inverse import decode_matrix, normalise_rows
from laplace_core.study.horizon import deadline_weights
from laplace_core.training.checkpoint import Loaded, load_checkpoint

ENVIRONMENT, HORIZONS = "LunarLander-v3", (50, 100, 200, None)
CHECKPOINTS = Path(__file__).resolve().parents[3] / "checkpoints"
SEEDS = tuple(f"seeds/laplace_{ENVIRONMENT}_{seed}" for seed in range(5))
PEERS = ("c51", "qrdqn", "dqn")
RULES = ("greedy", "matched", "fading")
EPISODES, TUNED = 100, 20
TUNING_SEED = FIRST_SEED + 900 * 100_000
"""Start seeds of the choice of alpha, of which no report uses any."""
ALPHAS = (0.03, 0.1, 0.3, 1.0, 3.0)
FAULTS = {
    "rescaled": "rows rescaled to 1",
    "folded": "as many rows as T",
    "constant": "the same T at every step",
    "linear": "discounts interpolated to 100, evenly in gamma",
    "closed": "rewards beyond the outermost sensitivities left out",
    "hard": "a hard deadline",
}
"""What the paper's way of decoding does, each with its words."""
STEPS, SOFTNESS, DISCOUNTS = 1000, 0.2, 100
"""What the library does in place of ``folded``, ``hard`` and ``linear``: rows, width of the deadline, own discounts."""


def ways() -> dict[str, tuple[str, ...]]:
    """The faults of each way to decode, by its name."""
    names = tuple(FAULTS)
    alone = {f"without {name}": tuple(each for each in names if each != name) for name in names}
    mended = {f"{i} mended": names[i:] for i in range(2, len(names) + 1)}
    return {"as in the paper": names, **alone, **mended}


def by_decoding(agent: HasGammaSpace, acting: float, length: int, faults: Sequence[str], *, alpha: float) -> Choose:
    """Acts on V_T of a tau-space that is decoded at every step.

    Args:
        acting: the discount of the values.
        length: T, in steps.
        faults: names in :data:`FAULTS`.
    """
    gammas, mix = agent.gammas, None
    if "linear" in faults:
        wanted = np.linspace(gammas[0], gammas[-1], DISCOUNTS)
        gammas, mix = wanted, mixing(gammas, wanted)
    open_ends = "closed" not in faults
    rewards = bin_values(agent.thetas, open_ends)
    matrices: dict[int, np.ndarray] = {}

    def choose(observations: np.ndarray, time: int) -> np.ndarray:
        left = length if "constant" in faults else length - time
        rows = left if "folded" in faults else max(STEPS, length)
        if rows not in matrices:
            matrices.clear()
            matrices[rows] = decode_matrix(gammas, rows, alpha)
        weights = acting ** np.arange(rows) * deadline_weights(left, rows, 0.0 if "hard" in faults else SOFTNESS)
        values, constant = agent.gamma_spaces(observations)
        masses = bin_differences(values, constant, open_ends)
        masses = masses if mix is None else mix @ masses
        if "rescaled" not in faults:  # linear: the weights go to the discounts, and no row is ever made
            return greedy_action((weights @ matrices[rows]) @ masses @ rewards)
        chosen = []
        needed = int(np.flatnonzero(weights)[-1]) + 1  # rows behind a hard deadline weigh nothing
        for each in masses:
            decoded = matrices[rows][:needed] @ each
            chosen.append(normalise_rows(decoded, decoded.sum(axis=-1), "paper") @ rewards @ weights[:needed])
        return greedy_action(np.array(chosen))

    return choose


def _measure(part: Options) -> Result:
    loaded = load_checkpoint(CHECKPOINTS / f"{part['agent']}.safetensors")
    if "way" not in part:
        scores = evaluate(loaded.agent, loaded.environment, episodes=EPISODES, horizon=part["horizon"],
                          rule=part["rule"])  # fmt: skip
        return {"returns": np.round(scores.returns, 2).tolist()}
    return _decoded(loaded, part)


def _decoded(loaded: Loaded, part: Options) -> Result:
    agent, faults = loaded.agent, ways()[part["way"]]
    length = part["horizon"] or vector.spec(loaded.environment).time_limit
    assert isinstance(agent, HasGammaSpace)
    assert length is not None  # LunarLander has a time limit
    acting = float(agent.gammas[agent.acting_head])

    def returns(alpha: float, first: int, count: int) -> np.ndarray:
        choose = by_decoding(agent, acting, length, faults, alpha=alpha)
        return played(choose, loaded.environment, range(first, first + count), length).returns

    tuned = {f"{alpha:g}": round(float(returns(alpha, TUNING_SEED, TUNED).mean()), 2) for alpha in ALPHAS}
    best = max(tuned, key=lambda alpha: tuned[alpha])
    reported = returns(float(best), FIRST_SEED, EPISODES)
    return {"alpha": float(best), "tuned": tuned, "returns": np.round(reported, 2).tolist()}


def _parts() -> list[Options]:
    parts: list[Options] = []
    for horizon in HORIZONS:  # what takes longest comes last
        parts += [{"agent": f"{peer}_{ENVIRONMENT}", "rule": "greedy", "horizon": horizon} for peer in PEERS]
        parts += [{"agent": seed, "rule": rule, "horizon": horizon} for rule in RULES for seed in SEEDS]
        for other in ("CartPole-v1", "Acrobot-v1"):
            parts += [{"agent": f"laplace_{other}", "rule": rule, "horizon": horizon} for rule in RULES]
        parts += [{"agent": seed, "way": way, "horizon": horizon} for seed in SEEDS for way in ways()]
    return parts


def _summary(rows: Sequence[Row]) -> Result:
    """Mean returns of each row of the table with 95% intervals, and what each repair is worth."""
    table: dict[str, dict[str, np.ndarray]] = {}
    for row in rows:
        part = row["part"]
        name = _label(part)
        returns = table.setdefault(_column(part), {})
        own = np.array(row["result"]["returns"])[None]
        returns[name] = np.concatenate([returns[name], own]) if name in returns else own
    return {column: _of_column(returns) for column, returns in table.items()}


def _label(part: Mapping[str, Any]) -> str:
    agent = part["agent"].removeprefix("seeds/").split("_")[0]
    return f"{agent}, {part['rule']}" if "rule" in part else f"laplace, {part['way']}"


def _column(part: Mapping[str, Any]) -> str:
    environment = next(name for name in (ENVIRONMENT, "CartPole-v1", "Acrobot-v1") if name in part["agent"])
    return f"{environment}, T {part['horizon'] or 'full'}"


def _of_column(returns: Mapping[str, np.ndarray]) -> Result:
    """Args: returns: ``(agents, episodes)`` by the name of a row."""
    summed: Result = {
        name: {
            "mean": round(float(each.mean()), 2), "agents": len(each), "episodes": each.shape[1],
            "interval": np.round(_interval(each), 2).tolist(),
        }
        for name, each in returns.items()
    }  # fmt: skip
    paper = returns.get("laplace, as in the paper")
    before = "as in the paper"
    for i, fault in enumerate(FAULTS):
        after = f"{i + 1} mended" if i else f"without {fault}"
        steps: Mapping[str, tuple[str, str]] = {
            "alone": ("as in the paper", f"without {fault}"),
            "then": (before, after),
        }
        for how, (base, mended) in steps.items() if paper is not None else ():
            first, second = returns.get(f"laplace, {base}"), returns.get(f"laplace, {mended}")
            if first is None or second is None or first.shape != second.shape:
                continue
            worth = second - first
            summed[f"{fault} mended, {how}"] = {
                "mean": round(float(worth.mean()), 2), "agents": len(worth),
                "interval": np.round(interval(worth), 2).tolist(),
            }  # fmt: skip
        before = after
    for how in ("alone", "then"):
        each = [summed[f"{fault} mended, {how}"]["mean"] for fault in FAULTS if f"{fault} mended, {how}" in summed]
        if len(each) == len(FAULTS):  # what the two sums differ by is interaction
            summed[f"all mended, {how}"] = {"mean": round(sum(each), 2)}
    return summed


def _interval(returns: np.ndarray) -> list[float]:
    return interval(returns) if len(returns) > 1 else mean_interval(returns[0])


EXPERIMENT = Measurement(
    name="table1",
    title="Table 1: LunarLander with T = 50, 100, 200 and in full",
    question="What do the peers and Laplace DQN score under a deadline, and what does each fault of decoding cost?",
    parts=_parts(),
    measure=_measure,
    summary=_summary,
)
