"""Pages compute what is large one after the other, and what is small at once."""

from __future__ import annotations

import threading

import numpy as np
import pytest

from app.components import waiting
from app.components.waiting import turn
from app.view.compute import is_large
from laplace_core import Settings, load_world
from laplace_core.study.settings import resolve
from laplace_core.study.size import set_largest_study
from laplace_core.subjects import Exact, View


def _view(**settings: int) -> View:
    world = load_world("two_branch")
    return View(Exact(world), resolve(Settings(world="two_branch", **settings), world), 0)


def test_only_what_a_page_computes_and_is_large_waits(subtests):
    # two_branch has 2 actions: the largest array has 2 x thetas x max(gammas, steps) numbers.
    for thetas, steps, large in ((150, 100, False), (1000, 500, False), (1000, 501, True), (2000, 2000, True)):
        with subtests.test(thetas=thetas, steps=steps):
            assert is_large(_view(thetas=thetas, steps=steps)) is large


def test_what_is_refused_does_not_wait():
    set_largest_study(2_000_000)
    try:
        assert not is_large(_view(thetas=2000, steps=2000))
        assert is_large(_view(thetas=1000, steps=1000))
    finally:
        set_largest_study(50_000_000)


def test_one_at_a_time_and_the_small_beside():
    seen: list[str] = []
    entered, leave = threading.Event(), threading.Event()

    def first() -> None:
        with turn(needed=True):
            seen.append("first begins")
            entered.set()
            leave.wait(30)
            seen.append("first ends")

    def second() -> None:
        with turn(needed=True):
            seen.append("second begins")

    threads = [threading.Thread(target=first), threading.Thread(target=second)]
    threads[0].start()
    assert entered.wait(30)
    threads[1].start()
    threads[1].join(0.1)
    assert threads[1].is_alive()
    with turn(needed=False):
        seen.append("small")
    leave.set()
    for thread in threads:
        thread.join(30)
    assert seen == ["first begins", "small", "first ends", "second begins"]


def test_an_error_ends_the_turn():
    with pytest.raises(np.linalg.LinAlgError), turn(needed=True):
        raise np.linalg.LinAlgError
    assert not waiting._large.locked()
