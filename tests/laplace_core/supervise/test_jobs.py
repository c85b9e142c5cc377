"""Jobs in line: their order, whose they are, when they end, and which results stay; by a clock that a test sets."""

from __future__ import annotations

import gc
import threading
import weakref
from collections.abc import Callable

import pytest

from laplace_core import InputError
from laplace_core.caching import Budget, Cache
from laplace_core.supervise import jobs
from laplace_core.supervise.jobs import (
    DONE,
    ENDED,
    FULL,
    GRACE,
    REFUSED,
    RELOAD,
    SHORT,
    TICK,
    Asked,
    Job,
    Kind,
    Progress,
    duration,
)
from tests.support.line import LIMIT, MOST, Gate, Server

LONG = SHORT + 1.0


def at_once(progress: Progress) -> str:
    return "done"


def noted(server: Server, name: str) -> Callable[[Progress], str]:
    """Work that notes its turn."""

    def work(progress: Progress) -> str:
        server.done.append(name)
        return name

    return work


def over(job: Job) -> Job:
    assert job.wait(60)
    return job


def held(server: Server, kind: Kind) -> tuple[Gate, Job]:
    """A long job of session ``first`` that holds the only thread."""
    gate = Gate()
    job = kind.take("held", gate, LONG, "first")
    assert gate.begun.wait(60)
    return gate, job


