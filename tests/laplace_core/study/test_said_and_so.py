"""Small inputs of which something false was once said, or that were taken for something else.

Each stands for a kind. They go through what anyone calls: the command line, ``study``, ``judge``, ``find_artefacts``.
"""

from __future__ import annotations

import copy
import json
import pickle
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from laplace_core import GammaSpace, InputError, Settings, load_world, study, study_of_gamma_space
from laplace_core.cli import main
from laplace_core.study.artefacts import find_artefacts
from laplace_core.study.npz import npz_bytes, read_gamma_space
from laplace_core.study.verdict import judge
from laplace_core.worlds import END, Outcome, World, parse_world, read_world

DATA = Path(__file__).parents[2] / "data"
SHIPPED = Path(__file__).parents[3] / "checkpoints" / "laplace_LunarLander-v3.safetensors"


def decoded(capsys, *words: str) -> dict:
    """What ``decode --json`` prints."""
    assert main(["decode", *map(str, words), "--json"]) == 0
    return json.loads(capsys.readouterr().out)


def refused(capsys, *words: str) -> str:
    """The one sentence on stderr."""
    assert main([*map(str, words)]) == 2
    printed = capsys.readouterr()
    assert printed.out == ""
    assert printed.err.count("\n") == 1
    return printed.err


def under(found, remedy):
    settings = remedy.apply(found.settings)
    world = load_world(settings.world, dict(settings.params)) if remedy.changes_world else found.world
    return study(world, settings)


def is_wrong(found, row: int) -> bool:
    optimum = found.truth.optimum[:, row]
    return optimum.max() - optimum[found.decoded.actions[row]] > 1e-9 * abs(optimum.max())


# --- one gamma-space ---


def test_decoded_and_readout_are_the_same_rule():
    from laplace_core.acting.rules import RULES, Options
    from laplace_core.training.checkpoint import load_checkpoint

    agent = load_checkpoint(SHIPPED).agent
    observations = np.random.default_rng(0).normal(0.0, 0.4, (12, 8)).astype(np.float32)
    one, other = (RULES[name].values(agent, 50, Options())(observations, 0) for name in ("readout", "decoded"))
    np.testing.assert_allclose(one, other, rtol=0, atol=1e-5 * np.abs(one).max())


# --- rounding ---


def test_a_row_that_holds_rounding_is_no_certain_reward(capsys):
    # 'pays after 1' is over after tau 1, and rewards are 0, 1 and 3.
    printed = decoded(capsys, "discounting_chain", "--normalise", "paper")
    assert np.min(printed["expected_reward"]) > -0.05


def test_values_of_rescaled_rows_are_possible_ones():
    # Rewards are 0 and 1 and one episode pays 1 at most: rescaled to a certain reward a row adds at most 1.
    found = study(load_world("gym:FrozenLake-v1"), Settings(normalise="paper"))
    values = found.decoded.horizon_values
    assert values.min() > -0.05
    assert np.all(values <= np.arange(1, values.shape[1] + 1))


def test_a_tie_is_relative():
    # Waiting once costs 1e-5 of the reward of 1e-4; taken for a tie, the policy waits for ever.
    found = study(read_world(DATA / "tiny_rewards.json"), Settings(acting_gamma=0.99999))
    assert found.truth.expected_reward[0, 1] == pytest.approx(1e-4)  # wait, then take
    assert found.truth.optimal_action[-1] == 1


# --- causes and remedies ---


def test_noise_is_blamed_only_where_it_is_to_blame():
    world = load_world("two_decisions")
    settings = Settings(alpha=0.023, noise=2e-4, noise_seed=79, gammas=15, policy="per_gamma")
    found = study(world, settings)
    assert is_wrong(found, 1)
    assert is_wrong(study(world, replace(settings, noise=0.0)), 1)
    verdict = judge(found, 1)
    assert verdict.cause is None or verdict.cause.name != "noise amplification"
    assert not any(is_wrong(under(found, remedy), 1) for remedy in verdict.remedies)


