"""What an explorer shows while a shape is dragged: one number for one thing, in one place, and no label that leaps."""

import random
import re
from functools import lru_cache
from math import cos, dist, pi, sin

import pytest
from speeds import one_in
from test_pictures import boxes, meet

import satviz as sv
from satviz.engine.axis_count import NUMBER_WORDS
from satviz.pictures import theme
from satviz.pictures.curve import gap_at
from satviz.pictures.dial import dial
from satviz.pictures.labels import contains_point
from satviz.scenes.failing import FAILURE_CASES, REFUSED
from satviz.scenes.scenefile import shape_data
from satviz.scenes.shape_tools import translated
from satviz.widgets.explorer_model import ExplorerModel
from satviz.widgets.snapping import snapped

EXPLORED = [scene.name for scene in sv.scenes.article.SCENES] + [c.name for c in FAILURE_CASES if c.how != REFUSED]
STEADY = "triangles", "aabb", "circle-polygon", "circles", "concave", "aabb-turned"
NUMBER = r"-?\d+(?:\.\d+)?(?:e-?\d+)?"


def plain(text):
    return text.replace("\N{MINUS SIGN}", "-")


def poses(name, count=12, step=0.21):
    """Yield the explorer's states while B of a scene is moved to the left and up."""
    model, scene = ExplorerModel(sv.scene(name)), sv.scene(name)
    size = 200 / model.picture().scale
    yield model, model.state()
    for i in range(1, count):
        move = sv.Vec(-step * i * size / count * 3, step * i * size / count)
        pose = {"kind": "pose", "a": shape_data(scene.a), "b": shape_data(translated(scene.b, move)), "final": False}
        state = model.answer(pose | {"n": i})
        if state["kind"] == "state":
            yield model, state


def text_of(state, where, part):
    return [plain(m["text"]) for m in state[where]["marks"] if m["part"] == part]


@pytest.mark.parametrize("name", one_in(6, EXPLORED))
def test_sentence_picture_number_line_and_table_show_the_same_axis_and_number(name):
    for model, state in poses(name):
        if state["lit"] is None or "line" not in state:
            continue
        row = state["rows"][state["lit"]]
        said = plain(row["outcome"])
        assert text_of(state, "line", "outcome") == [said]
        assert text_of(state, "line", "axis-name") == [f"axis {row['number']}"]
        assert text_of(state, "picture", "gap-name") in ([said], [said.replace(", ", ",\n")], [])
        assert set(text_of(state, "picture", "axis-name")) <= {f"axis {row['number']}", "x", "y"} | {
            f"axis {row['number']}\n(not to scale)",
            "x\n(not to scale)",
            "y\n(not to scale)",
        }
        ranges = text_of(state, "line", "range-name")
        assert [text.split(" ", 1)[1] for text in ranges] == [plain(row["a"]), plain(row["b"])]
        if model.trace.shortcut is None and model.trace.separating:
            assert f"axis {row['number']} (" in state["sentence"]
            gap = re.search(rf"gap of ({NUMBER})", plain(state["sentence"]))
            assert gap and said == f"gap +{gap[1]}"
        assert not re.search(r"gap of|leaves a gap", state["enough"])


WAYS = {}, {"pinned": 1}, {"mtv": True}, {"view": "truth"}, {"difference": True}, {"degree": 73.0}
LENGTH = rf"(?:gap \+|gap of |overlap |depth |distance |way out )({NUMBER})"


@lru_cache(maxsize=200)  # two tests read each
def anywhere(seed):
    """Return an explorer's state after random moves of both shapes, with one of the tools in use."""
    rng = random.Random(seed)
    scene = sv.scene(rng.choice(EXPLORED))
    model = ExplorerModel(scene)
    reach = 80 / model.picture().scale
    a, b = (translated(s, sv.Vec(*(rng.uniform(-reach, reach) for _ in "xy"))) for s in (scene.a, scene.b))
    pose = {"kind": "pose", "n": 1, "a": shape_data(a), "b": shape_data(b), "final": rng.random() < 0.5}
    return model.answer(pose | rng.choice(WAYS))


