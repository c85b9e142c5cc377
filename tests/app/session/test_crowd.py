"""Whether others are at work."""

from __future__ import annotations

import pytest

from app.session import crowd


@pytest.fixture
def alone(monkeypatch):
    """Asks for a session at a time, in a crowd of its own."""
    monkeypatch.setattr(crowd, "_seen", {})
    gone: set[str] = set()
    monkeypatch.setattr(crowd, "is_there", lambda name: name not in gone)

    def ask(name: str, clock: float) -> bool:
        monkeypatch.setattr(crowd, "session_id", lambda: name)
        return crowd.alone(clock)

    ask.gone = gone
    return ask


def test_one_session_is_alone_however_often_it_asks(alone):
    assert [alone("a", clock) for clock in (0.0, 0.5, 9.0)] == [True] * 3


def test_another_counts_for_a_moment_after_its_last_change(alone):
    assert alone("a", 0.0)
    assert not alone("b", 0.9 * crowd.RECENT)
    assert not alone("a", 1.8 * crowd.RECENT)
    assert alone("b", 3.8 * crowd.RECENT)


def test_a_session_that_has_left_does_not_count(alone):
    alone("a", 0.0)
    assert not alone("b", 0.1)
    alone.gone.add("a")
    assert alone("b", 0.2)


def test_code_outside_of_a_session_counts_for_nobody(alone):
    assert alone("", 0.0)
    assert alone("a", 0.1)
