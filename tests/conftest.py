"""What all tests share: one hypothesis profile, the same examples on every run and no time limits."""

from hypothesis import settings

settings.register_profile("suite", deadline=None, derandomize=True, database=None, max_examples=20)
settings.load_profile("suite")
