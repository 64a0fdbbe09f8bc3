"""The reference: every public name with its docstring, and examples with their output and pictures."""

import ast
import io
import re
from collections.abc import Iterator
from contextlib import contextmanager, redirect_stdout
from functools import cache
from html import escape
from importlib import import_module
from pathlib import Path

import satviz

from ..optional_imports import extra_needed
from ..safe_write import MADE_BY
from ..scenes import named
from .examples import EXAMPLES

MODULES = "satviz", "satviz.engine.axes", "satviz.batch", "satviz.testing"
EMPTY_LINK = re.compile(r'<a class="headerlink" href="#([^"]+)"(?=></a>)')
TEMPLATES = Path(__file__).with_name("templates")


def reference(*, in_site: bool = False) -> Iterator[tuple[str, bytes]]:
    """Yield (path, content) of each file of the reference; `in_site`: pages link to the site one folder above.

    Raise ImportError, which says what to install, if pdoc is missing.
    """
    try:
        import pdoc
        from pdoc import render
    except ImportError:
        raise ImportError(extra_needed("the reference", "docs")) from None
    render.configure(docformat="markdown", show_source=False, template_directory=TEMPLATES)
    render.env.globals |= {"example": example, "in_site": in_site}
    for name in satviz.__all__:  # pdoc sees only names that are loaded
        getattr(satviz, name)
    with _scenes_as_function():
        modules = {name: pdoc.doc.Module(import_module(name)) for name in MODULES}
        pages = {name.replace(".", "/"): render.html_module(module, modules) for name, module in modules.items()}
        pages["index"] = render.html_index(modules)
    for stem, page in pages.items():
        about = f"The reference of satviz: {stem.replace('/', '.')}, each public name with an example."
        head = f'<head><meta name="author" content="{MADE_BY}"><meta name="description" content="{about}">'
        named_links = EMPTY_LINK.sub(r'\g<0> aria-label="link to \1"', page)  # a voice reads an empty link as nothing
        yield f"{stem}.html", named_links.replace("<head>", head, 1).encode()
    yield "search.js", f"// {MADE_BY}\n{render.search_index(modules)}".encode()


@contextmanager
def _scenes_as_function() -> Iterator[None]:
    """Within a with block, let `satviz.scenes` be the public function, which pdoc documents, not the package."""
    face = vars(satviz)
    package = face["scenes"]
    face["scenes"] = named.scenes
    try:
        yield
    finally:
        face["scenes"] = package


@cache
def example(name: str) -> str:
    """Return the HTML of a public name's example: code, output and picture; "" for a name without an example."""
    code = EXAMPLES.get(name)
    if code is None:
        return ""
    text, picture = run_example(code)
    figure = f"<figure>{picture}</figure>" if picture else ""
    output = f'<pre class="given" tabindex="0">{escape(text)}</pre>'
    return f'<div class="example"><pre tabindex="0">{escape(code)}</pre>{output}{figure}</div>'


def run_example(code: str) -> tuple[str, str]:
    """Return what the code prints with its last value as text, and the SVG of that value ("" if none)."""
    *first, last = ast.parse(code).body
    assert isinstance(last, ast.Expr)
    names = {"sv": satviz}
    printed = io.StringIO()
    with redirect_stdout(printed):
        exec(compile(ast.Module(first, []), "example", "exec"), names)
        value = eval(compile(ast.Expression(last.value), "example", "eval"), names)
    shown = value._repr_mimebundle_() if hasattr(value, "_repr_mimebundle_") else {"text/plain": repr(value)}
    return printed.getvalue() + shown["text/plain"], shown.get("image/svg+xml", "")
