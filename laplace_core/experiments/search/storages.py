"""The storage of a search's trials: an SQLite file, a PostgreSQL server, or a journal that many machines append to.

All of them record a heartbeat of each running trial. A trial whose heartbeat stops is failed, and queued again with the
same values; the training behind it goes on from its checkpoint.
"""

from __future__ import annotations

import copy
import logging
import re
import time
import warnings
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from functools import lru_cache
from pathlib import Path

import optuna
from filelock import FileLock
from optuna.exceptions import ExperimentalWarning, OptunaError, StorageInternalError
from optuna.storages import BaseStorage, JournalStorage, RDBStorage, RetryHeartbeatStaleTrialCallback
from optuna.storages._heartbeat import BaseHeartbeat
from optuna.storages.journal import JournalFileBackend, JournalFileOpenLock
from optuna.trial import FrozenTrial, TrialState
from sqlalchemy.exc import SQLAlchemyError

from laplace_core.errors import InputError
from laplace_core.supervise.parallel import TRIES

HEARTBEAT = 20
"""Seconds between two heartbeats of a running trial, unless the search says otherwise."""
MISSED = 3
"""Heartbeats without a sign after which a trial counts as lost."""
_SQLITE = (".db", ".sqlite", ".sqlite3")
_JOURNAL = (".journal", ".log")
_POSTGRES = re.compile(r"postgres(ql)?(\+psycopg)?://")
_PATIENCE = 60.0  # seconds that a process waits for its turn to write to an SQLite file
_SQLITE_URL = "sqlite:///"
_BEATS = "heartbeat"
_KINDS = "a file that ends in .db (SQLite) or .journal, or an address postgresql://USER@HOST:PORT/DATABASE"

Queued = Callable[[optuna.Study, FrozenTrial], None]
"""Queues a lost trial again."""


class BeatingJournal(JournalStorage, BaseHeartbeat):
    """A journal that records heartbeats, which Optuna's own does not: the time of each is an attribute of its trial.

    The clocks of all machines that append to it must agree to within a few seconds.

    Args:
        path: of the journal; an open-lock beside it orders the writers, on NFS as well.
        interval: seconds between two heartbeats.
        grace: seconds without one after which a trial is lost.
    """

    def __init__(self, path: str, *, interval: int, grace: int, queued: Queued) -> None:
        super().__init__(JournalFileBackend(path, lock_obj=JournalFileOpenLock(path)))
        self._interval, self._grace, self._queued = interval, grace, queued

    def record_heartbeat(self, trial_id: int) -> None:
        try:
            self.set_trial_system_attr(trial_id, _BEATS, time.time())
        except optuna.exceptions.UpdateFinishedTrialError:
            return  # another worker has taken it for lost

    def _get_stale_trial_ids(self, study_id: int) -> list[int]:
        oldest = time.time() - self._grace
        running = self.get_all_trials(study_id, deepcopy=False, states=(TrialState.RUNNING,))
        return [trial._trial_id for trial in running if trial.system_attrs.get(_BEATS, oldest) < oldest]

    def get_heartbeat_interval(self) -> int:
        return self._interval

    def get_heartbeat_stale_trial_callback(self) -> Queued:
        return self._queued


class _SqliteFile(RDBStorage):
    """An SQLite file that hands a queued trial to one worker only.

    Optuna takes a trial by a read and a write, with a lock on the row between them that SQLite does not know: two
    workers would take the same one. Here a lock file beside it orders them.
    """

    def set_trial_state_values(
        self, trial_id: int, state: TrialState, values: Sequence[float] | None = None
    ) -> bool:  # fmt: skip
        with FileLock(f"{self.url.removeprefix(_SQLITE_URL)}.lock", _PATIENCE):
            return super().set_trial_state_values(trial_id, state, values)


def check_storage(text: str) -> None:
    """Refuse what names no storage.

    Raises:
        InputError: such a text.
    """
    if not _POSTGRES.match(text) and ("://" in text or Path(text).suffix not in (*_SQLITE, *_JOURNAL)):
        raise InputError(f"the storage must be {_KINDS}, not {text[:80]!r}.")


def absolute(text: str) -> str:
    """The same storage for a process that is at work in another folder."""
    return text if _POSTGRES.match(text) else str(Path(text).absolute())


JOB = "job"
"""The attribute of a trial that says which job of the plan it does."""


def queue_again(study: optuna.Study, trial: FrozenTrial) -> None:
    """Queue a lost trial again with the values that it had, unless it was lost ``TRIES`` times.

    Its job goes with it; the signs of life of its worker do not, or it would be lost again as soon as it begins.
    """
    trial = copy.deepcopy(trial)
    trial.user_attrs = {name: value for name, value in trial.user_attrs.items() if name == JOB}
    trial.system_attrs = {name: value for name, value in trial.system_attrs.items() if name != _BEATS}
    with warnings.catch_warnings(action="ignore", category=ExperimentalWarning):
        RetryHeartbeatStaleTrialCallback(max_retry=TRIES)(study, trial)


@lru_cache(maxsize=8)
def storage_of(text: str, interval: int = HEARTBEAT) -> BaseStorage:
    """The storage that a text names, opened once in a process.

    Args:
        interval: seconds between two heartbeats.

    Raises:
        InputError: a text that names none, or a storage that cannot be opened.
    """
    check_storage(text)
    optuna.logging.set_verbosity(logging.ERROR)  # the search itself reports a trial that fails
    if _POSTGRES.match(text):
        _check_driver()
        return _database(_POSTGRES.sub("postgresql+psycopg://", text), interval)
    path = Path(text)
    with readable(text):
        path.parent.mkdir(parents=True, exist_ok=True)
        if path.suffix in _SQLITE:
            return _database(f"{_SQLITE_URL}{path.absolute()}", interval)
        return BeatingJournal(str(path), interval=interval, grace=MISSED * interval, queued=queue_again)


def _database(url: str, interval: int) -> RDBStorage:
    connect = {"timeout": _PATIENCE} if url.startswith("sqlite") else {}
    for left in (2, 1, 0):  # workers that begin at the same time may all be about to make the tables
        try:
            with warnings.catch_warnings(action="ignore", category=ExperimentalWarning), readable(url):
                return (_SqliteFile if connect else RDBStorage)(
                    url,
                    {"connect_args": connect},
                    heartbeat_interval=interval,
                    grace_period=MISSED * interval,
                    heartbeat_stale_trial_callback=queue_again,
                )
        except InputError:
            if not left:
                raise
            time.sleep(0.5)
    raise AssertionError("the last attempt returns or raises")


def _check_driver() -> None:
    try:
        import psycopg  # noqa: F401  the driver that SQLAlchemy loads by this name
    except ImportError:
        raise InputError("PostgreSQL needs its driver: pip install -r requirements-postgresql.txt.") from None


@contextmanager
def readable(text: str) -> Iterator[None]:
    """A failure of a storage as one sentence, without the password of an address.

    Raises:
        InputError: instead of an error of the database, of a file or of Optuna.
    """
    try:
        yield
    except (*FAILURES, OptunaError, OSError, ValueError, LookupError, TypeError, AssertionError) as error:
        reason = (str(getattr(error, "orig", None) or error).strip() or type(error).__name__).splitlines()[0]
        raise InputError(f"the storage {_without_password(text)[:80]} cannot be used: {reason[:200]}.") from None


FAILURES = (SQLAlchemyError, StorageInternalError)
"""What a database raises that cannot be reached or does not answer."""


def _without_password(text: str) -> str:
    return re.sub(r"(://[^:/@]*):[^@]*@", r"\1@", text)
