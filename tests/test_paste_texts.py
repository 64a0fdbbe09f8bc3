"""Texts in notations of many libraries: each is read rightly, asked about, or named as unread."""

import random
import re
import time

import pytest
from pastes import PASTES
from reports import REPORTS
from speeds import one_in
from strangers import TEXTS

import satviz as sv


def bounds(read):
    """Return the bounding box of a shape as it was read."""
    reach = read.radius or 0
    xs, ys = zip(*read.points, strict=True)
    return tuple(float(v) for v in (min(xs) - reach, min(ys) - reach, max(xs) + reach, max(ys) + reach))


@pytest.mark.parametrize("paste", PASTES, ids=lambda paste: re.sub(r"\W+", "-", paste.name))
def test_a_text_is_read_correctly_or_its_unread_part_is_named(paste):
    try:
        pasted = sv.paste(paste.text, paste.as_)
    except sv.InvalidScene as error:
        assert not paste.bounds and paste.says and paste.says in str(error)
        return
    if [question.what for question in pasted.questions if question.matters] == ["rest"]:
        assert paste.says and paste.says in str(pasted.questions[0]) and not pasted.shapes
        pasted = sv.paste(paste.text, f"{paste.as_} leave-out")
    assert [bounds(each.read) for each in pasted.readings] == [pytest.approx(b) for b in paste.bounds]
    assert paste.says in " ".join(map(str, pasted.findings))
    assert not pasted.open


@pytest.mark.parametrize("text", TEXTS, ids=lambda text: re.sub(r"\W+", "-", text.name))
def test_an_outside_text_is_answered_at_once_unless_a_question_is_necessary(text):
    if not text.bounds:
        with pytest.raises(sv.InvalidScene):
            sv.paste(text.text)
        return
    assert sv.paste(text.text).open == text.asks
    pasted = sv.paste(text.text, text.as_)
    assert not pasted.open and pasted.shapes
    assert [bounds(each.read) for each in pasted.readings] == [pytest.approx(b, abs=1e-3) for b in text.bounds]


def answer(text, as_=""):
    """Whether a question is open, the shapes as they were read, and what is asked; None for a text that is refused."""
    try:
        pasted = sv.paste(text, as_)
    except sv.InvalidScene:
        return None
    shapes = [(each.read.points, each.read.radius) for each in pasted.readings]
    return pasted.open, shapes, [question.what for question in pasted.questions]


def every_line(text, sign):
    """The text with a sign before each of its lines."""
    return "\n".join(sign + line for line in text.split("\n"))


ANSWERED = [each for each in (*PASTES, *TEXTS) if each.bounds and not each.name.startswith(("diff", "a change", "DXF"))]


@pytest.mark.parametrize("part", one_in(2, range(4)))
def test_a_quoted_text_is_read_as_the_text_itself(part):
    for each in ANSWERED[part::4]:
        assert answer(every_line(each.text, "> "), each.as_) == answer(each.text, each.as_), each.name


@pytest.mark.parametrize("part", one_in(2, range(4)))
def test_a_change_is_read_as_the_text_that_it_leads_to(part):
    for old, new in zip(ANSWERED[part::4], ANSWERED[part + 1 :: 4], strict=False):
        if "\n@@" not in old.text + new.text:
            lines = every_line(old.text, "-"), every_line(new.text, "+")
            change = "\n".join(("--- a/x", "+++ b/x", "@@ -1,4 +1,4 @@", *lines))
            assert answer(change, new.as_) == answer("\n" + every_line(new.text, " "), new.as_), (old.name, new.name)


@pytest.mark.parametrize("call", ["set", "setTo", "setBounds", "setRect", "setFrame", "update"])
@pytest.mark.parametrize("kind, numbers", [("Rectangle", "10, 11, 4, 5"), ("java.awt.Rectangle", "1, 2, 3, 4")])
def test_numbers_given_anew_replace_those_of_the_constructor(call, kind, numbers):
    text = "a = new {0}({1});\nb = new Circle(3, 4, 5);\n{2}"
    once = answer(text.format(kind, numbers, ""))
    assert answer(text.format(kind, "0, 0, 9, 9", f"a.{call}({numbers});"))[:2] == (once[0], once[1][::-1])


@pytest.mark.parametrize("rows", ["[{}]\n", "a = [{}];", "np.array([{}])", "polygon: {}\n"])
@pytest.mark.parametrize(
    "sign",
    ["...", "\u2026", "... 12 more", "... and 12 more", "... 97 more items", "(truncated)", "<12 more>", "[truncated]"],
)
def test_a_list_that_is_shortened_is_never_answered(rows, sign):
    text = rows.format(f"(0, 0), (4, 0), (4, 4), {sign}") + "\ncircle((9, 9), 1)\ncircle((7, 9), 1)"
    assert sv.paste(text).open and "a list is shortened" in sv.paste(text).sentence
    behind = rows.format(f"(0, 0), (4, 0), {sign}, (4, 4)") + "\ncircle((9, 9), 1)\ncircle((7, 9), 1)"
    assert sv.paste(behind).open


@pytest.mark.parametrize(
    "text", ["circle(({0}, {1}), {2})", "Rectangle({0}, {1}, {2}, 0)", "{{x: {0}, y: {1}, r: {2}}}"]
)
@pytest.mark.parametrize("unit", ["px", "mm", " cm", "m"])
def test_a_number_without_a_unit_among_others_with_one_is_asked_about(text, unit):
    given = "10" + unit, "5" + unit, "3" + unit
    assert not sv.paste(text.format(*given)).open
    for i in range(3):
        numbers = [number if k != i else number.removesuffix(unit) for k, number in enumerate(given)]
        assert "without a unit" in sv.paste(text.format(*numbers)).sentence
        numbers[i] = "0"
        assert "without a unit" not in answer_in_words(text.format(*numbers))


