"""Differences of two studies: against sums done bin by bin, and what may not be compared says so."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from laplace_core import InputError, Settings, Study, load_world, study, study_of_gamma_space
from laplace_core.study.compare import difference, rebinned, summary, value_difference
from tests.support.hostile import assert_one_sentence

SPACES = ("tau_space", "gamma_space")
TWO = load_world("two_branch")


def two(**settings) -> Study:
    return study(TWO, Settings(alpha=0.2, **settings))


def naive_rebinned(masses, edges, new_edges):
    """Each bin's mass times the part of it that each new bin covers."""
    result = np.zeros(len(new_edges) - 1)
    for mass, low, high in zip(masses, edges[:-1], edges[1:], strict=True):
        for n, (new_low, new_high) in enumerate(pairwise(new_edges)):
            result[n] += mass * max(0.0, min(high, new_high) - max(low, new_low)) / (high - low)
    return result


edge_lists = st.lists(st.integers(-40, 40), min_size=2, max_size=8, unique=True).map(lambda e: np.sort(e) / 4)


@given(st.data(), edge_lists, edge_lists)
def test_moved_mass_is_the_mass_that_each_bin_covers(data, edges, new_edges):
    masses = np.array(data.draw(st.lists(st.floats(-2, 2), min_size=len(edges) - 1, max_size=len(edges) - 1)))
    moved = rebinned(masses, edges, new_edges)
    np.testing.assert_allclose(moved, naive_rebinned(masses, edges, new_edges), rtol=0, atol=1e-12)
    if new_edges[0] <= edges[0] and new_edges[-1] >= edges[-1]:
        assert moved.sum() == pytest.approx(masses.sum(), abs=1e-12)
    np.testing.assert_allclose(rebinned(masses[None].repeat(2, 0), edges, new_edges), [moved, moved])
    np.testing.assert_allclose(rebinned(masses, edges, edges), masses, atol=1e-12)


# --- on one grid ---


@pytest.mark.parametrize("what", SPACES)
@pytest.mark.parametrize("source", ["two_branch", "cliff_grid", "gym:FrozenLake-v1"])
def test_a_study_does_not_differ_from_itself(source, what):
    found = study(load_world(source), Settings(thetas=20, steps=6))
    same = difference(found, found, 0, 0, what=what)
    assert not same.difference.any()
    assert same.note == ""
    values = value_difference(found, found, 1, 1)
    assert not values.difference.any()
    assert values.chosen_a == values.chosen_b
    np.testing.assert_array_equal(values.horizons, found.horizons)
    text = summary(same, values)
    assert text == f"A and B show the same {what.replace('_', '-')}; both choose the same action at T = 1-6."


@pytest.mark.parametrize("what", SPACES)
@pytest.mark.parametrize(("action_a", "action_b"), [("short", "short"), ("short", "long"), (1, "short")])
def test_on_one_grid_arrays_are_subtracted(what, action_a, action_b):
    a, b = two(normalise="paper"), two(policy="per_gamma", noise=0.01)
    first, second = (TWO.actions.index(x) if isinstance(x, str) else x for x in (action_a, action_b))
    one, other = difference(a, b, action_a, action_b, what=what), difference(b, a, action_b, action_a, what=what)
    arrays = [s.decoded.tau_space if what == "tau_space" else s.gamma_space.values for s in (a, b)]
    np.testing.assert_array_equal(one.difference, arrays[1][second] - arrays[0][first])
    np.testing.assert_array_equal(one.difference, -other.difference)
    assert one.note == other.note == ""
    rows = b.taus if what == "tau_space" else b.gamma_space.gammas
    columns = b.midpoints if what == "tau_space" else b.gamma_space.thetas
    np.testing.assert_array_equal(one.rows, rows)
    np.testing.assert_array_equal(one.columns, columns)
    assert one.a.shape == one.b.shape == one.difference.shape == (len(rows), len(columns))


