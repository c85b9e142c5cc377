"""``check``: the test of consistency from the command line."""

import json

import numpy as np
import pytest

from laplace_core.cli import main
from tests.support.random_gamma_spaces import noisy_space


@pytest.fixture
def file(tmp_path):
    def write(factor: float = 1.0) -> str:
        _, noisy, _ = noisy_space(1e-3)
        path = tmp_path / "own.npz"
        np.savez(path, gamma_space=factor * noisy.values, constant_channel=factor * noisy.constant,
                 gammas=noisy.gammas, thetas=noisy.thetas)  # fmt: skip
        return str(path)

    return write


def test_a_file_that_is_consistent_is_said_to_be(file, capsys):
    assert main(["check", file(), "--noise-level", "1e-3"]) == 0
    text = capsys.readouterr().out
    assert "Some feasible timeline fits" in text
    assert "0.001, given" in text


def test_json_of_one_that_is_not(file, capsys):
    assert main(["check", file(1.2), "--noise-level", "1e-3", "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["consistent"] is False
    assert found["p_value"] <= found["level"]
    assert found["misfit"] > 10 * found["usual_misfit"]
    assert len(found["relief"]) == len(found["gammas"]) == 12
    assert len(found["misfit_by_action"]) == 2


def test_a_world_is_tested_as_it_would_be_decoded(capsys):
    assert main(["check", "two_branch", "--noise", "0.01"]) == 0
    assert "0.01, of --noise" in capsys.readouterr().out


def test_seeds_of_a_learned_agent_show_their_noise(tmp_path, capsys):
    path = str(tmp_path / "learned.safetensors")
    assert main(["learn", "two_branch", "--param", "slip=0.2", "--seeds", "4", "--episodes", "200", "--out", path]) == 0
    capsys.readouterr()
    assert main(["check", path, "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["noise"] == "from 4 seeds"
    assert main(["check", path, "--seed-index", "1", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["noise"] == "0.001, assumed"


def test_bad_input_is_one_sentence(subtests, capsys):
    for arguments, named in [
        (["two_branch", "--noise-level", "0"], "noise-level"),
        (["two_branch", "--noise-level", "much"], "noise-level"),
        (["two_branch", "--seed-index", "1"], "seed-index"),
        (["nowhere.npz"], "nowhere.npz"),
        (["two_branch", "--alpha", "1"], "alpha"),
    ]:
        with subtests.test(arguments=arguments):
            assert main(["check", *arguments]) == 2
            words = capsys.readouterr().err
            assert named in words
            assert len(words.splitlines()) == 1
