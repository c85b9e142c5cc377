"""Every figure of the library, one subject after the other."""

from __future__ import annotations

from collections.abc import Iterator

from bench import decoding, growth, importing, inverting, learning, solving
from bench.report import Figure


def main() -> Iterator[Figure]:
    for subject in (decoding, inverting, solving, learning, growth, importing):
        yield from subject.figures()
