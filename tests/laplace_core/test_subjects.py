"""What can be looked at: each kind of subject shows the study that the library makes, and is found again in caches."""

from __future__ import annotations

import numpy as np
import pytest

from app.catalogue.checkpoints import checkpoint
from app.catalogue.tabular import agent
from app.view import compute
from laplace_core import GammaSpace, InputError, Settings, Study, load_world, study, study_of_gamma_space
from laplace_core.study.settings import Resolved, resolve, resolve_for_gamma_space
from laplace_core.subjects import Exact, FromFile, Learner, Subject, View, state_in
from laplace_core.tabular.reading import study_settings
from laplace_core.trained.observations import observe

WORLD = load_world("two_branch")
EXACT = resolve(Settings(world="two_branch", thetas=20), WORLD)
LAPLACE = "laplace_CartPole-v1"


def saved() -> GammaSpace:
    return study(WORLD, EXACT).gamma_space


def exact() -> tuple[Subject, Resolved, Study]:
    return Exact(WORLD), EXACT, study(WORLD, EXACT)


def from_file() -> tuple[Subject, Resolved, Study]:
    space = saved()
    settings = resolve_for_gamma_space(Settings(), space.gammas)
    return FromFile(space), settings, study_of_gamma_space(space, settings)


def learned() -> tuple[Subject, Resolved, Study]:
    found = agent("fig6_chain_td")
    settings = resolve(study_settings(found.settings, Settings(world="fig6_chain")), found.world)
    tables = found.basis[:, found.world.state_index(settings.state)].astype(float).mean(axis=0)
    return Learner(found.world, found, None), settings, study(found.world, settings, learned=tables)


def observed() -> tuple[Subject, Resolved, Study]:
    subject = observe(checkpoint(LAPLACE), (0.0, 0.0, 0.0, 0.0), ("left", "right"), 1)
    settings = resolve_for_gamma_space(Settings(alpha=1.0), subject.gamma_space.gammas)
    return subject, settings, study_of_gamma_space(subject.gamma_space, settings, own_convention=False)


@pytest.mark.parametrize("made", [exact, from_file, learned, observed])
def test_a_subject_shows_what_the_library_makes_of_it(made):
    subject, settings, expected = made()
    found = subject.study(settings)
    np.testing.assert_array_equal(found.decoded.tau_space, expected.decoded.tau_space)
    assert found.action_names == subject.action_names
    assert (found.world is None) == (subject.world is None)
    assert (subject.gamma_space is None) == (subject.world is not None)
    assert (subject.learner is None) == (made is not learned)
    assert (subject.places is None) == (made is not observed)
    assert subject.added == (1 if made is observed else 0)


@pytest.mark.parametrize("made", [exact, from_file, learned, observed])
def test_the_same_view_is_the_same_study(made):
    subject, settings, _ = made()
    assert compute.study_for(View(subject, settings, 0)) is compute.study_for(View(subject, settings, 1))


def test_two_views_of_one_world_share_what_is_cached():
    assert Exact(WORLD) == Exact(WORLD)
    assert hash(Exact(WORLD)) == hash(Exact(WORLD))
    assert Exact(WORLD) != Exact(load_world("fig6_chain"))
    a, b = (View(Exact(WORLD), EXACT, 0) for _ in range(2))
    assert compute.study_for(a) is compute.study_for(b)
    assert compute.verdict_for(a) is compute.verdict_for(b)


def test_settings_without_a_state_are_refused_in_one_sentence():
    space = saved()
    with pytest.raises(InputError, match=r"^state is not decided: [^.]*\.$"):
        state_in(resolve_for_gamma_space(Settings(), space.gammas))


def test_an_agent_without_a_gamma_space_cannot_be_observed():
    with pytest.raises(InputError, match="has no gamma-space"):
        observe(checkpoint("dqn_CartPole-v1"), (0.0, 0.0, 0.0, 0.0), ("left", "right"))


def test_the_card_counts_what_the_network_gives():
    agent = checkpoint(LAPLACE).agent
    words = checkpoint(LAPLACE).settings.describe()
    assert words.startswith(f"{len(agent.gammas)} discounts to ")
    assert f" {len(agent.thetas)} sensitivities, " in words
    peer = checkpoint("c51_CartPole-v1").settings
    assert peer.describe().startswith(f"{peer.atoms} atoms")
