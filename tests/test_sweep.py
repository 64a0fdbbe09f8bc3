"""Tests of sweeps: the axis rotates, and marks move from step to step."""

import pytest

import satviz as sv
from satviz.cli import main
from satviz.pictures.caption import add_captions
from satviz.pictures.curve import gap_at, unit_vector
from satviz.pictures.float_geometry import range_along
from satviz.pictures.moves import animation, in_between
from satviz.pictures.playback import picture_playback
from satviz.scenes.named import ALL_SCENES


@pytest.mark.parametrize("name", [scene.name for scene in ALL_SCENES])
def test_while_an_axis_turns_no_shape_and_no_name_moves(name):
    frames = sv.sweep(name, step=30)
    assert len(frames) == 7 and len({frame.limits for frame in frames}) == 1
    for part in "outline", "name", "angle", "dial":
        marks = {tuple(mark for mark in frame.marks if mark.part == part) for frame in frames}
        assert len(marks) == 1, part
    for frame in frames:
        x0, y0, x1, y1 = frame.limits
        assert all(x0 <= p.x <= x1 and y0 <= p.y <= y1 for mark in frame.marks for p in mark.points)
        assert len({mark.id for mark in frame.marks}) == len(frame.marks)


@pytest.mark.parametrize("name", ["triangles", "circles", "circle-polygon", "aabb"])
def test_bars_sign_and_dial_show_the_gap_of_the_axis(name):
    a, b = sv.scene(name).a, sv.scene(name).b
    scales = set()
    for degree, frame in zip(range(0, 181, 15), sv.sweep(a, b, step=15), strict=True):
        gap = gap_at(a, b, degree)
        parts = {mark.part for mark in frame.marks}
        assert ("gap" in parts) is (gap > 0) and ("overlap" in parts) is (gap < 0)
        assert frame.mark("says").text.startswith(f"{degree}\N{DEGREE SIGN}: ")
        p, q = frame.mark("needle").points
        assert (q.x - p.x) ** 2 + (q.y - p.y) ** 2 == pytest.approx(84**2)
        (p, q) = frame.mark("A.range").points
        angle = range_along(a, unit_vector(float(degree)))
        scales.add(round(((q.x - p.x) ** 2 + (q.y - p.y) ** 2) ** 0.5 / (angle.hi - angle.lo), 6))
    assert len(scales) == 1


def test_dial_and_curve_share_one_playhead_and_the_curve_draws_itself():
    frames = sv.sweep("triangles", step=45)
    heads = [frame.mark("playhead").points[0].x for frame in frames]
    assert (
        heads == sorted(heads)
        and [frame.mark(f"angle.{45 * i}").points[0].x for i, frame in enumerate(frames)] == heads
    )
    drawn = [sum(m.part == "candidate" for m in frame.marks) for frame in frames]
    assert drawn == sorted(drawn) and drawn[0] == 0 and drawn[-1] == 5
    sectors = [mark for mark in frames[0].marks if mark.part == "sector"]
    assert sectors and not [mark for mark in sv.sweep("concave")[0].marks if mark.part == "sector"]


@pytest.mark.parametrize("step", [0, -3, 7, 2.5, True, "3"])
def test_a_step_of_a_sweep_divides_180(step):
    with pytest.raises(ValueError, match="divides 180"):
        sv.sweep("triangles", step=step)


def test_a_sweep_is_a_playback_and_a_page():
    show = picture_playback(sv.scene("triangles").record(), sv.sweep("triangles"), turns=True)
    assert len(show["steps"]) == 61 and not show["rows"] and not show["asks"]
    page = sv.page("triangles", sweep=True)
    assert page.count('"stage":"sweep"') == 61


def test_a_move_begins_where_the_mark_was_and_ends_where_it_goes():
    trace = sv.scene("triangles").record()
    before, after = sv.picture(trace, sv.Step(sv.Stage.AXIS, 0)), sv.picture(trace, sv.Step(sv.Stage.DROPS, 0))
    start, end = in_between(before, after, 0.0), in_between(before, after, 1.0)
    assert start.mark("B.drop.1.0").points[1] == after.mark("B.drop.1.0").points[0]  # out of the corner
    assert end.mark("B.drop.1.0") == after.mark("B.drop.1.0")
    assert set(end.marks) <= set(after.marks)
    assert start.mark("B.outline") == before.mark("B.outline")


def test_the_animation_of_the_triangles_takes_less_than_20_seconds_and_has_a_speed():
    trace = sv.scene("triangles").record()
    pictures = [sv.picture(trace, step) for step in sv.steps(trace)]
    times = animation(pictures).times
    assert sum(times) < 20_000 - 2_000  # the last picture stays longer
    assert sum(animation(pictures, speed=2).times) == pytest.approx(sum(times) / 2, rel=0.02)


@pytest.mark.parametrize("name", ["triangles", "aabb", "circles", "concave", "circle-polygon", "far-centers", "dart"])
def test_an_animation_leaves_time_to_read_its_words_at_20_letters_a_second(name):
    trace = sv.scene(name).record()
    pictures = add_captions([sv.picture(trace, step) for step in sv.steps(trace)], brief=True)
    shown = iter(zip(*animation(pictures), strict=True))
    for picture in pictures:
        text = picture.mark("caption").text
        assert 3 < len(text) < 40
        ms = 0
        for frame, lasts in shown:  # the frames of a move have the words of the step that they lead to
            assert frame.mark("caption").text == text
            ms += lasts
            if frame is picture:
                break
        assert ms >= 50 * len(text)


@pytest.mark.parametrize("speed", ["0", "-1", "x", "nan", "21"])
def test_a_speed_is_a_number_within_limits(speed, capsys):
    with pytest.raises(SystemExit):
        main(["draw", "triangles", "--format", "gif", "--speed", speed])
    assert "is not a speed" in capsys.readouterr().err


def test_speed_is_refused_without_an_animation(capsys):
    assert main(["draw", "triangles", "--speed", "2"]) == 2
    assert "--speed is for an animation or a page" in capsys.readouterr().err
