"""An entry of the catalogue, and how its results are found. No torch here.

An entry is a figure, table or section of the paper. It has claims: what the paper says, and a function that says of our
results whether they agree. No finding is a fixed sentence: another result makes another sentence, and a claim whose
results are not there yet has none.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from laplace_core.errors import InputError
from laplace_core.experiments.paper import EXPERIMENTS
from laplace_core.experiments.paper.result_files import contents, result_file

AGREES, DIFFERS, IN_PART, NEW = "agrees", "differs", "in part", "new"
MISSING, DAMAGED = "not measured", "not readable"
STATES = {
    AGREES: "our numbers support the paper's claim",
    DIFFERS: "our numbers contradict it",
    IN_PART: "some of its claims agree and others do not, or some are not measured yet",
    NEW: "the paper has no numbers to compare with",
    MISSING: "there is no result yet",
    DAMAGED: "the file of results is damaged",
}
"""What each state of an entry means."""
RUN = "python -m laplace_core"
_WRONG_CONTENT = (LookupError, TypeError, ValueError, AttributeError, ArithmeticError)
"""What reading a result raises where the file holds something else than was written."""


@dataclass(frozen=True)
class Results:
    """The results of an experiment.

    Attributes:
        path: of the file.
        finished, planned: parts or trainings; ``planned`` is None where no file says how many.
        unit: which of both.
        cells: of what is trained.
        rows, summary: of what is measured.
    """

    path: Path
    finished: int = 0
    planned: int | None = None
    unit: str = "parts"
    cells: Sequence[Mapping[str, Any]] = ()
    rows: Sequence[Mapping[str, Any]] = ()
    summary: Mapping[str, Any] = field(default_factory=dict)

    @property
    def complete(self) -> bool:
        return self.planned is not None and self.finished >= self.planned

    @property
    def there(self) -> bool:
        """Whether there is anything to show."""
        return bool(self.finished or self.summary)

    @property
    def progress(self) -> str:
        """The progress, such as ``62 of 336 parts``."""
        return "none" if self.planned is None else f"{self.finished} of {self.planned} {self.unit}"


@dataclass(frozen=True)
class Finding:
    """Whether a claim agrees, and the sentence that says so with the numbers.

    Attributes:
        whole: whether all that it needs is there, also while other results of the entry are missing.
    """

    state: str
    sentence: str
    whole: bool = False


@dataclass(frozen=True)
class Claim:
    """One thing that the paper says or promises, in our words.

    Attributes:
        judge: the finding; None where what it needs is not measured yet.
    """

    says: str
    judge: Callable[[Results], Finding | None]


@dataclass(frozen=True)
class Line:
    """A line of the table: a number of the paper beside ours, each empty where there is none."""

    what: str
    paper: str = ""
    ours: str = ""


@dataclass(frozen=True)
class View:
    """A view of the workbench: the page, and the values of its link."""

    page: str
    values: Mapping[str, str]


@dataclass(frozen=True)
class Entry:
    """A figure, table or section of the paper.

    Attributes:
        name: of the experiment, and of the file of its results.
        place: where it is in the paper.
        title: what it is about.
        lines: the table, from results that may be empty.
        command: what makes its results, where ``reproduce`` does not.
        view: None where the workbench has none.
        read: reads the results from the folders of results and of the agents that ship, where there is more of them
            than the experiment's file.
        sources: the files that it reads then, from the same folders.
    """

    name: str
    place: str
    title: str
    claims: Sequence[Claim]
    lines: Callable[[Results], list[Line]]
    command: str = ""
    view: View | None = None
    read: Callable[[Path, Path], Results] | None = None
    sources: Callable[[Path, Path], list[Path]] | None = None

    def files(self, folder: Path, agents: Path) -> list[Path]:
        """The files that its results are read from."""
        return [result_file(folder, self.name)] if self.sources is None else self.sources(folder, agents)

    @property
    def makes(self) -> str:
        """The command that makes its results again."""
        return self.command or f"{RUN} reproduce {self.name}"


@dataclass(frozen=True)
class Found:
    """An entry with what the results say.

    Attributes:
        findings: one for each claim of the entry.
        trouble: why the results cannot be read, in a sentence.
    """

    entry: Entry
    results: Results
    lines: Sequence[Line]
    findings: Sequence[Finding | None]
    trouble: str | None = None

    @property
    def state(self) -> str:
        if self.trouble is not None:
            return DAMAGED
        states = {None if finding is None else finding.state for finding in self.findings}
        if states == {None}:
            return MISSING
        compared = states - {NEW} or {NEW}  # what has nothing to compare with neither agrees nor differs
        only = compared.pop()
        return IN_PART if compared or only is None else only

    def sentence(self, index: int) -> str:
        """The finding of a claim, or why there is none."""
        finding = self.findings[index]
        if finding is not None:
            so_far = "" if self.results.complete or finding.whole else f"So far ({self.results.progress}): "
            return f"{so_far}{finding.sentence}"
        if self.trouble is not None:
            return self.trouble
        return f"Not measured yet: {self.entry.makes} ({self.results.progress} done)."


def look(entry: Entry, folder: Path, agents: Path) -> Found:
    """The findings on an entry in the committed results; a damaged file is named in a sentence.

    Args:
        folder: of the results.
        agents: the folder of the agents that ship.
    """
    files = [path, *_] = entry.files(folder, agents)
    try:
        results = entry.read(folder, agents) if entry.read else results_of(entry.name, path)
        return Found(entry, results, entry.lines(results), [claim.judge(results) for claim in entry.claims])
    except InputError as error:
        trouble = str(error)
    except _WRONG_CONTENT:
        names = " or ".join(each.name for each in files[:2])
        trouble = f"{names} does not hold results, so nothing of it is shown."
    nothing = Results(path)
    return Found(entry, nothing, entry.lines(nothing), [None] * len(entry.claims), trouble)


def results_of(name: str, path: Path) -> Results:
    """The contents of the file of an experiment; nothing if there is none.

    Raises:
        InputError: a file that is no result.
    """
    about, trained = contents(path), EXPERIMENTS.get(name)
    unit = "parts" if trained is None else "trainings"
    if about is None:
        planned = None if trained is None else sum(len(cell.seeds) for cell in trained.cells)
        return Results(path, 0, planned, unit)
    return Results(
        path, int(about["finished"]), int(about["planned"]), unit,
        cells=about.get("cells", ()), rows=about.get("results", ()), summary=about.get("summary", {}),
    )  # fmt: skip
