"""The documents of ``docs/``, one at a time."""

from __future__ import annotations

import streamlit as st

from app.session import store
from laplace_core.exchange.links import Entries, Schema, by_name
from laplace_core.files import documents
from laplace_core.parameters import Parameter

TITLES = documents.titles()
PAGE = Parameter("page", next(iter(TITLES), ""), help="The document to show.", choices=tuple(TITLES))
LINK = Schema(opening=dict, steps=(Entries(by_name(PAGE)),))
READABLE = 800  # pixels of a line of text


def page() -> None:
    store.open_page("guide", LINK)
    store.write_url()
    if not TITLES:
        st.info("The documents are not installed here: they are in the folder `docs` of the project.")
        return
    name = str(store.chosen().get("page", PAGE.default))
    key = store.show("page", name)
    st.sidebar.radio("Documents", list(TITLES), format_func=TITLES.get, key=key, on_change=store.keep, args=(key,))
    with st.container(key="guide"):
        for part in documents.parts(name, "guide?page="):
            if isinstance(part, documents.Picture):
                st.image(part.path, caption=part.words, width=READABLE)
            else:
                st.markdown(part, width=READABLE)


page()
