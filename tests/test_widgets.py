"""The widgets without a browser: what they answer, what they show where no front end runs."""

import base64
import json
import re
from math import cos, pi, sin
from xml.etree import ElementTree

import pytest
from speeds import one_in

import satviz as sv
from satviz.engine.geometry import InvalidScene, Relation
from satviz.pictures import playback
from satviz.pictures.caption import add_captions
from satviz.render.notebook import bundle
from satviz.scenes.failing import FAILURE_CASES, REFUSED
from satviz.scenes.link import parse_fragment
from satviz.scenes.named import names
from satviz.scenes.scenefile import shape_data
from satviz.scenes.shape_tools import box, translated
from satviz.site import live
from satviz.widgets.explorer_model import ExplorerModel
from satviz.widgets.player_model import PlayerModel

pytest.importorskip("anywidget", reason="anywidget is not installed")

TRIANGLES = sv.scene("triangles")


def explorer(scene="triangles"):
    """Return a widget whose messages are stored instead of sent."""
    widget = sv.explore(scene)
    widget.sent = []
    widget.send = lambda content, buffers=None: widget.sent.append((content, buffers))
    return widget


def pose(widget, n=1, **more):
    state = {"kind": "pose", "n": n, "a": widget.first["a"], "b": widget.first["b"], "degree": None, "pinned": None}
    widget._receive(widget, state | more, [])
    return widget.sent[-1][0]


def moved_b(widget, dx, dy):
    b = widget.first["b"]
    return {**b, "polygon": [[x + dx, y + dy] for x, y in b["polygon"]]}


def test_the_reply_to_a_pose_has_its_picture():
    widget = explorer()
    assert widget.trace.relation is Relation.APART
    said = pose(widget, b=moved_b(widget, -3, 0))
    assert widget.trace.relation is Relation.OVERLAPPING and said["relation"] == "overlapping"
    assert said["n"] == 1 and "Moving B by" in said["sentence"]
    assert widget.trace == sv.record(widget.scene.a, widget.scene.b, every_axis=True)


@pytest.mark.parametrize(
    "b, why",
    [
        ({"polygon": [[0, 0], [1, 1], [2, 2]]}, "one line"),
        ({"polygon": [[0, 0], [1, 1], [1, 0], [0, 1]]}, "cross"),
        ({"circle": [0, 0], "radius": 0}, "radius"),
        ({"polygon": [[0, 0], [float("nan"), 1], [1, 0]]}, "B"),
        ({"polygon": "abc"}, "B"),
        ({"circle": [1e300, 0], "radius": 1}, "cannot be drawn"),
        (None, "B"),
    ],
)
def test_an_invalid_pose_says_why_and_changes_nothing(b, why):
    widget = explorer()
    before = widget.scene
    said = pose(widget, b=b)
    assert said["kind"] == "refused" and why in said["why"]
    assert widget.scene == before and widget.trace.relation is Relation.APART


@pytest.mark.parametrize(
    "content",
    [
        {},
        None,
        "pose",
        {"kind": "no"},
        {"kind": "save", "form": "exe"},
        {"kind": "save", "form": ["png"]},
        {"kind": "save", "form": "png", "step": 1000},
        {"kind": "save", "form": "png", "step": -1},
    ],
)
def test_unknown_messages_are_ignored(content):
    widget = explorer()
    widget._receive(widget, content, [])
    assert widget.sent == []


def test_the_view_stays_while_dragging_and_is_fitted_when_the_drag_ends():
    widget = explorer()
    limits = widget.first["picture"]["limits"]
    far = moved_b(widget, 30, 0)
    assert pose(widget, b=far, final=False)["picture"]["limits"] == limits
    fitted = pose(widget, b=far, final=True)["picture"]
    x0, y0, x1, y1 = fitted["limits"]
    assert fitted["limits"] != limits
    assert all(x0 < x < x1 and y0 < y < y1 for m in fitted["marks"] if m["id"] == "B.outline" for x, y in m["points"])


def reply_to(widget, **content):
    widget._receive(widget, content, [])
    return widget.sent[-1][0]


