"""The committed results, read again when a file has changed."""

from __future__ import annotations

from contextlib import suppress
from pathlib import Path

from app.catalogue.checkpoints import SHIPPED
from laplace_core.caching import cached
from laplace_core.experiments.paper.claims import ENTRIES, Entry, Found, look

FOLDER = Path(__file__).resolve().parents[2] / "docs" / "paper"


def found() -> list[Found]:
    """The findings on every entry, in the order of the catalogue."""
    return [_found(entry.name, FOLDER, _stamp(entry)) for entry in ENTRIES]


@cached(64)
def _found(name: str, folder: Path, stamp: tuple[tuple[int, int], ...]) -> Found:
    return look(next(entry for entry in ENTRIES if entry.name == name), folder, SHIPPED)


def _stamp(entry: Entry) -> tuple[tuple[int, int], ...]:
    """The time and the size of each file of an entry; nothing for missing files."""
    found = []
    for path in entry.files(FOLDER, SHIPPED):
        with suppress(OSError):
            status = path.stat()
            found.append((status.st_mtime_ns, status.st_size))
    return tuple(found)
