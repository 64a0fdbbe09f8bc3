"""In a real browser: the two pens side by side, the page from disk."""

import numpy as np
import pytest
from matplotlib.colors import to_hex

import satviz as sv
from satviz.pictures import THEMES
from satviz.render.files import canvas

pytestmark = pytest.mark.slow

SCENES = ["triangles", "circle-polygon", "concave", "aabb-rotated"]


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


def numbers(path):
    """The coordinates of a path's M and L commands, in points."""
    flat = path.replace("Z", "").replace("L", " ").replace("M", " ").split()
    return np.array(flat, dtype=float).reshape(-1, 2)


READ = """() => [...document.querySelectorAll('[data-id]')].map(e => {
  const look = getComputedStyle(e), {x, y, width, height} = e.getBBox();
  const {fill, fillOpacity, stroke, strokeOpacity, strokeWidth, strokeDasharray, fontSize, fontWeight} = look;
  return {id: e.dataset.id, d: e.getAttribute('d'), at: e.dataset.at, text: e.dataset.text,
    box: [x, y, x + width, y + height], fill, fillOpacity, stroke, strokeOpacity,
    strokeWidth: parseFloat(strokeWidth), strokeDasharray, fontSize: parseFloat(fontSize), bold: fontWeight === '700'};
})"""


def colour(css):
    """ "rgb(0, 114, 178)" as "#0072b2"."""
    return to_hex([int(c) / 255 for c in css.removeprefix("rgb(").removesuffix(")").split(",")])


def svg_looks(parts):
    """(how it looks, the box around it in points) of each line and each filled shape in the browser."""
    for part in parts:
        if part["stroke"] != "none":
            dash = part["strokeDasharray"]
            dash = () if dash == "none" else tuple(float(d.removesuffix("px")) for d in dash.split(","))
            yield (colour(part["stroke"]), part["strokeOpacity"], part["strokeWidth"], dash), part["box"]
        elif part["d"]:
            yield (colour(part["fill"]), part["fillOpacity"], 0, ()), part["box"]


def matplotlib_looks(pen, drawn):
    """The same of the matplotlib pen's collections."""
    x0, _, _, y1 = drawn.limits

    def box(path):
        (left, low), (right, high) = path.get_extents().get_points()
        return [
            (left - x0) * drawn.scale,
            (y1 - high) * drawn.scale,
            (right - x0) * drawn.scale,
            (y1 - low) * drawn.scale,
        ]

    for filled in pen.fills, pen.solids:
        for path, rgba in zip(filled.get_paths(), filled.get_facecolors()):
            yield (to_hex(rgba), f"{rgba[3]:g}", 0, ()), box(path)
    lines = pen.strokes
    styles = lines.get_edgecolors(), lines.get_linewidths(), lines.get_linestyles()
    for path, rgba, width, (_, dash) in zip(lines.get_paths(), *styles):
        yield (to_hex(rgba), f"{rgba[3]:g}", width, tuple(dash or ())), box(path)


def alike(looks):
    """The boxes of those that look the same."""
    found = {}
    for look, box in looks:
        found.setdefault(look, []).append(box)
    return found


@pytest.mark.parametrize("theme", ["light", "dark"])
@pytest.mark.parametrize("name", SCENES)
def test_both_pens_draw_the_same_marks(browser, errors, pages, name, theme):
    """Ids, places in scene coordinates, texts, colours and widths, step by step."""
    trace = sv.scene(name).record()
    page = opened(browser, errors, pages / f"{name}.html", color_scheme=theme, reduced_motion="reduce")
    for i in range(len(sv.steps(trace))):
        drawn = sv.picture(trace, i)
        _, pen = canvas(drawn.size, THEMES[theme])
        artists = pen.draw(drawn)
        page.get_by_role("slider", name="step").fill(str(i))
        parts = page.evaluate(READ)
        by_id = {part["id"]: part for part in parts}
        assert set(by_id) == {m.id for m in drawn.marks} == set(artists)
        x0, y0, _, _ = drawn.limits

        def scene(points, x0=x0, y0=y0, drawn=drawn):
            return np.asarray(points) / drawn.scale * [1, -1] + [x0, y0 + drawn.size[1] / drawn.scale]

        paths = [p.vertices for c in (pen.fills, pen.strokes, pen.solids) for p in c.get_paths()]
        close = 0.01 / drawn.scale
        for mark in drawn.marks:
            part = by_id[mark.id]
            if mark.kind == "label":
                text = artists[mark.id]
                assert part["text"] == text.get_text() == mark.text
                assert np.allclose(scene([float(c) for c in part["at"].split()]), text.get_position(), atol=close)
                assert colour(part["fill"]) == to_hex(text.get_color())
                assert (part["fontSize"], part["bold"]) == (text.get_fontsize(), text.get_fontweight() == "bold")
                continue
            if mark.kind == "disc" or (mark.kind == "dot" and mark.role != "B"):
                edge = np.array(part["d"].replace("M", "").split("A")[0].split(), float)  # its leftmost point
                mine = [scene(edge)]
            else:
                mine = scene(numbers(part["d"]))
            for p in mine:  # each of its corners is a corner of a matplotlib path
                assert any((np.abs(v - p).max(axis=1) < close).any() for v in paths), (mark.id, p)
        mine, theirs = alike(svg_looks(parts)), alike(matplotlib_looks(pen, drawn))
        assert {look: len(boxes) for look, boxes in mine.items()} == {k: len(v) for k, v in theirs.items()}
        for look, boxes in mine.items():
            for box in boxes:
                # (a browser boxes an arc only roughly)
                assert any(np.allclose(box, other, atol=0.1) for other in theirs[look]), (look, box)
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
