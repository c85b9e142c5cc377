"""What the numbers of an observation mean, and the actions, of the environments that agents are trained in."""

from __future__ import annotations

from dataclasses import dataclass

from laplace_core.worlds import PRESETS, load_world


@dataclass(frozen=True)
class Component:
    """One number of an observation, with the range in which episodes live (physics may allow more)."""

    name: str
    unit: str
    low: float
    high: float
    start: float = 0.0


@dataclass(frozen=True)
class Scene:
    """An environment as a person reads it.

    Attributes:
        components: of an observation; empty for a tabular world, whose observation is its state.
    """

    title: str
    components: tuple[Component, ...]
    actions: tuple[str, ...]
    states: tuple[str, ...] = ()


_SCENES = {
    "CartPole-v1": Scene(
        "CartPole: keep the pole up; reward 1 a step",
        (
            Component("cart position", "m", -2.4, 2.4),
            Component("cart velocity", "m/s", -3.0, 3.0),
            Component("pole angle", "rad", -0.21, 0.21),
            Component("pole velocity", "rad/s", -3.0, 3.0),
        ),
        ("push left", "push right"),
    ),
    "Acrobot-v1": Scene(
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
    ),
    "MountainCar-v0": Scene(
        "MountainCar: swing up to the flag; reward -1 a step",
        (Component("position", "", -1.2, 0.6, -0.5), Component("velocity", "", -0.07, 0.07)),
        ("push left", "no push", "push right"),
    ),
    "LunarLander-v3": Scene(
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
    ),
}


_SCENES["CartPole-v0"] = _SCENES["CartPole-v1"]


def scene_of(environment: str) -> Scene:
    if environment in _SCENES:
        return _SCENES[environment]
    world = load_world(environment)
    title = PRESETS[environment].title if environment in PRESETS else environment.replace("gym:", "gymnasium ")
    return Scene(title, (), world.actions, world.states)
