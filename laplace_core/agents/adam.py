"""Adam (Kingma and Ba 2015, Algorithm 1) with gradients cut to a norm, as one kernel without bookkeeping.

``torch.optim.Adam`` takes the same step twice as slowly at the size of these networks, where its checks cost as much as
its arithmetic.
"""

from __future__ import annotations

from typing import Any

import torch
from torch import Tensor, nn

BETAS = (0.9, 0.999)
EPSILON = 1e-5


class Adam:
    """The optimiser of one network.

    Attributes:
        moments: one tensor for every parameter, in order: steps so far, running means of its gradient and its square.
    """

    def __init__(self, parameters: list[nn.Parameter]):
        self._parameters: list[Any] = parameters
        self._steps = torch.zeros(len(parameters))
        self.moments: dict[str, list[Tensor]] = {
            "step": list(self._steps.unbind()),
            "exp_avg": [torch.zeros_like(parameter.data) for parameter in parameters],
            "exp_avg_sq": [torch.zeros_like(parameter.data) for parameter in parameters],
        }

    @torch.no_grad()
    def step(self, rate: float, largest: float) -> None:
        """One step along the gradients of the parameters, which are then forgotten.

        Args:
            rate: step size.
            largest: norm of all gradients together that they are scaled down to where it is greater.
        """
        parameters: list[Any]
        parameters, steps, averages, squares = self._parameters, *self.moments.values()
        gradients: list[Any] = [parameter.grad for parameter in parameters]
        if any(gradient is None for gradient in gradients):
            # A part of the network that has not been used has no gradient, and stays as it is.
            used = [i for i, gradient in enumerate(gradients) if gradient is not None]
            parts = (parameters, gradients, steps, averages, squares)
            parameters, gradients, steps, averages, squares = ([part[i] for i in used] for part in parts)
            torch._foreach_add_(steps, 1.0)
        else:
            self._steps.add_(1.0)
        norm = torch.linalg.vector_norm(torch.stack(torch._foreach_norm(gradients))) + 1e-6
        if norm > largest:
            torch._foreach_mul_(gradients, largest / norm)
        torch._fused_adam_(
            parameters, gradients, averages, squares, [], steps, lr=rate, beta1=BETAS[0], beta2=BETAS[1],
            weight_decay=0.0, eps=EPSILON, amsgrad=False, maximize=False, grad_scale=None, found_inf=None,
        )  # fmt: skip
        for parameter in parameters:
            parameter.grad = None
