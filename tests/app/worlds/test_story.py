"""The guided story: every step is a link to the view that its words describe."""

from __future__ import annotations

from urllib.parse import parse_qsl

import pytest

from app.components.lens import _released
from app.worlds.schema import LINK
from app.worlds.sources import view_of
from app.worlds.story import STORY, story, values_of
from laplace_core import Study
from tests.support.pages import handed, link, opened, session

LAST = int(STORY.bounds[1])


def studied(step: int) -> Study:
    view = view_of(values_of(step))
    return view.subject.study(view.settings)


@pytest.mark.parametrize("step", range(1, LAST + 1))
def test_every_link_holds_its_step_and_nothing_in_vain(step):
    steps = story({})["steps"]
    assert len(steps) == LAST == 6
    query = dict(parse_qsl(steps[step - 1]["href"].removeprefix("?")))
    assert LINK.read(query) == (values_of(step), [])


def test_the_toy_is_as_its_words_say():
    """'short' pays 5, 'long' 10 after three steps: with 3 steps to go long is best, with fewer short is."""
    study = studied(1)
    assert study.action_names == ("short", "long")
    assert [study.action_names[a] for a in study.truth.optimal_action] == ["short", "short", "long"]
    rewards = study.truth.expected_reward
    assert rewards[0].tolist() == pytest.approx([5, 0, 0])
    assert rewards[1].tolist() == pytest.approx([0, 0, 10])


def test_the_artefact_and_its_repair_are_as_their_words_say():
    wrong, right = studied(4).decoded, studied(5).decoded
    assert wrong.expected_reward[0].tolist() == pytest.approx([5, 5, 5], abs=0.05)
    assert wrong.horizon_values[0, -1] == pytest.approx(15, abs=0.2)
    assert wrong.actions[-1] == 0
    assert right.horizon_values[0, -1] == pytest.approx(5, abs=0.2)
    assert right.actions[-1] == 1


def test_the_page_tells_the_step_of_its_link_and_none_without_one():
    assert handed(opened())[0]["story"]["at"] == 0
    page = opened(world="two_branch", story="4", normalise="paper", action="short")
    assert handed(page)[0]["story"]["at"] == 4
    assert not page.warning
    assert link(page)["story"] == "4"
    assert handed(opened(story="7"))[0]["story"]["at"] == 0


def test_a_step_from_the_browser_is_a_number_or_nothing():
    assert _released({"story": 3}, ()).story == 3
    for value in ("3", True, -1, None, [1]):
        assert _released({"story": value}, ()).story is None
    assert _released({"follow": "yes"}, ()).follow is None


def test_an_unknown_step_ends_the_story(monkeypatch):
    page = opened(story="2")
    assert session(page).shown_page.chosen["story"] == 2
    from app.worlds import story as module

    kept: dict[str, object] = {}
    monkeypatch.setattr(module.store, "choose", lambda name, value: kept.update({name: value}))
    module.show(99)
    assert kept == {"story": None}
