"""A sum tree: draw in proportion to priorities, and change them, in logarithmic time."""

from __future__ import annotations

import numpy as np


class SumTree:
    """Priorities of ``count`` places as the leaves of a binary tree whose nodes hold the sum below them."""

    def __init__(self, count: int):
        self.count = count
        self._base = 1 << max(1, (count - 1).bit_length())  # leaves begin here; node i has the children 2i and 2i+1
        self._nodes = np.zeros(2 * self._base)

    @property
    def total(self) -> float:
        return float(self._nodes[1])

    def leaves(self) -> np.ndarray:
        return self._nodes[self._base : self._base + self.count]

    def get(self, places: np.ndarray) -> np.ndarray:
        return self._nodes[self._base + places]

    def set(self, places: np.ndarray, priorities: np.ndarray) -> None:
        """Replace priorities, never negative; of a place that is named twice the last one counts."""
        nodes = self._base + np.asarray(places)
        self._nodes[nodes] = priorities
        while nodes.size and nodes[0] > 1:
            # Sums are taken afresh from both children: differences added up would drift. All nodes are on one level.
            nodes = np.unique(nodes >> 1)
            self._nodes[nodes] = self._nodes[2 * nodes] + self._nodes[2 * nodes + 1]

    def draw(self, count: int, random: np.random.Generator) -> np.ndarray:
        """Places, one from each of ``count`` equal parts of the total, int ``(count,)``."""
        wanted = (np.arange(count) + random.random(count)) / count * self.total
        nodes = np.ones(count, np.int64)
        while nodes[0] < self._base:
            left = 2 * nodes
            sums = self._nodes[left]
            # Rounding may point beyond the last priority; a node without any is never entered.
            right = (wanted >= sums) & (self._nodes[left + 1] > 0)
            wanted = np.where(right, wanted - sums, wanted)
            nodes = left + right
        return nodes - self._base