def test_a_challenge_is_set_in_the_widget_evaluated_at_every_pose_and_given_up():
    widget = explorer("aabb")
    begun = reply_to(widget, kind="challenge", goal="touch")
    assert begun["goal"]["goal"] == "touch" and not begun["goal"]["met"]
    assert begun["link"].endswith("&goal=touch") and widget.scene == sv.scene("aabb")
    met = pose(widget, b=moved_b(widget, -2, 0))
    assert met["goal"]["met"] and met["goal"]["status"] == "They touch, exactly."
    assert "goal" not in pose(widget, goal=None)
    assert pose(widget, goal="touch")["goal"]["goal"] == "touch"  # undone
    assert "goal" not in reply_to(widget, kind="preset", name="circles")


@pytest.mark.parametrize("name", ["triangles", "aabb", "far-centers", "box-in-u"])
@pytest.mark.parametrize("goal", ["touch", "one-axis"])
def test_no_challenge_of_the_widget_is_won_when_it_begins(name, goal):
    assert not reply_to(explorer(name), kind="challenge", goal=goal)["goal"]["met"]


@pytest.mark.parametrize("goal", ["touch", "one-axis", "break"])
def test_no_challenge_of_a_link_is_won_before_the_reader_did_anything(goal):
    opened = set()
    for name in names():
        reply = json.loads(live.answer("p", json.dumps({"kind": "open", "hash": f"{name}&goal={goal}&mtv=1"})))
        assert reply["kind"] == "refused" or not reply["first"]["goal"]["met"], name
        opened |= {name} if reply["kind"] == "opened" else set()
    assert "aabb-turned" in opened


def test_a_challenge_moves_a_wrong_shortcut_to_a_place_where_it_is_right():
    widget = explorer("far-centers")
    assert not reply_to(widget, kind="challenge", goal="break")["goal"]["met"]
    assert widget.scene.axes == "far-centers" and widget.scene != sv.scene("far-centers")


@pytest.mark.parametrize(
    "goal, why", [("break", "not a shortcut"), ("win", "choose one of"), (3, "challenge"), ([], "ch")]
)
def test_a_challenge_that_cannot_be_set_is_refused_and_changes_nothing(goal, why):
    for kind in "challenge", "pose":
        widget = explorer("circles")
        before = widget._model.state()
        said = reply_to(widget, kind=kind, a=before["a"], b=before["b"], goal=goal)
        assert said["kind"] == "refused" and why in said["why"]
        assert widget._model.state() == before


def test_explore_sets_a_challenge():
    assert sv.explore("aabb", goal="touch").first["goal"]["task"].startswith("Make the shapes touch")
    with pytest.raises(InvalidScene, match="not a shortcut"):
        sv.explore("aabb", goal="break")


ONLY_Y = sv.Shortcut("only y", "y is enough", sv.axes.directions((0, 1)))


def posed(model, b, **more):
    """Return the state after B was moved."""
    pose = {"kind": "pose", "n": 1, "a": shape_data(model.scene.a), "b": shape_data(b), "scene": model.state()["scene"]}
    return model.answer(pose | more)


def test_a_users_shortcut_is_explored_with_its_error_region_and_can_be_broken():
    a, b = sv.scene("triangles").a, sv.scene("triangles").b
    explorer = sv.explore(a, b, axes=ONLY_Y)
    state = explorer.first
    assert state["heading"] == ["Claim: y is enough.", "Wrong: overlapping. Right: apart."]
    assert state["view"] == "shortcut" and "the shortcut is wrong" in state["map"]
    assert explorer.scene.record().shortcut is ONLY_Y and explorer.scene.title == "y is enough"
    above = posed(explorer._model, translated(b, sv.Vec(0, 20)))
    assert (
        above["heading"][1].startswith("Here it happens to be right") and above["rows"][0]["axis"] == "direction (0, 1)"
    )
    challenge = sv.explore(a, translated(b, sv.Vec(0, 20)), axes=ONLY_Y, goal="break")
    assert not challenge.first["goal"]["met"] and posed(challenge._model, b)["goal"]["met"]
    set_later = sv.explore(a, b, axes=ONLY_Y)._model.answer({"kind": "challenge", "goal": "break"})
    assert set_later["goal"]["goal"] == "break" and not set_later["goal"]["met"]


