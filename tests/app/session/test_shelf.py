"""The shelf for work in the background: one piece a key, a few kept, and what makes room is cancelled."""

from __future__ import annotations

import threading

from app.session.background import Progress
from app.session.shelf import Shelf
from tests.support.quick_runs import until


def work(progress: Progress) -> int:
    return 0


def test_a_key_has_one_piece_of_work():
    shelf: Shelf[int] = Shelf(3)
    one = shelf.take("a", work)
    assert shelf.take("a", work) is one
    assert shelf.get("a") is one
    assert shelf.get("b") is None
    assert shelf.items() == [("a", one)]


def test_what_was_asked_for_longest_ago_makes_room_and_is_cancelled():
    shelf: Shelf[int] = Shelf(3)
    one, two, _ = (shelf.take(key, work) for key in "abc")
    shelf.take("a", work)
    shelf.take("d", work)
    assert [key for key, _ in shelf.items()] == ["c", "a", "d"]
    assert two.gone
    assert not one.gone


def test_work_that_was_cancelled_is_begun_anew_as_the_latest():
    shelf: Shelf[int] = Shelf(2)
    one, _ = shelf.take("a", work), shelf.take("b", work)
    one.cancel()
    assert shelf.get("a") is None
    assert shelf.take("a", work) is not one
    shelf.take("c", work)
    assert [key for key, _ in shelf.items()] == ["a", "c"]


def test_a_shelf_that_is_full_keeps_what_was_asked_for_last():
    shelf: Shelf[int] = Shelf(9, full=lambda kept: len(kept) > 0)
    shelf.take("a", work)
    two = shelf.take("b", work)
    assert shelf.items() == [("b", two)]
    assert not two.gone


def test_clearing_cancels_everything():
    shelf: Shelf[int] = Shelf(3)
    pieces = [shelf.take(key, work) for key in "abc"]
    shelf.clear()
    assert shelf.items() == []
    assert all(one.gone for one in pieces)


def test_many_threads_that_ask_at_once_get_one_piece():
    shelf, made, found = Shelf(3), [], []

    def make(progress: Progress) -> int:
        made.append(1)
        return 0

    threads = [threading.Thread(target=lambda: found.append(shelf.take("a", make))) for _ in range(20)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(set(map(id, found))) == 1
    until(lambda: found[0].worked)
    assert len(made) == 1
