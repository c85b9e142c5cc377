"""``make lock``: from the pins of requirements*.txt, every package that they need, with the hashes of its files.

``requirements.lock`` is the app's without torch, ``requirements-dev.lock`` what the tests need on top. torch comes in
two builds: ``requirements-cpu.lock`` is the one without CUDA, which is small and enough, ``requirements-cuda.lock`` the
one that a registry gives on Linux, with some gigabytes of libraries. On all other systems there is only one.
"""

from __future__ import annotations

import hashlib
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
HEAD = "# Written by `make lock`; to be installed with --require-hashes --no-deps.\n"
_CUDA = re.compile(r"(nvidia|cuda)-|triton$")  # beginnings of names of packages that only torch with CUDA needs
_ENTRY = re.compile(r"^(?=\S)(?!#)", re.MULTILINE)  # where the entry of a package begins


def compiled(requirements: str) -> dict[str, str]:
    """The entry of every package that a file of requirements leads to, by its first line: name, version, marker."""
    command = [
        sys.executable, "-m", "uv", "pip", "compile", requirements, "--quiet", "--universal", "--generate-hashes",
        "--python-version", "3.11", "--no-annotate", "--no-header", "--no-emit-index-url", "--no-emit-find-links",
    ]  # fmt: skip
    done = subprocess.run(command, cwd=ROOT, stdout=subprocess.PIPE, text=True, check=True)
    entries = [entry for entry in _ENTRY.split(done.stdout) if entry.strip() and not entry.startswith("#")]
    return {entry.splitlines()[0].removesuffix(" \\"): entry for entry in entries}


def cpu_build(pin: str) -> str:
    """The hash of the file that pip takes for a pin here."""
    with tempfile.TemporaryDirectory() as folder:
        command = [sys.executable, "-m", "pip", "download", "--quiet", "--no-deps", "--dest", folder, pin]
        subprocess.run(command, check=True)
        (wheel,) = Path(folder).iterdir()
        return hashlib.sha256(wheel.read_bytes()).hexdigest()


def main() -> None:
    app, dev = compiled("requirements.txt"), compiled("requirements-dev.txt")
    cuda = {first: entry for first, entry in app.items() if _CUDA.match(first.split("==")[0])}
    (torch,) = (first for first in app if first.startswith("torch=="))
    from_registry = app[torch].replace(torch, f"{torch} ; sys_platform {{}} 'linux'")
    small = f"{torch}+cpu ; sys_platform == 'linux' \\\n    --hash=sha256:{cpu_build(f'{torch}+cpu')}\n"
    wanted = {
        "requirements.lock": [entry for first, entry in app.items() if first != torch and first not in cuda],
        "requirements-cpu.lock": [small, from_registry.format("!=")],
        "requirements-cuda.lock": [from_registry.format("=="), *cuda.values()],
        "requirements-dev.lock": [entry for first, entry in dev.items() if first not in app],
    }
    for name, entries in wanted.items():
        (ROOT / name).write_text(HEAD + "".join(entries))
        print(f"{name}: {len(entries)} entries")


if __name__ == "__main__":
    main()