@pytest.mark.parametrize("poses_asked", [80, pytest.param(200, marks=pytest.mark.slow)])
def test_texts_shown_together_name_one_axis_and_print_a_length_with_the_same_digits(poses_asked):
    """The axis is the same in table, picture and number line; a length has the same digits everywhere."""
    spoken_of = 0
    for seed in range(poses_asked):
        state = anywhere(seed)
        if state["kind"] == "refused" or "line" not in state:
            continue
        shown = text_of(state, "line", "outcome")[0]
        drawn = {text.partition("\n")[0] for text in text_of(state, "picture", "axis-name")}
        assert drawn <= {*text_of(state, "line", "axis-name"), "x", "y"}, (seed, drawn)
        assert {text.replace(",\n", ", ") for text in text_of(state, "picture", "gap-name")} <= {shown}, seed
        if state["lit"] is not None:
            row = state["rows"][state["lit"]]
            assert plain(row["outcome"]) == shown and f"axis {row['number']}" in text_of(state, "line", "axis-name")
        spoken = {float(text): text for text in re.findall(LENGTH, shown)}
        said = plain(" ".join([state["sentence"], *state.get("heading", ()), state["enough"]]))
        for text in re.findall(LENGTH, said):
            same = [known for value, known in spoken.items() if abs(value - float(text)) < 0.006 * value]
            assert not same or text in same, (seed, text, shown)
            spoken_of += len(same)
        axes = re.findall(r"\b[Aa]xis (\d+) \(", state["sentence"])
        assert not axes or f"axis {axes[-1]}" in text_of(state, "line", "axis-name"), (seed, state["sentence"])
        tested = sum("reason" not in row for row in state["rows"])
        needed = re.search(r"(\w+) axes are needed here", state["enough"])
        assert not needed or NUMBER_WORDS.index(needed[1]) == tested, (seed, state["enough"])
    assert spoken_of > 0.4 * poses_asked


@pytest.mark.parametrize("poses_asked", [80, pytest.param(400, marks=pytest.mark.slow)])
def test_a_sentence_calls_the_claim_right_only_where_the_heading_does(poses_asked):
    wrong_numbers = 0
    for seed in range(poses_asked):
        state = anywhere(seed)
        heading, said = state.get("heading"), state.get("sentence", "")
        assert heading or "so it is" not in said
        if heading and state["view"] == "shortcut" and said.startswith("By the shortcut"):
            assert ("and so it is." in said) is heading[1].startswith("Here it happens to be right"), (seed, said)
            assert ("In truth" in said or heading[1] in said) is heading[1].startswith("Wrong"), (seed, said)
            wrong_numbers += heading[1] in said
    assert wrong_numbers > poses_asked / 20


@pytest.mark.parametrize("name", one_in(3, STEADY))
def test_numbers_keep_their_places_in_one_drag(name):
    decimals = set()
    for _, state in poses(name):
        for row in state["rows"]:
            for text in (row.get("a", ""), row.get("b", ""), row.get("outcome", "").replace("gap 0", "")):
                decimals |= {len(digits.partition(".")[2]) for digits in re.findall(r"\d+(?:\.\d+)?", text)}
    assert len(decimals) == 1


@pytest.mark.parametrize("name", one_in(3, STEADY))
def test_the_ticks_of_an_axis_stay_where_they_are_in_one_drag(name):
    ticks = {}
    for model, state in poses(name):
        test = model.trace.tests[state["lit"]] if model.trace.tests and state["lit"] is not None else None
        if test is None or test.source.kind in ("centers", "nearest vertex"):
            continue  # such an axis turns with the shapes
        marks = state["line"]["marks"]
        now = {m["number"]: (m["points"][0], m["text"]) for m in marks if m["part"] == "tick-name"}
        assert len(now) >= 4
        assert ticks.setdefault(test.axis.direction, now) == now
    assert ticks or name in ("circles", "concave")


def test_a_number_line_has_the_scale_of_its_picture():
    state = ExplorerModel(sv.scene("triangles")).state()
    (x0, _, x1, _), (width, _) = state["picture"]["limits"], state["picture"]["size"]
    spots = {m["number"]: m["points"][0][0] for m in state["line"]["marks"] if m["part"] == "tick-name"}
    assert spots[1] - spots[0] == pytest.approx(width / (x1 - x0))


@pytest.mark.parametrize("name", ["triangles", "circles", "far-centers", "lengths", "tile-seam"])
@pytest.mark.parametrize("width", [None, 350])
def test_no_labels_of_a_number_line_overlap(name, width):
    model = ExplorerModel(sv.scene(name))
    state = model.state()
    model.answer({"kind": "pose", "n": 1, "a": state["a"], "b": state["b"], "width": width})
    line = model.number_line()
    found = [box for _, box in boxes(line)]
    assert not [(p, q) for i, p in enumerate(found) for q in found[:i] if meet(p, q)]
    assert all(x0 >= 0 and x1 <= line.size[0] for x0, _, x1, _ in found)
    assert {m.style.size for m in line.labels} == {theme.TEXT_PT}


