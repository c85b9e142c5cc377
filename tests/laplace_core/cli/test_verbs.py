"""The command line: what it prints and writes, that its settings reproduce a run, and that it refuses in one line."""

import json
import os
import shlex
import subprocess
import sys

import numpy as np
import pytest

from laplace_core import PRESETS
from laplace_core.cli import main
from laplace_core.study.settings import SCHEMA
from laplace_core.worlds import TOY_TEXT, dump_world, load_world
from tests.support.hostile import OLD, assert_nothing_written, assert_refused
from tests.support.malformed_commands import CASES
from tests.support.malformed_saved import own_values, with_arrays
from tests.support.malformed_worlds import TEXT

GOLDEN = (
    "decode two_branch --param length=3 --param r1=5 --param r2=10 --gammas 15 --spacing inverse-log --gamma-min .01 "
    "--gamma-max .99 --thetas 150 --theta-min -2 --theta-max 12 --slope 25 --alpha .2 --steps 3"
)


def printed(capsys, words: list[str] | str) -> str:
    """What a command that succeeds prints."""
    words = shlex.split(words) if isinstance(words, str) else words
    assert main(words) == 0
    out, err = capsys.readouterr()
    assert err == ""
    return out


def strict_json(text: str) -> dict:
    """Parsed as other programs parse JSON: without NaN and Infinity."""

    def refuse(constant: str):
        raise AssertionError(f"{constant} is no JSON")

    return json.loads(text, parse_constant=refuse)


def arrays_of(path) -> dict[str, np.ndarray]:
    with np.load(path, allow_pickle=False) as file:
        return dict(file)


# --- notes ---


def test_rewards_that_no_sensitivity_reaches_are_told(capsys):
    out = printed(capsys, "decode two_branch --theta-max 7 --theta-min -2")
    note = "the sensitivities, -2 to 7, do not reach the reward 10: none of that is in tau-space"
    assert note in out.splitlines()
    assert strict_json(printed(capsys, "decode two_branch --theta-max 7 --theta-min -2 --json"))["notes"] == [note]
    # With a slope of 1 the reward 5, half a unit above 4.5, keeps sigmoid(6) - sigmoid(.5) = .375 of its mass.
    wide = printed(capsys, "decode two_branch --theta-min -1 --theta-max 4.5 --thetas 100 --slope 1")
    assert "do not reach the rewards 5, 10: at most 38% of that is in tau-space" in wide


def test_a_world_within_its_sensitivities_needs_no_note(capsys):
    assert strict_json(printed(capsys, "decode two_branch --json"))["notes"] == []


def test_states_that_end_an_episode_are_told(capsys, tmp_path):
    path = tmp_path / "sink.json"
    path.write_text(TEXT.replace("END", "sink").replace('"long"]', '"long", "sink"]').replace('"transitions": [',
        '"transitions": [{"state": "sink", "action": "*", "next": {"sink": 1}, "reward": {"0": 1}}, '))  # fmt: skip
    out = printed(capsys, ["decode", str(path)])
    assert "the episode ends on entering sink" in out


# --- files ---


def test_endings_may_be_in_capitals(capsys, tmp_path):
    (tmp_path / "W.JSON").write_text(TEXT)
    (tmp_path / "X.NPZ").write_bytes(with_arrays())
    assert "my_world" not in printed(capsys, ["decode", str(tmp_path / "X.NPZ"), "--out", str(tmp_path / "Y.NPZ")])
    assert "state start" in printed(capsys, ["decode", str(tmp_path / "W.JSON")])
    assert arrays_of(tmp_path / "Y.NPZ")["gamma_space"].shape == (2, 3, 4)
    learned = tmp_path / "L.SAFETENSORS"
    printed(capsys, ["learn", str(tmp_path / "W.JSON"), "--episodes", "2", "--out", str(learned)])
    assert "state start" in printed(capsys, ["decode", str(learned)])
    assert_refused(capsys, ["decode", "two_branch", "--out", "x.NPY"], "x.NPY", ".npz")


# --- worlds ---


def test_worlds_lists_every_world_with_its_parameters(capsys):
    out = printed(capsys, "worlds")
    tables = {name: preset.parameters for name, preset in PRESETS.items()}
    tables |= {f"gym:{name}": parameters for name, parameters in TOY_TEXT.items()}
    blocks = dict(zip(tables, [out.split(f"{name}\n", 1)[1] for name in tables], strict=True))
    for name, parameters in tables.items():
        for parameter in parameters:
            assert f"    {parameter.name}=" in blocks[name]
            assert parameter.help in blocks[name]


