"""Bounded caches between the pages and the library."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from app.session.jobs import is_there, session_id
from laplace_core import InputError, Study, World, figures
from laplace_core.caching import Cached, cached
from laplace_core.inverse.solvers import selecting
from laplace_core.payloads.lens import Simulated, decoding, follows, payload, structure
from laplace_core.planning import greedy_policy
from laplace_core.study.artefacts import Artefact, find_artefacts
from laplace_core.study.compare import Space, difference, summary, value_difference
from laplace_core.study.episodes import episode_regret_of
from laplace_core.study.evidence import work_to_believe
from laplace_core.study.explanation import Explanation, explain, trials_of
from laplace_core.study.pipeline import WorldStudy
from laplace_core.study.settings import Resolved
from laplace_core.study.size import largest_study, size_of
from laplace_core.study.trials import Trials
from laplace_core.study.verdict import Verdict, judge
from laplace_core.subjects import Learner, Subject, View, state_in
from laplace_core.supervise.aside import Aside
from laplace_core.tabular import Bands, Learned, bands, return_distributions


@cached(32)
def _study(subject: Subject, settings: Resolved) -> Study:
    return subject.study(settings)


def study_for(view: View) -> Study:
    return _study(view.subject, view.settings)


def unread(view: View) -> View:
    """The view without what only says at which horizon it is read: it has the same timeline, unless it is folded."""
    if view.settings.fold:
        return view
    return replace(view, settings=replace(view.settings, horizon=None, used=0.0, deadline="constant"))


def is_known(view: View) -> bool:
    """Whether the study of a view is there, if need be from the same timeline read at another horizon."""
    base = unread(view)
    if not _study.known(view.subject, view.settings) and _study.known(base.subject, base.settings):
        remember(view, study_for(base), None)
    return _study.known(view.subject, view.settings)


def made(view: View) -> tuple[Study, Study | None]:
    """The study of a view, in no cache, and the one that the lens draws from where that is decoded otherwise."""
    study = view.subject.study(view.settings)
    held = None if follows(study.settings) else decoding(study.settings)
    if held is None or study.settings.normalise == held.normalise:
        return study, None
    return study, view.subject.study(held)


def remember(view: View, study: Study, held: Study | None) -> None:
    """Keep what :func:`made` has made of a view, or of the same view :func:`unread`.

    The same timeline is kept for the alpha that a rule has chosen, typed, and at no horizon.
    """
    alpha = study.settings.alpha
    _study.remember(replace(study, settings=replace(view.settings, alpha=alpha)), view.subject, view.settings)
    if not view.settings.fold:  # folded, the horizon decides what is decoded
        typed = replace(view.settings.at_alpha(alpha), horizon=None)
        _study.remember(replace(study, settings=typed, automatic=None), view.subject, typed)
    if held is not None:
        _decoded.remember(held, view.subject, held.settings)


LARGE = 1_000_000
"""Numbers in the largest array of a study from which on pages compute one at a time: 8 MB, many times over."""


def is_large(view: View) -> bool:
    """Whether a study is so large that only one is computed at a time; false if it is refused."""
    s, space = view.settings, view.subject.gamma_space
    own = len(view.subject.action_names), s.gammas or 0, s.thetas or 0  # None where a gamma-space has its own
    actions, gammas, thetas = own if space is None else space.values.shape
    rewards = 1 if view.world is None else view.world.reward_values.size
    return LARGE < size_of(actions, gammas, thetas, s.steps, rewards=rewards) <= largest_study()


def horizon_of(view: View) -> float:
    """The chosen horizon; the longest one by default."""
    study = study_for(view)
    return float(study.horizons[study.row])


@cached(128)
def _graded(view: View) -> Verdict:
    return judge(study_for(view), study_for(view).row, view.action, explain=False)


@cached(128)
def _listed(view: View, action: int) -> tuple[Artefact, ...]:
    """The artefacts of an action as they are found without a search: no remedy but another solver, which is always
    offered."""
    listed = find_artefacts(study_for(view), action, horizon_of(view), searching=False)
    return tuple(replace(each, remedies=tuple(r for r in each.remedies if "solver" in r.changes)) for each in listed)


@cached(128)
def _explained(view: View) -> Explanation:
    made = explain(study_for(view), study_for(view).row, view.action, _trials(view))
    _trials.recount(view)  # they keep what they have tried
    return made


@cached(8)
def _trials(view: View) -> Trials | None:
    study = study_for(view)
    return trials_of(study, study.row, view.action)


AT_ONCE = 5e6
"""Products that a search may cost to be made before the pictures are drawn: a tenth of a second."""


MOST_SEARCHED = 32
"""Actions that are searched for artefacts beside the one that is shown: each costs in proportion to all of them."""


def is_explained(view: View, *, alone: bool = True) -> bool:
    """Whether the cause and the remedies are known, need no search, or are to be found before the pictures are drawn.

    Args:
        alone: whether nobody else waits for this server; otherwise no search is made before the pictures.
    """
    if _explained.known(view):  # found, not only begun: nobody is to wait for pictures
        return True
    trials, work = _trials(view), work_to_believe(study_for(view))
    if not work and (trials is None or (_graded(view).searched and not _listed(view, view.action))):
        return True
    return alone and work + (0.0 if trials is None else trials.work) <= AT_ONCE


def verdict_for(view: View, *, explained: bool = True) -> Verdict:
    """The verdict with its cause, which may take seconds to find; or without the cause."""
    return _explained(view).verdict if explained else _graded(view)


def artefacts_for(view: View, *, explained: bool = True) -> tuple[Artefact, ...]:
    """Artefacts in the tau-space of the shown action, with their remedies once the cause is known: to try them is part
    of the same search."""
    return _explained(view).artefacts if explained else _listed(view, view.action)


def artefacts_elsewhere(view: View) -> str:
    """One line that names artefacts which only other actions have; of very many actions, the first are searched."""
    here = {artefact.name for artefact in _listed(view, view.action)}
    lines: dict[str, list[str]] = {}
    names = study_for(view).action_names
    for other, name in enumerate(names[:MOST_SEARCHED]):
        for artefact in _listed(view, other) if other != view.action else ():
            if artefact.name not in here:
                lines.setdefault(artefact.name, []).append(name)
    found = [f"Also {name}, in {', '.join(actions)}." for name, actions in lines.items()]
    if len(names) > MOST_SEARCHED:
        found.append(f"Of the other actions, only the first {MOST_SEARCHED} were searched.")
    return " ".join(found)


def _lost(view: View, error: Exception) -> None:
    graded = _graded(view)
    words = f"{graded.sentence} Its cause was not found: {str(error).rstrip('.')}."
    _explained.remember(Explanation(replace(graded, sentence=words), _listed(view, view.action)), view)


_aside: Aside[View, Explanation] = Aside(lambda view, made: _explained.remember(made, view), _lost, is_there)


def search_aside(view: View) -> None:
    """Let a process of low priority find the cause and the remedies, in place of what this session wanted before."""
    if not _explained.known(view):
        study, trials = study_for(view), _trials(view)
        is_large = trials is not None and trials.work > AT_ONCE
        _aside.ask(session_id(), view, explain, study, study.row, view.action, is_large=is_large)


def is_searched(view: View, *, wait: float = 0.0) -> bool:
    """Whether the search of :func:`search_aside` is over.

    Args:
        wait: seconds to give it.
    """
    return _explained.known(view) or _aside.is_over(view, wait)


@cached(32)
def _episode_regrets(subject: Subject, settings: Resolved) -> np.ndarray | None:
    study = _study(subject, settings)
    if not isinstance(study, WorldStudy):
        return None
    learned = None if subject.learner is None else subject.learner.tables
    try:
        return episode_regret_of(study.world, study.settings, learned=learned)[:, study.state]
    except InputError:
        return None


def episode_regrets(view: View) -> np.ndarray | None:
    """Loss of whole episodes under the decoded rule from the study's state, by T; None where it cannot be had."""
    if view.world is None:
        return None
    s = study_for(view).settings
    return _episode_regrets(view.subject, replace(s.at_alpha(s.alpha), noise=0.0, noise_seed=0, horizon=None, used=0.0))