def test_a_named_cause_repairs_when_it_is_taken_away():
    settings = Settings(
        state="s0", gammas=30, spacing="log", thetas=60, theta_min=-1.4, theta_max=8.4, slope=14,
        alpha=0.012018264613155218, steps=40, normalise="paper", policy="per_gamma", acting_gamma=0.9,
    )  # fmt: skip
    found = study(read_world(DATA / "cause_1_29.json"), settings)
    verdict = judge(found, 12)
    assert is_wrong(found, 12)
    assert verdict.cause is not None  # raising alpha to 4.6 is one setting that repairs
    for remedy in verdict.remedies:
        after = under(found, remedy)
        row = after.row_at(13)
        assert not is_wrong(after, row)
        off = [
            np.abs(s.decoded.horizon_values[:, r] - s.truth.horizon_values[:, r]).max()
            for s, r in ((after, row), (found, 12))
        ]
        assert off[0] < off[1]


@pytest.mark.parametrize(
    ("world", "settings"),
    [("gym:Taxi-v4", {"noise": 1e-3}), ("fig6_chain", {"noise": 0.01, "alpha": 0.001})],
)
def test_one_alpha_is_suggested_at_most_and_it_repairs_and_stays(world, settings):
    found = study(load_world(world), Settings(**settings))
    row = len(found.horizons) - 1

    def suggested(view):
        chosen = int(view.decoded.actions[row])
        remedies = [*judge(view, row).remedies, *(r for each in find_artefacts(view, chosen) for r in each.remedies)]
        return {remedy.changes["alpha"] for remedy in remedies if "alpha" in remedy.changes}

    alphas = suggested(found)
    assert len(alphas) <= 1
    for alpha in alphas:
        after = study(found.world, replace(found.settings, alpha=alpha))
        assert not is_wrong(after, row)
        assert not suggested(after)


def test_rewards_given_survival_are_not_summed_as_if_sure():
    found = study(read_world(DATA / "survival_conditional.json"), Settings(normalise="survival"))
    row = len(found.horizons) - 1
    assert found.decoded.horizon_values[1, row] > found.decoded.horizon_values[0, row]  # 4.90 for a true 1.98
    assert "conditional rewards" in judge(found, row).sentence
    assert "conditional rewards" in {artefact.name for artefact in find_artefacts(found, 1)}


def test_a_repeated_reward_is_named_where_an_episode_idles_for_ever():
    # In 'idle' staying pays 0 for ever and leaving ends with 0: nothing is gained by ending, so the first action, to
    # stay, is taken. Survival stays 1, and rescaled rows repeat the 5 all the same.
    rows = [
        Outcome(0, 0, 1.0, 1, 5.0),
        Outcome(0, 1, 1.0, 2, 0.0),
        Outcome(1, 0, 1.0, 1, 0.0),
        Outcome(1, 1, 1.0, END, 0.0),
    ]
    rows += [Outcome(2, a, 1.0, 3, 0.0) for a in (0, 1)] + [Outcome(3, a, 1.0, 1, 10.0) for a in (0, 1)]
    world = World.from_outcomes("idles", ["start", "idle", "long 1", "long 2"], ["short", "long"], rows)
    found = study(world, Settings(normalise="paper", steps=10, alpha=0.2))
    np.testing.assert_array_equal(found.truth.survival[0], 1.0)  # nothing is gained by ending, so 'stay' is taken
    assert found.decoded.expected_reward[0, 1] > 4.0
    assert "repeated reward" in {artefact.name for artefact in find_artefacts(found, 0)}


def test_no_remedy_turns_a_right_choice_wrong():
    found = study(read_world(DATA / "absorbing_idle.json"), Settings(normalise="paper", steps=10, alpha=0.2))
    for row in range(10):
        for action in (0, 1):
            for artefact in find_artefacts(found, action, float(found.horizons[row])):
                for remedy in artefact.remedies:
                    after = under(found, remedy)
                    assert not is_wrong(after, after.row_at(found.horizons[row])), (row, artefact.name, remedy)


def test_a_constant_horizon_without_a_whole_step_is_no_fault():
    found = study(load_world("two_branch"), Settings(steps=1, time_step=0.5, deadline="constant"))
    assert "constant horizon" not in {artefact.name for artefact in find_artefacts(found, 0)}


def test_the_timeline_is_not_called_right_where_half_of_it_is_smeared():
    verdict = judge(study(load_world("fig6_chain"), Settings(alpha=10.0)), 3)
    assert verdict.timeline == "ruined"


# --- worlds as they are ---


