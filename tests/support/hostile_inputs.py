"""Links and files that nobody means well by, made from a seed: for a server under load and for the tests of the pages.

Each link and each file is of one kind of :data:`LINKS` and :data:`FILES`, which take turns, so that a few of them
already cover all kinds. None is too much for a server that keeps its limits: whatever one of them asks for is to be
shown, or refused with a sentence.
"""

from __future__ import annotations

import base64
import io
import json
import random
import struct
import zipfile
import zlib
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from urllib.parse import urlencode

import numpy as np

from laplace_core.files.packed_text import pack

HOST = "evil.example"
"""Of every address in them; no browser may ever ask for it."""
NAMES = (
    f"![x](http://{HOST}/picture.png)", f"[Log in again](https://{HOST})", f"https://{HOST}/a", f"www.{HOST}",
    f"<img src=//{HOST}/x onerror=alert(1)>", "<b>x</b>", f"<a href='https://{HOST}'>y</a>",
    "<script>alert(1)</script>", "=1+1", "@SUM(A1)", "**bold** _it_ `code` ~~s~~", "$x^2$", ":red[hot] :smile:",
    ":material/home:", "# head", "- item", "1. item", "%{x} %{customdata[0]} {done}", "&lt;b&gt; &amp;", "a,\"b\";'c'",
    "\u202egnp.exe", "état ☃ 🙂", "</script>", "javascript:alert(1)", "a\\*b\\", "x" * 90,
)  # fmt: skip
"""Names that a language of the page could take for its own."""
NUMBERS = ("NaN", "inf", "-1", "1e999", "-0", "0x10", "1_000", "9" * 400, "", " ", "2,5", "½", "١٢", "1e308", "1e-320")
_PATHS = (
    "../../etc/passwd",
    "..%2f..%2fetc%2fpasswd",
    "/etc/passwd",
    "run:../../x",
    "run:..",
    "C:\\x",
    "\x00",
    "a/../b",
)
_KEYS = {
    "": ("world", "own", "timeline", "data", "state", "action", "alpha", "gammas", "thetas", "steps", "theta_min",
         "theta_max", "horizon", "normalise", "policy", "look", "pin", "compare", "source", "agent", "run", "learner",
         "edit", "noise", "softness", "p.r1", "p.length", "l.episodes", "l.seeds", "time_step", "deadline"),
    "inverse": ("world", "agent", "data", "state", "action", "alpha", "selector", "solver", "weighting", "noise",
                "noise_level", "noise_seed", "gammas", "spacing", "gamma_min", "thetas", "steps", "horizon", "axis",
                "p.r1", "p.length"),
    "agents": ("checkpoint", "state", "action", "alpha", "steps", "o.0", "o.99", "added", "r.seed", "r.rule", "r.at",
               "r.horizon", "r.gamma", "horizon", "look", "normalise"),
    "race": ("checkpoint", "d.against", "d.T", "d.start", "d.left", "d.gamma", "d.right", "d.at", "d.starts"),
    "train": ("algorithm", "environment", "count", "run", "beside", "ships", "t.steps", "t.seed", "t.gammas", "t.what"),
}  # fmt: skip
"""Entries of the pages, by the path of the page."""


# ---- links


def links(count: int, seed: int) -> list[str]:
    """Hostile links, as path and query: ``/agents?checkpoint=...``."""
    rng = random.Random(seed)
    return [LINKS[i % len(LINKS)](rng) for i in range(count)]


def _link(page: str, query: dict[str, str]) -> str:
    return f"/{page}?{urlencode(query)}"


def _unknown(rng: random.Random) -> str:
    """Entries that no page has."""
    return _link(rng.choice(list(_KEYS)), {rng.choice(NAMES): rng.choice(NAMES) for _ in range(3)})


def _words(rng: random.Random) -> str:
    """Entries of the page with words in place of what they take."""
    page = rng.choice(list(_KEYS))
    return _link(page, {key: rng.choice(NAMES) for key in rng.sample(_KEYS[page], 4)})


def _numbers(rng: random.Random) -> str:
    page = rng.choice(list(_KEYS))
    return _link(page, {key: rng.choice(NUMBERS) for key in rng.sample(_KEYS[page], 5)})


def _paths(rng: random.Random) -> str:
    page, key = rng.choice(
        [("", "agent"), ("", "world"), ("agents", "checkpoint"), ("race", "d.against"), ("train", "run")]
    )
    return _link(page, {key: rng.choice(_PATHS), "source": "learned"} if page == "" else {key: rng.choice(_PATHS)})


