"""What all tests share: one hypothesis profile, the same examples on every run and no time limits."""

import gc
import os
import tempfile
from functools import cache, partial

# A worker has one core. Threads of BLAS that wait for each other on a busy machine took some tests ten times as long.
# NumPy reads it when it is imported: this stands above the imports.
os.environ["OMP_NUM_THREADS"] = os.environ["OPENBLAS_NUM_THREADS"] = os.environ["MKL_NUM_THREADS"] = "1"

import pytest
from hypothesis import settings
from streamlit.components.v2 import manifest_scanner
from streamlit.runtime.scriptrunner.script_cache import ScriptCache
from streamlit.testing.v1 import app_test, local_script_runner

os.environ["LAPLACE_RUNS"] = tempfile.mkdtemp(prefix="laplace_runs_")  # a page of a test resumes nobody's training

settings.register_profile("suite", deadline=None, derandomize=True, database=None, max_examples=20)
settings.load_profile("suite")

# Every run of an AppTest reads the metadata of all installed packages, ten times the work of the page: once is enough.
manifest_scanner.scan_component_manifests = cache(manifest_scanner.scan_component_manifests)

# And it compiles the scripts of the app again, which a server does once.
app_test.ScriptCache = local_script_runner.ScriptCache = partial(lambda shared: shared, ScriptCache())


def pytest_collection_finish():
    """What is imported by now stays: the collector of garbage need not go through it again and again."""
    gc.collect()
    gc.freeze()


@pytest.fixture(autouse=True)
def no_server():
    """A page that a test has drawn sets the limits of a server for its process: the next test has the library's."""
    from laplace_core import caching
    from laplace_core.study import size

    yield
    caching.BUDGET.limit = caching.MEGABYTES * 1_000_000
    size.set_largest_study(size.MAX_VALUES)


@pytest.fixture
def runs(tmp_path, monkeypatch):
    """The queue of the page of training, on an empty folder."""
    from app.catalogue import training_runs
    from tests.support.quick_runs import stand_in

    monkeypatch.setenv(training_runs.VARIABLE, str(tmp_path / "runs"))
    stand_in(monkeypatch)
    found = training_runs.queue()
    yield found
    for one in found.runs():
        found.end_at_once(one.name)


@pytest.fixture
def still_runs(tmp_path, monkeypatch):
    """An empty queue that moves only when a test ticks it."""
    from laplace_core.training.queue import Queue
    from tests.support.quick_runs import stand_in

    stand_in(monkeypatch)
    monkeypatch.setattr(Queue, "wake", lambda self: None)
    made = Queue(tmp_path / "runs")
    yield made
    for run in made.runs():
        made.end_at_once(run.name)
