"""Cases on which the lens is compared with the library: payloads, states of the controls, and expected numbers.

``tests/js`` makes the comparison: under node in ``tests/test_js.py``, and in a browser where one is asked for.
"""

from __future__ import annotations

import base64
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np

from laplace_core import Settings, load_world, study, study_of_gamma_space
from laplace_core.code.interpolation import with_added
from laplace_core.experiments.views import View, draw_view
from laplace_core.inverse import SOLVERS
from laplace_core.payloads.inverse import FOLLOWS
from laplace_core.payloads.lens import Simulated, payload, structure
from laplace_core.payloads.state import state_of
from laplace_core.study.settings import Resolved, resolve_for_gamma_space
from laplace_core.study.verdict import judge
from tests.support.lens_reference import seen, unpacked

FULL = {"gammas": 100, "thetas": 250, "steps": 200}
ROUNDING = 1e-13
"""Relative error of a gamma-space in doubles: where the library's own answer turns over it, there is none to match."""
_ROOT, _BARE = Path(__file__).resolve().parents[2], "http://lens.test/"
COMPARED = (
    "tau_space", "survival", "expected_reward", "horizon_values", "discount_kernel", "averaging_kernel", "differences",
    "distance", "reward_noise",
)  # fmt: skip


def payloads(*, small: bool = False) -> dict[str, tuple[bytes, Settings]]:
    """Spaces of every kind by a name: large, few rows, finer time steps, the paper's own grid, one without a world."""
    size = {"gammas": 40, "thetas": 60, "steps": 30} if small else FULL
    wanted = {
        "two_branch": ("two_branch", {}),
        "two_decisions": ("two_decisions", size),
        "discounting_chain": ("discounting_chain", size),
        "cliff_grid": ("cliff_grid", {"thetas": 60, "steps": 50, "theta_spacing": "asinh"}),
        "finer": ("two_decisions", {"time_step": 0.25, "thetas": 80}),
        "paper": ("discounting_chain", {"spacing": "paper", "thetas": 50, "steps": 40 if small else 120}),
    }
    found = {}
    for name, (world_name, values) in wanted.items():
        world = load_world(world_name)
        settings = study(world, Settings(world=world_name, **values)).settings
        found[name] = payload(study(world, structure(settings, world)))[0], settings
    space = study(load_world("two_branch"), Settings(thetas=40)).gamma_space
    for name, dt in (("own gamma-space", 1.0), ("own, finer", 0.5)):
        own = study_of_gamma_space(space, structure(Settings(world="own.npz", steps=20, time_step=dt), None))
        found[name] = payload(own, _simulated(len(space.thetas)))[0], own.settings
    return found


def solved(count: int) -> tuple[dict[str, tuple[bytes, Resolved]], list[dict[str, object]]]:
    """Spaces decoded by every solver, by weighted and filtered discounts, and states of them.

    A solver that the server runs has a payload for each of its states.

    Args:
        count: states a solver that the browser follows.
    """
    held, cases = {}, []
    ways = [(solver, "deviation", "none") for solver in SOLVERS if solver not in ("neural", "feasible")]
    ways += [("tikhonov2", "equal", "none"), ("tsvd", "equal", "savgol"), (FOLLOWS, "equal", "savgol")]
    for place, (solver, weighting, kind) in enumerate(ways):
        name = ("two_branch", "rise_and_fade", "cliff_grid")[place % 3]
        settings = Settings(
            world=name, thetas=20, gammas=12, steps=(None, 25, 20)[place % 3], solver=solver, weighting=weighting,
            filter=kind, time_step=0.5 if place == 5 else 1.0,
        )  # fmt: skip
        world = load_world(name)
        shown = study(world, settings).settings
        here = {f"{place} {solver}": (payload(study(world, structure(shown, world)))[0], shown)}
        held |= here
        cases += [_followed(case) for case in random_cases(here, count, place)]
    held |= _without_a_world()
    cases += [_followed(case) for name, each in _without_a_world().items() for case in random_cases({name: each}, 3, 5)]
    served = [
        {"solver": "feasible"},
        {"solver": "neural"},
        {"solver": "tsvd", "fold": True},
        {"solver": FOLLOWS, "fold": True},
    ]
    for place, values in enumerate(served):
        world = load_world("two_branch")
        shown = study(world, Settings(
            world="two_branch", thetas=14, noise=0.002, noise_seed=place, gammas=15, spacing="inverse-log", alpha=0.05,
            horizon=2, steps=6,
            weighting="equal" if values["solver"] == "neural" else "deviation", normalise="survival", **values,
        ))  # fmt: skip
        data = payload(study(world, structure(shown.settings, world)), shown=shown)[0]
        name = f"served {place} {values['solver']}"
        held[name] = data, shown.settings
        state = state_of(shown.settings, 2.0, action=place % 2)
        cases.append({"payload": name, "state": state, "tau": 1})
        if "fold" not in values:  # what is read otherwise needs no answer
            read = {"softness": 0.3, "normalise": "paper", "horizon": 3.0, "value_gamma": 0.8}
            cases.append({"payload": name, "state": state | read, "tau": 2})
    return held, cases


