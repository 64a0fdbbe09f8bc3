"""In a real browser: the two pens side by side, the page from disk."""

import json
import re
from itertools import pairwise
from xml.etree import ElementTree

import numpy as np
import pytest
from browser import accessibility_faults, explored, settled
from matplotlib.colors import to_hex
from matplotlib.path import Path

import satviz as sv
from satviz.pictures import THEMES
from satviz.pictures.caption import reading_time_ms
from satviz.pictures.playback import playback, playbacks
from satviz.render.files import canvas
from satviz.render.script import javascript, stylesheet
from satviz.scenes.named import ALL_SCENES
from satviz.widgets.explorer_model import ExplorerModel

pytestmark = pytest.mark.slow

SCENES = ["triangles", "circle-polygon", "concave", "aabb-rotated", "far-centers", "raw-depth", "tile-seam"]


def opened(browser, errors, path, **more):
    page = browser.new_page(**more)
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.on("console", lambda message: errors.append(message.text) if message.type == "error" else None)
    page.goto(path.as_uri())
    page.locator(".sv-picture").first.wait_for()
    settled(page)
    return page


@pytest.fixture(scope="module")
def pages(tmp_path_factory):
    folder = tmp_path_factory.mktemp("pages")
    for name in SCENES:
        (folder / f"{name}.html").write_text(sv.page(sv.scene(name).record(), title=name), encoding="utf-8")
    return folder


@pytest.mark.parametrize("size", [(1366, 650), (1440, 760), (900, 800)])
def test_picture_sentence_and_buttons_fit_into_one_window(browser, errors, tmp_path, size):
    a, b = sv.Polygon([(0, 0), (4, 0), (4, 3), (0, 3)]), sv.Polygon([(3, 2), (6, 2), (5, 5)])
    (tmp_path / "page.html").write_text(sv.page(a, b, predict=True), encoding="utf-8")
    page = opened(browser, errors, tmp_path / "page.html", viewport=dict(zip(("width", "height"), size, strict=True)))
    bar = page.get_by_role("button", name="reset").bounding_box()
    assert bar["y"] + bar["height"] <= size[1]
    picture = page.locator(".sv-board > .sv-picture")
    scale = picture.evaluate("svg => svg.getScreenCTM().a")
    assert scale >= 0.999 and picture.bounding_box()["height"] <= size[1]
    page.close()


READ = """() => [...document.querySelectorAll('[data-id]')].map(e => {
  const look = getComputedStyle(e);
  const {fill, fillOpacity, stroke, strokeOpacity, strokeWidth, strokeDasharray, fontSize, fontWeight} = look;
  return {id: e.dataset.id, d: e.getAttribute('d'), at: e.dataset.at, text: e.dataset.text,
    fill, fillOpacity, stroke, strokeOpacity, strokeWidth: parseFloat(strokeWidth),
    strokeDasharray, fontSize: parseFloat(fontSize), bold: fontWeight === '700'};
})"""


def colour(css):
    """Return a colour such as "rgb(0, 114, 178)" as "#0072b2"."""
    return to_hex([int(c) / 255 for c in css.removeprefix("rgb(").removesuffix(")").split(",")])


def svg_look(part):
    """Return the style and the corners (points) of a line, a filled shape or a text; of a circle both sides."""
    if part["text"] is not None:
        look = colour(part["fill"]), part["text"], part["fontSize"], part["bold"]
        return look, np.array([part["at"].split()], dtype=float)
    if part["stroke"] == "none":
        look = colour(part["fill"]), part["fillOpacity"], 0, ()
    else:
        dash = tuple(float(d) for d in re.findall(r"[\d.]+", part["strokeDasharray"]))
        look = colour(part["stroke"]), part["strokeOpacity"], part["strokeWidth"], dash
    ends = [piece.split()[-2:] for piece in re.split("[MLA]", part["d"].rstrip("Z"))[1:]]
    return look, np.array(ends[:2] if "A" in part["d"] else ends, dtype=float)


def matplotlib_looks(pen, drawn):
    """Yield the same for everything that the matplotlib pen drew, in drawing order."""

    def on_canvas(points):
        return (np.asarray(points) - [drawn.limits[0], drawn.limits[3]]) * [drawn.scale, -drawn.scale]

    def shape(path, rgba, width=0, dash=()):
        points = path.vertices
        if path.codes is not None and Path.CURVE4 in path.codes:
            (left, low), (right, high) = path.get_extents().get_points()
            points = [(left, (low + high) / 2), (right, (low + high) / 2)]
        elif path.codes is not None and path.codes[-1] == Path.CLOSEPOLY:
            points = points[:-1]
        return (to_hex(rgba), f"{rgba[3]:g}", width, dash), on_canvas(points)

    yield from map(shape, pen.fills.get_paths(), pen.fills.get_facecolors())
    lines = pen.strokes
    dashes = [tuple(dash or ()) for _, dash in lines.get_linestyles()]
    yield from map(shape, lines.get_paths(), lines.get_edgecolors(), lines.get_linewidths(), dashes)
    yield from map(shape, pen.solids.get_paths(), pen.solids.get_facecolors())
    for text in pen.texts:
        look = to_hex(text.get_color()), text.get_text(), text.get_fontsize(), text.get_fontweight() == "bold"
        yield look, on_canvas([text.get_position()])


@pytest.mark.parametrize("theme", ["light", "dark"])
@pytest.mark.parametrize("name", SCENES)
def test_both_pens_draw_the_same_marks(browser, errors, pages, name, theme):
    """Ids, places, texts, colours, widths, dashes and drawing order are compared, mark by mark and step by step."""
    trace = sv.scene(name).record()
    page = opened(browser, errors, pages / f"{name}.html", color_scheme=theme, reduced_motion="reduce")
    for i in range(len(sv.steps(trace))):
        drawn = sv.picture(trace, i)
        _, pen = canvas(drawn.size, THEMES[theme])
        artists = pen.draw(drawn)
        page.get_by_role("slider", name="step").fill(str(i))
        parts = page.evaluate(READ)
        assert {part["id"] for part in parts} == {m.id for m in drawn.marks} == set(artists)
        for part, (look, corners) in zip(parts, matplotlib_looks(pen, drawn), strict=True):
            mine, my_corners = svg_look(part)
            assert mine == look, part["id"]
            assert my_corners == pytest.approx(corners, abs=0.01), part["id"]
    page.close()


FIRST_FRAME = f"() => {{ document.querySelector('[aria-label=\"step forward\"]').click(); return ({READ})(); }}"


