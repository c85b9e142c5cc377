"""The Laplace code of a reward timeline: rewards over sensitivities, time over discounts. NumPy alone."""
