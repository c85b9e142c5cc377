"""Gamma-spaces of other conventions, recognised by values that no gamma-space of ours can have.

Facts that hold whatever the policies of the discounts are, for q = (1 - gamma) Q, which is a probability:

- q never rises with theta, and never exceeds 1;
- the lowest tail never exceeds the constant channel, and that channel is at least 1, for the first step happens;
- Q(gamma) - Q(gamma') is at most the constant channel at gamma less 1, for the first step is the same for both.

With one policy, Q and the constant channel never fall with gamma. Learned values keep all this up to their errors, so
that a fact counts as broken only far beyond them: what is merely noisy is read.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from itertools import permutations

import numpy as np

from laplace_core.errors import InputError

USUAL_NOISE = 0.025
"""Error of q where the data do not show theirs."""
_FAR, _SEEN, _MOST = 7.0, 0.02, 1.3
_AXES = ("actions", "gammas", "thetas")


def check_convention(values: np.ndarray, constant: np.ndarray | None, gammas: np.ndarray, thetas: np.ndarray) -> None:
    """Refuse values that are clearly those of something else.

    Args:
        values: ``(A, G, H)``; constant: ``(A, G)`` if there is one.

    Raises:
        InputError: what the values look like, and how to make a gamma-space of them.
    """
    order = np.argsort(gammas)
    gammas, values = gammas[order], values[:, order]
    constant = None if constant is None else constant[:, order]
    sizes = 1.0 - gammas
    held = np.abs(values).max(axis=2) if constant is None else np.maximum(np.abs(values).max(axis=2), constant)
    there = (held * sizes).max(axis=1) > _SEEN  # an action that is never possible holds nothing
    if not there.any():
        return
    facts = _Facts(values[there], None if constant is None else constant[there], sizes)
    if facts.sound:
        return
    # An exchange of axes can only be seen on all actions.
    exchanged = _better(values, constant, sizes, _exchanged(values.shape))
    if exchanged is not None:
        raise InputError(
            f"the axes of 'gamma_space' seem to be {_listed(exchanged)}: give them as (actions, gammas, thetas)."
        )
    if facts.rises:
        raise InputError(
            "'gamma_space' rises with theta, as values of P(r < theta) do: give those of P(r > theta), which are the "
            "constant channel less yours, or reverse its last axis if that runs against 'thetas'."
        )
    if facts.largest > _MOST:
        action, g = np.unravel_index(facts.sized.argmax(), facts.sized.shape)
        excess = f"{facts.sized[action, g] / sizes[g]:.4g} at gamma {gammas[g]:.4g}, well above 1 / (1 - gamma)"
        if _score(values[:, ::-1], None, sizes) < 0.5 * _score(values, None, sizes):
            raise InputError(
                f"'gamma_space' holds {excess}: its discounts seem to be in the reverse order of 'gammas'; "
                "reverse one of them."
            )
        raise InputError(f"'gamma_space' holds {excess}: give discounted sums of probabilities, not of rewards.")
    if facts.below:
        raise InputError(
            "'constant_channel' lies below the lowest tail of 'gamma_space': it must be the sum of gamma^tau over all "
            "steps that happen, or be left out."
        )
    if facts.scaled:
        raise InputError(
            "'gamma_space' seems to hold values times (1 - gamma), whose lowest tail or constant channel falls with "
            "gamma: divide all of them by 1 - gamma."
        )
    if facts.against:
        raise InputError(
            "'gamma_space' falls with gamma throughout: its discounts seem to be in the reverse order of 'gammas'; "
            "reverse one of them."
        )


class _Facts:
    """The violated properties of values ``(A, G, H)`` with increasing gammas, far beyond their errors."""

    def __init__(self, values: np.ndarray, constant: np.ndarray | None, sizes: np.ndarray):
        self.values, self.constant, self.sizes = values, constant, sizes
        self.errors = _errors(values, sizes)  # of q, (G,)
        self.steps = values[..., 0] if constant is None else constant
        top = values.max(axis=2) if constant is None else np.maximum(constant, values.max(axis=2))
        self.sized = sizes * top

    @property
    def sound(self) -> bool:
        broken = self.rises or self.below or self.scaled or self.against or self.early
        return not broken and self.largest <= _MOST

    @property
    def largest(self) -> float:
        return float(self.sized.max())

    @property
    def rises(self) -> bool:
        """Whether the mean of q above some theta exceeds that below it, and never the other way round as much."""
        q, count = self.values * self.sizes[:, None], self.values.shape[2]
        below = np.cumsum(q, axis=2)[..., :-1]
        left = np.arange(1, count)
        falls = below / left - (q.sum(axis=2, keepdims=True) - below) / (count - left)
        spread = np.sqrt(len(q) * np.sum(self.errors**2) * (1.0 / left + 1.0 / (count - left)))
        far, mean = falls.sum(axis=(0, 1)) / spread, falls.mean(axis=(0, 1))
        worst = int(far.argmin())
        return bool(far[worst] < -_FAR and mean[worst] < -_SEEN / 4 and -mean.min() > 2.0 * mean.max())

    @property
    def below(self) -> bool:
        """Whether the constant channel lies below the lowest tail: in the mean, or far at a single discount."""
        if self.constant is None:
            return False
        room = (self.constant - self.values[..., 0]) * self.sizes
        spread = np.sqrt(2.0) * self.errors
        whole = room.sum() / np.sqrt(len(room) * np.sum(spread**2)) < -_FAR and room.mean() < -_SEEN / 2
        return bool(whole or np.any((room < -_FAR * spread) & (room < -5.0 * _SEEN)))

    @property
    def scaled(self) -> bool:
        """Whether the steps still to come are at most 1 and fall with gamma, or do not move although the values do."""
        errors = self.errors / self.sizes  # of Q, (G,)
        if np.any(self.steps > 1.0 + 3.0 * errors + _SEEN / 4):
            return False
        if self.constant is None:
            return self._falls
        short = 1.0 - self.steps > np.maximum(_FAR * errors, _SEEN / 2)
        return bool((self._fell & short.any(axis=1)).any() or (self.early and np.all(self._moves <= 3.0)))

    @property
    def against(self) -> bool:
        """Whether the steps still to come fall with gamma throughout, from more than one."""
        return self._falls and not self.scaled

    @property
    def _falls(self) -> bool:
        """Policies that differ may let a tail fall once or twice, but not at several discounts, in all actions."""
        moves = self._moves
        return bool(np.all(moves <= 3.0) and np.all(self._fell) and np.all((moves < -1e-6).sum(axis=1) >= 3))

    @cached_property
    def _moves(self) -> np.ndarray:
        """Rises of the steps still to come from one discount to the next, in errors, ``(A, G-1)``."""
        errors = self.errors / self.sizes
        return np.diff(self.steps, axis=1) / np.hypot(errors[1:], errors[:-1])

    @cached_property
    def _fell(self) -> np.ndarray:
        """Whether the steps still to come are far fewer at a longer discount than at some shorter one, ``(A,)``."""
        errors, fell = self.errors / self.sizes, np.zeros(len(self.steps), dtype=bool)
        for g in range(1, len(errors)):  # one discount against all shorter ones: never all pairs at once
            drops = self.steps[:, :g] - self.steps[:, [g]]
            fell |= (drops > np.maximum(_FAR * np.hypot(errors[:g], errors[g]), _SEEN / 2)).any(axis=1)
        return fell

    @property
    def early(self) -> bool:
        """Whether Q differs between discounts by more than the steps after the first allow."""
        if self.constant is None:
            return False
        errors = self.errors / self.sizes
        least = self.values.min(axis=1, keepdims=True)
        at = self.values.argmin(axis=1)
        over = self.values - least - np.maximum(self.constant - 1.0, 0.0)[..., None]
        spread = np.sqrt(2.0 * errors[:, None] ** 2 + errors[at][:, None, :] ** 2)
        return bool(np.any((over > (_FAR + 1.0) * spread) & (over > 2.0 * _SEEN)))


def _errors(values: np.ndarray, sizes: np.ndarray) -> np.ndarray:
    """Error of q at each discount, ``(G,)``, by how rough q is along theta or along gamma, whichever is less.

    The lower quartile of second differences: rewards bend q at a few thetas, noise at all. A quarter of the absolute
    values of a normal number are below .3186 standard deviations; a second difference has sqrt(6) of them.
    """
    q = (values * sizes[:, None]).transpose(1, 0, 2)
    count, errors = len(q), np.full(len(q), USUAL_NOISE)
    along_gamma = np.abs(np.diff(q, n=2, axis=0))[np.clip(np.arange(count) - 1, 0, count - 3)] if count > 2 else q[:0]
    for bends in (np.abs(np.diff(q, n=2, axis=2)), along_gamma):
        quarter = np.inf
        if bends.size >= 16 * count:
            quarter = np.quantile(bends.reshape(count, -1), 0.25, axis=1)
        elif bends.size >= 16:
            quarter = np.quantile(bends, 0.25)
        errors = np.minimum(errors, 1.3 * quarter / (0.3186 * np.sqrt(6.0)))
    return errors + 1e-6


def _score(values: np.ndarray, constant: np.ndarray | None, sizes: np.ndarray) -> float:
    """The total violation of all properties, in probability; mixed policies count as one."""
    q = values * sizes[:, None]
    broken = np.maximum(np.diff(q, axis=2), 0.0).sum(axis=2).mean() + np.maximum(q - 1.0, 0.0).mean()
    broken += np.maximum(-np.diff(values, axis=1) * sizes[1:, None], 0.0).sum(axis=1).mean()
    if constant is not None:
        broken += np.maximum(values - constant[..., None], 0.0).mean(axis=2).dot(sizes).mean() / sizes.sum()
    return float(broken)


def _exchanged(shape: tuple[int, ...]) -> Iterator[tuple[int, ...]]:
    """Other orders of the axes that have the same shape."""
    for order in permutations(range(3)):
        if order != (0, 1, 2) and tuple(shape[axis] for axis in order) == shape:
            yield order


def _better(
    values: np.ndarray, constant: np.ndarray | None, sizes: np.ndarray, orders: Iterator[tuple[int, ...]]
) -> tuple[int, ...] | None:
    """The order of the axes that breaks hardly anything, if there is one."""
    scores = {}
    for order in orders:
        exchanged = values.transpose(order)
        if ((exchanged[..., 0] - exchanged[..., -1]) * sizes).mean() > _SEEN:  # it must fall with theta somewhere
            scores[order] = _score(exchanged, constant, sizes)
    best = min(scores, key=lambda order: scores[order], default=None)
    return best if best is not None and scores[best] < 0.2 * _score(values, constant, sizes) else None


def _listed(order: tuple[int, ...]) -> str:
    """Names of the axes as they are, where ``order`` is the transposition that mends them."""
    return f"({', '.join(_AXES[order.index(axis)] for axis in range(3))})"


def order_of_axes(shape: tuple[int, ...], gammas: int, thetas: int) -> str | None:
    """The likely order of the axes of a misshapen gamma-space, in words; None if its shape does not show it."""
    for order in permutations(range(len(shape))) if len(shape) in (2, 3) else ():
        if tuple(shape[axis] for axis in order)[-2:] == (gammas, thetas):
            names = _AXES[-len(shape) :]
            return f"({', '.join(names[order.index(axis)] for axis in range(len(shape)))})"
    return None
