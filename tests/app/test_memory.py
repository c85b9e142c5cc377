"""What a server may hold: the budget of all caches, pictures no larger than a screen, files that leave with their
session."""

from __future__ import annotations

import gc
import io
import json
import os
import subprocess
import sys
import textwrap
import weakref
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import streamlit as st
from streamlit.runtime.memory_uploaded_file_manager import MemoryUploadedFileManager

from app.session import record
from app.view import compute
from app.view.export import MOST_LINES
from laplace_core import InputError, Settings, World, figures, load_world
from laplace_core.caching import BUDGET
from laplace_core.figures.comparison import MOST_COLUMNS, MOST_ROWS, farthest
from laplace_core.files.packed_text import pack
from laplace_core.study.compare import Difference
from laplace_core.study.settings import resolve
from laplace_core.study.size import largest_study
from laplace_core.subjects import Exact, View
from laplace_core.supervise import limits
from tests.support.pages import choose, link, opened, pin, run, shown, upload, verdict
from tests.support.unpacking import unpacked

ROOT = Path(__file__).resolve().parents[2]


def view(world: World, alpha: float = 0.01, **settings: object) -> View:
    return View(Exact(world), resolve(Settings(alpha=alpha, **settings), world), 0)


# ---- the budget


@pytest.fixture
def budget(monkeypatch):
    """Sets the memory of the server, in megabytes."""

    def of(memory: int, **variables: str) -> None:
        for name, value in {"LAPLACE_MEMORY": str(memory), **variables}.items():
            monkeypatch.setenv(name, value)
        limits.limits.cache_clear()
        limits.enforce()

    yield of
    limits.limits.cache_clear()
    compute.forget()


def test_the_limits_of_the_server_are_those_of_the_library(budget):
    budget(123, LAPLACE_LARGEST_STUDY="54321")
    assert (BUDGET.limit, largest_study()) == (123_000_000, 54_321)


def test_many_views_stay_within_the_budget(budget):
    """Eight views of 2 x 200 x 300 doubles, two arrays each, are 15 MB."""
    budget(50)
    BUDGET.limit = BUDGET.fixed + 8_000_000  # other tests may have opened agents that stay
    world, most = load_world("two_branch"), 0
    for alpha in np.geomspace(1e-4, 1.0, 8):
        shown = view(world, float(alpha), thetas=300, steps=200)
        compute.verdict_for(shown)
        compute.artefacts_for(shown)
        compute.lens_payload(shown)
        compute.comparison(view(world, 0.5, thetas=300, steps=200), shown, "tau_space")
        most = max(most, BUDGET.bytes)
        assert BUDGET.bytes <= BUDGET.limit
    assert most - BUDGET.fixed > 4_000_000


def test_a_session_holds_no_study_beside_the_caches():
    """With the download popover open, and a comparison."""
    page = pin(opened("downloading", world="two_branch", alpha="0.02"))
    held = [weakref.ref(compute.study_for(seen)) for seen in (shown(page), shown(page))]
    compute.forget()
    gc.collect()
    assert [each() for each in held] == [None, None]
    assert verdict(run(page))


def test_the_process_grows_by_no_more_than_its_budget():
    """Measured in a process of its own: 16 views of which each has two arrays of 8 MB.

    What they grow by is the budget of 50 MB and what one view needs while it is made, less than 70 MB; without a
    budget 16 studies hold more than 250 MB.
    """
    script = textwrap.dedent(
        """
        import psutil
        from laplace_core.supervise import limits
        from app.view import compute
        from laplace_core.subjects import Exact, View
        from laplace_core import Settings, load_world
        from laplace_core.caching import BUDGET
        from laplace_core.study.settings import resolve

        limits.enforce()
        world, resident = load_world("two_branch"), psutil.Process().memory_info
        def shown(alpha):
            return View(Exact(world), resolve(Settings(alpha=alpha, thetas=1001, steps=500), world), 0)
        compute.verdict_for(shown(0.5), explained=False)
        before = resident().rss
        for i in range(16):
            compute.verdict_for(shown(0.5 + 0.01 * i), explained=False)
            assert BUDGET.bytes <= BUDGET.limit == 50_000_000
        print((resident().rss - before) // 1_000_000)
        """
    )
    environment = {**os.environ, "PYTHONPATH": str(ROOT), "LAPLACE_MEMORY": "50"}
    done = subprocess.run([sys.executable, "-c", script], env=environment, capture_output=True, text=True, check=True)
    assert int(done.stdout) < 120


# ---- a study for a page


