"""The section of searches: what ships and what was run here is drawn; a damaged file is one sentence."""

from __future__ import annotations

import json

from app.train.searches import COMMITTED
from laplace_core.experiments.search.results import kept, read
from laplace_core.figures import searches
from tests.support.hostile import assert_one_sentence
from tests.support.pages import run
from tests.support.train_page import opened


def shown(name: str):
    """The page with the section open, at one search."""
    page = opened("searches")
    box = next(each for each in page.selectbox if each.label == "Search")
    if box.value != name:
        box.set_value(name)
        run(page)
    return page


def test_a_search_that_ships_is_drawn_with_its_table(runs):
    page = shown("laplace_LunarLander-v3")
    assert not page.exception
    assert "as in the file" in page.code[0].value
    assert "averaging 0.005" in page.code[0].value
    assert any("Importances need 10 trials; this search has 8." in each.value for each in page.caption)


def test_a_search_that_was_run_here_comes_first_and_a_damaged_one_is_one_sentence(runs):
    for name, text in (("mine", (COMMITTED / "dqn_CartPole-v1.json").read_text()), ("broken", '{"trials": 3}')):
        (runs.folder / name).mkdir()
        (runs.folder / name / "search.json").write_text(text)
    assert set(list(kept(COMMITTED, runs.folder))[:2]) == {"mine, run here", "broken, run here"}
    assert "as in the file" in shown("mine, run here").code[0].value
    page = shown("broken, run here")
    assert_one_sentence(page.error[0].value, "search")
    assert not page.exception


def test_every_search_that_ships_has_its_figures(subtests):
    for path in sorted(COMMITTED.glob("*.json")):
        with subtests.test(path.stem):
            search = read(path)
            study = searches.study_of(search)
            assert [trial.value for trial in study.trials] == [row["median"] for row in search["trials"]]
            course, alone = searches.history(study), searches.slices(study)
            assert list(course["data"][0]["y"]) == [row["median"] for row in search["trials"]]
            assert len(alone["data"]) == min(4, len(study.trials[0].params))
            assert searches.importances(study) is None  # the fewest trials of which they say anything are ten


def test_importances_find_the_setting_that_matters():
    """The score is 100 n_step; the learning rate, drawn evenly on a log scale, has no part in it."""
    rows = [
        {"trial": {"n_step": 1 + i % 5, "learning_rate": 10 ** (-4 + 2 * (7 * i % 20) / 20)}, "median": 100.0 * (i % 5),
         "pruned": False, "reported": {"10": 1.0}}
        for i in range(20)
    ]  # fmt: skip
    space = {"n_step": "1..5", "learning_rate": "0.0001..0.01:log"}
    study = searches.study_of({"trials": [*rows, {**rows[0], "pruned": True}], "settings": {}, "space": space})
    (bars,) = searches.importances(study)["data"]
    shares = dict(zip(bars["y"], bars["x"], strict=True))
    assert shares["n_step"] > 0.8
    assert json.dumps(searches.slices(study)["layout"]).count('"log"') == 1
