"""The script that repeats a study runs, and gives the same arrays."""

import ast
import subprocess
import sys

import numpy as np
import pytest

from laplace_core import Settings, load_world, study, study_of_gamma_space
from laplace_core.study.npz import read_gamma_space
from laplace_core.study.settings import SCHEMA, parse_settings
from laplace_core.worlds import dump_world, read_world, world_from_rows, world_rows
from tests.support.malformed_saved import own_values, with_arrays
from tests.support.malformed_worlds import TEXT


def assert_same_study(script: str, expected) -> None:
    namespace: dict = {}
    exec(compile(script, "script", "exec"), namespace)
    found = namespace["result"]
    assert found.settings == expected.settings
    assert found.action_names == expected.action_names
    np.testing.assert_array_equal(found.gamma_space.values, expected.gamma_space.values)
    for name in ("tau_space", "survival", "expected_reward", "horizon_values", "actions"):
        np.testing.assert_array_equal(getattr(found.decoded, name), getattr(expected.decoded, name))
    if expected.truth is not None:
        np.testing.assert_array_equal(found.truth.optimum, expected.truth.optimum)
    assert max(map(len, script.splitlines())) <= 120


CHOICES = {
    "defaults": {},
    "a few": {"alpha": "0.2", "normalise": "paper", "thetas": "40"},
    "many": {
        **{"gammas": "20", "spacing": "log", "gamma_min": ".2", "gamma_max": ".95", "thetas": "31", "slope": "7.5"},
        **{"theta_spacing": "asinh", "theta_min": "-3", "theta_max": "1e1", "alpha": "1e-3", "steps": "9"},
        **{"time_step": "0.5", "policy": "per_gamma", "acting_gamma": ".9", "softness": ".1", "deadline": "constant"},
        **{"solver": "tikhonov", "noise": "0.01", "noise_seed": "3", "normalise": "survival", "state": "1"},
    },
}
WORLDS = {
    "two_branch": {},
    "two_decisions": {"r1": "4.5", "auxiliary": "true", "length": "5"},
    "gym:FrozenLake": {"is_slippery": "false"},
    "gym:CliffWalking-v1": {},
}


def test_the_script_repeats_a_study_of_a_named_world(subtests):
    for name, given in CHOICES.items():
        for world in WORLDS:
            with subtests.test(name, world=world):
                params = WORLDS[world]
                chosen = parse_settings(world, params, given)
                expected = study(load_world(world, params), chosen)
                for settings in (chosen, expected.settings):
                    script = settings.to_python()
                    assert_same_study(script, expected)
                    assert script.count("=") >= len(given)
                assert all(f"{name}=" in chosen.to_python() for name in given)
                unchosen = [parameter.name for parameter in SCHEMA if parameter.name not in given]
                assert not [name for name in unchosen if f" {name}=" in chosen.to_python()]


@pytest.mark.parametrize(
    "name", ["world.json", 'a "quoted" one.json', "it's.json", "весь мир.json", "back\\slash.json"]
)
def test_the_script_repeats_a_study_of_a_world_file(tmp_path, name):
    path = tmp_path / name
    path.write_text(TEXT, encoding="utf-8")
    chosen = Settings(world=str(path), alpha=0.1)
    assert_same_study(chosen.to_python(), study(load_world(str(path)), chosen))


def test_the_script_repeats_a_study_of_an_edited_world(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    rows = world_rows(load_world("two_branch"))
    rows[0]["reward"] = 3.0
    (tmp_path / "edited.json").write_text(dump_world(world_from_rows(rows)))
    expected = study(read_world("edited.json"), Settings(alpha=0.1))
    assert_same_study(Settings(alpha=0.1).to_python('read_world("edited.json")'), expected)
    text = f"parse_world({(tmp_path / 'edited.json').read_text().replace(chr(10), '')!r})"
    namespace: dict = {}
    exec(Settings(alpha=0.1).to_python(text), namespace)
    np.testing.assert_array_equal(namespace["result"].decoded.tau_space, expected.decoded.tau_space)


@pytest.mark.parametrize("leading", [(2,), (3, 2)])
def test_the_script_repeats_a_study_of_a_gamma_space(tmp_path, leading):
    path = tmp_path / "own.npz"
    values = own_values(leading)
    path.write_bytes(with_arrays(gamma_space=values, constant_channel=None))
    chosen = Settings(world=str(path), state="2" if len(leading) == 2 else None, alpha=0.1, normalise="paper")
    expected = study_of_gamma_space(read_gamma_space(path, chosen.state), chosen)
    for settings in (chosen, expected.settings):
        assert_same_study(settings.to_python(), expected)


def test_words_from_outside_stay_words():
    nasty = 'x"); import os; os.abort(); ("'
    settings = Settings(nasty + ".json", ((nasty, nasty + "'\n\\"),), state=nasty + "\ud800")
    for each in (settings, Settings(nasty + ".npz", state=nasty)):
        tree = ast.parse(each.to_python())
        imports = [node for node in ast.walk(tree) if isinstance(node, ast.Import)]
        assert imports == []
        assert nasty in {str(node.value) for node in ast.walk(tree) if isinstance(node, ast.Constant)}


def test_numpy_numbers_are_written_as_plain_ones():
    chosen = Settings("two_branch", (("r1", np.float64(4.0)),), alpha=np.float64(0.1), steps=np.int64(5))
    assert "np." not in chosen.to_python()
    assert_same_study(chosen.to_python(), study(load_world("two_branch", {"r1": 4.0}), Settings(alpha=0.1, steps=5)))


def test_the_script_runs_by_itself():
    script = Settings("two_branch", (("r1", 6.0),), alpha=0.2).to_python()
    done = subprocess.run(
        [sys.executable, "-W", "error", "-c", f"{script}print(result.decoded.actions)"], capture_output=True, text=True
    )
    assert (done.stdout, done.stderr) == ("[0 0 1]\n", "")
