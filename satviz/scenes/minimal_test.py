"""A pair of shapes as a minimal test in a programming language, and every built-in scene with its expected answer.

A test holds the coordinates as literals and the exact relation as the expected value.  It assumes no library: whoever
gets it puts one call into `collides`.  Nothing in it comes from a user's text but numbers.
"""

import json
from decimal import Decimal, localcontext
from typing import Any, NamedTuple

from ..engine.geometry import InvalidScene
from ..engine.relate import relate
from ..engine.shapes import Circle, Polygon, Shape
from .article import SCENES
from .failing import FAILURE_CASES, REFUSED, FailureCase
from .harnesses import HARNESSES
from .named import scene_of_case
from .scenefile import Scene, shape_data

HOW = "The exact relation of two closed shapes, computed by satviz. A circle is one point and a radius."
PUT = "Put a call of the library under test into `collides`."


class Language(NamedTuple):
    """A language: its name, the ending of its files, how a list of points is opened, split and closed, the template."""

    name: str
    ending: str
    comment: str
    brackets: str  # around a point
    template: str


JAVASCRIPT = """{comment}
const a = {{ points: [{a}], radius: {ar} }};
const b = {{ points: [{b}], radius: {br} }};
const relation = "{relation}"; // apart, touching or overlapping
const touchingIsAHit = true; // false for a library whose shapes are open sets

function collides(a, b) {{
  throw new Error("call the library under test here");
}}

const expected = relation === "overlapping" || (relation === "touching" && touchingIsAHit);
if (collides(a, b) !== expected) throw new Error(`expected ${{expected}}: the shapes are ${{relation}}`);
console.log("passed");
"""

PYTHON = """{comment}
A, A_RADIUS = [{a}], {ar}
B, B_RADIUS = [{b}], {br}
RELATION = "{relation}"  # apart, touching or overlapping
TOUCHING_IS_A_HIT = True  # False for a library whose shapes are open sets


def collides(a, a_radius, b, b_radius):
    raise NotImplementedError("call the library under test here")


def test_pair():
    expected = RELATION == "overlapping" or (RELATION == "touching" and TOUCHING_IS_A_HIT)
    assert collides(A, A_RADIUS, B, B_RADIUS) == expected, f"expected {{expected}}: the shapes are {{RELATION}}"


if __name__ == "__main__":
    test_pair()
    print("passed")
"""

CPP = """{comment}
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

struct Point {{ double x, y; }};
struct Shape {{ std::vector<Point> points; double radius; }};

const Shape a = {{ {{ {a} }}, {ar} }};
const Shape b = {{ {{ {b} }}, {br} }};
const std::string relation = "{relation}"; // apart, touching or overlapping
const bool touching_is_a_hit = true; // false for a library whose shapes are open sets

bool collides(const Shape& a, const Shape& b) {{
  throw std::logic_error("call the library under test here");
}}

int main() {{
  const bool expected = relation == "overlapping" || (relation == "touching" && touching_is_a_hit);
  if (collides(a, b) != expected) {{
    std::printf("expected %s: the shapes are %s\\n", expected ? "true" : "false", relation.c_str());
    return 1;
  }}
  std::puts("passed");
}}
"""

CSHARP = """{comment}
using System;

static class MinimalTest
{{
    static readonly double[,] A = {{ {a} }};
    const double ARadius = {ar};
    static readonly double[,] B = {{ {b} }};
    const double BRadius = {br};
    const string Relation = "{relation}"; // apart, touching or overlapping
    static readonly bool TouchingIsAHit = true; // false for a library whose shapes are open sets

    static bool Collides(double[,] a, double aRadius, double[,] b, double bRadius)
    {{
        throw new NotImplementedException("call the library under test here");
    }}

    static void Main()
    {{
        bool expected = Relation == "overlapping" || (Relation == "touching" && TouchingIsAHit);
        if (Collides(A, ARadius, B, BRadius) != expected)
        {{
            throw new Exception($"expected {{expected}}: the shapes are {{Relation}}");
        }}
        Console.WriteLine("passed");
    }}
}}
"""

RUST = """{comment}
struct Shape {{
    points: &'static [[f64; 2]],
    radius: f64,
}}

const A: Shape = Shape {{ points: &[{a}], radius: {ar} }};
const B: Shape = Shape {{ points: &[{b}], radius: {br} }};
const RELATION: &str = "{relation}"; // apart, touching or overlapping
const TOUCHING_IS_A_HIT: bool = true; // false for a library whose shapes are open sets

fn collides(a: &Shape, b: &Shape) -> bool {{
    let _ = (a.points, a.radius, b.points, b.radius);
    todo!("call the library under test here")
}}

fn main() {{
    let expected = RELATION == "overlapping" || (RELATION == "touching" && TOUCHING_IS_A_HIT);
    assert_eq!(collides(&A, &B), expected, "the shapes are {{}}", RELATION);
    println!("passed");
}}
"""