def _own(word: str, rng: random.Random) -> str:
    name = rng.choice(["own", "timeline"])
    return _link("", {"world": name, name: word})


@cache
def _packed(data: bytes) -> str:
    return base64.urlsafe_b64encode(zlib.compress(data, 9)).decode().rstrip("=")


def _bomb(rng: random.Random) -> str:
    """A short word that unfolds to far more than it may."""
    return _own(_packed(rng.choice([b"0", b"[", b" "]) * rng.choice([3_000_000, 8_000_000])), rng)


def _damaged(rng: random.Random) -> str:
    word = pack(world_text(rng))
    at = rng.randrange(1, len(word))
    return _own(rng.choice([word[:at], word[:at] + "-" + word[at + 1 :], word[::-1], "AAAA", "%00", "\ud7ff"]), rng)


def _nested(rng: random.Random) -> str:
    depth = rng.choice([500, 5_000, 400_000])
    return _own(_packed(rng.choice([b"[" * depth, b'{"a":' * depth, b"[" * depth + b"]" * depth])), rng)


def _named(rng: random.Random) -> str:
    """A world that is in order but for its names."""
    return _link(
        "", {"world": "own", "own": pack(world_text(rng)), "edit": "yes", "look": rng.choice(["heatmap", "surface"])}
    )


def _wrong_world(rng: random.Random) -> str:
    return _own(pack(_spoilt(world_text(rng), rng)), rng)


def _giant(rng: random.Random) -> str:
    """A word of a few thousand letters for a world with very many states, actions or rewards."""
    n = rng.choice([2_000, 6_000])
    kind = rng.randrange(3)
    states, actions = (["s"], [str(i) for i in range(n)]) if kind == 0 else ([str(i) for i in range(n)], ["a"])
    reward = {str(i): 1 / n for i in range(n)} if kind == 2 else {"1": 1.0}
    states = ["s"] if kind == 2 else states
    rows = [{"state": s, "action": "*", "next": {"END": 1.0}, "reward": reward} for s in states[:n]]
    return _link(
        "", {"world": "own", "own": pack(json.dumps({"states": states, "actions": actions, "transitions": rows}))}
    )


def _pin(rng: random.Random) -> str:
    """A view pinned as A that is a pin in a pin, no view, or one with hostile entries."""
    inner: dict[str, object] = {"world": "two_branch", rng.choice(NAMES): rng.choice(NAMES)}
    for _ in range(rng.randrange(4)):
        inner = {"world": "two_branch", "pin": pack(json.dumps(inner))}
    odd = rng.choice([json.dumps(inner), "[]", "7", "null", json.dumps({"world": rng.choice(NAMES)}), "{" * 9_000])
    return _link("", {"world": "two_branch", "pin": pack(odd)})


def _large(rng: random.Random) -> str:
    """Every setting at the end of its range, on a small world."""
    ends = {
        "gammas": "200",
        "thetas": "2000",
        "steps": "2000",
        "alpha": rng.choice(["1e-9", "1000"]),
        "policy": "per_gamma",
    }
    return _link("", {"world": rng.choice(["two_branch", "fig6_chain"]), **dict(rng.sample(list(ends.items()), 3))})


LINKS: tuple[Callable[[random.Random], str], ...] = (
    _unknown, _words, _numbers, _paths, _bomb, _damaged, _nested, _named, _wrong_world, _giant, _pin, _large,
)  # fmt: skip


# ---- files


@dataclass(frozen=True)
class Upload:
    """A file for the place of uploads of a page.

    Attributes:
        page: the path of the page, empty for that of worlds.
    """

    page: str
    name: str
    content: bytes


def files(count: int, seed: int) -> list[Upload]:
    """Hostile files, each with an ending that its page takes."""
    rng = random.Random(seed)
    return [FILES[i % len(FILES)](rng) for i in range(count)]


def world_text(rng: random.Random) -> str:
    """A small world file with hostile names."""
    states, actions = rng.sample(NAMES, 4), rng.sample(NAMES, 3)
    states = [name for name in states if name.isprintable()]
    actions = [name for name in actions if name.isprintable()]
    rows = [
        {"state": here, "action": "*", "next": {there: 0.5, "END": 0.5}, "reward": {str(i): 1.0}}
        for i, (here, there) in enumerate(zip(states, [*states[1:], "END"], strict=True))
    ]
    rows[-1]["next"] = {"END": 1.0}
    return json.dumps({"name": rng.choice(NAMES[:8]), "states": states, "actions": actions, "transitions": rows})


