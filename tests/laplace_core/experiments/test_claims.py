"""The catalogue of the paper: it has every experiment, and its words follow the numbers."""

from __future__ import annotations

import json
import shlex
import shutil
from pathlib import Path

import numpy as np
import pytest

from laplace_core.cli import main, verbs
from laplace_core.experiments.paper import EXPERIMENTS, MEASUREMENTS, measurement, pictures
from laplace_core.experiments.paper.claims import ENTRIES, STATES, Found, curves, look
from laplace_core.experiments.paper.claims.deadlines import PAPER
from laplace_core.experiments.paper.claims.entry import AGREES, DAMAGED, DIFFERS, IN_PART, MISSING, NEW, Results
from laplace_core.experiments.paper.smoothing import smoothed
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
        "write it again: python -m laplace_core reproduce --document > docs/reproduction.md"
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
    assert "a network 3.0% (2.0 to 4.0%, 3 seeds)" in changed("fig6", near).sentence(2)


def test_a_network_that_is_as_clean_as_a_table_differs():
    def clean(about):
        about["summary"]["network"].update(mean=0.001, low=0.0, high=0.002)

    assert changed("fig6", clean).findings[2].state == DIFFERS


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


def test_rows_left_alone_that_gain_nothing_on_the_lander_differ():
    def nothing(about):
        for column in about["summary"].values():
            if "rescaled mended, alone" in column:
                column["rescaled mended, alone"]["interval"] = [-1.0, 1.0]

    assert shown("table1").findings[2].state == AGREES
    assert changed("table1", nothing).findings[2].state == DIFFERS