def test_undo_goes_back_from_another_scene_to_a_users_axes():
    a, b = sv.scene("triangles").a, sv.scene("triangles").b
    model = sv.explore(a, b, axes=ONLY_Y)._model
    begun = model.state()
    model.answer({"kind": "preset", "name": "circles"})
    back = model.answer(
        {"kind": "pose", "a": begun["a"], "b": begun["b"], "scene": begun["scene"], "view": begun["view"]}
    )
    assert back["heading"] == begun["heading"] and back["rows"] == begun["rows"]


def test_a_users_axes_are_explored_and_a_link_opens_the_shapes():
    own = sv.explore("triangles", axes=sv.axes.directions((1, 3), (0, 1)))
    assert [row["axis"] for row in own.first["rows"]] == ["direction (1, 3)", "direction (0, 1)"]
    opened, _ = parse_fragment(own.first["link"])
    assert (opened.a, opened.axes) == (own.scene.a, "needed")
    assert sv.explore("triangles", axes="world").scene.axes == "world"
    with pytest.raises(sv.InvalidScene, match="unknown axes"):
        sv.explore("triangles", axes="nosuch")
    with pytest.raises(TypeError, match="axes is 5: pass a name, a function"):
        sv.explore("triangles", axes=5)


def test_a_free_axis_shows_its_gap_and_the_curve():
    widget = explorer()
    said = pose(widget, degree=166.0)
    assert "this axis separates them" in said["sentence"]
    parts = {mark["part"] for mark in said["curve"]["marks"]}
    assert {"here", "candidate", "gap-curve", "overlap-curve"} <= parts
    assert "no gap" in pose(widget, degree=90.0)["sentence"]


def test_a_chosen_row_stays_chosen():
    widget = explorer()
    assert pose(widget)["lit"] == 1
    assert pose(widget, pinned=4)["lit"] == 4
    assert pose(widget, pinned=4, b=moved_b(widget, 1, 1))["lit"] == 4


@pytest.mark.parametrize("name", one_in(4, ["triangles", "circles", "concave", "far-centers"]))
def test_a_scene_dragged_back_to_its_start_has_the_frame_of_the_start(name):
    """This holds whatever the view was fitted to since, after reset, after undo, and after a drag."""
    scene = sv.scene(name)
    hand = ExplorerModel(scene)
    first = hand.state()["picture"]
    begin = {"kind": "pose", "n": 1, "a": shape_data(scene.a), "b": shape_data(scene.b)}
    away = begin | {"b": shape_data(translated(scene.b, sv.Vec(90, 20)))}
    wide = hand.answer(away)["picture"]["limits"]
    assert wide[2] - wide[0] > 2 * (first["limits"][2] - first["limits"][0])
    assert hand.answer(begin | {"final": False})["picture"]["limits"] == wide  # nothing jumps under the hand
    assert hand.answer(begin)["picture"] == first
    for i in range(-60, 61, 3):  # labels move
        move = sv.Vec(2 * i / hand.picture().scale, i / hand.picture().scale)
        hand.answer(begin | {"b": shape_data(translated(scene.b, move)), "final": False})
    assert hand.answer(begin)["picture"] == first
    narrow = hand.answer(begin | {"width": 320})["picture"]["limits"]
    hand.answer(away | {"width": 320})
    assert hand.answer(begin | {"width": 320})["picture"]["limits"] == narrow != first["limits"]


def test_presets_are_the_built_in_scenes():
    widget = explorer()
    for name in widget.presets:
        widget._receive(widget, {"kind": "preset", "name": name}, [])
        assert widget.sent[-1][0]["kind"] == "state" and widget.scene == sv.scene(name)
    for name in ("nothing", None, ["circles"]):
        widget._receive(widget, {"kind": "preset", "name": name}, [])
        assert widget.sent[-1][0]["kind"] == "refused"


