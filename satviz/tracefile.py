"""A trace as JSON and back: the facts, and beside them the verdicts, which the reader checks."""

import json
from math import hypot
from typing import Any

from . import axes
from .axes import Axis, Choice, Skip, Source
from .exact import to_float
from .geometry import InvalidScene, Vec
from .sat import AxisTest, Projection
from .scenefile import shape_data, shape_from
from .strictjson import keys, parse, typed
from .trace import PLAIN, Names, Trace, record

MAX_CHARS = 1 << 26
ROUNDING = 2.0**-28  # how far another machine's square root may move a landing, relative to the reach


def dump(trace: Trace, indent: int | None) -> str:
    return json.dumps({"satviz": "trace 1", **_data(trace)}, indent=indent, ensure_ascii=False, allow_nan=False)


def load(text: str) -> Trace:
    data = dict(keys(parse(text, MAX_CHARS), "the trace", {"satviz"}, set(_KEYS)))
    if data.pop("satviz") != "trace 1":
        raise InvalidScene('"satviz" must be "trace 1"')
    trace = _trace(data, "trace")
    _true(trace)
    _agree(_data(trace), data, "trace")
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
    found = tuple(_axis(axis, f"{where}.axes[{i}]", (a, b)) for i, axis in lists["axes"])
    skipped = []
    for i, skip in lists["skipped"]:
        keys(skip, f"{where}.skipped[{i}]", {"axis", "reason"})
        reason = typed(skip["reason"], f"{where}.skipped[{i}].reason", str)
        skipped.append(Skip(_axis(skip["axis"], f"{where}.skipped[{i}].axis", (a, b)), reason))
    if len(lists["tests"]) > len(found):
        raise InvalidScene(f"{where}.tests has more tests than there are axes")
    tests = tuple(_test(test, f"{where}.tests[{i}]", found[i]) for i, test in lists["tests"])
    choice = Choice(found, tuple(skipped), typed(data["complete"], f"{where}.complete", bool))
    pairs = tuple(_trace(pair, f"{where}.pairs[{i}]") for i, pair in lists["pairs"])
    return Trace(a, b, choice, tests, typed(data["every_axis"], f"{where}.every_axis", bool), pairs, Names(*names))


def _axis(data: Any, where: str, shapes: tuple) -> Axis:
    keys(data, where, {"normal", "length", "source"})
    source = keys(data["source"], f"{where}.source", {"kind", "shape", "vertices"})
    ids = tuple(typed(i, f"{where}.source.vertices", int) for i in typed(source["vertices"], f"{where}.source", list))
    kind, role = typed(source["kind"], f"{where}.source.kind", str), source["shape"]
    axis = Axis(_vec(data["normal"], f"{where}.normal"), _float(data["length"], where), Source(kind, role, ids))
    try:
        x, y = axes.exact_direction(axis, *shapes)
    except (AttributeError, KeyError, TypeError, ValueError, IndexError):
        raise InvalidScene(f"{where}.source names vertices or a kind that these shapes do not have") from None
    k = max(abs(x), abs(y)).bit_length()
    exact = Vec(to_float(x, k), to_float(y, k))
    size = max(map(abs, axis.normal))
    off = abs(exact.x * axis.normal.y - exact.y * axis.normal.x)
    along = exact.x * axis.normal.x + exact.y * axis.normal.y
    if not size or off > size * 1e-12 or along <= 0 or abs(axis.length - hypot(*axis.normal)) > axis.length * 1e-12:
        raise InvalidScene(f"{where} is not the direction (or not the length) that its source has")
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
    """A number; other writers of JSON leave the .0 of a whole one out."""
    if isinstance(value, int) and not isinstance(value, bool) and abs(value) <= 1 << 53:
        return float(value)
    return typed(value, where, float)


def _agree(ours: Any, theirs: Any, where: str) -> None:
    """Every derived value in the file must be what the facts in it give."""
    if isinstance(ours, dict) and isinstance(theirs, dict):
        for key in ours:
            _agree(ours[key], theirs.get(key), f"{where}.{key}")
    elif isinstance(ours, list) and isinstance(theirs, list) and len(ours) == len(theirs):
        for i, (mine, yours) in enumerate(zip(ours, theirs)):
            _agree(mine, yours, f"{where}[{i}]")
    elif ours != theirs or isinstance(ours, bool) is not isinstance(theirs, bool):
        raise InvalidScene(f"{where} is {theirs!r}, but the facts give {ours!r}")


def _true(trace: Trace) -> None:
    """Measure again: numbers may differ by a rounding of another machine, signs and everything else may not."""
    if trace.names != PLAIN:
        raise InvalidScene(f"trace.names is {list(trace.names)}: expected {list(PLAIN)}")
    if not trace.pairs:
        again = record(trace.a, trace.b, axes=_choice_like(trace), every_axis=trace.every_axis)
        _same(trace, again, "trace")
        return
    again = record(trace.a, trace.b, every_axis=trace.every_axis)
    if len(again.pairs) != len(trace.pairs) or trace.choice != again.choice or trace.tests:
        raise InvalidScene("trace.pairs are not those of the shapes' convex parts")
    for i, (pair, ours) in enumerate(zip(trace.pairs, again.pairs)):
        if (pair.a, pair.b, pair.names, pair.pairs) != (ours.a, ours.b, ours.names, ()):
            raise InvalidScene(f"trace.pairs[{i}] is not that of the shapes' convex parts")
        _same(pair, ours, f"trace.pairs[{i}]")


def _choice_like(trace: Trace) -> Choice:
    """The named choice of axes that the trace made; one of its own may leave nothing out and prove nothing complete."""
    for choose in axes.NAMED.values():
        choice = choose(trace.a, trace.b)
        if _sources(choice) == _sources(trace.choice) and choice.complete == trace.choice.complete:
            return choice
    if trace.choice.complete or trace.choice.skipped:
        raise InvalidScene("trace.axes are complete, or leave some out, in a way that no choice of axes does")
    return trace.choice


def _sources(choice: Choice) -> tuple:
    given = [axis.normal if axis.source.kind == axes.GIVEN else axis.source for axis in choice.axes]
    return given, [(skip.axis.source, skip.reason) for skip in choice.skipped]


def _same(trace: Trace, again: Trace, where: str) -> None:
    if _sources(trace.choice) != _sources(again.choice) or trace.choice.complete != again.choice.complete:
        raise InvalidScene(f"{where}.axes are not those of these shapes")
    if trace.every_axis != again.every_axis or len(trace.tests) != len(again.tests):
        raise InvalidScene(f"{where}.tests has {len(trace.tests)} tests where the run has {len(again.tests)}")
    room = max(trace.a._reach, trace.b._reach) * ROUNDING
    for i, (test, ours) in enumerate(zip(trace.tests, again.tests)):
        same_sign = (test.gap > 0) == (ours.gap > 0) and (test.gap < 0) == (ours.gap < 0)
        if not same_sign or not _near((test.gap,), (ours.gap,), room):
            raise InvalidScene(f"{where}.tests[{i}].gap is {test.gap}, but the shapes give {ours.gap}")
        for name, mine, other in ("a", test.a, ours.a), ("b", test.b, ours.b):
            flat = [c for p in mine.points for c in p], [c for p in other.points for c in p]
            if not (_near(*flat, room) and _near(mine.landings, other.landings, room)):
                raise InvalidScene(f"{where}.tests[{i}].{name} is not where these shapes land")


def _near(mine: Any, ours: Any, room: float) -> bool:
    return len(mine) == len(ours) and all(abs(m - o) <= room or m == o for m, o in zip(mine, ours))
