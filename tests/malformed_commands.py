"""Command lines that must be refused, generated from the library's own tables of options and parameters.

``CASES`` holds (id, words after ``laplace``, words that the refusal must contain).
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from laplace_core.parameters import Parameter
from laplace_core.settings import SCHEMA, flag
from laplace_core.worlds import PRESETS, TOY_TEXT

NOT_NUMBERS = ("", " ", "x", "nan", "-nan", "inf", "-inf", "1e999", "-1e999", "1,5", "0x10", "1/2", "1e", "None", "5%")
NOT_BOOLS = ("", "yes", "2", "-1", "None", "truefalse", "1.0")
NOT_WORLDS = (
    *(
        "",
        " ",
        "nowhere",
        "two_branch ",
        "Two_Branch",
        "two_branch,fig6_chain",
        "worlds",
        ".",
        "..",
        "*",
        "--json",
        "-",
    ),
    *("/dev/null", "/etc/passwd", "world.JSON", "world.json.bak", "world.pkl", "world.npy", "http://127.0.0.1/world"),
    *("gym", "gym.Taxi-v4", "GYM:Taxi-v4", "__init__", "os.system", "two_branch\x00", "two\nlines", "x" * 10_000),
)
NOT_LISTED = (
    *("", " ", "CartPole-v1", "Blackjack-v1", "FrozenLake-v0", "FrozenLake-v2", "FrozenLake-v", "Taxi-v3", "taxi-v4"),
    *(
        "Taxi-v4 ",
        "os:Taxi-v4",
        "laplace_core:FrozenLake-v1",
        "ALE/Pong-v5",
        "../Taxi-v4",
        "Taxi-v4.json",
        "x" * 10_000,
    ),
)
NOT_FILES = (
    "missing.json",
    "missing.npz",
    "/dev/null/world.json",
    "/dev/null/own.npz",
    ".json",
    ".npz",
    "~/missing.json",
)
NOT_STATES = ("nowhere", "", " ", "-1", "3", "99999", "1.5", "1e0", "nan", "START", "9" * 200, "long 1,long 2", "[0]")
NOT_PARAMS = (
    *("length", "", "=", "=3", " =3", "length 3", "length:3", "Length=3", "no_such=1", "__class__=1", "length =3"),
    *("--length=3", "states=5", "x" * 10_000 + "=1", "length=3,r1=5", "two\nlines=1", "gammas=3"),
)


def _outside(parameter: Parameter) -> Iterator[str]:
    """Texts that a parameter cannot mean."""
    if parameter.choices:
        yield from ("", "x", "0", parameter.choices[0].upper(), f"{parameter.choices[0]}x", "none,all")
    elif parameter.type is bool:
        yield from NOT_BOOLS
    elif parameter.type is int:
        yield from (*NOT_NUMBERS, "2.5", str(int(parameter.low) - 1), str(int(parameter.high) + 1), "9" * 400)
    elif parameter.type is float:
        below, above = np.nextafter(parameter.low, -np.inf), np.nextafter(parameter.high, np.inf)
        yield from (*NOT_NUMBERS, repr(float(below)), repr(float(above)))


def _options() -> Iterator[tuple[list[str], tuple[str, ...]]]:
    for parameter in SCHEMA:
        for text in _outside(parameter):
            yield ["decode", "two_branch", flag(parameter), text], (parameter.name, "must be")
        yield ["decode", "two_branch", flag(parameter)], (flag(parameter), "expected one argument")
    for text in NOT_STATES:
        yield ["decode", "two_branch", "--state", text], ("state", text[:10])


def _parameters() -> Iterator[tuple[list[str], tuple[str, ...]]]:
    tables = {name: preset.parameters for name, preset in PRESETS.items()}
    tables |= {f"gym:{name}": parameters for name, parameters in TOY_TEXT.items()}
    for world, parameters in tables.items():
        for parameter in parameters:
            for text in list(_outside(parameter))[::2]:
                yield ["decode", world, "--param", f"{parameter.name}={text}"], (parameter.name, "must be")
        yield ["decode", world, "--param", "no_such=1"], (world, "'no_such'", *(p.name for p in parameters))
    for text in NOT_PARAMS:
        yield ["decode", "two_branch", "--param", text], ()
    yield ["decode", "two_branch", "--param", "r1=1", "--param", "r1=1"], ("r1", "twice")
    yield ["decode", "cliff_grid", "--param", "width=200", "--param", "height=200"], ("200 x 200", "5,000", "smaller")


def _worlds() -> Iterator[tuple[list[str], tuple[str, ...]]]:
    for text in NOT_WORLDS:
        yield ["decode", text], ()
    for text in NOT_LISTED:
        yield ["decode", f"gym:{text}"], ("gym:", *TOY_TEXT)
    for text in NOT_FILES:
        yield ["decode", text], ("cannot be read",)
    yield ["decode", "missing.json", "--param", "r1=1"], ("missing.json", "no parameters")


def _combinations() -> Iterator[tuple[list[str], tuple[str, ...]]]:
    for low, high in ((".9", ".1"), (".5", ".5"), (".999", ".99"), (".01", "1e-3")):
        for spacing in ("inverse-log", "log", "linear"):
            words = ["--gamma-min", low, "--gamma-max", high, "--spacing", spacing]
            yield ["decode", "two_branch", *words], ("gamma-min", "gamma-max")
    for low, high in (("1", "0"), ("0", "0"), ("-1", "-2"), ("1e9", "-1e9"), ("-1e-300", "-1e-299")):
        for spacing in ("uniform", "gaussian", "asinh"):
            words = ["--theta-min", low, "--theta-max", high, "--theta-spacing", spacing]
            yield ["decode", "two_branch", *words], ("theta-min", "theta-max")
    yield ["decode", "two_branch", "--gamma-min", ".995"], ("gamma-min", "gamma-max")
    yield ["decode", "two_branch", "--theta-max", "-100"], ("theta-min", "theta-max")


def _words() -> Iterator[tuple[list[str], tuple[str, ...]]]:
    yield [], ()
    for verb in ("", "decodes", "Decode", "two_branch", "world", "worlds,decode", "-1", "--decode", "help", "x" * 300):
        yield [verb], ()
    yield ["decode"], ("WORLD",)
    for extra in (["x"], ["--json=1"], ["--out=x.npz"], ["--gammas=3"], ["-x"], ["decode"]):
        yield ["worlds", *extra], ()
    for extra in (
        "fig6_chain",
        "x",
        "-x",
        "--no-such",
        "--no-such=1",
        "--json=1",
        "--GAMMAS=3",
        "--gamma_min=.1",
        "-g=3",
    ):
        yield ["decode", "two_branch", extra], ()
    for ambiguous in ("--gamma", "--theta", "--s", "--p"):
        yield ["decode", "two_branch", ambiguous, "1"], ("ambiguous",)


def _all_cases() -> Iterator[tuple[str, list[str], tuple[str, ...]]]:
    for catalogue in (_options, _parameters, _worlds, _combinations, _words):
        for number, (words, named) in enumerate(catalogue()):
            yield f"{catalogue.__name__} {number}: {' '.join(words)!r:.60}", words, named


CASES = list(_all_cases())