def _spoilt(text: str, rng: random.Random) -> str:
    """A world file with one entry of a wrong kind, or with a piece cut out."""
    if rng.random() < 0.3:
        at = rng.randrange(len(text))
        return text[:at] + text[at + rng.randrange(1, 40) :]
    document = json.loads(text)
    key = rng.choice(list(document))
    document[key] = rng.choice([None, 7, [], {}, "x", [[[]]], 10**400, [None], [{}], float("nan"), {"x": {"y": "z"}}])
    return json.dumps(document)


def _file_name(rng: random.Random, ending: str) -> str:
    stem = rng.choice([*NAMES[:8], "../../x", "a" * 200, "x.json", "plain", "\u202ex"]).replace("\x00", "")
    return f"{stem}.{ending}"


def _world_file(rng: random.Random) -> Upload:
    text = rng.choice([world_text(rng), _spoilt(world_text(rng), rng), "[" * 100_000, "{" * 50, "null", "NaN", ""])
    encoding = rng.choice(["utf-8", "utf-8-sig", "utf-16", "utf-8"])
    return Upload("", _file_name(rng, "json"), text.encode(encoding))


def _latin(rng: random.Random) -> Upload:
    return Upload("", _file_name(rng, "json"), world_text(rng).replace("x", "é").encode("latin-1", "replace") + b"\xe9")


def _many_states(rng: random.Random) -> Upload:
    states = [str(i) for i in range(rng.choice([5_001, 20_000]))]
    rows = [{"state": "0", "action": "*", "next": {"END": 1.0}, "reward": {"1": 1.0}}]
    return Upload("", "many.json", json.dumps({"states": states, "actions": ["a"], "transitions": rows}).encode())


def _npy(header: str, data: bytes) -> bytes:
    return b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header) + 1) + header.encode("latin-1") + b"\n" + data


def _archive(members: dict[str, bytes]) -> bytes:
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in members.items():
            archive.writestr(name, content)
    return file.getvalue()


def _lying_npz(rng: random.Random) -> Upload:
    """Headers that lie about shape or type: memory is asked for that no byte stands for, or objects."""
    shape = rng.choice(["(1000000, 1000000, 1000000)", "(4, 15, 113)", "(-1, 2, 3)", "()", "(1, 2, 45000)", "(10**9,)"])
    kind = rng.choice(["<f8", "|O", "<c16", "|V9000", "<U1000000", "<f2"])
    header = f"{{'descr': '{kind}', 'fortran_order': False, 'shape': {shape}, }}"
    grids = {"gammas.npy": _plain(np.array([0.5, 0.9])), "thetas.npy": _plain(np.array([0.0, 1.0, 2.0]))}
    return Upload("", _file_name(rng, "npz"), _archive({"gamma_space.npy": _npy(header, b"\x00" * 96), **grids}))


@cache
def _unfolding(names: tuple[str, ...], megabytes: int) -> bytes:
    return _archive(dict.fromkeys(names, _plain(np.zeros((1, 2, megabytes * 62_500)))))


def _bomb_npz(rng: random.Random) -> Upload:
    """A small file that unfolds to tens or hundreds of megabytes."""
    names = rng.choice([("gamma_space.npy",), ("gamma_space.npy", "../../x.npy"), ("other.npy",)])
    return Upload("", _file_name(rng, "npz"), _unfolding(names, rng.choice([20, 60])))


def _plain(array: np.ndarray) -> bytes:
    file = io.BytesIO()
    np.lib.format.write_array(file, array, allow_pickle=True)  # written for readers that must refuse it
    return file.getvalue()


class _Trap:
    """Unpickling it would print; whoever unpickles could as well run anything else."""

    def __reduce__(self) -> tuple[Callable[..., object], tuple[str]]:
        return print, ("unpickled",)


def _pickled_npz(rng: random.Random) -> Upload:
    trap = _plain(np.array([_Trap()], dtype=object))
    name = rng.choice(["gamma_space.npy", "gammas.npy", "settings.npy"])
    good = {"gamma_space.npy": _plain(np.ones((1, 2, 3))), "gammas.npy": _plain(np.array([0.5, 0.9])),
            "thetas.npy": _plain(np.array([0.0, 1.0, 2.0]))}  # fmt: skip
    return Upload("", _file_name(rng, "npz"), _archive({**good, name: trap}))


