"""Feasible timelines against Tikhonov's best: the report's numbers, and who falls short of what is demanded."""

from __future__ import annotations

import pytest

from laplace_core.experiments.inverse import timelines


@pytest.fixture(scope="module")
def made():
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(timelines, "PRESETS", ("fig6_chain",))
        patch.setattr(timelines, "ROWS", 20)
        patch.setattr(timelines, "THETAS", 12)
        patch.setattr(timelines, "NOISES", (1e-3,))
        return timelines.report(1, 0)


def test_a_feasible_timeline_of_the_chain_is_nearer_than_tikhonovs_best(made):
    numbers, text = made
    for row in numbers["rows"]:
        assert row["feasible_best"] <= row["feasible"] < row["tikhonov"]
        assert row["tikhonov"] <= row["auto"]["tikhonov"]  # auto does not know the truth
    row, _ = numbers["rows"]
    assert row["feasible"] < row["tikhonov"]
    assert row["kkt"] <= timelines.MOST_KKT
    assert row["violated"] <= timelines.MOST_VIOLATED
    assert timelines.shortfalls(numbers) == []
    assert "fig6_chain" in text
    assert "not below" not in text


def test_what_breaks_a_constraint_falls_short(made):
    numbers, _ = made
    row, _ = numbers["rows"]
    for name, value in (("kkt", 2e-6), ("violated", 2e-8)):
        assert timelines.shortfalls({"rows": [{**row, name: value}]}) == ["fig6_chain at 0.001"]