def test_a_free_axis_is_called_by_its_angle_and_never_axis_1():
    model = ExplorerModel(sv.scene("triangles"))
    state = model.state()
    state = model.answer({"kind": "pose", "n": 1, "a": state["a"], "b": state["b"], "degree": 30.0})
    assert text_of(state, "picture", "axis-name") == text_of(state, "line", "axis-name") == ["30\N{DEGREE SIGN}"]
    said = text_of(state, "line", "outcome")
    assert said == text_of(state, "picture", "gap-name") and said[0] in plain(state["sentence"])
    assert "axis 1" not in state["sentence"]


def test_a_challenge_counts_the_rows_with_a_gap():
    model = ExplorerModel(sv.scene("triangles"))
    state = model.answer({"kind": "challenge", "goal": "one-axis"})
    rows = [row for row in state["rows"] if row.get("gap", -1) > 0]
    assert state["goal"]["status"] == f"{len(rows)} axes separate them."
    assert "five are enough" in state["enough"] and sum("gap" in row for row in state["rows"]) == 5


def test_a_small_gap_is_not_hidden_by_fixed_places():
    far, near = sv.Polygon([(0, 0), (1, 0), (1, 1), (0, 1)]), sv.Polygon([(1 + 2**-20, 0), (2, 0), (2, 1), (1.5, 1)])
    state = ExplorerModel(sv.Scene("near", far, near)).state()
    assert plain(state["rows"][state["lit"]]["outcome"]) == "gap +0.000000954"


# -- labels do not leap

STEP_PX, LEAP_PX, POSES = 4, 24, 38
WIDEST_PX, WIDEST_PT = 760, 540  # a wide picture is shown so much larger; one of a phone as it is drawn


def drag(seed):
    """Yield (pixels in a unit, picture) of each pose of a drag, whose handle and way come from the seed."""
    rng = random.Random(seed)
    model = ExplorerModel(sv.scene(EXPLORED[seed % len(EXPLORED)]))
    state, width, key = model.state(), rng.choice([None, 350]), rng.choice("ab")
    corner, degree, way = rng.random() < 0.3, 30.0 if rng.random() < 0.25 else None, rng.uniform(0, 2 * pi)
    state = model.answer({"kind": "pose", "n": 0, "a": state["a"], "b": state["b"], "width": width, "degree": degree})
    per_unit = model.picture().scale * (1 if width else WIDEST_PX / WIDEST_PT)
    for n in range(1, POSES):
        way += rng.uniform(-0.3, 0.3)
        dx, dy = STEP_PX / per_unit * cos(way), STEP_PX / per_unit * sin(way)
        shape = dict(state[key])
        if "circle" in shape:
            shape["circle"] = [shape["circle"][0] + dx, shape["circle"][1] + dy]
        else:
            count = len(shape["polygon"])
            moved = {seed % count} if corner else range(count)
            shape["polygon"] = [[x + dx, y + dy] if i in moved else [x, y] for i, (x, y) in enumerate(shape["polygon"])]
        pose = {"kind": "pose", "n": n, "a": state["a"], "b": state["b"], key: shape, "degree": degree}
        answer = model.answer(pose | {"width": width, "final": False})
        if answer["kind"] == "state":
            state = answer
            yield per_unit, model.picture()
        else:
            way += 2.0  # an outline that would cross itself, or leave what float64 can draw


def middle(points):
    return sum(p[0] for p in points) / len(points), sum(p[1] for p in points) / len(points)


def target_of(label, picture):
    """Return what a label names: middle of its shape, a corner, a bar, an axis's or arrow's tip, or the canvas."""
    marks = {(m.part, m.owner, m.axis, m.number): m for m in picture.marks}

    def points(part, owner="", axis="", number=None):
        return marks[part, owner, axis, number].points

    if label.part == "name":
        return middle(points("outline", label.owner))
    if label.part == "vertex-name":
        return points("vertex", label.owner, number=label.number)[0]
    if label.part == "range-name":
        return middle(points("range", label.owner, label.axis))
    if label.part == "axis-name":
        return points("axis", axis=label.axis)[1]
    if label.part == "zero-name":
        return middle(points("zero", axis=label.axis))
    if label.part == "gap-name":
        bracket = points("gap", axis=label.axis)
        return middle(bracket[1:3] if len(bracket) == 4 else bracket)
    named = marks.get((label.part.removesuffix("-name"), label.owner, label.axis, label.number))
    if named is None:
        return picture.limits[:2]
    return named.points[-1] if named.kind == "arrow" else middle(named.points)


