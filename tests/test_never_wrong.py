"""Tests that no form of the verdict is wrong: against rationals, under equivalent changes, and for each find."""

import ctypes
import functools
import platform
import warnings
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from fractions import Fraction
from itertools import combinations, islice, pairwise
from random import Random

import numpy as np
import pytest
from adversary import wrong_answers
from forms import ENGINES, FORMS, RARE, Form, batch_of, misses_nothing
from hypothesis import HealthCheck, given, note, settings
from hypothesis import strategies as st
from oracle import naive, relation
from strategies import KINDS, drawn, pairs, some_pairs

from satviz import batch
from satviz.engine.geometry import Relation
from satviz.engine.shapes import Circle, Polygon, Shape
from satviz.study import truth

ORDINARY, MILLION = 10_000, 1_000_000
ALL = "everything at once"

every_form = pytest.mark.parametrize("form", FORMS)
every_kind = pytest.mark.parametrize("kind", KINDS)
COMPARED = [
    name for name, form in FORMS.items() if form.fits is not misses_nothing
]  # others may keep a pair, and then not

Known = list[tuple[Shape, Shape, Relation]]


def shown(known: Sequence[tuple]) -> str:
    """Return the first wrong pairs to paste, each with its answer and the true relation."""
    return "\n".join(f"says {said}, is {right}:\na = {a!r}\nb = {b!r}" for a, b, right, said in known[:3])


def refute(form: Form, known: Known, name: str = "") -> None:
    """Fail if the form is wrong for any of the pairs it is given."""
    tried = known[:: form.one_in]
    answers = form.ask([(a, b) for a, b, _ in tried])
    assert len(answers) == len(tried)
    wrong = [
        (a, b, right, said)
        for (a, b, right), said in zip(tried, answers, strict=True)
        if said is not None and not form.fits(said, right)
    ]
    if wrong:
        pytest.fail(f"{name} wrong about {len(wrong)} of {len(tried)} pairs\n{shown(wrong)}", pytrace=False)


# -- against rationals -----------------------------------------------------------------------------