def test_a_page_refuses_a_larger_study_than_its_server_takes(budget, monkeypatch):
    """2 actions x 200 thetas x 100 rows = 40,000."""
    budget(1_000, LAPLACE_LARGEST_STUDY="39999")
    page = opened(world="two_branch", thetas="200", steps="100")
    (said,) = [error.value for error in page.error]
    assert "2 actions, 3 distinct rewards, 200 thetas and 100 rows make arrays of 40,000 numbers" in said
    assert "above 39,999: lower thetas, gammas or steps" in said
    budget(1_000, LAPLACE_LARGEST_STUDY="40000")
    assert not opened(world="two_branch", thetas="200", steps="100").error


def test_a_wrong_limit_is_said_on_the_page(monkeypatch):
    monkeypatch.setenv("LAPLACE_MEMORY", "much")
    limits.limits.cache_clear()
    try:
        (said,) = [error.value for error in opened().error]
    finally:
        limits.limits.cache_clear()
    assert said.startswith("environment variable LAPLACE_MEMORY: ")


def test_a_lens_that_would_be_too_large_for_a_browser_is_refused_and_the_page_goes_on(monkeypatch):
    monkeypatch.setattr(compute, "MOST_PAYLOAD", 1e-3)
    compute.forget()
    page = opened(world="two_branch")
    (said,) = [error.value for error in page.error]
    assert said.startswith("the lens of this view would take 0 MB in the browser, above 0.001: lower thetas")
    assert any("Artefacts in the tau-space" in each.proto.body for each in page.get("html"))
    compute.forget()


# ---- pictures no larger than a screen


def twin(values: np.ndarray, high: int, wide: int) -> list[list[tuple[int, int]]]:
    """Place of the value of each block that is farthest from 0, one after the other."""
    found = []
    for top in range(0, values.shape[0], high):
        found.append([])
        for left in range(0, values.shape[1], wide):
            block = [
                (row, column)
                for row in range(top, min(top + high, values.shape[0]))
                for column in range(left, min(left + wide, values.shape[1]))
            ]
            found[-1].append(max(block, key=lambda at: abs(values[at])))
    return found


@pytest.mark.parametrize("shape", [(1, 1), (5, 7), (6, 4), (13, 3)])
@pytest.mark.parametrize("block", [(1, 1), (2, 3), (5, 2), (20, 20)])
def test_a_block_shows_the_value_farthest_from_0(shape, block):
    values = np.random.default_rng(1).normal(size=shape).round(1)
    row, column = farthest(values, block)
    expected = twin(values, *block)
    assert [list(zip(*pair, strict=True)) for pair in zip(row.tolist(), column.tolist(), strict=True)] == expected


def test_a_large_comparison_is_thinned_to_the_screen_and_says_so():
    """1,200 x 1,300 values in blocks of 5 x 4: 240 x 325 cells, each with a value that is there and its place."""
    rng = np.random.default_rng(2)
    a, b = rng.normal(size=(2, 1_200, 1_300))
    apart = Difference("tau_space", np.arange(1_200) / 2, np.linspace(-3, 9, 1_300), a, b)
    assert (
        figures.thinning(apart)
        == "Each cell shows one of 5 x 4 values, the one farthest from 0; point at it for its place."
    )
    for name, values in (("A", a), ("B", b), ("B - A", b - a)):
        text = figures.to_json(figures.comparison(apart)[name])
        heat = json.loads(text)["data"][0]
        z, places = unpacked(heat["z"]), unpacked(heat["customdata"])
        assert z.shape == (240, 325)
        assert len(text) < 5_000_000
        rows = np.rint(places[..., 0] * 2).astype(int)
        columns = np.rint((places[..., 1] + 3) / 12 * 1_299).astype(int)
        np.testing.assert_allclose(z, values[rows, columns], rtol=1e-6)
        assert np.abs(z).max() == pytest.approx(np.abs(values).max(), rel=1e-6)
        # Cells lie in the middle of their blocks: rows 0 to 4 at 2, the columns of the last block in their own middle.
        assert (unpacked(heat["y"])[0], unpacked(heat["y"])[-1]) == (2.0, 1_197.0)
        assert unpacked(heat["x"])[-1] == pytest.approx(np.linspace(-3, 9, 1_300)[-4:].mean(), rel=1e-6)


def test_a_comparison_of_as_many_values_as_cells_is_drawn_whole():
    values = np.random.default_rng(2).normal(size=(MOST_ROWS, MOST_COLUMNS))
    apart = Difference("gamma_space", np.linspace(0.1, 0.9, MOST_ROWS), np.arange(float(MOST_COLUMNS)), values, values)
    assert figures.thinning(apart) == ""
    heat = json.loads(figures.to_json(figures.comparison(apart)["A"]))["data"][0]
    np.testing.assert_allclose(unpacked(heat["z"]), values, rtol=1e-6)
    more = replace(apart, rows=np.linspace(0.1, 0.9, MOST_ROWS + 1), a=np.ones((MOST_ROWS + 1, MOST_COLUMNS)))
    assert "one of 2 x 1 values" in figures.thinning(more)


