"""A function of the user's own: the smallest scene where it is wrong, and the known mistake it behaves like."""

import os
import subprocess
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from own_functions.right import RIGHT, sat
from own_functions.wrong import WRONG, bounding_boxes, far_apart_first, normals_of_a, raw_depth, touching_is_apart
from processes import ends
from speeds import one_in

import satviz as sv
from satviz.checking import asking
from satviz.checking.answers import Rules
from satviz.checking.checked import Checked
from satviz.checking.mistakes import HYPOTHESES, SYMPTOMS, mistakes_with, predicted_answer
from satviz.checking.pairs import KINDS, kind_of_pair, near_pairs, whole_number_pairs
from satviz.scenes.failing import NAMED

SAME = {"line-for-axis": ("line-for-axis", "one-overlap")}  # the y axis alone


def corners(checked):
    return sum(len(shape.vertices) for shape in (checked.counterexample.a, checked.counterexample.b))


@pytest.mark.parametrize("row", one_in(6, WRONG), ids=[mistake for _, mistake, _ in WRONG])
def test_a_function_with_a_known_mistake_is_caught_and_named(row):
    fn, mistake, more = row
    found = sv.check(fn, **more)
    assert not found.right and found.finding == "wrong" and found.behaves_like[0].name == mistake
    scene = found.counterexample
    assert corners(found) <= 8 and all(x == int(x) for s in (scene.a, scene.b) for p in s.vertices for x in p)
    assert found.behaves_like[0].agrees >= 0.95 * found.behaves_like[0].pairs
    assert NAMED[mistake].claim in str(found)


@pytest.mark.parametrize("row", one_in(4, RIGHT), ids=[fn.__name__ for fn, _ in RIGHT])
def test_a_correct_function_gives_no_false_alarm(row):
    fn, more = row
    found = sv.check(fn, **more)
    assert found.right and found and found.counterexample is None, str(found)


@pytest.mark.parametrize("fn", [bounding_boxes, touching_is_apart], ids=["hit", "touching"])
def test_the_counterexample_shows_the_answer_of_the_function_and_the_right_one(fn):
    found = sv.check(fn)
    a, b = found.counterexample.a, found.counterexample.b
    assert found.said == fn(a.vertices, b.vertices) and found.truth is sv.relate(a, b)
    assert bool(found.said) is not (found.truth is not sv.Relation.APART)


def test_the_counterexample_cannot_lose_a_corner_or_come_nearer_by_one():
    """The shrinking ended because nothing smaller is wrong, not because it ran out of tries."""
    from satviz.checking.shrinking import cost, numbers_of, shape_of, smaller

    found = sv.check(bounding_boxes)
    scene = numbers_of(found.counterexample.a), numbers_of(found.counterexample.b)
    for less in smaller(scene):
        try:
            a, b = map(shape_of, less)
        except sv.InvalidShape:
            continue
        wrong = bounding_boxes(a.vertices, b.vertices) and sv.relate(a, b) is sv.Relation.APART
        assert cost(less) >= cost(scene) or not wrong, less


def test_the_report_names_the_mistake_and_can_be_pasted():
    text = str(sv.check(bounding_boxes))
    assert text.startswith("Wrong. Your function says hit. The right answer: apart.")
    assert "It behaves like aabb-not-upright" in text and "the same answer on 160 of 160 pairs" in text
    names = {"sv": sv}
    exec("\n".join(line for line in text.splitlines() if line.startswith(("a = ", "b = "))), names)
    assert sv.relate(names["a"], names["b"]) is sv.Relation.APART


def test_a_right_function_passes_every_pair_and_the_report_says_where_its_floats_fail():
    found = sv.check(sat)
    assert sum(found.passed.values()) == len(found.results) > 300
    assert found.near.asked > 50 and 0 < found.near.wrong < found.near.asked / 5
    assert found.near.largest_wrong < 20  # roundings: a float dot product is no worse
    assert "in rounded numbers, it is wrong on" in str(found) and "Not tried: outlines with dents" in str(found)


