"""What a browser needs in order to draw, packed as bytes: of a study, of an episode, of a race."""
