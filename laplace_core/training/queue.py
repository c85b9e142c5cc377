"""The queue of training runs in one folder: a few train at a time, each in a separate process, and others wait.

All that matters is on disk, so that another queue on the same folder, after a restart or beside this one, sees the
same: who waits and in which order (``job.json`` in the folder of each run), who trains (its lock and
``process.json``), why one failed (``errors.txt``). A process outlives the queue that started it, and the next queue
finds it again. Whatever is wrong with the files of one run is that run's failure, and the others go on.
"""

from __future__ import annotations

import contextlib
import errno
import os
import shutil
import threading
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path

from filelock import FileLock

from laplace_core.agents.settings import LoopSettings
from laplace_core.errors import InputError
from laplace_core.supervise import End, Process, Worker, command, end_in, is_taken, read_process
from laplace_core.training.defaults import name_of
from laplace_core.training.disk import check_free, held
from laplace_core.training.job import (
    Job,
    ask_to_stop,
    born_at,
    forget_request,
    is_run,
    read_job,
    run_folders,
    settings_in,
    write_job,
    write_owner,
)
from laplace_core.training.run_folder import RUN_NAME, new_run

MOST_TRAINING = 2
MOST_WAITING = 20
EVERY = 0.4
"""Seconds between two looks at the runs, while one trains or waits."""
_STARTS_WITHIN = 60.0
"""Seconds in which a process of another container may be on its way to take the lock of its run."""
_LEAVES_WITHIN = 10.0
"""Seconds that a process of another container is given to end before its files are removed."""

WAITING, TRAINING, STOPPING, FINISHED, STOPPED, FAILED = (
    "waiting", "training", "stopping", "finished", "stopped", "failed",
)  # fmt: skip


@dataclass(frozen=True)
class Run:
    """The present state of one run.

    Attributes:
        settings: None if its folder holds none that can be read.
        state: "stopping" from the request to end until its resume point is written and its process gone.
        place: in the queue, from 1; 0 if it does not wait.
        error: one sentence if it failed.
        born: when it was made, in seconds.
    """

    name: str
    folder: Path
    settings: LoopSettings | None
    state: str
    place: int = 0
    error: str | None = None
    born: float = 0.0

    @property
    def going(self) -> bool:
        return self.state in (WAITING, TRAINING, STOPPING)

    @property
    def at_work(self) -> bool:
        """Whether it has a process."""
        return self.state in (TRAINING, STOPPING)

    @property
    def best(self) -> Path | None:
        """The checkpoint of the best evaluation so far; None before the first."""
        path = self.folder / "best.safetensors"
        return path if path.is_file() and not path.is_symlink() else None