@functools.cache
def known(kind: str) -> Known:
    """Return pairs of a kind with their relations; for all kinds, some of each."""
    if kind == ALL:
        return [pair for name in KINDS for pair in judged(name, 0, 30)]
    return judged(kind, 1, ORDINARY // len(KINDS))


def judged(kind: str, seed: int, count: int) -> Known:
    rng = Random(f"{kind} {seed}")
    return [(a, b, relation(a, b)) for a, b in (drawn(rng, kind) for _ in range(count))]


@every_form
def test_every_form_of_the_relation_is_right(form):
    refute(FORMS[form], known(ALL))


@pytest.mark.slow
@every_kind
def test_every_form_of_the_relation_is_right_about_many_pairs_of_a_kind(kind):
    for name, form in FORMS.items():
        refute(form, known(kind), name)


@pytest.mark.full
@every_kind
def test_every_form_of_the_relation_is_right_about_a_million_pairs(kind):
    """All pairs go through the cheap forms, and samples through the expensive ones."""
    for seed in range(2, 2 + MILLION // len(KINDS) // 2_000):
        some = judged(kind, seed, 2_000)
        for name, form in FORMS.items():
            refute(form._replace(one_in=1 if form.one_in <= 2 else 4 * form.one_in), some, name)


@pytest.mark.parametrize("form", RARE)
def test_every_slow_or_rare_form_of_the_relation_is_right(form):
    refute(RARE[form], known(ALL))


def test_the_rationals_agree_with_the_simplest_method():
    for kind, a, b in pairs(1, 12 * len(KINDS)):
        if kind not in ("concave", "in the notch"):
            assert truth.relation(a, b) is truth.relation(b, a) is naive(a, b), (a, b)


@pytest.mark.slow
def test_the_generated_pairs_have_every_relation():
    irrational = {"random polygons", "random circles", "circles near tangent", "circle and polygon near tangent"}
    irrational |= {"map coordinates", "needles pointed at circles", "circle by a bent side"}
    for kind in KINDS:
        seen = {right for _, _, right in known(kind)}
        assert seen >= ({Relation.APART, Relation.OVERLAPPING} if kind in irrational else set(Relation)), kind


# -- numbers below 2.3e-308 taken for 0 ------------------------------------------------------------


@contextmanager
def flushed() -> Iterator[None]:
    """Flush subnormal numbers to zero, as code compiled with -ffast-math leaves a thread."""
    if (platform.machine(), platform.libc_ver()[0]) != ("x86_64", "glibc"):
        pytest.skip("this machine's word for flush-to-zero is not known here")
    math, kept = ctypes.CDLL("libm.so.6"), (ctypes.c_uint32 * 8)()
    math.fegetenv(kept)
    other = type(kept)(*kept)
    other[7] |= 0x8040  # MXCSR: results to zero, operands to zero
    math.fesetenv(other)
    try:
        yield
    finally:
        math.fesetenv(kept)


def test_a_thread_that_flushes_subnormal_numbers_to_zero_gets_a_warning():
    ring = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)]
    constructors = {
        "Polygon": lambda: Polygon(ring),
        "Circle": lambda: Circle((0, 0), 1),
        "Polygons": lambda: batch.Polygons(np.array([ring])),
        "a list": lambda: batch.Polygons([ring]),
        "offsets": lambda: batch.Polygons(np.array(ring), offsets=[0, 3]),
        "Circles": lambda: batch.Circles(np.zeros((2, 2)), 1.0),
        "boxes": lambda: batch.candidate_pairs(np.array([[0.0, 0.0, 1.0, 1.0]])),
    }
    for make in constructors.values():
        make()
        with flushed(), pytest.warns(RuntimeWarning, match="exact only if every number is 0 or at least 1e-290"):
            make()


def numbers(shape: Shape) -> list[float]:
    return [c for p in shape.core for c in p] + [shape.radius]


@pytest.mark.slow
def test_every_way_to_relate_is_right_with_subnormals_flushed_to_zero_if_no_input_is_subnormal():
    some = [row for row in known(ALL)[::4] if all(c == 0 or abs(c) > 1e-290 for s in row[:2] for c in numbers(s))]
    assert len(some) > 200
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", "this thread rounds")
        for name, form in FORMS.items():
            with flushed():
                refute(form, some, name)


# -- changes that change nothing -------------------------------------------------------------------


def mapped(shape: Shape, move: Callable[[float, float], tuple[float, float]], grow: float = 1.0) -> Shape:
    """Return the shape with its points mapped; ValueError if the radius is rounded."""
    if isinstance(shape, Circle):
        return Circle(move(*shape.center), exactly(Fraction(shape.radius) * Fraction(grow)))
    return Polygon([move(x, y) for x, y in shape.vertices])


def exactly(value: Fraction) -> float:
    rounded = float(value)
    if Fraction(rounded) != value:
        raise ValueError("rounded")
    return rounded


def scaled(rng: Random, a: Shape, b: Shape) -> tuple[Shape, Shape]:
    grow = 2.0 ** rng.choice((rng.randint(-8, 8), rng.randint(-1060, 1015)))
    times = Fraction(grow)
    return tuple(mapped(s, lambda *v: tuple(exactly(Fraction(c) * times) for c in v), grow) for s in (a, b))


def translated(rng: Random, a: Shape, b: Shape) -> tuple[Shape, Shape]:
    """Return the pair moved by one of its own coordinates, often as fine as the others, or by a whole number."""
    v = a.center if isinstance(a, Circle) else rng.choice(a.vertices)
    by = [Fraction(-c) for c in v] if rng.random() < 0.7 else [Fraction(rng.randint(-99, 99)) for _ in "xy"]
    return tuple(mapped(s, lambda *v: tuple(exactly(Fraction(c) + d) for c, d in zip(v, by))) for s in (a, b))


