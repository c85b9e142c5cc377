"""Strict JSON: no NaN or infinity, no name twice in an object, no absurd nesting."""

from __future__ import annotations

import json
from collections import Counter
from typing import Any, NoReturn

from laplace_core.errors import InputError


def parse_json(text: bytes | str, what: str) -> Any:
    """The value of a JSON document.

    Args:
        what: the document's name in the sentence of a refusal, such as "the world file".

    Raises:
        InputError: not JSON, a number that is not finite, or an entry that stands twice; one sentence that names
            ``what``.
    """

    def refuse_constant(constant: str) -> NoReturn:
        raise InputError(f"{what} contains {constant}; every number must be finite.")

    def refuse_duplicates(pairs: list[tuple[str, object]]) -> dict[str, object]:
        entries = dict(pairs)
        if len(entries) < len(pairs):
            twice = Counter(name for name, _ in pairs).most_common(1)[0][0]
            raise InputError(f"the entry {twice[:40]!r} stands twice in one object of {what}.")
        return entries

    try:
        return json.loads(text, parse_constant=refuse_constant, object_pairs_hook=refuse_duplicates)
    except json.JSONDecodeError as error:
        raise InputError(f"{what} is not JSON: {error.msg.removesuffix(' at')}, line {error.lineno}.") from None
    except RecursionError:
        raise InputError(f"{what} is not JSON that can be read: it is nested too deeply.") from None
    except UnicodeDecodeError:
        raise InputError(f"{what} is not JSON: it is not UTF-8 text.") from None
    except InputError:
        raise
    except ValueError:  # int() refuses numbers of thousands of digits
        raise InputError(f"{what} is not JSON that can be read: it contains a number with too many digits.") from None
