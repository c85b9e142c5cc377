"""Studies as ``.npz`` files, and gamma-spaces from files that somebody else wrote."""

from __future__ import annotations

import io
import json
import math
import warnings
import zipfile
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import asdict
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np

from laplace_core.code.gamma_space import GammaSpace, check_gammas, check_shapes, check_thetas, shown_shape
from laplace_core.code.ties import greedy_action
from laplace_core.errors import InputError
from laplace_core.files.atomic import atomic_write
from laplace_core.inverse import is_linear
from laplace_core.inverse.bands import Bands, bands, bands_by_draws, bins_of
from laplace_core.study.conventions import check_convention, order_of_axes
from laplace_core.study.horizon import regret
from laplace_core.study.kernels import averaging_kernel_of, discount_kernel_of
from laplace_core.study.pipeline import Study, WorldStudy, inverted, noise_of, solver_of
from laplace_core.study.settings import BY_NAME
from laplace_core.study.size import largest_study
from laplace_core.worlds import MAX_STATES

MAX_BYTES = 400_000_000
"""Most that a file's arrays may take together, as float64; as much as the largest study where that is less."""
_MOST = {"gammas": int(BY_NAME["gammas"].bounds[1]), "thetas": int(BY_NAME["thetas"].bounds[1])}
"""Entries of a file's grids: as many as those of a world may have."""
BAND_DRAWS, FEW_BAND_DRAWS = 20, 8
"""Draws of the noise, and those of the feasible solver, which takes long: the standard deviation of 20 draws is known
within 16%, of 8 within 27%."""
_WANTED = ("gamma_space", "gammas", "thetas", "constant_channel", "open_ends", "places")


def study_arrays(study: Study) -> dict[str, Any]:
    """Every array of a study by its name in the file, float64; settings and alpha record as JSON."""
    decoded, truth = study.decoded, study.truth
    read, left = study.reading(study.row)
    chosen = greedy_action(decoded.horizon_values[:, read], scale=decoded.scale)
    arrays = {
        "gamma_space": study.gamma_space.values,
        "constant_channel": study.gamma_space.constant,
        "differences": study.gamma_space.differences,
        "tau_space": decoded.tau_space,
        "survival": decoded.survival,
        "expected_reward": decoded.expected_reward,
        "horizon_values": decoded.horizon_values,
        "gammas": study.gamma_space.gammas,
        "thetas": study.gamma_space.thetas,
        "theta_midpoints": study.midpoints,
        "horizons": study.horizons,
    }
    if is_linear(study.settings.solver):  # else no kernel says what a value is made of
        arrays |= {"discount_kernel": discount_kernel_of(study), "averaging_kernel": averaging_kernel_of(study, 0)}
    if study.gamma_space.open_ends:
        arrays["open_ends"] = np.array(1.0)
    if study.gamma_space.places is not None:
        arrays["places"] = study.gamma_space.places
    if truth is not None:
        arrays |= {
            "true_tau_space": truth.tau_space,
            "true_survival": truth.survival,
            "true_expected_reward": truth.expected_reward,
            "true_horizon_values": truth.horizon_values,
        }
    found = bands_of_study(study)
    if found is not None:
        arrays |= {"band": found.noise, "band_bias": found.bias}
    arrays = {name: np.ascontiguousarray(array, dtype=np.float64) for name, array in arrays.items()}
    arrays |= {"read_row": np.array(read), "chosen": chosen, "alpha": np.array(study.settings.alpha)}
    if truth is not None:
        arrays["optimal_action"] = truth.optimal_action
        arrays["regret"] = regret(truth.optimum[:, [left]], np.array([chosen]))[0]
    settings = asdict(study.settings) | {"params": dict(study.settings.params)}
    settings |= {"actions": study.action_names, "command": study.settings.to_command()}
    return arrays | {
        "settings": np.array(json.dumps(settings)),
        "alpha_record": np.array(study.alpha_record.as_json()),
    }


def bands_of_study(study: Study) -> Bands | None:
    """Errors of the expected rewards of a study, ``(A, K)``, before any rescaling; None where no noise level is given.

    Of a linear solver the noise is exact; of another one it is measured over a few draws. Errors of different
    sensitivities are taken to be independent in exact values, and not in what was learned, from steps that they share.
    """
    s, space = study.settings, study.gamma_space
    deviations = noise_of(s, space.gammas)
    if deviations is None:
        return None
    independent = isinstance(study, WorldStudy) and study.learned is None
    if is_linear(s.solver):
        matrix = inverted(np.eye(space.gammas.size), space.gammas, s)
        return bands(space, s.steps, s.alpha, deviations, time_step=s.time_step, independent=independent, matrix=matrix)
    draws = FEW_BAND_DRAWS if s.solver == "feasible" else BAND_DRAWS
    bins = bins_of(space, s.steps, deviations, time_step=s.time_step, independent=independent)
    return bands_by_draws(solver_of(s), bins, s.alpha, draws=draws)


def save_study(study: Study, path: str | Path) -> None:
    """Write ``study_arrays`` to ``path``: whole or not at all.

    Raises:
        InputError: the folder is missing or not writable.
    """
    with atomic_write(path) as file:
        np.savez_compressed(file, **study_arrays(study))


def npz_bytes(study: Study) -> bytes:
    """The bytes that :func:`save_study` writes, for a download that needs no file."""
    file = io.BytesIO()
    np.savez_compressed(file, **study_arrays(study))
    return file.getvalue()


