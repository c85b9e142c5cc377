"""Are verdicts true? Every sentence of each against an independent judge, over random views.

``python -m laplace_core report verdicts`` prints the table and every disagreement.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import partial
from itertools import chain
from typing import Any

import numpy as np

from laplace_core.errors import InputError
from laplace_core.experiments.detector import wilson
from laplace_core.experiments.judge import Change, Judge, Judged
from laplace_core.experiments.views import View, draw_view
from laplace_core.study import verdict as verdicts
from laplace_core.study.artefacts import find_artefacts
from laplace_core.study.pipeline import study
from laplace_core.supervise.parallel import in_order
from laplace_core.worlds import dump_world, load_world

MOST_VIEWS = 100_000
MOST_JOBS = 64
HELD_OUT_SEED = 0
"""Nothing was tuned on its views."""
SEEDS_TO_LOOK_AT = 100

CRITERIA: Mapping[str, tuple[str, float | None]] = {
    "choice": ("the choice, and whether it is wrong, agreed", None),
    "values": ("of right choices, whether the values are off agreed", None),
    "timeline": ("grade of the timeline agreed", None),
    "cause": ("named causes that are causes", 0.99),
    "remedy": ("remedies of the verdict that repair", 0.99),
    "listed remedy": ("remedies of the artefact list that repair", 0.99),
    "needless remedy": ("remedies where nothing is to be repaired that spoil nothing", None),
    "exhausted": ("'no single setting' that is true", 0.99),
    "named": ("where one setting repairs, a cause is named", 0.90),
    "one alpha": ("views with a suggested alpha that have only one", 1.0),
    "alpha kept": ("suggested alphas that the next verdict keeps", 1.0),
}
"""Criteria that are counted: a description, and the share demanded."""


@dataclass(frozen=True)
class Answer:
    """The library's verdict on a view, in the form that the judge examines.

    Attributes:
        choice: ``right``, ``lucky`` or ``wrong``.
        timeline: ``sound``, ``smeared`` or ``ruined``, of the action looked at.
        cause: the change of settings that stands for the named cause; None where none is named.
        remedies, listed: changes that the verdict and the list of artefacts offer.
        exhausted: whether it says that no single setting explains or repairs the view.
        searched: whether single settings were tried at all.
    """

    choice: str
    chosen: int
    timeline: str | None
    cause: Mapping[str, Any] | None
    remedies: tuple[Mapping[str, Any], ...]
    listed: tuple[Mapping[str, Any], ...]
    exhausted: bool
    searched: bool
    sentence: str = ""

    @property
    def alphas(self) -> set[float]:
        """Every alpha that is suggested, by whichever part of it."""
        offered = [*self.remedies, *self.listed, *([self.cause] if self.cause else [])]
        return {float(changes["alpha"]) for changes in offered if "alpha" in changes}


@dataclass(frozen=True)
class Examined:
    """One view: the counts, as (criterion, held), and each disagreement as (criterion, detail)."""

    number: int
    judged: Judged
    grade: str
    searched: bool
    counts: tuple[tuple[str, bool], ...]
    disagreements: tuple[tuple[str, str], ...]


def ask_library(view: View) -> Answer:
    """The verdict of the library and the remedies of its artefact list."""
    result = study(view.world, view.settings)
    verdict = verdicts.judge(result, view.row, view.action)
    action = verdict.chosen if view.action is None else view.action
    listed = find_artefacts(result, action, float(result.horizons[view.row]))
    return Answer(
        verdict.choice, verdict.chosen, verdict.timeline,
        verdict.cause.changes if verdict.cause else None,
        tuple(remedy.changes for remedy in verdict.remedies),
        tuple(
            remedy.changes
            for artefact in listed
            for remedy in artefact.remedies
            if "solver" not in remedy.changes  # always offered, and the judge has no solver but one
        ),
        verdict.exhausted, verdict.searched, verdict.sentence,
    )  # fmt: skip


def examine(number: int, seed: int, ask: Callable[[View], Answer] = ask_library) -> Examined:
    """One view of a seed: the answer of ``ask``, sentence by sentence, against the judge."""
    view = draw_view(np.random.default_rng([seed, number]))
    judge, answer = Judge(view), ask(view)
    judged = judge.judged
    action = answer.chosen if view.action is None else view.action
    counted = list(chain(
        _grades(judge, answer, action), _changes(judge, answer), _completeness(judge, answer),
        _alphas(view, answer, ask),
    ))  # fmt: skip
    return Examined(
        number,
        judged,
        judged.grades[judge.action],
        answer.searched,
        tuple((name, detail is None) for name, detail in counted),
        tuple((name, detail) for name, detail in counted if detail is not None),
    )


Counted = Iterator[tuple[str, str | None]]
"""A criterion and a disagreement with it for each thing that is counted; None where both agree."""


def _grades(judge: Judge, answer: Answer, action: int) -> Counted:
    judged = judge.judged
    agreed = (answer.choice == "wrong") == (judged.choice == "wrong") and answer.chosen == judged.chosen
    yield "choice", None if agreed else f"says {answer.choice}, {answer.chosen}; {judged.choice}, {judged.chosen}"
    if "wrong" not in (answer.choice, judged.choice):
        agreed = (answer.choice == "lucky") == (judged.choice == "off")
        yield "values", None if agreed else f"says {answer.choice}; value error {judged.value_error:.6g}"
    agreed, error = answer.timeline == judged.grades[action], judged.timeline_errors[action]
    yield "timeline", None if agreed else f"says {answer.timeline}; error {error:.6g}"


def _changes(judge: Judge, answer: Answer) -> Counted:
    needed = judge.judged.needs_repair(judge.action)
    if answer.cause is not None:
        yield "cause", _against(judge, answer.cause)
    for name, offered in (("remedy", answer.remedies), ("listed remedy", answer.listed)):
        for changes in offered:
            if needed:
                yield name, _against(judge, changes)
            else:
                fault = judge.harm(changes)
                yield "needless remedy", None if fault is None else f"{_words(changes)}: {fault}"


def _against(judge: Judge, changes: Mapping[str, Any]) -> str | None:
    fault = judge.objection(changes)
    if fault is None:
        return None
    held = f" ({judge.share_held(changes, SEEDS_TO_LOOK_AT):.0%} hold)" if "seeds" in fault else ""
    return f"{_state(judge)}; {_words(changes)}: {fault}{held}"


def _completeness(judge: Judge, answer: Answer) -> Counted:
    if not answer.searched or not judge.judged.needs_repair(judge.action):
        return
    repairing = next(
        (change for change, repairs in judge.every_single_setting(until_one=True).items() if repairs), None
    )
    repair = "" if repairing is None else f"{_state(judge)}; repaired by {_change_words(judge, repairing)}"
    if answer.exhausted:
        yield "exhausted", repair or None
    if repairing is not None:
        yield "named", None if answer.cause is not None else repair


def _change_words(judge: Judge, change: Change) -> str:
    changes = dict(change)
    noisy = bool(changes.get("noise", judge.view.settings.noise))
    held = f" ({judge.share_held(changes, SEEDS_TO_LOOK_AT):.0%} hold)" if noisy else ""
    return f"{_words(changes)}{held}"


def _alphas(view: View, answer: Answer, ask: Callable[[View], Answer]) -> Counted:
    if answer.alphas:
        several = len(answer.alphas) > 1
        yield "one alpha", f"suggests {', '.join(f'{a:g}' for a in sorted(answer.alphas))}" if several else None
    for alpha in sorted(answer.alphas):
        following = ask(replace(view, settings=replace(view.settings, alpha=alpha))).alphas - {alpha}
        others = ", ".join(f"{a:g}" for a in sorted(following))
        yield "alpha kept", f"{alpha:g}, then {others}" if following else None


def _state(judge: Judge) -> str:
    return f"{judge.judged.choice}, {judge.judged.grades[judge.action]}"


def _words(changes: Mapping[str, Any]) -> str:
    values = (f"{value:.6g}" if isinstance(value, float) else str(value) for value in changes.values())
    return " ".join(f"{name}={value}" for name, value in zip(changes, values, strict=True))


# --- the table ---


def rows_of(examined: list[Examined]) -> list[dict[str, Any]]:
    """One row a criterion: how often it held, of how many, the share with its interval, and the goal."""
    counts = Counter(pair for one in examined for pair in one.counts)
    rows = []
    for name, (words, demanded) in CRITERIA.items():
        held, of = counts[name, True], counts[name, True] + counts[name, False]
        share = held / of if of else None
        rows.append({
            "name": name, "words": words, "held": held, "of": of, "share": share,
            "interval": wilson(held, of), "demanded": demanded,
            "met": demanded is None or share is None or share >= demanded,
        })  # fmt: skip
    return rows


def table(examined: list[Examined], seed: int) -> str:
    """The counts for reading, and every disagreement with the number of its view."""
    choices = Counter(one.judged.choice for one in examined)
    faulty = sum(one.judged.choice != "right" or one.grade != "sound" for one in examined)
    unsearched = sum(not one.searched for one in examined)
    lines = [
        f"Verdicts against an independent judge: {len(examined)} random views, seed {seed}, none left out.",
        f"Of the views {choices['wrong']} choose wrongly, {choices['off']} choose rightly on values that are off, and "
        f"{faulty - choices['wrong'] - choices['off']} hold but for the timeline; "
        f"in {unsearched} no setting was tried, as too large.",
        f"{'':62} {'held':>5} {'of':>5}  {'share (95%)':22} {'demanded':>8}",
    ]
    for row in rows_of(examined):
        low, high = row["interval"]
        share = "-" if row["share"] is None else f"{row['share']:.4f} ({low:.3f}-{high:.3f})"
        demanded = "" if row["demanded"] is None else f"{row['demanded']:.2f}" + ("" if row["met"] else " MISSED")
        lines.append(f"{row['words']:62} {row['held']:5} {row['of']:5}  {share:22} {demanded:>8}".rstrip())
    disagreements = [f"{one.number:6} {name}: {detail}" for one in examined for name, detail in one.disagreements]
    lines += (
        ["", "Disagreements, by the number of the view (--only NUMBER shows it):", *disagreements]
        if disagreements
        else []
    )
    return "\n".join(lines)


def described(number: int, seed: int) -> str:
    """One view in full: how to get it, the library's answer, and which single settings repair it."""
    view = draw_view(np.random.default_rng([seed, number]))
    judge, s = Judge(view), view.settings
    held = judge.every_single_setting()
    repairing = [_change_words(judge, change) for change, repairs in held.items() if repairs]
    preset = view.world.source and load_world(view.world.source, dict(view.world.params)) is view.world
    answer = ask_library(view)
    lines = [
        f"View {number} of seed {seed}: T {judge.horizon:g} (row {view.row}), action looked at {judge.action}.",
        s.to_command(),
        *([] if preset else [dump_world(view.world)]),
        f"judge: {judge.judged}",
        f"library: {answer}",
        f"single settings that repair, of {len(held)}: {'; '.join(repairing) or 'none'}",
    ]
    return "\n".join([*lines, *(f"{name}: {detail}" for name, detail in examine(number, seed).disagreements)])


def report(cases: int = 2_000, seed: int = HELD_OUT_SEED, jobs: int = 1) -> tuple[dict[str, Any], str]:
    """Examine that many views: numbers for a file, and the table for reading.

    Raises:
        InputError: a number of views, a seed or a number of jobs out of range.
    """
    for name, value, low, high in (
        ("cases", cases, 1, MOST_VIEWS), ("seed", seed, 0, 2**31 - 1), ("jobs", jobs, 1, MOST_JOBS),
    ):  # fmt: skip
        if not low <= value <= high:
            raise InputError(f"{name} is {value}; it must be from {low:,} to {high:,}.")
    one = partial(examine, seed=seed)
    examined = list(in_order(one, range(cases), jobs))
    numbers = {
        "cases": cases,
        "seed": seed,
        "rows": rows_of(examined),
        "disagreements": [
            {"case": one.number, "about": name, "detail": detail}
            for one in examined
            for name, detail in one.disagreements
        ],
    }
    return numbers, table(examined, seed)
