"""The reports on the inverse run, print what they count, and notice what falls short."""

import json

import pytest

from laplace_core.cli import main
from laplace_core.experiments.inverse import alarms, bumps, certificates, timelines


@pytest.mark.long
def test_certificates(capsys):
    assert main(["report", "inverse-certificates", "--cases", "2", "--json"]) == 0
    rows = json.loads(capsys.readouterr().out)["rows"]
    assert [row["noise"] for row in rows] == list(certificates.NOISES)
    assert all(row["wrong"] <= row["claimed"] <= row["cases"] == 2 for row in rows)


def test_bumps_print_a_class_a_line():
    numbers, text = bumps.report(4, 1)
    assert sum(row["bumps"] for row in numbers["rows"]) == numbers["bumps"]
    assert len(text.splitlines()) == 2 + len(numbers["rows"])


def test_what_falls_short_is_named():
    row = {"noise": 1e-4, "cases": 100, "claimed": 50, "wrong": 1, "clear": 80, "clear_claimed": 40, "missed": 0}
    assert certificates.shortfalls({"rows": [row]}) == []
    assert certificates.shortfalls({"rows": [row | {"wrong": 2}]}) == ["wrong claims at 0.0001"]
    assert certificates.shortfalls({"rows": [row | {"clear_claimed": 39}]}) == ["claims at 0.0001"]
    found = {"kind": "consistent", "noise_known": False, "noise": 1e-3, "cases": 100, "alarms": 7, "blamed": 0}
    assert alarms.shortfalls({"rows": [found]}) == []
    assert alarms.shortfalls({"rows": [found | {"alarms": 8}]}) == ["false alarms, noise estimated"]
    made = {"low": 0.2, "high": 0.4, "bumps": 100, "predicted": 0.3, "real": 0.34}
    assert bumps.shortfalls({"rows": [made]}) == []
    assert bumps.shortfalls({"rows": [made | {"real": 0.36}]}) == ["0.2 to 0.4"]
    solved = {"world": "w", "measure": "reward", "noise": 1e-2, "kkt": 1e-7, "violated": 1e-9}
    assert timelines.shortfalls({"rows": [solved]}) == []
    assert timelines.shortfalls({"rows": [solved | {"kkt": 1e-5}]}) == ["w at 0.01"]


def test_a_check_that_falls_short_ends_with_status_1(monkeypatch, capsys):
    monkeypatch.setattr(certificates, "LEAST_DECIDED", 1.1)
    with pytest.raises(SystemExit) as ended:
        main(["report", "inverse-certificates", "--cases", "2", "--seed", "3", "--check"])
    assert ended.value.code == 1
    assert "not reached" in capsys.readouterr().err
