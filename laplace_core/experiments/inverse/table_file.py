"""A CSV table that grows group by group, and that a stopped process leaves whole."""

from __future__ import annotations

import csv
import io
import os
from collections import Counter
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from laplace_core.errors import InputError
from laplace_core.files.atomic import write_whole

MOST_BYTES = 2_000_000_000


def whole_groups(text: str) -> str:
    """What of a table's text was written to the end: a group ends with an empty line; empty before the first one."""
    return text[: text.rfind("\n\n") + 2] if "\n\n" in text else ""


def rows_in(text: str) -> list[dict[str, str]]:
    """The rows of a table's text, behind its comment and its header."""
    table = csv.DictReader(io.StringIO(text.partition("\n")[2]))
    return [row for row in table if None not in row.values()]


class TableFile:
    """Rows in a CSV file behind a comment and a header.

    Rows of one group are appended by a single write. What a process that was killed had written in part is cut off when
    the file is opened again.

    Args:
        columns: names of the columns.
        groups: those of them that tell one group from another.
        about: the comment, which has to be the same when a file is gone on with.

    Raises:
        InputError: a file that is no such table.
    """

    def __init__(self, path: Path, columns: Sequence[str], groups: Sequence[str], about: str):
        self.path, self._columns, self._groups = path, tuple(columns), tuple(groups)
        self._head = f"# {about}\n{','.join(columns)}\n"
        if not path.exists():
            try:
                path.parent.mkdir(parents=True, exist_ok=True)
            except OSError as error:
                reason = (error.strerror or "unknown").lower()
                raise InputError(f"the folder {path.parent} cannot be made: {reason}.") from None
            write_whole(path, self._head.encode())
            return
        if path.stat().st_size > MOST_BYTES:
            raise InputError(f"{path} is larger than {MOST_BYTES / 1e9:g} GB: it is no table of a study.")
        text = path.read_bytes().decode(errors="replace")
        if not text.startswith(self._head):
            raise InputError(f"{path} is no table of a study like this one: name another file with --out.")
        whole = whole_groups(text) or self._head
        if whole != text:
            write_whole(path, whole.encode())

    def key(self, row: Mapping[str, Any]) -> tuple[str, ...]:
        """The group that a row belongs to."""
        return tuple(str(row[name]) for name in self._groups)

    def rows(self) -> list[dict[str, str]]:
        """All rows, as text."""
        return rows_in(self.path.read_text(encoding="utf-8"))

    def counts(self) -> Counter[tuple[str, ...]]:
        """How many rows each group has."""
        return Counter(self.key(row) for row in self.rows())

    def append(self, rows: Sequence[Mapping[str, Any]]) -> None:
        """Add the rows of one group."""
        text = io.StringIO()
        csv.DictWriter(text, self._columns, lineterminator="\n").writerows(rows)
        with self.path.open("ab") as file:
            file.write(f"{text.getvalue()}\n".encode())
            file.flush()
            os.fsync(file.fileno())