def test_what_a_step_explains_moves_from_where_it_comes(browser, errors, pages):
    trace = sv.scene("triangles").record()
    page = opened(browser, errors, pages / "triangles.html")
    before, moved = set(), set()
    for i in range(1, len(sv.steps(trace))):
        drawn = sv.picture(trace, i)
        x0, _, _, y1 = drawn.limits
        found = {part["id"]: part for part in reversed(page.evaluate(FIRST_FRAME))}  # of an arrow the shaft
        for mark in drawn.marks:
            if mark.start and mark.id not in before:
                _, corners = svg_look(found[mark.id])
                spot = corners.mean(axis=0) if mark.kind == "dot" else corners[0]
                at = np.array([mark.start[0].x - x0, y1 - mark.start[0].y]) * drawn.scale
                assert spot == pytest.approx(at, abs=0.01), mark.id
                moved.add(mark.part)
        before = {mark.id for mark in drawn.marks}
    assert moved == {"normal", "slide", "axis", "drop", "landing", "range", "gap"}
    page.close()


def test_the_page_steps_by_keys_buttons_and_slider(browser, errors, pages):
    trace = sv.scene("triangles").record()
    page = opened(browser, errors, pages / "triangles.html")
    said = page.locator(".sv-sentence")
    assert said.inner_text() == sv.picture(trace, 0).sentence
    page.locator(".sv-picture").press("ArrowRight")
    assert said.inner_text() == sv.picture(trace, 1).sentence
    page.get_by_role("button", name="step forward").click()
    page.get_by_role("button", name="last step").click()
    assert said.inner_text() == trace.sentence
    page.locator(".sv-picture").press("Home")
    assert said.inner_text() == sv.picture(trace, 0).sentence
    page.get_by_role("slider", name="step").fill("14")
    lit = page.locator("tr.sv-lit").inner_text()
    assert "v1v3" in lit and "gap +1.213" in lit
    assert page.locator(".sv-code .sv-lit").last.inner_text().strip() == "stop: the shapes are apart"
    assert page.locator("tr.sv-skipped").count() == 4
    page.get_by_role("button", name="test the rest").click()
    page.get_by_role("button", name="last step").click()
    assert page.locator("tr.sv-skipped").count() == 0 and page.locator("tbody tr").count() == 6
    page.close()


def test_the_page_plays_only_on_request_and_stops_at_the_end(browser, errors, pages):
    page = opened(browser, errors, pages / "triangles.html", reduced_motion="reduce")
    page.wait_for_timeout(600)
    assert page.locator(".sv-count").inner_text() == "1 / 16"
    page.get_by_role("slider", name="step").fill("14")
    page.get_by_role("button", name="play").click()
    page.get_by_text("16 / 16").wait_for(timeout=5000)
    page.get_by_role("button", name="play").wait_for()
    page.close()


def pressed_on(page, key, *, on="body"):
    """Return by how many steps a key moves the player."""
    before = page.locator(".sv-count").inner_text()
    if on == "body":
        page.evaluate("document.activeElement.blur()")
        page.keyboard.press(key)
    else:
        page.locator(on).first.press(key)
    return int(page.locator(".sv-count").inner_text().split()[0]) - int(before.split()[0])


def test_arrow_keys_step_as_soon_as_the_page_is_open(browser, errors, pages):
    page = opened(browser, errors, pages / "triangles.html")
    assert pressed_on(page, "ArrowRight") == pressed_on(page, "ArrowRight") == 1
    assert pressed_on(page, "ArrowLeft") == -1
    page.get_by_role("button", name="step forward").click()
    assert pressed_on(page, "ArrowRight", on="[aria-label='step forward']") == 1  # also right after a click
    page.close()


def test_arrow_keys_step_the_player_where_nothing_has_the_focus(browser, errors, pages):
    page = opened(browser, errors, pages / "triangles.html")
    for key in "Control+ArrowRight", "Alt+ArrowRight", "Meta+ArrowRight", "Shift+ArrowRight", "End", " ", "ArrowDown":
        assert pressed_on(page, key) == 0, key
    page.evaluate("""() => document.querySelector("main").insertAdjacentHTML("beforeend",
        "<input id=field value=abc><textarea id=text>abc</textarea><div id=own contenteditable>abc</div>")""")
    for field in "#field", "#text", "#own", ".sv-controls select", ".sv-controls [type=checkbox]":
        assert pressed_on(page, "ArrowRight", on=field) == 0, field
    page.locator("#field").press("Home")
    page.locator("#field").press("ArrowRight")
    assert page.evaluate("document.getElementById('field').selectionStart") == 1
    page.close()


PLAYERS = """
const data = JSON.parse(document.getElementById("data").textContent);
for (const root of document.querySelectorAll(".here")) arrowKeys(new Player(root, data.shows, data));
"""


def test_with_several_players_arrow_keys_step_the_one_last_used_or_in_view(browser, errors):
    """None of those that are folded away."""
    data = json.dumps({"shows": playbacks(sv.scene("triangles").record())}).replace("<", "\\u003c")
    page = browser.new_page(viewport={"width": 1280, "height": 900})
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.set_content(
        f"<!doctype html><style>{stylesheet()}</style>"
        '<details><summary>more</summary><div class="here"></div></details>'
        '<div class="here"></div><div class="here"></div><p style="height: 3000px">words</p><div class="here"></div>'
        f'<script type="application/json" id="data">{data}</script>'
        f'<script type="module">{javascript("player", "arrows")}{PLAYERS}</script>'
    )
    page.locator(".sv-count").nth(3).wait_for(state="attached")
    settled(page)

    def steps():
        return [int(count.split()[0]) for count in page.locator(".sv-count").all_text_contents()]

    page.keyboard.press("ArrowRight")
    assert steps() == [1, 2, 1, 1]  # of the two in view the one of which more is seen
    page.locator(".sv-stage").nth(2).click(position={"x": 5, "y": 5})
    page.evaluate("document.activeElement.blur()")
    page.evaluate("scrollTo(0, 100)")
    page.keyboard.press("ArrowRight")
    assert steps() == [1, 2, 2, 1]
    page.get_by_text("words").evaluate("p => scrollTo(0, p.offsetTop + 500)")
    page.keyboard.press("ArrowRight")
    assert steps() == [1, 2, 2, 1]  # none is in view
    page.evaluate("scrollTo(0, document.body.scrollHeight)")
    page.keyboard.press("ArrowRight")
    assert steps() == [1, 2, 2, 2]
    page.evaluate("scrollTo(0, 0)")
    page.get_by_text("more").click()
    page.evaluate("document.activeElement.blur()")
    page.locator(".sv-stage").nth(0).click(position={"x": 5, "y": 5})
    page.evaluate("document.activeElement.blur()")
    page.keyboard.press("ArrowRight")
    assert steps() == [2, 2, 2, 2]
    page.close()


