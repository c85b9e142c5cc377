"""What browser tests and measurements share: a server of the app, a Chromium, and hands on the lens.

Tests wait for conditions, never for a time. Where nothing more should happen, they wait until the page has come to
rest, which :data:`WATCH` makes visible (:func:`settled`).
"""

from __future__ import annotations

import contextlib
import os
import re
import shutil
import socket
import subprocess
import sys
import tempfile
import threading
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import IO, Any

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
MAIN, DEMO = ROOT / "app" / "main.py", ROOT / "tests" / "browser" / "lens_demo.py"
CHROMIUM = ("chromium", "chromium-browser", "google-chrome")
FLAGS = ["--no-sandbox", "--disable-gpu", "--disable-background-networking", "--disable-component-update"]
PATIENCE = 120_000
"""Milliseconds until a condition that has not come true is a failure: a busy machine may be slow for long."""

# Makes visible whether a page is at rest. It changes nothing of what the page does: timers, frames and messages are
# only noted. A run of the server is due from the message that asks for it until the run that follows has ended.
WATCH = """
(() => {
  const SHORT = 1000, AWAKE = 3; // ms of a timer that counts; frames in a row without any news
  const RERUN = (11 << 3) | 2, NEW_SESSION = 4, FINISHED = 6, FOR_RERUN = 2; // fields of Streamlit's messages
  const timers = new Set(), frames = new Set(), watched = (window.watched = { runs: 0, received: [] });
  const { setTimeout, clearTimeout, requestAnimationFrame, cancelAnimationFrame, WebSocket } = window;
  let due = '', still = 0;

  window.setTimeout = (call, delay = 0, ...rest) => {
    if (typeof call !== 'function' || delay > SHORT) return setTimeout(call, delay, ...rest);
    const id = setTimeout((...given) => { timers.delete(id); call(...given); }, delay, ...rest);
    timers.add(id);
    return id;
  };
  window.clearTimeout = (id) => { timers.delete(id); clearTimeout(id); };
  window.requestAnimationFrame = (call) => {
    const id = requestAnimationFrame((now) => { frames.delete(id); call(now); });
    frames.add(id);
    return id;
  };
  window.cancelAnimationFrame = (id) => { frames.delete(id); cancelAnimationFrame(id); };

  // The fields of a message of protobuf: numbers by themselves, all else by its length.
  function fieldsOf(bytes) {
    const fields = {};
    let at = 0;
    const number = () => {
      let value = 0, shift = 1, byte;
      do { byte = bytes[at++]; value += (byte & 127) * shift; shift *= 128; } while (byte & 128);
      return value;
    };
    while (at < bytes.length) {
      const tag = number(), kind = tag & 7, value = kind === 1 ? 8 : kind === 5 ? 4 : number();
      if (kind) at += value;
      fields[tag >> 3] = value;
    }
    return fields;
  }

  window.WebSocket = class extends WebSocket {
    constructor(...given) {
      super(...given);
      this.addEventListener('message', ({ data }) => {
        if (!(data instanceof ArrayBuffer)) return;
        watched.received.push(data.byteLength);
        const fields = fieldsOf(new Uint8Array(data));
        if (NEW_SESSION in fields && due) due = 'runs';
        if (FINISHED in fields && due === 'runs' && fields[FINISHED] !== FOR_RERUN) due = '';
      });
    }
    send(data) {
      if (data instanceof Uint8Array && data[0] === RERUN) {
        watched.runs += 1;
        due = 'asked';
      }
      super.send(data);
    }
  };

  const reasons = (watched.reasons = () => [
    due && `a run is ${due}`, timers.size && `${timers.size} timers`, frames.size && `${frames.size} frames`,
    document.querySelector('[data-testid=stApp]')?.dataset.testScriptState !== 'notRunning' && 'the script runs',
    document.getAnimations().some(moves) && 'something moves',
  ].filter(Boolean));
  const moves = ({ playState, effect }) => playState === 'running' && isFinite(effect.getComputedTiming().endTime);
  window.addEventListener('scroll', () => { still = 0; }, true); // a finger's throw goes on after the finger
  watched.still = () => (still = reasons().length ? 0 : still + 1) >= AWAKE;
})();
"""


@contextlib.contextmanager
def served(
    script: Path, log: IO[str] | None = None, *, variables: Mapping[str, str] | None = None
) -> Iterator[tuple[str, subprocess.Popen[str]]]:
    """A Streamlit server on a free port of this machine; yields its address and its process.

    Args:
        log: what it says goes there, or nowhere.
        variables: environment variables of its own.

    Raises:
        RuntimeError: the server does not start.
    """
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
    command = [sys.executable, "-m", "streamlit", "run", str(script), "--server.port", str(port)]
    command += ["--server.address", "127.0.0.1", "--server.headless", "true", "--server.fileWatcherType", "none"]
    runs = tempfile.TemporaryDirectory(prefix="laplace_runs_", ignore_cleanup_errors=True)  # never somebody's own
    process = subprocess.Popen(
        command, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace",
        env={**os.environ, "LAPLACE_RUNS": runs.name, "PYTHONUNBUFFERED": "1", **(variables or {})},
    )  # fmt: skip
    begun, listening = threading.Event(), False

    def listen() -> None:
        nonlocal listening
        assert process.stdout is not None
        for line in process.stdout:
            if log is not None:
                log.write(line)
            if "URL:" in line:  # said once it listens
                listening = True
                begun.set()
        begun.set()

    reader = threading.Thread(target=listen, daemon=True)
    reader.start()
    try:
        if not begun.wait(PATIENCE / 1000) or not listening:
            raise RuntimeError(f"{script.name} did not start")
        yield f"http://127.0.0.1:{port}", process
    finally:
        process.terminate()
        process.wait()
        reader.join(PATIENCE / 1000)
        runs.cleanup()


