"""The page of deadline races."""
