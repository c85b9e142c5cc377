"""Tabular agents that learn the Laplace code: learning, tables, reading, saving and watching them."""

from laplace_core.tabular.files import learned_bytes, parse_learned, read_learned, save_learned
from laplace_core.tabular.learner import Learning, seconds_to_learn
from laplace_core.tabular.model import CURVE_NAMES, Learned, PeerTables
from laplace_core.tabular.process import Run, start
from laplace_core.tabular.reading import (
    CODES,
    QUANTILE_LEVELS,
    Band,
    Bands,
    Returns,
    bands,
    noise_over_seeds,
    noise_settings,
    return_distributions,
    reward_gain_over_seeds,
    study_of,
)
from laplace_core.tabular.returns import independent_steps_return, return_bounds, wasserstein
from laplace_core.tabular.settings import LEARN_SCHEMA, LearnSettings, parse_learn_settings, resolve_learning

__all__ = [
    "CODES",
    "CURVE_NAMES",
    "LEARN_SCHEMA",
    "QUANTILE_LEVELS",
    "Band",
    "Bands",
    "LearnSettings",
    "Learned",
    "Learning",
    "PeerTables",
    "Returns",
    "Run",
    "bands",
    "independent_steps_return",
    "learned_bytes",
    "noise_over_seeds",
    "noise_settings",
    "parse_learn_settings",
    "parse_learned",
    "read_learned",
    "resolve_learning",
    "return_bounds",
    "return_distributions",
    "reward_gain_over_seeds",
    "save_learned",
    "seconds_to_learn",
    "start",
    "study_of",
    "wasserstein",
]
