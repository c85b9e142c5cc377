"""Experiments on the inverse: what its solvers, tests and certificates are worth on random worlds of known truth."""
