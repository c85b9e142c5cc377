"""The explanations of the pictures, one click away; their text is in the Markdown files of this folder."""

from __future__ import annotations

from pathlib import Path

from streamlit.delta_generator import DeltaGenerator

READING, TRAINING = "reading.md", "training.md"
GUIDE = {READING: ("concepts", "Concepts on one page"), TRAINING: ("guides/agent", "How to train an agent")}
"""The document that says more, and what the link to it is called."""


def explain(place: DeltaGenerator, words: str = READING) -> None:
    """Draw the explanation; a closed popover stays empty, because formulas load a large script."""
    box = place.popover("How to read this", width="stretch", on_change="rerun", key="reading")
    if box.open:
        box.markdown(Path(__file__).with_name(words).read_text(encoding="utf-8"))
        page, label = GUIDE[words]
        box.page_link("screens/guide.py", label=label, icon=":material/help:", query_params={"page": page})
