"""In a real browser: the two pens side by side, the page from disk."""

import re

import numpy as np
import pytest
from matplotlib.colors import to_hex
from matplotlib.path import Path

import satviz as sv
from satviz.pictures import THEMES
from satviz.render.files import canvas

pytestmark = pytest.mark.slow

SCENES = ["triangles", "circle-polygon", "concave", "aabb-rotated", "far-centers", "raw-depth", "tile-seam"]


def opened(browser, errors, path, **more):
    page = browser.new_page(**more)
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.on("console", lambda message: errors.append(message.text) if message.type == "error" else None)
    page.goto(path.as_uri())
    page.locator(".sv-picture").first.wait_for()
    return page


@pytest.fixture(scope="module")
def pages(tmp_path_factory):
    folder = tmp_path_factory.mktemp("pages")
    for name in SCENES:
        (folder / f"{name}.html").write_text(sv.page(sv.scene(name).record(), title=name), encoding="utf-8")
    return folder


READ = """() => [...document.querySelectorAll('[data-id]')].map(e => {
  const look = getComputedStyle(e);
  const {fill, fillOpacity, stroke, strokeOpacity, strokeWidth, strokeDasharray, fontSize, fontWeight} = look;
  return {id: e.dataset.id, d: e.getAttribute('d'), at: e.dataset.at, text: e.dataset.text,
    fill, fillOpacity, stroke, strokeOpacity, strokeWidth: parseFloat(strokeWidth),
    strokeDasharray, fontSize: parseFloat(fontSize), bold: fontWeight === '700'};
})"""


def colour(css):
    """ "rgb(0, 114, 178)" as "#0072b2"."""
    return to_hex([int(c) / 255 for c in css.removeprefix("rgb(").removesuffix(")").split(",")])


def svg_look(part):
    """How a line, a filled shape or a text looks, and its corners in points; of a circle its leftmost and rightmost."""
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
    """The same of all that the matplotlib pen drew, what lies on top last."""

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
    """Ids, places, texts, colours, widths, dashes and what lies on what, mark by mark and step by step."""
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
    assert moved == {"normal", "axis", "drop", "landing", "range", "gap"}
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
    page.get_by_role("button", name="test the axes left out").click()
    page.get_by_role("button", name="last step").click()
    assert page.locator("tr.sv-skipped").count() == 0 and page.locator("tbody tr").count() == 6
    page.close()


def test_the_page_plays_only_when_asked_and_stops_at_the_end(browser, errors, pages):
    page = opened(browser, errors, pages / "triangles.html", reduced_motion="reduce")
    page.wait_for_timeout(600)
    assert page.locator(".sv-count").inner_text() == "1 / 16"
    page.get_by_role("slider", name="step").fill("14")
    page.get_by_role("button", name="play").click()
    page.get_by_text("16 / 16").wait_for(timeout=5000)
    page.get_by_role("button", name="play").wait_for()
    page.close()


def test_predict_asks_before_it_shows_and_keeps_count(browser, errors, pages):
    page = opened(browser, errors, pages / "triangles.html", reduced_motion="reduce")
    page.get_by_label("predict").check()
    page.get_by_role("button", name="last step").click()
    question = page.locator(".sv-question")
    assert "separate them?" in question.inner_text() and "1.664" not in page.locator("tbody").inner_text()
    question.get_by_role("button", name="yes").click()
    assert page.locator(".sv-sentence").inner_text().startswith("Not so.")
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
