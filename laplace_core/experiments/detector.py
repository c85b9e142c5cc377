"""Does the list of artefacts name what is there, and nothing else? Precision and recall over random cases.

``python -m laplace_core report detectors`` prints the table. Seed 1 was used while the detector was made; the
default seed was not.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np

from laplace_core.artifacts import MEASURES, VISIBLE, find_artefacts
from laplace_core.errors import InputError
from laplace_core.experiments.cases import Case, draw_case
from laplace_core.experiments.labels import Effects
from laplace_core.pipeline import study

MOST_CASES = 100_000


@dataclass(frozen=True)
class Compared:
    """One case: the true effect of every artefact and the size that the detector lists, 0 if it does not."""

    case: Case
    effects: Mapping[str, float]
    sizes: Mapping[str, float]


@dataclass(frozen=True)
class Score:
    """How one artefact fared, over ``true_positive + ... + true_negative`` cases; ``switched`` counts its switch."""

    name: str
    true_positive: int
    false_positive: int
    false_negative: int
    true_negative: int

    @property
    def present(self) -> int:
        return self.true_positive + self.false_negative

    @property
    def absent(self) -> int:
        return self.false_positive + self.true_negative

    @property
    def precision(self) -> float:
        return _ratio(self.true_positive, self.true_positive + self.false_positive)

    @property
    def recall(self) -> float:
        return _ratio(self.true_positive, self.present)

    def as_dict(self) -> dict[str, object]:
        return {
            "name": self.name,
            "present": self.present,
            "absent": self.absent,
            "true_positive": self.true_positive,
            "false_positive": self.false_positive,
            "false_negative": self.false_negative,
            "true_negative": self.true_negative,
            "precision": self.precision,
            "precision_interval": wilson(self.true_positive, self.true_positive + self.false_positive),
            "recall": self.recall,
            "recall_interval": wilson(self.true_positive, self.present),
        }


def _ratio(part: int, whole: int) -> float:
    return part / whole if whole else float("nan")


def wilson(part: int, whole: int, z: float = 1.96) -> tuple[float, float]:
    """95% interval of a proportion (Wilson); 0 to 1 where nothing was counted."""
    if whole == 0:
        return 0.0, 1.0
    p, scale = part / whole, 1.0 + z**2 / whole
    middle = p + z**2 / (2 * whole)
    half = z * np.sqrt(p * (1.0 - p) / whole + z**2 / (4 * whole**2))
    return float(max(0.0, (middle - half) / scale)), float(min(1.0, (middle + half) / scale))


def compare(cases: int, seed: int) -> Iterator[Compared]:
    """Cases one by one: the detector's list beside the truth. The same seed gives the same cases.

    Raises:
        InputError: a number of cases or a seed out of range.
    """
    if not 1 <= cases <= MOST_CASES:
        raise InputError(f"cases is {cases}; it must be from 1 to {MOST_CASES:,}.")
    if not 0 <= seed < 2**31:
        raise InputError(f"seed is {seed}; it must be from 0 to 2147483647.")
    for number in range(cases):
        case = draw_case(np.random.default_rng([seed, number]))
        found = find_artefacts(study(case.world, case.settings), case.action)
        sizes = dict.fromkeys(MEASURES, 0.0) | {artefact.name: artefact.size for artefact in found}
        yield Compared(case, Effects(case).all(), sizes)


def score(compared: list[Compared]) -> list[Score]:
    """One score an artefact: present if its effect exceeds :data:`VISIBLE`, found if it is listed."""
    scores = []
    for name in MEASURES:
        present = np.array([one.effects[name] > VISIBLE for one in compared])
        listed = np.array([one.sizes[name] > 0.0 for one in compared])
        counts = (present & listed, ~present & listed, present & ~listed, ~present & ~listed)
        scores.append(Score(name, *(int(count.sum()) for count in counts)))
    return scores
