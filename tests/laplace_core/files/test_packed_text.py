"""Texts packed into one word: they come back whole, or are refused in one sentence."""

from __future__ import annotations

import base64
import zlib

import pytest
from hypothesis import given
from hypothesis import strategies as st

from laplace_core import InputError
from laplace_core.files.packed_text import pack, unpack
from tests.support.hostile import assert_one_sentence

WORD = pack('{"name": "my_world"}' * 20)


@given(st.text())
def test_every_text_comes_back(text):
    if any("\ud800" <= character <= "\udfff" for character in text):
        return
    assert unpack(pack(text)) == text


@given(st.text(max_size=2_000))
def test_a_packed_word_needs_no_escape_in_a_link(text):
    assert set(pack(text)) <= set("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_")


DAMAGED = {
    "empty": "",
    "cut off": WORD[:-8],
    "cut off within four": WORD[:-1],
    "first letter lost": WORD[1:],
    "another letter": WORD[:20] + ("A" if WORD[20] != "A" else "B") + WORD[21:],
    "blank": WORD[:10] + " " + WORD[10:],
    "line break": WORD[:10] + "\n" + WORD[10:],
    "plus": WORD[:10] + "+" + WORD[11:],
    "not latin": WORD + "ß",
    "not ascii digits": "１２３４",
    "nul": WORD + "\x00",
    "half a character": "\ud800",
    "no deflate": base64.urlsafe_b64encode(b"plain text").decode().rstrip("="),
    "not utf-8": base64.urlsafe_b64encode(zlib.compress(b"\xff\xfe\xfa")).decode().rstrip("="),
    "a bomb": base64.urlsafe_b64encode(zlib.compress(b"0" * 50_000_000, 9)).decode().rstrip("="),
    "long": "A" * 200_000,
}


def test_a_damaged_word_is_refused_in_one_sentence(subtests):
    for kind in DAMAGED:
        with subtests.test(kind):
            with pytest.raises(InputError) as refused:
                unpack(DAMAGED[kind])
            assert_one_sentence(str(refused.value), "copy it again")


@given(st.text(max_size=300))
def test_any_text_is_unpacked_or_refused(word):
    try:
        unpack(word)
    except InputError as error:
        assert_one_sentence(str(error))
