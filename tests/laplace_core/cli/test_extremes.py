"""Settings at the ends of their ranges: odd, but allowed; they give finite numbers or one sentence."""

import json
import shlex

import numpy as np
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from laplace_core import PRESETS
from laplace_core.cli import main
from laplace_core.parameters import Parameter
from laplace_core.study.settings import SCHEMA, flag
from tests.support.hostile import assert_one_sentence
from tests.support.malformed_saved import with_arrays


def outcome(capsys, words: list[str]) -> dict | str:
    """The finite JSON that a command prints, or the one sentence that it refuses with."""
    capsys.readouterr()
    status = main([*words, "--json"])
    out, err = capsys.readouterr()
    if status == 0:
        assert err == ""

        def refuse(constant: str):
            raise AssertionError(f"{constant} in the output of {shlex.join(words)}")

        return json.loads(out, parse_constant=refuse)
    assert (status, out) == (2, "")
    assert_one_sentence(err.rstrip("\n"))
    return err


ACCEPTED = [
    "two_branch --softness 1e-310",
    "two_branch --theta-min 0 --theta-max 1e-30",
    "two_branch --thetas 2000 --steps 2000",
    "two_branch --thetas 2 --gammas 2 --steps 1",
    "two_branch --gammas 500 --steps 300 --alpha 0",
    "two_branch --slope 1e9",
    "two_branch --slope 1e-6",
    "two_branch --theta-min 0 --theta-max 1e-300 --slope 1",
    "two_branch --theta-min -1e9 --theta-max 1e9",
    "two_branch --alpha 0 --steps 2000 --thetas 10",
    "two_branch --alpha 1e6",
    "two_branch --alpha 5e-324",
    "two_branch --time-step .001 --thetas 10",
    "two_branch --time-step .001 --steps 1",
    "two_branch --gamma-min .5 --gamma-max .5000001 --alpha 0",
    "two_branch --gamma-min 1e-6 --gamma-max .999999 --spacing log --steps 2000 --thetas 10",
    "two_branch --acting-gamma .999999 --softness 10",
    "two_branch --acting-gamma 1e-6 --softness 1e-6",
    "two_branch --param r1=1000 --param r2=-1000 --param length=200 --param auxiliary=true --normalise paper",
    "two_branch --param length=1 --param slip=.5",
    "two_branch --param r1=0 --param r2=0",
    "fig6_chain --param outer=0 --param inner=0 --normalise survival",
    "double_chain --param p_early=0 --param early=1 --param late=1",
    "double_chain --param p_early=1 --normalise survival --alpha 0",
    "rise_and_fade --param length=4 --param low=1000 --param high=-1000 --policy per_gamma",
    "discounting_chain --param reward=-1000 --thetas 2000 --steps 50",
    "cliff_grid --param width=3 --param height=2 --param slip=1",
    "cliff_grid --param width=50 --param height=40 --thetas 5 --steps 20 --gammas 5",
    "gym:CliffWalking --acting-gamma .999999 --alpha 0 --thetas 2",
]


def test_extremes_give_finite_numbers(subtests, capsys):
    for command in ACCEPTED:
        with subtests.test(command):
            assert isinstance(outcome(capsys, ["decode", *command.split()]), dict)


def test_what_decode_fills_in_for_extreme_rewards_can_be_given_and_read_back(subtests, tmp_path, capsys):
    """The command that reproduces the run, and the file as a gamma-space of one's own.

    Options may be refused, defaults may not: those are the program's own.
    """
    for rewards, options in [
        ("100000000 100000001", ""),
        ("1e-300 0", ""),
        ("1 2", "--theta-min 1 --theta-max 1.0000000000000002"),
        ("1 2", "--gamma-min .5 --gamma-max .5000000000000001"),
        ("1e9 -1e9", ""),
        ("1 2", "--thetas 2 --theta-min -1e9 --theta-max 1e9"),
        ("1e8 0", "--theta-min 0 --theta-max 1e8"),
        ("1e-6 2e-6", ""),
    ]:
        with subtests.test(rewards=rewards, options=options):
            world, out = tmp_path / "world.json", tmp_path / "out.npz"
            entry = {"state": "s", "action": "a", "next": {"END": 1.0}, "reward": dict.fromkeys(rewards.split(), 0.5)}
            world.write_text(json.dumps({"states": ["s"], "actions": ["a"], "transitions": [entry]}))
            found = outcome(capsys, ["decode", str(world), *options.split(), "--out", str(out)])
            if options and isinstance(found, str):
                return
            assert isinstance(found, dict)
            with np.load(out, allow_pickle=False) as file:
                command = json.loads(str(file["settings"]))["command"]
            assert isinstance(outcome(capsys, shlex.split(command)[3:]), dict)
            assert isinstance(outcome(capsys, ["decode", str(out)]), dict)


def test_a_gamma_space_of_ones_own_has_default_steps_at_any_time_step(tmp_path, capsys):
    path = tmp_path / "own.npz"
    path.write_bytes(with_arrays(gammas=np.array([0.2, 0.5, 0.999])))
    assert isinstance(outcome(capsys, ["decode", str(path), "--time-step", ".001"]), dict)


def numbers(low: float, high: float) -> st.SearchStrategy[float]:
    ends = [low, high, low + (high - low) * 1e-9, high - (high - low) * 1e-9, (low + high) / 2]
    return st.floats(low, high) | st.sampled_from(ends)


def values(parameter: Parameter, most: int) -> st.SearchStrategy[str]:
    """Texts that a parameter accepts; whole numbers up to ``most``, so that every run is quick."""
    if parameter.choices:
        return st.sampled_from(parameter.choices)
    if parameter.type is bool:
        return st.sampled_from(["true", "false"])
    if parameter.type is str:
        return st.sampled_from(["0", "1", "start"])
    if parameter.type is int:
        return st.integers(int(parameter.bounds[0]), min(int(parameter.bounds[1]), most)).map(str)
    if parameter.name == "softness":
        return st.just("0") | st.floats(1e-6, 10).map(repr)
    return numbers(*parameter.bounds).map(repr)


@st.composite
def commands(draw) -> list[str]:
    """A preset with some of its parameters, and any of the settings."""
    preset = draw(st.sampled_from(list(PRESETS.values())))
    words = ["decode", preset.name]
    for parameter in draw(st.lists(st.sampled_from(preset.parameters), unique=True)):
        value = draw(values(parameter, 12))
        words += ["--param", f"{parameter.name}={value}"]
    for parameter in draw(st.lists(st.sampled_from(SCHEMA), unique=True)):
        words += [flag(parameter), draw(values(parameter, 40))]
    return words


@settings(max_examples=100, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(commands())
def test_any_settings_in_range_give_finite_numbers_or_a_sentence(capsys, words):
    outcome(capsys, words)
