"""Independent jobs side by side: in processes of this machine through joblib, or on a Ray cluster.

A job whose process dies is done again, and so are those that were under way beside it; finished ones keep their
results. Workers end with the process that started them, however that ends. Ctrl-C is for that process alone, so that no
worker prints a traceback.
"""

from __future__ import annotations

import logging
import os
import re
import signal
import socket
import threading
import time
import warnings
from collections.abc import Callable, Generator, Iterator, Sequence
from contextlib import closing, contextmanager
from typing import Any, TypeVar

from laplace_core.errors import InputError

Argument = TypeVar("Argument")
Result = TypeVar("Result")

TRIES = 3
"""How often a job is begun before its process has died too often."""
_ANSWERS_WITHIN = 10.0  # seconds until an address counts as one where nothing answers
_LOOK_EVERY = 1.0  # seconds between two looks at whether the parent still lives


def in_parallel(
    function: Callable[[Argument], Result],
    arguments: Sequence[Argument],
    processes: int = 1,
    cluster: str | None = None,
) -> Generator[tuple[int, Result], None, None]:
    """Call a function once for each argument, and give results in the order in which they are ready.

    Args:
        function: of a module, so that another process can import it; arguments and results are pickled.
        processes: of this machine; with 1 the calls are made here, one after another.
        cluster: address of a Ray cluster, such as ``127.0.0.1:6379`` or ``auto``, which is used in place of processes
            of this machine. The library must be installed on every node, in this version.

    Yields:
        Index of the argument, and its result.

    Raises:
        InputError: a process died ``TRIES`` times at the same job, or there is no such cluster.
        Exception: what the function raised, as soon as it did; jobs that are under way are given up.
    """
    if cluster is not None:
        yield from _on_cluster(function, arguments, cluster)
    elif processes == 1 or len(arguments) < 2:
        for i, argument in enumerate(arguments):
            yield i, function(argument)
    else:
        yield from _in_processes(function, arguments, processes)


def in_order(
    function: Callable[[Argument], Result], arguments: Sequence[Argument], processes: int = 1
) -> Generator[Result, None, None]:
    """As :func:`in_parallel`, with results in the order of the arguments: each once all before it are known."""
    early: dict[int, Result] = {}
    following = 0
    with closing(in_parallel(function, arguments, processes)) as results:
        for i, result in results:
            early[i] = result
            while following in early:
                yield early.pop(following)
                following += 1


def _in_processes(
    function: Callable[[Argument], Result], arguments: Sequence[Argument], processes: int
) -> Iterator[tuple[int, Result]]:
    from joblib import Parallel, delayed
    from joblib.externals.loky.process_executor import TerminatedWorkerError

    left, tries = dict(enumerate(arguments)), 0
    while left:
        call = delayed(_Job(function, os.getpid()))
        pool = Parallel(n_jobs=min(processes, len(left)), return_as="generator_unordered", batch_size=1)
        try:
            with without_interrupt():
                results = pool([call(i, argument) for i, argument in left.items()])
            for i, result in results:
                del left[i]
                tries = 0
                yield i, result
        except GeneratorExit:
            with warnings.catch_warnings(action="ignore", category=UserWarning):  # that jobs are given up is wanted
                results.close()
            raise
        except TerminatedWorkerError as error:  # all that were under way are lost with it, and begin again
            tries += 1
            if tries == TRIES:
                by = re.search(r"SIG[A-Z0-9]+", str(error))  # joblib lists exit statuses, such as SIGKILL(-9)
                raise InputError(
                    f"a process died {TRIES} times without finishing a job, the last time "
                    f"{f'by {by[0]} ' if by else ''}with {len(left)} to go: give each job more memory by fewer "
                    "processes."
                ) from None


@contextmanager
def without_interrupt() -> Iterator[None]:
    """Hold Ctrl-C back for a moment: processes and threads that start within it do not get it at all."""
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


class _Job:
    """A call that another process makes for this one, with the index of its argument."""

    def __init__(self, function: Callable[[Any], Any], parent: int):
        self._function, self._parent = function, parent

    def __call__(self, index: int, argument: object) -> tuple[int, Any]:
        end_with(self._parent)
        return index, self._function(argument)


_watched: set[int] = set()


def end_with(parent: int) -> None:
    """Let this process end when its parent does: a worker whose parent was killed would wait for ever."""
    if parent in _watched or os.getpid() == parent:
        return
    _watched.add(parent)
    if threading.current_thread() is threading.main_thread():
        signal.signal(signal.SIGINT, signal.SIG_IGN)  # where no mask could be given to it

    def watch() -> None:
        while os.getppid() == parent:
            time.sleep(_LOOK_EVERY)
        os._exit(1)

    threading.Thread(target=watch, daemon=True, name="ends with its parent").start()


def _check_address(cluster: str) -> None:
    """Refuse an address at which nothing answers; Ray itself would try for minutes.

    Raises:
        InputError: such an address.
    """
    host, colon, port = cluster.removeprefix("ray://").rpartition(":")
    if not colon:  # ``auto`` and the like
        return
    try:
        socket.create_connection((host, int(port)), timeout=_ANSWERS_WITHIN).close()
    except (OSError, ValueError, OverflowError) as error:
        raise InputError(f"there is no Ray cluster at {cluster[:80]}: {str(error)[:200]}.") from None


def _on_cluster(
    function: Callable[[Argument], Result], arguments: Sequence[Argument], cluster: str
) -> Iterator[tuple[int, Result]]:
    try:
        import ray
    except ImportError:
        raise InputError("a cluster needs Ray: pip install -r requirements-cluster.txt.") from None
    _check_address(cluster)
    try:
        ray.init(address=cluster, log_to_driver=False, logging_level=logging.ERROR)
    except (ConnectionError, ValueError, RuntimeError) as error:
        raise InputError(f"there is no Ray cluster at {cluster[:80]}: {str(error).splitlines()[0][:200]}.") from None
    try:
        # A task whose worker or node is lost is begun again elsewhere; what the function raises is not tried again.
        # Ray takes functions alone; ours may be a partial of one.
        task = ray.remote(num_cpus=1, max_retries=TRIES, retry_exceptions=False)(lambda argument: function(argument))
        waiting = {task.remote(argument): i for i, argument in enumerate(arguments)}
        while waiting:
            (done,), _ = ray.wait(list(waiting), num_returns=1)
            try:
                result = ray.get(done)
            except ray.exceptions.RayTaskError as error:
                raise error.cause from None
            except ray.exceptions.RayError as error:
                raise InputError(f"the cluster lost a job {TRIES} times: {str(error).splitlines()[0][:200]}.") from None
            yield waiting.pop(done), result
    finally:
        ray.shutdown()
