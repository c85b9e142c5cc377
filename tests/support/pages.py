"""What the tests of the page share: opening it, reading its pictures and words, and typing into its tables."""

from __future__ import annotations

import base64
import json
import struct
import time
from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path

import numpy as np
import streamlit
from streamlit.delta_generator import DeltaGenerator
from streamlit.testing.v1 import AppTest

from app.session import KEY, Session
from app.worlds.schema import LINK
from app.worlds.sources import view_of
from laplace_core import Study
from laplace_core.files.packed_text import pack
from laplace_core.subjects import View
from laplace_core.tabular.work import Runs, Watched
from tests.support.lens_reference import seen

MAIN = str(Path(__file__).resolve().parents[2] / "app" / "main.py")
PATIENCE = 600
"""Seconds after which a run of a page is a failure: a busy machine may be slow for long."""


def opened(*unfolded: str, screen: str | None = None, **query: str) -> AppTest:
    """The page of a link; what lies in a closed expander or popover is not on it unless ``unfolded`` names it."""
    page = AppTest.from_file(MAIN, default_timeout=PATIENCE)
    if screen is not None:
        page.switch_page(f"screens/{screen}.py")
    for key in unfolded:
        page.session_state[key] = True
    for name, value in query.items():
        page.query_params[name] = value
    return run(page)


def session(page: AppTest) -> Session:
    """What the server keeps for this session."""
    return page.session_state[KEY]


def runs_of(page: AppTest) -> dict[str, Watched]:
    """The learners of this session, by their keys in the link."""
    return {key[:10]: run for key, run in session(page).parts[Runs].watched.items()}


def run(page: AppTest) -> AppTest:
    page.run()
    assert not page.exception
    return page


def press(page: AppTest, label: str) -> AppTest:
    next(button for button in page.button if button.label == label).click()
    return run(page)


def labels(page: AppTest) -> list[str]:
    return [button.label for button in page.button]


def link(page: AppTest) -> dict[str, str]:
    return {name: value[0] if isinstance(value, list) else value for name, value in page.query_params.items()}


def handed(page: AppTest) -> tuple[dict, bytes]:
    """The message to the lens, and its payload."""
    message = next(block.proto.bytes for block in page.get("bidi_component") if "lens" in block.proto.component_name)
    (size,) = struct.unpack("<I", message[:4])
    return json.loads(message[4 : 4 + size]), message[4 + size :]


def verdict(page: AppTest) -> str:
    """Tone and words of the verdict in the message to the lens."""
    said = handed(page)[0]["said"]
    return f"{said['tone']}: {said['sentence']}"


def choose(page: AppTest, **values: object) -> AppTest:
    """Set values as the lens does when something in it is let go of; None takes one back."""
    record = session(page)
    for name, value in values.items():
        record.shown_page.chosen.pop(name, None)
        if value is not None:
            record.shown_page.chosen[name] = value
    record.touched = True
    return run(page)


def pin(page: AppTest) -> AppTest:
    """Keep what is seen as A."""
    values = {name: value for name, value in link(page).items() if name not in ("pin", "edit")}
    return choose(page, pin=pack(json.dumps({"world": "two_branch", **values})))


def pictures(page: AppTest) -> dict[str, dict]:
    """Every plotly figure on the page, by the key of its chart, and as ``lens`` the message to the lens."""
    told = {name: value for name, value in handed(page)[0].items() if name != "revision"}
    return {"lens": told, **charts(page)}


def charts(page: AppTest) -> dict[str, dict]:
    """Every plotly figure on the page, by the key of its chart."""
    sent = [json.loads(block.proto.json) for block in page.get("bidi_component") if "chart " in block.proto.id]
    return {data["name"]: json.loads(data["figure"]) for data in sent}


def copied(page: AppTest, name: str) -> str:
    """What the copy button of this name copies."""
    sent = next(block.proto for block in page.get("bidi_component") if block.proto.id.endswith(name))
    return json.loads(sent.json)["text"]


def edit(page: AppTest, rows: Mapping[int, Mapping[str, object]], added: tuple = (), deleted: tuple = ()) -> AppTest:
    """Hold these edits in the table, relative to the rows that it was opened with; numbers count rows from 0."""
    key = page.data_editor[0].key
    page.session_state[key] = {"edited_rows": dict(rows), "added_rows": list(added), "deleted_rows": list(deleted)}
    return run(page)


def upload(page: AppTest, name: str, content: bytes) -> AppTest:
    page.file_uploader(key="upload").set_value((name, content, "application/octet-stream"))
    return run(page)


def downloads(monkeypatch) -> dict[str, object]:
    """What the download buttons would save, by the file's name, from here on."""
    saved: dict[str, object] = {}
    button = DeltaGenerator.download_button

    def noted(place, label, data, **options):
        saved[options["file_name"]] = data() if callable(data) else data
        return button(place, label, data, **options)

    monkeypatch.setattr(DeltaGenerator, "download_button", noted)
    monkeypatch.setattr(streamlit, "download_button", partial(noted, streamlit._main))
    return saved


def shown(page: AppTest) -> View:
    """What the page's link stands for, by the same words but without the page; learned views are not exact."""
    found, notes = LINK.read(link(page))
    assert notes == []
    return view_of(found)


def numbers(packed: dict | list) -> np.ndarray:
    """An array as a figure holds it."""
    if isinstance(packed, list):
        return np.array(packed)
    flat = np.frombuffer(base64.b64decode(packed["bdata"]), dtype="<f4")
    return flat.reshape([int(n) for n in packed["shape"].split(",")]) if "shape" in packed else flat


def seen_on(page: AppTest) -> dict[str, np.ndarray]:
    """What the lens draws, computed by the library from what it is handed."""
    told, data = handed(page)
    return seen(data, told["state"])


def tau_space(page: AppTest) -> np.ndarray:
    return seen_on(page)["tau_space"][handed(page)[0]["state"]["action"]]


def assert_shows(page: AppTest, study: Study, action: int = 0) -> None:
    """The page draws this study, and this action of it: its tau-space and its gamma-space."""
    found = seen_on(page)
    assert handed(page)[0]["state"]["action"] == action
    np.testing.assert_allclose(found["tau_space"], study.decoded.tau_space, rtol=1e-5, atol=1e-6)
    np.testing.assert_allclose(found["differences"], study.gamma_space.differences, rtol=1e-5, atol=1e-5)


def wait(page: AppTest, done: Callable[[AppTest], object], seconds: float = 120) -> AppTest:
    """Look at the page again and again, as it does by itself in a browser, until something has happened."""
    end = time.monotonic() + seconds
    while not done(page):
        assert time.monotonic() < end, "it did not happen"
        time.sleep(0.05)
        run(page)
    return page
