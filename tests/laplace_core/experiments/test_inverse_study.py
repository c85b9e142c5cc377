"""The study of solvers and selectors: its table, how it goes on, and its sums."""

from __future__ import annotations

import csv
import json
import re
from dataclasses import replace

import numpy as np
import pytest

from laplace_core import InputError, Settings, load_world, study
from laplace_core.cli import main
from laplace_core.experiments.inverse.measuring import command_of, measuring, plan_of
from laplace_core.experiments.inverse.random_cases import random_case
from laplace_core.experiments.inverse.selection import (
    COLUMNS,
    Job,
    Plan,
    gammas_of,
    rows_of,
    run,
    seconds_to_measure,
)
from laplace_core.experiments.inverse.selection_report import summed
from laplace_core.experiments.inverse.table_file import TableFile
from laplace_core.figures.inverse_study import behind_the_best
from laplace_core.inverse import SELECTORS, choose_alpha, solve
from laplace_core.inverse.distances import choice_regret, mean_time_distance

SMALL = Plan(cases=2, noises=(1e-3,), grids=("log", "paper"), solvers=("tikhonov",), selectors=("gcv", "quasiopt"))
WORDS = ["study", "--worlds", "2", "--noise", "1e-3", "--grids", "log,paper", "--solvers", "tikhonov", "--selectors",
         "gcv,quasiopt"]  # fmt: skip


def test_a_row_is_what_the_parts_say():
    job = Job(1, 1e-3, "log")
    rows = rows_of(job, SMALL)
    assert [row["selector"] for row in rows] == ["best", "gcv", "quasiopt"]
    case = random_case(np.random.default_rng([0, 1]))
    problem = case.problem(1e-3, seed=1, gammas=gammas_of("log"))
    alpha = choose_alpha(problem, "tikhonov", "gcv").value
    masses = solve(problem, "tikhonov", alpha).masses
    assert rows[1]["alpha"] == alpha
    distance = mean_time_distance(masses, case.masses, case.settings.time_step).mean()
    assert rows[1]["distance"] == pytest.approx(distance, rel=1e-9)
    regret = choice_regret(case.values_of(masses @ case.worth), case.values_of(case.rewards))
    assert rows[1]["regret"] == pytest.approx(regret, abs=1e-12)
    assert all(row["distance"] >= row["least"] for row in rows)
    assert rows[0]["distance"] == rows[0]["least"]


@pytest.mark.parametrize("solver", ["tikhonov1", "tsvd", "nonnegative"])
def test_every_solver_has_the_distance_and_regret_of_its_solution(solver):
    """Linear solvers are measured by components; the slow twin decodes the masses."""
    plan = Plan(cases=1, noises=(1e-2,), grids=("paper",), solvers=(solver,), selectors=("fitted",))
    for number in (0, 2, 5):
        case = random_case(np.random.default_rng([0, number]))
        problem = case.problem(1e-2, seed=number, gammas=gammas_of("paper"))
        for row in rows_of(Job(number, 1e-2, "paper"), plan):
            masses = solve(problem, solver, row["alpha"]).masses
            distance = mean_time_distance(masses, case.masses, case.settings.time_step).mean()
            assert row["distance"] == pytest.approx(distance, rel=1e-9)
            values = case.values_of(masses @ case.worth)
            assert row["regret"] == pytest.approx(choice_regret(values, case.values_of(case.rewards)), abs=1e-12)


def test_a_study_is_gone_on_with_where_it_was_stopped(tmp_path):
    whole, parts = tmp_path / "whole.csv", tmp_path / "parts.csv"
    assert list(run(SMALL, whole))[-1] == (4, 4)
    measured = run(SMALL, parts)
    assert [next(measured) for _ in range(3)] == [(0, 4), (1, 4), (2, 4)]
    measured.close()
    with parts.open("ab") as file:  # killed in the middle of a write
        file.write(b"1,0.001,log,tikhonov,gcv,0.")
    assert next(run(SMALL, parts)) == (2, 4)
    assert list(run(SMALL, parts))[-1] == (4, 4)
    assert parts.read_bytes() == whole.read_bytes()
    assert list(run(SMALL, parts)) == [(4, 4)]


