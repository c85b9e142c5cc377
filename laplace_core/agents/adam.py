"""Adam (Kingma and Ba 2015, Algorithm 1) with gradients cut to a norm, as one kernel without bookkeeping.

``torch.optim.Adam`` takes the same step twice as slowly at the size of these networks, where its checks cost as much as
its arithmetic.
"""

from __future__ import annotations

import torch
from torch import Tensor, nn

BETAS = (0.9, 0.999)
EPSILON = 1e-5
MOMENTS = ("step", "exp_avg", "exp_avg_sq")
"""Names of what Adam remembers of every parameter: steps so far, running mean of its gradient and of the square."""


class Adam:
    """The optimiser of one network.

    Attributes:
        moments: name -> one tensor for every parameter, in order; see ``MOMENTS``.
    """

    def __init__(self, parameters: list[nn.Parameter]):
        self._parameters = parameters
        self.moments: dict[str, list[Tensor]] = {
            "step": [torch.zeros(()) for _ in parameters],
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
        gradients = [parameter.grad for parameter in self._parameters]
        norm = torch.linalg.vector_norm(torch.stack(torch._foreach_norm(gradients)))
        torch._foreach_mul_(gradients, (largest / (norm + 1e-6)).clamp(max=1.0))
        steps, averages, squares = (self.moments[name] for name in MOMENTS)
        torch._foreach_add_(steps, 1.0)
        torch._fused_adam_(
            self._parameters, gradients, averages, squares, [], steps, lr=rate, beta1=BETAS[0], beta2=BETAS[1],
            weight_decay=0.0, eps=EPSILON, amsgrad=False, maximize=False, grad_scale=None, found_inf=None,
        )  # fmt: skip
        for parameter in self._parameters:
            parameter.grad = None
