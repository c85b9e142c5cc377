"""Worlds, gamma-spaces and timelines of one's own on the page: they are seen, and what is refused changes nothing."""

from __future__ import annotations

import io
import json
from pathlib import Path

import numpy as np
import pytest

from app.catalogue.checkpoints import SHIPPED
from laplace_core import Settings, load_world, study, study_of_gamma_space
from laplace_core.files import packed_text as links
from laplace_core.study.npz import read_gamma_space, study_arrays
from laplace_core.worlds import parse_world, world_from_rows, world_rows
from laplace_core.worlds.timeline import FIRST_TIMELINE, packed_timeline, timeline_rows_of
from tests.support.hostile import assert_one_sentence
from tests.support.malformed_saved import GOOD, with_arrays
from tests.support.malformed_worlds import CASES, TEXT, VALID
from tests.support.pages import (
    assert_shows,
    choose,
    downloads,
    edit,
    handed,
    labels,
    link,
    opened,
    pictures,
    press,
    run,
    seen_on,
    shown,
    tau_space,
    upload,
    verdict,
)

OWN = {"world": "own", "own": links.pack(TEXT), "alpha": "0.01"}


def table_of_two_branch():
    return press(opened("bring", world="two_branch"), "Edit this world as a table")


def cells(page):
    """The rows of a table, with its numbers as numbers."""
    numbers = ("probability", "reward", "tau")
    rows = page.data_editor[0].value.to_dict("records")
    return [{name: float(cell) if name in numbers else cell for name, cell in row.items()} for row in rows]


# --- a world as a table ---


def test_a_world_opened_as_a_table_shows_the_same_picture():
    plain, page = opened(world="two_branch"), table_of_two_branch()
    assert cells(page) == world_rows(load_world("two_branch"))
    np.testing.assert_array_equal(tau_space(page), tau_space(plain))
    assert verdict(page) == verdict(plain)
    assert link(page)["world"] == "own"


def test_an_edited_reward_moves_the_picture_and_the_verdict():
    page = table_of_two_branch()
    assert "choose long" in verdict(page)
    edit(page, {4: {"reward": 3.0}, 5: {"reward": 3.0}})
    assert "choose short" in verdict(page)
    rows = world_rows(load_world("two_branch"))
    rows[4]["reward"] = rows[5]["reward"] = 3.0
    expected = world_from_rows(rows, name="two_branch", states=("start", "long 1", "long 2"), actions=("short", "long"))
    found = study(expected, shown(page).settings)
    assert_shows(page, found)
    assert not page.warning


def test_a_new_state_can_be_typed_in_and_a_row_deleted():
    page = table_of_two_branch()
    added = [
        {"state": "cellar", "action": action, "probability": 1.0, "reward": 4.0, "next": "END"}
        for action in ("short", "long")
    ]
    edit(page, {0: {"next": "cellar"}}, added)
    assert not page.warning
    assert "cellar" in page.selectbox(key="state").options
    edit(page, {0: {"next": "END"}}, added, deleted=(1,))
    assert "start" in page.warning[0].value


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"probability": 0.5}, "add up to 0.5"),
        ({"probability": None}, "probability"),
        ({"reward": None}, "reward"),
        ({"next": "nowhere"}, "nowhere"),
        ({"state": ""}, "state"),
    ],
)
def test_a_row_that_makes_no_sense_is_one_sentence_and_the_picture_stays(changes, said):
    page = table_of_two_branch()
    before, words = tau_space(page), link(page)
    edit(page, {1: changes})
    assert len(page.warning) == 1
    assert said in page.warning[0].value
    assert_one_sentence(page.warning[0].value)
    np.testing.assert_array_equal(tau_space(page), before)
    assert link(page) == words


@pytest.mark.parametrize("typed", ["2,5", "1/3", "1 000", "2.5.1", "0x10", "५", "1e400", "=1+1", "NaN", "2.5 %"])
@pytest.mark.parametrize("table", ["own", "timeline"])
def test_what_is_typed_as_a_number_is_that_number_or_refused(typed, table):
    page = table_of_two_branch() if table == "own" else press(opened("bring"), "Draw a timeline")
    before = link(page)
    edit(page, {1: {"reward": typed}})
    assert_one_sentence(page.warning[0].value.replace("\\", "").replace("\u2060", ""), "row 2")
    assert link(page) == before


