"""The lock files hold exactly what the pins need, each package with hashes; an audit that could see nothing says so."""

from __future__ import annotations

import re
import runpy
from importlib.metadata import distribution
from pathlib import Path

import pytest
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

ROOT = Path(__file__).resolve().parents[1]
APP = ("requirements.lock", "requirements-cpu.lock")
LOCKS = (*APP, "requirements-cuda.lock", "requirements-dev.lock")
AUDIT = runpy.run_path(str(ROOT / ".ci" / "audit.py"))
LOCK = runpy.run_path(str(ROOT / ".ci" / "lock.py"))


def pins(name: str) -> list[Requirement]:
    """The lines of a file of requirements that state a package."""
    lines = (ROOT / name).read_text().splitlines()
    return [Requirement(line.removesuffix(" \\")) for line in lines if re.match(r"[a-zA-Z]", line)]


def locked(*names: str) -> dict[str, str]:
    """Version of every package that the files install on this machine, by its name."""
    found = {}
    for pin in (pin for name in names for pin in pins(name)):
        if pin.marker is None or pin.marker.evaluate():
            assert canonicalize_name(pin.name) not in found, f"{pin.name} is locked twice"
            (version,) = pin.specifier
            found[canonicalize_name(pin.name)] = version.version
    return found


def needed(*names: str) -> dict[str, str]:
    """What files of requirements lead to, by the packages that are installed: version by name, all the way down."""
    found, ahead = {}, [pin for name in names for pin in pins(name)]
    while ahead:
        pin = ahead.pop()
        extras = {"extra": ""} if not pin.extras else {"extra": next(iter(pin.extras))}
        name = canonicalize_name(pin.name)
        if (pin.marker is not None and not pin.marker.evaluate({"extra": ""})) or name in found:
            continue
        installed = distribution(name)
        found[name] = installed.version
        for each in map(Requirement, installed.requires or ()):
            if each.marker is None or each.marker.evaluate(extras):
                each.marker = None
                ahead.append(each)
    return found


def test_the_locks_hold_what_the_pins_lead_to():
    assert locked(*APP) == needed("requirements.txt")
    assert locked(*APP, "requirements-dev.lock") == needed("requirements.txt", "requirements-dev.txt")


@pytest.mark.parametrize(("file", "locks"), [("requirements.txt", APP), ("requirements-dev.txt", LOCKS)])
def test_every_pin_is_locked_at_its_version(file, locks):
    versions = {canonicalize_name(pin.name): pin.specifier for name in locks for pin in pins(name)}
    for pin in pins(file):
        (wanted,), (held,) = pin.specifier, versions[canonicalize_name(pin.name)]
        assert held.version.removesuffix("+cpu") == wanted.version, pin.name


@pytest.mark.parametrize("name", LOCKS)
def test_every_locked_package_has_hashes_and_no_address(name):
    text = (ROOT / name).read_text()
    assert "://" not in text
    entries = re.split(r"^(?=[a-z0-9])", text, flags=re.MULTILINE)[1:]
    assert entries
    for entry in entries:
        assert re.search(r"--hash=sha256:[0-9a-f]{64}\b", entry), entry.splitlines()[0]


def test_torch_is_locked_in_both_builds_and_only_one_of_them_needs_cuda():
    small, large = ([str(pin) for pin in pins(f"requirements-{build}.lock")] for build in ("cpu", "cuda"))
    assert [pin.split(";")[0] for pin in small] == ["torch==2.13.0+cpu", "torch==2.13.0"]
    assert large[0] == 'torch==2.13.0; sys_platform == "linux"'
    assert any(pin.startswith("nvidia-cublas") for pin in large)
    assert not any(pin.name.startswith(("nvidia", "cuda", "triton")) for pin in pins("requirements.lock"))


def test_entries_are_told_apart_by_their_first_lines(monkeypatch):
    first = "alpha==1 \\\n    --hash=sha256:aa \\\n    --hash=sha256:bb\n"
    second = "beta==2 ; os_name == 'nt' \\\n    --hash=sha256:cc\n"
    done = type("Done", (), {"stdout": f"# a remark\n{first}{second}"})
    monkeypatch.setattr(LOCK["subprocess"], "run", lambda *_, **__: done)
    assert LOCK["compiled"]("requirements.txt") == {"alpha==1": first, "beta==2 ; os_name == 'nt'": second}


def test_an_audit_tells_flaws_and_what_it_could_not_see(subtests):
    sound = {"name": "sound", "version": "1", "vulns": []}
    flawed = {"name": "flawed", "version": "2", "vulns": [{"id": "CVE-1", "fix_versions": ["3"]}]}
    unseen = {"name": "unseen", "skip_reason": "not found"}
    for packages, status, text in [
        ([sound], 0, "1 packages audited"),
        ([sound, flawed], 1, "flawed 2: CVE-1, mended in 3\n2 packages audited"),
        ([sound, unseen], 0, "not audited: unseen\n1 packages audited"),
        ([unseen], 2, "Nothing was audited: pip-audit cannot reach its data on vulnerabilities from here."),
        ([], 2, "Nothing was audited: pip-audit cannot reach its data on vulnerabilities from here."),
    ]:
        with subtests.test(text=text):
            assert AUDIT["told"]({"dependencies": packages}) == (status, text)


def test_the_app_and_the_image_are_installed_by_the_lock():
    for file in ("Makefile", "Dockerfile"):
        text = (ROOT / file).read_text()
        assert "pip install" in text
        assert "--require-hashes" in text
        assert "-r requirements.txt" not in text