def _odd_numbers_npz(rng: random.Random) -> Upload:
    values = np.ones((2, 3, 4)) * rng.choice([np.nan, np.inf, 1e308, -1e308, 1e-320])
    gammas = np.array(
        rng.choice([[0.2, 0.5, 0.9], [0.9, 0.5, 0.2], [0.5, 0.5, 0.5], [np.nan, 0.5, 1.0], [0.0, 1.0, 2.0]])
    )
    thetas = np.array(rng.choice([[0.0, 1.0, 2.0, 3.0], [3.0, 2.0, 1.0, 0.0], [0.0, 1.0, 2.0, np.inf], [0.0] * 4]))
    members = {"gamma_space.npy": values, "gammas.npy": gammas, "thetas.npy": thetas}
    return Upload("", _file_name(rng, "npz"), _archive({name: _plain(array) for name, array in members.items()}))


def _shipped(rng: random.Random, pattern: str) -> bytes:
    folder = Path(__file__).resolve().parents[2] / "checkpoints"
    return rng.choice(sorted(folder.glob(pattern))).read_bytes()


def _cut(content: bytes, rng: random.Random) -> bytes:
    """Cut, padded, or with a length of its header, or one byte of it, that is not true."""
    kind, size = rng.randrange(4), int.from_bytes(content[:8], "little")
    if kind == 0:
        return content[: rng.choice([0, 3, 8, 9, size, size + 8, len(content) // 2, len(content) - 1])]
    if kind == 1:
        return content + b"\x00" * rng.choice([1, 8, 10_000])
    if kind == 2:
        return struct.pack("<Q", rng.choice([0, 1, size - 1, size + 1, 2**31, 2**63])) + content[8:]
    at = 8 + rng.randrange(size)
    return content[:at] + bytes([content[at] ^ rng.choice([1, 2, 128])]) + content[at + 1 :]


def _checkpoint(rng: random.Random) -> Upload:
    page = rng.choice(["agents", "agents", ""])  # at the wrong page, too
    return Upload(page, _file_name(rng, "safetensors"), _cut(_shipped(rng, "*_CartPole-v1.safetensors"), rng))


def _learned(rng: random.Random) -> Upload:
    return Upload(
        rng.choice(["", "agents"]), _file_name(rng, "safetensors"), _cut(_shipped(rng, "*_td.safetensors"), rng)
    )


def _metadata(rng: random.Random) -> Upload:
    """A header that is JSON but describes nothing."""
    endless = json.dumps({"algorithm": NAMES[0], "settings": {}, "seed": 1e999})
    elsewhere = json.dumps({"algorithm": "laplace", "environment": "../../x", "settings": {NAMES[4]: 1}})
    about = rng.choice([rng.choice(NAMES), "[" * 50_000, endless, elsewhere])
    entry = {
        "dtype": rng.choice(["F32", "O", "F64"]),
        "shape": rng.choice([[2], [2**40], [-1], "x"]),
        "data_offsets": rng.choice([[0, 8], [8, 0], [0, 2**62], [-1, 7]]),
    }
    header = json.dumps({"__metadata__": {"laplace": about}, rng.choice(NAMES): entry}).encode()
    content = struct.pack("<Q", len(header)) + header + bytes(8)
    return Upload(rng.choice(["", "agents"]), _file_name(rng, "safetensors"), content)


def _other(rng: random.Random) -> Upload:
    """A file of another kind under an ending that is taken: a table, a picture, a program, a page."""
    table, picture, program = b"a,b\n=1+1,2\n" * 1000, b"\x89PNG\r\n\x1a\n" + bytes(500), b"\x7fELF" + bytes(500)
    page, archive = b"<html><script>alert(1)</script>", b"PK\x03\x04" + bytes(40)
    content = rng.choice([table, picture, program, page, archive, bytes(range(256)) * 40])
    return Upload("", _file_name(rng, rng.choice(["json", "npz", "safetensors"])), content)


FILES: tuple[Callable[[random.Random], Upload], ...] = (
    _world_file, _lying_npz, _checkpoint, _pickled_npz, _latin, _learned, _odd_numbers_npz, _metadata, _bomb_npz,
    _other, _many_states,
)  # fmt: skip
