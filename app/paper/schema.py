"""What the link of the page may hold: nothing, for all of it is shown."""

from __future__ import annotations

from laplace_core.exchange.links import Entries, Schema

LINK = Schema(opening=dict, steps=(Entries({}),))
