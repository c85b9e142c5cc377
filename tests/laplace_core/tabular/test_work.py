"""Learners of all sessions: a few at a time; each ends with its sessions, and what it has learned stays."""

from __future__ import annotations

import numpy as np
import pytest

from laplace_core import InputError, load_world
from laplace_core.caching import BUDGET
from laplace_core.supervise import jobs
from laplace_core.supervise.jobs import GRACE, SHORT, Asked
from laplace_core.tabular import LearnSettings, resolve_learning, seconds_to_learn, work
from laplace_core.tabular.process import Run
from laplace_core.tabular.work import MOST_KEPT, Runs, Watched, Work
from tests.support.hostile import assert_one_sentence
from tests.support.line import LIMIT, Server, Stub
from tests.support.quick_runs import until

WORLD = load_world("two_branch", {"slip": 0.1})
ENDLESS = LearnSettings(episodes=1_000_000)
PLACES = 2


class Session:
    """What a session has asked for, and the runs that it has looked at."""

    def __init__(self, name: str):
        self.asked, self.runs = Asked(name), Runs()


class Wish(jobs.Wish):
    """Of the session that a test goes on as."""

    now = Session("first")
    learners: jobs.Kind

    @property
    def asked(self) -> Asked:
        return self.now.asked


@pytest.fixture
def server(monkeypatch):
    """Places for learners of this test alone; all end with it."""
    made = Server(threads=PLACES)
    monkeypatch.setattr(Wish, "learners", made.kind(MOST_KEPT), raising=False)
    monkeypatch.setattr(Wish, "now", Session("first"))
    yield made
    Wish.learners.clear()
    until(lambda: made.line.usage().running == 0)


@pytest.fixture
def asks(monkeypatch):
    """Go on as another session."""
    kept: dict[str, Session] = {}

    def become(name: str) -> None:
        monkeypatch.setattr(Wish, "now", kept.setdefault(name, Session(name)))

    become("first")
    return become


@pytest.fixture
def started(server, asks, monkeypatch) -> list[Stub]:
    """Every run that was started, in order; none is a process."""
    found: list[Stub] = []

    def start(world, settings, folder):
        found.append(Stub())
        return found[-1]

    monkeypatch.setattr(work, "start", start)
    return found


def run_of(key: str, slot: str = "learner", *, linked: bool = False, settings: LearnSettings = ENDLESS) -> Wish:
    """The wish of a run; one from a link may start without a button."""
    learn, by_itself = Work(key, WORLD, settings).learn, SHORT if linked else 0.0
    return Wish(Wish.learners, key, learn, lambda: SHORT + 1.0, slot, by_itself=by_itself)


def watch(wish: Wish) -> Watched | None:
    return Wish.now.runs.watch(wish)


def begun(key: str) -> Watched:
    run_of(key).begin()
    found = watch(run_of(key, linked=True))
    assert found is not None
    return found


def test_a_run_waits_while_the_server_has_no_place_and_starts_when_there_is_one(started, asks):
    watched = []
    for name in "abc":
        asks(name)
        watched.append(begun(name))
        until(lambda: len(started) == min(PLACES, len(watched)))
    assert [run.waiting for run in watched] == [False] * PLACES + [True]
    assert watched[-1].before == PLACES
    assert all(run.running for run in watched)
    asks("a")
    watched[0].cancel(run_of("a"))
    until(lambda: len(started) == PLACES + 1)
    assert [run.running for run in watched] == [False, True, True]
    assert not watched[-1].waiting


def test_a_session_has_one_place_however_many_runs_it_begins(started):
    """A pinned view learns beside the present one."""
    first = begun("a")
    until(lambda: started)
    run_of("b", "pinned").begin()
    second = watch(run_of("b", "pinned", linked=True))
    assert first.running
    assert second.waiting
    first.cancel(run_of("a"))
    until(lambda: len(started) == 2)


def test_a_run_that_is_cancelled_while_it_waits_never_starts(started, asks):
    for name in "ab":
        asks(name)
        begun(name)
    until(lambda: len(started) == PLACES)
    asks("c")
    late = begun("c")
    late.cancel(run_of("c"))
    assert not late.running
    assert not late.waiting
    Wish.learners.clear()
    assert len(started) == PLACES


def test_a_new_run_of_a_session_ends_the_one_before(started):
    first = begun("a")
    until(lambda: started)
    second = begun("b")
    until(lambda: started[0].finished)
    assert not first.running
    assert second.running
    assert Wish.now.runs.at_work()


def test_a_session_keeps_a_few_runs_and_forgets_the_oldest(started):
    kept = [begun(str(i)) for i in range(MOST_KEPT + 2)]
    assert [watch(run_of(str(i))) for i in range(MOST_KEPT + 2)] == [None, None, *kept[2:]]


