"""The race of the page: the form, the track under its verdict, and what can be taken along."""

from __future__ import annotations

from dataclasses import dataclass, field
from html import escape

import numpy as np
import streamlit as st

from app import session
from app.catalogue import checkpoints
from app.catalogue.rules import title_of
from app.catalogue.scenes import scene_of
from app.components.track import track
from app.race import jobs, schema, words
from app.race.jobs import Control
from app.race.schema import AGAINST, AGENT, AT, COUNT, GAMMA, HORIZON, LEFT, RIGHT, START
from app.session import store
from app.session.background import Work
from laplace_core import InputError
from laplace_core.acting.frames import animation, side_by_side
from laplace_core.acting.race import FIRST_START, MOST_RACES, MOST_START, Race
from laplace_core.acting.race_file import race_npz
from laplace_core.agents.capabilities import HasDiscounts
from laplace_core.environments import environment_of

LOOK_EVERY = 0.4  # seconds between two looks at a race in the making
PATIENCE = 2.5  # seconds that the page waits for a race before it speaks of progress
SECONDS = 0.06  # a step on the screen
_SAME = "the same agent"


def choose() -> None:
    """Which agent."""
    listed = checkpoints.names()
    if listed:
        key = store.show(AGENT, schema.opening()[AGENT])
        st.selectbox(
            "Agent", listed, key=key, on_change=_another, format_func=checkpoints.title,
            help="A checkpoint opened on the page of trained agents is listed here, too.",
        )  # fmt: skip


def _another() -> None:
    """Callback: rules and the number of starts mean the same for another agent, all else does not."""
    store.replace_all({AGENT: st.session_state[AGENT]})


def form(control: Control) -> None:
    """Deadline, start, and how either side acts; a change counts at once."""
    key = store.put(HORIZON, control.horizon)
    st.select_slider(
        "Deadline T (steps)", schema.horizons(control.right, control.horizon), key=key, on_change=_keep, args=(key,),
        help="Both episodes are stopped after so many steps.",
    )  # fmt: skip
    key = store.show(START, 0)
    st.number_input(
        "Start", 0, MOST_START, step=1, key=key, on_change=_keep, args=(key,),
        help="Both sides begin from it. No agent was trained or chosen on any of these starts.",
    )  # fmt: skip
    _left(control)
    key = store.put(RIGHT, control.right_rule)
    st.selectbox(
        "Right side", schema.rules_of(control.right.agent), key=key, format_func=title_of, on_change=_keep,
        args=(key,), help="The rule by which the agent acts for the time to go.",
    )  # fmt: skip
    key = store.show(COUNT, schema.USUAL_COUNT)
    st.number_input(
        "Starts to race over", 2, MOST_RACES, step=50, key=key, on_change=store.keep, args=(key,),
        help="From start 0 on; more starts make the interval narrower.",
    )  # fmt: skip


def _left(control: Control) -> None:
    key = store.put(LEFT, control.left_rule)
    st.selectbox(
        "Left side", schema.rules_of(control.left.agent), key=key, format_func=title_of, on_change=_keep,
        args=(key,), help="What the right side is held against.",
    )  # fmt: skip
    if control.left_rule == "greedy" and isinstance(control.left.agent, HasDiscounts):
        gammas = [float(gamma) for gamma in control.left.agent.gammas]
        at = control.gamma or gammas[control.left.agent.acting_head]
        key = store.put(GAMMA, min(gammas, key=lambda gamma: abs(gamma - at)))
        st.selectbox(
            "Discount of the left side", gammas, key=key, format_func="{:.4g}".format, on_change=_discount,
            args=(gammas[control.left.agent.acting_head],), help="It takes the best action at this discount.",
        )  # fmt: skip
    others = schema.rivals(str(store.chosen()[AGENT]), control.environment)
    if others:
        key = store.put(AGAINST, store.chosen().get(AGAINST, _SAME))
        st.selectbox(
            "Agent of the left side", (_SAME, *others), key=key, on_change=_rival,
            format_func=lambda name: name if name == _SAME else checkpoints.title(name),
            help="Another agent of this environment.",
        )  # fmt: skip


def _keep(key: str) -> None:
    """Callback: another race is shown at its end."""
    store.choose(AT, None)
    store.keep(key)


