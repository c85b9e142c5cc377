"""The payload of the player, sent once for a rollout and packed small, so that scrubbing needs no server.

The differences of gamma-space are only looked at while the hand moves; at rest the lens gets the exact ones. They are
rounded to 16 bits: at every discount in steps of a 32,767th of the largest difference of the episode there, so that
none is off by more than half such a step. Neighbouring steps are alike, so each is written as its change against the
one before, and all of it deflated. Everything else is exact.
"""

from __future__ import annotations

import zlib
from collections.abc import Mapping

import numpy as np

from laplace_core.acting.rollout import Rollout
from laplace_core.code.gamma_space import bin_differences
from laplace_core.payloads.packing import pack, packed_blocks

LEVELS = 32_767


def payload(rollout: Rollout, said: Mapping[str, np.ndarray] | None = None) -> bytes:
    """A length, a header as JSON, and blocks, each on a multiple of 8 bytes after the header.

    Args:
        said: what a peer said at every step, from :func:`laplace_core.acting.return_laws.outputs_along`.

    Blocks by name, with N steps, A actions, O numbers in an observation, G discounts and H sensitivities:
        of an agent with a gamma-space ``differences`` ``(N, A, G, H+1)``: 16-bit changes, low bytes and then high ones;
        ``scales`` ``(G,)``: what one level is worth; ``constant`` ``(N, A, G)``: single floats; both deflated.
        those of ``said``: single floats, deflated.
        ``observations`` ``(N + 1, O)``: single floats.
        ``actions``, ``differs``, ``rewards``, ``surprise``, ``received``, ``predicted`` ``(N,)``; ``values``,
        ``greedy_values`` ``(N, A)``: doubles.
        ``frames``: JPEG files one after the other; ``ends`` ``(N + 1,)``: where each ends.
    """
    doubles = ("actions", "differs", "rewards", "surprise", "received", "predicted", "values", "greedy_values")
    blocks = {
        **_spaces(rollout.spaces, rollout.constants),
        **{name: ("z4", zlib.compress(array.astype("<f4").tobytes(), 6)) for name, array in (said or {}).items()},
        "observations": ("f4", rollout.observations.astype("<f4").tobytes()),
        **{name: ("f8", getattr(rollout, name).astype("<f8").tobytes()) for name in doubles},
        "frames": ("u1", b"".join(rollout.frames)),
        "ends": ("f8", np.cumsum([len(frame) for frame in rollout.frames], dtype="<f8").tobytes()),
    }
    header = {
        "steps": len(rollout),
        "actions": rollout.values.shape[1],
        "terminated": rollout.terminated,
        "acting_gamma": rollout.acting_gamma,
        "rule": rollout.rule,
        "horizon": rollout.horizon,
    }
    table, data = packed_blocks((name, kind, block, len(block)) for name, (kind, block) in blocks.items())
    return pack({**header, "blocks": table}, data)


def _spaces(spaces: np.ndarray | None, constants: np.ndarray | None) -> dict[str, tuple[str, bytes]]:
    """Blocks of the gamma-spaces of a rollout, if there are any."""
    if spaces is None or constants is None:
        return {}
    levels, scales = rounded(bin_differences(spaces, constants, open_ends=True))
    changes = np.diff(levels, axis=0, prepend=np.zeros_like(levels[:1]))  # 16-bit, wrapping around as the sum will
    halves = np.ascontiguousarray(changes).view(np.uint8).reshape(-1, 2).T
    return {
        "differences": ("i2", zlib.compress(np.ascontiguousarray(halves).tobytes(), 6)),
        "constant": ("f4", zlib.compress(constants.astype("<f4").tobytes(), 6)),
        "scales": ("f8", scales.tobytes()),
    }


def rounded(differences: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Differences of gamma-spaces ``(N, A, G, B)`` in 16-bit levels, and what a level is worth, ``(G,)``."""
    largest = np.abs(differences).max(axis=(0, 1, 3)).astype(float)
    scales = np.where(largest > 0, largest, 1.0) / LEVELS
    return np.rint(differences / scales[:, None]).astype("<i2"), scales
