"""Words as cells of a CSV file."""

from __future__ import annotations

import csv
import io

FORMULA = ("=", "+", "-", "@", "\t", "\r", "\n")
"""What a spreadsheet may take for the beginning of a formula."""


def no_formula(words: str) -> str:
    """Words with an apostrophe before them where a spreadsheet would compute them.

    ``quoted`` in ``app/js/lens/export.js`` is the same rule.
    """
    return f"'{words}" if words.startswith(FORMULA) else words


def csv_cell(words: str) -> str:
    """Words as :func:`no_formula` leaves them, quoted where they need it."""
    text, end = io.StringIO(), "\r\n"  # only what ends a line is quoted within a word
    csv.writer(text, lineterminator=end).writerow([no_formula(words)])
    return text.getvalue().removesuffix(end)