def answer_in_words(text):
    """The sentence of a text, or why it is refused."""
    try:
        return sv.paste(text).sentence
    except sv.InvalidScene as error:
        return str(error)


AFTER_A_NUMBER = (
    " * 2", " + 1", " - d", "*k", " / 2", " % 3", " ** 2", "^2", " << 1", " >> 1", " | 1", " & 3", "++", ".sin()",
    " if c else 9", " ? 1 : 2", "%", "!", " mod 2", " || 9", "\u00b2", " ?? 3", " max 3", " times 2",
)  # fmt: skip
AFTER_A_BRACKET = (
    " * 2", ".T", ".scale(2)", "[::-1]", " + d", " @ m", " << 1", " if c else d", ".rotate(t)", ".flip()", "'", " - 1",
    ".map(f)", ".clone().flip()", " ** 2", "[1:]", ".mirrored", " || d", " |> f", " % d", ".get().flip()", " .* 2",
)  # fmt: skip
BEFORE_A_BRACKET = ("-", "~", "-1 * ", "!!", "2 * ", "d + ", "mirror ", "half * ", "!", "scale(2) * ", "k*")
LINES_BEHIND = (
    "{}.x += 5", "{} *= 2", "flip({})", "{}.flip()", "scale({}, 2)", "{}.vertices[0].x -= 2", "{0} = {0} * 2",
)  # fmt: skip


def places_of_data(pasted):
    """Yield the places after the numbers and around the brackets of the shapes, each with texts to insert there."""
    text = pasted.text
    for each in pasted.readings:
        yield from ((place, AFTER_A_NUMBER) for place in sorted(each.read.used))
        for place in range(each.read.start + 1, each.read.end):
            if re.search(r"//|#|--|^-  ", text[text.rfind("\n", 0, place) + 1 : place]):
                continue  # in a comment, or in a line that a change removes
            before, here = text[place - 1], text[place]
            if before in ")]" and place > 1 and text[place - 2].isalnum():
                yield place, AFTER_A_BRACKET
            if here in "([" and not before.isalnum() and before not in "!_":
                yield place, BEFORE_A_BRACKET


def attack(count, seed):
    """Insert a sign or a call beside the data of answered texts, or a line after them; return those still answered."""
    rng = random.Random(seed)
    answered = [sv.paste(each.text, each.as_) for each in (*PASTES, *REPORTS, *TEXTS) if getattr(each, "bounds", True)]
    answered = [p for p in answered if not p.open and p.traces and "leave-out" not in p.chosen and "_" not in p.chosen]
    for _ in range(count):
        pasted = rng.choice(answered)
        place, signs = rng.choice(list(places_of_data(pasted)) or [(0, ("",))])
        sign = rng.choice(signs)
        names = [
            each.label for each in pasted.readings if each.label.isidentifier() and f"{each.label} =" in pasted.text
        ]
        if names and rng.random() < 0.2:
            place, sign = len(pasted.text), "\n" + rng.choice(LINES_BEHIND).format(rng.choice(names))
        changed = pasted.text[:place] + sign + pasted.text[place:]
        try:
            assert not sign or sv.paste(changed, pasted.chosen).open, (sign, changed[max(0, place - 80) : place + 80])
        except sv.InvalidScene:
            continue


def test_a_sign_beside_the_data_is_never_dropped_without_a_question():
    attack(60, seed=1)


@pytest.mark.slow
def test_none_of_two_thousand_signs_beside_the_data_is_dropped_without_a_question():
    attack(2000, seed=2)


CHANGES = (
    "{} * 2", "2 * {}", "{}.T", "{}.scale(2)", "{}.buffer(d)", "{}[1:]", "{} + d", "{} @ m", "-{}", "~{}", "mirror({})",
    "list(map(f, {}))", "{} if c else ((9, 9), (8, 9), (9, 8))", "c ? {} : d", "{} << 1", "{}.rotate(t)", "{} - offset",
)  # fmt: skip
PLAIN = (
    "((0, 0), (4, 0), (0, 3))",
    "Polygon([(0, 0), (4, 0), (0, 3)])",
    "Polygon(pts)",
    "np.array([[0, 0], [4, 0], [0, 3]])",
)


@pytest.mark.parametrize("change", CHANGES)
@pytest.mark.parametrize("plain", PLAIN)
def test_words_around_a_shape_are_never_dropped_without_a_question(plain, change):
    text = "pts = [(0, 0), (4, 0), (0, 3)]\na = {}\ncircle((9, 9), 1)"
    assert len(sv.paste(text.format(plain)).shapes) == 2 + (plain[0] == "(" or "array" in plain or "[(" in plain)
    try:
        assert sv.paste(text.format(change.format(plain))).open
    except sv.InvalidScene as error:
        assert "evaluated" in str(error)


