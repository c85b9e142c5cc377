"""Pictures of the paper's entries from raw results, whatever a file holds."""

from __future__ import annotations

import contextlib
import json

import plotly.graph_objects as go

from laplace_core.experiments.paper import pictures
from laplace_core.experiments.paper.claims import look
from tests.laplace_core.experiments.test_claims import AGENTS, BY_NAME, COMMITTED, FILES, damages


def test_acting_through_tau_space_is_drawn():
    row = {"mean": 30.0, "against greedy": {"mean": 5.0, "interval": [1.0, 9.0]}}
    found = look(BY_NAME["fig4"], COMMITTED, AGENTS)
    summary = {"T 50": {"greedy": row, "neural": row}, "T 100": {"neural": row}}
    acting = type(found)(BY_NAME["acting"], type(found.results)(COMMITTED, 3, 9, summary=summary), [], [None, None])
    figure = pictures.picture(acting).figure
    go.Figure(figure)
    assert [trace["name"] for trace in figure["data"]] == ["T 50", "T 100"]


def test_what_is_damaged_is_drawn_or_refused(tmp_path):
    """Whatever a file holds, no picture raises anything that the page does not expect."""
    for path in FILES:
        for text in damages(json.loads(path.read_text())):
            (tmp_path / path.name).write_text(text)
            found = look(BY_NAME[path.stem], tmp_path, AGENTS)
            with contextlib.suppress(pictures.CANNOT_DRAW):
                pictures.picture(found)