def test_a_row_that_is_not_tested_yet_does_not_say_whether_it_will_be(browser, errors, pages):
    """Else the first step would tell where the run stops."""
    page = opened(browser, errors, pages / "triangles.html", reduced_motion="reduce")
    for i, step in enumerate(playback(sv.scene("triangles").record())["steps"]):
        page.get_by_role("slider", name="step").fill(str(i))
        for row in page.locator("tbody tr").all():
            number, _, *results = row.locator("td").all_inner_texts()
            assert not number or any(results) or "sv-lit" in row.get_attribute("class"), (i, step["sentence"])
    page.get_by_role("slider", name="step").fill("0")
    assert not any(row.locator("td").first.inner_text() for row in page.locator("tbody tr").all())
    page.close()


def test_predict_asks_for_each_result_first_and_counts_right_answers(browser, errors, pages):
    page = opened(browser, errors, pages / "triangles.html", reduced_motion="reduce")
    page.get_by_label("predict").check()
    page.get_by_role("button", name="last step").click()
    question = page.locator(".sv-question")
    assert "separate them?" in question.inner_text() and "1.664" not in page.locator("tbody").inner_text()
    question.get_by_role("button", name="yes").click()
    assert page.locator(".sv-sentence").inner_text().startswith("Not right.")
    page.get_by_role("button", name="last step").click()
    question.get_by_role("button", name="yes").click()
    assert page.locator(".sv-sentence").inner_text().startswith("Right.")
    assert page.locator(".sv-score").inner_text() == "1 of 2 right"
    page.close()


def test_without_javascript_the_page_shows_pictures_table_and_sentences(browser, pages):
    context = browser.new_context(java_script_enabled=False)
    page = context.new_page()
    page.goto((pages / "triangles.html").as_uri())
    assert page.locator(".sv-static svg").count() == 2 and page.locator(".sv-static svg").first.is_visible()
    assert page.locator(".sv-static li").count() == 16
    context.close()


def test_a_page_with_predict_shows_no_result_before_the_answer(browser, errors, tmp_path):
    """It shows no numbers, not which axes are tested, and not how many steps there are."""
    file = tmp_path / "asks.html"
    file.write_text(sv.page("triangles", predict=True), encoding="utf-8")
    page = opened(browser, errors, file, reduced_motion="reduce")
    question = page.locator(".sv-question")
    for row in range(2):
        page.get_by_role("button", name="last step").click()
        question.wait_for()
        seen = page.locator("main").inner_text()
        assert "apart" not in seen.replace("stop: the shapes are apart", "") and "1.213" not in seen
        assert "–" not in seen and "16" not in page.locator(".sv-count").inner_text()
        cells = page.locator("tbody tr").nth(row + 1).locator("td").all_inner_texts()
        assert [cell for cell in cells if cell and not cell.startswith("normal of")] == []
        assert not page.get_by_role("slider", name="step").is_visible()
        assert not page.get_by_role("button", name="test the rest").is_visible()
        question.get_by_role("button", name="no" if row == 0 else "yes").click()
    page.get_by_role("button", name="last step").click()
    assert page.locator(".sv-count").inner_text() == "16 / 16"
    assert page.get_by_role("button", name="test the rest").is_visible()
    page.close()


def test_predict_asks_about_the_true_run_and_not_about_that_of_the_shortcut(browser, errors, pages, tmp_path):
    file = tmp_path / "asks.html"
    file.write_text(sv.page("far-centers", predict=True), encoding="utf-8")
    page = opened(browser, errors, file)
    assert page.locator("h1").inner_text() == "Do A and B collide?"
    page.close()
    page = opened(browser, errors, pages / "far-centers.html")
    assert not page.get_by_label("predict").is_visible()
    page.close()


def test_each_step_stays_as_long_as_its_words_take_to_read(browser, errors, pages):
    trace = sv.scene("triangles").record()
    page = browser.new_page(reduced_motion="reduce")
    page.add_init_script(
        "window.waits = []; const later = window.setTimeout;"
        "window.setTimeout = (does, ms) => { if (ms >= 600) waits.push(ms); return later(does, Math.min(ms, 30)); };"
    )
    page.goto((pages / "triangles.html").as_uri())
    page.get_by_role("button", name="play").click()
    page.get_by_text("16 / 16").wait_for()
    waits = page.evaluate("() => window.waits")
    assert waits[:15] == [reading_time_ms(sv.picture(trace, i).sentence) for i in range(1, 16)]
    page.close()


# -- the explorer, without Jupyter

PHONE = {"viewport": {"width": 390, "height": 844}, "is_mobile": True, "has_touch": True}
ZOOMED = {"viewport": {"width": 640, "height": 400}}  # 1280 by 800 at 200 %
WIDE = {"viewport": {"width": 1280, "height": 800}}


def answered(page, words):
    page.locator(".sv-sentence").filter(has_text=words).wait_for()


@pytest.mark.parametrize(("theme", "screen"), [("light", PHONE), ("dark", WIDE)], ids=["light phone", "dark desk"])
def test_the_page_has_no_accessibility_fault(browser, errors, pages, axe_core, theme, screen):
    for name in "triangles", "aabb-turned":
        with explored(browser, ExplorerModel(sv.scene(name)), errors, color_scheme=theme, **screen) as page:
            if theme == "dark":
                page.evaluate("() => { document.body.style.background = '#111'; }")
                page.locator("[data-theme='dark']").wait_for()
            page.get_by_label("free axis").check()
            page.get_by_role("checkbox", name="B − A").check()
            page.locator(".sv-difference").wait_for()
            page.locator(".sv-menu summary:has-text('save')").click()
            assert [f for f in accessibility_faults(axe_core, page) if "<h1" not in f[1]] == []
    for name in "triangles", "tile-seam":
        context = browser.new_context(color_scheme=theme, **screen)
        page = context.new_page()
        page.goto((pages / f"{name}.html").as_uri())
        settled(page)
        for step in "0", "2":
            page.get_by_role("slider", name="step").fill(step)
            assert accessibility_faults(axe_core, page) == []
        context.close()


SMALL = """() => {
  const every = [...document.querySelectorAll('.satviz *')];
  const shown = every.filter(e => e.checkVisibility() && e.getClientRects().length);
  const texts = shown.filter(e => [...e.childNodes].some(n => n.nodeType === 3 && n.data.trim()));
  const size = e => {
    const svg = e.closest('svg');
    const [, , wide] = svg?.getAttribute('viewBox')?.split(' ') ?? [];
    return parseFloat(getComputedStyle(e).fontSize) * (wide ? svg.getBoundingClientRect().width / wide : 1);
  };
  const targets = shown.filter(e => e.matches('.sv-handle, button, summary, select'));
  const least = e => { const {width, height} = e.getBoundingClientRect(); return Math.min(width, height); };
  const beyond = e => e.getBoundingClientRect().right > innerWidth + 0.5;
  const out = shown.filter(e => !e.closest('.sv-scrolls, .sv-said') && beyond(e));
  return [Math.min(...texts.map(size)), Math.min(...targets.map(least)), out.map(e => e.outerHTML.slice(0, 80)),
    document.documentElement.scrollWidth - innerWidth];
}"""


