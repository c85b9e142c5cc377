"""Work of the page of trained agents that takes seconds: rollouts, their artefacts, and simulations from their states.

What is begun and done is shared by all sessions of this server.
"""

from __future__ import annotations

from collections.abc import Sequence

from app.session.jobs import Wish, background
from laplace_core.acting.continuations import Continuations, Outcomes
from laplace_core.acting.flags import Flags
from laplace_core.acting.return_laws import SimulatedReturns
from laplace_core.acting.rollout import Rollout
from laplace_core.subjects import View
from laplace_core.supervise.jobs import Job, Kind
from laplace_core.trained import returns as observed
from laplace_core.trained import rollouts, truths
from laplace_core.trained.rollouts import Control, RolledOut
from laplace_core.training.checkpoint import Loaded

MOST_KEPT = 16
"""Rollouts that are kept once they were seen, of 90 MB each at the most."""
Rolling = Job[RolledOut]

_rollouts: Kind[RolledOut] = Kind("rollouts", MOST_KEPT, line=background)
_artefacts: Kind[Flags] = Kind("artefacts along rollouts", MOST_KEPT, line=background)
_truths: Kind[Continuations | Outcomes] = Kind("simulated continuations", 8, line=background)
_returns: Kind[tuple[SimulatedReturns, ...]] = Kind("simulated returns", MOST_KEPT, line=background)


def rolling(loaded: Loaded, control: Control) -> Wish[RolledOut]:
    """The rollout of an agent under a control."""
    return Wish.of(_rollouts, rollouts.rolling(loaded, control))


def artefacts(rolled: RolledOut, view: View) -> Wish[Flags]:
    """The search for artefacts at every step under the settings of a view."""
    return Wish.of(_artefacts, rollouts.artefacts(rolled, view))


def truth(loaded: Loaded, rollout: Rollout, step: int, action: int, *, own: bool) -> Wish[Continuations | Outcomes]:
    """What follows; see :func:`laplace_core.trained.truths.truth`."""
    return Wish.of(_truths, truths.truth(loaded, rollout, step, action, own=own))


def returns(agents: Sequence[Loaded], rollout: Rollout, step: int, action: int) -> Wish[tuple[SimulatedReturns, ...]]:
    """Returns of several agents; see :func:`laplace_core.trained.returns.returns`."""
    return Wish.of(_returns, observed.returns(agents, rollout, step, action))
