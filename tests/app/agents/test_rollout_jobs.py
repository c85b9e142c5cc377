"""Rollouts in the background: all that are asked for, a few kept, and ended where nobody waits."""

from __future__ import annotations

import threading

import pytest

from app.agents import jobs
from app.agents.jobs import MOST_KEPT, Rolling, rolling
from laplace_core import InputError
from laplace_core.agents import LaplaceSettings
from laplace_core.caching import BUDGET
from laplace_core.trained import rollouts
from laplace_core.trained.rollouts import Control
from laplace_core.training.checkpoint import Loaded, load_checkpoint, new_agent, save_checkpoint


@pytest.fixture
def loaded(tmp_path) -> Loaded:
    settings = LaplaceSettings(environment="two_branch", hidden=4, features=4, gammas=3, thetas=5, theta_max=12.0)
    save_checkpoint(tmp_path / "a.safetensors", new_agent(settings), 0, None)
    return load_checkpoint(tmp_path / "a.safetensors")


@pytest.fixture(autouse=True)
def empty():
    jobs._rollouts.clear()
    yield
    jobs._rollouts.clear()


def taken(loaded, control: Control, session: str = "") -> Rolling:
    wish = rolling(loaded, control)
    return wish.kind.take(wish.key, wish.make, wish.estimate(), session)


def finished(loaded, control: Control) -> Rolling:
    one = taken(loaded, control)
    assert one.wait(60)
    return one


def test_the_same_control_is_the_same_rollout(loaded):
    one = finished(loaded, Control(seed=1))
    assert taken(loaded, Control(seed=1)).result() is one.result()
    assert one.done == len(one.result().rollout)


def test_thirty_sessions_with_a_rollout_each_all_get_theirs(loaded):
    """More than are kept, asked for at once: each used to drive out the one before it."""
    asked = [taken(loaded, Control(seed=seed), str(seed)) for seed in range(30)]
    for seed, one in enumerate(asked):
        assert one.result().rollout.seed == seed


def test_fifty_rollouts_that_were_seen_leave_a_few(loaded):
    for seed in range(50):
        finished(loaded, Control(seed=seed)).result()
    taken(loaded, Control(seed=49))
    assert [control.seed for (_, control), _ in jobs._rollouts.items()] == list(range(50 - MOST_KEPT, 50))


def test_rollouts_stay_within_the_memory_of_the_server(loaded, monkeypatch):
    """Two and a half of them fit: of nine, the last two stay."""
    BUDGET.clear()
    finished(loaded, Control(seed=0, rule="random"))
    before = BUDGET.bytes
    finished(loaded, Control(seed=1, rule="random"))
    one = BUDGET.bytes - before
    assert one > 1_000
    monkeypatch.setattr(BUDGET, "limit", before + int(1.5 * one))
    for seed in range(2, 9):
        finished(loaded, Control(seed=seed, rule="random"))
        assert BUDGET.bytes <= BUDGET.limit
    assert 1 <= len(jobs._rollouts.items()) <= 3
    assert "rollouts" in {usage.name for usage in BUDGET.usage()}


def test_one_that_is_refused_says_why(loaded):
    with pytest.raises(InputError, match="own"):
        finished(loaded, Control(rule="own")).result()


def test_a_cancelled_one_ends_at_the_next_step_and_is_begun_anew(loaded, monkeypatch):
    begun, held, steps = threading.Event(), threading.Event(), []

    def slow(agent, environment, *rest, progress, **options):
        begun.set()
        for i in range(1000):
            held.wait(30)
            progress(i + 1, 1000)
            steps.append(i)

    monkeypatch.setattr(rollouts, "roll_out", slow)
    one = taken(loaded, Control())
    assert begun.wait(30)
    one.leave("")
    held.set()
    assert one.wait(60)
    assert one.gone
    assert len(steps) == 0
    assert taken(loaded, Control()) is not one
