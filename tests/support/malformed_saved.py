"""Saved gamma-spaces that must be refused: a valid ``.npz``, broken in its arrays, its headers and its zip.

``cases()`` yields (id, content of the file, words that the refusal must contain).
"""

from __future__ import annotations

import io
import struct
import zipfile
from collections.abc import Iterator, Mapping

import numpy as np

GOOD = {
    "gamma_space": np.array([1.0, 1.5, 5.0])[:, None] * np.array([[[1.0, 0.75, 0.5, 0.25]], [[0.9, 0.6, 0.3, 0.0]]]),
    "gammas": np.array([0.2, 0.5, 0.9]),
    "thetas": np.array([-1.0, 0.0, 1.0, 2.5]),
    "constant_channel": np.array([[1.2, 1.8, 6.0], [1.1, 1.6, 5.0]]),
}


def own_values(leading: tuple[int, ...] = (2,)) -> np.ndarray:
    """Random tails that fall with theta and rise with gamma, ``(*leading, 3, 4)``, on the grids of ``GOOD``."""
    chances = -np.sort(-np.random.default_rng(0).random((*leading, 1, 4)), axis=-1)
    return np.array([1.0, 1.5, 5.0])[:, None] * chances


DATA = GOOD["gamma_space"].tobytes()
NO_ARRAYS = "not an .npz file of plain number arrays"


class Trap:
    """Unpickling it creates a file."""

    def __init__(self, path: str):
        self.path = path

    def __reduce__(self):
        return open, (self.path, "w")


def npy(array: object, *, pickled: bool = False) -> bytes:
    """The content of an .npy file."""
    file = io.BytesIO()
    np.lib.format.write_array(file, np.asarray(array), allow_pickle=pickled)
    return file.getvalue()


def npy_by_hand(header: str, data: bytes = DATA, version: tuple[int, int] = (1, 0)) -> bytes:
    length = struct.pack("<H" if version == (1, 0) else "<I", len(header) + 1)
    return b"\x93NUMPY" + bytes(version) + length + header.encode("latin-1") + b"\n" + data


def npz(members: Mapping[str, bytes], compression: int = zipfile.ZIP_STORED) -> bytes:
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w", compression) as archive:
        for name, content in members.items():
            archive.writestr(zipfile.ZipInfo(f"{name}.npy"), content, compression)
    return file.getvalue()


def with_arrays(**changes: object) -> bytes:
    """The good file with other arrays; None leaves one out."""
    members = {name: array for name, array in (GOOD | changes).items() if array is not None}
    return npz({name: npy(array) for name, array in members.items()})


def with_member(content: bytes, name: str = "gamma_space") -> bytes:
    return npz({member: npy(array) for member, array in GOOD.items()} | {name: content})


def described(descr: str = "'<f8'", shape: str = "(2, 3, 4)", order: str = "False") -> str:
    return f"{{'descr': {descr}, 'fortran_order': {order}, 'shape': {shape}, }}"


def patched(content: bytes, local: tuple[int, bytes], central: tuple[int, bytes]) -> bytes:
    """A zip with some bytes overwritten in the first local header and in the first entry of the directory."""
    patch = bytearray(content)
    for signature, (offset, put) in ((b"PK\x03\x04", local), (b"PK\x01\x02", central)):
        at = content.index(signature) + offset
        patch[at : at + len(put)] = put
    return bytes(patch)


def _arrays() -> Iterator[tuple[str, bytes, tuple[str, ...]]]:
    for name in ("gamma_space", "gammas", "thetas"):
        yield f"no {name}", with_arrays(**{name: None}), (f"'{name}'",)
    for name, good in GOOD.items():
        for value in (np.nan, np.inf, -np.inf, 1e13, -1e300):
            bad = good.copy()
            bad.flat[-1] = value
            yield f"{value} in {name}", with_arrays(**{name: bad}), (f"'{name}'",)
        for kind in ("c16", "U4", "S4", "?", "M8[s]", "m8[s]", "V8", [("re", "f8"), ("im", "f8")]):
            bad = np.zeros(good.shape, dtype=kind)
            yield f"{name} as {kind}", with_arrays(**{name: bad}), (f"'{name}'", "not real numbers")
        shapes = {good[..., None].shape, good[:0].shape, good[:-1].shape, good[..., :-1].shape, good.T.shape, (), (1,)}
        for shape in sorted(shapes - {good.shape, (0, 3, 4)}):
            if (name, shape) != ("gamma_space", (1, 3, 4)):
                yield f"{name} of shape {shape}", with_arrays(**{name: np.ones(shape)}), ("must be",)
    for shape in ((24,), (3, 3), (4, 3), (2, 4, 3), (0, 3, 4), (0, 2, 3, 4), (2, 0, 3, 4), (1, 1, 2, 3, 4), (1,) * 40):
        bad = np.ones(shape)
        yield f"gamma_space of shape {shape}", with_arrays(gamma_space=bad, constant_channel=None), ("'gamma_space'",)
    for gammas in ([0, 0.5, 0.9], [0.5, 0.9, 1], [0.1, 0.5, 1.5], [-0.1, 0.5, 0.9], [0.5, 0.5, 0.9], [0.9, 0.5, 0.9]):
        yield f"gammas {gammas}", with_arrays(gammas=np.array(gammas)), ("'gammas'",)
    for thetas in ([0, 1, 1, 2], [0, 2, 1, 3], [3, 2, 1, 0], [0, 0, 0, 0]):
        yield f"thetas {thetas}", with_arrays(thetas=np.array(thetas)), ("'thetas'", "increasing")
    for shape in ((3,), (3, 2), (2, 3, 1), (1, 2, 3), (2, 4), (5, 2, 3)):
        bad = np.ones(shape)
        yield f"constant of shape {shape}", with_arrays(constant_channel=bad), ("'constant_channel'", "(2, 3)")
    states = np.ones((5, 2, 3, 4))
    for shape in ((2, 3), (2, 2, 3), (5, 3), (5, 3, 2)):
        bad = with_arrays(gamma_space=states, constant_channel=np.ones(shape))
        yield f"five states and a constant of shape {shape}", bad, ("'constant_channel'", "(5, 2, 3)")


