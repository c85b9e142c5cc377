"""Experiments that are measured on worlds, tabular learners and agents that ship: no long training comes first.

A measurement has parts, each a small dictionary of options. A part is measured by itself, in a process or on a node of
a cluster, and its result is a row of the measurement's file; one that has its row there is not measured again.
"""

from __future__ import annotations

import contextlib
import json
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from laplace_core.errors import InputError
from laplace_core.files.atomic import write_whole
from laplace_core.files.plain_json import as_json
from laplace_core.files.strict_json import parse_json
from laplace_core.files.versions import versions
from laplace_core.supervise.parallel import in_parallel

Options = Mapping[str, Any]
"""Numbers, words and None by name: what tells one part from another."""
Result = dict[str, Any]
Row = dict[str, Any]
"""A part, its result, and when, in how many seconds and with which versions it was measured."""
_MOST_BYTES = 50_000_000


@dataclass(frozen=True)
class Measurement:
    """A figure, table or claim of the paper that needs no training.

    Attributes:
        name: what ``reproduce`` calls it.
        title: what it is in the paper.
        question: what it asks.
        parts: what is measured one by one.
        measure: the result of a part: numbers, words, lists and dictionaries of them.
        summary: what all rows say together; rows of parts that are not measured yet are missing.
    """

    name: str
    title: str
    question: str
    parts: Sequence[Options]
    measure: Callable[[Options], Result]
    summary: Callable[[Sequence[Row]], Result]


@dataclass(frozen=True)
class Measured:
    """The outcome of one part: its row, or a sentence that says why there is none."""

    part: Options
    row: Row | None = None
    trouble: str | None = None


def rows_in(path: Path) -> list[Row]:
    """The rows of a measurement's file; none where there is no file.

    Raises:
        InputError: a file that is no measurement: it is not written over.
    """
    if not path.exists():
        return []
    with contextlib.suppress(OSError, TypeError, KeyError):
        rows = parse_json(path.read_bytes()[:_MOST_BYTES], path.name)["results"]
        if all(isinstance(row["part"], dict) and isinstance(row["result"], dict) for row in rows):
            return list(rows)
    raise InputError(f"{path} is no result of a measurement: move it away, or name another --out folder.")


def finished(measurement: Measurement, path: Path) -> list[Row]:
    """Rows of the parts that the measurement plans, in its order."""
    known = {_key(row["part"]): row for row in rows_in(path)}
    return [known[_key(part)] for part in measurement.parts if _key(part) in known]


def measure(
    measurement: Measurement,
    path: Path,
    stop: Callable[[], object],
    *,
    processes: int = 1,
    cluster: str | None = None,
) -> Iterator[Measured]:
    """Measure every part that has no row yet; the file holds each as soon as it is measured.

    Args:
        path: the measurement's file.
        stop: called between two parts; when it returns True, no more are begun.
        processes, cluster: as in :func:`laplace_core.supervise.parallel.in_parallel`.
    """
    done = {_key(row["part"]) for row in finished(measurement, path)}
    left = [part for part in measurement.parts if _key(part) not in done]
    save(measurement, path, [])
    if not left or stop():
        return
    calls = [(measurement.measure, dict(part)) for part in left]
    for i, outcome in in_parallel(_measured, calls, processes, cluster):
        if isinstance(outcome, str):
            yield Measured(left[i], trouble=outcome)
        else:
            save(measurement, path, [outcome])
            yield Measured(left[i], outcome)
        if stop():
            return


def _measured(call: tuple[Callable[[Options], Result], Options]) -> Row | str:
    """The row of a part, or the sentence of its refusal."""
    measured, part = call
    began = time.perf_counter()
    try:
        result = measured(part)
    except InputError as error:
        return str(error)
    seconds = round(time.perf_counter() - began, 2)
    date = datetime.now(UTC).date().isoformat()
    return {"part": dict(part), "result": result, "seconds": seconds, "date": date, "versions": versions()}


def save(measurement: Measurement, path: Path, rows: Sequence[Row]) -> None:
    """Bring the file up to date: the rows that are there and planned, and these; whole or not at all."""
    known = {_key(row["part"]): row for row in [*rows_in(path), *rows]}
    kept = [known[_key(part)] for part in measurement.parts if _key(part) in known]
    about = {
        "experiment": measurement.name,
        "title": measurement.title,
        "question": measurement.question,
        "command": f"python -m laplace_core reproduce {measurement.name}",
        "finished": len(kept),
        "planned": len(measurement.parts),
        "summary": measurement.summary(kept) if kept else {},
        "results": kept,
    }
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise InputError(f"the folder {path.parent} cannot be made: {(error.strerror or 'unknown').lower()}.") from None
    write_whole(path, as_json(about))


def _key(part: Options) -> str:
    return json.dumps(part, sort_keys=True)
