"""The rule by which the server and the hand in the browser keep from undoing each other, line by line."""

from __future__ import annotations

import pytest

from laplace_core.exchange.messages import Channel

ONE, TWO = {"alpha": 0.1}, {"alpha": 0.2}
A, B, C = ("a" * 16, "b" * 16, "c" * 16)


def test_a_state_that_the_server_sets_has_a_revision_of_its_own():
    channel = Channel()
    assert channel.show("world", ONE) == ONE
    first = channel.revision
    assert channel.show("world", ONE) == ONE
    assert channel.revision == first, "nothing has changed"
    assert channel.show("world", TWO) == TWO
    assert channel.revision == first + 1


def test_a_release_is_answered_with_the_message_before():
    channel = Channel()
    channel.show("world", ONE)
    before = channel.revision
    assert channel.release(TWO, before) == TWO
    assert channel.show("world", TWO) == ONE, "the browser shows TWO already"
    assert channel.revision == before
    assert channel.show("world", ONE) == ONE, "Back: the server sets what was before"
    assert channel.revision == before + 1


def test_beside_another_payload_the_hand_has_the_last_word():
    channel = Channel()
    channel.show("step 1", ONE)
    before = channel.revision
    assert channel.show("step 2", ONE) == ONE
    assert channel.revision == before
    channel.release(TWO, before)
    assert channel.show("step 3", TWO) == TWO, "a lens that is mounted again has nothing of its own for this payload"
    assert channel.revision == before


def test_a_cursor_is_always_sent_its_step():
    channel = Channel()
    channel.place("episode", 3)
    before = channel.revision
    channel.release(7, before)
    channel.place("episode", 7)
    assert (channel.sent, channel.revision) == (7, before), "the cursor rests there already"
    channel.place("episode", 0)
    assert (channel.sent, channel.revision) == (0, before + 1)
    channel.place("other", 0)
    assert channel.revision == before + 2, "another episode"


def test_a_release_of_a_state_that_the_server_has_set_anew_keeps_what_both_changed():
    channel = Channel()
    start = {"alpha": 0.1, "horizon": 5.0, "clip": False}
    channel.show("world", start)
    seen = channel.revision
    channel.show("world", start | {"clip": True})  # a remedy
    both = start | {"clip": True, "horizon": 3.0}
    assert channel.release(start | {"horizon": 3.0}, seen) == both
    assert channel.show("world", both) == both
    assert channel.revision == seen + 2, "the browser shows the remedy without the hand's horizon"
    later = both | {"alpha": 0.2}
    assert channel.release(start | {"horizon": 3.0, "alpha": 0.2}, seen) == later, "a second one from before"
    assert channel.show("world", later) == later
    assert channel.release(later | {"alpha": 0.3}, channel.revision) == later | {"alpha": 0.3}


def test_a_step_released_while_the_server_set_another_is_sent_again():
    channel = Channel()
    channel.place("episode", 3)
    seen = channel.revision
    channel.place("episode", 0)
    assert channel.release(7, seen) == 7
    channel.place("episode", 7)
    assert (channel.sent, channel.revision) == (7, seen + 2), "the cursor rests at 0, where the server put it"


@pytest.mark.parametrize("revision", [None, -1, 99, "1", [], {}])
def test_a_release_of_a_revision_that_there_never_was_is_taken_whole(revision):
    channel = Channel()
    channel.show("world", ONE)
    assert channel.release(TWO, revision) == TWO
    assert channel.release({}, revision) == ONE
    assert channel.release("no state", revision) == "no state"


def test_a_payload_is_sent_until_the_browser_holds_it_and_again_when_it_does_not():
    channel = Channel()
    assert channel.due(A, b"data") == b"data"
    assert channel.answered({"id": A, "state": {}}, 2)
    assert channel.due(A, b"data") == b""
    assert not channel.answered({"missing": A}, 2)
    assert channel.due(A, b"data") == b"data"


def test_an_answer_about_an_older_payload_does_not_say_that_the_newer_one_is_held():
    channel = Channel()
    channel.show(B, ONE)
    channel.answered({"id": A, "state": TWO}, 2)
    assert (channel.due(A, b"data"), channel.due(B, b"data")) == (b"", b"data")
    for strange in (None, 7, "x" * 10_000, [A]):
        channel.answered({"id": strange}, 2)
    assert channel.held == [A]


def test_the_oldest_payload_makes_room():
    channel = Channel()
    for name in (A, B, A, C):
        channel.answered({"id": name}, 2)
    assert channel.held == [C, A]
