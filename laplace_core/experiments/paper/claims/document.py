"""``docs/reproduction.md``: the catalogue as a document, claim by claim."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from laplace_core.experiments.paper.claims import ENTRIES, MISSING, STATES, Found, look
from laplace_core.experiments.paper.claims.entry import DIFFERS, RUN

COMMAND = f"{RUN} reproduce --document > docs/reproduction.md"
_OPENING = f"""# The paper, claim by claim

*Laplace DQN: Deep RL Algorithm for Temporally Flexible Planning*: every figure, table and claim of it beside our
results. All numbers below are those of the files in `docs/paper/` and of the bundled agents. The page Paper of the
workbench shows the same with pictures. This command writes the page from the files:

```
{COMMAND}
```

Numbers of the paper are marked as such. Where ours have a range, it goes from the lowest to the highest seed; where
agents act under a deadline, it is a 95% interval, which draws agents and starts. The paper used LunarLander-v2, which
gymnasium no longer has; ours is v3. Every row in a file of results has its date and the versions that made it.
"""


def document(folder: Path, agents: Path) -> str:
    """The page, from a folder of results and that of the agents that ship."""
    found = [look(entry, folder, agents) for entry in ENTRIES]
    return (
        "\n".join(
            [_OPENING, *_overview(found), *_differing(found), *(line for each in found for line in _section(each))]
        )
        + "\n"
    )


def _overview(found: Sequence[Found]) -> list[str]:
    used = {each.state for each in found}
    rows = [f"| {each.entry.place} | {each.entry.title} | {each.state} | {_measured(each)} |" for each in found]
    meaning = [f"- **{state}**: {words}." for state, words in STATES.items() if state in used]
    return ["| of the paper | about | state | results |", "|---|---|---|---|", *rows, "", *meaning, ""]


def _differing(found: Sequence[Found]) -> list[str]:
    """The claims that our numbers contradict; their sections say why."""
    claims = [
        f"- {each.entry.place}: {claim.says}"
        for each in found
        for claim, finding in zip(each.entry.claims, each.findings, strict=True)
        if finding is not None and finding.state == DIFFERS
    ]
    return ["Claims of the paper that our numbers contradict:", "", *claims, ""] if claims else []


def _measured(found: Found) -> str:
    return "none" if not found.results.finished else "all" if found.results.complete else found.results.progress


def _section(found: Found) -> list[str]:
    entry = found.entry
    lines = [f"## {entry.place}: {entry.title}", ""]
    for claim, finding, index in zip(entry.claims, found.findings, range(len(entry.claims)), strict=True):
        state = "" if finding is None else f" **{finding.state.capitalize()}.**"
        lines += [f"- {claim.says}" if found.state == MISSING else f"- {claim.says}{state} {found.sentence(index)}"]
    lines += ["", found.sentence(0)] if found.state == MISSING else []
    lines += ["", f"`{entry.makes}`", ""]
    if found.lines:
        lines += ["| | the paper | ours |", "|---|---|---|"]
        lines += [f"| {line.what} | {line.paper} | {line.ours or 'not measured'} |" for line in found.lines]
        lines += [""]
    return lines
