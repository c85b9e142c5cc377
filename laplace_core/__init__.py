"""The Laplace code: learn over discounts, decode over time, act for any horizon.

from laplace_core import Settings, load_world, study

result = study(load_world("two_branch"), Settings(alpha=0.2))
result.decoded.tau_space        # (A, K, H-1): how likely each reward is at each future step
result.decoded.horizon_values   # (A, K): column T-1 is the value of each action for the horizon T
"""

from laplace_core.interrupt import guard_start

guard_start()  # above the imports, which take most of the time of a short command

from laplace_core.code.gamma_space import GammaSpace  # noqa: E402 - see above
from laplace_core.errors import InputError  # noqa: E402 - see above
from laplace_core.study.pipeline import Study, study, study_of_gamma_space  # noqa: E402 - see above
from laplace_core.study.settings import Settings  # noqa: E402 - see above
from laplace_core.worlds import PRESETS, World, load_world  # noqa: E402 - see above

__version__ = "0.2.0"

__all__ = [
    "PRESETS",
    "GammaSpace",
    "InputError",
    "Settings",
    "Study",
    "World",
    "load_world",
    "study",
    "study_of_gamma_space",
]
