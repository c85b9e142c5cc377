"""Who may do what with a run on a shared server, what the server grants, and what its page says of it."""

from __future__ import annotations

import hashlib
import re
from pathlib import Path

import pytest

from app.catalogue import training_runs
from app.session import owner
from laplace_core import InputError
from laplace_core.parameters import schema_of
from laplace_core.supervise.limits import ENVIRONMENTS, Limits, limits
from laplace_core.training.job import owner_of
from laplace_core.training.queue import STOPPED
from tests.support.hostile import assert_one_sentence
from tests.support.pages import downloads, labels, press, run, session, wait
from tests.support.quick_runs import SMALL, states
from tests.support.train_page import FORM, NAME, made, opened, with_cookie

MINE, OTHER = "a" * 43, "b" * 43


@pytest.fixture
def granted(monkeypatch):
    """Set variables of the server."""

    def grant(**variables: str) -> None:
        for name, value in variables.items():
            monkeypatch.setenv(f"LAPLACE_{name.upper()}", value)
        limits.cache_clear()

    yield grant
    monkeypatch.undo()
    limits.cache_clear()


def begun(monkeypatch) -> None:
    """A run that this browser has started."""
    with_cookie(monkeypatch, MINE)
    press(opened(**FORM), "Start training")


def test_another_browser_sees_a_run_and_can_do_nothing_with_it(runs, monkeypatch):
    begun(monkeypatch)
    wait(opened(), lambda page: states(runs)[NAME] == "training")
    made(runs, "nobodys")
    assert "Cancel" in labels(opened())
    saved = downloads(monkeypatch)
    opened(f"more_{NAME}")
    assert saved
    saved.clear()
    for word in (OTHER, None):
        with_cookie(monkeypatch, word)
        page = opened(f"more_{NAME}")
        assert "Cancel" not in labels(page)
        assert page.button(key=f"show {NAME}")
        assert "Started in another browser." in [caption.value for caption in page.caption]
        assert not [name for name in saved if name.startswith(NAME)]
    page = opened("more_nobodys")
    assert "Resume" in labels(page)  # a run from the command line is everybody's
    assert "Remove ..." in labels(page)


def test_what_the_page_does_not_offer_is_refused_as_well(runs, monkeypatch):
    """A button that the page of another browser once had, or a callback that somebody sends by hand."""
    begun(monkeypatch)
    wait(opened(), lambda page: states(runs)[NAME] == "training")
    page = opened()
    session(page).parts[owner._Owner].word = OTHER
    page.button(key=f"cancel {NAME}").click()
    run(page)
    assert states(runs)[NAME] == "training"
    assert [note.value for note in page.toast if "another browser" in note.value]
    session(page).parts[owner._Owner].word = MINE
    press(run(page), "Cancel")
    wait(page, lambda page: states(runs)[NAME] == STOPPED)


def test_a_browser_keeps_its_runs_over_a_reload_and_a_restart_of_the_server(runs, monkeypatch):
    begun(monkeypatch)
    training_runs._queue.cache_clear()  # another server on the same folder
    press(wait(opened(), lambda page: "Cancel" in labels(page)), "Cancel")
    page = wait(opened(), lambda page: "Resume" in labels(page))
    assert "Cancel" not in labels(page)
    assert states(runs)[NAME] == STOPPED


def test_the_word_of_a_browser_is_in_no_file_and_no_link(runs, monkeypatch):
    begun(monkeypatch)
    assert owner_of(runs.folder / NAME) == hashlib.sha256(MINE.encode()).hexdigest()
    for path in (runs.folder / NAME).rglob("*"):
        assert MINE.encode() not in path.read_bytes()
    assert MINE not in str(dict(opened().query_params))


def test_a_word_that_no_browser_was_given_is_not_taken(subtests, monkeypatch):
    for told in ("", "x", "a" * 42, "a" * 44, "a" * 42 + " ", None, 7, ["a" * 43]):
        with subtests.test(told=told):
            assert not owner._is_word(told)
    assert owner._is_word(MINE)
    with_cookie(monkeypatch, "nonsense")
    first, second = owner._known_or_new(), owner._known_or_new()
    assert owner._is_word(first)
    assert first != second


