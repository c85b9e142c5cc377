"""Processes that learn or train beside the application: how they begin, are known again, and end."""

from laplace_core.supervise.note import FILE, PLAIN, last_line, read_process, read_small, refusal_in, write_process
from laplace_core.supervise.process import ONE_THREAD, Process, start

__all__ = [
    "FILE",
    "ONE_THREAD",
    "PLAIN",
    "Process",
    "last_line",
    "read_process",
    "read_small",
    "refusal_in",
    "start",
    "write_process",
]
