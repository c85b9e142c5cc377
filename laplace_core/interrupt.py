"""Ctrl-C at the command line: one line on stderr and exit status 130, at whatever moment it comes.

Most of the time a command spends before it does anything goes into imports. An exception that is raised there comes
out as a traceback, or is lost in somebody else's module, so that until the command begins a handler of ours ends the
process: nothing has been written yet.
"""

from __future__ import annotations

import os
import signal
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import PurePath
from types import FrameType
from typing import NoReturn

STATUS = 128 + signal.SIGINT
LINE = "laplace: stopped"


def guard_start() -> None:
    """End quietly on Ctrl-C from here on, if this process is the command and not a program that uses the library."""
    # While Python imports the package of ``python -m``, this is all it says of the command.
    if sys.argv[:1] == ["-m"] or PurePath(sys.argv[0] if sys.argv else "").stem == "laplace":
        signal.signal(signal.SIGINT, _end)


def _end(_number: int, _frame: FrameType | None) -> NoReturn:
    os.write(2, f"{LINE}\n".encode())
    os._exit(STATUS)


@contextmanager
def by_exception() -> Iterator[None]:
    """Ctrl-C as ``KeyboardInterrupt`` and SIGTERM as ``SystemExit`` within the block, so that what is being written
    is dropped, and files keep their last whole state."""
    if threading.current_thread() is not threading.main_thread():  # only the main thread may
        yield
        return

    def end(number: int, _frame: FrameType | None) -> NoReturn:
        raise SystemExit(128 + number)

    before = {signal.SIGTERM: signal.signal(signal.SIGTERM, end)}
    if signal.getsignal(signal.SIGINT) is _end:
        before[signal.SIGINT] = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