@pytest.mark.parametrize(
    "text",
    [
        "a = [0 4 4 0; 0 0 4 4]';\ncircle((9, 9), 1)",
        "a = structure(c(0, 4, 4, 0, 0, 3), dim = c(3L, 2L).map(f))\ncircle((9,9),1)",
        "a=[lerp(0,1),lerp(2,3),lerp(4,9)]\nb=[(0,0),(1,0),(1,1)]",
        "a: 1,000 2,000 1,500 3,000 800 900\nb = [(0,0),(1,0),(1,1)]",
        "a = Circle(0, 0, 5)\nif big:\n    a = Circle(0, 0, 50)\nb = Circle(7, 0, 5)",
        "a = {x: 0, y: 0, r: 5}\nb = {x: 20, y: 0, r: 5}\na.x = b.x",
        "a = Circle(0, 0, 5)\na.flipX()\nb = Circle(7, 0, 5)",
        "a = {x: 0, y: 0, r: 5, mirrored: true}\nb = {x: 20, y: 0, r: 5}",
        "A: rect(0, 0, 4, 4) but twice as large\nB: rect(3, 3, 4, 4)",
        "poly = Polygon([(0,0),(4,0),(0,3)])\nbox = shapely.box(0,0,1,1)\nc = poly.union(box)",
        "circle(x ? 1 : 2, 3, 1)\ncircle((0, 0), 1)",
        '<rect x="0" y="0" width="10 - w" height="10"/><circle cx="5" cy="5" r="3"/>',
        '<path d="M 0 0 L 10 0 L 10++ 10 Z"/><circle cx="5" cy="5" r="3"/>',
        "v = [(0,0),(4,0),(0,3)]\nd = [(9,9),(8,9),(9,8)]\na = Polygon(v if c else d)\ncircle((0,0), 1)",
        "new THREE.Box2.flip()(new V(0,0), new V(4,4))\nnew THREE.Box2(new V(1,1), new V(5,4))",
        "verts[0] = (0,0)\nverts[1] << 1 = (4,0)\nverts[2] = (0,3)\ncircle((9,9), 1)",
        "circle((9,9), 1)\ncircle((0,0), 1)\nB is twice as large",
        "circle((9,9), 1)\na = [(0,0),(1,0),(0,1)",
        "1: (0,0) or d (4,0) (4,4)\n2: (5,0) (9,0) (9,4)",
        "1: (0,0)\u00b2 (4,0) (4,4)\n2: (5,0) (9,0) (9,4)",
        "polygon (0,0) when big, (4,0), (0,3)\ncircle((9,9), 1)",
        "ctx.moveTo(0, 0);\nctx.lineTo(40, 0) or d;\nctx.lineTo(0, 30);\ncircle((9,9), 1)",
        "v[0] = (0,0)\nv[1] = (4,0) and d\nv[2] = (0,3)\ncircle((9,9), 1)",
        "circle((9,9), 1) if big\ncircle((0,0), 1)",
        "circle((9,9), 1) . flip\ncircle((0,0), 1)",
        '<object x="1" y="1" rotation=""><polygon points="0,0 32,0 32,32"/></object>\ncircle((0,0), 1)',
        "a = flip . id $ [(0,0),(4,0),(4,4)]\ncircle((0,0), 1)",
        "p = [(0,0),(4,0),(4,4)]\nhull = ConvexHull(p)\nflip(hull)\ncircle((0,0), 1)",
        "a circle at (0, 0) with radius 2 m.sin()\ncircle((0,0), 1)",
        "draw.circle(s, (255, 0, 9\u00b2), (4, 4), 9)\ncircle((0,0), 1)",
        "hit = collideCirclePoly(45 || 9, 100, 30, p)\np = [(0,0),(4,0),(0,3)]\ncircle((0,0), 1)",
        "a.bounds: Center: mirror (0, 0, 0), Extents: (1, 1, 0)\nb.bounds: Center: (0, 2, 0), Extents: (1, 1, 0)",
        "circle: center = (0, 0), radius = 6!\ncircle: center = (3, 4), radius = 2",
        "a circle at (0, 0) with radius 6! and a circle at (3, 4) with radius 2",
        "a = ball(0.5).translation(vector![0.0, 0.5]).restitution(0.7).clone().flip().build();\nball(1)",
        "a = [\n  - [3, 3],\n  [3, 4],\n  [4, 4]\n]\ncircle((9,9), 1)",
        "Polygon([new flipped(0, 0), new Vec2(4, 0), new Vec2(4, 3)])\ncircle((9,9), 1)",
        "{mins: not [0, 0], maxs: [1, 1]}\n{mins: [1, 0], maxs: [2, 1]}",
        "a = size ?? new Rectangle(0, 0, 4, 4);\nb = Circle(6, 6, 1)",
        "a = size || new Rectangle(0, 0, 4, 4);\nb = Circle(6, 6, 1)",
        "a = size or Rectangle(0, 0, 4, 4)\nb = Circle(6, 6, 1)",
        "`POLYGON mirror ((0 0, 4 0, 0 3, 0 0))`\n`POLYGON ((0 0, 4 0, 0 3, 0 0))`",
        "a.bounds: Center: (2, 2, 0)[1:], Extents: (1, 1, 0)\nb.bounds: Center: (0, 2, 0), Extents: (1, 1, 0)",
        "p = Polygon()\np.addPoint(0, 0) % d\np.addPoint(4, 0)\np.addPoint(4, 4)\nr = Rectangle(9, 0, 5, 5)",
        "<POLYGON not ((0 0, 4 0, 0 3, 0 0))>\n<POLYGON ((0 0, 4 0, 0 3, 0 0))>",
        "| x | y | w | h |\n|---|---|---|---|\n| 0 | 0 | 9 | 9 |\n| 9 | 0 | 9 | 9 | 1 |\nbox(0, 0, 1, 1)",
        "<coordinates>0,0 4,0 0,3 and 2 0,0</coordinates>\n<coordinates>1,0 4,0 1,3 1,0</coordinates>",
        '<rect x="0" y="0" width="9" height="9" transform="translate(20.sin(), 5)"/><circle cx="5" cy="5" r="3"/>',
        "\\draw (0,0) -- 2*(3,0) -- (3,2) -- cycle;\n\\draw (2,1) circle (1);",
        "\\draw (0,0) -- (3,0) -- (3,2) -- cycle + (1,1);\n\\draw (2,1) circle (1);",
        "\\draw[fill=red!20] mirror (0,0) -- (3,0) -- (3,2) -- cycle;\n\\draw (2,1) circle (1);",
        "\\draw[rotate=30] (0,0) -- (3,0) -- (3,2) -- cycle;\n\\draw (2,1) circle (1);",
    ],
)
def test_an_unknown_part_gives_a_question(text):
    pasted = sv.paste(text, "corner-size")
    assert pasted.open and not pasted.shapes and not pasted.traces
    assert "\n" not in pasted.sentence and len(pasted.sentence) < 500


