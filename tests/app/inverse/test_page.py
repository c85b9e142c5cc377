"""The page of the inverse: what it says, what its controls do, and what a drag leaves behind."""

from __future__ import annotations

import io
import json
import struct
from dataclasses import replace

import numpy as np
import pytest

from app.inverse import compute
from app.inverse.subjects import OPENING, view_of
from app.view.compute import study_for
from laplace_core.experiments.inverse.measuring import plan_of
from laplace_core.experiments.inverse.selection import rows_of
from laplace_core.experiments.inverse.table_file import rows_in
from laplace_core.inverse.certificate import certify
from laplace_core.inverse.consistency import check_noise
from laplace_core.inverse.grids import judged, task_for
from laplace_core.payloads import inverse_words as words
from laplace_core.study.course import errors_of
from laplace_core.study.evidence import Evidence, gathered, horizons_of
from laplace_core.tabular import noise_over_seeds, reward_gain_over_seeds, study_of
from tests.support.lens_reference import unpacked
from tests.support.pages import charts, downloads, labels, link, opened, press, run, wait


def told(page):
    """The header of the message to the pictures."""
    for node in page.get("bidi_component"):
        data = node.proto.bytes if hasattr(node.proto, "bytes") else b""
        if data:
            (length,) = struct.unpack("<I", data[:4])
            header = json.loads(data[4 : 4 + length])
            if header.get("rules"):
                return header
    raise AssertionError("no pictures")


def sentence(values, found=None, **more):
    view = view_of({**OPENING, **values})
    shown = compute.shown(view)
    return words.said(shown.study, shown.found, shown.course, found, **more)


def test_the_sentence_names_the_rule_its_alpha_and_how_far_the_best_is():
    said = sentence({"selector": "gcv"}, Evidence(0.4, ()))
    alpha = study_for(view_of({**OPENING, "selector": "gcv"})).settings.alpha
    assert said.sentence.startswith(f"GCV takes alpha {alpha:.3g}.")
    assert "the best alpha" in said.sentence
    assert "degrees of freedom" in said.sentence
    assert "p = 0.4" in said.sentence


def test_an_alpha_by_hand_is_compared_with_what_the_data_suggest():
    assert sentence({"alpha": 0.3}).sentence.startswith("Alpha 0.3 was set by hand; automatic takes ")


def test_degrees_of_freedom_are_those_of_an_alpha_beyond_the_sweep():
    """The reference: sum of s^2 / (s^2 + alpha^2) over the singular values, which all lie far below this alpha."""
    view = view_of({**OPENING, "alpha": 1e4})
    s = compute.shown(view).found.sweep.spectrum.s
    degrees = float(np.sum(s**2 / (s**2 + 1e8)))
    assert f"{degrees:.3g} of 15 degrees of freedom are fitted" in sentence({"alpha": 1e4}).sentence


def test_values_of_no_timeline_are_called_so():
    said = sentence({}, Evidence(0.005, ()))
    assert said.tone == "bad"
    assert "No feasible timeline has these values" in said.sentence


def test_an_alpha_at_the_end_of_the_sweep_is_said():
    view = view_of(OPENING)
    shown = compute.shown(view)
    edged = replace(shown.study, automatic=replace(shown.study.automatic, edge="upper"))
    said = words.said(edged, shown.found, shown.course, None)
    assert "the largest alpha of the sweep" in said.sentence
    assert said.tone == "warn"


def test_of_a_solver_that_takes_long_the_own_error_is_told_and_the_map_is_of_another():
    values = {**OPENING, "solver": "feasible"}
    study = study_for(view_of(values))
    shown = compute.shown(view_of(values))
    assert shown.course.solver == "tikhonov"
    assert (
        f"The timeline is off by {errors_of(study).distance:.3g} steps; that of Tikhonov" in sentence(values).sentence
    )


def test_what_is_missing_is_said():
    assert sentence({}).sentence.endswith(words.NO_NOISE)
    assert sentence({}, lacking=words.TESTING).sentence.endswith(words.TESTING)


def test_evidence_is_that_of_the_library():
    study = study_for(view_of(OPENING))
    deviations = study.settings.noise_level / (1.0 - study.gamma_space.gammas)
    steps = []
    found = gathered(study, deviations, independent=True, progress=lambda done, of: steps.append((done, of)))
    assert found.p_value == check_noise(study.gamma_space, deviations).p_value
    rewards = float(study.world.reward_values[0]), float(study.world.reward_values[-1])
    for horizon, action in found.certified:
        best = certify(study.gamma_space, int(horizon), deviations, value_gamma=study.settings.value_gamma,
                       slope=study.settings.slope, rewards=rewards).best  # fmt: skip
        assert action == (-1 if best is None else best)
    assert steps[-1][0] == len(found.certified)


