"""A trace as JSON and back: the facts, and beside them the verdicts, which the reader checks."""

import json
from typing import Any

from .axes import Axis, Choice, Skip, Source, exact_normal
from .exact import aligned, to_float
from .geometry import InvalidScene, Vec
from .sat import AxisTest, Projection, axis_tests
from .scenefile import shape_data, shape_from
from .shapes import Circle
from .strictjson import keys, parse, typed
from .trace import Names, Trace, record
from .verdict import relate

MAX_CHARS = 1 << 26
ROUNDING = 2.0**-28  # how far another machine's square root may move a landing, relative to the reach


def dump(trace: Trace, indent: int | None) -> str:
    return json.dumps({"satviz": "trace 1", **_data(trace)}, indent=indent, ensure_ascii=False, allow_nan=False)


def load(text: str) -> Trace:
    data = dict(keys(parse(text, MAX_CHARS), "the trace", {"satviz"}, set(_KEYS)))
    if data.pop("satviz") != "trace 1":
        raise InvalidScene('"satviz" must be "trace 1"')
    trace = _trace(data, "trace")
    _agree(_data(trace), data, "trace")
    _true(trace)
    return trace


def _axis_data(axis: Axis) -> dict:
    kind, shape, ids = axis.source
    source = {"kind": kind, "shape": shape, "vertices": list(ids)}
    return {"normal": list(axis.normal), "length": axis.length, "source": source}


def _side_data(side: Projection) -> dict:
    points = [list(p) for p in side.points]
    return {"points": points, "landings": list(side.landings), "interval": list(side.interval)}


def _test_data(test: AxisTest) -> dict:
    return {"a": _side_data(test.a), "b": _side_data(test.b), "gap": test.gap, "separates": test.separates}


def _data(trace: Trace) -> dict:
    mtv = trace.mtv
    return {
        "a": shape_data(trace.a),
        "b": shape_data(trace.b),
        "names": list(trace.names),
        "every_axis": trace.every_axis,
        "complete": trace.choice.complete,
        "axes": [_axis_data(axis) for axis in trace.choice.axes],
        "skipped": [{"axis": _axis_data(s.axis), "reason": s.reason} for s in trace.choice.skipped],
        "tests": [_test_data(test) for test in trace.tests],
        "pairs": [_data(pair) for pair in trace.pairs],
        "relation": str(trace.relation),
        "hit": trace.hit,
        "mtv": mtv and list(mtv),
        "sentence": trace.sentence,
    }


_LISTS = ["axes", "skipped", "tests", "pairs"]
_KEYS = ["a", "b", "names", "every_axis", "complete", *_LISTS, "relation", "hit", "mtv", "sentence"]


def _trace(data: Any, where: str) -> Trace:
    keys(data, where, set(_KEYS))
    a, b = (shape_from(data[name], f"{where}.{name}") for name in ("a", "b"))
    names = [typed(name, f"{where}.names", str) for name in typed(data["names"], f"{where}.names", list)]
    if len(names) != 2:
        raise InvalidScene(f"{where}.names must be two texts")
    lists = {name: list(enumerate(typed(data[name], f"{where}.{name}", list))) for name in _LISTS}
    axes = tuple(_axis(axis, f"{where}.axes[{i}]", (a, b)) for i, axis in lists["axes"])
    skipped = []
    for i, skip in lists["skipped"]:
        keys(skip, f"{where}.skipped[{i}]", {"axis", "reason"})
        reason = typed(skip["reason"], f"{where}.skipped[{i}].reason", str)
        skipped.append(Skip(_axis(skip["axis"], f"{where}.skipped[{i}].axis", (a, b)), reason))
    if len(lists["tests"]) > len(axes):
        raise InvalidScene(f"{where}.tests has more tests than there are axes")
    tests = tuple(_test(test, f"{where}.tests[{i}]", axes[i]) for i, test in lists["tests"])
    choice = Choice(axes, tuple(skipped), typed(data["complete"], f"{where}.complete", bool))
    pairs = tuple(_trace(pair, f"{where}.pairs[{i}]") for i, pair in lists["pairs"])
    return Trace(a, b, choice, tests, typed(data["every_axis"], f"{where}.every_axis", bool), pairs, Names(*names))