def test_the_report_says_once_what_was_not_understood():
    report = str(sv.paste("{x=0 y=0 r=5}\tmoved 4\n{x=3 y=0 r=5}"))
    assert report.count("Not understood") == 1
    assert "or take the shapes without it.\n  --as leave-out" in report


def test_a_short_unknown_part_is_named_with_its_line():
    asked = sv.paste("verts[0] = (0,0)\nverts[1] << 1 = (4,0)\nverts[2] = (0,3)").questions[0].asks
    assert asked == "Not understood: << (in verts[1] << 1 = (4,0))."


@pytest.mark.parametrize("call", ["a.clone()", "copy.deepcopy(a)", "a.copy()"])
def test_a_copy_is_a_shape_of_its_own(call):
    text = f"a = {{x: 0, y: 0, r: 5}}\nb = {call}\nc = {{x: 20, y: 0, r: 5}}"
    assert [each.label for each in sv.paste(text).readings] == ["a", "b", "c"]
    assert sv.paste(f"{text}\nb.x = 7").open


def test_a_call_that_gives_the_hull_of_points_is_read_as_the_hull():
    pasted = sv.paste("p = [(0,0),(4,0),(1,1),(0,3)]\nh = cv2.convexHull(p)\ncircle((9, 9), 1)")
    assert pasted.shapes[0].vertices == ((0, 0), (4, 0), (0, 3))
    assert pasted.readings[0].said == "a polygon of 3 corners, the convex hull of 4 points"


@pytest.mark.parametrize(
    "text",
    [
        "(0,5; 0,5) (4,5; 0,5) (0,5; 3,5)",
        "POLYGON((0,5 0,5, 4,5 0,5, 0,5 3,5))",
        "[(0,5, 0,5), (4,5, 0,5), (0,5, 3,5)]",
        "x\ty\n0,5\t0,5\n4,5\t0,5\n0,5\t3,5\n",
        "A\n0,5\t0,5\n4,5\t0,5\n0,5\t3,5\n",
    ],
)
def test_decimal_commas_are_asked_about_and_then_read(text):
    (question,) = sv.paste(f"{text}\n{text}").questions
    assert [answer.choice for answer in question.answers] == ["decimal-commas", "separators"]
    first, second = sv.paste(f"{text}\n{text}", "decimal-commas").readings
    assert first.vertices == second.vertices == ((0.5, 0.5), (4.5, 0.5), (0.5, 3.5))
    assert "0,5" in first.excerpt


@pytest.mark.parametrize(
    "text",
    [
        "x;y;w;h\n0;1;4;4\n2;2;4,5;4\n",
        "name;x;y;radius\nA;1;2;3,5\nB;4;2;1,5\n",
        "A\n0,5;1,5\n4,5;1,5\n4,5;5,5\nB\n2,5;2,5\n6,5;2,5\n6,5;6,5\n",
        "A: 0,5; 1,5; 4,5; 1,5; 4,5; 5,5\nB: 2,5; 2,5; 6,5; 2,5; 6,5; 6,5\n",
    ],
)
def test_columns_of_a_spreadsheet_with_decimal_commas_are_asked_about(text):
    assert [question.what for question in sv.paste(text).questions] == ["commas"]


@pytest.mark.parametrize(
    "text", ["[(0,0),(4,0),(0,3)] 0,0 4,0", 'points="0,5 4,5 0,3"', "0,5;4,0;0,3", "Rect(0,5, 4,5)"]
)
def test_commas_between_numbers_are_no_decimal_commas(text):
    try:
        assert "commas" not in [question.what for question in sv.paste(text).questions]
    except sv.InvalidScene as error:
        assert "comma" not in str(error)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("<Widget>:\n    canvas:\n        Rectangle:\n            pos: 10, 20\n            size: 9, 9", "Kivy"),
        ("shapes {\n  shape_type: TYPE_BOX\n  position {\n    x: 0.0\n  }\n}\ndata: 16.0", "Defold"),
    ],
)
def test_an_unclear_text_gives_a_hint_how_to_write_it(text, said):
    with pytest.raises(sv.InvalidScene, match=f"{said} (is|are) not read: write each shape on its own line"):
        sv.paste(text)


def test_no_reading_is_called_chosen_while_a_question_is_open():
    text = "THREE.Box2((0, 0), (4, 4)).flip()\n[0, 0, 10, 10]\n[1, 1, 11, 11]"
    pasted = sv.paste(text)
    assert pasted.open and [question.matters for question in pasted.questions] == [True, False]
    assert "was taken" not in str(pasted).partition("Without it:")[0]
    assert "was taken" in str(sv.paste("[0, 0, 10, 10]\n[1, 1, 11, 11]"))


@pytest.mark.parametrize(
    "comment",
    [
        "# a circle at (9, 9) with radius 3",
        "// newpath 0 0 moveto 4 0 lineto 4 4 lineto closepath",
        '<!-- <circle cx="9" cy="9" r="1"/> -->',
        "/* circle((9, 9), 1) */",
    ],
)
def test_a_shape_in_a_comment_is_not_read(comment):
    circles = "circle((1, 1), 1)\n", "circle((2, 1), 1)\n"
    for text in (f"{circles[0]}{comment}\n{circles[1]}", f"{circles[0]}{circles[1]}{comment}"):
        assert [each.read.points for each in sv.paste(text).readings] == [((1, 1),), ((2, 1),)]


def test_a_name_with_two_values_is_asked_about():
    text = "a = [(0,0),(1,0),(1,1)]\na = [(9,9),(10,9),(10,10)]\nb = [(3,3),(4,3),(4,4)]"
    assert [len(sv.paste(text, as_).shapes) for as_ in ("", "each-value", "last-value")] == [0, 3, 2]


