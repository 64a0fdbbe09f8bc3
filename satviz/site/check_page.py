"""The page "Is yours right?": an editor for the reader's function, and the scene where it is wrong."""

import json
import re
from collections.abc import Iterable
from html import escape
from importlib.resources import files

from ..checking.mistakes import SYMPTOMS
from ..scenes.failing import NAMED
from ..scenes.link import link
from ..scenes.named import scene
from ..widgets.explorer_model import ExplorerModel
from . import parts
from .chapters import programs, used_by
from .pages import POLICY, SiteInfo, html_page

PATH = "yours.html"
# A worker of the reader's code is made by the page itself, so that it obeys the policy of the page.
CHECK_POLICY = POLICY.replace("worker-src 'self'", "worker-src 'self' blob: data:")
SKELETONS = {
    "python": """def collide(a, b):
    # a and b are lists of (x, y).
    # Return True if they share a point.
    for axis in 0, 1:
        on_a = [p[axis] for p in a]
        on_b = [p[axis] for p in b]
        if max(on_a) < min(on_b) or max(on_b) < min(on_a):
            return False
    return True
""",
    "javascript": """function collide(a, b) {
    // a and b are lists of [x, y].
    // Return true if they share a point.
    for (const axis of [0, 1]) {
        const onA = a.map((p) => p[axis]), onB = b.map((p) => p[axis]);
        if (Math.max(...onA) < Math.min(...onB)) return false;
        if (Math.max(...onB) < Math.min(...onA)) return false;
    }
    return true;
}
""",
}
CHOICES = {
    "boxes|convex": "convex shapes",
    "boxes": "upright boxes only",
    "boxes|convex|concave": "also outlines with dents",
    "circles": "two circles",
}
TOUCHING = {"hit": "a hit", "miss": "no hit", "either": "either"}


def check_page(info: SiteInfo) -> bytes:
    """Return the page; without Python in the site it says how to check a function on one's own machine."""

    def options(choices: dict[str, str]) -> str:
        """Return the options of a list of choices as HTML."""
        return "".join(f'<option value="{value}">{words}</option>' for value, words in choices.items())

    given = {name: program for chapter in info.chapters for name, program in programs(chapter).items()}
    codes = {f"{name}-python": code for name, (_, code) in given.items()}
    codes |= {f"{name}-javascript": code for name, code in javascript_programs(given).items()}
    data = json.dumps(SKELETONS | codes).replace("<", "\\u003c")
    opened = "".join(
        f'<option id="{name}" value="{name}">{escape(heading)}</option>' for name, (heading, _) in given.items()
    )
    body = f"""
<h1>Is yours right?</h1>
<p class="lead">Write a collision test. <b>Run</b> finds the smallest scene where it is wrong, and says which known
mistake it behaves like. The test in the editor has such a mistake: it compares bounding boxes.</p>
<noscript><p>This page needs JavaScript. On your own machine, <code>satviz check mine.py</code> does the same.</p>
</noscript>
<section class="check" aria-label="your function">
<div class="written">
<fieldset><legend>Language</legend>
<label><input type="radio" name="language" value="python" checked> Python</label>
<label><input type="radio" name="language" value="javascript"> JavaScript</label></fieldset>
<p class="choices"><label>Program <select name="program"><option value="">your own</option>
<optgroup label="with a mistake, to fix">{opened}</optgroup></select></label></p>
<label class="editor">Your function <textarea rows="13" spellcheck="false" autocapitalize="off" autocomplete="off"
autocorrect="off" wrap="off" aria-describedby="editor-keys"></textarea></label>
<p class="keys" id="editor-keys">Ctrl+Enter runs it. Tab indents; press Escape before Tab to leave the editor.</p>
<p class="choices"><label>Shapes <select name="kinds">{options(CHOICES)}</select></label>
<label>Touching is <select name="touching">{options(TOUCHING)}</select></label>
<button class="run" type="button" disabled>Run</button>
<button class="forget" type="button">Delete my code</button></p>
<p class="keys">The answer may also be a depth, or a move (x, y) that ends the overlap
(None or null if there is no overlap).</p>
<p class="keys">Your code stays in this browser. It is not sent anywhere, and no link contains it.</p>
</div>
<div class="answers">
<p class="check-status" role="status"></p>
<p class="yours" role="status" hidden></p>
<pre class="printed out" aria-label="what your code printed" tabindex="0" hidden></pre>
<div class="found" hidden>{parts.explorer(ExplorerModel(scene("triangles")))}</div>
<div class="report" hidden></div>
</div>
<script type="application/json" class="skeletons">{data}</script>
</section>
{_symptoms()}
"""
    description = "Write a collision test, and see the smallest scene where it is wrong."
    title = "Is yours right? Check your own function"
    return html_page(info, PATH, title, body, description=description, kind="checks", policy=CHECK_POLICY)


def javascript_programs(names: Iterable[str]) -> dict[str, str]:
    """Return the programs of these names in JavaScript, each with all the functions that it uses."""
    source = (files(__package__) / "browser" / "programs.js").read_text(encoding="utf-8")
    known = {code[: code.index("(")]: f"function {code.strip()}\n" for code in source.split("export function ")[1:]}
    words = {name: set(re.findall(r"\w+", code)) for name, code in known.items()}
    return {name: "\n".join(known[each] for each in used_by({name}, words)) for name in names}


def _symptoms() -> str:
    """Return the list of symptoms in the words of users, each with the known mistakes that cause it, as HTML."""
    items = []
    for words, names in SYMPTOMS.items():
        links = "".join(
            f'<li><a href="{escape(link(scene(name)))}">{escape(NAMED[name].claim)}</a></li>' for name in names
        )
        items.append(f"<details><summary>It {escape(words)}</summary><ul>{links}</ul></details>")
    return f"""<section class="symptoms" aria-label="what you see">
<h2>What does it do in your program?</h2>
<p>Choose what you see. The list names the known mistakes that look like this, each with a scene to drag.</p>
{"".join(items)}
</section>"""
