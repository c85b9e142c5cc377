"""Jobs that other processes can import."""

from __future__ import annotations

import os
import signal
import threading
import time
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from laplace_core import InputError


def square(number: int) -> int:
    return number * number


def refuse(number: int) -> int:
    raise InputError(f"number {number} is refused.")


def die_once(argument: tuple[str, int]) -> int:
    """Kills its own process when it is first called with the number 3; each call leaves a line in the folder."""
    folder, number = argument
    with (Path(folder) / f"{number}").open("a") as calls:
        calls.write(f"{os.getpid()}\n")
    if number == 3 and (Path(folder) / "3").read_text().count("\n") == 1:
        os.kill(os.getpid(), signal.SIGKILL)
    return number * number


def die(number: int) -> int:
    os.kill(os.getpid(), signal.SIGKILL)
    return number


def interrupt_itself(number: int) -> int:
    """Sends its own process what Ctrl-C sends."""
    os.kill(os.getpid(), signal.SIGINT)
    return number


def note_and_wait(argument: tuple[str, int]) -> None:
    """Leaves a file named after the process in the folder, and then works for ever."""
    (Path(argument[0]) / str(os.getpid())).touch()
    while True:
        time.sleep(0.05)


class Paused:
    """What is read from a pickle only once it goes on, in the process that reads it."""

    is_read, goes_on = threading.Event(), threading.Event()

    def __reduce__(self) -> tuple[object, tuple[()]]:
        return Paused._read, ()

    @staticmethod
    def _read() -> None:
        Paused.is_read.set()
        Paused.goes_on.wait()


def long_answer() -> tuple[Paused, bytes]:
    """More than a pipe holds: its end is sent only while it is read."""
    return Paused(), bytes(1_000_000)


def note_and_wait_after(argument: tuple[str, int]) -> int:
    """The numbers 0 and 1 are given back; others work for ever."""
    if argument[1] > 1:
        note_and_wait(argument)
    return argument[1]


def slow_square(argument: tuple[str, int]) -> int:
    """A tenth of a second of work; each call leaves a line in the folder."""
    folder, number = argument
    end = time.monotonic() + 0.1
    while time.monotonic() < end:
        pass
    with (Path(folder) / f"{number}").open("a") as calls:
        calls.write(f"{os.getpid()}\n")
    return number * number


def measured_number(part: Mapping[str, Any]) -> dict[str, int]:
    """The square of a number; 3 is refused."""
    if part["number"] == 3:
        raise InputError("number 3 is refused.")
    return {"square": part["number"] ** 2}


def summed_numbers(rows: Sequence[dict[str, Any]]) -> dict[str, int]:
    return {"sum": sum(row["result"]["square"] for row in rows)}


def priority() -> int:
    """The niceness of the process that calls this."""
    return os.nice(0)


def unsendable() -> object:
    """A result that no other process can be given."""
    return lambda: 1
