"""A study as CSV texts, one line a number, that a spreadsheet, pandas and R read alike.

UTF-8, comma and decimal point; numbers are written so that they come back exactly.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from laplace_core.errors import InputError
from laplace_core.files.cells import csv_cell
from laplace_core.planning import check_policy, reward_timeline
from laplace_core.study.pipeline import Study, WorldStudy, policies_of
from laplace_core.worlds import MAX_TAU, timeline_rows


def tau_space_csv(study: Study) -> str:
    """action, tau, theta_low, theta_high, probability[, true_probability]: a line for each bin of each row.

    A probability is per step of the world: with a ``time_step`` below 1, a row divided by it. A true one is that of
    the step that lies on the row; between two steps there is none. Open ends reach to -inf and inf.
    """
    step, thetas = study.settings.time_step, study.gamma_space.thetas
    if study.gamma_space.open_ends:
        thetas = np.concatenate([[-np.inf], thetas, [np.inf]])
    bins = [f"{low},{high}" for low, high in zip(_texts(thetas[:-1]), _texts(thetas[1:]), strict=True)]
    columns = {"probability": study.decoded.tau_space / step}
    if study.truth is not None:
        columns["true_probability"] = study.truth.tau_space
    return _long("action,tau,theta_low,theta_high", study, _texts(study.taus), bins, columns=columns)


def gamma_space_csv(study: Study) -> str:
    """action, gamma, theta, value: a line for each sensitivity at each discount.

    With open ends there is one more, of the constant channel, as the sensitivity -inf that every reward lies above.
    """
    space = study.gamma_space
    values, thetas = space.values, space.thetas
    if space.open_ends:
        values = np.concatenate([space.constant[..., None], values], axis=-1)
        thetas = np.concatenate([[-np.inf], thetas])
    return _long("action,gamma,theta", study, _texts(space.gammas), _texts(thetas), columns={"value": values})


def values_csv(study: Study) -> str:
    """action, horizon, value[, true_value, optimal_value], chosen[, best]: a line for each horizon of each action.

    ``chosen`` and ``best`` are 1 where the action is the one that is taken, and the one that should be.
    """
    decoded, truth = study.decoded, study.truth
    everyone = np.arange(len(study.action_names))[:, None]
    columns = {"value": decoded.horizon_values}
    if truth is not None:
        columns |= {"true_value": truth.horizon_values, "optimal_value": truth.optimum}
    columns["chosen"] = (everyone == decoded.actions).astype(int)
    if truth is not None:
        columns["best"] = (everyone == truth.optimal_action).astype(int)
    return _long("action,horizon", study, _texts(study.horizons), None, columns=columns)


def rewards_csv(study: Study) -> str:
    """action, tau, expected_reward, survival[, true_expected_reward, true_survival]: a line for each row.

    All are per step of the world, as in :func:`tau_space_csv`.
    """
    step, decoded, truth = study.settings.time_step, study.decoded, study.truth
    columns = {"expected_reward": decoded.expected_reward / step, "survival": decoded.survival / step}
    if truth is not None:
        columns |= {"true_expected_reward": truth.expected_reward, "true_survival": truth.survival}
    return _long("action,tau", study, _texts(study.taus), None, columns=columns)


def true_timeline_rows(study: Study, policy: np.ndarray | None = None) -> list[dict[str, object]]:
    """The true timeline of a study's state as rows to draw on (``timeline_world(rows, "ended")``), to 4 digits.

    Args:
        policy: what happens after the first action; by default the policy that is greedy at the acting gamma.

    Raises:
        InputError: a study without a world has no true timeline.
    """
    if not isinstance(study, WorldStudy):
        raise InputError("a saved gamma-space has no true timeline to start from: choose a world.")
    world, s = study.world, study.settings
    if policy is None:
        policy = policies_of(world, study.gamma_space.gammas, "shared", s.acting_gamma)[0]
    length = min(int(np.ceil(s.steps * s.time_step - 1e-9)), MAX_TAU + 1)
    timeline = reward_timeline(world, study.state, check_policy(world, policy), length)
    return timeline_rows(timeline, world.reward_values, world.actions)


def _long(
    header: str, study: Study, rows: Sequence[str], bins: Sequence[str] | None, *, columns: dict[str, np.ndarray]
) -> str:
    """Lines ``action,row[,bin],numbers...`` for arrays ``(A, K[, M])``.

    The words before the numbers are joined once a row, which makes a long file several times faster than the csv
    module; only names may need its quotes.
    """
    parts = [f"{header},{','.join(columns)}\n"]
    flat = [array.reshape(len(study.action_names), len(rows), -1) for array in columns.values()]
    endings = [f",{words}" for words in bins] if bins is not None else [""]
    for a, name in enumerate(study.action_names):
        action = csv_cell(name)
        for k, row in enumerate(rows):
            before = f"{action},{row}"
            numbers = map(",".join, zip(*(_texts(array[a, k]) for array in flat), strict=True))
            parts += [f"{before}{ending},{values}\n" for ending, values in zip(endings, numbers, strict=True)]
    return "".join(parts)


def _texts(numbers: np.ndarray) -> list[str]:
    """Every number as the shortest text that reads back as itself."""
    return list(map(repr, numbers.tolist()))
