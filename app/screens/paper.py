"""The paper: each of its figures, tables and claims beside ours, with the command that reproduces ours."""

from __future__ import annotations

import streamlit as st

from app.paper import results, sections
from app.paper.schema import LINK
from app.session import store
from app.view import explain


def page() -> None:
    store.open_page("paper", LINK)
    store.write_url()
    st.markdown(
        "*Laplace DQN: Deep RL Algorithm for Temporally Flexible Planning*, figure by figure: the numbers of the paper "
        "beside ours, from the raw results that come with the workbench."
    )
    found = results.found()
    with st.sidebar:
        sections.contents(found)
    explain.guide("paper")
    sections.overview(found)
    for each in found:
        sections.section(each)


page()
