"""The same quantities as the library's, in the slow way that is plain to see: dense, looped, sampled."""

from __future__ import annotations

import numpy as np

from laplace_core.worlds import END, World
from laplace_core.worlds.env import TabularEnv


def dense_model(world: World) -> tuple[np.ndarray, np.ndarray]:
    """P(s' | s, a) alive, ``(S, A, S)``, and P(r = v | s, a), ``(S, A, V)``, one outcome at a time.

    To idle for ever is the end.
    """
    values = list(world.reward_values)
    moves = np.zeros((world.n_states, world.n_actions, world.n_states))
    paid = np.zeros((world.n_states, world.n_actions, len(values)))
    columns = (world.state, world.action, world.next_state, world.probability, world.reward)
    over = {END, *idle_for_ever(world)}
    for s, a, successor, p, r in zip(*columns, strict=True):
        paid[s, a, values.index(r)] += p
        if successor not in over:
            moves[s, a, successor] += p
    return moves, paid


def idle_for_ever(world: World) -> set[int]:
    """States after which nothing is ever paid and END never comes, found by striking out, again and again."""
    left = set(range(world.n_states))
    columns = (world.state, world.next_state, world.probability, world.reward)
    rows = [row for row in zip(*columns, strict=True) if row[2] > 0]
    while struck := {state for state, successor, _, reward in rows if state in left
                     and (reward != 0 or successor == END or successor not in left)}:  # fmt: skip
        left -= struck
    return left


def as_table(world: World, policy: np.ndarray) -> np.ndarray:
    """Any policy as probabilities ``(S, A)``."""
    return np.eye(world.n_actions)[policy] if policy.ndim == 1 else policy


def dense_gamma_space(world: World, channels: np.ndarray, gammas: np.ndarray, policies: list[np.ndarray]) -> np.ndarray:
    """E sum_tau gamma^tau channels[r_tau, h] in all states, ``(S, A, G, H)``: a full solve for every g and h.

    Args:
        channels: what each distinct reward is worth in each channel, ``(V, H)``.
    """
    moves, paid = dense_model(world)
    found = np.empty((world.n_states, world.n_actions, len(gammas), channels.shape[1]))
    for g, (gamma, policy) in enumerate(zip(gammas, policies, strict=True)):
        table = as_table(world, policy)
        followed = np.einsum("sa,sat->st", table, moves)
        for h in range(channels.shape[1]):
            now = paid @ channels[:, h]
            later = np.linalg.solve(np.eye(world.n_states) - gamma * followed, (table * now).sum(axis=1))
            found[:, :, g, h] = now + gamma * moves @ later
    return found


def value_iteration(world: World, gamma: float) -> np.ndarray:
    """Optimal Q(s, a), ``(S, A)``, by repeating Bellman's equation until nothing moves."""
    moves, paid = dense_model(world)
    q = np.zeros((world.n_states, world.n_actions))
    while True:
        following = paid @ world.reward_values + gamma * moves @ q.max(axis=1)
        if np.abs(following - q).max() < 1e-13:
            return following
        q = following


def best_by_recursion(world: World, state: int, action: int, horizon: int, *, gamma: float) -> float:
    """Q*_T(s, a): try everything that may be done in the steps that are left."""
    total = 0.0
    for row in world.outcomes(state, action):
        later = 0.0
        if horizon > 1 and row.next_state != END:
            later = max(
                best_by_recursion(world, row.next_state, b, horizon - 1, gamma=gamma) for b in range(world.n_actions)
            )
        total += row.probability * (row.reward + gamma * later)
    return total


def rule_by_recursion(world: World, actions: np.ndarray, state: int, horizon: int, *, gamma: float) -> float:
    """J_T(s) of a rule ``actions[T-1, s]``, outcome by outcome."""
    if horizon == 0 or state == END:
        return 0.0
    return sum(
        row.probability
        * (row.reward + gamma * rule_by_recursion(world, actions, row.next_state, horizon - 1, gamma=gamma))
        for row in world.outcomes(state, int(actions[horizon - 1, state]))
    )


def timeline_by_paths(world: World, state: int, action: int, policy: np.ndarray, *, steps: int) -> np.ndarray:
    """P(r_tau = v, alive), ``(steps, V)``, by walking every path there is."""
    table, values = as_table(world, policy), list(world.reward_values)
    found, over = np.zeros((steps, len(values))), {END, *idle_for_ever(world)}

    def walk(state: int, action: int, tau: int, chance: float) -> None:
        for row in world.outcomes(state, action):
            found[tau, values.index(row.reward)] += chance * row.probability
            if row.next_state not in over and tau + 1 < steps:
                for b in np.flatnonzero(table[row.next_state]):
                    walk(row.next_state, b, tau + 1, chance * row.probability * table[row.next_state, b])

    walk(state, action, 0, 1.0)
    return found


def sampled_rewards(world: World, state: int, action: int, policy: np.ndarray, *, count: int, seed: int) -> np.ndarray:
    """Rewards of whole episodes played in the environment, ``(count, longest)``; NaN after the end.

    The first action is ``action``, the later ones those of a deterministic policy.
    """
    env = TabularEnv(world)
    env.reset(seed=seed)
    episodes = []
    for _ in range(count):
        env.reset(options={"state": state})
        observation, reward, ended, _, _ = env.step(action)
        episode = [reward]
        while not ended:
            observation, reward, ended, _, _ = env.step(policy[observation])
            episode.append(reward)
            assert len(episode) < 1_000, "the policy never ends the episode"
        episodes.append(episode)
    rewards = np.full((count, max(map(len, episodes))), np.nan)
    for row, episode in zip(rewards, episodes, strict=True):
        row[: len(episode)] = episode
    return rewards


def assert_mean_agrees(samples: np.ndarray, exact: np.ndarray, errors: float = 4.0) -> None:
    """The mean over axis 0 lies within ``errors`` standard errors of ``exact``.

    4 / count is allowed on top: an event rarer than that may well be absent, and then has no spread.
    """
    count = len(samples)
    allowed = errors * samples.std(axis=0) / np.sqrt(count) + 4.0 / count
    off = np.abs(samples.mean(axis=0) - exact)
    assert np.all(off <= allowed), f"{(off / allowed).max():.2f} times what chance allows"
