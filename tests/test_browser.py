"""In a real browser: the widgets in a real JupyterLab and in Notebook 7."""

import json
import shutil
from math import dist

import pytest
from browser import jupyterlab

import satviz as sv
from satviz.lessons.shipped import shipped_notebooks
from satviz.pictures import DARK, LIGHT, playback
from satviz.pictures.caption import add_captions
from satviz.pictures.moves import animation
from satviz.render.files import MADE_BY, encode, encode_frames

pytestmark = pytest.mark.slow

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

    def __init__(self, browser, lab, app="lab", **more):
        self.errors = []
        self.page = browser.new_page(viewport={"width": 1500, "height": 1900}, **more)
        self.page.on("pageerror", self.complained)
        lab.notebook("hand.ipynb", *NOTEBOOK)
        lab.open(self.page, "hand.ipynb", app)
        lab.run_all(self.page)
        self.widgets = self.page.locator(".satviz")
        self.page.locator(".sv-count").first.wait_for(timeout=60_000)
        self.page.wait_for_function("() => document.querySelectorAll('.satviz').length === 3")
        self.rest()

    def rest(self):
        """Wait until B stays where it is: JupyterLab still scrolls and lays out after the cells have run."""
        before = None
        while (now := self.spot("B-move")) != before:
            before = now
            self.page.wait_for_timeout(500)

    def complained(self, error):
        """Keep what goes wrong in a widget, whose code comes from a blob; Jupyter has errors of its own."""
        if "blob:" in (error.stack or ""):
            self.errors.append(error.stack)

    def handle(self, name, widget=0):
        return self.widgets.nth(widget).locator(f"[data-handle='{name}']")

    def spot(self, name, widget=0):
        box = self.handle(name, widget).bounding_box()
        return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2

    def said(self, words, widget=0):
        self.widgets.nth(widget).locator(".sv-sentence").filter(has_text=words).wait_for(timeout=20_000)

    def drag(self, name, dx, dy, widget=0, steps=12):
        x, y = self.spot(name, widget)
        self.page.mouse.move(x, y)
        self.page.mouse.down()
        self.page.mouse.move(x + dx, y + dy, steps=steps)
        self.page.mouse.up()

    def press(self, name, widget=0):
        self.widgets.nth(widget).get_by_role("button", name=name, exact=True).click()

    def file(self, name, widget=0):
        """The name and the bytes of the file that a button hands over."""
        self.widgets.nth(widget).locator(".sv-menu summary:has-text('save')").click()
        with self.page.expect_download() as found:
            self.press(name, widget)
        return found.value.suggested_filename, found.value.path().read_bytes()

    def kernel(self, expression):
        """What an expression is in the kernel."""
        return self.page.evaluate(ASK, f"print({expression})")

    def until(self, expression):
        """Wait until an expression is true in the kernel: by then the browser has its answers too."""
        for _ in range(200):
            if self.kernel(expression) == "True":
                return
            self.page.wait_for_timeout(50)
        pytest.fail(f"never true in the kernel: {expression}; w.scene is {self.kernel('w.scene')}")


@pytest.fixture(scope="module")
def hand(browser, lab):
    found = Hand(browser, lab)
    yield found
    found.page.close()
    assert not found.errors, found.errors


AT_START = "[w.scene.a, w.scene.b] == [sv.scene('triangles').a, sv.scene('triangles').b]"


def reset(hand):
    hand.press("reset")
    hand.until(AT_START)


def test_dragging_a_triangle_changes_the_sentence_and_the_kernel(hand):
    assert hand.kernel("w.trace.relation") == "apart"
    hand.drag("B-move", -130, 0)
    hand.said("A and B overlap")
    assert hand.kernel("w.trace.relation") == "overlapping"
    hand.press("undo")
    hand.said("A and B are apart")
    assert hand.kernel("w.scene == sv.scene('triangles')") == "True"


SEEN = """() => {
  const svg = document.querySelector('.satviz .sv-picture');
  const outline = () => svg.querySelector("[data-layer='2'] [data-id='B.outline']").getAttribute('d');
  window.seen = [outline()];
  svg.closest('.satviz').addEventListener('pointermove', () => window.seen.push(outline()), {once: true});
}"""


def test_the_outline_follows_the_pointer_within_the_same_event(hand):
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
    hand.until("w.scene.a != sv.scene('triangles').a")
    reset(hand)
    bx, by = hand.spot("A-vertex-1")
    x, y = hand.spot("A-vertex-2")
    hand.page.mouse.move(x, y)
    hand.page.mouse.down()
    hand.page.mouse.move(bx, by, steps=8)  # two corners on one spot: no area
    why.filter(has_text="Not possible").wait_for(timeout=5000)
    hand.page.mouse.up()
    hand.said("A and B")
    assert hand.kernel("len(set(w.scene.a.vertices))") == "3"
    assert (
        why.is_visible() and hand.widgets.first.locator(".sv-drawing.sv-wrong path").count() == 1
    )  # until the next change
    reset(hand)
    why.wait_for(state="hidden", timeout=5000)
    assert hand.widgets.first.locator(".sv-drawing path").count() == 0


