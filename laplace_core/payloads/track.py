"""The payload of the race track, sent once for a race: numbers as JSON, pictures unchanged."""

from __future__ import annotations

import json
import struct

import numpy as np

from laplace_core.acting.race import Race


def payload(race: Race) -> bytes:
    """A length, a header as JSON, and the JPEG files of the left and then of the right side, one after the other.

    Of a side of N steps the header holds ``rewards`` and ``actions`` ``(N,)``, whether it ``terminated``, and
    ``ends`` ``(N + 1,)``: where each of its pictures ends, counted from the first of the left side; empty if it has
    none.
    """
    sides, at = [], 0
    for side in (race.left, race.right):
        ends = at + np.cumsum([len(frame) for frame in side.frames], dtype=int)
        at = int(ends[-1]) if ends.size else at
        sides.append({
            "rewards": side.rewards.tolist(), "actions": side.actions.tolist(), "terminated": side.terminated,
            "ends": ends.tolist(),
        })  # fmt: skip
    text = json.dumps({"horizon": race.horizon, "parting": race.parting, "sides": sides}).encode()
    return struct.pack("<I", len(text)) + text + b"".join((*race.left.frames, *race.right.frames))