def _without_a_world() -> dict[str, tuple[bytes, Resolved]]:
    """A gamma-space from a file, whose last tail is not 0, and one with open ends, by the non-negative solver."""
    space = study(load_world("two_branch"), Settings(thetas=12, theta_max=9.0, gammas=12)).gamma_space
    found = {}
    for name, each in (("own", space), ("network", replace(space, open_ends=True))):
        settings = Settings(world="own.npz", steps=10, solver=FOLLOWS, weighting="deviation")
        own = study_of_gamma_space(each, structure(resolve_for_gamma_space(settings, each.gammas), None))
        found[f"{name} {FOLLOWS}"] = payload(own)[0], own.settings
    return found


def _followed(case: dict[str, object]) -> dict[str, object]:
    """A case without what only the server can answer, at an alpha that the dual of the non-negative solver can take."""
    state: Any = case["state"]
    return {**case, "state": state | {"fold": False, "alpha": float(max(state["alpha"], 1e-3))}}


def _simulated(count: int) -> Simulated:
    """Tails of 12 steps that continuations after action 1 may have come to."""
    rng = np.random.default_rng(0)
    lines = {name: np.zeros(12) for name in ("reward", "reward_error", "survival", "survival_error", "chance")}
    ends = -np.sort(-rng.random((12, count + 2)), axis=1)
    ends[:, -1] = 0.0
    return Simulated(1, SimpleNamespace(count=50, tails=ends[:, 1:-1], open_tails=ends, **lines))


def network() -> dict[str, tuple[bytes, Settings]]:
    """A space as of a network: sensitivities spaced in asinh, discounts added between, a slope that may be softened."""
    settings = Settings(thetas=40, theta_min=-4.0, theta_max=14.0, theta_spacing="asinh", slope=4.0)
    space = with_added(replace(study(load_world("two_branch"), settings).gamma_space, open_ends=True), 1)
    added = study_of_gamma_space(space, structure(Settings(world="network", steps=20), None))
    places = 2.5 / np.diff(np.arcsinh(space.thetas)).max() * np.arcsinh(space.thetas)
    simulated = _simulated(len(space.thetas))
    return {"network": (payload(added, simulated, places=places, added=1)[0], added.settings)}


def random_cases(held: dict[str, tuple[bytes, Settings]], count: int, seed: int) -> list[dict[str, object]]:
    """States over the whole range of every control, all switches thrown by chance."""
    rng, cases = np.random.default_rng(seed), []
    for i in range(count):
        name = list(held)[i % len(held)]
        settings = held[name][1]
        last = settings.steps * settings.time_step
        T = float(rng.integers(1, last + 1)) if settings.time_step == 1 else float(rng.uniform(1, last))
        chance = rng.random(7) < 0.35
        state = state_of(settings, T, action=int(rng.integers(len(unpacked(held[name][0])[0]["actions"]))))
        state |= {
            "alpha": float(10 ** rng.uniform(-6, 0)),
            "slope": float(state["slope"] * 10 ** rng.uniform(-1, 1)),
            "softness": float(rng.choice([0, 0, 0.2, 0.7])),
            "value_gamma": float(rng.uniform(0.5, 0.995)),
            "noise": float(rng.choice([0, 0, 1e-5, 1e-2])),
            "noise_seed": int(rng.integers(0, 2**31)),
            "normalise": str(rng.choice(["none", "survival", "paper"])),
            **dict(zip(("fold", "mixed", "paper_grid", "clip", "constant", "shift"), map(bool, chance), strict=False)),
            "used": float(rng.integers(0, int(T) + 1)) if chance[6] else 0.0,
        }
        if "places" in unpacked(held[name][0])[1]:
            state["slope_share"] = float(rng.choice([1.0, 0.7, 0.2]))
        cases.append({"payload": name, "state": state, "tau": int(rng.integers(settings.steps))})
    return cases


