"""Precision and recall of the list of artefacts over random cases.

``python -m laplace_core report detectors`` prints the table.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from laplace_core.errors import InputError
from laplace_core.experiments.cases import KINDS, Case, draw_case
from laplace_core.experiments.labels import LABELS, OWN_SWITCHES, Effects
from laplace_core.study.artefacts import MEASURES, VISIBLE, find_artefacts
from laplace_core.study.pipeline import study

MOST_CASES = 100_000
HELD_OUT_SEED = 0
"""Not looked at while the detector's measures and levels were chosen; that was done on seeds 1 and 2."""


@dataclass(frozen=True)
class Compared:
    """One case: the true effect of every artefact and the size that the detector lists, 0 if it does not."""

    case: Case
    effects: Mapping[str, float]
    sizes: Mapping[str, float]


@dataclass(frozen=True)
class Score:
    """Detections of one artefact, against the truth.

    Attributes:
        thrown, unseen: cases in which a switch of its own was thrown, and those of them without a visible effect.
        unthrown: cases in which it is present although no switch of its own was thrown.
    """

    name: str
    true_positive: int
    false_positive: int
    false_negative: int
    true_negative: int
    thrown: int
    unseen: int
    unthrown: int

    @property
    def on(self) -> int:
        return self.true_positive + self.false_negative

    @property
    def off(self) -> int:
        return self.false_positive + self.true_negative

    @property
    def precision(self) -> float | None:
        """True among listed; None where nothing was listed."""
        return _ratio(self.true_positive, self.true_positive + self.false_positive)

    @property
    def recall(self) -> float | None:
        """Listed among true; None where nothing was there."""
        return _ratio(self.true_positive, self.on)

    def as_dict(self) -> dict[str, Any]:
        return {
            **vars(self),
            "on": self.on,
            "off": self.off,
            "precision": self.precision,
            "precision_interval": wilson(self.true_positive, self.true_positive + self.false_positive),
            "recall": self.recall,
            "recall_interval": wilson(self.true_positive, self.on),
        }


def _ratio(part: int, whole: int) -> float | None:
    return part / whole if whole else None


def wilson(part: int, whole: int, z: float = 1.96) -> tuple[float, float]:
    """95% interval of a proportion (Wilson); 0 to 1 where nothing was counted."""
    if whole == 0:
        return 0.0, 1.0
    p, scale = part / whole, 1.0 + z**2 / whole
    middle = p + z**2 / (2 * whole)
    half = z * np.sqrt(p * (1.0 - p) / whole + z**2 / (4 * whole**2))
    return float(max(0.0, (middle - half) / scale)), float(min(1.0, (middle + half) / scale))


def compare(cases: int, seed: int, kind: str = "short") -> Iterator[Compared]:
    """Cases of one kind, one by one: the detector's list beside the truth. The same seed gives the same cases.

    Raises:
        InputError: a number of cases or a seed out of range.
    """
    if not 1 <= cases <= MOST_CASES:
        raise InputError(f"cases is {cases}; it must be from 1 to {MOST_CASES:,}.")
    if not 0 <= seed < 2**31:
        raise InputError(f"seed is {seed}; it must be from 0 to 2147483647.")
    for number in range(cases):
        rng = np.random.default_rng([seed, number, KINDS.index(kind)])
        case = draw_case(rng, kind=kind, more=OWN_SWITCHES)
        listed = find_artefacts(study(case.world, case.settings), case.action, searching=False)
        sizes = dict.fromkeys(MEASURES, 0.0) | {artefact.name: artefact.size for artefact in listed}
        yield Compared(case, Effects(case).all(), sizes)


def score(compared: list[Compared]) -> list[Score]:
    """One score an artefact: present if its effect exceeds :data:`VISIBLE`, detected if it is listed."""
    scores = []
    for name in MEASURES:
        present = np.array([one.effects[name] > VISIBLE for one in compared])
        listed = np.array([one.sizes[name] > 0.0 for one in compared])
        thrown = np.array([LABELS[name].switch in one.case.switched for one in compared])
        counts: tuple[np.ndarray, ...] = (present & listed, ~present & listed, present & ~listed, ~present & ~listed)
        counts += (thrown, thrown & ~present, present & ~thrown)
        scores.append(Score(name, *(int(count.sum()) for count in counts)))
    return scores


TITLES: Mapping[str, str] = {
    "short": "Worlds that end within nine steps, with more rows than steps",
    "lasting": "Worlds with cycles, hundreds of steps or no end, with fewer or more rows, some closer than steps",
    "all": "All together",
}


DEMANDED = 0.97
"""Precision and recall that every artefact must reach."""


def falls_short(counted: Mapping[str, Any]) -> bool:
    """Whether precision or recall of one artefact, from :meth:`Score.as_dict`, is below its goal."""
    return any(counted[name] is not None and counted[name] < DEMANDED for name in ("precision", "recall"))


def table(scores: list[Score], cases: int, seed: int, kind: str = "all") -> str:
    """The scores of one kind of cases, or of all, for reading."""
    lines = [
        f"{TITLES[kind]}: {cases} random cases, seed {seed}, none left out.",
        f"{'':19} {'there':>5} {'not':>4}  {'TP':>3} {'FP':>3} {'FN':>3}  {'precision (95%)':19} {'recall (95%)':19} "
        f"{'thrown':>6} {'unseen':>6} {'without':>7}",
    ]
    for one in scores:
        precision = _with_interval(one.precision, one.true_positive, one.true_positive + one.false_positive)
        recall = _with_interval(one.recall, one.true_positive, one.on)
        lines.append(
            f"{one.name:19} {one.on:5} {one.off:4}  {one.true_positive:3} {one.false_positive:3} "
            f"{one.false_negative:3}  {precision:19} {recall:19} {one.thrown:6} {one.unseen:6} {one.unthrown:7}"
        )
    return "\n".join(lines)


def _with_interval(value: float | None, part: int, whole: int) -> str:
    low, high = wilson(part, whole)
    return "-" if value is None else f"{value:.3f} ({low:.2f}-{high:.2f})"


def report(cases: int = 500, seed: int = HELD_OUT_SEED) -> tuple[dict[str, Any], str]:
    """Run the comparison on as many cases of each kind: numbers for a file, and the tables for reading."""
    compared = {kind: list(compare(cases, seed, kind)) for kind in KINDS}
    compared["all"] = [one for each in compared.values() for one in each]
    scores = {kind: score(each) for kind, each in compared.items()}
    numbers = {
        "cases": cases,
        "seed": seed,
        "visible": VISIBLE,
        "artefacts": [one.as_dict() for one in scores["all"]],
        "kinds": {kind: [one.as_dict() for one in scores[kind]] for kind in KINDS},
    }
    heading = (
        "Artefacts listed against artefacts there.\n"
        f"There: turning this one thing off changes the picture or the value by more than {VISIBLE:g} (shares).\n"
        "Its switch: how often it was thrown; of these, without a visible effect; and there without it."
    )
    tables = [table(each, len(compared[kind]), seed, kind) for kind, each in scores.items()]
    return numbers, "\n\n".join([heading, *tables])
