"""How far learning is, in words."""

from __future__ import annotations

import pytest

from laplace_core.tabular import Learning, LearnSettings, words
from laplace_core.worlds import load_world

LINE = {"episodes": 50, "of": 200, "steps_per_second": 1_200, "error": 0.25, "eta": 3.4, "finished": False}


@pytest.mark.parametrize(
    ("changes", "seeds", "running", "said"),
    [
        ({}, 1, True, "50 of 200 episodes · 1,200 steps/s · error 25% of the range · 3 s left"),
        ({}, 2, True, "25 of 100 episodes by each of 2 learners · 1,200 steps/s · error 25% of the range · 3 s left"),
        ({"error": 0.00123}, 1, False, "cancelled at · 50 of 200 episodes · 1,200 steps/s · error 0.12% of the range"),
        ({"error": 1e-9, "finished": True}, 1, False,
         "50 of 200 episodes · 1,200 steps/s · error below 0.0001% of the range"),
        ({"error": None, "eta": None, "finished": True}, 1, True, "50 of 200 episodes · 1,200 steps/s"),
    ],
)  # fmt: skip
def test_progress(changes, seeds, running, said):
    assert words.progress(LINE | changes, seeds, running=running) == (0.25, said)


def test_what_was_learned():
    learning = Learning(load_world("two_branch"), LearnSettings(episodes=3, seeds=2))
    for _ in learning:
        pass
    assert words.learned(learning.snapshot()) == "Learned in 3 episodes by each of 2 learners, policy shared."
