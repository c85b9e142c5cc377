"""Training: from settings to a checkpoint. This module loads no torch; ``laplace_core.training.loop`` does."""
