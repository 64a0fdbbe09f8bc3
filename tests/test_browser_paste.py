"""The paste box and shapes by hand, in a real browser, at the width of a desk and of a phone."""

import pytest
from browser import accessibility_faults, axe, explored, settled
from reports import REPORTS

import satviz as sv
from satviz.widgets.explorer_model import ExplorerModel

pytestmark = pytest.mark.slow

WIDTHS = pytest.mark.parametrize("width", [1300, 390])
BY_THREAD = {report.thread: report for report in REPORTS}


BY_HAND = "draw polygon", "draw circle", "add corner", "remove corner"


class Desk:
    """A page with the explorer, and what a person does with it."""

    def __init__(self, page, model, touch=False):
        self.page, self.model, self.touch = page, model, touch

    def paste(self, text):
        if not self.page.locator(".sv-paste[open]").count():
            self.page.locator(".sv-paste > summary").click()
        self.page.locator(".sv-text").fill(text)
        self.press("explain")

    def press(self, name):
        if name in BY_HAND:
            self.page.get_by_text("draw", exact=True).click()
        self.page.get_by_role("button", name=name, exact=True).click()
        settled(self.page)

    def click(self, *places):
        """Click on, or on a phone tap, places of the board, each as shares of its width and height."""
        self.page.locator(".sv-board").scroll_into_view_if_needed()
        for x, y in places:
            box = self.page.locator(".sv-board").bounding_box()
            spot = box["x"] + box["width"] * x, box["y"] + box["height"] * y
            (self.page.touchscreen.tap if self.touch else self.page.mouse.click)(*spot)
        settled(self.page)

    def text(self, selector):
        return self.page.locator(selector).inner_text()


@pytest.fixture
def desk(browser, width, request):
    errors = []
    model = ExplorerModel(sv.scene("triangles"))
    more = {"viewport": {"width": width, "height": 1000}, "has_touch": width < 500}
    with explored(browser, model, errors, **more) as page:
        yield Desk(page, model, touch=width < 500)
    assert errors == []


@WIDTHS
@pytest.mark.parametrize("thread", ["libgdx/libgdx#1635", "MonoGame/MonoGame#468", "Turfjs/turf#1333"])
def test_a_pasted_report_is_explained_in_the_page(desk, width, thread):
    report = BY_THREAD[thread]
    desk.paste(report.text)
    verdict, findings = desk.text(".sv-verdict"), desk.text(".sv-findings")
    assert (report.meant or {"touching": "touch", "overlapping": "overlap"}[report.relation]) in verdict
    assert {"crossing-outline": "crosses itself", "touching": "touch", "containment": "inside"}[
        report.finding
    ] in findings
    assert desk.page.locator(".sv-refused").count() == (report.finding == "crossing-outline")
    assert desk.page.evaluate("document.documentElement.scrollWidth <= innerWidth"), "nothing is wider than the page"


@WIDTHS
def test_an_unknown_part_is_named_and_a_button_leaves_it_out(desk, width):
    desk.paste("a = np.array([[0, 0], [4, 0], [0, 3]]).T\ncircle((1, 1), 2)")
    verdicts = desk.page.locator(".sv-verdict").all_inner_texts()
    assert ".T" in verdicts[0] and verdicts[1] == "Without it:" and "A and B overlap" in verdicts[2]
    desk.press("the shapes as read, without it: overlapping")
    assert "overlap" in desk.text(".sv-verdict") and ".T" in desk.text(".sv-findings")


@WIDTHS
def test_a_button_takes_in_what_may_be_a_shape_and_its_form_is_asked_then(desk, width):
    desk.paste("circle((0, 0), 5)\ncircle((30, 0), 5)\nEdit: with (4, 0, 9, 5)")
    assert "Choose which it is" in desk.page.locator(".sv-verdict").first.inner_text()
    desk.press("a shape of its own: A and C overlap")
    questions = desk.page.get_by_role("button", name="two opposite corners")
    assert "of 3 pairs meet" in desk.text(".sv-verdict") and questions.count() == 1
    assert desk.page.evaluate("document.documentElement.scrollWidth <= innerWidth"), "nothing is wider than the page"


@WIDTHS
def test_the_exported_files_hold_a_picture_of_the_pair(desk, width):
    desk.paste("circle((0, 0), 2) circle((9, 9), 1) [0,0, 4,0, 0,4]")
    desk.page.get_by_text("send it on").click()
    for form, begins in ("SVG", b"<svg"), ("PNG", b"\x89PNG"):
        with desk.page.expect_download() as found:
            desk.page.get_by_role("button", name=f"save picture as {form}").click()
        data = found.value.path().read_bytes()
        assert found.value.suggested_filename == f"satviz.{form.lower()}" and data.startswith(begins)
        assert form == "PNG" or b"A and C overlap" in data
    assert desk.page.evaluate("document.documentElement.scrollWidth <= innerWidth"), "nothing is wider than the page"


