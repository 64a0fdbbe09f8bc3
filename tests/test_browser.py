"""In a real browser: the page from disk, the two pens side by side, the widgets in a real JupyterLab."""

import numpy as np
import pytest
from browser import chromium, jupyterlab

import satviz as sv
from satviz.pictures import THEMES
from satviz.render.files import canvas

SCENES = ["triangles", "circle-polygon", "concave", "aabb-rotated"]


@pytest.fixture(scope="module")
def browser():
    with chromium() as found:
        yield found


@pytest.fixture
def errors():
    """What the browser complained of; a test ends with none."""
    found = []
    yield found
    assert not found, found


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


READ = """() => [...document.querySelectorAll('[data-id]')].map(e => ({
  id: e.dataset.id, d: e.getAttribute('d'), at: e.dataset.at, text: e.dataset.text,
  fill: getComputedStyle(e).fill, stroke: getComputedStyle(e).stroke, width: e.getAttribute('stroke-width')}))"""


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
        by_id = {}
        for part in page.evaluate(READ):
            by_id.setdefault(part["id"], []).append(part)
        assert set(by_id) == {m.id for m in drawn.marks} == set(artists)
        x0, y0, _, _ = drawn.limits

        def scene(points, x0=x0, y0=y0, drawn=drawn):
            return np.asarray(points) / drawn.scale * [1, -1] + [x0, y0 + drawn.size[1] / drawn.scale]

        paths = [p.vertices for c in (pen.fills, pen.strokes, pen.solids) for p in c.get_paths()]
        close = 0.01 / drawn.scale
        for mark in drawn.marks:
            part = by_id[mark.id][-1]
            if mark.kind == "label":
                text = artists[mark.id]
                assert part["text"] == text.get_text() == mark.text
                assert np.allclose(scene([float(c) for c in part["at"].split()]), text.get_position(), atol=close)
                continue
            if mark.kind in ("disc",) or (mark.kind == "dot" and mark.role != "B"):
                edge = np.array(part["d"].replace("M", "").split("A")[0].split(), float)  # its leftmost point
                mine = [scene(edge)]
            else:
                mine = scene(numbers(part["d"]))
            for p in mine:  # each of its corners is a corner of a matplotlib path
                assert any((np.abs(v - p).max(axis=1) < close).any() for v in paths), (mark.id, p)
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


# -- in JupyterLab


@pytest.fixture(scope="module")
def lab(tmp_path_factory, browser):
    with jupyterlab(tmp_path_factory.mktemp("lab")) as found:
        yield found


NOTEBOOK = (
    "import satviz as sv\nw = sv.explore('triangles')\nw",
    "v = sv.explore('circle-polygon')\nv",
    "sv.play(sv.scene('triangles').record())",
)


ASK = """async code => {
  const kernel = jupyterapp.shell.currentWidget.sessionContext.session.kernel;
  let out = '';
  const asked = kernel.requestExecute({code});
  asked.onIOPub = message => { out += message.content.text ?? ''; };
  await asked.done;
  return out.trim();
}"""


class Hand:
    """A page with the notebook open and run; what a person does with it."""

    def __init__(self, browser, lab, **more):
        self.errors = []
        self.page = browser.new_page(viewport={"width": 1500, "height": 1900}, **more)
        self.page.on("pageerror", lambda error: self.errors.append(str(error)))
        lab.notebook("hand.ipynb", *NOTEBOOK)
        lab.open(self.page, "hand.ipynb")
        lab.run_all(self.page)
        self.page.locator(".sv-count").first.wait_for(timeout=60_000)
        self.widgets = self.page.locator(".satviz")

    def handle(self, name, widget=0):
        return self.widgets.nth(widget).locator(f"[data-handle='{name}']")

    def spot(self, name, widget=0):
        box = self.handle(name, widget).bounding_box()
        return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2

    def said(self, words, widget=0):
        self.widgets.nth(widget).locator(".sv-sentence").filter(has_text=words).wait_for(timeout=10_000)

    def drag(self, name, dx, dy, widget=0, steps=12):
        x, y = self.spot(name, widget)
        self.page.mouse.move(x, y)
        self.page.mouse.down()
        self.page.mouse.move(x + dx, y + dy, steps=steps)
        self.page.mouse.up()

    def kernel(self, expression):
        """What an expression is in the kernel."""
        return self.page.evaluate(ASK, f"print({expression})")


@pytest.fixture(scope="module")
def hand(browser, lab):
    found = Hand(browser, lab)
    yield found
    found.page.close()
    assert not found.errors, found.errors


def reset(hand):
    hand.widgets.first.get_by_role("button", name="reset").click()
    hand.said("A and B are apart")


def test_dragging_a_triangle_changes_the_sentence_and_the_kernel(hand):
    assert hand.kernel("w.trace.relation") == "apart"
    hand.drag("B-move", -130, 0)
    hand.said("A and B overlap")
    assert hand.kernel("w.trace.relation") == "overlapping"
    hand.widgets.first.get_by_role("button", name="undo").click()
    hand.said("A and B are apart")
    assert hand.kernel("w.scene == sv.scene('triangles')") == "True"


