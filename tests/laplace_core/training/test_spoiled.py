"""Ways to spoil a checkpoint: each takes the bytes of a good one and returns others that must be refused."""

from __future__ import annotations

import io
import json
import os
import pickle
import struct
import zipfile

import numpy as np
import safetensors.numpy
import torch


def parts(data: bytes) -> tuple[dict, bytes]:
    length = struct.unpack("<Q", data[:8])[0]
    return json.loads(data[8 : 8 + length]), data[8 + length :]


def joined(header: object, body: bytes) -> bytes:
    text = header if isinstance(header, bytes) else json.dumps(header).encode()
    return struct.pack("<Q", len(text)) + text + body


def about(**changes):
    """Change entries of the metadata; None takes one away, and anything callable changes what is there."""

    def spoil(data: bytes) -> bytes:
        header, body = parts(data)
        kept = json.loads(header["__metadata__"]["laplace"])
        for key, value in changes.items():
            kept[key] = value(kept.get(key)) if callable(value) else value
        kept = {key: value for key, value in kept.items() if value is not REMOVED}
        header["__metadata__"]["laplace"] = json.dumps(kept)
        return joined(header, body)

    return spoil


REMOVED = object()


def setting(**changes):
    return about(settings=lambda kept: kept | changes)


def metadata(value: object):
    def spoil(data: bytes) -> bytes:
        header, body = parts(data)
        header["__metadata__"] = value
        return joined(header, body)

    return spoil


def entry(change):
    """Change the header's entry of the head's bias; ``change`` gets it and may return another one."""

    def spoil(data: bytes) -> bytes:
        header, body = parts(data)
        header["head.bias"] = change(header["head.bias"])
        return joined(header, body)

    return spoil


def arrays(change):
    """Change the arrays and save them properly, with the metadata as it was."""

    def spoil(data: bytes) -> bytes:
        found = safetensors.numpy.load(data)
        change(found)
        return safetensors.numpy.save(found, parts(data)[0]["__metadata__"])

    return spoil


def set_array(name: str, value):
    return arrays(lambda found: found.__setitem__(name, value(found.get(name))))


def put(value: float):
    def change(array: np.ndarray) -> np.ndarray:
        array = array.copy()
        array.flat[0] = value
        return array

    return change


def zipped(data: bytes) -> bytes:
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w") as archive:
        archive.writestr("data.pkl", b"x" * 2_000)
    return file.getvalue()


class Evil:
    def __reduce__(self):
        return (os.system, ("touch /tmp/laplace-was-here",))


def header_text(change):
    def spoil(data: bytes) -> bytes:
        header, body = parts(data)
        return joined(change(json.dumps(header)).encode(), body)

    return spoil


def double_offsets(data: bytes) -> bytes:
    """Two arrays of one size that share their bytes."""
    header, body = parts(data)
    names = [name for name in header if name != "__metadata__"]
    biases = [name for name in names if header[name]["shape"] == [4]]
    header[biases[0]]["data_offsets"] = header[biases[1]]["data_offsets"]
    return joined(header, body)