@WIDTHS
def test_an_ambiguous_paste_gives_a_question_with_both_answers(desk, width):
    desk.paste(BY_THREAD["nenjack/check2d#52"].text)
    buttons = desk.page.locator(".sv-question button").all_inner_texts()
    assert [b.rsplit(": ", 1)[1] for b in buttons] == ["apart", "overlapping"]
    desk.page.locator(".sv-question button").nth(1).click()
    desk.page.locator(".sv-findings").wait_for()
    settled(desk.page)
    assert "overlap" in desk.text(".sv-verdict") and str(desk.model.trace.relation) == "overlapping"


@WIDTHS
def test_the_diagnosis_without_what_is_not_understood_stands_below_the_question(desk, width):
    before = desk.model.state()
    desk.paste("a = [(0,0),(4,0),(4,4)]\nb = [(4,0),(8,0),(8,4)] zork 3")
    desk.page.locator(".sv-findings").wait_for()
    asked, heading, answer = desk.page.locator(".sv-verdict").all_inner_texts()
    assert asked.startswith("Not understood") and heading == "Without it:" and answer.startswith("A and B touch")
    assert "they share border points" in desk.text(".sv-findings") and "send it on" not in desk.text(".sv-answer")
    assert desk.model.state() == before
    desk.page.locator(".sv-question button").click()
    settled(desk.page)
    assert str(desk.model.trace.relation) == "touching" and "send it on" in desk.text(".sv-answer")


@WIDTHS
def test_an_error_keeps_the_text_and_the_scene_and_markup_stays_text(desk, width):
    before = desk.model.state()
    bad = "<img src=x onerror='document.title = 1'> \u05de\u05e8\u05d5\u05d1\u05e2"
    desk.paste(bad)
    assert "no shape was found" in desk.page.locator(".sv-paste .sv-unread").inner_text()
    assert desk.page.locator(".sv-text").input_value() == bad and desk.model.state()["json"] == before["json"]
    desk.paste("<b>x</b> = circle((0, 0), 1)\n<b>y</b> = circle((1, 0), 1)")
    assert desk.page.locator(".sv-answer b b").count() == 0 and "overlap" in desk.text(".sv-verdict")
    assert desk.page.title() == "An explorer"


@WIDTHS
def test_the_undo_button_restores_the_scene_and_control_z_in_the_text_box_only_its_text(desk, width):
    before = desk.model.state()["json"]
    desk.paste("circle((0, 0), 1) circle((1, 0), 1)")
    desk.page.locator(".sv-text").press("End")
    desk.page.locator(".sv-text").press("z")
    desk.page.locator(".sv-text").press("Control+z")
    assert desk.model.scene.b == sv.Circle((1, 0), 1)
    desk.press("undo")
    assert desk.model.state()["json"] == before


@WIDTHS
def test_a_polygon_is_drawn_by_clicking_and_undone(desk, width):
    first = desk.model.scene
    desk.press("draw polygon")
    desk.click((0.2, 0.2), (0.5, 0.25), (0.4, 0.5), (0.2, 0.45))
    desk.press("done")
    assert len(desk.model.scene.a.vertices) == 4 and desk.model.scene.b == first.b
    desk.press("undo")
    assert desk.model.scene.a == first.a
    desk.press("draw polygon")
    desk.click((0.2, 0.2), (0.5, 0.25), (0.4, 0.5), (0.2, 0.2))  # the first corner again closes it
    assert len(desk.model.scene.a.vertices) == 3 and desk.model.scene.a != first.a


@WIDTHS
def test_a_refused_outline_stays_visible_with_the_reason_and_can_be_corrected(desk, width):
    first = desk.model.scene
    desk.press("draw polygon")
    desk.click((0.2, 0.2), (0.5, 0.5), (0.5, 0.2), (0.2, 0.5))
    desk.press("done")
    assert desk.model.scene.a == first.a
    assert "cross" in desk.page.locator(".sv-board > .sv-why").first.inner_text()
    assert desk.page.locator(".sv-drawing.sv-wrong path").count() == 1
    assert desk.page.locator(".sv-drawing circle").count() == 4
    desk.page.locator(".sv-plane").press("Backspace")
    desk.press("done")
    assert len(desk.model.scene.a.vertices) == 3 and desk.page.locator(".sv-drawing circle").count() == 0


@WIDTHS
def test_an_outline_that_crosses_after_a_key_stays_visible_with_the_reason(desk, width):
    handle = desk.page.locator('[data-handle="A-vertex-0"]')
    desk.page.locator('[data-handle="A-move"]').focus()
    desk.page.keyboard.press("PageDown")
    desk.press("draw polygon")
    desk.click((0.2, 0.2), (0.5, 0.2), (0.5, 0.5), (0.2, 0.5))
    desk.press("done")
    handle.focus()
    for _ in range(60):
        desk.page.keyboard.press("ArrowRight")
        settled(desk.page)
        if desk.page.locator(".sv-drawing.sv-wrong path").count():
            break
    assert desk.page.locator(".sv-drawing.sv-wrong circle").count() == 4
    assert "Not possible" in desk.page.locator(".sv-board > .sv-why").first.inner_text()
    desk.press("undo")
    assert desk.page.locator(".sv-drawing circle").count() == 0


