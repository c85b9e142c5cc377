"""Work in the background of a server: its lines keep its limits, and a wish is of the session that looks."""

from __future__ import annotations

import pytest

from app.session import jobs, record
from app.session.jobs import Wish, background, is_there, learners
from laplace_core.supervise.jobs import SHORT
from laplace_core.supervise.limits import limits
from tests.support.line import Gate, Server


def test_the_lines_keep_the_limits_of_the_server():
    for line, places in ((background(), 2), (learners(), limits().learners)):
        assert (line.threads, line.limit) == (places, limits().background_seconds)
        assert line.usage().most_waiting == limits().jobs_in_line


def test_outside_of_a_server_everybody_is_there():
    assert is_there("")
    assert is_there("a session")


@pytest.fixture
def asks(monkeypatch):
    """Go on as another session."""
    kept: dict[str, dict] = {}

    def become(name: str) -> None:
        monkeypatch.setattr(record.st, "session_state", kept.setdefault(name, {}))
        monkeypatch.setattr(jobs, "session_id", lambda: name)

    become("first")
    return become


def test_a_wish_is_of_the_session_that_looks(asks):
    gate, wish = Gate(), Wish(Server().kind(), "a", lambda progress: gate(progress), lambda: SHORT + 1.0, "race")
    wish.begin()
    job = wish.look()
    assert job.sessions == ("first",)
    asks("second")
    assert wish.look() is job  # whoever has begun it
    assert job.sessions == ("first", "second")
    wish.cancel()
    assert wish.look() is None
    asks("first")
    assert wish.look() is job
    assert job.going
    gate.open()
