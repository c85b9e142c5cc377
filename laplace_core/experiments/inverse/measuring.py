"""A study of the inverse in the background of a server: the command ``study`` in a process, and its growing table."""

from __future__ import annotations

import os
import sys
import tempfile
import time
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any
from weakref import WeakValueDictionary

from laplace_core.caching import BUDGET, Cache
from laplace_core.errors import InputError
from laplace_core.experiments.inverse.selection import GRIDS, NOISES, WORLDS, Plan
from laplace_core.experiments.inverse.selection_report import summed
from laplace_core.experiments.inverse.table_file import rows_in, whole_groups
from laplace_core.inverse import SELECTORS, SOLVERS
from laplace_core.parameters import NUMBER, Parameter, as_text
from laplace_core.supervise import Worker, command
from laplace_core.supervise.jobs import Progress, too_large

SOLVERS_OFFERED = tuple(name for name in SOLVERS if name != "neural")
"""The neural inverse takes only the discounts and rows that it was fitted to, which random worlds do not keep to."""
MOST_ROWS = 20_000
"""Most rows of a study on a page: some 4 MB."""
PARAMETERS = (
    Parameter("worlds", "random", help="Random worlds, or listed worlds."),
    Parameter("cases", 20, 1, 1000, "Number of random worlds, and of noise draws for each listed world."),
    Parameter("noises", ",".join(map(as_text, NOISES)), help="Standard deviations of (1 - gamma) Q, by commas."),
    Parameter("grids", "paper", help="Grids of 15 discounts from .01 to .99."),
    Parameter("solvers", "tikhonov,tikhonov2", help="Solvers of the inverse."),
    Parameter("selectors", "fitted,gcv,lcurve", help="Rules for alpha."),
    Parameter("seed", 0, 0, 2**31 - 1, "Seed of the worlds and of their noise."),
)
"""What a page asks of a study; lists are texts, as the command and links write them."""
OPTIONS: Mapping[str, tuple[str, ...]] = {
    "worlds": WORLDS, "grids": GRIDS, "solvers": SOLVERS_OFFERED, "selectors": tuple(SELECTORS)
}  # fmt: skip
"""The words that a list may hold."""
_LOOK_EVERY = 0.2  # seconds between two looks at the process


def words_in(text: str) -> list[str]:
    """The words of a list that is written as one text."""
    return [word.strip() for word in text.split(",") if word.strip()]


def plan_of(given: Mapping[str, Any]) -> Plan:
    """The plan of values by the names of :data:`PARAMETERS`; what is missing is at its default.

    Raises:
        InputError: words or numbers that make no study, or one that is too large for a page.
    """
    values = {each.name: given.get(each.name, each.default) for each in PARAMETERS}
    noises = words_in(str(values["noises"]))
    for word in noises:
        if not NUMBER.fullmatch(word):
            raise InputError(f"noise {word[:40]!r} is not a number: give numbers above 0 and at most 1, such as 0.001.")
    lists = {name: tuple(words_in(str(values[name]))) for name in OPTIONS}
    if "neural" in lists["solvers"]:
        raise InputError("the neural inverse takes no random world: it was fitted to discounts and rows of its own.")
    plan = Plan(
        cases=int(values["cases"]), seed=int(values["seed"]), noises=tuple(dict.fromkeys(map(float, noises))), **lists
    )
    rows = plan.size * plan.rows_of_a_job
    if rows > MOST_ROWS:
        raise InputError(
            f"this study has {rows:,} rows, and a page takes {MOST_ROWS:,}: lower its worlds, noises or grids."
        )
    return plan


def command_of(plan: Plan, out: str) -> list[str]:
    """The words of the command that measures a plan, after ``laplace``."""
    return [
        "study", "--out", out, "--of", ",".join(plan.worlds), "--worlds", str(plan.cases), "--noise",
        ",".join(map(as_text, plan.noises)), "--grids", ",".join(plan.grids), "--solvers", ",".join(plan.solvers),
        "--selectors", ",".join(plan.selectors), "--seed", str(plan.seed),
    ]  # fmt: skip


class Measuring:
    """A study that is measured, or was, to its end or not: what was measured stays as long as somebody holds this.

    Its table counts in the memory of the server for its caches, and leaves with what was used least recently there.
    """

    def __init__(self, plan: Plan):
        self.plan = plan
        self._path: Path | None = None
        self._place = object()  # the key of its own in the cache
        self._sums: tuple[int, list[dict[str, Any]]] = (0, [])

    @property
    def table(self) -> str:
        """The table so far, CSV behind a comment; empty before the first rows."""
        path = self._path
        if path is None:
            return _tables.get(self._place) or ""
        try:
            return whole_groups(path.read_text(encoding="utf-8"))
        except OSError:  # it does not begin yet, or has just ended
            return ""

    @property
    def done(self) -> int:
        """How many worlds, noises and grids are in it."""
        return self.table.count("\n\n")

    def sums(self) -> Sequence[Mapping[str, Any]]:
        """The table so far, summed up by solver and selector."""
        table = self.table
        if len(table) != self._sums[0]:
            self._sums = len(table), summed(rows_in(table))
        return self._sums[1]

    def measure(self, progress: Progress) -> Measuring:
        """Measure what of it was not measured before.

        Raises:
            InputError: the process cannot start or ended by itself, or the table is too large for the caches.
        """
        try:
            with tempfile.TemporaryDirectory(prefix="laplace_study_", ignore_cleanup_errors=True) as folder:
                path, before = Path(folder) / "study.csv", self.table
                if before:
                    path.write_text(before, encoding="utf-8")
                self._path = path
                words = [*command_of(self.plan, str(path)), "--json", "--parent", str(os.getpid())]
                worker = Worker.start(Path(folder), command(*words))
                try:
                    while not worker.ended:
                        progress(self.done, self.plan.size)
                        time.sleep(_LOOK_EVERY)
                    self._check(worker)
                finally:
                    worker.stop()
                    self._keep()
        except OSError as error:
            raise InputError(f"the study cannot start: {(error.strerror or 'unknown error').lower()}.") from None
        return self

    def _check(self, worker: Worker) -> None:
        end = worker.end
        if end is not None and end.status:
            raise InputError(end.refusal or f"the study ended unexpectedly, with status {end.status}: start it again.")

    def _keep(self) -> None:
        table, self._path = self.table, None
        if not _tables.put(self._place, table):
            raise InputError(too_large(table, BUDGET, "lower the worlds, noises or grids"))
        BUDGET.drop_with_owner(self, _tables, self._place)


_tables: Cache[str] = Cache("studies of the inverse", sys.maxsize)
_known: WeakValueDictionary[Plan, Measuring] = WeakValueDictionary()


def measuring(plan: Plan) -> Measuring:
    """The study of a plan: the same one for all sessions while one of them holds it."""
    return _known.setdefault(plan, Measuring(plan))
