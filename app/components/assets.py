"""What Streamlit serves to the browser as files of their own, so that no message carries it: ``app/static``.

The browser's half of the app is one tree of modules, ``app/js``. It is served as it is, from a folder that is named by
its content: a browser never shows an old one, and all components of a page share its modules. On a read-only file
system everything is put there beforehand: ``python -m app.components.assets``.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from pathlib import Path

import plotly
import streamlit as st

from laplace_core.files.atomic import atomic_write
from laplace_core.files.folders import name_by_content, publish

_HERE = Path(__file__).resolve().parents[1]
_STATIC, _TREE = _HERE / "static", _HERE / "js"
_STUB = """
let loading;

export default function (component) {
  loading ??= import(new URL('__ADDRESS__', document.baseURI).href);
  loading.then((module) => module.default(component)).catch((error) => {
    component.parentElement.textContent = `The page is not complete: ${error.message}. Reload it.`;
  });
}
"""


@cache
def plotly_js() -> str:
    """The address of the plotly.js of the installed plotly package."""
    content = (Path(plotly.__file__).parent / "package_data" / "plotly.min.js").read_bytes()
    path = _STATIC / "plotly.min.js"
    if not path.exists() or path.read_bytes() != content:
        _STATIC.mkdir(exist_ok=True)
        with atomic_write(path) as file:
            file.write(content)
    return f"app/static/{path.name}?{name_by_content(content)}"


def module(name: str) -> str:
    """The address of a module of ``app/js``, as ``lens/entry.js``."""
    return f"app/static/js/{_tree().name}/{name}"


@cache
def component(name: str, entry: str = "") -> Callable:
    """The component of the folder ``name``, with the style that lies there; its script is ``app/js/NAME/NAME.js``,
    or another ``entry`` of that folder.

    Streamlit sends the script with every answer, so it does nothing but load the module. Every message is handed on to
    the default export of the module, in order. Nothing is isolated: plotly.js puts its style into the document.
    """
    style = _HERE / "components" / name / "style.css"
    script = _STUB.replace("__ADDRESS__", module(f"{name}/{entry or name}.js"))
    css = style.read_text(encoding="utf-8") if style.exists() else None
    return st.components.v2.component(f"laplace_{name}", js=script, css=css, isolate_styles=False)


@cache
def offline_page() -> str:
    """The lens as a page that needs no network; what it shows goes into the element ``held``, as JSON."""
    page = (_HERE / "offline" / "page.html").read_text(encoding="utf-8")
    script = (_HERE / "offline" / "standalone.js").read_text(encoding="utf-8")
    style = (_HERE / "components" / "lens" / "style.css").read_text(encoding="utf-8")
    return page.replace("/* STYLE */", style).replace("/* SCRIPT */", script)


@cache
def _tree() -> Path:
    """The served folder of all modules."""
    content = {path.relative_to(_TREE).as_posix(): path.read_bytes() for path in sorted(_TREE.rglob("*.js"))}
    content |= {"lens/offline.html": offline_page().encode(), "print/pdf.js": (_HERE / "offline/pdf.js").read_bytes()}
    return publish(_STATIC / "js", content)


if __name__ == "__main__":
    print(plotly_js(), module("lens/entry.js"))
