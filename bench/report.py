"""A measured figure beside its goal, as text and as JSON."""

from __future__ import annotations

import operator
from dataclasses import dataclass

from bench.timing import Spread

_RELATIONS = {"<": operator.lt, "<=": operator.le, ">=": operator.ge}


@dataclass(frozen=True)
class Goal:
    """A bound on the median, in the unit of the figure that it stands beside."""

    relation: str
    bound: float

    def met(self, value: float) -> bool:
        return _RELATIONS[self.relation](value, self.bound)


@dataclass(frozen=True)
class Figure:
    """One measured quantity.

    Attributes:
        subject: the heading that it stands under.
        unit: ``x`` for a ratio, ``s``, ``ms``, ``MB``, or nothing.
        sizes: of the arrays or the world that were measured.
        note: what was done, where the name alone would not say it.
    """

    subject: str
    name: str
    value: Spread
    unit: str
    sizes: str
    goal: Goal | None = None
    note: str = ""

    @property
    def met(self) -> bool | None:
        """Whether the median reaches the goal; None without one."""
        return None if self.goal is None else self.goal.met(self.value.median)

    def text(self) -> str:
        v = self.value
        line = f"{number(v.median)} {self.unit}".rstrip()
        line += f", quartiles {number(v.low)} to {number(v.high)}, n = {v.samples}"
        if self.goal is not None:
            bound = f"{self.goal.bound:g} {self.unit}".rstrip()
            line += f"   goal {self.goal.relation} {bound}: {'met' if self.met else 'NOT met'}"
        lines = [f"  {self.name}", f"    {line}", f"    {self.sizes}"]
        return "\n".join(lines + ([f"    {self.note}"] if self.note else []))

    def as_json(self) -> dict[str, object]:
        goal = None if self.goal is None else {"relation": self.goal.relation, "bound": self.goal.bound}
        return {**vars(self), "value": self.value._asdict(), "goal": goal, "met": self.met}


def number(value: float) -> str:
    """Three significant digits, and never an exponent above a hundred."""
    return f"{value:,.0f}" if abs(value) >= 100 else f"{value:#.3g}"


def tally(figures: list[Figure]) -> str:
    """The last line: how many goals were met, and which were not."""
    missed = [figure.name for figure in figures if figure.met is False]
    with_goal = [figure for figure in figures if figure.goal is not None]
    line = f"{len(with_goal) - len(missed)} of {len(with_goal)} goals met"
    return line + (f"; NOT met: {'; '.join(missed)}" if missed else "")