@pytest.mark.parametrize(("typed", "number"), [("2.5", 2.5), ("-1.5e1", -15.0), (" +7 ", 7.0), (".25", 0.25)])
def test_a_number_is_taken_however_it_is_written(typed, number):
    page = edit(table_of_two_branch(), {1: {"reward": typed}})
    assert not page.warning
    assert number in parse_world(links.unpack(link(page)["own"])).reward.tolist()
    drawn = edit(press(opened("bring"), "Draw a timeline"), {1: {"reward": typed}})
    assert not drawn.warning
    assert timeline_rows_of(link(drawn)["timeline"])[0][1]["reward"] == number


def test_rescale_repairs_probabilities_even_where_they_come_back_to_what_was_there():
    page = edit(table_of_two_branch(), {1: {"probability": 0.5}})
    press(page, "Rescale probabilities to 1")
    assert not page.warning
    assert [row["probability"] for row in cells(page)] == [1.0] * 6
    assert "Rescale probabilities to 1" not in labels(page)


def test_rescale_divides_by_the_sum():
    added = [{"state": "start", "action": "long", "probability": 1.0, "reward": 2.0, "next": "END"}]
    page = edit(table_of_two_branch(), {}, added)
    assert "add up to 2" in page.warning[0].value
    press(page, "Rescale probabilities to 1")
    assert not page.warning
    table = page.data_editor[0].value
    assert table[(table.state == "start") & (table.action == "long")]["probability"].tolist() == ["0.5", "0.5"]
    assert_shows(page, study(parse_world(links.unpack(link(page)["own"])), shown(page).settings))


def test_nothing_is_offered_where_rescaling_cannot_help():
    page = edit(table_of_two_branch(), {1: {"probability": 0.0}})
    assert "Rescale probabilities to 1" not in labels(page)


def test_edits_outlive_a_look_at_another_world_and_the_way_back():
    page = edit(table_of_two_branch(), {1: {"reward": 7.0}})
    before, words = tau_space(page), link(page)
    page.selectbox(key="world").set_value("fig6_chain")
    run(page)
    assert "own" not in link(page)
    page.query_params.clear()
    for name, value in words.items():
        page.query_params[name] = value
    run(page)  # the browser's Back
    run(page)
    assert cells(page)[1]["reward"] == 7.0
    np.testing.assert_array_equal(tau_space(page), before)
    assert link(page) == words


def test_edits_outlive_an_error_elsewhere():
    page = edit(table_of_two_branch(), {1: {"reward": 7.0}})
    words = link(page)
    page.session_state["learning"] = True
    run(page)
    page.number_input(key="theta_min").set_value(50.0)
    run(page)
    assert page.error
    press(page, "Undo the last change")
    assert not page.error
    assert link(page)["own"] == words["own"]


def test_the_table_s_world_is_the_one_that_is_downloaded(monkeypatch):
    saved = downloads(monkeypatch)
    page = edit(table_of_two_branch(), {1: {"reward": 7.0}})
    content = saved["two_branch.json"]
    assert content == links.unpack(link(page)["own"])
    assert_shows(page, study(parse_world(content), shown(page).settings))


# --- files ---


def test_a_world_file_is_opened_whatever_the_case_of_its_ending():
    for name in ("mine.json", "MINE.JSON"):
        page = upload(opened("bring"), name, TEXT.encode())
        assert not page.error
        assert page.selectbox(key="world").value == "own"
        assert_shows(page, study(parse_world(TEXT), shown(page).settings))


