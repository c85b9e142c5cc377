"""Calls in one process of low priority: each result reaches those who asked, and what nobody wants is given up."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator
from pathlib import Path

import psutil
import pytest

from laplace_core import InputError
from laplace_core.supervise import aside
from laplace_core.supervise.aside import Aside
from tests.support.jobs import Paused, die, die_once, long_answer, note_and_wait, priority, refuse, square, unsendable
from tests.support.quick_runs import until

ROOT = Path(__file__).parents[3]
Kept = dict[str, object]
Made = tuple[Aside[str, object], Kept]


@pytest.fixture
def made(monkeypatch) -> Iterator[Callable[..., Made]]:
    """Makes an object and what it has kept; its process is gone after the test."""
    monkeypatch.setattr(aside, "GIVEN", 0.2)
    before = set(psutil.Process().children())

    def make(is_there: Callable[[str], bool] = lambda owner: True) -> Made:
        kept: Kept = {}
        return Aside(kept.__setitem__, kept.__setitem__, is_there), kept

    yield make
    for child in set(psutil.Process().children()) - before:
        child.kill()
        child.wait()


def test_results_reach_who_asked(made):
    calls, kept = made()
    for number in range(4):
        calls.ask(f"session {number}", f"{number}", square, number)
    for number in range(4):
        assert calls.is_over(f"{number}", 60)
    assert kept == {"0": 0, "1": 1, "2": 4, "3": 9}


def test_what_a_call_raises_is_told(made):
    calls, kept = made()
    calls.ask("a", "bad", refuse, 2)
    calls.ask("b", "good", square, 3)
    assert calls.is_over("bad", 60)
    assert calls.is_over("good", 60)
    assert isinstance(kept["bad"], InputError)
    assert str(kept["bad"]) == "number 2 is refused."
    assert kept["good"] == 9


def test_what_cannot_be_sent_is_told_and_costs_no_other_call(made):
    calls, kept = made()
    calls.ask("a", "no call", lambda: 1)
    calls.ask("b", "no answer", unsendable)
    calls.ask("c", "good", square, 3)
    for key in ("no call", "no answer", "good"):
        assert calls.is_over(key, 60)
    assert "lambda" in str(kept["no call"])
    assert str(kept["no answer"]).startswith("the result cannot be sent: ")
    assert kept["good"] == 9


def test_only_the_latest_wish_of_an_owner_is_made(made, tmp_path):
    calls, kept = made()
    calls.ask("other", "first", note_and_wait, (str(tmp_path), 0))  # keeps the process busy until nobody wants it
    until(lambda: list(tmp_path.iterdir()))
    for number in range(5):
        calls.ask("a", f"{number}", square, number)
    calls.ask("other", "4", square, 4)  # shared with the last wish of a
    assert calls.is_over("4", 60)
    assert calls.is_over("first", 60)
    assert set(kept) == {"4"}


def test_what_runs_for_somebody_is_not_given_up(made, tmp_path):
    """Another call waits for longer than a call that nobody wants is given."""
    calls, kept = made()
    calls.ask("a", "long", note_and_wait, (str(tmp_path), 0))
    calls.ask("b", "short", square, 2)
    assert not calls.is_over("short", 5 * aside.GIVEN)
    calls.ask("a", "now", square, 3)
    assert calls.is_over("now", 60)
    assert calls.is_over("short", 60)
    assert kept == {"short": 4, "now": 9}


def test_the_call_of_a_session_that_has_left_is_given_up(made, tmp_path):
    there = {"a", "b"}
    calls, kept = made(lambda owner: owner in there)
    calls.ask("a", "long", note_and_wait, (str(tmp_path), 0))
    calls.ask("b", "short", square, 2)
    until(lambda: list(tmp_path.iterdir()))
    there.remove("a")
    assert calls.is_over("short", 60)
    assert kept == {"short": 4}


def test_a_process_that_is_ended_in_the_middle_of_an_answer_ends_its_reader(monkeypatch):
    """And raises no error there: a file that one thread closed while another read it did."""
    raised = []
    monkeypatch.setattr(threading, "excepthook", raised.append)
    process = aside._Process()
    process.send(long_answer, ())
    assert Paused.is_read.wait(60)
    process.end()
    Paused.goes_on.set()
    until(lambda: "answers from aside" not in [thread.name for thread in threading.enumerate()])
    assert not raised


def test_small_calls_go_first(made, tmp_path):
    calls, kept = made()
    calls.ask("a", "long", note_and_wait, (str(tmp_path), 0))
    until(lambda: list(tmp_path.iterdir()))
    calls.ask("b", "large", square, 2, is_large=True)
    calls.ask("c", "small", square, 3)
    calls.ask("a", "also small", square, 4)
    assert calls.is_over("large", 60)
    assert list(kept) == ["small", "also small", "large"]


def test_a_call_whose_process_dies_is_made_again(made, tmp_path):
    calls, kept = made()
    calls.ask("a", "3", die_once, (str(tmp_path), 3))
    assert calls.is_over("3", 60)
    assert kept == {"3": 9}


def test_a_call_that_always_kills_its_process_is_given_up(made):
    calls, kept = made()
    calls.ask("a", "deadly", die, 1)
    assert calls.is_over("deadly", 60)
    assert str(kept["deadly"]) == "the process of this search died 3 times."
    calls.ask("a", "next", square, 5)
    assert calls.is_over("next", 60)
    assert kept["next"] == 25


def test_the_process_has_low_priority_and_ends_when_nothing_is_asked(made, monkeypatch):
    monkeypatch.setattr(aside, "IDLE", 0.2)
    before = set(psutil.Process().children())
    calls, kept = made()
    calls.ask("a", "nice", priority)
    assert calls.is_over("nice", 60)
    assert kept["nice"] == aside.LOW
    until(lambda: not set(psutil.Process().children()) - before)
    calls.ask("a", "again", square, 2)  # and begins again
    assert calls.is_over("again", 60)
    assert kept["again"] == 4


def test_the_process_ends_with_a_parent_that_is_killed(tmp_path):
    script = f"""
import time
from laplace_core.supervise.aside import Aside
from tests.support.jobs import note_and_wait
Aside(print, print).ask("a", "long", note_and_wait, ({str(tmp_path)!r}, 0))
time.sleep(600)
"""
    parent = subprocess.Popen([sys.executable, "-c", script], cwd=ROOT, env={**os.environ, "PYTHONPATH": str(ROOT)})
    until(lambda: list(tmp_path.iterdir()))
    child = int(next(tmp_path.iterdir()).name)
    parent.kill()
    parent.wait()
    until(lambda: not psutil.pid_exists(child))
    assert parent.returncode == -signal.SIGKILL


def test_many_threads_ask_at_once(made):
    calls, kept = made()
    threads = [threading.Thread(target=lambda i=i: calls.ask(f"{i}", f"{i % 5}", square, i % 5)) for i in range(40)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for number in range(5):
        assert calls.is_over(f"{number}", 60)
    assert kept == {f"{number}": number * number for number in range(5)}
