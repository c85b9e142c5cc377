"""Learning while the user watches: its settings, its progress, and the pictures of learning."""

from __future__ import annotations

import hashlib

import streamlit as st
from streamlit.delta_generator import DeltaGenerator

from app.catalogue import tabular
from app.components.chart import chart
from app.components.waiting import attempt, place_in_line
from app.components.widgets import download, field, select
from app.session import store
from app.session.jobs import Wish
from app.session.typed import in_markdown
from app.view import compute
from app.worlds import learners
from app.worlds.sources import LEARN
from laplace_core import InputError, World, load_world
from laplace_core.exchange.links import by_name
from laplace_core.payloads.link import Values
from laplace_core.subjects import View, about, fits, learned_file
from laplace_core.supervise.jobs import duration
from laplace_core.tabular import LEARN_SCHEMA, Learned, LearnSettings, learned_bytes, resolve_learning, words
from laplace_core.tabular.settings import DECIDED_NAMES, ResolvedLearning
from laplace_core.tabular.work import Watched, Work
from laplace_core.words import capital

_SHOWN = {
    "episodes": "Episodes",
    "seeds": "Learners (seeds)",
    "seed": "First seed",
    "max_steps": "Longest episode",
    "starts": "Start",
    "rate_first": "First rate",
    "rate_half": "Rate half-life",
    "rate_floor": "Smallest rate",
    "epsilon_first": "First epsilon",
    "epsilon_half": "Epsilon half-life",
    "epsilon_floor": "Smallest epsilon",
    "peers": "Also learn the four other codes of the return",
}

LARGE = 500_000
"""Numbers in a learner's table beyond which pictures of its earlier snapshots are not kept."""
LEARN_DEFAULTS = resolve_learning(LearnSettings(), load_world("two_branch"))


def source_group(world: World) -> None:
    """The choice of exact or learned, and the settings of learning."""
    key = store.show("source", "exact")
    st.segmented_control("Gamma-space", ("exact", "learned"), key=key, on_change=store.keep, args=(key,), required=True,
                         help="Exact: solved. Learned: from sampled episodes, while you watch.")  # fmt: skip
    if store.chosen().get("source") != "learned":
        return
    if "agent" in store.chosen():
        st.caption(f"Learned before, in {agent_title(str(store.chosen()['agent']))}.")
        st.button("Learn again instead", on_click=store.choose, args=("agent", None), width="stretch")
        return
    wanted = attempt(lambda: learning_of(world))
    shown = wanted or LEARN_DEFAULTS  # what was set by hand is shown, and can be set right
    box = st.expander("How it learns", key="how", on_change="rerun")
    if box.open:
        with box:
            columns, known = st.columns(2), by_name(*LEARN_SCHEMA)
            for i, (name, title) in enumerate(_SHOWN.items()):
                place = st if known[name].type is bool else columns[i % 2]
                field(known[name], getattr(shown, name), title, key=LEARN + name, place=place)
    if wanted is None:
        return
    wish = _wish(world, wanted)
    going = learners.watch(wish)
    idle = (going is None or not going.running) and not wish.too_long
    st.button("Learn", on_click=_begin, args=(world,), type="primary", width="stretch", disabled=not idle)


def agent_title(agent: str) -> str:
    return "the file that you opened" if agent in tabular.opened_agents() else agent.replace("_", " ")


def learning_of(world: World, values: Values | None = None) -> ResolvedLearning:
    """What would be learned in a view, by default the present one: the learner's settings, its discounts and policy.

    Raises:
        InputError: settings that do not fit the world.
    """
    values = store.chosen() if values is None else values
    given = {name: values[name] for name in DECIDED_NAMES if name in values}
    given |= {name.removeprefix(LEARN): value for name, value in values.items() if name.startswith(LEARN)}
    return resolve_learning(LearnSettings(**given), world)


_IN_LINK = 10
"""Digits of a run's key that a link holds."""


def _wish(
    world: World, wanted: LearnSettings, values: Values | None = None, *, slot: str = "learner"
) -> Wish[Work]:  # fmt: skip
    """The run of settings in a view, by default the present one; a link names it."""
    values = store.chosen() if values is None else values
    what = (world.source, world.params, values.get("own"), values.get("timeline"), wanted)
    key = hashlib.sha256(repr(what).encode()).hexdigest()
    return learners.learning(key, world, wanted, slot=slot, linked=values.get("run") == key[:_IN_LINK])


def _begin(world: World) -> None:
    """Callback: (re)start the run of the present settings."""
    try:
        wish = _wish(world, learning_of(world))
    except InputError:  # said beside the button already
        return
    learners.forget(wish)
    wish.begin()
    store.choose("run", str(wish.key)[:_IN_LINK])


def current(world: World) -> tuple[Learned | None, Watched | None]:
    """The learner of the view, finished or running; none for an exact gamma-space."""
    values = store.chosen()
    if values.get("source") != "learned":
        return None, None
    if "agent" in values:
        learned = _opened(values, world)
        if learned is not None:
            return learned, None
        store.choose("agent", None)
        st.toast("The agent was closed, because it learned another world.")
    try:
        wanted = learning_of(world)
    except InputError:  # said where the settings are
        return None, None
    watched = learners.watch(_wish(world, wanted))
    learned = None if watched is None else watched.learned()
    if watched is not None and learned is not None and watched.running and learned.basis.size > LARGE:
        compute.forget()
    return None if learned is None else about(learned, world), watched


def _opened(values: Values, world: World) -> Learned | None:
    """The learned values of the agent of a view, if it learned this world."""
    learned = tabular.agent(str(values["agent"]))
    return about(learned, world) if fits(learned, world) else None