def test_a_corner_is_added_once_however_often_the_text_is_read():
    text = "pts = [(0, 0), (4, 0)]\npts.append((4, 4))\npts.append((0, 4))\n[1, 1, 2, 2]"
    pasted = sv.paste(text)
    assert [len(each.vertices) for each in pasted.readings] == [4, 4] and pasted.questions
    (shape, _) = sv.paste(text, "corner-size").shapes
    assert shape.bounds == (0, 0, 4, 4)


@pytest.mark.parametrize("place", range(4))
@pytest.mark.parametrize("item", ["[1]", "[1, 2, 3, 4]", "[1, 2, 3, 4, 5]", "[(1, 2), (3, 4)]"])
def test_the_item_of_a_list_that_is_not_a_corner_is_named_by_its_place(place, item):
    for corners in (["(0, 0)"], ["(0, 0)", "(4, 0)"], ["(0, 0)", "(4, 0)", "(0, 4)"]):
        if place <= len(corners):
            text = ", ".join([*corners[:place], item, *corners[place:]])
            with pytest.raises(sv.InvalidScene, match=rf"(item|corner) {place} \(counted from 0\)"):
                sv.paste(f"[{text}]")


def test_a_missing_corner_and_lists_of_two_lengths_are_named():
    for text, said in (
        ("v[0] = (0, 0); v[1] = (4, 0); v[3] = (0, 4)", r"v\[2\] is missing"),
        ("v[2] = (0, 0); v[3] = (4, 0); v[4] = (0, 4)", r"begin with \[2\]"),
        ("xs = [0, 4, 4]; ys = [0, 0, 4, 4]", "3 and 4 numbers"),
        ("x = [0, 1, 0]\ny = [0, 0]", "3 and 2 numbers"),
        ("v = [(0, 0), (4, 0), (0, 4)]; v[1] = (9, 9)", "changed after"),
        ("new Polygon(new int[]{0, 4, 4}, new int[]{0, 0, 4}, 9)", "3 and 3 numbers, and the call says 9 corners"),
        ("0 0.5 0.5 0.2 0.2", "five numbers"),
        ('{"center": [0, 0], "width": 4, "height": 4, "originX": "right"}', "origin"),
        ('{"vertices": [[0,0],[1,0],[0,1]], "offset": [1, 1], "angle": 30}', "offset and an angle"),
        ("{left: 0, top: 0, right: 4, bottom: 4, width: 9, height: 4}", "width and height"),
    ):
        with pytest.raises(sv.InvalidScene, match=said):
            sv.paste(text)


@pytest.mark.parametrize(
    "line, said",
    [
        ("circle(-w, 0, 1)", "-w is not evaluated"),
        ("c = {x: -w, y: 0, r: 1}", "-w is not evaluated"),
        ("[(-w, -w), (w, -w), (w, w)]", "-w is not evaluated"),
        ("Circle(-Vec2(1, 2), 1)", r"-Vec2\(1, 2\) is not evaluated"),
        ("c = -np.array([(0, 0), (4, 0), (0, 3)])", "not evaluated"),
        ("c = np.array([(0, 0), (4, 0), (0, 3)]) @ turn", "not evaluated"),
        ("c = list(map(half, [(0, 0), (4, 0), (0, 3)]))", r"map\(\.\.\.\) is not evaluated"),
        ("circle(sqrt(4), 3, 1)", r"sqrt\(4\) is not evaluated"),
        ("circle(3, sqrt(4), 2, 1)", r"sqrt\(4\) is not evaluated"),
        ("Circle(Vec2(sqrt(4), 0), 1)", r"sqrt\(4\) is not evaluated"),
        ("Circle(Vec2(0, 0), sqrt(4), 1)", r"sqrt\(4\) is not evaluated"),
        ("for i in range(3): circle(i, 5, 1)", "i is a name"),
    ],
)
def test_a_sign_or_a_call_around_a_number_is_not_dropped(line, said):
    with pytest.raises(sv.InvalidScene, match=said):
        sv.paste(f"w = 3\n{line}")


def test_a_line_may_begin_with_a_bullet_without_a_space():
    assert [each.read.points for each in sv.paste("-circle((1, 2), 3)\n-circle((3, 2), 1)").readings] == [
        ((1, 2),),
        ((3, 2),),
    ]


def test_a_color_before_the_center_of_a_circle_is_no_expression():
    (shape,) = sv.paste("draw.circle(screen, Color(255, 0, 0), (1, 2), 3)").readings
    assert (shape.read.points, shape.read.radius) == (((1, 2),), 3)


@pytest.mark.parametrize("mark", [",", ";", "\t", " "])
def test_a_table_of_two_corners_is_one_of_boxes_and_of_three_one_of_triangles(mark):
    boxes = sv.paste(mark.join(("x1", "y1", "x2", "y2")) + "".join(f"\n{mark.join(row)}" for row in ("0044", "1155")))
    assert [each.bounds for each in boxes.shapes] == [(0, 0, 4, 4), (1, 1, 5, 5)] and not boxes.questions
    names = ("x1", "y1", "x2", "y2", "x3", "y3")
    triangles = sv.paste(",".join(names) + "\n0,0,4,0,4,4\n1,1,5,1,5,5")
    assert [each.bounds for each in triangles.shapes] == [(0, 0, 4, 4), (1, 1, 5, 5)]
    assert all(len(each.vertices) == 3 for each in triangles.shapes)


@pytest.mark.parametrize(("x", "y"), [("0,1,0", "0,0"), ("0,0", "0,0,1"), ("0,1,0,2", "0,0,1")])
def test_lists_of_x_and_y_of_different_lengths_are_refused(x, y):
    with pytest.raises(sv.InvalidScene, match="write one x and one y for each corner"):
        sv.paste(f'{{"x": [{x}], "y": [{y}]}}')


