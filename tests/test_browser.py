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


class OpenNotebook:
    """A page with an open notebook after its cells have run, and the actions of a person on it."""

    def __init__(self, browser, lab, app="lab", **more):
        self.errors = []
        self.page = browser.new_page(viewport={"width": 1500, "height": 1900}, **more)
        self.page.on("pageerror", self.complained)
        lab.notebook("explorer.ipynb", *NOTEBOOK)
        lab.open(self.page, "explorer.ipynb", app)
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

    def expect_sentence(self, words, widget=0):
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
        """Return the name and the bytes of the file that a button saves."""
        self.widgets.nth(widget).locator(".sv-menu summary:has-text('save')").click()
        with self.page.expect_download(timeout=120_000) as found:  # a GIF takes seconds on a quiet machine
            self.press(name, widget)
        return found.value.suggested_filename, found.value.path().read_bytes()

    def kernel(self, expression):
        """Return the value of an expression in the kernel, as text."""
        return self.page.evaluate(ASK, f"print({expression})")

    def until(self, expression):
        """Wait until an expression is true in the kernel: by then the browser has its answers too."""
        for _ in range(200):
            if self.kernel(expression) == "True":
                return
            self.page.wait_for_timeout(50)
        pytest.fail(f"never true in the kernel: {expression}; w.scene is {self.kernel('w.scene')}")


@pytest.fixture(scope="module")
def notebook(browser, lab):
    found = OpenNotebook(browser, lab)
    yield found
    found.page.close()
    assert not found.errors, found.errors


AT_START = "[w.scene.a, w.scene.b] == [sv.scene('triangles').a, sv.scene('triangles').b]"


def reset(notebook):
    notebook.press("reset")
    notebook.until(AT_START)


def test_dragging_a_triangle_changes_the_sentence_and_the_kernel(notebook):
    assert notebook.kernel("w.trace.relation") == "apart"
    notebook.drag("B-move", -130, 0)
    notebook.expect_sentence("A and B overlap")
    assert notebook.kernel("w.trace.relation") == "overlapping"
    notebook.press("undo")
    notebook.expect_sentence("A and B are apart")
    assert notebook.kernel("w.scene == sv.scene('triangles')") == "True"


SEEN = """() => {
  const svg = document.querySelector('.satviz .sv-picture');
  const outline = () => svg.querySelector("[data-layer='2'] [data-id='B.outline']").getAttribute('d');
  window.seen = [outline()];
  svg.closest('.satviz').addEventListener('pointermove', () => window.seen.push(outline()), {once: true});
}"""


def test_the_outline_follows_the_pointer_within_the_same_event(notebook):
    reset(notebook)
    x, y = notebook.spot("B-move")
    notebook.page.mouse.move(x, y)
    notebook.page.mouse.down()
    notebook.page.evaluate(SEEN)
    notebook.page.mouse.move(x + 40, y)
    before, after = notebook.page.evaluate("() => window.seen")
    notebook.page.mouse.up()
    assert before != after
    reset(notebook)


def test_a_vertex_is_dragged_and_a_crossing_outline_is_refused(notebook):
    reset(notebook)
    notebook.drag("A-vertex-1", -200, 130)
    why = notebook.widgets.first.locator(".sv-why")
    notebook.until("w.scene.a != sv.scene('triangles').a")
    reset(notebook)
    bx, by = notebook.spot("A-vertex-1")
    x, y = notebook.spot("A-vertex-2")
    notebook.page.mouse.move(x, y)
    notebook.page.mouse.down()
    notebook.page.mouse.move(bx, by, steps=8)  # two corners on one spot: no area
    why.filter(has_text="Not possible").wait_for(timeout=5000)
    notebook.page.mouse.up()
    notebook.expect_sentence("A and B")
    assert notebook.kernel("len(set(w.scene.a.vertices))") == "3"
    assert (
        why.is_visible() and notebook.widgets.first.locator(".sv-drawing.sv-wrong path").count() == 1
    )  # until the next change
    reset(notebook)
    why.wait_for(state="hidden", timeout=5000)
    assert notebook.widgets.first.locator(".sv-drawing path").count() == 0


