"""``docs/command-line.md``: every verb with its arguments and options, from the parser itself.

``python -m laplace_core.cli.document > docs/command-line.md`` writes it.
"""

from __future__ import annotations

import argparse
import re
from collections.abc import Iterator

from laplace_core.cli import verbs

COMMAND = "python -m laplace_core.cli.document > docs/command-line.md"
_LEFT_OUT = (argparse._SubParsersAction, argparse._HelpAction)
_OPENING = f"""# Command line

Every command has the form `python -m laplace_core VERB ...`; an installed package also has the command `laplace VERB
...`. A command ends with exit status 0. After bad input it prints one sentence and ends with exit status 2. `VERB
--help` prints the same options as this page. This page is written from the program by

```
{COMMAND}
```
"""


def document() -> str:
    """The page as Markdown: a table of the verbs, then a section for each."""
    parser = verbs.parser()
    listed = list(_verbs(parser))
    rows = [f"| [`{name}`](#{name}) | {_text(words)} |" for name, words, _ in listed]
    table = "\n".join(["| verb | what it does |", "|---|---|", *rows])
    return "\n\n".join([_OPENING + "\n" + table, *(_section(name, words, verb) for name, words, verb in listed)]) + "\n"


def _verbs(parser: argparse.ArgumentParser) -> Iterator[tuple[str, str, argparse.ArgumentParser]]:
    """Name, help and parser of every verb of a parser, in their order."""
    for action in parser._actions:
        if isinstance(action, argparse._SubParsersAction):
            for choice in action._choices_actions:
                yield choice.dest, choice.help or "", action.choices[choice.dest]


def _section(name: str, words: str, parser: argparse.ArgumentParser, level: int = 2) -> str:
    inner = list(_verbs(parser))
    shown = [each for each in parser._actions if not isinstance(each, _LEFT_OUT)]
    described = parser.description or f"{words[:1].upper()}{words[1:]}."
    parts = [f"{'#' * level} {name}", _text(described), f"```\n{_usage(name, parser, shown)}\n```"]
    if shown:
        rows = [f"| `{_head(each)}` | {_text((each.help or '').replace('%%', '%'))} |" for each in shown]
        parts.append("\n".join(["| argument or option | meaning |", "|---|---|", *rows]))
    parts += [_section(f"{name} {each}", words, verb, level + 1) for each, words, verb in inner]
    return "\n\n".join(parts)


def _usage(name: str, parser: argparse.ArgumentParser, shown: list[argparse.Action]) -> str:
    """One line: the verb, what must be given, and whether there are options; or the lines that the parser states."""
    if parser.usage:
        return "\n".join(line.strip() for line in parser.usage.splitlines())
    given = [_head(each) for each in shown if each.required and each.option_strings]
    named = [f"[{_head(each)}]" if each.nargs == "?" else _head(each) for each in shown if not each.option_strings]
    options = ["[options]"] if any(each.option_strings and not each.required for each in shown) else []
    below = ["EXPERIMENT ..."] if any(_verbs(parser)) else []
    return " ".join(["laplace", name, *given, *named, *below, *options])


def _head(action: argparse.Action) -> str:
    """The name of an argument, or an option with what it takes."""
    takes = action.metavar or action.dest.upper()
    if not action.option_strings:
        return f"{takes} ..." if action.nargs == "+" else f"{takes}"
    return action.option_strings[-1] if action.nargs in (0, "?") else f"{action.option_strings[-1]} {takes}"


def _text(words: str) -> str:
    """A sentence of the parser as a cell of a table shows it: no mark of Markdown means anything."""
    return re.sub(r"([\\|*<>$`\[\]{}])", r"\\\1", words)


if __name__ == "__main__":
    print(document(), end="")
