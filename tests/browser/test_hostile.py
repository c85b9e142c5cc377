"""Names and values from outside, in a browser: shown as typed, and never a link, a picture, a script or a request."""

from __future__ import annotations

import json
from urllib.parse import urlencode

import pytest

from laplace_core.files.packed_text import pack
from tests.browser.support import DRAWN, settled
from tests.support.hostile_inputs import HOST, NAMES

pytestmark = pytest.mark.browser

# What Markdown, Streamlit's additions to it, or the search for addresses in finished text would each turn into
# something else; one of each kind. Names that are more than 40 letters long are cut in a note.
TYPED = (
    *(name for name in NAMES if len(name) <= 40 and name.isprintable()),
    f"a@{HOST}", f"<https://{HOST}>", f"_https://{HOST}_", f"(https://{HOST})", f"_www.{HOST}", f"HTTP://{HOST}",
    "__b__",
    "$$y$$", "a $5 and $6", ":streamlit:", ":+1:", ":red b", "a:small[x]", "a -> b <- c -- d", "e >= f <= g ~= h <-> i",
    "***", "---", "+ x", "> q", "12) x", "| a | b |", "&#58; &copy;", "snake_case_name _x", "[x]: http", "[^1]",
    "a_b_c* d",
    "a<!-- c -->b", "~~~", "```", "5 < 6 & 7 > 3", "two_branch", "#",
)  # fmt: skip
_LIVE = f"""() => [...document.querySelectorAll('a, img, iframe, script, object, embed')]
  .map((each) => each.getAttribute('href') ?? each.getAttribute('xlink:href') ?? each.getAttribute('src') ?? '')
  .filter((address) => /{HOST.replace(".", "[.]")}|^javascript:/.test(address))"""
# The words of every warning as they stand, and what in it is more than words.
_WARNINGS = """() => [...document.querySelectorAll('[data-testid=stAlert]')].map((each) => [
  each.textContent.replaceAll('\\u2060', '').replace(/\\s+/g, ' ').trim(),
  [...each.querySelectorAll('a, img, b, strong, em, code, del, h1, ul, ol, hr, table, .katex, [style*=color]')]
    .map((inner) => inner.tagName + inner.textContent)])"""


@pytest.fixture
def watched(page):
    """The tab, and after the test: nothing was asked of another host, and no script of a name was run."""
    asked, dialogs = [], []

    def note(request):
        if HOST in request.url.partition("?")[0]:
            asked.append(request.url)

    def dismiss(dialog):
        dialogs.append(dialog.message)
        dialog.dismiss()

    page.on("request", note)
    page.on("dialog", dismiss)
    yield page
    assert page.evaluate(_LIVE) == []
    page.remove_listener("request", note)
    page.remove_listener("dialog", dismiss)
    assert asked == []
    assert dialogs == []


def test_a_note_about_a_link_quotes_it_as_it_was_typed(watched, address):
    watched.goto(f"{address}/train?{urlencode(dict.fromkeys(TYPED, '1'))}")
    watched.wait_for_function(f"() => document.querySelectorAll('[data-testid=stAlert]').length >= {len(TYPED)}")
    settled(watched)
    found = dict(watched.evaluate(_WARNINGS))
    for name in TYPED:
        said = " ".join(f"The link has an entry {name!r} that this page does not know.".split())
        assert found.get(said) == [], f"{name!r}: {[text for text in found if text not in said]}"


@pytest.mark.parametrize(
    ("path", "names"),
    [
        ("agents", ("checkpoint", "o.x")),
        ("race", ("checkpoint", "d.against")),
        ("train", ("run", "beside", "algorithm")),
    ],
)
def test_no_value_of_a_link_is_live(watched, address, path, names):
    for value in (f"![x](http://{HOST}/p.png)", f"[Log in again](https://{HOST})"):
        watched.goto(f"{address}/{path}?{urlencode(dict.fromkeys(names, value))}")
        watched.wait_for_selector("[data-testid=stAlert]")
        assert watched.evaluate(_LIVE) == []


def test_names_of_a_world_are_shown_as_typed_everywhere(watched, address):
    states, actions = ["<b>x</b>", f"<a href='//{HOST}'>y</a>"], [f"![x](//{HOST}/p)", "<img src=x onerror=alert(1)>"]
    rows = [
        {"state": states[0], "action": "*", "next": {states[1]: 1.0}, "reward": {"0": 1.0}},
        {"state": states[1], "action": actions[0], "next": {"END": 1.0}, "reward": {"5": 1.0}},
        {"state": states[1], "action": actions[1], "next": {states[1]: 1.0}, "reward": {"1": 1.0}},
    ]
    text = json.dumps({"name": "<i>w</i>", "states": states, "actions": actions, "transitions": rows})
    query = urlencode({"world": "own", "own": pack(text), "state": states[1], "action": actions[0], "edit": "yes"})
    watched.goto(f"{address}/?{query}")
    watched.wait_for_function(DRAWN)
    settled(watched)
    graph = watched.locator(".laplace-lens .world")
    assert states[0] in graph.inner_text()
    assert graph.locator("a").count() == 0
    shown = watched.locator("body").inner_text()
    assert actions[0] in shown  # the verdict, the buttons of actions, the list of artefacts
    assert states[1] in watched.locator("[data-testid=stSidebar]").inner_text() + str(
        watched.locator("[data-testid=stSidebar] input").evaluate_all("(all) => all.map((each) => each.value)")
    )
