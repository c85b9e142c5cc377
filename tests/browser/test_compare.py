"""A pinned view beside the present one, and what is saved to disk."""

from __future__ import annotations

import re

import numpy as np
import pytest
from playwright.sync_api import expect

from laplace_core import Settings, load_world, study
from laplace_core.study.compare import difference
from laplace_core.study.npz import study_arrays
from laplace_core.study.tables import gamma_space_csv, rewards_csv, tau_space_csv, values_csv
from tests.browser.support import open_at, settled

pytestmark = pytest.mark.browser

MAPS = ("compare A", "compare B", "compare B - A")


def drawn(page, name: str) -> np.ndarray:
    return np.array(
        page.evaluate(
            """(name) => Array.from([...document.querySelectorAll('.js-plotly-plot')]
            .find((p) => p.dataset.name === name)._fullData[0].z, (row) => Array.from(row))""",
            name,
        )
    )


def test_pin_change_and_see_three_maps(page, address):
    open_at(page, address, "world=two_branch")
    page.get_by_role("button", name="pin as A").click()
    expect(page.get_by_text("A and B show the same tau-space")).to_be_visible()
    page.get_by_label("rows of tau-space").select_option("paper")
    expect(page.get_by_text(re.compile("largest change of the tau-space"))).to_be_visible()
    settled(page)
    a, b = (study(load_world("two_branch"), Settings(normalise=how)) for how in ("none", "paper"))
    found = difference(a, b, 0, 0)
    for name, expected in zip(MAPS, (found.a, found.b, found.difference), strict=True):
        np.testing.assert_allclose(drawn(page, name), expected, rtol=1e-4, atol=1e-5)
    page.reload()
    page.wait_for_selector(".js-plotly-plot[data-name='compare B - A'] .main-svg")
    np.testing.assert_allclose(drawn(page, MAPS[2]), found.difference, rtol=1e-4, atol=1e-5)
    page.get_by_role("button", name="Unpin", exact=True).click()
    expect(page.locator(".js-plotly-plot[data-name='compare A']")).to_have_count(0)
    expect(page).not_to_have_url(re.compile("pin="))


def test_every_file_that_is_saved_holds_the_library_s_numbers(page, address, tmp_path):
    open_at(page, address, "world=two_decisions&alpha=0.05")
    page.get_by_role("button", name="Download", exact=True).click()
    found = study(load_world("two_decisions"), Settings(world="two_decisions", alpha=0.05))
    tables = {"tau-space": tau_space_csv, "gamma-space": gamma_space_csv, "values over T": values_csv,
              "rewards and survival": rewards_csv}  # fmt: skip
    for title, csv in tables.items():
        with page.expect_download() as waiting:
            page.get_by_role("button", name=f"CSV: {title}").click()
        assert waiting.value.path().read_text() == csv(found)
        assert waiting.value.suggested_filename == f"two_decisions_{title.replace(' ', '_')}.csv"
    with page.expect_download() as waiting:
        page.get_by_role("button", name="NPZ: every").click()
    waiting.value.save_as(tmp_path / "view.npz")
    saved = np.load(tmp_path / "view.npz")
    for name, array in study_arrays(found).items():
        np.testing.assert_array_equal(saved[name], array)
