"""The page of worlds: tabular worlds, learners of them, and what a person brings along."""