def test_worlds_as_json_hold_what_decode_takes(capsys):
    listed = strict_json(printed(capsys, "worlds --json"))
    assert [preset["name"] for preset in listed["presets"]] == list(PRESETS)
    assert listed["gym"] == list(TOY_TEXT)
    for preset in listed["presets"]:
        words = ["decode", preset["name"], "--thetas", "5", "--json"]
        for parameter in preset["parameters"]:
            assert parameter["low"] <= parameter["default"] <= parameter["high"]
            words += ["--param", f"{parameter['name']}={parameter['default']}"]
        assert strict_json(printed(capsys, words))["settings"]["world"] == preset["name"]


# --- decode ---


@pytest.mark.parametrize(
    ("extra", "short_rewards", "short_value", "long_value"),
    [
        ("--normalise paper", "5.00    5.00    5.00", "14.85", "9.74"),
        ("--normalise none", None, "5.00", "9.70"),
        ("--param auxiliary=true --normalise paper", None, "5.00", "9.74"),
    ],
)
def test_the_toy_of_the_paper(capsys, extra, short_rewards, short_value, long_value):
    lines = printed(capsys, f"{GOLDEN} {extra}").splitlines()
    values = [line.split() for line in lines if "  decoded " in line][2:]
    assert [(name, value) for name, _, value, *_ in values] == [("short", short_value), ("long", long_value)]
    assert [true for *_, true in values] == ["5.00", "9.80"]
    assert short_rewards is None or short_rewards in next(line for line in lines if "decoded" in line)


def test_the_toy_of_the_paper_as_json(capsys):
    found = strict_json(printed(capsys, f"{GOLDEN} --normalise paper --json"))
    assert [f"{value:.2f}" for value in found["expected_reward"][0]] == ["5.00", "5.00", "5.00"]
    assert [f"{values[-1]:.2f}" for values in found["horizon_values"]] == ["14.85", "9.74"]
    assert found["true_expected_reward"] == [[5.0, 0.0, 0.0], [0.0, 0.0, 10.0]]
    assert found["actions"] == ["short", "long"]
    assert found["optimal_action"] == [0, 0, 1]


def test_the_verdict_is_printed_and_explained_where_that_is_asked_for(capsys):
    quick = printed(capsys, f"{GOLDEN} --normalise paper").splitlines()[-1]
    assert quick.startswith("verdict       At T = 3 the decoded values choose short (14.85 v 9.74); the best is long.")
    assert "Cause" not in quick
    told = printed(capsys, f"{GOLDEN} --normalise paper --explain").splitlines()
    assert "Cause: repeated reward, in short." in next(line for line in told if line.startswith("verdict"))
    assert "remedy        Keep survival" in told
    assert any(line.startswith("artefact      repeated reward, in short:") for line in told)
    verdict = strict_json(printed(capsys, f"{GOLDEN} --normalise paper --explain --json"))["verdict"]
    assert (verdict["horizon"], verdict["choice"], verdict["chosen"]) == (3.0, "wrong", "short")
    assert verdict["remedies"][0] == {"label": "Keep survival", "changes": {"normalise": "none"}}
    # At T = 1 the same settings choose short rightly, on the right value.
    first = strict_json(printed(capsys, f"{GOLDEN} --normalise paper --horizon 1 --json"))["verdict"]
    assert (first["horizon"], first["choice"]) == (1.0, "right")
    assert "cause" not in first


def test_actions_are_told_as_runs_over_the_horizon(capsys):
    lines = printed(capsys, f"{GOLDEN} --normalise none").splitlines()
    assert lines[-3].split(maxsplit=3) == ["chosen", "by", "T", "1-2 short, 3 long"]
    assert lines[-2].split(maxsplit=3) == ["best", "by", "T", "1-2 short, 3 long"]
    assert lines[-1].startswith("verdict       At T = 3 the decoded values choose long")


