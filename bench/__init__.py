"""Costs of the library as ratios measured in one run, each beside its goal: ``python -m bench``."""
