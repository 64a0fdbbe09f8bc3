"""A trace as JSON and back: the facts, and beside them the verdicts, which the reader checks."""

import json
from dataclasses import replace
from itertools import takewhile
from math import hypot
from typing import Any

from ..engine import axes, describe, number_format
from ..engine.axes import Axis, Choice, Skip, Source
from ..engine.describe import Names
from ..engine.geometry import InvalidScene, InvalidShape, Vec
from ..engine.mtv import ends_overlap
from ..engine.polygon_validation import number, shown
from ..engine.predicates import MAX_FLOAT, MIN_FLOAT
from ..engine.sat import CLOSE_GAP_FACTOR, AxisTest, Projection
from ..engine.shapes import Shape
from ..engine.shortcut import Shortcut
from ..engine.trace import PLAIN, Trace, record
from .scenefile import shape_data, shape_from
from .shortcuts import NAMED as SHORTCUTS
from .strictjson import keys, parse, refuse_large, typed

MAX_CHARS = 1 << 26
# How far another machine's square root may move a landing, relative to the reach: under 26 * 2**-53, see sat.CLOSE.
ROUNDING = 2.0**-46
# The same where all is float work: a shortcut's own measure, and the way out of concave outlines.
FLOAT_ROUNDING = 2.0**-28


def dump(trace: Trace, indent: int | None) -> str:
    """A trace as the text of a trace file; InvalidScene for a shortcut of one's own, which nobody could run again."""
    if trace.shortcut and SHORTCUTS.get(trace.shortcut.name) != trace.shortcut:
        raise InvalidScene(
            f"the shortcut {shown(trace.shortcut.name)} is none of satviz's: its trace cannot be written"
        )
    data = {"satviz": "trace 1", **_trace_data(trace, trace.known_mtv)}
    text = json.dumps(data, indent=indent, ensure_ascii=False, allow_nan=False)
    try:
        refuse_large(text, MAX_CHARS)
    except InvalidScene as error:
        raise InvalidScene(f"the trace is too large for a file that can be read again: {error}") from None
    return text


def load(text: str) -> Trace:
    """Everything is worked out again from the two shapes alone, in bounded time, and compared."""
    data = dict(keys(parse(text, MAX_CHARS), "the trace", {"satviz"}, _KEYS))
    if data.pop("satviz") != "trace 1":
        raise InvalidScene('"satviz" must be "trace 1"')
    keys(data, "trace", _KEYS)
    a, b = (shape_from(data[name], f"trace.{name}") for name in ("a", "b"))
    shortcut = _parse_shortcut(data["shortcut"])
    pairs = typed(data["pairs"], "trace.pairs", list)
    if pairs or (shortcut and shortcut.split):
        every_axis = typed(data["every_axis"], "trace.every_axis", bool)
        again = record(a, b, axes=shortcut or axes.needed, every_axis=every_axis)
        if len(pairs) != len(again.pairs):
            raise InvalidScene("trace.pairs are not those of the shapes' convex parts")
        found = zip(pairs, again.pairs, strict=True)
        trace = replace(
            again, pairs=tuple(_parse_pair(pair, f"trace.pairs[{i}]", ours) for i, (pair, ours) in enumerate(found))
        )
    else:
        trace = _parse_run(data, "trace", a, b, PLAIN, shortcut)
        _require_same_run(trace, _record_again(trace), "trace")
    _require_equal(_trace_data(trace, _accepted_mtv(trace, data["mtv"])), data, "trace")
    return trace


def _parse_shortcut(name: Any) -> Shortcut | None:
    if name is None:
        return None
    if typed(name, "trace.shortcut", str) not in SHORTCUTS:
        raise InvalidScene(f"trace.shortcut is {shown(name)}: no shortcut of that name")
    return SHORTCUTS[name]


def _parse_pair(data: Any, where: str, ours: Trace) -> Trace:
    trace = _parse_run(data, where, ours.a, ours.b, ours.names)
    _require_same_run(trace, ours, where)
    return trace


def _accepted_mtv(trace: Trace, data: Any) -> Vec | None:
    """The file's move for concave outlines, if it is as good; another machine may round its way to another one."""
    ours = trace.known_mtv
    if not trace.pairs or not ours or data is None:
        return ours
    theirs = _parse_vector(data, "trace.mtv")
    as_short = hypot(*theirs) <= hypot(*ours) * (1 + FLOAT_ROUNDING)
    return theirs if as_short and ends_overlap(trace.a, trace.b, theirs) else ours


def _axis_data(axis: Axis) -> dict[str, object]:
    kind, shape, ids = axis.source
    source = {"kind": kind, "shape": shape, "vertices": list(ids)}
    return {"normal": list(axis.normal), "length": axis.length, "source": source}