def _conventions() -> Iterator[tuple[str, bytes, tuple[str, ...]]]:
    """An episode that goes on with .8 at every step and pays by one law, as other conventions would write it."""
    gammas, thetas = np.array([0.1, 0.3, 0.5, 0.7, 0.8, 0.9, 0.95, 0.97]), np.arange(8.0)
    steps, above = 1.0 / (1.0 - 0.8 * gammas), np.array([1.0, 1.0, 0.9, 0.7, 0.65, 0.3, 0.1, 0.0])
    values = np.stack([np.outer(steps, above), np.outer(steps, above**2)])
    constant, sizes = np.stack([steps, steps]), 1.0 - gammas

    def saved(values, constant=None, thetas=thetas):
        return with_arrays(gamma_space=values, gammas=gammas, thetas=thetas, constant_channel=constant)

    for known in (None, constant):
        told = "with" if known is not None else "without"
        yield f"P(r < theta), {told} a constant", saved(constant[..., None] - values, known), ("P(r < theta)",)
        yield f"last axis reversed, {told} a constant", saved(values[..., ::-1], known), ("reverse its last axis",)
        yield f"axes exchanged, {told} a constant", saved(values.transpose(0, 2, 1), known), ("axes",)
        own = None if known is None else known * sizes
        yield f"times 1 - gamma, {told} a constant", saved(values * sizes[:, None], own), ("times (1 - gamma)",)
    yield "rewards in place of probabilities", saved(20.0 * values), ("above 1 / (1 - gamma)",)
    yield "rows against gammas", saved(values[:, ::-1]), ("reverse order of 'gammas'",)
    yield "constant channel too low", saved(values, constant * sizes), ("'constant_channel' lies below",)
    yield "thetas descending", saved(values[..., ::-1], None, thetas[::-1]), ("reverse 'thetas'", "last axis")
    for flag in (2.0, np.array([1.0, 0.0])):
        yield f"open_ends {flag}", with_arrays(open_ends=np.array(flag)), ("'open_ends'", "1 or 0")
    yield "open ends without a constant", with_arrays(open_ends=np.array(1), constant_channel=None), ("'open_ends'",)


def _headers() -> Iterator[tuple[str, bytes, tuple[str, ...]]]:
    for version in ((1, 0), (2, 0), (3, 0)):
        for shape in ("(2000000, 3, 4)", "(2, 3, 5)", "(9" + "9" * 30 + ",)", "(" + "9, " * 60 + ")", "(10**9,)"):
            content = npy_by_hand(described(shape=shape), version=version)
            yield f"version {version}, shape {shape:.20}", with_member(content), ()
    for shape in ("(-2, -3, 4)", "(-1,)", "(2.0, 3, 4)", "[2, 3, 4]", "24", "None", "'24'", "(2, 3, 4", "()", "(0,)"):
        yield f"shape {shape}", with_member(npy_by_hand(described(shape=shape))), ()
    for descr in (
        "'O'",
        "'|O'",
        "'|S0'",
        "'|V0'",
        "'<U0'",
        "'<f3'",
        "'x'",
        "''",
        "None",
        "7",
        "'<f8' * 99",
        "[('a', 'O')]",
    ):
        yield f"descr {descr}", with_member(npy_by_hand(described(descr))), ()
    claims = (
        "(" * 3000 + ")" * 3000,
        "-" * 5000 + "1",
        "9" * 5000,
        "[" * 150,
        "{}",
        "",
        "1",
        "()",
        "\\",
        "\x00",
        "\xff",
    )
    for number, header in enumerate(
        (*claims, described() + ", 1", described(order="1"), described()[:-4], " " * 20_000)
    ):
        yield f"header {number}", with_member(npy_by_hand(header)), (NO_ARRAYS,)
    yield "an escape in the header", with_member(npy_by_hand(described("'<f8\\y'"))), (NO_ARRAYS,)
    yield "a call in the header", with_member(npy_by_hand(described(shape="(exit(), 3, 4)"))), (NO_ARRAYS,)
    for version in ((0, 0), (1, 1), (4, 0), (255, 255)):
        yield f"version {version}", with_member(npy_by_hand(described(), version=version)), (NO_ARRAYS,)
    for magic in (b"", b"\x93", b"\x93NUMPY", b"\x93NUMPZ\x01\x00", b"PK\x03\x04", b"\x80\x04\x95", b"\x00" * 200):
        yield f"magic {magic[:8]}", with_member(magic), (NO_ARRAYS,)
    whole = npy(GOOD["gamma_space"])
    for length in range(1, len(whole), 20):
        yield f"array cut at {length}", with_member(whole[:length]), ()


