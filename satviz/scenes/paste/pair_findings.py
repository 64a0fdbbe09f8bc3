"""What usually lies behind a report about a pair of shapes: what decides, what another reading would give."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import NamedTuple

from ...engine.geometry import InvalidShape, Relation
from ...engine.number_format import number as short
from ...engine.polygon_validation import short_repr
from ...engine.relate import relate
from ...engine.shapes import Polygon, Shape
from ...engine.trace import Trace
from . import others
from .boxes import FORM_WORDS, Read, plain
from .exact import Pt, Where, hull, where
from .findings import Finding, PastedShape, exact_of, make_shape
from .notations import ANY_BOX, Form
from .points import ZERO

APART, TOUCHING, OVERLAPPING = Relation
CUT_SIZE = 4.0  # shapes smaller than this are never meant in whole numbers
NEARLY_TOUCHING = 2.0**-23  # a gap below this share of the largest coordinate is finer than float32


class AnsweredPair(NamedTuple):
    """Two usable shapes with the answer about them: the trace over every axis, and how the shapes lie."""

    a: PastedShape
    b: PastedShape
    trace: Trace
    lies: Where
    gap: float  # the largest gap of the axes: negative for an overlap


def findings_of_pair(pair: AnsweredPair, *, decimals: bool) -> Iterator[Finding]:
    """Yield the findings about a pair; `decimals`: the numbers are decimals of a text, not float64 of a program."""
    a, b, relation = pair.a, pair.b, pair.lies.relation
    p, q = pair.trace.a, pair.trace.b
    both = (a.name, b.name)
    size = max(p.max_coordinate, q.max_coordinate)
    in_decimals = _in_decimals(a, b) if decimals else None
    if in_decimals is not None and in_decimals is not relation:
        yield Finding(
            "decimals",
            both,
            f"As decimals {a.name} and {b.name} are {_words(in_decimals)}, but float64 cannot hold "
            f"{_first_rounded(a, b)}, and with rounded numbers they are {_words(relation)} ({_gap_words(pair.gap)}).",
            "No test in floating point can tell: use numbers that float64 holds, or allow a tolerance.",
        )
    elif pair.gap and abs(pair.gap) < size * NEARLY_TOUCHING:
        yield Finding(
            "near-touch",
            both,
            f"{a.name} and {b.name} look as if they touch, but are {_words(relation)}: {_gap_words(pair.gap)}, "
            f"where the coordinates are up to {short(size)}.",
            "A rounding decides such a pair: an expected answer from arithmetic in floats may be wrong.",
        )
    if relation is TOUCHING:
        yield Finding(
            "touching",
            both,
            f"{a.name} and {b.name} touch: they share border points, but no interior point.",
            "Tests with <= say hit, tests with < say no hit. Decide which one you want.",
        )
    yield from _of_concave(pair)
    single = others.in_float32(p, q)
    if single is not relation:
        said = (
            f"in float32 they are {_words(single)}"
            if isinstance(single, Relation)
            else f"float32 makes a shape invalid ({single})"
        )
        yield Finding(
            "float32",
            both,
            f"{a.name} and {b.name} are {_words(relation)} ({_gap_words(pair.gap)}), but {said}.",
            "The gap is finer than float32: subtract a common origin before you round, or use float64.",
        )
    cut = others.in_whole_numbers(p, q)
    if cut is not relation and isinstance(cut, Relation) and min(_extent(p), _extent(q)) >= CUT_SIZE:
        yield Finding(
            "whole-numbers",
            both,
            f"With the digits after the decimal point cut off, {a.name} and {b.name} are {_words(cut)} "
            f"instead of {_words(relation)}.",
            "Keep floating-point numbers, or scale before you convert.",
        )
    if pair.lies.a_in_b or pair.lies.b_in_a:
        inner, outer = (a, b) if pair.lies.a_in_b else (b, a)
        equal = pair.lies.a_in_b and pair.lies.b_in_a
        border = " and touches its border from inside" if pair.lies.at_border else ""
        text = f"{a.name} and {b.name} are equal" if equal else f"{inner.name} lies inside {outer.name}{border}"
        yield Finding(
            "containment",
            both,
            f"{text}: OGC overlaps says false for that, intersects says true.",
            "A test that only looks for crossing edges misses this: use intersects, or test one corner as well.",
        )
    yield from _of_other_readings(pair)


def _of_concave(pair: AnsweredPair) -> Iterator[Finding]:
    """Yield the finding for concave outlines, with what a convex test would say."""
    concave = [each for each in (pair.a, pair.b) if each.usable and not each.usable.is_convex]
    if not concave:
        return
    hulls = []
    for each in (pair.a, pair.b):
        shape = each.usable
        assert shape is not None
        hulls.append(Polygon([(float(x), float(y)) for x, y in hull(each.read.points)]) if each in concave else shape)
    changed = relate(hulls[0], hulls[1])
    names = " and ".join(each.title for each in concave)
    verb = "are" if len(concave) > 1 else "is"
    wrong = changed is not pair.lies.relation
    text = f"{names} {verb} concave: a test for convex shapes answers for the hull"
    text += (
        f", {_words(changed)} instead of {_words(pair.lies.relation)}." if wrong else ", with the same relation here."
    )
    kind = "concave" if wrong else "note"
    yield Finding(kind, tuple(each.name for each in concave), text, "Cut it into convex parts and test each of them.")


def _of_other_readings(pair: AnsweredPair) -> Iterator[Finding]:
    """Yield the findings about arguments that mean something else: another reading has another relation."""
    a, b, relation = pair.a, pair.b, pair.lies.relation
    for each, other in ((a, b), (b, a)):
        read = each.read
        if read.form in (Form.CORNER_SIZE, Form.CENTER_SIZE) and not read.rounded:
            form = Form.CENTER_SIZE if read.form == Form.CORNER_SIZE else Form.CORNER_SIZE
            together = _relation_of_boxes(a, b, form)
            changed = _relation_with(box_points(read.box, form), other) if together is None else together
            if changed is not None and changed is not relation and (together is None or each is a):
                point = "center" if form == Form.CENTER_SIZE else "corner"
                owner = f"the point of {each.title}" if together is None else f"the points of {a.name} and {b.name}"
                be = f"were its {point}" if together is None else f"were their {point}s"
                yield Finding(
                    "corner-for-center",
                    (each.name,) if together is None else (a.name, b.name),
                    f"If {owner} {be}, they would be {_words(changed)} instead of {_words(relation)}.",
                    f"It was read as {FORM_WORDS[read.form]}: check what the library wants.",
                )
            opposite = _relation_of_corners(a, b) if read.keyed and not read.named else None
            if opposite is not None and opposite is not relation and each is a:
                yield Finding(
                    "corner-for-center",
                    (a.name, b.name),
                    f"If the last two numbers of {a.title} and {b.title} were the opposite corner, "
                    f"they would be {_words(opposite)} instead of {_words(relation)}.",
                    f"It was read as {FORM_WORDS[read.form]}: check what the library wants.",
                )
            swapped = None
            if not read.keyed:
                swapped = _relation_with(box_points((*read.box[:2], read.box[3], read.box[2]), read.form), other)
            if swapped is not None and swapped is not relation:
                yield Finding(
                    "swapped-arguments",
                    (each.name,),
                    f"With width and height of {each.title} exchanged they would be {_words(swapped)}.",
                    "Check the order of the arguments.",
                )
        if read.shift != ZERO and other.read.shift == ZERO and relation is APART:
            changed = _relation_with(tuple((x - read.shift[0], y - read.shift[1]) for x, y in read.points), other)
            if changed:
                x, y = read.shift
                yield Finding(
                    "position-twice",
                    (each.name,),
                    f"The corners of {each.title} were moved by its position ({plain(x)}, {plain(y)}). If they were "
                    f"absolute already, they would be {_words(changed)} instead of {_words(relation)}.",
                    "Give corners relative to the position, or a position of (0, 0).",
                )
    if relation is APART and not any(each.read.is_circle and len(each.read.points) > 1 for each in (a, b)):
        yield from _of_swapped(pair)


def _extent(shape: Shape) -> float:
    """Return the larger side of a shape's bounding box."""
    x0, y0, x1, y1 = shape.bounds
    return max(x1 - x0, y1 - y0)


