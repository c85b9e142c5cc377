"""A process at work in its own folder: its start, its note there, its end and the reason for it."""

from __future__ import annotations

import contextlib
import re
import signal
import subprocess
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from laplace_core.errors import InputError
from laplace_core.supervise.note import last_line, read_process, refusal_in, write_process
from laplace_core.supervise.process import PATIENCE, Process, start

ERRORS = "errors.txt"
"""The file in the folder of a worker that holds the error messages of its process."""
_ASKED_TO_END = (-signal.SIGTERM, -signal.SIGINT, 128 + signal.SIGTERM, 128 + signal.SIGINT)


@dataclass(frozen=True)
class End:
    """How a process ended.

    Attributes:
        status: its exit status, minus the number of the signal that killed it; None if it was not our child, so that
            nobody saw it.
        line: the last line of its error messages; empty if there are none.
    """

    status: int | None
    line: str

    @property
    def asked(self) -> bool:
        """Whether somebody asked it to end, as the system does before it is shut down."""
        return self.status in _ASKED_TO_END

    @property
    def signal(self) -> int | None:
        """The number of the signal that killed it."""
        return -self.status if self.status is not None and self.status < 0 else None

    @property
    def refusal(self) -> str | None:
        """The sentence with which the command line refused to go on."""
        return refusal_in(self.line)

    @property
    def fault(self) -> str | None:
        """The message of the exception that ended it, without its name and without a full stop."""
        name = re.match(r"[A-Za-z_][\w.]*(Error|Exception)\b(: )?", self.line)
        return None if name is None else self.line[name.end() :].rstrip(".") or "a fault of the program"


class Worker:
    """A process that works in ``folder``: our child, or one that another server has started and noted there."""

    def __init__(self, folder: Path, process: Process, child: subprocess.Popen[bytes] | None = None):
        self.folder, self.process, self._child = folder, process, child

    @classmethod
    def start(cls, folder: Path, words: Sequence[str]) -> Worker:
        """Begin a process and note it in the folder, where another server finds it.

        Raises:
            OSError, InputError: it cannot be started, or not be noted; then it does not run.
        """
        child = start(words, folder / ERRORS)
        worker = cls(folder, Process.of(child.pid), child)
        try:
            write_process(folder, worker.process)
        except (OSError, InputError):
            worker.stop()
            raise
        return worker

    @classmethod
    def noted(cls, folder: Path) -> Worker | None:
        """The worker of the folder's note; None if there is no note."""
        process = read_process(folder)
        return None if process is None else cls(folder, process)

    @property
    def end(self) -> End | None:
        """How its process ended; None while it runs."""
        if self._child is None:
            return None if self.process.alive else end_in(self.folder)
        status = self._child.poll()
        return None if status is None else end_in(self.folder, status)

    @property
    def ended(self) -> bool:
        return not self.process.alive if self._child is None else self._child.poll() is not None

    def ask(self) -> None:
        """Ask the process to end, and return at once: it may have to write a file first."""
        self.process.ask()

    def stop(self, patience: float = PATIENCE) -> None:
        """End the process and all that it has started; returns when they are gone.

        Args:
            patience: seconds that it is given to end when it is asked to, before it is killed.
        """
        self.process.end(patience)
        if self._child is not None:
            with contextlib.suppress(subprocess.TimeoutExpired):
                self._child.wait(patience)


def end_in(folder: Path, status: int | None = None) -> End:
    """How the process of a folder ended that does not run any more."""
    return End(status, last_line(folder / ERRORS))


def command(*words: str) -> list[str]:
    """The words that start this library's command line in a separate process."""
    return [sys.executable, "-m", "laplace_core", *words]