def test_the_keyboard_moves_and_turns(hand):
    reset(hand)
    handle = hand.handle("B-move")
    handle.focus()
    for _ in range(30):
        handle.press("ArrowLeft")
    hand.said("A and B overlap")
    handle.press("[")
    hand.until("w.scene.b.vertices[0].y != 5.0")
    assert hand.page.evaluate("() => document.activeElement.dataset.handle") == "B-move"
    reset(hand)


def test_the_turn_handle_turns_a_shape_about_its_middle(hand):
    reset(hand)
    (mx, my), (x, y) = hand.spot("B-move"), hand.spot("B-rotate")
    hand.drag("B-rotate", mx - (y - my) - x, my + (x - mx) - y)  # a quarter turn, wherever the handle sits
    hand.until("w.scene.b.vertices[0].x > 6")
    before = sv.scene("triangles").b.vertices
    after = json.loads(hand.kernel("[list(v) for v in w.scene.b.vertices]"))

    def sides(corners):
        return [dist(corners[i - 1], corners[i]) for i in range(3)]

    def middle(corners):
        return [sum(c) / 3 for c in zip(*corners)]

    assert sides(after) == pytest.approx(sides(before)) and middle(after) == pytest.approx(middle(before))
    reset(hand)


def test_undo_goes_back_over_keys_and_presets_one_by_one(hand):
    reset(hand)
    handle = hand.handle("A-vertex-0")
    handle.focus()
    handle.press("ArrowDown")
    hand.until("w.scene.a != sv.scene('triangles').a")
    moved = hand.kernel("list(w.scene.a.vertices)")
    hand.widgets.first.get_by_label("presets").select_option("circles")
    hand.handle("A-radius").wait_for()
    hand.press("undo")
    hand.handle("A-vertex-0").wait_for()
    assert hand.kernel("list(w.scene.a.vertices)") == moved
    hand.press("undo")
    hand.until(AT_START)
    hand.widgets.first.get_by_label("presets").select_option("triangles")
    hand.until("w.scene.name == 'triangles'")


def test_a_circle_is_made_larger_by_its_handle_without_moving_the_other_widget(hand):
    first = hand.kernel("w.scene.to_json()")
    radius = float(hand.kernel("v.scene.b.radius"))
    hand.drag("B-radius", 40, 0, widget=1)
    hand.until(f"v.scene.b.radius > {radius}")
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


def test_a_failing_scene_has_a_switch_between_the_shortcut_and_the_truth(hand):
    widget = hand.widgets.first
    switch = widget.get_by_role("group", name="what is shown")
    assert not switch.is_visible()
    widget.get_by_label("presets").select_option("aabb-turned")
    hand.said("a false hit")
    assert switch.is_visible() and "Claim: the bounding boxes" in widget.locator(".sv-heading").inner_text()
    assert widget.locator("[data-id='error-region.0']").count() == 1
    hand.press("truth")
    hand.said("A and B are apart: axis")
    assert hand.kernel("w.trace.shortcut") == "None"
    assert widget.locator("[data-id='error-region.0']").count() == 0
    hand.press("shortcut")
    hand.said("a false hit")
    hand.drag("B-move", -100, 100)
    hand.said("and so it is")
    assert "Here it happens to be right" in widget.locator(".sv-heading").inner_text()
    widget.get_by_label("presets").select_option("triangles")
    hand.until(AT_START)
    switch.wait_for(state="hidden")


def test_the_difference_is_shown_beside_the_scene_and_follows_a_drag(hand):
    widget = hand.widgets.first
    shown = widget.locator(".sv-difference")
    assert not shown.is_visible()
    widget.get_by_role("checkbox", name="B − A").check()
    shown.locator("[data-id='verdict']").filter(has_text="apart").wait_for()
    hand.drag("B-move", -130, 0)
    shown.locator("[data-id='verdict']").filter(has_text="overlapping").wait_for()
    hand.press("undo")
    widget.get_by_role("checkbox", name="B − A").uncheck()
    hand.until(AT_START)
    shown.wait_for(state="hidden")


