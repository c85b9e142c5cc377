"""The metrics of a run as curves, read while they are written: only what is new, thinned to a bounded number of points.

Each call of :meth:`Reader.look` reads a bounded number of bytes, however long the file; the next call reads on.
"""

from __future__ import annotations

import csv
import io
import json
import math
import os
import stat
import threading
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from laplace_core.files.cells import no_formula
from laplace_core.supervise import PLAIN

MOST_POINTS = 1024
"""Points of a curve; when there are more, neighbours are merged."""
MOST_EVALUATIONS = 512
_AT_ONCE = 4_000_000  # bytes in one look
_LONGEST_LINE = 200_000
_MARK = 64  # last bytes read, compared with the file to notice that it was cut back and has grown again
_BY_DISCOUNT = ("values", "discounted", "discounted_errors")
_SMOOTHING = 0.02  # of all episodes, on either side
_LEAST_SMOOTHING = 5


@dataclass(frozen=True, eq=False)
class Curves:
    """The curves of a run.

    Attributes:
        episode_steps, returns: ``(E,)``; thinned, each return a mean over neighbouring episodes.
        smooth: ``(E,)``, their moving average.
        steps, scores, errors: ``(N,)`` of the evaluations; the errors are standard errors.
        values, discounted, discounted_errors: ``(N, G)``, predicted and observed discounted returns of the evaluations
            and the standard errors of the observed ones; G = 0 without any.
        episodes: how many have ended.
        best: index of the best evaluation; None before the first.
    """

    episode_steps: np.ndarray
    returns: np.ndarray
    smooth: np.ndarray
    steps: np.ndarray
    scores: np.ndarray
    errors: np.ndarray
    values: np.ndarray
    discounted: np.ndarray
    discounted_errors: np.ndarray
    episodes: int
    best: int | None

    @property
    def in_words(self) -> str:
        """The last return and the best evaluation."""
        words = []
        if self.episodes:
            words.append(f"return now {self.smooth[-1]:,.4g} over {self.episodes:,} episodes")
        if self.best is not None:
            at = self.best
            error = f" ± {self.errors[at]:.2g}" if self.errors[at] else ""
            words.append(f"best evaluation {self.scores[at]:,.4g}{error} at step {self.steps[at]:,}")
        return " · ".join(words) or "no episode has ended yet"


