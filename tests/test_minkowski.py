"""The Minkowski difference B - A against the origin shows the same relation as the shapes themselves."""

from random import Random

import pytest
from speeds import one_in

import satviz as sv
from satviz.engine.describe import RELATION_PHRASES
from satviz.pictures.float_geometry import circle_points, midpoint
from satviz.scenes.named import ALL_SCENES
from satviz.scenes.shape_tools import box

TRIANGLE = sv.Polygon([(3, 1), (6, 0), (5, 3)])


def side_of_rim(ring, p):
    """Return 1 for a point inside a convex counter-clockwise ring, 0 on its rim, -1 outside."""
    sides = [(q.x - r.x) * (p.y - r.y) - (q.y - r.y) * (p.x - r.x) for r, q in zip(ring, (*ring[1:], ring[0]))]
    return (min(sides) > 1e-12) - (min(sides) < -1e-12)


@pytest.mark.parametrize(
    "b, where",
    [(TRIANGLE, 1), (sv.Polygon([(4, 0), (6, 0), (6, 2)]), 0), (sv.Polygon([(5, 0), (7, 0), (7, 2)]), -1)],
    ids=["overlapping", "touching", "apart"],
)
def test_the_place_of_the_origin_in_b_minus_a_follows_the_relation(b, where):
    trace = sv.record(box(0, 0, 4, 2), b)
    drawn = sv.difference(trace)
    assert side_of_rim(drawn.mark("difference.0").points, sv.Vec(0, 0)) == where
    assert drawn.mark("verdict").text == str(trace.relation)
    assert ["outside", "on the rim of", "inside"][where + 1] in drawn.sentence


def test_the_mtv_leads_from_the_boundary_to_the_origin():
    trace = sv.record(box(0, 0, 4, 2), TRIANGLE)
    tail, tip = sv.difference(trace).mark("mtv").points
    assert tip == (0, 0) and (-tail.x, -tail.y) == trace.mtv
    assert side_of_rim(sv.difference(trace).mark("difference.0").points, tail) == 0


def test_the_gap_is_how_far_the_origin_is_from_the_side_along_the_separating_axis():
    trace = sv.record(box(0, 0, 1, 1), sv.Circle((1.8, 1.8), 1), every_axis=True)
    drawn = sv.difference(trace)
    origin, foot = drawn.mark("gap").points
    assert origin == (0, 0) and (foot.x**2 + foot.y**2) ** 0.5 == pytest.approx(max(t.gap for t in trace.tests))
    assert side_of_rim(drawn.mark("difference.0").points, sv.Vec(foot.x * 1.02, foot.y * 1.02)) == 1  # a rounded corner
    assert "nearest vertex a3" in drawn.sentence


def test_every_scene_has_the_picture_also_circles_and_concave_ones():
    for scene in ALL_SCENES:
        trace = scene.record()
        drawn = sv.difference(trace)
        parts = len(sv.parts(trace.a)) * len(sv.parts(trace.b))
        assert len([m for m in drawn.marks if m.part == "difference"]) == parts
        assert str(trace.relation) in (mark.text for mark in drawn.marks) and drawn.sentence.endswith(".")
    sv.draw(drawn)


def test_one_shape_has_no_difference():
    with pytest.raises(TypeError, match="two shapes"):
        sv.difference(box(0, 0, 1, 1))


def test_the_explorer_shows_the_difference_beside_the_pair_on_request():
    from satviz.widgets.explorer_model import ExplorerModel

    explorer = ExplorerModel(sv.scene("triangles"))
    state = explorer.state()
    assert "difference" not in state
    pose = {"kind": "pose", "n": 1, "a": state["a"], "b": state["b"], "difference": True}
    assert explorer.answer(pose)["difference"]["sentence"].startswith("The origin lies outside B \u2212 A")


@pytest.mark.parametrize("seed", range(12))
def test_the_gap_lies_on_the_canvas_and_the_difference_is_seen_however_far_and_small(seed):
    rng = Random(seed)
    far = 10.0 ** rng.uniform(0, 9)
    x, y = far * rng.uniform(-1, 1), far * rng.uniform(-1, 1)
    b = sv.Polygon([(x, y), (x + 1, y + rng.uniform(-2, 2)), (x + rng.random(), y + 3)])
    drawn = sv.difference(sv.record(box(0, 0, 2, 1), b))
    x0, y0, x1, y1 = drawn.limits
    seen = [m for m in drawn.marks if m.part.startswith("difference") and m.kind != "label"]
    assert all(x0 <= p.x <= x1 and y0 <= p.y <= y1 for m in drawn.marks for p in m.points)
    size = max(abs(p.x - q.x) + abs(p.y - q.y) for p in seen[0].points for q in seen[0].points) * drawn.scale
    assert size >= 8 or seen[1].kind == "dot"


