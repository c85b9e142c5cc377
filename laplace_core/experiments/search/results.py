"""The results of a search as a table, and saved searches, read again."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from laplace_core.errors import InputError
from laplace_core.files.strict_json import parse_json

MOST_BYTES = 10_000_000
_MOST_LISTED = 100
_LARGEST, _STEPS = 1e12, re.compile("[0-9]{1,10}")
SearchResult = Mapping[str, Any]
"""The content of a ``search.json``."""


def in_words(trial: Mapping[str, Any]) -> str:
    """The changes of a trial, in words."""
    short = {name: f"{value:.4g}" if isinstance(value, float) else value for name, value in trial.items()}
    return ", ".join(f"{name} {value}" for name, value in short.items()) or "as in the file"


def table(rows: Sequence[Mapping[str, Any]], *, one_at_a_time: bool) -> str:
    """The best first, with the score of every seed; one at a time, against the unchanged settings.

    ``value off`` is the predicted less the observed discounted return at the starts, of the seed where that is largest.
    Trials that were pruned stand below the others, with the last median that they reported.
    """
    base = next((row["median"] for row in rows if not row["trial"]), None) if one_at_a_time else None
    width = 8 * max(len(row["scores"]) for row in rows)
    change = "" if base is None else f"{'change':>8}"
    lines = [f"{'median':>8}{change}  {'every seed':>{width}}  {'value off':>9}  settings"]
    for row in sorted(rows, key=lambda row: (row.get("pruned", False), -row["median"])):
        words = in_words(row["trial"])
        change = "" if base is None else f"{row['median'] - base:>+8.1f}"
        scores = "".join(f"{score:>8.1f}" for score in row["scores"]) or f"{'pruned':>{max(width, 10)}}"
        error = max((each for each in row["value_errors"] if each is not None), key=abs, default=None)
        off = f"{'':>9}" if error is None else f"{error:>+9.1f}"
        lines.append(f"{row['median']:>8.1f}{change}  {scores}  {off}  {words}")
    return "\n".join(lines)


def report(paths: Sequence[Path]) -> tuple[list[SearchResult], str]:
    """Saved searches: the content of each file, and their commands and tables as text.

    Raises:
        InputError: a file that cannot be read or is no result of a search.
    """
    searches = [read(path) for path in paths]
    return searches, "\n\n".join(_text(search) for search in searches)


def _text(search: SearchResult) -> str:
    rows = search["trials"]
    hours = sum(row["seconds"] for row in rows) / 3600
    steps = sum(int(row["trial"].get("steps", search["settings"]["steps"])) for row in rows) * search["seeds"]
    pruned = sum(bool(row.get("pruned")) for row in rows)
    early = f", {pruned} of {len(rows)} trials pruned" if pruned else ""
    most = "at most " if pruned else ""
    about = f"{len(rows) * search['seeds']} trainings, {most}{steps:,} steps, {hours:.1f} hours of one core{early}"
    return f"{search['command']}\n{about}\n{table(rows, one_at_a_time=search['one_at_a_time'])}"


def kept(committed: Path, runs: Path) -> dict[str, Path]:
    """Searches that there are, the newest first: in the folders of runs, then those that ship; each by its name."""
    own = [each for pattern in ("search.json", "*/search.json") for each in runs.glob(pattern)]
    own = sorted((each for each in own if each.is_file()), key=lambda each: -each.stat().st_mtime)
    named = {f"{each.parent.name}, run here": each for each in own[:_MOST_LISTED]}
    return named | {each.stem: each for each in sorted(committed.glob("*.json"))}


def read(path: Path) -> SearchResult:
    """A ``search.json``.

    Raises:
        InputError: it cannot be read or is no result of a search.
    """
    try:
        text = path.read_bytes() if path.stat().st_size <= MOST_BYTES else b""
    except OSError as error:
        raise InputError(f"{path} cannot be read: {(error.strerror or 'unknown error').lower()}.") from None
    search = parse_json(text, path.name)
    if not _is_search(search):
        raise InputError(f"{path} is no result of a search: name the search.json of one.")
    return search


def _is_search(content: object) -> bool:
    if not isinstance(content, dict) or not isinstance(content.get("settings"), dict):
        return False
    rows, seeds = content.get("trials"), content.get("seeds")
    return (
        isinstance(content.get("command"), str)
        and isinstance(content.get("one_at_a_time"), bool)
        and _is_number(content["settings"].get("steps"))
        and isinstance(rows, list)
        and len(rows) > 0
        and all(isinstance(row, dict) and _is_row(row, seeds) for row in rows)
    )


def _is_row(row: Mapping[str, Any], seeds: object) -> bool:
    scores, errors, trial = row.get("scores"), row.get("value_errors"), row.get("trial")
    return (
        isinstance(trial, dict)
        and all(isinstance(value, str | bool) or _is_number(value) for value in trial.values())
        and _STEPS.fullmatch(str(trial.get("steps", "1"))) is not None
        and isinstance(scores, list)
        and isinstance(errors, list)
        and len(scores) == len(errors) == (0 if row.get("pruned") is True else seeds)
        and all(_is_number(each) for each in (row.get("median"), row.get("seconds"), *scores))
        and all(each is None or _is_number(each) for each in errors)
    )


def _is_number(value: object) -> bool:
    return isinstance(value, int | float) and abs(value) <= _LARGEST
