"""A visitor without a screen: speaks Streamlit's protocol over its websocket, and keeps what a page shows.

A hundred of these cost less than one Chromium, so that what is measured is the server. A visitor opens a page, follows
a link as Back and Forward do, moves the lens, presses buttons and uploads files; it sees elements, not pictures. It
runs what the server asks it to run again, such as a page that looks at a training.
"""

from __future__ import annotations

import asyncio
import contextlib
import json
import re
from collections.abc import AsyncIterator, Mapping
from dataclasses import dataclass, field
from html import unescape
from typing import Any

import requests
from streamlit.components.v2.bidi_component.constants import EVENT_DELIM
from streamlit.proto.BackMsg_pb2 import BackMsg
from streamlit.proto.Block_pb2 import Block
from streamlit.proto.Element_pb2 import Element
from streamlit.proto.ForwardMsg_pb2 import ForwardMsg
from streamlit.runtime.state.session_state import STREAMLIT_INTERNAL_KEY_PREFIX
from websockets.asyncio.client import ClientConnection, connect
from websockets.exceptions import WebSocketException

PAGES = {"worlds": "", "inverse": "inverse", "agents": "agents", "race": "race", "train": "train"}
"""Address of every page, by the name that the app gives it."""
_ORIGIN_COOKIE = "_streamlit_xsrf"
_TAGS = re.compile(r"<style>.*?</style>|<[^>]*>", re.DOTALL)
_TEXTS = ("markdown", "html", "alert", "text", "heading", "code", "toast", "exception")


class Broken(Exception):
    """The server did not answer, or answered with an error."""


@dataclass(frozen=True)
class Place:
    """An element of a page, and the fragment that it belongs to."""

    element: Element
    fragment: str


