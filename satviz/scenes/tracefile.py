"""Trace files: a trace as JSON and back, with what was measured and what follows from it, which `load` checks.

The argument `where` names a field of the file in error lines, such as "trace.tests[0]".
"""

import json
from dataclasses import replace
from itertools import takewhile
from math import hypot
from typing import Any

from ..engine import axes, describe, number_format
from ..engine.axes import Axis, Choice, Skip, Source
from ..engine.geometry import InvalidScene, InvalidShape, Vec
from ..engine.mtv import ends_overlap
from ..engine.polygon_validation import parse_number, short_repr
from ..engine.predicates import MAX_FLOAT, MIN_FLOAT
from ..engine.sat import CLOSE_GAP_FACTOR, AxisTest, Projection
from ..engine.shapes import Shape
from ..engine.shortcut import Shortcut
from ..engine.trace import DEFAULT_NAMES, ShapeNames, Trace, record
from .failing import SHORTCUTS
from .scenefile import shape_data, shape_from
from .strictjson import parse, refuse_large, require_keys, require_type

MAX_CHARS = 1 << 26
# By how much a landing may differ on another machine, whose square roots are rounded differently, relative to the
# largest coordinate: 2 * 13 u with u = 2**-53 (see sat.CLOSE_GAP_FACTOR), rounded up to 128 u.
ROUNDING = 2.0**-46
FLOAT_ROUNDING = 2.0**-28  # the same for what is computed in floats alone: a shortcut's measure, the MTV of parts


def dump(trace: Trace, indent: int | None) -> str:
    """Return a trace as JSON text; InvalidScene for a shortcut not in SHORTCUTS, or a text too large to be read."""
    if trace.shortcut and SHORTCUTS.get(trace.shortcut.name) != trace.shortcut:
        raise InvalidScene(
            f"the shortcut {short_repr(trace.shortcut.name)} is not of satviz, so its trace cannot be saved"
        )
    data = {"satviz": "trace 1", **_trace_data(trace, trace.known_mtv)}
    text = json.dumps(data, indent=indent, ensure_ascii=False, allow_nan=False)
    try:
        refuse_large(text, MAX_CHARS)
    except InvalidScene as error:
        raise InvalidScene(f"the trace is too large for a file that can be read again: {error}") from None
    return text


def load(text: str) -> Trace:
    """Return the trace in the text of a trace file, after checking it against the run recorded anew.

    The run is recorded again from the two shapes, in bounded time; InvalidScene where the file differs from it.
    """
    data = dict(require_keys(parse(text, MAX_CHARS), "the trace", {"satviz"}, _KEYS))
    if data.pop("satviz") != "trace 1":
        raise InvalidScene('this is not a trace file of this version: the key "satviz" must have the value "trace 1"')
    require_keys(data, "trace", _KEYS)
    a, b = (shape_from(data[name], f"trace.{name}") for name in ("a", "b"))
    shortcut = _parse_shortcut(data["shortcut"])
    pairs = require_type(data["pairs"], "trace.pairs", list)
    if pairs or (shortcut and shortcut.split):
        every_axis = require_type(data["every_axis"], "trace.every_axis", bool)
        again = record(a, b, axes=shortcut or axes.needed, every_axis=every_axis)
        if len(pairs) != len(again.pairs):
            raise InvalidScene(
                f"trace.pairs has {len(pairs)} pairs, but the shapes have {len(again.pairs)} pairs of convex parts: "
                "record the trace again"
            )
        found = zip(pairs, again.pairs, strict=True)
        trace = replace(
            again, pairs=tuple(_parse_pair(pair, f"trace.pairs[{i}]", ours) for i, (pair, ours) in enumerate(found))
        )
    else:
        trace = _parse_run(data, "trace", a, b, DEFAULT_NAMES, shortcut)
        _require_same_run(trace, _record_again(trace), "trace")
    _require_equal(_trace_data(trace, _accepted_mtv(trace, data["mtv"])), data, "trace")
    return trace


