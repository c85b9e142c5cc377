"""The parameters that a link of the page Inverse may hold."""

from __future__ import annotations

from app.inverse import measured, memory, studies, subjects
from laplace_core import InputError
from laplace_core.exchange.links import Check, Entries, Schema, Values, by_name, check_of
from laplace_core.experiments.inverse.measuring import PARAMETERS, plan_of
from laplace_core.parameters import Parameter
from laplace_core.payloads.link import ACTION, PARAM, check_reached
from laplace_core.study.pipeline import grids
from laplace_core.study.settings import ResolvedForWorld
from laplace_core.worlds import parameters_of

SUBJECT = (
    Parameter("world", None, help="The world that the page shows.", kind=str),
    Parameter("agent", None, help="The trained agent whose start state the page shows.", kind=str),
    Parameter("data", None, help="Your own gamma-space, named by the digest of its file.", kind=str),
)


def _world_is_listed(name: str) -> None:
    if name not in subjects.WORLDS:
        raise InputError(f"The link asks for an unknown world, {name[:40]!r}; the opening view is shown instead.")


def _of_world(values: Values) -> dict[str, Parameter]:
    known = values.get("world") if subjects.kind_of(values) == "world" else None
    return by_name(*parameters_of(str(known))) if known else {}


def _is_one_of(name: str) -> Check:
    def test(values: Values) -> None:
        world = subjects.world_of(values)
        if world is not None and name in values:
            members = world.states if name == "state" else world.actions
            if values[name] not in members:
                raise InputError(f"{name} {str(values[name])[:40]!r} is not in {world.name}.")

    return Check(test, drops=(name,))


def _grids_fit(values: Values) -> None:
    settings = subjects.view_of(values).settings
    if isinstance(settings, ResolvedForWorld):
        grids(settings)


def _is_a_study(values: Values) -> None:
    plan_of(studies.given(values))


def _is_reached(values: Values) -> None:
    if "horizon" in values:
        check_reached("horizon", values, subjects.view_of(values).settings)


LINK = Schema(
    opening=lambda: subjects.OPENING,
    assumed=lambda: {},
    steps=(
        Entries(by_name(*SUBJECT)),
        check_of("world", _world_is_listed, lead=""),
        Entries(_of_world, PARAM, owner=lambda values: str(values.get("world", "this subject"))),
        Entries({**subjects.parameters(), **measured.PARAMETERS, **by_name(ACTION, subjects.AXIS)}),
        Entries(by_name(*memory.PARAMETERS), prefix=memory.EDIT),
        Entries(by_name(*PARAMETERS), prefix=studies.STUDY),
        Check(subjects.world_of, drops=(f"{PARAM}*",)),
        _is_one_of("state"),
        _is_one_of("action"),
        Check(_grids_fit, drops=("gamma*", "theta*", "spacing")),
        Check(_is_a_study, drops=(f"{studies.STUDY}*",)),
        Check(_is_reached, drops=("horizon",)),
        Check(subjects.view_of, lead=""),
    ),
)
