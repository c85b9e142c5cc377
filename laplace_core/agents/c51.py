"""C51: probabilities of fixed returns, by cross-entropy with the projected target (Bellemare et al. 2017)."""

from __future__ import annotations

from typing import Any, ClassVar

import torch
from torch import Tensor
from torch.nn.functional import log_softmax

from laplace_core.agents.peer import Peer
from laplace_core.agents.settings import C51Settings

FLOOR = 1e-3
"""Least mass of an atom before training, when nearly all of it lies at return 0."""


class C51Agent(Peer[C51Settings]):
    """C51.

    Attributes:
        atoms: ``(C,)``, evenly spaced from v_min to v_max, in units of reward.
    """

    settings_class: ClassVar[type[C51Settings]] = C51Settings
    in_returns: ClassVar[bool] = False

    def __init__(self, settings: C51Settings, *sizes: Any) -> None:
        self.atoms = torch.linspace(settings.v_min, settings.v_max, settings.atoms)
        super().__init__(settings, *sizes)

    @classmethod
    def channels(cls, settings: C51Settings) -> int:
        return settings.atoms

    def initial(self) -> Tensor:
        return project(torch.zeros(1, 1), torch.ones(1, 1), self.atoms)[0].clamp(min=FLOOR).log()

    def means(self, outputs: Tensor) -> Tensor:
        return torch.softmax(outputs, dim=-1) @ self.atoms

    def distribution(self, outputs: Tensor) -> tuple[Tensor, Tensor]:
        """The atoms and their probabilities."""
        return self.atoms.expand_as(outputs), torch.softmax(outputs, dim=-1)

    def loss(self, outputs: Tensor, locations: Tensor, masses: Tensor) -> Tensor:
        """Cross-entropy above the target's own entropy, which has no gradient: 0 where the two agree."""
        target = project(locations, masses, self.atoms)
        return -(target * log_softmax(outputs, dim=-1)).sum(-1) - torch.special.entr(target).sum(-1)


def project(locations: Tensor, masses: Tensor, atoms: Tensor) -> Tensor:
    """Masses on evenly spaced atoms, ``(B, C)``, from those at ``locations`` ``(B, M)``.

    Each location is shared by its two neighbours in proportion to nearness (Bellemare et al. 2017, Eq. 7): the mass is
    conserved, and so is the mean of all that lies between the outermost atoms; the rest is moved there.
    """
    last = atoms.numel() - 1
    places = ((locations - atoms[0]) * (last / (atoms[-1] - atoms[0]))).clamp(0, last)
    left = places.floor().clamp(max=last - 1)
    upper = masses * (places - left)
    result, left = torch.zeros(len(places), last + 1), left.long()
    return result.scatter_add_(1, left, masses - upper).scatter_add_(1, left + 1, upper)
