"""What README.md and the other documents say can be done, and the files and modules that they name, are there.

Examples with output are run: blocks ``pycon`` as doctests, one page in one namespace, blocks ``console`` and the one of
README as commands. Every other command must be one, and names files that are there.
"""

from __future__ import annotations

import doctest
import json
import re
import shlex
from pathlib import Path

import pytest

from bench.gallery import VIEWS
from laplace_core.cli import document as command_line
from laplace_core.cli import main, verbs
from laplace_core.worlds import parse_world
from tests.test_architecture import exists, is_name

ROOT = Path(__file__).resolve().parent.parent
README = (ROOT / "README.md").read_text(encoding="utf-8")
DOCUMENTS = [
    "README.md",
    "CONTRIBUTING.md",
    "app/static/README.md",
    *sorted(path.relative_to(ROOT).as_posix() for path in (ROOT / "docs").rglob("*.md") if "_api" not in path.parts),
]
"""All but CHANGELOG.md, which names what was."""
WITH_EXAMPLES = ["README.md", *(name for name in DOCUMENTS if name.startswith("docs/"))]
FOLDERS = r"(app|laplace_core|docs|tests|bench|checkpoints)"


def blocks(language: str, text: str = README) -> list[str]:
    return [body for name, body in re.findall(r"^```(\w*)\n(.*?)^```", text, re.M | re.S) if name == language]


def commands() -> list[tuple[str, str]]:
    """Every command line of the documents, with the document, without its comment."""
    found = []
    for document in WITH_EXAMPLES:
        text = (ROOT / document).read_text(encoding="utf-8")
        lines = [line for kind in ("", "console") for body in blocks(kind, text) for line in body.splitlines()]
        matches = [
            re.fullmatch(r"(?:\$ )?python -m laplace_core (?!VERB)(.*?)( > \S+)?( +#.*)?", line) for line in lines
        ]
        found += [(document, match[1]) for match in matches if match]
    return found


def shown_outputs() -> list[tuple[str, str, str]]:
    """Document, words and output of every command whose output a document shows."""
    found = []
    for document in WITH_EXAMPLES:
        text = (ROOT / document).read_text(encoding="utf-8")
        for body in [*blocks("", text), *blocks("console", text)]:
            for command, output in re.findall(r"^\$ python -m laplace_core (.*)\n((?:(?!\$ ).*\n)*)", body, re.M):
                found.append((document, command, output))
    return found


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


def test_outputs_are_shown():
    assert {document for document, _, _ in shown_outputs()} >= {"README.md", "docs/start.md"}


@pytest.mark.parametrize(("document", "command", "output"), shown_outputs())
def test_the_output_in_a_document_is_what_the_command_prints(document, command, output, capsys):
    assert main(shlex.split(command)) == 0
    assert capsys.readouterr().out == output


def test_every_command_of_the_documents_is_one():
    assert len(commands()) > 40
    for document, command in commands():
        options = verbs.parser().parse_args(verbs._joined(shlex.split(command)))
        assert options.verb == command.split()[0], document
        for path in re.findall(r"(?:checkpoints|docs|tests)/\S+", command):
            assert list(ROOT.glob(path)), f"{document}: {path}"


@pytest.mark.parametrize("document", [name for name in WITH_EXAMPLES if blocks("pycon", (ROOT / name).read_text())])
def test_the_python_of_a_document_prints_what_is_shown(document, tmp_path, monkeypatch):
    for name in ("docs", "checkpoints"):
        (tmp_path / name).symlink_to(ROOT / name)
    monkeypatch.chdir(tmp_path)  # where an example may write a file
    names: dict = {}
    for body in blocks("pycon", (ROOT / document).read_text(encoding="utf-8")):
        test = doctest.DocTestParser().get_doctest(body, names, document, document, 0)
        said: list[str] = []
        result = doctest.DocTestRunner().run(test, out=said.append, clear_globs=False)
        assert result.attempted
        assert not result.failed, "".join(said)
        names = test.globs


def test_the_page_of_the_command_line_is_what_the_parser_says():
    written = (ROOT / "docs" / "command-line.md").read_text(encoding="utf-8")
    assert written == command_line.document(), f"write it again: {command_line.COMMAND}"


def test_the_page_of_the_command_line_has_every_option():
    page = command_line.document()
    for name, verb in verbs.parser()._subparsers._group_actions[0].choices.items():
        section = page.split(f"\n## {name}\n")[1].split("\n## ")[0]
        for action in verb._actions:
            for option in [each for each in action.option_strings if each.startswith("--") and each != "--help"]:
                assert f"| `{option}" in section, f"{name} {option}"


def test_the_readme_is_short_and_its_links_lead_somewhere():
    assert len(README.splitlines()) <= 120
    links = re.findall(r"\]\(([^)#]+)\)", README)
    assert len(links) > 10
    for link in links:
        assert (ROOT / link).is_file(), link


def test_every_picture_of_the_gallery_is_a_view_and_is_shown():
    shown = re.findall(r"\(gallery/(\w+)\.png\)", (ROOT / "docs" / "gallery.md").read_text(encoding="utf-8"))
    assert sorted(shown) == sorted(VIEWS)
    assert {path.stem for path in (ROOT / "docs" / "gallery").iterdir()} == set(VIEWS)


@pytest.mark.parametrize("document", DOCUMENTS)
def test_every_module_and_file_that_a_document_names_is_there(document):
    for span in re.findall(r"`([^`]+)`", (ROOT / document).read_text(encoding="utf-8").replace("```", "")):
        if is_name(span):
            assert span == "app.main" or exists(span), span
        elif re.fullmatch(rf"{FOLDERS}/[\w./*-]*", span):
            assert list(ROOT.glob(re.sub("NAME|ALGORITHM|ENVIRONMENT", "*", span).rstrip("/"))), span


def test_the_layout_in_the_architecture_has_every_package():
    architecture = (ROOT / "docs" / "architecture.md").read_text(encoding="utf-8")
    (layout,) = [text for text in blocks("", architecture) if text.startswith("app/")]
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
