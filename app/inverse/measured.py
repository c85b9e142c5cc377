"""Noise measured over the seeds of a learner, which learn in the background; the page shows the first one."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import replace
from typing import Any

import streamlit as st

from app.components.waiting import attempt, offer, progress
from app.components.widgets import field
from app.session.jobs import Wish, learners
from laplace_core import InputError, World
from laplace_core.exchange.links import Values, by_name
from laplace_core.parameters import Parameter
from laplace_core.study.settings import ResolvedForWorld
from laplace_core.subjects import Exact, Subject, about, learner
from laplace_core.supervise.jobs import Kind
from laplace_core.tabular import LEARN_SCHEMA, Learned, LearnSettings, noise_settings, resolve_learning
from laplace_core.tabular.settings import DECIDED_NAMES, ResolvedLearning
from laplace_core.tabular.work import MOST_KEPT, Work, learning

PARAMETERS = by_name(
    Parameter("measured", False, help="Look at a learned gamma-space, with the spread over seeds as its noise."),
    Parameter("seeds", 4, 2, 8, "Independent learners; the page shows the first one."),
    by_name(*LEARN_SCHEMA)["episodes"],
)
_learners: Kind[Work] = Kind("learners of the inverse", MOST_KEPT, line=learners)


def _wanted(values: Values, world: World, settings: ResolvedForWorld) -> ResolvedLearning:
    """The settings of the learners of a view: with its discounts and its target policy."""
    given: dict[str, Any] = {name: getattr(settings, name) for name in DECIDED_NAMES}
    given |= {"seeds": values.get("seeds", PARAMETERS["seeds"].default), "episodes": values.get("episodes")}
    return resolve_learning(LearnSettings(**given), world)


def seen(values: Values, world: World, settings: ResolvedForWorld) -> tuple[Subject, ResolvedForWorld]:
    """The first learner with the noise measured over all of them; until they have learned, the exact world."""
    settings = replace(settings, noise=0.0, noise_level=values.get("noise_level"))
    key = learning(world, _wanted(values, world, settings), slot="noise").key
    job = _learners.get(key)
    found = job.result().learned() if job is not None and job.worked else None
    if found is None:  # it may have had to make room
        _learners.drop(key)
        return Exact(world), settings
    if settings.noise_level is None:  # else a given level holds
        with suppress(InputError):  # the sidebar says that they show none
            settings = replace(settings, **noise_settings(found, settings))
    return learner(world, about(found, world), 0), settings


def controls(values: Values, world: World, settings: ResolvedForWorld) -> bool:
    """The controls of measured noise: on or off, the learners, and their progress."""
    field(PARAMETERS["measured"], PARAMETERS["measured"].default, "Measure noise from a learner's seeds")
    if not values.get("measured"):
        return False
    wanted = _wanted(values, world, settings)
    left, right = st.columns(2)
    field(PARAMETERS["seeds"], wanted.seeds, "Learners", place=left)
    field(PARAMETERS["episodes"], wanted.episodes, "Episodes", place=right)
    wish = Wish.of(_learners, learning(world, wanted, slot="noise"))
    job = wish.look()
    if job is None:
        offer(wish, "Learn", key="learn_noise", words="Until then, the pictures use the exact gamma-space.")
    elif job.going:
        progress(job, "{done:,} of {of:,} episodes", wish.cancel, key="cancel_noise")
    else:
        work = attempt(job.result)
        found = None if work is None else work.learned()
        if found is not None:
            _say(found, settings)
    return True


def _say(found: Learned, settings: ResolvedForWorld) -> None:
    try:
        levels = noise_settings(found, settings)
    except InputError as error:
        st.info(str(error))
    else:
        st.caption(f"Measured noise {levels['noise_level']:.2g} on average, over {len(found.basis)} seeds.")
