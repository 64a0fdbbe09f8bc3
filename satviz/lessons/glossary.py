"""The glossary: each term in one sentence, with a picture, its symbol, and its names in other libraries.

The names were taken from the documentation of Box2D, dyn4j, SAT.js, shapely and SciPy.
"""

import re
from collections.abc import Callable
from typing import NamedTuple

from ..engine.axes import hull_normals
from ..engine.shapes import Polygon
from ..engine.trace import Trace, record
from ..pictures import Picture, Stage, Step, picture, views
from ..pictures.figures import FIGURES
from ..pictures.layout import NARROW_SIZE_PT
from ..pictures.minkowski import difference
from ..pictures.playback import NARROW_PANEL_SIZES_PT


class Term(NamedTuple):
    """A term: its name, the words in texts that mean it, its explanation, symbol, other names, and its picture.

    `symbol` is "" where the field writes none; `others` names libraries in brackets.
    """

    name: str
    words: str  # a regular expression
    sentence: str
    symbol: str
    others: str
    draw: Callable[[], Picture]

    @property
    def id(self) -> str:
        """Return the term's anchor on the page."""
        return re.sub(r"\W+", "-", self.name.lower()).strip("-")


_TRIANGLES = Polygon([(0, 1), (3, 2), (1, 5)]), Polygon([(5, 5), (8, 3), (4, 1)], labels=["v1", "v2", "v3"])
_OVERLAP = _TRIANGLES[0], Polygon([(3, 5), (6, 3), (2, 1)], labels=["v1", "v2", "v3"])
_BOXES = Polygon([(1, 1), (5, 1), (5, 3), (1, 3)]), Polygon([(5, 1), (7, 1), (7, 3), (5, 3)])
_DART = Polygon([(-3, -3), (4, 0), (1, 1), (0, 4)]), Polygon([(2.2, 2.2), (3.2, 2.2), (3.2, 3.2), (2.2, 3.2)])


def _figure(number: int) -> Callable[[], Picture]:
    """Return a function that draws the article's figure with this number, from 1."""
    return FIGURES[number - 1].picture


def _stage(stage: Stage, test: int = 0) -> Callable[[], Picture]:
    """Return a function that draws one stage of a test of the two triangles."""
    return _narrow(lambda: record(*_TRIANGLES), Step(stage, test), by_itself=True)


def _narrow(
    make: Callable[[], Trace | str], step: int | Step = -1, *, by_itself: bool = False
) -> Callable[[], Picture]:
    """Return a function that draws a step of what `make` returns, as wide as a card of the page."""

    def draw() -> Picture:
        """Draw the step; two panels stand one above the other."""
        what = make()
        largest = NARROW_PANEL_SIZES_PT[0] if isinstance(what, str) else NARROW_SIZE_PT
        return picture(what, step, largest=largest, by_itself=by_itself)

    return draw


