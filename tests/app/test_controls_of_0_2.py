"""Every control and download of version 0.2.0 is still there.

``data/controls_of_0_2.txt`` lists what that version's pages hold, by page, kind and label; popovers are opened.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from streamlit.testing.v1 import AppTest

ROOT = Path(__file__).resolve().parents[2]
LISTED = (ROOT / "tests" / "data" / "controls_of_0_2.txt").read_text(encoding="utf-8").splitlines()
VIEWS = (
    ("worlds.py", {"world": "two_branch", "normalise": "paper"}),
    ("worlds.py", {"world": "fig6_chain", "source": "learned"}),
    ("worlds.py", {"world": "own"}),
    ("worlds.py", {"world": "timeline"}),
    ("agents.py", {"checkpoint": "laplace_CartPole-v1"}),
    ("agents.py", {"checkpoint": "c51_CartPole-v1"}),
    ("race.py", {}),
    ("train.py", {}),
)
_BOTH, _NOW = "NPZ: the lens as it is, switches included", "NPZ: every array and the settings"
ELSEWHERE = {
    f"{page} download_button: {_BOTH}": f"{page} download_button: {_NOW}" for page in ("agents.py", "worlds.py")
}
"""What was given up, and where what it held is now."""


def labels(page: str, query: dict[str, str], opened: str | None) -> set[str]:
    app = AppTest.from_file(str(ROOT / "app" / "main.py"), default_timeout=120)
    app.switch_page(f"screens/{page}")
    for name, value in query.items():
        app.query_params[name] = value
    if opened:
        app.session_state[opened] = True
    app.run()
    assert not app.exception
    found: set[str] = set()
    waiting = [app._tree]
    while waiting:
        node = waiting.pop()
        waiting += getattr(node, "children", {}).values()
        label = getattr(node, "label", None) or getattr(getattr(node, "proto", None), "label", None)
        if label and getattr(node, "type", None):
            found.add(f"{page} {node.type}: {label}")
    return found


@pytest.mark.long
def test_every_control_of_0_2_is_there():
    found = set().union(
        *(labels(*view, opened) for view in VIEWS for opened in (None, "downloading", "copying", "reading"))
    )
    assert len(LISTED) > 70
    assert [line for line in LISTED if ELSEWHERE.get(line, line) not in found] == []
