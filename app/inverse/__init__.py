"""The page of the inverse: alpha under the finger, what the rules say of it, and where the decision turns."""
