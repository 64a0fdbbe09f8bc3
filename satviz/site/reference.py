"""The reference: every public name with its docstring, and examples that were run for it, with their pictures."""

import ast
import io
from collections.abc import Iterator
from contextlib import redirect_stdout
from functools import cache
from html import escape
from importlib import import_module
from pathlib import Path

import satviz

from ..optional_imports import extra_needed
from ..safe_write import MADE_BY
from .examples import EXAMPLES

MODULES = "satviz", "satviz.engine.axes", "satviz.batch"
TEMPLATES = Path(__file__).with_name("templates")


def reference() -> Iterator[tuple[str, bytes]]:
    """(path, content) of each file; ImportError says what to install where pdoc is missing."""
    try:
        import pdoc
        from pdoc import render
    except ImportError:
        raise ImportError(extra_needed("the reference", "docs")) from None
    render.configure(docformat="markdown", show_source=False, template_directory=TEMPLATES)
    render.env.globals["example"] = example
    for name in satviz.__all__:  # what is loaded at first use is in no module before
        getattr(satviz, name)
    modules = {name: pdoc.doc.Module(import_module(name)) for name in MODULES}
    pages = {name.replace(".", "/"): render.html_module(module, modules) for name, module in modules.items()}
    pages["index"] = render.html_index(modules)
    for stem, page in pages.items():
        yield f"{stem}.html", page.replace("<head>", f'<head><meta name="author" content="{MADE_BY}">', 1).encode()
    yield "search.js", f"// {MADE_BY}\n{render.search_index(modules)}".encode()


@cache
def example(name: str) -> str:
    """HTML for below a name's docstring: code, and what it gave; nothing for most names."""
    code = EXAMPLES.get(name)
    if code is None:
        return ""
    text, picture = run(code)
    drawn = f"<figure>{picture}</figure>" if picture else ""
    given = f'<pre class="given" tabindex="0">{escape(text)}</pre>'
    return f'<div class="example"><pre tabindex="0">{escape(code)}</pre>{given}{drawn}</div>'


def run(code: str) -> tuple[str, str]:
    """What code prints and gives, and the picture of what it gives if it has one."""
    *first, last = ast.parse(code).body
    assert isinstance(last, ast.Expr)
    names = {"sv": satviz}
    said = io.StringIO()
    with redirect_stdout(said):
        exec(compile(ast.Module(first, []), "example", "exec"), names)
        value = eval(compile(ast.Expression(last.value), "example", "eval"), names)
    shown = value._repr_mimebundle_() if hasattr(value, "_repr_mimebundle_") else {"text/plain": repr(value)}
    return said.getvalue() + shown["text/plain"], shown.get("image/svg+xml", "")
