"""A button that copies a text to the clipboard, in the browser."""

from __future__ import annotations

from app.components import assets


def copy_button(label: str, text: str, key: str) -> None:
    """Copy ``text`` on a click; where the browser allows no clipboard, show it to be copied by hand."""
    assets.component("copy")(key=key, data={"label": label, "text": text})
