"""Gamma-space: what is learned for one state, from a reward-indicator basis, with or without error."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from laplace_core.code.encoding import encoded, softening, theta_midpoints
from laplace_core.code.noise import normal_noise
from laplace_core.errors import InputError


@dataclass(frozen=True, eq=False)
class GammaSpace:
    """The values of one state: Q[a, g, h] and the constant channel Q[a, g].

    Between neighbouring sensitivities lie H-1 bins, at whose midpoints rewards count (paper, Eq. 9). With open ends
    what lies below the first and above the last sensitivity counts as well, at those sensitivities: B = H+1 bins.

    Attributes:
        values: ``(A, G, H)``, never increasing with h if exact.
        constant: ``(A, G)``, the constant channel: discounted steps still to come.
        gammas: ``(G,)``, distinct, in (0, 1).
        thetas: ``(H,)``, increasing, in units of reward.
        open_ends: whether what lies below the first and above the last sensitivity counts, at those sensitivities.
        places: ``(H,)``, of the sensitivities on the axis of the activation that was trained, in units of 1/slope;
            None where its slope is not known.

    Raises:
        InputError: arrays that do not fit each other, or that hold what none of them can.
    """

    values: np.ndarray
    constant: np.ndarray
    gammas: np.ndarray
    thetas: np.ndarray
    open_ends: bool = False
    places: np.ndarray | None = None

    def __post_init__(self) -> None:
        for field, name in _NAMES.items():
            object.__setattr__(self, field, _numbers(getattr(self, field), name))
        check_gammas(self.gammas)
        check_thetas(self.thetas)
        check_shapes(self.values, self.constant, self.gammas, self.thetas)
        if self.places is not None:
            object.__setattr__(self, "places", _numbers(self.places, "places"))
            check_places(self.places, self.thetas)
        if self.values.ndim != 3:
            raise _misshapen(self.values, self.gammas, self.thetas)

    @property
    def differences(self) -> np.ndarray:
        """Z[a, g, b], discounted steps that pay what lies in bin b, ``(A, G, B)``."""
        return bin_differences(self.values, self.constant, self.open_ends)

    @property
    def bin_values(self) -> np.ndarray:
        """The reward that stands for each bin, ``(B,)``, in units of reward."""
        return bin_values(self.thetas, self.open_ends)

    @property
    def bin_edges(self) -> np.ndarray:
        """The edges of the bins, ``(B+1,)``; open ends, which have no edge, are drawn as wide as their neighbours."""
        return bin_edges(self.thetas, self.open_ends)


def bin_differences(values: np.ndarray, constant: np.ndarray, open_ends: bool) -> np.ndarray:
    """Q[h] - Q[h+1], ``(..., G, B)``, from tails ``(..., G, H)`` and the constant channel ``(..., G)``.

    With open ends the constant channel stands before the tails, and nothing is left after them.
    """
    inner = -np.diff(values, axis=-1)
    if not open_ends:
        return inner
    return np.concatenate([constant[..., None] - values[..., :1], inner, values[..., -1:]], axis=-1)


def bin_values(thetas: np.ndarray, open_ends: bool) -> np.ndarray:
    """Midpoints of the sensitivities, ``(H-1,)``; with open ends between the outermost two, ``(H+1,)``."""
    inner = theta_midpoints(thetas)
    return np.concatenate([thetas[:1], inner, thetas[-1:]]) if open_ends else inner


def bin_edges(thetas: np.ndarray, open_ends: bool) -> np.ndarray:
    """The sensitivities, ``(H,)``; with open ends one neighbouring spacing more at each end, ``(H+2,)``."""
    if not open_ends:
        return thetas
    return np.concatenate([[2.0 * thetas[0] - thetas[1]], thetas, [2.0 * thetas[-1] - thetas[-2]]])


_NAMES = {"values": "gamma_space", "constant": "constant_channel", "gammas": "gammas", "thetas": "thetas"}
"""Attributes as they are called in files and in refusals."""


def _numbers(array: object, name: str) -> np.ndarray:
    """An array as float64.

    Raises:
        InputError: it holds something else than finite real numbers.
    """
    try:
        numbers = np.asarray(array)
        numbers = numbers if numbers.dtype == np.float64 else numbers.astype(np.float64, casting="same_kind")
    except (TypeError, ValueError):
        raise InputError(f"{name!r} must be an array of real numbers.") from None
    if not np.isfinite(numbers).all():
        raise InputError(f"{name!r} holds a value that is not a finite number.")
    return numbers


def check_gammas(gammas: np.ndarray) -> None:
    """Raises: InputError: not a list of distinct discounts."""
    if gammas.ndim != 1 or not gammas.size or not np.all((gammas > 0) & (gammas < 1)):
        raise InputError("'gammas' must be a list of numbers between 0 and 1, both excluded.")
    if np.unique(gammas).size < gammas.size:
        raise InputError("'gammas' holds the same discount twice.")


def check_thetas(thetas: np.ndarray) -> None:
    """Raises: InputError: not a list of increasing sensitivities."""
    if thetas.ndim != 1 or thetas.size < 2 or not np.all(np.diff(thetas) > 0):
        if thetas.ndim == 1 and thetas.size >= 2 and np.all(np.diff(thetas) < 0):
            raise InputError("'thetas' must be increasing: reverse 'thetas' and the last axis of 'gamma_space'.")
        raise InputError("'thetas' must be a list of at least 2 increasing numbers.")


def check_places(places: np.ndarray, thetas: np.ndarray) -> None:
    """Raises: InputError: not one increasing place for each sensitivity."""
    if places.shape != thetas.shape or not np.all(np.diff(places) > 0):
        raise InputError(f"'places' must be {thetas.size} increasing numbers, one for each of the 'thetas'.")


def check_shapes(values: np.ndarray, constant: np.ndarray | None, gammas: np.ndarray, thetas: np.ndarray) -> None:
    """Of values ``(..., G, H)`` and of the constant channel ``(..., G)``, if there is one.

    Raises:
        InputError: shapes that do not fit the grids or each other.
    """
    if values.ndim < 3 or not values.size or values.shape[-2:] != (gammas.size, thetas.size):
        raise _misshapen(values, gammas, thetas)
    if constant is not None and constant.shape != values.shape[:-1]:
        raise InputError(
            f"'constant_channel' has shape {shown_shape(constant.shape)}; it must be {shown_shape(values.shape[:-1])}."
        )


def _misshapen(values: np.ndarray, gammas: np.ndarray, thetas: np.ndarray) -> InputError:
    return InputError(
        f"'gamma_space' has shape {shown_shape(values.shape)}; with {gammas.size} gammas and {thetas.size} "
        f"thetas it must be (actions, {gammas.size}, {thetas.size})."
    )


def shown_shape(shape: tuple[int, ...]) -> str:
    text = str(shape)
    return text if len(text) <= 60 else f"{text[:60]}...)"


def encode(basis: np.ndarray, rewards: np.ndarray, gammas: np.ndarray, thetas: np.ndarray, slope: float) -> GammaSpace:
    """gamma_space = W @ f for a reward-indicator basis ``(A, G, V)``; all that a change of slope costs."""
    return GammaSpace(encoded(basis, rewards, thetas, slope), basis.sum(axis=-1), gammas, thetas)


_SOFTENED = 5_000_000
"""Numbers of the softening map that are made at a time."""


def softened(gamma_space: GammaSpace, slope_share: float) -> GammaSpace:
    """Gamma-space as a gentler slope would have it, a share of the slope that was trained.

    Raises:
        InputError: the gamma-space does not say where its sensitivities lie on the activation.
    """
    if slope_share == 1.0:
        return gamma_space
    if gamma_space.places is None:
        raise InputError(
            "--slope-share needs the slope that was trained, which this gamma-space does not hold: its file must have "
            "'places', slope times theta for each sensitivity."
        )
    places, differences = gamma_space.places, gamma_space.differences
    soft, block = np.zeros_like(differences), max(1, _SOFTENED // places.size)
    for start in range(0, differences.shape[-1], block):  # so that S is never there as a whole
        rows = slice(start, start + block)
        soft += differences[..., rows] @ softening(places, slope_share, gamma_space.open_ends, rows)
    tails = np.cumsum(soft[..., ::-1], axis=-1)[..., ::-1]
    if gamma_space.open_ends:
        return replace(gamma_space, values=tails[..., 1:])
    last = gamma_space.values[..., -1:]  # what lies above every sensitivity stays
    return replace(gamma_space, values=np.concatenate([tails + last, last], axis=-1))


def shifted(values: np.ndarray) -> np.ndarray:
    """Each discount's values ``(..., G, n)`` where those of the next one belong, and 0 at the first.

    The decoder of the paper's published notebook raises its index before it stores a row, so that it multiplies the
    values of every discount by the row of the next.
    """
    return np.concatenate([np.zeros_like(values[..., :1, :]), values[..., :-1, :]], axis=-2)


def with_noise(gamma_space: GammaSpace, noise: float, seed: int) -> GammaSpace:
    """Gamma-space as a learner with a random error holds it.

    Every value at discount gamma gets an independent normal error of ``noise`` / (1 - gamma), the constant channel
    too: ``noise`` is the standard deviation of (1 - gamma) Q, which is a probability.
    """
    if not noise:
        return gamma_space
    scale = noise / (1.0 - gamma_space.gammas)
    values, constant = gamma_space.values, gamma_space.constant
    values = values + scale[:, None] * normal_noise(seed, values.shape)
    constant = constant + scale * normal_noise(seed, constant.shape, skip=values.size)
    return replace(gamma_space, values=values, constant=constant)