TERMS = (
    Term(
        "vertex",
        r"corners?|vertex|vertices",
        "A corner of a polygon, given by its coordinates.",
        "v",
        "corner, point; exterior.coords (shapely)",
        _narrow(lambda: record(*_TRIANGLES), 0, by_itself=True),
    ),
    Term(
        "edge",
        r"edges?",
        "The straight line from one vertex of a polygon to the next.",
        "e = v₂ − v₁",
        "side, segment; Polygon.edges (SAT.js)",
        _stage(Stage.EDGE),
    ),
    Term(
        "normal",
        r"normals?",
        "A vector at right angles to an edge.",
        "n",
        "perpendicular; Polygon.normals (SAT.js), b2Polygon.normals (Box2D)",
        _stage(Stage.NORMAL),
    ),
    Term(
        "axis",
        r"ax[ei]s",
        "A direction onto which both shapes are projected.",
        "n, with length 1",
        "direction",
        _stage(Stage.AXIS),
    ),
    Term(
        "projection",
        r"project(?:ed|ing|ion|s)?",
        "The move of a point onto an axis, at right angles to it; its coordinate there is a dot product.",
        "p · n",
        "shadow, landing; Convex.project (dyn4j), flattenPointsOn (SAT.js)",
        _stage(Stage.DROPS),
    ),
    Term(
        "range",
        r"ranges?",
        "All coordinates that a shape covers on an axis, from the lowest to the highest.",
        "[lo, hi]",
        "interval, extent, shadow; Interval (dyn4j)",
        _stage(Stage.RANGE),
    ),
    Term(
        "gap",
        r"gaps?",
        "How far two ranges are apart: positive apart, zero touching, negative where they overlap.",
        "max(loᴮ − hiᴬ, loᴬ − hiᴮ)",
        "separation (Box2D), with the opposite sign overlap (SAT.js)",
        _stage(Stage.GAP, 1),
    ),
    Term(
        "separating axis",
        r"separating ax[ei]s",
        "An axis on which there is a gap, which proves that the shapes are apart.",
        "n with gap > 0",
        "isSeparatingAxis (SAT.js)",
        _figure(3),
    ),
    Term(
        "separating line",
        r"separating lines?",
        "A line with one shape on each side, at right angles to a separating axis.",
        "{p : p · n = c}",
        "dividing line; in space, separating plane",
        _figure(4),
    ),
    Term(
        "early exit",
        r"early exit",
        "The test stops at the first gap, since one gap is a proof.",
        "",
        "early out",
        _figure(14),
    ),
    Term(
        "AABB",
        r"AABB|upright box(?:es)?",
        "An axis-aligned bounding box: the smallest box around a shape whose edges are parallel to x and y.",
        "[x₀, x₁] × [y₀, y₁]",
        "bounds, envelope (shapely), b2AABB (Box2D), AABB (dyn4j)",
        _figure(1),
    ),
    Term(
        "touching",
        r"touch(?:es|ing)?",
        "The shapes share boundary points but no inner ones; satviz counts this as a hit.",
        "gap = 0",
        "contact; touches (shapely)",
        _narrow(lambda: record(*_BOXES), by_itself=True),
    ),
    Term(
        "false hit",
        r"false hits?",
        "A test says “hit”, but the shapes are apart.",
        "",
        "false positive",
        _narrow(lambda: "no-nearest-vertex"),
    ),
    Term(
        "missed hit",
        "missed hits?",
        "A test says “apart”, but the shapes collide.",
        "",
        "false negative",
        _narrow(lambda: "corner-inside"),
    ),
    Term(
        "penetration depth",
        r"penetration depth|depths?",
        "The length of the shortest move that ends an overlap.",
        "d = |m|",
        "Penetration.getDepth (dyn4j), Response.overlap (SAT.js)",
        _narrow(lambda: record(*_OVERLAP), Step(Stage.GAP, 1), by_itself=True),
    ),
    Term(
        "MTV",
        r"MTV|minimum translation vector|way out",
        "The minimum translation vector: the shortest move of B that ends an overlap.",
        "m",
        "way out; Response.overlapV (SAT.js), Penetration (dyn4j)",
        _narrow(lambda: record(*_OVERLAP), by_itself=True),
    ),
    Term(
        "support point",
        r"support points?|extreme (?:corners?|vert(?:ex|ices))",
        "The point of a shape that is furthest along an axis.",
        "arg max p · n",
        "extreme point; getFarthestPoint (dyn4j), b2DistanceProxy::GetSupport (Box2D 2.4)",
        _figure(18),
    ),
    Term(
        "convex",
        r"convex(?! (?:hull|part))",
        "Without dents: the straight line between any two points of the shape stays inside.",
        "",
        "Convex (dyn4j)",
        lambda: views.single_shape(Polygon([(0, 0), (4, 0), (5, 3), (2, 5), (-1, 3)])),
    ),
    Term(
        "concave",
        r"concave|dents?",
        "With a dent: some corner turns the other way.",
        "",
        "non-convex; such a corner is a reflex corner",
        lambda: views.single_shape(Polygon([(0, 0), (4, 0), (4, 2), (2, 2), (2, 4), (0, 4)])),
    ),
    Term(
        "convex hull",
        r"(?:convex )?hulls?",
        "The smallest convex shape around a shape, with all dents filled.",
        "conv A",
        "convex_hull (shapely), ConvexHull (SciPy), b2ComputeHull (Box2D)",
        _narrow(lambda: record(*_DART, axes=hull_normals)),
    ),
    Term(
        "convex parts",
        r"convex parts?",
        "Convex pieces into which a concave shape is cut; shapes collide if two of their parts do.",
        "A = A₁ ∪ A₂ ∪ …",
        "convex decomposition; Decomposer (dyn4j)",
        _figure(20),
    ),
    Term(
        "Minkowski difference",
        r"Minkowski difference|B − A",
        "All differences of a point of B and a point of A; the shapes collide if it contains the origin.",
        "B − A = {q − p}",
        "configuration space obstacle; the shape that GJK searches",
        lambda: difference(record(*_TRIANGLES)),
    ),
    Term(
        "broad phase",
        r"broad phase",
        "The quick search for pairs whose bounding boxes meet; the narrow phase then tests these pairs.",
        "",
        "BroadphaseDetector (dyn4j), b2BroadPhase (Box2D), STRtree (shapely)",
        _narrow(lambda: "aabb-turned"),
    ),
    Term(
        "tunnelling",
        r"tunnelling",
        "A shape moves through another one between two frames, so no frame shows a collision.",
        "",
        "what continuous collision detection (CCD) and bullet bodies (Box2D) prevent",
        _narrow(lambda: "tunnelling"),
    ),
)


class TermLinker:
    """Links each term to the glossary where a text of several parts uses it first."""

    def __init__(self, page: str) -> None:
        """Link no term yet; `page`: the path of the glossary's page."""
        self.page = page
        # longer names first: "convex hull" is not an example of "convex"
        self.open = sorted(TERMS, key=lambda term: -len(term.name))

    def linked(self, html: str) -> str:
        """Return a paragraph's HTML with the terms linked that no paragraph before it used; no link within a link."""
        pieces, within = re.split(r"(<[^>]+>)", html), 0
        for i, piece in enumerate(pieces):
            if piece.startswith(("<a ", "<code", "</a", "</code")):
                within += -1 if piece.startswith("</") else 1
            elif not piece.startswith("<") and not within:
                pieces[i] = self._link_terms(piece)
        return "".join(pieces)

    def _link_terms(self, text: str) -> str:
        """Link each term of `self.open` where a tag-free text first uses it, and remove it from `self.open`."""
        for term in [*self.open]:
            match = re.search(rf"(?<![\w-])(?:{term.words})(?![\w-])", text, re.IGNORECASE)
            if match:
                self.open.remove(term)
                before, after = text[: match.start()], text[match.end() :]
                link = f'<a class="term" href="{self.page}#{term.id}">{match[0]}</a>'
                return self._link_terms(before) + link + self._link_terms(after)
        return text
