"""What a fresh Python loads: the library and its command start without a network library or a screen."""

import json
import subprocess
import sys

import pytest

HEAVY = ("torch", "streamlit", "plotly")
REPORT = f"import json, sys; print(json.dumps([m for m in {HEAVY!r} if m in sys.modules]))"


def loaded_after(code: str) -> list[str]:
    done = subprocess.run([sys.executable, "-c", f"{code}\n{REPORT}"], capture_output=True, text=True, check=True)
    return json.loads(done.stdout.splitlines()[-1])


@pytest.mark.parametrize(
    "code",
    [
        "import laplace_core",
        "import laplace_core.training.queue, laplace_core.training.curves",
        "from laplace_core.cli import main; assert main(['decode', 'two_branch', '--state', '0']) == 0",
        "from laplace_core.cli import main; assert main(['worlds']) == 0",
    ],
)
def test_core_and_command_start_light(code):
    assert loaded_after(code) == []