def test_a_table_with_sizes_is_not_read_as_corners():
    boxes = sv.paste("x,y,half_width,half_height\n0,0,2,1\n9,9,1,1")
    assert [each.bounds for each in boxes.shapes] == [(-2, -1, 2, 1), (8, 8, 10, 10)]
    for names in ("x,y,rx,ry", "x,y,size,id"):
        with pytest.raises(sv.InvalidScene, match="names of the columns fit no shape"):
            sv.paste(names + "\n0,0,2,1\n9,0,1,1\n9,9,1,1")


def test_a_hole_is_not_read_as_a_shape_of_its_own():
    for text in (
        "Polygon(shell=[(0, 0), (4, 0), (0, 3)], holes=[[(1, 1), (2, 1), (1, 2)]])",
        "{outer: [[0, 0], [4, 0], [0, 3]], holes: [[[1, 1], [2, 1], [1, 2]]]}",
    ):
        pasted = sv.paste(text)
        assert [each.vertices for each in pasted.readings] == [((0, 0), (4, 0), (0, 3))]
        assert "holes 1, 1, 2, 1, 1, 2" in str(pasted)


def test_a_variable_that_is_counted_up_is_named():
    for step in ("x++", "x--", "++x", "--x"):
        pasted = sv.paste(f"x = 5; {step}; circle((x, 0), 1); circle((0, 0), 1)")
        assert pasted.open and {*step} <= {*pasted.sentence.partition(":")[2]}


def test_a_variable_has_the_value_last_assigned_above_its_use():
    pasted = sv.paste("x = 2\ncircle((x, 0), 1)\nx = 5\ncircle((x, 0), 1)\nx = 9")
    assert [each.read.points[0][0] for each in pasted.readings] == [2, 5]


def test_an_unread_part_is_named_once():
    pasted = sv.paste("this.add.circle(9, 9, 4)\nthis.add.rectangle(15, 10, 4, 2).setOrigin(0, 0)")
    assert "setOrigin" in pasted.questions[0].asks and pasted.findings == ()


def test_several_refused_shapes_are_listed_in_words():
    pasted = sv.paste("[0,0, 1,1, 2,2]\n[0,0, 2,2, 3,3]\n[0,0, 1,1, 5,5]")
    assert pasted.sentence == "A, B and C are not valid shapes, so there is no answer."
    assert sv.paste("[0, 0, 4, 4]\n[3, 3, 1, 2]").sentence.startswith("Four readings are possible")


@pytest.mark.parametrize(
    "text",
    [
        pytest.param("a.push(1, 2)\n" * 16_000, marks=pytest.mark.slow),
        "<rect " * 170_000,
        pytest.param('<rect x="' * 100_000, marks=pytest.mark.slow),
        pytest.param('"M' * 400_000, marks=pytest.mark.slow),
        "[a" * 400_000,
        pytest.param("x: 1 " * 39_000, marks=pytest.mark.slow),
        pytest.param("1 vs " * 59_000, marks=pytest.mark.slow),
        pytest.param("1 px " * 59_000, marks=pytest.mark.slow),
        pytest.param("0.0 | a: b" * 39_000, marks=pytest.mark.slow),
        pytest.param("hexagon ellipse " * 29_000, marks=pytest.mark.slow),
        pytest.param("center point, X= " * 15_000, marks=pytest.mark.slow),
        pytest.param("1 2 moveto " + "3 4 lineto " * 16_000, marks=pytest.mark.slow),
        pytest.param("LWPOLYLINE\n" + " 10\n1.0\n" * 29_000, marks=pytest.mark.slow),
        "x" * 100_000 + " = [1, 2, 3]",
        pytest.param('<path d="M' + "1 2 " * 15_000 + 'z"/>', marks=pytest.mark.slow),
        pytest.param("lineTo(1, 2)\n" * 16_000, marks=pytest.mark.slow),
        "a: " * 2_000,
        "a = " * 2_000,
        pytest.param("a." * 500_000, marks=pytest.mark.slow),
        '"\\' * 400_000,
        pytest.param("<!--" * 250_000, marks=pytest.mark.slow),
        pytest.param("radius of the center and " * 6_000, marks=pytest.mark.slow),
        pytest.param('<g transform="translate(1,2)">' * 4_000, marks=pytest.mark.slow),
        pytest.param("".join(f"rect(1 + 2, 3, 4, {i})\n" for i in range(3_000)), marks=pytest.mark.slow),
        pytest.param("}\t" * 500_000, marks=pytest.mark.slow),
        pytest.param("@export var\n" * 80_000, marks=pytest.mark.slow),
        pytest.param("class_name a\n" * 80_000, marks=pytest.mark.slow),
        pytest.param(" " * 200_000 + "-" + "\t" * 200_000, marks=pytest.mark.slow),
        pytest.param("Nov 27 11:06:25 " * 60_000, marks=pytest.mark.slow),
        pytest.param("edit [0, 0, 1, 1] " * 5_000, marks=pytest.mark.slow),
        pytest.param("a:\n  b: 1\n" * 8_000, marks=pytest.mark.slow),
        pytest.param("a:\n" + "  b: 1\n" * 16_000, marks=pytest.mark.slow),
        pytest.param('[node name="a"]\n' * 7_000, marks=pytest.mark.slow),
        pytest.param("m_Paths:\n" * 100_000, marks=pytest.mark.slow),
        pytest.param(":add(a, 1" * 11_000, marks=pytest.mark.slow),
        pytest.param("".join(" " * i + "a:\n" for i in range(1_000)), marks=pytest.mark.slow),
        pytest.param('<g transform="scale(2)">' * 9_000, marks=pytest.mark.slow),
        pytest.param('<g transform="scale(' + "2 " * 30_000 + ')">', marks=pytest.mark.slow),
        pytest.param("<g " * 300_000, marks=pytest.mark.slow),
        "POLYGON Z(" + "1" * 100_000,
        pytest.param("1,1;" * 5 + "x1,1;" * 30_000, marks=pytest.mark.slow),
        pytest.param("a;b\n" * 100_000, marks=pytest.mark.slow),
    ],
    ids=range(42),
)
def test_a_long_text_in_these_notations_is_refused_in_linear_time(text):
    start = time.process_time()
    with pytest.raises(sv.InvalidScene):
        sv.paste(text)
    assert time.process_time() - start < 20  # a slow machine takes five; quadratic time would be minutes