@pytest.mark.parametrize("screens", [[PHONE], [ZOOMED, WIDE]], ids=["phone", "desk"])
@pytest.mark.parametrize("name", ["triangles", "circle-polygon", "concave", "unit-normals"])
def test_letters_are_readable_targets_are_large_enough_and_nothing_is_cut(browser, errors, tmp_path, name, screens):
    def fits(page):
        for screen in screens:
            page.set_viewport_size(screen["viewport"])
            settled(page)  # with the picture for this width
            letters, targets, cut, beyond = page.evaluate(SMALL)
            assert letters >= 10.99 and targets >= 24 and cut == [] and beyond <= 0

    with explored(browser, ExplorerModel(sv.scene(name)), errors, **screens[0]) as page:
        page.get_by_label("free axis").check()
        page.locator(".sv-curve").wait_for()
        page.locator(".sv-menu summary:has-text('save')").click()
        fits(page)
    context = browser.new_context(**screens[0])
    page = context.new_page()
    (tmp_path / "page.html").write_text(sv.page(name), encoding="utf-8")
    page.goto((tmp_path / "page.html").as_uri())
    page.get_by_role("button", name="last step").click()
    fits(page)
    context.close()


@pytest.mark.parametrize("name", ["sum-of-parts", "dart", "slipped-normal", "pentagram"])
def test_two_panels_need_no_scrolling_aside_on_a_telephone(browser, tmp_path, name):
    context = browser.new_context(**PHONE)
    page = context.new_page()
    (tmp_path / "page.html").write_text(sv.page(name), encoding="utf-8")
    page.goto((tmp_path / "page.html").as_uri())
    every = "[document.documentElement, ...document.querySelectorAll('.sv-scrolls')]"
    fits = f"() => {every}.every(e => e.scrollWidth <= e.clientWidth)"  # once the place's width is known
    page.wait_for_function(fits)
    if name != "pentagram":  # which has no steps
        page.get_by_role("button", name="last step").click()
        assert page.evaluate(fits)
        headings = "what the shortcut saw", "what is true"
        claimed, actual = (page.get_by_text(words).first.bounding_box() for words in headings)
        assert actual["y"] > claimed["y"] + 150
    context.close()


def test_a_line_under_the_picture_says_what_the_map_shows_or_why_there_is_none(browser, errors):
    for name, words in ("sum-of-parts", "The map: while"), ("many-pairs", "No map of where it is wrong"):
        with explored(browser, ExplorerModel(sv.scene(name)), errors, **PHONE) as page:
            line = page.locator(".sv-map")
            assert line.inner_text().startswith(words)
            page.get_by_role("button", name="truth").click()
            answered(page, "A and B")
            line.wait_for(state="hidden")


def test_the_curve_is_right_under_the_picture_where_it_is_not_beside_it(browser, errors):
    for screen, under in (PHONE, True), (WIDE, False):
        with explored(browser, ExplorerModel(sv.scene("triangles")), errors, **screen) as page:
            page.get_by_label("free axis").check()
            page.locator(".sv-curve").wait_for()
            settled(page)
            parts = [page.locator(c).bounding_box() for c in (".sv-board", ".sv-line", ".sv-dial", ".sv-curve")]
            for above, below in pairwise(parts) if under else [parts[:2], parts[2:]]:
                assert 0 <= below["y"] - above["y"] - above["height"] < 30
            assert (parts[2]["x"] >= parts[0]["x"] + parts[0]["width"]) is not under


def test_a_finger_beside_the_shapes_scrolls_the_page_and_one_on_a_shape_drags_it(browser, errors):
    with explored(browser, ExplorerModel(sv.scene("triangles")), errors, **PHONE) as page:
        page.evaluate("() => { document.body.style.height = '3000px'; }")
        session = page.context.new_cdp_session(page)

        def touch(kind, *points):
            session.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})

        def swipe(x, y):
            touch("touchStart", {"x": x, "y": y})
            for i in range(1, 11):
                touch("touchMove", {"x": x, "y": y - 8 * i})
            touch("touchEnd")
            page.wait_for_timeout(300)
            return page.evaluate("() => scrollY")

        box = page.locator("[data-handle='B-move']").bounding_box()
        corner = page.locator("[data-handle='A-vertex-0']").bounding_box()
        assert swipe(box["x"] + 4, box["y"] + 4) == 0
        assert page.locator("[data-handle='B-move']").bounding_box()["y"] < box["y"] - 60
        assert swipe(corner["x"] + 20, corner["y"] + 20) == 0
        board = page.locator(".sv-board").bounding_box()
        swipe(board["x"] + board["width"] - 8, board["y"] + board["height"] - 12)
        page.wait_for_function("() => scrollY > 30")


def test_a_shape_is_one_stop_of_tab_and_its_corners_are_reached_from_it(browser, errors):
    hand = ExplorerModel(sv.scene("triangles"))
    with explored(browser, hand, errors) as page:
        here = "() => document.activeElement.dataset.handle ?? document.activeElement.tagName"
        stops = []
        for _ in range(3):
            page.keyboard.press("Tab")
            stops.append(page.evaluate(here))
        assert stops == ["A-move", "B-move", "SELECT"]
        page.keyboard.press("Shift+Tab")
        went = []
        for key in ("PageDown", "PageDown", "n", "PageDown", "PageDown", "p", "Escape"):
            page.keyboard.press(key)
            went.append(page.evaluate(here))
        assert went == ["B-vertex-0", "B-vertex-1", "B-vertex-2", "B-rotate", "B-move", "B-rotate", "B-move"]
        page.keyboard.press("PageDown")
        page.keyboard.press("Shift+Tab")
        page.keyboard.press("Tab")
        assert page.evaluate(here) == "B-vertex-0"  # the way back leads to where one was
        page.keyboard.press("ArrowDown")
        page.locator("[data-handle='B-vertex-0'][aria-valuetext='at (5, 4.9)']").wait_for()
        settled(page)
        assert hand.scene.b.vertices[0] == (5, 4.9) and hand.scene.b.vertices[1] == (8, 3)


def test_a_screen_reader_gets_the_name_and_the_place_of_each_handle(browser, errors):
    with explored(browser, ExplorerModel(sv.scene("circle-polygon")), errors) as page:
        page.get_by_label("free axis").check()
        page.locator("[data-handle='axis']").wait_for()
        settled(page)
        tree = page.locator(".sv-board").aria_snapshot()
        sliders = "() => [...document.querySelectorAll('[role=slider]')]"
        told = page.evaluate(f"{sliders}.map(e => [e.ariaLabel, e.ariaValueText])")
        assert page.locator("[role=img] [role=slider]").count() == 0
        for name, text in told:
            assert f'slider "{name}"' in tree and text, name
        assert dict(told)["A: corner a2"] == "at (4, 1)" and dict(told)["turn the axis"] == "30 degrees"
        hints = page.evaluate(
            f"{sliders}.map(e => document.getElementById(e.getAttribute('aria-describedby')).textContent)"
        )
        assert all("Arrow keys move" in hint for hint in hints)