def leaps_and_missing(seed):
    """Return the labels that jump in a drag, how often a label goes missing, and how many labels there are."""
    leaps, missing, shown, before = [], 0, 0, {}
    for per_unit, picture in drag(seed):
        now = {m.id: (m.points[0], target_of(m, picture)) for m in picture.labels}
        axes = {m.axis for m in picture.marks}
        for name in now.keys() & before.keys():
            (at, target), (was, target_was) = now[name], before[name]
            if dist(at, was) * per_unit > LEAP_PX >= dist(target, target_was) * per_unit:
                leaps.append((name, was, at))
        missing += sum(name not in now and before_axis(name, axes) for name in before)
        shown += len(now)
        before = now
    return leaps, missing, shown


def before_axis(name, axes):
    """Return whether the axis of a label is still shown."""
    number = name.rsplit(".", 1)[1] if "range-name" in name or "gap-name" in name or "axis-name" in name else ""
    return not number or number in axes


@pytest.mark.parametrize(
    "seeds",
    [
        [*range(3), 148],  # 148: pieces whose pushes turn by a quarter
        pytest.param(range(3, 40), marks=pytest.mark.slow),
        pytest.param(range(40, 200), marks=pytest.mark.full),
    ],
    ids=["few", "many", "most"],
)
def test_no_label_jumps_unless_its_target_does_and_few_are_left_out(seeds):
    found = {seed: leaps_and_missing(seed) for seed in seeds}
    assert not {seed: leaps for seed, (leaps, _, _) in found.items() if leaps}
    missing, shown = (sum(each[i] for each in found.values()) for i in (1, 2))
    assert shown > 200 * len(seeds) and missing < 0.01 * shown


def test_while_dragging_a_push_is_drawn_as_long_as_it_is():
    for model, _ in poses("sum-of-parts"):
        arrows = {m.number: m.points for m in model.picture().marks if m.part == "mtv"}
        moves = {i: pair.mtv for i, pair in enumerate(model.trace.pairs) if pair.mtv}
        assert arrows.keys() == moves.keys()
        for i, (start, tip) in arrows.items():
            assert (tip.x - start.x, tip.y - start.y) == pytest.approx(moves[i])


def test_when_the_drag_rests_no_label_covers_another():
    for seed in range(0, 36, 6):
        *_, (model, state) = poses(EXPLORED[seed % len(EXPLORED)])
        model.answer({"kind": "pose", "n": 1, "a": state["a"], "b": state["b"], "final": True})
        found = [box for _, box in boxes(model.picture())]
        assert not [(p, q) for i, p in enumerate(found) for q in found[:i] if meet(p, q)]


# -- snapping to a touch


def nearly_touching(seed):
    """Return two shapes with corners on a grid of tenths, a little apart or overlapping a little."""
    rng = random.Random(seed)

    def shape(x):
        if rng.random() < 0.3:
            return sv.Circle((round(x, 1), round(rng.uniform(-0.5, 0.5), 1)), 1)
        angles = sorted(rng.sample(range(0, 360, 15), rng.choice([3, 4, 5])))
        return sv.Polygon([(round(x + cos(t * pi / 180), 1), round(sin(t * pi / 180), 1)) for t in angles])

    a, b = shape(0.0), shape(5.0)
    test = max(sv.record(a, b, every_axis=True).tests, key=lambda t: t.gap)
    n = test.axis.direction
    sign = 1 if test.b.interval.lo > test.a.interval.hi else -1
    off = sign * (test.gap - rng.uniform(-0.1, 0.1))
    return a, translated(b, sv.Vec(round(-n.x * off, 2), round(-n.y * off, 2)))


def test_a_shape_is_snapped_to_where_it_touches_exactly_and_not_further_than_it_may():
    found = 0
    for seed in range(60):
        a, b = nearly_touching(seed)
        there = snapped(b, a, 0.3)
        if there is None:
            continue
        found += 1
        assert sv.relate(a, there) is sv.Relation.TOUCHING
        moves = [(x - u, y - v) for (x, y), (u, v) in zip(there.vertices or there.core, b.vertices or b.core)]
        assert max(abs(x - moves[0][0]) + abs(y - moves[0][1]) for x, y in moves) < 1e-12  # nothing but moved
        assert dist(moves[0], (0, 0)) <= 0.3 + 1e-12
    assert found >= 30