@pytest.mark.parametrize(
    "change",
    [
        lambda text: text.replace(" ", "\u00a0"),
        lambda text: "\ufeff" + text,
        lambda text: text.replace("(", "\uff08").replace(")", "\uff09").replace(",", "\uff0c"),
        lambda text: text.replace("\n", "<br>\n"),
        lambda text: every_line(text, "    "),
        lambda text: "class Thing {\n    float x = 0, y = 0;\n    float r = 1;\n}\nThing t;\n" + text,
        lambda text: "class Thing:\n    x = 0\n    y = 0\n    r = 1\n\nprint(Thing)\n" + text,
    ],
)
def test_additions_of_a_page_or_a_class_do_not_change_the_shapes(change):
    text = "a = Circle(0, 0, 5)\nb = Polygon([(4, 0), (9, 0), (9, 4)])"
    assert answer(change(text))[1] == answer(text)[1] and not answer(change(text))[0]


@pytest.mark.parametrize("words", ["contact points", "normals", "axes", "simplex", "Minkowski difference", "overlap"])
def test_the_printed_result_of_a_test_is_not_read_as_a_shape(words):
    text = "a = Circle(0, 0, 5)\nb = Circle(9, 0, 5)\n"
    assert answer(f"{text}{words}: (5, 0), (6, 2), (7, 9)")[1] == answer(text)[1]


@pytest.mark.parametrize(
    "text",
    [
        "a {} at (0, 0) with radius 5 and a circle at (9, 0) with radius 3",
        '{{"type": "{}", "x": 0, "y": 0, "width": 10, "height": 6}}\n'
        '{{"type": "rectangle", "x": 9, "y": 4, "width": 1, "height": 6}}',
        "{}: kind={} x=0 y=0 r=5\nb: kind=circle x=9 y=0 r=5",
    ],
)
@pytest.mark.parametrize("kind", ["ellipse", "hexagon", "triangle", "capsule", "oval", "diamond", "8-gon"])
def test_a_shape_of_another_kind_is_never_taken_for_a_circle_or_a_box(text, kind):
    pasted = sv.paste(text.format(kind, kind))
    assert not pasted.shapes and f"of another kind: {kind}" in pasted.sentence


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("Square center (0, 0) radius 5\nCircle center (8, 0) radius 3", "Square"),
        ("rectangle at (0, 0) with radius 5 and a circle at (9, 0) with radius 3", "rectangle"),
        (
            '[{"type": "arrow", "x": 0, "y": 0, "width": 9, "height": 5}, {"x": 5, "y": 0, "width": 4, "height": 4}]',
            "arrow",
        ),
    ],
)
def test_a_square_with_a_radius_and_an_arrow_with_a_width_are_asked_about(text, kind):
    pasted = sv.paste(text)
    assert not pasted.shapes and f"of another kind: {kind}" in pasted.sentence


@pytest.mark.parametrize(
    "text",
    [
        "a: pos (0,0) size (2,2) angle {}\nb: pos (9,0) size (2,2)",
        "a = {{x: 0, y: 0, w: 2, h: 2, rotation: {}}}\nb = {{x: 9, y: 0, w: 2, h: 2}}",
    ],
)
@pytest.mark.parametrize("unit", ["deg", "degrees", "\u00b0", "rad", "radians"])
@pytest.mark.parametrize("space", ["", " "])
def test_an_angle_with_its_unit_turns_a_box_and_is_not_asked_about(text, unit, space):
    pasted = sv.paste(text.format(f"0.5{space}{unit}"))
    assert not {"angle", "rest"} & {question.what for question in pasted.questions}
    assert pasted.readings[0].said.endswith(f"turned by 0.5 {'radians' if unit[0] == 'r' else 'degrees'}")


BOTH = "a = [(0,0),(4,0),(4,4),(0,4)]\nb = [(2,2),(6,2),(6,6),(2,6)]\n"


@pytest.mark.parametrize(
    "line",
    [
        "result = [(2,2),(4,2),(4,4)]",
        "expected = [(2,2),(4,2),(4,4)]",
        "Got: POLYGON((2 2, 4 2, 4 4, 2 2))",
        "union: (2,2), (4,2), (4,4)",
        "Answer: 2,2 4,2 4,4",
        "clip(a, b) = [(2,2),(4,2),(4,4)]",
        "a = [(0,0),(4,0),(4,4),(0,4)]",
    ],
)
def test_a_result_or_a_shape_that_is_printed_again_is_asked_about(line):
    asked = sv.paste(BOTH + line)
    assert asked.open and {"leave-out", "take-in"} <= {a.choice for q in asked.questions for a in q.answers}
    assert [each.label for each in sv.paste(BOTH + line, "leave-out").readings] == ["a", "b"]


def test_a_log_of_two_moments_is_asked_about():
    text = "player: Rect(0, 0, 4, 4)\nenemy: Rect(2, 2, 4, 4)\nplayer: Rect(1, 0, 4, 4)\nenemy: Rect(3, 2, 4, 4)"
    assert [len(sv.paste(text, f"corner-size {as_}").shapes) for as_ in ("", "each-value", "last-value")] == [0, 4, 2]


