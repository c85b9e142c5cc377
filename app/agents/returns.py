"""Codes side by side: for one state and first action, the return that each agent predicts and the observed one."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape

import streamlit as st

from app.agents import jobs
from app.catalogue import checkpoints
from app.components.chart import chart
from app.components.waiting import attempt, offer, progress
from app.components.widgets import download
from laplace_core import figures
from laplace_core.acting.return_laws import SimulatedReturns, laws_npz
from laplace_core.acting.rollout import Rollout
from laplace_core.figures.returns import ReturnRow, rows_height
from laplace_core.trained import returns
from laplace_core.trained.observations import DEFAULTS
from laplace_core.training.checkpoint import Loaded


def section(
    loaded: Loaded, observation: tuple[float, ...], action: int, name: str, *, alpha: float | None = None,
    rollout: Rollout | None = None, step: int = 0,
) -> None:  # fmt: skip
    """Learned laws at once; observed returns after a button, which needs a rollout to go on from.

    Args:
        action, name: the first action, and what it is called.
        alpha: regularisation of the opened agent's inverse.
    """
    agents = returns.beside(loaded, checkpoints.same_environment(loaded))
    if not agents:
        return
    st.html('<h2 class="panel-title">Return distributions: P(return ≤ x), by each agent</h2>')
    alphas = [alpha if each is loaded and alpha else DEFAULTS["alpha"] for each in agents]
    laws = [returns.law_of(each, observation, action, one) for each, one in zip(agents, alphas, strict=True)]
    observed = _offered(agents, rollout, step, action, name=name)
    twice = len(agents) > len({each.algorithm for each in agents})
    rows = [
        ReturnRow(returns.title(each, law, opened=twice and each is loaded), law, observed[i] if observed else None)
        for i, (each, law) in enumerate(zip(agents, laws, strict=True))
    ]
    left, right = st.container(key="codes").columns([2, 1], gap="medium")
    alt = "Cumulative distribution of the return, one panel an agent: learned and observed."
    chart(figures.returns_side_by_side(rows), "codes", alt, rows_height(len(rows)), place=left)
    with right:
        st.html(_table(rows))
        st.caption(returns.notes(agents, laws, observation, action=action, alphas=alphas))
        algorithms = [each.algorithm for each in agents]
        file = f"returns_{loaded.environment.replace(':', '-')}_step_{step}.npz"
        contents = "Returns and their probabilities for every distribution, and the observed returns."
        download("Save returns (NPZ)", lambda: laws_npz(algorithms, laws, observed), file, help=contents)


def _offered(
    agents: Sequence[Loaded], rollout: Rollout | None, step: int, action: int, *, name: str
) -> tuple[SimulatedReturns, ...] | None:
    """One row over the pictures: a button to simulate, its progress, or a summary; gives the returns."""
    with st.container(key="codes_line"):
        words, button = st.columns([5, 1], vertical_alignment="center")
        if rollout is None:
            first = f"The learned return of each agent if {name} is taken first."
            words.caption(f"{first} Roll out an episode to compare it with observed returns.")
            return None
        wish = jobs.returns(agents, rollout, step, action)
        job = wish.look()
        if job is None:
            told = returns.offer(agents[0], step, name)
            offer(wish, "Simulate returns", key="simulate returns", words=told, place=words, button_place=button)
            return None
        if job.going:
            progress(job, "Simulating: {share:.0%}", wish.cancel, key="cancel returns")
            return None
        observed = attempt(job.result)
        if observed is not None:
            words.caption(returns.summary(observed, step, name))
        return observed


def _table(rows: Sequence[ReturnRow]) -> str:
    """The numbers of the pictures, one line for each agent."""
    heads = ("", "W1", "by chance", "mean learned", "mean observed")
    hints = ("", "area between learned and observed, in reward", "W1 of as many draws from the learned distribution",
             "in reward, discounted", "in reward, discounted; +- one standard error")  # fmt: skip
    lines = ["".join(f'<th title="{hint}">{head}</th>' for head, hint in zip(heads, hints, strict=True))]
    for row in rows:
        cells = [escape(row.name.split(",")[0]), "", "", f"{row.law.mean:.4g}", ""]
        if row.observed is not None:
            mean, error = row.observed.mean
            many = len(row.observed.returns) > 1
            cells[1] = f"{row.observed.distance(row.law):.3g}"
            cells[2] = f"{row.observed.by_chance:.2g}" if many else "none"
            cells[4] = f"{mean:.4g} ± {error:.2g}" if many else f"{mean:.4g}"
        lines.append("".join(f"<td>{cell or '–'}</td>" for cell in cells))
    return f'<table class="numbers">{"".join(f"<tr>{line}</tr>" for line in lines)}</table>'