# What the graph of a world does not depend on; it is drawn once for all values of these.
_UNSEEN: dict[str, Any] = {
    "alpha": 1.0, "steps": 1, "time_step": 1.0, "normalise": "none", "softness": 0.0, "deadline": "constant",
    "noise": 0.0, "noise_seed": 0, "thetas": 2, "gammas": 2, "theta_min": 0.0, "theta_max": 1.0, "slope": 1.0,
    "policy": "shared", "value_gamma": 0.5, "horizon": None, "used": 0.0, "fold": False, "shift": False, "clip": False,
    "paper_grid": False,
}  # fmt: skip


def world_figure(view: View) -> str:
    """The graph of a view's world as JSON."""
    world = view.world
    assert world is not None  # without one there is no graph to ask for
    return _world_figure(world, view.subject.learner, replace(view.settings, **_UNSEEN), view.action)


@cached(64)
def _world_figure(world: World, learner: Learner | None, settings: Resolved, action: int) -> str:
    policy = greedy_policy(world, settings.acting_gamma) if learner is None else learner.policy
    return figures.to_json(figures.world_graph(world, world.state_index(state_in(settings)), action, policy))


@cached(8)
def _bands(learned: Learned, settings: Resolved) -> Bands:
    return bands(learned, settings)


def learning_figure(name: str, view: View) -> str:
    """A picture of learning; ``values`` and ``rewards`` need several seeds."""
    softness = view.settings.softness if name == "values" else 0.0
    settings = replace(view.settings, deadline="constant", softness=softness)
    learner = view.subject.learner
    assert learner is not None  # nobody asks for these pictures where nothing was learned
    return _learning_figure(name, learner, settings, view.action, row=study_for(view).row if name == "values" else 0)


