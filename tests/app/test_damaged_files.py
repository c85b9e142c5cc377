"""Files that come with the workbench, damaged: what cannot be used is left out with a sentence, all else works."""

from __future__ import annotations

import json
import math
import random
import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from app.catalogue import checkpoints, tabular
from laplace_core import InputError
from laplace_core.experiments import shipped_agents
from laplace_core.experiments.shipping import MANIFEST, curves_of, damaged, manifest
from laplace_core.figures.training import Band, score_curve, shipped_curves
from laplace_core.tabular import shipped as shipped_learners
from laplace_core.training import defaults
from tests.support.hostile import assert_one_sentence
from tests.support.pages import labels, opened

AGENT, OTHER = "c51_CartPole-v1", "dqn_CartPole-v1"
TABULAR = "fig6_chain_td"
CURVE = f"{AGENT}.curve.json"


def forget() -> None:
    shipped_agents.forget()
    shipped_learners.forget()


@pytest.fixture
def folder(tmp_path, monkeypatch) -> Iterator[Path]:
    """A copy of some of the files that ship, in their place."""
    shipped = checkpoints.SHIPPED
    for name in (AGENT, OTHER):
        shutil.copy(shipped / f"{name}.safetensors", tmp_path)
        shutil.copy(shipped / f"{name}.curve.json", tmp_path)
    shutil.copy(shipped / f"{TABULAR}.safetensors", tmp_path)
    entries = [entry for entry in manifest(shipped) if Path(entry["file"]).stem in (AGENT, OTHER)]
    (tmp_path / MANIFEST).write_text(json.dumps(entries))
    for module in (checkpoints, tabular):
        monkeypatch.setattr(module, "SHIPPED", tmp_path)
    forget()
    yield tmp_path
    forget()


ODD: tuple[Any, ...] = (math.nan, math.inf, -1, 10**400, "", "seven", None, [], [[1]], {}, True, 1e308, {"x": [None]})


def places(value: Any, path: tuple = ()) -> Iterator[tuple]:
    """Paths to every entry of a JSON value."""
    listed = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, each in listed:
        yield (*path, key)
        yield from places(each, (*path, key))


def changed(value: Any, rng: random.Random) -> Any:
    """The same with one entry replaced by something odd, or taken away."""
    value = json.loads(json.dumps(value))
    *path, last = rng.choice(list(places(value)))
    inner = value
    for key in path:
        inner = inner[key]
    if rng.random() < 0.25:
        del inner[last]
    else:
        inner[last] = rng.choice(ODD)
    return value


def use_everything(folder: Path) -> dict[str, str]:
    """All that the pages ask of the files; returns what was left out."""
    forget()
    names = checkpoints.names()
    for name in names:
        loaded = checkpoints.checkpoint(name)
        curves = checkpoints.curves(name)
        if curves:
            score_curve(curves, loaded.step)
        checkpoints.same_environment(loaded)
    drawn = checkpoints.shipped_curves("CartPole-v1")
    shipped_curves("t", [Band.of(name, "#000000", curves) for name, curves in drawn.items()])
    for sentence in checkpoints.left_out():
        assert_one_sentence(sentence)
    return damaged(folder)


def test_nothing_is_left_out_of_what_ships():
    assert damaged(checkpoints.SHIPPED) == {}
    assert tabular.learners() == {TABULAR: None}


def test_a_manifest_changed_at_any_place_leaves_the_agents(folder, subtests):
    rng, whole = random.Random(1), json.loads((folder / MANIFEST).read_text())
    for i in range(25):
        with subtests.test(i=i):
            (folder / MANIFEST).write_text(json.dumps(changed(whole, rng)))
            use_everything(folder)
            assert set(checkpoints.shipped()) == {AGENT, OTHER}


