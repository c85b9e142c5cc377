"""Settings that suit an algorithm and an environment, from readable files beside this module."""

from __future__ import annotations

import json
from importlib import resources
from typing import Any


def tuned_settings(algorithm: str, environment: str) -> dict[str, Any]:
    """What the file of this pair says, by name; nothing if there is none."""
    file = resources.files("laplace_core.training") / "settings" / algorithm / f"{environment}.json"
    return json.loads(file.read_text(encoding="utf-8")) if file.is_file() else {}
