"""Files appear whole or not at all."""

import pytest

from laplace_core import InputError
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
