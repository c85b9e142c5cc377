"""The progress and the result of learning, in words."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from laplace_core.tabular.model import Learned


def learned(learned: Learned) -> str:
    """How the shown values were learned."""
    shown = learned.settings
    who = f"each of {shown.seeds} learners" if shown.seeds > 1 else "one learner"
    return f"Learned in {_done(learned)} episodes by {who}, policy {shown.policy}."


def progress(line: Mapping[str, Any], seeds: int, *, running: bool) -> tuple[float, str]:
    """The share of the episodes that are over, and words for it.

    Args:
        line: the last one that the learning process has written.
        seeds: how many learners share the episodes.
        running: whether it goes on; else it was cancelled, unless it has finished.
    """
    each = f" by each of {seeds} learners" if seeds > 1 else ""
    words = [f"{line['episodes'] // seeds:,} of {line['of'] // seeds:,} episodes{each}"]
    words.append(f"{line['steps_per_second']:,} steps/s")
    if line["error"] is not None:
        words.append(f"error {_percent(line['error'])} of the range")
    if running and line["eta"] is not None:
        words.append(f"{line['eta']:.0f} s left")
    elif not line["finished"]:
        words.insert(0, "cancelled at")
    return min(1.0, line["episodes"] / line["of"]), " · ".join(words)


def _done(learned: Learned) -> str:
    """Episodes that were learned; of a run that was cancelled fewer than it was meant to learn."""
    fewest, most, of = min(learned.episodes), max(learned.episodes), learned.settings.episodes
    done = f"{most:,}" if fewest == most else f"{fewest:,} to {most:,}"
    return done if fewest == of else f"{done} of {of:,}"


def _percent(share: float) -> str:
    if share < 1e-6:
        return "below 0.0001%"
    return f"{100 * share:.0f}%" if share >= 0.0995 else f"{100 * share:.2g}%"
