"""Running learners, a few at a time on a server: those that a session has begun or shows."""

from __future__ import annotations

from functools import lru_cache

from app import session
from app.session.jobs import Wish
from app.session.jobs import learners as line
from laplace_core.supervise.jobs import Kind
from laplace_core.tabular import LearnSettings, seconds_to_learn
from laplace_core.tabular.work import MOST_KEPT, Runs, Watched, Work
from laplace_core.worlds import World

BY_ITSELF = 1.0
"""Seconds of estimate below which a link learns without a button."""
_jobs: Kind[Work] = Kind("learners", MOST_KEPT, line=line)
_seconds = lru_cache(maxsize=32)(seconds_to_learn)


def learning(key: str, world: World, settings: LearnSettings, *, slot: str, linked: bool) -> Wish[Work]:
    """A run.

    Args:
        key: of what it learns.
        slot: of the session, see :class:`laplace_core.supervise.jobs.Wish`.
        linked: whether it comes from a link, so that it starts automatically if it is short.
    """
    work, lower = Work(key, world, settings), "lower the number of episodes or of learners"
    by_itself = BY_ITSELF if linked else 0.0
    return Wish(_jobs, key, work.learn, lambda: _seconds(world, settings), slot, lower, by_itself)


def forget(wish: Wish[Work]) -> None:
    """Drop a run that has ended, so that it can begin again."""
    session.part(Runs).forget(wish)


def watch(wish: Wish[Work]) -> Watched | None:
    """The run of a wish, if this session has begun or seen it, or its link holds it."""
    return session.part(Runs).watch(wish)


def at_work() -> bool:
    """Whether a run that this session has begun or shown is still running."""
    return session.part(Runs).at_work()


__all__ = ["Watched", "at_work", "forget", "learning", "watch"]
