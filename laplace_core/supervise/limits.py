"""The limits of a server, which its owner sets by environment variables; read once.

Each is a field of :class:`Limits`, stated as any other setting; its variable is ``LAPLACE_`` and its name in capitals,
such as ``LAPLACE_MEMORY=2000``.
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache

from laplace_core.caching import BUDGET
from laplace_core.parameters import from_variables, setting, switch
from laplace_core.study.size import set_largest_study
from laplace_core.supervise.memory import return_large


@dataclass(frozen=True)
class Limits:
    """Limits of a server; a single user can keep the defaults."""

    memory: int = setting(
        1_000, 50, 1_000_000, "Megabytes that all caches, opened files and results of the server may hold together."
    )
    largest_study: int = setting(
        10_000_000,
        10_000,
        50_000_000,
        "Numbers in the largest array of a study on a page; the library takes 50 million.",
    )
    background_seconds: int = setting(
        600, 1, 1_000_000, "Seconds that one background job of a session may take; a longer one is refused or ended."
    )
    jobs_in_line: int = setting(50, 1, 10_000, "Background jobs that may wait at once, of all sessions together.")
    learners: int = setting(2, 1, 1_000, "Tabular learners that may run at once, of all sessions together.")
    trainings: int = setting(2, 0, 1_000, "Training runs at once; others wait in the queue.")
    disk: int = setting(10_000, 1, 100_000_000, "Megabytes that the training runs may hold on disk.")
    owners: bool = switch(
        "Only the browser that started a training run may stop, resume, delete or download it.", default=True
    )
    read_only: bool = switch("Nobody may start, stop, delete or download training runs.", default=False)


ENVIRONMENTS = "LAPLACE_ENVIRONMENTS"
"""Variable that lists the environments which may be trained on, by commas; all of them where it is not set."""


@cache
def limits() -> Limits:
    """The limits of this server.

    Raises:
        InputError: a variable that states no limit.
    """
    return Limits(**from_variables(Limits, os.environ, "LAPLACE_"))


def enforce() -> None:
    """Let the library keep the limits of this server: bytes of its caches, numbers of a study.

    Raises:
        InputError: a variable that states no limit.
    """
    return_large()
    BUDGET.limit = limits().memory * 1_000_000
    set_largest_study(limits().largest_study)


def may_train(environment: str, variables: Mapping[str, str] = os.environ) -> bool:
    """Whether this server trains on an environment."""
    listed = [name.strip() for name in variables.get(ENVIRONMENTS, "").split(",") if name.strip()]
    return not listed or environment in listed