def test_the_keyboard_moves_and_turns(notebook):
    reset(notebook)
    handle = notebook.handle("B-move")
    handle.focus()
    for _ in range(30):
        handle.press("ArrowLeft")
    notebook.expect_sentence("A and B overlap")
    handle.press("[")
    notebook.until("w.scene.b.vertices[0].y != 5.0")
    assert notebook.page.evaluate("() => document.activeElement.dataset.handle") == "B-move"
    reset(notebook)


def test_the_turn_handle_turns_a_shape_about_its_middle(notebook):
    reset(notebook)
    (mx, my), (x, y) = notebook.spot("B-move"), notebook.spot("B-rotate")
    notebook.drag("B-rotate", mx - (y - my) - x, my + (x - mx) - y)  # a quarter turn, wherever the handle sits
    notebook.until("w.scene.b.vertices[0].x > 6")
    before = sv.scene("triangles").b.vertices
    after = json.loads(notebook.kernel("[list(v) for v in w.scene.b.vertices]"))

    def sides(corners):
        return [dist(corners[i - 1], corners[i]) for i in range(3)]

    def middle(corners):
        return [sum(c) / 3 for c in zip(*corners)]

    assert sides(after) == pytest.approx(sides(before)) and middle(after) == pytest.approx(middle(before))
    reset(notebook)


def test_undo_goes_back_over_keys_and_presets_one_by_one(notebook):
    reset(notebook)
    handle = notebook.handle("A-vertex-0")
    handle.focus()
    handle.press("ArrowDown")
    notebook.until("w.scene.a != sv.scene('triangles').a")
    moved = notebook.kernel("list(w.scene.a.vertices)")
    notebook.widgets.first.get_by_label("presets").select_option("circles")
    notebook.handle("A-radius").wait_for()
    notebook.press("undo")
    notebook.handle("A-vertex-0").wait_for()
    assert notebook.kernel("list(w.scene.a.vertices)") == moved
    notebook.press("undo")
    notebook.until(AT_START)
    notebook.widgets.first.get_by_label("presets").select_option("triangles")
    notebook.until("w.scene.name == 'triangles'")


def test_a_circle_is_made_larger_by_its_handle_without_moving_the_other_widget(notebook):
    first = notebook.kernel("w.scene.to_json()")
    radius = float(notebook.kernel("v.scene.b.radius"))
    notebook.drag("B-radius", 40, 0, widget=1)
    notebook.until(f"v.scene.b.radius > {radius}")
    assert notebook.kernel("w.scene.to_json()") == first


def test_the_free_axis_turns_and_the_curve_follows(notebook):
    reset(notebook)
    widget = notebook.widgets.first
    widget.get_by_label("free axis").check()
    notebook.expect_sentence("The axis at 30 degrees")
    assert widget.locator(".sv-curve [data-id^='candidate']").count() >= 5
    handle = notebook.handle("axis")
    handle.focus()
    handle.press("[")
    notebook.expect_sentence("The axis at 35 degrees")
    widget.get_by_label("free axis").uncheck()
    notebook.expect_sentence("A and B are apart")


def test_a_failing_scene_has_a_switch_between_the_shortcut_and_the_truth(notebook):
    widget = notebook.widgets.first
    switch = widget.get_by_role("group", name="what is shown")
    assert not switch.is_visible()
    widget.get_by_label("presets").select_option("aabb-turned")
    notebook.expect_sentence("a false hit")
    assert switch.is_visible() and "Claim: the bounding boxes" in widget.locator(".sv-heading").inner_text()
    assert widget.locator("[data-id='error-region.0']").count() == 1
    notebook.press("truth")
    notebook.expect_sentence("A and B are apart: axis")
    assert notebook.kernel("w.trace.shortcut") == "None"
    assert widget.locator("[data-id='error-region.0']").count() == 0
    notebook.press("shortcut")
    notebook.expect_sentence("a false hit")
    notebook.drag("B-move", -100, 100)
    notebook.expect_sentence("and so it is")
    assert "Here it happens to be right" in widget.locator(".sv-heading").inner_text()
    widget.get_by_label("presets").select_option("triangles")
    notebook.until(AT_START)
    switch.wait_for(state="hidden")


