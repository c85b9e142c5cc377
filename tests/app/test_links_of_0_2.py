"""Twenty links as version 0.2.0 wrote them open the same view, in numbers.

``data/links_of_0_2.json`` holds what that version made of each: the settings of the study, the row that is read, sums
of the rows of tau-space, expected rewards, and the value of every action at T.
"""

from __future__ import annotations

import json
from pathlib import Path
from urllib.parse import parse_qsl

import numpy as np

from app.agents import schema
from app.catalogue import checkpoints
from app.view import compute
from app.worlds.schema import LINK
from app.worlds.sources import view_of
from laplace_core.environments import environment_of
from laplace_core.exchange.links import query_of
from laplace_core.trained import observations

LINKS = json.loads((Path(__file__).parents[1] / "data" / "links_of_0_2.json").read_text(encoding="utf-8"))


def opened(link: str):
    """Values, notes and view of a link; and its values once more as a link of today."""
    path, _, text = link.partition("?")
    query = dict(parse_qsl(text))
    if path != "/agents":
        values, notes = LINK.read(query)
        return values, notes, view_of(values)
    values, notes = schema.LINK.read(query)
    loaded = checkpoints.checkpoint(str(values["checkpoint"]))
    return values, notes, observations.view_of(loaded, environment_of(loaded.environment), values)


def test_there_are_twenty_of_them():
    assert len(LINKS) == 20


def test_a_link_of_0_2_opens_the_same_view(subtests):
    for told in LINKS:
        with subtests.test(told["link"]):
            values, notes, view = opened(told["link"])
            clamped = [note for note in notes if "lies beyond the end of the timeline" in note]  # which was not said
            assert notes == told["notes"] + clamped == clamped
            assert view.action == told["action"]
            for name, value in told["settings"].items():
                if name == "horizon" and clamped:
                    continue
                assert getattr(view.settings, name) == value, name
            found = compute.study_for(view)
            assert float(found.horizons[found.row]) == told["horizon"]
            assert found.reading(found.row)[0] == told["read_row"]
            decoded = found.decoded
            count = len(told["rewards"])
            # An agent's outermost bins, which 0.2.0 left out of the picture and not of the choice, count since.
            within = {"rtol": 0, "atol": 1e-9 * max(1.0, np.abs(told["values"]).max())}
            if not told["link"].startswith("/agents"):
                np.testing.assert_allclose(
                    decoded.tau_space[view.action].sum(axis=-1)[:count], told["tau_space"], **within
                )
                np.testing.assert_allclose(decoded.expected_reward[view.action][:count], told["rewards"], **within)
                np.testing.assert_allclose(decoded.horizon_values[:, told["read_row"]], told["values"], **within)
                again, more = LINK.read(query_of(values))
                assert (again, more) == (values, [])
