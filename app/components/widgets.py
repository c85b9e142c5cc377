"""Widgets: one for a parameter, which shows its present value and keeps what a user sets; files in and out."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from dataclasses import field as field_of
from functools import partial
from typing import Any

import numpy as np
import streamlit as st
from streamlit.runtime.memory_uploaded_file_manager import MemoryUploadedFileManager
from streamlit.runtime.scriptrunner import get_script_run_ctx
from streamlit.runtime.uploaded_file_manager import DeletedFile, UploadedFile

from app import session
from app.catalogue import files
from app.session import store
from app.session.typed import in_markdown
from laplace_core import InputError
from laplace_core.parameters import Parameter

Titles = Callable[[Any], str] | Mapping[Any, str]
"""What the options of a box are called; an option that is missing keeps its own name."""
_MIME = {"csv": "text/csv", "json": "application/json", "gif": "image/gif"}


def field(
    parameter: Parameter, value: object, label: str, *, key: str = "", titles: Titles = str,
    keep: Callable[[str], None] = store.keep, place: Any = st, **more: Any,
) -> None:  # fmt: skip
    """The widget for a parameter of a page or of its view.

    Args:
        value: shown where nothing is set by hand.
        key: of the widget and of the value in the link, where it is not the parameter's name.
        titles, keep, place: see :func:`select`.
        more: other arguments of :func:`select` or of Streamlit's widget for a number.
    """
    key = store.show(key or parameter.name, value)
    more = {"help": parameter.help, **more}
    if parameter.choices:
        select(label, parameter.choices, key, titles, keep=keep, place=place, **more)
        return
    kept = {"key": key, "on_change": keep, "args": (key,), **more}
    if parameter.type is bool:
        place.checkbox(label, **kept)
    elif parameter.type is int:
        low, high = parameter.bounds
        place.number_input(label, int(low), int(high), **{"step": 1, **kept})
    else:
        low, high = parameter.bounds
        step = 0.01 if high <= 1 else 0.5
        if parameter.default:  # a small number moves by its last digit
            step = min(step, 10.0 ** math.floor(math.log10(abs(float(parameter.default)))))
        place.number_input(label, float(low), float(high), step=step, format="%g", **kept)


def select(
    label: str, options: Sequence, key: str, titles: Titles = str,
    *, keep: Callable[[str], None] = store.keep, place: Any = st, **more: Any,
) -> None:  # fmt: skip
    """A box with options, after :func:`app.session.store.show` or :func:`~app.session.store.put` for its key.

    Args:
        keep: callback for the key, once a person has chosen.
        place: a container; by default here.
    """
    named = titles if callable(titles) else lambda option: titles.get(option, str(option))
    place.selectbox(label, options, format_func=named, key=key, on_change=keep, args=(key,), **more)


def discount(
    label: str, gammas: np.ndarray, key: str, gamma: float, *, keep: Callable[[str], None], help: str | None = None
) -> None:
    """A box with the discounts that an agent has learned, at the one nearest to ``gamma``."""
    options = [float(each) for each in gammas]
    key = store.put(key, min(options, key=lambda each: abs(each - gamma)))
    select(label, options, key, "{:.4g}".format, keep=keep, help=help)


def download(
    label: str, data: str | Callable[[], str | bytes], file_name: str, *, place: Any = st, **more: Any
) -> None:
    """A button that saves a file, which is made when it is clicked; the ending of its name says of what kind it is."""
    mime = _MIME.get(file_name.rpartition(".")[2], "application/octet-stream")
    place.download_button(label, data, file_name=file_name, mime=mime, on_click="ignore", **more)


def upload(
    label: str, endings: Sequence[str], key: str, take: Callable[[str, bytes], None], *, anywhere: bool = False,
    **more: Any,
) -> None:  # fmt: skip
    """A place for a file, and under it why the last one was refused, if it was.

    Args:
        take: callback for its name and its content; may raise InputError.
        anywhere: whether a file is taken here although another page is where such files are opened.
    """
    taken = partial(_uploaded, key, take, anywhere=anywhere)
    st.file_uploader(label, type=list(endings), key=key, on_change=taken, **more)
    if key in session.current().refusals:
        st.error(in_markdown(session.current().refusals[key]))
    home = session.part(_Homes).by_key.get(key)
    if home is not None:
        st.page_link(f"screens/{home}.py", label=f"To the page {files.TITLES[home]}")


@dataclass
class _Homes:
    """Pages that open a file which was refused, by the key of the widget."""

    by_key: dict[str, str] = field_of(default_factory=dict)


def shortened(name: str) -> str:
    """A file's name, as a sentence can hold it."""
    return name if len(name) <= 60 else f"{name[:40]} ... {name[-15:]}"


def left_out(sentences: Sequence[str]) -> None:
    """Show a sentence about each damaged file of the workbench."""
    for sentence in sentences:
        st.warning(f"Left out because a file of the workbench is damaged: {in_markdown(sentence)}")


def _uploaded(key: str, take: Callable[[str, bytes], None], *, anywhere: bool) -> None:
    """Callback: an uploaded file replaces the view, or says in one sentence why it cannot."""
    file = st.session_state[key]
    if isinstance(file, DeletedFile):  # it was taken, and Streamlit's copy of it dropped
        return
    session.current().refusals.pop(key, None)
    session.part(_Homes).by_key.pop(key, None)
    if file is None:
        return
    home = None if anywhere else files.home_of(file.name, file.getvalue())
    if home is not None and home[0] != store.page_name():
        session.part(_Homes).by_key[key] = home[0]
        name = shortened(file.name)
        session.current().refusals[key] = f"{name} is {home[1]}: the page {files.TITLES[home[0]]} opens it."
    else:
        try:
            take(file.name, file.getvalue())
        except InputError as error:
            session.current().refusals[key] = str(error)
    _drop_copy(file)


def _drop_copy(file: UploadedFile) -> None:
    """Delete Streamlit's copy of a file: the content that was read from it is kept."""
    context = get_script_run_ctx()
    if context is not None and isinstance(context.uploaded_file_mgr, MemoryUploadedFileManager):
        context.uploaded_file_mgr.remove_file(context.session_id, file.file_id)
    file.truncate(0)
