"""A timeline changed by hand: its values, its choice, and the gamma-space that would have been learned of it."""

from __future__ import annotations

import numpy as np
import pytest

from laplace_core import InputError, Settings, load_world, study
from laplace_core.inverse import solve
from laplace_core.study.edited import Edit, edit
from laplace_core.study.manipulate import cut, distorted, rediscounted, transformed, values_of
from laplace_core.study.pipeline import problem_for


@pytest.fixture(scope="module")
def shown():
    return study(load_world("two_branch"), Settings(solver="nonnegative", alpha=1e-3, thetas=40, steps=6))


def test_without_a_change_nothing_changes(shown):
    found = edit(shown, Edit())
    assert not Edit().changes
    np.testing.assert_array_equal(found.values, found.new_values)
    np.testing.assert_array_equal(found.before.values, found.after.values)
    np.testing.assert_array_equal(found.actions, shown.decoded.actions)


def test_changes_are_made_in_their_order(shown):
    s, thetas = shown.settings, shown.gamma_space.thetas
    masses = solve(problem_for(shown.gamma_space, s), s.solver, s.alpha).masses
    found = edit(shown, Edit(horizon=2.0, gamma=0.9, worst=0.5))
    worth = found.after.bin_values
    changed = distorted(rediscounted(cut(masses, 2.0), 0.9), worth, "cvar", 0.5)
    np.testing.assert_allclose(found.new_values, values_of(changed, thetas, s.value_gamma)[0])
    np.testing.assert_allclose(found.after.values, transformed(changed, shown.gamma_space.gammas, thetas).values)


def test_an_episode_that_is_stopped_before_the_late_reward_turns_the_choice(shown):
    found = edit(shown, Edit(horizon=2.0))
    last = shown.world.actions.index("long"), shown.world.actions.index("short")
    assert (found.actions[-1], found.new_actions[-1]) == last


def test_a_change_out_of_its_range_is_refused(shown):
    with pytest.raises(InputError, match="the discount is 2"):
        edit(shown, Edit(gamma=2.0))
