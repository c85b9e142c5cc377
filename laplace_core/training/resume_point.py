"""The arrays of a resume point: both networks, the optimiser and the replay buffer."""

from __future__ import annotations

import numpy as np
import torch

from laplace_core.agents.agent import Agent
from laplace_core.training.checkpoint import check_tensors
from laplace_core.training.replay import Replay

_MOMENTS = ("step", "exp_avg", "exp_avg_sq")


def arrays_of(agent: Agent, replay: Replay) -> dict[str, np.ndarray]:
    """Everything that is an array, by name."""
    arrays = {f"network.{name}": tensor.numpy() for name, tensor in agent.network.state_dict().items()}
    arrays |= {f"target.{name}": tensor.numpy() for name, tensor in agent.target.state_dict().items()}
    for index, parameter in enumerate(agent.network.parameters()):
        moments = agent.optimiser.state.get(parameter) or {
            "step": torch.zeros(()), "exp_avg": torch.zeros_like(parameter), "exp_avg_sq": torch.zeros_like(parameter),
        }  # fmt: skip
        arrays |= {f"optimiser.{index}.{name}": moments[name].detach().numpy() for name in _MOMENTS}
    return arrays | {f"replay.{name}": array for name, array in replay.arrays().items()}


def restore_agent(agent: Agent, replay: Replay, arrays: dict[str, np.ndarray], name: str) -> None:
    """Put the arrays back.

    Raises:
        InputError: they are not those of this agent and this buffer.
    """
    check_tensors(arrays, arrays_of(agent, replay), name)
    for part, network in (("network.", agent.network), ("target.", agent.target)):
        network.load_state_dict({key: torch.from_numpy(array) for key, array in _under(part, arrays).items()})
    for index, parameter in enumerate(agent.network.parameters()):
        kept = _under(f"optimiser.{index}.", arrays)
        # Adam keeps nothing of a parameter before its first update.
        if kept["step"] > 0:
            agent.optimiser.state[parameter] = {key: torch.from_numpy(kept[key].copy()) for key in _MOMENTS}
    replay.restore(_under("replay.", arrays))


def _under(prefix: str, arrays: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
    return {key.removeprefix(prefix): array for key, array in arrays.items() if key.startswith(prefix)}