@pytest.mark.parametrize(
    ("fn", "kind"),
    [
        (lambda a, b: sv.relate(sv.Polygon(a), sv.Polygon(b)), "relation"),
        (lambda a, b: str(sv.relate(sv.Polygon(a), sv.Polygon(b))), "relation"),
        (lambda a, b: sv.record(sv.Polygon(a), sv.Polygon(b)).mtv, "mtv"),
        (lambda a, b: {"hit": bool(t := sv.record(sv.Polygon(a), sv.Polygon(b)).mtv), "mtv": t}, "hit and mtv"),
        (lambda a, b: int(bool(sv.relate(sv.Polygon(a), sv.Polygon(b)))), "hit"),
    ],
)
def test_the_kind_of_answer_of_a_function_is_inferred(fn, kind):
    found = sv.check(fn)
    assert found.right and found.rules.returns == kind, str(found)


@pytest.mark.parametrize("form", ["points", "dicts", "xy", "shapes", lambda shape: shape])
def test_shapes_are_passed_in_the_form_that_the_option_names(form):
    seen = []

    def fn(a, b):
        seen.append(a)
        return True

    sv.check(fn, form=form, kinds=("convex", "circles"))
    circle, polygon = {
        "points": (((int, int), int), [(int, int)] * 3),
        "dicts": ({"circle": [int, int], "radius": int}, {"polygon": [[int, int]] * 3}),
        "xy": ((int, int, int), ([int] * 3, [int] * 3)),
    }.get(form, (sv.Circle, sv.Polygon))

    def type_of(value):
        if isinstance(value, dict):
            return {key: type_of(item) for key, item in value.items()}
        return type(value)(map(type_of, value)) if isinstance(value, (list, tuple)) else type(value)

    assert {str(circle), str(polygon)} <= {str(type_of(shape)) for shape in seen}


def raising(a, b):
    return 1 / (len(a) - 4)


def forgets_to_return(a, b):
    if sat(a, b):
        return True


def returns_text(a, b):
    return "yes"


def writes(a, b):
    a.append(a[0])
    return sat(a, b)


def make_unsteady():
    calls = []

    def unsteady(a, b):
        calls.append(1)
        return len(calls) % 2 == 0

    return unsteady


def without_end(a, b):
    return without_end(b, a)


def leaves(a, b):
    raise SystemExit


class Speechless(Exception):
    def __str__(self):
        raise RuntimeError


def raises_without_words(a, b):
    raise Speechless


@pytest.mark.parametrize(
    ("fn", "finding", "line"),
    [
        (raising, "error", "raises ZeroDivisionError in line"),
        (forgets_to_return, "unreadable", "returns nothing: every way through the function must end in a return"),
        (returns_text, "unreadable", "returns 'yes': expected True or False"),
        (lambda a, b: float("nan"), "unreadable", "returns nan: expected True or False"),
        (lambda a, b: (yield), "unreadable", "returns <generator object"),
        (lambda a, b: object(), "unreadable", "returns <object object at"),
        (raises_without_words, "error", "raises Speechless in line"),
        (writes, "wrote", "changes its argument A"),
        (make_unsteady(), "unsteady", "changes its answer about the same shapes"),
        (without_end, "error", "calls itself without end (RecursionError)"),
        (leaves, "error", "raises SystemExit in line"),
        (lambda a: True, "error", "raises TypeError"),
    ],
)
def test_each_fault_of_the_function_is_reported_in_one_line(fn, finding, line):
    found = sv.check(fn)
    assert not found.right and found.finding == finding and found.line.startswith(line), found.line
    assert "\n" not in found.line and "Traceback" not in str(found) and found.counterexample is not None


def test_an_endless_loop_is_ended_with_the_option_call_seconds():
    def loops(a, b):
        while len(a) == 3:
            pass
        return True

    found = sv.check(loops, call_seconds=0.2)
    assert found.finding == "no answer" and "gives no answer within 0.2 s: an endless loop?" in str(found)
    assert found.counterexample and not sv.check(loops, call_seconds=0.2).score().passed.count("convex")


def test_a_function_in_a_process_of_its_own_answers_as_it_does_here():
    one, other = sv.check(bounding_boxes, call_seconds=2), sv.check(bounding_boxes)
    assert str(one) == str(other)


class Stranger(BaseException):
    """No Exception, as KeyboardInterrupt is none."""


def raises(error):
    raise error


def deep():
    found = []
    found += [found, found]
    return found