def read_gamma_space(
    source: str | Path | bytes | BinaryIO, state: str | None = None, name: str | None = None
) -> GammaSpace:
    """A gamma-space from an ``.npz`` with ``gamma_space``, ``gammas`` and ``thetas``.

    ``gamma_space`` is ``(A, G, H)``, or ``(G, H)`` for one action, or ``(S, A, G, H)`` with ``state`` as an
    index. Without a ``constant_channel`` ``(A, G)`` the tail at the lowest sensitivity is used instead: it
    is the same thing as long as no reward lies below that sensitivity. ``open_ends`` 1 says that what lies beyond the
    sensitivities counts, and ``places`` where these lie on the activation, as :class:`GammaSpace` has it. Values that
    are clearly those of another convention are refused (:mod:`laplace_core.study.conventions`).

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
    check_gammas(gammas)
    if gammas.size < 2:
        raise InputError("'gammas' must hold at least 2 discounts, or nothing can be decoded.")
    check_thetas(thetas)
    for grid, most in _MOST.items():
        if arrays[grid].size > most:
            raise InputError(
                f"{grid!r} holds {arrays[grid].size:,} numbers, above {most:,}: save 'gamma_space' at fewer of them."
            )
    open_ends = _open_ends(arrays)
    axes = order_of_axes(values.shape, gammas.size, thetas.size)
    if values.shape[-2:] != (gammas.size, thetas.size) and axes is not None:
        raise InputError(
            f"'gamma_space' has shape {shown_shape(values.shape)}, whose axes seem to be {axes}: give them as "
            f"(actions, {gammas.size} gammas, {thetas.size} thetas); the shape must be (actions, gammas, thetas)."
        )
    values = values[None] if values.ndim == 2 else values
    constant = arrays.get("constant_channel")
    if constant is not None and constant.ndim == 1:
        constant = constant[None]
    check_shapes(values, constant, gammas, thetas)
    if values.ndim == 4:
        index = _state_index(state, len(values))
        values = values[index].copy()  # the memory of the other states is freed
        constant = None if constant is None else constant[index].copy()
    elif state not in (None, "0"):
        raise InputError(f"state {state[:40]!r} does not exist: this gamma-space holds a single state, 0.")
    if len(values) > MAX_STATES:
        raise InputError(f"'gamma_space' holds {len(values):,} actions, above {MAX_STATES:,}: save fewer of them.")
    if values.ndim == 3:
        check_convention(values, constant, gammas, thetas)
    places = arrays.get("places")
    return GammaSpace(values, values[..., 0] if constant is None else constant, gammas, thetas, open_ends, places)


def _open_ends(arrays: Mapping[str, np.ndarray]) -> bool:
    flag = arrays.get("open_ends", np.zeros(()))
    if flag.size != 1 or flag.item() not in (0.0, 1.0):
        raise InputError("'open_ends' must be 1 or 0: whether what lies beyond the thetas counts, at those thetas.")
    if flag.item() and "constant_channel" not in arrays:
        raise InputError("'open_ends' needs a 'constant_channel': without it nothing is known of what lies below.")
    return bool(flag.item())


def _state_index(state: str | None, count: int) -> int:
    text = state or "0"
    if not text.isdecimal() or len(text) > 9 or int(text) >= count:
        raise InputError(f"state {text[:40]!r} is not in this gamma-space: use an index from 0 to {count - 1}.")
    return int(text)


def states_of(source: str | Path | bytes | BinaryIO, name: str | None = None) -> int:
    """The number of states in a gamma-space file: S of ``(S, A, G, H)``, else 1. Only a header is read.

    Raises:
        InputError: as :func:`read_gamma_space`, as far as the header of ``gamma_space`` shows it.
    """
    name = _name_of(source, name)
    with _opened(source, name) as archive:
        if "gamma_space.npy" not in archive.namelist():
            raise _lacks(name, "gamma_space")
        shape = _checked_shape(archive, "gamma_space", _most_bytes())
    if len(shape) not in (2, 3, 4) or 0 in shape:
        raise InputError(f"'gamma_space' has shape {shown_shape(shape)}; it must be (actions, gammas, thetas).")
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
            room = _most_bytes() - sum(array.nbytes for array in arrays.values())
            arrays[name] = _read_member(archive, name, room)
    return arrays


def _most_bytes() -> int:
    return min(MAX_BYTES, 8 * largest_study())


def _checked_shape(archive: zipfile.ZipFile, name: str, room: int) -> tuple[int, ...]:
    """The shape in an array's header, compared with the bytes that the file has and the ``room`` left."""
    member = f"{name}.npy"
    with archive.open(member) as file:
        version = np.lib.format.read_magic(file)
        header = np.lib.format.read_array_header_1_0 if version == (1, 0) else np.lib.format.read_array_header_2_0
        shape, _, dtype = header(file)
    if dtype.kind not in "fiu":
        raise InputError(f"{name!r} holds {str(dtype)[:40]}, not real numbers.")
    stored = archive.getinfo(member).file_size
    if dtype.itemsize * math.prod(shape) > stored:
        raise InputError(f"{name!r} claims the shape {shown_shape(shape)} but is too short for it; save it again.")
    if 8 * math.prod(shape) > room:
        raise InputError(f"{name!r} brings the arrays above {_most_bytes() // 10**6} MB; save fewer states or thetas.")
    return shape


def _read_member(archive: zipfile.ZipFile, name: str, room: int) -> np.ndarray:
    """One array of at most ``room`` bytes."""
    _checked_shape(archive, name, room)
    with archive.open(f"{name}.npy") as file:
        array = np.lib.format.read_array(file, allow_pickle=False).astype(np.float64, copy=False)
    if not (array.min(initial=0.0) >= -1e12 and array.max(initial=0.0) <= 1e12):  # NaN fails both
        raise InputError(f"{name!r} holds a value that is not a number within +-1e12.")
    return array
