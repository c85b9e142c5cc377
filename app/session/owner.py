"""The owner of training runs: a random word that the browser keeps, and by which it proves that a run is its own.

The word comes with the cookie of a connection. A browser that has none is offered one, which
:mod:`app.components.owner` hands to it. Runs hold only the digest of it, so that their files give nobody control.
"""

from __future__ import annotations

import hashlib
import re
import secrets
from dataclasses import dataclass, field
from typing import TypeGuard

import streamlit as st

from app import session

COOKIE = "laplace_owner"
_WORD = re.compile(r"[A-Za-z0-9_-]{43}")


def _known_or_new() -> str:
    word = st.context.cookies.get(COOKIE)
    return word if _is_word(word) else secrets.token_urlsafe(32)


def _is_word(told: object) -> TypeGuard[str]:
    return isinstance(told, str) and _WORD.fullmatch(told) is not None


@dataclass
class _Owner:
    word: str = field(default_factory=_known_or_new)


def word() -> str:
    """The secret word of this browser; never to be written into a link or a file."""
    return session.part(_Owner).word


def take(told: object) -> None:
    """Take over the word that the browser has already, from a tab that was opened at the same time."""
    if _is_word(told):
        session.part(_Owner).word = told


def digest() -> str:
    """The digest of the owner's word, which the run's folder holds."""
    return hashlib.sha256(word().encode()).hexdigest()
