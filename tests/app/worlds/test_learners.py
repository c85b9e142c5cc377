"""Learners of this server: a link starts short ones, and not those that take long."""

from __future__ import annotations

import pytest

from app.session import jobs, record
from app.worlds import learners
from app.worlds.learners import BY_ITSELF, at_work, learning, watch
from laplace_core import load_world
from laplace_core.tabular import LearnSettings, work
from laplace_core.tabular.work import MOST_KEPT
from tests.support.line import Server, Stub
from tests.support.quick_runs import until

WORLD = load_world("two_branch", {"slip": 0.1})


@pytest.fixture
def server(monkeypatch):
    """Places for learners of this test alone, and one session; none starts a process."""
    made = Server()
    monkeypatch.setattr(record.st, "session_state", {})
    monkeypatch.setattr(jobs, "session_id", lambda: "first")
    monkeypatch.setattr(learners, "_jobs", made.kind(MOST_KEPT))
    monkeypatch.setattr(work, "start", lambda world, settings, folder: Stub())
    yield made
    learners._jobs.clear()
    until(lambda: made.line.usage().running == 0)


def run_of(*, linked: bool):
    return learning("a", WORLD, LearnSettings(episodes=1_000_000), slot="learner", linked=linked)


def test_a_link_starts_what_is_learned_in_a_moment_and_nothing_else(server, monkeypatch):
    monkeypatch.setattr(learners, "_seconds", lambda world, settings: BY_ITSELF + 0.1)
    assert watch(run_of(linked=True)) is None
    monkeypatch.setattr(learners, "_seconds", lambda world, settings: BY_ITSELF - 0.1)
    assert watch(run_of(linked=False)) is None
    assert not at_work()
    assert watch(run_of(linked=True)).running
    assert at_work()


def test_what_takes_longer_than_the_server_allows_is_not_learned(server, monkeypatch):
    monkeypatch.setattr(learners, "_seconds", lambda world, settings: 14_400.0)
    asked = run_of(linked=False)
    asked.begin()
    assert watch(run_of(linked=True)) is None
    assert asked.notice == (
        "this takes about 4 hours, and this server allows 100 seconds: lower the number of episodes or of learners."
    )