def _zips() -> Iterator[tuple[str, bytes, tuple[str, ...]]]:
    whole = with_arrays()
    for length in range(0, len(whole), len(whole) // 50):
        yield f"file cut at {length}", whole[:length], (NO_ARRAYS,)
    for seed in range(15):
        random = np.random.default_rng(seed).bytes(20 * seed * seed)
        yield f"random bytes {seed}", random, (NO_ARRAYS,)
        yield f"random member {seed}", with_member(random), (NO_ARRAYS,)
        yield f"random directory {seed}", whole[: whole.index(b"PK\x01\x02")] + random, (NO_ARRAYS,)
    yield "encrypted", patched(whole, (6, b"\x01\x00"), (8, b"\x01\x00")), (NO_ARRAYS,)
    yield "encrypted in the directory only", patched(whole, (0, b""), (8, b"\x01\x00")), (NO_ARRAYS,)
    for method in (1, 8, 9, 12, 14, 93, 99):
        code = struct.pack("<H", method)
        yield f"stored, claims method {method}", patched(whole, (8, code), (10, code)), (NO_ARRAYS,)
    for compression in (zipfile.ZIP_DEFLATED, zipfile.ZIP_BZIP2, zipfile.ZIP_LZMA):
        packed = npz({name: npy(array) for name, array in GOOD.items()}, compression)
        start = packed.index(b"gamma_space.npy") + len("gamma_space.npy")
        broken = packed[: start + 8] + b"\xff" * 20 + packed[start + 28 :]
        yield f"broken packing {compression}", broken, (NO_ARRAYS,)
    for size in (10**6, 3 * 10**8, 2**32 - 2):  # declared in the directory, never there
        header = npy_by_hand(described("'|i1'", f"({size - 200},)"))
        declared = patched(with_member(header), (22, struct.pack("<I", size)), (24, struct.pack("<I", size)))
        yield f"declares {size} bytes", declared, ()
    renamed = npz({f"x/{name}": npy(array) for name, array in GOOD.items()})
    yield "arrays in a folder", renamed, ("'gamma_space'",)
    yield "no arrays", npz({}), ("'gamma_space'",)
    yield "text", b"gamma_space,gammas,thetas\n1,2,3\n", (NO_ARRAYS,)
    yield "a bare .npy", npy(GOOD["gamma_space"]), (NO_ARRAYS,)
    yield "a gzip", b"\x1f\x8b\x08" + bytes(40), (NO_ARRAYS,)
    yield "an HDF5 file", b"\x89HDF\r\n\x1a\n" + bytes(100), (NO_ARRAYS,)


def pickles(trap: str) -> Iterator[tuple[str, bytes]]:
    """Files that create ``trap`` if anything in them is unpickled."""
    pickled = npy(np.array([Trap(trap)], dtype=object), pickled=True)
    body = pickled[pickled.index(b"\n") + 1 :]
    for name in GOOD:
        yield f"pickled {name}", with_member(pickled, name)
        yield f"{name} as a bare pickle", with_member(body, name)
    yield "a bare pickle", body
    yield "a bare .npy", pickled
    for descr in ("'O'", "'|O8'", "[('a', 'O')]", "[('a', '<f8'), ('b', '|O')]"):
        for version in ((1, 0), (2, 0), (3, 0)):
            content = npy_by_hand(described(descr, "(1,)"), body, version)
            yield f"pickled under {descr} in version {version}", with_member(content)


def cases() -> Iterator[tuple[str, bytes, tuple[str, ...]]]:
    for catalogue in (_arrays, _conventions, _headers, _zips):
        yield from catalogue()


CASES = list(cases())