def turned(rng: Random, a: Shape, b: Shape) -> tuple[Shape, Shape]:
    times = rng.randint(1, 3)
    for _ in range(times):
        a, b = (mapped(s, lambda x, y: (-y, x)) for s in (a, b))
    return a, b


def mirrored(rng: Random, a: Shape, b: Shape) -> tuple[Shape, Shape]:
    move = rng.choice((lambda x, y: (-x, y), lambda x, y: (x, -y), lambda x, y: (y, x)))
    return mapped(a, move), mapped(b, move)


def rings_changed(change: Callable[[Random, list], list]) -> Callable[[Random, Shape, Shape], tuple[Shape, Shape]]:
    def changed(rng: Random, a: Shape, b: Shape) -> tuple[Shape, Shape]:
        return tuple(s if isinstance(s, Circle) else Polygon(change(rng, list(s.vertices))) for s in (a, b))

    return changed


def started_elsewhere(rng: Random, ring: list) -> list:
    k = rng.randrange(len(ring))
    return ring[k:] + ring[:k]


def with_a_straight_vertex(rng: Random, ring: list) -> list:
    """Return the pair with one more vertex, in the middle of an edge or a quarter along it."""
    i = rng.randrange(len(ring))
    part = rng.choice((Fraction(1, 2), Fraction(1, 4)))
    middle = [exactly(Fraction(p) + (Fraction(q) - Fraction(p)) * part) for p, q in zip(ring[i - 1], ring[i])]
    return [*ring[:i], tuple(middle), *ring[i:]]


CHANGES: dict[str, Callable[[Random, Shape, Shape], tuple[Shape, Shape]]] = {
    "swapped": lambda rng, a, b: (b, a),
    "from another first vertex": rings_changed(started_elsewhere),
    "the other way round": rings_changed(lambda rng, ring: ring[::-1]),
    "with a straight vertex": rings_changed(with_a_straight_vertex),
    "turned by quarters": turned,
    "mirrored": mirrored,
    "times a power of two": scaled,
    "moved exactly": translated,
}


@functools.cache
def changed(kind: str, count: int) -> list[tuple[str, Shape, Shape, int]]:
    """Return (change, a, b, index among the `count` pairs); first the pairs themselves."""
    rng = Random(f"{kind} 2")
    originals = [drawn(rng, kind if kind != ALL else rng.choice(list(KINDS))) for _ in range(count)]
    found = [("nothing", a, b, i) for i, (a, b) in enumerate(originals)]
    for name, change in CHANGES.items():
        for i, (a, b) in enumerate(originals):
            for _ in range(2):  # a straight vertex is not on every edge, nor every move exact
                with suppress(ValueError, OverflowError):
                    found.append((name, *change(rng, a, b), i))
                    break
    return found


def refute_by_changes(form: Form, kind: str, name: str = "") -> None:
    ask, one_in = form.ask, form.one_in
    cases = changed(kind, (6 if one_in < 8 else 4 if one_in < 20 else 2) * (2 if kind == ALL else 1))
    answers = ask([(a, b) for _, a, b, _ in cases])
    base = {i: answer for (change, *_, i), answer in zip(cases, answers, strict=True) if change == "nothing"}
    wrong = [
        (a, b, f"{base[i]} before it was {change}", answer)
        for (change, a, b, i), answer in zip(cases, answers, strict=True)
        if answer is not None and answer != base[i] and not (form.overflows and base[i] is None)
    ]
    if wrong:
        pytest.fail(f"{name}\n{shown(wrong)}", pytrace=False)


@pytest.mark.parametrize("form", COMPARED)
def test_an_equivalent_pair_has_the_same_answer(form):
    refute_by_changes(FORMS[form], ALL)


