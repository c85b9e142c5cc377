"""docs/architecture.md is true to the code: every name in it exists, and packages import each other as it says."""

from __future__ import annotations

import ast
import importlib
import re
import tomllib
from collections.abc import Iterable, Mapping
from functools import cache
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
TEXT = (ROOT / "docs" / "architecture.md").read_text(encoding="utf-8")
SPAN = re.compile(r"`([^`]+)`")
SPANS = sorted(set(SPAN.findall(TEXT)))
SUBJECTS = ("app.worlds", "app.inverse", "app.agents", "app.race", "app.train", "app.paper")
WALKS = {
    "A reward": "laplace_core.",
    "A slider": "app/js/",
    "A training step": "laplace_core.training.",
    "A link": "app.session.",
}
"""What the headings of the walks begin with, and names that each of them leads through."""

Graph = Mapping[str, set[str]]


# --- the names ---


def is_name(span: str) -> bool:
    return re.fullmatch(r"(app|laplace_core)(\.\w+)+", span) is not None


def is_path(span: str) -> bool:
    return re.match(r"(app|laplace_core|docs|tests)/", span) is not None


def exists(name: str) -> bool:
    """Whether a dotted name is a module, something in a module, or a member of a class there, fields included."""
    parts = name.split(".")
    for count in range(len(parts), 0, -1):
        if ".".join(parts[:count]) in modules():
            found = importlib.import_module(".".join(parts[:count]))
            break
    else:
        return False
    for part in parts[count:]:
        if not hasattr(found, part):
            return part == parts[-1] and part in getattr(found, "__dataclass_fields__", ())
        found = getattr(found, part)
    return True


@pytest.mark.parametrize("name", [span for span in SPANS if is_name(span)])
def test_every_name_is_in_the_code(name):
    assert name == "app.main" or exists(name)  # the script of the app is run, and not imported


@pytest.mark.parametrize("path", [span for span in SPANS if is_path(span)])
def test_every_path_is_there(path):
    assert (ROOT / path).exists()


def test_names_that_are_not_there_are_noticed():
    assert exists("laplace_core.study.pipeline.Study.at")
    assert exists("app.session.PageState.chosen")
    for name in ("laplace_core.study.nothing", "laplace_core.study.pipeline.Study.nothing", "laplace_core.learned"):
        assert not exists(name)


def scripts() -> list[tuple[str, str]]:
    """Every function of JavaScript that the document names, and the file that it is said to be in."""
    return re.findall(r"`(\w+)`\s+in\s+`(app/js/[\w/]+\.js)`", TEXT)


def test_every_function_of_the_browser_is_exported():
    assert len(scripts()) >= 5
    for name, path in scripts():
        assert re.search(rf"^export (const|function|async function) {name}\b", (ROOT / path).read_text(), re.M), name


@pytest.mark.parametrize("heading", WALKS)
def test_a_walk_takes_some_ten_steps_and_names_where_it_leads(heading):
    (body,) = re.findall(rf"^## {heading}.*?$(.*?)(?=^## |\Z)", TEXT, re.M | re.S)
    steps = re.findall(r"^(\d+)\. (.*?)(?=^\d+\. |^$|\Z)", body, re.M | re.S)
    assert [int(number) for number, _ in steps] == list(range(1, len(steps) + 1))
    assert 8 <= len(steps) <= 12
    assert WALKS[heading] in body
    for _, words in steps:
        assert any(is_name(span) or is_path(span) for span in SPAN.findall(words))


# --- the imports ---


@cache
def modules() -> dict[str, Path]:
    """Every module of both packages, by its name."""
    found = {}
    for package in ("app", "laplace_core"):
        for path in (ROOT / package).rglob("*.py"):
            name = ".".join(path.relative_to(ROOT).with_suffix("").parts)
            found[name.removesuffix(".__init__")] = path
    return found


@cache
def imports() -> dict[str, set[str]]:
    """The modules of both packages that each module imports, at its top or within a function."""
    return {name: imported(path.read_text(encoding="utf-8")) - {name} for name, path in modules().items()}


