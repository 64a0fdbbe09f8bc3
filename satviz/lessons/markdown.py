"""Markdown as HTML for the site's pages, with coloured code."""

import re
from html import escape
from typing import Any

from ..optional_imports import extra_needed


def markdown_parser(*, anchors: bool = False) -> Any:
    """Return a Markdown parser; with `anchors` a heading gets the id that GitHub gives it.

    Raise ImportError, which says what to install, if markdown-it-py is missing.
    """
    try:
        from markdown_it import MarkdownIt
    except ImportError:
        raise ImportError(extra_needed("making the chapters and guides of a site", "site")) from None
    markdown = MarkdownIt("commonmark", {"html": True, "highlight": highlighted_code}).enable("table")
    markdown.add_render_rule("code_block", _indented_code)
    if anchors:
        markdown.add_render_rule("heading_open", _heading_with_id)
    return markdown


def highlighted_code(code: str, language: str = "python", _attributes: str = "") -> str:
    """Return a block of code as HTML; a block of text is output, and has no colours."""
    from pygments import highlight
    from pygments.formatters import HtmlFormatter
    from pygments.lexers import get_lexer_by_name

    if language == "text":
        return f'<pre class="out" tabindex="0">{escape(code)}</pre>'
    lexer = get_lexer_by_name(language or "python")
    return f'<pre class="code" tabindex="0">{highlight(code, lexer, HtmlFormatter(nowrap=True))}</pre>'


def _indented_code(_renderer: Any, tokens: Any, i: int, _options: Any, _env: Any) -> str:
    """Return an indented block of code as HTML, without colours (a render rule of markdown-it)."""
    return f'<pre tabindex="0"><code>{escape(tokens[i].content)}</code></pre>\n'


def _heading_with_id(_renderer: Any, tokens: Any, i: int, _options: Any, _env: Any) -> str:
    """Return a heading's start tag with the id that GitHub gives it: small letters, hyphens for spaces."""
    words = re.sub(r"[^\w\s-]", "", tokens[i + 1].content.lower()).replace(" ", "-")
    return f'<{tokens[i].tag} id="{words}">'
