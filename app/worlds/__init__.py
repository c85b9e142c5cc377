"""The page Worlds: tabular worlds, their learners, and the user's own worlds, timelines and gamma-spaces."""