def _side_data(side: Projection) -> dict[str, object]:
    points = [list(p) for p in side.points]
    return {"points": points, "landings": list(side.landings), "interval": list(side.interval)}


def _test_data(test: AxisTest) -> dict[str, object]:
    return {"a": _side_data(test.a), "b": _side_data(test.b), "gap": test.gap, "separates": test.separates}


def _trace_data(trace: Trace, mtv: Vec | None) -> dict[str, object]:
    return {
        "a": shape_data(trace.a),
        "b": shape_data(trace.b),
        "names": list(trace.names),
        "shortcut": trace.shortcut and trace.shortcut.name,
        "every_axis": trace.every_axis,
        "complete": trace.choice.complete,
        "axes": [_axis_data(axis) for axis in trace.choice.axes],
        "skipped": [
            {"axis": _axis_data(s.axis), "reason": describe.reason(s.why, s.number)} for s in trace.choice.skipped
        ],
        "tests": [_test_data(test) for test in trace.tests],
        "pairs": [_trace_data(pair, pair.known_mtv) for pair in trace.pairs],
        "claim": str(trace.claim),
        "relation": str(trace.relation),
        "hit": trace.hit,
        "mtv": mtv and list(mtv),
        "sentence": number_format.plain(describe.verdict(trace, mtv)),
    }


_LISTS = ["axes", "skipped", "tests", "pairs"]
_KEYS = {"a", "b", "names", "shortcut", "every_axis", "complete", *_LISTS}
_KEYS |= {"claim", "relation", "hit", "mtv", "sentence"}


def _parse_run(data: Any, where: str, a: Shape, b: Shape, names: Names, shortcut: Shortcut | None = None) -> Trace:
    """The trace of one run, with the file's numbers."""
    keys(data, where, _KEYS)
    lists = {name: list(enumerate(typed(data[name], f"{where}.{name}", list))) for name in _LISTS}
    known = axes.axes_by_source(a, b)
    if shortcut:
        known |= {axis.source: axis for axis in shortcut.choose(a, b).axes}
    found = tuple(_parse_axis(axis, f"{where}.axes[{i}]", known) for i, axis in lists["axes"])
    parallel = [(axes.PARALLEL, i) for i in range(1, len(found) + 1)]
    reasons = {describe.reason(*facts): facts for facts in [(axes.NO_DIRECTION, None), *parallel]}
    skipped = []
    for i, skip in lists["skipped"]:
        keys(skip, f"{where}.skipped[{i}]", {"axis", "reason"})
        reason = typed(skip["reason"], f"{where}.skipped[{i}].reason", str)
        if reason not in reasons:
            raise InvalidScene(
                f"{where}.skipped[{i}].reason is {shown(reason)}: no reason to leave out one of these axes"
            )
        skipped.append(Skip(_parse_axis(skip["axis"], f"{where}.skipped[{i}].axis", known), *reasons[reason]))
    if len(lists["tests"]) > len(found):
        raise InvalidScene(f"{where}.tests has more tests than there are axes")
    tests = tuple(_parse_test(test, f"{where}.tests[{i}]", found[i]) for i, test in lists["tests"])
    choice = Choice(found, tuple(skipped), typed(data["complete"], f"{where}.complete", bool))
    every_axis = typed(data["every_axis"], f"{where}.every_axis", bool)
    return Trace(a, b, choice, tests, every_axis, (), names, shortcut)


def _parse_axis(data: Any, where: str, known: dict[Source, Axis]) -> Axis:
    keys(data, where, {"normal", "length", "source"})
    told = keys(data["source"], f"{where}.source", {"kind", "shape", "vertices"})
    ids = tuple(typed(i, f"{where}.source.vertices", int) for i in typed(told["vertices"], f"{where}.source", list))
    kind, role = typed(told["kind"], f"{where}.source.kind", str), told["shape"]
    source = Source(kind, role if role is None else typed(role, f"{where}.source.shape", str), ids)
    axis = Axis(
        _parse_vector(data["normal"], f"{where}.normal"), _parse_float(data["length"], f"{where}.length"), source
    )
    if kind == axes.GIVEN and role is None and len(ids) == 1 and any(axis.normal):
        ours: Axis | None = axes.given_axis(axis.normal, ids[0])
    else:
        ours = known.get(source)
    if ours is None:
        raise InvalidScene(f"{where}.source names vertices or a kind that these shapes do not have")
    if not axes.same_axis(axis, ours):
        raise InvalidScene(f"{where} is not the direction (or not the length) that its source has")
    return axis


def _parse_test(data: Any, where: str, axis: Axis) -> AxisTest:
    keys(data, where, {"a", "b", "gap", "separates"})
    a, b = (_parse_projection(data[side], f"{where}.{side}") for side in ("a", "b"))
    return AxisTest(axis, a, b, _parse_float(data["gap"], f"{where}.gap"))


