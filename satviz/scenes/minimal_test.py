"""A pair of shapes as a minimal test in a programming language, and every built-in scene with its expected answer.

A test holds the coordinates as literals and the exact relation as the expected value.  It assumes no library: whoever
gets it puts one call into `collides`.  Nothing in it comes from a user's text but numbers.
"""

import json
import re
from decimal import Decimal, localcontext
from importlib.resources import files
from typing import Any, NamedTuple

from ..engine.geometry import InvalidScene
from ..engine.relate import relate
from ..engine.shapes import Circle, Shape
from .article import SCENES
from .failing import FAILURE_CASES, REFUSED, FailureCase
from .named import scene_of_case
from .scenefile import Scene, shape_data

HOW = "The exact relation of two closed shapes, computed by satviz. A circle is one point and a radius."
PUT = "Put a call of the library under test into `collides`."


class Language(NamedTuple):
    """A language: how a line of comment begins, and the brackets around a point."""

    comment: str
    brackets: str


# Each has a template in the folder minimal_tests.
LANGUAGES = {
    "javascript": Language("//", "[]"),
    "python": Language("#", "()"),
    "cpp": Language("//", "{}"),
    "csharp": Language("//", "{}"),
    "rust": Language("//", "[]"),
    "java": Language("//", "{}"),
}
FIELD = re.compile(r"(?<!\$)\{(comment|relation|a|ar|b|br)\}")

# The smallest programs around a collision function, for `satviz check --command`.  Each reads pairs of polygons or
# circles, a line of JSON each, calls `collide`, and writes an answer.  Its code is in the folder harnesses; `build` is
# the command that compiles it, "" where none does, and `run` the command that `satviz check --command` is given.
HARNESSES = (
    {"language": "JavaScript", "file": "mine.js", "build": "", "run": "node mine.js"},
    {"language": "C++", "file": "mine.cpp", "build": "g++ -std=c++17 -O2 -o mine mine.cpp", "run": "./mine"},
    {"language": "Rust", "file": "mine.rs", "build": "rustc -O -o mine mine.rs", "run": "./mine"},
)


def _code(path: str) -> str:
    """Return the text of the file `path`.txt of this package: a template, or the code of a harness."""
    return (files(__package__) / f"{path}.txt").read_text(encoding="utf-8")


def minimal_test(a: Shape, b: Shape, language: str) -> str:
    """Return a pair as the source of a test in a language of LANGUAGES; InvalidScene for another one."""
    found = LANGUAGES.get(language)
    if found is None:
        raise InvalidScene(f"there is no minimal test in {language[:40]!r}: choose one of {', '.join(LANGUAGES)}")
    comment = "\n".join(f"{found.comment} {line}" for line in (HOW, PUT))
    values = {"comment": comment, "relation": str(relate(a, b)), "ar": repr(a.radius), "br": repr(b.radius)}
    values |= {"a": _points(a, found), "b": _points(b, found)}
    return FIELD.sub(lambda field: values[field[1]], _code(f"minimal_tests/{language}"))


def _points(shape: Shape, language: Language) -> str:
    """Return the points of a shape as literals: the vertices as given, or a circle's center."""
    opening, closing = language.brackets[0], language.brackets[1]
    return ", ".join(f"{opening}{x!r}, {y!r}{closing}" for x, y in (shape.vertices or shape.core))


def wkt(shape: Shape) -> str:
    """Return a polygon as a WKT POLYGON, its ring closed, or a circle as a CURVEPOLYGON of a CIRCULARSTRING."""
    if isinstance(shape, Circle):
        x, y, r = (Decimal(repr(value)) for value in (*shape.center, shape.radius))
        with localcontext(prec=800):  # the sums are exact, so that the same center and radius are read again
            left, right = f"{x - r} {y}", f"{x + r} {y}"
        return f"CURVEPOLYGON (CIRCULARSTRING ({left}, {right}, {left}))"
    ring = list(shape.vertices)
    ring += ring[:1] if ring[-1] != ring[0] else []
    return f"POLYGON (({', '.join(f'{x!r} {y!r}' for x, y in ring)}))"


def _expected(scene: Scene, case: FailureCase | None) -> dict[str, Any]:
    """Return as JSON values a scene with its exact answer, and for a failing case what its shortcut claims."""
    trace = scene.record()
    truth = trace.truth
    data: dict[str, Any] = {
        "name": scene.name,
        "title": scene.title,
        "a": shape_data(scene.a),
        "b": shape_data(scene.b),
    }
    data |= {"relation": str(truth.relation), "hit": truth.hit, "mtv": list(truth.mtv) if truth.mtv else None}
    if case:
        claimed, actual = case.answers
        data["failing"] = {"how": case.how, "claim": case.claim, "claimed": claimed, "actual": actual}
    return data


def _expected_refusal(case: FailureCase) -> dict[str, Any]:
    """Return as JSON values the raw outlines of a failing case that the engine refuses, with the reason."""
    data: dict[str, Any] = {"name": case.name, "title": case.claim}
    for key, outline in ("a", case.a), ("b", case.b):
        raw = [] if isinstance(outline, Shape) else [[float(x), float(y)] for x, y in outline]
        data[key] = shape_data(outline) if isinstance(outline, Shape) else {"polygon": raw}
    return data | {"relation": None, "hit": None, "mtv": None, "refused": case.actual}


def scenes_json() -> str:
    """Return every built-in scene, the failing ones included, with its exact expected answer, as JSON.

    The JSON also has "harnesses": the programs around a collision function for `satviz check --command`.
    """
    scenes = [_expected(scene, None) for scene in SCENES]
    scenes += [
        _expected_refusal(case) if case.how == REFUSED else _expected(scene_of_case(case), case)
        for case in FAILURE_CASES
    ]
    harnesses = [{**harness, "code": _code(f"harnesses/{harness['file']}")} for harness in HARNESSES]
    return json.dumps({"satviz": "scenes 1", "scenes": scenes, "harnesses": harnesses}, ensure_ascii=False, indent=1)
