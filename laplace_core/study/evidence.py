"""What follows from the size of the noise alone, whatever alpha is: whether a timeline has the values, and what is
certainly best."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from laplace_core.inverse.certificate import certify
from laplace_core.inverse.consistency import check_noise
from laplace_core.study.pipeline import Study, WorldStudy

MOST_HORIZONS = 14
USUAL_NOISE = 1e-3


@dataclass(frozen=True)
class Evidence:
    """What the noise allows to say.

    Attributes:
        p_value: of the test whether any feasible timeline has these values.
        certified: horizons, and the action that is certainly best there, -1 where none is.
    """

    p_value: float
    certified: tuple[tuple[float, int], ...]


def seconds_to_gather(study: Study) -> float:
    """An estimate of how long :func:`gathered` takes."""
    actions, discounts, _ = study.gamma_space.values.shape
    # The time axis has more windows, the smaller the noise is.
    finer = np.sqrt(np.clip(USUAL_NOISE / (study.settings.noise_level or USUAL_NOISE), 1.0, 100.0))
    return float(finer) * (actions * discounts / 60.0 + 0.05 * MOST_HORIZONS * actions)


def gathered(
    study: Study, deviations: np.ndarray, *, independent: bool, progress: Callable[[int, int], None]
) -> Evidence:
    """The test and the certificates of a study, one after the other."""
    horizons = horizons_of(study)
    progress(0, 1 + len(horizons))
    space, s = study.gamma_space, study.settings
    test = check_noise(space, deviations, independent=independent)
    rewards = None
    if isinstance(study, WorldStudy):
        rewards = float(study.world.reward_values[0]), float(study.world.reward_values[-1])
    certified = []
    for done, horizon in enumerate(horizons, start=1):
        progress(done, 1 + len(horizons))
        found = certify(
            space, horizon, deviations, value_gamma=s.value_gamma, slope=s.slope, rewards=rewards,
            independent=independent,
        )  # fmt: skip
        certified.append((float(horizon), -1 if found.best is None or not found.consistent else found.best))
    return Evidence(test.p_value, tuple(certified))


def horizons_of(study: Study) -> list[int]:
    """Whole horizons of a study, close together where they are short."""
    last = int(study.horizons[-1])
    return np.unique(np.rint(np.geomspace(1, max(1, last), MOST_HORIZONS)).astype(int)).tolist()
