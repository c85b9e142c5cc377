"""Artefacts and remedies, and the size from which an artefact is listed."""

from __future__ import annotations

from dataclasses import dataclass

from laplace_core.study.trials import Remedy

__all__ = ["VISIBLE", "Artefact", "Remedy"]

VISIBLE = 0.05
"""The one level above which an artefact is listed: probability in a row, or the share of a value or of a spacing
that the artefact's size names."""


@dataclass(frozen=True)
class Artefact:
    """One feature of the picture that is not in the world.

    Attributes:
        size: the measure, in the unit that ``shown`` names.
        shown: the measure in words, with its unit.
        sentence: what it does to the picture and why.
        remedies: changes that may remove it, the first one the usual choice; :mod:`laplace_core.study.artefacts.offers`
            keeps those that do.
    """

    name: str
    size: float
    shown: str
    sentence: str
    remedies: tuple[Remedy, ...]