def clear(pair: AnsweredPair) -> Finding:
    """Return the finding for a pair about which there is nothing else to say."""
    a, b, relation = pair.a.name, pair.b.name, pair.lies.relation
    return Finding(
        "clear",
        (a, b),
        f"{a} and {b} are clearly {relation}: none of the usual causes of a wrong answer is in these numbers.",
        "A test that says otherwise is wrong, or got other numbers: send it the minimal test.",
    )


def _of_swapped(pair: AnsweredPair) -> Iterator[Finding]:
    """Yield the finding for shapes far apart that meet once x and y of one of them are exchanged."""
    p, q = pair.trace.a.bounds, pair.trace.b.bounds
    extent = max(p[2] - p[0], p[3] - p[1], q[2] - q[0], q[3] - q[1])
    if not pair.gap > 2 * extent:
        return
    changed = _relation_with(tuple((y, x) for x, y in pair.b.read.points), pair.a, pair.b.read.radius)
    if changed:
        yield Finding(
            "swapped-arguments",
            (pair.a.name, pair.b.name),
            f"{pair.a.name} and {pair.b.name} are far apart, and {'touch' if changed is TOUCHING else 'overlap'} once "
            f"x and y of {pair.b.name} are exchanged.",
            "Longitude comes before latitude in WKT and GeoJSON, and x before y.",
        )