def test_remedies_of_an_own_world_are_not_tried_on_a_preset():
    text = json.dumps({
        "name": "own", "states": ["start", "w1", "w2"], "actions": ["short", "long"], "start": {"start": 1.0},
        "transitions": [
            {"state": "start", "action": "short", "next": {"END": 1.0}, "reward": {"5": 1.0}},
            {"state": "start", "action": "long", "next": {"w1": 1.0}, "reward": {"0": 1.0}},
            {"state": "w1", "action": "*", "next": {"w2": 1.0}, "reward": {"0": 1.0}},
            {"state": "w2", "action": "*", "next": {"END": 1.0}, "reward": {"5.15": 1.0}},
        ],
    })  # fmt: skip
    found = study(parse_world(text), Settings(normalise="paper", alpha=0.2, steps=3, theta_min=-2, theta_max=12))
    assert found.settings.world != "two_branch"
    assert all("auxiliary" not in remedy.label for remedy in judge(found, 2).remedies)


def test_the_fickle_passenger_is_another_world():
    plain, fickle = load_world("gym:Taxi-v4"), load_world("gym:Taxi-v4", {"fickle_passenger": "true"})
    assert fickle.n_states > plain.n_states


def test_true_rows_at_a_fine_time_step_hold_the_whole_reward(capsys):
    printed = decoded(capsys, "two_branch", "--time-step", ".25")
    assert np.sum(printed["true_expected_reward"][0]) == pytest.approx(5.0)


def test_an_absorbing_state_ends_as_end_does(capsys):
    printed = decoded(capsys, DATA / "absorbing.json")
    assert printed["settings"]["steps"] == 3
    assert printed["expected_reward"][0][1] == pytest.approx(5.0, abs=0.2)
    assert printed["chosen_action"] == [0, 0, 1]


def test_frozen_lake_has_gymnasium_s_time_limit():
    import gymnasium

    from laplace_core.environments import vector

    assert vector.spec("gym:FrozenLake-v1").time_limit == gymnasium.spec("FrozenLake-v1").max_episode_steps == 100


# --- nothing is silently taken for something else ---


@pytest.mark.parametrize(("name", "word"), [("cdf", "r < theta"), ("square_swapped", "axes")])
def test_other_conventions_of_a_gamma_space_are_recognised(capsys, name, word):
    assert word in refused(capsys, "decode", DATA / f"{name}.npz")


def test_exact_values_of_mixed_policies_are_not_called_noise():
    found = study(load_world("two_decisions"), Settings(policy="per_gamma", alpha=0.01))
    own = study_of_gamma_space(
        read_gamma_space(npz_bytes(found), None, "x"), Settings(world="x.npz", alpha=0.01, steps=4)
    )
    names = {artefact.name for action in (0, 1) for artefact in find_artefacts(own, action)}
    assert "noise amplification" not in names


def test_a_byte_order_mark_is_read_and_another_encoding_refused(capsys):
    decoded(capsys, DATA / "bom.json")
    assert "UTF-8" in refused(capsys, "decode", DATA / "latin1.json")


def test_a_search_does_not_vary_its_environment(capsys, tmp_path):
    words = ["search", "dqn", "two_branch", "--vary", "environment=fig6_chain,cliff_grid", "--budget"]
    assert "environment" in refused(capsys, *words, "--runs", tmp_path)


# --- Python objects ---


def test_a_world_can_be_pickled_copied_and_loaded_by_path():
    world = load_world("two_branch")
    pickled = pickle.loads(pickle.dumps(world))  # noqa: S301 - our own
    for twin in (pickled, copy.deepcopy(world), load_world(DATA / "absorbing.json")):
        assert study(twin, Settings(steps=3)).decoded.horizon_values.shape == (2, 3)


def test_impossible_objects_are_refused_when_they_are_built():
    with pytest.raises(InputError, match="alpha"):
        Settings(alpha=-1)
    values, constant, gammas = np.ones((1, 2, 2)), np.ones((1, 2)), np.array([0.5, 0.9])
    with pytest.raises(InputError, match="thetas"):
        GammaSpace(values, constant, gammas, np.array([1.0, 0.0]))
    with pytest.raises(InputError):
        GammaSpace(values * np.nan, constant, gammas, np.array([0.0, 1.0]))


def test_the_shifted_index_is_that_of_the_published_notebook():
    """The notebook multiplies the values of each discount by the decoder's row of the next one; rows do not move."""
    shifted = study(load_world("two_branch"), Settings(shift=True))
    np.testing.assert_allclose(shifted.decoded.expected_reward[0], [0.19, 3.47, 1.52], atol=0.005)
