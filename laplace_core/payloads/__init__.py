"""Data for a browser to draw, packed as bytes: a study, an episode, a race."""
