"""Can any feasible timeline have these values, given their noise? A test that needs neither truth nor alpha.

The statistic is the weighted misfit of the feasible timeline that fits best. Its null, "some feasible timeline", is
composite, and how many numbers a timeline can fit depends on which of its masses are 0. So its distribution is drawn:
data are made of the fitted timeline with fresh noise, fitted again, and the share of misfits that are as large is the
p-value (parametric bootstrap). Where the noise was estimated from seeds, each draw estimates it again from as many.

The test works on the constant channel and a few means over sensitivities (:mod:`laplace_core.inverse.channels`), whose
differences are masses of a few wide bins. What breaks a timeline breaks it there: mixed policies and a wrong discount
change how long episodes run and what they pay on the whole. An error that only moves reward between neighbouring
sensitivities is not seen.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property, partial

import numpy as np

from laplace_core.code.gamma_space import GammaSpace
from laplace_core.errors import InputError
from laplace_core.inverse.axis import FORGOTTEN, Axis, axis_of, growth_for
from laplace_core.inverse.channels import channel_gains, channel_weights, channels_of
from laplace_core.inverse.interior import Optimum, solve_feasible

LAYERS = 2
ROWS = 20
"""Of the time axis: the exact steps. The windows after them grow as the noise permits."""
DRAWS = 199
LEVEL = 0.05
TOLERANCE = 1e-4
PENALTY = 1e-4
"""On |x|^2 beside a misfit of a few tens: it only picks one of the timelines that fit alike."""
BATCH = 20
LEAST_DEVIATION = 1e-4
"""Of the largest deviation that seeds show: what a few of them happen to agree on is not known without any error."""
ROUNDING = 1e-14
"""Of the masses: seeds that differ by less do not differ."""
HEARD = 0.3
"""What a direction of the whitened data must be able to change, in units of its noise, to count in the misfit. The rest
is noise whatever the timeline."""
STRONGEST = 1e4
"""The same, at most: a direction that is measured more exactly counts as if it were not. The statistic may be weighted
as one likes, data and draws alike; directions that differ by more than this from the weakest leave the solver nothing
but rounding."""


@dataclass(frozen=True, eq=False)
class Consistency:
    """What the test found.

    Attributes:
        p_value: of the null that each action has a feasible timeline.
        misfit: sum of the squared whitened residuals, all actions.
        usual: the median of the misfits drawn.
        draws: how many; fewer than asked for once the p-value cannot fall to :data:`LEVEL` any more.
        deviations: ``(A, G)``, standard deviation of the error of the constant channel.
        residuals: ``(A, G, B)``, residuals over their deviations.
        gammas: ``(G,)``.
        without: the misfits with each discount left out, ``(G,)``.
    """

    p_value: float
    misfit: float
    usual: float
    draws: int
    deviations: np.ndarray
    residuals: np.ndarray
    gammas: np.ndarray
    without: Callable[[], np.ndarray]

    @cached_property
    def relief(self) -> np.ndarray:
        """By how much the misfit falls if one discount is left out, ``(G,)``; a fit for each, made when asked for."""
        return np.asarray(self.misfit - self.without())

    @property
    def consistent(self) -> bool:
        """Whether the null stands at :data:`LEVEL`."""
        return self.p_value > LEVEL

    def blamed(self, share: float = 0.5) -> np.ndarray:
        """Discounts whose absence takes away this share of what the misfit is above the usual one, the most first."""
        excess = self.misfit - self.usual
        if self.consistent or excess <= 0.0:
            return np.array([])
        order = np.argsort(-self.relief, kind="stable")
        return np.asarray(self.gammas[order[self.relief[order] >= share * excess]])


def check_noise(
    gamma_space: GammaSpace,
    deviations: np.ndarray,
    *,
    independent: bool = True,
    starts_alive: bool = True,
    draws: int = DRAWS,
    seed: int = 0,
) -> Consistency:
    """The test with noise of known size.

    Args:
        deviations: ``(G,)``, standard deviation of the error of one value at each discount; errors are normal and
            independent between discounts.
        independent: whether those of different sensitivities are independent; if not, they are taken to be the same.

    Raises:
        InputError: deviations that do not fit the discounts.
    """
    deviations = np.asarray(deviations, dtype=float)
    if deviations.shape != gamma_space.gammas.shape or not np.all(np.isfinite(deviations) & (deviations > 0)):
        raise InputError(f"deviations must be {gamma_space.gammas.size} numbers above 0, one for each discount.")
    weights = channel_weights(gamma_space.thetas, LAYERS)[0]
    channels = channels_of(gamma_space.values, gamma_space.constant, weights)
    actions, count, discounts = channels.shape
    gains = channel_gains(weights, independent=independent)
    sizes = gains[:, None] * deviations
    whiten = 1.0 / np.sqrt(_sum_of_neighbours(sizes**2))  # (B, G)
    axis = _axis(gamma_space.gammas, deviations)

    def draw(rng: np.random.Generator, fitted: np.ndarray, n: int) -> tuple[np.ndarray, np.ndarray]:
        errors = sizes * rng.normal(size=(n, actions, count, discounts))
        return fitted + _masses(errors), whiten

    known = np.broadcast_to(deviations, (actions, discounts))
    return _test(_masses(channels), whiten, draw, axis, gamma_space.gammas, alive=starts_alive, draws=draws, seed=seed,
                 deviations=known)  # fmt: skip


def check_seeds(
    values: np.ndarray, constant: np.ndarray, gamma_space: GammaSpace, *, starts_alive: bool = True,
    draws: int = DRAWS, seed: int = 0,
) -> Consistency:  # fmt: skip
    """The test of the mean of several seeds, with the noise that their differences show.

    From n seeds the covariance of all channels and discounts has rank n - 1: it is shrunk towards its diagonal
    (:func:`shrunk_covariance`). Each draw makes n seeds of that covariance and estimates it again.

    Args:
        values: ``(n, A, G, H)``, of n seeds.
        constant: ``(n, A, G)``.
        gamma_space: any of that grid; its discounts and sensitivities are taken.

    Raises:
        InputError: fewer than three seeds, or seeds that do not differ.
    """
    n = len(values)
    if n < 3:
        raise InputError(f"{n} seeds do not show how large the noise is: give at least 3, or a noise level.")
    weights = channel_weights(gamma_space.thetas, LAYERS)[0]
    masses = _masses(channels_of(values, constant, weights))  # (n, A, B, G)
    _, actions, bins, discounts = masses.shape
    least = LEAST_DEVIATION * float(masses.std(axis=0, ddof=1).max())
    if least <= ROUNDING * np.abs(masses).max():
        raise InputError("all seeds have the same values, so they show no noise: give a noise level.")
    flat = masses.reshape(n, actions, bins * discounts)
    roots = np.array([_root(shrunk_covariance(flat[:, a], least)) for a in range(actions)])
    deviations = constant.std(axis=0, ddof=1) / np.sqrt(n)
    axis = _axis(gamma_space.gammas, np.maximum(deviations.max(axis=0), np.finfo(float).tiny))

    def whitening(samples: np.ndarray) -> np.ndarray:
        """1 / standard error of the mean, ``(..., n, A, B * G)`` to ``(..., A, B, G)``."""
        errors = np.maximum(samples.std(axis=-3, ddof=1), least)
        return np.sqrt(n) / _moderate(errors.reshape(*errors.shape[:-1], bins, discounts))

    def draw(rng: np.random.Generator, fitted: np.ndarray, many: int) -> tuple[np.ndarray, np.ndarray]:
        errors = rng.normal(size=(many, n, actions, bins * discounts))
        seeds = np.einsum("aij,mnaj->mnai", roots, errors)
        mean = fitted + seeds.mean(axis=1).reshape(many, actions, bins, discounts)
        return mean, whitening(seeds)

    return _test(masses.mean(axis=0), whitening(flat), draw, axis, gamma_space.gammas, alive=starts_alive, draws=draws,
                 seed=seed, deviations=deviations)  # fmt: skip


def shrunk_covariance(samples: np.ndarray, least: float = 0.0) -> np.ndarray:
    """Covariance of n samples ``(n, P)``, its correlations shrunk towards 0 so that it has full rank.

    The shrinkage is the one of least mean squared error, estimated from the samples themselves (Schäfer and Strimmer,
    Stat. Appl. Genet. Mol. Biol. 4, 2005); variances are kept, but for deviations below ``least``, which become it.
    """
    n, size = samples.shape
    deviations = samples.std(axis=0, ddof=1)
    deviations = np.maximum(deviations, max(least, np.finfo(float).tiny))
    scores = (samples - samples.mean(axis=0)) / deviations
    correlation = scores.T @ scores / (n - 1)
    products = scores[:, :, None] * scores[:, None, :]
    variance = n / (n - 1) ** 3 * ((products - products.mean(axis=0)) ** 2).sum(axis=0)
    off = ~np.eye(size, dtype=bool)
    total = (correlation[off] ** 2).sum()
    share = float(np.clip(variance[off].sum() / total, 0.02, 1.0)) if total > 0 else 1.0
    return np.where(off, (1.0 - share) * correlation, 1.0) * np.outer(deviations, deviations)


def _root(covariance: np.ndarray) -> np.ndarray:
    """R with R R^T = covariance, from its correlations: variances may differ by many orders."""
    deviations = np.sqrt(np.diag(covariance))
    return np.asarray(deviations[:, None] * np.linalg.cholesky(covariance / np.outer(deviations, deviations)))


def _moderate(errors: np.ndarray) -> np.ndarray:
    """Standard deviations ``(..., B, G)`` moderated over the discounts.

    From few seeds a single variance is off by half; those of one bin, divided by their course over the discounts, are
    one number. The geometric mean of the two keeps a discount that is noisier than the others.
    """
    logs = np.log(errors)
    place = np.linspace(-1.0, 1.0, errors.shape[-1])
    basis = np.linalg.qr(np.stack([np.ones_like(place), place, place**2], axis=1))[0]
    return np.asarray(np.exp((logs + (logs @ basis) @ basis.T) / 2.0))


def _axis(gammas: np.ndarray, deviations: np.ndarray) -> Axis:
    last = np.log(FORGOTTEN) / np.log(gammas.max())
    return axis_of(gammas, int(min(ROWS, np.ceil(last) + 1)), growth=growth_for(deviations, gammas))


def _masses(channels: np.ndarray) -> np.ndarray:
    """Each channel less the next, ``(..., B, G)``."""
    return np.concatenate([channels[..., :-1, :] - channels[..., 1:, :], channels[..., -1:, :]], axis=-2)


def _sum_of_neighbours(variances: np.ndarray) -> np.ndarray:
    """Variances of the masses of independent channels, ``(B, G)``."""
    return np.concatenate([variances[:-1] + variances[1:], variances[-1:]])


def _test(
    masses: np.ndarray, whiten: np.ndarray, draw: Callable[..., tuple[np.ndarray, np.ndarray]], axis: Axis,
    gammas: np.ndarray, *, alive: bool, draws: int, seed: int, deviations: np.ndarray,
) -> Consistency:  # fmt: skip
    """The bootstrap, for ``masses`` ``(A, B, G)`` with a whitening ``(A, B, G)`` or ``(B, G)``."""
    found = _fit(masses, whiten, axis, alive=alive)
    fitted = found.masses @ axis.transform.T
    misfit = float(found.misfit.sum())
    rng = np.random.default_rng(seed)
    drawn: list[float] = []
    enough = LEVEL * (draws + 1)  # as many as large, and the p-value stays above LEVEL
    while len(drawn) < draws and (np.array(drawn) >= misfit).sum() <= enough:
        count = min(BATCH, draws - len(drawn))
        made, whitening = draw(rng, fitted, count)
        whitening = whitening if whitening.ndim == 2 else whitening.reshape(-1, *masses.shape[1:])
        again = _fit(made.reshape(-1, *masses.shape[1:]), whitening, axis, alive=alive)
        drawn += again.misfit.reshape(count, -1).sum(axis=1).tolist()
    p_value = (1 + int((np.array(drawn) >= misfit).sum())) / (1 + len(drawn))
    residuals = np.swapaxes((masses - fitted) * whiten, 1, 2)
    without = partial(_without, masses, whiten, axis, alive=alive)
    return Consistency(p_value, misfit, float(np.median(drawn)), len(drawn), deviations, residuals, gammas, without)


def _fit(masses: np.ndarray, whiten: np.ndarray, axis: Axis, *, alive: bool) -> Optimum:
    """Feasible fits of ``(n, B, G)``; the whitening may be one for all, ``(B, G)``."""
    system = whiten[..., None] * axis.transform
    values, vectors = np.linalg.eigh(system @ np.swapaxes(system, -1, -2))
    heard = values > HEARD**2
    most = max(1, int(heard.sum(axis=-1).max()))
    weights = heard / np.maximum(1.0, np.sqrt(np.maximum(values, 0.0)) / STRONGEST)
    rotation = np.swapaxes(vectors[..., -most:] * weights[..., None, -most:], -1, -2)
    data = (rotation @ (whiten * masses)[..., None])[..., 0]
    return solve_feasible(rotation @ system, data, axis, PENALTY * axis.size, starts_alive=alive, tolerance=TOLERANCE)


def _without(masses: np.ndarray, whiten: np.ndarray, axis: Axis, *, alive: bool) -> np.ndarray:
    """The misfit with each discount left out, ``(G,)``."""
    discounts = masses.shape[-1]
    kept = 1.0 - np.eye(discounts)
    weights = (kept[:, None, None, :] * np.broadcast_to(whiten, masses.shape)).reshape(-1, *masses.shape[1:])
    repeated = np.broadcast_to(masses, (discounts, *masses.shape)).reshape(weights.shape)
    return np.asarray(_fit(repeated, weights, axis, alive=alive).misfit.reshape(discounts, -1).sum(axis=1))
