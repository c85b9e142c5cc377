"""Work in the background on a page: how far it is, a way out, and what it was refused for."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

import streamlit as st

from app.session.background import Work
from app.session.typed import in_markdown
from laplace_core import InputError

Result = TypeVar("Result")
LOOK_EVERY = 0.4  # seconds between two looks at work that is not done


def progress(work: Work, words: str, queued: str, cancel: Callable[[], None] | None = None, *, key: str = "") -> None:
    """A bar that is drawn anew until the work is done, and then the page with it.

    Args:
        words: a format of ``done``, ``of`` and ``share``; ``queued`` stands there before anything is done.
        cancel: callback of the button beside it; without one there is no button.
        key: of that button.
    """
    st.fragment(_progress, run_every=LOOK_EVERY)(work, words, queued, cancel, key=key)


def _progress(work: Work, words: str, queued: str, cancel: Callable[[], None] | None, *, key: str) -> None:
    if not work.going:
        st.rerun()
    share = min(1.0, work.done / work.of) if work.of else 0.0
    bar, button = st.columns([5, 1], vertical_alignment="center") if cancel else (st, st)
    bar.progress(share, words.format(done=work.done, of=work.of, share=share) if work.of else queued)
    if cancel is not None:
        button.button("Cancel", key=key, width="stretch", on_click=cancel)


def attempt(make: Callable[[], Result]) -> Result | None:
    """What a function returns; where it refuses, None, and the sentence that says why is on the page."""
    try:
        return make()
    except InputError as error:
        st.error(in_markdown(error))
        return None
