"""Background jobs on a page: the estimated time, the place in the queue, progress, Cancel, and the result."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any, TypeVar

import streamlit as st

from app.session.jobs import Wish
from app.session.typed import in_markdown
from laplace_core import InputError
from laplace_core.supervise.jobs import Job, duration
from laplace_core.words import capital

Result = TypeVar("Result")
LOOK_EVERY = 0.4  # seconds between two looks at work that is not done
WORTH_SAYING = 2.0
"""Seconds from which on it is said what work will cost."""


def offer(
    wish: Wish, label: str, *, key: str, words: str = "", then: Callable[[], None] | None = None, place: Any = st,
    button_place: Any = None, primary: bool = False, help: str | None = None,
) -> None:  # fmt: skip
    """A button that begins work, with the estimated time; or the reason why it cannot begin.

    Args:
        words: said before the cost.
        then: called by the button as well.
        place, button_place: of the words, and of the button where it stands elsewhere.
    """

    def begin() -> None:
        wish.begin()
        if then is not None:
            then()

    notice = wish.notice
    cost = f"This takes about {duration(wish.estimate())}." if not notice and wish.estimate() >= WORTH_SAYING else ""
    said = " ".join(part for part in (words, cost) if part)
    if said:
        place.caption(said)
    if notice:
        place.warning(capital(notice))
    kind = "primary" if primary else "secondary"
    button = place if button_place is None else button_place
    button.button(label, key=key, type=kind, width="stretch", on_click=begin, disabled=bool(wish.too_long), help=help)


def progress(job: Job, words: str, cancel: Callable[[], None] | None = None, *, key: str = "") -> None:
    """A progress bar that is redrawn until the work is done; then the page is redrawn.

    Args:
        words: a format of ``done``, ``of`` and ``share``, for work that has begun.
        cancel: callback of the button beside it; without one there is no button.
        key: of that button.
    """
    st.fragment(_progress, run_every=LOOK_EVERY)(job, words, cancel, key=key)


def _progress(job: Job, words: str, cancel: Callable[[], None] | None, *, key: str) -> None:
    if not job.going:
        st.rerun()
    share = min(1.0, job.done / job.of) if job.of else 0.0
    bar, button = st.columns([5, 1], vertical_alignment="center") if cancel else (st, st)
    bar.progress(share, words.format(done=job.done, of=job.of, share=share) if job.of else place_in_line(job.before))
    if cancel is not None:
        button.button("Cancel", key=key, width="stretch", on_click=cancel)


def place_in_line(before: int) -> str:
    """The sentence about a waiting job with this number of jobs before it."""
    if not before:
        return "Starting ..."
    return "Waits: 1 other is before this one" if before == 1 else f"Waits: {before} others are before this one"


def attempt(make: Callable[[], Result]) -> Result | None:
    """The result of a function; if it raises InputError, None, and the page shows the sentence."""
    try:
        return make()
    except InputError as error:
        st.error(in_markdown(error))
        return None


_large = threading.Lock()


@contextmanager
def turn(*, needed: bool) -> Iterator[None]:
    """Wait until no other page computes something large, so that memory and processors remain for small work.

    Args:
        needed: whether the work is large; small work begins at once.
    """
    if not needed:
        yield
        return
    place = st.empty()
    while not _large.acquire(timeout=LOOK_EVERY):
        place.caption("Waits: another large study is being computed.")  # where Streamlit ends a run that nobody awaits
    try:
        place.empty()
        yield
    finally:
        _large.release()