SEEN = """() => {
  const svg = document.querySelector('.satviz .sv-picture');
  const outline = () => svg.querySelector("[data-layer='2'] [data-id='B.outline']").getAttribute('d');
  window.seen = [outline()];
  svg.addEventListener('pointermove', () => window.seen.push(outline()), {once: true});
}"""


def test_the_outline_is_under_the_hand_in_the_same_event(hand):
    reset(hand)
    x, y = hand.spot("B-move")
    hand.page.mouse.move(x, y)
    hand.page.mouse.down()
    hand.page.evaluate(SEEN)
    hand.page.mouse.move(x + 40, y)
    before, after = hand.page.evaluate("() => window.seen")
    hand.page.mouse.up()
    assert before != after
    reset(hand)


def test_a_vertex_is_dragged_and_a_crossing_outline_is_refused(hand):
    reset(hand)
    hand.drag("A-vertex-1", -200, 130)
    why = hand.widgets.first.locator(".sv-why")
    assert hand.kernel("w.scene.a == sv.scene('triangles').a") == "False"
    reset(hand)
    bx, by = hand.spot("A-vertex-1")
    x, y = hand.spot("A-vertex-2")
    hand.page.mouse.move(x, y)
    hand.page.mouse.down()
    hand.page.mouse.move(bx, by, steps=8)  # two corners on one spot: no area
    why.filter(has_text="Not possible").wait_for(timeout=5000)
    hand.page.mouse.up()
    why.wait_for(state="hidden", timeout=5000)
    hand.said("A and B")
    assert hand.kernel("len(set(w.scene.a.vertices))") == "3"
    reset(hand)


def test_the_keyboard_moves_and_turns(hand):
    reset(hand)
    handle = hand.handle("B-move")
    handle.focus()
    for _ in range(30):
        handle.press("ArrowLeft")
    hand.said("A and B overlap")
    handle.press("[")
    hand.page.wait_for_timeout(300)
    assert hand.kernel("w.scene.b.vertices[0].y != 5.0") == "True"
    assert hand.page.evaluate("() => document.activeElement.dataset.handle") == "B-move"
    reset(hand)


def test_a_circle_is_made_larger_by_its_handle_without_moving_the_other_widget(hand):
    first = hand.kernel("w.scene.to_json()")
    radius = float(hand.kernel("v.scene.b.radius"))
    hand.drag("B-radius", 40, 0, widget=1)
    hand.page.wait_for_timeout(400)
    assert float(hand.kernel("v.scene.b.radius")) > radius
    assert hand.kernel("w.scene.to_json()") == first


def test_the_free_axis_turns_and_the_curve_follows(hand):
    reset(hand)
    widget = hand.widgets.first
    widget.get_by_label("free axis").check()
    hand.said("The axis at 30 degrees")
    assert widget.locator(".sv-curve [data-id^='candidate']").count() >= 5
    handle = hand.handle("axis")
    handle.focus()
    handle.press("[")
    hand.said("The axis at 35 degrees")
    widget.get_by_label("free axis").uncheck()
    hand.said("A and B are apart")


def test_presets_change_the_scene(hand):
    widget = hand.widgets.first
    widget.get_by_label("presets").select_option("circles")
    hand.handle("A-radius").wait_for()
    assert hand.kernel("w.scene.name") == "circles"
    widget.get_by_label("presets").select_option("triangles")
    hand.handle("A-vertex-0").wait_for()


def test_touch_drags_too(hand):
    reset(hand)
    x, y = hand.spot("B-move")
    session = hand.page.context.new_cdp_session(hand.page)

    def touch(kind, *points):
        session.send(
            "Input.dispatchTouchEvent", {"type": kind, "touchPoints": [{"x": px, "y": py} for px, py in points]}
        )

    touch("touchStart", (x, y))
    for i in range(1, 11):
        touch("touchMove", (x - 13 * i, y))
    touch("touchEnd")
    hand.said("A and B overlap")
    reset(hand)


RUN_FIRST_CELL = """async () => {
  const notebook = jupyterapp.shell.currentWidget.content;
  notebook.activeCellIndex = 0;
  await jupyterapp.commands.execute('notebook:run-cell');
}"""


def test_running_a_cell_again_leaks_no_listener(hand):
    """The old output's widget is taken down with its listeners: only the new one hears."""
    hand.page.evaluate("() => { window.old = document.querySelector('.satviz'); }")
    hand.page.evaluate(RUN_FIRST_CELL)
    hand.page.wait_for_function("() => !window.old.isConnected && document.querySelectorAll('.satviz').length === 3")
    assert hand.page.evaluate("() => window.old.childElementCount") == 0
    hand.drag("B-move", -130, 0)
    hand.said("A and B overlap")
    reset(hand)


def test_the_player_in_a_notebook_keeps_its_keys_to_itself(hand):
    player = hand.widgets.nth(2)
    player.locator(".sv-picture").press("ArrowRight")
    player.locator(".sv-count").filter(has_text="2 / 16").wait_for()
    player.locator(".sv-picture").press("End")
    player.locator(".sv-sentence").filter(has_text="are apart").wait_for()
    assert hand.page.locator(".jp-CodeCell").count() == 3
