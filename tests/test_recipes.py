"""Each recipe of CONTRIBUTING.md, followed with a toy example, is all that it takes."""

from __future__ import annotations

import inspect
import json
import re

import numpy as np
import pytest

from laplace_core.acting.continuations import steps_known
from laplace_core.acting.deadlines import rules_of_race
from laplace_core.acting.race import race
from laplace_core.acting.rollout import roll_out, titles_of
from laplace_core.acting.rules import RULES, Rule, rules_of, suited
from laplace_core.agents import SETTINGS, LaplaceSettings
from laplace_core.agents.peer_settings import C51Settings
from laplace_core.agents.registry import AGENTS
from laplace_core.cli import main
from laplace_core.trained import races, rollouts
from laplace_core.training.checkpoint import load_checkpoint, new_agent, save_checkpoint
from tests.support.workshop import ROOT, Workshop

SMALL = ("--steps", "400", "--hidden", "8", "--learning-starts", "50", "--buffer", "300", "--batch", "8",
         "--evaluate-every", "200", "--evaluate-episodes", "2")  # fmt: skip
"""Settings of a training that takes no time."""


def last_action(agent, length, options):
    """Always the last action, more surely the less is to go."""
    wanted = np.eye(agent.n_actions)[-1]
    return lambda observations, time: np.tile(wanted * (length - time), (len(observations), 1))


TITLE = "for T: always the last action"


@pytest.fixture
def toy(monkeypatch):
    """The recipe of ``laplace_core.acting.rules``: a function and its entry."""
    entry = Rule(last_action, lambda agent: agent.n_actions > 1, title=TITLE, words="last action")
    monkeypatch.setitem(RULES, "last", entry)


def laplace():
    return new_agent(LaplaceSettings(environment="two_branch", hidden=8, features=4, theta_max=12.0))


