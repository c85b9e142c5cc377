"""Random error of a gamma-space, and its effect on the inverse."""

from __future__ import annotations

import numpy as np

from laplace_core.study.artefacts.look import Look, Measure, largest_change, of_a_row
from laplace_core.study.artefacts.model import VISIBLE, Artefact, Remedy

LARGEST_ALPHA = 10.0
_SENTENCE = (
    "Gamma-space has random errors, as all learned values do, and the inverse divides them by small singular values."
)
_APART = " Some falls are too large for noise: there, discounts follow different policies or are less well learned."
_ROUNDING, _FEW = 1e-6, 5
"""Of (1 - gamma) Z; and discounts so few that falls between most of them say nothing."""
_TOO_MUCH = " No alpha removes the noise and keeps the picture"


def noise_amplification(look: Look) -> Artefact | None:
    """Error of gamma-space magnified by the inverse: the most probability that it moves in a row.

    Without a truth, only what no exact gamma-space can hold counts as error, and the size is a lower bound.
    """
    return _against_truth(look) if look.has_truth else _from_violations(look)


def _against_truth(look: Look) -> Artefact | None:
    study, s = look.study, look.settings
    if not s.noise and study.learned is None:
        return None
    exact = look.exact()
    error = look.differences - exact
    size = largest_change(look.decode(error))
    if size < VISIBLE:
        return None
    alphas = sorted(_larger(s.alpha), key=look.error)
    better = [a for a in alphas if look.error(a) < look.error() and _keeps_a_picture(look, exact, a)]
    calm = [a for a in better if largest_change(look.decode(error, a)) < VISIBLE]
    chosen = [Remedy(f"Raise alpha to {a:g}", {"alpha": a}) for a in (calm or better)[:1]]
    without = [Remedy("Leave out the noise", {"noise": 0.0})] if s.noise else []
    return Artefact(
        "noise amplification",
        size,
        f"noise moves up to {of_a_row(size)}",
        _SENTENCE + ("" if calm else _too_much(look)),
        tuple(chosen + without if calm else without + chosen),
    )


def _too_much(look: Look) -> str:
    """The remedy if no alpha helps: leave out added noise, or learn longer against an error of learning."""
    return f"{_TOO_MUCH}." if look.settings.noise else f"{_TOO_MUCH}; only more learning does."


def _keeps_a_picture(look: Look, exact: np.ndarray, alpha: float) -> bool:
    """Whether half of the probability survives: an empty picture has no noise either."""
    return bool(look.decode(exact, alpha).sum() >= 0.5 * look.decode(exact).sum())


def _from_violations(look: Look) -> Artefact | None:
    falls, mixed = _falls(look)
    error = violations(look, falls)
    size, other = _expected_change(look, error), _expected_change(look, violations(look, mixed, negative=False))
    if size < VISIBLE:
        return _mixed(look, other)
    larger = _larger(look.settings.alpha) if look.searching else []
    calm = next(([a] for a in larger if _expected_change(look, error, a) < VISIBLE), [])
    return Artefact(
        "noise amplification",
        size,
        f"noise moves at least {of_a_row(size)} across a threshold",
        _SENTENCE
        + " Here it shows in differences that are negative or fall with gamma, which exact ones never do."
        + ("" if calm else _too_much(look))
        + (_APART if other >= VISIBLE else ""),
        tuple(Remedy(f"Raise alpha to {a:g}", {"alpha": a}) for a in calm),
    )


def _mixed(look: Look, size: float) -> Artefact | None:
    """Values that fall with gamma and do not look random. Their cause cannot be known, so that both are named."""
    if size < VISIBLE:
        return None
    return Artefact(
        "mixed policies",
        size,
        f"differences that fall with gamma move at least {of_a_row(size)} across a threshold",
        "Gamma-space falls with gamma at some discounts, as the values of no single process do: discounts follow "
        "different policies, or some are not learned well enough. No alpha makes one timeline of such values.",
        (),
    )