def test_the_difference_is_shown_beside_the_scene_and_follows_a_drag(notebook):
    widget = notebook.widgets.first
    shown = widget.locator(".sv-difference")
    assert not shown.is_visible()
    widget.get_by_role("checkbox", name="B − A").check()
    shown.locator("[data-id='verdict']").filter(has_text="apart").wait_for()
    notebook.drag("B-move", -130, 0)
    shown.locator("[data-id='verdict']").filter(has_text="overlapping").wait_for()
    notebook.press("undo")
    widget.get_by_role("checkbox", name="B − A").uncheck()
    notebook.until(AT_START)
    shown.wait_for(state="hidden")


def test_presets_change_the_scene(notebook):
    widget = notebook.widgets.first
    widget.get_by_label("presets").select_option("circles")
    notebook.handle("A-radius").wait_for()
    assert notebook.kernel("w.scene.name") == "circles"
    widget.get_by_label("presets").select_option("triangles")
    notebook.handle("A-vertex-0").wait_for()


def test_a_challenge_can_be_set_evaluated_and_given_up(notebook):
    reset(notebook)
    widget = notebook.widgets.first
    goal = widget.locator(".sv-goal")
    assert not goal.is_visible()
    widget.get_by_label("challenges").select_option("one-axis")
    goal.get_by_text("2 axes separate them").wait_for()
    notebook.drag("B-move", -30, 0)
    goal.get_by_text("Exactly one axis separates them").wait_for()
    widget.get_by_label("challenges").select_option("")
    goal.wait_for(state="hidden")
    widget.get_by_label("presets").select_option("triangles")
    notebook.until(AT_START)


SLOW = """
import time
answer = w._model.answer
def slow(content):
    time.sleep({seconds} * (content.get("kind") in ("pose", "preset")))
    return answer(content)
w._model.answer = slow
"""


@pytest.mark.parametrize("seconds", [0.3, 1.2])  # three answers come within what is waited for, or beyond
def test_a_slow_python_loses_neither_a_preset_nor_the_end_of_a_drag(notebook, seconds):
    reset(notebook)
    widget = notebook.widgets.first
    notebook.page.evaluate(ASK, SLOW.format(seconds=seconds))
    notebook.drag("B-move", -130, 0)
    widget.get_by_label("presets").select_option("circles")
    notebook.drag("B-move", -30, 0)  # of shapes that are leaving
    notebook.until("w.scene == sv.scene('circles')")
    notebook.handle("A-radius").wait_for()
    widget.get_by_label("presets").select_option("triangles")
    notebook.handle("A-vertex-0").wait_for()
    notebook.drag("B-move", -130, 0)
    notebook.expect_sentence("A and B overlap")
    notebook.page.wait_for_timeout(1000 * 4 * seconds)  # what is on its way has come
    assert dist(json.loads(notebook.kernel("list(w.scene.b.vertices[0])")), (5, 5)) > 1
    notebook.page.wait_for_function(
        "words => document.querySelector('.satviz .sv-sentence').innerText === words",
        arg=notebook.kernel("w._model.picture().sentence"),
    )
    notebook.page.evaluate(ASK, "del w._model.answer")
    reset(notebook)


