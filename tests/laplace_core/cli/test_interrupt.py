"""Ctrl-C and SIGTERM in every verb: one line and a status, while it imports and while it works."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from laplace_core.cli import main, verbs
from tests.support.quick_runs import until

ROOT = Path(__file__).resolve().parents[3]
AGENT = str(ROOT / "checkpoints" / "laplace_CartPole-v1.safetensors")
VERBS = {
    "worlds": ["worlds"],
    "decode": ["decode", "two_branch"],
    "learn": ["learn", "two_branch"],
    "train": ["train", "laplace", "two_branch", "--run", "run"],
    "evaluate": ["evaluate", AGENT],
    "race": ["race", AGENT, "--horizon", "9"],
    "report": ["report", "shipped"],
    "search": ["search", "dqn", "two_branch", "--vary", "averaging=0.01,0.05"],
    "reproduce": ["reproduce", "all", "--budget"],
}
FUNCTIONS = {
    "worlds": "verbs._worlds", "decode": "verbs.study_of_options", "learn": "learn.Learning",
    "train": "train.settings_of", "evaluate": "evaluate.checked_number", "race": "race.checked_number",
    "report": "report.Path", "search": "search.named_params", "reproduce": "reproduce.recorded_rows",
}  # fmt: skip
"""Something that each verb calls when it is at work, in the module of its name."""


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_every_verb_that_is_interrupted_at_work_ends_with_one_line(
    subtests, tmp_path, monkeypatch, capsys, number
):  # fmt: skip
    """The parser hands a verb's function over when it is made, once for all verbs."""
    monkeypatch.chdir(tmp_path)
    for verb, words in VERBS.items():
        with subtests.test(verb), monkeypatch.context() as patched:
            patched.setattr(f"laplace_core.cli.{FUNCTIONS[verb]}", lambda *_, **__: os.kill(os.getpid(), number))
            verbs.parser.cache_clear()
            before = [signal.getsignal(each) for each in (signal.SIGINT, signal.SIGTERM)]
            if number == signal.SIGINT:
                assert main(words) == 130
            else:
                with pytest.raises(SystemExit) as ended:
                    main(words)
                assert ended.value.code == 143
            assert capsys.readouterr().err == ("laplace: stopped\n" if number == signal.SIGINT else "")
            assert [signal.getsignal(each) for each in (signal.SIGINT, signal.SIGTERM)] == before
    verbs.parser.cache_clear()
    assert list(tmp_path.iterdir()) == []


def imported(process: subprocess.Popen, library: str) -> bool:
    """Whether a process has begun to load a library, by what it has mapped."""
    return library in Path(f"/proc/{process.pid}/maps").read_text()


@pytest.mark.skipif(not Path("/proc/self/maps").exists(), reason="what a process loads is read from /proc")
@pytest.mark.parametrize(
    ("words", "library"),
    [(VERBS["worlds"], "_multiarray_umath"), (VERBS["decode"], "scipy"), (VERBS["report"], "libtorch_cpu")],
    ids=["numpy", "scipy", "torch"],
)
def test_a_command_that_is_interrupted_while_it_imports_ends_with_one_line(words, library):
    process = subprocess.Popen(
        [sys.executable, "-m", "laplace_core", *words], cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
        text=True,
    )  # fmt: skip
    until(lambda: imported(process, library))
    process.send_signal(signal.SIGINT)
    assert process.communicate(timeout=120)[1] == "laplace: stopped\n"
    assert process.returncode == 130


def test_a_program_that_uses_the_library_keeps_its_own_handler():
    code = "import signal; before = signal.getsignal(2); import laplace_core; assert signal.getsignal(2) is before"
    assert subprocess.run([sys.executable, "-c", code], cwd=ROOT).returncode == 0