def test_the_paper_s_artefact_by_hand():
    """Rescaled rows pay 5 for ever; without rescaling the row at tau = 2 is nearly empty and long wins at T = 3."""
    a, b = two(normalise="paper"), two()
    found, values = difference(a, b, "short", "short"), value_difference(a, b, "short", "short")
    row, column = np.unravel_index(np.abs(found.difference).argmax(), found.difference.shape)
    assert (found.rows[row], found.columns[column]) == (2.0, pytest.approx(5.0, abs=0.05))
    assert values.chosen_a == ("short", "short", "short")
    assert values.chosen_b == ("short", "short", "long")
    np.testing.assert_array_equal(values.difference, (b.decoded.horizon_values - a.decoded.horizon_values)[0])
    text = summary(found, values)
    assert text.startswith("The largest change of the tau-space is -0.5")
    assert "in probability, at tau = 2, reward 5 (A 0.5" in text
    assert text.endswith("; at T = 3 A chooses short, B long.")
    assert summary(None, values) == "At T = 3 A chooses short, B long."


def test_rows_that_only_one_has_are_left_out():
    a, b = two(steps=3), two(steps=9)
    for one, other in ((a, b), (b, a)):
        found = difference(one, other, 0, 0)
        assert found.a.shape[0] == 3
        assert found.note == "Only the 3 rows are shown that both have."
        np.testing.assert_array_equal(found.b, other.decoded.tau_space[0, :3])
        np.testing.assert_array_equal(found.a, one.decoded.tau_space[0, :3])
        np.testing.assert_array_equal(value_difference(one, other, 0, 0).horizons, [1, 2, 3])


def test_other_worlds_are_compared_by_the_names_of_actions():
    other = study(load_world("two_decisions"), Settings(alpha=0.2, thetas=150, theta_min=-2, theta_max=12))
    a = two(gammas=15)
    values = value_difference(a, other, "short", "go on / long")
    assert set(values.chosen_a) <= set(TWO.actions)
    assert set(values.chosen_b) <= set(other.action_names)
    assert difference(a, other, "long", "leave / short").a.shape == (3, 149)
    assert "A chooses short, B leave / short" in summary(None, values)


def test_a_saved_gamma_space_compares_like_any_study():
    a = two()
    own = study_of_gamma_space(a.gamma_space, Settings(world="own.npz", alpha=0.2, steps=3))
    for what in SPACES:
        np.testing.assert_allclose(difference(a, own, "long", "action 1", what=what).difference, 0, atol=1e-12)


# --- on other sensitivities ---


@pytest.mark.parametrize("thetas", [2, 7, 40, 151, 600])
def test_other_sensitivities_conserve_probability(thetas):
    a, b = two(), two(thetas=thetas, theta_min=-3.0, theta_max=13.0)
    found = difference(a, b, 1, 0)
    np.testing.assert_allclose(found.a.sum(axis=1), a.decoded.mass[1], atol=1e-12)
    np.testing.assert_array_equal(found.b, b.decoded.tau_space[0])
    assert found.note == "A's probability was moved to the sensitivities of B."
    naive = naive_rebinned(a.decoded.tau_space[1, 2], a.gamma_space.thetas, b.gamma_space.thetas)
    np.testing.assert_allclose(found.a[2], naive, atol=1e-12)


def test_what_lies_beyond_the_sensitivities_of_b_is_told():
    a, b = two(steps=5), two(steps=5, theta_min=-2.0, theta_max=7.0)
    found = difference(a, b, "long", "long")
    inside = a.gamma_space.thetas <= 7.0
    assert found.a.sum() == pytest.approx(a.decoded.tau_space[1][:, : inside.sum() - 1].sum(), abs=0.02)
    assert "of A lies beyond them and is not shown" in found.note
    apart = two(theta_min=20.0, theta_max=30.0)
    for what in SPACES:
        with pytest.raises(InputError, match="no difference map") as refused:
            difference(a, apart, 0, 0, what=what)
        assert_one_sentence(str(refused.value), "sensitivities", "20", "30")


def test_gamma_space_on_other_sensitivities_is_linear_between_those_of_a():
    a, b = two(), two(thetas=40, theta_min=0.0, theta_max=20.0)
    found = difference(a, b, 0, 1, what="gamma_space")
    np.testing.assert_array_equal(found.columns, b.gamma_space.thetas[b.gamma_space.thetas <= 12.0])
    for g, row in enumerate(a.gamma_space.values[0]):
        np.testing.assert_allclose(found.a[g], np.interp(found.columns, a.gamma_space.thetas, row), atol=1e-12)
    np.testing.assert_array_equal(found.b, b.gamma_space.values[1][:, : len(found.columns)])
    assert "sensitivities" in found.note


