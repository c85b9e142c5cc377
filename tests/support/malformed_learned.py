"""Learned files that must be refused: a valid one, broken in its bytes, its header, its metadata and its tensors.

``cases(good)`` yields (id, content of the file, words that the refusal must contain).
"""

from __future__ import annotations

import io
import json
import pickle
import struct
import zipfile
from collections.abc import Callable, Iterator

import numpy as np

from laplace_core import load_world
from laplace_core.worlds import dump_world

Case = tuple[str, bytes, tuple[str, ...]]
DTYPES = {"F32": np.float32, "F64": np.float64, "F16": np.float16, "I64": np.int64}


class Trap:
    """Unpickling it creates a file."""

    def __init__(self, path: str):
        self.path = path

    def __reduce__(self):
        return open, (self.path, "w")


def parts(content: bytes) -> tuple[dict, bytes]:
    length = struct.unpack("<Q", content[:8])[0]
    return json.loads(content[8 : 8 + length]), content[8 + length :]


def joined(header: dict | bytes, data: bytes) -> bytes:
    text = header if isinstance(header, bytes) else json.dumps(header).encode()
    return struct.pack("<Q", len(text)) + text + data


def with_metadata(content: bytes, **changes: object) -> bytes:
    """Other metadata entries, as JSON; bytes are put in as the text that they are, None leaves one out."""
    header, data = parts(content)
    for name, value in changes.items():
        header["__metadata__"].pop(name, None)
        if value is not None:
            header["__metadata__"][name] = value.decode() if isinstance(value, bytes) else json.dumps(value)
    return joined(header, data)


def with_settings(content: bytes, **changes: object) -> bytes:
    settings = json.loads(parts(content)[0]["__metadata__"]["settings"]) | changes
    return with_metadata(content, settings={name: value for name, value in settings.items() if value != "leave out"})


def with_curve(content: bytes, **changes: object) -> bytes:
    curves = json.loads(parts(content)[0]["__metadata__"]["curves"])
    curves[0] |= changes
    return with_metadata(content, curves=curves)


def with_tensor(
    content: bytes, name: str, change: Callable[[np.ndarray], np.ndarray], dtype: str | None = None
) -> bytes:
    """One tensor changed and everything laid out again, as a well-meaning program would write it."""
    header, data = parts(content)
    arrays = {}
    for key, entry in header.items():
        if key != "__metadata__":
            first, last = entry["data_offsets"]
            arrays[key] = np.frombuffer(data[first:last], DTYPES[entry["dtype"]]).reshape(entry["shape"])
    arrays[name] = change(arrays[name].copy()).astype(DTYPES[dtype or header[name]["dtype"]])
    new, body = {"__metadata__": header["__metadata__"]}, b""
    for key, array in arrays.items():
        kind = next(kind for kind, known in DTYPES.items() if array.dtype == known)
        new[key] = {"dtype": kind, "shape": list(array.shape), "data_offsets": [len(body), len(body) + array.nbytes]}
        body += array.tobytes()
    return joined(new, body)


def with_entry(content: bytes, name: str, **changes: object) -> bytes:
    """A header entry that no longer fits the bytes."""
    header, data = parts(content)
    header[name] = header.get(name, {}) | changes
    return joined(header, data)


def put(value: float) -> Callable[[np.ndarray], np.ndarray]:
    def change(array: np.ndarray) -> np.ndarray:
        array.flat[-1] = value
        return array

    return change


def cases(good: bytes, trap: str) -> Iterator[Case]:
    """``good``: two seeds of ``two_branch``, with peers; ``trap``: a path that unpickling would create."""
    yield from _bytes(good, trap)
    yield from _headers(good)
    yield from _metadata(good)
    yield from _settings(good)
    yield from _curves(good)
    yield from _tensors(good)