@pytest.mark.parametrize(
    ("act", "line"),
    [
        (lambda: os._exit(3), "ends the program by itself (exit code 3)"),
        (lambda: os.kill(os.getpid(), 9), "ends the program by itself (SIGKILL)"),
        (lambda: os.closerange(3, 256), "ends the program by itself (exit code 0)"),
        (lambda: raises(KeyboardInterrupt), "raises KeyboardInterrupt in line"),
        (lambda: raises(Stranger()), "raises Stranger in line"),
        (lambda: setattr(asking, "plain", None), "changes its answer about the same shapes"),
        (lambda: setattr(asking.CalledHere, "ask_untrusted", None), "ends the program by itself"),
    ],
)
@pytest.mark.skipif(not hasattr(os, "fork"), reason="a function must be sent to a process that is no copy")
def test_the_end_of_a_functions_process_is_reported_in_one_line_and_does_no_harm(act, line, capfd):
    found = sv.check(lambda a, b: bool(act()), call_seconds=5)
    assert found.line.startswith(line), found.line
    assert capfd.readouterr() == ("", "") and sv.check(sat, call_seconds=5, kinds="boxes").right


@pytest.mark.slow
@pytest.mark.skipif(not hasattr(os, "fork"), reason="no process makes a copy of itself")
def test_a_function_that_makes_copies_of_its_process_still_answers_once():
    assert sv.check(lambda a, b: bool(os.fork() + 1) and sat(a, b), call_seconds=5, kinds="boxes").right


@pytest.mark.skipif(not hasattr(os, "killpg"), reason="no groups of processes")
def test_child_processes_of_a_checked_function_end_with_it(tmp_path):
    file = tmp_path / "pid"

    def starts(a, b):
        file.write_text(str(subprocess.Popen(["sleep", "60"]).pid))
        while True:
            pass

    assert sv.check(starts, call_seconds=1).finding == "no answer" and ends(int(file.read_text()))


@pytest.mark.parametrize(
    ("make", "line"),
    [
        (deep, "returns ((("),
        (lambda: {"x": deep(), "y": 0}, "returns (("),
        (lambda: 10**10000, "returns a number that is too large: expected True or False"),
        (lambda: (float("nan"), float("inf")), "returns (nan, inf): expected True or False"),
        (lambda: "x" * 10**6, "returns 'xxxxx"),
        (lambda: [(0, 0)] * 10**6, "returns [(0, 0), (0, 0)"),
    ],
)
@pytest.mark.parametrize("more", [{}, {"call_seconds": 5}], ids=["here", "in a process"])
def test_an_answer_of_a_wrong_type_is_reported_in_one_short_line(make, line, more):
    found = sv.check(lambda a, b: make(), **more)
    assert found.finding == "unreadable" and found.line.startswith(line) and len(found.line) < 300, found.line


def test_a_vector_of_the_functions_own_class_is_an_answer_also_from_a_process():
    class Vector:
        def __init__(self, x, y):
            self.x, self.y = x, y

    def way_out(a, b):
        move = sv.record(sv.Polygon(a), sv.Polygon(b)).mtv
        return move and Vector(Fraction(move.x), move.y)

    found = sv.check(way_out, call_seconds=5)
    assert found.right and found.rules.returns == "mtv", str(found)


class Outline:
    """Equal to itself alone."""

    def __init__(self, points):
        self.points = points


@pytest.mark.parametrize(
    "form", [lambda shape: np.array(shape.vertices), lambda shape: Outline(shape.vertices)], ids=["array", "object"]
)
def test_arguments_of_any_kind_raise_no_false_alarm(form):
    found = sv.check(lambda a, b: sat(*([*getattr(each, "points", each)] for each in (a, b))), form=form)
    assert found.right, str(found)


def test_a_function_that_writes_to_its_arrays_is_reported():
    found = sv.check(lambda a, b: bool(a.sort()), form=lambda shape: np.array(shape.vertices)[::-1])
    assert found.finding == "wrote" and "changes its argument A" in found.line


@pytest.mark.slow
def test_what_counts_as_right_for_touching_shapes_is_an_option():
    assert sv.check(touching_is_apart, touching="miss").right and sv.check(touching_is_apart, touching="either").right
    assert not sv.check(sat, touching="miss").right and sv.check(sat, touching="either").right
    assert 'touching="miss"' in str(sv.check(touching_is_apart))


