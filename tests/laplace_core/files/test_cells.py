"""Names as cells: what a spreadsheet would compute is kept from it, and all else stays as it is."""

from __future__ import annotations

import csv
import io

import pytest

from laplace_core import Settings, study
from laplace_core.files.cells import csv_cell
from laplace_core.study.tables import gamma_space_csv, rewards_csv, tau_space_csv, values_csv
from laplace_core.worlds import world_from_rows


@pytest.mark.parametrize("name", ["=1+1", "+1", "-1", "@SUM(A1)", "\t=1", "\r=1", "\n=1"])
def test_what_a_spreadsheet_would_compute_is_a_word_to_it(name):
    assert next(csv.reader(io.StringIO(csv_cell(name), newline=""))) == [f"'{name}"]


@pytest.mark.parametrize("name", ["short", "a,b", 'say "x"', "1 - 1", "état", "a=1", " x"])
def test_other_names_come_back_as_they_are(name):
    assert next(csv.reader(io.StringIO(csv_cell(name), newline=""))) == [name]


@pytest.mark.parametrize("table", [tau_space_csv, gamma_space_csv, values_csv, rewards_csv])
def test_no_table_of_a_study_holds_a_formula(table):
    rows = [{"state": "s", "action": "=1+1", "probability": 1.0, "reward": 2.0, "next": "END"}]
    world = world_from_rows(rows)
    cells = [cell for row in csv.reader(io.StringIO(table(study(world, Settings(steps=3))))) for cell in row]
    assert "'=1+1" in cells
    assert "=1+1" not in cells
