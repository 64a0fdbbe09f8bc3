"""Tests of convex parts: they fill a concave polygon exactly, and `relate` is right for concave shapes."""

import functools
import math
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from fractions import Fraction
from itertools import combinations
from random import Random

import oracle
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from oracle import cross, edges, holds, integers, meet, on_segment
from speeds import one_in

from satviz.engine import convex_parts, polygon_validation, sweep, triangulation
from satviz.engine.convex_parts import parts
from satviz.engine.geometry import InvalidShape, Relation
from satviz.engine.relate import relate
from satviz.engine.shapes import Circle, Polygon
from satviz.study import truth

APART, TOUCHING, OVERLAPPING = Relation

Ring = Sequence[tuple[float, float]]

L = [(0, 0), (4, 0), (4, 2), (2, 2), (2, 4), (0, 4)]
NOTCH = Polygon([(2.5, 2.5), (3.5, 2.5), (3.5, 3.5), (2.5, 3.5)])
ULP = 2.0**-52


# -- random simple polygons ------------------------------------------------------------------------


def untangled(points: Iterable[tuple[float, float]]) -> Ring:
    """Return the points in an order without crossings if 2-opt finds one; it is exact on small grids."""
    ring = list(dict.fromkeys(points))
    n = len(ring)
    for _ in range(200):
        crossed = False
        for i, j in combinations(range(n), 2):
            p, q, r, s = ring[i], ring[i + 1], ring[j], ring[(j + 1) % n]
            if j - i in (1, n - 1) or not meet(p, q, r, s):
                continue
            ring[i + 1 : j + 1] = ring[i + 1 : j + 1][::-1]
            crossed = True
        if not crossed:
            break
    return ring


def spread(rng: Random, n: int, coordinate: Callable[[Random], float]) -> Ring:
    return untangled([(coordinate(rng), coordinate(rng)) for _ in range(n)])


def star_shaped(rng: Random, n: int, size: float, step: float = 0) -> Ring:
    """Return a star-shaped ring around the origin, rounded to a grid so that vertices, edges and lines coincide."""
    angles = sorted(rng.uniform(0, math.tau) for _ in range(n))
    arms = [(rng.uniform(size / 5, size), angle) for angle in angles]
    ring = [(r * math.cos(angle), r * math.sin(angle)) for r, angle in arms]
    return [(round(x / step) * step, round(y / step) * step) for x, y in ring] if step else ring


def polyomino(rng: Random, n: int) -> Ring:
    """Return the outline of n connected squares: it has only right angles, and many edges on one line."""
    cells = {(0, 0)}
    while len(cells) < n:
        x, y = rng.choice(sorted(cells))
        dx, dy = rng.choice([(1, 0), (-1, 0), (0, 1), (0, -1)])
        cells.add((x + dx, y + dy))
    after: dict = {}
    for x, y in cells:
        square = [(x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)]
        for i, beside in enumerate([(x, y - 1), (x + 1, y), (x, y + 1), (x - 1, y)]):
            if beside not in cells:
                after[square[i]] = square[(i + 1) % 4]
    ring = [min(after)]
    while (corner := after[ring[-1]]) not in ring:  # squares corner to corner end it too early
        ring.append(corner)
    return ring if corner == ring[0] else []


def scaled(ring: Ring, power: int) -> Ring:
    return [(math.ldexp(x, power), math.ldexp(y, power)) for x, y in ring]


KINDS: dict[str, Callable[[Random, int], Ring]] = {
    "small grid": lambda rng, n: spread(rng, n, lambda rng: rng.randint(0, 5)),
    "quarters": lambda rng, n: spread(rng, n, lambda rng: rng.randint(0, 40) / 4),
    "floats": lambda rng, n: spread(rng, n, lambda rng: rng.uniform(-5, 5)),
    "star of integers": lambda rng, n: star_shaped(rng, n, 8, 1),
    "star of quarters": lambda rng, n: star_shaped(rng, n, 5, 0.25),
    "star of floats": lambda rng, n: star_shaped(rng, n, 5),
    "right angles": polyomino,
    "offset of 1e8": lambda rng, n: [(x + 1e8, y - 1e8) for x, y in spread(rng, n, lambda rng: rng.randint(0, 12) / 2)],
    "1 ulp": lambda rng, n: spread(rng, n, lambda rng: rng.choice([1, 1.25, 1.5]) + rng.randint(0, 3) * ULP),
    "mixed magnitudes": lambda rng, n: spread(
        rng, n, lambda rng: rng.randint(0, 3) * rng.choice([1, 1, 1e-17, 1e-300])
    ),
    "2^-1000": lambda rng, n: scaled(spread(rng, n, lambda rng: rng.randint(0, 9)), -1000),
    "2^1000": lambda rng, n: scaled(spread(rng, n, lambda rng: rng.uniform(0, 9)), 1000),
}
every_kind = pytest.mark.parametrize("kind", KINDS)


def concave_polygons(kind: str, count: int, most: int = 30, seed: int = 1) -> Iterator[Polygon]:
    """Yield concave polygons of one kind with 4 to `most` vertices; invalid ones are drawn again."""
    rng = Random(f"{kind} {seed}")
    while count:
        try:
            polygon = Polygon(KINDS[kind](rng, rng.randint(4, most)))
        except InvalidShape:
            continue
        if not polygon.is_convex:
            count -= 1
            yield polygon