def find_chromium() -> str | None:
    return next((path for name in CHROMIUM if (path := shutil.which(name))), None)


_ADDRESSES = "performance.getEntriesByType('resource').map(({ name }) => name)"


def module_of(page: Any, name: str) -> Any:
    """A handle of a module of ``app/js`` as the components of the page have it, by the address that they loaded."""
    page.wait_for_function(f"() => ({_ADDRESSES}).some((address) => address.endsWith('/{name}'))")
    address = f"({_ADDRESSES}).find((address) => address.endsWith('/{name}'))"
    return page.evaluate_handle(f"() => import({address})")


# ---- a page at rest


def settled(page: Any) -> None:
    """Wait until the page has come to rest.

    No run of the server is due or going on, no timer of up to a second and no frame is waited for, and nothing
    moves or scrolls. A change that a hand has made is then drawn, described, sent and answered.
    """
    from playwright.sync_api import TimeoutError as Late

    try:
        page.wait_for_function("() => window.watched.still()", polling="raf")
    except Late as late:
        raise AssertionError(f"the page does not come to rest: {page.evaluate('watched.reasons()')}") from late


def runs_asked(page: Any) -> int:
    """Runs of the server that this page has asked for since it was loaded."""
    return page.evaluate("() => window.watched.runs")


# ---- the lens


DRAWN = """() => document.querySelector('.laplace-lens')?.lens?.seen
  && (!document.querySelector('.laplace-lens .world') || document.querySelector('.laplace-lens .world .main-svg'))"""


def open_at(page: Any, address: str, query: str = "") -> Any:
    """Open a view of the Worlds page, or of the lens alone, and wait until it is drawn; returns its verdict."""
    page.goto(f"{address}/?{query}" if query else address)
    page.wait_for_function(DRAWN)
    return page.locator(".laplace-lens .verdict")


def ask_why(page: Any) -> None:
    """Open the part of the lens that explains the rest, if it is closed."""
    summary = page.locator(".laplace-lens .why > summary")
    if not summary.evaluate("(summary) => summary.parentElement.open"):
        summary.click()
    settled(page)


def tau_space(page: Any) -> np.ndarray:
    """The decoded probabilities that the lens draws, ``(steps, sensitivities - 1)``."""
    handle = page.wait_for_function(  # a lens with another payload has yet to draw it
        """() => { const seen = document.querySelector('.laplace-lens')?.lens?.seen;
        return seen && [Array.from(seen.tau), seen.n]; }"""
    )
    values, rows = handle.json_value()
    return np.array(values).reshape(rows, -1)


_SHOWS = """
([wanted, shape, relative, absolute]) => {
  const seen = document.querySelector('.laplace-lens')?.lens?.seen;
  return !!seen && seen.n === shape[0] && seen.tau.length === wanted.length
    && wanted.every((value, i) => Math.abs(seen.tau[i] - value) <= absolute + relative * Math.abs(value));
}
"""


def comes_to_show(page: Any, expected: np.ndarray) -> None:
    """Wait until the tau-space is drawn as expected."""
    from playwright.sync_api import TimeoutError as Late

    try:
        page.wait_for_function(_SHOWS, arg=[expected.ravel().tolist(), list(expected.shape), 1e-4, 1e-5])
    except Late:
        np.testing.assert_allclose(tau_space(page), expected, rtol=1e-4, atol=1e-5)
        raise


def comes_to_differ(page: Any, before: np.ndarray) -> None:
    """Wait until another tau-space is drawn than ``before``."""
    page.wait_for_function(
        "(before) => Array.from(document.querySelector('.laplace-lens')?.lens?.seen?.tau ?? before)"
        ".some((value, i) => value !== before[i])",
        arg=before.ravel().tolist(),
    )


def grab(page: Any, name: str) -> Callable[[float], None]:
    """Press the mouse in the middle of a slider; returns what moves it to a share of the track."""
    handle = page.locator(f"input[name={name}]")
    handle.scroll_into_view_if_needed()
    box = handle.bounding_box()
    y, low, high = box["y"] + box["height"] / 2, box["x"] + 8, box["x"] + box["width"] - 8
    page.mouse.move((low + high) / 2, y)
    page.mouse.down()
    return lambda share: page.mouse.move(low + share * (high - low), y)


def runs_of_demo(page: Any) -> int:
    """Runs of the server as the page of the lens alone counts them."""
    return int(page.get_by_text(re.compile(r"^runs \d")).inner_text().split()[1].rstrip(","))