def _parse_projection(data: Any, where: str) -> Projection:
    keys(data, where, {"points", "landings", "interval"})
    points = tuple(_parse_vector(p, f"{where}.points") for p in typed(data["points"], f"{where}.points", list))
    landings = tuple(_parse_float(v, f"{where}.landings") for v in typed(data["landings"], f"{where}.landings", list))
    return Projection(points, landings)


def _parse_vector(data: Any, where: str) -> Vec:
    if not isinstance(data, list) or len(data) != 2:
        raise InvalidScene(f"{where} must be a pair of numbers")
    return Vec(*(_parse_float(v, where) for v in data))


def _parse_float(value: Any, where: str) -> float:
    """A finite number; other writers of JSON leave the .0 of a whole one out."""
    try:
        return number(value, where)
    except InvalidShape as error:
        raise InvalidScene(str(error)) from None


def _require_equal(ours: Any, theirs: Any, where: str) -> None:
    """Every derived value in the file must be what the facts in it give."""
    if isinstance(ours, dict) and isinstance(theirs, dict):
        for key in {**ours, **theirs}:
            _require_equal(ours.get(key), theirs.get(key), f"{where}.{key}")
    elif isinstance(ours, list) and isinstance(theirs, list) and len(ours) == len(theirs):
        for i, (mine, yours) in enumerate(zip(ours, theirs)):
            _require_equal(mine, yours, f"{where}[{i}]")
    elif ours != theirs or isinstance(ours, bool) is not isinstance(theirs, bool):
        if isinstance(ours, str) and isinstance(theirs, str):
            ours, theirs = _from_difference(ours, theirs)
        raise InvalidScene(f"{where} is {shown(theirs)}, but the facts give {shown(ours)}")


def _from_difference(one: str, other: str) -> tuple[str, str]:
    """Both texts from a few words before they part, as long as a message shows."""
    same = [*takewhile(lambda both: both[0] == both[1], zip(one, other))]
    begin = max(0, len(same) - 20)
    told = slice(begin, begin + 50)
    return one[told], other[told]


def _record_again(trace: Trace) -> Trace:
    """The same run, with its axes in the numbers of these shapes, and no more left out than is true."""
    try:
        return record(trace.a, trace.b, axes=trace.shortcut or trace.choice, every_axis=trace.every_axis)
    except InvalidScene:
        raise
    except ValueError as error:
        raise InvalidScene(f"trace.axes: {error}") from None


def _sources(choice: Choice) -> tuple[list[Source], list[object]]:
    return [axis.source for axis in choice.axes], [(skip.axis.source, skip.why, skip.number) for skip in choice.skipped]


def _require_same_run(trace: Trace, again: Trace, where: str) -> None:
    """Measured again, numbers may differ by a rounding of another machine; signs and everything else may not."""
    if _sources(trace.choice) != _sources(again.choice):
        raise InvalidScene(f"{where}.axes are not those of these shapes")
    _require_equal(again.choice.complete, trace.choice.complete, f"{where}.complete")
    _require_equal(again.every_axis, trace.every_axis, f"{where}.every_axis")
    if len(trace.tests) != len(again.tests):
        raise InvalidScene(f"{where}.tests has {len(trace.tests)} tests where the run has {len(again.tests)}")
    rounding = ROUNDING if trace.proves else FLOAT_ROUNDING
    # beyond float64 a circle's is infinite
    reach_a, reach_b = (min(shape.max_coordinate, MAX_FLOAT) for shape in (trace.a, trace.b))
    reach = max(reach_a, reach_b)
    for i, (test, ours) in enumerate(zip(trace.tests, again.tests)):
        same_sign = (test.gap > 0) == (ours.gap > 0) and (test.gap < 0) == (ours.gap < 0)
        exact = trace.proves and max(abs(test.gap), abs(ours.gap)) <= reach * CLOSE_GAP_FACTOR  # and rounded once
        room = abs(ours.gap) * 2.0**-50 if exact else reach * rounding
        if not same_sign or not _all_near((test.gap,), (ours.gap,), room):
            raise InvalidScene(f"{where}.tests[{i}].gap is {test.gap}, but the shapes give {ours.gap}")
        for name, own, mine, other in ("a", reach_a, test.a, ours.a), ("b", reach_b, test.b, ours.b):
            room = max((own if trace.proves else reach) * rounding, MIN_FLOAT)
            flat = [c for p in mine.points for c in p], [c for p in other.points for c in p]
            if not (_all_near(*flat, room) and _all_near(mine.landings, other.landings, room)):
                raise InvalidScene(f"{where}.tests[{i}].{name} is not where these shapes land")


def _all_near(mine: Any, ours: Any, room: float) -> bool:
    return len(mine) == len(ours) and all(abs(m - o) <= room or m == o for m, o in zip(mine, ours))
