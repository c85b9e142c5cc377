"""Files appear whole or not at all."""

import os
import signal
import subprocess
import sys
import time

import pytest

from laplace_core import InputError
from laplace_core.files import atomic
from laplace_core.files.atomic import atomic_write
from tests.support.hostile import assert_one_sentence


def test_a_file_takes_the_place_of_the_old_one_when_the_block_ends(tmp_path):
    path = tmp_path / "file"
    for content in (b"first", b"second"):
        with atomic_write(path) as file:
            file.write(content)
            file.flush()
            assert not path.exists() or path.read_bytes() == b"first"
        assert path.read_bytes() == content
    assert [entry.name for entry in tmp_path.iterdir()] == ["file"]
    assert path.stat().st_mode & 0o777 == 0o644


def fail_halfway(path, error: BaseException) -> None:
    with atomic_write(path) as file:
        file.write(b"half")
        raise error


@pytest.mark.parametrize(
    "error", [OSError(28, "No space left on device"), OSError("odd"), ValueError("no"), SystemExit()]
)
@pytest.mark.parametrize("before", [None, b"old"])
def test_a_block_that_fails_leaves_what_was_there(tmp_path, error, before):
    path = tmp_path / "file"
    if before is not None:
        path.write_bytes(before)
    with pytest.raises(InputError if isinstance(error, OSError) else type(error)) as raised:
        fail_halfway(path, error)
    if isinstance(error, OSError):
        assert_one_sentence(f"laplace: {raised.value}", "file", "cannot be written")
    assert list(tmp_path.iterdir()) == ([path] if before is not None else [])
    assert before is None or path.read_bytes() == before


def test_places_that_cannot_be_written_are_refused(tmp_path):
    (tmp_path / "file").touch()
    (tmp_path / "folder").mkdir()
    for name in ("missing/file", "file/file", "x" * 300, "zero\0byte", "folder"):
        with pytest.raises(InputError) as refused, atomic_write(tmp_path / name) as file:
            file.write(b"content")
        assert_one_sentence(f"laplace: {refused.value}", name[:4])
    assert sorted(entry.name for entry in tmp_path.iterdir()) == ["file", "folder"]


KILLED = """
import os, signal, sys
from laplace_core.files import atomic
if sys.argv[2] == "named":
    atomic._NAMELESS = 0
with atomic.atomic_write(sys.argv[1]) as file:
    file.write(b"half")
    os.kill(os.getpid(), int(sys.argv[3]))
"""


def killed(path, kind: str, number: int) -> list[str]:
    """What is left in the folder by a process that was killed while it wrote."""
    done = subprocess.run([sys.executable, "-c", KILLED, str(path), kind, str(number)], capture_output=True)
    assert done.returncode == -number
    return [entry.name for entry in path.parent.iterdir()]


@pytest.mark.skipif(not atomic._NAMELESS, reason="this system has no files without a name")
def test_a_process_that_is_killed_while_it_writes_leaves_nothing(tmp_path):
    for number in (signal.SIGKILL, signal.SIGTERM):
        assert killed(tmp_path / "file", "nameless", number) == []


def test_what_a_killed_process_left_is_cleared_when_the_file_is_written_again(tmp_path, monkeypatch):
    """Where files have names from the first moment; what is young may belong to a process that still writes."""
    path = tmp_path / "file[1]"
    (left,) = killed(path, "named", signal.SIGKILL)
    (tmp_path / "mine.tmp").touch()
    os.utime(tmp_path / "mine.tmp", (0, 0))
    monkeypatch.setattr(atomic, "_NAMELESS", 0)
    for age, kept in ((60, {left}), (7_200, set())):
        os.utime(tmp_path / left, (time.time() - age, time.time() - age))
        with atomic_write(path) as file:
            file.write(b"whole")
        assert {entry.name for entry in tmp_path.iterdir()} == {path.name, "mine.tmp", *kept}
    assert path.stat().st_mode & 0o777 == 0o644


def test_a_folder_that_knows_no_nameless_files_is_written_as_well(tmp_path, monkeypatch):
    monkeypatch.setattr(atomic, "_nameless", lambda folder: None)
    with atomic_write(tmp_path / "file") as file:
        file.write(b"whole")
    assert (tmp_path / "file").read_bytes() == b"whole"
    assert len(list(tmp_path.iterdir())) == 1
