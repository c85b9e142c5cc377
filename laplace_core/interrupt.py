"""Ctrl-C while the command line starts: one line on stderr and exit status 130.

Most of the time of a short command goes into imports. An exception that is raised there comes out as a traceback, or is
lost in somebody else's module. So until the command begins a handler of ours ends the process: nothing has been written
yet. This module imports next to nothing itself.
"""

from __future__ import annotations

import os
import signal
import sys
from typing import NoReturn

STATUS = 128 + signal.SIGINT
LINE = "laplace: stopped"


def guard_start() -> None:
    """End quietly on Ctrl-C from here on, if this process is the command and not a program that uses the library."""
    # While Python imports the package of ``python -m``, "-m" is all that it says of the command.
    if sys.argv[:1] == ["-m"] or os.path.basename(sys.argv[0] if sys.argv else "") == "laplace":
        signal.signal(signal.SIGINT, end)


def end(_number: int, _frame: object) -> NoReturn:
    """The handler: end the process with the line."""
    os.write(2, f"{LINE}\n".encode())
    os._exit(STATUS)