def _falls(look: Look) -> tuple[np.ndarray, np.ndarray]:
    """Falls of Z from one discount to the next, ``(G-1, n)``: those that may be random, and what is beyond them.

    In errors of (1 - gamma) Z. Discounts that change their policy make Z fall where they do, and rise or stay
    everywhere else: where nothing is negative either, no fall is called random. Else errors make Z fall everywhere,
    each about as far as all: twelve times their median is beyond what the largest of them reach.
    """
    Z = look.study.gamma_space.differences[look.action][np.argsort(look.gammas)]
    sizes = 1.0 - np.sort(look.gammas)
    falls = np.maximum(-np.diff(Z, axis=0), 0.0)
    errors = falls / np.hypot(1.0 / sizes[1:], 1.0 / sizes[:-1])[:, None]
    there = errors > _ROUNDING
    elsewhere = there.any(axis=1).mean() <= 0.5 or len(sizes) <= _FEW
    if not there.any():
        return falls, np.zeros_like(falls)
    if elsewhere and (Z * sizes[:, None]).min() > -_ROUNDING:
        return np.zeros_like(falls), falls
    most = 12.0 * np.median(errors[there])
    return falls * most / np.maximum(errors, most), np.where(errors > most, falls, 0.0)


def violations(look: Look, falls: np.ndarray | None = None, *, negative: bool = True) -> np.ndarray:
    """The least error, in size, that explains what no exact Z does, ``(G, B)``, in the units of Z.

    Z = sum_tau gamma^tau P is never negative and never falls with gamma. A fall between two discounts is shared
    between them as an error whose size grows like 1 / (1 - gamma) would spread it.

    Args:
        falls: to be explained, ``(G-1, B)``, in the order of the discounts; by default all.
        negative: whether what is below 0 is to be explained too.
    """
    Z = look.study.gamma_space.differences[look.action]
    order = np.argsort(look.gammas)
    scale = (1.0 / (1.0 - look.gammas[order])) ** 2
    fall = np.maximum(-np.diff(Z[order], axis=0), 0.0) ** 2 if falls is None else falls**2
    share = (scale[1:] / (scale[1:] + scale[:-1]))[:, None]
    variance = np.minimum(Z[order], 0.0) ** 2 if negative else np.zeros_like(Z)
    variance[1:] = np.maximum(variance[1:], share * fall)
    variance[:-1] = np.maximum(variance[:-1], (1.0 - share) * fall)
    least = np.empty_like(Z)
    least[order] = np.sqrt(variance)
    return least


def propagated(look: Look, error: np.ndarray, alpha: float | None = None) -> np.ndarray:
    """Standard deviation of each decoded entry, ``(K, n)``, for independent errors of these sizes, ``(G, n)``."""
    return np.sqrt(look.decode_matrix(alpha) ** 2 @ error**2)


def _expected_change(look: Look, error: np.ndarray, alpha: float | None = None) -> float:
    """Expected error of the worst row's probability to lie above one threshold, for errors of Z, ``(G, H-1)``.

    Z is the difference of two thresholds and has twice their variance; a normal error is sqrt(2 / pi) of its
    standard deviation on average.
    """
    tails = np.sqrt((error**2).mean(axis=-1, keepdims=True) / 2.0)
    return float(np.sqrt(2.0 / np.pi) * propagated(look, tails, alpha).max())


def _larger(alpha: float) -> list[float]:
    """Alphas above this one, two digits each, up to where little of a picture is left."""
    first = np.log10(max(alpha, 1e-9))
    count = max(0, int(np.ceil(3.0 * (np.log10(LARGEST_ALPHA) - first))))
    grid = [float(f"{10.0 ** (first + (n + 1) / 3.0):.2g}") for n in range(min(count, 30))]
    return [a for a in grid if a > alpha]


MEASURES: dict[str, Measure] = {
    "noise amplification": noise_amplification,
}
"""The artefacts of this module by name, the gravest kinds first."""