def _discount(acting: float) -> None:
    """Callback: the acting discount is what holds where none is chosen."""
    chosen = st.session_state[GAMMA]
    store.choose(AT, None)
    store.choose(GAMMA, None if chosen == acting else chosen)


def _rival() -> None:
    """Callback: another agent may know other rules and discounts."""
    chosen = st.session_state[AGAINST]
    for name in (AT, LEFT, GAMMA):
        store.choose(name, None)
    store.choose(AGAINST, None if chosen == _SAME else chosen)


def begun(control: Control) -> jobs.Racing:
    """The race that the page shows: at its end, if that takes a moment only."""
    racing = jobs.racing(control, int(store.chosen().get(START, 0)))
    only("race", racing)
    racing.wait(PATIENCE)
    return racing


@dataclass
class _Asked:
    """What this session has asked for last: one race, and one field of many."""

    work: dict[str, Work] = field(default_factory=dict)


def only(name: str, work: Work) -> None:
    """Nobody waits any more for what this session had asked for before."""
    asked = session.part(_Asked).work
    before = asked.get(name)
    if before is not None and before is not work and before.going:
        before.cancel()
    asked[name] = work


def progress(work: Work, what: str) -> None:
    """How far it is; the page is drawn anew when it is done."""
    if not work.going:
        st.rerun()
    share = work.done / work.of if work.of else 0.0
    words = f"step {work.done:,} of at most {work.of:,}" if work.of else "waits for other work of this server"
    st.progress(min(1.0, share), f"{what}: {words}")


def said(tone: str, sentence: str) -> None:
    st.html(f'<div class="race-verdict {tone}">{escape(sentence)}</div>')


def show(control: Control, racing: jobs.Racing) -> None:
    """The verdict and the track."""
    race, packed = racing.result()
    said(*words.verdict(race, control))
    remark = environment_of(control.environment).remark
    if remark:
        st.caption(remark)
    last = max(len(race.left), len(race.right))
    at = min(int(store.chosen().get(AT, last)), last)

    def heard(step: int) -> None:
        store.choose(AT, None if step >= last else step)

    track(
        packed,
        at,
        store.page_name(),
        words.sides(control),
        action_names=scene_of(control.environment).actions,
        on_step=heard,
        seconds=SECONDS,
    )
    _footer(control, race, at)


def _footer(control: Control, race: Race, at: int) -> None:
    agents = {"left": store.chosen().get(AGAINST, store.chosen()[AGENT]), "right": store.chosen()[AGENT]}
    file = f"race_{race.left.environment}_T_{race.horizon}_start_{race.start}"
    with st.container(horizontal=True, vertical_alignment="center", gap="small"):
        for side, name in zip(agents, words.sides(control), strict=True):
            query = {"checkpoint": str(agents[side])} | words.inside(control, side, FIRST_START + race.start, at)
            st.page_link(
                "screens/agents.py", label=f"Look inside: {name}", icon=":material/frame_inspect:", query_params=query,
                help="The same episode with gamma-space and tau-space of every step.",
            )  # fmt: skip
        if race.left.frames and race.right.frames:
            st.download_button(
                "GIF", lambda: _gif(race, words.sides(control)), file_name=f"{file}.gif", mime="image/gif",
                on_click="ignore", help="Both episodes side by side, moving.",
            )  # fmt: skip
        st.download_button(
            "NPZ", lambda: race_npz(race), file_name=f"{file}.npz", mime="application/octet-stream",
            on_click="ignore", help="Observations, actions, rewards and values of every step of both episodes.",
        )  # fmt: skip


def _gif(race: Race, names: tuple[str, str]) -> bytes:
    sums = [np.concatenate([[0.0], np.cumsum(side.rewards)]) for side in (race.left, race.right)]
    pictures = []
    for step in range(max(map(len, sums))):
        pair = [(side.frames[min(step, len(side))], total[min(step, len(side))])
                for side, total in zip((race.left, race.right), sums, strict=True)]  # fmt: skip
        (left, before), (right, after) = pair
        words = f"{names[0]}: {before:.1f}".replace("γ", "gamma"), f"{names[1]}: {after:.1f}"
        pictures.append(side_by_side(left, right, words))
    return animation(pictures, SECONDS)


def refused(work: Work) -> bool:
    """Say why there is no result, if there is none."""
    try:
        work.result()
    except InputError as error:
        st.error(str(error))
        return True
    return False
