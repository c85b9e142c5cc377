"""What Streamlit serves to the browser as files of their own, so that no message carries it: ``app/static``.

On a read-only file system they are put there beforehand: ``python -m app.served``.
"""

from __future__ import annotations

import hashlib
from functools import cache
from pathlib import Path

import plotly

from laplace_core.atomic import atomic_write

_FOLDER = Path(__file__).resolve().parent / "static"


def served(name: str, content: bytes) -> str:
    """Put a file where Streamlit serves it from, unless it is there already; returns its address.

    The address changes with the content: a browser never shows an old one.
    """
    path = _FOLDER / name
    if not path.exists() or path.read_bytes() != content:
        _FOLDER.mkdir(exist_ok=True)
        with atomic_write(path) as file:
            file.write(content)
    return f"app/static/{name}?{hashlib.sha256(content).hexdigest()[:12]}"


@cache
def plotly_js() -> str:
    """The address of the plotly.js of the installed plotly package."""
    return served("plotly.min.js", (Path(plotly.__file__).parent / "package_data" / "plotly.min.js").read_bytes())


def serve_all() -> tuple[str, ...]:
    """Put everything there; returns the addresses."""
    from app.lens import lens_js
    from app.player import player_js
    from app.track import track_js

    return plotly_js(), lens_js(), player_js(), track_js()


if __name__ == "__main__":
    print(*serve_all())
