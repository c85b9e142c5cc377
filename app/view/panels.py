"""The lens on a view with the verdict over it, and the list of artefacts under it."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from html import escape
from typing import Any

import streamlit as st

from app import session
from app.components.lens import Graph, Pin, Preset, Released, Said, lens
from app.components.waiting import LOOK_EVERY, attempt
from app.session import crowd, store
from app.session.typed import in_markdown
from app.view import compute, solver
from laplace_core.inverse.selectors import TYPED
from laplace_core.inverse.titles import RULE_TITLES
from laplace_core.payloads.lens import Simulated
from laplace_core.payloads.link import PARAM
from laplace_core.payloads.state import checked, state_of, values_of
from laplace_core.study.artefacts import Artefact
from laplace_core.study.settings import BY_NAME, SWITCHES
from laplace_core.study.verdict import Verdict
from laplace_core.subjects import View

TONES = {"lucky": "warn", "wrong": "bad", "unknown": "unknown"}
_ACROSS = 3  # artefacts side by side
_ROWS = {"steps", "time_step"}


@dataclass
class _Search:
    """The search for the cause of a verdict and for remedies.

    Attributes:
        alone: whether no other session is at work.
        explained: whether the page shows what is found.
        due: whether it is still to be made.
        done_for: the values that it was last made for.
    """

    alone: bool = True
    explained: bool = True
    due: bool = False
    done_for: dict[str, Any] | None = None


def pictures(
    view: View, base: View, *, presets: Sequence[Preset] = (), pin: Pin | None = None,
    lead: Mapping[str, Any] | None = None, followed: Mapping[str, Any] | None = None,
    simulated: Simulated | None = None, follows: bool = False, story: Mapping[str, Any] | None = None,
    on_story: Callable[[int], None] = lambda step: None, coming: str | None = None,
) -> None:  # fmt: skip
    """Draw the lens; the values of a released control are then set by hand.

    Args:
        base: the view that Reset leads to.
        presets, pin: views that are one click away, and the one that is pinned.
        lead, followed: the episode that the lens follows, and what was observed; see :func:`app.components.lens.lens`.
        simulated: what continuations from there came to.
        follows: whether the action of the view is the one that was taken, and not one that was chosen.
        story, on_story: the guided story, and what shows another step of it.
        coming: the solver that this view stands in for (:mod:`app.view.feasible`): no cause is searched for.
    """
    look = str(store.chosen().get("look", "heatmap"))
    horizon, added = compute.horizon_of(view), view.subject.added
    settings = compute.study_for(view).settings  # with the alpha of the rule
    solver.shows(settings)
    # An action that follows the episode is none of the state: with every step the state would be another one.
    action = 0 if follows else view.action
    shown = state_of(settings, horizon, action=action, look=look, added=added)
    search = session.part(_Search)
    search.alone = crowd.alone()
    search.explained = explained = compute.is_explained(view, alone=search.alone)
    judged = compute.verdict_for(view, explained=explained)

    def release(released: Released) -> None:
        if released.preset is not None:
            look = {"look": store.chosen()["look"]} if "look" in store.chosen() else {}
            store.replace_all({**next(each.values for each in presets if each.name == released.preset), **look})
            store.refresh_sidebar()
            return
        if released.story is not None:
            on_story(released.story)
            return
        study = compute.study_for(view)  # looked up, for the session holds this function: no arrays may hang on it
        changes = values_of(checked(released.state, study), shown, study.action_names)
        if "selector" in changes:  # alpha was dragged
            solver.by_hand(changes.pop("alpha"))
            changes.pop("selector")
            store.refresh_sidebar()
        for name, value in changes.items():
            store.choose(name, value)
        if released.follow is not None:
            taken = int(checked(released.state, study)["action"])
            store.choose("action", None if released.follow else study.action_names[taken])
        if "policy" in changes:  # which the sidebar shows, too
            store.refresh_sidebar()
        if released.remedy is not None and released.remedy < len(judged.remedies):
            remedy(judged.remedies[released.remedy].changes, horizon)
        if released.solver is not None:
            remedy({"solver": released.solver}, horizon)
        if view.world is not None and released.picked is not None and released.picked < view.world.n_states:
            store.apply_changes({"state": view.world.states[released.picked]})
        if released.pin is not None and pin is not None:
            pin.keep(released.pin)

    data = attempt(lambda: compute.lens_payload(view, simulated))
    if data is None:
        return
    last, remedies = float(compute.study_for(base).horizons[-1]), tuple(each.label for each in judged.remedies)
    lens(
        data,
        shown,
        store.page_name(),
        base=state_of(compute.study_for(base).settings, last, action=view.action),
        rule=None if settings.selector == TYPED else RULE_TITLES[settings.selector],
        coming=coming,
        presets=presets,
        on_release=release,
        said=Said(_tone(judged), _sentence(judged, view, explained=explained or coming is not None), remedies),
        world=_graph(view),
        pin=None if view.world is None else pin,
        lead=lead,
        followed=followed,
        follows=follows,
        story=story,
    )


def _tone(judged: Verdict) -> str:
    """The tone of a verdict: by its choice, and if that is right by its timeline."""
    if judged.choice == "right":
        return "ok" if judged.timeline == "sound" else str(judged.timeline)
    return TONES[judged.choice]


def _sentence(judged: Verdict, view: View, *, explained: bool) -> str:
    """The verdict; where its cause is still to be found, :func:`explain` finds it at the end of this run.

    One search a view: what is learned meanwhile is another object at every run of the page, and never explained.
    """
    search = session.part(_Search)
    search.due = due = not explained and search.done_for != dict(store.chosen())
    if due and view.learned is None and not judged.searched:
        return f"{judged.sentence} The cause is being searched for."
    return judged.sentence


def explain(view: View) -> None:
    """Search for the cause that the lens does not show yet, after everything else is on the page.

    What the lens shows counts, not what is known by now: another visitor's search may have ended meanwhile.
    """
    search = session.part(_Search)
    if not search.due:
        return
    compute.search_aside(view)
    if search.alone:
        place = st.empty()
        while not compute.is_searched(view, wait=0.05):
            place.empty()  # where Streamlit ends a run that nobody awaits
        _searched(view)
    else:  # this run ends, so that what was changed meanwhile is not kept waiting
        st.fragment(_searched, run_every=LOOK_EVERY)(view)


def _searched(view: View) -> None:
    """Draw the page with the cause once the search is over; as it is, where what was found could not be kept."""
    if compute.is_searched(view):
        session.part(_Search).done_for = dict(store.chosen())
        st.rerun()


def _graph(view: View) -> Graph | None:
    if view.world is None:
        return None
    s, name = view.settings, view.world.actions[view.action]
    alt = f"Graph of the world {s.world}, state {s.state} and action {name} highlighted."
    return Graph(compute.world_figure(view), alt, f"{s.world} {view.world.n_states}")


def remedy(changes: Mapping[str, object], horizon: float) -> None:
    """Callback: make the changes of a remedy: fields, and ``param:NAME`` for a parameter of the world.

    A switch that it turns off is no longer set by hand, so that the link does not name it. A remedy was tried at the
    horizon of the view: where it changes the rows, and with them the longest horizon, the view stays at its own.
    """
    if _ROWS & changes.keys():
        changes = {**changes, "horizon": horizon}
    if "alpha" in changes:
        solver.by_hand()
    off = {name for name, value in changes.items() if name in SWITCHES and value == BY_NAME[name].default}
    store.apply_changes(
        {name.replace("param:", PARAM): None if name in off else value for name, value in changes.items()}
    )


def artefacts(view: View, coming: str | None = None) -> None:
    """The artefacts in the tau-space of the shown action: name, size, a sentence, remedies.

    Args:
        coming: the solver that this view replaces for now, which is not offered.
    """
    if view.subject.added:
        st.caption("Interpolated discounts repeat the errors of their neighbours: noise does more than it shows.")
    name = compute.study_for(view).action_names[view.action]
    listed = compute.artefacts_for(view, explained=session.part(_Search).explained)
    others = compute.artefacts_elsewhere(view)
    st.html(f'<h2 class="panel-title">Artefacts in the tau-space of {escape(name)}</h2>')
    with st.container(key="artefacts"):
        if not listed:
            st.html(f'<div class="artefact">None found for this action. {escape(others)}</div>')
        for first in range(0, len(listed), _ACROSS):
            for column, artefact in zip(st.columns(_ACROSS), listed[first : first + _ACROSS], strict=False):
                with column:
                    _artefact(artefact, compute.horizon_of(view), coming)
        if listed and others:
            st.html(f'<div class="artefact">{escape(others)}</div>')


def _artefact(artefact: Artefact, horizon: float, coming: str | None) -> None:
    st.html(
        f'<div class="artefact"><b>{escape(artefact.name)}</b> · {escape(artefact.shown)}<br>'
        f"<span>{escape(artefact.sentence)}</span></div>"
    )
    remedies = [offer for offer in artefact.remedies if offer.changes != {"solver": coming}][:2]
    for column, offer in zip(st.columns(len(remedies)) if remedies else (), remedies, strict=True):
        column.button(
            in_markdown(offer.label), key=f"fix {artefact.name} {offer.label}", on_click=remedy,
            args=(offer.changes, horizon), width="stretch",
        )  # fmt: skip
