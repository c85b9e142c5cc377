"""The catalogue of the paper: it has every experiment, and its words follow the numbers."""

from __future__ import annotations

import json
import shlex
import shutil
from pathlib import Path

import pytest

from laplace_core.cli import main, verbs
from laplace_core.experiments.paper import EXPERIMENTS, MEASUREMENTS, measurement
from laplace_core.experiments.paper.claims import ENTRIES, STATES, Found, look
from laplace_core.experiments.paper.claims.deadlines import PAPER
from laplace_core.experiments.paper.claims.entry import AGREES, DAMAGED, DIFFERS, IN_PART, MISSING, NEW, Results
from tests.support.hostile import assert_refused

ROOT = Path(__file__).resolve().parents[3]
COMMITTED, AGENTS = ROOT / "docs" / "paper", ROOT / "checkpoints"
BY_NAME = {entry.name: entry for entry in ENTRIES}
FILES = sorted(COMMITTED.glob("*.json"))


def shown(name: str, folder: Path = COMMITTED) -> Found:
    return look(BY_NAME[name], folder, AGENTS)


def committed(name: str) -> dict:
    return json.loads((COMMITTED / f"{name}.json").read_text())


def judged(name: str, results: Results) -> list[str | None]:
    """The state of each claim."""
    return [finding and finding.state for finding in (claim.judge(results) for claim in BY_NAME[name].claims)]


def trained(**scores: list[float]) -> Results:
    """Finished trainings with these scores, by the label of a cell, ``_`` for a space; each learned at an even pace."""
    cells = [
        {"label": label.replace("_", " "), "trainings": [
            {"best": {"score": score}, "evaluations": {"scores": [0.0, score]}} for score in each
        ]}
        for label, each in scores.items()
    ]  # fmt: skip
    return Results(Path("x.json"), 1, 1, "trainings", cells=cells)


# ---- the catalogue is whole


def test_every_experiment_has_an_entry():
    assert {*EXPERIMENTS, *MEASUREMENTS} <= set(BY_NAME)
    assert len(BY_NAME) == len(ENTRIES)


def test_every_command_is_one():
    for entry in ENTRIES:
        words = shlex.split(entry.makes.removeprefix("python -m laplace_core "))
        assert verbs.parser().parse_args(words).verb in ("reproduce", "report")
        if not entry.command:
            assert words[1] in {*EXPERIMENTS, *MEASUREMENTS}


@pytest.mark.parametrize("name", ["table1", "table2", "fig3"])
def test_the_numbers_of_the_paper_stand_also_where_nothing_is_measured(name, tmp_path):
    told = {line.paper for line in look(BY_NAME[name], tmp_path, tmp_path).lines}
    numbers = {
        "table1": {f"{value:.2f}" for row in PAPER.values() for value in row.values()},
        "table2": {"188.45", "-90.22", "-203.77"},
        "fig3": {"161.63 (v2)", "224.71 (v2)", "188.45 (v2)"},
    }
    assert numbers[name] <= told


# ---- the committed results


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_every_committed_file_has_a_finding(path):
    found = shown(path.stem)
    assert found.trouble is None
    assert found.state in STATES.keys() - {DAMAGED}
    assert any(line.ours for line in found.lines) or not found.results.finished
    if found.results.complete:
        assert None not in found.findings


@pytest.mark.parametrize("name", ["fig1_5", "fig4", "fig6", "aliasing"])
def test_a_committed_summary_is_what_its_rows_say(name):
    about = committed(name)
    assert measurement(name).summary(about["results"]) == about["summary"]


def test_the_document_says_what_the_results_say(monkeypatch, capsys):
    monkeypatch.chdir(ROOT)
    assert main(["reproduce", "--document"]) == 0
    now = capsys.readouterr().out
    assert now == (ROOT / "docs" / "reproduction.md").read_text(encoding="utf-8"), (
        "write it anew: python -m laplace_core reproduce --document > docs/reproduction.md"
    )


