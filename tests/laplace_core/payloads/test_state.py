"""The state of the lens: what its controls hold goes to the values of a page and back, and is not trusted."""

from __future__ import annotations

from dataclasses import replace

from laplace_core import Settings, load_world, study
from laplace_core.payloads.lens import structure
from laplace_core.payloads.state import checked, state_of, values_of


def made(name="two_decisions", **values):
    world = load_world(name)
    settings = study(world, Settings(world=name, **values)).settings
    return study(world, settings), study(world, structure(settings, world))


def test_the_state_goes_to_the_page_and_back():
    found, _ = made("two_branch")
    opening = state_of(found.settings, 3.0)
    state = {**opening, "alpha": 0.5, "mixed": True, "fold": True, "action": 1, "used": 2.0, "constant": True}
    state |= {"slope_share": 0.5, "added": 2}
    values = values_of(state, opening, found.action_names)
    assert values == {"alpha": 0.5, "used": 2.0, "fold": True, "action": "long", "policy": "per_gamma",
                      "deadline": "constant", "slope_share": 0.5, "added": 2}  # fmt: skip
    settings = replace(found.settings, alpha=0.5, policy="per_gamma", deadline="constant", fold=True, used=2.0)
    settings = replace(settings, slope_share=0.5)
    assert state_of(settings, 3.0, action=1, added=2) == state


def test_a_state_from_the_browser_is_not_trusted(subtests):
    for heard in [
        None, 7, [], {"alpha": -1}, {"alpha": "x"}, {"alpha": float("nan")}, {"horizon": 1e9}, {"fold": "yes"},
        {"normalise": "<b>"}, {"action": 99}, {"nonsense": 1}, {"noise_seed": 2.0**40}, {"alpha": True},
        {"slope_share": 0.0}, {"slope_share": 1.5}, {"added": 4}, {"added": "2"},
    ]:  # fmt: skip
        with subtests.test(heard=heard):
            found, _ = made("two_branch")
            assert checked(heard, found) == state_of(found.settings, 3.0)
            good = {**state_of(found.settings, 2.0), "alpha": 0.5, "fold": True}
            assert checked(good, found) == good
