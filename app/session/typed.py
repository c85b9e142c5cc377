"""Text from outside, such as a name in a file or an entry of a link, shown on a page exactly as it was typed.

Streamlit reads what it shows, labels and help as well, as Markdown: a name such as ``![](//host/picture)`` would be a
request to another host. Whatever is not the program's own words passes through :func:`in_markdown`, once, where it is
shown. HTML has :func:`html.escape`, figures :func:`laplace_core.figures.theme.in_plotly`. What JavaScript draws needs
none of them: it sets texts, never HTML.
"""

from __future__ import annotations

import re

_JOINER = "\u2060"  # takes no room, and breaks up what is found by its letters alone
_BREAKS = re.compile(r"[\s\x00-\x1f\x7f]+")
_MARKS = re.compile(r"[\\`*\[<~$]|&(?=#?\w+;)|(?<![^\W_])_|_(?![^\W_])|:(?=[a-zA-Z])")
_AT_FIRST = re.compile(r"(?:[-+#>=|]|\d+(?=[.)]))")  # of a line: a list, a heading, a quotation, a rule or a table
_FOUND = (
    # Addresses, icons and emoji are looked for in texts whose escapes are resolved already.
    (re.compile(r"(?i)https?:(?=/)|www(?=\.)|(?<=\S)@(?=\S)|:(?=[\w+-]+:|material/)"), r"\g<0>" + _JOINER),
    (re.compile(r"(?<!\S)([-<>~])(?=[-=>]+(?!\S))"), r"\1" + _JOINER),  # arrows, dashes and signs of comparison
)


def in_markdown(text: object) -> str:
    """A text for Streamlit's Markdown, which shows it as typed, on one line.

    Backslashes stand before what Markdown marks up. What is found by its letters alone, such as an address of the web,
    is broken up by a character that takes no room.
    """
    line = _BREAKS.sub(" ", str(text)).strip()
    for pattern, broken in _FOUND:
        line = pattern.sub(broken, line)
    line = _MARKS.sub(r"\\\g<0>", line)
    first = _AT_FIRST.match(line)
    if first is None:
        return line
    return f"\\{line}" if not line[0].isdigit() else f"{first[0]}\\{line[first.end() :]}"
