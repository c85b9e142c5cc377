"""The page of trained agents: observations, rollouts, returns and simulated truth."""