ANSWERED = "() => !window.unanswered"


def stop_the_clock(page):
    """Stop the page's clock, so that only the test lets its time pass."""
    page.clock.install(time=0)
    page.clock.pause_at(1000)


def test_the_sentence_is_announced_once_when_a_drag_ends(browser, errors):
    with explored(browser, ExplorerModel(sv.scene("triangles")), errors) as page:
        assert page.locator(".sv-sentence").get_attribute("aria-live") is None
        page.evaluate(
            "() => { window.said = []; const status = document.querySelector('.sv-said');"
            "new MutationObserver(() => said.push(status.textContent)).observe(status, {childList: true}); }"
        )
        stop_the_clock(page)
        box = page.locator("[data-handle='B-move']").bounding_box()
        page.mouse.move(box["x"] + 14, box["y"] + 14)
        page.mouse.down()
        for i in range(12):
            page.mouse.move(box["x"] + 14 - 12 * i, box["y"] + 14)
            page.wait_for_function(ANSWERED)
            page.clock.run_for(60)
        answered(page, "overlap")
        page.clock.run_for(600)
        assert page.evaluate("() => window.said") == []
        page.mouse.up()
        page.wait_for_function(ANSWERED)
        page.clock.run_for(600)
        assert page.evaluate("() => window.said") == [page.locator(".sv-sentence").inner_text()]


HEARD = """() => {
  window.heard = [];
  for (const live of document.querySelectorAll("[role=status], [role=alert], [aria-live]")) {
    const all = {childList: true, characterData: true, subtree: true};
    new MutationObserver(() => heard.push(live.textContent)).observe(live, all);
  }
}"""


def test_the_challenge_status_is_announced_once_when_a_drag_pauses(browser, errors):
    with explored(browser, ExplorerModel(sv.scene("aabb"), "touch"), errors) as page:
        page.evaluate(HEARD)
        stop_the_clock(page)

        def heard():
            page.wait_for_function(ANSWERED)
            page.clock.run_for(600)
            (words,) = page.evaluate("() => heard.splice(0)")
            return words

        page.locator("[data-handle='B-move']").focus()
        for _ in range(20):
            page.keyboard.press("ArrowLeft")
        page.locator(".sv-goal.sv-met").wait_for()
        assert heard().startswith("Done. They touch, exactly. A and B touch")
        box = page.locator("[data-handle='B-move']").bounding_box()
        page.mouse.move(box["x"] + 14, box["y"] + 14)
        page.mouse.down()
        for i in range(12):
            page.mouse.move(box["x"] + 14 + 4 * i, box["y"] + 14)
            page.wait_for_function(ANSWERED)
        answered(page, "apart")
        page.clock.run_for(600)
        assert page.evaluate("() => heard") == []
        page.mouse.up()
        assert heard().startswith("They are apart")
        for goal, asks in ("one-axis", "Make exactly one axis"), ("touch", "Make the shapes touch"):
            page.get_by_label("challenges").select_option(goal)
            assert heard().startswith(asks)


@pytest.mark.parametrize("clipboard", ["undefined", "{ writeText: () => Promise.reject(new Error('forbidden')) }"])
def test_copying_works_with_and_without_a_clipboard_and_a_line_confirms_it(browser, errors, clipboard):
    """A page from http, such as a JupyterLab of another machine, has no clipboard; a browser may forbid one."""
    hand = ExplorerModel(sv.scene("circles"))
    with explored(browser, hand, errors) as page:
        page.evaluate(f"() => Object.defineProperty(navigator, 'clipboard', {{ value: {clipboard} }})")
        page.evaluate(
            "() => { window.copies = []; addEventListener('copy', () => copies.push(String(getSelection()))); }"
        )

        def copy(name):
            page.locator(".sv-menu summary:has-text('save')").click()
            page.wait_for_function("() => document.querySelector('.sv-done').textContent === ''")
            page.get_by_role("button", name=name).click()
            page.locator(".sv-done", has_text=".").wait_for()
            return page.locator(".sv-done").inner_text()

        assert [copy("copy JSON"), copy("copy link")] == ["Copied.", "Copied."]
        assert page.evaluate("() => copies") == [hand.state()["json"], "scene.html#circles"]
        page.evaluate("() => { document.execCommand = () => false; }")
        assert "does not allow it" in copy("copy link")


def test_the_hint_disappears_at_the_first_use(browser, errors):
    with explored(browser, ExplorerModel(sv.scene("triangles")), errors) as page:
        hint = page.locator(".sv-hint")
        assert "Drag a shape, a corner or the turn handle" in hint.inner_text() and "Tab" in hint.inner_text()
        page.keyboard.press("Tab")
        page.keyboard.press("ArrowLeft")
        hint.wait_for(state="hidden")


def test_undo_and_redo_cover_the_axis_and_scenes_too(browser, errors):
    hand = ExplorerModel(sv.scene("triangles"))
    with explored(browser, hand, errors) as page:
        page.get_by_label("free axis").check()
        page.locator("[data-handle='axis']").focus()
        page.keyboard.press("[")
        answered(page, "at 35 degrees")
        page.keyboard.press("Control+z")
        answered(page, "at 30 degrees")
        page.keyboard.press("Control+Shift+Z")
        answered(page, "at 35 degrees")
        page.get_by_label("presets").select_option("aabb-turned")
        page.locator(".sv-heading").wait_for()
        page.get_by_role("button", name="undo").click()
        page.locator(".sv-heading").wait_for(state="hidden")
        answered(page, "at 35 degrees")
        assert hand.scene == sv.scene("triangles") and page.get_by_label("presets").input_value() == "triangles"
        for _ in range(2):
            page.get_by_role("button", name="undo").click()
        answered(page, "axis 2")
        assert not page.get_by_label("free axis").is_checked()
        for _ in range(3):
            page.get_by_role("button", name="redo").click()
        page.locator(".sv-heading").wait_for()
        assert hand.scene == sv.scene("aabb-turned") and page.get_by_role("button", name="redo").is_disabled()


def test_a_free_axis_has_one_knob_and_it_stays_on_the_arrow_while_it_is_dragged(browser, errors):
    with explored(browser, ExplorerModel(sv.scene("triangles")), errors) as page:
        page.get_by_label("free axis").check()
        handle = page.locator("[data-handle='axis']")
        handle.wait_for()
        assert handle.locator(".sv-grip").evaluate("e => getComputedStyle(e).borderTopColor") == "rgba(0, 0, 0, 0)"
        box = handle.bounding_box()
        page.mouse.move(box["x"] + 14, box["y"] + 14)
        page.mouse.down()
        for i in range(1, 6):
            page.mouse.move(box["x"] + 14, box["y"] + 14 - 20 * i)
            settled(page)
            knob = page.locator("[data-id='knob'][fill^='var']").bounding_box()
            mine = handle.bounding_box()
            assert abs(knob["x"] + knob["width"] / 2 - mine["x"] - mine["width"] / 2) < 1.5
            assert abs(knob["y"] + knob["height"] / 2 - mine["y"] - mine["height"] / 2) < 1.5
        page.mouse.up()


