"""Runs of training in words."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from laplace_core.agents import LaplaceSettings
from laplace_core.training import words
from laplace_core.training.curves import Curves
from laplace_core.training.progress import Progress
from laplace_core.training.queue import FINISHED, STOPPING, TRAINING, WAITING, Run

SETTINGS = LaplaceSettings(environment="CartPole-v1", steps=1_000, seed=3)
RUN = Run("laplace_CartPole-v1_3", Path("runs"), SETTINGS, TRAINING)
NONE = np.zeros(0)
EMPTY = Curves(NONE, NONE, NONE, NONE, NONE, NONE, np.zeros((0, 0)), np.zeros((0, 0)), np.zeros((0, 0)), 0, None)


@pytest.mark.parametrize(
    ("state", "step", "share", "said"),
    [
        (WAITING, 0, 0.0, "0 of 1,000 steps · waiting; 2 runs train at once"),
        (TRAINING, 0, 0.0, "0 of 1,000 steps · starting"),
        (TRAINING, 250, 0.25, "250 of 1,000 steps · first episodes"),
        (STOPPING, 250, 0.25, "250 of 1,000 steps · its resume point is being written"),
        (FINISHED, 990, 1.0, "1,000 of 1,000 steps"),
    ],
)
def test_progress(state, step, share, said):
    noted = Progress(1, step, 1_000, None)
    assert words.progress(replace(RUN, state=state), noted, EMPTY, 2) == (share, said)


def test_a_last_round_beyond_the_end_counts_to_the_end():
    ended = replace(EMPTY, episode_steps=np.array([400.0, 1_007.0]))
    assert words.progress(RUN, None, ended, 2) == (1.0, "1,000 of 1,000 steps")


def test_a_label_tells_runs_of_one_environment_apart():
    assert words.label(RUN) == "Laplace DQN, seed 3"
    assert words.label(replace(RUN, name="laplace_CartPole-v1_3_2")) == "Laplace DQN, seed 3 (2)"
    assert words.label(replace(RUN, name="mine")) == "Laplace DQN, seed 3 (mine)"


def test_a_family_has_one_environment_the_oldest_first():
    other = replace(RUN, name="other", settings=replace(SETTINGS, environment="two_branch"))
    newer, unread = replace(RUN, name="newer"), replace(RUN, name="unread", settings=None)
    assert words.family([newer, unread, other, RUN], RUN) == [RUN, newer]
