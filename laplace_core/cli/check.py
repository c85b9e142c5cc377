"""The command line's ``check`` verb: can any feasible timeline have these values?"""

from __future__ import annotations

import argparse
import json

import numpy as np

from laplace_core.cli.learn import study_of_file
from laplace_core.cli.options import add_parameters, checked_number, named_params
from laplace_core.errors import InputError
from laplace_core.inverse.consistency import LEVEL, Consistency, check_noise, check_seeds
from laplace_core.study.npz import read_gamma_space
from laplace_core.study.pipeline import study, study_of_gamma_space
from laplace_core.study.settings import BY_NAME, ENCODING_NAMES, Settings, check_paper_grid, parse_settings
from laplace_core.tabular.files import read_learned
from laplace_core.worlds import load_world

ASSUMED_NOISE = 1e-3
FEWEST_SEEDS = 3
CHECKED = ("state", *ENCODING_NAMES, "acting_gamma", "noise", "noise_seed")
"""Settings that decide the values of a gamma-space; how they are decoded changes nothing."""


def add_check(verbs: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add ``check`` to the verbs."""
    check = verbs.add_parser(
        "check",
        help="test whether any feasible timeline has these values",
        description="A test of gamma-space before any inverse: whether probabilities that are never negative, of an "
        "episode that does not come back once it is over, can have these values, given their noise. The noise is that "
        "of several seeds where the file holds them.",
    )
    check.add_argument("world", metavar="FILE_OR_WORLD", help="what decode takes")
    check.add_argument("--param", action="append", default=[], metavar="name=value", help="a parameter of the world")
    add_parameters(check, [BY_NAME[name] for name in CHECKED])
    check.add_argument(
        "--noise-level",
        metavar="s",
        help="standard deviation of (1 - gamma) Q that is tested against (default: what the seeds of a learned file "
        f"show, else --noise, else {ASSUMED_NOISE:g})",
    )
    check.add_argument("--seed-index", metavar="N", help="test this one learner of a learned agent, from 0")
    check.add_argument("--json", action="store_true", help="print JSON")
    check.set_defaults(run=_check)


def _check(options: argparse.Namespace) -> None:
    given = {name: getattr(options, name) for name in CHECKED}
    check_paper_grid(given)
    level = options.noise_level
    level = None if level is None else checked_number("noise-level", level, float, 1e-9, high=1.0)
    settings = parse_settings(options.world, named_params(options.param), given)
    result, source, action_names = _tested(options, settings, level)
    if options.json:
        print(json.dumps(_payload(options.world, result, source)))
    else:
        print(_report(options.world, result, source, action_names))


def _tested(
    options: argparse.Namespace, settings: Settings, level: float | None
) -> tuple[Consistency, str, tuple[str, ...]]:
    """The test, where its noise comes from, and the names of the actions."""
    ending = options.world.lower().rpartition(".")[2]
    if ending != "safetensors" and options.seed_index is not None:
        raise InputError("--seed-index chooses a learner of a learned agent (.safetensors): leave it out.")
    if ending == "safetensors":
        seeds = range(read_learned(options.world).settings.seeds)
        if options.seed_index is None and level is None and len(seeds) >= FEWEST_SEEDS:
            found = [study_of_file(options.world, _of_seed(settings, str(index))) for index in seeds]
            spaces = [each.gamma_space for each in found]
            result = check_seeds(
                np.array([space.values for space in spaces]), np.array([space.constant for space in spaces]), spaces[0]
            )
            return result, f"from {len(seeds)} seeds", found[0].action_names
        one = study_of_file(options.world, _of_seed(settings, options.seed_index or "0"))
    elif ending == "npz":
        one = study_of_gamma_space(read_gamma_space(options.world, settings.state), settings)
    else:
        one = study(load_world(options.world, dict(settings.params)), settings)
    source = "given" if level is not None else "of --noise" if settings.noise else "assumed"
    level = level or settings.noise or ASSUMED_NOISE
    result = check_noise(one.gamma_space, level / (1.0 - one.gamma_space.gammas))
    return result, f"{level:g}, {source}", one.action_names


def _of_seed(settings: Settings, index: str) -> Settings:
    given = {name: getattr(settings, name) for name in CHECKED}
    return parse_settings(settings.world, dict(settings.params) | {"seed_index": index}, given)


def _payload(world: str, result: Consistency, source: str) -> dict[str, object]:
    return {
        "world": world, "p_value": result.p_value, "consistent": result.consistent, "level": LEVEL,
        "misfit": result.misfit, "usual_misfit": result.usual, "draws": result.draws, "noise": source,
        "blamed": result.blamed().tolist(), "gammas": result.gammas.tolist(), "relief": result.relief.tolist(),
        "misfit_by_action": (result.residuals**2).sum(axis=(1, 2)).tolist(),
    }  # fmt: skip


def _report(world: str, result: Consistency, source: str, action_names: tuple[str, ...]) -> str:
    found = "Some feasible timeline fits" if result.consistent else "No feasible timeline fits"
    lines = [
        f"{world}: {found} these values within their noise ({source}).",
        f"p-value       {result.p_value:.3g} ({result.draws} draws)",
        f"misfit        {result.misfit:.4g}, usual {result.usual:.4g}",
    ]
    if result.consistent:
        return "\n".join(lines)
    each = (result.residuals**2).sum(axis=(1, 2))
    width = max(map(len, action_names))
    lines += [f"  {name:{width}}  {misfit:.4g}" for name, misfit in zip(action_names, each, strict=True)]
    blamed = result.blamed()
    if blamed.size:
        lines.append(f"to blame      gamma {', '.join(f'{gamma:.4g}' for gamma in blamed[:5])}")
    else:
        lines.append("to blame      no single discount: the values disagree as a whole, as those of mixed policies do")
    return "\n".join(lines)