@pytest.mark.slow
@every_kind
def test_an_equivalent_pair_of_each_kind_has_the_same_answer(kind):
    for name in COMPARED:
        refute_by_changes(FORMS[name], kind, name)


@pytest.mark.slow
def test_every_change_that_keeps_the_relation_is_tried_on_pairs_of_every_kind():
    """Exact moves and collinear vertices do not exist for every pair, but for many."""
    made = Counter(change for kind in KINDS for change, *_ in changed(kind, 6))
    assert min(made.values()) > 2 * len(KINDS), made


# -- drawn by hypothesis ---------------------------------------------------------------------------

QUICK = [name for name, form in FORMS.items() if form.one_in < 20]


@given(pair=some_pairs(), data=st.data())
@settings(max_examples=150, deadline=None, database=None, suppress_health_check=list(HealthCheck))
def test_every_form_of_the_relation_is_right_about_a_randomly_drawn_pair(pair, data):
    """Hypothesis searches for the smallest pair for which any form is wrong."""
    name = data.draw(st.sampled_from(QUICK))
    note(f"{name}:\na = {pair[0]!r}\nb = {pair[1]!r}")
    refute(FORMS[name], [(*pair, relation(*pair))])


@pytest.mark.full
def test_an_evolutionary_search_finds_no_pair_that_a_form_is_wrong_about():
    wrong = [(a, b, right, f"{name}: {said}") for name, a, b, right, said in islice(wrong_answers(1, 300), 3)]
    if wrong:
        pytest.fail(shown(wrong), pytrace=False)


# -- the broad phase, whole layouts ----------------------------------------------------------------


def tiled(rng: Random) -> list[Shape]:
    """Return a floor of tiles beside 0, each side computed in one of the ways that programs use."""
    size, rows, start = rng.choice((0.1, 0.3, 1.0, 7.0)), rng.randint(2, 9), rng.randint(-6, 0)
    tiny = rng.choice((0.0, 0.0, -1e-17, 1e-17, -5e-324, -1e-300, 2.0**-60))
    way = rng.randrange(3)

    def side(k: int) -> float:
        if k + start == 0 and tiny:
            return tiny
        if way == 0:
            return (k + start) * size
        return start * size + (k * size if way == 1 else sum([size] * k))

    sides = [side(k) for k in range(rows + 1)]
    rings = [
        [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]
        for x0, x1 in pairwise(sides)
        for y0, y1 in pairwise(sides)
        if rng.random() < 0.8
    ]
    return [Polygon(ring) for ring in rings[: rng.choice((2, 60))]]


@pytest.mark.parametrize("engine", ENGINES)
def test_colliding_pairs_of_tiles_are_those_found_by_testing_every_pair(engine):
    rng = Random(1)
    for _ in range(60):
        shapes = tiled(rng)
        batched = batch_of(shapes)
        every = np.array(list(combinations(range(len(shapes)), 2))).reshape(-1, 2)
        hits = every[batch.hits(batched, batched, every, engine=engine)].tolist()
        assert batch.colliding_pairs(batched, engine=engine).tolist() == hits, shapes
        strips = batch.stream_colliding_pairs(np.array([s.vertices for s in shapes]), engine=engine, strip=7)
        assert sorted(np.concatenate(list(strips)).tolist()) == hits, shapes


# -- each find -------------------------------------------------------------------------------------

