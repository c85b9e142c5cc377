"""The pictures of runs: the one that is shown, those drawn with it, and its discounts."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape

import streamlit as st

from app.catalogue import checkpoints, training_runs
from app.components.chart import chart
from app.session import store
from app.session.typed import in_markdown
from app.train.schema import MOST_AT_ONCE, NOTHING, names_in
from app.view.explain import TRAINING, explain
from laplace_core.agents.settings import SETTINGS, algorithm_title
from laplace_core.figures import training as figures
from laplace_core.figures.theme import ACTION_COLOURS, action_colour
from laplace_core.figures.training import TALL, Band, Line
from laplace_core.training.queue import Run
from laplace_core.training.words import family, label, settings_of
from laplace_core.worlds.titles import world_title

_MOST_OFFERED = 24


def looked_at(runs: Sequence[Run]) -> Run | None:
    """The run that was chosen, else the newest that can be read."""
    readable = [run for run in runs if run.settings is not None]
    named = [run for run in readable if run.name == store.chosen().get("run")]
    return next(iter(named or readable), None)


def colour_of(runs: Sequence[Run], run: Run) -> str:
    return action_colour([other.name for other in family(runs, run)].index(run.name))


def shipped_colour(algorithm: str) -> str:
    """The colour of a bundled agent, counted from the end; runs take theirs from the beginning."""
    return action_colour(len(ACTION_COLOURS) - 1 - list(SETTINGS).index(algorithm))


def pictures(runs: Sequence[Run], run: Run) -> None:
    same = family(runs, run)
    drawn, bands = _beside(same, run)
    settings = settings_of(run)
    gammas = settings.discounts()
    row = st.container(key="run_pictures")  # its height is kept free while a browser still loads what draws
    places = row.columns([1.35, *[1] * min(2, len(gammas))], gap="small")
    lines = [Line(label(one), colour_of(runs, one), training_runs.curves(one)) for one in drawn]
    with places[0]:
        steps = max(settings_of(one).steps for one in drawn)
        figure = figures.learning_curves(f"{world_title(settings.environment)}: return", lines, steps, bands)
        alt = f"Return over steps of {len(drawn)} runs: while training, and in evaluation with standard errors."
        chart(figure, "training", alt, TALL, revision=f"{settings.environment} {steps}")
    if not gammas.size:
        return
    mine = training_runs.curves(run)
    first = min(settings.evaluate_every, settings.steps)
    with places[1]:
        alt = f"How far the values of {label(run)} at the start are from observed returns, a line for each discount."
        figure = figures.discount_errors(mine, gammas, settings.steps, first)
        chart(figure, "discounts", alt, TALL, revision=run.name)
    if len(gammas) == 1:
        return
    with places[2]:
        alt = f"Predicted and observed discounted return of {label(run)} from the start, over the discounts."
        figure = figures.values_by_discount(mine, gammas, colour_of(runs, run), first)
        chart(figure, "value at the start", alt, TALL, revision=run.name)


def shipped(environment: str) -> None:
    """The curves of bundled agents for an environment on which nothing has been trained yet, if there are any."""
    bands = [
        Band.of(f"{algorithm_title(algorithm)}, {len(curves)} seeds", action_colour(i), curves)
        for i, (algorithm, curves) in enumerate(checkpoints.shipped_curves(environment).items())
    ]
    if not bands:
        return
    title = world_title(environment)
    alt = f"Evaluations over the steps of training of the bundled agents for {title}: {len(bands)} algorithms."
    chart(figures.shipped_curves(f"{title}: bundled agents", bands), "shipped", alt, TALL, revision=environment)
    st.caption("Lines: median of the seeds. Shading: lowest to highest seed. Your own runs are drawn on top.")


def _beside(same: Sequence[Run], run: Run) -> tuple[list[Run], list[Band]]:
    """What is drawn: runs that were picked, by default the newest, and the one that is looked at always; and agents
    that ship, by default those of its algorithm."""
    settings = settings_of(run)
    others = [one.name for one in same if one.name != run.name]
    names, curves = _picked_runs(others), checkpoints.shipped_curves(settings.environment)
    picked = store.chosen().get("ships")
    ships = [settings.ALGORITHM] if picked is None else names_in(picked)
    ships = [algorithm for algorithm in curves if algorithm in ships]
    left, right, words = st.columns([2.5, 2.5, 1], vertical_alignment="center")
    if others:
        titles = {one.name: label(one) for one in same}
        options = [name for name in others if name in others[-_MOST_OFFERED:] or name in names]
        left.pills(
            f"Beside {in_markdown(label(run))}", options, selection_mode="multi", key=store.put("beside", names),
            format_func=lambda name: in_markdown(titles.get(name, name)), on_change=_pick, args=("beside",),
        )  # fmt: skip
    else:
        left.html(f'<h2 class="panel-title">{escape(label(run))}</h2>')
    if curves:
        right.pills(
            "Bundled agents", list(curves), selection_mode="multi", key=store.put("ships", ships),
            format_func=algorithm_title, on_change=_pick, args=("ships",),
        )  # fmt: skip
    explain(words, TRAINING)
    bands = [
        Band.of(f"shipped {algorithm_title(algorithm)}, {len(curves[algorithm])} seeds", shipped_colour(algorithm),
                curves[algorithm])
        for algorithm in ships
    ]  # fmt: skip
    return [one for one in same if one.name == run.name or one.name in names], bands


def _picked_runs(others: Sequence[str]) -> list[str]:
    picked = store.chosen().get("beside")
    return (
        list(others[-MOST_AT_ONCE + 1 :]) if picked is None else [name for name in names_in(picked) if name in others]
    )


def _pick(name: str) -> None:
    """Callback: keep the choice of runs; no run at all is also a choice."""
    store.choose(name, ",".join(st.session_state[name][: MOST_AT_ONCE - 1]) or NOTHING)
