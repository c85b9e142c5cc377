"""Replay: one ring of transitions for every environment, in preallocated arrays, whose memory the system provides as
they are filled.

Rings keep the steps of an environment in order, so that n-step rewards are gathered when a batch is drawn and no
episode in progress has to be remembered elsewhere. With separate experience for every discount, ring g belongs to
discount g and a batch has one column a discount; otherwise all rings are drawn from as one.
"""

from __future__ import annotations

import numpy as np
import torch

from laplace_core.agents.agent import Batch
from laplace_core.agents.settings import LoopSettings
from laplace_core.environments import GYMNASIUM
from laplace_core.errors import InputError
from laplace_core.training.checkpoint import check_tensors
from laplace_core.training.sum_tree import SumTree

_ARRAYS = ("observations", "next_observations", "actions", "rewards", "terminated", "ended", "elapsed")


LARGEST_NUMBER = float(np.finfo(np.float32).max)
"""Of what is not a weight: the optimiser counts its steps in millions, priorities are losses."""


class Replay:
    """Transitions of N environments.

    Args:
        capacity: transitions in all rings together.
        own: a batch takes its column g from ring g; otherwise it has one column, drawn from all rings.
        exponent: of the priorities; None replays uniformly.
        one_hot: observations have a single 1 and are 0 elsewhere: of each its place is stored.
    """

    def __init__(
        self, capacity: int, rings: int, observation: int, *, n_step: int = 1, own: bool = False,
        exponent: float | None = None, one_hot: bool = False,
    ):  # fmt: skip
        self.length, self.rings, self.n_step, self.own = max(1, capacity // rings), rings, n_step, own
        self._observation, self._one_hot = observation, one_hot
        shape = (rings, self.length)
        stored = np.zeros(shape, np.int32) if one_hot else np.zeros((*shape, observation), np.float32)
        self.observations, self.next_observations = stored, np.zeros_like(stored)
        self.actions = np.zeros(shape, np.int64)
        self.rewards = np.zeros(shape, np.float32)
        self.terminated = np.zeros(shape, bool)
        self.ended = np.zeros(shape, bool)  # terminated or truncated: rewards after it belong to another episode
        self.elapsed = np.zeros(shape, np.int32)
        self.sizes = np.zeros(rings, np.int64)
        self.heads = np.zeros(rings, np.int64)  # where each ring is written next
        self.exponent = exponent
        self.tree = None if exponent is None else SumTree(rings * self.length)
        self.top = 1.0  # largest priority so far: what a new transition gets

    def __len__(self) -> int:
        return int(self.sizes.sum())

    def add(
        self,
        real: np.ndarray,
        observations: np.ndarray,
        actions: np.ndarray,
        rewards: np.ndarray,
        *,
        next_observations: np.ndarray,
        terminated: np.ndarray,
        truncated: np.ndarray,
        elapsed: np.ndarray,
    ) -> None:
        """Store one step of every environment, arrays ``(N, ...)``, but for those where ``real`` is False."""
        rings = np.flatnonzero(real)
        places = rings, self.heads[rings]
        self.observations[places] = self._stored(observations[rings])
        self.next_observations[places] = self._stored(next_observations[rings])
        self.actions[places] = actions[rings]
        self.rewards[places] = rewards[rings]
        self.terminated[places] = terminated[rings]
        self.ended[places] = (terminated | truncated)[rings]
        self.elapsed[places] = elapsed[rings]
        if self.tree is not None and self.exponent is not None:
            self.tree.set(rings * self.length + places[1], np.full(rings.size, self.top**self.exponent))
        self.heads[rings] = (places[1] + 1) % self.length
        self.sizes[rings] = np.minimum(self.sizes[rings] + 1, self.length)

    def _stored(self, observations: np.ndarray) -> np.ndarray:
        """Observations ``(..., O)`` in the form in which they are kept."""
        return observations.argmax(axis=-1) if self._one_hot else observations

    def _seen(self, stored: np.ndarray) -> torch.Tensor:
        """The way back: ``(..., O)``."""
        if not self._one_hot:
            return torch.from_numpy(stored)
        observations = np.zeros((*stored.shape, self._observation), np.float32)
        np.put_along_axis(observations, stored[..., None], 1.0, axis=-1)
        return torch.from_numpy(observations)

    def sample(self, count: int, random: np.random.Generator, correction: float = 1.0) -> tuple[Batch, np.ndarray]:
        """A batch of ``count`` rows, and the places of its transitions ``(count, g)`` for :meth:`prioritise`."""
        weights: np.ndarray = np.ones(count, np.float32)
        if self.own:
            # An offset counts from the oldest transition of its ring.
            rings = np.broadcast_to(np.arange(self.rings), (count, self.rings))
            offsets = (random.random((count, self.rings)) * self.sizes).astype(np.int64)
            slots = (self.heads - self.sizes + offsets) % self.length
        elif self.tree is not None:
            # In any order: a round of updates divides these among its updates, and the tree draws ring after ring.
            places = random.permutation(self.tree.draw(count, random))
            weights = (len(self) * self.tree.get(places) / self.tree.total) ** -correction
            weights = (weights / weights.max()).astype(np.float32)
            rings, slots = (part[:, None] for part in np.divmod(places, self.length))
        else:
            offsets = (random.random(count) * len(self)).astype(np.int64)
            rings = np.searchsorted(np.cumsum(self.sizes), offsets, side="right")
            offsets -= (np.cumsum(self.sizes) - self.sizes)[rings]
            slots = ((self.heads - self.sizes)[rings] + offsets) % self.length
            rings, slots = rings[:, None], slots[:, None]
        return self._gather(rings, slots, weights), rings * self.length + slots

    def _gather(self, rings: np.ndarray, slots: np.ndarray, weights: np.ndarray) -> Batch:
        """Follow each transition for up to n steps: to the end of its episode or to the newest one stored."""
        left = (self.heads[rings] - slots - 1) % self.length  # transitions stored after this one
        lengths, last, going = np.ones_like(slots), slots, ~self.ended[rings, slots]
        rewards = np.zeros((*slots.shape, self.n_step), np.float32)
        rewards[..., 0] = self.rewards[rings, slots]
        for k in range(1, self.n_step):
            going = going & (k <= left)
            place = (slots + k) % self.length
            rewards[..., k] = np.where(going, self.rewards[rings, place], 0.0)
            lengths, last = lengths + going, np.where(going, place, last)
            going = going & ~self.ended[rings, place]
        return Batch(
            observations=self._seen(self.observations[rings, slots]),
            actions=torch.from_numpy(self.actions[rings, slots]),
            rewards=torch.from_numpy(rewards),
            lengths=torch.from_numpy(lengths),
            next_observations=self._seen(self.next_observations[rings, last]),
            terminated=torch.from_numpy(self.terminated[rings, last]),
            elapsed=torch.from_numpy(self.elapsed[rings, last]),
            weights=torch.from_numpy(weights),
        )

    def cut(self) -> None:
        """End the stored episodes here: transitions that are added next belong to other episodes."""
        rings = np.flatnonzero(self.sizes)
        self.ended[rings, (self.heads[rings] - 1) % self.length] = True

    def prioritise(self, places: np.ndarray, losses: np.ndarray) -> None:
        """Give the transitions at ``places`` ``(B, 1)`` the priority of their loss ``(B,)``."""
        if self.tree is not None:
            priorities = np.abs(losses).astype(np.float64) + 1e-3
            self.top = max(self.top, float(priorities.max()))
            self.tree.set(places[:, 0], priorities**self.exponent)

    def arrays(self) -> dict[str, np.ndarray]:
        """All that is stored, by name, for a resume point: as many places of each ring as the fullest one has."""
        filled = int(self.sizes.max())
        arrays = {name: array[:, :filled] for name, array in self._rings().items()}
        arrays |= {"sizes": self.sizes, "heads": self.heads}
        return arrays if self.tree is None else arrays | {"top": np.array([self.top])}

    def _rings(self) -> dict[str, np.ndarray]:
        """The stored arrays of every transition, ``(rings, length, ...)``, by name."""
        arrays: dict[str, np.ndarray] = {name: getattr(self, name) for name in _ARRAYS}
        if self.tree is not None:
            arrays["priorities"] = self.tree.leaves().reshape(self.rings, self.length)
        return arrays

    @property
    def bytes_of_transition(self) -> int:
        """Bytes that one of them takes, in memory as in a resume point."""
        return sum(array.itemsize * int(np.prod(array.shape[2:])) for array in self._rings().values())

    def restore(self, arrays: dict[str, np.ndarray], name: str) -> None:
        """Put the arrays of :meth:`arrays` back; those of version 0.2 have all places and no one-hot places.

        Args:
            name: of the file that they are from.

        Raises:
            InputError: arrays of another buffer, or places that they do not have.
        """
        arrays = self._converted(arrays)
        wanted = self.arrays()
        stored = arrays["actions"].shape[1] if arrays.get("actions", np.zeros(0)).ndim == 2 else 0
        shapes = {key: (self.rings, stored, *array.shape[2:]) if array.ndim > 1 else array.shape
                  for key, array in wanted.items()}  # fmt: skip
        # Of these arrays only shape and type are looked at: they take no memory.
        check_tensors(
            arrays,
            {key: np.broadcast_to(np.zeros((), array.dtype), shapes[key]) for key, array in wanted.items()},
            name,
            LARGEST_NUMBER,
        )
        sizes, heads = arrays["sizes"], arrays["heads"]
        full = sizes == self.length
        fits = (sizes >= 0) & (sizes <= min(stored, self.length)) & (heads >= 0) & (heads < self.length)
        if stored > self.length or not np.all(fits & (full | (heads == sizes % self.length))):
            raise InputError(f"{name!r} holds a replay buffer of {stored} places a ring whose sizes do not fit it.")
        for key in ("observations", "next_observations"):
            if self._one_hot and stored and not 0 <= arrays[key].min() <= arrays[key].max() < self._observation:
                raise InputError(f"{name!r} holds a state that its world does not have.")
        for key in _ARRAYS:
            getattr(self, key)[:, :stored] = arrays[key]
        self.sizes[...], self.heads[...] = sizes, heads
        if self.tree is not None:
            self.top = float(arrays["top"][0])
            places = np.arange(self.rings * self.length).reshape(self.rings, self.length)[:, :stored]
            self.tree.set(places.ravel(), arrays["priorities"].ravel())

    def _converted(self, arrays: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
        """Arrays of version 0.2 in the form of :meth:`arrays`."""
        arrays = dict(arrays)
        for key in ("observations", "next_observations"):
            if self._one_hot and key in arrays and arrays[key].ndim == 3 and arrays[key].shape[-1] == self._observation:
                arrays[key] = self._stored(arrays[key]).astype(np.int32)
        if arrays.get("priorities", np.zeros(())).shape == (self.rings * self.length,):
            arrays["priorities"] = arrays["priorities"].reshape(self.rings, -1)
        return arrays


def buffer_of(settings: LoopSettings, observation: int) -> Replay:
    """The empty replay buffer of a run.

    Args:
        observation: numbers in an observation.
    """
    return Replay(
        settings.buffer,
        settings.rings,
        observation,
        n_step=settings.n_step,
        own=settings.own_experience,
        exponent=settings.priority_exponent if settings.prioritised else None,
        one_hot=settings.environment not in GYMNASIUM,  # states of a tabular world
    )
