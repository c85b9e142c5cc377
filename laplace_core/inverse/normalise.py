"""What may be done to the rows of a tau-space after decoding, and what must not."""

from __future__ import annotations

import numpy as np

from laplace_core.errors import InputError

NORMALISATIONS = ("none", "survival", "paper")
SURVIVAL_FLOOR = 0.05
"""Below this decoded survival a conditional distribution is noise over noise and is left out."""


def normalise_rows(
    tau_space: np.ndarray,
    survival: np.ndarray,
    how: str,
    time_step: float = 1.0,
    rounding: np.ndarray | None = None,
) -> np.ndarray:
    """Rows of a tau-space ``(..., K, H-1)`` rescaled, given the decoded survival ``(..., K)``.

    ``none`` leaves them alone: a vanishing row means that the episode is over.
    ``survival`` divides by survival, P(reward | still alive), and is zero where survival is below
    ``SURVIVAL_FLOOR``. ``paper`` clips at zero and rescales every row that holds anything to total probability 1,
    which turns the residue after the end of an episode into a certain reward: the repeated reward of the paper's
    Fig. 4c. With ``time_step`` < 1 a row that stands for probability 1 sums to ``time_step``.

    Args:
        rounding: of ``paper``, the mass up to which a row holds nothing but rounding and becomes 0, ``(..., K)``, from
            :func:`laplace_core.inverse.rounding_of_rows`; default: none does.
    """
    if how not in NORMALISATIONS:
        raise InputError(f"normalise {how!r} is not one of {', '.join(NORMALISATIONS)}.")
    if how == "none":
        return tau_space
    if how == "survival":
        alive = np.asarray(survival)[..., None] / time_step
        return np.divide(tau_space, alive, out=np.zeros_like(tau_space), where=alive > SURVIVAL_FLOOR)
    clipped = np.maximum(tau_space, 0.0)
    mass = clipped.sum(axis=-1, keepdims=True)
    least = 0.0 if rounding is None else np.asarray(rounding)[..., None]
    return time_step * np.divide(clipped, mass, out=np.zeros_like(clipped), where=mass > least)