def test_files_come_from_the_matplotlib_pen(notebook):
    """Byte for byte what the same picture gives here."""
    trace = sv.scene("triangles").record()
    player = notebook.widgets.nth(2)
    player.get_by_role("slider", name="step").fill("7")
    drawn = sv.picture(trace, 7)
    for form in "svg", "png":
        assert notebook.file(f"save {form.upper()}", 2) == (f"satviz.{form}", encode(drawn, form, LIGHT))
    every = add_captions([sv.picture(trace, i) for i in range(len(sv.steps(trace)))], brief=True)
    pictures, times = animation(every)
    assert notebook.file("save GIF", 2) == ("satviz.gif", encode_frames(pictures, "gif", times=times))
    notebook.press("reset", 2)


def test_the_player_says_why_it_cannot_save_a_file(notebook):
    notebook.page.evaluate(ASK, "from satviz.pictures import playback; playback.MAX_STEPS = 1")
    player = notebook.widgets.nth(2)
    player.locator(".sv-menu summary:has-text('save')").click()
    notebook.press("save GIF", 2)
    player.locator(".sv-done", has_text="too many to step through").wait_for()
    notebook.page.evaluate(ASK, f"playback.MAX_STEPS = {playback.MAX_STEPS}")
    player.locator(".sv-menu summary:has-text('save')").click()  # forgotten when the menu opens again
    player.locator(".sv-done", has_text="too many").wait_for(state="detached")
    player.locator(".sv-menu summary:has-text('save')").click()


def test_the_explorer_saves_what_it_shows(notebook):
    reset(notebook)
    notebook.drag("B-move", -130, 0)
    notebook.expect_sentence("A and B overlap")
    name, svg = notebook.file("save SVG")
    assert name == "satviz.svg" and MADE_BY.encode() in svg and b">overlapping</text>" in svg
    for form, magic in ("png", b"\x89PNG\r\n"), ("gif", b"GIF89a"):
        name, data = notebook.file(f"save {form.upper()}")
        assert name == f"satviz.{form}" and data.startswith(magic)
    notebook.page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    notebook.widgets.first.locator(".sv-menu summary:has-text('save')").click()
    notebook.press("copy JSON")
    notebook.widgets.first.get_by_text("Copied.").wait_for()
    copied = notebook.page.evaluate("() => navigator.clipboard.readText()")
    assert copied == notebook.kernel("w.scene.to_json()")
    reset(notebook)


@pytest.mark.parametrize("width", [1500, 390])
def test_a_text_pasted_into_a_notebook_is_explained_and_can_be_exported(notebook, width):
    before = notebook.page.viewport_size
    sidebar = "jupyterapp.commands.execute('application:toggle-left-area')"  # leaves no room on a phone
    if width < 500:
        notebook.page.evaluate(sidebar)
    notebook.page.set_viewport_size({"width": width, "height": before["height"]})
    widget = notebook.widgets.first
    if not widget.locator(".sv-paste[open]").count():
        widget.locator(".sv-paste > summary").click()
    widget.locator(".sv-text").fill("int[] xs = {0, 4, 4, 0};\nint[] ys = {0, 0, 4, 4};\ncircle((5, 2), 1)\nscale = 3")
    notebook.press("explain")
    notebook.press("the shapes as read, without it: touching")
    widget.locator(".sv-findings", has_text="scale 3").wait_for(timeout=20_000)
    assert "A and B touch" in widget.locator(".sv-verdict").inner_text()
    notebook.until("w.scene.b == sv.Circle((5, 2), 1)")
    widget.get_by_text("send it on").click()
    with notebook.page.expect_download() as found:
        notebook.press("save picture as SVG")
    assert "A and B touch" in found.value.path().read_text(encoding="utf-8")
    fits = """() => {  // once JupyterLab has laid out its page for this width
      const right = selector => document.querySelector(selector).getBoundingClientRect().right;
      return right('.satviz .sv-text') <= right('.satviz') + 1;
    }"""
    notebook.page.wait_for_function(fits)
    notebook.page.set_viewport_size(before)
    if width < 500:
        notebook.page.evaluate(sidebar)
    widget.locator(".sv-paste > summary").click()
    widget.get_by_label("presets").select_option("triangles")  # what reset goes back to
    notebook.until(AT_START)