JAVA = """{comment}
public class MinimalTest {{
    static final double[][] A = {{ {a} }};
    static final double A_RADIUS = {ar};
    static final double[][] B = {{ {b} }};
    static final double B_RADIUS = {br};
    static final String RELATION = "{relation}"; // apart, touching or overlapping
    static final boolean TOUCHING_IS_A_HIT = true; // false for a library whose shapes are open sets

    static boolean collides(double[][] a, double aRadius, double[][] b, double bRadius) {{
        throw new UnsupportedOperationException("call the library under test here");
    }}

    public static void main(String[] args) {{
        boolean expected = RELATION.equals("overlapping") || (RELATION.equals("touching") && TOUCHING_IS_A_HIT);
        if (collides(A, A_RADIUS, B, B_RADIUS) != expected) {{
            throw new AssertionError("expected " + expected + ": the shapes are " + RELATION);
        }}
        System.out.println("passed");
    }}
}}
"""

LANGUAGES = {
    language.name: language
    for language in (
        Language("javascript", "js", "//", "[]", JAVASCRIPT),
        Language("python", "py", "#", "()", PYTHON),
        Language("cpp", "cpp", "//", "{}", CPP),
        Language("csharp", "cs", "//", "{}", CSHARP),
        Language("rust", "rs", "//", "[]", RUST),
        Language("java", "java", "//", "{}", JAVA),
    )
}


def minimal_test(a: Shape, b: Shape, language: str) -> str:
    """Return a pair as the source of a test in a language of LANGUAGES; InvalidScene for another one."""
    found = LANGUAGES.get(language)
    if found is None:
        raise InvalidScene(f"no minimal test in {language[:40]!r}: choose one of {', '.join(LANGUAGES)}")
    comment = "\n".join(f"{found.comment} {line}" for line in (HOW, PUT))
    numbers = {"a": _points(a, found), "b": _points(b, found), "ar": repr(a.radius), "br": repr(b.radius)}
    return found.template.format(comment=comment, relation=relate(a, b), **numbers)


def _points(shape: Shape, language: Language) -> str:
    """Return the points of a shape as literals: the vertices as given, or a circle's center."""
    opening, closing = language.brackets[0], language.brackets[1]
    return ", ".join(f"{opening}{x!r}, {y!r}{closing}" for x, y in (shape.vertices or shape.core))


def wkt(shape: Shape) -> str:
    """Return a shape as WKT, closed as WKT wants it; a circle as the curve that SQL/MM has for it."""
    if isinstance(shape, Circle):
        x, y, r = (Decimal(repr(value)) for value in (*shape.center, shape.radius))
        with localcontext(prec=800):  # the sums are exact, so that the same center and radius are read again
            left, right = f"{x - r} {y}", f"{x + r} {y}"
        return f"CURVEPOLYGON (CIRCULARSTRING ({left}, {right}, {left}))"
    ring = list(shape.vertices)
    ring += ring[:1] if ring[-1] != ring[0] else []
    return f"POLYGON (({', '.join(f'{x!r} {y!r}' for x, y in ring)}))"


def _expected(scene: Scene, case: FailureCase | None) -> dict[str, Any]:
    """Return a scene with its exact answer, and what the shortcut of a failing case claims."""
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
    """Return a failing case whose outlines are refused, with the reason."""
    data: dict[str, Any] = {"name": case.name, "title": case.claim}
    for key, outline in ("a", case.a), ("b", case.b):
        data[key] = shape_data(outline) if isinstance(outline, (Polygon, Circle)) else {"polygon": _raw(outline)}
    return data | {"relation": None, "hit": None, "mtv": None, "refused": case.actual}


def _raw(outline: Any) -> list[list[float]]:
    """Return the vertices of an outline that nobody has checked."""
    return [[float(x), float(y)] for x, y in outline]


def scenes_json() -> str:
    """Return every built-in scene, the failing ones included, with its exact expected answer, as JSON.

    The harnesses are those for `satviz check --command`.
    """
    scenes = [_expected(scene, None) for scene in SCENES]
    scenes += [
        _expected_refusal(case) if case.how == REFUSED else _expected(scene_of_case(case), case)
        for case in FAILURE_CASES
    ]
    harnesses = [harness._asdict() for harness in HARNESSES]
    return json.dumps({"satviz": "scenes 1", "scenes": scenes, "harnesses": harnesses}, ensure_ascii=False, indent=1)