@cached(32)
def _learning_figure(name: str, subject: Learner, settings: Resolved, action: int, *, row: int) -> str:
    learned, index, state = subject.learned, subject.index or 0, state_in(settings)
    drawn = {
        "curve": lambda: figures.learning_curve(learned),
        "probabilities": lambda: figures.reward_bands(_bands(learned, settings), action),
        "returns": lambda: figures.return_laws(
            return_distributions(learned, state, action, seed_index=index, settings=settings)
        ),
        "values": lambda: figures.values_over_horizon(_study(subject, settings), row, _bands(learned, settings)),
        "rewards": lambda: figures.rewards_and_survival(_study(subject, settings), action, _bands(learned, settings)),
    }[name]()
    return figures.to_json(drawn)


@cached(16)
def comparison(a: View, b: View, what: Space) -> tuple[str, dict[str, str]]:
    """One sentence on two views, and the pictures of a space of A, of B and of B - A.

    Where the spaces have no common grid, the sentence says so and there are no pictures.
    """
    first, second = study_for(a), study_for(b)
    values = value_difference(first, second, a.action, b.action)
    try:
        apart = difference(first, second, a.action, b.action, what=what)
    except InputError as error:
        return f"{error} {summary(None, values)}", {}
    drawn = figures.comparison(apart)
    notes = "".join(f" {note}" for note in (apart.note, figures.thinning(apart)) if note)
    return summary(apart, values) + notes, {name: figures.to_json(figure) for name, figure in drawn.items()}


MOST_PAYLOAD = 25
"""Megabytes that the lens may send to a browser."""


def lens_payload(view: View, simulated: Simulated | None = None) -> bytes:
    """The payload of the lens for a view: the factors of its inverse, for the settings that do not move in the browser.

    Raises:
        InputError: it is more than a browser should be sent.
    """
    study, held = study_for(view), None
    if not follows(study.settings):
        held = decoding(study.settings)
        if study.settings.normalise == held.normalise:  # it is decoded already
            _decoded.remember(study, view.subject, held)
    return _lens_payload(view.subject, structure(study.settings, view.world), simulated, held)


@cached(4)
def _decoded(subject: Subject, settings: Resolved) -> Study:
    """A study as far as the server has to decode it: settings of the reading may be others."""
    return _study(subject, settings)


@cached(16)
def _lens_payload(
    subject: Subject, settings: Resolved, simulated: Simulated | None, held: Resolved | None
) -> bytes:  # fmt: skip
    shown = None if held is None else replace(_decoded(subject, held), settings=held)
    # Nothing of what it decodes is sent: by the linear solver it is soon made.
    base = replace(_study(subject, replace(settings, solver=selecting(settings.solver))), settings=settings)
    data = payload(base, simulated, subject.places, added=subject.added, shown=shown)[0]
    if len(data) > MOST_PAYLOAD * 1_000_000:
        raise InputError(
            f"the lens of this view would take {len(data) / 1e6:.0f} MB in the browser, above {MOST_PAYLOAD}: lower "
            "thetas, gammas or steps, or round the rewards."
        )
    return data


def forget() -> None:
    """Clear all caches of views; a large learner makes a new table every moment."""
    for each in list(globals().values()):
        if isinstance(each, Cached) and each.__module__ == __name__:
            each.cache_clear()
