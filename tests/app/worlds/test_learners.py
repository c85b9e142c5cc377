"""Learners of all sessions: a few at a time, the others wait; each goes with its session."""

from __future__ import annotations

import gc
import threading

import pytest

from app.worlds import learners
from app.worlds.learners import MOST_KEPT, MOST_RUNNING, Runs, Watched
from laplace_core import InputError, load_world
from laplace_core.tabular import LearnSettings

WORLD = load_world("two_branch", {"slip": 0.1})
ENDLESS = LearnSettings(episodes=1_000_000)


class Stub:
    """A run that goes on until it is told to end."""

    error = None

    def __init__(self):
        self.finished = False

    def cancel(self):
        self.finished = True

    def progress(self):
        return None

    def snapshot(self):
        return None


@pytest.fixture
def started(monkeypatch) -> list[Stub]:
    """Every run that was started, in order; none is a process."""
    found: list[Stub] = []

    def start(world, settings, folder):
        found.append(Stub())
        return found[-1]

    monkeypatch.setattr(learners, "start", start)
    monkeypatch.setattr(learners, "_running", [])
    return found


def test_a_run_waits_while_the_server_has_no_place_and_starts_when_there_is_one(started):
    watched = [Watched(WORLD, ENDLESS) for _ in range(MOST_RUNNING + 2)]
    assert [run.waiting for run in watched] == [False] * MOST_RUNNING + [True, True]
    assert all(run.running for run in watched)
    watched[0].cancel()
    assert [run.waiting for run in watched[MOST_RUNNING:]] == [False, True]
    assert len(started) == MOST_RUNNING + 1


def test_a_run_that_is_cancelled_while_it_waits_never_starts(started):
    busy = [Watched(WORLD, ENDLESS) for _ in range(MOST_RUNNING)]
    assert not any(run.waiting for run in busy)
    late = Watched(WORLD, ENDLESS)
    assert late.running
    late.cancel()
    for run in busy:
        run.cancel()
    assert not late.running
    assert not late.waiting
    assert len(started) == MOST_RUNNING


def test_a_new_run_of_a_session_ends_the_one_before(started):
    session = Runs()
    first, second = session.begin("a", WORLD, ENDLESS), session.begin("b", WORLD, ENDLESS)
    assert first.running is False
    assert second.running
    assert session.running
    assert session.begin("a", WORLD, ENDLESS) is first  # what was learned stays


def test_a_session_keeps_a_few_runs_and_forgets_the_oldest(started):
    session = Runs()
    kept = [session.begin(str(i), WORLD, ENDLESS) for i in range(MOST_KEPT + 2)]
    assert [session.get(str(i)) for i in range(MOST_KEPT + 2)] == [None, None, *kept[2:]]
    assert sum(not run.finished for run in started) <= 1


def test_again_starts_anew(started):
    session = Runs()
    first = session.begin("a", WORLD, ENDLESS)
    assert first.running
    session.again("a")
    assert not first.running
    assert session.begin("a", WORLD, ENDLESS) is not first


def test_one_session_s_end_leaves_the_others_alone(started):
    gone, stays = Runs(), Runs()
    for session in (gone, stays):
        assert session.begin("a", WORLD, ENDLESS).running
    del gone, session
    gc.collect()
    assert [run.finished for run in started] == [True, False]
    assert stays.running


def test_no_more_than_the_places_are_taken_however_many_ask_at_once(started):
    watched = [Watched(WORLD, ENDLESS) for _ in range(24)]
    threads = [threading.Thread(target=lambda run=run: run.waiting) for run in watched]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(started) == MOST_RUNNING


def test_a_run_that_cannot_start_says_why_and_takes_no_place(monkeypatch):
    def refuse(world, settings, folder):
        raise InputError("learning cannot start: no space left on device.")

    monkeypatch.setattr(learners, "start", refuse)
    monkeypatch.setattr(learners, "_running", [])
    watched = Watched(WORLD, ENDLESS)
    assert not watched.running
    assert watched.error == "learning cannot start: no space left on device."
    assert learners._running == []
    assert watched.progress() is None
    assert watched.learned() is None


def test_a_real_process_is_gone_after_cancel_and_its_files_after_forget():
    watched = Watched(WORLD, ENDLESS)
    assert not watched.waiting
    assert watched.running
    watched.cancel()
    assert not watched.running
    assert watched._run._worker.ended
    assert watched.error is None
    folder = watched._folder
    assert folder.exists()
    watched.forget()
    assert not folder.exists()
