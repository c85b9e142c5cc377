"""The feasible timeline in the background: the page does not wait for it, and who asks for something else ends it."""

from __future__ import annotations

import threading

import numpy as np
import pytest

from app.session import crowd, jobs, record
from app.view import compute, feasible
from app.worlds.sources import view_of
from laplace_core import Settings, load_world, study
from laplace_core.inverse import interior
from laplace_core.inverse.interior import calling
from tests.support.lens_reference import unpacked
from tests.support.pages import handed, opened, press, run

HERE = {"world": "two_branch", "thetas": "12", "steps": "8", "solver": "feasible"}


@pytest.fixture
def held(monkeypatch):
    """Every timeline counts as long, and waits for an event before each of its steps."""
    go, began = threading.Event(), threading.Event()
    made = compute.made

    def waits(view):
        step = interior._on_step.get() or (lambda: None)

        def first():
            began.set()
            while not go.wait(0.01):
                step()
            step()

        with calling(first):
            return made(view)

    monkeypatch.setattr(compute, "made", waits)
    monkeypatch.setattr(feasible, "AT_ONCE", -1.0)
    monkeypatch.setattr(feasible, "SOON", 0.0)
    monkeypatch.setattr(crowd, "alone", lambda: False)
    feasible._timelines.clear()
    compute.forget()
    go.began = began
    yield go
    go.set()
    feasible._timelines.clear()


def decoded(solver="feasible", **changes):
    settings = Settings(world="two_branch", thetas=12, steps=8, solver=solver, **changes)
    return study(load_world("two_branch"), settings).decoded.tau_space


def view(**changes):
    return view_of({"world": "two_branch", "thetas": 12, "steps": 8, "solver": "feasible", **changes})


def test_the_linear_timeline_is_drawn_with_a_sentence_until_the_feasible_one_is_there(held):
    page = opened(**HERE)
    told, data = handed(page)
    assert unpacked(data)[0]["solver"] == "tikhonov"
    assert told["coming"] == "feasible"
    assert "searched for" not in told["said"]["sentence"]
    held.set()
    for job in [job for _, job in feasible._timelines.items()]:
        job.wait(60.0)
    told, data = handed(run(page))
    assert unpacked(data)[0]["solver"] == "feasible"
    assert told["coming"] is None
    np.testing.assert_allclose(unpacked(data)[1]["decoded"], decoded(), atol=1e-12)


def test_cancel_leaves_the_linear_timeline_and_a_button_that_begins_anew(held):
    page = opened(**HERE)
    job = feasible._timelines.items()[0][1]
    press(page, "Cancel")
    assert job.gone
    assert "This is the linear timeline." in [each.value.split(" This takes")[0] for each in page.caption]
    assert unpacked(handed(page)[1])[0]["solver"] == "tikhonov"
    held.set()
    press(page, "Compute the feasible timeline")
    feasible._timelines.items()[0][1].wait(60.0)
    assert unpacked(handed(run(page))[1])[0]["solver"] == "feasible"


def test_another_horizon_is_read_from_the_same_timeline(held):
    held.set()
    first = compute.unread(view())
    compute.remember(first, *compute.made(first))
    later = view(horizon=3.0, used=1.0, deadline="time_to_go")
    assert compute.is_known(later)
    found, whole = compute.study_for(later), later.subject.study(later.settings)
    assert found.settings == whole.settings
    assert found.row == whole.row
    np.testing.assert_array_equal(found.decoded.tau_space, whole.decoded.tau_space)
    np.testing.assert_array_equal(found.decoded.horizon_values, whole.decoded.horizon_values)


def test_a_request_that_is_superseded_ends_unless_somebody_else_waits_for_it(held, monkeypatch):
    kept: dict[str, dict] = {}

    def become(name):
        monkeypatch.setattr(record.st, "session_state", kept.setdefault(name, {}))
        monkeypatch.setattr(jobs, "session_id", lambda: name)

    monkeypatch.setattr(jobs.background(), "is_there", lambda name: True)
    first, second = (feasible.wish_for(view(alpha=alpha), 1.0) for alpha in (0.1, 0.2))
    become("one")
    shared = first.look()
    become("two")
    assert first.look() is shared
    other = second.look()
    assert shared.going  # the first still waits for it
    become("one")
    first.cancel()
    assert shared.gone
    assert other.going
    assert held.began.wait(60.0)
    become("two")
    jobs.leave(feasible.SLOT)  # another solver was chosen
    assert other.gone
    assert other.wait(60.0)  # in the middle of its steps


def test_a_step_of_the_solver_may_end_it():
    class Ended(Exception):
        pass

    def end():
        raise Ended

    with pytest.raises(Ended), calling(end):
        decoded()
    decoded()  # outside of it no more
