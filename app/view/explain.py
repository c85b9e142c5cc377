"""The words behind the pictures, one click away from them; they lie in Markdown beside this file."""

from __future__ import annotations

from pathlib import Path

from streamlit.delta_generator import DeltaGenerator

READING, TRAINING = "reading.md", "training.md"
GUIDE = {READING: ("concepts", "Concepts on one page"), TRAINING: ("guides/agent", "How to train an agent")}
"""The document that says more, and what the link to it is called."""


def explain(place: DeltaGenerator, words: str = READING) -> None:
    """What lies in a closed popover is left out: formulas bring a large script along."""
    box = place.popover("How to read this", width="stretch", on_change="rerun", key="reading")
    if box.open:
        box.markdown(Path(__file__).with_name(words).read_text(encoding="utf-8"))
        page, label = GUIDE[words]
        box.page_link("screens/guide.py", label=label, icon=":material/help:", query_params={"page": page})