@pytest.mark.parametrize(
    "name", one_in(3, ["concave", "circle-polygon", "circles", "triangles", "gap-as-distance", "touch-as-apart"])
)
def test_during_the_construction_of_b_minus_a_the_shapes_stay_and_the_reflected_a_covers_only_the_difference(name):
    trace = sv.scene(name).record()
    steps = sv.difference_steps(trace)
    assert len({step.limits for step in steps}) == 1 and len({step.mark("B.outline") for step in steps}) == 1
    rings = [m.points for m in sv.difference(trace.a, trace.b).marks if m.part == "difference"]
    whole = next(step for step in steps if any(m.part == "difference" for m in step.marks))
    assert [m.points for m in whole.marks if m.part == "difference"] == rings
    assert f"so A and B {RELATION_PHRASES[trace.relation]}." in whole.sentence
    every = [p for step in steps for m in step.marks if m.part == "covered" for p in m.points]
    assert every
    for p in every:
        assert max(depth_in_ring(ring, p) for ring in rings) > -0.01  # circles are drawn as polygons
    if len(rings) == 1 and trace.a.vertices and trace.b.vertices:  # every corner of B - A is passed
        close = [min((p.x - q.x) ** 2 + (p.y - q.y) ** 2 for q in every) for p in rings[0]]
        assert max(close) < 1e-18
    for step in steps:
        assert len({mark.id for mark in step.marks}) == len(step.marks)


@pytest.mark.parametrize("a", [sv.Circle((0, 0), 1), box(-1, 0, 1, 1)], ids=["circle", "box"])
@pytest.mark.parametrize(
    "b", [sv.Circle((4, 1), 2), sv.Polygon(circle_points(sv.Vec(4.0, 1.0), 2.0, 40))], ids=["circle", "40-gon"]
)
def test_the_reflected_a_moves_along_the_boundary_of_b_and_not_along_chords(a, b):
    last = [mark for step in sv.difference_steps(a, b) for mark in step.marks if mark.part == "covered"][-1]
    for ring in (m.points for m in sv.difference(a, b).marks if m.part == "difference"):
        for corner in ring:  # what the difference is, at most a hair's breadth of a circle drawn as a polygon less
            assert min((corner.x - p.x) ** 2 + (corner.y - p.y) ** 2 for p in last.points) < 0.2**2
        middles = [midpoint(p, q) for p, q in zip(ring, (*ring[1:], ring[0]), strict=True)]
        n = [sv.Vec(m.x - 4, m.y - 1) for m in middles]
        for out, m in zip(n, middles, strict=True):
            reach = max(out.x * p.x + out.y * p.y for p in last.points) - out.x * m.x - out.y * m.y
            assert reach > -0.02 * (out.x**2 + out.y**2)


def depth_in_ring(ring, p):
    """Return the distance of p from the nearest edge line of a counter-clockwise ring, positive inside."""
    edges = zip(ring, (*ring[1:], ring[0]), strict=True)
    return min(
        ((q.x - r.x) * (p.y - r.y) - (q.y - r.y) * (p.x - r.x)) / ((q.x - r.x) ** 2 + (q.y - r.y) ** 2) ** 0.5
        for r, q in edges
    )


@pytest.mark.parametrize("far", [0.0, 1e7])
def test_the_range_of_b_minus_a_is_the_range_of_b_minus_that_of_a(far):
    a, b = box(far, 0, far + 4, 2), sv.Polygon([(far + x, y) for x, y in TRIANGLE.vertices])
    trace = sv.record(a, b, every_axis=True)
    last = sv.difference_steps(a, b)[-1]
    best = max(trace.tests, key=lambda test: test.gap)
    p, q = last.mark("range").points
    length = ((p.x - q.x) ** 2 + (p.y - q.y) ** 2) ** 0.5
    assert length == pytest.approx(best.b.interval.hi - best.a.interval.lo - best.b.interval.lo + best.a.interval.hi)
    assert last.scale * length > 20
    assert ("next to the origin" in sv.difference_steps(a, b)[0].sentence) is (far > 0)
    assert "that is the overlap" in last.sentence


@pytest.mark.parametrize("y", [0.45913173191066836, 0.926506623785866])
def test_shapes_that_are_moved_next_to_the_origin_keep_their_relation(y):
    """A move along y would round, and the circle would no longer only touch the notch of the L."""
    notch = sv.Polygon([(1000, -3.7), (1003, -3.7), (1003, 0), (1001, 0), (1001, 2), (1000, 2)])
    steps = sv.difference_steps(notch, sv.Circle((1002, y), y))
    assert "next to the origin" in steps[0].sentence and "so A and B touch." in steps[-1].sentence


def test_the_drawing_of_b_minus_a_is_a_choice_of_the_command_line_and_of_a_page(tmp_path, capsys):
    from satviz.cli import main

    assert (
        main(
            [
                "draw",
                "aabb",
                "--difference",
                "--format",
                "svg",
                "--format",
                "html",
                "--speed",
                "0.5",
                "--out",
                str(tmp_path),
            ]
        )
        == 0
    )
    count = len(sv.difference_steps("aabb"))
    assert len(list(tmp_path.glob("aabb-difference-*.svg"))) == count
    page = (tmp_path / "aabb-difference.html").read_text(encoding="utf-8")
    assert page.count('"stage":"difference"') == count and '"speed":0.5' in page
    assert main(["draw", "no-area", "--difference", "--out", str(tmp_path)]) == 2
    assert "--difference" in capsys.readouterr().err