def let_go(b, key="b"):
    model = ExplorerModel(sv.Scene("snap", sv.Polygon([(0, 0), (3, 0), (3, 3), (0, 3)]), b))
    state = model.state()
    return model.answer({"kind": "pose", "n": 1, "a": state["a"], "b": state["b"], "snap": key}), model


@pytest.mark.parametrize("x", [2.93, 3.07])
@pytest.mark.parametrize("key", ["a", "b"])
def test_shapes_released_near_a_touch_snap_and_a_message_says_so(x, key):
    state, model = let_go(sv.Polygon([(x, 1), (5, 0.5), (5, 2)]), key)
    assert state["relation"] == "touching" and state["snapped"] == "Snapped: they touch exactly."
    assert (model.scene.a.vertices[0].x != 0) == (key == "a")
    again = model.answer({"kind": "pose", "n": 2, "a": state["a"], "b": state["b"]})
    assert again["relation"] == "touching" and "snapped" not in again


def test_the_message_about_snapping_does_not_stay_in_the_next_scene():
    state, model = let_go(sv.Polygon([(3.07, 1), (5, 0.5), (5, 2)]))
    assert "snapped" in state and "snapped" not in model.answer({"kind": "preset", "name": "triangles"})


def test_if_no_touching_place_is_found_a_message_says_so_and_nothing_moves():
    third = 1 / 3
    state, model = let_go(sv.Circle((3.4 + third, 3.4 + third), 1.013))  # off a corner, at no angle with floats
    assert state["snapped"].startswith("No place nearby was found") and state["relation"] != "touching"
    assert model.scene.b.center == (3.4 + third, 3.4 + third)


@pytest.mark.parametrize("b", [sv.Polygon([(8, 1), (9, 0.5), (9, 2)]), sv.Polygon([(3, 1), (5, 0.5), (5, 2)])])
def test_shapes_far_apart_or_touching_already_do_not_snap(b):
    state, model = let_go(b)
    assert "snapped" not in state and model.scene.b == b


def test_an_arrow_key_snaps_on_the_way_to_a_touch_and_leaves_it_again():
    _, model = let_go(sv.Polygon([(3.25, 1), (5, 0.5), (5, 2)]), None)
    relations = []
    for step in (-0.1, -0.1, -0.1, 0.1, 0.1, 0.01, 0.1):  # to the touch, into A, back to the touch, and away
        state = model.state()
        b = {"polygon": [[x + step, y] for x, y in state["b"]["polygon"]]}
        sent = {"kind": "pose", "n": 1, "a": state["a"], "b": b, "snap": "b", "byKey": True}
        relations.append(model.answer(sent)["relation"])
    assert relations == ["touching", "overlapping", "overlapping", "touching", "apart", "apart", "apart"]


# -- challenges, the dial


def test_the_error_region_is_hidden_until_the_challenge_is_solved_or_given_up():
    model = ExplorerModel(sv.scene("far-centers"))
    state = model.answer({"kind": "challenge", "goal": "break"})

    def red(state):
        return [m for m in state["picture"]["marks"] if m["part"].startswith("error-region")]

    assert not state["goal"]["met"] and not red(state) and "or give up" in state["map"]
    pose = {"kind": "pose", "n": 1, "a": state["a"], "b": state["b"]}
    given_up = model.answer(pose | {"goal": None})
    assert red(given_up) and given_up["map"].startswith("The map:")
    assert not red(model.answer(pose | {"goal": "break"}))
    won = model.answer(pose | {"b": shape_data(sv.scene("far-centers").b)})
    assert won["goal"]["met"] and red(won)
    assert red(model.answer(pose))  # it stays, once the challenge is won


@pytest.mark.parametrize("name", ["triangles", "circles", "aabb-turned"])
def test_the_dial_is_green_where_there_is_a_gap(name):
    a, b = sv.scene(name).a, sv.scene(name).b
    drawn = dial(a, b, 30.0)
    center = drawn.mark("dial").points[0]
    sectors = [m.points for m in drawn.marks if m.part == "sector"]

    def green(degree):
        x, y = center.x + 20 * cos(degree * pi / 180), center.y + 20 * sin(degree * pi / 180)
        return any(contains_point(sv.Polygon(points), sv.Vec(x, y)) for points in sectors)

    for degree in range(0, 360, 7):
        gap = gap_at(a, b, degree)
        assert green(degree) == (gap > 0) or abs(gap) < 0.05
    assert len(sectors) <= 2 * 3
