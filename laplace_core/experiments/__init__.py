"""Experiments: each a configuration, a run and a report."""
