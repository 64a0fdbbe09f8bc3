"""Tests of pictures at every scale: nothing overlaps, is clipped or invisible, and the printed numbers agree."""

import math
from itertools import combinations
from random import Random

import pytest
from speeds import one_in
from test_number_format import printed_gap, sign, value
from test_pictures import boxes, meet

import satviz as sv
from satviz.engine import describe
from satviz.pictures.insets import MIN_SHAPE_PT

SEEN = 5.0  # points


def ring(rng, corners, center, size, squeeze=1.0):
    """Return a convex outline of that many corners."""
    turn, (x, y) = rng.random(), center
    angles = sorted(rng.uniform(0, 2 * math.pi) for _ in range(corners))
    points = [(size * math.cos(t), size * squeeze * math.sin(t)) for t in angles]
    c, s = math.cos(turn), math.sin(turn)
    return sv.Polygon([(x + c * p - s * q, y + s * p + c * q) for p, q in points])


def comb(teeth, center, size):
    """Return a concave outline with that many teeth, and so about as many convex parts."""
    x, y = center
    w = size / (2 * teeth)
    points = [(0.0, 0.0), (size, 0.0)]
    for i in reversed(range(teeth)):
        points += [(w * (2 * i + 2), size), (w * (2 * i + 1), size), (w * (2 * i + 1), size / 3), (w * 2 * i, size / 3)]
    return sv.Polygon([(x + p, y + q) for p, q in points[:-1]] + [(x, y + size / 3)])


def scene(rng):
    """Return two shapes of sizes 1e-9 to 1e9, offsets to 2**40 sizes, up to 60 corners or 12 parts, also needles."""
    size = 10.0 ** rng.uniform(-9, 9)
    far = rng.choice((0.0, 1.0, 2.0 ** rng.uniform(0, 40)))
    center = size * far * rng.uniform(-1, 1), size * far * rng.uniform(-1, 1)
    ratio = rng.choice((1.0, 1.0, 10.0 ** rng.uniform(-4, 0)))
    apart = size * rng.choice((0.0, 0.5, 1.5, 2.5, 30.0))
    where = center[0] + apart * math.cos(rng.random()), center[1] + apart * math.sin(rng.random())

    def shape(spot, big):
        kind = rng.random()
        if kind < 0.2:
            return sv.Circle(spot, big)
        if kind < 0.35:
            return comb(rng.randint(2, 12), spot, big)
        return ring(rng, rng.choice((3, 4, 5, 12, 60)), spot, big, rng.choice((1.0, 1.0, 0.02)))

    return named(shape(center, size), rng), named(shape(where, size * ratio), rng)


def named(shape, rng):
    """Return an outline whose vertices may have names, short and long, and letters that DejaVu lacks."""
    if isinstance(shape, sv.Circle) or len(shape.vertices) > 8 or rng.random() < 0.6:
        return shape
    names = "the north-eastern corner", "a", "日本語ラベル", "left"
    return sv.Polygon(shape.vertices, labels=[f"{rng.choice(names)}{i}" for i in range(len(shape.vertices))])


def scenes(seed, count):
    rng, found = Random(seed), 0
    while found < count:
        try:
            a, b = scene(rng)
            trace = sv.record(a, b)
        except (sv.InvalidShape, sv.InvalidScene):  # corners that became one, or too many tests
            continue
        found += 1
        yield trace


def some_steps(trace, rng):
    every = sv.steps(trace)
    return {0, len(every) - 1, len(every) - 2, *(rng.randrange(len(every)) for _ in range(3))}


def hold(trace, rng):
    """Check all that must hold of a scene's pictures."""
    for i in some_steps(trace, rng):
        picture = sv.picture(trace, i)
        placed = list(boxes(picture))
        overlap = [(m.text, n.text) for (m, p), (n, q) in combinations(placed, 2) if meet(p, q)]
        assert not overlap, (i, overlap)
        width, height = picture.size
        for mark, (left, low, right, high) in placed:
            assert left >= 0 and low >= 0 and right <= width and high <= height, (i, mark.text)
        for name in trace.names:
            reach = [seen(mark, picture.scale) for mark in picture.marks if mark.owner.startswith(name)]
            assert max(reach) >= SEEN, (i, name)
    for run in trace.pairs or (trace,):
        for t in run.tests:
            digits = describe.digits(run, t)
            gap = value(digits.signed(t.gap).lstrip("+"))
            assert sign(printed_gap(digits.ranges(t))) == sign(t.gap) == sign(gap), (digits.ranges(t), t.gap)


def seen(mark, scale):
    """Return the size of a mark of a shape in points."""
    if mark.kind == "dot":
        return mark.style.size
    if mark.kind not in ("outline", "disc"):
        return 0.0
    return max(math.dist(p, q) for p in mark.points for q in mark.points) * scale + 2 * mark.radius * scale


@pytest.mark.parametrize("seed", one_in(8, range(8)))
def test_pictures_hold_at_any_scale(seed):
    rng = Random(seed)
    for trace in scenes(seed, 4):
        hold(trace, rng)


@pytest.mark.parametrize(
    "seed", [pytest.param(seed, marks=pytest.mark.slow if seed < 108 else pytest.mark.full) for seed in range(100, 140)]
)
def test_many_more_pictures_hold_at_any_scale(seed):
    rng = Random(seed)
    for trace in scenes(seed, 25):
        hold(trace, rng)


def test_a_shape_too_small_to_see_is_a_dot_with_an_inset():
    tiny = sv.Polygon([(1, 0), (1.0001, 0), (1, 0.0001)])
    picture = sv.picture(sv.record(sv.Polygon([(-1, -1), (0.9, 0), (-1, 1)]), tiny))
    assert picture.mark("B.speck").kind == "dot" and "B, ×5,000" in picture.texts
    shown = [p for m in picture.marks if m.part == "inset-edge" and m.owner == "B" for p in m.points]
    assert MIN_SHAPE_PT < max(math.dist(p, q) for p in shown for q in shown) * picture.scale < 100


def test_a_gap_finer_than_the_pen_is_shown_larger():
    box = [(0, 0), (1, 0), (1, 1), (0, 1)]
    trace = sv.record(sv.Polygon(box), sv.Polygon([(x + 1 + 1e-12, y / 2) for x, y in box]))
    picture = sv.picture(trace)
    p, *_, q = picture.mark("inset-gap.1").points
    assert 20 < math.dist(p, q) * picture.scale < 96 and any(text.startswith("gap, ") for text in picture.texts)


@pytest.mark.parametrize("teeth", one_in(3, [3, 2, 5]))
def test_no_box_beside_the_picture_is_empty(teeth):
    line = [(float(i), 0.6 * (i % 2)) for i in range(teeth + 1)]
    zigzag = sv.Polygon(line + [(x, y + 0.002) for x, y in reversed(line)])
    trace = sv.record(zigzag, sv.Polygon([(1, 3), (1.5, 2), (3, 4)]), every_axis=True)
    for i in range(len(sv.steps(trace))):
        marks = sv.picture(trace, i).marks
        filled = {m.number for m in marks if m.part in ("inset-edge", "inset-range")}
        assert {m.number for m in marks if m.part == "inset"} == filled
        colour = {m.number: m.role for m in marks if m.part == "inset-gap"}
        assert all(m.text.startswith(colour[m.number]) for m in marks if m.part == "inset-name" and m.number in colour)