THEMES_OF_PAGES = [
    ("JupyterLab", "document.body.dataset.jpThemeLight = '{light}'"),
    ("VS Code", "document.body.className = {light} ? 'vscode-light' : 'vscode-dark'"),
    ("a colour", "document.body.style.background = {light} ? 'rgb(250 250 250)' : 'oklch(0.2 0.02 250)'"),
    ("a class", "document.documentElement.className = {light} ? 'light' : 'dark'"),
]


@pytest.mark.parametrize("system", ["light", "dark"])
@pytest.mark.parametrize("says", [s for _, s in THEMES_OF_PAGES], ids=[name for name, _ in THEMES_OF_PAGES])
def test_a_widget_is_light_or_dark_as_the_page_is_and_not_as_the_system(browser, errors, says, system):
    with explored(browser, ExplorerModel(sv.scene("circles")), errors, color_scheme=system) as page:
        page.add_style_tag(content="html.light { background: #fff } html.dark { background: #181c1a }")
        assert page.locator(".satviz").get_attribute("data-theme") == "light"  # a bare page is white
        for theme in "dark", "light", "dark":
            page.evaluate(says.replace("{light}", str(theme == "light").lower()))
            page.locator(f".satviz[data-theme='{theme}']").wait_for()
            paper = page.locator(".satviz").evaluate("e => getComputedStyle(e).backgroundColor")
            assert colour(paper) == THEMES[theme].paper.lower()


@pytest.mark.parametrize("noise", [[0, 0, 0, 255], [255, 255, 255, 255]], ids=["black", "white"])
def test_the_theme_is_right_where_a_browser_answers_with_noise_for_a_canvas(browser, errors, noise):
    """Firefox does so with privacy.resistFingerprinting."""
    with explored(browser, ExplorerModel(sv.scene("circles")), errors) as page:
        page.evaluate(f"() => {{ CanvasRenderingContext2D.prototype.getImageData = () => ({{data: {noise}}}); }}")
        for theme, paper in ("dark", "oklch(0.2 0.02 250)"), ("light", "rgb(250 250 250 / 0.9)"), ("dark", "#111"):
            page.evaluate(f"() => {{ document.body.style.background = '{paper}'; }}")
            page.locator(f".satviz[data-theme='{theme}']").wait_for()
            page.wait_for_timeout(600)  # it is looked at again
            assert page.locator(".satviz").get_attribute("data-theme") == theme


@pytest.mark.parametrize("size", [1e-14, 1.0, 1e12])
def test_the_announced_value_of_a_handle_is_a_plain_number_at_any_scale(browser, errors, size):
    corners = [(2 * size, 0.0), (-1 * size, 1.7320508075688776 * size), (-1 * size, -1.7320508075688774 * size)]
    shapes = sv.Polygon(corners), sv.Circle((3e-9 * size, 4 * size), size)
    with explored(browser, ExplorerModel(sv.Scene("any", *shapes)), errors) as page:
        for handle in page.locator("[data-handle]").all():
            now = handle.get_attribute("aria-valuenow")
            assert re.fullmatch(r"-?[0-9]+(\.[0-9]+)?", now), (handle.get_attribute("data-handle"), now)
        assert page.locator('[data-handle="A-rotate"]').get_attribute("aria-valuetext") == "first corner at 0 degrees"


def test_a_page_to_share_saves_the_step_that_it_shows(browser, errors, pages):
    page = opened(browser, errors, pages / "triangles.html")
    page.get_by_role("slider", name="step").fill("7")
    for form, begins in ("svg", b"<svg"), ("png", b"\x89PNG"):
        page.locator(".sv-menu summary:has-text('save')").click()
        with page.expect_download() as found:
            page.get_by_role("button", name=f"save {form.upper()}").click()
        data = found.value.path().read_bytes()
        assert data.startswith(begins)
        if form == "svg":
            title = ElementTree.fromstring(data).find("{*}title").text
            assert (
                title
                == page.locator(".sv-sentence").inner_text()
                == sv.picture(sv.scene("triangles").record(), 7).sentence
            )
    assert "GIF" not in page.locator(".sv-menu:has-text('save')").inner_text()
    page.close()


def test_a_picture_that_the_browser_cannot_draw_is_not_saved_and_the_page_says_so(browser, errors, pages):
    page = opened(browser, errors, pages / "triangles.html")
    files = []
    page.on("download", lambda file: files.append(file))
    page.evaluate("HTMLCanvasElement.prototype.toBlob = (made) => made(null); 0")  # as a browser out of memory does
    page.locator(".sv-menu summary:has-text('save')").click()
    page.get_by_role("button", name="save PNG").click()
    page.get_by_text("This browser cannot draw the file.").wait_for()
    assert not files
    page.close()


def test_a_picture_saved_during_a_move_is_the_one_at_its_end(browser, errors, pages):
    page = opened(browser, errors, pages / "triangles.html")
    save = "document.querySelector('[aria-label=\"save SVG\"]').click();"
    for i in range(1, 16):
        files = []
        for first in f"document.querySelector('[aria-label=\"step forward\"]').click(); {save}", save:
            with page.expect_download() as found:
                page.evaluate(f"() => {{ {first} }}")
            files.append(found.value.path().read_bytes())
            page.wait_for_timeout(500 if first is not save else 0)
        assert files[0] == files[1], i
    page.close()


def test_the_save_menu_opens_and_closes_from_the_keyboard(browser, errors):
    with explored(browser, ExplorerModel(sv.scene("triangles")), errors) as page:
        menu = page.locator(".sv-menu:has-text('save')")
        assert not page.get_by_role("button", name="save SVG").is_visible()
        menu.locator("summary").focus()
        page.keyboard.press("Enter")
        page.get_by_role("button", name="save SVG").wait_for()
        page.keyboard.press("Tab")
        page.keyboard.press("Escape")
        assert not page.get_by_role("button", name="save SVG").is_visible()
        assert page.evaluate("() => document.activeElement.tagName") == "SUMMARY"
        page.evaluate("() => { document.querySelector('.sv-menu').style.marginLeft = 'auto'; }")  # at the right edge
        page.keyboard.press("Enter")
        page.get_by_role("button", name="copy JSON").wait_for()
        page.wait_for_function(f"() => {{ const [, , out, beyond] = ({SMALL})(); return !out.length && !beyond; }}")


