"""Folders that can be written, and folders that are named by their content."""

from __future__ import annotations

import pytest

from laplace_core.files import folders
from laplace_core.files.folders import name_by_content, publish, temporary, writable

FILES = {"a.js": b"1", "inner/b.js": b"2"}


@pytest.fixture
def elsewhere(tmp_path, monkeypatch):
    """Another place for temporary folders."""
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    temporary.cache_clear()
    yield tmp_path
    temporary.cache_clear()


def test_the_wanted_folder_is_taken_where_it_can_be_written(tmp_path):
    assert writable(tmp_path / "new", "runs") == tmp_path / "new"
    assert writable(tmp_path, "runs") == tmp_path


def test_elsewhere_a_temporary_one_is_the_same_after_a_restart(elsewhere, monkeypatch):
    monkeypatch.setattr("os.access", lambda path, mode: False)
    found = writable(elsewhere / "new", "runs")
    assert found.is_dir()
    temporary.cache_clear()
    assert writable(elsewhere / "new", "runs") == found


def test_a_name_that_is_taken_by_something_else_is_left_alone(elsewhere):
    first = temporary("runs")
    temporary.cache_clear()
    first.rmdir()
    first.write_text("somebody else's")
    other = temporary("runs")
    assert other.is_dir()
    assert other != first
    assert first.read_text() == "somebody else's"


def test_a_folder_is_named_by_what_is_in_it_and_is_whole(tmp_path):
    found = publish(tmp_path / "js", FILES)
    assert {path.relative_to(found).as_posix(): path.read_bytes() for path in found.rglob("*.js")} == FILES
    assert publish(tmp_path / "js", FILES) == found
    assert publish(tmp_path / "js", FILES | {"a.js": b"3"}) != found
    assert name_by_content(b"ab", b"c") != name_by_content(b"a", b"bc")


def test_what_another_process_makes_at_the_same_moment_is_taken(tmp_path, monkeypatch):
    real = folders.os.rename

    def late(made, folder):
        real(made, folder)
        raise OSError("it is there")

    monkeypatch.setattr(folders.os, "rename", late)
    found = publish(tmp_path, FILES)
    assert list(tmp_path.iterdir()) == [found]