def test_a_file_of_something_else_is_left_alone(tmp_path, subtests):
    other = tmp_path / "other.csv"
    for content in (b"", b"a,b\n1,2\n", b"# seed 1\n", b"\xff\xfe"):
        with subtests.test(content=content):
            other.write_bytes(content)
            with pytest.raises(InputError, match="no table of a study like this one"):
                list(run(SMALL, other))
            assert other.read_bytes() == content
    list(run(SMALL, tmp_path / "mine.csv"))
    with pytest.raises(InputError, match="of other solvers or selectors"):
        list(run(Plan(cases=1, noises=(1e-3,), grids=("log",), solvers=("tikhonov",), selectors=("gcv",)),
                 tmp_path / "mine.csv"))  # fmt: skip


def test_sums_are_medians_and_shares(tmp_path):
    table = TableFile(tmp_path / "t.csv", COLUMNS, ("case", "noise", "grid"), about="seed 0")
    for case, (distance, regret) in enumerate([(2.0, 0.1), (2.6, 0.0), (8.0, 0.3)]):
        row = dict.fromkeys(COLUMNS, 0) | {"case": case, "solver": "tikhonov", "selector": "gcv", "grid": "log"}
        table.append([row | {"distance": distance, "least": 2.0, "regret": regret, "regret_at_least": 0.1}])
    (entry,) = summed(table.rows())
    # Ratios 1, 1.3 and 4: two are at most 1.3. Excess regret 0, -.1 and .2.
    assert entry["near"] == pytest.approx(2 / 3)
    assert entry["ratio"]["median"] == pytest.approx(1.3)
    assert entry["excess"]["median"] == pytest.approx(0.0)
    assert entry["excess"]["nine tenths"] == pytest.approx(0.16)  # .8 of the way from 0 to .2


def test_the_command_writes_a_table_and_sums_it_up(tmp_path, capsys):
    path = tmp_path / "study.csv"
    assert main([*WORDS, "--out", str(path), "--json", "--jobs", "2"]) == 0
    entries = json.loads(capsys.readouterr().out)
    assert [(entry["solver"], entry["selector"], entry["cases"]) for entry in entries] == [
        ("tikhonov", "best", 4), ("tikhonov", "gcv", 4), ("tikhonov", "quasiopt", 4)
    ]  # fmt: skip
    with path.open() as file:
        assert len(list(csv.reader(line for line in file if line.strip()))) == 2 + 4 * 3
    assert main(["study", "--summary", "--out", str(path), "--by", "grid,selector"]) == 0
    assert "paper" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (["--solvers", "magic"], "solver 'magic' is not one of"),
        (["--selectors", "gcv,gcv"], "name each selector of the study once"),
        (["--grids", ""], "grid '' is not one of"),
        (["--noise", "0"], "the noise of a study must be numbers above 0"),
        (["--worlds", "0"], "worlds must be"),
        (["--by", "alpha"], "--by takes noise, grid, solver and selector"),
        (["--summary"], "run the study first"),
    ],
)
def test_bad_words_are_one_sentence_and_write_nothing(tmp_path, capsys, words, sentence):
    assert main(["study", "--out", str(tmp_path / "no.csv"), *words]) == 2
    assert sentence in capsys.readouterr().err
    assert not list(tmp_path.iterdir())


def test_a_listed_world_is_studied_as_its_page_shows_it_with_one_draw_of_noise_after_another():
    plan = Plan(cases=2, noises=(1e-3,), grids=("paper",), solvers=("tikhonov",), selectors=("gcv",), seed=5,
                worlds=("fig6_chain", "random"))  # fmt: skip
    assert [job.case for job in plan.jobs()] == ["fig6_chain:0", "fig6_chain:1", 0, 1]
    assert plan.size == len(plan.jobs())
    shown = study(load_world("fig6_chain"), Settings(spacing="paper", noise=1e-3, noise_seed=6, selector="gcv",
                                                     noise_level=1e-3))  # fmt: skip
    (_, row) = rows_of(plan.jobs()[1], plan)  # its seed is that of the plan and the number of the draw
    assert row["alpha"] == pytest.approx(shown.settings.alpha, rel=1e-9)
    assert rows_of(plan.jobs()[3], plan)[1]["alpha"] == rows_of(Job(1, 1e-3, "paper"), plan)[1]["alpha"]