def test_what_is_forgotten_starts_anew(started):
    first = begun("a")
    until(lambda: started)
    first.cancel(run_of("a"))
    Wish.now.runs.forget(run_of("a"))
    assert watch(run_of("a")) is None
    assert begun("a") is not first
    until(lambda: len(started) == 2)


def test_a_page_that_is_loaded_again_finds_its_run_at_work(started, server, asks):
    begun("a")
    until(lambda: started)
    server.gone.add("first")
    asks("first, loaded again")
    assert watch(run_of("a")) is None  # of somebody else, as far as this link goes
    again = watch(run_of("a", linked=True))
    assert again is not None
    assert again.running
    server.now += GRACE + 1.0
    server.line.tick()
    assert again.running
    assert len(started) == 1


def test_a_run_ends_with_its_session_and_leaves_the_others_alone(started, server, asks):
    begun("a")
    until(lambda: started)
    asks("second")
    begun("b")
    until(lambda: len(started) == 2)
    server.gone.add("first")
    server.now += GRACE + 1.0
    until(lambda: started[0].finished)
    assert not started[1].finished


def test_a_run_is_ended_at_the_limit_and_says_so(started, server):
    found = begun("a")
    until(lambda: started)
    server.now = LIMIT + 1.0
    until(lambda: not found.running)
    assert found.error == (
        "it was ended after 100 seconds, the limit of this server; what was learned until then stays."
    )
    assert watch(run_of("a")) is found


def test_a_run_that_cannot_start_says_why_and_takes_no_place(started, server, monkeypatch):
    def refuse(world, settings, folder):
        raise InputError("learning cannot start: no space left on device.")

    monkeypatch.setattr(work, "start", refuse)
    watched = begun("a")
    until(lambda: not watched.running)
    assert watched.error == "learning cannot start: no space left on device."
    until(lambda: server.line.usage()[0] == 0)
    assert watched.progress() is None
    assert watched.learned() is None


def test_a_real_process_and_its_files_are_gone_after_cancel_and_what_it_learned_stays(server, asks, monkeypatch):
    runs: list[Run] = []
    folders = []

    def start(world, settings, folder):
        folders.append(folder)
        runs.append(real(world, settings, folder))
        return runs[-1]

    real = work.start
    monkeypatch.setattr(work, "start", start)
    watched = begun("a")
    until(lambda: watch(run_of("a")).learned() is not None)
    watched.cancel(run_of("a"))
    assert not watched.running
    assert runs[0].finished
    assert not folders[0].exists()
    assert watched.error is None
    learned, progress = watched.learned(), watched.progress()
    assert 0 < learned.episodes[0] < ENDLESS.episodes
    assert progress["episodes"] == learned.episodes[0]


def test_what_was_learned_counts_in_the_memory_of_the_server_and_is_learned_anew_once_it_has_left(server):
    settings = LearnSettings(episodes=5)
    run = run_of("a", linked=True, settings=settings)
    before = BUDGET.bytes
    run.begin()
    watched = watch(run)
    until(lambda: not watched.running)
    assert watch(run) is watched
    learned = watched.learned()
    assert learned is not None
    assert BUDGET.bytes - before > learned.basis.nbytes
    assert watch(run).learned() is learned
    BUDGET.clear()  # as when other results need the room
    assert watch(run) is None
    run.begin()
    anew = watch(run)
    until(lambda: not anew.running)
    np.testing.assert_array_equal(anew.learned().basis, learned.basis)


def test_what_was_learned_and_fits_nowhere_is_one_sentence(server, monkeypatch):
    monkeypatch.setattr(BUDGET, "limit", 1_000)
    run = run_of("a", linked=True, settings=LearnSettings(episodes=5))
    run.begin()
    watched = watch(run)
    until(lambda: not watched.running)
    assert_one_sentence(watched.error, "together on this server", "lower the number of learners")
    assert watched.learned() is None


def test_the_estimate_is_that_of_the_first_episodes():
    """The first takes 3 s, the others .25 s: after the fifth, 4 s are over. 2 learners, 1,000 episodes of .25 s.

    Of a single episode that takes longer than the measurement may, its 3 s count.
    """
    settings = resolve_learning(LearnSettings(episodes=1_000, seeds=2), WORLD)
    times = (0.0, 3.0, 3.25, 3.5, 3.75, 4.0)
    assert seconds_to_learn(WORLD, settings, most=4.0, clock=iter(times).__next__) == 0.25 * 1_000 * 2
    assert seconds_to_learn(WORLD, settings, most=2.0, clock=iter(times).__next__) == 3.0 * 1_000 * 2