def test_presets_change_the_scene(hand):
    widget = hand.widgets.first
    widget.get_by_label("presets").select_option("circles")
    hand.handle("A-radius").wait_for()
    assert hand.kernel("w.scene.name") == "circles"
    widget.get_by_label("presets").select_option("triangles")
    hand.handle("A-vertex-0").wait_for()


def test_a_challenge_can_be_set_evaluated_and_given_up(hand):
    reset(hand)
    widget = hand.widgets.first
    goal = widget.locator(".sv-goal")
    assert not goal.is_visible()
    widget.get_by_label("challenges").select_option("one-axis")
    goal.get_by_text("2 axes separate them").wait_for()
    hand.drag("B-move", -30, 0)
    goal.get_by_text("Exactly one axis separates them").wait_for()
    widget.get_by_label("challenges").select_option("")
    goal.wait_for(state="hidden")
    widget.get_by_label("presets").select_option("triangles")
    hand.until(AT_START)


SLOW = """
import time
answer = w._model.answer
def slow(content):
    time.sleep({seconds} * (content.get("kind") in ("pose", "preset")))
    return answer(content)
w._model.answer = slow
"""


@pytest.mark.parametrize("seconds", [0.3, 1.2])  # three answers come within what is waited for, or beyond
def test_a_slow_python_loses_neither_a_preset_nor_the_end_of_a_drag(hand, seconds):
    reset(hand)
    widget = hand.widgets.first
    hand.page.evaluate(ASK, SLOW.format(seconds=seconds))
    hand.drag("B-move", -130, 0)
    widget.get_by_label("presets").select_option("circles")
    hand.drag("B-move", -30, 0)  # of shapes that are leaving
    hand.until("w.scene == sv.scene('circles')")
    hand.handle("A-radius").wait_for()
    widget.get_by_label("presets").select_option("triangles")
    hand.handle("A-vertex-0").wait_for()
    hand.drag("B-move", -130, 0)
    hand.said("A and B overlap")
    hand.page.wait_for_timeout(1000 * 4 * seconds)  # what is on its way has come
    assert dist(json.loads(hand.kernel("list(w.scene.b.vertices[0])")), (5, 5)) > 1
    hand.page.wait_for_function(
        "words => document.querySelector('.satviz .sv-sentence').innerText === words",
        arg=hand.kernel("w._model.picture().sentence"),
    )
    hand.page.evaluate(ASK, "del w._model.answer")
    reset(hand)


def test_files_come_from_the_matplotlib_pen(hand):
    """Byte for byte what the same picture gives here."""
    trace = sv.scene("triangles").record()
    player = hand.widgets.nth(2)
    player.get_by_role("slider", name="step").fill("7")
    drawn = sv.picture(trace, 7)
    for form in "svg", "png":
        assert hand.file(f"save {form.upper()}", 2) == (f"satviz.{form}", encode(drawn, form, LIGHT))
    every = add_captions([sv.picture(trace, i) for i in range(len(sv.steps(trace)))], brief=True)
    pictures, times = animation(every)
    assert hand.file("save GIF", 2) == ("satviz.gif", encode_frames(pictures, "gif", times=times))
    hand.press("reset", 2)


def test_the_player_says_why_it_cannot_save_a_file(hand):
    hand.page.evaluate(ASK, "from satviz.pictures import playback; playback.MAX_STEPS = 1")
    player = hand.widgets.nth(2)
    player.locator(".sv-menu summary:has-text('save')").click()
    hand.press("save GIF", 2)
    player.locator(".sv-done", has_text="too many to step through").wait_for()
    hand.page.evaluate(ASK, f"playback.MAX_STEPS = {playback.MAX_STEPS}")
    player.locator(".sv-menu summary:has-text('save')").click()  # forgotten when the menu opens again
    player.locator(".sv-done", has_text="too many").wait_for(state="detached")
    player.locator(".sv-menu summary:has-text('save')").click()


def test_the_explorer_saves_what_it_shows(hand):
    reset(hand)
    hand.drag("B-move", -130, 0)
    hand.said("A and B overlap")
    name, svg = hand.file("save SVG")
    assert name == "satviz.svg" and MADE_BY.encode() in svg and b">overlapping</text>" in svg
    for form, magic in ("png", b"\x89PNG\r\n"), ("gif", b"GIF89a"):
        name, data = hand.file(f"save {form.upper()}")
        assert name == f"satviz.{form}" and data.startswith(magic)
    hand.page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    hand.widgets.first.locator(".sv-menu summary:has-text('save')").click()
    hand.press("copy JSON")
    hand.widgets.first.get_by_text("Copied.").wait_for()
    copied = hand.page.evaluate("() => navigator.clipboard.readText()")
    assert copied == hand.kernel("w.scene.to_json()")
    reset(hand)