def test_the_page_says_what_a_cell_of_a_thinned_comparison_is():
    page = pin(opened(world="two_branch", thetas="900", steps="20"))
    assert any("Each cell shows one of 1 x 3 values" in each.value for each in page.caption)


def test_a_table_that_no_spreadsheet_opens_is_not_offered():
    """2 actions x 1,000 rows x 599 bins are 1,198,000 lines."""
    page = opened("downloading", world="two_branch", thetas="600", steps="1000")
    words = [each.value for each in page.caption]
    assert any(f"tau-space would have {1_198_000:,} lines" in each for each in words)
    assert MOST_LINES < 1_198_000


# ---- opened files


def test_an_opened_file_counts_and_leaves_with_its_session(budget):
    """20 states of 240 kB, of which two are looked at."""
    budget(100)
    file = io.BytesIO()
    gammas = np.linspace(0.1, 0.9, 15)
    values = np.broadcast_to(np.linspace(0.9, 0, 2_000), (20, 1, 15, 2_000)) / (1 - gammas)[:, None]
    np.savez(file, gamma_space=values, gammas=gammas, thetas=np.arange(2_000.0))
    page = opened("bring")  # which reads what ships, and that stays
    before = BUDGET.fixed
    page = upload(page, "mine.npz", file.getvalue())
    choose(page, state="3")
    assert not page.error
    held = BUDGET.fixed - before
    assert len(file.getvalue()) < held < len(file.getvalue()) + 500_000
    assert any(usage.name == "files that sessions have opened" for usage in BUDGET.usage())
    cached = sum(usage.bytes for usage in BUDGET.usage() if "compute" in usage.name)
    assert link(page)["world"] == "data"
    del page
    gc.collect()
    assert BUDGET.fixed == before
    assert sum(usage.bytes for usage in BUDGET.usage() if "compute" in usage.name) < cached


def test_the_next_file_takes_the_place_of_the_last(budget, monkeypatch):
    budget(100)
    monkeypatch.setattr(st, "session_state", {})
    first, second = os.urandom(1_000_000), os.urandom(2_000_000)
    before = BUDGET.fixed
    record.keep_opened(first, first)
    record.keep_opened(second, second)
    assert BUDGET.fixed - before == pytest.approx(2_000_000, abs=1_000)


def test_more_files_than_half_of_the_memory_are_refused_and_nothing_is_kept(budget, monkeypatch):
    budget(50)
    monkeypatch.setattr(st, "session_state", {})
    fits, large = os.urandom(1_000_000), os.urandom(26_000_000)
    record.keep_opened(fits, fits)
    before = BUDGET.fixed
    with pytest.raises(InputError, match=r"this file takes 26 MB, and the files .* may take 25 MB together"):
        record.keep_opened(bytearray(large), large)
    assert BUDGET.fixed == before
    assert list(record.opened(bytes).values()) == [fits]
    assert dict(record.opened(bytearray)) == {}


def test_streamlit_keeps_no_copy_of_a_file_that_was_taken_or_refused():
    def kept() -> int:
        gc.collect()
        managers = [each for each in gc.get_objects() if type(each) is MemoryUploadedFileManager]
        return sum(
            len(file.data) for each in managers for files in each.file_storage.values() for file in files.values()
        )

    before = kept()
    page = upload(opened("bring"), "bad.npz", os.urandom(3_000_000))
    assert "not an .npz file" in page.error[0].value
    page = run(page)  # the widget still holds it, and says so at every run
    assert "not an .npz file" in page.error[0].value
    assert kept() - before < 3_000_000


def test_a_link_to_a_world_of_many_rewards_is_shown(budget):
    """3,000 rewards fit into a link; each pair of them would be 72 MB."""
    budget(50)
    rewards = {f"{i / 10:g}": 1 / 3_000 for i in range(3_000)}
    rows = [
        {"state": "s", "action": "a", "next": {"END": 1.0}, "reward": rewards},
        {"state": "s", "action": "b", "next": {"END": 1.0}, "reward": {"7": 1.0}},
    ]
    text = json.dumps({"states": ["s"], "actions": ["a", "b"], "transitions": rows})
    page = opened(world="own", own=pack(text), thetas="60")
    assert "decoded values choose" in verdict(page)
    assert BUDGET.bytes <= BUDGET.limit
