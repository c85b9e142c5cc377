"""The page of the paper: each of its figures and tables beside ours."""