def test_horizons_are_close_together_where_they_are_short():
    study = study_for(view_of({"world": "discounting_chain"}))
    horizons = horizons_of(study)
    assert horizons[:3] == [1, 2, 3]
    assert horizons[-1] == 110
    assert np.all(np.diff(np.diff(horizons)) >= -1)


def test_the_page_opens_and_says_what_was_found():
    page = wait(opened(screen="inverse"), lambda page: "being tested" not in told(page)["said"]["sentence"])
    header = told(page)
    assert header["said"]["sentence"].startswith("Automatic, by the fitted network, takes alpha")
    assert "p = " in header["said"]["sentence"]
    assert header["rule"] == "fitted"
    assert header["certified"]
    assert link(page) == {"world": "two_branch", "action": "long", "noise": "0.001"}


def test_a_rule_takes_the_place_of_an_alpha_by_hand_and_back():
    page = opened(screen="inverse", world="two_branch", noise="0.001", alpha="0.3", selector="typed")
    assert told(page)["state"]["alpha"] == 0.3
    assert told(page)["rule"] is None
    page.selectbox(key="selector").select("gcv")
    run(page)
    assert link(page) == {"world": "two_branch", "noise": "0.001", "selector": "gcv"}
    alpha = told(page)["state"]["alpha"]
    page.selectbox(key="selector").select("typed")
    run(page)
    assert float(link(page)["alpha"]) == pytest.approx(alpha, rel=1e-3)


def test_another_world_keeps_noise_and_solver_but_not_alpha():
    page = opened(screen="inverse", world="two_branch", noise="0.001", alpha="0.3", selector="typed", solver="tsvd")
    page.selectbox(key="world").select("fig6_chain")
    run(page)
    assert link(page)["world"] == "fig6_chain"
    assert link(page)["solver"] == "tsvd"
    assert "alpha" not in link(page)


def test_a_trained_agent_and_a_file_can_be_looked_at():
    page = opened(screen="inverse")
    page.segmented_control(key="kind").set_value("agent")
    run(page)
    assert "agent" in link(page)
    assert told(page)
    page.segmented_control(key="kind").set_value("data")
    run(page)
    assert any("open a file" in info.value for info in page.info)
    page.segmented_control(key="kind").set_value("world")
    run(page)
    assert link(page)["world"] == "two_branch"


def test_a_file_is_opened_here_although_the_page_of_worlds_opens_such_files():
    space, file = study_for(view_of({"world": "two_branch"})).gamma_space, io.BytesIO()
    np.savez(file, gamma_space=space.values, constant_channel=space.constant, gammas=space.gammas, thetas=space.thetas)
    page = opened(screen="inverse")
    page.segmented_control(key="kind").set_value("data")
    run(page)
    page.file_uploader[0].set_value(("own.npz", file.getvalue(), "application/octet-stream"))
    run(page)
    assert not page.error
    assert set(link(page)) == {"data", "noise"}
    assert told(page)["said"]["sentence"].startswith("Automatic")


def test_the_leaderboard_lists_every_solver_and_opens_one():
    page = opened("leaderboard", screen="inverse")
    (table,) = page.dataframe
    assert list(table.value["Solver"])[:2] == ["Tikhonov", "Tikhonov, first differences"]
    assert table.value["W1 (steps)"].notna().all()


def test_settings_that_do_not_fit_are_refused_and_can_be_undone():
    page = opened(screen="inverse", world="two_branch", noise="0.001")
    page.number_input(key="gamma_min").set_value(0.99)
    run(page)
    assert page.error
    press(page, "Undo the last change")
    assert not page.error


def test_a_timeline_that_is_stopped_early_turns_the_choice():
    page = opened("memory", screen="inverse", world="two_branch")
    before = next(caption.value for caption in page.caption if caption.value.startswith("As decoded"))
    assert "Changed" not in before
    page.number_input(key="m.horizon").set_value(2)
    run(page)
    after = next(caption.value for caption in page.caption if caption.value.startswith("As decoded"))
    assert "Changed: short is chosen at every T." in after
    assert link(page)["m.horizon"] == "2"


def test_a_change_of_the_timeline_is_in_the_link():
    page = opened(screen="inverse", world="two_branch", **{"m.gamma": "0.8", "m.worst": "2"})
    assert any("worst must be a number" in warning.value for warning in page.warning)
    assert link(page)["m.gamma"] == "0.8"


def test_grids_are_judged_and_one_is_used():
    page = wait(opened("grids", screen="inverse", world="two_branch", gammas="6"), lambda page: bool(page.dataframe))
    (table,) = page.dataframe
    assert list(table.value["Grid"])[:2] == ["designed", "inverse-log"]
    found = judged(task_for(3, 0.0), 6, lambda done, of: None)
    assert [each.name for each in found] == list(table.value["Grid"])
    assert found[0].error == min(each.error for each in found if len(each.gammas) == 6)


