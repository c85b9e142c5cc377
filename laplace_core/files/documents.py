"""The pages of ``docs/`` as Markdown that needs no Sphinx: includes are replaced by their text, pictures are parts.

``docs/index.md`` lists the pages, in their order; ``make docs`` builds HTML of the same files.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

FOLDER = Path(__file__).resolve().parents[2] / "docs"
"""Where the pages are; a package that is installed without its documents has none."""
BUILT = "*`make docs` builds this part from the code.*"
"""The text in place of a part that only Sphinx can make."""
_DIRECTIVE = re.compile(r"^```\{([\w-]+)\} ?(.*)\n((?:.*\n)*?)```$", re.M)
_PICTURE = re.compile(r"^!\[([^]]*)\]\(([^)\s]+)\)$", re.M)
_LINK = re.compile(r"\]\(([\w./-]+)\.md(#[\w-]*)?\)")


@dataclass(frozen=True)
class Picture:
    """A picture of a page.

    Attributes:
        path: an existing file.
        words: what it shows.
    """

    path: Path
    words: str


def titles(folder: Path = FOLDER) -> dict[str, str]:
    """The title of every page by its name, such as ``guides/world``, in the order of ``index.md``."""
    index = folder / "index.md"
    if not index.is_file():
        return {}
    trees = (body for kind, _, body in _DIRECTIVE.findall(index.read_text(encoding="utf-8")) if kind == "toctree")
    names = [line for body in trees for line in body.split("\n") if line and not line.startswith(":")]
    return {name: _text(folder / f"{name}.md").split("\n", 1)[0].removeprefix("# ") for name in names}


def parts(name: str, address: str, folder: Path = FOLDER) -> Iterator[str | Picture]:
    """The page as texts and pictures, in their order.

    Args:
        name: one of :func:`titles`.
        address: what a link to another page begins with; the page's name follows.
    """
    path = folder / f"{name}.md"
    text = _LINK.sub(lambda link: f"]({address}{_target(path, link[1], folder)}{link[2] or ''})", _text(path))
    words = _PICTURE.split(text)
    for i in range(0, len(words), 3):
        if words[i].strip():
            yield words[i].strip()
        if i + 1 < len(words):
            yield Picture((path.parent / words[i + 2]).resolve(), words[i + 1])


def _text(path: Path) -> str:
    """A file's Markdown, in which directives of Sphinx are replaced."""

    def replaced(found: re.Match[str]) -> str:
        kind, target = found[1], found[2].strip()
        if kind == "include":
            return _text(path.parent / target).strip()
        if kind == "literalinclude":
            return f"```\n{(path.parent / target).read_text(encoding='utf-8').strip()}\n```"
        return "" if kind == "toctree" else BUILT

    return _DIRECTIVE.sub(replaced, path.read_text(encoding="utf-8"))


def _target(page: Path, link: str, folder: Path) -> str:
    """The name of the page that a link of another page leads to."""
    return (page.parent / f"{link}.md").resolve().relative_to(folder.resolve()).with_suffix("").as_posix()