def test_the_report_says_what_a_tolerance_costs():
    found = sv.check(touching_is_apart, tolerance=1e-9)
    touching = sum(r.truth.relation is sv.Relation.TOUCHING for r in found.results)
    assert found.right and f"leaves {touching} of {len(found.results)} pairs unjudged" in str(found)
    assert not sv.check(far_apart_first, tolerance=1e-9).right


def test_with_clockwise_false_all_outlines_are_counter_clockwise():
    def needs_order(a, b):
        def area(p):
            return sum(x0 * y1 - x1 * y0 for (x0, y0), (x1, y1) in zip(p, [*p[1:], p[0]]))

        return sat(a, b) and area(a) > 0 and area(b) > 0

    assert sv.check(needs_order, clockwise=False).right
    assert "with clockwise=False it is right" in str(sv.check(needs_order))


def test_the_same_seed_gives_the_same_report_and_another_seed_other_pairs():
    assert str(sv.check(bounding_boxes)) == str(sv.check(bounding_boxes))
    assert whole_number_pairs(("convex",), 1) != whole_number_pairs(("convex",), 2)


def test_a_check_ends_in_time():
    import time

    def slow(a, b):
        time.sleep(0.01)
        return sat(a, b)

    found = sv.check(slow, seconds=0.1, whole_numbers=True)
    assert found.right and "Stopped after 0.1 s" in str(found) and found.unasked


def test_a_text_instead_of_a_function_is_refused_with_the_way_to_pass_one():
    with pytest.raises(TypeError, match=r"fn is the text 'x\.py:f', not a function: import .*satviz check FILE:NAME"):
        sv.check("x.py:f")
    with pytest.raises(TypeError, match="fn is a list: pass a function of two shapes"):
        sv.check([])


@pytest.mark.parametrize(
    "more",
    [{"returns": "colour"}, {"kinds": "cubes"}, {"kinds": ()}, {"touching": "no"}, {"tolerance": -1}, {"form": "x"}],
)
def test_an_invalid_option_is_refused(more):
    with pytest.raises(ValueError, match=r"choose|must be"):
        sv.check(sat, **more)


@pytest.mark.parametrize("kind", KINDS)
def test_generated_integer_pairs_cover_every_relation_of_their_kind(kind):
    pairs = whole_number_pairs((kind,), 1)
    relations = [sv.relate(p.a, p.b) for p in pairs]
    for relation in sv.Relation:
        assert relations.count(relation) >= (3 if kind != "repeated" else 1), relation
    assert len(pairs) >= 60 and all(kind_of_pair(p.a, p.b) in (kind, "boxes", "convex") for p in pairs)
    assert all(x == int(x) for p in pairs for s in p[:2] for v in s.core for x in (*v, s.radius))


def test_the_first_pairs_are_small_boxes():
    assert all(
        p.kind == "boxes" and max(p.a.max_coordinate, p.b.max_coordinate) <= 6
        for p in whole_number_pairs(tuple(KINDS), 1)[:50]
    )


def test_pairs_in_rounded_numbers_nearly_touch():
    from satviz.advice.relative_margin import relative_margin

    margins = [relative_margin(p.a, p.b) for p in near_pairs(("convex",), 1, 60)]
    assert sum(margin < 2.0**34 for margin in margins) > 50 and sum(0 < margin < 20 for margin in margins) > 3


def test_a_symptom_leads_to_known_mistakes():
    assert "far-centers" in mistakes_with("it falls through the floor")
    assert "push-from-center" in mistakes_with("my box is pushed the wrong way")
    assert "unit-normals" in mistakes_with("jitters") and mistakes_with("xyzzy") == []
    assert {name for names in SYMPTOMS.values() for name in names} <= NAMED.keys()


def test_every_hypothesis_names_a_failing_case():
    assert {hypothesis.name for hypothesis in HYPOTHESES} <= NAMED.keys() and len(HYPOTHESES) > 20


