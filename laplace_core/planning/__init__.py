"""Dynamic programming in a tabular world: its policies, its gamma-space, and the truth that a decoded tau-space
is compared with."""

from laplace_core.planning.exact import proxy_gamma_space, reward_indicator_basis
from laplace_core.planning.policies import (
    TARGET_POLICIES,
    check_policy,
    greedy_policy,
    state_values,
    target_policies,
)
from laplace_core.planning.truth import finite_horizon_optimum, reward_timeline, value_of_rule

__all__ = [
    "TARGET_POLICIES",
    "check_policy",
    "finite_horizon_optimum",
    "greedy_policy",
    "proxy_gamma_space",
    "reward_indicator_basis",
    "reward_timeline",
    "state_values",
    "target_policies",
    "value_of_rule",
]