@pytest.mark.parametrize(
    ("name", "scores", "states"),
    [
        ("fig7", {"free": [20.0, 30.0], "accumulated": [500.0, 500.0]}, [AGREES, AGREES, None, None]),
        ("fig7", {"free": [500.0, 490.0], "softmax": [500.0], "accumulated": [500.0, 20.0], "clipped": [20.0]},
         [DIFFERS, IN_PART, DIFFERS, NEW]),
        ("table2", {"uniform": [190.0, 200.0], "Gaussian,_std_20": [-90.0], "Gaussian,_std_50": [-200.0]},
         [AGREES, AGREES]),
        ("table2", {"uniform": [190.0, 200.0], "Gaussian,_std_20": [240.0], "Gaussian,_std_50": [230.0]},
         [DIFFERS, DIFFERS]),
        ("table2", {"uniform": [190.0]}, [None, None]),
        ("multiplexer", {"network": [10.0, 100.0], "multiplexer": [150.0, 90.0], "trunk": [250.0]}, [IN_PART, NEW]),
        ("multiplexer", {"network": [200.0], "multiplexer": [150.0]}, [DIFFERS, None]),
        ("auxiliary", {"CartPole,_alone": [300.0], "CartPole,_beside_fourteen": [400.0]}, [AGREES, None]),
        ("termination", {"plain": [240.0], "auxiliary": [230.0], "absorbing": [200.0]}, [None, None, None, NEW]),
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


@pytest.mark.parametrize(("low", "states"), [(2.0, [AGREES, DIFFERS, AGREES]), (-2.0, [DIFFERS, DIFFERS, AGREES])])
def test_acting_through_tau_space_is_judged_by_paired_intervals(low, states):
    row = {
        "mean": 30.0, "agents": 5, "episodes": 100, "against greedy": {"mean": 5.0, "interval": [low, 9.0]},
        "against fading": {"mean": -1.0, "interval": [-3.0, 1.0]},
    }  # fmt: skip
    worse = row | {"against greedy": {"mean": 4.0, "interval": [-9.0, 9.0]}}
    results = Results(Path("x.json"), 1, 2, summary={"T 50": {"neural": row, "fading": row, "tikhonov": worse}})
    assert judged("acting", results) == states
    lines = [line.what for line in BY_NAME["acting"].lines(results)]
    assert lines == ["T 50: tau-space by neural", "T 50: fading", "T 50: tau-space by tikhonov"]


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
    assert Found(entry, results, [], [None, entry.claims[1].judge(results), None, None]).state == IN_PART


@pytest.mark.parametrize(
    ("sure", "coins", "state"), [((3, 29), (90, 50), IN_PART), ((3, 29), (40, 50), AGREES), ((9, 9), (90, 50), DIFFERS)]
)
def test_the_discount_that_is_accurate_first_is_named(sure, coins, state):
    def row(after, played):
        return {"smallest": 0.368, "after": after[0], "largest": 0.99, "its after": after[1], "played": played, "of": 1}

    summary = {"sure": {"32": row(sure, 48)}, "coins": {"1": row((1, 1), 91), "32": row(coins, 91)}}
    results = Results(Path("x.json"), 4, 4, summary=summary)
    assert judged("timescales", results) == [state]
    told = BY_NAME["timescales"].claims[0].judge(results).sentence
    assert f"32 steps from the end, discount 0.368 is within a tenth after {sure[0]} episodes" in told
    assert ("more than 86" in told) == (coins[0] == 90)


# ---- figure 3, and what is read of trainings


def learned(**returns: list[list[float]]) -> Results:
    """Trainings of figure 3 on CartPole with these returns of their episodes, by algorithm and seed."""
    cells = [
        {"label": name, "algorithm": name, "environment": "CartPole-v1", "trainings": [
            {"seed": seed, "each_episode": {
                "episodes": list(range(1, len(each) + 1)), "steps": list(range(len(each))), "returns": each,
            }} for seed, each in enumerate(seeds)
        ]}
        for name, seeds in returns.items()
    ]  # fmt: skip
    return Results(Path("x.json"), 2, 52, "trainings", cells=cells)


def test_curves_over_episodes_improve_where_every_seed_does():
    judge = BY_NAME["fig3"].claims[2].judge
    rising, falling = [float(i) for i in range(20)], [float(-i) for i in range(20)]
    assert judge(learned(laplace=[rising, rising])).state == AGREES
    assert "from 0.50 to 18.5 on CartPole-v1 (2 seeds)" in judge(learned(laplace=[rising, rising])).sentence
    assert judge(learned(laplace=[rising, falling])).state == DIFFERS
    assert judge(learned(dqn=[rising])) is None


@pytest.mark.parametrize(
    ("laplace", "states"),
    [([100.0, 400.0], [AGREES, AGREES, None]), ([100.0, 120.0], [DIFFERS, DIFFERS, None])],
)
def test_the_agents_that_ship_are_compared_with_both_peers(laplace, states):
    scores = {"laplace": laplace, "c51": [300.0, 380.0], "qrdqn": [350.0, 420.0]}
    summary = {"CartPole-v1": {name: {"scores": each, "curves": ()} for name, each in scores.items()}}
    results = Results(Path("x.json"), 0, 52, "trainings", summary=summary)
    assert judged("fig3", results) == states
    found = Found(BY_NAME["fig3"], results, [], [claim.judge(results) for claim in BY_NAME["fig3"].claims])
    assert not found.sentence(0).startswith("So far")  # all that it needs ships
    assert "(0 of 52 trainings done)" in found.sentence(2)


def test_smoothing_is_the_mean_of_neighbours():
    values = np.random.default_rng(0).normal(size=30)
    slow = [np.mean(values[max(0, i - 4) : i + 5]) for i in range(30)]
    np.testing.assert_allclose(smoothed(values, 4), slow)
    np.testing.assert_allclose(smoothed(values, 0), values)


def test_seeds_are_read_at_episodes_that_all_of_them_reached():
    rows = [
        {"episodes": [1, 2, 3, 4], "returns": [0.0, 1.0, 2.0, 3.0]},
        {"episodes": [1, 3], "returns": [0.0, 20.0]},  # the second was played by another discount
    ]
    places, returns = curves.at_episodes(rows, 0)
    assert places.tolist() == [1, 2, 3]
    assert returns.tolist() == [[0.0, 1.0, 2.0], [0.0, 10.0, 20.0]]


def held_out(all_of_them: list[float], every_other: list[float]) -> Results:
    """Readings of networks on CartPole, a number a seed, with three discounts of which the second is held out."""
    cells = []
    for which, errors, kept in (("all fifteen", all_of_them, True), ("every other", every_other, False)):
        rows = [
            {"seed": seed, "reading": {
                "trained": [True, kept, True], "network": [0.0, error, 0.0],
                "line": [None, None if kept else 2.0 * error, None],
            }}
            for seed, error in enumerate(errors)
        ]  # fmt: skip
        cells.append({"label": f"CartPole, network, {which}", "trainings": rows})
    return Results(Path("x.json"), len(all_of_them), 24, "trainings", cells=cells)


@pytest.mark.parametrize(
    ("all_of_them", "every_other", "state"),
    [([0.01, 0.03], [0.02, 0.02], AGREES), ([0.01, 0.03], [0.02, 0.06], IN_PART), ([0.01, 0.03], [0.05], DIFFERS)],
)
def test_values_at_held_out_discounts_are_compared_with_trained_ones(all_of_them, every_other, state):
    results = held_out(all_of_them, every_other)
    assert judged("interpolation", results) == [state, None, NEW]
    assert BY_NAME["interpolation"].lines(results)[1].ours.startswith(f"{np.mean(every_other):g} (")
    assert pictures.picture(Found(BY_NAME["interpolation"], results, [], [])).figure["data"]


def endings(**returns: tuple[float, float]) -> Results:
    """Readings of three seeds each: mean return with rescaled rows and with rows left alone, the same at every T."""
    noise = np.random.default_rng(0).normal(size=(3, 10))
    cells = [
        {"label": ending, "trainings": [
            {"seed": seed, "best": {"score": 200.0}, "reading": {
                f"T {horizon}": {
                    "greedy": {"returns": [0.0] * 10},
                    "rescaled": {"returns": list(rescaled + noise[seed] * scale)},
                    "left alone": {"returns": list(alone + noise[seed] * scale)},
                }
                for horizon in (50, 100, 200)
            }}
            for seed in range(3)
        ]}
        for (ending, (rescaled, alone)), scale in zip(returns.items(), (1.0, 1.1, 0.9), strict=False)
    ]  # fmt: skip
    return Results(Path("x.json"), 3 * len(returns), 9, "trainings", cells=cells)


@pytest.mark.parametrize(
    ("auxiliary", "states"),
    [
        ((60.0, 50.0), [AGREES, AGREES]),  # repairs rescaled rows, and changes nothing else
        ((20.0, 50.0), [DIFFERS, AGREES]),
        ((60.0, 80.0), [AGREES, DIFFERS]),
    ],
)
def test_auxiliary_states_are_judged_by_both_readings(auxiliary, states):
    results = endings(plain=(20.0, 50.0), auxiliary=auxiliary, absorbing=(20.0, 50.0))
    assert judged("termination", results) == [*states, NEW, NEW]
    lines = {line.what: line.ours for line in BY_NAME["termination"].lines(results)}
    assert lines["T 50, rows left alone: plain"].endswith("3 agents x 10")
    assert pictures.picture(Found(BY_NAME["termination"], results, [], [])).figure["data"]


def test_the_searches_that_are_kept_are_counted():
    found = shown("search")
    assert [finding.state for finding in found.findings] == [NEW, AGREES, NEW]
    files = list((ROOT / "docs" / "searches").glob("*.json"))
    assert found.sentence(0).startswith(f"{len(files)} searches are kept, with ")
    assert {line.what for line in found.lines} >= {"C51, atoms", "QR-DQN, exploration", "Laplace DQN, thetas"}


def test_a_search_that_takes_as_long_on_the_lander_differs():
    trial = {"trial": {}, "scores": [1.0], "median": 1.0, "seconds": 60.0}
    rows = [{"file": "c51_x.json", "settings": {"environment": name}, "seeds": 1, "one_at_a_time": True,
             "trials": [trial]} for name in ("LunarLander-v3", "CartPole-v1")]  # fmt: skip
    assert judged("search", Results(Path("x"), 2, 2, "searches", rows=rows)) == [NEW, DIFFERS, None]