@dataclass
class Visitor:
    """One session of the app; made by :func:`visit`.

    Attributes:
        shown: elements by their path.
        query: of the address bar, as the server has written it last.
        received: bytes of all messages.
        patience: seconds until an answer that has not come is an error.
    """

    address: str
    socket: ClientConnection
    patience: float = 60.0
    shown: dict[tuple[int, ...], Place] = field(default_factory=dict)
    query: str = ""
    received: int = 0
    _path: str = ""
    _hash: str = ""
    _session: str = ""
    _due: str = ""
    _due_fragment: str = ""
    _fresh: set[tuple[int, ...]] = field(default_factory=set)
    _idle: asyncio.Condition = field(default_factory=asyncio.Condition)
    _urls: asyncio.Queue = field(default_factory=asyncio.Queue)
    _groups: dict[tuple[int, ...], Block.Expandable] = field(default_factory=dict)
    _unfolded: set[str] = field(default_factory=set)
    _again: dict[str, asyncio.Task] = field(default_factory=dict)

    # What a person does.

    async def open(self, page: str, query: str = "") -> None:
        """Open a page by a link."""
        self.query, self._path, self._hash = query, PAGES[page], ""
        await self._ask()

    async def go(self, query: str) -> None:
        """Follow a link of the same page, as Back and Forward do."""
        self.query = query
        await self._ask(back=True)

    async def move_lens(self, **state: object) -> None:
        """Release a control of the lens with these values of its state."""
        place = self.component("laplace_lens")
        base = place.element.bidi_component.id
        event = json.dumps([{"event": "released", "value": {"state": state}}])
        await self._ask(
            {f"{STREAMLIT_INTERNAL_KEY_PREFIX}_{base}{EVENT_DELIM}events": {"json_trigger_value": event}},
            place.fragment,
        )

    async def press(self, label: str) -> None:
        """Press a button."""
        place = self.button(label)
        if place is None:
            raise Broken(f"there is no button {label!r}")
        await self._ask({place.element.button.id: {"trigger_value": True}}, place.fragment)

    async def unfold(self, label: str) -> None:
        """Open the group of controls with this label, which stays open."""
        group = next((group for group in self._groups.values() if group.label == label), None)
        if group is None:
            raise Broken(f"there is no group {label!r}")
        self._unfolded.add(group.id)
        await self._ask()

    async def upload(self, label: str, name: str, data: bytes) -> None:
        """Give a file to the uploader whose label begins so."""
        place = self._first("file_uploader", label)
        if place is None:
            raise Broken(f"there is no uploader {label!r}")
        asked = BackMsg()
        asked.file_urls_request.request_id = asked.file_urls_request.session_id = self._session
        asked.file_urls_request.file_names.append(name)
        await self.socket.send(asked.SerializeToString())
        async with asyncio.timeout(self.patience):
            urls = await self._urls.get()
        await asyncio.to_thread(self._put, urls.upload_url, name, data)
        info = {"name": name, "size": len(data), "file_id": urls.file_id, "file_urls": urls}
        await self._ask(
            {place.element.file_uploader.id: {"file_uploader_state_value": {"uploaded_file_info": [info]}}},
            place.fragment,
        )

    def _put(self, url: str, name: str, data: bytes) -> None:
        with requests.Session() as browser:
            browser.get(f"{self.address}/_stcore/health", timeout=self.patience)
            token = {"X-Xsrftoken": browser.cookies.get(_ORIGIN_COOKIE, "")}
            answer = browser.put(
                f"{self.address}{url}", files={name: (name, data)}, headers=token, timeout=self.patience
            )
            if not answer.ok:
                raise Broken(f"the upload of {name} was answered with {answer.status_code}")

    # What a person sees.

    def button(self, label: str) -> Place | None:
        """The first button whose label begins so and that can be pressed."""
        return self._first("button", label)

    def has_button(self, label: str) -> bool:
        """Whether a button with exactly this label can be pressed."""
        return any(
            place.element.button.label == label and not place.element.button.disabled
            for place in self.of_kind("button")
        )

    def _first(self, kind: str, label: str) -> Place | None:
        """The first widget of a kind whose label begins so and that is not disabled."""
        for place in self.of_kind(kind):
            widget = getattr(place.element, kind)
            if widget.label.startswith(label) and not widget.disabled:
                return place
        return None

    def of_kind(self, kind: str) -> list[Place]:
        """All elements of a kind: ``button``, ``progress``, ``alert``."""
        return [place for place in self.shown.values() if place.element.WhichOneof("type") == kind]

    def component(self, name: str) -> Place:
        """The first component of the app with this name."""
        for place in self.of_kind("bidi_component"):
            if place.element.bidi_component.component_name.endswith(name):
                return place
        raise Broken(f"the page shows no {name}: {self.text()[:300]!r}")

    def texts(self, *kinds: str) -> list[str]:
        """What elements of these kinds say, in the order of the page; by default of all that hold text."""
        found = []
        for path in sorted(self.shown):
            element = self.shown[path].element
            kind = element.WhichOneof("type")
            if kind in (kinds or _TEXTS):
                said = getattr(element, kind)
                body = getattr(said, "body", "") or getattr(said, "message", "") or getattr(said, "code_text", "")
                found.append(" ".join(unescape(_TAGS.sub(" ", body)).split()))
        return found

    def text(self) -> str:
        return " ".join(self.texts())

    # The protocol.

    async def _ask(self, widgets: Mapping[str, Any] | None = None, fragment: str = "", *, back: bool = False) -> None:
        await self._send(widgets or {}, fragment, back=back)
        await self.rest()

    async def _send(self, widgets: Mapping[str, Any], fragment: str, *, back: bool = False, auto: bool = False) -> None:
        message = BackMsg()
        run = message.rerun_script
        run.query_string, run.page_script_hash, run.fragment_id = self.query, self._hash, fragment
        run.page_name = "" if self._hash else self._path
        run.is_history_navigation, run.is_auto_rerun = back, auto
        run.context_info.url = f"{self.address}/{self._path}"
        run.context_info.timezone, run.context_info.locale = "UTC", "en"
        run.widget_states.SetInParent()
        held = {p.element.bidi_component.id: {"json_value": "{}"} for p in self.of_kind("bidi_component")}
        open_groups = {group: {"bool_value": True} for group in self._unfolded}
        for key, value in {**held, **open_groups, **widgets}.items():
            run.widget_states.widgets.add(id=key, **value)
        if not auto:  # nobody waits for what a page repeats by itself
            self._due, self._due_fragment = "asked", fragment
        await self.socket.send(message.SerializeToString())

    async def rest(self) -> None:
        """Wait until the server has answered.

        Raises:
            Broken: it does not, within the visitor's patience.
        """
        try:
            async with asyncio.timeout(self.patience), self._idle:
                await self._idle.wait_for(lambda: self._due in ("", "gone"))
        except TimeoutError:
            raise Broken(f"no answer within {self.patience:g} s") from None
        if self._due == "gone":
            raise Broken("the connection is gone")

    async def listen(self) -> None:
        """Take over messages until the connection ends."""
        try:
            with contextlib.suppress(OSError, WebSocketException):
                async for data in self.socket:
                    if isinstance(data, bytes):
                        await self._take(data)
        finally:
            for task in self._again.values():
                task.cancel()
            async with self._idle:
                self._due = "gone"
                self._idle.notify_all()

    async def _take(self, data: bytes) -> None:
        self.received += len(data)
        message = ForwardMsg.FromString(data)
        kind = message.WhichOneof("type")
        if kind == "new_session":
            self._session = message.new_session.initialize.session_id or self._session
            self._fresh = set()
            self._due = self._due and "runs"
        elif kind == "delta":
            self._show(message)
        elif kind == "navigation":
            self._hash = message.navigation.page_script_hash
        elif kind == "page_info_changed":
            self.query = message.page_info_changed.query_string
        elif kind == "auto_rerun":
            self._repeat(message.auto_rerun.fragment_id, message.auto_rerun.interval)
        elif kind == "stop_auto_rerun":
            for name in message.stop_auto_rerun.fragment_ids:
                self._stop(name)
        elif kind == "file_urls_response":
            self._urls.put_nowait(message.file_urls_response.file_urls[0])
        elif kind == "script_finished" and message.script_finished != ForwardMsg.FINISHED_EARLY_FOR_RERUN:
            if message.script_finished == ForwardMsg.FINISHED_SUCCESSFULLY:
                self.shown = {path: place for path, place in self.shown.items() if path in self._fresh}
            fragment = message.script_finished == ForwardMsg.FINISHED_FRAGMENT_RUN_SUCCESSFULLY
            if self._due == "runs" and (self._due_fragment or not fragment):  # not what the page repeats by itself
                async with self._idle:
                    self._due = ""
                    self._idle.notify_all()

    def _show(self, message: ForwardMsg) -> None:
        path, delta = tuple(message.metadata.delta_path), message.delta
        self._fresh.add(path)
        if delta.WhichOneof("type") == "new_element":
            self.shown[path] = Place(delta.new_element, delta.fragment_id)
        elif delta.WhichOneof("type") == "add_block":
            self.shown.pop(path, None)
            self._groups.pop(path, None)
            if delta.add_block.WhichOneof("type") == "expandable":
                self._groups[path] = delta.add_block.expandable

    def _repeat(self, fragment: str, interval: float) -> None:
        self._stop(fragment)

        async def again() -> None:
            while True:
                await asyncio.sleep(interval)
                if not self._due:
                    await self._send({}, fragment, auto=True)

        self._again[fragment] = asyncio.create_task(again())

    def _stop(self, fragment: str) -> None:
        task = self._again.pop(fragment, None)
        if task is not None:
            task.cancel()


@contextlib.asynccontextmanager
async def visit(address: str, *, patience: float = 60.0) -> AsyncIterator[Visitor]:
    """A new session at a server's address, which may end in a path."""
    stream = f"ws://{address.partition('://')[2]}/_stcore/stream"
    async with connect(stream, subprotocols=["streamlit"], max_size=None, compression=None) as socket:
        visitor = Visitor(address, socket, patience)
        listening = asyncio.create_task(visitor.listen())
        try:
            yield visitor
        finally:
            listening.cancel()
            with contextlib.suppress(asyncio.CancelledError):
                await listening
            for task in visitor._again.values():
                task.cancel()