@functools.cache
def sample(kind: str) -> tuple[Polygon, ...]:
    return tuple(concave_polygons(kind, 25))


# -- the oracle ------------------------------------------------------------------------------------


def boxes_meet(a: Polygon, b: Polygon) -> bool:
    (ax0, ay0, ax1, ay1), (bx0, by0, bx1, by1) = a.bounds, b.bounds
    return ax0 < bx1 and bx0 < ax1 and ay0 < by1 and by0 < ay1


def reflex_count(polygon: Polygon) -> int:
    ring = polygon.corners
    return sum(truth.orientation(ring[i - 1], ring[i], ring[(i + 1) % len(ring)]) < 0 for i in range(len(ring)))


def refute(polygon: Polygon) -> str:
    """Return what is wrong with the parts of a concave polygon, with the polygon to paste; empty if nothing is."""
    found = parts(polygon)
    own, *rings = integers(polygon.corners, *(part.vertices for part in found))
    wrong = []
    if not all(part.is_convex and not part.notes and truth.twice_signed_area(part.vertices) > 0 for part in found):
        wrong.append("a part is not convex, not counter-clockwise, or has a collinear vertex")
    if sum(map(truth.twice_signed_area, rings)) != truth.twice_signed_area(own):
        wrong.append("the areas do not add up")
    if any(truth.polygons(p, q) is OVERLAPPING for p, q in combinations(found, 2) if boxes_meet(p, q)):
        wrong.append("two parts overlap")
    if not all(holds(own, v) for ring in rings for v in ring):
        wrong.append("a part has a vertex outside")
    if len(found) > 2 * reflex_count(polygon) + 1:
        wrong.append("more than two cuts for a reflex vertex")
    return f"{'; '.join(wrong)}:\n{polygon!r}" if wrong else ""


def refute_all(polygons: Iterable[Polygon]) -> None:
    """Fail with polygons to paste back if the parts of any are wrong."""
    wrong = [said for said in map(refute, polygons) if said]
    if wrong:
        pytest.fail(f"{len(wrong)} wrong\n" + "\n".join(wrong[:3]), pytrace=False)


def refute_at_any_size(polygon: Polygon) -> str:
    """Return the same as `refute`, in time linear in the corners of the parts, without the oracle.

    Parts fill the polygon once if their edges, as signed lengths on their lines, add up to its own edges:
    then they wind around every point as often as it does.
    """
    found = parts(polygon)
    own, *rings = integers(polygon.corners, *(part.vertices for part in found))
    lengths: Counter = Counter()
    for sign, ring in ((-1, own), *((1, ring) for ring in rings)):
        for p, q in edges(ring):
            dx, dy = q[0] - p[0], q[1] - p[1]
            way = dx // math.gcd(dx, dy), dy // math.gcd(dx, dy)
            dx, dy = max(way, (-way[0], -way[1]))
            line = dx, dy, dx * p[1] - dy * p[0]
            lengths[line, p] += sign
            lengths[line, q] -= sign
    reflex = sum(cross(own[i - 2], own[i - 1], own[i]) < 0 for i in range(len(own)))
    wrong = []
    if any(lengths.values()):
        wrong.append("the parts do not fill it once")
    area, *areas = (sum(p[0] * q[1] - p[1] * q[0] for p, q in edges(ring)) for ring in (own, *rings))
    if sum(areas) != area:
        wrong.append("the areas do not add up")
    if any(cross(ring[i - 2], ring[i - 1], ring[i]) <= 0 for ring in rings for i in range(len(ring))):
        wrong.append("a part has a turn that is not to the left")
    if not all(part.is_convex for part in found):
        wrong.append("a part is not convex")
    if len(found) > 2 * reflex + 1:
        wrong.append("more than two cuts for a reflex vertex")
    return "; ".join(wrong)


# -- exactly the polygon ---------------------------------------------------------------------------


@every_kind
def test_the_parts_are_convex_and_disjoint_and_fill_the_polygon_exactly(kind):
    refute_all(sample(kind))


@pytest.mark.full
@every_kind
def test_the_parts_are_right_on_twenty_thousand_polygons(kind):
    refute_all(concave_polygons(kind, 1_700, seed=2))


grid_points = st.tuples(st.integers(0, 6), st.integers(0, 6))
float_points = st.tuples(st.floats(-9, 9), st.floats(-9, 9))


@given(st.lists(grid_points, min_size=4, max_size=14) | st.lists(float_points, min_size=4, max_size=10))
@settings(max_examples=100, deadline=None, derandomize=True, database=None)
def test_the_parts_are_right_for_any_simple_polygon(points):
    try:
        polygon = Polygon(untangled(points))
    except InvalidShape:
        assume(False)
    assume(not polygon.is_convex)
    refute_all([polygon])


@every_kind
def test_the_parts_are_right_from_any_first_vertex_and_in_either_winding(kind):
    for polygon in sample(kind)[:10]:
        ring = polygon.vertices
        for other in (ring[::-1], ring[3:] + ring[:3]):
            refute_all([Polygon(other)])