HOSTILE = {
    "empty": lambda data: b"",
    "one byte": lambda data: data[:1],
    "only a length": lambda data: data[:8],
    "cut in the header": lambda data: data[:100],
    "cut in the arrays": lambda data: data[:-1],
    "padded": lambda data: data + b"\0",
    "header of 2^63 bytes": lambda data: struct.pack("<Q", 2**63) + data[8:],
    "header of 2^64 - 1 bytes": lambda data: b"\xff" * 8 + data[8:],
    "header longer than the file": lambda data: struct.pack("<Q", len(data)) + data[8:],
    "header above the limit": lambda data: joined(b"{" + b" " * 2_000_000 + b"}", b""),
    "header one byte short": lambda data: struct.pack("<Q", struct.unpack("<Q", data[:8])[0] - 1) + data[8:],
    "header of length 0": lambda data: struct.pack("<Q", 0) + data[8:],
    "header no JSON": header_text(lambda text: text[:-1] + ","),
    "header not UTF-8": lambda data: joined(b'{"\xff\xfe": 1}', b""),
    "header a list": lambda data: joined([], b""),
    "header a number": lambda data: joined(b"12345678901", b""),
    "header deeply nested": lambda data: joined(b"[" * 100_000, b""),
    "header with a name twice": header_text(lambda text: text[:-1] + ', "head.bias": {}}'),
    "header with NaN": header_text(lambda text: text.replace("[0,", "[NaN,", 1).replace("[0, ", "[NaN, ", 1)),
    "pickle": lambda data: pickle.dumps(Evil()),
    "pickle of a torch file": lambda data: torch_file(),
    "zip": zipped,
    "random bytes": lambda data: np.random.default_rng(0).bytes(5_000),
    "text": lambda data: b"hello, I am a checkpoint\n" * 10,
    "no metadata": lambda data: joined(
        {k: v for k, v in parts(data)[0].items() if k != "__metadata__"}, parts(data)[1]
    ),
    "metadata a list": metadata([]),
    "metadata a text": metadata("x"),
    "metadata without ours": metadata({"format": "pt"}),
    "metadata with more": metadata({"laplace": "{}", "format": "pt"}),
    "metadata not JSON": metadata({"laplace": "{'a': 1}"}),
    "metadata JSON list": metadata({"laplace": "[]"}),
    "metadata a number": metadata({"laplace": 5}),
    "metadata with infinity": metadata({"laplace": '{"score": Infinity}'}),
    "metadata empty": metadata({"laplace": "{}"}),
    "no algorithm": about(algorithm=REMOVED),
    "unknown algorithm": about(algorithm="ppo"),
    "algorithm a list": about(algorithm=["laplace"]),
    "unknown environment": about(environment="Ant-v5", settings=lambda kept: kept | {"environment": "Ant-v5"}),
    "environment of a module": about(
        environment="os:system", settings=lambda kept: kept | {"environment": "os:system"}
    ),
    "environment contradicted": about(environment="Acrobot-v1"),
    "another environment": about(environment="Acrobot-v1", settings=lambda kept: kept | {"environment": "Acrobot-v1"}),
    "seed contradicted": about(seed=8),
    "seed a truth value": about(seed=True),
    "step negative": about(step=-1),
    "step a fraction": about(step=1.5),
    "score a text": about(score="500"),
    "score beyond reason": about(score=1e300),
    "version a number": about(version=1),
    "version endless": about(version="1" * 1_000),
    "more entries": about(run="os.system"),
    "settings a list": about(settings=[]),
    "settings unknown": setting(code="import os"),
    "settings of the wrong type": setting(hidden="4"),
    "settings a truth value": setting(hidden=True),
    "settings a list inside": setting(learning_rate=[1]),
    "settings null": setting(gammas=None),
    "settings out of range": setting(gammas=10**9),
    "settings of a giant network": setting(hidden=1024, features=512, gammas=100, thetas=1000),
    "settings of a larger network": setting(hidden=5),
    "settings of another network": setting(network="multiplexer"),
    "settings of no discount grid": setting(gamma_min=0.999),
    "settings of no sensitivities": setting(theta_min=5.0),
    "entry not an object": entry(lambda kept: 5),
    "entry without a shape": entry(lambda kept: {k: v for k, v in kept.items() if k != "shape"}),
    "entry with more": entry(lambda kept: kept | {"code": "x"}),
    "entry of an unknown dtype": entry(lambda kept: kept | {"dtype": "OBJECT"}),
    "entry with a dtype list": entry(lambda kept: kept | {"dtype": ["F32"]}),
    "entry of a negative shape": entry(lambda kept: kept | {"shape": [-2, -5]}),
    "entry of a huge shape": entry(lambda kept: kept | {"shape": [2**62, 2**62]}),
    "entry of a shape of truth": entry(lambda kept: kept | {"shape": [True, 10]}),
    "entry of another size": entry(lambda kept: kept | {"shape": [3, 5]}),
    "entry of a hundred dimensions": entry(lambda kept: kept | {"shape": [*kept["shape"], *[1] * 100]}),
    "entry with offsets reversed": entry(lambda kept: kept | {"data_offsets": kept["data_offsets"][::-1]}),
    "entry with offsets beyond": entry(lambda kept: kept | {"data_offsets": [10**6, 10**6 + 40]}),
    "entry with one offset": entry(lambda kept: kept | {"data_offsets": [0]}),
    "arrays that overlap": double_offsets,
    "array missing": arrays(lambda found: found.pop("head.bias")),
    "array of no use": set_array("evil", lambda _: np.zeros(3, np.float32)),
    "array renamed": arrays(lambda found: found.__setitem__("head.bia", found.pop("head.bias"))),
    "array turned": set_array("head.bias", lambda array: np.ascontiguousarray(array.T)),
    "array flat": set_array("head.bias", np.ravel),
    "array of doubles": set_array("head.bias", lambda array: array.astype(np.float64)),
    "array of whole numbers": set_array("head.bias", lambda array: array.astype(np.int32)),
    "array with NaN": set_array("head.bias", put(np.nan)),
    "array with infinity": set_array("trunk.0.weight", put(-np.inf)),
    "array beyond reason": set_array("trunk.0.weight", put(1e30)),
}


def torch_file() -> bytes:
    file = io.BytesIO()
    torch.save({"head.bias": torch.zeros(3)}, file)
    return file.getvalue()
