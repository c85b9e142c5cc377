"""From a world to its gamma-space, and to the truth that a decoded tau-space is held against."""

from laplace_core.learning.exact import proxy_gamma_space, reward_indicator_basis
from laplace_core.learning.peers import (
    Categorical,
    Expectile,
    PlainQ,
    Quantile,
    ReturnDistribution,
    impute,
    project,
    return_distribution,
)
from laplace_core.learning.policies import (
    TARGET_POLICIES,
    check_policy,
    greedy_policy,
    state_values,
    target_policies,
)
from laplace_core.learning.td import (
    Decay,
    LaplaceTD,
    Progress,
    Sampler,
    Schedule,
    Transition,
    learn,
    sensitivity_channels,
    td_update,
)
from laplace_core.learning.truth import finite_horizon_optimum, reward_timeline, value_of_rule

__all__ = [
    "TARGET_POLICIES",
    "Categorical",
    "Decay",
    "Expectile",
    "LaplaceTD",
    "PlainQ",
    "Progress",
    "Quantile",
    "ReturnDistribution",
    "Sampler",
    "Schedule",
    "Transition",
    "check_policy",
    "finite_horizon_optimum",
    "greedy_policy",
    "impute",
    "learn",
    "project",
    "proxy_gamma_space",
    "return_distribution",
    "reward_indicator_basis",
    "reward_timeline",
    "sensitivity_channels",
    "state_values",
    "target_policies",
    "td_update",
    "value_of_rule",
]