def test_a_rule_of_control(toy, tmp_path, capsys):
    agent = laplace()
    for each in (agent, new_agent(C51Settings(environment="two_branch", hidden=8))):
        assert "last" in rules_of(each)
    rollout = roll_out(agent, "two_branch", 0, rule="last", horizon=3, spaces=False)
    assert set(rollout.actions) == {agent.n_actions - 1}
    assert steps_known(agent, rollout, 1, 50, own=True) == 2  # it acts for T = 3, and says nothing after it

    # The forms, the links and the words of the pages.
    assert titles_of(agent)["last"] == TITLE
    assert rollouts.parameters(agent)[rollouts.RULE].parse("last") == "last"
    assert rollouts.control_of({rollouts.RULE: "last"}, 9).horizon == 9
    save_checkpoint(tmp_path / "agent.safetensors", agent, 0, None)
    loaded = load_checkpoint(tmp_path / "agent.safetensors")
    control = races.Control(loaded, "greedy", None, loaded, "last", 3)
    assert "last" in rules_of_race(agent)
    assert races.sides(control) == ("greedy", "last action")
    assert race("two_branch", *control.entrants, 0, horizon=3).right.rule == "last"

    # The command line.
    assert main(["evaluate", str(tmp_path / "agent.safetensors"), "--rule", "last", "--horizon", "3", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["rule"] == "last"
    assert main(["evaluate", str(tmp_path / "agent.safetensors"), "--rule", "last", "--alpha", "2"]) == 2
    assert "changes nothing under the rule 'last'" in capsys.readouterr().err


def test_no_rule_is_chosen_by_itself_but_those_that_suit(toy):
    assert suited(laplace(), 3) == "fading"


@pytest.fixture
def workshop(tmp_path):
    return Workshop(tmp_path)


def assert_in_the_recipe(heading, files):
    """Every file that was touched is one that the recipe names, or lies in a folder of which it names ``NAME.py``."""
    recipes = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
    (recipe,) = [text for text in recipes.split("\n## ") if text.startswith(heading)]
    for file in files:
        assert f"`{file}`" in recipe or f"`{file.rpartition('/')[0]}/NAME.py`" in recipe, file


def test_every_path_of_the_recipes_is_there():
    recipes = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
    paths = re.findall(r"`((?:app|laplace_core|tests|docs)/[^`]+)`", recipes)
    assert len(paths) > 15
    for path in paths:
        assert list(ROOT.glob(re.sub("NAME|ALGORITHM|ENVIRONMENT", "*", path))), path


LAST_ENTRY = f'''    "last": Rule(
        last_action, lambda agent: agent.n_actions > 1, title="{TITLE}", words="last action"
    ),
'''


@pytest.mark.long
def test_a_rule_of_control_in_its_file(workshop):
    rules = "laplace_core/acting/rules.py"
    workshop.insert(rules, "@dataclass(frozen=True)\nclass Rule:", f"{inspect.getsource(last_action)}\n\n")
    workshop.insert(rules, '    "own": Rule(', LAST_ENTRY)
    assert workshop.touched() == [rules]
    assert_in_the_recipe("A control rule", workshop.touched())

    (workshop.root / "checkpoints").mkdir()
    path = workshop.root / "checkpoints" / "laplace_two_branch.safetensors"
    save_checkpoint(path, laplace(), 0, None)
    (said,), (episode, race) = workshop.follow(
        ("evaluate", str(path), "--rule", "last", "--horizon", "3", "--json"),
        pages=[
            ("agents", {"checkpoint": path.stem, "r.shown": "yes", "r.rule": "last"}),
            ("race", {"checkpoint": path.stem, "d.right": "last", "d.T": "3"}),
        ],
    )
    assert json.loads(said)["rule"] == "last"
    assert TITLE in episode["options"]["r.rule"]
    assert any("player" in name for name in episode["components"])
    assert any("last action" in words for words in race["verdict"])


SWITCH_PACKAGE = """
import gymnasium
import numpy as np
from gymnasium.spaces import Box, Discrete


class Switch(gymnasium.Env):
    observation_space, action_space = Box(0.0, 1.0, (2,), np.float32), Discrete(2)

    def reset(self, *, seed=None, options=None):
        super().reset(seed=seed)
        self.on = 0
        return np.array([0.0, 1.0], np.float32), {}

    def step(self, action):
        self.on ^= int(action)
        return np.array([self.on, 1 - self.on], np.float32), float(self.on), False, False, {}


gymnasium.register("Switch-v0", Switch)
"""

SWITCH_ENTRY = """    "Switch-v0": Environment(
        "Switch: keep the light on; reward 1 a step",
        (Component("lit", "", 0.0, 1.0), Component("dark", "", 0.0, 1.0, 1.0)),
        ("stay", "switch"),
        time_limit=12,
        module="toy_switch",
    ),
"""


@pytest.mark.long
def test_an_environment(workshop):
    (workshop.packages / "toy_switch.py").write_text(SWITCH_PACKAGE)
    workshop.insert("laplace_core/environments/catalogue.py", '    "CartPole-v0": replace(', SWITCH_ENTRY)
    assert workshop.touched() == ["laplace_core/environments/catalogue.py"]
    assert_in_the_recipe("An environment", workshop.touched())

    # Trained and evaluated by the command line.
    agent = {"checkpoint": "run:lights"}
    (_, said), (form, card, episode, race) = workshop.follow(
        ("train", "laplace", "Switch-v0", "--run", "runs/lights", "--gammas", "4", "--features", "4", *SMALL),
        ("evaluate", "runs/lights/best.safetensors", "--episodes", "3", "--json"),
        pages=[
            ("train", {"environment": "Switch-v0"}), ("agents", agent), ("agents", agent | {"r.shown": "yes"}),
            ("race", agent | {"d.T": "5"}),
        ],
    )  # fmt: skip
    said = json.loads(said)
    assert said["environment"] == "Switch-v0"
    assert len(said["returns"]) == 3
    assert max(said["returns"]) <= 12

    # Offered by the form, opened, rolled out and raced on the pages.
    assert "Switch-v0" in form["options"]["environment"]
    assert "Switch: keep the light on; reward 1 a step" in card["captions"]
    assert card["sliders"][:2] == ["lit", "dark"]
    assert any("player" in name for name in episode["components"])
    assert any("track" in name for name in race["components"])


HUBER_AGENT = '''"""DQN with Huber's loss in place of the square."""

from typing import ClassVar

from torch import Tensor
from torch.nn.functional import huber_loss

from laplace_core.agents.dqn import DqnAgent
from laplace_core.agents.peer_settings import HuberSettings


class HuberAgent(DqnAgent):
    settings_class: ClassVar[type[HuberSettings]] = HuberSettings

    def loss(self, outputs: Tensor, locations: Tensor, masses: Tensor) -> Tensor:
        errors = huber_loss(outputs.expand_as(locations), locations, reduction="none", delta=self.settings.delta)
        return (masses * errors).sum(-1)
'''

HUBER_SETTINGS = '''@dataclass(frozen=True)
class HuberSettings(DqnSettings):
    """Settings of Huber DQN."""

    delta: float = setting(1.0, 1e-3, 1e6, "Error from which on the loss grows linearly.")

    ALGORITHM: ClassVar[str] = "dqn_huber"
    TITLE: ClassVar[str] = "Huber DQN"

    def numbers(self) -> str:
        return f"the return up to errors of {self.delta:g}"


'''


HUBER_IMPORT = "from laplace_core.agents.huber import HuberAgent\n"


@pytest.mark.long
def test_an_algorithm(workshop):
    agents = "laplace_core/agents"
    (workshop.root / agents / "huber.py").write_text(HUBER_AGENT)
    workshop.insert(f"{agents}/peer_settings.py", "PEERS: tuple[", HUBER_SETTINGS)
    workshop.insert(f"{agents}/peer_settings.py", "C51Settings, QrdqnSettings, Exp", "HuberSettings, ")
    workshop.insert(f"{agents}/registry.py", "from laplace_core.agents.laplace", HUBER_IMPORT)
    workshop.insert(f"{agents}/registry.py", "LaplaceAgent, C51Agent", "HuberAgent, ")
    assert workshop.touched() == [f"{agents}/{name}.py" for name in ("huber", "peer_settings", "registry")]
    assert_in_the_recipe("An algorithm", workshop.touched())

    # Trained and evaluated by the command line, with a setting of its own.
    (_, said), (form, card, race) = workshop.follow(
        ("train", "dqn_huber", "two_branch", "--run", "runs/mine", "--delta", "0.5", *SMALL),
        ("evaluate", "runs/mine/best.safetensors", "--episodes", "3", "--json"),
        copies=[("runs/mine/best.safetensors", "checkpoints/dqn_huber_two_branch.safetensors")],
        pages=[
            ("train", {"algorithm": "dqn_huber", "run": "mine"}),
            ("agents", {"checkpoint": "run:mine", "r.shown": "yes"}), ("race", {"checkpoint": "run:mine"}),
        ],
    )  # fmt: skip
    said = json.loads(said)
    assert said["algorithm"] == "dqn_huber"
    assert len(said["returns"]) == 3

    # Offered by the form with that setting, listed, opened and raced by its title.
    assert "Huber DQN" in form["options"]["algorithm"]
    assert form["numbers"]["t.delta"] == 1.0
    assert "two_branch · Huber DQN" in card["options"]["checkpoint"]
    assert any(words.startswith("Huber DQN, seed 0") for words in card["captions"])
    assert any("Outputs: the return up to errors of 0.5, discount 0.99." in words for words in card["captions"])
    assert any("player" in name for name in card["components"])
    assert any("track" in name for name in race["components"])


DISCOUNT_MEASURE = '''def other_discount(look: Look) -> Artefact | None:
    """Values read at another discount than the acting one: largest change of the true values, relative."""
    s = look.settings
    if not look.has_truth or s.value_gamma == s.acting_gamma:
        return None
    rewards = look.timeline() @ look.of_world.world.reward_values
    steps = np.arange(rewards.size)
    read, meant = (np.cumsum(rewards * gamma**steps) for gamma in (s.value_gamma, s.acting_gamma))
    size = float(np.abs(read - meant).max() / max(np.abs(meant).max(), 1e-12))
    if size < VISIBLE:
        return None
    return Artefact(
        "discount of the values",
        size,
        f"a true value moves by up to {100 * size:.0f}% of the largest one",
        WHY["discount of the values"],
        (Remedy("Read values at the acting gamma", {"value_gamma": s.acting_gamma}),),
    )


'''

DISCOUNT_EFFECT = '''    def at_another_discount(self) -> float:
        """Largest change of a true value by its discount, as a share of the largest at the acting one."""
        read, meant, change, largest = 0.0, 0.0, 0.0, 1e-12
        for step, mean in enumerate(self.timeline @ self.world.reward_values):
            read += float(mean) * self.settings.value_gamma**step
            meant += float(mean) * self.settings.acting_gamma**step
            change, largest = max(change, abs(read - meant)), max(largest, abs(meant))
        return change / largest

'''

DISCOUNT_ENTRY = '    "discount of the values": other_discount,\n'
DISCOUNT_LABEL = """    "discount of the values": Label(
        Effects.at_another_discount,
        "value gamma",
        lambda rng, world, s: {"value_gamma": float(rng.uniform(0.1, 0.8))},
    ),
"""


@pytest.mark.long
def test_an_artefact(workshop):
    measures, labels = "laplace_core/study/artefacts/deadline.py", "laplace_core/experiments/labels.py"
    workshop.insert(measures, "MEASURES: dict[", DISCOUNT_MEASURE)
    workshop.insert(measures, '    "constant horizon": constant_horizon', DISCOUNT_ENTRY)
    workshop.insert(labels, "    def constant(self)", DISCOUNT_EFFECT)
    workshop.insert(labels, '    "constant horizon": Label(', DISCOUNT_LABEL)
    assert workshop.touched() == [labels, measures]
    assert_in_the_recipe("An artefact", workshop.touched())

    decode = ("decode", "two_branch", "--explain", "--json")
    (faulty, clean, report), (page,) = workshop.follow(
        (*decode, "--value-gamma", "0.8"),
        decode,
        ("report", "detectors", "--cases", "8", "--json"),
        pages=[("worlds", {"world": "two_branch", "action": "long", "value_gamma": "0.5"})],
    )

    # Listed by the command line where it is there, and not where it is not: the long branch pays 10 at step 2, which
    # is 6.4 when it is read at .8, and 9.801 at .99.
    sizes, none = (
        {each["name"]: each["size"] for each in json.loads(said)["verdict"]["artefacts"]} for said in (faulty, clean)
    )
    assert sizes["discount of the values"] == pytest.approx(1 - 6.4 / 9.801)
    assert "discount of the values" not in none

    # On the page, with its sentence and, since it makes the choice wrong, its remedy.
    assert any("discount of the values" in words and "74% of the largest" in words for words in page["artefacts"])
    assert "Read values at the acting gamma" in page["buttons"]

    # Compared with the truth by the report, which brings it about in some cases and not in others.
    report = json.loads(report)
    (score,) = [each for each in report["artefacts"] if each["name"] == "discount of the values"]
    assert (score["precision"], score["recall"]) == (1.0, 1.0)
    assert score["true_positive"] > 0
    assert score["true_negative"] > 0
    assert score["unthrown"] == 0


HALVED_SOLVER = '''"""Half of the least-squares timeline: every mass is pulled towards 0, whatever alpha is."""

import numpy as np

from laplace_core.inverse.problem import Problem, Solution


def halved(problem: Problem, alpha: float) -> Solution:
    masses = np.linalg.pinv(problem.transform) @ problem.masses / 2
    freedom = np.full(problem.masses.shape[:-2], problem.steps / 2)
    return Solution(masses, problem.masses - problem.transform @ masses, freedom)
'''


def test_a_solver(workshop):
    solvers, words = "laplace_core/inverse/solvers.py", "laplace_core/inverse/titles.py"
    (workshop.root / "laplace_core/inverse/halved.py").write_text(HALVED_SOLVER)
    workshop.insert(solvers, "from laplace_core.inverse.linear", "from laplace_core.inverse.halved import halved\n")
    workshop.insert(
        solvers, '    "neural": Solver(', '    "halved": Solver(partial(_of_one_alpha, halved), has_alpha=False),\n'
    )
    workshop.insert(words, '    "neural": "Neural network",', '    "halved": "Half of it",\n')
    assert workshop.touched() == ["laplace_core/inverse/halved.py", solvers, words]
    assert_in_the_recipe("A solver", workshop.touched())

    # Two certain steps: the least-squares timeline of the exact values is the true one, and this is half of it.
    view = {"world": "two_branch", "p.length": "2", "solver": "halved", "selector": "gcv"}
    (said,), (inverse,) = workshop.follow(
        ("decode", "two_branch", "--param", "length=2", "--solver", "halved", "--json"),
        pages=[("inverse", view)],
    )
    expected = np.array(json.loads(said)["true_expected_reward"]) / 2
    np.testing.assert_allclose(json.loads(said)["expected_reward"], expected, atol=0.02)
    assert "Half of it" in inverse["options"]["solver"]


LARGEST_SELECTOR = '''def largest(sweep: Sweep) -> np.ndarray:
    """The largest alpha that is tried, ``(n, a)``."""
    return -np.broadcast_to(sweep.alphas, sweep.residual.shape)


'''


def test_a_selector(workshop):
    selectors, titles = "laplace_core/inverse/selectors.py", "laplace_core/inverse/titles.py"
    words = "laplace_core/payloads/inverse_words.py"
    workshop.insert(selectors, "SELECTORS: ", LARGEST_SELECTOR)
    workshop.insert(selectors, '    "fitted": fitted,', '    "largest": largest,\n')
    workshop.insert(words, '    "fitted": (', '    "largest": ("The largest alpha that is tried.", "-alpha"),\n')
    workshop.insert(titles, '    "fitted": "Fitted network"', '    "largest": "Largest",\n')
    assert workshop.touched() == [selectors, titles, words]
    assert_in_the_recipe("A selector", workshop.touched())

    decode = ("decode", "two_branch", "--json", "--alpha")
    (chosen, other), (inverse,) = workshop.follow(
        (*decode, "largest"), (*decode, "gcv"), pages=[("inverse", {"world": "two_branch", "selector": "largest"})]
    )
    record, others = (json.loads(said)["alpha_record"] for said in (chosen, other))
    assert record["value"] == max(record["alphas"])
    assert others["others"]["largest"] == max(others["alphas"])
    assert "Largest" in inverse["options"]["selector"]


COIN_WORLD = '''def coin(chance: float, reward: float) -> World:
    """A coin that is tossed until it falls: the simplest world without a longest episode."""
    rows = [Outcome(0, 0, chance, END, reward), Outcome(0, 0, 1.0 - chance, 0, 0.0)]
    return World.from_outcomes("coin", ["toss"], ["wait"], rows)


'''
COIN_ENTRY = """    coin: (
        "A coin",
        (
            Parameter("chance", 0.5, 0.01, 0.99, "Chance that it falls at a step."),
            Parameter("reward", 2.0, -1000, 1000, "What is paid when it falls."),
        ),
    ),
"""


def test_a_world(workshop):
    presets = "laplace_core/worlds/presets.py"
    workshop.insert(presets, "_PARAMETERS: dict[", COIN_WORLD)
    workshop.insert(presets, "    cliff_grid: (", COIN_ENTRY)
    assert workshop.touched() == [presets]
    assert_in_the_recipe("A world", workshop.touched())

    (listed, said), (page,) = workshop.follow(
        ("worlds",),
        ("decode", "coin", "--param", "chance=0.25", "--steps", "3", "--json"),
        pages=[("worlds", {"world": "coin", "p.chance": "0.25"})],
    )
    assert "A coin that is tossed until it falls" in listed
    # 2 is paid with probability .25 at step 0, .75 * .25 at step 1, .75^2 * .25 at step 2.
    np.testing.assert_allclose(json.loads(said)["true_expected_reward"], [[0.5, 0.375, 0.28125]])
    assert "A coin" in page["options"]["world"]


def test_every_algorithm_says_for_itself_what_it_is_called():
    """A class that only inherits them would go by the words of another."""
    assert set(AGENTS) == set(SETTINGS)
    for name, kind in SETTINGS.items():
        assert AGENTS[name].settings_class is kind
        assert {"ALGORITHM", "TITLE"} <= set(vars(kind))
        assert kind().describe()
    assert len({kind.TITLE for kind in SETTINGS.values()}) == len(SETTINGS)