def test_an_estimate_counts_cases_solvers_and_selectors():
    one = Plan(cases=10, noises=(1e-3,), grids=("paper",), solvers=("tikhonov",), selectors=("gcv",))
    assert seconds_to_measure(replace(one, cases=40)) == pytest.approx(4 * seconds_to_measure(one))
    assert seconds_to_measure(replace(one, worlds=("random", "two_branch"))) == pytest.approx(
        2 * seconds_to_measure(one)
    )
    assert seconds_to_measure(replace(one, solvers=("feasible",))) > 10 * seconds_to_measure(one)
    assert seconds_to_measure(replace(one, selectors=("gcv", "aic"))) > seconds_to_measure(one)


class Stopped(Exception):
    pass


def test_what_was_measured_beside_a_server_stays_when_it_is_stopped_and_is_gone_on_with(tmp_path):
    plan = plan_of({"cases": 12, "grids": "log", "noises": "1e-3", "solvers": "tikhonov", "selectors": "gcv"})
    measured, seen = measuring(plan), []
    assert measuring(plan) is measured

    def until_some(done, of):
        seen.append((done, of))
        if done:
            raise Stopped

    with pytest.raises(Stopped):
        measured.measure(until_some)
    first = measured.done
    assert 0 < first < plan.size
    assert seen[0] == (0, 12)
    assert measured.sums()[0]["cases"] == first
    measured.measure(lambda done, of: seen.append((done, of)))
    assert measured.done == plan.size
    list(run(plan, tmp_path / "whole.csv"))
    assert measured.table == (tmp_path / "whole.csv").read_text()
    assert [entry["selector"] for entry in measured.sums()] == ["best", "gcv"]


def test_the_command_of_a_plan_is_its_plan(tmp_path):
    plan = plan_of({"worlds": "random,two_branch", "cases": 1, "noises": "0.0125, 1e-5", "selectors": "aic",
                    "solvers": "tsvd", "grids": "log", "seed": 7})  # fmt: skip
    assert main([*command_of(plan, str(tmp_path / "a.csv")), "--json"]) == 0
    list(run(plan, tmp_path / "b.csv"))
    assert (tmp_path / "a.csv").read_text() == (tmp_path / "b.csv").read_text()


@pytest.mark.parametrize(
    ("given", "sentence"),
    [
        ({"noises": "0.1,x"}, "noise 'x' is not a number"),
        ({"noises": ""}, "must be numbers above 0"),
        ({"noises": "0"}, "must be numbers above 0"),
        ({"noises": "nan"}, "noise 'nan' is not a number"),
        ({"worlds": ""}, "name each world of the study once, and at least one"),
        ({"worlds": "../../etc/passwd"}, "is not one of random, two_branch"),
        ({"worlds": "own.json"}, "is not one of random, two_branch"),
        ({"solvers": "neural"}, "the neural inverse takes no random world"),
        ({"solvers": "tsvd,tsvd"}, "name each solver of the study once"),
        ({"cases": 1000, "selectors": ",".join(SELECTORS)}, "a page takes 20,000"),
        ({"cases": 1000, "noises": ",".join(f"0.{i:04d}" for i in range(1, 900))}, "a page takes 20,000"),
    ],
)
def test_a_study_that_makes_no_sense_is_refused_in_one_sentence(given, sentence):
    with pytest.raises(InputError, match=re.escape(sentence)):
        plan_of(given)


def test_the_picture_has_a_dot_and_a_line_for_every_solver_and_rule():
    spread = {"median": 1.5, "nine tenths": 4.0, "mean": 2.0}
    sums = [{"solver": solver, "selector": rule, "cases": 3, "ratio": spread, "excess": spread | {"median": 5.0}}
            for solver in ("tikhonov", "tsvd") for rule in ("gcv", "aic")]  # fmt: skip
    titles = {name: name.upper() for name in ("tikhonov", "tsvd", "gcv", "aic")}
    figure = behind_the_best(sums, "ratio", titles, titles)
    assert [trace["name"] for trace in figure["data"]] == ["TIKHONOV", "TSVD"]
    np.testing.assert_array_equal(figure["data"][0]["error_x"]["array"], [2.5, 2.5])
    heights = np.array([trace["y"] for trace in figure["data"]])
    assert np.unique(heights).size == 4
    np.testing.assert_array_equal(np.rint(heights), [[0, 1], [0, 1]])
    assert figure["layout"]["yaxis"]["ticktext"] == ["GCV", "AIC"]
    at_most = behind_the_best(sums, "excess", titles, titles)["data"][0]["error_x"]["array"]
    np.testing.assert_array_equal(at_most, [0.0, 0.0])  # a line never points backwards
