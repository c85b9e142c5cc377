"""An explanation is what the verdict and the list of artefacts say, each with its search."""

from __future__ import annotations

import pickle
from dataclasses import replace

import pytest

from laplace_core import InputError, Settings, load_world
from laplace_core.study.artefacts import find_artefacts
from laplace_core.study.evidence import believe
from laplace_core.study.explanation import explain, trials_of
from laplace_core.study.pipeline import study
from laplace_core.study.verdict import judge

VIEWS = [
    {"normalise": "paper"},
    {"alpha": 1.0, "noise": 0.01},
    {"shift": True, "alpha": 0.01},
    {},
]


@pytest.mark.parametrize("changes", VIEWS)
def test_it_says_what_verdict_and_artefacts_say(changes):
    seen = study(load_world("two_branch"), Settings(**changes))
    row = seen.row_at(3.0)
    made = explain(seen, row, 0)
    belief = believe(seen, row, 0)
    assert made.belief == belief
    sentence, own = judge(seen, row, 0).sentence, [] if belief is None else belief.artefacts
    assert made.verdict.sentence == (sentence if belief is None else f"{sentence} {belief.sentence}")
    assert replace(made.verdict, sentence=sentence) == judge(seen, row, 0)
    assert list(made.artefacts) == [*own, *find_artefacts(seen, 0, 3.0)]
    assert (belief is None) == ("noise" not in changes)
    assert explain(seen, row, 0, trials_of(seen, row, 0)) == made


def test_another_process_can_make_it():
    seen = study(load_world("two_branch"), Settings(normalise="paper"))
    sent = pickle.loads(pickle.dumps((seen, 0, 1)))  # noqa: S301 - from the line above
    assert pickle.loads(pickle.dumps(explain(*sent))) == explain(seen, 0, 1)  # noqa: S301 - from this very line


def test_rows_and_actions_that_are_not_there_are_refused():
    seen = study(load_world("two_branch"), Settings())
    for row, action in ((10**6, 0), (0, 9)):
        with pytest.raises(InputError, match="does not exist: this study has"):
            explain(seen, row, action)
