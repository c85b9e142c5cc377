"""The queue of training runs in one folder: a few train at a time, each in a process of its own, and others wait.

All that matters is on disk, so that another queue on the same folder, after a restart or beside this one, sees the
same: who waits and in which order (``job.json`` in the folder of each run), who trains (``process.json``), why one
failed (``errors.txt``). A process outlives the queue that started it, and the next queue finds it again.
"""

from __future__ import annotations

import contextlib
import errno
import os
import shutil
import threading
import time
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path

from filelock import FileLock

from laplace_core.agents.settings import LoopSettings
from laplace_core.errors import InputError
from laplace_core.supervise import End, Worker, command, end_in, read_process
from laplace_core.training.defaults import name_of
from laplace_core.training.job import Job, born_at, is_run, read_job, run_folders, settings_in, write_job
from laplace_core.training.run_folder import RUN_NAME, new_run

MOST_TRAINING = 2
MOST_WAITING = 20
EVERY = 0.4
"""Seconds between two looks at the runs, while one trains or waits."""
_MOST_BUFFER = 2_000_000_000

WAITING, TRAINING, FINISHED, STOPPED, FAILED = "waiting", "training", "finished", "stopped", "failed"


@dataclass(frozen=True)
class Run:
    """One run as it stands.

    Attributes:
        settings: None if its folder holds none that can be read.
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
        return self.state in (WAITING, TRAINING)


class Queue:
    """The runs in ``folder``.

    Raises:
        InputError: a folder that cannot be made or written to.
    """

    def __init__(self, folder: str | Path, most: int = MOST_TRAINING):
        self.folder, self._most = Path(folder), most
        self._workers: dict[str, Worker] = {}
        self._new = True
        self._turn = threading.RLock()
        self._thread: threading.Thread | None = None
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
        if process is not None and process.alive:
            state = TRAINING
        elif (path / "last.safetensors").is_file():
            state = FINISHED
        else:
            state = {"run": WAITING, "fail": FAILED}.get(job.wanted, STOPPED)
        return Run(path.name, path, settings, state, 0, error if state == FAILED else None, born), job

    def add(self, settings: LoopSettings) -> str:
        """A new run, which begins when there is a place; returns its name.

        Raises:
            InputError: settings that no agent can be made of, the very run that is here already, or too many that wait.
        """
        check_trainable(settings)
        self._make()  # it may have been deleted since
        with self._locked():
            runs = self.runs()
            for run in runs:
                if run.settings == settings:
                    raise InputError(f"this very run is here already, as {run.name}: take another seed, or resume it.")
            _check_line(runs)
            path, taken = self.folder / name_of(settings), 1
            while path.exists() or path.is_symlink():
                taken += 1
                path = self.folder / f"{name_of(settings)}_{taken}"
            new_run(path, settings)
            write_job(path, Job("run", time.time_ns()))
        self.wake()
        return path.name

    def resume(self, name: str) -> None:
        """Let a run that was stopped or failed go on when there is a place."""
        with self._locked():
            run = self.get(name)
            if run.state in (STOPPED, FAILED) and run.settings is not None:
                _check_line(self.runs())
                write_job(run.folder, Job("run", time.time_ns()))
        self.wake()

    def stop(self, name: str) -> None:
        """End a run within some two seconds, or take it out of the queue; it stays and can be resumed."""
        with self._locked():
            run = self.get(name)
            if run.going:
                write_job(run.folder, Job("stop", 0))
            # Ours, and the one that another server has started since.
            workers = [self._workers.pop(name, None), Worker.noted(run.folder)]
        for worker in workers:
            if worker is not None:
                worker.stop()
        self.wake()

    def remove(self, name: str) -> None:
        """End a run and delete its files."""
        self.stop(name)
        with self._locked():
            run = self.get(name)  # once more: somebody else may have removed or resumed it
            if run.going:
                raise InputError(f"{name} was resumed at this moment: remove it again.")
            away = self.folder / f".removed-{time.time_ns()}"  # gone at once for whoever looks
            try:
                os.rename(run.folder, away)
            except OSError as error:
                raise InputError(f"{name} cannot be removed: {(error.strerror or 'unknown error').lower()}.") from None
            shutil.rmtree(away, ignore_errors=True)

    def wake(self) -> None:
        """Start the thread that begins runs as places become free, until none waits or trains any more."""
        with self._turn:
            if self._thread is None or not self._thread.is_alive():
                self._thread = threading.Thread(target=self._attend, name="training queue", daemon=True)
                self._thread.start()

    def _attend(self) -> None:
        while True:
            with self._turn:
                try:
                    going = self.tick()
                except (OSError, InputError):  # the folder is full or gone for the moment
                    going = self.folder.is_dir()
                if not going:
                    self._thread = None
                    return
            time.sleep(EVERY)

    def tick(self) -> bool:
        """Record which runs have ended and start the next ones; returns whether any run still trains or waits."""
        with self._locked():
            for path in run_folders(self.folder):
                self._settle(path)
            self._new = False
            runs = self.runs()
            free = self._most - sum(run.state == TRAINING for run in runs)
            queued = sorted((run for run in runs if run.state == WAITING), key=lambda run: run.place)
            for run in queued[: max(0, free)]:
                if not read_job(run.folder).begun:  # else its process is ending, and the next look settles it
                    self._start(run)
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
        if run.state != WAITING or not job.begun:
            return
        if worker is not None and end is None:
            return  # it is ending: its note of itself goes before it does
        end = end or end_in(path)
        if end.asked:
            write_job(path, Job("later", job.ticket))
            return
        error = _why(end)
        write_job(path, Job("run", job.ticket) if error is None else Job("fail", 0, error=error))

    def _start(self, run: Run) -> None:
        write_job(run.folder, Job("run", read_job(run.folder).ticket, begun=True))
        self._workers[run.name] = Worker.start(run.folder, _command(run.folder.resolve()))


def _command(folder: Path) -> list[str]:
    """To resume a run that has not begun is to begin it."""
    return command("train", "--resume", str(folder))


def _why(end: End) -> str | None:
    """Why a run broke off, as one sentence; None if it was cut off unseen and complained about nothing."""
    if end.refusal:
        return end.refusal
    if end.fault:
        return f"training broke off: {end.fault}; errors.txt in the run's folder says more."
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
    size = settings.buffer * (8 * vector.spec(settings.environment).observation + 18)
    if size > _MOST_BUFFER:
        raise InputError(f"these settings ask for a replay buffer of {size / 1e9:.1f} GB: lower buffer.")


def _check_line(runs: list[Run]) -> None:
    if sum(run.state == WAITING for run in runs) >= MOST_WAITING:
        raise InputError(f"{MOST_WAITING} runs wait already: cancel some, or come back when they have begun.")
