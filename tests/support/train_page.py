"""The page of training as tests open it, and runs laid in front of it."""

from __future__ import annotations

from pathlib import Path

import streamlit
from streamlit.testing.v1 import AppTest

from app.session import owner
from laplace_core.agents.settings import LoopSettings
from laplace_core.training.checkpoint import new_agent, save_checkpoint
from laplace_core.training.queue import Queue
from laplace_core.training.run_folder import new_run
from tests.laplace_core.training.test_curves import STORY
from tests.support import pages
from tests.support.quick_runs import SMALL

FORM = {"environment": "two_branch", "t.steps": "600", "t.hidden": "8", "t.seed": "3"}
NAME = "laplace_two_branch_3"


def opened(*unfolded: str, screen: str = "train", **query: str) -> AppTest:
    return pages.opened(*unfolded, screen=screen, **query)


def words(page: AppTest) -> str:
    """What the cards say."""
    told = [block.proto.body for block in page.get("html") if 'class="run-' in block.proto.body]
    return " ".join([*told, *(bar.proto.text for bar in page.get("progress"))])


def made(
    runs: Queue, name: str, *, settings: LoopSettings = SMALL, story: str = STORY, checkpoint: bool = False
) -> Path:
    """A run from elsewhere, that was stopped."""
    folder = runs.folder / name
    new_run(folder, settings)
    (folder / "metrics.jsonl").write_text(story)
    if checkpoint:
        save_checkpoint(folder / "best.safetensors", new_agent(settings), 50, 9.0, episodes=20)
    return folder


def with_cookie(monkeypatch, word: str | None) -> None:
    """Pages that are opened from here on are opened in the browser that keeps this word; None has none yet."""
    cookies = {} if word is None else {owner.COOKIE: word}
    monkeypatch.setattr(type(streamlit.context), "cookies", property(lambda context: cookies))