COVERED = """() => {
  const boxes = selector => [...document.querySelectorAll(selector)].map(e => e.getBoundingClientRect());
  const words = boxes('.sv-board text');
  const lies = (p, q) => p.left < q.right && q.left < p.right && p.top < q.bottom && q.top < p.bottom;
  return boxes('.sv-does-rotate .sv-icon').map(turn => words.filter(word => lies(turn, word)).length);
}"""


@pytest.mark.parametrize(
    "name", ["triangles", "concave", "aabb-rotated", "slipped-normal", "dart", "tile-seam", "range-inside"]
)
def test_a_turn_handle_hides_no_words(browser, errors, name):
    for screen in PHONE, WIDE:
        with explored(browser, ExplorerModel(sv.scene(name)), errors, **screen) as page:
            assert not any(page.evaluate(COVERED))


@pytest.mark.parametrize(
    "b", [[(0.5, 0), (3.5, 0), (2, 4)], [(1, 1), (3, 1), (3, 4), (1, 4)], [(0, 0), (4, 0), (4, 4), (0, 4)]]
)
def test_no_turn_handle_hides_the_other(browser, errors, b):
    """The two shapes have one height and lie one over the other."""
    scene = sv.Scene("over", sv.Polygon([(0, 0), (4, 0), (4, 4), (0, 4)]), sv.Polygon(b))
    for screen in PHONE, WIDE:
        with explored(browser, ExplorerModel(scene), errors, **screen) as page:
            first, second = (page.locator(f'[data-handle="{shape}-rotate"]').bounding_box() for shape in "AB")
            assert max(abs(first[side] - second[side]) for side in "xy") >= 24  # as large as the icon


DOTS = """() => {
  const middle = e => {
    const {x, y, width, height} = e.getBoundingClientRect();
    return [x + width / 2, y + height / 2];
  };
  const solids = [...document.querySelectorAll('.sv-board > svg [data-layer="solid"] path')];
  const arrow = e => e.getAttribute("d").split("L").length === 3; // a triangle
  const handles = [...document.querySelectorAll(".sv-handle")];
  return {
    dots: solids.filter(e => !arrow(e)).map(e => [e.dataset.id, ...middle(e)]),
    handles: Object.fromEntries(handles.map(e => [e.dataset.handle, middle(e)])),
  };
}"""
HELD = """() => {
  const held = document.activeElement;
  held.blur();
  return held.dataset.handle ?? "";
}"""


@pytest.mark.parametrize("i", range(len(ALL_SCENES)), ids=[scene.name for scene in ALL_SCENES])
def test_a_dot_that_is_no_handle_has_no_handle_over_it(browser, errors, i):
    """What is pressed in the middle of a dot: the handle that sits there, else the shape or nothing; of a map B.

    Every second scene is shown on a telephone.
    """
    name, screen = ALL_SCENES[i].name, (PHONE, WIDE)[i % 2]
    with explored(browser, ExplorerModel(sv.scene(name)), errors, **screen) as page:
        truth = page.get_by_role("button", name="truth", exact=True)
        for view in ["shortcut", "truth"][: 1 + truth.is_visible()]:
            if view == "truth":
                truth.click()
            settled(page)
            found = page.evaluate(DOTS)
            for dot, x, y in found["dots"]:
                page.mouse.click(x, y)
                held = page.evaluate(HELD)
                if dot == "reference":
                    assert held == "B-move", (view, held)
                elif held and not held.endswith("-move"):
                    assert np.hypot(*np.subtract(found["handles"][held], (x, y))) < 2, (view, dot, held)
                for handle, at in found["handles"].items():  # its icon would hide the dot
                    if handle.endswith("-rotate"):
                        assert np.hypot(*np.subtract(at, (x, y))) > 14, (view, dot, handle)


def test_dragging_the_dot_of_the_error_region_moves_b_without_reshaping_it(browser, errors):
    scene = sv.scene("far-centers")
    hand = ExplorerModel(scene)
    with explored(browser, hand, errors, **WIDE) as page:
        x, y = next((x, y) for dot, x, y in page.evaluate(DOTS)["dots"] if dot == "reference")
        page.mouse.move(x, y)
        page.mouse.down()
        page.mouse.move(x - 60, y - 40, steps=5)
        page.mouse.up()
        settled(page)
        moves = {(round(q.x - p.x, 6), round(q.y - p.y, 6)) for p, q in zip(scene.b.vertices, hand.scene.b.vertices)}
        assert len(moves) == 1 and moves != {(0, 0)}


def test_reset_frames_the_scene_as_it_was(browser, errors):
    with explored(browser, ExplorerModel(sv.scene("triangles")), errors, **WIDE) as page:
        outline = page.locator('[data-id="A.outline"]').first
        before = outline.bounding_box()
        for _ in range(60):
            page.locator('[data-handle="B-move"]').press("ArrowRight")
        page.wait_for_function(
            "wide => document.querySelector('[data-id=\"A.outline\"]').getBoundingClientRect().width < wide",
            arg=before["width"] / 1.5,
        )
        page.get_by_role("button", name="reset").click()
        settled(page)
        assert outline.bounding_box() == before


SEEN = """() => [
  ...[...document.querySelectorAll(".sv-handle")].map(({dataset, style}) => [dataset.handle, style.left, style.top]),
  ...[...document.querySelectorAll("[data-id]")].map(e => [e.dataset.id, e.getAttribute("d"), e.dataset.at]),
]"""


@pytest.mark.parametrize("name, keys", [("concave", ["ArrowDown"] * 40), ("triangles", ["]"]), ("aabb", ["["] * 3)])
@pytest.mark.parametrize("back", ["reset", "undo"])
def test_a_shape_dragged_back_to_its_start_has_the_picture_of_the_start(browser, errors, name, keys, back):
    """The labels and the turn handles are the same too, after reset and after undo."""
    with explored(browser, ExplorerModel(sv.scene(name)), errors, **WIDE) as page:
        before = page.evaluate(SEEN)
        for key in keys:
            page.locator('[data-handle="B-move"]').press(key)
        settled(page)
        assert page.evaluate(SEEN) != before
        for _ in keys if back == "undo" else "1":
            page.get_by_role("button", name=back).click()
        settled(page)
        assert page.evaluate(SEEN) == before


def test_arrow_keys_move_a_shape_without_focus_except_in_a_text_field(browser, errors):
    hand = ExplorerModel(sv.scene("triangles"))
    with explored(browser, hand, errors, keys=True, viewport={"width": 1280, "height": 600}) as page:

        def moved(x, y):
            page.wait_for_function("() => !document.querySelector('[aria-label=undo]').disabled")
            settled(page)
            before, now = sv.scene("triangles").b.vertices[0], hand.scene.b.vertices[0]
            return [(now.x > before.x) - (now.x < before.x), (now.y > before.y) - (now.y < before.y)] == [x, y]

        page.keyboard.press("ArrowDown")  # scrolls the page: the explorer is not in use yet
        page.keyboard.press("ArrowLeft")
        assert moved(-1, 0)
        page.locator(".sv-sentence").click()  # in use, and still nothing has the focus
        page.keyboard.press("ArrowUp")
        assert moved(-1, 1)
        page.locator(".sv-paste > summary").click()
        place = hand.scene.b
        page.locator(".sv-text").fill("ab")
        page.locator(".sv-text").press("ArrowLeft")
        page.keyboard.type("x")
        page.get_by_label("presets").focus()
        page.keyboard.press("ArrowLeft")
        settled(page)
        assert page.locator(".sv-text").input_value() == "axb" and hand.scene.b == place


