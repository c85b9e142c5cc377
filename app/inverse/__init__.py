"""The page Inverse: alpha by dragging, the rules that choose it, and where the choice of action turns."""