@WIDTHS
def test_the_dragged_scene_can_be_copied_into_the_box(desk, width):
    desk.page.locator(".sv-paste > summary").click()
    desk.page.locator('[data-handle="B-move"]').focus()
    desk.page.keyboard.press("ArrowLeft")
    settled(desk.page)
    desk.press("take the shapes above")
    assert desk.model.scene.b.vertices[0][0] < 5 and "apart" in desk.text(".sv-verdict")
    desk.page.get_by_text("send it on").click()
    assert desk.page.get_by_role("button", name="copy minimal test").count() == 1


@WIDTHS
def test_a_circle_is_drawn_and_corners_are_added_and_removed(desk, width):
    desk.page.get_by_text("draw", exact=True).click()
    desk.page.get_by_label("which shape").select_option("b")
    desk.page.get_by_role("button", name="draw circle").click()
    desk.click((0.6, 0.3), (0.7, 0.3))
    assert isinstance(desk.model.scene.b, sv.Circle)
    count = len(desk.model.scene.a.vertices)
    desk.press("add corner")
    desk.click((0.15, 0.6))
    assert len(desk.model.scene.a.vertices) == count + 1
    desk.press("add corner")
    desk.press("remove corner")
    desk.click((0.15, 0.6))
    assert len(desk.model.scene.a.vertices) == count
    desk.click((0.15, 0.6))
    assert len(desk.model.scene.a.vertices) == count, "two corners are no polygon"
    assert "Not possible" in desk.page.locator(".sv-board > .sv-why").first.inner_text()


def test_everything_that_the_mouse_can_do_works_with_keys(browser):
    errors = []
    model = ExplorerModel(sv.scene("triangles"))
    with explored(browser, model, errors, viewport={"width": 1300, "height": 1000}) as page:
        page.locator("summary", has_text="draw").focus()
        page.keyboard.press("Enter")
        page.get_by_role("button", name="draw polygon").focus()
        page.keyboard.press("Enter")
        for moves in ("ArrowUp",) * 6, ("ArrowRight",) * 9, ("ArrowDown",) * 9:
            for key in moves:
                page.keyboard.press(key)
            page.keyboard.press("Enter")
        page.get_by_role("button", name="done").focus()
        page.keyboard.press("Enter")
        settled(page)
        assert len(model.scene.a.vertices) == 3 and model.scene.a != sv.scene("triangles").a
        page.locator("summary", has_text="draw").focus()
        page.keyboard.press("Enter")
        page.get_by_role("button", name="draw circle").focus()
        page.keyboard.press("Enter")
        page.keyboard.press("Enter")
        for _ in range(5):
            page.keyboard.press("ArrowRight")
        page.keyboard.press("Enter")
        settled(page)
        assert isinstance(model.scene.a, sv.Circle)
        page.locator("summary", has_text="draw").focus()
        page.keyboard.press("Enter")
        page.get_by_role("button", name="add corner").focus()
        page.keyboard.press("Enter")
        page.keyboard.press("Escape")
        assert page.locator(".sv-plane").is_hidden()
    assert errors == []


def test_the_paste_box_has_no_accessibility_fault(browser):
    source = axe()
    errors = []
    with explored(
        browser, ExplorerModel(sv.scene("triangles")), errors, viewport={"width": 1300, "height": 1000}
    ) as page:
        desk = Desk(page, None)
        desk.paste(BY_THREAD["libgdx/libgdx#1635"].text)
        desk.press("draw polygon")
        assert accessibility_faults(source, page) == []
    assert errors == []


@pytest.mark.parametrize("longest", [10, 1_000, 100_000])
def test_an_explorer_with_long_numbers_is_not_wider_than_its_window(browser, longest):
    a = sv.Polygon([(-0.6 * longest, 1), (longest, 3), (7, 0.45 * longest + 0.25)])
    b = sv.Polygon(
        [(-0.25 * longest, -0.25 * longest), (0.2 * longest + 0.5, -0.15 * longest), (longest, 0.4 * longest)]
    )
    errors = []
    with explored(
        browser, ExplorerModel(sv.Scene("own", a, b)), errors, viewport={"width": 1600, "height": 1000}
    ) as page:
        wider = []
        for width in range(320, 1600, 40):
            page.set_viewport_size({"width": width, "height": 1000})
            settled(page)
            if page.evaluate("document.documentElement.scrollWidth > innerWidth"):
                wider.append(width)
        assert wider == []
    assert errors == []