def fixture(held: Mapping[str, tuple[bytes, Settings]], cases: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
    """What ``tests/js/agreement.js`` compares, as JSON: the payloads, and every case with what the library shows."""
    return {
        "payloads": {name: base64.b64encode(data).decode() for name, (data, _) in held.items()},
        "cases": [{**case, "expected": _expected(*held[case["payload"]], case)} for case in cases],
    }


def compared_in(browser: Any, given: Mapping[str, Any]) -> dict[str, Any]:
    """The answer of ``tests/js/agreement.js`` on a fixture, in a page of a browser that has nothing else on it."""
    page = browser.new_page()
    page.route(f"{_BARE}**", _from_the_tree)
    page.goto(_BARE)
    script = f"(given) => import('{_BARE}tests/js/agreement.js').then(({{ compared }}) => compared(given))"
    result = page.evaluate(script, given)
    page.close()
    return result


def _from_the_tree(route: Any) -> None:
    """Answer from the sources, as a server would."""
    path = _ROOT / route.request.url.removeprefix(_BARE)
    if path.is_file():
        route.fulfill(path=path)
    else:
        route.fulfill(body="<!doctype html>", content_type="text/html")


def packed(array: np.ndarray) -> str:
    """Doubles as base64, so that no digit and no NaN is lost."""
    return base64.b64encode(np.asarray(array, dtype="<f8").tobytes()).decode()


def _expected(data: bytes, settings: Settings, case: Mapping[str, Any]) -> dict[str, Any]:
    """The library's arrays under a state, each with its range and with the entries that stand for something.

    A row rescaled although it holds nothing but rounding is rounding itself, in the browser as in the library: an
    entry holds where the library's own answer survives a rounding of gamma-space. ``chosen`` is None where the best
    two actions are too close to tell.
    """
    state = case["state"]
    solved = settings if isinstance(settings, Resolved) else None
    true, *moved = (seen(data, state, case["tau"], shake, solved=solved) for shake in (0.0, ROUNDING, -ROUNDING))
    arrays = {}
    for name in COMPARED:
        if name not in true:
            continue
        action = state["action"] if name in ("tau_space", "differences") else slice(None)
        shown = true[name][action]
        width = max(float(np.ptp(shown[np.isfinite(shown)])), 1e-300)
        holds = np.all([np.abs(each[name][action] - shown) <= 1e-6 * width for each in moved], axis=0)
        arrays[name] = {"values": packed(shown), "holds": packed(holds), "width": width}
    values, row = true["horizon_values"], int(true["read_row"])
    first, second = np.sort(values[:, row])[::-1][:2] if len(values) > 1 else (1.0, 0.0)
    span = np.ptp(values[np.isfinite(values)])
    stays = max(np.abs(each["horizon_values"] - values)[:, row].max() for each in moved) <= 1e-6 * span
    clear = bool(stays and first - second > 1e-4 * span)
    return {
        "arrays": arrays,
        "read_row": row,
        "chosen": int(true["chosen"]) if clear else None,
        "regret": float(true["regret"]) if clear and "regret" in true else None,
    }


def verdicts(count: int, first: int = 0) -> list[dict[str, Any]]:
    """Random views, rescaled rows included, and the library's verdict on each."""
    views = [draw_view(np.random.default_rng([77, number])) for number in range(first, first + count)]
    return [_judged(view) for view in views]


def _judged(view: View) -> dict[str, Any]:
    shown = study(view.world, view.settings)
    verdict = judge(shown, view.row, view.action, explain=False)
    data = payload(study(view.world, structure(shown.settings, view.world)))[0]
    action = verdict.chosen if view.action is None else view.action
    values = shown.at(view.row).horizon_values[:, shown.reading(view.row)[0]]
    # Where nothing is ever paid, the sensitivities are the measure.
    span = shown.settings.theta_max - shown.settings.theta_min
    tone = {"wrong": "bad", "lucky": "warn"}.get(verdict.choice)
    return {
        "payload": base64.b64encode(data).decode(),
        "state": state_of(shown.settings, float(shown.horizons[view.row]), action=action),
        "tone": tone or ("ok" if verdict.timeline == "sound" else verdict.timeline),
        "chosen": int(verdict.chosen),
        "values": values.tolist(),
        "error": float(verdict.error),
        "timeline": float(verdict.timeline_error),
        "allowed": float(1e-6 * max(np.abs(values).max(), np.abs(shown.world.reward_values).max() or span)),
    }
