"""Work beside the caller: processes that learn or train, how they start and end; jobs in threads; a server's limits."""

from laplace_core.supervise.lock import is_taken, take
from laplace_core.supervise.note import FILE, PLAIN, last_line, read_process, read_small, refusal_in, write_process
from laplace_core.supervise.process import ONE_THREAD, Process, start
from laplace_core.supervise.worker import ERRORS, End, Worker, command, end_in

__all__ = [
    "ERRORS",
    "FILE",
    "ONE_THREAD",
    "PLAIN",
    "End",
    "Process",
    "Worker",
    "command",
    "end_in",
    "is_taken",
    "last_line",
    "read_process",
    "read_small",
    "refusal_in",
    "start",
    "take",
    "write_process",
]
