"""Rules of control: how an agent that knows values for many discounts acts when an episode ends after T steps.

A rule is a function of the agent, of the length of the episode and of :class:`Options`, and returns what is called at
every step: a function from observations ``(B, O)`` and the step t, from 0, to the values of all actions ``(B, A)``, the
best of which is taken. T - t steps are to go.

To add a rule, write one more such function and its entry in ``RULES``; the command line, rollouts, races,
evaluations and pages follow.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from laplace_core.agents.agent import Agent
from laplace_core.agents.capabilities import HasDiscounts, HasGammaSpace, HasTimeToGo
from laplace_core.code.gamma_space import GammaSpace
from laplace_core.code.ties import greedy_action
from laplace_core.errors import InputError
from laplace_core.inverse import is_linear
from laplace_core.inverse.certificate import certify
from laplace_core.study.horizon import readout_weights, target_discounts
from laplace_core.study.pipeline import decode_and_read, with_alpha
from laplace_core.study.settings import Settings, resolve_for_gamma_space

FADING_ALPHA = 1e-2
"""Interpolation between neighbouring discounts is well conditioned: this only keeps rounding out."""

Judge = Callable[[np.ndarray, int], np.ndarray]
"""From observations ``(B, O)`` and the step to the values of all actions ``(B, A)``."""
Choose = Callable[[np.ndarray, int], np.ndarray]
"""The same to actions ``(B,)``."""


@dataclass(frozen=True)
class Options:
    """Options of a rule besides the length of the episode.

    Attributes:
        softness: width of the deadline as a fraction of the time to go.
        alpha, steps: regularisation and length of the inverse; it is never shorter than the episode.
        stretch: time constant of a fading deadline over the time to go.
        head: another one than the acting head to be greedy at.
        solver, selector: of the inverse, as in :class:`laplace_core.study.settings.Settings`; a selector other than
            ``typed`` chooses alpha again for every observation, in place of ``alpha``.
        noise_level: standard deviation of (1 - gamma) Q; None where it is not known.
    """

    softness: float = 0.2
    alpha: float = 1.0
    steps: int = 1000
    stretch: float = 1.5
    head: int | None = None
    solver: str = "tikhonov"
    selector: str = "typed"
    noise_level: float | None = None


def greedy(agent: Agent, length: int | None, options: Options) -> Judge:
    """Values at the acting discount, or at another one, whatever the time to go."""
    head = agent.acting_head if options.head is None else options.head
    return lambda observations, time: agent.action_values(observations, head)


def matched(agent: Agent, length: int | None, options: Options) -> Judge:
    """Values at one trained discount: that whose time constant -1 / log gamma is nearest to the time to go.

    Nearest in the logarithm; of two as near, the shorter.
    """
    gammas, length = _discounts(agent, length, "matched")
    left = np.arange(1, length + 1)
    heads = np.abs(np.log(left[:, None]) + np.log(-np.log(gammas))).argmin(axis=1)  # row T - 1 is for T steps to go
    return lambda observations, time: agent.action_values(observations, int(heads[length - time - 1]))


def readout(agent: Agent, length: int | None, options: Options) -> Judge:
    """The values of all discounts, weighed for the time to go by :func:`laplace_core.study.horizon.readout_weights`."""
    gammas, length = _discounts(agent, length, "readout")
    acting, steps = float(gammas[agent.acting_head]), max(options.steps, length)
    wanted = [target_discounts(left, steps, acting, options.softness) for left in range(1, length + 1)]
    return _by_weights(agent, readout_weights(gammas, np.array(wanted), options.alpha), length)


def fading(agent: Agent, length: int | None, options: Options) -> Judge:
    """A deadline that fades: a reward at tau counts exp(-tau / (stretch * time to go)), no more than gamma^tau allows.

    The edge of a deadline is what a gamma-space knows least about, and its weights multiply the noise of the values
    by their norm, |w|. An exponential lies between the discounts that were learned, so |w| stays at 1 or below. Where
    stretch * time to go exceeds the time constant of the acting discount, this is ``greedy``.
    """
    gammas, length = _discounts(agent, length, "fading")
    acting, left = agent.acting_head, np.arange(1, length + 1)
    constants = np.minimum(options.stretch * left, -1.0 / np.log(gammas[acting]))
    wanted = np.exp(-np.arange(max(options.steps, length)) / constants[:, None])
    weights = readout_weights(gammas, wanted, FADING_ALPHA)
    weights[options.stretch * left >= -1.0 / np.log(gammas[acting])] = np.eye(len(gammas))[acting]
    return _by_weights(agent, weights, length)


def _by_weights(agent: Agent, weights: np.ndarray, length: int) -> Judge:
    """sum_g w_g Q_g, where row T - 1 of the weights ``(length, G)`` is for T steps to go."""
    return lambda observations, time: np.einsum(
        "bga,g->ba", agent.action_values(observations), weights[length - time - 1]
    )


def decoded(agent: Agent, length: int | None, options: Options) -> Judge:
    """V_T of a tau-space that is decoded for every observation, by any solver and selector.

    With Tikhonov and a typed alpha it is the same as ``readout``, and slower. A solver that keeps survival in its
    constraints has columns for what comes after its last row, and is given as many rows as steps are left.
    """
    gammas, length = _discounts(agent, length, "decoded")
    longest = max(options.steps, length)
    chosen = Settings(
        alpha=options.alpha, steps=longest, time_step=1.0, normalise="none", solver=options.solver,
        selector=options.selector, noise_level=options.noise_level,
        acting_gamma=float(gammas[agent.acting_head]), softness=options.softness,
    )  # fmt: skip
    settings = resolve_for_gamma_space(chosen, gammas)

    def judge(observations: np.ndarray, time: int) -> np.ndarray:
        assert isinstance(agent, HasGammaSpace)  # its discounts were asked for
        left = length - time
        here = settings if is_linear(settings.solver) else replace(settings, steps=left)
        values = []
        for tails, constant in zip(*agent.gamma_spaces(observations), strict=True):
            space = GammaSpace(tails, constant, gammas, agent.thetas, open_ends=True)
            values.append(decode_and_read(space, with_alpha(space, here)[0]).horizon_values[:, left - 1])
        return np.array(values)

    return judge


def certified(agent: Agent, length: int | None, options: Options) -> Judge:
    """Greedy, unless another action is certainly worth more for the time to go.

    An action is certain where it is best in every feasible timeline that fits the values within their noise
    (:func:`laplace_core.inverse.certificate.certify`). Errors of different sensitivities come from one network: they
    are not taken to be independent.
    """
    gammas, length = _discounts(agent, length, "certified")
    if options.noise_level is None:
        raise InputError("rule 'certified' needs the size of the values' error: give --noise-level.")
    acting = float(gammas[agent.acting_head])
    deviations = options.noise_level / (1.0 - gammas)

    def judge(observations: np.ndarray, time: int) -> np.ndarray:
        assert isinstance(agent, HasGammaSpace)  # its discounts were asked for
        values = agent.action_values(observations, agent.acting_head)
        for i, (tails, constant) in enumerate(zip(*agent.gamma_spaces(observations), strict=True)):
            space = GammaSpace(tails, constant, gammas, agent.thetas, open_ends=True)
            best = certify(space, length - time, deviations, value_gamma=acting, independent=False).best
            if best is not None:
                values[i] = np.eye(agent.n_actions)[best]
        return values

    return judge


def own(agent: Agent, length: int | None, options: Options) -> Judge:
    """Values for the time to go, of an agent that has learned it; beyond its longest one, for that."""
    if not isinstance(agent, HasTimeToGo):
        raise InputError("rule 'own' needs an agent that takes the time to go as an input: train fixed_horizon.")
    longest = agent.horizon
    return lambda observations, time: agent.action_values(
        observations, min(longest, longest if length is None else length - time) - 1
    )


@dataclass(frozen=True)
class Rule:
    """A rule of control. Called with an agent, the length of an episode and :class:`Options`, it takes the best action.

    Attributes:
        values: makes the function that values actions at every step.
        suits: whether an agent has learned enough for it.
        for_deadline: whether it acts for the T of an episode; else T changes nothing.
        options: names of the :class:`Options` that it uses, besides ``steps`` and ``head``.
        needs: those of them that have to be given.
        title: what a form calls it, where that is not its name in ``RULES``.
        words: what a sentence calls it, where that is not its name either.
    """

    values: Callable[[Agent, int | None, Options], Judge]
    suits: Callable[[Agent], bool]
    for_deadline: bool = True
    options: tuple[str, ...] = ()
    needs: tuple[str, ...] = ()
    title: str = ""
    words: str = ""

    def __call__(self, agent: Agent, length: int | None, options: Options) -> Choose:
        judge = self.values(agent, length, options)
        return lambda observations, time: greedy_action(judge(observations, time))


def _has_discounts(agent: Agent) -> bool:
    return isinstance(agent, HasDiscounts)


def _has_gamma_space(agent: Agent) -> bool:
    return isinstance(agent, HasGammaSpace)


def _has_time_to_go(agent: Agent) -> bool:
    return isinstance(agent, HasTimeToGo)


RULES: dict[str, Rule] = {
    "greedy": Rule(greedy, lambda agent: True, for_deadline=False, title="greedy at a discount"),
    "matched": Rule(matched, _has_discounts, title="for T: nearest discount", words="nearest discount"),
    "fading": Rule(
        fading, _has_discounts, options=("stretch",), title="for T: fading deadline", words="fading deadline"
    ),
    "readout": Rule(readout, _has_discounts, options=("softness", "alpha"), title="for T: readout of all discounts"),
    "decoded": Rule(
        decoded,
        _has_gamma_space,
        options=("softness", "alpha", "solver", "selector", "noise_level"),
        title="for T: decoded tau-space (slow)",
        words="decoded tau-space",
    ),
    "certified": Rule(
        certified,
        _has_gamma_space,
        options=("noise_level",),
        needs=("noise_level",),
        title="for T: greedy unless another action is certainly better",
    ),
    "own": Rule(own, _has_time_to_go, title="for T: values of the steps to go", words="learned values"),
}


def rules_of(agent: Agent) -> tuple[str, ...]:
    """Names of the rules that an agent has learned enough for, the one that suits it best first."""
    suitable = tuple(name for name, rule in RULES.items() if rule.suits(agent))
    return ("own", *(name for name in suitable if name != "own")) if "own" in suitable else suitable


def title_of(rule: str) -> str:
    """The title of a rule in a form; a rule that is not in the list, such as random actions, keeps its name."""
    return (RULES[rule].title if rule in RULES else "") or rule


def words_of(rule: str) -> str:
    """The name of a rule in a sentence."""
    return (RULES[rule].words if rule in RULES else "") or rule


def for_deadline(rule: str) -> bool:
    """Whether a rule acts for the T of an episode, which random actions do not."""
    return rule in RULES and RULES[rule].for_deadline


def check_rule_options(rule: str, given: Iterable[str]) -> None:
    """Refuse an option that a rule would not use; a rule that does not exist is refused elsewhere.

    Raises:
        InputError: naming the option and the rules that take it.
    """
    for name in given if rule in RULES else ():
        if name not in RULES[rule].options:
            takers = " and ".join(taker for taker, other in RULES.items() if name in other.options)
            option = "alpha by name" if name == "selector" else name.replace("_", "-")
            raise InputError(f"--{option} changes nothing under the rule {rule[:40]!r}: it is for {takers}.")


def options_for(rule: str, given: Mapping[str, Any]) -> dict[str, Any]:
    """The options that a rule uses; none for a rule that does not exist."""
    return {name: value for name, value in given.items() if rule in RULES and name in RULES[rule].options}


def suited(agent: Agent, horizon: int | None) -> str:
    """The rule by which an agent acts for a horizon if none is named."""
    if horizon is None:
        return "greedy"
    if isinstance(agent, HasTimeToGo):
        return "own"
    return "fading" if isinstance(agent, HasDiscounts) else "greedy"


def _discounts(agent: Agent, length: int | None, rule: str) -> tuple[np.ndarray, int]:
    """Discounts of the agent, and the length of an episode.

    Raises:
        InputError: it has one discount only, or the episode has no end to go to.
    """
    if not isinstance(agent, HasDiscounts):
        raise InputError(f"rule {rule!r} needs an agent with many discounts.")
    if length is None:
        raise InputError(f"rule {rule!r} needs a horizon here: the environment has no time limit.")
    return agent.gammas, length