def test_a_failing_scene_has_two_views_and_a_map_of_where_the_shortcut_is_wrong():
    widget = sv.explore("aabb-turned")
    widget.sent = []
    widget.send = lambda content, buffers=None: widget.sent.append((content, buffers))
    first = widget.first
    assert first["view"] == "shortcut" and first["heading"][0].startswith("Claim: ")
    assert "a false hit" in first["sentence"] and widget.trace.shortcut and widget.trace.false_hit
    parts = {mark["id"] for mark in first["picture"]["marks"]}
    assert {"error-region.0", "reference", "claim-strike"} <= parts
    truth = pose(widget, view="truth")
    assert truth["view"] == "truth" and truth["sentence"].startswith("A and B are apart")
    assert widget.trace.shortcut is None and "error-region.0" not in {m["id"] for m in truth["picture"]["marks"]}
    back = pose(widget, view="shortcut", b=moved_b(widget, -1, -1))
    assert back["relation"] == "overlapping" and back["heading"][1].startswith("Here it happens to be right")
    assert "claim-strike" not in {m["id"] for m in back["picture"]["marks"]}
    refused = widget.sent[-1][0]["n"]
    widget._receive(widget, {"kind": "pose", "n": refused + 1, "a": back["a"], "b": back["b"], "view": "both"}, [])
    assert widget.sent[-1][0]["why"] == 'the view must be "shortcut" or "truth"'


def test_a_scene_without_a_shortcut_has_no_views():
    widget = explorer()
    assert widget.first["view"] is None and "heading" not in widget.first
    assert pose(widget, view="truth")["view"] is None


@pytest.mark.slow
def test_every_failing_scene_can_be_explored_dragged_and_shown_with_the_exact_answer():
    for name in explorer().failing:
        widget = sv.explore(name)
        widget.sent = []
        widget.send = lambda content, buffers=None, sent=widget.sent: sent.append((content, buffers))
        for more in (
            {"mtv": True},
            {"view": "truth", "mtv": True},
            {"view": "shortcut", "pinned": 0},
            {"degree": 20},
        ):
            assert pose(widget, **more)["picture"]["marks"], (name, more)


@pytest.mark.slow
def test_files_come_from_the_matplotlib_pen():
    widget = sv.play("circles")  # of few steps
    sent = []
    widget.send = lambda content, buffers=None: sent.append((content, buffers))
    for form, magic in ("svg", b"<?xml"), ("png", b"\x89PNG"), ("gif", b"GIF89a"):
        widget._receive(widget, {"kind": "save", "form": form, "step": 3, "which": 1}, [])
        content, (data,) = sent[-1]
        assert content["name"] == f"satviz.{form}" and data.startswith(magic)


def test_the_step_that_is_saved_is_the_one_that_is_shown(monkeypatch):
    """This holds also if a playback leaves steps out because there are too many."""
    monkeypatch.setattr(playback, "MAX_STEPS", 20)
    trace = TRIANGLES.record().without_early_exit()
    (shown,) = playback.playbacks(trace)
    assert len(shown["steps"]) < len(sv.steps(trace))
    for i, step in enumerate(shown["steps"]):
        (drawn,) = PlayerModel(trace).pictures_to_save({"step": i}, every_step=False)
        assert drawn.sentence == step["sentence"]


def test_an_animation_of_too_many_steps_is_refused(monkeypatch):
    monkeypatch.setattr(playback, "MAX_STEPS", 5)
    widget = explorer()
    widget._receive(widget, {"kind": "save", "form": "gif"}, [])
    assert widget.sent[-1][0]["kind"] == "refused" and "too many to step through" in widget.sent[-1][0]["why"]


WIDGETS = [
    lambda: sv.explore("circles"),
    lambda: sv.play(TRIANGLES.record()),
    lambda: sv.play(TRIANGLES.record(), pen="matplotlib"),
]


@pytest.mark.parametrize("make", WIDGETS, ids=["explore", "play", "plain"])
def test_where_no_front_end_runs_there_is_the_picture_and_the_sentence(make):
    widget = make()
    found = widget._repr_mimebundle_()
    data = found[0] if isinstance(found, tuple) else found
    assert data["text/plain"] == repr(widget) and " at 0x" not in repr(widget)
    assert widget.trace.sentence in data["text/plain"]
    drawn = data["image/svg+xml"]
    assert "are apart" in ElementTree.fromstring(drawn).find("{http://www.w3.org/2000/svg}desc").text
    assert "application/vnd.jupyter.widget-view+json" in data


