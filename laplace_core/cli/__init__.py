"""The command line, a module for each verb."""

from laplace_core.cli.verbs import main

__all__ = ["main"]
