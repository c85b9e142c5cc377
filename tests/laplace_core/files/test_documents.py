"""The pages of ``docs/`` as plain Markdown: what they include, pictures and links."""

from __future__ import annotations

import re

import pytest

from laplace_core.files.documents import BUILT, FOLDER, Picture, parts, titles

ADDRESS = "guide?page="


@pytest.fixture
def folder(tmp_path):
    (tmp_path / "inner").mkdir()
    (tmp_path / "index.md").write_text(
        "# All\n\n```{toctree}\n:caption: Some\n\none\ninner/two\n```\n\n```{toctree}\nthree\n```\n"
    )
    (tmp_path / "one.md").write_text(
        "# One\n\nSee [two](inner/two.md#part) and [there](https://example.org/x.md).\n\n"
        "![a dot](dot.png)\n\nAfter it.\n\n```{literalinclude} conf.txt\n:language: text\n```\n"
    )
    (tmp_path / "inner" / "two.md").write_text("# Two\n\nBack to [one](../one.md).\n\n```{eval-rst}\n.. thing::\n```\n")
    (tmp_path / "three.md").write_text("```{include} text.md\n```\n")
    (tmp_path / "text.md").write_text("# Three\n\nWords.\n")
    (tmp_path / "conf.txt").write_text("listen 80;\n")
    return tmp_path


def test_titles_are_those_of_the_tables_of_contents_in_their_order(folder):
    assert list(titles(folder).items()) == [("one", "One"), ("inner/two", "Two"), ("three", "Three")]


def test_a_page_is_texts_and_pictures_with_links_to_other_pages(folder):
    first, picture, last = parts("one", ADDRESS, folder)
    assert first == ("# One\n\nSee [two](guide?page=inner/two#part) and [there](https://example.org/x.md).")
    assert picture == Picture(folder / "dot.png", "a dot")
    assert last == "After it.\n\n```\nlisten 80;\n```"


def test_what_only_sphinx_can_make_is_said(folder):
    assert list(parts("inner/two", ADDRESS, folder)) == [f"# Two\n\nBack to [one](guide?page=one).\n\n{BUILT}"]
    assert list(parts("three", ADDRESS, folder)) == ["# Three\n\nWords."]


def test_without_documents_there_are_no_titles(tmp_path):
    assert titles(tmp_path) == {}


def test_every_document_is_in_a_table_of_contents():
    there = {path.relative_to(FOLDER).with_suffix("").as_posix() for path in FOLDER.rglob("*.md")}
    there = {name for name in there if not name.startswith(("_", "paper/", "searches/"))}
    assert set(titles()) == there - {"index"}


@pytest.mark.parametrize("name", titles())
def test_every_document_stands_by_itself(name):
    for part in parts(name, ADDRESS):
        if isinstance(part, Picture):
            assert part.path.is_file()
            assert part.path.is_relative_to(FOLDER)
            assert len(part.words) > 10
        else:
            assert "```{" not in part
            for link in re.findall(r"\]\(guide\?page=([\w/-]+)", part):
                assert link in titles()
