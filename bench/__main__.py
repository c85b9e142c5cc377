"""``python -m bench [--only core|training|agents|browser] [--json FILE]``: print every figure beside its goal.

A part is a module of this package whose ``main()`` yields :class:`bench.report.Figure`, or prints for itself and
returns its samples by name.
"""

from __future__ import annotations

import argparse
import json
from collections.abc import Iterable, Mapping, Sequence
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path

from bench.machine import line, machine
from bench.report import Figure, tally

PARTS = ("core", "training", "agents", "browser")


def main() -> None:
    parser = argparse.ArgumentParser(prog="python -m bench", description="Costs of the library, each beside its goal.")
    parser.add_argument("--only", choices=PARTS, help="run one part")
    parser.add_argument("--json", metavar="FILE", type=Path, help="write the figures here as well")
    options = parser.parse_args()
    parts = [part for part in PARTS if options.only in (None, part) and find_spec(_module(part))]
    if not parts:
        parser.error(f"there is no {options.only} part")
    if options.json is not None and not options.json.parent.is_dir():
        parser.error(f"there is no folder {options.json.parent}")

    facts = machine()
    print(line(facts))
    print("medians over interleaved repetitions; goals are for the median")
    figures: list[Figure] = []
    samples: dict[str, Sequence[float]] = {}
    for part in parts:
        found = import_module(_module(part)).main()
        if isinstance(found, Mapping):
            samples |= found
        else:
            figures += show(found)
    if figures:
        print(f"\n{tally(figures)}")
    if options.json is not None:
        written = {"machine": facts, "figures": [figure.as_json() for figure in figures], "samples": samples}
        options.json.write_text(json.dumps(written, indent=1) + "\n")


def _module(part: str) -> str:
    return "bench.agents_page" if part == "agents" else f"bench.{part}"


def show(figures: Iterable[Figure]) -> list[Figure]:
    """Print figures as they come, under their subjects."""
    shown: list[Figure] = []
    for figure in figures:
        if not shown or shown[-1].subject != figure.subject:
            print(f"\n{figure.subject}")
        print(figure.text(), flush=True)
        shown.append(figure)
    return shown


if __name__ == "__main__":
    main()
