"""The arrays of a resume point: both networks, the optimiser and the replay buffer."""

from __future__ import annotations

import numpy as np
import torch

from laplace_core.agents.agent import Agent
from laplace_core.training.checkpoint import check_tensors
from laplace_core.training.replay import Replay

LARGEST_NUMBER = float(np.finfo(np.float32).max)
"""Of what is not a weight: the optimiser counts its steps in millions, priorities are losses."""


def arrays_of(agent: Agent, replay: Replay) -> dict[str, np.ndarray]:
    """Everything that is an array, by name."""
    arrays = {f"network.{name}": tensor.numpy() for name, tensor in agent.network.state_dict().items()}
    arrays |= {f"target.{name}": tensor.numpy() for name, tensor in agent.target.state_dict().items()}
    for name, tensors in agent.optimiser.moments.items():
        arrays |= {f"optimiser.{index}.{name}": tensor.numpy() for index, tensor in enumerate(tensors)}
    return arrays | {f"replay.{name}": array for name, array in replay.arrays().items()}


def restore_agent(agent: Agent, replay: Replay, arrays: dict[str, np.ndarray], name: str) -> None:
    """Put the arrays back.

    Raises:
        InputError: they are not those of this agent and this buffer.
    """
    wanted = arrays_of(agent, replay)
    check_tensors(arrays, wanted, name, LARGEST_NUMBER)
    for part in ("network.", "target."):
        check_tensors(_under(part, arrays), _under(part, wanted), name)
    for part, network in (("network.", agent.network), ("target.", agent.target)):
        network.load_state_dict({key: torch.from_numpy(array) for key, array in _under(part, arrays).items()})
    for name, tensors in agent.optimiser.moments.items():
        for index, tensor in enumerate(tensors):
            tensor.copy_(torch.from_numpy(arrays[f"optimiser.{index}.{name}"]))
    replay.restore(_under("replay.", arrays))


def _under(prefix: str, arrays: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
    return {key.removeprefix(prefix): array for key, array in arrays.items() if key.startswith(prefix)}
