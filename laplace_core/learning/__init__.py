"""From a world to its gamma-space, and to the truth that a decoded tau-space is held against."""

from laplace_core.learning.exact import proxy_gamma_space, reward_indicator_basis
from laplace_core.learning.policies import (
    TARGET_POLICIES,
    check_policy,
    greedy_policy,
    state_values,
    target_policies,
)
from laplace_core.learning.truth import finite_horizon_optimum, reward_timeline, value_of_rule

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