@pytest.mark.parametrize("kind", [kind for kind in KINDS if kind not in ("mixed magnitudes", "2^-1000", "2^1000")])
def test_the_parts_scale_with_the_polygon(kind):
    for polygon in sample(kind)[:10]:
        for power in (-900, 900):
            there = [Polygon(scaled(part.vertices, power)) for part in parts(polygon)]
            assert parts(Polygon(scaled(polygon.vertices, power))) == tuple(there), repr(polygon)


def test_a_larger_outline_is_split_with_the_same_integers():
    for factor in (2.0**900, 5):
        larger = Polygon([(x * factor, y * factor) for x, y in L])
        assert convex_parts._Pieces(larger).at == convex_parts._Pieces(Polygon([(x / 2, y / 2) for x, y in L])).at


@pytest.mark.parametrize("unit", [5e-324, 2.0**1020])
def test_the_ends_of_the_float_range_are_cut_exactly_too(unit):
    for ring in (L, [(0, 0), (5, 1), (3, 3), (7, 6), (1, 7), (2, 4)]):
        refute_all([Polygon([(x * unit, y * unit) for x, y in ring])])


@pytest.mark.parametrize(
    "ring",
    [
        [(0, 0), (1, 0), (1, 1), (0.5 + ULP, 1), (0.5, ULP), (0.5, 1), (0, 1)],
        [(0, 0), (1, 0), (1, 1), (0.5, 1 - ULP), (0, 1)],
        [(0, 0), (1, 0), (1, 1), (0.5, 5e-324), (0, 1)],
        [(1e8, 1e8), (1e8 + 3, 1e8), (1e8 + 3, 1e8 + 3), (1e8 + 1.5, 1e8 + 2**-26), (1e8, 1e8 + 3)],
    ],
)
def test_a_notch_one_ulp_wide_or_deep_is_left_out(ring):
    polygon = Polygon(ring)
    assert not polygon.is_convex
    refute_all([polygon])


@pytest.mark.parametrize(
    "ring",
    [
        [(5, 7), (4, 4), (4, 7), (3, 5), (2, 6), (7, 0)],
        [(3, 3), (4, 1), (1, 4), (0, 6), (0, 3), (0, 0), (6, 1), (5, 1)],
        [(6, 0), (4, 0), (5, 8), (-1, 5), (-7, 5), (-4, 2), (4, -7), (4, -4)],
        [(3, 1), (5, 2), (4, 4), (2, 5), (1, 5), (4, 3), (0, 2), (2, 0)],
    ],
)
def test_a_cut_ends_on_the_nearest_of_the_vertices_in_its_way(ring):
    refute_all([Polygon(ring)])


ARM = [(-3, 1), (0, 0), (-3, -1), (-3, -20), (40, -20), (40, 5), (4, 0), (3, 0.25), (2, 0), (30, 9.5), (40, 9)]
ARM += [(40, 20), (-3, 20)]


@pytest.mark.parametrize("ring", [ARM, [(x, -y) for x, y in ARM[::-1]]], ids=["left", "right"])
def test_of_two_vertices_on_one_ray_a_cut_ends_on_the_nearer_from_any_first_vertex(ring):
    """A rotating ray from the reflex vertex reaches both at once; the lines of its edges end between floats."""
    refute_all(Polygon(ring[i:] + ring[:i]) for i in range(len(ring)))


# -- few parts -------------------------------------------------------------------------------------


def test_the_L_of_the_article_becomes_its_two_boxes():
    bottom, top = parts(Polygon(L))
    assert bottom.vertices == ((0, 0), (4, 0), (4, 2), (0, 2))
    assert top.vertices == ((2, 2), (2, 4), (0, 4), (0, 2))


@pytest.mark.parametrize("start", range(6))
@pytest.mark.parametrize("step", [1, -1])
def test_the_L_becomes_the_same_boxes_from_any_first_vertex_and_winding(start, step):
    found = parts(Polygon((L[start:] + L[:start])[::step]))
    assert {part.bounds for part in found} == {(0, 0, 4, 2), (0, 2, 2, 4)}
    assert all(part.is_upright_box for part in found)


def comb(teeth: int) -> Ring:
    ring = [(0, -1), (2 * teeth - 1, -1)]
    for i in reversed(range(teeth)):
        ring += [(2 * i + 1, 0), (2 * i + 1, 3), (2 * i, 3), (2 * i, 0)]
    return [p for p in ring if p not in ((0, 0), (2 * teeth - 1, 0))]


def star(points: int, inner: float = 0.4) -> Ring:
    turns = [(math.tau * i / (2 * points), (1, inner)[i % 2]) for i in range(2 * points)]
    return [(r * math.cos(angle), r * math.sin(angle)) for angle, r in turns]


