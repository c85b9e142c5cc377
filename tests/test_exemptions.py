"""Where a line or a file is exempt from a check of the linter or of the types, it says why."""

from __future__ import annotations

import io
import re
import tokenize
import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
FILES = sorted(path for name in ("laplace_core", "app", "bench", "tests") for path in (ROOT / name).rglob("*.py"))
MARK = re.compile(r"# (?:noqa: [A-Z]+\d+(?:, [A-Z]+\d+)*|type: ignore\[[a-z, -]+\])")
"""An exemption that names what it is from."""


def unexplained(text: str) -> list[int]:
    """Lines whose exemption or cast has no reason: at least two words behind it, or a comment on the line above."""
    lines, marked, reasons = text.splitlines(), set(), set()
    before = tokenize.TokenInfo(tokenize.NL, "", (0, 0), (0, 0), "")
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type == tokenize.COMMENT:
            rest = MARK.sub("", token.string).strip(" #-")
            if re.search(r"#\s*(noqa|type:\s*ignore)", token.string):
                marked.add(token.start[0])
                rest = "" if re.search(r"noqa|type:", rest) else rest
            if len(rest.split()) >= 2:
                reasons.add(token.start[0])
        if token.string == "(" and before.string == "cast":
            marked.add(token.start[0])
        before = token
    above = {line for line in marked if line - 1 in reasons and lines[line - 2].lstrip().startswith("#")}
    return sorted(marked - reasons - above)


def test_an_exemption_without_a_reason_is_noticed(subtests):
    for text, lines in [
        ("a = 1  # noqa: E731\n", [1]),
        ("a = 1  # noqa\n", [1]),
        ("a = 1  # noqa - for a reason\n", [1]),
        ("a = 1  # noqa: E731 - the shortest way\n", []),
        ("a = 1  # type: ignore[override]  # it prepares nothing\n", []),
        ("a = 1  # type: ignore\n", [1]),
        ("# The shortest way.\na = 1  # noqa: E731\n", []),
        ("b = 2  # of no concern\na = 1  # noqa: E731\n", [2]),
        ("a = cast(int, b)\n", [1]),
        ("a = cast(int, b)  # json knows no types\n", []),
        ("a = '# noqa'\n", []),
    ]:
        with subtests.test(text=text, lines=lines):
            assert unexplained(text) == lines


def test_every_exemption_has_its_reason():
    missing = {str(path.relative_to(ROOT)): unexplained(path.read_text(encoding="utf-8")) for path in FILES}
    assert {name: lines for name, lines in missing.items() if lines} == {}


def test_every_file_that_is_exempt_exists():
    exempt = tomllib.loads((ROOT / "pyproject.toml").read_text())["tool"]["ruff"]["lint"]["per-file-ignores"]
    for pattern in exempt:
        for single in alternatives(pattern):
            assert list(ROOT.glob(single)), single


def alternatives(pattern: str) -> list[str]:
    """A pattern with braces as several without."""
    braces = re.search(r"\{([^}]*)\}", pattern)
    if braces is None:
        return [pattern]
    return [pattern[: braces.start()] + one + pattern[braces.end() :] for one in braces[1].split(",")]