@pytest.mark.parametrize("i", one_in(60, range(len(HYPOTHESES))))
def test_every_variant_of_a_mistake_is_recognised(i):
    """A function that answers as one hypothesis does, and rightly where this one knows no answer."""
    hypothesis, case = HYPOTHESES[i], NAMED[HYPOTHESES[i].name]
    in_moves = case.is_about_push or "digit" in hypothesis.variant or "the smallest, too" in hypothesis.variant
    rules = Rules("mtv" if in_moves else "hit")  # those two are seen in hardly any verdict
    if not hypothesis.is_about(rules):
        pytest.skip("no answer for two shapes shows it")

    def fn(a, b):
        predicted = predicted_answer(hypothesis, a, b, rules)
        return predicted[0] if predicted else sv.record(a, b).mtv if in_moves else bool(sv.relate(a, b))

    kinds = {"boxes", "convex", kind_of_pair(*case.shapes)} | (
        {"circles", "circle and polygon"} if "circle" in hypothesis.variant else set()
    )
    found = sv.check(fn, form="shapes", returns=rules.returns, kinds=sorted(kinds), seconds=30)
    assert found.finding == "wrong" and found.behaves_like[0].name in SAME.get(hypothesis.name, (hypothesis.name,))


@pytest.mark.slow
def test_a_score_gives_credit_by_kind_of_scene():
    right, boxes, moves = sv.check(sat).score(), sv.check(bounding_boxes).score(), sv.check(raw_depth).score()
    assert right.total == 1 and set(right.parts) == {"upright boxes", "convex", "touching"}
    assert boxes.passed == ["upright boxes", "touching"] or boxes.passed == ["upright boxes"]
    assert moves.parts["MTV"][0] < moves.parts["MTV"][1] and "MTV" not in moves.passed
    assert sv.check(bounding_boxes).score({"convex": 0, "touching": 0}).total == 1
    assert sv.check(lambda a, b: True).score().total < 0.5
    every = sv.check(lambda a, b: sv.relate(a, b) > 0, form="shapes", kinds="all", seconds=60).score()
    assert set(every.parts) == {"upright boxes", "convex", "circles", "concave", "touching"} and every.total == 1


def test_the_right_answer_of_a_check_is_that_of_the_exact_engine():
    found = sv.check(normals_of_a)
    assert all(r.truth.relation is sv.relate(r.a, r.b) for r in found.results)


def test_the_data_of_a_report_hold_the_counterexample_as_a_scene_file():
    found = sv.check(bounding_boxes)
    assert isinstance(found, Checked) and found.data()["right"] is False
    assert sv.Scene.from_json(found.data()["scene"]) == found.counterexample


def test_a_check_in_a_page_exchanges_only_json_messages():
    """The trusted side sends pairs, and the side of the reader's code answers, both in JSON only."""
    import json

    from satviz.site import live

    def tell(content):
        return json.loads(live.answer("check", json.dumps(content)))

    code = (
        "print('once')\ndef collide(a, b):\n    print(b[0])\n    return max(p[0] for p in a) >= min(p[0] for p in b)\n"
    )
    assert tell({"kind": "define", "code": code}) == {"why": "", "printed": "once\n"}
    reply = tell({"kind": "check", "kinds": ["boxes", "convex"], "touching": "hit"})
    while reply["kind"] == "ask":
        outcomes = [tell({"kind": "call", **pair}) for pair in reply["pairs"]]
        pair = reply["pairs"][-1]
        reply = tell({"kind": "outcomes", "outcomes": outcomes})
    assert not reply["right"] and reply["link"] and sv.Scene.from_json(reply["scene"])
    outcome = tell({"kind": "call", **pair})
    assert outcome["printed"] == f"{tuple(map(int, pair['b']['polygon'][0]))}\n"
    judged = tell({"kind": "judge", **pair, "outcome": outcome})
    assert judged["kind"] == "judged" and judged["said"] in ("hit", "no hit")


def test_the_beginning_of_printed_output_is_kept_even_if_the_code_closes_it():
    from satviz.checking.reading import MAX_PRINTED, ReaderPython

    code = "import sys\ndef f(a, b):\n    for c in 'xy': print(c * 10**6)\n    sys.stdout.close()\n    return True\n"
    reader = ReaderPython()
    assert reader.answer({"kind": "define", "code": code}) == {"why": "", "printed": ""}
    box = {"polygon": [[0, 0], [1, 0], [1, 1]]}
    said = reader.answer({"kind": "call", "a": box, "b": box})
    assert said == {"value": True, "problem": "", "line": "", "printed": "x" * MAX_PRINTED}