def _parse_shortcut(name: Any) -> Shortcut | None:
    """Return the shortcut of this name; None for null, InvalidScene for an unknown name."""
    if name is None:
        return None
    if require_type(name, "trace.shortcut", str) not in SHORTCUTS:
        raise InvalidScene(f"trace.shortcut is {short_repr(name)}: choose the name of a shortcut of satviz")
    return SHORTCUTS[name]


def _parse_pair(data: Any, where: str, ours: Trace) -> Trace:
    """Return the file's trace of one pair of parts; InvalidScene unless it agrees with `ours`, recorded anew."""
    trace = _parse_run(data, where, ours.a, ours.b, ours.names)
    _require_same_run(trace, ours, where)
    return trace


def _accepted_mtv(trace: Trace, data: Any) -> Vec | None:
    """Return the file's MTV (`data`) if it is as good as the recomputed one (for concave outlines), else the latter.

    Where two moves are equally short, rounding decides which one a machine finds.
    """
    ours = trace.known_mtv
    if not trace.pairs or not ours or data is None:
        return ours
    theirs = _parse_vector(data, "trace.mtv")
    as_short = hypot(*theirs) <= hypot(*ours) * (1 + FLOAT_ROUNDING)
    return theirs if as_short and ends_overlap(trace.a, trace.b, theirs) else ours


def _axis_data(axis: Axis) -> dict[str, object]:
    """Return an axis as the object that a trace file stores: normal, length and source."""
    kind, shape, ids = axis.source
    source = {"kind": kind, "shape": shape, "vertices": list(ids)}
    return {"normal": list(axis.normal), "length": axis.length, "source": source}


def _projection_data(side: Projection) -> dict[str, object]:
    """Return a projection as the object that a trace file stores: points, landings and interval."""
    points = [list(p) for p in side.points]
    return {"points": points, "landings": list(side.landings), "interval": list(side.interval)}


def _test_data(test: AxisTest) -> dict[str, object]:
    """Return a test as the object that a trace file stores: both projections, the gap, and if it separates."""
    a, b = _projection_data(test.a), _projection_data(test.b)
    return {"a": a, "b": b, "gap": test.gap, "separates": test.separates}


def _trace_data(trace: Trace, mtv: Vec | None) -> dict[str, object]:
    """Return a trace as the object that a trace file stores; `mtv`: the MTV to write into it."""
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
        "sentence": number_format.ascii_minus(describe.verdict_sentence(trace, mtv)),
    }


_LISTS = ["axes", "skipped", "tests", "pairs"]
_KEYS = {"a", "b", "names", "shortcut", "every_axis", "complete", *_LISTS}
_KEYS |= {"claim", "relation", "hit", "mtv", "sentence"}


def _parse_run(data: Any, where: str, a: Shape, b: Shape, names: ShapeNames, shortcut: Shortcut | None = None) -> Trace:
    """Return the Trace with the file's numbers, not yet checked against the shapes; `where`: its field's name."""
    require_keys(data, where, _KEYS)
    lists = {name: list(enumerate(require_type(data[name], f"{where}.{name}", list))) for name in _LISTS}
    known = axes.axes_by_source(a, b)
    if shortcut:
        known |= {axis.source: axis for axis in shortcut.choose(a, b).axes}
    found = tuple(_parse_axis(axis, f"{where}.axes[{i}]", known) for i, axis in lists["axes"])
    parallel = [(axes.PARALLEL, i) for i in range(1, len(found) + 1)]
    reasons = {describe.reason(*skip): skip for skip in [(axes.NO_DIRECTION, None), *parallel]}
    skipped = []
    for i, skip in lists["skipped"]:
        require_keys(skip, f"{where}.skipped[{i}]", {"axis", "reason"})
        reason = require_type(skip["reason"], f"{where}.skipped[{i}].reason", str)
        if reason not in reasons:
            raise InvalidScene(f"{where}.skipped[{i}].reason {short_repr(reason)} is unknown: save a new trace")
        skipped.append(Skip(_parse_axis(skip["axis"], f"{where}.skipped[{i}].axis", known), *reasons[reason]))
    if len(lists["tests"]) > len(found):
        raise InvalidScene(f"{where}.tests has {len(lists['tests'])} tests for {len(found)} axes: save a new trace")
    tests = tuple(_parse_test(test, f"{where}.tests[{i}]", found[i]) for i, test in lists["tests"])
    choice = Choice(found, tuple(skipped), require_type(data["complete"], f"{where}.complete", bool))
    every_axis = require_type(data["every_axis"], f"{where}.every_axis", bool)
    return Trace(a, b, choice, tests, every_axis, (), names, shortcut)