def box_points(box: Sequence[Fraction], form: str) -> tuple[Pt, ...]:
    """Return the corners of an upright box by its size and, as `form` says, a corner or its center."""
    x, y, w, h = box
    x0, y0 = (x, y) if form == Form.CORNER_SIZE else (x - w / 2, y - h / 2)
    return (x0, y0), (x0 + w, y0), (x0 + w, y0 + h), (x0, y0 + h)


def _relation_with(points: tuple[Pt, ...], other: PastedShape, radius: Fraction | None = None) -> Relation | None:
    """Return the relation of changed points to another shape; None where they make no shape."""
    try:
        changed = make_shape(Read(points, radius, "", 0, 0))
    except InvalidShape:
        return None
    return relate(changed, other.usable) if other.usable else None


def _relation_of_boxes(a: PastedShape, b: PastedShape, form: str) -> Relation | None:
    """Return the relation of two boxes if the numbers of both are read in another form; None for other shapes."""
    if a.read.form not in ANY_BOX or a.read.form != b.read.form or a.read.rounded or b.read.rounded:
        return None
    moved = replace(b, read=b.read, meant=None, shape=None)
    try:
        moved = replace(moved, shape=make_shape(replace(b.read, points=box_points(b.read.box, form))))
    except InvalidShape:
        return None
    return _relation_with(box_points(a.read.box, form), moved)


def _relation_of_corners(a: PastedShape, b: PastedShape) -> Relation | None:
    """Return the relation of two boxes if their last two numbers are the opposite corner; None for other shapes."""
    made = []
    for each in (a, b):
        box = each.read.box
        if each.read.form != Form.CORNER_SIZE or each.read.rounded or not (box[2] > box[0] and box[3] > box[1]):
            return None
        x0, y0, x1, y1 = map(float, box)
        made.append(Polygon([(x0, y0), (x1, y0), (x1, y1), (x0, y1)]))
    return relate(*made)


def _in_decimals(a: PastedShape, b: PastedShape) -> Relation | None:
    """Return the relation of the decimals as written; None where float64 holds them all, or they were turned."""
    if a.read.rounded or b.read.rounded or a.shape is None or b.shape is None or not _first_rounded(a, b):
        return None
    found = where(exact_of(a.read), exact_of(b.read))
    return found.relation if found else None


def _first_rounded(a: PastedShape, b: PastedShape) -> str:
    """Return the first decimal that float64 rounds, or ""."""
    for each in (a, b):
        for value in (*(c for p in each.read.points for c in p), *([each.read.radius] if each.read.radius else [])):
            if Fraction(float(value)) != value:
                return _decimal(value)
    return ""


def _decimal(value: Fraction) -> str:
    """Return an exact decimal in full where it is one, else shortened."""
    places = 0
    scaled = value
    while scaled.denominator != 1 and places < 40:
        scaled *= 10
        places += 1
    if scaled.denominator != 1:
        return short_repr(float(value))
    digits = str(abs(scaled.numerator)).rjust(places + 1, "0")
    whole = f"{digits[:-places]}.{digits[-places:]}" if places else digits
    return f"-{whole}" if value < 0 else whole


def _words(relation: Relation | str) -> str:
    """Return a relation as text, such as "apart"; a text (why there is none) is unchanged."""
    return str(relation)


def _gap_words(gap: float) -> str:
    """Return a gap or a depth in words."""
    return "gap 0" if not gap else f"a gap of {short(gap)}" if gap > 0 else f"an overlap of {short(-gap)}"