def test_a_manifest_cut_anywhere_leaves_the_agents(folder, subtests):
    text = (folder / MANIFEST).read_bytes()
    for size in range(0, len(text), len(text) // 20):
        with subtests.test(size=size):
            (folder / MANIFEST).write_bytes(text[:size])
            assert MANIFEST in use_everything(folder)
            assert set(checkpoints.shipped()) == {AGENT, OTHER}
            assert checkpoints.curves(AGENT) == ()


def test_a_curve_of_any_kind_is_drawn_or_left_out(folder, subtests):
    """Changed by somebody who entered the new sha256 in the manifest, too."""
    import hashlib

    rng, whole = random.Random(2), json.loads((folder / CURVE).read_text())
    entries = json.loads((folder / MANIFEST).read_text())
    for i in range(25):
        with subtests.test(i=i):
            data = json.dumps(changed(whole, rng)).encode()
            (folder / CURVE).write_bytes(data)
            next(e for e in entries if e["file"].startswith(AGENT))["curve"]["sha256"] = hashlib.sha256(
                data
            ).hexdigest()
            (folder / MANIFEST).write_text(json.dumps(entries))
            assert set(use_everything(folder)) <= {CURVE}
            assert set(checkpoints.shipped()) == {AGENT, OTHER}
            assert checkpoints.curves(OTHER)


def test_a_curve_that_is_not_the_manifest_s_is_left_out(folder):
    text = (folder / CURVE).read_bytes()
    (folder / CURVE).write_bytes(text[: len(text) // 2])
    assert list(use_everything(folder)) == [CURVE]
    assert checkpoints.curves(AGENT) == ()
    with pytest.raises(InputError, match=AGENT):
        curves_of(folder, next(entry for entry in manifest(folder) if entry["file"].startswith(AGENT)))


@pytest.mark.parametrize("name", [AGENT, TABULAR])
def test_an_agent_cut_or_changed_is_left_out(folder, subtests, name):
    path = folder / f"{name}.safetensors"
    content = path.read_bytes()
    length = int.from_bytes(content[:8], "little")
    for size in (0, 7, 8, 100, 8 + length, len(content) // 2, len(content) - 1):
        with subtests.test(size=size):
            path.write_bytes(content[:size])
            use_everything(folder)
            assert set(checkpoints.shipped()) == {AGENT, OTHER} - {name}
            assert (tabular.learners()[TABULAR] is None) == (name != TABULAR)
    path.write_bytes(content[:-4] + b"\x00\x00\xc0\x7f")  # a weight that is not a number
    use_everything(folder)
    assert set(checkpoints.shipped()) == {AGENT, OTHER} - {name}
    path.unlink()
    path.mkdir()
    use_everything(folder)
    assert set(checkpoints.shipped()) == {AGENT, OTHER} - {name}


@pytest.mark.parametrize("screen", ["agents", "race", "train"])
def test_a_page_says_what_is_left_out_and_works(folder, screen):
    path = folder / f"{AGENT}.safetensors"
    path.write_bytes(path.read_bytes()[:1000])
    (folder / CURVE).write_bytes(b"[")
    page = opened(screen=screen)
    said = [warning.value for warning in page.warning]
    assert len(said) == 2
    assert all(AGENT in each.replace("\\", "") for each in said)
    assert not page.error
    if screen != "train":
        assert page.selectbox(key="checkpoint").value == OTHER


def test_the_page_of_worlds_says_it_beside_the_learned_agents(folder):
    path = folder / f"{TABULAR}.safetensors"
    path.write_bytes(path.read_bytes()[:1000])
    page = opened("bring")
    assert not any(label.startswith("Open the learned") for label in labels(page))
    assert any(TABULAR in warning.value for warning in page.warning)


@pytest.mark.parametrize("text", ["", "[", "[]", "7", "null", '{"steps": "many"}', '{"steps": NaN}', '{"steps": [1]}',
                                  '{"what": 1}', '{"steps": 1' + "0" * 400 + "}"])  # fmt: skip
def test_a_file_of_settings_that_is_damaged_is_one_sentence_on_the_page_of_training(tmp_path, monkeypatch, text):
    (tmp_path / "settings" / "laplace").mkdir(parents=True)
    (tmp_path / "settings" / "laplace" / "CartPole-v1.json").write_text(text)
    monkeypatch.setattr(defaults.resources, "files", lambda package: tmp_path)
    defaults.suited_settings.cache_clear()
    page = opened(screen="train")
    defaults.suited_settings.cache_clear()
    assert len(page.error) == 1
    assert_one_sentence(page.error[0].value)
