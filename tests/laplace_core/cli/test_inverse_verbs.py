"""The verbs ``grid`` and ``train-inverse`` and the reports that go with them."""

import json

import numpy as np
import pytest

from laplace_core.cli import main
from laplace_core.inverse.neural import read_network


def printed(capsys, *words: str) -> str:
    assert main([*words]) == 0
    return capsys.readouterr().out


def test_a_grid_is_printed_beside_the_usual_ones(capsys):
    numbers = json.loads(printed(capsys, "grid", "--gammas", "3", "--horizon", "6", "--noise", "0.01", "--json"))
    names = [each["name"] for each in numbers["grids"]]
    assert names == ["designed", "inverse-log, tuned", "log, tuned", "inverse-log", "log", "linear", "paper"]
    designed, *others = numbers["grids"]
    assert all(designed["error"] <= other["error"] for other in others if len(other["gammas"]) == 3)
    assert numbers["horizons"] == [1, 2, 3, 4, 5, 6]


def test_a_grid_is_printed_as_a_table(capsys):
    lines = printed(capsys, "grid", "--gammas", "2", "--horizon", "3").splitlines()
    assert lines[0] == "2 discounts for horizons up to 3, noise 0.001"
    assert lines[1].split()[-3:] == ["T", "=", "3"]
    assert [line[:18].strip() for line in lines[2:-1]][:2] == ["designed", "inverse-log, tuned"]
    low, high = (float(word) for word in lines[-1].removeprefix("designed: ").split())
    assert 0.0 < low < high <= 0.999


def test_grids_on_random_worlds(capsys):
    numbers = json.loads(
        printed(capsys, "report", "grids", "--gammas", "3", "--horizon", "5", "--cases", "12", "--json")
    )
    designed, *others = numbers["rows"]
    (usual,) = [row for row in others if row["grid"] == "inverse-log"]
    assert designed["worlds"]["error"] < usual["worlds"]["error"]
    assert usual["worlds"]["designed nearer"] > 0.5


def test_a_network_is_trained_into_a_file_and_judged(capsys, tmp_path):
    path = tmp_path / "a.safetensors"
    text = printed(
        capsys, "train-inverse", "--gammas", "4", "--spacing", "log", "--gamma-max", "0.9", "--steps", "200",
        "--updates", "2", "--samples", "100", "--out", str(path),
    )  # fmt: skip
    assert text.splitlines()[-1].startswith("4 discounts from 0.01 to 0.9, 200 rows")
    network = read_network(path)
    np.testing.assert_allclose(network.gammas, np.exp(-1 / np.geomspace(-1 / np.log(0.01), -1 / np.log(0.9), 4)))
    (numbers,) = json.loads(printed(capsys, "report", "neural", str(path), "--cases", "2", "--json")).values()
    assert [row["solver"] for row in numbers["rows"] if "solver" in row][:4] == [
        "tikhonov gcv", "clipped gcv", "tikhonov best", "neural",
    ]  # fmt: skip


def test_a_network_of_few_rows_cannot_be_judged(capsys, tmp_path):
    path = tmp_path / "a.safetensors"
    printed(capsys, "train-inverse", "--gammas", "3", "--steps", "3", "--updates", "1", "--samples", "100",
            "--out", str(path))  # fmt: skip
    assert main(["report", "neural", str(path), "--cases", "5"]) == 2
    assert "train for 200" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("words", "named"),
    [
        (("grid", "--gammas", "1"), "gammas"),
        (("grid", "--horizon", "0"), "horizon"),
        (("grid", "--noise", "x"), "noise"),
        (("grid", "--gamma-max", "1"), "gamma-max"),
        (("grid", "--value-gamma", "0"), "value-gamma"),
        (("report", "grids", "--cases", "0"), "cases"),
        (("report", "neural", "nothing.safetensors"), "nothing.safetensors"),
        (("train-inverse", "--out", "a.npz"), "must end in .safetensors"),
        (("train-inverse", "--out", "a.safetensors", "--spacing", "odd"), "spacing"),
        (("train-inverse", "--out", "a.safetensors", "--gammas", "1"), "gammas"),
        (("train-inverse", "--out", "a.safetensors", "--steps", "501"), "steps"),
        (("train-inverse", "--out", "a.safetensors", "--gamma-min", "0.99", "--gamma-max", "0.9"), "gamma-min"),
    ],
)
def test_bad_input_is_one_line(capsys, tmp_path, monkeypatch, words, named):
    monkeypatch.chdir(tmp_path)
    assert main([*words]) == 2
    (line,) = capsys.readouterr().err.splitlines()
    assert named in line
    assert list(tmp_path.iterdir()) == []


def test_a_check_that_is_not_met_ends_with_status_1(capsys, tmp_path):
    """A network of one update is further from the truth than Tikhonov."""
    path = tmp_path / "a.safetensors"
    printed(capsys, "train-inverse", "--gammas", "3", "--updates", "1", "--samples", "100", "--out", str(path))
    with pytest.raises(SystemExit) as ended:
        main(["report", "neural", str(path), "--cases", "3", "--check"])
    assert ended.value.code == 1
    assert "at noise 0.001" in capsys.readouterr().err