def _axis(data: Any, where: str, shapes: tuple) -> Axis:
    keys(data, where, {"normal", "length", "source"})
    source = keys(data["source"], f"{where}.source", {"kind", "shape", "vertices"})
    ids = tuple(typed(i, f"{where}.source.vertices", int) for i in typed(source["vertices"], f"{where}.source", list))
    kind, role = typed(source["kind"], f"{where}.source.kind", str), source["shape"]
    if role is not None and role not in ("A", "B"):
        raise InvalidScene(f'{where}.source.shape must be "A", "B" or null')
    axis = Axis(_vec(data["normal"], f"{where}.normal"), _float(data["length"], where), Source(kind, role, ids))
    try:
        cores = aligned(*shapes)
        x, y = exact_normal(axis, dict(zip("AB", shapes)), dict(zip("AB", cores)))
    except (AttributeError, KeyError, TypeError, ValueError, IndexError):
        raise InvalidScene(f"{where}.source names vertices or a kind that these shapes do not have") from None
    k = max(abs(x), abs(y)).bit_length()
    exact = Vec(to_float(x, k), to_float(y, k))
    size = max(map(abs, axis.normal))
    off = abs(exact.x * axis.normal.y - exact.y * axis.normal.x)
    if not (x or y) or axis.length <= 0 or off > size * 1e-12 or exact.x * axis.normal.x + exact.y * axis.normal.y <= 0:
        raise InvalidScene(f"{where}.normal is not the direction its source has")
    return axis


def _test(data: Any, where: str, axis: Axis) -> AxisTest:
    keys(data, where, {"a", "b", "gap", "separates"})
    a, b = (_side(data[side], f"{where}.{side}") for side in ("a", "b"))
    return AxisTest(axis, a, b, _float(data["gap"], f"{where}.gap"))


def _side(data: Any, where: str) -> Projection:
    keys(data, where, {"points", "landings", "interval"})
    points = tuple(_vec(p, f"{where}.points") for p in typed(data["points"], f"{where}.points", list))
    landings = tuple(_float(v, f"{where}.landings") for v in typed(data["landings"], f"{where}.landings", list))
    if not landings or len(points) != len(landings):
        raise InvalidScene(f"{where} needs as many landings as points, and at least one")
    return Projection(points, landings)


def _vec(data: Any, where: str) -> Vec:
    if not isinstance(data, list) or len(data) != 2:
        raise InvalidScene(f"{where} must be a pair of numbers")
    return Vec(*(_float(v, where) for v in data))


def _float(value: Any, where: str) -> float:
    return typed(value, where, float)


def _agree(ours: Any, theirs: Any, where: str) -> None:
    """Every derived value in the file must be what the facts in it give."""
    if isinstance(ours, dict) and isinstance(theirs, dict):
        for key in ours:
            _agree(ours[key], theirs.get(key), f"{where}.{key}")
    elif isinstance(ours, list) and isinstance(theirs, list) and len(ours) == len(theirs):
        for i, (mine, yours) in enumerate(zip(ours, theirs)):
            _agree(mine, yours, f"{where}[{i}]")
    elif ours != theirs or type(ours) is not type(theirs):
        raise InvalidScene(f"{where} is {theirs!r}, but the facts give {ours!r}")


def _true(trace: Trace) -> None:
    """Measure again: landings may differ by a rounding of another machine, signs may not."""
    if trace.relation is not relate(trace.a, trace.b):
        raise InvalidScene(f"the trace says {trace.relation}, but the shapes are {relate(trace.a, trace.b)}")
    if trace.pairs:
        again = record(trace.a, trace.b, every_axis=trace.every_axis)
        if [(p.a, p.b, p.names) for p in again.pairs] != [(p.a, p.b, p.names) for p in trace.pairs]:
            raise InvalidScene("the trace's pairs are not those of the shapes' convex parts")
        for pair in trace.pairs:
            _true(pair)
    room = max(trace.a._reach, trace.b._reach) * ROUNDING
    for i, (test, again) in enumerate(zip(trace.tests, axis_tests(trace.a, trace.b, trace.choice.axes))):
        same_sign = (test.gap > 0) == (again.gap > 0) and (test.gap < 0) == (again.gap < 0)
        if not same_sign or not _near((test.gap,), (again.gap,), room):
            raise InvalidScene(f"tests[{i}].gap is {test.gap}, but the shapes give {again.gap}")
        for name, mine, ours, shape in ("a", test.a, again.a, trace.a), ("b", test.b, again.b, trace.b):
            exact_points = isinstance(shape, Circle) or mine.points == ours.points
            flat = [c for p in mine.points for c in p], [c for p in ours.points for c in p]
            if not (exact_points and _near(*flat, room) and _near(mine.landings, ours.landings, room)):
                raise InvalidScene(f"tests[{i}].{name} is not where these shapes land")


def _near(mine: Any, ours: Any, room: float) -> bool:
    return len(mine) == len(ours) and all(abs(m - o) <= room or m == o for m, o in zip(mine, ours))
