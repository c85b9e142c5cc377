"""Whether other sessions are at work: then a page postpones work that can wait."""

from __future__ import annotations

import time

from app.session.jobs import is_there, session_id

RECENT = 2.0
"""Seconds after its last change in which a session counts as at work."""
_seen: dict[str, float] = {}


def alone(clock: float | None = None) -> bool:
    """Note that this session is at work, and say whether no other is.

    Args:
        clock: seconds; default: now.
    """
    now, own = time.monotonic() if clock is None else clock, session_id()
    for name, last in list(_seen.items()):
        if now - last > RECENT or not is_there(name):
            _seen.pop(name, None)
    if own:
        _seen[own] = now
    return not _seen.keys() - {own}