class Queue:
    """The runs in ``folder``.

    Args:
        most: runs that train at once.
        most_bytes: that all runs may hold on disk; None is as much as there is.
        allowed: whether an environment may be trained on.
        read_only: runs are shown and nothing is changed: none is started, stopped or removed.

    Attributes:
        trouble: why the queue itself cannot go on for the moment, as one sentence; None while it can.

    Raises:
        InputError: a folder that cannot be made or written to.
    """

    def __init__(
        self, folder: str | Path, most: int = MOST_TRAINING, *, most_bytes: int | None = None,
        allowed: Callable[[str], bool] = lambda environment: True, read_only: bool = False,
    ):  # fmt: skip
        self.folder, self._most, self._most_bytes = Path(folder), most, most_bytes
        self._allowed, self._read_only = allowed, read_only
        self.trouble: str | None = None
        self._workers: dict[str, Worker] = {}
        self._broken: dict[str, str] = {}  # why a run failed whose folder takes no note of it
        self._new = True
        self._turn = threading.RLock()
        self._thread: threading.Thread | None = None
        if not read_only:
            self._make()

    def _make(self) -> None:
        try:
            self.folder.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise self._refusal(error) from None
        with self._locked():
            pass

    def _refusal(self, error: OSError) -> InputError:
        return InputError(f"no run can be kept in {self.folder}: {(error.strerror or 'unknown error').lower()}.")

    @contextlib.contextmanager
    def _locked(self) -> Iterator[None]:
        """One at a time, among threads and among servers on the same folder."""
        if self._read_only:
            raise InputError("this server only shows runs: nothing can be started, stopped or removed here.")
        with self._turn:
            if not self.folder.is_dir():  # the lock would make it
                raise self._refusal(FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT)))
            lock = FileLock(self.folder / ".lock", mode=0o600, poll_interval=0.01)
            try:
                lock.acquire()
            except OSError as error:
                raise self._refusal(error) from None
            try:
                yield
            finally:
                lock.release()

    def runs(self) -> list[Run]:
        """Every run, the newest first."""
        pairs = [self._look(path) for path in run_folders(self.folder)]
        queued = sorted((job.ticket, run.name) for run, job in pairs if run.state == WAITING)
        places = {name: place for place, (_, name) in enumerate(queued, 1)}
        runs = [replace(run, place=places.get(run.name, 0)) for run, _ in pairs]
        return sorted(runs, key=lambda run: (-run.born, run.name))

    def get(self, name: str) -> Run:
        """One run by its name.

        Raises:
            InputError: there is none of that name.
        """
        if RUN_NAME.fullmatch(name) and is_run(self.folder / name):
            return next((run for run in self.runs() if run.name == name), None) or self._look(self.folder / name)[0]
        raise InputError(f"there is no run {name[:60]!r} here.")

    def _look(self, path: Path) -> tuple[Run, Job]:
        job, process = read_job(path), read_process(path)
        born, error = born_at(path), job.error
        settings, refused = settings_in(path / "config.json", born)
        if settings is None:
            return Run(path.name, path, None, FAILED, 0, f"its settings cannot be read: {refused}", born), job
        if _trains(path, process, job):
            state = STOPPING if job.wanted == "stop" and job.begun else TRAINING
        elif (path / "last.safetensors").is_file():
            state = FINISHED
        else:
            state = {"run": WAITING, "fail": FAILED}.get(job.wanted, STOPPED)
        if path.name in self._broken and state in (WAITING, STOPPED):
            state, error = FAILED, self._broken[path.name]
        return Run(path.name, path, settings, state, 0, error if state == FAILED else None, born), job

    def add(self, settings: LoopSettings, owner: str | None = None) -> str:
        """A new run, which begins when there is a place; returns its name.

        Args:
            owner: whose it is, in any form that is not secret; see :func:`laplace_core.training.job.owner_of`.

        Raises:
            InputError: settings that no agent can be made of or that this queue does not train, the very run that is
                here already, too many that wait, or no room on the disk.
        """
        check_trainable(settings)
        self._check_allowed(settings)
        self._make()  # it may have been deleted since
        with self._locked():
            runs = self.runs()
            for run in runs:
                if run.settings == settings:
                    raise InputError(f"this very run is here already, as {run.name}: take another seed, or resume it.")
            _check_line(runs)
            self._check_room(settings, [run for run in runs if run.going])
            path, taken = self.folder / name_of(settings), 1
            while path.exists() or path.is_symlink():
                taken += 1
                path = self.folder / f"{name_of(settings)}_{taken}"
            new_run(path, settings)
            if owner is not None:
                write_owner(path, owner)
            write_job(path, Job("run", time.time_ns()))
        self.wake()
        return path.name

    def resume(self, name: str) -> None:
        """Let a run that was stopped or failed go on when there is a place.

        Raises:
            InputError: no such run, one that this queue does not train, or too many that wait.
        """
        with self._locked():
            run = self.get(name)
            if run.state in (STOPPED, FAILED) and run.settings is not None:
                self._check_allowed(run.settings)
                _check_line(self.runs())
                self._broken.pop(name, None)
                write_job(run.folder, Job("run", time.time_ns()))
        self.wake()

    def stop(self, name: str, patience: float | None = None) -> None:
        """Ask a run to end, or take it out of the queue; it stays and can be resumed.

        Its process writes a resume point first and is not disturbed, however long that takes.

        Args:
            patience: seconds to wait for its end; None waits until it comes.

        Raises:
            InputError: no such run, or a folder that takes no note; the process is asked to end all the same.
        """
        with self._locked():
            run = self.get(name)
            workers = self._workers_of(run)
            for worker in workers:
                worker.ask()
            if run.at_work:
                write_job(run.folder, Job("stop", 0, begun=True))
            elif run.going:
                write_job(run.folder, Job("stop", 0))
        self.wake()
        if run.at_work and self._wait(run.folder, workers, patience):
            with self._locked():
                self._settle(run.folder)

    def end_at_once(self, name: str) -> None:
        """End a run that was asked to end and does not; it can be resumed from its last resume point.

        Raises:
            InputError: no such run, or one whose process is in another container and does not end when it is asked to.
        """
        with self._locked():
            run = self.get(name)
            workers = self._workers_of(run)
            self._workers.pop(name, None)
            if run.going:
                write_job(run.folder, Job("stop", 0))
        for worker in workers:
            worker.stop()
        if not self._wait(run.folder, workers, _LEAVES_WITHIN):
            raise InputError(f"{name} is trained by another server: end it there, or wait until it has ended.")
        self.wake()

    def _workers_of(self, run: Run) -> list[Worker]:
        """Ours, and the one that another server has started since."""
        return [worker for worker in (self._workers.get(run.name), Worker.noted(run.folder)) if worker is not None]

    def _wait(self, path: Path, workers: list[Worker], patience: float | None) -> bool:
        """Wait until nobody trains a run any more, for so many seconds at the most; returns whether that is so."""
        limit = None if patience is None else time.monotonic() + patience
        # A process gives back lock and note a moment before it is gone.
        while any(worker.process.alive for worker in workers) or _trains(path, read_process(path), read_job(path)):
            ask_to_stop(path)  # also where a signal does not reach it, in another container
            if limit is not None and time.monotonic() >= limit:
                return False
            time.sleep(0.05)
        forget_request(path)
        return True

    def remove(self, name: str) -> None:
        """End a run, without a resume point, and delete its files.

        Raises:
            InputError: no such run, or one that cannot be ended or deleted.
        """
        self.end_at_once(name)
        with self._locked():
            run = self.get(name)  # once more: somebody else may have removed or resumed it
            if run.going:
                raise InputError(f"{name} was resumed at this moment: remove it again.")
            away = self.folder / f".removed-{time.time_ns()}"  # gone at once for every reader
            try:
                os.rename(run.folder, away)
            except OSError as error:
                raise InputError(f"{name} cannot be removed: {(error.strerror or 'unknown error').lower()}.") from None
            self._broken.pop(name, None)
            shutil.rmtree(away, ignore_errors=True)

    def _check_allowed(self, settings: LoopSettings) -> None:
        if not self._allowed(settings.environment):
            raise InputError(f"this server does not train on {settings.environment}: choose another environment.")
        if self._most < 1:
            raise InputError("this server trains nothing: train on your own machine, by the command line.")

    def _check_room(self, settings: LoopSettings, others: list[Run], folder: Path | None = None) -> None:
        """Refuse a run whose files will not fit beside what is there and what other runs will still write.

        Args:
            folder: of the run, where it has one already.
        """
        pairs = [(run.settings, run.folder) for run in others if run.settings is not None]
        needed = sum(
            max(0, bytes_of_run(each) - (0 if path is None else held(path)))
            for each, path in [(settings, folder), *pairs]
        )
        check_free(self.folder, needed, self._most_bytes)

    def wake(self) -> None:
        """Start the thread that begins runs as places become free, until none waits or trains any more."""
        if self._read_only:
            return
        with self._turn:
            if self._thread is None or not self._thread.is_alive():
                self._thread = threading.Thread(target=self._attend, name="training queue", daemon=True)
                self._thread.start()

    def _attend(self) -> None:
        while True:
            with self._turn:
                try:
                    going, self.trouble = self.tick(), None
                except (OSError, InputError) as error:  # the folder is full or gone for the moment
                    going, self.trouble = self.folder.is_dir(), _sentence(error)
                if not going:
                    self._thread = None
                    return
            time.sleep(EVERY)

    def tick(self) -> bool:
        """Record which runs have ended and start the next ones; returns whether any run still trains or waits."""
        with self._locked():
            for path in run_folders(self.folder):
                try:
                    self._settle(path)
                except (OSError, InputError) as error:
                    self._fail(path, error)
            self._new = False
            runs = self.runs()
            places = self._most - sum(run.at_work for run in runs)
            for run in sorted((run for run in runs if run.state == WAITING), key=lambda run: run.place):
                if places < 1:
                    break
                ending = read_job(run.folder).begun  # the next look settles it
                if ending or self._start(run):
                    places -= 1
        return any(run.going for run in runs)

    def _settle(self, path: Path) -> None:
        """Record the end of a process: a failure, or, if nobody watched it end, an interruption to resume from."""
        worker = self._workers.get(path.name)
        end = None if worker is None else worker.end
        if end is not None:
            del self._workers[path.name]
        run, job = self._look(path)
        if job.wanted == "later" and self._new:
            write_job(path, Job("run", job.ticket))
        if run.state not in (WAITING, STOPPED) or not job.begun:
            return
        if worker is not None and end is None:
            return  # it is ending: its note of itself goes before it does
        if job.wanted == "stop":
            refusal = None if end is None else end.refusal  # as of a resume point that there is no room for
            write_job(path, Job("stop", 0) if refusal is None else Job("fail", 0, error=refusal))
            return
        end = end or end_in(path)
        if end.asked:
            write_job(path, Job("later", job.ticket))
            return
        error = _why(end)
        write_job(path, Job("run", job.ticket) if error is None else Job("fail", 0, error=error))

    def _start(self, run: Run) -> bool:
        """Begin to train a run; returns whether it began. What keeps it from that is its failure."""
        try:
            assert run.settings is not None  # others do not wait
            self._check_allowed(run.settings)
            self._check_room(run.settings, [other for other in self.runs() if other.at_work], run.folder)
            forget_request(run.folder)
            write_job(run.folder, Job("run", read_job(run.folder).ticket, begun=True))
            self._workers[run.name] = Worker.start(run.folder, _command(run.folder.resolve(), self._most_bytes))
        except (OSError, InputError) as error:
            self._fail(run.folder, error)
            return False
        return True

    def _fail(self, path: Path, error: OSError | InputError) -> None:
        """Note why a run cannot go on: in its folder, or, where that is what is wrong, here."""
        try:
            write_job(path, Job("fail", 0, error=_sentence(error)))
        except (OSError, InputError):
            self._broken[path.name] = _sentence(error)