def test_a_bad_world_file_is_one_sentence_and_the_view_stays(subtests):
    for case in CASES[:: len(CASES) // 12]:
        with subtests.test(case[0]):
            _, text, _ = case
            page = opened("bring", alpha="0.5")
            before, words = pictures(page), link(page)
            upload(page, "bad.json", text.encode("utf-8", "surrogatepass"))
            assert len(page.error) == 1
            assert_one_sentence(page.error[0].value)
            assert pictures(page) == before
            assert link(page) == words


def test_a_gamma_space_is_decoded_without_a_world():
    page = upload(opened("bring"), "mine.npz", with_arrays())
    assert not page.error
    view = read_gamma_space(with_arrays())
    assert_shows(page, study_of_gamma_space(view, Settings(world="mine.npz")))
    assert handed(page)[0]["world"] is None  # the fit over the discounts stands in its place
    assert verdict(page).startswith("unknown")


def test_every_state_of_a_gamma_space_can_be_looked_at():
    several = np.stack([GOOD["gamma_space"], 0.5 * GOOD["gamma_space"]])
    content = with_arrays(gamma_space=several, constant_channel=None)
    page = upload(opened("bring"), "mine.npz", content)
    first = tau_space(page)
    page.number_input(key="state_index").set_value(1)
    run(page)
    np.testing.assert_allclose(tau_space(page), 0.5 * first, rtol=1e-5, atol=1e-6)
    choose(page, action="action 1")
    expected = study_of_gamma_space(read_gamma_space(content, "1"), Settings(world="mine.npz"))
    assert_shows(page, expected, 1)


def test_what_the_page_downloads_it_opens_again(monkeypatch):
    saved = downloads(monkeypatch)
    page = opened("downloading", world="two_decisions", alpha="0.05")
    again = upload(opened("bring"), "view.npz", saved["two_decisions.npz"])
    choose(again, alpha=0.05)
    both = [seen_on(p)["differences"] for p in (page, again)]
    np.testing.assert_allclose(both[0], both[1], rtol=1e-12, atol=1e-14)
    found = study(load_world("two_decisions"), Settings(world="two_decisions", alpha=0.05))
    with np.load(io.BytesIO(saved["two_decisions.npz"])) as file:
        assert set(file.files) == set(study_arrays(found))
        for name, array in study_arrays(found).items():
            np.testing.assert_array_equal(file[name], array)


BAD_NPZ = {
    "empty": b"",
    "text": b"gamma_space,gammas,thetas",
    "a world": TEXT.encode(),
    "cut off": with_arrays()[:200],
    "no gammas": with_arrays(gammas=None),
    "nan": with_arrays(gamma_space=GOOD["gamma_space"] * np.nan),
    "shape": with_arrays(gamma_space=np.zeros((2, 3, 5))),
    "no actions": with_arrays(gamma_space=np.zeros((0, 3, 4))),
    "no states": with_arrays(gamma_space=np.zeros((0, 2, 3, 4)), constant_channel=None),
    "words": with_arrays(gammas=np.array(["a", "b", "c"])),
    "complex": with_arrays(thetas=GOOD["thetas"] + 1j),
    "gamma of 1": with_arrays(gammas=np.array([0.2, 0.5, 1.0])),
}


def test_a_bad_gamma_space_is_one_sentence_and_the_view_stays(subtests):
    for kind in BAD_NPZ:
        with subtests.test(kind):
            page = opened("bring", alpha="0.5")
            before, words = pictures(page), link(page)
            upload(page, "bad.npz", BAD_NPZ[kind])
            assert len(page.error) == 1
            assert_one_sentence(page.error[0].value)
            assert pictures(page) == before
            assert link(page) == words


def test_a_refusal_goes_when_the_file_is_taken_away():
    page = upload(opened("bring"), "bad.npz", b"")
    assert page.error
    page.file_uploader(key="upload").set_value(None)
    assert not run(page).error


@pytest.mark.parametrize(
    "name", ["-rf.npz", "=1+1.npz", "a b'c\"d.npz", "..npz", "x" * 200 + ".npz", "<b>.npz", "mine.npz"]
)
def test_odd_names_of_files_make_no_trouble(name, monkeypatch):
    saved = downloads(monkeypatch)
    page = opened("bring", "copying", "downloading")
    upload(page, name, with_arrays())
    assert not page.error
    assert len(saved) >= 5
    for file in saved:
        assert file.count(".npz") <= 1
        assert not set(file) & set("/\\<>\"' :=")


def test_a_link_to_a_gamma_space_asks_for_the_file():
    page = opened(world="data", data="0123456789ab")
    assert "open the file again" in page.warning[0].value
    assert "14.85 v 9.74" in verdict(page)


def test_going_to_a_listed_world_drops_what_was_brought():
    page = upload(opened("bring"), "mine.npz", with_arrays())
    page.selectbox(key="world").set_value("two_branch")
    run(page)
    assert link(page) == {"world": "two_branch"} | ({"normalise": "none"} if "normalise" in link(page) else {})
    assert not page.error
    page = opened(**OWN)
    page.selectbox(key="world").set_value("fig6_chain")
    assert link(run(page)) == {"world": "fig6_chain"}


# --- timelines ---


def test_a_timeline_is_drawn_and_its_gamma_space_follows():
    page = press(opened("bring"), "Draw a timeline")
    assert not page.warning
    rows = timeline_rows_of(FIRST_TIMELINE)[0]
    assert cells(page) == rows
    assert_shows(page, study(shown(page).world, shown(page).settings))
    before = tau_space(choose(page, action="later"))
    edit(page, {1: {"tau": 5}})
    assert not page.warning
    found = study(shown(page).world, shown(page).settings)
    later = found.action_names.index("later")
    assert_shows(page, found, later)
    np.testing.assert_allclose(found.truth.expected_reward[later, :9], [0, 0, 0, 0, 0, 1.8, 0, 0, 8.0], atol=1e-9)
    assert not np.array_equal(tau_space(page), before)


def test_what_is_left_of_a_step_can_be_its_end():
    rows = [{"action": "go", "tau": tau, "reward": 2.0, "probability": p} for tau, p in enumerate((1.0, 0.5, 0.25))]
    page = opened(world="timeline", timeline=packed_timeline(rows, "zero"), alpha="0.001")
    page.radio[0].set_value("ended")
    run(page)
    assert not page.warning
    found = study(shown(page).world, shown(page).settings)
    np.testing.assert_allclose(found.truth.survival[0, :4], [1.0, 0.5, 0.25, 0.0], atol=1e-9)
    assert_shows(page, found)


@pytest.mark.parametrize(
    "changes", [{"probability": None}, {"tau": 0, "action": "now"}, {"tau": None}, {"action": "END"}, {"reward": None}]
)
def test_a_bad_row_of_a_timeline_is_one_sentence_and_the_picture_stays(changes):
    page = press(opened("bring"), "Draw a timeline")
    before, words = tau_space(page), link(page)
    edit(page, {1: changes})
    assert len(page.warning) == 1
    assert_one_sentence(page.warning[0].value)
    np.testing.assert_array_equal(tau_space(page), before)
    assert link(page) == words


def test_a_timeline_can_be_taken_along_as_a_world_file(monkeypatch):
    saved = downloads(monkeypatch)
    page = press(opened("bring", "copying"), "Draw a timeline")
    view = shown(page)
    assert_shows(page, study(parse_world(saved[view.settings.world]), view.settings))


# --- links ---


@pytest.mark.parametrize(
    "query",
    [OWN, {"world": "timeline", "timeline": FIRST_TIMELINE}, {**OWN, "state": "long", "action": "right"}],
    ids=["own", "timeline", "a state of it"],
)
def test_a_link_alone_reproduces_the_view(query):
    page = opened(**query)
    assert not page.warning
    again = opened(**link(page))
    assert pictures(again) == pictures(page)
    assert verdict(again) == verdict(page)
    assert link(again) == link(page)


def test_a_damaged_link_opens_with_a_note():
    page = opened(**{**OWN, "own": OWN["own"][:-20]})
    assert "copy it again in full" in page.warning[0].value
    assert "14.85 v 9.74" in verdict(page)


def test_a_world_too_long_for_a_link_is_shown_and_says_so():
    generator = np.random.default_rng(0)
    states = [f"state {i} {generator.integers(1 << 60)}" for i in range(400)]
    moves = [
        {"state": here, "action": "*", "next": {there: 1.0}, "reward": {f"{i % 7}": 1.0}}
        for i, (here, there) in enumerate(zip(states, [*states[1:], "END"], strict=True))
    ]
    text = json.dumps({**VALID, "states": states, "start": {states[0]: 1.0}, "transitions": moves})
    page = upload(opened("bring"), "long.json", text.encode())
    assert not page.error
    assert link(page) == {}
    assert any("too long for a link" in caption.value for caption in page.caption)
    assert_shows(page, study(parse_world(text), Settings()))
    choose(page, alpha=0.05)  # the view stays although its link is empty
    assert page.selectbox(key="world").value == "own"
    assert handed(page)[0]["state"]["alpha"] == 0.05


def test_a_world_of_ones_own_can_be_begun_beside_a_gamma_space():
    """A gamma-space has no world to begin with: the opening one is there to be edited."""
    page = upload(opened("bring"), "mine.npz", with_arrays())
    page.selectbox(key="world").select("own")
    run(page)
    assert link(page)["world"] == "own"
    assert cells(page) == world_rows(load_world("two_branch"))


# --- worlds that are too large for a link ---


def large_world() -> bytes:
    """A world file of more than 3 MB: few states, and very many outcomes of each action."""
    states = [f"state {i}" for i in range(12)]
    outcomes = [{"p": 1 / 1024, "next": states[i % 12] if i % 3 else "END", "reward": i % 4} for i in range(1024)]
    rows = [{"state": s, "action": a, "outcomes": outcomes} for s in states for a in ("stay", "go", "run", "wait")]
    text = json.dumps(
        {"name": "large", "states": states, "actions": ["stay", "go", "run", "wait"], "transitions": rows}
    )
    assert len(text) > links.MOST
    return text.encode()


def test_a_world_too_large_for_a_link_opens_and_the_page_says_what_the_link_lacks(monkeypatch):
    saved, content = downloads(monkeypatch), large_world()
    page = upload(opened("bring"), "large.json", content)
    assert not page.error
    assert_shows(page, study(parse_world(content.decode()), Settings()))
    assert any("too long for a link" in caption.value for caption in page.caption)
    assert parse_world(str(saved["large.json"])).states == parse_world(content.decode()).states
    again = opened(**link(page))  # somebody else, or the same person after a reload
    assert "too large for a link" in again.warning[0].value
    assert_one_sentence(again.warning[0].value.removeprefix("Left out of the link: "))
    assert handed(again)[0]["state"] == handed(opened())[0]["state"]


# --- a file at the wrong page ---


@pytest.mark.parametrize(
    ("screen", "name", "what", "home"),
    [
        ("worlds", "dqn_CartPole-v1.safetensors", "a trained agent", "Trained agents"),
        ("agents", "fig6_chain_td.safetensors", "learned a tabular world", "Worlds"),
        ("agents", "world.json", "a world", "Worlds"),
        ("agents", "space.npz", "a gamma-space", "Worlds"),
    ],
)
def test_a_file_at_the_wrong_page_is_sent_to_the_right_one(screen, name, what, home):
    content = (SHIPPED / name).read_bytes() if name.endswith("safetensors") else TEXT.encode()
    page = opened("bring", screen=screen)
    before = link(page)
    page.file_uploader[0].set_value((name, content, "application/octet-stream"))
    run(page)
    (error,) = page.error
    assert what in error.value
    assert home in error.value
    assert_one_sentence(error.value)
    assert link(page) == before
    links = [block.proto.label for block in page.get("page_link")]
    assert [label for label in links if label.startswith("To the page")] == [f"To the page {home}"]


# --- one rule of encodings for the page and the command ---


def test_a_byte_order_mark_is_read_and_another_encoding_refused():
    data = Path(__file__).parents[2] / "data"
    page = upload(opened("bring"), "bom.json", (data / "bom.json").read_bytes())
    assert not page.error
    assert shown(page).world.states == load_world(data / "bom.json").states
    before = link(page)
    upload(page, "latin1.json", (data / "latin1.json").read_bytes())
    assert "UTF-8" in page.error[0].value
    assert link(page) == before
