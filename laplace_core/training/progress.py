"""One line about where a run stands. No torch here."""

from __future__ import annotations

from collections import deque
from time import perf_counter

from laplace_core.training.events import Episode, Evaluation, Event, Resumed


class Progress:
    """Listens to events and says in one line: steps, steps a second, scores and the time left.

    Args:
        steps: of the whole run.
        recent: episodes that the mean return is taken over.
    """

    def __init__(self, steps: int, recent: int = 50, clock=perf_counter):
        self.steps, self.step, self.score = steps, 0, None
        self._returns: deque[float] = deque(maxlen=recent)
        self._clock, self._began = clock, (clock(), 0)

    def hear(self, event: Event) -> None:
        """Take note of any event."""
        self.step = event.step
        if isinstance(event, Resumed):
            self._began = self._clock(), event.step
        elif isinstance(event, Episode):
            self._returns.append(event.episode_return)
        elif isinstance(event, Evaluation):
            self.score = event.score

    def line(self) -> str:
        started, first = self._began
        rate = (self.step - first) / max(1e-9, self._clock() - started)
        parts = [f"{min(1.0, self.step / self.steps):4.0%}", f"step {self.step:,}", f"{rate:,.0f} steps/s"]
        if self._returns:
            parts.append(f"last {len(self._returns)} episodes {sum(self._returns) / len(self._returns):.1f}")
        if self.score is not None:
            parts.append(f"evaluated {self.score:.1f}")
        if rate > 0 and self.step < self.steps:
            left = int((self.steps - self.step) / rate)
            parts.append(f"{left // 3600}:{left // 60 % 60:02d}:{left % 60:02d} left")
        return " · ".join(parts)