def imported(source: str) -> set[str]:
    """The modules of both packages that a text of Python imports."""
    names: set[str] = set()
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Import):
            names |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, "imports are absolute here"
            within = {f"{node.module}.{alias.name}" for alias in node.names}
            names |= within & set(modules())
            if not within <= set(modules()):  # something in the module itself
                names.add(str(node.module))
    return names & set(modules())


def package_of(module: str) -> str:
    """``laplace_core.study`` for ``laplace_core.study.pipeline``."""
    return ".".join(module.split(".")[:2])


def among_packages(graph: Graph) -> dict[str, set[str]]:
    found: dict[str, set[str]] = {}
    for name, others in graph.items():
        package = package_of(name)
        found.setdefault(package, set()).update(package_of(other) for other in others if package_of(other) != package)
    return found


def circle(graph: Graph) -> list[str]:
    """A way through the graph that ends where it began; empty if there is none."""
    done: set[str] = set()

    def walk(at: str, way: list[str]) -> list[str]:
        if at in way:
            return [*way[way.index(at) :], at]
        if at in done:
            return []
        for other in sorted(graph.get(at, ())):
            found = walk(other, [*way, at])
            if found:
                return found
        done.add(at)
        return []

    return next((found for start in sorted(graph) if (found := walk(start, []))), [])


def test_a_circle_is_noticed():
    assert circle({"a": {"b"}, "b": {"c"}, "c": set()}) == []
    assert circle({"a": {"b"}, "b": {"c"}, "c": {"b"}}) == ["b", "c", "b"]


def test_imports_within_functions_count():
    assert imported("def f():\n    from laplace_core.study import pipeline\n    import app.session.store") == {
        "laplace_core.study.pipeline",
        "app.session.store",
    }
    assert imported("from laplace_core.study.pipeline import study") == {"laplace_core.study.pipeline"}


def test_no_modules_import_each_other_in_a_circle():
    assert circle(imports()) == []


def test_no_packages_import_each_other_in_a_circle():
    assert circle(among_packages(imports())) == []


def test_no_subject_imports_another():
    wrong = [
        (name, other)
        for name, others in imports().items()
        for other in others
        if package_of(name) in SUBJECTS and package_of(other) in SUBJECTS and package_of(name) != package_of(other)
    ]
    assert wrong == []


def rows(package: str) -> list[str]:
    """The packages in the table of the document, from the top to the bottom."""
    return re.findall(rf"^\| `({package}\.\w+)` \|", TEXT, re.M)


def contract(layer: str) -> list[str]:
    """All of the layers of the contract in pyproject.toml that has this one."""
    contracts = tomllib.loads((ROOT / "pyproject.toml").read_text())["tool"]["importlinter"]["contracts"]
    (layers,) = [each["layers"] for each in contracts if layer in each.get("layers", ())]
    return [name for layer in layers for name in re.split(r"\s*[:|]\s*", layer)]


@pytest.mark.parametrize("package", ["app", "laplace_core"])
def test_every_package_has_a_row_and_imports_only_those_below_it(package):
    listed = rows(package)
    there = {name for name in map(package_of, modules()) if name.startswith(f"{package}.")}
    assert set(listed) == there - {"laplace_core.__main__"}
    for name, others in among_packages(imports()).items():
        for other in others & set(listed):
            if name in listed:
                assert listed.index(name) < listed.index(other), f"{name} imports {other}"


@pytest.mark.parametrize(("package", "layer"), [("app", "app.screens"), ("laplace_core", "laplace_core.cli")])
def test_the_tables_are_in_the_order_of_the_contracts(package, layer):
    assert rows(package) == [name for name in contract(layer) if name.startswith(f"{package}.")]


def scripts_imported() -> dict[str, set[str]]:
    """The modules of the browser that each of them imports, by their paths."""
    found = {}
    for path in (ROOT / "app" / "js").rglob("*.js"):
        others: Iterable[str] = re.findall(r"^import [^;]*?from '(\.[^']+)'", path.read_text(), re.M)
        found[str(path)] = {str((path.parent / other).resolve()) for other in others}
    return found


def test_no_modules_of_the_browser_import_each_other_in_a_circle():
    graph = scripts_imported()
    assert sum(map(len, graph.values())) > 50
    assert all(Path(other).is_file() for others in graph.values() for other in others)
    assert circle(graph) == []
