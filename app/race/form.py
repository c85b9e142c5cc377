"""The race of the page: the form, the track under its verdict, and the downloads."""

from __future__ import annotations

from functools import partial
from html import escape

import streamlit as st

from app.catalogue import checkpoints
from app.components.track import track
from app.components.waiting import attempt, offer, progress
from app.components.widgets import discount, download, field, select
from app.race import jobs, schema
from app.race.schema import AGAINST, AGENT
from app.session import store
from laplace_core.acting.race import FIRST_START, Race
from laplace_core.acting.race_file import race_gif, race_npz
from laplace_core.acting.rules import title_of
from laplace_core.agents.capabilities import HasDiscounts
from laplace_core.environments import environment_of
from laplace_core.trained import races
from laplace_core.trained.races import AT, COUNT, GAMMA, HORIZON, LEFT, RIGHT, START, USUAL_COUNT, Control

PATIENCE = 2.5  # seconds that the page waits for a race before it speaks of progress
SECONDS = 0.06  # a step on the screen
RACING = "Racing: step {done:,} of at most {of:,}"
_SAME = "the same agent"


def choose() -> None:
    """Choose the agent."""
    listed = checkpoints.names()
    if listed:
        key, words = store.show(AGENT, schema.opening()[AGENT]), "A checkpoint that you open on the page Trained agents"
        select("Agent", listed, key, checkpoints.title, keep=store.begin_anew, help=f"{words} is listed here, too.")


def form(control: Control) -> None:
    """Deadline, start, and how either side acts; a change counts at once."""
    known, key = races.parameters(control.right, control.left), store.put(HORIZON, control.horizon)
    stops = races.horizons(control.right, control.horizon)
    st.select_slider("Deadline T (steps)", stops, key=key, on_change=_keep, args=(key,), help=known[HORIZON].help)
    field(known[START], 0, "Start", keep=_keep)
    field(known[LEFT], control.left_rule, "Left side", titles=title_of, keep=_keep)
    agent, words = control.left.agent, known[GAMMA].help
    if control.left_rule == "greedy" and isinstance(agent, HasDiscounts):
        acting = float(agent.gammas[agent.acting_head])
        at, keep = control.gamma or acting, partial(_discount, acting)
        discount("Discount of the left side", agent.gammas, GAMMA, at, keep=keep, help=words)
    others = schema.rivals(str(store.chosen()[AGENT]), control.environment)
    if others:
        titles, key = {name: checkpoints.title(name) for name in others}, store.show(AGAINST, _SAME)
        select("Agent of the left side", (_SAME, *others), key, titles, keep=_rival, help=schema.RIVAL.help)
    field(known[RIGHT], control.right_rule, "Right side", titles=title_of, keep=_keep)
    field(known[COUNT], USUAL_COUNT, "Starts to race over", step=50)


def _keep(key: str) -> None:
    """Callback: another race is shown at its end."""
    store.choose(AT, None)
    store.keep(key)


def _discount(acting: float, key: str) -> None:
    """Callback: choose a discount; the acting discount is the default."""
    chosen = st.session_state[key]
    store.choose(AT, None)
    store.choose(key, None if chosen == acting else chosen)


def _rival(key: str) -> None:
    """Callback: another agent may know other rules and discounts."""
    chosen = st.session_state[key]
    for name in (AT, LEFT, GAMMA):
        store.choose(name, None)
    store.choose(key, None if chosen == _SAME else chosen)


def raced(control: Control) -> tuple[Race, bytes] | None:
    """The race of the page; until it has ended, a button that begins it, or its progress."""
    wish = jobs.racing(control, int(store.chosen().get(START, 0)))
    job = wish.look()
    if job is None:
        words, button = st.columns([4.2, 1.2], vertical_alignment="center")
        offer(wish, "Race", key="begin race", place=words, button_place=button, primary=True)
        return None
    if job.going and not job.wait(PATIENCE):
        progress(job, RACING, wish.cancel, key="cancel race")
        st.html('<div class="race-room"></div>')  # where the race will be
        return None
    return attempt(job.result)


def verdict(tone: str, sentence: str) -> None:
    st.html(f'<div class="race-verdict {tone}">{escape(sentence)}</div>')


def show(control: Control, race: Race, packed: bytes) -> None:
    """The verdict and the track."""
    verdict(*races.verdict(race, control))
    remark = environment_of(control.environment).remark
    if remark:
        st.caption(remark)
    last = max(len(race.left), len(race.right))
    store.clamp(AT, last)
    at = min(int(store.chosen().get(AT, last)), last)
    track(
        packed, at, store.page_name(), races.sides(control), action_names=environment_of(control.environment).actions,
        on_step=lambda step: store.choose(AT, None if step >= last else step), seconds=SECONDS,
    )  # fmt: skip
    _footer(control, race, at)


def _footer(control: Control, race: Race, at: int) -> None:
    agents = {"left": store.chosen().get(AGAINST, store.chosen()[AGENT]), "right": store.chosen()[AGENT]}
    file = f"race_{race.left.environment}_T_{race.horizon}_start_{race.start}"
    with st.container(horizontal=True, vertical_alignment="center", gap="small"):
        for side, name in zip(agents, races.sides(control), strict=True):
            query = {"checkpoint": str(agents[side])} | races.inside(control, side, FIRST_START + race.start, at)
            st.page_link(
                "screens/agents.py", label=f"Look inside: {name}", icon=":material/frame_inspect:", query_params=query,
                help="The same episode with gamma-space and tau-space of every step.",
            )  # fmt: skip
        if race.left.frames and race.right.frames:
            names, moving = races.sides(control), "Both episodes side by side, as an animated GIF."
            download("GIF", lambda: race_gif(race, names, SECONDS), f"{file}.gif", help=moving)
        contents = "Observations, actions, rewards and values of every step of both episodes."
        download("NPZ", lambda: race_npz(race), f"{file}.npz", help=contents)