LOOKS = """() => {
  const root = document.querySelector('.satviz');
  const stroke = id => getComputedStyle(root.querySelector(`[data-layer='2'] [data-id='${id}']`)).stroke;
  return [getComputedStyle(root).backgroundColor, stroke('A.outline'), stroke('B.outline')];
}"""


@pytest.mark.parametrize("theme", [DARK, LIGHT], ids=["dark", "light"])
def test_the_picture_follows_jupyterlabs_theme(notebook, theme):
    name = f"JupyterLab {theme.name.title()}"
    notebook.page.evaluate("theme => jupyterapp.commands.execute('apputils:change-theme', {theme})", name)
    light = str(theme is LIGHT).lower()
    notebook.page.locator(f"body[data-jp-theme-light='{light}']").wait_for(state="attached")
    wanted = [css(theme.paper), css(theme.roles["A"]), css(theme.roles["B"])]
    notebook.page.wait_for_function(f"wanted => String(({LOOKS})()) === String(wanted)", arg=wanted)


def css(colour):
    """Return a colour such as "#0072B2" as "rgb(0, 114, 178)"."""
    return f"rgb({', '.join(str(c) for c in bytes.fromhex(colour[1:]))})"


def test_a_shape_can_be_dragged_by_touch(notebook):
    reset(notebook)
    x, y = notebook.spot("B-move")
    session = notebook.page.context.new_cdp_session(notebook.page)

    def touch(kind, *points):
        session.send(
            "Input.dispatchTouchEvent", {"type": kind, "touchPoints": [{"x": px, "y": py} for px, py in points]}
        )

    touch("touchStart", (x, y))
    for i in range(1, 11):
        touch("touchMove", (x - 13 * i, y))
    touch("touchEnd")
    notebook.expect_sentence("A and B overlap")
    reset(notebook)


RUN_FIRST_CELL = """async () => {
  const notebook = jupyterapp.shell.currentWidget.content;
  notebook.activeCellIndex = 0;
  await jupyterapp.commands.execute('notebook:run-cell');
}"""


def test_running_a_cell_again_leaks_no_listener(notebook):
    """The old output's widget is taken down with its listeners: only the new one hears."""
    notebook.page.evaluate("() => { window.old = document.querySelector('.satviz'); }")
    notebook.page.evaluate(RUN_FIRST_CELL)
    replaced = "() => !window.old.isConnected && document.querySelectorAll('.satviz').length === 3"
    notebook.page.wait_for_function(replaced)
    notebook.page.wait_for_function("() => window.old.childElementCount === 0")
    notebook.rest()
    notebook.drag("B-move", -130, 0)
    notebook.expect_sentence("A and B overlap")
    reset(notebook)


def test_the_player_in_a_notebook_keeps_its_keys_to_itself(notebook):
    player = notebook.widgets.nth(2)
    player.locator(".sv-picture").press("ArrowRight")
    player.locator(".sv-count").filter(has_text="2 / 16").wait_for()
    player.locator(".sv-picture").press("End")
    player.locator(".sv-sentence").filter(has_text="are apart").wait_for()
    assert notebook.page.locator(".jp-CodeCell").count() == 3


# -- in Notebook 7


def test_in_notebook_7_the_widgets_show_and_can_be_dragged(browser, lab):
    pytest.importorskip("notebook", minversion="7", reason="Notebook 7 is not installed")
    found = OpenNotebook(browser, lab, "notebooks")
    assert found.widgets.count() == 3 and found.page.locator(".jp-NotebookPanel").count() == 1
    found.drag("B-move", -130, 0)
    found.expect_sentence("A and B overlap")
    assert found.kernel("w.trace.relation") == "overlapping"
    found.widgets.nth(2).locator(".sv-picture").press("End")
    found.expect_sentence("A and B are apart", 2)
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
