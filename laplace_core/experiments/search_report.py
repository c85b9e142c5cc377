"""What a search has found, as a table; and searches that are kept, read again."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from laplace_core.errors import InputError
from laplace_core.files.strict_json import parse_json

MOST_BYTES = 10_000_000
_LARGEST, _STEPS = 1e12, re.compile("[0-9]{1,10}")
Found = Mapping[str, Any]
"""What ``search.json`` holds."""


def table(rows: Sequence[Mapping[str, Any]], *, one_at_a_time: bool) -> str:
    """The best first, with the score of every seed; one at a time, against the unchanged settings.

    ``value off`` is the value at the starts less the discounted return that came, of the seed where it is farthest off.
    """
    base = rows[0]["median"] if one_at_a_time else None
    width = 8 * len(rows[0]["scores"])
    change = "" if base is None else f"{'change':>8}"
    lines = [f"{'median':>8}{change}  {'every seed':>{width}}  {'value off':>9}  settings"]
    for row in sorted(rows, key=lambda row: -row["median"]):
        words = ", ".join(f"{name} {value}" for name, value in row["trial"].items()) or "as in the file"
        change = "" if base is None else f"{row['median'] - base:>+8.1f}"
        scores = "".join(f"{score:>8.1f}" for score in row["scores"])
        error = max((each for each in row["value_errors"] if each is not None), key=abs, default=None)
        off = f"{'':>9}" if error is None else f"{error:>+9.1f}"
        lines.append(f"{row['median']:>8.1f}{change}  {scores}  {off}  {words}")
    return "\n".join(lines)


def report(paths: Sequence[Path]) -> tuple[list[Found], str]:
    """Searches that are kept: what each file holds, and their commands and tables as text.

    Raises:
        InputError: a file that cannot be read or is no result of a search.
    """
    kept = [read(path) for path in paths]
    return kept, "\n\n".join(_text(found) for found in kept)


def _text(found: Found) -> str:
    rows = found["trials"]
    hours = sum(row["seconds"] for row in rows) / 3600
    steps = sum(int(row["trial"].get("steps", found["settings"]["steps"])) for row in rows) * found["seeds"]
    about = f"{len(rows) * found['seeds']} trainings, {steps:,} steps, {hours:.1f} hours of one core"
    return f"{found['command']}\n{about}\n{table(rows, one_at_a_time=found['one_at_a_time'])}"


def read(path: Path) -> Found:
    """A ``search.json``.

    Raises:
        InputError: it cannot be read or is no result of a search.
    """
    try:
        text = path.read_bytes() if path.stat().st_size <= MOST_BYTES else b""
    except OSError as error:
        raise InputError(f"{path} cannot be read: {(error.strerror or 'unknown error').lower()}.") from None
    found = parse_json(text, path.name)
    if not _is_search(found):
        raise InputError(f"{path} is no result of a search: name the search.json of one.")
    return found


def _is_search(found: object) -> bool:
    if not isinstance(found, dict) or not isinstance(found.get("settings"), dict):
        return False
    rows, seeds = found.get("trials"), found.get("seeds")
    return (
        isinstance(found.get("command"), str)
        and isinstance(found.get("one_at_a_time"), bool)
        and _is_number(found["settings"].get("steps"))
        and isinstance(rows, list)
        and len(rows) > 0
        and all(isinstance(row, dict) and _is_row(row, seeds) for row in rows)
    )


def _is_row(row: Mapping[str, Any], seeds: object) -> bool:
    scores, errors, trial = row.get("scores"), row.get("value_errors"), row.get("trial")
    return (
        isinstance(trial, dict)
        and _STEPS.fullmatch(str(trial.get("steps", "1"))) is not None
        and isinstance(scores, list)
        and isinstance(errors, list)
        and len(scores) == len(errors) == seeds
        and all(_is_number(each) for each in (row.get("median"), row.get("seconds"), *scores))
        and all(each is None or _is_number(each) for each in errors)
    )


def _is_number(value: object) -> bool:
    return isinstance(value, int | float) and abs(value) <= _LARGEST
