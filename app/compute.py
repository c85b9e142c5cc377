"""Bounded caches between the pages and the library, and the bytes of a download."""

from __future__ import annotations

import io
from dataclasses import replace
from functools import lru_cache

import numpy as np

from app import figures
from laplace_core import InputError, Settings, Study, load_world, study
from laplace_core.artifacts import Artefact, find_artefacts
from laplace_core.control import episode_regret_of
from laplace_core.learning import greedy_policy
from laplace_core.saved import study_arrays
from laplace_core.verdict import Verdict, judge


@lru_cache(maxsize=32)
def study_for(settings: Settings) -> Study:
    return study(load_world(settings.world, dict(settings.params)), settings)


@lru_cache(maxsize=128)
def verdict_for(settings: Settings, row: int) -> Verdict:
    return judge(study_for(settings), row)


@lru_cache(maxsize=128)
def artefacts_for(settings: Settings, action: int) -> tuple[Artefact, ...]:
    return tuple(find_artefacts(study_for(settings), action))


def artefacts_elsewhere(settings: Settings, action: int) -> str:
    """One line that names artefacts which only other actions have."""
    here = {artefact.name for artefact in artefacts_for(settings, action)}
    lines: dict[str, list[str]] = {}
    for other, name in enumerate(study_for(settings).action_names):
        for artefact in artefacts_for(settings, other) if other != action else ():
            if artefact.name not in here:
                lines.setdefault(artefact.name, []).append(name)
    return " ".join(f"Also {name}, in {', '.join(actions)}." for name, actions in lines.items())


@lru_cache(maxsize=32)
def episode_regrets(settings: Settings) -> np.ndarray | None:
    """Loss of whole episodes under the decoded rule from the study's state, by T; None if too large to ask."""
    found = study_for(settings)
    try:
        return episode_regret_of(found.world, found.settings)[:, found.state]
    except InputError:
        return None


def npz_bytes(settings: Settings) -> bytes:
    buffer = io.BytesIO()
    np.savez_compressed(buffer, **study_arrays(study_for(settings)))
    return buffer.getvalue()


# What each picture does not depend on; it is drawn once for all values of these.
_DECODING = {"alpha": 1.0, "steps": 1, "time_step": 1.0, "normalise": "none", "softness": 0.0}
_ANY = {
    "world": {
        **_DECODING,
        "thetas": 2,
        "gammas": 2,
        "theta_min": 0.0,
        "theta_max": 1.0,
        "slope": 1.0,
        "policy": "shared",
    },
    "gamma-space": _DECODING,
    "tau-space": {"softness": 0.0},
    "rewards": {"softness": 0.0},
    "values": {},
}


def figure(name: str, settings: Settings, action: int, row: int, surface: bool) -> str:
    """One of the page's pictures as JSON."""
    if name != "values":
        row = 0
    return _figure(name, replace(settings, **_ANY[name]), action, row, surface)


@lru_cache(maxsize=64)
def _figure(name: str, settings: Settings, action: int, row: int, surface: bool) -> str:
    if name == "world":
        world = load_world(settings.world, dict(settings.params))
        policy = greedy_policy(world, settings.acting_gamma)
        return figures.to_json(figures.world_graph(world, world.state_index(settings.state), action, policy))
    found = study_for(settings)
    drawn = {
        "gamma-space": lambda: figures.gamma_space(found, action, surface),
        "tau-space": lambda: figures.tau_space(found, action, surface),
        "rewards": lambda: figures.rewards_and_survival(found, action),
        "values": lambda: figures.values_over_horizon(found, row),
    }[name]()
    return figures.to_json(drawn)
