"""The inverse, studied: random cases with a known truth, and reports of how solvers and grids do on them."""
