"""The committed results, read again when a file has changed."""

from __future__ import annotations

from pathlib import Path

from app.catalogue.checkpoints import SHIPPED
from laplace_core.caching import cached
from laplace_core.experiments.paper.claims import ENTRIES, Entry, Found, look
from laplace_core.experiments.shipping import MANIFEST

FOLDER = Path(__file__).resolve().parents[2] / "docs" / "paper"


def found() -> list[Found]:
    """What the results say of every entry, in the order of the catalogue."""
    return [_found(entry.name, FOLDER, _stamp(entry)) for entry in ENTRIES]


@cached(64)
def _found(name: str, folder: Path, stamp: tuple[int, ...]) -> Found:
    return look(next(entry for entry in ENTRIES if entry.name == name), folder, SHIPPED)


def _stamp(entry: Entry) -> tuple[int, ...]:
    """When the file of an entry was written, and its size; nothing where there is none."""
    try:
        path = SHIPPED / MANIFEST if entry.read else FOLDER / f"{entry.name}.json"
        status = path.stat()
    except OSError:
        return ()
    return status.st_mtime_ns, status.st_size
