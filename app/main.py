"""The workbench: navigation and theme. ``streamlit run app/main.py``."""

import os
import sys
from pathlib import Path

import streamlit as st

# The products of a page are small: threads for them would wait for each other longer than they work, and other sessions
# for them. numpy, which streamlit has not imported yet, looks here once.
os.environ.update(dict.fromkeys(("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"), "1") | os.environ)
sys.path.insert(0, str(Path(__file__).resolve().parent.parent))  # streamlit puts only this folder on the path

from app.catalogue import training_runs
from app.components import chart, page
from app.session import collector
from laplace_core import InputError
from laplace_core.supervise import limits

st.set_page_config(page_title=page.NAME, page_icon="∑", layout="wide")
st.html(Path(__file__).with_name("style.css"))
chart.preload()
try:
    limits.enforce()
except InputError as error:
    st.error(str(error))
    st.stop()
training_runs.wake()
st.sidebar.html(f'<div class="brand">{page.NAME}</div>')
PAGES = [
    st.Page("screens/worlds.py", title="Worlds", default=True),
    st.Page("screens/inverse.py", title="Inverse", url_path="inverse"),
    st.Page("screens/agents.py", title="Trained agents", url_path="agents"),
    st.Page("screens/race.py", title="Deadline race", url_path="race"),
    st.Page("screens/train.py", title="Train", url_path="train"),
    st.Page("screens/paper.py", title="Paper", url_path="paper"),
    st.Page("screens/guide.py", title="Guide", url_path="guide"),
]
shown = st.navigation(PAGES, position="top")
title = getattr(shown, "title", "")  # outside of a session a page has none
if title == "Guide":  # its documents bring headings of their own, and are to be read
    page.begin(title, skip="Skip to the text", heading=False)
else:
    page.begin(title, skip="Skip to the picture")
shown.run()
collector.settle(title)
