"""The documents in the workbench: each opens, a link leads to one, and a link to none is refused with a sentence."""

from __future__ import annotations

from urllib.parse import parse_qsl

import pytest

from laplace_core.files.documents import titles
from tests.support.pages import opened


@pytest.mark.parametrize("name", titles())
def test_every_document_opens_by_its_link(name):
    page = opened(screen="guide", page=name)
    assert page.markdown[0].value.startswith(f"# {titles()[name]}")
    assert page.radio[0].value == name
    assert not page.warning


def test_another_document_is_chosen_and_the_link_follows():
    page = opened(screen="guide")
    first, second, *_ = titles()
    assert page.radio[0].value == first
    page.radio[0].set_value(second).run()
    assert page.markdown[0].value.startswith(f"# {titles()[second]}")
    assert page.query_params["page"] == second


def test_a_link_to_no_document_shows_the_first_and_says_so():
    page = opened(screen="guide", page="../../etc/passwd")
    assert page.radio[0].value == next(iter(titles()))
    (warning,) = page.warning
    assert "Left out of the link" in warning.value


def test_how_to_read_the_page_leads_to_the_concepts():
    (link,) = opened("reading").get("page_link")
    assert link.proto.query_string == "page=concepts"


@pytest.mark.parametrize("screen", ["inverse", "agents", "race", "train", "paper"])
def test_every_other_page_has_a_link_to_its_guide(screen):
    links = [dict(parse_qsl(link.proto.query_string)) for link in opened(screen=screen).get("page_link")]
    assert any(titles().get(link.get("page", ""), "") for link in links)
