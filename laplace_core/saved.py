"""Studies as ``.npz`` files, and gamma-spaces from files that somebody else wrote."""

from __future__ import annotations

import io
import json
import math
import warnings
import zipfile
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import asdict
from pathlib import Path
from typing import BinaryIO

import numpy as np

from laplace_core.atomic import atomic_write
from laplace_core.errors import InputError
from laplace_core.pipeline import GammaSpace, Study

MAX_BYTES = 400_000_000
"""Most that a file's arrays may take together, as float64."""
_WANTED = ("gamma_space", "gammas", "thetas", "constant_channel")


def study_arrays(study: Study) -> dict[str, np.ndarray]:
    """Every array of a study by its name in the file (design: ``decode``), float64, and ``settings`` as JSON."""
    decoded, truth = study.decoded, study.truth
    arrays = {
        "gamma_space": study.gamma_space.values,
        "constant_channel": study.gamma_space.constant,
        "tau_space": decoded.tau_space,
        "survival": decoded.survival,
        "expected_reward": decoded.expected_reward,
        "horizon_values": decoded.horizon_values,
        "gammas": study.gamma_space.gammas,
        "thetas": study.gamma_space.thetas,
        "theta_midpoints": study.midpoints,
    }
    if truth is not None:
        arrays |= {
            "true_tau_space": truth.tau_space,
            "true_survival": truth.survival,
            "true_expected_reward": truth.expected_reward,
            "true_horizon_values": truth.horizon_values,
        }
    arrays = {name: np.ascontiguousarray(array, dtype=np.float64) for name, array in arrays.items()}
    if truth is not None:
        arrays["optimal_action"] = truth.optimal_action
    settings = asdict(study.settings) | {"params": dict(study.settings.params)}
    settings |= {"actions": study.action_names, "command": study.settings.to_command()}
    return arrays | {"settings": np.array(json.dumps(settings))}


def save_study(study: Study, path: str | Path) -> None:
    """Write ``study_arrays`` to ``path``: whole or not at all.

    Raises:
        InputError: the folder is missing or not writable.
    """
    with atomic_write(path) as file:
        np.savez_compressed(file, **study_arrays(study))


def npz_bytes(study: Study) -> bytes:
    """What :func:`save_study` writes, for a download that needs no file."""
    file = io.BytesIO()
    np.savez_compressed(file, **study_arrays(study))
    return file.getvalue()


def read_gamma_space(
    source: str | Path | bytes | BinaryIO, state: str | None = None, name: str | None = None
) -> GammaSpace:
    """A gamma-space from an ``.npz`` with ``gamma_space``, ``gammas`` and ``thetas``.

    ``gamma_space`` is ``(A, G, H)``, or ``(G, H)`` for one action, or ``(S, A, G, H)`` with ``state`` as an
    index. Without a ``constant_channel`` ``(A, G)`` the tail at the lowest sensitivity stands in for it: it
    is the same thing as long as no reward lies below that sensitivity.

    Args:
        source: a path, the content of a file, or an open binary file, as an upload brings it.
        name: what to call the source in a refusal; by default the name of the file.

    Raises:
        InputError: not such a file; the sentence names the array.
    """
    name = _name_of(source, name)
    with _opened(source, name) as archive:
        arrays = _read_arrays(archive)
    for wanted in ("gamma_space", "gammas", "thetas"):
        if wanted not in arrays:
            raise _lacks(name, wanted)
    gammas, thetas, values = arrays["gammas"], arrays["thetas"], arrays["gamma_space"]
    if gammas.ndim != 1 or gammas.size < 2 or not np.all((gammas > 0) & (gammas < 1)):
        raise InputError("'gammas' must be a list of at least 2 numbers between 0 and 1, both excluded.")
    if thetas.ndim != 1 or thetas.size < 2 or not np.all(np.diff(thetas) > 0):
        raise InputError("'thetas' must be a list of at least 2 increasing numbers.")
    if np.unique(gammas).size < gammas.size:
        raise InputError("'gammas' holds the same discount twice.")
    shape = values.shape
    if values.ndim == 2:
        values = values[None]
    if values.ndim not in (3, 4) or not values.size or values.shape[-2:] != (gammas.size, thetas.size):
        raise InputError(
            f"'gamma_space' has shape {_shown(shape)}; with {gammas.size} gammas and {thetas.size} "
            f"thetas it must be (actions, {gammas.size}, {thetas.size})."
        )
    constant = arrays.get("constant_channel", values[..., 0])
    if constant.ndim == 1:
        constant = constant[None]
    if constant.shape != values.shape[:-1]:
        raise InputError(f"'constant_channel' has shape {_shown(constant.shape)}; it must be {values.shape[:-1]}.")
    if values.ndim == 4:
        index = _state_index(state, len(values))
        values, constant = values[index], constant[index]
    elif state not in (None, "0"):
        raise InputError(f"state {state[:40]!r} does not exist: this gamma-space holds a single state, 0.")
    return GammaSpace(values, constant, gammas, thetas)


