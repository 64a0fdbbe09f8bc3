"""Functions as other people write them, from `own_functions/others`: each mistake is named, no right one is refused."""

import inspect
import shutil
import subprocess
from pathlib import Path

import pytest
from own_functions.others import right, wrong

import satviz as sv
from satviz.checking.checker import check_asker
from satviz.checking.options import Options
from satviz.checking.programs import Program

OTHERS = Path(__file__).parent / "own_functions" / "others"
DENTS = {"kinds": ("boxes", "convex", "concave")}
MISTAKES = {
    "game_jam_boxes": ("aabb-not-upright", {}),
    "classes_second_first": ("one-shapes-normals", {}),
    "any_for_all": ("one-overlap", {}),
    "stops_before_the_last_edge": ("open-outline", {}),
    "saves_half": ("half-the-normals", {}),
    "compass_points": ("extremes-once", {}),
    "complex_conjugate": ("slipped-normal", {}),
    "vector_projection": ("lengths", {}),
    "axes_along_the_edges": ("line-for-axis", {}),
    "quick_reject": ("far-centers", {}),
    "twins": ("same-shape", {}),
    "strict": ("touch-as-apart", {}),
    "depth_of_any_length": ("raw-depth", {}),
    "some_corner_inside": ("corner-inside", {}),
    "some_middle_inside": ("corner-inside", {}),
    "borders_meet": ("edges-cross", {}),
    "circles_round_them": ("bounding-circles", {}),
    "one_comparison": ("one-sided-gap", {}),
    "one_comparison_of_boxes": ("one-sided-gap", {}),
    "depth_from_one_side": ("one-sided-gap", {}),
    "pushed_along_the_normal": ("push-along-normal", {}),
    "without_the_minus": ("slipped-normal", {}),
    "without_the_first_edge": ("open-outline", {}),
    "else_in_the_loop": ("one-overlap", {}),
    "overwritten": ("one-overlap", {}),
    "largest_from_zero": ("start-at-zero", {}),
    "extents_about_the_middle": ("bounding-circles", {}),
    "line_of_middles": ("one-overlap", {}),
    "corner_of_a_inside": ("corner-inside", {}),
    "an_end_of_b_within": ("corner-inside", {}),
    "counter_clockwise_or_not": ("edges-cross", {}),
    "squares_and_sum": ("circles-turned-round", {"kinds": "circles"}),
    "corners_and_center": ("corner-inside", {"kinds": "circle and polygon"}),
    "whole_half_sizes": ("integer-halves", {}),
    "tidy_normals": ("rounded-normals", {}),
    "angle_plus_90": ("degrees-for-radians", {}),
    "separated": ("circles-turned-round", {}),
    "argmax": ("largest-overlap", {}),
    "the_last_is_kept": ("largest-overlap", {}),
    "shared_fairly": ("half-the-way", {}),
    "divided_at_the_end": ("raw-depth", {}),
    "push_along_centers.js": ("push-from-center", {}),
    "circle_sign.js": ("circles-turned-round", {"kinds": "circles"}),
    "circle_and_edges.js": ("no-nearest-vertex", {"kinds": "circle and polygon"}),
    "any_outline.js": ("dart", DENTS),
    "normalised.js": ("unit-normals", {}),
    "inner_ends.cpp": ("range-inside", {}),
    "outward_each.cpp": ("mixed-signs", {}),
}
RIGHT = [
    name
    for name, fn in vars(right).items()
    if inspect.isfunction(fn) and fn.__module__ == right.__name__ and not name.startswith("_")
]
RIGHT_OPTIONS = {
    "two_circles": {"kinds": "circles"},
    "circle_and_outline": {"kinds": "circle and polygon"},
    "ears": DENTS,
    "outlines_or_insides": {"kinds": (*DENTS["kinds"], "repeated")},
    "interiors_meet": {"touching": "miss"},
}
SECONDS = 5  # in which a mistake is to be found; a check that is stopped says so


def checked(name, folder, more):
    """Check a function of wrong.py, or a program made of a file in another language."""
    source, harness = OTHERS / name, OTHERS.parent
    if source.suffix == ".js":
        if shutil.which("node") is None:
            pytest.skip("no node is installed")
        program = folder / name
        program.write_text(source.read_text() + (harness / "harness.js").read_text())
        return check_asker(Program(f"node {program}", SECONDS), Options(seconds=SECONDS, **more))
    if source.suffix == ".cpp":
        if shutil.which("g++") is None:
            pytest.skip("no g++ is installed")
        program = folder / source.stem
        subprocess.run(["g++", "-std=c++17", "-I", harness, "-o", program, source], check=True, timeout=120)
        return check_asker(Program(str(program), SECONDS), Options(seconds=SECONDS, **more))
    return sv.check(getattr(wrong, name), seconds=SECONDS, **more)


QUICK = "axes_along_the_edges"


@pytest.mark.parametrize(
    "name", [name if name == QUICK else pytest.param(name, marks=pytest.mark.slow) for name in MISTAKES]
)
def test_a_mistake_is_named_however_it_is_written(name, tmp_path):
    mistake, more = MISTAKES[name]
    found = checked(name, tmp_path, more)
    assert found.finding == "wrong" and found.behaves_like[0].name == mistake, str(found)
    assert found.behaves_like[0].is_close and not found.unasked
    shapes = found.counterexample.a, found.counterexample.b
    assert sum(len(shape.vertices) for shape in shapes) <= 8
    assert all(x == int(x) for shape in shapes for point in shape.core for x in (*point, shape.radius))
    assert not any(len(set(shape.vertices)) < len(shape.vertices) for shape in shapes)  # it was asked about none such


@pytest.mark.parametrize(
    "name", [name if name == "gjk" else pytest.param(name, marks=pytest.mark.slow) for name in RIGHT]
)
def test_a_right_function_is_right_however_it_is_written(name):
    found = sv.check(getattr(right, name), **RIGHT_OPTIONS.get(name, {}))
    assert found.right and not found.unasked and found.line == "", str(found)
