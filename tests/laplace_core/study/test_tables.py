"""CSV texts of a study: every number comes back exactly, names are safe, and long tables are fast."""

import csv
import io
import time
from dataclasses import replace

import numpy as np
import pandas as pd
import pytest

from laplace_core import InputError, Settings, Study, load_world, study, study_of_gamma_space
from laplace_core.study.tables import gamma_space_csv, rewards_csv, tau_space_csv, true_timeline_rows, values_csv
from laplace_core.worlds import World

TABLES = (tau_space_csv, gamma_space_csv, values_csv, rewards_csv)


def without_truth() -> Study:
    space = study(load_world("two_branch"), Settings(thetas=12)).gamma_space
    return study_of_gamma_space(space, Settings(world="own.npz", steps=7))


STUDIES = {
    "two_branch": lambda: study(load_world("two_branch"), Settings(thetas=12, alpha=0.2)),
    "fine time": lambda: study(load_world("two_branch"), Settings(thetas=12, time_step=0.25, normalise="paper")),
    "one action": lambda: study(load_world("fig6_chain"), Settings(thetas=7, theta_spacing="asinh", noise=0.01)),
    "slippery": lambda: study(load_world("gym:FrozenLake-v1"), Settings(thetas=9, steps=11, softness=0.3)),
    "no truth": without_truth,
}


def naive(header: list[str], study: Study, rows, bins, *, columns) -> str:
    """The csv module, one number at a time."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow([*header, *columns])
    for a, name in enumerate(study.action_names):
        for k, row in enumerate(rows):
            for h, words in enumerate(bins if bins is not None else [()]):
                place = (a, k, h) if bins is not None else (a, k)
                writer.writerow([name, float(row), *words, *(array[place].item() for array in columns.values())])
    return text.getvalue()


@pytest.fixture(params=STUDIES.values(), ids=STUDIES)
def found(request) -> Study:
    return request.param()


def test_tables_equal_those_of_the_csv_module(found):
    s, decoded, truth, space = found.settings, found.decoded, found.truth, found.gamma_space
    edges = [(float(low), float(high)) for low, high in zip(space.thetas[:-1], space.thetas[1:], strict=True)]
    columns = {"probability": decoded.tau_space / s.time_step}
    rewards = {"expected_reward": decoded.expected_reward / s.time_step, "survival": decoded.survival / s.time_step}
    values = {"value": decoded.horizon_values}
    chosen = np.array([decoded.actions == a for a in range(len(found.action_names))]).astype(int)
    if truth is None:
        values |= {"chosen": chosen}
    else:
        columns["true_probability"] = truth.tau_space
        rewards["true_expected_reward"] = truth.expected_reward
        rewards["true_survival"] = truth.survival
        best = np.array([truth.optimal_action == a for a in range(len(found.action_names))]).astype(int)
        values |= {"true_value": truth.horizon_values, "optimal_value": truth.optimum, "chosen": chosen, "best": best}
    header = ["action", "tau", "theta_low", "theta_high"]
    assert tau_space_csv(found) == naive(header, found, found.taus, edges, columns=columns)
    sensitivities = [(float(theta),) for theta in space.thetas]
    header = ["action", "gamma", "theta"]
    assert gamma_space_csv(found) == naive(header, found, space.gammas, sensitivities, columns={"value": space.values})
    assert rewards_csv(found) == naive(["action", "tau"], found, found.taus, None, columns=rewards)
    assert values_csv(found) == naive(["action", "horizon"], found, found.horizons, None, columns=values)


def test_pandas_reads_the_arrays_back_exactly(found):
    def read(text: str) -> pd.DataFrame:
        frame = pd.read_csv(io.StringIO(text))
        assert not frame.isna().any().any()
        return frame

    shape, step = found.decoded.tau_space.shape, found.settings.time_step
    frame = read(tau_space_csv(found))
    np.testing.assert_array_equal(frame["probability"].to_numpy().reshape(shape), found.decoded.tau_space / step)
    middles = (frame["theta_low"] + frame["theta_high"]).to_numpy().reshape(shape)[0, 0] / 2
    np.testing.assert_allclose(middles, found.midpoints, rtol=1e-15)
    frame = read(gamma_space_csv(found))
    space = found.gamma_space
    np.testing.assert_array_equal(frame["value"].to_numpy().reshape(space.values.shape), space.values)
    np.testing.assert_array_equal(np.unique(frame["gamma"]), space.gammas)
    frame = read(values_csv(found))
    assert (frame.groupby("horizon")["chosen"].sum() == 1).all()
    for horizon, chosen in zip(found.horizons, found.decoded.actions, strict=True):
        row = frame[(frame["horizon"] == horizon) & (frame["chosen"] == 1)].iloc[0]
        assert row["action"] == found.action_names[chosen]
        assert row["value"] == found.decoded.horizon_values[chosen, found.row_at(horizon)]
    assert ("best" in frame) == ("true_value" in frame) == (found.truth is not None)
    assert len(read(rewards_csv(found))) == shape[0] * shape[1]


def test_two_branch_by_hand():
    found = STUDIES["two_branch"]()
    frame = pd.read_csv(io.StringIO(values_csv(found))).set_index(["action", "horizon"])
    assert frame.columns.tolist() == ["value", "true_value", "optimal_value", "chosen", "best"]
    assert frame["true_value"]["short"].tolist() == [5.0, 5.0, 5.0]
    assert frame["true_value"]["long"].tolist() == pytest.approx([0.0, 0.0, 10 * 0.99**2])
    assert frame["best"]["long"].tolist() == [0, 0, 1]
    frame = pd.read_csv(io.StringIO(rewards_csv(found))).set_index(["action", "tau"])
    assert frame["true_survival"]["short"].tolist() == [1.0, 0.0, 0.0]
    assert frame["true_expected_reward"]["long"].tolist() == [0.0, 0.0, 10.0]


FORMULAS = ["=1+1", "+left", "-left", "@SUM(A1)", "=cmd|' /C calc'!A0"]


def test_names_are_quoted_and_never_formulas(subtests):
    for name in [*FORMULAS, "plain", 'a "quoted", name', "comma, comma", "← left", "'=1", "a=b", "кратко"]:
        with subtests.test(name=name):
            source = load_world("two_branch")
            world = replace(source, actions=(name, "other"), source="")
            assert isinstance(world, World)
            found = study(world, Settings(thetas=4))
            for table in TABLES:
                rows = list(csv.reader(io.StringIO(table(found))))
                first = rows[1][0]
                assert first == (f"'{name}" if name in FORMULAS else name)
                assert {row[0] for row in rows[1:]} == {first, "other"}
                assert {len(row) for row in rows} == {len(rows[0])}
                assert table(found).encode("utf-8").decode("utf-8") == table(found)
                assert not table(found).startswith("\ufeff")


def test_a_large_tau_space_is_written_fast():
    found = study(load_world("cliff_grid"), Settings(steps=200, thetas=251))
    assert found.decoded.tau_space.shape == (4, 200, 250)
    times = []
    for _ in range(3):
        started = time.process_time()
        text = tau_space_csv(found)
        times.append(time.process_time() - started)
    assert text.count("\n") == 200_001
    assert min(times) < 0.5


def test_a_gamma_space_from_a_file_has_no_true_timeline():
    with pytest.raises(InputError, match="no true timeline"):
        true_timeline_rows(without_truth())
