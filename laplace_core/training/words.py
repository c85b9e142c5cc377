"""Runs of training in words: what they are called, how far they are, and what was set by hand."""

from __future__ import annotations

from collections.abc import Sequence

from laplace_core.agents.settings import LoopSettings, algorithm_title
from laplace_core.supervise.jobs import duration
from laplace_core.training.curves import Curves
from laplace_core.training.defaults import changed
from laplace_core.training.progress import Progress
from laplace_core.training.queue import FAILED, FINISHED, STOPPING, TRAINING, WAITING, Run
from laplace_core.worlds.titles import world_title

_MOST_LISTED = 6


def settings_of(run: Run) -> LoopSettings:
    """The settings of a run whose folder holds some that can be read."""
    assert run.settings is not None  # others are neither drawn nor compared
    return run.settings


def title(settings: LoopSettings) -> str:
    """The title of a run."""
    return f"{algorithm_title(settings.ALGORITHM)} · {world_title(settings.environment)} · seed {settings.seed}"


def label(run: Run) -> str:
    """Short words for a run among those of its environment."""
    s = settings_of(run)
    usual = f"{s.ALGORITHM}_{s.environment.replace(':', '-')}_{s.seed}"
    rest = run.name.removeprefix(usual).strip("_") if run.name.startswith(usual) else run.name
    return f"{algorithm_title(s.ALGORITHM)}, seed {s.seed}" + (f" ({rest})" if rest else "")


def family(runs: Sequence[Run], run: Run) -> list[Run]:
    """Of runs that begin with the newest, those of the same environment, the oldest first: their returns compare."""
    environment = settings_of(run).environment
    same = [other for other in runs if other.settings and other.settings.environment == environment]
    return same[::-1]


def state(run: Run) -> str:
    """The state of a run, in words."""
    return {FAILED: "failed", WAITING: f"waiting, place {run.place}"}.get(run.state, run.state)


def progress(run: Run, progress: Progress | None, curves: Curves, places: int) -> tuple[float, str]:
    """The share of the steps that are done, and words for it.

    Args:
        progress: what the run has noted last.
        places: how many runs train at once.
    """
    of = settings_of(run).steps
    reported = [int(steps[-1]) for steps in (curves.episode_steps, curves.steps) if len(steps)]
    step = min(of, max(progress.step if progress else 0, *reported, 0))  # the last round of environments may go beyond
    step = of if run.state == FINISHED else step
    words = [f"{step:,} of {of:,} steps"]
    if run.state == WAITING:
        words.append(f"waiting; {places} runs train at once")
    elif run.state == STOPPING:
        words.append("its resume point is being written")
    elif run.state == TRAINING and not reported:
        words.append("starting" if not step else "first episodes")
    if run.state == TRAINING and progress and progress.steps_per_second:
        words.append(f"{progress.steps_per_second:,.0f} steps/s")
        if progress.seconds_left is not None:
            words.append(f"{duration(progress.seconds_left)} left")
    return min(1.0, step / of), " · ".join(words)


def set_by_hand(settings: LoopSettings) -> str:
    """The settings that differ from the recommended ones, in words."""
    words = changed(settings)
    listed = ", ".join(words[:_MOST_LISTED]) + (", ..." if len(words) > _MOST_LISTED else "")
    return f"set by hand: {listed}" if words else "recommended settings"