@pytest.mark.slow
@pytest.mark.parametrize("make", WIDGETS, ids=["explore", "play", "plain"])
def test_an_exported_page_shows_the_picture_with_its_sentence(make):
    """nbconvert takes the picture and leaves the text."""
    nbformat, nbconvert = pytest.importorskip("nbformat"), pytest.importorskip("nbconvert")
    widget = make()
    found = widget._repr_mimebundle_()
    data = found[0] if isinstance(found, tuple) else found
    shown = nbformat.v4.new_output("execute_result", data, execution_count=1)
    notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell("w", outputs=[shown], execution_count=1)])
    page, _ = nbconvert.HTMLExporter().from_notebook_node(notebook)
    drawn = widget.picture() if isinstance(widget, sv.widgets.Explorer) else sv.picture(widget.trace)
    assert drawn.sentence == widget.trace.sentence
    (still,) = re.findall(r'src="data:image/svg\+xml;base64,([^"]*)"', page)
    assert base64.b64decode(still).decode() == bundle(add_captions([drawn])[0])["image/svg+xml"]
    assert re.findall(r'alt="([^"]*)"', page) == [drawn.sentence]


def test_the_plain_player_steps_with_its_slider_and_buttons():
    trace = TRIANGLES.record()
    widget = sv.play(trace, pen="matplotlib")
    first = widget.image.value
    widget.slider.value = 7
    assert sv.picture(trace, 7).sentence.replace("'", "&#x27;") in widget.sentence.value
    assert widget.image.value != first
    widget.slider.value = widget.slider.max
    widget.children[2].children[2].click()
    assert widget.slider.value == widget.slider.max
    with pytest.raises(ValueError, match="matplotlib"):
        sv.play(trace, pen="crayon")


def test_the_gap_curve_has_the_numbers_of_the_trace():
    for scene in ("triangles", "circle-polygon", "aabb", "circles"):
        found = sv.scene(scene)
        curve = sv.gap_curve(found.a, found.b, 20)
        best = max(t.gap for t in sv.record(found.a, found.b, every_axis=True).tests)
        assert f"{best:.3f}".rstrip("0").rstrip(".") in curve.sentence


SHOW = [sv.play, sv.page, sv.difference, sv.sheet, sv.gap_curve, sv.explore]


def words_of(shown):
    """Return the shown picture or text in words."""
    return shown if isinstance(shown, str) else shown.sentence if isinstance(shown, sv.Picture) else repr(shown)


@pytest.mark.parametrize("show", SHOW, ids=lambda show: show.__name__)
def test_whatever_shows_a_pair_takes_a_name_a_scene_two_shapes_or_their_trace(show):
    scene = sv.scene("circles")
    asked = [("circles",), (scene,), (scene.a, scene.b), (sv.record(scene.a, scene.b),)]
    if show is sv.explore:
        with pytest.raises(TypeError, match="a Trace, one run of two shapes: pass the shapes"):
            show(*asked.pop())
    assert len({words_of(show(*what)) for what in asked}) == 1


@pytest.mark.parametrize("show", [sv.picture, sv.draw, sv.steps], ids=lambda show: show.__name__)
def test_steps_can_be_drawn_of_a_scene_or_its_name(show):
    scene = sv.scene("aabb")
    drawn = [show(what) for what in ("aabb", scene, scene.record())]
    assert show is sv.draw or drawn[0] == drawn[1] == drawn[2]


@pytest.mark.parametrize("what", [5, None, sv.Circle((0, 0), 1), ["aabb"]])
@pytest.mark.parametrize("show", SHOW, ids=lambda show: show.__name__)
def test_a_value_that_is_not_a_pair_is_refused_with_the_right_form(show, what):
    with pytest.raises(TypeError, match=f"this is a {type(what).__name__}: pass a scene's name, a Scene, .*two shapes"):
        show(what)
    with pytest.raises(TypeError, match=r"make it a satviz\.Polygon"):
        show(what, 5)
    with pytest.raises(sv.InvalidScene, match="no scene 'trianglse': did you mean triangles"):
        show("trianglse")


def test_the_explorer_alone_opens_the_triangles():
    assert sv.explore().scene == TRIANGLES


def polygon_data(*points):
    return {"polygon": [list(map(float, p)) for p in points]}


def square_data(at, size):
    return polygon_data((at, at), (at + size, at), (at + size, at + size), (at, at + size))


def ring_data(n, dent=1.0):
    """Return n corners around (0, 0), every second one pulled inwards."""
    ring = [((dent if i % 2 else 1.0), 2 * pi * i / n) for i in range(n)]
    return polygon_data(*((r * cos(t), r * sin(t)) for r, t in ring))


