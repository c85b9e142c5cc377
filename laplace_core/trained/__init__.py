"""What is asked of trained agents: observations, rollouts, races, returns, truth by simulation; and its words."""
