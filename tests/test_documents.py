"""What README.md and the other documents say can be done, and the files and modules that they name, are there."""

from __future__ import annotations

import json
import re
import shlex
from pathlib import Path

import pytest

from laplace_core.cli import main, verbs
from laplace_core.worlds import parse_world
from tests.test_architecture import exists, is_name

ROOT = Path(__file__).resolve().parent.parent
README = (ROOT / "README.md").read_text(encoding="utf-8")
BLOCKS = re.findall(r"^```(\w*)\n(.*?)^```", README, re.M | re.S)
DOCUMENTS = [
    "README.md",
    "CONTRIBUTING.md",
    "docs/architecture.md",
    "docs/server.md",
    "docs/paper/README.md",
    "docs/reproduction.md",
    "app/static/README.md",
]
"""All but CHANGELOG.md, which names what was."""
FOLDERS = r"(app|laplace_core|docs|tests|bench|checkpoints)"


def blocks(language: str) -> list[str]:
    return [text for name, text in BLOCKS if name == language]


def commands() -> list[str]:
    """Every command line of the README, without its comment."""
    lines = [line for text in blocks("") for line in text.splitlines()]
    found = [re.fullmatch(r"(?:\$ )?python -m laplace_core (.*?)( +#.*)?", line) for line in lines]
    return [match[1] for match in found if match]


def test_the_python_of_the_readme_runs():
    (script,) = blocks("python")
    names: dict = {}
    exec(script, names)  # what it shows is looked at by its last lines
    result = names["result"]
    assert result.decoded.tau_space.ndim == 3
    assert result.decoded.actions.shape == result.truth.optimal_action.shape


def test_the_world_file_of_the_readme_is_one():
    (text,) = blocks("json")
    assert parse_world(text).name == json.loads(text)["name"]


def test_the_output_in_the_readme_is_what_the_command_prints(capsys):
    (shown,) = [text for text in blocks("") if text.startswith("$ ")]
    command, _, output = shown.partition("\n")
    assert main(shlex.split(command.removeprefix("$ python -m laplace_core "))) == 0
    assert capsys.readouterr().out == output


def test_every_command_of_the_readme_is_one():
    assert len(commands()) > 15
    for command in commands():
        options = verbs.parser().parse_args(verbs._joined(shlex.split(command)))
        assert options.verb == command.split()[0]


@pytest.mark.parametrize("document", DOCUMENTS)
def test_every_module_and_file_that_a_document_names_is_there(document):
    for span in re.findall(r"`([^`]+)`", (ROOT / document).read_text(encoding="utf-8").replace("```", "")):
        if is_name(span):
            assert span == "app.main" or exists(span), span
        elif re.fullmatch(rf"{FOLDERS}/[\w./*-]*", span):
            assert list(ROOT.glob(re.sub("NAME|ALGORITHM|ENVIRONMENT", "*", span).rstrip("/"))), span


def test_the_layout_of_the_readme_has_every_package():
    (layout,) = [text for text in blocks("") if text.startswith("app/")]
    for package in ("app", "laplace_core"):
        for folder in (path.parent.name for path in (ROOT / package).glob("*/__init__.py")):
            assert f"{folder}/" in layout, f"{package}/{folder}"


def test_modules_that_moved_are_where_the_changelog_says():
    table = re.findall(r"^  \| (`.*) \| (.*) \|$", (ROOT / "CHANGELOG.md").read_text(encoding="utf-8"), re.M)
    assert len(table) > 15
    for old, now in table:
        names = re.findall(r"`([^`]+)`", now)
        if now.startswith("the same names in"):
            names = [f"{names[0]}.{name.rpartition('.')[2]}" for name in re.findall(r"`([^`]+)`", old)]
        for name in names:
            assert exists(name), name


def test_every_reference_in_a_docstring_is_there():
    references = [
        (path, name)
        for folder in ("app", "laplace_core", "tests", "bench")
        for path in (ROOT / folder).rglob("*.py")
        for name in re.findall(r":(?:mod|func|class|data|meth|attr):`~?([\w.]+)`", path.read_text(encoding="utf-8"))
        if is_name(name)
    ]
    assert len(references) > 30
    assert [(path, name) for path, name in references if not exists(name)] == []