@pytest.mark.parametrize("extra", ["", "--normalise survival", "--normalise paper --policy per_gamma --softness .3"])
@pytest.mark.parametrize("world", ["two_branch", "fig6_chain", "gym:FrozenLake"])
def test_the_file_holds_every_array_of_the_contract(tmp_path, capsys, world, extra):
    out = tmp_path / "out.npz"
    printed(capsys, f"decode {world} --gammas 12 --thetas 30 --steps 7 {extra} --out {out}")
    arrays = arrays_of(out)
    actions = len(load_world(world).actions)
    rows, table = (actions, 7), (actions, 7, 29)
    shapes = {"gamma_space": (actions, 12, 30), "gammas": (12,), "thetas": (30,), "theta_midpoints": (29,)}
    for prefix in ("", "true_"):
        shapes |= {f"{prefix}{name}": rows for name in ("survival", "expected_reward", "horizon_values")}
        shapes |= {f"{prefix}tau_space": table}
    for name, shape in shapes.items():
        assert (arrays[name].shape, arrays[name].dtype) == (shape, np.float64), name
        assert np.all(np.isfinite(arrays[name])), name
    assert arrays["optimal_action"].shape == (7,)
    assert np.issubdtype(arrays["optimal_action"].dtype, np.integer)
    np.testing.assert_allclose(arrays["theta_midpoints"], (arrays["thetas"][1:] + arrays["thetas"][:-1]) / 2)
    np.testing.assert_allclose(arrays["expected_reward"], arrays["tau_space"] @ arrays["theta_midpoints"])
    totals = np.cumsum(arrays["true_expected_reward"] * 0.99 ** np.arange(7), axis=1)
    if "softness" not in extra:  # a soft deadline reads the true values softly too
        np.testing.assert_allclose(arrays["true_horizon_values"], totals, atol=1e-12)
    assert set(strict_json(str(arrays["settings"]))) >= {"world", "params", *(p.name for p in SCHEMA)}


COMMANDS = [
    "two_branch",
    "two_branch --param auxiliary=true --param slip=.1 --param r1=-0.1 --param r2=1e-3 --state 'long 1'",
    "two_branch --theta-min -1e-5 --theta-max 10 --alpha 1e-7 --gamma-min 0.12345678901234567",
    "two_branch --param r1=3.3333333333333335 --slope 0.1234567890123456 --theta-min -1e+2 --theta-max 1e2",
    "two_decisions --policy per_gamma --normalise paper --softness 0.1 --acting-gamma .87654321098765432",
    "double_chain --param p_early=.123456789012345678 --time-step .3 --normalise survival",
    "discounting_chain --spacing paper --theta-spacing asinh",
    "cliff_grid --param slip=.2 --state 7 --spacing linear --gamma-min .1 --theta-spacing gaussian",
    "gym:FrozenLake --param is_slippery=False --state '(1, 0)'",
    "gym:Taxi-v4 --steps 5 --thetas 10",
]


def assert_reproduced(tmp_path, capsys, words: list[str]) -> None:
    """The command in the file's settings writes the same file again."""
    first, second = tmp_path / "first.npz", tmp_path / "second.npz"
    printed(capsys, [*words, "--out", str(first)])
    command = shlex.split(json.loads(str(arrays_of(first)["settings"]))["command"])
    assert command[:3] == ["python", "-m", "laplace_core"]
    printed(capsys, [*command[3:], "--out", str(second)])
    one, two = arrays_of(first), arrays_of(second)
    assert set(one) == set(two)
    for name in set(one) - {"settings"}:
        np.testing.assert_array_equal(one[name], two[name], err_msg=name)


@pytest.mark.parametrize("command", COMMANDS)
def test_settings_reproduce_the_run(tmp_path, capsys, command):
    assert_reproduced(tmp_path, capsys, ["decode", *shlex.split(command)])


def test_settings_reproduce_a_run_on_files(tmp_path, capsys):
    own, world = tmp_path / "my own.npz", tmp_path / "my world.json"
    own.write_bytes(with_arrays(gamma_space=own_values((2, 2)), constant_channel=None))
    world.write_text(TEXT.replace("long", " - 長い "), encoding="utf-8")
    assert_reproduced(tmp_path, capsys, ["decode", str(own), "--state", "1", "--steps", "5", "--alpha", ".1"])
    assert_reproduced(tmp_path, capsys, ["decode", str(world), "--state", " - 長い "])
    assert_reproduced(tmp_path, capsys, ["decode", str(world), "--state", "2"])


def test_a_preset_and_its_file_decode_to_the_same(tmp_path, capsys):
    path = tmp_path / "world.json"
    path.write_text(dump_world(load_world("cliff_grid", {"slip": "0.1"})))
    options = "--gammas 20 --spacing log --gamma-min .3 --thetas 20 --steps 12 --alpha .01 --json"
    preset = strict_json(printed(capsys, f"decode cliff_grid --param slip=.1 {options}"))
    own = strict_json(printed(capsys, f"decode {path} {options}"))
    for name in ("expected_reward", "horizon_values", "true_horizon_values"):
        np.testing.assert_allclose(own[name], preset[name], rtol=1e-9, atol=1e-9)


