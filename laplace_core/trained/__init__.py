"""Jobs with trained agents: observations, rollouts, races, returns, truth by simulation; and their words."""
