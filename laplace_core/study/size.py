"""The limit of a study's size, in numbers of its largest array: one limit for a process."""

from __future__ import annotations

from laplace_core.errors import InputError

MAX_VALUES = 50_000_000
"""Largest array a study may hold, in numbers; 50 million are 400 MB."""
_most = MAX_VALUES


def largest_study() -> int:
    """Numbers that the largest array of a study may hold in this process."""
    return _most


def set_largest_study(numbers: int) -> None:
    """Let the studies of this process hold fewer numbers than the library takes: a server has several at a time."""
    global _most
    _most = min(numbers, MAX_VALUES)


def size_of(actions: int, gammas: int, thetas: int, steps: int, *, rewards: int = 1, learners: int = 1) -> int:
    """Numbers of the largest array of a study, or of one for each of several learners."""
    rows = max(gammas, steps)
    return learners * max(actions * thetas * rows, rewards * thetas, actions * rewards * rows)


def check_size(actions: int, gammas: int, thetas: int, steps: int, *, rewards: int = 1, learners: int = 1) -> None:
    """Refuse a study, or one for each of several learners, that would hold more.

    Raises:
        InputError: naming the numbers, and what to lower.
    """
    size, rows = size_of(actions, gammas, thetas, steps, rewards=rewards, learners=learners), max(gammas, steps)
    if size > _most:
        several = f"{learners} learners, " if learners > 1 else ""
        raise InputError(
            f"{several}{actions} actions, {rewards} distinct rewards, {thetas} thetas and {rows} rows make arrays of "
            f"{size:,} numbers, above {_most:,}: lower {'seeds, ' if several else ''}thetas, gammas or steps, or "
            "round the rewards."
        )