# what a hand can hardly make, but a link or a message can
EXTREME = {
    "a speck": (square_data(0.0, 1.0), square_data(0.0, 1e-17)),
    "two specks": (square_data(0.0, 1e-17), square_data(0.0, 1e-17)),
    "nearly the smallest": (square_data(0.0, 1e-300), square_data(5e-301, 1e-300)),
    "squares beyond float64": (square_data(0.0, 2e155), square_data(1e155, 2e155)),
    "nearly the largest": (square_data(-1e290, 2e290), square_data(-1e289, 3e290)),
    "a hundred corners": (ring_data(100), ring_data(100, 0.9)),
}


@pytest.mark.parametrize("pair", EXTREME)
@pytest.mark.parametrize(
    "name", one_in(24, [*(row.name for row in FAILURE_CASES if row.how != REFUSED), "triangles", "concave"])
)
def test_an_extreme_pose_is_shown_or_refused_without_any_change(name, pair):
    explored, (a, b) = ExplorerModel(sv.scene(name)), EXTREME[pair]
    before = json.dumps(explored.state())
    for more in ({}, {"view": "truth", "mtv": True}, {"degree": 20.0}, {"difference": True}):
        said = explored.answer({"kind": "pose", "n": 1, "a": a, "b": b, "degree": None, "pinned": None} | more)
        if said["kind"] == "refused":
            assert 0 < len(said["why"]) < 500 and json.dumps(explored.state()) == before
        else:
            before = json.dumps(explored.state())
            assert said["picture"]["marks"]


def test_an_error_region_of_many_parts_is_not_computed_while_dragging():
    """Each pair of parts cuts up what the others leave: 40 corners took 6 seconds, 60 took 43."""
    explored = ExplorerModel(sv.scene("aabb-turned"))
    for n in 20, 40, 60:
        pose = {"kind": "pose", "n": 1, "a": ring_data(n), "b": ring_data(n, 0.9), "degree": None, "pinned": None}
        assert ("too many corners" in str(explored.answer(pose)["map"])) == (n > 20)


@pytest.mark.parametrize(
    ("name", "pair", "why"),
    [
        ("aabb-turned", "a speck", "cannot tell their corners apart"),
        ("tile-seam", "squares beyond float64", "too large for float64"),
        ("sum-of-parts", "squares beyond float64", "too large for float64"),
    ],
)
def test_a_reason_is_shown_for_an_error_region_that_floats_cannot_hold(name, pair, why):
    explored, (a, b) = ExplorerModel(sv.scene(name)), EXTREME[pair]
    said = explored.answer({"kind": "pose", "n": 1, "a": a, "b": b, "degree": None, "pinned": None})
    assert said["kind"] == "state" and why in str(said["map"])


def test_undo_may_go_back_to_another_scene_with_its_own_axes():
    widget = explorer()
    begun = widget.first["scene"]
    widget._receive(widget, {"kind": "preset", "name": "aabb-turned"}, [])
    assert widget.trace.shortcut
    back = pose(widget, scene=begun)
    assert widget.scene == TRIANGLES and back["view"] is None
    assert pose(widget, scene='{"satviz": 1}')["kind"] == "refused" and widget.scene == TRIANGLES
    assert pose(widget, scene=7)["why"] == "the scene must be text, not a number"


@pytest.mark.parametrize("name", ["triangles", "circle-polygon", "concave", "far-centers"])
def test_a_narrow_place_gets_a_narrow_picture_and_not_smaller_letters(name):
    widget = explorer(name)
    for width in (None, 700, 358, 100):
        wanted = {None: 540, 700: 540, 358: 358, 100: 300}[width]
        said = pose(widget, width=width, degree=20, difference=True)
        assert [said[key]["size"][0] <= wanted for key in ("picture", "curve", "difference")] == [True] * 3
        assert said["picture"]["size"][0] == wanted
        assert min(style["size"] for style in said["picture"]["styles"] if style["kind"] == "label") >= 11
    assert pose(widget, width="wide")["why"] == "the width must be a finite number, not 'wide'"


def test_corners_are_named_where_the_table_names_them():
    def names(scene, **more):
        marks = pose(explorer(scene), **more)["picture"]["marks"]
        return {mark["text"] for mark in marks if mark["part"] == "vertex-name"}

    assert names("triangles") == {"a1", "a2", "a3", "v1", "v2", "v3"} == names("triangles", degree=30)
    assert names("aabb") == set()


