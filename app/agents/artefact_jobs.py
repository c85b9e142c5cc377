"""Artefacts at every step of a rollout, looked for in the background under the settings that a page has."""

from __future__ import annotations

import threading
from dataclasses import replace
from typing import Any
from weakref import WeakKeyDictionary

import numpy as np

from app.agents.rollout_jobs import Rolling
from app.session.background import Told, Work
from app.session.shelf import Shelf
from app.view.subjects import View
from laplace_core.acting.flags import Flags, flag_steps

MOST_KEPT = 8
"""Searches for one rollout, of some kilobytes each; they go when it goes."""
_kept: WeakKeyDictionary[Rolling, Shelf[Work[Flags]]] = WeakKeyDictionary()
_lock = threading.Lock()


def flagging(rolling: Rolling, view: View) -> Work[Flags]:
    """The search for a rollout that is done under the settings of a view: the one there is, or a new one."""
    rollout, added = rolling.rollout(), view.subject.added
    # Without a truth no artefact depends on how values are read.
    key = settings, _ = replace(view.settings, softness=0.0, deadline="time_to_go"), added

    def make(told: Told) -> Flags:
        return flag_steps(rollout, settings, added, told)

    with _lock:
        shelf = _kept.setdefault(rolling, Shelf(MOST_KEPT))
    return shelf.take(key, lambda: Work(make))


def for_player(flags: Flags, alpha: float) -> dict[str, Any]:
    """What the player is told: names, and at every step which of them are there, a bit each."""
    marks = flags.marks @ (1 << np.arange(len(flags.names)))
    return {"alpha": alpha, "names": list(flags.names), "marks": marks.astype(int).tolist()}