class Reader:
    """Follows the metrics of one run."""

    def __init__(self, path: str | Path):
        self.path, self._lock = Path(path), threading.Lock()  # several pages may look at a time
        self._restart()

    def _restart(self) -> None:
        self._offset, self._mark, self._skipping = 0, b"", False
        self._bins: list[tuple[float, float, int]] = []  # last step, sum of returns, episodes
        self._per_bin = 1
        self._evaluations: list[
            tuple[float, float, float, tuple[float, ...], tuple[float, ...], tuple[float, ...]]
        ] = []
        self._curves: Curves | None = None
        self.behind = False

    def look(self) -> Curves:
        """The curves so far; the same object while nothing is new. ``behind`` says whether more was there to read."""
        with self._lock:
            data = self._new()
            for line in data.splitlines():
                self._take(line)
            if data or self._curves is None:
                self._curves = self._drawn()
            return self._curves

    def _new(self) -> bytes:
        """Whole lines that were not read yet, at most ``_AT_ONCE`` bytes of them."""
        try:
            handle = os.open(self.path, PLAIN)
        except OSError:  # not there yet, or removed
            self._restart()
            return b""
        status = os.fstat(handle)
        if not stat.S_ISREG(status.st_mode):
            os.close(handle)
            return b""
        with os.fdopen(handle, "rb") as file:
            if self._offset:
                file.seek(self._offset - len(self._mark))
                if file.read(len(self._mark)) != self._mark:  # cut back at a resume point
                    self._restart()
            file.seek(self._offset)
            data = file.read(_AT_ONCE)
            end = data.rfind(b"\n") + 1
            if not end and len(data) > _LONGEST_LINE:  # a line that is none of ours: leave it out
                self._skipping, end = True, len(data)
            self._offset += end
            self._mark = (self._mark + data[:end])[-_MARK:]
            self.behind = status.st_size > self._offset and len(data) == _AT_ONCE
        data = data[:end]
        if self._skipping and b"\n" in data:
            self._skipping, data = False, data.partition(b"\n")[2]
        return b"" if self._skipping else data

    def _take(self, line: bytes) -> None:
        if len(line) > _LONGEST_LINE:
            return
        try:
            about = json.loads(line)
            kind, step = about["event"], _number(about["step"])
            if kind == "Episode":
                self._add_episode(step, _number(about["episode_return"]))
            elif kind == "Evaluation":
                one, other, third = (tuple(map(_number, about.get(name) or ())) for name in _BY_DISCOUNT)
                if not len(one) == len(other) == len(third) <= 1000:
                    one = other = third = ()
                score, error = _number(about["score"]), _number(about["standard_error"])
                self._evaluations.append((step, score, error, one, other, third))
                if len(self._evaluations) > MOST_EVALUATIONS:
                    best = max(self._evaluations, key=lambda one: one[1])
                    last = len(self._evaluations) - 1
                    self._evaluations = [e for i, e in enumerate(self._evaluations) if i % 2 or e is best or i == last]
        except (ValueError, TypeError, KeyError, AttributeError, RecursionError):  # written by somebody else
            return

    def _add_episode(self, step: float, total: float) -> None:
        if self._bins and self._bins[-1][2] < self._per_bin:
            _, earlier, count = self._bins[-1]
            self._bins[-1] = step, earlier + total, count + 1
        else:
            self._bins.append((step, total, 1))
        if len(self._bins) > MOST_POINTS:
            pairs = zip(self._bins[::2], [*self._bins[1::2], (0.0, 0.0, 0)], strict=False)
            self._bins = [(max(a[0], b[0]), a[1] + b[1], a[2] + b[2]) for a, b in pairs]
            self._per_bin *= 2

    def _drawn(self) -> Curves:
        bins = np.array(self._bins, dtype=float).reshape(-1, 3)
        steps, sums, counts = bins.T
        width = max(_LEAST_SMOOTHING, round(_SMOOTHING * len(bins)))
        smooth, around = _sum_around(sums, width), _sum_around(counts, width)
        evaluations = self._evaluations
        heads = len(evaluations[-1][3]) if evaluations else 0
        missing = (math.nan,) * heads
        lists = (
            [each if len(each) == heads else missing for each in some]
            for some in ([e[3] for e in evaluations], [e[4] for e in evaluations], [e[5] for e in evaluations])
        )
        by_discount = [np.array(part, dtype=float).reshape(len(evaluations), heads) for part in lists]
        scores = np.array([e[1] for e in evaluations])
        return Curves(
            steps, sums / np.maximum(counts, 1), smooth / np.maximum(around, 1),
            np.array([e[0] for e in evaluations]), scores,
            np.array([e[2] for e in evaluations]), by_discount[0], by_discount[1], by_discount[2],
            int(counts.sum()), len(scores) - 1 - int(scores[::-1].argmax()) if evaluations else None,
        )  # fmt: skip


def _sum_around(values: np.ndarray, width: int) -> np.ndarray:
    """The sum over each value and its ``width`` neighbours on either side, ``(E,)``."""
    if not len(values):
        return values
    return np.convolve(values, np.ones(2 * width + 1))[width : width + len(values)]


def _number(value: object) -> float:
    if isinstance(value, bool) or not isinstance(value, int | float) or not abs(value) < 1e15:  # NaN fails as well
        raise ValueError("no number")
    return value


def metrics_csv(path: str | Path) -> bytes:
    """Episodes and evaluations of a run, a row each; what an event does not have is left empty."""
    columns = ("event", "step", "episode", "head", "episode_return", "length", "truncated", "epsilon", "loss", "score",
               "standard_error", "episodes", "best", "seconds")  # fmt: skip
    text = io.StringIO()
    rows = csv.writer(text, lineterminator="\n")
    rows.writerow(columns)
    with open(path, encoding="utf-8", errors="replace") as lines:
        for line in lines:
            try:
                about = json.loads(line)
                if about["event"] in ("Episode", "Evaluation"):
                    values = (about.get(name) for name in columns)
                    rows.writerow([no_formula(value) if isinstance(value, str) else value for value in values])
            except (ValueError, TypeError, KeyError, RecursionError):
                continue
    return text.getvalue().encode()