def _bytes(good: bytes, trap: str) -> Iterator[Case]:
    zipped = io.BytesIO()
    with zipfile.ZipFile(zipped, "w") as archive:
        archive.writestr("basis.npy", b"x" * 100)
    yield "empty", b"", ("own.safetensors", "0 bytes")
    yield "seven bytes", good[:7], ("7 bytes",)
    yield "a pickle", pickle.dumps(Trap(trap)), ("own.safetensors",)
    yield "a pickle behind a length", joined(pickle.dumps(Trap(trap)), b""), ("not JSON",)
    yield "a zip", zipped.getvalue(), ("own.safetensors",)
    yield "text", b"hello, this is no tensor file at all", ("own.safetensors",)
    yield "zeros", bytes(1000), ("header",)
    yield "header beyond the file", struct.pack("<Q", 2**20) + good[8:], ("cut short",)
    yield "header of 2^63 bytes", struct.pack("<Q", 2**63) + good[8:], ("header",)
    yield "header above the limit", joined(b"{" + b" " * 8_000_000 + b"}", b""), ("header",)
    yield "cut in the tensors", good[:-1], ("tensors",)
    yield "cut in half", good[: len(good) // 2], ()
    yield "one byte more", good + b"\0", ("tensors",)


def _headers(good: bytes) -> Iterator[Case]:
    header, data = parts(good)
    text = json.dumps(header)
    yield "a list", joined(b"[]", data), ("JSON object",)
    yield "not UTF-8", joined(b'{"\xff": 1}', data), ("not JSON",)
    yield "nested without end", joined(b"[" * 100_000, data), ("not JSON",)
    yield "a number of 10,000 digits", joined(b'{"a": ' + b"9" * 10_000 + b"}", data), ("not JSON",)
    yield "NaN in the header", joined(text.replace('"basis"', '"x": NaN, "basis"').encode(), data), ("NaN",)
    twice = text[:-1] + f', "basis": {json.dumps(header["basis"])}}}'
    yield "a tensor twice", joined(twice.encode(), data), ("twice",)
    yield "no metadata", joined({k: v for k, v in header.items() if k != "__metadata__"}, data), ("metadata",)
    yield "metadata a list", joined(header | {"__metadata__": []}, data), ("metadata",)
    yield "metadata of numbers", joined(header | {"__metadata__": {"kind": 1}}, data), ("no text",)
    yield "an entry a list", joined(header | {"basis": []}, data), ("'basis'",)
    yield "an entry without dtype", joined(header | {"basis": {"shape": [1]}}, data), ("'basis'", "dtype")
    yield "an unknown tensor", with_entry(good, "extra", **header["basis"]), ("'extra'",)
    yield "no basis", joined({k: v for k, v in header.items() if k != "basis"}, data), ("'basis'", "missing")
    yield "offsets swapped", with_entry(good, "basis", data_offsets=header["basis"]["data_offsets"][::-1]), ("tensors",)
    yield "offsets beyond", with_entry(good, "basis", data_offsets=[0, 10**12]), ("tensors",)
    yield "offsets of words", with_entry(good, "basis", data_offsets=["0", "8"]), ("tensors",)
    yield "offsets below 0", with_entry(good, "basis", data_offsets=[-8, 0]), ("tensors",)
    yield (
        "offsets shared",
        with_entry(good, "plain", data_offsets=header["acting_values"]["data_offsets"]),
        ("tensors",),
    )
    yield "shape of words", with_entry(good, "basis", shape=["2"]), ("'basis'", "shape")
    yield "shape of billions", with_entry(good, "basis", shape=[10**9] * 5), ("'basis'", "shape")
    yield "a made-up type", with_entry(good, "basis", dtype="F1000"), ("'basis'", "F1000")


def _metadata(good: bytes) -> Iterator[Case]:
    for name in ("kind", "version", "world", "settings", "curves", "finished"):
        yield f"no {name}", with_metadata(good, **{name: None}), (f"'{name}'",)
        yield f"{name} is no JSON", with_metadata(good, **{name: b"{"}), (f"'{name}'", "JSON")
        yield f"{name} is null", with_metadata(good, **{name: b"null"}), ()
    yield "another kind", with_metadata(good, kind="weights"), ("'kind'",)
    yield "an unknown entry", with_metadata(good, surprise=1), ("'surprise'",)
    yield "a later version", with_metadata(good, version=2), ("version 2",)
    yield "version true", with_metadata(good, version=True), ("version",)
    yield "finished 1", with_metadata(good, finished=1), ("'finished'",)
    yield "no such preset", with_metadata(good, world={"source": "nowhere", "params": {}}), ("'nowhere'",)
    yield "a path", with_metadata(good, world={"source": "/etc/passwd", "params": {}}), ("preset",)
    yield "a file", with_metadata(good, world={"source": "world.json", "params": {}}), ("preset",)
    yield "an unlisted environment", with_metadata(good, world={"source": "gym:Blackjack-v1", "params": {}}), ("gym:",)
    yield "no such parameter", with_metadata(good, world={"source": "two_branch", "params": {"x": 1}}), ("'x'",)
    yield (
        "a parameter out of range",
        with_metadata(good, world={"source": "two_branch", "params": {"length": 1e9}}),
        ("length",),
    )
    yield "parameters a list", with_metadata(good, world={"source": "two_branch", "params": []}), ("preset",)
    yield "source and text", with_metadata(good, world={"source": "two_branch", "text": ""}), ("'world'",)
    yield "a broken world", with_metadata(good, world={"text": "{}"}), ("'states'",)
    bigger = dump_world(load_world("two_branch", {"length": 20}))
    yield "a world of more states than the table", with_metadata(good, world={"text": bigger}), ("shape",)
    yield "another preset", with_metadata(good, world={"source": "cliff_grid", "params": {}}), ("shape",)


def _settings(good: bytes) -> Iterator[Case]:
    yield "settings a list", with_metadata(good, settings=[]), ("'settings'",)
    yield "a setting too few", with_settings(good, epsilon_half="leave out"), ("'settings'",)
    yield "a setting too many", with_settings(good, surprise=1), ("'settings'",)
    yield "a setting null", with_settings(good, episodes=None), ("'episodes'",)
    yield "a number as text", with_settings(good, episodes="200"), ("'episodes'",)
    yield "a truth as number", with_settings(good, seeds=True), ("'seeds'",)
    yield "a number as truth", with_settings(good, peers=1), ("'peers'",)
    yield "a setting twice", with_metadata(good, settings=b'{"seeds": 1, "seeds": 2}'), ("twice",)
    yield "infinite", with_metadata(good, settings=b'{"seeds": Infinity}'), ("Infinity",)
    yield "too many seeds", with_settings(good, seeds=9), ("seeds",)
    yield "other seeds than the table", with_settings(good, seeds=1), ("'curves'",)
    yield "a discount of 1", with_settings(good, gamma_max=1.0), ("gamma_max",)
    yield "discounts in the wrong order", with_settings(good, gamma_min=0.99, gamma_max=0.1), ("gamma",)
    yield "other discounts than the table", with_settings(good, gammas=16), ("shape",)
    yield "the paper's spacing with other ends", with_settings(good, spacing="paper", gamma_min=0.5), ("contradict",)
    yield "a policy unheard of", with_settings(good, policy="best"), ("policy",)
    yield "a floor above the first", with_settings(good, rate_floor=0.9, rate_first=0.5), ("rate_floor",)
    yield "more atoms than the table", with_settings(good, atoms=52), ("'categorical'",)
    yield "an even number of expectiles", with_settings(good, expectiles=10), ("expectiles",)
    yield "tables beyond all files", with_settings(good, gammas=500, seeds=8, atoms=500, quantiles=500), ()
    yield "no peers but their tables", with_settings(good, peers=False), ("unknown tensor",)


def _curves(good: bytes) -> Iterator[Case]:
    yield "curves an object", with_metadata(good, curves={}), ("'curves'",)
    yield "one curve too few", with_metadata(good, curves=[{}]), ("'curves'",)
    yield "a curve without columns", with_metadata(good, curves=[{}, {}]), ("curve",)
    yield "columns of different length", with_curve(good, error=[1.0]), ("'error'",)
    yield "a word in a curve", with_curve(good, episode=[1], error=["x"]), ("curve",)
    yield "a column a number", with_curve(good, error=1), ("'error'",)
    length = len(json.loads(parts(good)[0]["__metadata__"]["curves"])[0]["error"])
    yield "huge numbers", with_curve(good, error=[1e300] * length), ("'error'",)
    yield "episodes that fall", with_curve(good, episode=list(range(length, 0, -1))), ("'episode'",)
    yield "episodes beyond the last", with_curve(good, episode=list(range(10_000, 10_000 + length))), ("'episode'",)
    long = {key: list(range(1, 6_000)) for key in ("episode", "steps", "return", "epsilon", "change", "error")}
    yield "a curve without end", with_metadata(good, curves=[long, long]), ("5,000",)


def _tensors(good: bytes) -> Iterator[Case]:
    for name in ("basis", "acting_values", "laplace_values", "plain", "categorical", "quantile", "expectile"):
        for value in (np.nan, np.inf, -np.inf):
            yield f"{name} with {value}", with_tensor(good, name, put(value)), (f"'{name}'", "finite")
        yield f"{name} too large", with_tensor(good, name, put(1e6)), (f"'{name}'",)
        yield f"{name} of another shape", with_tensor(good, name, lambda array: array[..., :1]), (f"'{name}'", "shape")
        yield f"{name} flat", with_tensor(good, name, np.ravel), (f"'{name}'", "shape")
        yield f"{name} of whole numbers", with_tensor(good, name, lambda array: array, "I64"), (f"'{name}'", "I64")
    yield "a count below 0", with_tensor(good, "basis", put(-0.5)), ("'basis'",)
    yield "counts that add up to too much", with_tensor(good, "basis", lambda array: array + 40.0), ("'basis'",)
    yield "masses below 0", with_tensor(good, "categorical", put(-0.5)), ("'categorical'",)
    yield "masses that do not add up", with_tensor(good, "categorical", lambda array: array * 0.9), ("'categorical'",)
