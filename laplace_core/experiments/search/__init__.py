"""Searches over settings, on Optuna: the space, its storage, the workers, what a trial trains, and kept results."""
