"""Links and files that nobody means well by: each is shown, or refused with a sentence, and costs little memory.

``python -m bench.hold`` opens many more of them in a browser.
"""

from __future__ import annotations

import resource
from itertools import cycle
from urllib.parse import parse_qsl, urlsplit

import pytest
from streamlit.testing.v1 import AppTest

from app.agents import schema as agents
from app.inverse import schema as inverse
from app.race import schema as race
from app.train import schema as train
from app.worlds import schema as worlds
from tests.support.hostile_inputs import LINKS, files, links
from tests.support.pages import MAIN, PATIENCE, opened

MEMORY = 400_000
"""Kilobytes by which all of them together may raise the process's peak."""


def follow(link: str) -> AppTest:
    """The page of a link."""
    parts = urlsplit(link)
    page = AppTest.from_file(MAIN, default_timeout=PATIENCE)
    page.switch_page(f"screens/{parts.path.strip('/') or 'worlds'}.py")
    for name, value in parse_qsl(parts.query, keep_blank_values=True):
        page.query_params[name] = value
    return page.run()


def assert_told_well(page: AppTest) -> None:
    assert not page.exception
    for block in (*page.error, *page.warning):
        assert block.value
        assert "Traceback" not in block.value
        assert len(block.value) < 900


@pytest.fixture
def memory():
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    yield
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before < MEMORY


def test_no_link_breaks_a_page(subtests, memory):
    """A link of each kind, but for those that are merely large: they take long."""
    for kind, link in zip(LINKS, links(len(LINKS), seed=1), strict=True):
        with subtests.test(f"{kind.__name__} {link[:120]}"):
            if kind.__name__ not in ("_large", "_giant"):
                assert_told_well(follow(link))


def test_whatever_a_link_holds_its_notes_are_sentences(subtests, memory):
    schemas = {"": worlds, "inverse": inverse, "agents": agents, "race": race, "train": train}
    for kind, link in zip(cycle(LINKS), links(120, seed=2), strict=False):
        parts = urlsplit(link)
        if kind.__name__ not in ("_large", "_giant"):
            with subtests.test(link[:120]):
                _, notes = schemas[parts.path.strip("/")].LINK.read(
                    dict(parse_qsl(parts.query, keep_blank_values=True))
                )
                for note in notes:
                    assert note.endswith((".", ")"))
                    assert len(note) < 900


def test_no_file_breaks_a_page(subtests, memory, capsys):
    pages = {"": opened("bring", world="two_branch"), "agents": opened(screen="agents")}
    for file in files(40, seed=1):
        with subtests.test(f"{file.name[:60]} of {len(file.content)} bytes"):
            page = pages[file.page]
            place = page.file_uploader[0]
            place.set_value((file.name, file.content, "application/octet-stream"))
            assert_told_well(page.run())
    assert "unpickled" not in capsys.readouterr().out
