"""The visitor of ``python -m bench.hold`` sees what a server answers, and the server is held to its memory."""

from __future__ import annotations

import asyncio
import subprocess
import sys
from urllib.parse import parse_qs

import pytest

from bench.hold import FAULTS, asked, give, heavy_visits, victims
from bench.serving import ROOT, serving
from bench.visitor import Broken, visit
from laplace_core import InputError


@pytest.fixture(scope="module")
def server():
    with serving(ROOT, 4000) as running:
        yield running


def test_a_visitor_opens_links_and_moves_the_lens(server):
    async def visiting() -> None:
        async with visit(server.address) as visitor:
            await visitor.open("worlds", "world=two_branch&normalise=paper")
            assert parse_qs(visitor.query)["normalise"] == ["paper"]
            assert visitor.button("Reset world and settings") is not None
            await visitor.move_lens(alpha=0.25)
            assert parse_qs(visitor.query)["alpha"] == ["0.25"]
            await visitor.go("world=two_branch&nonsense=1")
            assert "'nonsense'" in " ".join(visitor.texts("alert"))
            assert not visitor.texts("exception")
            with pytest.raises(Broken, match="no button 'Fly'"):
                await visitor.press("Fly")

    asyncio.run(visiting())


def test_a_visitor_opens_a_group_and_gives_its_uploader_a_file(server):
    async def visiting() -> None:
        async with visit(server.address) as visitor:
            await visitor.open("worlds")
            with pytest.raises(Broken, match="no uploader ''"):
                await visitor.upload("", "world.json", b"{}")
            await visitor.unfold("Bring your own")
            await visitor.upload("", "world.json", b"{}")
            assert "'states' must be a list" in " ".join(visitor.texts("alert"))
            with pytest.raises(Broken, match="no group 'Nothing'"):
                await visitor.unfold("Nothing")

    asyncio.run(visiting())


def test_a_visitor_finds_another_page_and_gives_it_a_file(server):
    async def visiting() -> None:
        async with visit(server.address) as visitor:
            await visitor.open("agents", "checkpoint=laplace_CartPole-v1")
            assert visitor.button("Roll out") is not None
            await visitor.upload("Open a checkpoint", "broken.safetensors", b"not a checkpoint")
            assert "broken.safetensors" in " ".join(visitor.texts("alert"))

    asyncio.run(visiting())


def test_a_file_given_to_the_worlds_page_is_opened_or_refused_there(server):
    # The uploader lies in a closed section. Given to the first element without a label instead, every file only
    # broke the page, and no file was tried.
    world = (
        '{"name": "w", "states": ["s"], "actions": ["stay"], "start": {"s": 1.0}, "transitions": '
        '[{"state": "s", "action": "stay", "next": {"END": 1.0}, "reward": {"1": 1.0}}]}'
    )

    async def visiting() -> None:
        async with visit(server.address) as visitor:
            await give(visitor, "worlds", "w.json", world.encode())
            assert not visitor.texts("exception")
            assert parse_qs(visitor.query)["world"] == ["own"]
            await give(visitor, "worlds", "half.json", world[:50].encode())
            assert not visitor.texts("exception")
            assert "not JSON" in " ".join(visitor.texts("alert"))
            with pytest.raises(Broken, match="no uploader 'Of nothing'"):
                await visitor.upload("Of nothing", "w.json", b"")
            with pytest.raises(Broken, match="no group 'Of nothing'"):
                await visitor.unfold("Of nothing")

    asyncio.run(visiting())


def test_a_visitor_notices_that_the_server_is_gone():
    with serving(ROOT, None) as server:

        async def visiting() -> None:
            async with visit(server.address) as visitor:
                await visitor.open("worlds")
                server.process.kill()
                with pytest.raises(FAULTS):
                    await visitor.go("world=two_branch")

        asyncio.run(visiting())
        assert server.process.wait() != 0
        assert not server.alive


def test_memory_is_that_of_the_whole_family(server):
    assert server.alive
    assert 50 < server.memory < 4000
    assert server.spent > 0
    assert server.limited.startswith("4000 MB by a ")


def test_heavy_visits_take_turns():
    names = [name for name, _ in heavy_visits(18)]
    assert names[:9] == names[9:]
    assert len(set(names)) == 9


def test_help_of_hold_names_its_parts():
    shown = subprocess.run([sys.executable, "-m", "bench.hold", "--help"], cwd=ROOT, capture_output=True, text=True)
    assert shown.returncode == 0
    for part in ("visits", "sessions", "asked", "kills", "hostile"):
        assert part in shown.stdout


@pytest.mark.long
def test_rollouts_and_races_asked_at_once_all_finish():
    (finished,) = asked(short=True)
    assert finished.met, finished.note


@pytest.mark.long
def test_points_of_work_refuse_a_file_that_is_half_written(tmp_path, subtests):
    listed = {victim.name: victim for victim in victims(tmp_path)}
    files = {"search": "search/a/run.json", "learning": "l.safetensors"}
    for name, file in files.items():
        with subtests.test(name):
            assert listed[name].points() == {}
            (tmp_path / file).parent.mkdir(parents=True, exist_ok=True)
            (tmp_path / file).write_text('{"half')
            with pytest.raises((InputError, ValueError)):
                listed[name].points()
    # A table whose last row a kill has cut short: the whole rows count, with the header.
    (tmp_path / "s.csv").write_text("a,b\n1,2\n3,")
    assert listed["study"].points() == {"rows": 2}
