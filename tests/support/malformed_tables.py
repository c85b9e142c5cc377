"""Numbers and cells as people of other habits write them: tables of a world, timelines, and what both share."""

from __future__ import annotations

from collections.abc import Iterator

NEAR_NUMBERS = (
    *("5,0", "5.000,00", "1,000", "1 000", "1'000", "1_000", "5 €", "$5", "50%", "50 %", "1/2", "1:2", "5-1", "5..6"),
    *(
        "\u22125",
        "\u20135",
        "\uff15",
        "\u00bd",
        "\u221e",
        "5\u00d7",
        "5k",
        "5M",
        "five",
        "V",
        "1e",
        "1e+",
        "e1",
        "10^2",
    ),
    *(
        "10**2",
        "1.5.0",
        "+-5",
        "- 5",
        "+ 5",
        "--5",
        "~5",
        "\u22485",
        "<5",
        ">=5",
        "=5",
        "(5)",
        "[5]",
        "{5}",
        "5;",
        "5!",
    ),
    *(
        "0x5",
        "0b1",
        "5f",
        "5d0",
        "5L",
        "5j",
        "NaN",
        "inf",
        "-Infinity",
        "None",
        "null",
        "true",
        "#5",
        "n/a",
        "?",
        "TBD",
    ),
)
"""Texts that mean a number to somebody, and none to us."""

NEAR_ENDS = ("end", "End", "END.", "TERMINAL", "terminal", "Terminated", "done", "stop", "goal", "exit", "-1", "*")

ROWS = [
    {"state": "start", "action": "go", "probability": 0.5, "reward": 1.0, "next": "late"},
    {"state": "start", "action": "go", "probability": 0.5, "reward": 0.0, "next": "END"},
    {"state": "late", "action": "go", "probability": 1.0, "reward": 2.5, "next": "END"},
]
TIMELINE = [
    {"action": "go", "tau": 0, "reward": 1.0, "probability": 1.0},
    {"action": "go", "tau": 2, "reward": 2.5, "probability": 0.5},
]
_COLUMNS = {
    "state": ("State", "s", "from", "states", "node", "state "),
    "action": ("Action", "a", "act", "actions", "choice", "act."),
    "probability": ("Probability", "p", "prob", "P", "chance", "weight", "%"),
    "reward": ("Reward", "r", "value", "payoff", "rewards", "return"),
    "next": ("Next", "next_state", "next state", "to", "s'", "successor", "target"),
    "tau": ("Tau", "t", "time", "step", "delay", "\u03c4", "n"),
}

Case = tuple[str, list[dict], str | None]
"""What it is, the rows, and a word of the refusal; None where they mean the same as the rows as they stand."""


def _changed(rows: list[dict], number: int, **cells: object) -> list[dict]:
    return [row | cells if i == number else row for i, row in enumerate(rows)]


def _common(rows: list[dict], numeric: tuple[str, ...], number: int) -> Iterator[Case]:
    for column in numeric:
        for cell in NEAR_NUMBERS:
            yield f"{column} {cell!r}", _changed(rows, number, **{column: cell}), f"row {number + 1}, {column}"
        for cell in (f"{rows[number][column]}", f" {rows[number][column]} ", f"{rows[number][column]:.3e}"):
            yield f"{column} {cell!r}", _changed(rows, number, **{column: cell}), None
    for column in rows[0]:
        for name in _COLUMNS[column]:
            renamed = [{name if key == column else key: cell for key, cell in row.items()} for row in rows]
            yield f"column {name!r} for {column}", renamed, f"row 1 has no {column}"


def world_tables() -> Iterator[Case]:
    """Near-misses of ``ROWS``."""
    yield from _common(ROWS, ("probability", "reward"), 2)
    for cell in (*NEAR_ENDS, "late.", "Late", "late,", "LATE", "late start"):
        yield f"next {cell!r}", _changed(ROWS, 0, next=cell), "row 1, next"
    for cell in (" late", "late ", "\tlate"):
        yield f"next {cell!r}", _changed(ROWS, 0, next=cell), None
    for cell in (0, 1, 1.0, True, ["start"], {"start": 1}):
        yield f"state {cell!r}", _changed(ROWS, 0, state=cell), "row 1, state"
        yield f"action {cell!r}", _changed(ROWS, 0, action=cell), "row 1, action"
        yield f"next {cell!r}", _changed(ROWS, 0, next=cell), "row 1, next"
    for cell in ("*", "END"):
        yield f"state {cell!r}", _changed(ROWS, 2, state=cell), "row 3, state"
        yield f"action {cell!r}", _changed(ROWS, 2, action=cell), "row 3, action"
    for cells in ((50, 50), (5, 5), (0.33, 0.66), (0.5, 0), (1, 1), (0.5, 0.49), (-0.5, 1.5), ("50%", "50%")):
        rows = _changed(_changed(ROWS, 0, probability=cells[0]), 1, probability=cells[1])
        yield f"probabilities {cells}", rows, "probabilit"
    for name in ("Start", "START", "start.", "state start"):
        yield f"another state {name!r}", _changed(ROWS, 1, state=name), "add up to"


def timelines() -> Iterator[Case]:
    """Near-misses of ``TIMELINE``."""
    yield from _common(TIMELINE, ("tau", "reward", "probability"), 1)
    for cell in (1.5, "1.5", "0.5", -1, "-1", 501, "501", 1.0001, "2.0001", "1st", "t2", "tau 2", "2s", "2 steps"):
        yield f"tau {cell!r}", _changed(TIMELINE, 1, tau=cell), "row 2, tau"
    for cell in (2.0, "2", "2.0", "02", "2e0"):
        yield f"tau {cell!r}", _changed(TIMELINE, 1, tau=cell), None
    for cell in (0, 1, True, ["go"], "END", "*", {"go": 1}):
        yield f"action {cell!r}", _changed(TIMELINE, 1, action=cell), "row 2"
    for cell in (50, 100, 1.5, -0.5, "150e-2"):
        yield f"probability {cell!r}", _changed(TIMELINE, 1, probability=cell), "row 2, probability"