def learned_in(values: Values, world: World) -> tuple[Learned | None, bool]:
    """The learned values of a pinned view, and whether they are still being learned.

    A run that is not here any more is learned again, from its seed, if that is short.

    Raises:
        InputError: an agent that is not here, or a run that would take long, or ended before anything was learned.
    """
    if values.get("source") != "learned":
        return None, False
    if "agent" in values:
        return _opened(values, world), False
    wanted = learning_of(world, values)
    wish = _wish(world, wanted, values, slot="pinned")
    if not wish.by_itself:
        return None, False
    watched = learners.watch(wish)
    if watched is None:
        raise InputError(wish.notice or f"learning it again takes about {duration(wish.estimate())}: unpin it.")
    learned = watched.learned()
    if learned is None and not watched.running:
        raise InputError("its learning ended before anything was learned.")
    return (None, True) if learned is None else (about(learned, world), False)


def strip(view: View, watched: Watched | None) -> None:
    """Between the verdict and the pictures: the progress of learning."""
    if store.chosen().get("source") != "learned":
        return
    with st.container(key="learning_strip"):
        text, button, seed, save = st.columns([3, 1, 1.2, 1.2], vertical_alignment="center")
        with text:
            _progress(view, watched)
        learner = view.learner
        if watched is None and learner is None:
            wish = _present(view)
            button.button("Learn now", on_click=_begin, args=(view.world,), type="primary", width="stretch",
                          disabled=wish is None or bool(wish.too_long))  # fmt: skip
        if watched is not None and watched.running:
            button.button("Cancel", on_click=_cancel, args=(watched, _present(view)), width="stretch")
        if learner is None:
            return
        if len(learner.learned.basis) > 1:
            _which(learner.learned, seed)
        if watched is None or not watched.running:
            file = learned_file(learner.world)
            download("Download agent", lambda: learned_bytes(learner.learned), file, place=save, width="stretch")


def _present(view: View) -> Wish[Work] | None:
    """The run of a view; none where its settings do not fit, which is said beside them."""
    try:
        return None if view.world is None else _wish(view.world, learning_of(view.world))
    except InputError:
        return None


def _cost(wish: Wish[Work] | None) -> str:
    if wish is None:
        return ""
    return capital(wish.notice or f"learning takes about {duration(wish.estimate())}.")


def _cancel(watched: Watched, wish: Wish[Work] | None) -> None:
    """Callback: stop learning; the link no longer holds the run."""
    if wish is not None:
        watched.cancel(wish)
    store.choose("run", None)


def _progress(view: View, watched: Watched | None) -> None:
    if watched is None:
        if view.learned is None:
            st.info(f"Nothing is learned yet with these settings: the pictures are exact. {_cost(_present(view))}")
        else:
            st.caption(words.learned(view.learned))
        return
    if watched.error:
        st.error(in_markdown(capital(watched.error)))
        return
    progress = watched.progress()
    if progress is None and not watched.running:
        st.info("Cancelled before anything was learned: the pictures show the exact solution.")
        return
    if progress is None:
        st.progress(0.0, place_in_line(watched.before))
        return
    assert view.world is not None  # a run learns of a world
    seeds = learning_of(view.world).seeds if view.learned is None else view.learned.settings.seeds
    st.progress(*words.progress(progress, seeds, running=watched.running))


def _which(learned: Learned, place: DeltaGenerator) -> None:
    titles = {"mean": "mean of all", **{str(i): f"seed {seed}" for i, seed in enumerate(learned.seeds)}}
    key = store.show("learner", "mean")
    select("Learner shown", list(titles), key, titles, place=place, label_visibility="collapsed")


def pictures(view: View) -> None:
    """Under the lens: the learning curve, what the learners agree on, the codes of the return."""
    if view.learned is None:
        return
    name = view.subject.action_names[view.action]
    left, middle, right = st.columns(3, gap="small")
    _picture("curve", view, "Error of the learned gamma-space and return over episodes, one line for each seed.", left)
    alt = f"Probability of each reward after {name} over future steps: the range over all seeds, the truth dotted."
    _picture("probabilities", view, alt, middle)
    with right:
        if view.learned.peers is None:
            st.html('<h2 class="panel-title">Return: four codes and the truth</h2>')
            st.caption(
                "Categorical, quantile, expectile and plain Q can learn from the same transitions; they stand here "
                "beside the true return then."
            )
            st.button("Learn them too", on_click=_with_peers, args=(view.world,))
        else:
            alt = f"Cumulative distribution of the return after {name}: four codes and the true one."
            _picture("returns", view, alt, right)
    if len(view.learned.basis) > 1:
        _over_seeds(view, name)


def _over_seeds(view: View, name: str) -> None:
    """What the learners agree on beside the probabilities: values and choices, rewards and survival."""
    left, right = st.columns([1.4, 1], gap="small")
    alt = "Value of each action over the horizon: the range over all seeds, and how many seeds choose it."
    _picture("values", view, alt, left)
    alt = f"Expected reward and survival of {name} over future steps: the range over all seeds."
    _picture("rewards", view, alt, right)


def _picture(name: str, view: View, alt: str, place: DeltaGenerator) -> None:
    with place:
        figure = attempt(lambda: compute.learning_figure(name, view))
        if figure is not None:
            chart(figure, name, alt, revision=view.settings.world)


def _with_peers(world: World) -> None:
    store.choose("agent", None)
    store.choose(f"{LEARN}peers", True)
    _begin(world)
    store.refresh_sidebar()
