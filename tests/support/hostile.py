"""What every refusal of hostile input must look like, whoever refuses it."""

from __future__ import annotations

import re
from pathlib import Path

from laplace_core.cli import main

OLD = b"what was there before"
"""Content of the --out file that a refused command must leave alone."""


def assert_one_sentence(message: str, *named: str) -> None:
    """One printable line of a readable length, without Python's own words, that names the entry at fault."""
    assert message.isprintable()
    assert 15 <= len(message) <= 500
    assert message.endswith((".", ")"))
    assert not re.search(r"Traceback|object at 0x|<class|[A-Z]\w+Error|NoneType", message)
    for entry in named:
        assert entry in message, f"{entry!r} is not named in: {message}"


def assert_refused(capsys, words: list[str], *named: str) -> None:
    """``words`` end with status 2, one sentence on stderr and nothing on stdout."""
    capsys.readouterr()
    status = main(words)
    out, err = capsys.readouterr()
    assert status == 2
    assert out == ""
    assert err.startswith("laplace: ")
    assert err.endswith("\n")
    assert_one_sentence(err[:-1], *named)


def assert_nothing_written(capsys, words: list[str], folder: Path, *named: str) -> None:
    """As :func:`assert_refused`, with an --out file that exists: it stays, and no other file comes."""
    out = folder / "out.npz"
    out.write_bytes(OLD)
    before = sorted(folder.iterdir())
    assert_refused(capsys, [*words, "--out", str(out)], *named)
    assert sorted(folder.iterdir()) == before
    assert out.read_bytes() == OLD
