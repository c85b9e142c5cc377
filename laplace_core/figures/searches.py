"""Figures of a search, made by Optuna from its kept result: its course, what matters, and each setting by itself."""

from __future__ import annotations

import warnings
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from laplace_core.figures.theme import ACTION_COLOURS, Figure, Trace, axis, build, in_plotly
from laplace_core.parameters import NUMBER

if TYPE_CHECKING:
    import optuna

LEAST_FOR_IMPORTANCES = 10
"""Trials below which importances say nothing."""
_SLICES = 4
"""Settings that are drawn by themselves, the most important ones."""


def study_of(search: Mapping[str, Any]) -> optuna.Study:
    """A search as a study in memory: a trial for each row, whose values are those of all varied settings.

    Args:
        search: as :func:`laplace_core.experiments.search.results.read` gives it; of any version.
    """
    import optuna

    optuna.logging.set_verbosity(optuna.logging.ERROR)
    rows, ranges = search["trials"], search.get("space", {})
    names = list(dict.fromkeys(name for row in rows for name in row["trial"]))
    values = [{name: _typed(row["trial"].get(name, search["settings"].get(name))) for name in names} for row in rows]
    kinds = {name: _distribution(ranges.get(name, ""), [each[name] for each in values]) for name in names}
    study = optuna.create_study(direction="maximize")
    for row, params in zip(rows, values, strict=True):
        pruned = bool(row.get("pruned"))
        study.add_trial(
            optuna.create_trial(
                state=optuna.trial.TrialState.PRUNED if pruned else optuna.trial.TrialState.COMPLETE,
                value=None if pruned else row["median"],
                params=params,
                distributions=kinds,
                intermediate_values={int(step): value for step, value in row.get("reported", {}).items()},
            )
        )
    return study


def _typed(value: Any) -> Any:
    """Files of version 0.2 hold all values as text."""
    if not isinstance(value, str) or NUMBER.fullmatch(value) is None:
        return {"true": True, "false": False}.get(value, value) if isinstance(value, str) else value
    return int(value) if value.isdigit() else float(value)


def _distribution(text: str, values: Sequence[Any]) -> optuna.distributions.BaseDistribution:
    from optuna.distributions import CategoricalDistribution, FloatDistribution, IntDistribution

    if ".." not in text:  # a list: whole numbers and others are one kind of value
        return CategoricalDistribution(list(dict.fromkeys(sorted(values, key=lambda value: (str(type(value)), value)))))
    log = text.endswith(":log")
    if all(isinstance(value, int) for value in values):
        return IntDistribution(min(values), max(values), log=log)
    return FloatDistribution(min(values), max(values), log=log)


def history(study: optuna.Study) -> Figure:
    """The score of every trial, and the best so far."""
    made = _made("plot_optimization_history", study, target_name="median score")
    for trace, colour in zip(made["data"], ACTION_COLOURS, strict=False):
        trace["marker"] = {"color": colour, "size": 7}
        trace["line"] = {"color": colour}
    drawn = [trace for trace in made["data"] if len(trace["x"])]
    return build("Trials in their order", drawn, xaxis=axis("trial"), yaxis=axis("median score"))


def importances(study: optuna.Study) -> Figure | None:
    """The share of the variance between trials that each setting explains; None if there are too few trials.

    By PED-ANOVA (Watanabe et al., IJCAI 2023), Optuna's own measure.
    """
    complete = [trial for trial in study.trials if trial.value is not None]
    if len(complete) < LEAST_FOR_IMPORTANCES or len({trial.value for trial in complete}) < 2:
        return None
    (bars,) = _made("plot_param_importances", study)["data"]
    bars |= {"marker": {"color": ACTION_COLOURS[0]}, "textposition": "auto", "textangle": 0}
    return build("Importance of each setting", [bars], {"l": 130}, xaxis=axis("share"), yaxis=axis(), showlegend=False)


def slices(study: optuna.Study) -> Figure:
    """The score over the values of single settings, all trials in each: the most important settings first."""
    names = list(_ranked(study))[:_SLICES]
    made = _made("plot_slice", study, params=names, target_name="median score")
    data, layout = made["data"], made["layout"]
    for trace in data:
        shown = {"size": 7, "color": ACTION_COLOURS[0], "opacity": 0.7}
        trace |= {"marker": shown, "showlegend": False}
    axes: Trace = {}
    for name, each in layout.items():
        if name.startswith(("xaxis", "yaxis")):
            kept = {key: each[key] for key in ("anchor", "domain", "matches", "type", "showticklabels") if key in each}
            kept |= {"dtick": 1} if each.get("type") == "log" else {}
            axes[name] = axis(in_plotly(each.get("title", {}).get("text", "")).replace("_", " "), **kept)
    return build("Score by setting", data, {"l": 56, "b": 44}, showlegend=False, **axes)


def _ranked(study: optuna.Study) -> list[str]:
    import optuna

    names = list(study.trials[0].params)
    if importances(study) is None:
        return names
    with warnings.catch_warnings(action="ignore"):
        return list(optuna.importance.get_param_importances(study))


def _made(which: str, study: optuna.Study, **options: object) -> dict[str, Any]:
    """A figure of the library as plain data; its colours and fonts give way to those of the page."""
    import optuna.visualization

    with warnings.catch_warnings(action="ignore"):  # of experimental functions
        figure = getattr(optuna.visualization, which)(study, **options)
    return figure.to_plotly_json()