@pytest.mark.parametrize(
    ("code", "why"),
    [
        ("def f(a, b:", "This is not Python: '(' was never closed in line 1."),
        ("1 / 0", "The code raises ZeroDivisionError in line 1: division by zero."),
        ("x = 1", "There is no function of two shapes"),
        ("raise KeyboardInterrupt", "The code raises KeyboardInterrupt in line 1."),
        ("x = 1\0", "This is not Python: the code has a null character."),
    ],
)
def test_code_without_a_function_is_refused_in_one_line(code, why):
    from satviz.checking.reading import ReaderPython

    said = ReaderPython().answer({"kind": "define", "code": code})["why"]
    assert said.startswith(why) and "\n" not in said


@pytest.mark.parametrize("forged", [None, 5, [], {"value": {"a": [1]}}, {"problem": "x\n" * 999, "line": ["y"]}])
def test_a_forged_outcome_of_a_worker_counts_as_a_wrong_answer(forged):
    from satviz.checking.answers import Rules
    from satviz.checking.reading import outcome_from
    from satviz.checking.results import judge

    result = judge(whole_number_pairs(("boxes",), 1)[0], outcome_from(forged), Rules())
    assert not result.right and len(result.line) < 600


def test_an_assertion_that_fails_shows_the_sentence_the_data_and_a_picture():
    a, b = [(0, 0), (2, 0), (0, 2)], [(2, 0), (4, 0), (2, 2)]
    sv.testing.assert_touching(a, b)
    sv.testing.assert_apart(a, sv.Circle((5, 5), 1))
    sv.testing.assert_overlapping(a, a)
    sv.testing.assert_same_relation(sat, [(a, b)])
    with pytest.raises(AssertionError) as failed:
        sv.testing.assert_apart(a, b)
    lines = str(failed.value).splitlines()
    assert lines[0] == "the shapes are not apart" and "touch" in lines[1]
    assert lines[2] == "a = sv.Polygon([(0, 0), (2, 0), (0, 2)])"
    path = Path(lines[-1].removeprefix("picture: "))
    assert path.read_text(encoding="utf-8").startswith("<?xml") and "pytest" in str(path)
    with pytest.raises(AssertionError, match="pair 1: the function says no hit"):
        sv.testing.assert_same_relation(touching_is_apart, [(a, a), (a, b)])


def test_a_wrong_function_unlike_all_known_mistakes_is_not_given_one_of_their_names():
    """No failing case looks at areas; and though its first answers are all False, it returns verdicts."""

    def by_area(a, b):
        return sat(a, b) and abs(sum(x0 * y1 - x1 * y0 for (x0, y0), (x1, y1) in zip(a, [*a[1:], a[0]]))) != 8

    found = sv.check(by_area)
    assert (
        found.finding == "wrong"
        and found.rules.returns == "hit"
        and not any(like.is_close for like in found.behaves_like)
    )
    assert "behaves like" not in str(found)


def test_a_smaller_scene_is_of_a_kind_that_was_tested():
    def on_x(a, b):
        return max(p[0] for p in a) >= min(p[0] for p in b)

    scene = sv.check(on_x, kinds="boxes").counterexample
    assert kind_of_pair(scene.a, scene.b) == "boxes"


def test_a_function_for_whole_numbers_only_gets_a_report_that_says_so():
    def whole(a, b):
        if any(not isinstance(x, int) for point in a for x in point):
            raise TypeError("whole numbers, please")
        return sat(a, b)

    found = sv.check(whole)
    assert found.finding == "error" and found.line.endswith("(whole_numbers=True leaves such pairs out)")
    assert "whole numbers, please" in found.line and sv.check(whole, whole_numbers=True).right


def test_a_function_with_one_answer_for_every_pair_is_reported_so_without_a_mistake():
    for said, words in (True, "hit"), (False, "no hit"):
        found = sv.check(lambda a, b, said=said: said)
        assert found.finding == "wrong" and not found.behaves_like and f"It says {words} for every pair." in str(found)