L = Polygon([(0, 0), (4, 0), (4, 2), (2, 2), (2, 4), (0, 4)])
T = Polygon([(10, 10), (12, 10), (10, 12)])
FINDS: dict[str, tuple[Shape, Shape]] = {
    "a diamond off the corner of a triangle ten million times as large": (
        Polygon([(0, -10), (10, 0), (0, 10), (-10, 0)]),
        Polygon([(-(10**9), -5 * 10**8), (-5 * 10**8, -(10**9)), (-9, -9)]),
    ),
    "the same, touching": (
        Polygon([(0, -10), (10, 0), (0, 10), (-10, 0)]),
        Polygon([(-(10**9), -5 * 10**8), (-5 * 10**8, -(10**9)), (-5, -5)]),
    ),
    "tiles a rounding off 0": (
        Polygon([(-1e-17, 0), (1, 0), (1, 1), (-1e-17, 1)]),
        Polygon([(1, 0), (2, 0), (2, 1), (1, 1)]),
    ),
    "a circle that reaches beyond float64": (
        Circle((5.8471884068399994e289, 7.79625120912e289), 9.7453140114e289),
        Circle((-6.741349255733685e307, -8.98846567431158e307), 1.1235582092889474e308),
    ),
    "products of the second shape overflow, and the first is in doubt": (
        Polygon(
            [
                (3.4993032202554845e-06, 1.4206998076913991e-14),
                (-2.8762055146757608e-207, 9.728768612449612e-58),
                (-0.809335975886294, -3.881747674521009e-281),
            ]
        ),
        Polygon(
            [
                (3.4993032202554845e-06, 1.4206998076913988e-14),
                (15.710354896350877, 2.045063374219829),
                (3.8581799378775944e90, 1.6061729690813666e257),
            ]
        ),
    ),
    "a concave polygon that is touched": (L, Polygon([(2, 4), (3, 3), (4, 5)])),
    "a center inside that looks as if it lay on the line of the farther part of a bent side": (
        Circle((-0.21513426670056085, -1.049634022941197), 2.0**-30),
        Polygon(
            [
                (0.35055044081457876, 0.07237696439512242),
                (0.16528560013045612, -0.2950877806353641),
                (-0.31492680671564166, -1.2475681810748873),
                (0.39584744441892955, -0.5104130692165282),
            ]
        ),
    ),
    "the same, below the side": (
        Polygon(
            [
                (0.15337934752318283, -0.19039964824112587),
                (-0.0831543152614718, -0.39236320556143933),
                (-0.8061433981374292, -1.0096852618064176),
                (0.1842911285919867, -0.996608964272762),
            ]
        ),
        Circle((-0.37993179535337646, -0.6457657652913393), 2.0**-30),
    ),
}


@functools.cache
def dressed(find: str) -> Known:
    """Return the pair with every first vertex, both windings and both orders."""
    a, b = FINDS[find]
    right = relation(a, b)
    found = [(p, q) for p in started(a) for q in started(b)]
    return [(p, q, right) for p, q in found] + [(q, p, right) for p, q in found]


@every_form
def test_every_form_of_the_relation_is_right_about_pairs_on_which_one_was_wrong_before(form):
    for find in FINDS:
        few = FORMS[form].one_in < 16 or len(dressed(find)) < 30
        refute(FORMS[form]._replace(one_in=1 if few else 5), dressed(find), find)  # 5 divides no number of vertices


def started(shape: Shape) -> list[Shape]:
    """Return the same shape with every first vertex and both windings."""
    if isinstance(shape, Circle):
        return [shape]
    ring = shape.vertices
    return [Polygon((ring[i:] + ring[:i])[::way]) for i in range(len(ring)) for way in (1, -1)]


def test_a_slice_of_a_split_batch_selects_shapes_and_not_parts():
    shapes = batch.Polygons([T, L, T], concave="split")
    assert batch.relate(shapes[1:], shapes[1:]).tolist() == [2, 2]
    assert batch.relate(shapes[[1, 2, 0]], shapes[::-1]).tolist() == [0, 0, 2]
    assert batch.relate(shapes[np.array([False, True, False])], shapes).tolist() == [0, 2, 0]
    assert len(shapes[-2]) == len(shapes[1]) == 1
    assert batch.relate(shapes[-2], shapes).tolist() == [0, 2, 0]
    for outside in (3, -4, [0, 3]):
        with pytest.raises(IndexError):
            shapes[outside]