def test_a_dragged_shape_stays_where_it_touches_until_it_is_pulled_away(browser, errors):
    corner = sv.Polygon([(3.6, 1), (5, 0.5), (5, 2)])
    hand = ExplorerModel(sv.Scene("snap", sv.Polygon([(0, 0), (3, 0), (3, 3), (0, 3)]), corner))
    with explored(browser, hand, errors) as page:
        page.get_by_label("snap").check()
        box = page.locator("[data-handle=B-move]").bounding_box()
        x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
        page.mouse.move(x, y)
        page.mouse.down()
        unit = (
            hand.picture().scale * page.locator(".sv-board svg").first.bounding_box()["width"] / hand.picture().size[0]
        )
        for beside in (0.55, 0.65):  # in scene units to the left: a little apart, a little into A
            page.mouse.move(x - beside * unit, y)
            settled(page)
            assert hand.state()["relation"] == "touching"
        page.mouse.move(x - 1.2 * unit, y)
        settled(page)
        assert hand.state()["relation"] == "overlapping"
        page.mouse.move(x - 0.55 * unit, y)
        page.mouse.up()
        page.get_by_text("Snapped: they touch exactly.").wait_for()


@pytest.mark.parametrize("width", [768, 1024, 1280, 1440])
def test_the_toolbar_is_one_row_and_each_tool_has_an_icon_and_a_word(browser, errors, width):
    """Nothing in it is cut, and a range in the table is on one line."""
    hand = ExplorerModel(sv.scene("one-shapes-normals"))  # with the two views of a shortcut
    with explored(browser, hand, errors, viewport={"width": width, "height": 800}) as page:
        tools = page.locator(".sv-bar .sv-tool:visible").all() + page.locator(".sv-scenes select").all() * (
            width > 1000
        )
        boxes = [tool.bounding_box() for tool in tools]
        assert len(tools) == 11 + 2 * (width > 1000) and len({round(b["y"] + b["height"] / 2) for b in boxes}) == 1
        for tool in page.locator(".sv-bar .sv-tool:visible").all():
            assert tool.locator("svg[aria-hidden=true]").count() == 1 and tool.inner_text().strip()
            assert tool.evaluate("e => e.scrollWidth <= e.clientWidth")
        room = """select => { const pen = document.createElement('canvas').getContext('2d');
          pen.font = getComputedStyle(select).font;
          const arrow = 24, names = [...select.options].map(o => pen.measureText(o.text).width);
          return select.clientWidth - arrow - Math.max(...names); }"""
        assert all(select.evaluate(room) > 0 for select in page.locator(".sv-scenes select").all())
        for part in page.locator(".sv-table td.sv-A").all():
            assert part.evaluate("e => e.clientHeight < 40")


def test_the_message_about_snapping_disappears_at_the_next_change(browser, errors):
    corner = sv.Polygon([(3.07, 1), (5, 0.5), (5, 2)])
    hand = ExplorerModel(sv.Scene("snap", sv.Polygon([(0, 0), (3, 0), (3, 3), (0, 3)]), corner))
    with explored(browser, hand, errors) as page:
        page.get_by_label("free axis").check()
        page.get_by_label("snap").check()
        for follows in (lambda: page.locator(".sv-dial svg").click(), lambda: page.keyboard.press("Shift+ArrowRight")):
            box = page.locator("[data-handle=B-move]").bounding_box()
            page.mouse.click(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
            page.get_by_text("Snapped: they touch exactly.").wait_for()
            follows()
            page.get_by_text("Snapped: they touch exactly.").wait_for(state="detached")
            page.keyboard.press("Shift+ArrowRight")


def test_the_axis_turns_by_itself_on_request_but_not_with_reduced_motion(browser, errors):
    hand = ExplorerModel(sv.scene("triangles"))
    with explored(browser, hand, errors) as page:
        page.get_by_label("free axis").check()
        turn = page.get_by_role("button", name="turn the axis")
        turn.click()
        angle = "parseFloat(document.querySelector('.sv-sentence').textContent.split('axis at ')[1])"
        page.wait_for_function(f"() => {angle} > 34")
        turn.click()
        settled(page)
        stopped = hand._degree
        page.wait_for_timeout(300)
        assert hand._degree == stopped > 34 and turn.get_attribute("aria-pressed") == "false"
        box = page.locator(".sv-dial svg").bounding_box()
        page.mouse.click(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2 - 30)
        page.wait_for_function(f"() => {angle} === 90")
    with explored(browser, hand, errors, reduced_motion="reduce") as page:
        page.locator(".sv-dial").wait_for()
        assert not page.get_by_role("button", name="turn the axis").is_visible()


def test_on_a_touch_screen_handles_and_buttons_have_44_pixels_and_tools_are_at_the_bottom(browser, errors):
    with explored(browser, ExplorerModel(sv.scene("far-centers")), errors, **PHONE) as page:
        page.get_by_label("free axis").check()
        page.locator(".sv-dial").wait_for()
        small = """() => [...document.querySelectorAll('.satviz :is(button, select, summary, .sv-toggle, .sv-handle)')]
          .filter(e => e.checkVisibility()).map(e => [e.outerHTML.slice(0, 80), e.getBoundingClientRect()])
          .filter(([_, box]) => box.width && (box.width < 43.5 || box.height < 43.5)).map(([html]) => html)"""
        assert page.evaluate(small) == []
        box = page.locator(".sv-bar").bounding_box()
        assert box["y"] + box["height"] == pytest.approx(page.viewport_size["height"], abs=1) and box["height"] < 130


def test_nothing_jumps_while_a_shape_is_dragged(browser, errors):
    hand = ExplorerModel(sv.scene("triangles"))
    with explored(browser, hand, errors, viewport={"width": 1280, "height": 900}) as page:
        parts = [".sv-board", ".sv-line", ".sv-sentence", ".sv-tip", ".sv-fold", ".sv-tools"]

        def places():
            return [page.locator(part).bounding_box() for part in parts]

        box = page.locator("[data-handle=B-move]").bounding_box()
        x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
        before = [(b["x"], b["y"]) for b in places()]
        page.mouse.move(x, y)
        page.mouse.down()
        for i in range(1, 12):
            page.mouse.move(x - 20 * i, y + 3 * i)
            settled(page)
            assert [(b["x"], b["y"]) for b in places()] == before
        page.mouse.up()
