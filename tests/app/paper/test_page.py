"""The page of the paper: a section for each entry, with all that belongs to it; damaged files harm no others."""

from __future__ import annotations

import json
import shutil
from html import unescape
from urllib.parse import parse_qsl

import plotly.graph_objects as go
import pytest

from app.agents import schema as agents
from app.paper import results
from app.race import schema as race
from app.train import schema as train
from app.worlds import schema as worlds
from laplace_core.experiments.paper.claims import ENTRIES, look
from tests.laplace_core.experiments.test_claims import AGENTS, COMMITTED
from tests.support.pages import charts, downloads, numbers, opened

SCHEMAS = {"worlds": worlds, "agents": agents, "race": race, "train": train}


def words(page) -> str:
    return unescape(" ".join(block.proto.body for block in page.get("html")))


def test_every_entry_has_a_section_with_all_that_belongs_to_it(monkeypatch):
    saved = downloads(monkeypatch)
    page = opened(screen="paper")
    assert not page.error
    assert not page.warning
    text = words(page)
    assert [code.value for code in page.code] == [entry.makes for entry in ENTRIES]
    for entry, found in zip(ENTRIES, results.found(), strict=True):
        assert f'id="paper-{entry.name}"' in text
        assert f'href="#paper-{entry.name}"' in text
        assert all(found.sentence(index)[:40] in text for index in range(len(entry.claims)))
    assert set(saved) == {f"{found.results.path.stem}.json" for found in results.found() if found.results.there}
    assert len(saved) > 5
    for name in saved.keys() - {"manifest.json", "searches.json"}:
        assert saved[name] == (COMMITTED / name).read_bytes()
    searches = sorted((COMMITTED.parent / "searches").glob("*.json"))
    assert json.loads(saved["searches.json"]) == [json.loads(path.read_text()) for path in searches]
    links = [link for link in page.get("page_link") if "guides" not in link.proto.query_string]
    assert len(links) == sum(entry.view is not None for entry in ENTRIES)
    assert {name for link in links for name, _ in parse_qsl(link.proto.query_string)} >= {"world", "d.T", "environment"}


def test_there_is_a_picture_of_all_that_is_measured_and_plotly_takes_it():
    drawn = charts(opened(screen="paper"))
    measured = {f"paper {each.entry.name}" for each in results.found() if each.results.there} - {"paper search"}
    assert set(drawn) == measured
    assert {"paper fig1_5", "paper fig3", "paper fig4", "paper fig6", "paper fig7", "paper table1"} <= measured
    for figure in drawn.values():
        go.Figure(figure)
    rescaled = [numbers(trace["y"]) for trace in drawn["paper fig4"]["data"][:2]]
    assert rescaled[0] == pytest.approx([5.0, 5.0, 5.0], abs=0.01)
    assert "the paper" in [trace["name"] for trace in drawn["paper table1"]["data"]]


@pytest.mark.parametrize("entry", [entry for entry in ENTRIES if entry.view], ids=lambda entry: entry.name)
def test_a_view_is_a_link_that_holds(entry):
    values, notes = SCHEMAS[entry.view.page].LINK.read(dict(entry.view.values))
    assert notes == []
    assert set(entry.view.values) <= set(values)


def test_a_damaged_and_a_missing_file_leave_the_other_sections_as_they_are(monkeypatch, tmp_path):
    folder = shutil.copytree(COMMITTED, tmp_path / "paper")
    (folder / "fig4.json").write_text('{"results": [')
    (folder / "fig6.json").unlink()
    monkeypatch.setattr(results, "FOLDER", folder)
    page = opened(screen="paper")
    assert set(charts(page)) == {
        f"paper {entry.name}" for entry in ENTRIES
        if entry.name not in ("fig4", "fig6", "search") and look(entry, COMMITTED, AGENTS).results.there
    }  # fmt: skip
    assert "fig4.json is not JSON" in words(page)
    assert "Not measured yet: python -m laplace_core reproduce fig6" in words(page)


def test_rows_that_cannot_be_drawn_are_one_sentence(monkeypatch, tmp_path):
    folder = shutil.copytree(COMMITTED, tmp_path / "paper")
    about = json.loads((folder / "fig6.json").read_text())
    (folder / "fig6.json").write_text(json.dumps(about | {"results": [{"part": {"values": "exact"}, "result": {}}]}))
    monkeypatch.setattr(results, "FOLDER", folder)
    page = opened(screen="paper")
    assert [warning.value for warning in page.warning] == ["fig6.json cannot be drawn: the file does not hold results."]
    assert "paper fig6" not in charts(page)


def test_a_link_to_it_holds_nothing():
    page = opened(screen="paper", world="two_branch")
    assert ["this page does not know" in warning.value for warning in page.warning] == [True]