def _sentence(error: OSError | InputError) -> str:
    if isinstance(error, InputError):
        return str(error)
    name = Path(str(error.filename)).name if error.filename else "a file of the run"
    return f"{name} cannot be used: {(error.strerror or 'unknown error').lower()}."


def _trains(path: Path, process: Process | None, job: Job) -> bool:
    """Whether a process works on a run, in any container."""
    if (process is not None and process.alive) or is_taken(path):
        return True
    if process is None or process.near or not job.begun:
        return False
    return abs(time.time() - process.started) < _STARTS_WITHIN


def _command(folder: Path, most_bytes: int | None) -> list[str]:
    """To resume a run that has not begun is to begin it."""
    disk = [] if most_bytes is None else ["--disk", str(most_bytes // 10**6)]
    return command("train", "--resume", str(folder), *disk)


def _why(end: End) -> str | None:
    """Why a run broke off, as one sentence; None if it was cut off unseen and complained about nothing."""
    if end.refusal:
        return end.refusal
    if end.fault:
        return f"training broke off: {end.fault}; errors.txt in the run's folder has the details."
    if end.signal is not None:
        return f"its process was killed (signal {end.signal}); resume it, smaller if memory was short."
    return None if end.status is None else f"its process ended too early, with status {end.status}; resume it."


def check_trainable(settings: LoopSettings) -> None:
    """Refuse at once what training would refuse later; loads torch.

    Raises:
        InputError: settings that do not fit the environment, or an environment whose physics is not installed.
    """
    from laplace_core.environments import vector
    from laplace_core.training.checkpoint import new_agent

    vector.make(settings.environment).close()
    new_agent(settings)


@lru_cache(maxsize=256)
def bytes_of_run(settings: LoopSettings) -> int:
    """Bytes that the files of a run take at the most; loads torch."""
    from laplace_core.training import resume_point

    return resume_point.bytes_of_run(settings)


def _check_line(runs: list[Run]) -> None:
    if sum(run.state == WAITING for run in runs) >= MOST_WAITING:
        raise InputError(f"{MOST_WAITING} runs wait already: cancel some, or come back when they have begun.")
