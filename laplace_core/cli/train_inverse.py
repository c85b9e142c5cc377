"""The command line's ``train-inverse`` verb: a neural inverse for a grid of discounts."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING

from laplace_core.cli.options import checked_number
from laplace_core.code.encoding import GAMMA_SPACINGS, discount_grid
from laplace_core.errors import InputError

if TYPE_CHECKING:
    from laplace_core.training.neural_inverse import Progress


def add_train_inverse(verbs: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add ``train-inverse`` to the verbs."""
    train = verbs.add_parser(
        "train-inverse",
        help="train a neural inverse for a grid of discounts",
        description="A network from gamma-space to timelines that can be, learned from random timelines with noise. "
        "It takes minutes on one core; the same seed gives the same network.",
    )
    train.add_argument("--gammas", default="15", metavar="N", help="number of discounts (default: 15)")
    train.add_argument(
        "--spacing", default="inverse-log", metavar="NAME", help=f"one of {', '.join(GAMMA_SPACINGS)} (inverse-log)"
    )
    train.add_argument("--gamma-min", default="0.01", metavar="G", help="smallest discount (default: 0.01)")
    train.add_argument("--gamma-max", default="0.99", metavar="G", help="largest discount (default: 0.99)")
    train.add_argument("--steps", default="200", metavar="K", help="rows of the timeline (default: 200)")
    train.add_argument("--updates", default="5000", metavar="N", help="updates of the network (default: 5000)")
    train.add_argument("--samples", default="16000", metavar="N", help="timelines to learn from (default: 16000)")
    train.add_argument("--seed", default="0", metavar="N", help="seed of timelines, noise and weights (default: 0)")
    train.add_argument("--out", required=True, metavar="FILE.safetensors", help="where the network goes")
    train.set_defaults(run=_train_inverse)


def _train_inverse(options: argparse.Namespace) -> None:
    if not options.out.lower().endswith(".safetensors"):
        raise InputError(f"--out {options.out[:60]!r} must end in .safetensors.")
    low, high = (
        checked_number(name, getattr(options, name.replace("-", "_")), float, 1e-6, high=0.999999)
        for name in ("gamma-min", "gamma-max")
    )
    count = checked_number("gammas", options.gammas, int, 2, high=100)
    gammas = discount_grid(count, options.spacing, low, high)
    numbers = {
        "seed": checked_number("seed", options.seed, int, 0, high=2**31 - 1),
        "updates": checked_number("updates", options.updates, int, 1, high=1_000_000),
        "samples": checked_number("samples", options.samples, int, 100, high=100_000),
    }
    steps = checked_number("steps", options.steps, int, 2, high=500)
    import torch

    from laplace_core.inverse.neural import save_network
    from laplace_core.training.neural_inverse import train

    torch.set_num_threads(1)

    def report(progress: Progress) -> None:
        if progress.update % 500 == 0 or progress.update == numbers["updates"]:
            print(f"update {progress.update:6}  loss {progress.loss:.3f}", flush=True)

    save_network(train(gammas, steps, report=report, **numbers), options.out)
    print(f"{len(gammas)} discounts from {gammas[0]:g} to {gammas[-1]:g}, {steps} rows: {options.out}")