def test_a_key_has_one_job_however_many_threads_ask_at_once():
    kind, made, found = Server().kind(), [], []

    def work(progress: Progress) -> str:
        made.append(1)
        return "done"

    threads = [threading.Thread(target=lambda: found.append(kind.take("a", work, 1.0))) for _ in range(20)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(set(map(id, found))) == 1
    assert over(found[0]).result() == "done"
    assert len(made) == 1


def test_the_shortest_goes_first_and_its_place_is_known():
    server = Server()
    kind = server.kind()
    gate, _ = held(server, kind)
    waiting = {
        seconds: kind.take(seconds, noted(server, str(seconds)), float(seconds), str(seconds))
        for seconds in (30, 10, 20)
    }
    assert {seconds: job.before for seconds, job in waiting.items()} == {10: 1, 20: 2, 30: 3}
    gate.open()
    for job in waiting.values():
        over(job)
    assert server.done == ["10", "20", "30"]
    assert waiting[30].before == 0


def test_what_has_waited_for_as_long_as_it_takes_goes_before_what_is_asked_for_then():
    """30 seconds asked for at 0 have their turn at 30; 10 asked for at 21 at 31, and at 19 at 29."""
    server = Server()
    kind = server.kind()
    gate, _ = held(server, kind)
    jobs_of = [kind.take("30", noted(server, "30 at 0"), 30.0, "a")]
    for now in (19.0, 21.0):
        server.now = now
        jobs_of.append(kind.take(f"10 at {now}", noted(server, f"10 at {now:.0f}"), 10.0, f"b {now}"))
    gate.open()
    for job in jobs_of:
        over(job)
    assert server.done == ["10 at 19", "30 at 0", "10 at 21"]


def test_a_thread_is_kept_for_short_jobs():
    server = Server(threads=2, kept=1)
    kind = server.kind()
    gate, _ = held(server, kind)
    long = kind.take("long", at_once, LONG, "second")
    short = over(kind.take("short", at_once, SHORT, "first"))
    assert short.result() == "done"
    assert long.state == "waiting"
    gate.open()
    assert over(long).worked


def test_a_session_has_one_long_job_at_a_time_while_others_have_theirs():
    server = Server(threads=2)
    kind = server.kind()
    gate, _ = held(server, kind)
    own = kind.take("own", noted(server, "own"), LONG, "first")
    other = kind.take("other", noted(server, "other"), LONG + 5.0, "second")
    over(other)
    assert own.state == "waiting"
    gate.open()
    over(own)
    assert server.done == ["other", "own"]


def test_the_line_is_bounded_and_says_so():
    server = Server(most=2)
    kind = server.kind()
    gate, first = held(server, kind)
    waiting = [kind.take(i, at_once, 1.0) for i in range(2)]
    with pytest.raises(InputError, match="the queue of this server is full; try again soon"):
        kind.take("late", at_once, 1.0)
    assert kind.get("late") is None
    assert server.line.usage() == (1, 2, 2)
    gate.open()
    for job in (first, *waiting):
        over(job)
    assert over(kind.take("late", at_once, 1.0)).worked


def test_thirty_rollouts_and_twenty_races_that_are_asked_for_at_once_all_finish():
    """Each kind keeps three: what waits is never driven out by what is asked for later."""
    server = Server(threads=2, kept=1)
    rollouts, races = server.kind(3), server.kind(3)
    gate, _ = held(server, rollouts)
    asked = [rollouts.take(i, lambda progress, i=i: i, 3.0, f"rollout {i}") for i in range(30)]
    asked += [races.take(i, lambda progress, i=i: i, 40.0, f"race {i}") for i in range(20)]
    gate.open()
    assert [over(job).result() for job in asked] == [*range(30), *range(20)]


def test_work_ends_with_the_last_session_that_wants_it_after_a_grace():
    server = Server()
    kind = server.kind()
    gate, job = held(server, kind)
    job.want("second")
    server.gone.add("first")
    server.now += GRACE + TICK + 1.0
    gate.step()
    assert job.going  # the second session is there
    server.gone.add("second")
    server.now += GRACE - 1.0
    gate.step()
    assert job.going  # it may be loading its page again
    job.want("second, loaded again")
    server.now += 2.0
    gate.step()
    assert job.going
    server.gone.add("second, loaded again")
    server.now += GRACE + 1.0
    gate.step()
    assert over(job).state == ENDED
    assert kind.get("held") is None


def test_what_waits_ends_with_its_session_too():
    server = Server()
    kind = server.kind()
    gate, _ = held(server, kind)
    waiting = kind.take("waiting", noted(server, "waiting"), LONG, "second")
    server.gone.add("second")
    server.now += GRACE + 1.0
    gate.step()
    assert over(waiting).state == ENDED
    assert server.done == []
    gate.open()


def test_a_session_that_leaves_ends_what_nobody_else_waits_for():
    server = Server()
    kind = server.kind()
    gate, job = held(server, kind)
    job.want("second")
    job.leave("first")
    assert job.going
    job.leave("second")
    assert job.gone
    assert kind.get("held") is None  # it may be begun again before its last step is over
    gate.step()
    assert over(job).state == ENDED
    with pytest.raises(InputError, match="this was cancelled: ask for it again"):
        job.result()


def test_a_page_that_was_loaded_again_cancels_for_the_session_before():
    server = Server()
    kind = server.kind()
    gate, job = held(server, kind)  # of the session "first"
    server.gone.add("first")
    job.want("reloaded")
    job.leave("reloaded")
    assert job.going  # "first" was there a moment ago: somebody else may be loading the page
    job.want("reloaded")
    server.now += RELOAD + 0.1
    job.leave("reloaded")
    assert job.gone
    gate.step()
    assert over(job).state == ENDED


def test_a_job_is_ended_at_the_limit_with_a_sentence():
    server = Server()
    kind = server.kind()
    gate, job = held(server, kind)
    server.now = LIMIT
    gate.step()
    assert job.going
    server.now = LIMIT + 1.0
    gate.step()
    assert over(job).state == ENDED
    assert kind.why("held") == job.why == "it was ended after 100 seconds, the limit of this server"
    again = kind.take("held", at_once, LONG, "first")
    assert over(again).worked
    assert kind.why("held") == ""


def test_waiting_does_not_count_towards_the_limit():
    server = Server()
    kind = server.kind()
    gate, _ = held(server, kind)
    waiting = kind.take("waiting", lambda progress: progress(1, 1), LONG, "second")
    server.now = LIMIT
    gate.open()
    assert over(waiting).state == DONE


def test_results_go_when_they_were_seen_or_nobody_wants_them_and_the_oldest_first():
    server = Server()
    kind = server.kind(2)
    for name in "abc":
        over(kind.take(name, at_once, 1.0, name))
    assert [key for key, _ in kind.items()] == ["a", "b", "c"]  # nobody has seen one of them
    kind.get("b").result()
    over(kind.take("d", at_once, 1.0, "d"))
    assert [key for key, _ in kind.items()] == ["a", "c", "d"]
    server.gone.add("c")
    server.now += GRACE + 1.0
    over(kind.take("e", at_once, 1.0, "e"))
    assert [key for key, _ in kind.items()] == ["a", "d", "e"]


def kilobytes(progress: Progress) -> bytes:
    return bytes(10_000)


def test_results_count_in_the_budget_of_all_caches_and_leave_with_what_was_used_least_recently():
    """Three of 10 kB fit into 36 kB, beside the little that keys and tuples take."""
    budget = Budget(36_000)
    server, elsewhere = Server(), Cache("of something else", 9, budget=budget)
    kind = server.kind(budget=budget)
    for name in "abc":
        over(kind.take(name, kilobytes, 1.0, name))
    assert 30_000 < budget.bytes < 36_000
    kind.take("a", kilobytes, 1.0, "a")  # it is looked at again
    elsewhere.put("x", bytes(11_000))
    assert [key for key, _ in kind.items()] == ["c", "a"]
    assert budget.bytes < 36_000
    assert kind.get("b") is None
    assert kind.why("b") == ""  # so that a page begins it again
    assert over(kind.take("b", kilobytes, 1.0, "b")).worked
    kind.drop("b")
    kind.clear()
    assert 11_000 < budget.bytes < 12_000


def test_a_result_that_is_larger_than_the_budget_is_refused_and_what_was_there_stays():
    budget = Budget(5_000)
    kind = Server().kind(budget=budget)
    small = over(kind.take("small", at_once, 1.0))
    large = over(kind.take("large", kilobytes, 1.0, lower="lower T"))
    assert large.refusal == (
        "the result takes 0 MB, and results, caches and opened files may take 0 MB together on this server: lower T."
    )
    assert small.result() == "done"
    assert kind.get("small") is small
    assert budget.bytes < 5_000


def test_a_session_holds_no_result_that_has_left(asks):
    budget = Budget(15_000)
    kind = Server().kind(budget=budget)
    first = wish(kind, "first", 1.0, kilobytes)
    held = weakref.ref(over(first.look()))
    assert over(wish(kind, "second", 1.0, kilobytes, slot="field").look()).worked
    gc.collect()
    assert held() is None
    assert over(first.look()).worked  # made again


def test_work_that_was_cleared_counts_nothing_when_it_comes_to_its_end():
    budget, gate = Budget(50_000), threading.Event()
    kind = Server().kind(budget=budget)

    def slow(progress: Progress) -> bytes:
        assert gate.wait(60)
        return kilobytes(progress)

    job = kind.take("a", slow, 1.0)
    kind.clear()
    gate.set()
    over(job)
    assert budget.bytes == 0


def test_an_error_of_the_work_is_raised_where_its_result_is_asked_for():
    def refuse(progress: Progress) -> None:
        raise InputError("the sand is wet.")

    kind = Server().kind()
    job = over(kind.take("a", refuse, 1.0))
    assert job.state == REFUSED
    assert job.refusal == "the sand is wet."
    with pytest.raises(InputError, match="the sand is wet"):
        job.result()
    assert kind.get("a") is job
    kind.drop("a")
    assert kind.get("a") is None


def test_clearing_ends_everything():
    server = Server()
    kind = server.kind()
    gate, job = held(server, kind)
    waiting = kind.take("b", at_once, 1.0)
    kind.clear()
    gate.step()
    assert over(job).gone
    assert over(waiting).gone
    assert kind.items() == []


def test_the_use_of_a_line_is_told():
    server = Server(threads=2, kept=1)
    gate, _ = held(server, server.kind())
    server.kind().take("b", at_once, LONG, "second")
    used = server.line.usage()
    assert (used.running, used.waiting, used.most_waiting) == (1, 1, MOST)
    gate.open()


@pytest.mark.parametrize(
    ("seconds", "words"),
    [(0.2, "1 second"), (9.4, "9 seconds"), (119.0, "119 seconds"), (180.0, "3 minutes"), (32_400.0, "9 hours"),
     (400_000.0, "5 days")],
)  # fmt: skip
def test_a_length_of_time_is_said_in_one_unit(seconds, words):
    assert duration(seconds) == words


# --- wishes: what a page wants, and what a session does about it ---


class Wish(jobs.Wish):
    """Of the session that a test goes on as."""

    now = Asked()

    @property
    def asked(self) -> Asked:
        return self.now


@pytest.fixture
def asks(monkeypatch) -> Callable[[str], None]:
    """Go on as another session."""
    kept: dict[str, Asked] = {}

    def become(name: str) -> None:
        monkeypatch.setattr(Wish, "now", kept.setdefault(name, Asked(name)))

    become("first")
    return become


def wish(kind: Kind, key: str, seconds: float = LONG, make=at_once, **more) -> Wish:
    return Wish(kind, key, make, lambda: seconds, **{"slot": "race", "lower": "lower T"} | more)


def test_a_look_starts_what_is_short_and_leaves_the_rest_to_a_button(asks):
    kind = Server().kind()
    assert over(wish(kind, "short", SHORT - 0.1).look()).worked
    assert wish(kind, "long", SHORT + 0.1).look() is None
    assert wish(kind, "button only", 0.01, by_itself=0.0).look() is None
    long = wish(kind, "long")
    long.begin()
    assert over(long.look()).worked
    assert long.notice == ""


def test_what_takes_longer_than_the_server_allows_is_refused_with_what_to_lower(asks):
    kind = Server().kind()
    nine_hours = wish(kind, "a", 32_400.0)
    said = "this takes about 9 hours, and this server allows 100 seconds: lower T."
    assert nine_hours.too_long == nine_hours.notice == said
    nine_hours.begin()  # a button that was pressed before its estimate was known
    assert nine_hours.look() is None
    assert kind.items() == []
    assert nine_hours.notice == said


def test_a_full_line_is_said_and_tried_again_by_a_button_only(asks):
    server = Server(most=1)
    kind = server.kind()
    gate, first = held(server, kind)
    waiting = kind.take("waiting", at_once, 1.0)
    short = wish(kind, "short", 1.0)
    assert short.look() is None
    assert short.notice == FULL
    gate.open()
    over(first)
    over(waiting)
    assert short.look() is None
    short.begin()
    assert over(short.look()).worked
    assert short.notice == ""


def test_what_was_ended_at_the_limit_says_so_and_does_not_start_again_by_itself(asks):
    server, gate = Server(), Gate()
    kind = server.kind()
    short = wish(kind, "short", 1.0, gate)
    job = short.look()
    assert gate.begun.wait(60)
    server.now = LIMIT + 1.0
    gate.step()
    over(job)
    assert short.look() is None
    assert short.notice == "it was ended after 100 seconds, the limit of this server: lower T."


def test_what_a_session_asks_for_in_a_slot_takes_the_place_of_what_it_asked_for_before(asks):
    server = Server(threads=4)
    kind, gate = server.kind(), Gate()
    one = wish(kind, "one", LONG, gate)
    one.begin()
    job = one.look()
    assert wish(kind, "elsewhere", slot="field").look() is None
    assert job.going
    assert wish(kind, "two", LONG).look() is None  # the page shows another one, which is not begun
    assert job.gone


def test_what_only_a_button_starts_goes_on_while_the_page_shows_something_else(asks):
    server = Server(threads=4)
    kind, gate = server.kind(), Gate()
    one, two = (wish(kind, key, LONG, gate, by_itself=0.0) for key in ("one", "two"))
    one.begin()
    job = one.look()
    assert two.look() is None
    assert job.going
    two.begin()
    assert job.gone
    two.cancel()


def test_a_cancel_is_of_one_session_and_ends_the_work_with_the_last(asks):
    server, gate = Server(), Gate()
    kind = server.kind()
    shared = wish(kind, "shared", 1.0, gate)
    job = shared.look()
    asks("second")
    assert shared.look() is job
    shared.cancel()
    assert job.going
    assert shared.look() is None  # it goes on, but not for this session
    shared.begin()
    assert shared.look() is job
    shared.cancel()
    asks("first")
    assert shared.look() is job
    shared.cancel()
    assert job.gone
    assert shared.look() is None  # short, but it was cancelled


def test_a_page_that_is_loaded_again_finds_its_work(asks):
    server, gate = Server(), Gate()
    kind = server.kind()
    long = wish(kind, "long", LONG, gate)
    long.begin()
    job = long.look()
    server.gone.add("first")
    asks("first, loaded again")
    assert long.look() is job
    server.now += GRACE + 1.0
    gate.step()
    assert job.going
    gate.open()
    assert over(job).result() == "done"
