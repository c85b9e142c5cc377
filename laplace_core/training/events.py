"""Events of a training run: one small dataclass for each kind. No torch here."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Step:
    """All environments have stepped once; ``step`` counts the transitions stored so far."""

    step: int


@dataclass(frozen=True)
class Episode:
    """An episode has ended.

    Attributes:
        head: index of the discount whose head behaved.
        episode_return: sum of the rewards, in units of reward.
        loss: mean over the updates since the last episode; None if there was none.
        seconds: since the run began or was resumed, as in all events: the only field that two equal runs differ in.
    """

    step: int
    episode: int
    head: int
    episode_return: float
    length: int
    truncated: bool
    epsilon: float
    loss: float | None
    seconds: float


@dataclass(frozen=True)
class Evaluation:
    """The averaged network has acted greedily from held-out start seeds.

    Attributes:
        values: of the actions taken at the starts, a mean at every discount, ``(G,)``; None for an agent without many.
        discounted: mean observed discounted returns, likewise; they omit rewards beyond the time limit.
        discounted_errors: standard errors of these means.
    """

    step: int
    score: float
    standard_error: float
    episodes: int
    best: bool
    seconds: float
    values: tuple[float, ...] | None = None
    discounted: tuple[float, ...] | None = None
    discounted_errors: tuple[float, ...] | None = None


@dataclass(frozen=True)
class Checkpoint:
    """Files were written: the resume point, and where the score was the best so far, the checkpoint."""

    step: int
    path: str
    seconds: float


@dataclass(frozen=True)
class Resumed:
    """A run goes on from its resume point.

    Attributes:
        exact: False where the inner state of the environments cannot be saved: all of them begin a new episode, and
            the run differs from one never interrupted.
    """

    step: int
    exact: bool
    message: str
    seconds: float


Event = Step | Episode | Evaluation | Checkpoint | Resumed
