"""``make audit``: whether a locked package has a known vulnerability; exit status 1 if so, 2 if nobody can say."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[1]
LOCKS = ("requirements.lock", "requirements-cuda.lock", "requirements-dev.lock")
CANNOT = "Nothing was audited: pip-audit cannot reach its data on vulnerabilities from here."


def told(report: dict[str, Any]) -> tuple[int, str]:
    """Exit status and text for what pip-audit writes as JSON."""
    packages = report["dependencies"]
    audited = [package for package in packages if "vulns" in package]
    if not audited:
        return 2, CANNOT
    lines = []
    for package in audited:
        for flaw in package["vulns"]:
            mended = ", ".join(flaw["fix_versions"]) or "no version"
            lines.append(f"{package['name']} {package['version']}: {flaw['id']}, mended in {mended}")
    left = [package["name"] for package in packages if "vulns" not in package]
    if left:
        lines.append(f"not audited: {', '.join(left)}")
    lines.append(f"{len(audited)} packages audited")
    return int(any(package["vulns"] for package in audited)), "\n".join(lines)


def main() -> int:
    command = [sys.executable, "-m", "pip_audit", "--disable-pip", "--require-hashes", "--format", "json"]
    command += ["--progress-spinner", "off", *(word for lock in LOCKS for word in ("--requirement", lock))]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    status, text = told(json.loads(done.stdout)) if done.stdout.strip() else (2, CANNOT)
    print(text)
    return status


if __name__ == "__main__":
    sys.exit(main())