# --- on other discounts and time steps ---


def test_gamma_space_on_other_discounts_stays_within_those_of_a():
    a, b = two(spacing="log", gammas=60, gamma_min=0.3), two(spacing="log", gammas=23, gamma_min=0.1, gamma_max=0.98)
    found = difference(a, b, 0, 0, what="gamma_space")
    assert found.rows.min() >= 0.3
    assert len(found.rows) < 23
    np.testing.assert_allclose(found.difference, 0.0, atol=0.01)  # the same world: only the interpolation differs
    assert "time constant" in found.note
    reversed_a = replace(
        a,
        gamma_space=replace(
            a.gamma_space, values=a.gamma_space.values[:, ::-1], gammas=np.ascontiguousarray(a.gamma_space.gammas[::-1])
        ),
    )
    np.testing.assert_allclose(difference(reversed_a, b, 0, 0, what="gamma_space").a, found.a, atol=1e-12)
    low, high = two(gamma_min=0.01, gamma_max=0.2, gammas=5), two(gamma_min=0.5, gamma_max=0.9, gammas=5)
    with pytest.raises(InputError, match="no difference map") as refused:
        difference(low, high, 0, 0, what="gamma_space")
    assert_one_sentence(str(refused.value), "discounts")
    difference(low, high, 0, 0)  # tau-spaces do not know their discounts


def test_other_time_steps_are_moved_to_the_rows_of_b():
    fine, coarse = two(steps=14, time_step=0.5, gammas=60), two(steps=6, gammas=60)
    found = difference(fine, coarse, 0, 0)
    tau_space = fine.decoded.tau_space[0]
    np.testing.assert_array_equal(found.rows, np.arange(6.0))
    for row in (1, 2, 5):  # half of the row before, the whole of its own, half of the one after
        around = tau_space[2 * row] + (tau_space[2 * row - 1] + tau_space[2 * row + 1]) / 2
        np.testing.assert_allclose(found.a[row], around, atol=1e-12)
    np.testing.assert_allclose(found.a[0], tau_space[0] + tau_space[1] / 2, atol=1e-12)
    assert "0.5 apart" in found.note
    back = difference(coarse, fine, 0, 0)
    assert back.rows[-1] == 5.0  # the row at 5 ends at 5.25, A at 5.5
    np.testing.assert_allclose(back.a[4], coarse.decoded.tau_space[0, 2], atol=1e-12)
    np.testing.assert_allclose(back.b, fine.decoded.tau_space[0, :11] / 0.5)
    tiny = two(steps=1, time_step=0.1)
    with pytest.raises(InputError, match="more steps"):
        difference(tiny, coarse, 0, 0)


def test_values_of_other_time_steps_are_linear_between_horizons():
    fine, coarse = two(steps=14, time_step=0.5), two(steps=6)
    values = value_difference(fine, coarse, 0, 0)
    np.testing.assert_array_equal(values.horizons, np.arange(1.0, 7.0))
    expected = np.interp(values.horizons, fine.horizons, fine.decoded.horizon_values[0])
    np.testing.assert_allclose(values.a, expected, rtol=1e-12)
    np.testing.assert_array_equal(values.b, coarse.decoded.horizon_values[0])
    with pytest.raises(InputError, match="more steps"):
        value_difference(two(steps=1, time_step=0.1), coarse, 0, 0)


# --- words ---


def test_unknown_actions_are_refused(subtests):
    for action in ["up", "", 2, -1, "0"]:
        with subtests.test(action=action):
            for call in (difference, value_difference):
                for pair in ((action, 0), (0, action)):
                    with pytest.raises(InputError, match="short, long") as refused:
                        call(two(), two(), *pair)
                    assert_one_sentence(str(refused.value))


def test_many_changes_of_mind_are_told_briefly():
    values = value_difference(two(steps=9), two(steps=9), 0, 0)
    values = replace(values, chosen_a=tuple("aaaaaaaaa"), chosen_b=tuple("abacbbaca"))
    assert summary(None, values) == (
        "At T = 2 A chooses a, B b, at T = 4 A chooses a, B c, at T = 5-6 A chooses a, B b, and so on."
    )
    values = replace(values, chosen_b=tuple("baaaaaaac"))
    assert summary(None, values) == "At T = 1 A chooses a, B b, at T = 9 A chooses a, B c."
