"""The shared part of the verbs that decode: a state of a world or of a file, and the settings of its study."""

from __future__ import annotations

import argparse

from laplace_core.cli.learn import study_of_file
from laplace_core.cli.options import add_parameters, checked_number, named_params
from laplace_core.errors import InputError
from laplace_core.inverse import SELECTORS
from laplace_core.study.npz import read_gamma_space
from laplace_core.study.pipeline import Study, study, study_of_gamma_space
from laplace_core.study.settings import SCHEMA, Settings, check_paper_grid, parse_settings
from laplace_core.worlds import load_world

_BY_NAME = ("auto", *SELECTORS)
"""What ``--alpha`` takes in place of a number."""


def add_subject(parser: argparse.ArgumentParser) -> None:
    """The world or file, and one option a setting."""
    parser.add_argument(
        "world",
        metavar="WORLD",
        help="a preset, a world file (.json), gym:NAME, a gamma-space (.npz) or a learned agent (.safetensors)",
    )
    parser.add_argument("--param", action="append", default=[], metavar="name=value", help="a parameter of the world")
    add_parameters(parser, SCHEMA)
    parser.add_argument("--seed-index", metavar="N", help="which learner of a learned agent, from 0")
    parser.epilog = f"--alpha takes a number, or the selector that chooses it: {', '.join(_BY_NAME)}."


def study_of_options(options: argparse.Namespace) -> Study:
    """The study that the options ask for.

    Raises:
        InputError: options that do not fit each other, the world or the file.
    """
    params = named_params(options.param)
    if options.seed_index is not None:
        params["seed_index"] = options.seed_index
    given = {parameter.name: getattr(options, parameter.name) for parameter in SCHEMA}
    if given["alpha"] in _BY_NAME:
        if given["selector"] not in (None, given["alpha"]):
            raise InputError(f"--alpha {given['alpha']} and --selector {given['selector']} differ: give one of them.")
        given |= {"alpha": None, "selector": given["alpha"]}
    settings = parse_settings(options.world, params, given)
    check_paper_grid(given)
    _check_used(settings)
    ending = options.world.lower().rpartition(".")[2]
    if ending == "safetensors":
        result = study_of_file(options.world, settings)
    elif ending == "npz":
        if settings.deadline == "constant" and not settings.used:
            raise InputError("--deadline changes nothing for a saved gamma-space: no episode is acted without a world.")
        result = study_of_gamma_space(read_gamma_space(options.world, settings.state), settings)
    else:
        result = study(load_world(options.world, params), settings)
    if options.horizon is not None:  # at a time_step of 1 there is no T between two whole ones
        kind, least = (int, 1) if result.settings.time_step == 1.0 else (float, float(result.horizons[0]))
        checked_number("horizon", options.horizon, kind, least, high=float(result.horizons[-1]))
    return result


def _check_used(settings: Settings) -> None:
    """Refuse an option that changes nothing beside the others."""
    s, ruled = settings, settings.selector not in (None, "typed")
    if s.noise is None and s.noise_seed is not None:
        raise InputError("--noise-seed changes nothing without --noise: give both, or neither.")
    if s.theta_scale and s.theta_spacing in (None, "uniform"):
        raise InputError("--theta-scale changes nothing beside --theta-spacing uniform: leave it out.")
    if ruled and s.alpha is not None:
        raise InputError(f"--alpha {s.alpha:g} changes nothing beside --selector {s.selector}: leave one of them out.")
    if s.noise_level is not None and s.weighting == "equal" and not ruled:
        raise InputError("--noise-level changes nothing beside --weighting equal and a typed alpha: leave it out.")
    if s.noise_levels is not None and s.weighting == "equal" and not ruled:
        raise InputError("--noise-levels changes nothing beside --weighting equal and a typed alpha: leave it out.")
    if s.filter in (None, "none") and (s.filter_window, s.filter_order) != (None, None):
        raise InputError("--filter-window and --filter-order change nothing without --filter savgol: leave them out.")
