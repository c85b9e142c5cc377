"""What an artefact and a remedy are, and from where on an artefact is worth a word."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

from laplace_core.settings import Settings

VISIBLE = 0.05
"""The one level above which an artefact is listed: probability in a row, or the share of a value or of a spacing
that the artefact's size names."""


@dataclass(frozen=True)
class Remedy:
    """A change of settings, by field; ``param:NAME`` is a parameter of the world."""

    label: str
    changes: Mapping[str, object]

    @property
    def changes_world(self) -> bool:
        return any(name.startswith("param:") for name in self.changes)

    def apply(self, settings: Settings) -> Settings:
        fields = {name: value for name, value in self.changes.items() if not name.startswith("param:")}
        params = dict(settings.params)
        params |= {name.removeprefix("param:"): v for name, v in self.changes.items() if name.startswith("param:")}
        return replace(settings, params=tuple(params.items()), **fields)


@dataclass(frozen=True)
class Artefact:
    """One thing in the picture that is not in the world.

    Attributes:
        size: the measure, in the unit that ``shown`` names.
        shown: the measure in words, with its unit.
        sentence: what it does to the picture and why.
        remedies: changes that remove it, the first one the usual choice.
    """

    name: str
    size: float
    shown: str
    sentence: str
    remedies: tuple[Remedy, ...]
