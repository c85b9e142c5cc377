"""The entries of environments, compared with gymnasium."""

from __future__ import annotations

from dataclasses import replace

import gymnasium
import numpy as np
import pytest

from laplace_core.environments import ENVIRONMENTS, GYMNASIUM, environment_of
from laplace_core.environments.vector import make
from laplace_core.errors import InputError
from tests.support.hostile import assert_one_sentence


@pytest.fixture(params=GYMNASIUM)
def name(request):
    if request.param == "LunarLander-v3":
        pytest.importorskip("Box2D")
    return request.param


def test_an_entry_says_what_gymnasium_says(name):
    entry, env = GYMNASIUM[name], make(name)
    assert entry.time_limit == gymnasium.spec(name).max_episode_steps
    assert env.action_space.n == len(entry.actions)
    starts = np.array([env.reset(seed=seed)[0] for seed in range(20)])
    for part, values in zip(entry.components, starts.T, strict=True):
        assert np.all((part.low <= values) & (values <= part.high)), part.name


def test_an_inner_state_is_all_that_decides_what_comes_next(name):
    """Put into another environment, whose random numbers differ: without chance all that follows is the same."""
    entry = GYMNASIUM[name]
    if entry.chance or entry.inner is None:
        pytest.skip("its inner state is not known")
    one, other = make(name).unwrapped, make(name).unwrapped
    one.reset(seed=0)
    other.reset(seed=1)
    for _ in range(5):
        one.step(1)
    for attribute in entry.inner:
        setattr(other, attribute, getattr(one, attribute))
    for action in (0, 1, 1, 0):
        np.testing.assert_array_equal(one.step(action)[0], other.step(action)[0])


def test_every_environment_of_the_list_has_an_entry():
    for name in ENVIRONMENTS:
        entry = environment_of(name)
        assert bool(entry.states) != bool(entry.components)
    with pytest.raises(InputError, match="is not one of"):
        environment_of("Ant-v5")


def test_a_package_that_is_missing_is_named_in_one_sentence(monkeypatch):
    monkeypatch.setitem(GYMNASIUM, "CartPole-v1", replace(GYMNASIUM["CartPole-v1"], module="no_such_package"))
    with pytest.raises(InputError) as refused:
        make("CartPole-v1")
    assert_one_sentence(str(refused.value), "no_such_package")


def test_pictures_come_only_where_an_environment_makes_some(monkeypatch):
    assert make("CartPole-v1", pictures=True).render_mode == "rgb_array"
    kind = type(make("CartPole-v1").unwrapped)
    monkeypatch.setattr(kind, "metadata", {})  # one that says nothing of pictures
    assert make("CartPole-v1", pictures=True).render_mode is None
