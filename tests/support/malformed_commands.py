"""Command lines that must be refused, generated from the library's own tables of options and parameters.

``CASES`` holds (id, words after ``laplace``, words that the refusal must contain).
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from laplace_core.agents.settings import SETTINGS
from laplace_core.parameters import Parameter
from laplace_core.study.settings import SCHEMA, flag
from laplace_core.worlds import PRESETS, TOY_TEXT
from tests.support.malformed_tables import NEAR_NUMBERS

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
        low, high = parameter.bounds
        yield from (*NOT_NUMBERS, "2.5", str(int(low) - 1), str(int(high) + 1), "9" * 400)
    elif parameter.type is float:
        below, above = np.nextafter(parameter.bounds, (-np.inf, np.inf))
        yield from (*NOT_NUMBERS, repr(float(below)), repr(float(above)))


def _options() -> Iterator[tuple[list[str], tuple[str, ...]]]:
    for parameter in SCHEMA:
        for text in _outside(parameter):
            yield ["decode", "two_branch", flag(parameter), text], (parameter.name, "must be")
        if parameter.type is not bool:  # a switch may stand alone: it is on
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


_TYPED = ("5,0", "50%", "1/2", "1 000", "\u22125", "5k", "1e", "five", "0x5", "5;", "~5", "[5]", "5..6", "=5", "none.")
"""Texts that no option of a number takes."""
_SPELLED = {
    "spacing": ("inverse_log", "inverselog", "Log", "logarithmic", "geometric", "exp", "exponential", "lin", "uniform"),
    "theta_spacing": ("Uniform", "linear", "even", "arcsinh", "gauss", "normal"),
    "normalise": ("off", "false", "no", "None", "sum", "softmax", "clip", "PAPER", "alive", "rows"),
    "policy": ("per-gamma", "pergamma", "Shared", "greedy", "own", "each", "on", "single"),
    "deadline": ("time-to-go", "timetogo", "Constant", "hard", "soft", "fixed", "T"),
    "solver": ("Tikhonov", "ridge", "svd", "lstsq", "pinv", "l2"),
}
_WORLD_WORDS = (
    *(
        "two-branch",
        "TwoBranch",
        "two branch",
        "twobranch",
        "two_branch.json",
        "two_branch:",
        "branch",
        "preset:two_branch",
    ),
    *(
        "gym/Taxi-v4",
        "gymnasium:Taxi-v4",
        "Taxi-v4",
        "gym:taxi",
        "gym:Taxi-v5",
        "gym: Taxi-v4",
        "gym:FrozenLake-v1-4x4",
    ),
    *("FrozenLake", "world", "my_world", "my_world.yaml", "my_world.csv", "my_world.npy", "my_world.pt", "file:w.json"),
)


def near_decode() -> Iterator[tuple[list[str], str | list[str]]]:
    """Words after ``laplace`` in other conventions, and a word of the refusal or the words that mean the same."""
    for parameter in SCHEMA:
        if parameter.type in (int, float):
            for text in _TYPED:
                yield ["decode", "two_branch", f"{flag(parameter)}={text}"], parameter.name
        for text in _SPELLED.get(parameter.name, ()):
            yield ["decode", "two_branch", flag(parameter), text], parameter.name
    for text in _WORLD_WORDS:
        yield ["decode", text], ""
    for text in ("Start", "start.", "s0", "START", "long_1", "long1", "0.0", "first", "#0", "state 0"):
        yield ["decode", "two_branch", "--state", text], "state"
    for text in ("length:4", "length 4", "length==4", "--length=4", "Length=4", "len=4", "length=4.5", "length=four",
                 "r1=5,0", "auxiliary=yes", "auxiliary=on", "slip=20%", "slip=20"):  # fmt: skip
        yield ["decode", "two_branch", "--param", text], ""
    for word in ("--Alpha", "--alpha_", "--gamma_min", "--theta_max", "-a", "--regularisation", "--T",
                 "--K", "--normalize", "--seed", "--gammas-min", "--n-gammas", "--tau"):  # fmt: skip
        yield ["decode", "two_branch", word, ".2"], ""
    for same in (["--alpha=.2"], ["--alpha", "2e-1"], ["--alpha", "+.2"], ["--alpha", " .2 "], ["--alp", ".2"]):
        yield ["decode", "two_branch", *same], ["decode", "two_branch", "--alpha", ".2"]
    for same in (["--gammas", "15.0"], ["--gammas", "1.5e1"], ["--gammas", "015"], ["--normalise", " none"]):
        yield ["decode", "two_branch", *same], ["decode", "two_branch"]


def near_search() -> Iterator[tuple[list[str], str | list[str]]]:
    """The same for ``search``; all with --budget, so that nothing is ever trained."""
    base = ["search", "dqn", "two_branch", "--budget"]
    numeric = [p.name for p in SETTINGS["dqn"].SCHEMA if p.type in (int, float) and p.name != "seed"]
    for name in numeric:
        for text in _TYPED[:10]:
            yield [*base, "--vary", f"{name}={text}"], ""
    for name in (
        "learning-rate",
        "lr",
        "learningRate",
        "LEARNING_RATE",
        "learning rate",
        "rate",
        "eta",
        " learning_rate",
    ):
        yield [*base, "--vary", f"{name}=1e-3"], "setting"
        yield [*base, "--set", f"{name}=1e-3"], "setting"
    for text in ("=[1e-3,1e-4]", "=1e-3;1e-4", "=1e-3:1e-2", "=1e-2..1e-3", "=1e-3..", "=1e-3..1e-2:lin",
                 "=0..1e-2:log", "=1e-3,", "=", ":1e-3", " 1e-3",
                 "=1e-3|1e-4", "=(1e-3,1e-4)", "=1e-3 1e-4", "=1e-3,1e-3", "=.001,1e-3", "==1e-3",
                 "=linspace(0,1,3)"):  # fmt: skip
        yield [*base, "--vary", f"learning_rate{text}"], ""
    for option in ("--vary", "--set"):
        for text in ("environment=fig6_chain", "environment=two_branch", "algorithm=c51", "seed=3", "seeds=3", "jobs=2",
                     "env=two_branch", "world=two_branch"):  # fmt: skip
            yield [*base, option, text], ""
        for text in ("double=yes", "double=on", "double=True,maybe", "dueling=2"):
            yield [*base, option, text], "must be true or false"
    for text in ("0,1,2", "1-3", "three", "3.5", "0", "-1", "101", "[0,1]", "all"):
        yield [*base, "--seeds", text], "seeds"
        yield [*base, "--jobs", f"x{text}"], "jobs"
    for words in (["DQN", "two_branch"], ["dqn"], ["two_branch", "dqn"], ["rainbow", "two_branch"], ["dqn", "CartPole"],
                  ["dqn", "CartPole-v2"], ["dqn", "two_branch,cliff_grid"], ["dqn,c51", "two_branch"],
                  ["dqn", "gym:Taxi"], ["dqn", "my_world.json"]):  # fmt: skip
        yield ["search", *words, "--budget"], ""
    for same in (["--vary", "learning_rate=.001,1e-2"], ["--vary", "learning_rate= 1e-3 , .01 "]):
        yield [*base, *same], [*base, "--vary", "learning_rate=0.001,0.01"]


def near_evaluate(checkpoint: str) -> Iterator[tuple[list[str], str | list[str]]]:
    """The same for ``evaluate`` of an agent of Laplace DQN."""
    base = ["evaluate", checkpoint, "--episodes", "2", "--horizon", "3"]
    ruled = {"stretch": "fading", "alpha": "readout", "softness": "decoded"}
    for name in ("episodes", "seed", "horizon", *ruled):
        more = ["--rule", ruled[name]] if name in ruled else []
        for text in (*NEAR_NUMBERS[:12], *_TYPED, "-1", "1e9", "", " "):
            yield [*base, *more, f"--{name}={text}"], name
    for text in ("full", "none", "0", "T", "2.5", "50,100"):
        yield [*base, f"--horizon={text}"], "horizon"
    for text in ("Greedy", "GREEDY", "matching", "match", "fade", "Fading", "read-out", "read_out", "decode",
                 "decoded ", "readout,decoded", "best", "argmax", "random", "epsilon", "own", "own ", "policy", "0",
                 "", "none"):  # fmt: skip
        yield [*base, "--rule", text], "rule"
    for option in ("--gamma", "--gammas", "--steps", "--out", "--start", "--against", "--environment", "--theta-min"):
        yield [*base, option, "3"], ""
    for text in ("runs/x", "agent", "agent.pt", "agent.pth", "agent.zip", "best.safetensors", "two_branch",
                 "gym:Taxi-v4", checkpoint.upper(), checkpoint + ".bak",
                 checkpoint.removesuffix(".safetensors")):  # fmt: skip
        yield ["evaluate", text], ""
    for rule in ("greedy", "matched"):
        for name in ruled:
            yield [*base, "--rule", rule, f"--{name}", "1"], f"--{name}"
    for same in (
        ["--seed", "0"],
        ["--seed", "0.0"],
        ["--rule", "fading"],
        ["--stretch", "1.5"],
        ["--stretch", "15e-1"],
    ):
        yield [*base, *same], base