@pytest.mark.parametrize(
    ("text", "names"),
    [
        ("player rect: (0, 0, 4, 4)\nenemy rect: (2, 2, 4, 4)", ["player rect", "enemy rect"]),
        ("Triangle 1: (0,0), (4,0), (4,4)\nTriangle 2: (2,2), (6,2), (6,6)", ["Triangle 1", "Triangle 2"]),
        ("first shape is [(0,0),(4,0),(4,4)]\nsecond shape is [(2,2),(6,2),(6,6)]", ["", ""]),
        ("Input: A = [[0,0],[4,0],[4,4]], B = [[2,2],[6,2],[6,6]]\nOutput: true", ["A", "B"]),
        ("my code:\nverts = [(0,0),(4,0),(4,4)]\nother = [(2,2),(6,2),(6,6)]", ["verts", "other"]),
        ("Here is the data: [(0,0),(4,0),(4,4)]\nwall: [(2,2),(6,2),(6,6)]", ["", "wall"]),
        ("[@pixi/math:Rectangle x=0 y=0 width=9 height=9]\n[@pixi/math:Circle x=5 y=5 radius=3]", ["", ""]),
        ("let a: Polygon = Polygon([(0,0),(4,0),(4,4)])\nlet b: Circle = Circle(2, 2, 1)", ["a", "b"]),
    ],
)
def test_a_shape_has_the_name_that_the_author_gives_it(text, names):
    assert [each.label for each in sv.paste(text).readings] == names


def test_where_no_shape_is_found_the_numbers_of_the_text_are_named():
    with pytest.raises(sv.InvalidScene, match=r"no shape was found, only the numbers radius 10.0, size 4, 5: paste"):
        sv.paste("class_name Ball\n@export var radius = 10.0\n@export var size = Vector2(4, 5)")


@pytest.mark.parametrize("kind", ["POLYGON Z", "POLYGONZ", "POLYGON M", "POLYGON ZM", "polygon z"])
def test_z_and_m_of_wkt_are_left_out_and_named(kind):
    more = " 7 8" if "ZM" in kind else " 7"
    pasted = sv.paste(f"{kind} ((0 0{more}, 4 0{more}, 0 3{more}))\nPOLYGON((1 1, 4 1, 1 3))")
    assert pasted.shapes[0].vertices == ((0, 0), (4, 0), (0, 3))
    assert "Z and M of WKT were left out" in str(pasted)


@pytest.mark.parametrize(
    ("inner", "outer", "touches"),
    [
        ("Circle(3, 0, 2)", "Circle(0, 0, 5)", True),
        ("Circle(2, 0, 2)", "Circle(0, 0, 5)", False),
        ("[(0,1),(2,1),(2,2)]", "[(0,0),(4,0),(4,4),(0,4)]", True),
        ("[(1,1),(2,1),(2,2)]", "[(0,0),(4,0),(4,4),(0,4)]", False),
        ("[(0,1),(2,1),(2,2)]", "[(0,0),(4,0),(4,4),(3,3),(0,4)]", True),
        ("Circle((1, 2), 1)", "[(0,0),(4,0),(4,4),(0,4)]", True),
        ("Circle((1, 2), 0.5)", "[(0,0),(4,0),(4,4),(3,3),(0,4)]", False),
        ("Circle((1, 1), 1)", "[(0,0),(4,0),(4,4),(3,3),(0,4)]", True),
        ("[(3,4),(0,0),(1,0)]", "Circle(0, 0, 5)", True),
        ("[(3,3),(0,0),(1,0)]", "Circle(0, 0, 5)", False),
    ],
)
def test_a_border_that_is_touched_from_inside_is_named(inner, outer, touches):
    (finding,) = (f for f in sv.paste(f"a = {inner}\nb = {outer}").findings if f.kind == "containment")
    assert "A lies inside B" in finding.text and ("touches its border from inside" in finding.text) == touches


def test_a_ring_that_only_overlaps_the_first_of_its_list_is_no_hole():
    assert len(sv.paste("[[[0,0],[9,0],[0,9]],[[4,4],[8,4],[8,8]]]").shapes) == 2
    asked = sv.paste("[[[0,0],[9,0],[9,9],[0,9]],[[4,4],[8,4],[8,8]]]")
    assert "a hole of the first outline of its list, which is filled without it" in str(asked)


def test_corners_that_are_turned_about_a_position_at_the_origin_are_asked_about():
    text = "{vertices: [[1,0],[3,0],[3,2]], position: [0,0], angle: 90}\n{vertices: [[0,0],[3,0],[3,2]]}"
    assert "corners" in [question.what for question in sv.paste(text).questions]
    assert sv.paste(text, "absolute").shapes[0].vertices == ((1, 0), (3, 0), (3, 2))


def test_two_points_are_never_taken_for_a_box_without_a_word():
    assert "a line segment is no shape here" in str(sv.paste("a = [(0,0),(4,4)]\nb = [(2,2),(6,6)]"))
    for name in ("segment", "line1", "wallEdge", "ray"):
        assert "two points are a line segment" in str(sv.paste(f"{name} = [(0,0),(4,4)]\n{BOTH}"))


def test_corners_have_the_names_of_the_pictures_in_every_finding():
    pasted = sv.paste("a = [(0,0),(2,0),(4,0),(4,0),(4,4)]\nb = [(0,0),(4,4),(4,0),(0,4)]")
    said = " ".join(finding.text for finding in pasted.findings)
    assert "a4 repeats a3, with a1 as the first corner" in said
    assert "a2 lies straight on between its neighbours, with a1 as the first corner" in said
    assert "edges b1b2 and b3b4 cross" in said