def test_the_document_is_about_all_of_them(capsys):
    assert_refused(capsys, ["reproduce", "fig4", "--document"], "--document")
    assert_refused(capsys, ["reproduce", "--document", "--json"], "--json")


# ---- words follow the numbers


def changed(name: str, change) -> Found:
    """A committed result with something in it changed."""
    about = committed(name)
    change(about)
    results = Results(
        Path("x.json"), about["finished"], about["planned"], cells=about.get("cells", ()),
        rows=about.get("results", ()), summary=about.get("summary", {}),
    )  # fmt: skip
    entry = BY_NAME[name]
    return Found(entry, results, entry.lines(results), [claim.judge(results) for claim in entry.claims])


def test_the_toy_mdp_agrees_where_rescaled_rows_alone_choose_wrongly():
    found = shown("fig4")
    assert [finding.state for finding in found.findings] == [AGREES, AGREES, DIFFERS]
    assert found.state == IN_PART
    assert "14.85" in found.sentence(0)
    assert "rescaled" in found.sentence(2)


def test_the_cause_is_not_named_where_rows_left_alone_choose_wrongly_too():
    def wrong(about):
        for name, each in about["summary"].items():
            if name.endswith("plain, rows none"):
                each["right"] = 0

    found = changed("fig4", wrong)
    assert found.findings[2].state == AGREES
    assert "cause" not in found.sentence(2)
    assert found.state == AGREES


def test_a_chain_that_a_network_holds_agrees():
    def near(about):
        about["summary"]["network"].update(mean=0.03, low=0.02, high=0.04)

    assert changed("fig6", near).state == AGREES
    assert "3.0%" in changed("fig6", near).sentence(1)


def test_codes_that_other_codes_tell_apart_as_well_agree_in_part():
    def told(about):
        about["summary"]["quantile"]["right"] = 48.0

    assert changed("aliasing", told).findings[0].state == IN_PART
    assert "100% of any other (quantile)" in changed("aliasing", told).sentence(0)


def test_a_deadline_that_a_peer_acts_better_for_agrees_with_the_paper():
    def better(about):
        for name, column in about["summary"].items():
            if name.startswith("LunarLander"):
                column["dqn, greedy"]["mean"] = 900.0

    found = changed("table1", better)
    assert found.findings[0].state == AGREES
    assert "best peer DQN, 900.0" in found.sentence(0)


@pytest.mark.parametrize(
    ("name", "scores", "states"),
    [
        ("fig7", {"free": [20.0, 30.0], "accumulated": [500.0, 500.0]}, [AGREES, AGREES, None]),
        ("fig7", {"free": [500.0, 490.0], "softmax": [500.0], "accumulated": [500.0, 20.0]}, [DIFFERS, IN_PART, NEW]),
        ("table2", {"uniform": [190.0, 200.0], "Gaussian,_std_20": [-90.0], "Gaussian,_std_50": [-200.0]},
         [AGREES, AGREES]),
        ("table2", {"uniform": [190.0, 200.0], "Gaussian,_std_20": [240.0], "Gaussian,_std_50": [230.0]},
         [DIFFERS, DIFFERS]),
        ("table2", {"uniform": [190.0]}, [None, None]),
        ("multiplexer", {"network": [10.0, 100.0], "multiplexer": [150.0, 90.0], "trunk": [250.0]}, [IN_PART, NEW]),
        ("multiplexer", {"network": [200.0], "multiplexer": [150.0]}, [DIFFERS, None]),
        ("auxiliary", {"CartPole,_alone": [300.0], "CartPole,_beside_fourteen": [400.0]}, [AGREES, None]),
        ("termination", {"plain": [240.0], "auxiliary": [230.0], "absorbing": [200.0]}, [DIFFERS, NEW]),
        ("paper_agent", {"CartPole": [500.0, 300.0], "LunarLander": [20.0]}, [IN_PART, DIFFERS]),
        ("new_agents", {"averaging_.005": [239.0, 270.0]}, [NEW]),
    ],
)  # fmt: skip
def test_trainings_are_judged_by_their_scores(name, scores, states):
    results = trained(**scores)
    assert judged(name, results) == states
    for finding in filter(None, (claim.judge(results) for claim in BY_NAME[name].claims)):
        assert finding.sentence.endswith(".")