def test_where_owners_do_not_count_everybody_may_do_everything(runs, monkeypatch, granted):
    granted(owners="false")
    begun(monkeypatch)
    assert owner_of(runs.folder / NAME) is None
    with_cookie(monkeypatch, OTHER)
    wait(opened(), lambda page: "Cancel" in labels(page))


def test_a_server_that_only_shows_offers_and_does_nothing(runs, monkeypatch, granted):
    made(runs, "one")
    granted(read_only="true")
    before = {path: path.stat().st_mtime_ns for path in runs.folder.rglob("*")}
    page = opened("more_one", "server")
    assert "does not start new ones" in page.info[0].value
    assert not {"Start training", "Resume", "Cancel", "Remove ..."} & set(labels(page))
    assert any("LAPLACE_READ_ONLY" in caption.value for caption in page.caption)
    for act in ("stop", "resume", "remove", "end_at_once"):
        with pytest.raises(InputError) as refused:
            training_runs.change(act, "one")
        assert_one_sentence(str(refused.value))
    with pytest.raises(InputError) as refused:
        training_runs.queue().add(SMALL)
    assert_one_sentence(str(refused.value), "only shows")
    assert {path: path.stat().st_mtime_ns for path in runs.folder.rglob("*")} == before


def test_the_queue_of_the_page_keeps_the_limits(runs, monkeypatch, granted):
    granted(trainings="1", environments="two_branch,CartPole-v1", disk="7")
    page = opened("server", **FORM)
    assert len(page.selectbox(key="environment").options) == 2
    table = next(block.value for block in page.markdown if "LAPLACE_TRAININGS" in block.value)
    assert re.search(r"Training runs at once \| 0  ?\| 1 ", table)
    assert re.search(r"Disk of all runs \| 0 MB \| 7 MB", table)
    page = press(opened(environment="gym:Taxi-v4", **{"t.steps": "900"}), "Start training")
    assert_one_sentence(page.error[0].value.replace("\N{WORD JOINER}", ""), "Taxi")
    page = press(opened(environment="CartPole-v1", **{"t.hidden": "1024"}), "Start training")
    assert_one_sentence(page.error[0].value, "7.0 MB", "remove runs")
    page = press(opened(count="2", **FORM), "Start training")
    wait(page, lambda page: sorted(states(runs).values()) == ["training", "waiting"])
    assert sorted(states(runs).values()) == ["training", "waiting"]


def test_caches_and_background_work_stand_in_the_section(runs):
    table = opened("server").markdown[-1].value
    assert re.search(r"\| Caches and opened files together \| [\d,]+ MB \| 1,000 MB \| `LAPLACE_MEMORY` \|", table)
    assert re.search(r"\| Background jobs that wait \| 0  ?\| 50  ?\| `LAPLACE_JOBS_IN_LINE` \|", table)
    assert re.search(r"\| Tabular learners at once \| 0  ?\| 2  ?\| `LAPLACE_LEARNERS` \|", table)


def test_a_queue_that_stands_still_says_why(runs):
    (runs.folder / ".lock").unlink()
    (runs.folder / ".lock").mkdir()
    made(runs, "one")
    runs.wake()
    page = wait(opened(), lambda page: page.error)
    assert_one_sentence(page.error[0].value, "paused", str(runs.folder))
    (runs.folder / ".lock").rmdir()
    wait(page, lambda page: not page.error)


def test_every_limit_is_in_the_table_of_the_document():
    text = (Path(__file__).resolve().parents[3] / "docs" / "server.md").read_text(encoding="utf-8")
    rows = dict(re.findall(r"^\| `(LAPLACE_\w+)` \| (.*) \|$", text, re.M))
    wanted = {}
    for parameter in schema_of(Limits):
        default = str(parameter.default).lower() if parameter.type is bool else f"{parameter.default:,}"
        wanted[f"LAPLACE_{parameter.name.upper()}"] = f"{default} | {parameter.help}"
    container = (Path(__file__).resolve().parents[3] / "compose.yaml").read_text(encoding="utf-8")
    others = {ENVIRONMENTS, training_runs.VARIABLE, *re.findall(r"\$\{(LAPLACE_\w+)", container)} - set(wanted)
    assert {name: row for name, row in rows.items() if name not in others} == wanted
    assert others <= set(rows)