def test_a_file_is_replaced_as_a_whole(tmp_path, capsys):
    out = tmp_path / "out.npz"
    out.write_bytes(OLD)
    printed(capsys, f"decode two_branch --thetas 5 --out {out}")
    assert [entry.name for entry in tmp_path.iterdir()] == ["out.npz"]
    assert arrays_of(out)["thetas"].shape == (5,)


# --- as a process ---


def run(*words: str, **environment: str) -> subprocess.CompletedProcess:
    command = [sys.executable, "-m", "laplace_core", *words]
    return subprocess.run(command, capture_output=True, env=os.environ | environment, check=False)


def test_the_process_ends_with_the_status_of_the_contract(tmp_path):
    good = run("decode", "two_branch", "--thetas", "5", "--json")
    assert (good.returncode, good.stderr) == (0, b"")
    assert strict_json(good.stdout.decode())["actions"] == ["short", "long"]
    bad = run("decode", "two_branch", "--alpha", "-1", "--out", str(tmp_path / "out.npz"))
    assert (bad.returncode, bad.stdout) == (2, b"")
    assert bad.stderr == b"laplace: alpha must be a number from 0 to 1e+06, not '-1'.\n"
    assert not list(tmp_path.iterdir())


def test_a_terminal_without_the_letters_of_a_name_shows_their_numbers(tmp_path):
    path = tmp_path / "world.json"
    path.write_text(TEXT.replace("left", "←"), encoding="utf-8")
    shown = run("decode", str(path), "--thetas", "5", PYTHONIOENCODING="ascii:strict")
    assert (shown.returncode, shown.stderr) == (0, b"")
    assert b"\\u2190" in shown.stdout


# --- what is refused ---


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("refused")


def test_a_malformed_command_is_refused_by_name(subtests, folder, capsys):
    assert CASES
    for name, words, named in CASES:
        with subtests.test(name):
            assert_nothing_written(capsys, words, folder, *named)


@pytest.mark.parametrize("name", ["", "out", "out.npy", "out.npz ", "out.npz/", "out.NPY", "-", "missing/out.npz"])
def test_a_file_that_cannot_be_written_is_refused(tmp_path, capsys, monkeypatch, name):
    monkeypatch.chdir(tmp_path)
    assert_refused(capsys, ["decode", "two_branch", "--thetas", "5", "--out", name], name.strip())
    assert not list(tmp_path.iterdir())


def test_an_out_path_that_is_no_file_is_refused(tmp_path, capsys):
    (tmp_path / "folder.npz").mkdir()
    (tmp_path / "file.npz").write_bytes(OLD)
    before = sorted(tmp_path.rglob("*"))
    for name in ("folder.npz", "file.npz/out.npz", "zero\0byte.npz", "x" * 300 + ".npz"):
        assert_refused(capsys, ["decode", "two_branch", "--thetas", "5", "--out", str(tmp_path / name)], name[:4])
    assert sorted(tmp_path.rglob("*")) == before
    assert (tmp_path / "file.npz").read_bytes() == OLD


def test_a_saved_gamma_space_decides_its_own_encoding(tmp_path, capsys):
    own = tmp_path / "own.npz"
    own.write_bytes(with_arrays())
    for option, value in [
        ("--gammas", "3"),
        ("--spacing", "log"),
        ("--theta-max", "5"),
        ("--slope", "2"),
        ("--policy", "shared"),
    ]:
        assert_nothing_written(capsys, ["decode", str(own), option, value], tmp_path, option, "the file decides it")
    for words, named in [(["--param", "r1=1"], "--param"), (["--state", "1"], "state"), (["--steps", "0"], "steps")]:
        assert_nothing_written(capsys, ["decode", str(own), *words], tmp_path, named)


def test_a_study_too_large_to_hold_is_refused(tmp_path, capsys):
    world = json.loads(TEXT) | {"actions": [f"a{i}" for i in range(40)]}
    world["transitions"] = [
        {"state": s, "action": "*", "next": {"END": 1.0}, "reward": {"1": 1.0}} for s in world["states"]
    ]
    path = tmp_path / "world.json"
    path.write_text(json.dumps(world))
    words = ["decode", str(path), "--thetas", "2000", "--steps", "2000"]
    assert_nothing_written(capsys, words, tmp_path, "40 actions", "2000 thetas", "160,000,000")
