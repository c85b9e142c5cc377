"""The arrays of a resume point: both networks, the optimiser and the replay buffer."""

from __future__ import annotations

import numpy as np
import torch

from laplace_core.agents.agent import Agent
from laplace_core.agents.settings import LoopSettings
from laplace_core.training.checkpoint import check_tensors, new_agent
from laplace_core.training.replay import LARGEST_NUMBER, Replay, buffer_of


def arrays_of(agent: Agent, replay: Replay) -> dict[str, np.ndarray]:
    """Everything that is an array, by name."""
    return _agent_arrays(agent) | {f"replay.{name}": array for name, array in replay.arrays().items()}


def bytes_of_run(settings: LoopSettings) -> int:
    """Bytes that the files of a run take at the most: a resume point beside the one that it replaces, and two
    checkpoints.

    Raises:
        InputError: settings that no agent can be made of.
    """
    agent = new_agent(settings)
    replay = buffer_of(settings, agent.n_observations)
    stored = min(replay.length * replay.rings, settings.steps + settings.rings) * replay.bytes_of_transition
    weights = sum(tensor.numpy().nbytes for tensor in agent.target.state_dict().values())
    return 2 * (sum(array.nbytes for array in _agent_arrays(agent).values()) + stored) + 2 * weights


def _agent_arrays(agent: Agent) -> dict[str, np.ndarray]:
    arrays = {f"network.{name}": tensor.numpy() for name, tensor in agent.network.state_dict().items()}
    arrays |= {f"target.{name}": tensor.numpy() for name, tensor in agent.target.state_dict().items()}
    for name, tensors in agent.optimiser.moments.items():
        arrays |= {f"optimiser.{index}.{name}": tensor.numpy() for index, tensor in enumerate(tensors)}
    return arrays


def restore_agent(agent: Agent, replay: Replay, arrays: dict[str, np.ndarray], name: str) -> None:
    """Put the arrays back.

    Raises:
        InputError: they are not those of this agent and this buffer.
    """
    wanted = _agent_arrays(agent)
    check_tensors(
        {key: array for key, array in arrays.items() if not key.startswith("replay.")}, wanted, name, LARGEST_NUMBER
    )
    for part in ("network.", "target."):
        check_tensors(_under(part, arrays), _under(part, wanted), name)
    for part, network in (("network.", agent.network), ("target.", agent.target)):
        network.load_state_dict({key: torch.from_numpy(array) for key, array in _under(part, arrays).items()})
    for moment, tensors in agent.optimiser.moments.items():
        for index, tensor in enumerate(tensors):
            tensor.copy_(torch.from_numpy(arrays[f"optimiser.{index}.{moment}"]))
    replay.restore(_under("replay.", arrays), name)


def _under(prefix: str, arrays: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
    return {key.removeprefix(prefix): array for key, array in arrays.items() if key.startswith(prefix)}
