"""The sidebar of the page Train: the algorithm, the environment and the settings."""

from __future__ import annotations

from typing import Any

import streamlit as st

from app import session
from app.catalogue import training_runs
from app.components.waiting import attempt
from app.components.widgets import field, select
from app.session import store
from app.session.typed import in_markdown
from app.train.schema import FORM, OPENING, TRAIN, suited, wanted
from laplace_core import InputError
from laplace_core.agents.settings import ENVIRONMENTS, LOOP_SCHEMA, SETTINGS, LoopSettings, algorithm_title
from laplace_core.exchange.links import by_name
from laplace_core.parameters import Parameter
from laplace_core.supervise.limits import limits, may_train
from laplace_core.training.defaults import fields
from laplace_core.words import capital
from laplace_core.worlds.titles import world_title

_FORM = "training"  # what refusals of this form go by
_NAMES = {"gammas": "Discounts", "thetas": "Sensitivities", "spacing": "Spacing"}
_SHORT = 13  # letters of a title that has room beside another
_GREEK = ("gamma", "theta")
_SEED, _COUNT = by_name(*LOOP_SCHEMA)["seed"], by_name(*FORM)["count"]


def form() -> None:
    """The whole form: a change is kept and shows in the link; the button starts runs with these settings."""
    if limits().read_only:
        st.info("This server shows runs but does not start new ones.")
        return
    values = store.chosen()
    key = store.show("algorithm", OPENING["algorithm"])
    select("Algorithm", tuple(SETTINGS), key, algorithm_title, keep=_change_algorithm)
    key = store.show("environment", OPENING["environment"])
    select(
        "Environment",
        [each for each in ENVIRONMENTS if may_train(each) or each == values.get("environment")],
        key,
        world_title,
        keep=_change_environment,
    )
    usual, refused = attempt(lambda: suited(values)), None
    if usual is None:  # the file of settings that ships for the two is damaged
        return
    try:
        shown = wanted(values)
    except InputError as error:
        shown, refused = usual, str(error)
    left, right = st.columns(2)
    field(_SEED, shown.seed, "Seed", key=f"{TRAIN}seed", place=left)
    field(_COUNT, 1, "Runs", place=right)
    first, others = fields(usual.ALGORITHM)
    _in_columns(first, shown)
    box = st.expander("All other settings", key="train_all", on_change="rerun")
    if box.open:
        with box:
            _in_columns(others, shown)
    if refused:
        st.error(in_markdown(refused))
    st.button("Start training", type="primary", width="stretch", on_click=start, disabled=refused is not None)
    if _FORM in session.current().refusals:
        st.error(in_markdown(session.current().refusals[_FORM]))
    if any(name.startswith(TRAIN) for name in values):
        st.button("Reset to the recommended settings", on_click=_suit, width="stretch")


def _in_columns(parameters: list[Parameter], shown: LoopSettings) -> None:
    for row in _rows(parameters):
        for column, parameter in zip(st.columns(len(row)), row, strict=True):
            name = parameter.name
            field(parameter, getattr(shown, name), _title(name), key=TRAIN + name, place=column)


def _rows(parameters: list[Parameter]) -> list[list[Parameter]]:
    """Two in a row, but for long titles."""
    rows: list[list[Parameter]] = []
    for parameter in parameters:
        short = len(_title(parameter.name)) <= _SHORT
        if short and rows and len(rows[-1]) == 1 and len(_title(rows[-1][0].name)) <= _SHORT:
            rows[-1].append(parameter)
        else:
            rows.append([parameter])
    return rows


def _title(name: str) -> str:
    if name in _NAMES:
        return _NAMES[name]
    words = name.replace("_", " ")
    return words if name.startswith(_GREEK) else words.capitalize()


def _change_algorithm(key: str) -> None:
    """Callback: settings that the new algorithm has as well stay."""
    name = st.session_state[key]
    known = {TRAIN + parameter.name for parameter in SETTINGS[name].SCHEMA}
    _replace({k: v for k, v in store.chosen().items() if not k.startswith(TRAIN) or k in known}, algorithm=name)


def _change_environment(key: str) -> None:
    """Callback: drop the settings for the old environment; the seed stays."""
    kept = {k: v for k, v in store.chosen().items() if not k.startswith(TRAIN) or k == f"{TRAIN}seed"}
    _replace(kept, environment=st.session_state[key])


def _suit() -> None:
    """Callback: reset all settings to the recommended ones."""
    _replace({key: value for key, value in store.chosen().items() if not key.startswith(TRAIN)})


def _replace(values: dict[str, Any], **changes: object) -> None:
    session.current().refusals.pop(_FORM, None)
    store.replace_all(values | changes)


def start() -> None:
    """Callback: start a run for every seed of the form."""
    session.current().refusals.pop(_FORM, None)
    values, started = dict(store.chosen()), None
    try:
        for extra in range(int(values.get("count", 1))):
            seed = int(values.get(f"{TRAIN}seed", 0)) + extra
            name = training_runs.begin(wanted(values | {f"{TRAIN}seed": seed}))
            started = started or name
    except InputError as error:
        session.current().refusals[_FORM] = capital(str(error))
    if started is not None:
        show(started)


def show(name: str) -> None:
    """Callback: show a run, with the newest ones."""
    store.choose("run", name)
    store.choose("beside", None)