def spiral(n: int) -> Ring:
    outer = [(10 + 0.9 * i, 0.3 * i) for i in range(n // 2)]
    ring = outer + [(r - 6, angle) for r, angle in reversed(outer)]
    return [(r * math.cos(angle), r * math.sin(angle)) for r, angle in ring]


def saw(n: int) -> Ring:
    return [(0, -5), (n - 3, -5)] + [(x, x % 2 * 100 + x * 7 % 5 / 10) for x in reversed(range(n - 2))]


WELL_KNOWN = pytest.mark.parametrize(
    ("name", "ring", "count"),
    [
        ("L", L, 2),
        ("plus", [(1, 0), (2, 0), (2, 1), (3, 1), (3, 2), (2, 2), (2, 3), (1, 3), (1, 2), (0, 2), (0, 1), (1, 1)], 3),
        ("T", [(1, 0), (2, 0), (2, 2), (3, 2), (3, 3), (0, 3), (0, 2), (1, 2)], 2),
        ("U", [(0, 0), (3, 0), (3, 3), (2, 3), (2, 1), (1, 1), (1, 3), (0, 3)], 3),
        ("Z", [(0, 0), (2, 0), (2, 1), (3, 1), (3, 2), (1, 2), (1, 1), (0, 1)], 2),
        ("dart", [(-3, -3), (4, 0), (1, 1), (0, 4)], 2),
        ("comb", comb(7), 8),
        ("hourglass", [(0, 0), (4, 0), (3, 3), (4, 6), (0, 6), (1, 3)], 2),
    ],
)


@WELL_KNOWN
def test_well_known_outlines_have_the_fewest_parts(name, ring, count):
    assert len(parts(Polygon(ring))) == count


@WELL_KNOWN
@pytest.mark.parametrize("turned", [(1, 1), (-1, 1), (1, -1), (-1, -1)])
def test_well_known_outlines_have_the_fewest_parts_from_any_first_vertex_at_any_rotation(name, ring, count, turned):
    """The partners of a reflex vertex are checked against both its edges, also across the first vertex."""
    for start in range(len(ring)):
        for x, y in (0, 1), (1, 0):
            around = [(p[x] * turned[0], p[y] * turned[1]) for p in ring[start:] + ring[:start]]
            assert len(parts(Polygon(around))) == count, around


@pytest.mark.parametrize(
    "ring",
    [
        [(-5, 4), (-4, 2), (-5, 0), (-3, -1), (-3, -4), (0, -4), (2, -6)],
        [(3, 3), (4, 1), (1, 2), (1, 1), (0, 2), (0, 3), (2, 3), (1, 5)],
        [(2, 1), (6, 4), (1, 7), (0, 5), (-5, 6), (-7, 1), (2, -1), (4, -2)],
        [(5, 0), (4, 1), (7, 3), (3, 2), (2, 7), (-2, 1), (-4, 1), (-4, -1), (3, -6)],
    ],
)
def test_a_cut_between_two_reflex_vertices_is_decided_by_the_edges_next_to_them(ring):
    # those one further on would miss the one cut that ends two, and make a part more
    assert len(parts(Polygon(ring))) == 3 <= fewest_without_new_points(Polygon(ring))


@pytest.mark.parametrize(
    ("ring", "count"),
    [
        # a cut that misses the line of an edge by next to nothing ends one only
        ([(2, 0), (2, 3), (0, 4), (0, 2), (-2, 5), (-3, 4), (-8, 0), (-1, -3), (6, -3)], 4),
        ([(5, 1), (2, 1), (1, 6), (-4, 7), (-4, -5), (3, -3), (4, -3), (3, -2)], 4),
        ([(1, 5), (-1, 6), (-1, 1), (-3, 0), (-7, -2), (2, -1), (6, -1), (2, 0), (6, 0)], 3),
        ([(1, 3), (0, 1), (1, 0), (3, 1), (4, 1), (5, 3), (2, 4), (3, 4), (1, 5)], 3),
        # one along the line of an edge ends both
        ([(0, 5), (2, 4), (3, 4), (3, 2), (4, 0)], 2),
        # the shortest of all comes first, whichever vertex it starts at
        ([(2, 0), (2, 1), (3, 3), (-3, 4), (-2, 1), (-2, -1), (1, -6), (1, -7), (4, -4)], 3),
        # one that leaves by the edge that closes the ring, or past a vertex next to it, is none
        ([(35, 16), (29, 25), (40, 38), (8, 24), (6, 26), (10, 15), (7, 3), (30, 5), (19, 20)], 5),
        ([(4, 3), (5, 5), (3, 4), (1, 5), (1, 3), (0, 0), (2, 4), (2, 0), (5, 0), (3, 1)], 5),
        ([(5, 5), (-2, 2), (-4, 2), (-2, 1), (-5, 2), (-3, 1), (-1, -1), (-1, -5), (0, -4), (0, -6), (7, 0)], 6),
    ],
)
def test_no_cut_is_missed_that_ends_two_reflex_vertices_and_none_taken_that_does_not(ring, count):
    assert len(parts(Polygon(ring))) == count


def test_of_two_cuts_that_end_two_reflex_vertices_the_shorter_is_made():
    # an hourglass with a second, wider waist: each waist is cut across, not from one to the other
    waists = [(0, 0), (6, 0), (4, 4), (6, 8), (5, 12), (6, 16), (0, 16), (1, 12), (0, 8), (2, 4)]
    found = {edge for part in parts(Polygon(waists)) for edge in edges(part.vertices)}
    assert {((4, 4), (2, 4)), ((5, 12), (1, 12))} <= found and len(parts(Polygon(waists))) == 3


@pytest.mark.parametrize("kind", ["right angles", "small grid", "quarters", "star of integers"])
def test_there_are_at_most_as_many_cuts_as_reflex_vertices(kind):
    cuts, reflex = 0, 0
    for polygon in sample(kind):
        cuts += len(parts(polygon)) - 1
        reflex += reflex_count(polygon)
        assert kind != "right angles" or len(parts(polygon)) <= reflex_count(polygon) + 1, repr(polygon)
    assert cuts <= reflex


def test_a_reflex_vertex_takes_two_cuts_only_where_float64_holds_neither_end_of_its_edges_lines():
    # between the lines of its edges the reflex vertex sees the inside of one edge and no vertex
    assert len(parts(Polygon([(0, 0), (10, 0), (9, 9), (5, 1), (3, 10)]))) == 2  # cut to (4.5, 0)
    assert len(parts(Polygon([(0, 0), (10, 0), (7, 10), (5, 1), (3, 10)]))) == 3  # 5 - 2/9 and 5 + 2/9


def fewest_without_new_points(polygon: Polygon) -> int:
    """Return the least number of convex parts without new corners, by trying every chain of diagonals."""
    (at,) = integers(polygon.corners)
    n = len(at)

    def inside(i: int, j: int) -> bool:
        before, after = cross(at[i - 1], at[i], at[j]) > 0, cross(at[i], at[(i + 1) % n], at[j]) > 0
        return (before and after) if cross(at[i - 1], at[i], at[(i + 1) % n]) > 0 else (before or after)

    def clear(i: int, j: int) -> bool:
        """Return whether i j is an edge of the polygon, or a diagonal that meets edges only at its ends."""
        far = [(k, (k + 1) % n) for k in range(n) if not {i, j} & {k, (k + 1) % n}]
        beside = any(on_segment(at[k], at[i], at[j]) for k in range(n) if k not in (i, j))
        alone = not (beside or any(meet(at[i], at[j], at[k], at[m]) for k, m in far))
        return j - i in (1, n - 1) or (alone and inside(i, j) and inside(j, i))

    seen = {(i, j) for i, j in combinations(range(n), 2) if clear(i, j)}

    @functools.cache
    def fewest(i: int, j: int) -> float:
        """Return the fewest parts beyond i j: one part along i j, and those behind its other sides."""
        return 0 if j - i == 1 else 1 + min((chain(i, j, k, j) for k in range(i + 1, j)), default=math.inf)

    @functools.cache
    def chain(i: int, j: int, k: int, m: int) -> float:
        """Return the fewest parts behind the sides of a convex chain i ... k m below i j."""
        if (k, m) not in seen or (m == j and cross(at[k], at[j], at[i]) < 0):
            return math.inf
        if k == i:
            return fewest(i, m) if cross(at[j], at[i], at[m]) >= 0 else math.inf
        chains = (chain(i, j, h, k) for h in range(i, k) if cross(at[h], at[k], at[m]) >= 0)
        return fewest(k, m) + min(chains, default=math.inf)

    return fewest(0, n - 1)


def test_the_fewest_parts_of_known_outlines_without_new_points():
    assert fewest_without_new_points(Polygon(L)) == 2
    assert fewest_without_new_points(Polygon(star(6))) == 7
    assert fewest_without_new_points(Polygon([(0, 0), (10, 0), (7, 10), (5, 1), (3, 10)])) == 3


@pytest.mark.parametrize("kind", ["small grid", "quarters", "floats", "star of integers", "star of floats"])
def test_the_parts_are_hardly_more_than_the_fewest_without_new_points(kind):
    found = [(len(parts(p)), fewest_without_new_points(p)) for p in concave_polygons(kind, 60, most=12, seed=5)]
    assert sum(some for some, _ in found) <= 1.03 * sum(fewest for _, fewest in found)


def test_a_cut_along_an_edges_line_goes_before_a_shorter_slanted_one():
    # the cut from (0, 0) to (1, 1) is shorter than the one to (10, 0), and each ends two reflex vertices
    ring = [(0, 0), (0, -3), (10, -3), (10, 0), (15, 0), (15, 1), (1, 1), (1, 3), (-5, 3), (-5, 0)]
    assert all(part.is_upright_box for part in parts(Polygon(ring)))


def test_of_the_two_edges_lines_at_a_reflex_vertex_the_shorter_is_cut():
    thin, flat = [(0, 0), (4, 0), (4, 2), (1, 2), (1, 9), (0, 9)], [(0, 0), (9, 0), (9, 1), (2, 1), (2, 4), (0, 4)]
    assert {part.bounds for part in parts(Polygon(thin))} == {(0, 0, 4, 2), (0, 2, 1, 9)}
    assert {part.bounds for part in parts(Polygon(flat))} == {(0, 0, 2, 4), (2, 0, 9, 1)}


@every_kind
def test_no_two_parts_with_an_edge_in_common_could_be_one(kind):
    for polygon in sample(kind):
        sides = {edge: part for part in parts(polygon) for edge in edges(part.vertices)}
        for (p, q), part in sides.items():
            if (other := sides.get((q, p))) is None:
                continue
            i, j = part.vertices.index(q), other.vertices.index(p)
            joined = (*part.vertices[i:], *part.vertices[:i])[:-1] + (*other.vertices[j:], *other.vertices[:j])[:-1]
            assert not Polygon(joined).is_convex, repr(polygon)


# -- names and labels of parts ---------------------------------------------------------------------


def test_a_circle_and_a_convex_polygon_are_their_own_only_part():
    for shape in (Circle((1, 2), 3), NOTCH, Polygon([(0, 0), (2, 0), (2, 1), (2, 2), (0, 2)])):
        assert parts(shape) == (shape,)
        assert parts(shape)[0] is shape


def test_the_parts_of_a_concave_shape_are_numbered_and_a_convex_one_keeps_its_name():
    bottom, top = parts(Polygon(L))
    assert convex_parts.named_parts(Polygon(L), "A") == [(bottom, "A1"), (top, "A2")]
    assert convex_parts.named_parts(NOTCH, "B") == [(NOTCH, "B")]


@pytest.mark.parametrize("thing", [None, [(0, 0), (1, 0), (0, 1)], "L", 3])
def test_anything_but_a_shape_is_a_type_error(thing):
    with pytest.raises(TypeError, match=r"make it a satviz\.Polygon or satviz\.Circle"):
        parts(thing)


def test_the_parts_are_computed_once():
    polygon = Polygon(L)
    assert parts(polygon) is parts(polygon)


@every_kind
def test_the_order_of_the_parts_is_by_the_lowest_vertex_number(kind):
    for polygon in sample(kind):
        number = {v: i for i, v in enumerate(polygon.vertices)}
        lowest = [min(number.get(v, math.inf) for v in part.vertices) for part in parts(polygon)]
        assert lowest == sorted(lowest)
        assert all(number.get(part.vertices[0], math.inf) == low for part, low in zip(parts(polygon), lowest))
        assert parts(polygon) == parts(Polygon(polygon.vertices))


def test_parts_carry_the_labels_of_the_vertices_and_none_for_new_points():
    bottom, top = parts(Polygon(L, labels=list("abcdef")))
    assert bottom.labels == ("a", "b", "c", "")
    assert top.labels == ("d", "e", "f", "")
    assert all(part.labels is None for part in parts(Polygon(L)))


def test_a_cut_that_ends_on_a_collinear_vertex_takes_its_label():
    ring = [(0, 0), (4, 0), (4, 2), (2, 2), (2, 4), (0, 4), (0, 2)]
    bottom, top = parts(Polygon(ring, labels=list("abcdefg")))
    assert bottom.labels == ("a", "b", "c", "g")
    assert top.labels == ("d", "e", "f", "g")


def test_of_a_repeated_vertex_the_first_label_counts():
    ring = [*L[:2], L[1], *L[2:], L[0]]
    bottom, top = parts(Polygon(ring, labels=list("abBcdefA")))
    assert bottom.labels == ("a", "b", "c", "")
    assert top.labels == ("d", "e", "f", "")


# -- relate on concave shapes ----------------------------------------------------------------------


def concave_pairs(count: int) -> Iterator[tuple[Polygon, Polygon]]:
    """Yield pairs near each other, on grids where vertices and edges often coincide."""
    kinds = ["small grid", "quarters", "star of integers", "star of quarters", "right angles"]
    pools = [list(concave_polygons(kind, 40, most=10, seed=3)) for kind in kinds]
    rng = Random(4)
    for _ in range(count):
        a, b = (rng.choice(pool) for pool in rng.choices(pools, k=2))
        ax0, ay0, ax1, ay1 = a.bounds
        bx0, by0, bx1, by1 = b.bounds
        # from side by side to on top of each other, more often near a touch
        dx = rng.choice([ax1 - bx0, rng.uniform(ax0 - bx1, ax1 - bx0)])
        dy = rng.uniform(ay0 - by1, ay1 - by0)
        dx, dy = (round(d * 4) / 4 for d in rng.sample([dx, dy], 2))
        yield a, Polygon([(x + dx, y + dy) for x, y in b.vertices])


@pytest.mark.slow
def test_relate_is_right_on_a_thousand_concave_pairs():
    seen: Counter = Counter()
    for a, b in concave_pairs(1000):
        right = oracle.relation(a, b)
        seen[right] += 1
        assert relate(a, b) is right, f"{right}\na = {a!r}\nb = {b!r}"
        assert relate(b, a) is right, f"{right}\na = {b!r}\nb = {a!r}"
    assert min(seen[relation] for relation in Relation) >= 50, seen


def test_the_box_in_the_notch_of_the_L_is_apart():
    assert relate(Polygon(L), NOTCH) is APART
    assert relate(NOTCH, Polygon(L)) is APART


@pytest.mark.parametrize(
    ("x0", "y0", "x1", "y1", "right"),
    [
        (0.5, 0.5, 1, 1, OVERLAPPING),  # inside, far from the seam
        (0.5, 1.5, 1, 2.5, OVERLAPPING),  # inside, across the seam
        (0.5, 2, 1, 2.5, OVERLAPPING),  # inside, an edge on the seam
        (-9, -9, 9, 9, OVERLAPPING),  # the other way round
        (2, 2, 3, 3, TOUCHING),  # in the notch, along both its edges
        (2 + ULP, 2 + 2 * ULP, 3, 3, TOUCHING),  # 2 + ULP rounds to 2
        (2.5, 2 + 2 * ULP, 3, 3, APART),
        (2 - ULP, 2 + 2 * ULP, 3, 3, OVERLAPPING),
        (4, 2, 5, 3, TOUCHING),  # corner to corner
    ],
)
def test_relate_is_right_for_boxes_inside_and_around_the_L(x0, y0, x1, y1, right):
    box = Polygon([(x0, y0), (x1, y0), (x1, y1), (x0, y1)])
    assert relate(Polygon(L), box) is right
    assert relate(box, Polygon(L)) is right
    assert oracle.relation(Polygon(L), box) is right


def test_a_circle_in_the_notch_of_the_L_is_decided_to_the_last_bit():
    assert relate(Polygon(L), Circle((3, 3), 1)) is TOUCHING
    assert relate(Polygon(L), Circle((3, 3), 1 - ULP)) is APART
    assert relate(Polygon(L), Circle((3, 3), 1 + ULP)) is OVERLAPPING
    assert relate(Circle((1, 2), 0.25), Polygon(L)) is OVERLAPPING


# -- big outlines ----------------------------------------------------------------------------------


def polar(arms: Iterable[tuple[float, float]]) -> Ring:
    return [(r * math.cos(angle), r * math.sin(angle)) for r, angle in arms]


def on_grid(ring: Ring, unit: float, offset: float = 0.0) -> Ring:
    return [(round(x) * unit + offset, round(y) * unit - offset) for x, y in ring]


def zigzag(n: int) -> Ring:
    top = [(x, x % 2 * 5.0) for x in range(n // 2)]
    return top + [(x, y + 1) for x, y in reversed(top)]


def stairs(n: int) -> Ring:
    steps = n // 2 - 1
    return [(0, 0), *(p for i in range(steps) for p in ((steps - i, i), (steps - i, i + 1))), (0, steps)]


def towers(n: int) -> Ring:
    """Return an outline with only right angles: columns of random heights above and below a line."""
    rng, count = Random(n), n // 4
    low = [p for x in range(count) for y in [-rng.randint(1, count)] for p in ((x, y), (x + 1, y))]
    high = [p for x in reversed(range(count)) for y in [rng.randint(1, count)] for p in ((x + 1, y), (x, y))]
    return low + high


def hall(n: int) -> Ring:
    """Return chambers around a circular hall, each with walls turned to the next, so that few lines halve it."""
    angle = 4 * math.tau / n
    arms = [((10, 12, 12, 10)[i % 4], i // 4 * angle + (0, 0.1, 0.5, 0.6)[i % 4] * angle) for i in range(n // 4 * 4)]
    return polar(arms)


def bowl(n: int) -> Ring:
    half = n // 2
    return [
        (-half, -5.0 * half * half),
        (half, -5.0 * half * half),
        *((x, float(x * x)) for x in range(half, -half, -1)),
    ]


def subdivided(ring: Ring) -> Ring:
    """Return the ring with collinear vertices added on its edges."""
    return [(p[0] + (q[0] - p[0]) * i / 4, p[1] + (q[1] - p[1]) * i / 4) for p, q in edges(ring) for i in range(4)]


def coast(n: int) -> Ring:
    rng, heights, step = Random(n), [5.0, 6.0, 5.0, 4.0], 1.5
    while len(heights) < n:
        between = [(p + q) / 2 + rng.uniform(-step, step) for p, q in edges(heights)]
        heights, step = [h for pair in zip(heights, between) for h in pair], step / 1.7
    return polar((max(h, 0.5), math.tau * i / len(heights)) for i, h in enumerate(heights))


BIG: dict[str, Callable[[int], Ring]] = {
    "star": lambda n: star(n // 2),
    "comb": lambda n: comb(n // 4),
    "lying comb": lambda n: [(y, -x) for x, y in comb(n // 4)],
    "spiral": spiral,
    "saw": saw,
    "zigzag": zigzag,
    "stairs": stairs,
    "towers": towers,
    "hall": hall,
    "bowl": bowl,
    "coast": coast,
    "arms of any length": lambda n: star_shaped(Random(n), n, 10),
    "arms on a grid": lambda n: on_grid(
        polar((Random(i).uniform(2 * n, 9 * n), math.tau * i / n) for i in range(n)), 0.25
    ),
    "one dent": lambda n: [*polar((9, math.tau * (i + 0.5) / n) for i in range(n - 1)), (1.0, -0.001)],
    "needles": lambda n: star(n // 2, 1e-6),
    "needles with collinear vertices": lambda n: subdivided(comb(n // 16)),
    "offset of 1e15": lambda n: on_grid([(x * 64 * n, y * 64 * n) for x, y in star(n // 2)], 1.0, 1e15),
    "subnormal": lambda n: on_grid([(x * 64 * n, y * 64 * n) for x, y in star(n // 2)], 5e-324),
}


@pytest.mark.parametrize("kind", one_in(2, BIG))
def test_convex_parts_cover_every_point_of_a_big_outline_exactly_once(kind):
    assert not refute_at_any_size(Polygon(BIG[kind](600)))


@pytest.mark.slow
@pytest.mark.parametrize("kind", BIG)
def test_outlines_of_thousands_of_vertices_are_filled_once_by_convex_parts(kind):
    assert not refute_at_any_size(Polygon(BIG[kind](2400)))


@pytest.mark.parametrize("most", one_in(3, [0, 1, 5]))
@every_kind
def test_pieces_that_are_halved_to_any_size_are_right(kind, most, monkeypatch):
    monkeypatch.setattr(convex_parts, "MAX_REFLEX_VERTICES", most)
    for polygon in sample(kind):
        assert not refute_at_any_size(Polygon(polygon.vertices)), repr(polygon)


@pytest.mark.parametrize("most", [1, 5])
@every_kind
def test_halving_leaves_no_piece_with_more_reflex_vertices_than_the_limit(kind, most, monkeypatch):
    monkeypatch.setattr(convex_parts, "MAX_REFLEX_VERTICES", most)
    for polygon in sample(kind):
        pieces = convex_parts._Pieces(polygon)
        pieces.halve()
        assert max(Counter(map(id, pieces.home.values())).values(), default=0) <= most, repr(polygon)


@pytest.mark.parametrize(
    ("outline", "many"),
    [
        ([(0, 4), (0, 1), (2, 1), (3, 0), (5, 1), (3, 2), (4, 4)], 4),
        ([(3, 2), (3, 5), (4, 4), (6, 4), (4, 1), (1, 2)], 3),  # from either side of the diagonal
        ([(7, 12), (10, 8), (12, 5), (10, 7), (1, 6), (7, 8), (6, 12)], 3),  # two diagonals
        ([(1, 4), (1, 0), (3, 1), (6, 0), (9, 7), (7, 8), (3, 11), (9, 12), (6, 12), (3, 12)], 4),  # at its end
    ],
    ids=["one side", "either side", "two diagonals", "at its end"],
)
def test_no_cut_ends_inside_a_diagonal_that_only_halves_so_that_it_can_be_taken_back(outline, many, monkeypatch):
    monkeypatch.setattr(convex_parts, "MAX_REFLEX_VERTICES", 1)
    assert len(parts(Polygon(outline))) == many


@pytest.mark.parametrize("kind", one_in(10, BIG))
def test_halving_first_gives_hardly_more_parts(kind, monkeypatch):
    """Halving adds no part where all its cuts are diagonals that no vertex needs, since they are undone."""
    halved = len(parts(Polygon(BIG[kind](600))))
    monkeypatch.setattr(convex_parts, "MAX_REFLEX_VERTICES", 600)
    whole = len(parts(Polygon(BIG[kind](600))))
    assert halved <= (1 if kind in ("star", "needles", "zigzag", "spiral", "bowl") else 1.03) * whole


@pytest.mark.parametrize("kind", ["comb", "lying comb", "stairs", "towers"])
def test_a_big_outline_with_right_angles_only_is_cut_into_upright_boxes(kind):
    assert all(part.is_upright_box for part in parts(Polygon(BIG[kind](1200))))


@every_kind
def test_the_diagonals_cut_an_outline_into_triangles(kind):
    for polygon in sample(kind):
        (at,) = integers(polygon.corners)
        found = triangulation.diagonals(polygon.corners)
        assert len(found) == len({frozenset(cut) for cut in found}) == len(at) - 3
        for i, j in map(sorted, found):
            assert not any(i < k < j < m for k, m in map(sorted, found)), repr(polygon)
            assert not any(on_segment(at[k], at[i], at[j]) for k in range(len(at)) if k not in (i, j)), repr(polygon)
            middle = ((at[i][0] + at[j][0]) / Fraction(2), (at[i][1] + at[j][1]) / Fraction(2))
            assert j - i not in (1, len(at) - 1) and holds(at, middle), repr(polygon)


QUICK = ("towers", "comb", "one dent")


@pytest.mark.parametrize("kind", [k if k in QUICK else pytest.param(k, marks=pytest.mark.slow) for k in BIG])
def test_splitting_grows_almost_as_the_outline(kind, monkeypatch):
    """The work is counted in orientations and visited corners; n log n would be 10.7 times as much."""
    work_done: Counter = Counter()

    def counted(owner: object, name: str, work: Callable[..., int]) -> None:
        done = getattr(owner, name)
        monkeypatch.setattr(owner, name, lambda *args: work_done.update({name: work(*args)}) or done(*args))

    for name in "orient_det", "_orientation_at":
        counted(convex_parts, name, lambda *_: 1)
    for module in sweep, triangulation, polygon_validation:
        counted(module, "orient", lambda *_: 1)
    for name in "_sees", "_extend_edge", "_first_beside", "_cut":
        counted(convex_parts._Pieces, name, lambda _, ring, *rest: len(ring))
    cost = []
    for n in (300, 2400) if kind in QUICK else (500, 4000):
        work_done.clear()
        parts(Polygon(BIG[kind](n)))
        cost.append(work_done.total())
    assert cost[1] < 13 * cost[0], cost
