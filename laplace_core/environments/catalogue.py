"""The environments that agents are trained in: names, components, actions and remarks, each stated once.

An environment of gymnasium is one entry in :data:`GYMNASIUM`; tabular worlds speak for themselves. Nothing here loads
gymnasium, so that lists, forms and checkpoints open where the physics of an environment is not installed.
:mod:`laplace_core.environments.vector` builds and steps what is listed here.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

from laplace_core.errors import InputError
from laplace_core.worlds import PRESETS, TOY_TEXT, load_world, toy_text_limit

WORLD_TIME_LIMIT = 200
"""Steps after which an episode in a preset world is truncated, and in one of gymnasium's that sets no limit itself."""


@dataclass(frozen=True)
class Component:
    """One number of an observation, with the range in which episodes live (physics may allow more)."""

    name: str
    unit: str
    low: float
    high: float
    start: float = 0.0


@dataclass(frozen=True)
class Environment:
    """An environment whose observations are numbers, or the state of a tabular world, and whose actions are few.

    Attributes:
        title: what it is about, in one line.
        components: the numbers of an observation, in order; empty for a tabular world.
        actions: what the actions are called, in order.
        states: names of the states of a tabular world; empty for other environments.
        time_limit: steps after which an episode is truncated; None if it never is.
        chance: whether the same action in the same state may lead to different things.
        inner: attributes that are all of its inner state besides its random numbers and its time. None where there is
            more to it: a run that is gone on with begins its episodes again there.
        seconds: that a step lasts in life; by default as many as the eye can follow.
        remark: what a race to a deadline should be read with; empty for nothing.
        module: the module that registers it with gymnasium when it is imported; empty for gymnasium's own.
    """

    title: str
    components: tuple[Component, ...]
    actions: tuple[str, ...]
    states: tuple[str, ...] = ()
    time_limit: int | None = None
    chance: bool = True
    inner: tuple[str, ...] | None = None
    seconds: float = 0.05
    remark: str = ""
    module: str = ""


_CARTPOLE = Environment(
    "CartPole: keep the pole up; reward 1 a step",
    (
        Component("cart position", "m", -2.4, 2.4),
        Component("cart velocity", "m/s", -3.0, 3.0),
        Component("pole angle", "rad", -0.21, 0.21),
        Component("pole velocity", "rad/s", -3.0, 3.0),
    ),
    ("push left", "push right"),
    time_limit=500,
    chance=False,
    inner=("state", "steps_beyond_terminated"),
    seconds=0.02,
    remark="Every step pays 1 while the pole stands: what is best hardly depends on the deadline.",
)

GYMNASIUM: dict[str, Environment] = {
    "CartPole-v1": _CARTPOLE,
    "Acrobot-v1": Environment(
        "Acrobot: swing the tip above the line; reward -1 a step",
        (
            Component("cos of the first angle", "", -1.0, 1.0, 1.0),
            Component("sin of the first angle", "", -1.0, 1.0),
            Component("cos of the second angle", "", -1.0, 1.0, 1.0),
            Component("sin of the second angle", "", -1.0, 1.0),
            Component("first joint's velocity", "rad/s", -12.57, 12.57),
            Component("second joint's velocity", "rad/s", -28.27, 28.27),
        ),
        ("torque -1", "no torque", "torque +1"),
        time_limit=500,
        chance=False,
        inner=("state",),
        seconds=1 / 15,
        remark="Every step costs 1 until the tip is up: the fastest way is best for any deadline that it makes.",
    ),
    "LunarLander-v3": Environment(
        "LunarLander: land between the flags; shaped rewards, +-100 at the end",
        (
            Component("position across", "", -1.5, 1.5),
            Component("height", "", -0.2, 1.5, 1.4),
            Component("velocity across", "", -2.0, 2.0),
            Component("velocity upwards", "", -2.0, 2.0),
            Component("angle", "rad", -3.14, 3.14),
            Component("angular velocity", "rad/s", -5.0, 5.0),
            Component("left leg on the ground", "", 0.0, 1.0),
            Component("right leg on the ground", "", 0.0, 1.0),
        ),
        ("nothing", "left engine", "main engine", "right engine"),
        time_limit=1000,
        seconds=0.02,
    ),
    "MountainCar-v0": Environment(
        "MountainCar: swing up to the flag; reward -1 a step",
        (Component("position", "", -1.2, 0.6, -0.5), Component("velocity", "", -0.07, 0.07)),
        ("push left", "no push", "push right"),
        time_limit=200,
        chance=False,
        inner=("state",),
        remark="Every step costs 1 until the flag: the fastest way is best for any deadline that it makes.",
    ),
    "CartPole-v0": replace(_CARTPOLE, time_limit=200),
}
"""Those of gymnasium, by the name that it gives them; a test holds each entry against the environment itself."""

GYMNASIUM_ENVIRONMENTS = tuple(GYMNASIUM)
ENVIRONMENTS = (*GYMNASIUM_ENVIRONMENTS, *PRESETS, *(f"gym:{name}" for name in TOY_TEXT))
"""Every environment that can be trained on and that a checkpoint may name: no others are ever built."""


def environment_of(name: str) -> Environment:
    """The entry of an environment of the list.

    Raises:
        InputError: a name that is not on it.
    """
    if name not in ENVIRONMENTS:
        raise InputError(f"environment {str(name)[:40]!r} is not one of {', '.join(ENVIRONMENTS)}.")
    if name in GYMNASIUM:
        return GYMNASIUM[name]
    world = load_world(name)
    title = PRESETS[name].title if name in PRESETS else name.replace("gym:", "gymnasium ")
    own_limit = toy_text_limit(name.removeprefix("gym:")) if name.startswith("gym:") else None
    return Environment(title, (), world.actions, world.states, own_limit or WORLD_TIME_LIMIT)
