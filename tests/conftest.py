"""What all tests share: one hypothesis profile, the same examples on every run and no time limits."""

import os
import tempfile

from hypothesis import settings

os.environ["LAPLACE_RUNS"] = tempfile.mkdtemp(prefix="laplace_runs_")  # a page of a test resumes nobody's training

settings.register_profile("suite", deadline=None, derandomize=True, database=None, max_examples=20)
settings.load_profile("suite")