def test_the_explorer_says_how_many_axes_are_enough():
    widget = explorer()
    assert widget.first["enough"].startswith("One axis with a gap is enough here. Wherever they are moved, five are")
    assert "Five axes are needed here" in pose(widget, b=moved_b(widget, -3, 0))["enough"]


def test_a_free_axis_does_not_hide_the_verdict():
    said = pose(explorer(), degree=90)
    (note,) = (mark["text"] for mark in said["picture"]["marks"] if mark["id"] == "verdict")
    assert note == "apart: this axis shows no gap"
    assert said["sentence"].startswith("A and B are apart. The axis at 90 degrees: ")


def test_a_player_with_predict_shows_no_answer_where_no_front_end_runs():
    widget = sv.play("triangles", predict=True)
    data, _ = widget._repr_mimebundle_()
    assert "apart" not in data["text/plain"] + data["text/html"]
    assert f'alt="{sv.picture("triangles", 0).sentence}"' in data["text/html"]


def test_both_widgets_know_the_link_of_what_they_show():
    assert explorer().first["link"] == "triangles"
    assert sv.play(TRIANGLES.record()).link == "triangles"
    widget = explorer()
    assert "free=30" in pose(widget, degree=30.0)["link"] and widget.site == ""


@pytest.mark.parametrize("name", [row.name for row in FAILURE_CASES if row.how != REFUSED])
def test_every_failing_scene_has_an_error_region_while_dragging_or_a_reason(name):
    first = sv.explore(name).first
    red = [mark for mark in first["picture"]["marks"] if mark["id"].startswith("error-region")]
    assert first["map"].startswith("The map: " if red else "No map of where it is wrong: ")
    assert len(first["map"]) > 60


def test_the_picture_says_if_the_shortcut_is_right_everywhere_in_it():
    hand = ExplorerModel(sv.Scene("boxes", box(0, 0, 2, 2), box(1, 1, 4, 3), "aabb-turned"))
    assert hand.state()["map"] == "No red on the map: wherever B lies in this picture, the shortcut is right."
    shapes = {key: hand.state()[key] for key in ("a", "b")}
    free = hand.answer({"kind": "pose", **shapes, "degree": 30})
    assert "map" not in free  # the picture of a free axis has none


def test_a_dent_made_by_dragging_removes_the_error_region_and_gives_a_reason():
    hand = ExplorerModel(sv.scene("raw-depth"))
    first = hand.state()
    a = {"polygon": [*first["a"]["polygon"], [0.5, 0.5]]}
    state = hand.answer({"kind": "pose", "a": a, "b": first["b"]})
    assert state["map"].startswith("No map of where it is wrong: a shape has a dent")


@pytest.mark.parametrize("option, pictures", [("sweep", sv.sweep), ("difference", sv.difference_steps)])
def test_a_player_of_a_sweep_or_a_difference_shows_and_saves_its_pictures(option, pictures):
    player, drawn = sv.play("triangles", **{option: True}), pictures("triangles")
    (show,) = player.shows
    assert [step["sentence"] for step in show["steps"]] == [one.sentence for one in drawn] and not player.narrow
    model = PlayerModel(player.trace, turns=option == "sweep", difference=option == "difference")
    assert model.pictures_to_save({}, every_step=True) == list(drawn)
    assert model.pictures_to_save({"step": 2}, every_step=False) == [drawn[2]]


def test_a_player_begins_at_the_speed_that_is_passed():
    assert sv.play("triangles").speed == 1 and sv.play("triangles", speed=0.5).speed == 0.5
    once, slow = (sv.play("circles", pen="matplotlib", speed=speed).player.interval for speed in (1, 0.25))
    assert slow == 4 * once


@pytest.mark.parametrize(
    "options, words",
    [
        ({"speed": 0}, "above 0"),
        ({"speed": float("nan")}, "above 0"),
        ({"sweep": True, "difference": True}, "one of them"),
        ({"difference": True, "pen": "matplotlib"}, 'difference needs pen="svg"'),
    ],
)
def test_invalid_options_of_a_player_are_refused(options, words):
    with pytest.raises(ValueError, match=words):
        sv.play("triangles", **options)