def _state_index(state: str | None, count: int) -> int:
    text = state or "0"
    if not text.isdecimal() or len(text) > 9 or int(text) >= count:
        raise InputError(f"state {text[:40]!r} is not in this gamma-space: use an index from 0 to {count - 1}.")
    return int(text)


def states_of(source: str | Path | bytes | BinaryIO, name: str | None = None) -> int:
    """How many states a gamma-space file holds: S of ``(S, A, G, H)``, else 1. Only a header is read.

    Raises:
        InputError: as :func:`read_gamma_space`, as far as the header of ``gamma_space`` shows it.
    """
    name = _name_of(source, name)
    with _opened(source, name) as archive:
        if "gamma_space.npy" not in archive.namelist():
            raise _lacks(name, "gamma_space")
        shape = _checked_shape(archive, "gamma_space", MAX_BYTES)
    if len(shape) not in (2, 3, 4) or 0 in shape:
        raise InputError(f"'gamma_space' has shape {_shown(shape)}; it must be (actions, gammas, thetas).")
    return shape[0] if len(shape) == 4 else 1


def _name_of(source: str | Path | bytes | BinaryIO, name: str | None) -> str:
    if name is not None:
        return name[:60] if name.isprintable() else repr(name[:60])
    return Path(source).name if isinstance(source, str | Path) else "the file"


def _lacks(name: str, array: str) -> InputError:
    return InputError(f"{name} holds no array {array!r}; it needs gamma_space, gammas and thetas.")


@contextmanager
def _opened(source: str | Path | bytes | BinaryIO, name: str) -> Iterator[zipfile.ZipFile]:
    """The archive; whatever a hostile one raises while it is read becomes one sentence."""
    try:
        with (
            zipfile.ZipFile(io.BytesIO(source) if isinstance(source, bytes) else source) as archive,
            warnings.catch_warnings(),
        ):
            warnings.simplefilter("ignore")  # what numpy remarks on odd headers is not for the user
            yield archive
    except InputError:
        raise
    except Exception as error:  # noqa: BLE001 - a hostile zip or npy header may raise anything; none of it is ours
        if isinstance(error, OSError) and error.strerror:
            raise InputError(f"{name} cannot be read: {error.strerror.lower()}.") from None
        raise InputError(f"{name!r} is not an .npz file of plain number arrays.") from None


def _read_arrays(archive: zipfile.ZipFile) -> dict[str, np.ndarray]:
    """The wanted members as finite float64 arrays, each measured before it is read; nothing is unpickled."""
    arrays: dict[str, np.ndarray] = {}
    present = archive.namelist()
    for name in _WANTED:
        if f"{name}.npy" in present:
            room = MAX_BYTES - sum(array.nbytes for array in arrays.values())
            arrays[name] = _read_member(archive, name, room)
    return arrays


def _checked_shape(archive: zipfile.ZipFile, name: str, room: int) -> tuple[int, ...]:
    """The shape in an array's header, held against the bytes that are really there and the ``room`` left."""
    member = f"{name}.npy"
    with archive.open(member) as file:
        version = np.lib.format.read_magic(file)
        header = np.lib.format.read_array_header_1_0 if version == (1, 0) else np.lib.format.read_array_header_2_0
        shape, _, dtype = header(file)
    if dtype.kind not in "fiu":
        raise InputError(f"{name!r} holds {str(dtype)[:40]}, not real numbers.")
    stored = archive.getinfo(member).file_size
    if dtype.itemsize * math.prod(shape) > stored:
        raise InputError(f"{name!r} claims the shape {_shown(shape)} but is too short for it; save it again.")
    if 8 * math.prod(shape) > room:
        raise InputError(f"{name!r} brings the arrays above {MAX_BYTES // 10**6} MB; save fewer states or thetas.")
    return shape


def _read_member(archive: zipfile.ZipFile, name: str, room: int) -> np.ndarray:
    """One array of at most ``room`` bytes."""
    _checked_shape(archive, name, room)
    with archive.open(f"{name}.npy") as file:
        array = np.lib.format.read_array(file, allow_pickle=False).astype(np.float64, copy=False)
    if not (array.min(initial=0.0) >= -1e12 and array.max(initial=0.0) <= 1e12):  # NaN fails both
        raise InputError(f"{name!r} holds a value that is not a number within +-1e12.")
    return array


def _shown(shape: tuple[int, ...]) -> str:
    text = str(shape)
    return text if len(text) <= 60 else f"{text[:60]}...)"
