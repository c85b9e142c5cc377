"""One record for a session: nobody else keeps anything under a key of Streamlit's, and two sessions share nothing."""

from __future__ import annotations

import ast
from dataclasses import dataclass, field
from pathlib import Path

import pytest
import streamlit as st

from app import session
from tests.support.pages import choose, link, opened, run
from tests.support.pages import session as record_of

APP = Path(__file__).resolve().parents[3] / "app"
SCREENS = ("worlds", "inverse", "agents", "race", "train", "paper")
FREE = ("session/record.py",)  # the record itself


def _is_the_state(node: ast.expr) -> bool:
    return isinstance(node, ast.Attribute) and node.attr == "session_state"


def _written(tree: ast.AST) -> list[int]:
    """Lines that put something into ``st.session_state`` or take something out of it."""
    items = [node for node in ast.walk(tree) if isinstance(node, ast.Subscript) and _is_the_state(node.value)]
    calls = [node for node in ast.walk(tree) if isinstance(node, ast.Attribute) and _is_the_state(node.value)]
    lines = [node.lineno for node in items if not isinstance(node.ctx, ast.Load)]
    return lines + [node.lineno for node in calls if node.attr in ("setdefault", "pop", "update", "clear")]


def _private(tree: ast.AST) -> list[int]:
    """Lines that ask it for a key with an underscore, as no widget has one."""
    words = [
        node.lineno
        for node in ast.walk(tree)
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and node.value.startswith("_")
    ]
    asked = {node.lineno for node in ast.walk(tree) if isinstance(node, ast.expr) and _is_the_state(node)}
    return [line for line in words if line in asked]


def _trees() -> dict[str, ast.AST]:
    files = {str(path.relative_to(APP)): path for path in APP.rglob("*.py")}
    return {name: ast.parse(path.read_text(encoding="utf-8")) for name, path in files.items() if name not in FREE}


def test_only_the_record_and_widgets_are_kept_by_streamlit():
    assert {name for name, tree in _trees().items() if _written(tree)} == {"session/store.py"}


def test_nobody_asks_for_a_private_key():
    assert {name: lines for name, tree in _trees().items() if (lines := _private(tree))} == {}


@pytest.mark.parametrize(
    ("line", "written", "private"),
    [
        ('st.session_state["_x"] = 1', True, True),
        ('del st.session_state["_x"]', True, True),
        ('st.session_state.setdefault("_x", {})["a"] = 1', True, True),
        ('st.session_state.pop("x", None)', True, False),
        ('st.session_state.get(f"_x {y}")', False, True),
        ('"_x" in st.session_state', False, True),
        ('st.session_state["world"]', False, False),
    ],
)
def test_these_tests_see_what_they_look_for(line, written, private):
    assert (bool(_written(ast.parse(line))), bool(_private(ast.parse(line)))) == (written, private)


@pytest.mark.parametrize("screen", SCREENS)
def test_a_page_keeps_one_record(screen, runs):
    page = opened(screen=screen)
    assert isinstance(record_of(page), session.Session)
    assert [name for name in page.session_state if name.startswith("_")] == []
    assert len(record_of(page).pages) == 1
    assert record_of(page).shown_page.written == link(page)


def test_two_sessions_share_nothing():
    one, other = opened(world="two_branch"), opened(world="two_branch")
    choose(one, alpha=0.5)
    run(other)
    assert link(one)["alpha"] == "0.5"
    assert "alpha" not in link(other)
    assert record_of(one) is not record_of(other)


@dataclass
class Notes:
    """What a part of a page might keep."""

    lines: list[str] = field(default_factory=list)


def test_a_part_has_one_object_a_session(monkeypatch):
    monkeypatch.setattr(st, "session_state", {})
    session.part(Notes).lines.append("first")
    assert session.part(Notes).lines == ["first"]
    monkeypatch.setattr(st, "session_state", {})
    assert session.part(Notes).lines == []


def test_the_last_file_of_a_kind_is_kept(monkeypatch):
    monkeypatch.setattr(st, "session_state", {})
    assert session.opened(Notes) == {}
    first, second = Notes(["a"]), Notes(["b"])
    assert session.keep_opened(first, b"a") != session.keep_opened(second, b"b")
    assert list(session.opened(Notes).values()) == [second]
    assert session.opened(Notes)[session.keep_opened(second, b"b")] is second