@pytest.mark.parametrize("width", [1500, 390])
def test_a_text_pasted_into_a_notebook_is_explained_and_can_be_exported(hand, width):
    before = hand.page.viewport_size
    sidebar = "jupyterapp.commands.execute('application:toggle-left-area')"  # leaves no room on a phone
    if width < 500:
        hand.page.evaluate(sidebar)
    hand.page.set_viewport_size({"width": width, "height": before["height"]})
    widget = hand.widgets.first
    if not widget.locator(".sv-paste[open]").count():
        widget.locator(".sv-paste > summary").click()
    widget.locator(".sv-text").fill("int[] xs = {0, 4, 4, 0};\nint[] ys = {0, 0, 4, 4};\ncircle((5, 2), 1)\nscale = 3")
    hand.press("explain")
    hand.press("the shapes as read, without it: touching")
    widget.locator(".sv-verdict", has_text="A and B touch").wait_for(timeout=20_000)
    assert "scale 3" in widget.locator(".sv-findings").inner_text()
    hand.until("w.scene.b == sv.Circle((5, 2), 1)")
    widget.get_by_text("send it on").click()
    with hand.page.expect_download() as found:
        hand.press("save picture as SVG")
    assert "A and B touch" in found.value.path().read_text(encoding="utf-8")
    fits = """() => {  // once JupyterLab has laid out its page for this width
      const right = selector => document.querySelector(selector).getBoundingClientRect().right;
      return right('.satviz .sv-text') <= right('.satviz') + 1;
    }"""
    hand.page.wait_for_function(fits)
    hand.page.set_viewport_size(before)
    if width < 500:
        hand.page.evaluate(sidebar)
    widget.locator(".sv-paste > summary").click()
    widget.get_by_label("presets").select_option("triangles")  # what reset goes back to
    hand.until(AT_START)


LOOKS = """() => {
  const root = document.querySelector('.satviz');
  const stroke = id => getComputedStyle(root.querySelector(`[data-layer='2'] [data-id='${id}']`)).stroke;
  return [getComputedStyle(root).backgroundColor, stroke('A.outline'), stroke('B.outline')];
}"""


@pytest.mark.parametrize("theme", [DARK, LIGHT], ids=["dark", "light"])
def test_the_picture_follows_jupyterlabs_theme(hand, theme):
    name = f"JupyterLab {theme.name.title()}"
    hand.page.evaluate("theme => jupyterapp.commands.execute('apputils:change-theme', {theme})", name)
    light = str(theme is LIGHT).lower()
    hand.page.locator(f"body[data-jp-theme-light='{light}']").wait_for(state="attached")
    wanted = [css(theme.paper), css(theme.roles["A"]), css(theme.roles["B"])]
    hand.page.wait_for_function(f"wanted => String(({LOOKS})()) === String(wanted)", arg=wanted)


def css(colour):
    """ "#0072B2" as "rgb(0, 114, 178)"."""
    return f"rgb({', '.join(str(c) for c in bytes.fromhex(colour[1:]))})"


def test_a_shape_can_be_dragged_by_touch(hand):
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
    hand.page.wait_for_function("() => window.old.childElementCount === 0")
    hand.rest()
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


# -- in Notebook 7


def test_in_notebook_7_the_widgets_show_and_can_be_dragged(browser, lab):
    pytest.importorskip("notebook", minversion="7", reason="Notebook 7 is not installed")
    found = Hand(browser, lab, "notebooks")
    assert found.widgets.count() == 3 and found.page.locator(".jp-NotebookPanel").count() == 1
    found.drag("B-move", -130, 0)
    found.said("A and B overlap")
    assert found.kernel("w.trace.relation") == "overlapping"
    found.widgets.nth(2).locator(".sv-picture").press("End")
    found.said("A and B are apart", 2)
    found.page.close()
    assert not found.errors, found.errors


@pytest.mark.parametrize("app", ["lab", "notebooks"])
def test_the_text_that_answers_a_question_of_a_chapter_is_folded(browser, lab, app):
    chapter = next(path for path in shipped_notebooks() if path.name.startswith("1"))
    shutil.copy(chapter, lab.folder / "chapter.ipynb")
    page = browser.new_page(viewport={"width": 1200, "height": 12_000})
    lab.open(page, "chapter.ipynb", app)
    answer = page.locator(".jp-Notebook details", has_text="Only one. The table")
    answer.wait_for(timeout=60_000)
    text = answer.locator("p", has_text="Only one.")
    assert not text.is_visible()
    answer.locator("summary").press("Enter")
    text.wait_for()
    answers = page.locator(".jp-Notebook details", has_text="The answer")
    assert [each.get_attribute("open") is not None for each in answers.all()].count(True) == 1
    page.close()
