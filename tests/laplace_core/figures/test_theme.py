"""Figures of plotly and pictures of the lens have the same colours; what they look like is tested in tests/js."""

from __future__ import annotations

from pathlib import Path

from laplace_core.figures.theme import ACTION_COLOURS, probability_scale

DRAWING = Path(__file__).resolve().parents[3] / "app" / "js" / "draw" / "drawing.js"


def test_the_colours_are_those_of_the_lens():
    script = DRAWING.read_text(encoding="utf-8")
    assert f"const ACTIONS = {list(ACTION_COLOURS)};" in script
    colours = [f"'{colour}'" for _, colour in probability_scale()]
    assert f"[0, {colours[0]}]" in script
    assert f"[0.75 * zero, {colours[1]}]" in script
    assert f"const VIRIDIS = [{', '.join(colours[2:])}];" in script
