"""Bounded caches between the pages and the library, and the bytes of a download."""

from __future__ import annotations

import io
from dataclasses import replace
from functools import lru_cache

import numpy as np
import plotly.graph_objects as go

from app import figures
from laplace_core import InputError, Settings, Study, World, load_world, study
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


@lru_cache(maxsize=32)
def world_graph(world: World, state: int, action: int, acting_gamma: float) -> go.Figure:
    return figures.world_graph(world, state, action, greedy_policy(world, acting_gamma))


def gamma_figure(settings: Settings, action: int, surface: bool) -> go.Figure:
    """The picture of gamma-space, drawn once for all settings that only concern decoding."""
    return _gamma_figure(replace(settings, **_ANY_DECODING), action, surface)


_ANY_DECODING = {"alpha": 1.0, "steps": 1, "time_step": 1.0, "normalise": "none", "softness": 0.0}


@lru_cache(maxsize=32)
def _gamma_figure(settings: Settings, action: int, surface: bool) -> go.Figure:
    return figures.gamma_space(study_for(settings), action, surface)