def _parse_axis(data: Any, where: str, known: dict[Source, Axis]) -> Axis:
    """Return the file's axis; InvalidScene unless its source, direction and length are those of a known axis."""
    require_keys(data, where, {"normal", "length", "source"})
    source_data = require_keys(data["source"], f"{where}.source", {"kind", "shape", "vertices"})
    ids = tuple(
        require_type(i, f"{where}.source.vertices", int)
        for i in require_type(source_data["vertices"], f"{where}.source", list)
    )
    kind, role = require_type(source_data["kind"], f"{where}.source.kind", str), source_data["shape"]
    source = Source(kind, role if role is None else require_type(role, f"{where}.source.shape", str), ids)
    axis = Axis(
        _parse_vector(data["normal"], f"{where}.normal"), _parse_float(data["length"], f"{where}.length"), source
    )
    if kind == axes.GIVEN and role is None and len(ids) == 1 and any(axis.normal):
        ours: Axis | None = axes.given_axis(axis.normal, ids[0])
    else:
        ours = known.get(source)
    if ours is None:
        raise InvalidScene(
            f"{where}.source does not fit these shapes: check its kind, its shape and its vertex numbers"
        )
    if not axes.same_axis(axis, ours):
        raise InvalidScene(
            f"{where} has another direction or length than its edge or line, which `source` names: "
            "record the trace again"
        )
    return axis


def _parse_test(data: Any, where: str, axis: Axis) -> AxisTest:
    """Return the AxisTest that the file gives for an axis; its numbers are not yet checked."""
    require_keys(data, where, {"a", "b", "gap", "separates"})
    a, b = (_parse_projection(data[side], f"{where}.{side}") for side in ("a", "b"))
    return AxisTest(axis, a, b, _parse_float(data["gap"], f"{where}.gap"))


def _parse_projection(data: Any, where: str) -> Projection:
    """Return the Projection that the file gives; its numbers are not yet checked."""
    require_keys(data, where, {"points", "landings", "interval"})
    points = tuple(_parse_vector(p, f"{where}.points") for p in require_type(data["points"], f"{where}.points", list))
    landings = tuple(
        _parse_float(v, f"{where}.landings") for v in require_type(data["landings"], f"{where}.landings", list)
    )
    return Projection(points, landings)


def _parse_vector(data: Any, where: str) -> Vec:
    """Return a Vec from a list of two finite numbers; InvalidScene for anything else."""
    if not isinstance(data, list) or len(data) != 2:
        raise InvalidScene(f"{where} must be a pair of numbers")
    return Vec(*(_parse_float(v, where) for v in data))


def _parse_float(value: Any, where: str) -> float:
    """Return a finite number as a float, also from an integer, since JSON writers may omit the ".0"."""
    try:
        return parse_number(value, where)
    except InvalidShape as error:
        raise InvalidScene(str(error)) from None


def _require_equal(ours: Any, theirs: Any, where: str) -> None:
    """Raise InvalidScene, which names the field, unless the file's data (theirs) equal the recomputed data (ours)."""
    if isinstance(ours, dict) and isinstance(theirs, dict):
        for key in {**ours, **theirs}:
            _require_equal(ours.get(key), theirs.get(key), f"{where}.{key}")
    elif isinstance(ours, list) and isinstance(theirs, list) and len(ours) == len(theirs):
        for i, (mine, yours) in enumerate(zip(ours, theirs)):
            _require_equal(mine, yours, f"{where}[{i}]")
    elif ours != theirs or isinstance(ours, bool) is not isinstance(theirs, bool):
        if isinstance(ours, str) and isinstance(theirs, str):
            ours, theirs = _from_difference(ours, theirs)
        raise InvalidScene(
            f"{where} is {short_repr(theirs)}, but the shapes and options in the file give {short_repr(ours)}"
        )


