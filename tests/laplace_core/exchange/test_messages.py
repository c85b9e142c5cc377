"""The rule by which the server and the hand in the browser keep from undoing each other, line by line."""

from __future__ import annotations

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
    channel.release(TWO)
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
    channel.release(TWO)
    assert channel.show("step 3", TWO) == TWO, "a lens that is mounted again has nothing of its own for this payload"
    assert channel.revision == before


def test_a_cursor_is_always_sent_its_step():
    channel = Channel()
    channel.place("episode", 3)
    before = channel.revision
    channel.release(7)
    channel.place("episode", 7)
    assert (channel.sent, channel.revision) == (7, before), "the cursor rests there already"
    channel.place("episode", 0)
    assert (channel.sent, channel.revision) == (0, before + 1)
    channel.place("other", 0)
    assert channel.revision == before + 2, "another episode"


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
