"""A widget for a parameter: it shows the value that holds and keeps what a person sets."""

from __future__ import annotations

import math
from typing import Any

import streamlit as st

from app.session import store
from laplace_core.parameters import Parameter


def number(key: str, parameter: Parameter, value: object, label: str) -> None:
    store.show(key, value)
    kept: dict[str, Any] = {"key": key, "on_change": store.keep, "args": (key,), "help": parameter.help}
    if parameter.type is bool:
        st.checkbox(label, **kept)
    elif parameter.choices:
        st.selectbox(label, parameter.choices, **kept)
    elif parameter.type is int:
        low, high = parameter.bounds
        st.number_input(label, int(low), int(high), step=1, **kept)
    else:
        low, high = parameter.bounds
        step = 0.01 if high <= 1 else 0.5
        if parameter.default:  # a small number moves by its last digit
            step = min(step, 10.0 ** math.floor(math.log10(abs(float(parameter.default)))))
        st.number_input(label, float(low), float(high), step=step, format="%g", **kept)