def test_seeds_below_the_floor_are_counted():
    judge = BY_NAME["new_agents"].claims[0].judge
    assert "none of them below" in judge(trained(x=[250.0])).sentence
    assert "1 of them below" in judge(trained(x=[250.0, 9.0])).sentence


@pytest.mark.parametrize(("low", "states"), [(2.0, [AGREES, DIFFERS]), (-2.0, [DIFFERS, DIFFERS])])
def test_acting_through_tau_space_is_judged_by_paired_intervals(low, states):
    row = {
        "mean": 30.0, "agents": 5, "episodes": 100, "against greedy": {"mean": 5.0, "interval": [low, 9.0]},
        "against fading": {"mean": -1.0, "interval": [-3.0, 1.0]},
    }  # fmt: skip
    results = Results(Path("x.json"), 1, 2, summary={"T 50": {"neural": row, "fading": row}})
    assert judged("acting", results) == states
    assert [line.what for line in BY_NAME["acting"].lines(results)] == ["T 50: tau-space by neural", "T 50: fading"]


# ---- what is missing, in part or damaged


def test_what_is_missing_says_what_measures_it(tmp_path):
    for name, how_much in (("table2", "0 of 12 trainings"), ("fig4", "none")):
        found = shown(name, tmp_path)
        assert found.state == MISSING
        assert found.sentence(0) == f"Not measured yet: python -m laplace_core reproduce {name} ({how_much} done)."


def test_what_is_there_in_part_says_how_much(tmp_path):
    about = committed("fig4") | {"planned": 11}
    (tmp_path / "fig4.json").write_text(json.dumps(about))
    assert shown("fig4", tmp_path).sentence(0).startswith("So far (9 of 11 parts): With rescaled rows")
    (tmp_path / "fig4.json").write_text(json.dumps(about | {"summary": {}}))
    assert shown("fig4", tmp_path).sentence(0).endswith("(9 of 11 parts done).")


def damages(about: dict) -> list[str]:
    """Texts in the place of a file: cut short, none at all, and each of its entries replaced."""
    whole = json.dumps(about)
    broken = [whole[: len(whole) // 2], "", "[]", "null", "{}", whole.replace("0", "NaN", 1)]
    for name in ("finished", "planned", "cells", "results", "summary"):
        if name in about:
            broken += [json.dumps(about | {name: other}) for other in (None, "x", 3.5, [1], [{}])]
    return broken


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_a_damaged_file_is_one_sentence(path, tmp_path):
    for text in damages(json.loads(path.read_text())):
        (tmp_path / path.name).write_text(text)
        found = shown(path.stem, tmp_path)
        for index in range(len(found.findings)):
            assert found.sentence(index).endswith(".")
        if found.trouble is not None:
            assert found.state == DAMAGED
            assert path.name in found.trouble
            assert str(tmp_path) not in found.trouble


def test_a_damaged_manifest_of_agents_is_one_sentence(tmp_path):
    (tmp_path / "manifest.json").write_text('[{"file": "laplace_CartPole-v1.safetensors"}]')
    found = look(BY_NAME["fig3"], COMMITTED, tmp_path)
    assert found.state == DAMAGED
    assert "manifest.json" in found.trouble


def test_one_damaged_file_leaves_the_others_as_they_are(tmp_path):
    folder = shutil.copytree(COMMITTED, tmp_path / "paper")
    (folder / "fig4.json").write_text("{")
    states = {entry.name: look(entry, folder, AGENTS).state for entry in ENTRIES}
    assert states.pop("fig4") == DAMAGED
    assert states == {name: shown(name).state for name in states}


def test_a_claim_without_a_finding_makes_an_entry_one_in_part():
    entry, results = BY_NAME["fig7"], trained(accumulated=[500.0])
    assert Found(entry, results, [], [None, entry.claims[1].judge(results), None]).state == IN_PART
