"""What solving a world again costs, and what a change of slope costs instead."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from bench.report import Figure, Goal
from bench.timing import interleaved, spread
from laplace_core import GammaSpace, Settings, World, load_world, study
from laplace_core.code.gamma_space import encode
from laplace_core.planning import reward_indicator_basis, target_policies
from laplace_core.study.pipeline import basis_of, grids
from laplace_core.study.settings import resolve

WORLDS = {
    "gym:Taxi": ("gym:Taxi", {}),
    "cliff_grid 20x20": ("cliff_grid", {"width": 20, "height": 20}),
}
SUBJECT = "A change of slope"


def figures() -> Iterator[Figure]:
    for label, (source, params) in WORLDS.items():
        yield from _slope_change(label, load_world(source, params), Settings(world=source, gammas=100, thetas=250))


def full_solve(world: World, settings: Settings) -> GammaSpace:
    """Policy, reward-indicator basis and encoding of one state, without any cache."""
    gammas, thetas = grids(settings)
    policies = target_policies(world, gammas, settings.policy, settings.acting_gamma)
    basis = reward_indicator_basis(world, world.state_index(settings.state), gammas, policies)
    return encode(basis, world.reward_values, gammas, thetas, settings.slope)


def _slope_change(label: str, world: World, settings: Settings) -> Iterator[Figure]:
    settings = resolve(settings, world)
    ready = study(world, settings)
    basis, space = basis_of(ready), ready.gamma_space
    steeper = replace(settings, slope=2.0 * settings.slope)
    seconds = interleaved(
        {
            "solve": (lambda: full_solve(world, settings), 1),
            "encode": (lambda: encode(basis, world.reward_values, space.gammas, space.thetas, steeper.slope), 50),
            "first": (lambda: study(replace(world), settings), 1),  # a copy of the world is found in no cache
            "again": (lambda: study(world, steeper), 10),
        },
        rounds=15,
    )
    sizes = f"{label}, {world.n_states} states, {world.n_actions} actions, 100 discounts x 250 sensitivities"
    yield Figure(
        SUBJECT, f"{label}: full solve / slope change", spread(seconds["solve"] / seconds["encode"]), "x", sizes,
        Goal(">=", 50), "policy, basis and encoding without caches, against the encoding alone",
    )  # fmt: skip
    yield Figure(
        SUBJECT, f"{label}: first study / study after a slope change", spread(seconds["first"] / seconds["again"]),
        "x", f"{sizes}, {settings.steps} steps", note="both with the truth, decoding and reading",
    )  # fmt: skip
