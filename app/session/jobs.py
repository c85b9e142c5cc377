"""Background jobs of a server: its two queues, and the session of a wish.

How work waits, runs and ends is that of :mod:`laplace_core.supervise.jobs`, which knows no page.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cache
from typing import TypeVar

from streamlit import runtime
from streamlit.runtime.scriptrunner import get_script_run_ctx

from app import session
from laplace_core.supervise import jobs
from laplace_core.supervise.jobs import Asked, Line
from laplace_core.supervise.limits import limits

Result = TypeVar("Result")


def session_id() -> str:
    """The session that this code runs for; empty outside of one."""
    context = get_script_run_ctx(suppress_warning=True)
    return "" if context is None else context.session_id


def is_there(name: str) -> bool:
    """Whether a session's page is open in a browser."""
    try:
        return not name or not runtime.exists() or bool(runtime.get_instance().is_active_session(name))
    except RuntimeError:  # no server: a test of pages has ended meanwhile
        return True


@cache
def background() -> Line:
    """The queue of all jobs that run in threads of this server."""
    return Line(2, kept=1, most=limits().jobs_in_line, limit=limits().background_seconds, is_there=is_there)


@cache
def learners() -> Line:
    """The queue of tabular learners, each of which runs in its own process."""
    given = limits()
    return Line(given.learners, kept=0, most=given.jobs_in_line, limit=given.background_seconds, is_there=is_there)


@dataclass
class _Asked(Asked):
    name: str = field(default_factory=lambda: session_id())


def leave(slot: str) -> None:
    """The session that this code runs for waits for the job in a slot no more."""
    session.part(_Asked).leave(slot)


class Wish(jobs.Wish[Result]):
    """A wish of the session that this code runs for."""

    @property
    def asked(self) -> Asked:
        return session.part(_Asked)
