"""The explanations of the pictures, one click away; their text is in the Markdown files of this folder."""

from __future__ import annotations

from pathlib import Path

import streamlit as st
from streamlit.delta_generator import DeltaGenerator

READING, TRAINING = "reading.md", "training.md"
GUIDE = {READING: ("concepts", "Concepts on one page"), TRAINING: ("guides/agent", "How to train an agent")}
"""The document that says more, and the label of the link to it."""
_GUIDES = {
    "inverse": ("guides/regularisation", "How to choose alpha"),
    "agents": ("guides/agent", "How to use a trained agent"),
    "race": ("guides/agent", "How to act under a deadline"),
    "train": ("guides/agent", "How to train an agent"),
    "paper": ("guides/figure", "How to make a figure again"),
}
"""The same for the sidebar of a page."""


def explain(place: DeltaGenerator, words: str = READING) -> None:
    """Draw the explanation; a closed popover stays empty, because formulas load a large script."""
    box = place.popover("How to read this", width="stretch", on_change="rerun", key="reading")
    if box.open:
        box.markdown(Path(__file__).with_name(words).read_text(encoding="utf-8"))
        page, label = GUIDE[words]
        _link(box, page, label)


def guide(name: str) -> None:
    """A link from a page to its document, in the sidebar."""
    _link(st.sidebar, *_GUIDES[name])


def _link(place: DeltaGenerator, page: str, label: str) -> None:
    place.page_link("screens/guide.py", label=label, icon=":material/help:", query_params={"page": page})
