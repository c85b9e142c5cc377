"""The reader of tensor files: size first, then safetensors' own checks, then a schema."""

from __future__ import annotations

import os

import numpy as np
import pytest
from safetensors.numpy import save

from laplace_core.errors import InputError
from laplace_core.files.tensors import parse_tensor_file, read_bytes
from tests.laplace_core.training.test_spoiled import joined, parts
from tests.support.hostile import assert_one_sentence

GOOD = save({"a": np.arange(6, dtype=np.float32).reshape(2, 3), "b": np.ones(2)}, {"kind": "test"})
SHAPES = {"a": ("F32", (2, 3)), "b": ("F64", (2,))}
DTYPES = ("F32", "F64")


def read(content: bytes, shapes=SHAPES, dtypes=DTYPES):
    return parse_tensor_file(content, "x.safetensors", most_bytes=1000, most_header=500).load(dtypes, shapes)


@pytest.mark.parametrize("shapes", [SHAPES, None])
def test_tensors_come_back_as_arrays_that_can_be_changed(shapes):
    found = read(GOOD, shapes)
    assert set(found) == {"a", "b"}
    np.testing.assert_array_equal(found["a"], [[0, 1, 2], [3, 4, 5]])
    assert found["b"].dtype == np.float64
    found["a"][0, 0] = 7


def test_what_differs_from_the_schema_is_refused(subtests):
    for shapes, dtypes, named in [
        ({"a": ("F32", (2, 3))}, DTYPES, "unknown tensor 'b'"),
        (SHAPES | {"c": ("F32", (1,))}, DTYPES, "'c' is missing"),
        (SHAPES | {"a": ("F64", (2, 3))}, DTYPES, "is F32; it must be F64"),
        (SHAPES | {"a": ("F32", (3, 2))}, DTYPES, "has shape [2, 3]; it must be [3, 2]"),
        (None, ("F64",), "is F32; it must be F64"),
        (None, ("I32", "I64"), "must be I32 or I64"),
    ]:
        with subtests.test(named):
            with pytest.raises(InputError) as refused:
                read(GOOD, shapes, dtypes)
            assert_one_sentence(str(refused.value), named)


def spoil(**changes) -> bytes:
    header, body = parts(GOOD)
    header["a"] |= changes
    return joined(header, body)


def test_files_that_are_not_whole_are_refused(subtests):
    for content in [
        b"", GOOD[:9], GOOD[:-1], GOOD + b"\0", joined({}, b"") + bytes(1000), joined(b"{" + b" " * 600 + b"}", b""),
        joined([], b""), spoil(data_offsets=[0, 8]), spoil(data_offsets=[8, 32]), spoil(dtype=["F32"]),
        spoil(dtype="OBJECT"), spoil(shape=[True, 6]), spoil(shape=[-2, -3]), spoil(shape=[2**62, 2**62]),
        spoil(shape=[2, 3] + [1] * 100), spoil(more=1), spoil(shape={}),
    ]:  # fmt: skip
        for shapes in [SHAPES, None]:
            with subtests.test(content=content, shapes=shapes):
                with pytest.raises(InputError) as refused:
                    read(content, shapes)
                assert_one_sentence(str(refused.value))


@pytest.mark.parametrize("kind", ["missing", "folder", "pipe", "too large", "zero byte"])
def test_what_is_no_plain_file_is_refused_without_waiting(tmp_path, kind):
    path = tmp_path / ("a\0b" if kind == "zero byte" else "file")
    if kind == "folder":
        path.mkdir()
    elif kind == "pipe":
        os.mkfifo(path)
    elif kind == "too large":
        path.write_bytes(bytes(11))
    with pytest.raises(InputError) as refused:
        read_bytes(path, "the file", most_bytes=10)
    assert_one_sentence(str(refused.value))
    assert read_bytes(__file__, "the test", most_bytes=10**6).startswith(b'"""The reader')