def _from_difference(one: str, other: str) -> tuple[str, str]:
    """Return an excerpt of each text, 50 letters long, that shows their first difference."""
    same = [*takewhile(lambda both: both[0] == both[1], zip(one, other))]
    begin = max(0, len(same) - 20)
    excerpt = slice(begin, begin + 50)
    return one[excerpt], other[excerpt]


def _record_again(trace: Trace) -> Trace:
    """Record the run of a trace anew from its shapes, and return it; InvalidScene if its axes do not fit them."""
    try:
        return record(trace.a, trace.b, axes=trace.shortcut or trace.choice, every_axis=trace.every_axis)
    except InvalidScene:
        raise
    except ValueError as error:
        raise InvalidScene(f"trace.axes: {error}") from None


def _sources(choice: Choice) -> tuple[list[Source], list[object]]:
    """Return the sources of the chosen axes, and (source, reason, number) of each skipped one."""
    return [axis.source for axis in choice.axes], [(skip.axis.source, skip.why, skip.number) for skip in choice.skipped]


def _require_same_run(trace: Trace, again: Trace, where: str) -> None:
    """Raise InvalidScene unless a trace equals the run that was recorded again.

    Numbers may differ by the rounding of another machine; signs and everything else may not.
    """
    if _sources(trace.choice) != _sources(again.choice):
        raise InvalidScene(f"{where}.axes are not the axes of these shapes: record the trace again")
    _require_equal(again.choice.complete, trace.choice.complete, f"{where}.complete")
    _require_equal(again.every_axis, trace.every_axis, f"{where}.every_axis")
    if len(trace.tests) != len(again.tests):
        raise InvalidScene(f"{where}.tests has {len(trace.tests)} tests, not {len(again.tests)}: save a new trace")
    rounding = ROUNDING if trace.gaps_are_proofs else FLOAT_ROUNDING
    # the largest coordinate of a circle that reaches beyond float64 is infinite
    max_a, max_b = (min(shape.max_coordinate, MAX_FLOAT) for shape in (trace.a, trace.b))
    max_coordinate = max(max_a, max_b)
    for i, (test, ours) in enumerate(zip(trace.tests, again.tests)):
        same_sign = (test.gap > 0) == (ours.gap > 0) and (test.gap < 0) == (ours.gap < 0)
        # a close gap is computed exactly and rounded once
        exact = trace.gaps_are_proofs and max(abs(test.gap), abs(ours.gap)) <= max_coordinate * CLOSE_GAP_FACTOR
        tolerance = abs(ours.gap) * 2.0**-50 if exact else max_coordinate * rounding
        if not same_sign or not _all_near((test.gap,), (ours.gap,), tolerance):
            raise InvalidScene(f"{where}.tests[{i}].gap is {test.gap}, but the shapes give {ours.gap}: save a new one")
        for name, own_max, mine, other in ("a", max_a, test.a, ours.a), ("b", max_b, test.b, ours.b):
            tolerance = max((own_max if trace.gaps_are_proofs else max_coordinate) * rounding, MIN_FLOAT)
            flat = [c for p in mine.points for c in p], [c for p in other.points for c in p]
            if not (_all_near(*flat, tolerance) and _all_near(mine.landings, other.landings, tolerance)):
                raise InvalidScene(f"{where}.tests[{i}].{name} is not the projection of these shapes: save a new trace")


def _all_near(mine: Any, ours: Any, tolerance: float) -> bool:
    """Return whether two sequences have one length and no two numbers differ by more than the tolerance."""
    return len(mine) == len(ours) and all(abs(m - o) <= tolerance or m == o for m, o in zip(mine, ours))