SMALL_STUDY = {"s.noises": "0.001", "s.solvers": "tikhonov,tsvd", "s.selectors": "gcv,aic"}


def test_a_study_of_many_worlds_is_measured_drawn_and_taken_along(monkeypatch):
    saved = downloads(monkeypatch)
    page = opened("study", screen="inverse", world="two_branch", **{**SMALL_STUDY, "s.cases": "3"})
    assert not charts(page).keys() & {"study ratio", "study excess"}
    press(page, "Run the study")
    wait(page, lambda page: "study ratio" in charts(page) and "Cancel" not in labels(page))
    assert [trace["name"] for trace in charts(page)["study ratio"]["data"]] == ["Tikhonov", "Truncated SVD"]
    plan = plan_of({"cases": 3, "noises": "0.001", "solvers": "tikhonov,tsvd", "selectors": "gcv,aic"})
    rows = rows_in(saved["inverse_study.csv"])
    assert len(rows) == 3 * plan.rows_of_a_job
    assert rows[4]["alpha"] == str(rows_of(plan.jobs()[0], plan)[4]["alpha"])
    assert "Run the study" not in labels(page)


def test_what_a_cancelled_study_has_measured_stays_and_the_rest_can_be_measured():
    page = opened("study", screen="inverse", world="two_branch", **{**SMALL_STUDY, "s.cases": "400"})
    press(page, "Run the study")
    wait(page, lambda page: "study ratio" in charts(page))
    press(page, "Cancel")
    wait(page, lambda page: "Measure the rest" in labels(page))
    assert any("of 400 cases are measured" in caption.value for caption in page.caption)
    assert {"study ratio", "study excess"} <= charts(page).keys()


def test_words_of_a_study_that_make_no_sense_are_one_sentence():
    page = opened("study", screen="inverse", world="two_branch", **{"s.solvers": "magic"})
    assert any("solver 'magic' is not one of" in warning.value for warning in page.warning)
    assert link(page) == {"world": "two_branch"}
    page.text_input(key="s.noises").set_value("0.1; 5")
    run(page)
    assert [error.value for error in page.error] == [
        "noise '0.1; 5' is not a number: give numbers above 0 and at most 1, such as 0.001."
    ]
    page.multiselect(key="s.solvers box").set_value([])
    page.text_input(key="s.noises").set_value("0.1")
    run(page)
    assert [error.value for error in page.error] == ["name each solver of the study once, and at least one."]
    page.multiselect(key="s.solvers box").set_value(["tsvd", "dsvd"])
    run(page)
    assert link(page) == {"world": "two_branch", "s.noises": "0.1", "s.solvers": "tsvd,dsvd"}
    assert "Run the study" in labels(page)


def test_a_study_longer_than_the_server_allows_is_refused():
    page = opened("study", screen="inverse", world="two_branch",
                  **{"s.solvers": "feasible", "s.cases": "1000", "s.selectors": "gcv"})  # fmt: skip
    button = next(button for button in page.button if button.label == "Run the study")
    assert button.disabled
    assert any("this server allows 10 minutes: lower its worlds" in warning.value for warning in page.warning)


def test_noise_is_measured_from_the_seeds_of_a_learner_that_is_then_looked_at():
    page = opened(screen="inverse", world="two_branch", **{"p.slip": "0.3", "measured": "true", "seeds": "3",
                                                          "episodes": "50"})  # fmt: skip
    wait(page, lambda page: any("Measured noise" in caption.value for caption in page.caption))
    values = {"world": "two_branch", "p.slip": 0.3, "measured": True, "seeds": 3, "episodes": 50}
    view = view_of(values)
    learned = view.learner.learned
    assert learned.settings.episodes == 50
    spread = noise_over_seeds(learned, view.settings)
    assert any(f"{view.settings.noise_level:.2g} on average, over 3 seeds" in caption.value for caption in page.caption)
    header, arrays = unpacked(compute.shown(view).data)
    assert header["gain"] == reward_gain_over_seeds(learned, view.settings)
    np.testing.assert_allclose(arrays["deviations"], spread / (1 - learned.gammas), rtol=1e-3)
    own = study_of(learned, view.settings, 0).gamma_space.values
    np.testing.assert_array_equal(study_for(view).gamma_space.values, own)
    assert view_of({**values, "noise_level": 0.02}).settings.noise_levels is None  # a given level holds
    page.checkbox(key="measured").uncheck()
    run(page)
    assert view_of({**values, "measured": False}).learner is None
    assert told(page)["said"]["sentence"].endswith(words.NO_NOISE)


def test_seeds_that_agree_are_said_to_show_no_noise():
    page = opened(screen="inverse", world="two_branch", measured="true", seeds="2")
    wait(page, lambda page: page.info)
    assert [info.value for info in page.info] == [
        "all seeds have learned the same values: there is no noise to measure."
    ]
