"""The link of the page holds nothing, because the page always shows everything."""

from __future__ import annotations

from laplace_core.exchange.links import Entries, Schema

LINK = Schema(opening=dict, steps=(Entries({}),))
