"""Adam in one kernel against torch's own, step by step."""

from __future__ import annotations

import torch

from laplace_core.agents.adam import Adam


def test_steps_are_those_of_torch():
    """Gradients of norm 40 are cut to 10 by both, those of norm 4 by neither; they are forgotten after the step."""
    random = torch.Generator().manual_seed(0)
    start = [torch.randn(shape, generator=random) for shape in ((5, 3), (5,), (1, 5))]
    mine, theirs = ([torch.nn.Parameter(tensor.clone()) for tensor in start] for _ in range(2))
    one, other = Adam(mine), torch.optim.Adam(theirs, eps=1e-5, fused=True)
    for step, size in enumerate((4.0, 40.0, 4.0, 40.0)):
        gradients = [torch.randn(tensor.shape, generator=random) for tensor in start]
        norm = torch.cat([gradient.flatten() for gradient in gradients]).norm()
        for parameters in (mine, theirs):
            for parameter, gradient in zip(parameters, gradients, strict=True):
                parameter.grad = gradient * (size / norm)
        rate = 0.1 / (step + 1)
        one.step(rate, 10.0)
        other.param_groups[0]["lr"] = rate
        torch.nn.utils.clip_grad_norm_(theirs, 10.0)
        other.step()
        for parameter, expected in zip(mine, theirs, strict=True):
            torch.testing.assert_close(parameter, expected)
            assert parameter.grad is None
    for name in ("exp_avg", "exp_avg_sq", "step"):
        for found, parameter in zip(one.moments[name], theirs, strict=True):
            torch.testing.assert_close(found, other.state[parameter][name])


def test_the_first_step_worked_by_hand():
    """Bias-corrected, both moments of the first gradient g are g and g^2: the step is rate g / (|g| + eps)."""
    parameter = torch.nn.Parameter(torch.tensor([1.0, 1.0]))
    parameter.grad = torch.tensor([0.5, -1e-5])
    Adam([parameter]).step(0.1, 10.0)
    torch.testing.assert_close(parameter.data, torch.tensor([0.9, 1.05]), atol=1e-5, rtol=0.0)


def test_what_has_no_gradient_stays():
    used, unused = (torch.nn.Parameter(torch.ones(2)) for _ in range(2))
    used.grad = torch.ones(2)
    optimiser = Adam([unused, used])
    optimiser.step(0.1, 10.0)
    assert torch.equal(unused.data, torch.ones(2))
    assert torch.all(used.data < 1.0)
    assert [int(count) for count in optimiser.moments["step"]] == [0, 1]
