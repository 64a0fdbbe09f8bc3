"""The site in a real browser, from a server of its own: drag without waiting for anything from elsewhere."""

import io
import re
import shutil
import threading
from contextlib import contextmanager
from functools import partial
from http.server import BaseHTTPRequestHandler, SimpleHTTPRequestHandler, ThreadingHTTPServer
from itertools import cycle
from xml.etree import ElementTree

import pytest
from browser import accessibility_faults, served, settled
from PIL import Image

import satviz as sv
from satviz.lessons.chapter_text import chapters
from satviz.pictures import DARK, LIGHT
from satviz.safe_write import write
from satviz.scenes.link import ViewOptions, fragment
from satviz.site import build, pages, runtime
from satviz.site.build import site
from satviz.site.check_page import CHECK_POLICY
from satviz.site.guides import guides
from satviz.site.hosting import NOT_FOUND

pytestmark = pytest.mark.slow

LIVE = 30_000  # milliseconds that Python may take to start here


@pytest.fixture(scope="module")
def url(built):
    with served(built) as found:
        yield found


def watched(context, at, errors):
    """Return a page that records each error, and each request to another address."""
    page = context.new_page()
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.on("console", lambda message: errors.append(message.text) if message.type == "error" else None)
    page.on(
        "request", lambda request: None if request.url.startswith((at, f"blob:{at}")) else errors.append(request.url)
    )
    return page


@pytest.fixture
def visit(browser, errors, url):
    """Open a page of the site; no error and no request to anywhere else."""
    contexts = []

    def opened(path, *, at=url, live=True, **more):
        context = browser.new_context(**{"viewport": {"width": 1280, "height": 800}, **more})
        contexts.append(context)
        page = watched(context, at, errors)
        page.goto(at + path)
        if live:
            page.evaluate("document.querySelector('.live').scrollIntoView()")  # a scene is opened when it is near
            page.locator(".live.ready").first.wait_for(timeout=LIVE)
            page.evaluate("scrollTo(0, 0)") if "#" not in path else None
            settled(page)
        return page

    yield opened
    for context in contexts:
        context.close()


def without_python(page):
    """Keep Python out of the pages to come; no service worker may answer for them."""
    page.context.route("**/worker.js*", lambda route: route.fulfill(body="", content_type="text/javascript"))


OPEN_ALL = "for (const rest of document.querySelectorAll('.rest')) rest.open = true"  # where no script does


def whole(page):
    """Open all folds of a chapter, and scroll to its players, which are made when they are near."""
    page.get_by_role("button", name="Show the whole chapter").click()
    for player in page.locator(".player:visible").all():
        player.evaluate("player => player.scrollIntoView()")
        player.locator(".still").wait_for(state="detached")
    page.evaluate("scrollTo(0, 0)")
    return page


def middle(page, part):
    box = page.locator(f'.live [data-id="{part}"]').first.bounding_box()
    return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2


def sentence_of(page):
    return page.locator(".live .sv-sentence").inner_text()


def wait_for_sentence(page, word):
    page.wait_for_function(f"() => document.querySelector('.live .sv-sentence').textContent.includes({word!r})")


def test_a_triangle_is_dragged_with_the_mouse(visit):
    page = visit("")
    assert sentence_of(page) == sv.scene("triangles").record().sentence
    (ax, ay), (bx, by) = middle(page, "A.outline"), middle(page, "B.outline")
    page.mouse.move(bx, by)
    page.mouse.down()
    for i in range(1, 21):
        page.mouse.move(bx + (ax - bx) * i / 20, by + (ay - by) * i / 20)
    page.mouse.up()
    wait_for_sentence(page, "overlap")
    assert page.locator(".live").get_by_text("overlapping").count()


def test_a_triangle_is_dragged_with_a_finger_on_a_phone(visit):
    page = visit("", viewport={"width": 390, "height": 844}, has_touch=True, is_mobile=True)
    (ax, ay), (bx, by) = middle(page, "A.outline"), middle(page, "B.outline")
    hand = page.context.new_cdp_session(page)

    def finger(kind, *spots):
        points = [{"x": x, "y": y} for x, y in spots]
        hand.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})

    finger("touchStart", (bx, by))
    for i in range(1, 11):
        finger("touchMove", (bx + (ax - bx) * i / 10, by + (ay - by) * i / 10))
    finger("touchEnd")
    wait_for_sentence(page, "overlap")


def test_a_triangle_is_moved_with_the_keyboard(visit):
    page = visit("")
    page.locator('[data-handle="B-move"]').focus()
    for _ in range(24):
        page.keyboard.press("ArrowLeft")
    wait_for_sentence(page, "overlap")


def test_no_page_is_wider_than_its_window_or_has_an_accessibility_fault(visit, url, built, axe_core):
    """Chapters are open, the front page moves; pages are dark on a telephone and light at a desk, in turn."""
    page = visit("", live=False, service_workers="block")
    without_python(page)  # on a busy machine Chromium itself crashes now and then where a page is left while it starts
    paths = sorted(str(path.relative_to(built)) for path in built.rglob("*.html"))
    paths.remove("reference/index.html")  # it leads to another page
    for path, desk in zip(["", *paths], cycle([False, True])):
        theme = "light" if desk else "dark"
        page.emulate_media(reduced_motion="reduce" if path else "no-preference", color_scheme=theme)
        page.set_viewport_size({"width": 390, "height": 844})
        page.goto(url + path)
        if page.locator(".waits").count():
            whole(page)
        for width in (390, 1280) if desk else (1280, 390):
            page.set_viewport_size({"width": width, "height": 844})
            settled(page)
            assert page.evaluate("document.documentElement.scrollWidth") <= width, path
        assert accessibility_faults(axe_core, page) == [], path


def test_a_site_works_where_a_browser_has_no_space_to_store_its_files(visit, url):
    page = visit("")
    page.evaluate("navigator.serviceWorker.ready.then((it) => it.active.state)")
    page.evaluate("caches.keys().then((names) => Promise.all(names.map((name) => caches.delete(name))))")
    page.context.new_cdp_session(page).send("Storage.overrideQuotaForOrigin", {"origin": url, "quotaSize": 1000})
    page.goto(url + "2-sat.html")
    assert page.evaluate("navigator.serviceWorker.controller !== null")
    page.locator(".live.ready").first.wait_for(timeout=LIVE)


LIGHT_NOW = "() => [...document.querySelectorAll('[data-theme]')].every((each) => each.dataset.theme === 'light')"
LIVE_PAGES = "", "2-sat.html", "6-where-it-fails.html", "scene.html#far-centers"
LIVE_PAGES += tuple(f"scene.html?{query}#aabb" for query in ("embed", "embed&play&show=table"))
LIVE_PAGES += ("scene.html?embed&challenge=touch&show=tools#aabb",)


@pytest.mark.parametrize("path", LIVE_PAGES)
def test_no_live_page_and_no_frame_has_an_accessibility_fault(visit, axe_core, path):
    """The pages are dark at a desk and light on a telephone."""
    page = visit(path, color_scheme="dark")
    if path[:1].isdigit():
        assert accessibility_faults(axe_core, page) == []
        whole(page)
    assert accessibility_faults(axe_core, page) == []
    page.emulate_media(color_scheme="light")
    page.set_viewport_size({"width": 390, "height": 844})
    page.wait_for_function(LIGHT_NOW)
    assert accessibility_faults(axe_core, page) == []


def test_python_starts_from_the_stored_memory(visit):
    assert visit("").locator(".live").get_attribute("data-from") == "memory"


@pytest.mark.parametrize("width", [390, 1280])
def test_the_live_scene_has_the_size_of_the_still_one(visit, width):
    """Then nothing jumps before the reader's eyes when Python is ready."""
    more = {"viewport": {"width": width, "height": 844}}
    still_page = visit("", live=False, java_script_enabled=False, **more)
    still = still_page.locator(".live .picture:visible").first.bounding_box()
    letters = still_page.locator(".live .picture:visible text").evaluate_all(
        "all => all.map(t => t.getBoundingClientRect().height)"
    )
    assert min(letters) > 12  # the height of letters of 10 px
    page = visit("", **more)
    live = page.locator(".live svg.sv-picture").first.bounding_box()
    assert [live[k] for k in ("x", "width", "height")] == pytest.approx(
        [still[k] for k in ("x", "width", "height")], abs=2
    )
    assert live["y"] == pytest.approx(still["y"], abs=40)  # words about the scene may stand above it
    for path in "scene.html", "scene.html#far-centers", "challenges.html":
        page = visit(path, live=False, **more)
        page.evaluate(
            "new PerformanceObserver(list => { window.shifts = (window.shifts ?? 0) + "
            "list.getEntries().reduce((all, entry) => all + entry.value, 0); })"
            ".observe({ type: 'layout-shift', buffered: true })"
        )
        if path.startswith("scene"):
            page.locator(".live.ready").wait_for(timeout=LIVE)
        page.wait_for_timeout(500)
        assert page.evaluate("window.shifts ?? 0") < (0.05 if path == "scene.html" else 0.01), path


def test_without_javascript_every_page_is_there(visit):
    page = visit("", live=False, java_script_enabled=False)
    assert page.locator(".live svg.picture").first.is_visible() and "gap of 1.213" in page.locator(".live").inner_text()
    page.goto(page.url + "2-sat.html")
    page.evaluate(OPEN_ALL)
    assert page.locator("svg.picture").count() > 8 and page.locator(".player .still svg").is_visible()
    page.get_by_text("step by step, in words").first.click()
    assert page.locator(".player li").count() > 15
    page.locator("summary", has_text="Solution").first.click()
    assert page.locator("details[open]:not(.rest) > pre.code").last.is_visible()


def test_without_javascript_the_explorer_says_so_and_where_the_pictures_are(visit, built):
    page = visit("scene.html", live=False, java_script_enabled=False)
    says = page.locator("main").inner_text()
    assert "This page needs JavaScript" in says and "The gallery has a still picture of every scene" in says
    assert "needs JavaScript" not in visit("scene.html", live=False).locator("main").inner_text()
    assert (built / "gallery.html").is_file()


def test_an_answer_is_opened_with_the_keyboard_and_without_javascript(visit):
    page = visit("1-aabb.html", live=False, java_script_enabled=False)
    assert page.locator("ul.choices:visible").count() == 1
    page.locator(".rest > summary").first.press("Enter")  # what comes after an answer waits in a fold of its own
    assert page.locator("ul.choices:visible").count() == 2
    page.evaluate(OPEN_ALL)
    answer = page.locator("details.later", has_text="Only one.")
    assert not page.get_by_text("Only one. The table").is_visible() and not answer.locator("pre.out").is_visible()
    assert "Only one." not in page.locator("article").aria_snapshot()  # nor is it read aloud
    summary = answer.locator("> summary")
    for key, open_ in ("Enter", True), ("Space", False), ("Enter", True):
        summary.press(key)
        assert page.get_by_text("Only one. The table").is_visible() == answer.locator("pre.out").is_visible() == open_


def test_a_widget_in_a_folded_answer_starts_when_the_answer_opens(visit):
    page = whole(visit("6-where-it-fails.html"))
    answer = page.locator("details.later", has=page.locator(".live"))
    assert not answer.locator(".live.ready").count()
    answer.locator("> summary").click()
    answer.locator(".live.ready").wait_for(timeout=LIVE)
    place = answer.locator(".live")
    settled(page)
    before = answer.locator(".open a").get_attribute("href")
    place.locator('[data-handle="B-move"]').press("ArrowRight")
    page.wait_for_function(
        "before => document.querySelector('.later .open a').getAttribute('href') !== before", arg=before
    )
    assert place.bounding_box()["width"] > 1000


@pytest.mark.parametrize("link", ["nosuch", "triangles&goal=nosense", "eyJzYXR2", "circles&free=x", "A" * 1_900_000])
def test_a_link_that_opens_nothing_says_why_and_offers_the_scenes(visit, link):
    page = visit(f"scene.html#{link}", live=False, viewport={"width": 390, "height": 844})
    page.get_by_text("This link cannot be opened").wait_for(timeout=LIVE)
    why, offer = page.locator(".status"), page.locator(".offer")
    for width in 390, 1280:
        page.set_viewport_size({"width": width, "height": 844})
        settled(page)
        assert len(why.inner_text()) < 240 and why.bounding_box()["y"] < 400
        assert not page.locator(".live .picture").first.is_visible()  # nothing that looks as if it could be dragged
        assert page.evaluate("document.documentElement.scrollWidth") <= width
    offer.get_by_role("link", name="Two circles").click()
    page.locator(".live.ready").wait_for(timeout=LIVE)
    assert not offer.is_visible() and why.inner_text() == "" and page.url.endswith("#circles")
    assert sentence_of(page) == sv.scene("circles").record().sentence


def test_a_failing_scenes_link_opens_it(visit):
    page = visit("scene.html#far-centers")
    assert "Claim: the centers are far apart" in page.locator(".sv-heading").inner_text()
    page.goto(page.url.replace("far-centers", "aabb-turned"))  # another link in the same page
    page.wait_for_function("() => document.querySelector('.sv-heading')?.textContent.includes('bounding boxes')")


def test_a_link_opens_the_same_state_and_the_address_follows_each_drag(visit):
    mine = sv.Scene("mine", sv.Polygon([(0, 0), (4, 0), (0, 4)]), sv.Circle((5, 5), 1))
    page = visit(f"scene.html#{fragment(mine, ViewOptions(free=40.0, mtv=True))}")
    assert "at 40 degrees" in sentence_of(page) and page.get_by_label("free axis").is_checked()
    assert page.get_by_label("way out").is_checked() and not page.get_by_role("checkbox", name="B − A").is_checked()
    page.locator('[data-handle="axis"]').focus()
    page.keyboard.press("[")
    wait_for_sentence(page, "at 45 degrees")
    page.wait_for_function("() => location.hash.includes('free=45')")
    page.reload()
    page.locator(".live.ready").wait_for(timeout=LIVE)
    assert "at 45 degrees" in sentence_of(page)


def test_a_link_to_a_step_opens_the_player(visit):
    page = visit("scene.html#triangles&step=14&predict=1")
    assert page.get_by_label("predict").is_checked() and page.locator(".sv-question").is_visible()
    page = visit("scene.html#triangles&step=14")
    assert page.locator(".sv-count").inner_text() == "15 / 16"


def test_the_link_that_is_copied_opens_the_same(visit):
    page = visit("scene.html#far-centers&view=truth")
    page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    page.locator(".sv-menu summary:has-text('save')").click()
    page.get_by_role("button", name="copy link").click()
    page.get_by_text("Copied.").wait_for()
    assert page.evaluate("navigator.clipboard.readText()") == page.url
    page = whole(visit("2-sat.html"))
    page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    player = page.locator(".player")
    player.locator(".sv-menu summary:has-text('save')").click()
    player.get_by_role("button", name="copy link").click()
    player.get_by_text("Copied.").wait_for()
    page.goto(page.evaluate("navigator.clipboard.readText()"))
    page.locator(".live.ready").wait_for(timeout=LIVE)
    assert page.get_by_label("predict").is_checked() and page.locator(".sv-count").inner_text().startswith("1")


def test_the_link_to_a_step_of_the_run_on_every_axis_opens_that_step(visit):
    page = visit("scene.html#triangles&step=2")
    page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    page.get_by_role("button", name="test the rest").click()
    page.get_by_role("slider", name="step").fill("30")
    before = sentence_of(page), page.locator(".sv-count").inner_text()
    page.locator(".sv-menu summary:has-text('save')").click()
    page.get_by_role("button", name="copy link").click()
    page.get_by_text("Copied.").wait_for()
    page = visit(page.evaluate("navigator.clipboard.readText()").rpartition("/")[2])
    assert (sentence_of(page), page.locator(".sv-count").inner_text()) == before
    assert page.get_by_role("button", name="test the rest").get_attribute("aria-pressed") == "true"


def test_the_scene_of_a_link_stays_if_the_first_drag_is_refused(visit):
    page = visit("scene.html#circles&free=40&mtv=1&difference=1")
    radius, center = (page.locator(f'[data-handle="B-{part}"]').bounding_box() for part in ("radius", "move"))
    page.mouse.move(radius["x"] + radius["width"] / 2, radius["y"] + radius["height"] / 2)
    page.mouse.down()
    page.mouse.move(center["x"] + center["width"] / 2, center["y"] + center["height"] / 2)  # in one go
    page.locator(".sv-why", has_text="Not possible").wait_for()
    page.mouse.up()
    assert page.locator(".sv-why").is_visible()  # the reason stays until the next change
    page.locator('[data-handle="B-move"]').press("ArrowLeft")
    page.locator(".sv-why").wait_for(state="hidden")
    for box in "free axis", "way out", "B − A":
        assert page.get_by_role("checkbox", name=box).is_checked(), box


def test_the_skip_link_does_not_open_a_scene(visit):
    page = visit("scene.html#circles")
    page.locator(".skip").focus()
    page.keyboard.press("Enter")
    page.wait_for_function("() => location.hash === '#main'")
    page.locator('[data-handle="B-move"]').press("ArrowLeft")
    wait_for_sentence(page, "1.700")
    assert page.locator(".status").inner_text() == ""
    page = visit("scene.html#main")
    assert sentence_of(page) == sv.scene("triangles").record().sentence


def test_a_drag_just_before_another_scene_is_opened_does_not_change_its_address(visit):
    page = visit("scene.html#circles")
    page.locator('[data-handle="B-move"]').press("ArrowLeft")
    wait_for_sentence(page, "1.700")  # the address follows a little later
    page.evaluate("() => { location.hash = 'far-centers'; }")
    page.locator(".sv-heading", has_text="centers").wait_for()
    page.wait_for_timeout(600)
    assert page.url.endswith("#far-centers")


def test_the_error_of_a_link_disappears_when_the_scene_changes(visit):
    page = visit("scene.html#circles")
    page.evaluate("() => { location.hash = 'no-such-scene'; }")
    page.get_by_text("This link cannot be opened").wait_for()
    assert page.locator(".offer").is_visible()
    page.locator('[data-handle="B-move"]').press("ArrowLeft")
    wait_for_sentence(page, "1.700")
    assert page.locator(".status").inner_text() == "" and not page.locator(".offer").is_visible()


@pytest.mark.parametrize("screen", [{}, {"viewport": {"width": 390, "height": 844}}], ids=["wide", "phone"])
def test_a_bad_link_in_a_running_page_is_reported_once_and_the_scenes_are_in_view(visit, screen):
    page = visit("scene.html#circles", **screen)
    offered = page.locator(".offer")
    told = """() => {
      const inside = ({ top, bottom }) => top > -1 && bottom <= innerHeight;
      const words = [...document.querySelectorAll('main *')].filter(e => e.checkVisibility()
        && [...e.childNodes].some(n => n.nodeType === 3 && n.data.includes('no scene is called')));
      const seen = [...words, document.querySelector('.offer a')].map(e => e.getBoundingClientRect());
      return words.length === 1 && seen.every(inside);
    }"""

    def refused():
        offered.wait_for()
        page.wait_for_function(told)
        settled(page)
        assert page.evaluate(told)

    page.evaluate("() => { location.hash = 'nosuch'; }")
    refused()
    offered.get_by_role("link", name="Two triangles").first.click()
    offered.wait_for(state="hidden")
    page.go_back()
    assert page.url.endswith("#nosuch")
    refused()


AFTER_EACH_PAINT = """() => {
  window.themes = new Set();
  const look = () => requestAnimationFrame(() => {
    const all = () => [...document.querySelectorAll("[data-theme]")];
    setTimeout(() => all().forEach((each) => window.themes.add(each.dataset.theme)));
    look();
  });
  addEventListener("DOMContentLoaded", look);
}"""


@pytest.mark.parametrize("path", ["scene.html#triangles", "scene.html#triangles&step=3", "2-sat.html"])
def test_no_scene_flashes_light_in_a_dark_page(visit, path):
    page = visit("challenges.html", live=False, color_scheme="dark")
    page.add_init_script(f"({AFTER_EACH_PAINT})()")
    page.goto(page.url.replace("challenges.html", path))
    page.locator(".live.ready").first.wait_for(timeout=LIVE)
    page.wait_for_timeout(700)
    assert page.evaluate("[...window.themes]") == ["dark"]


def test_opened_as_files_the_pages_are_whole_their_players_play_and_a_line_says_how_to_drag(visit, built):
    page = whole(visit("2-sat.html", at=f"{built.as_uri()}/", live=False))
    player = page.locator(".player")
    player.get_by_role("button", name="step forward").click()
    assert player.locator(".sv-count").inner_text().startswith("2")
    assert "python -m http.server" in page.locator(".status").first.inner_text()
    assert page.locator(".live .picture").first.is_visible()


@pytest.mark.parametrize("scripts", [True, False])
def test_a_printed_chapter_has_its_questions_without_the_answers(visit, scripts):
    """What is folded stays folded on paper, and with it what follows a question; what is open is printed."""
    page = visit("2-sat.html", live=False, java_script_enabled=scripts)
    page.emulate_media(media="print")
    folds = page.locator(":is(article, .rest) > details:not(.cell, .rest)")
    seen = "each => [...each.children].slice(1).some(it => it.checkVisibility({contentVisibilityAuto: true}))"
    assert page.locator(".choices:visible").count() == 1 and not page.locator(".cell").first.is_visible()
    page.evaluate(OPEN_ALL)
    page.wait_for_function("() => !document.querySelector('.rest:not([open])')")
    assert page.locator(".choices:visible").count() == 5
    assert folds.count() > 6 and not any(fold.evaluate(seen) for fold in folds.all())
    folds.first.evaluate("fold => { fold.open = true; }")
    assert folds.first.evaluate(seen)
    assert page.evaluate("[...document.querySelectorAll('pre')].every(pre => pre.scrollWidth <= pre.clientWidth + 1)")
    page.goto(page.url.replace("2-sat", "gallery"))
    assert page.locator("img").count() > 40 and not page.locator("img[loading]").count()


def test_no_page_of_a_handout_has_only_lines_to_write_on(browser):
    page = browser.new_page()
    page.set_content(sv.handout("1"))
    assert len(re.findall(rb"/Type /Page\b", page.pdf(prefer_css_page_size=True))) == 4
    page.close()


def test_a_question_is_answered_by_a_choice_and_the_page_says_whether_it_is_right(visit):
    page = whole(visit("2-sat.html", live=False))
    question = page.locator("ul.judges", has_text="v2v3")
    fold, said = question.locator("~ details.later").first, question.locator("+ .judged")
    assert fold.get_attribute("open") is None and said.inner_text() == ""
    question.get_by_role("button", name="v2v3").click()
    assert said.inner_text().startswith("Not right. This edge faces away from A.")
    assert fold.get_attribute("open") is None
    question.get_by_role("button", name="v1v3").press("Enter")
    assert said.inner_text() == "Right. It is the edge of B that faces A."
    assert fold.get_attribute("open") is not None and fold.locator("figure").is_visible()


PHONE = {"viewport": {"width": 390, "height": 844}, "is_mobile": True, "has_touch": True}
# what would give a chapter's question (counted from 0) away before it is asked
GIVES_AWAY = {
    ("2-sat.html", 0): r"normal of A's edge \w+\) leaves",  # said of the scene that the question is about
    ("3-circles.html", 2): "hardly ever wrong",
    ("7-speed-against-accuracy.html", 3): "corners are wrong",  # a heading
}


def one_spaced(texts):
    return {" ".join(line.split()) for text in texts for line in text.split("\n")}


def announced(page):
    """Return the lines of all names and texts that the browser gives to a screen reader."""
    nodes = page.context.new_cdp_session(page).send("Accessibility.getFullAXTree")["nodes"]
    return one_spaced(node.get("name", {}).get("value", "") for node in nodes if not node["ignored"])


# Chapters are read at a desk and on a telephone in turn, and only in a full run on both.
READ = [
    pytest.param(chapter, more, id=f"{chapter.path} {screen}", marks=[] if (i + k) % 2 == 0 else pytest.mark.full)
    for i, chapter in enumerate(chapters())
    for k, (screen, more) in enumerate({"desk": {}, "phone": PHONE}.items())
]


@pytest.mark.parametrize(("chapter", "more"), READ)
def test_nothing_gives_a_question_away_until_it_is_answered(visit, chapter, more):
    """No reader and no screen reader gets the answer, or anything that comes after it."""
    page = visit("gallery.html", live=False, service_workers="block", **more)
    without_python(page)
    page.goto(page.url.replace("gallery.html", chapter.path))
    asked = page.locator("ul.choices")
    unseen = "all => all.every((it) => !it.checkVisibility({ contentVisibilityAuto: true }))"
    for i in range(asked.count()):
        assert asked.nth(i).is_visible() and page.locator("ul.choices:visible").count() == i + 1
        waiting = page.locator("article > .later:not([open]) > :not(summary), .rest > :not(summary)")
        assert waiting.evaluate_all(unseen)
        lines, there = announced(page), page.locator("article > :is(:not(.rest, .later), .later[open])")
        given_away = lines & one_spaced(waiting.all_text_contents()) - one_spaced(there.all_text_contents())
        assert not {line for line in given_away if len(line) > 30}
        words = GIVES_AWAY.get((chapter.path, i))
        assert not words or not re.search(words, "\n".join([page.locator("article").inner_text(), *lines]))
        choose = asked.nth(i).locator("li[data-right] button")
        choose.tap() if more else choose.click()
        page.wait_for_function(
            "n => document.querySelectorAll('article > ul.choices').length === n", arg=min(i + 2, asked.count())
        )
    page.wait_for_function("() => !document.querySelector('.rest, .waits')")  # the last answer opens what follows it


def test_a_chapter_opens_where_its_reader_stopped(visit):
    page = visit("2-sat.html", live=False)
    page.locator("article > .later > summary").first.press("Enter")  # the answer alone, without a choice
    page.locator("h2", has_text="One axis, by hand").wait_for()
    page.reload()
    assert page.locator("ul.choices:visible").count() == 2 and page.locator(".waits").is_visible()
    whole(page)
    assert page.evaluate("document.activeElement.textContent") == "Projecting is a dot product"
    page.reload()
    assert page.locator("ul.choices:visible").count() == 5 and not page.locator(".waits").count()


def test_a_slider_shows_one_of_its_pictures(visit):
    page = whole(visit("5-doing-less.html", live=False))
    place = page.locator(".frames").first
    slider = place.get_by_role("slider")
    before = place.locator("figure:visible").inner_text()
    slider.press("ArrowRight")
    after = place.locator("figure:visible").inner_text()
    assert "comparisons so far" in after != before and slider.get_attribute("aria-valuetext") == after.strip()


def test_no_label_of_a_link_makes_the_page_wider(visit):
    long = sv.Scene("long", sv.Polygon([(0, 0), (4, 0), (0, 4)], ["x" * 3000, "y" * 200, "z"]), sv.Circle((5, 5), 1))
    for width in 390, 1280:
        for more in "", "&step=3":
            page = visit(f"scene.html#{fragment(long)}{more}", viewport={"width": width, "height": 800})
            assert page.evaluate("document.documentElement.scrollWidth") <= width, (width, more)


def saved(page, form, inside=".live"):
    """Return the file that the save menu saves."""
    page.locator(f"{inside} .sv-menu summary:has-text('save')").click()
    with page.expect_download() as found:
        page.locator(inside).get_by_role("button", name=f"save {form.upper()}").click()
    assert found.value.suggested_filename == f"satviz.{form}"
    return found.value.path().read_bytes()


@pytest.mark.parametrize("theme", [DARK, LIGHT], ids=["dark", "light"])
def test_the_picture_is_saved_as_it_is_shown(visit, theme):
    page = visit("scene.html#triangles", color_scheme=theme.name)
    page.locator('[data-handle="B-move"]').press("ArrowLeft")
    wait_for_sentence(page, "1.11")
    svg = saved(page, "svg").decode()
    root = ElementTree.fromstring(svg)
    line = page.locator(".live .sv-line").get_attribute("aria-label")
    assert root.find("{*}title").text == f"{sentence_of(page)} {line}" and "var(" not in svg and "style=" not in svg
    assert root.find("{*}rect").get("fill") == theme.paper
    blue = f"rgb({', '.join(str(c) for c in bytes.fromhex(theme.roles['A'][1:]))})"
    assert blue in {path.get("stroke") for path in root.findall(".//{*}path")}
    assert {text.get("font-family") for text in root.findall(".//{*}text")} == {
        page.locator(".live .sv-picture text").first.evaluate("text => getComputedStyle(text).fontFamily")
    }
    with Image.open(io.BytesIO(saved(page, "png"))) as drawn:
        size = [float(root.get(name)) for name in ("width", "height")]
        assert drawn.size == tuple(int(2 * side) for side in size)
        shown = {colour[:3] for _, colour in drawn.getcolors(1 << 20)}
        assert {
            tuple(bytes.fromhex(colour[1:])) for colour in (theme.paper, theme.roles["A"], theme.roles["B"])
        } <= shown


@pytest.mark.parametrize("screen", [{}, {"viewport": {"width": 390, "height": 844}}], ids=["wide", "phone"])
def test_what_is_shown_beside_the_picture_is_saved_with_it(visit, screen):
    page = visit("scene.html#triangles&free=40&difference=1", **screen)
    pictures = page.locator(".live svg.sv-picture:not(.sv-dial svg)")  # the dial is a control
    assert pictures.count() == 4 and all(each.is_visible() for each in pictures.all())
    root = ElementTree.fromstring(saved(page, "svg"))
    texts = "each => [...each.querySelectorAll('text')].map(text => text.textContent)"
    inner = root.findall("{*}svg")
    assert [["".join(text.itertext()) for text in svg.findall(".//{*}text")] for svg in inner] == [
        each.evaluate(texts) for each in pictures.all()
    ]
    boxes = [[float(svg.get(name)) for name in ("x", "y", "width", "height")] for svg in inner]
    width, height = (float(root.get(name)) for name in ("width", "height"))
    assert all(x >= 0 and x + wide <= width for x, _, wide, _ in boxes)
    assert all(y == sum(box[3] for box in boxes[:i]) for i, (_, y, *_) in enumerate(boxes))
    with Image.open(io.BytesIO(saved(page, "png"))) as drawn:
        assert drawn.size == (int(2 * width), int(2 * height))
        for _, y, _, high in boxes:  # something is drawn in each
            assert len(drawn.crop((0, int(2 * y), drawn.width, int(2 * (y + high)))).getcolors(1 << 20)) > 50


def test_the_page_offers_no_format_that_it_cannot_make(visit):
    page = whole(visit("2-sat.html"))
    for inside in ".live", ".player":
        menu = page.locator(f"{inside} .sv-menu:has-text('save')").first
        menu.wait_for()
        assert menu.locator("button").all_text_contents()[:2] == ["SVG", "PNG"] and "GIF" not in menu.inner_text()
    assert saved(page, "png", ".player").startswith(b"\x89PNG")


def test_a_link_of_a_stranger_runs_nothing_and_says_why(visit):
    page = visit("scene.html#<img src=x onerror=alert(1)>&free=1", live=False)
    page.get_by_text("This link cannot be opened").wait_for(timeout=LIVE)
    assert page.locator(".offer").is_visible() and not page.locator("main img").count()


def test_the_player_and_the_explorer_of_a_chapter_work(visit):
    page = whole(visit("2-sat.html"))
    player = page.locator(".player")
    player.get_by_role("button", name="last step").click()
    assert player.locator(".sv-question").is_visible()  # this one asks before it shows
    page.locator(".live").last.scroll_into_view_if_needed()
    page.locator(".live").last.locator('[data-handle="B-move"]').focus()
    before = page.locator(".open a").last.get_attribute("href")
    page.keyboard.press("ArrowLeft")
    page.wait_for_function(
        "before => [...document.querySelectorAll('.open a')].at(-1).getAttribute('href') !== before", arg=before
    )


@pytest.mark.parametrize("harm", ["gone", "not gzip", "of another build", "unknown to Pyodide"])
def test_python_starts_without_its_memory_snapshot_if_that_does_not_load(built, visit, tmp_path, harm, errors):
    folder = tmp_path / "site"
    shutil.copytree(built, folder)
    memory = folder / "python" / "memory.bin"
    if harm == "gone":
        memory.unlink()
    elif harm == "not gzip":
        memory.write_bytes(b"nothing that unpacks" * 1000)
    elif harm == "unknown to Pyodide":  # the option is private: another Pyodide may not know it any more
        worker = folder / "python" / "worker.js"
        assert "_loadSnapshot" in worker.read_text()
        worker.write_text(worker.read_text().replace("_loadSnapshot", "_noSuchOption"))
    else:
        memory.write_bytes((folder / "python" / "library.bin").read_bytes())
    with served(folder) as at:
        page = visit("", at=at, live=False)
        page.locator(".live.ready").wait_for(timeout=2 * LIVE)
        assert page.locator(".live").get_attribute("data-from") == "nothing"
        page.locator('[data-handle="B-move"]').focus()
        for _ in range(24):
            page.keyboard.press("ArrowLeft")
        wait_for_sentence(page, "overlap")
        page.context.close()
    if harm == "unknown to Pyodide":  # Python itself says why its first start failed
        assert errors[0].startswith("Fatal Python error")
        errors.clear()


@pytest.fixture
def slim(monkeypatch):
    """Let a site that is built now have no chapters, no reference and no previews, which take long to make."""
    monkeypatch.setattr(build, "chapters", list)
    monkeypatch.setattr(build.hosting, "social_pictures", lambda chapters: ())
    monkeypatch.setattr(build, "reference", lambda in_site: ())


def test_where_pyodide_keeps_no_memory_a_site_is_built_and_all_of_it_works(slim, visit, tmp_path, monkeypatch):
    """The function that stores the memory is private, and may be gone in another Pyodide."""
    core = runtime._core_from_npm()
    script = core["pyodide.asm.mjs"]
    assert b"makeMemorySnapshot" in script
    renamed = core | {"pyodide.asm.mjs": script.replace(b"makeMemorySnapshot", b"somethingElse")}
    monkeypatch.setattr(runtime, "_core_from_npm", lambda: renamed)
    found, lacks = site()
    assert len(lacks) == 1 and "pages start slower" in lacks[0] and "makeMemorySnapshot" in lacks[0]
    for path, data in found:
        write(tmp_path / path, data)
    assert not (tmp_path / "python" / "memory.bin").exists()
    with served(tmp_path) as at:
        page = visit("scene.html#far-centers&view=truth", at=at, live=False)
        page.locator(".live.ready").wait_for(timeout=2 * LIVE)
        assert page.locator(".live").get_attribute("data-from") == "nothing"
        page.locator('[data-handle="B-move"]').press("ArrowRight")
        page.wait_for_function("() => location.hash.length > 40")
        page.context.close()
        page = visit("yours.html", at=at, live=False)
        page.wait_for_function("() => !document.querySelector('.run').disabled", timeout=2 * LIVE)
        assert run_code(page, "python").startswith("Wrong. Your function says hit. The right answer: apart.")
        page.context.close()
        page = visit("scene.html?embed&predict#triangles", at=at, live=False)
        page.locator(".live.ready").wait_for(timeout=2 * LIVE)
        assert page.locator(".sv-count").inner_text() == "1"
        page.context.close()


def test_a_site_without_python_says_so_and_has_its_pictures(slim, visit, tmp_path):
    for path, data in site(live=False)[0]:
        write(tmp_path / path, data)
    with served(tmp_path) as at:
        page = visit("", at=at, live=False)
        page.get_by_text("no Python in it").wait_for()
        assert page.locator(".live .picture").first.is_visible()
        page.context.close()


# The addresses of what the service worker keeps, once it keeps all that the page and its worker have read: the worker's
# files are read by name here, since a page does not see what its worker reads.
KEPT = """async () => {
  const read = performance.getEntriesByType("resource").map(({ name }) => name);
  const found = (await (await caches.open((await caches.keys())[0])).keys()).map(({ url }) => url);
  const memory = ["about.json", "pyodide.asm.js", "wasm.bin", "memory.bin"];
  const keeps = (name) => found.some((url) => url.includes(name));
  return read.every((url) => url.startsWith("blob:") || keeps(url)) && memory.every(keeps) && found;
}"""


def kept(page):
    return page.wait_for_function(KEPT).json_value()


def test_a_page_read_once_opens_without_a_server(built, visit):
    with served(built) as at:
        page = visit("", at=at)
        page.evaluate("navigator.serviceWorker.ready")
        page.reload()
        page.locator(".live.ready").wait_for(timeout=LIVE)
        assert kept(page)
    page.reload()
    page.locator(".live.ready").wait_for(timeout=LIVE)


def left_until_met(page):
    """Press the arrow key, each time with its answer, until the challenge is met."""
    for _ in range(60):
        before = sentence_of(page)
        page.keyboard.press("ArrowLeft")
        page.wait_for_function(
            "before => document.querySelector('.live .sv-sentence').textContent !== before", arg=before
        )
        if "met" in page.locator(".sv-goal").get_attribute("class"):
            return
    pytest.fail("the challenge is not met")


def test_a_challenge_is_solved_by_dragging_and_evaluated_by_the_engine(visit):
    page = visit("scene.html#aabb&goal=touch")
    goal = page.locator(".sv-goal")
    assert "They are apart." in goal.inner_text()
    page.locator('[data-handle="B-move"]').focus()
    left_until_met(page)
    assert "They touch, exactly." in goal.inner_text()
    page.wait_for_function("() => location.hash.endsWith('&goal=touch')")
    page.goto(page.url.partition("#")[0] + "#far-centers")
    page.locator(".sv-heading").wait_for()
    assert not goal.is_visible()


def test_a_challenge_is_chosen_undone_and_kept_in_the_address(visit):
    page = visit("scene.html#triangles")
    goal, choice = page.locator(".sv-goal"), page.get_by_label("challenges")
    assert choice.locator("option", has_text="break").is_disabled() and not goal.is_visible()
    choice.select_option("touch")
    goal.get_by_text("Make the shapes touch").wait_for()
    page.get_by_label("presets").select_option("far-centers")
    goal.wait_for(state="hidden")
    choice.select_option("break")
    goal.get_by_text("happens to be right").wait_for()
    page.wait_for_function("() => location.hash.endsWith('goal=break')")
    for _ in range(2):
        page.get_by_role("button", name="undo").click()
    goal.get_by_text("Make the shapes touch").wait_for()
    choice.select_option("")
    goal.wait_for(state="hidden")


# -- in a folder of any server


def test_the_site_works_in_a_subfolder_of_a_server_as_at_its_root(built, visit, tmp_path):
    """The site needs no setting and no header of its own: those of Python's server are enough."""
    (tmp_path / "courses").mkdir()
    (tmp_path / "courses" / "sat").symlink_to(built)
    handler = partial(SimpleHTTPRequestHandler, directory=str(tmp_path))
    with ThreadingHTTPServer(("127.0.0.1", 0), handler) as serving:
        thread = threading.Thread(target=serving.serve_forever, daemon=True)
        thread.start()
        at = f"http://127.0.0.1:{serving.server_address[1]}/courses/sat/"
        for path in "", "2-sat.html", "scene.html?embed#circles":
            page = visit(path, at=at)  # and no request leaves the folder
            page.locator('.live.ready [data-handle="B-move"]').first.press("ArrowLeft")
            page.wait_for_function("() => document.querySelector('.live.ready .sv-sentence').textContent.length > 10")
            page.context.close()
        serving.shutdown()
        thread.join()


def test_at_any_depth_a_page_asks_for_the_service_worker_of_its_site(browser, built, tmp_path):
    """This holds also for the page of a missing address, which is shown in a folder that does not exist."""
    (tmp_path / "courses").mkdir()
    (tmp_path / "courses" / "sat").symlink_to(built)
    with served(tmp_path) as at:
        frame = pages.SiteInfo(chapters(), guides(), "1", True, False, f"{at}courses/sat/")
        (tmp_path / NOT_FOUND).write_bytes(pages.not_found_page(frame))
        for path in "nothing/at/all.html", "2-sat.html":
            context, asked = browser.new_context(), []
            page = context.new_page()
            context.on("request", lambda request, asked=asked: asked.append(request.url))
            page.goto(f"{at}courses/sat/{path}")
            scope = page.evaluate("navigator.serviceWorker.ready.then(it => [it.scope, it.active.scriptURL])")
            assert scope == [f"{at}courses/sat/", f"{at}courses/sat/sw.js"]
            assert [url for url in asked if url.endswith("/sw.js")] in ([], [f"{at}courses/sat/sw.js"])
            assert page.locator("nav a").first.evaluate("a => a.href") == f"{at}courses/sat/index.html"
            context.close()


# -- a scene in a frame of another page


@pytest.fixture
def framed(browser, errors, url):
    """Open a page of somebody else with a frame; return the page and its frame."""
    contexts = []

    def opened(what, *, more=(), before="", scripts=True, **options):
        context = browser.new_context(**{"viewport": {"width": 1000, "height": 900}, **dict(more)})
        contexts.append(context)
        page = context.new_page()
        page.on("console", lambda message: errors.append(message.text) if message.type == "error" else None)
        html = sv.embed(what, site=url, **options)
        page.set_content(f"<!doctype html><body>{before}{html if scripts else html.partition('<script>')[0]}")
        frame = page.frame_locator("iframe")
        frame.locator(".live.ready").wait_for(timeout=LIVE)
        return page, frame

    yield opened
    for context in contexts:
        context.close()


@pytest.mark.parametrize("options", [{}, {"play": True}, {"show": ["tools", "table"]}], ids=["drag", "play", "tools"])
def test_a_frame_is_as_high_as_its_content(framed, options):
    page, frame = framed("triangles", more={"viewport": {"width": 320, "height": 900}}, **options)
    fits = "document.documentElement.scrollHeight === innerHeight && document.body.offsetHeight > innerHeight - 2"
    cut = """() => [...document.querySelectorAll('button, select, summary, .sv-tool')].filter(e => e.checkVisibility()
      && (e.getBoundingClientRect().right > innerWidth || e.scrollWidth > e.clientWidth)).map(e => e.textContent)"""
    letters = "[...document.querySelectorAll('svg.sv-picture text')].filter(t => t.checkVisibility())"
    readable = f"{letters}.every(t => t.getBoundingClientRect().height >= 12)"  # the height of letters of 10 px
    for width in 200, 320, 390, 1000:
        page.set_viewport_size({"width": width, "height": 900})
        page.frames[1].wait_for_function(f"() => innerWidth > {width} - 100 && {fits}")
        # Python draws the picture for this width; in the narrowest frame it becomes smaller
        page.frames[1].wait_for_function(f"() => ({width} === 200 || {readable}) && {fits}")
        assert page.frames[1].evaluate("document.documentElement.scrollWidth <= innerWidth")
        assert page.frames[1].evaluate(cut) == []
        if width == 200:
            assert page.frames[1].evaluate(
                "[...document.querySelectorAll('.sv-board')].every(e => e.scrollWidth <= e.clientWidth)"
            )
            says = page.frames[1].evaluate("getComputedStyle(document.querySelector('main'), '::after').content")
            assert "needs 350 px" in says
    assert not frame.locator(".sv-text").is_visible()  # the box to paste into is there, but closed
    for hidden in "header", "footer", "h1", ".lead":
        assert not frame.locator(hidden).is_visible(), hidden
    assert frame.locator(".sv-fold").is_visible() == ("table" in options.get("show", ()))
    assert frame.get_by_role("button", name="undo").is_visible() == ("tools" in options.get("show", ()))


def test_a_frame_that_stays_low_shows_a_smaller_picture(framed):
    page, frame = framed("triangles", scripts=False)
    high = frame.locator(".sv-board").bounding_box()["height"]
    page.evaluate("document.querySelector('iframe').height = 680")
    page.frames[1].wait_for_function(f"() => document.querySelector('.sv-board').clientHeight < {high} - 20")
    page.frames[1].wait_for_function("() => document.documentElement.scrollHeight <= innerHeight")


@pytest.mark.parametrize("theme", ["light", "dark"])
def test_an_embedded_frame_has_the_chosen_theme_from_the_first_paint_on(framed, theme):
    other = {"light": "dark", "dark": "light"}[theme]
    page, frame = framed("circle-polygon", theme=theme, more={"color_scheme": other})
    paper = {"light": LIGHT, "dark": DARK}[theme].paper
    colour = f"rgb({', '.join(str(c) for c in bytes.fromhex(paper[1:]))})"
    for each in "body", ".live .satviz":
        colour_of = f"getComputedStyle(document.querySelector('{each}')).backgroundColor"
        page.frames[1].wait_for_function(f"() => {colour_of} === '{colour}'")  # a widget's follows when it is placed
    assert frame.locator("body > script:first-child").get_attribute("src").startswith("embed.js?")


def test_a_frame_of_some_steps_plays_these_alone(framed):
    _, frame = framed("triangles", steps=(3, 8))
    count = frame.locator(".sv-count")
    assert count.inner_text() == "4 / 16"
    for name, number in (("last step", 9), ("step forward", 9), ("first step", 4), ("step back", 4)):
        frame.get_by_role("button", name=name).click()
        assert count.inner_text() == f"{number} / 16", name
    assert not frame.get_by_role("button", name="test the rest").is_visible()


def test_a_frame_can_have_predict_or_a_challenge(framed):
    _, frame = framed("triangles", predict=True)
    frame.get_by_role("button", name="last step").click()
    assert frame.locator(".sv-question").is_visible()
    _, frame = framed("aabb", challenge="")
    assert "Make the shapes touch" in frame.locator(".sv-goal").inner_text()
    link = frame.locator(".open a")
    assert link.get_attribute("target") == "_blank" and link.get_attribute("href").endswith("#aabb&goal=touch")


def test_without_scripts_a_frame_is_its_picture_and_its_sentence(browser, url):
    context = browser.new_context(java_script_enabled=False)
    page = context.new_page()
    page.set_content(sv.embed("triangles", site=url))
    assert not page.locator("iframe").is_visible()
    assert (
        page.locator("img").evaluate("i => i.checkVisibility()") and page.locator("img").bounding_box()["height"] > 200
    )
    assert page.locator("p").bounding_box()["height"] > 10
    assert page.locator("p").text_content() == sv.scene("triangles").record().sentence
    context.close()


def test_the_file_of_a_frame_is_cached_once_and_opens_without_a_server(built, visit):
    with served(built) as at:
        page = visit("scene.html?embed#triangles", at=at)
        page.evaluate("navigator.serviceWorker.ready")
        page.reload()
        page.locator(".live.ready").wait_for(timeout=LIVE)
        keys = kept(page)
        assert f"{at}scene.html" in keys and not [key for key in keys if "embed&" in key or "?embed" in key]
    page.goto(f"{at}scene.html?embed&play#circles")
    page.locator(".live.ready").wait_for(timeout=LIVE)
    assert page.locator(".sv-count").is_visible()


def test_a_built_in_scene_has_its_own_picture_until_python_has_come(visit):
    page = visit("scene.html#circles", live=False, service_workers="block")
    page.context.route("**/worker.js*", lambda route: route.fulfill(body="", content_type="text/javascript"))
    page.reload()
    assert page.locator(".live .still img").get_attribute("src") == "pictures/circles.svg"


def test_a_page_without_python_shows_no_picture_of_another_scene_than_its_link_names(visit):
    """The scene of the page itself is no answer to a link to shapes of one's own."""
    page = visit("scene.html", live=False, service_workers="block")

    def without_python(route):
        html = re.sub(r' data-python="[^"]*"', "", route.fetch().text())
        route.fulfill(body=html, content_type="text/html")

    page.context.route("**/scene.html*", without_python)
    own = sv.link(sv.Scene("coins", sv.Circle((0, 0), 1), sv.Circle((1.5, 0), 1))).partition("#")[2]
    page.evaluate("hash => { location.hash = hash; }", own)
    page.reload()
    assert page.locator(".live .still .picture").count() == 0
    assert "cannot show the scene of this link" in page.locator("main").inner_text()
    page.evaluate("location.hash = 'circles'")
    page.locator('.live .still img[src="pictures/circles.svg"]').wait_for()
    assert "so the picture stays still" in page.locator("main").inner_text()


def test_solved_challenges_are_stored_in_this_browser_until_they_are_deleted(visit):
    page = visit("challenges.html", live=False)
    progress, forget = page.locator(".progress"), page.get_by_role("button", name="Forget")
    assert "None of" in progress.inner_text() and not forget.is_visible()
    page.locator("li[data-challenge='touch:aabb'] a").click()
    page.locator(".live.ready").wait_for(timeout=LIVE)
    page.locator('[data-handle="B-move"]').focus()
    left_until_met(page)
    page.goto(page.url.partition("scene.html")[0] + "challenges.html")
    item = page.locator("li[data-challenge='touch:aabb']")
    assert "solved" in item.get_attribute("class") and item.inner_text().endswith("solved")
    assert "You have solved 1 of" in progress.inner_text()
    go_on = page.get_by_role("link", name="Go on with the next challenge")
    assert go_on.evaluate("a => a.href") == page.locator(".tiles li:not(.solved) a").first.evaluate("a => a.href")
    forget.click()
    assert page.get_by_role("link", name="Begin with the first challenge").is_visible()
    assert "None of" in progress.inner_text() and page.evaluate("localStorage.length") == 0


def test_the_front_page_shows_the_idea_once_and_then_asks_to_drag(visit):
    page = visit("", live=False)
    page.clock.install()
    page.reload()
    now, turning = page.locator(".told .now"), page.locator(".turning")
    page.clock.run_for(500)
    assert "shadows overlap" in now.inner_text() and turning.locator('[data-id="overlap"]').count()
    page.clock.run_for(5000)
    assert now.inner_text().startswith("If the line turns")
    page.clock.run_for(5000)
    assert "there is a gap" in now.inner_text() and turning.locator('[data-id="gap"]').count()
    page.clock.run_for(3000)
    assert not turning.count() and not now.count() and page.locator(".live").is_visible()
    page.get_by_role("button", name="Show it again").click()
    page.clock.run_for(500)
    assert turning.count() and now.count()
    page.get_by_role("button", name="Stop").click()
    assert not turning.count() and not now.count()


def test_nothing_moves_by_itself_where_a_reader_wants_less_motion(visit):
    page = visit("", live=False, reduced_motion="reduce")
    assert not page.locator(".turning, .again").count() and page.locator(".told li").count() == 3


def test_a_key_on_a_handle_ends_the_first_minute_and_moves_the_shape(visit):
    page = visit("")
    page.get_by_role("button", name="Show it again").or_(page.get_by_role("button", name="Stop")).wait_for()
    if not page.locator(".turning").count():
        page.get_by_role("button", name="Show it again").click()
    page.locator('[data-handle="B-move"]').focus()
    page.locator(".turning").wait_for(state="detached")
    page.keyboard.press("ArrowLeft")
    wait_for_sentence(page, "1.")


# -- the page "Is yours right?"


def run_code(page, language=None, code=None):
    """Run the code in the editor, and return the page's report."""
    if language:
        page.locator(f'[value="{language}"]').check()
    if code is not None:
        page.get_by_role("textbox", name="Your function").fill(code)
    page.locator(".run").click()
    page.wait_for_function(
        "() => document.querySelector('.run').textContent === 'Run'", timeout=2 * LIVE
    )  # Python starts anew for the code
    return page.locator(".check-status").inner_text()


@pytest.fixture(scope="module")
def one_check_page(browser, url):
    """Yield the page, opened once since Python takes long to start, and the list of its errors."""
    errors = []
    context = browser.new_context(viewport={"width": 1280, "height": 800})
    yield watched(context, url, errors), errors
    context.close()


@pytest.fixture
def check_page(one_check_page, url):
    """Yield the page in Python without stored code; an earlier test may have left code and an answer there."""
    page, errors = one_check_page
    if page.url != f"{url}yours.html":
        page.goto(f"{url}yours.html")
    page.wait_for_function("() => !document.querySelector('.run').disabled", timeout=LIVE)
    page.locator('[value="python"]').check()
    page.get_by_label("Program").select_option("your own")
    page.locator(".forget").click()
    yield page
    assert not errors, errors


@pytest.mark.parametrize("language", ["python", "javascript"])
def test_a_wrong_function_is_caught_and_called_again_while_its_counterexample_is_dragged(check_page, language):
    said = run_code(check_page, language)
    assert said.startswith("Wrong. Your function says hit. The right answer: apart. It behaves like aabb-not-upright")
    assert "It behaves like aabb-not-upright" in check_page.locator(".report").inner_text()
    check_page.locator(".yours.wrong").wait_for()
    check_page.locator('[data-handle="B-move"]').focus()
    for _ in range(20):
        check_page.keyboard.press("ArrowRight")
    check_page.locator(".yours.right").wait_for()
    assert check_page.locator(".yours").inner_text() == "✓ Your function says: hit. The right answer: overlapping."


@pytest.mark.parametrize(
    ("language", "code"),
    [("python", "def collide(a, b):\n    while True: pass\n"), ("javascript", "function collide(a, b) { for (;;); }")],
)
def test_an_endless_loop_is_stopped_and_the_explorer_stays(check_page, language, code):
    assert run_code(check_page, language, code) == "Your function gives no answer within 2 s: an endless loop?"
    assert run_code(check_page, language, code.replace("while True: pass", "return 1").replace("for (;;);", "return 1"))


def test_code_is_kept_in_this_browser_until_it_is_deleted_and_no_link_has_it(check_page):
    check_page.get_by_role("textbox", name="Your function").fill("# mine")
    check_page.reload()
    check_page.wait_for_function("() => !document.querySelector('.run').disabled", timeout=LIVE)
    assert (
        check_page.get_by_role("textbox", name="Your function").input_value() == "# mine" and "#" not in check_page.url
    )
    check_page.locator(".forget").click()
    assert check_page.get_by_role("textbox", name="Your function").input_value().startswith("def collide")
    assert check_page.evaluate("() => localStorage.length") == 0


HOSTILE = {  # in JavaScript, and in Python by its module js
    "fetch('{}')": "js.fetch('{}')",
    "new WebSocket('{}')": "js.WebSocket.new('{}')",
    "import('{}').then(() => 1)": None,
    "importScripts('{}')": "js.importScripts('{}')",
    "navigator.sendBeacon('{}')": "js.navigator.sendBeacon('{}')",
    "new EventSource('{}')": "js.EventSource.new('{}')",
    "new FontFace('x', 'url({})').load()": "js.FontFace.new('x', 'url({})').load()",
    "new Worker('data:text/javascript,1')": "js.Worker.new('data:text/javascript,1')",
    "caches.open('x')": "js.caches.open('x')",
    "indexedDB.open('x')": "js.indexedDB.open('x')",
    "webkitRequestFileSystemSync(0, 9)": "js.webkitRequestFileSystemSync(0, 9)",
    "localStorage.length": "js.localStorage.length",
    "document.title": "js.document.title",
    "parent.document": "js.parent.document",
    "postMessage('x')": "js.postMessage('x')",
    "close()": "js.close()",
    "Function('return 1')()": "js.eval('1')",
}
IN_JAVASCRIPT = """function collide(a, b) {
  const reached = [];
  for (const [name, f] of [%s]) try { f(); reached.push(name); } catch {}
  throw new Error("reached " + reached);
}"""
IN_PYTHON = """import js
def collide(a, b):
    reached = []
    for name, f in [%s]:
        try:
            f()
            reached.append(name)
        except BaseException: pass
    raise ValueError(f"reached {reached}")
"""


@contextmanager
def served_without_headers(folder):
    """Serve the site without a security policy in the headers, so that only the page's own meta tag counts."""
    plain = partial(Plain, directory=str(folder))
    with ThreadingHTTPServer(("127.0.0.1", 0), plain) as serving:
        threading.Thread(target=serving.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{serving.server_address[1]}/"
        serving.shutdown()


class Plain(SimpleHTTPRequestHandler):
    def log_message(self, *args):
        pass


@pytest.mark.parametrize("by", [served, served_without_headers], ids=["policy as header", "as meta tag alone"])
@pytest.mark.parametrize("language", ["python", "javascript"])
def test_a_hostile_function_reaches_neither_the_page_nor_another_server(browser, built, language, by):
    with served_spy() as (address, asked), by(built) as at:
        context = browser.new_context()
        page = context.new_page()
        got = page.goto(at + "yours.html")
        assert ("content-security-policy" in got.headers) is (by is served)
        page.wait_for_function("() => !document.querySelector('.run').disabled", timeout=LIVE)
        if language == "javascript":
            tries = [each.format(address) for each in HOSTILE]
            code = IN_JAVASCRIPT % ", ".join(f'["{t.split("(")[0]}", () => {t}]' for t in tries)
        else:
            tries = [each.format(address) for each in HOSTILE.values() if each]
            code = IN_PYTHON % ", ".join(f'("{t.split("(")[0]}", lambda: {t})' for t in tries)
        run_code(page, language, code)
        report = page.locator(".report").inner_text()
        reached = report.partition("reached ")[2].splitlines()[0]
        page.wait_for_timeout(300)
        assert "raises" in report and not asked, (report, asked)
        # a module that is asked for from elsewhere is refused later, by the policy
        assert set(re.findall(r"[a-zA-Z]{4,}", reached)) <= {"import"}, reached
        context.close()


@contextmanager
def served_spy():
    """Yield a server of another origin that records its requests and answers all."""
    asked = []

    class Spy(BaseHTTPRequestHandler):
        def do_GET(self):
            asked.append(self.path)
            self.send_response(200)
            self.send_header("Access-Control-Allow-Origin", "*")
            self.send_header("Content-Type", "text/javascript")
            self.end_headers()

        do_POST = do_GET

        def log_message(self, *args):
            pass

    with ThreadingHTTPServer(("127.0.0.1", 0), Spy) as spy:
        threading.Thread(target=spy.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{spy.server_address[1]}/x.js", asked
        spy.shutdown()


def test_the_security_policy_stands_before_any_script_and_equals_that_of_the_server(browser, built):
    """A meta tag holds for what comes after it."""
    text = (built / "yours.html").read_text(encoding="utf-8")
    tags = re.findall(r'<meta http-equiv="Content-Security-Policy" content="([^"]+)">', text)
    assert tags == [CHECK_POLICY] and text.index(tags[0]) < text.index("<script") < text.index("<body")
    context = browser.new_context()
    page = context.new_page()
    with served_without_headers(built) as at:
        page.goto(at + "yours.html")
        refused = page.evaluate(
            """() => new Promise((resolve) => {
              document.addEventListener("securitypolicyviolation", (event) => resolve(event.effectiveDirective));
              const script = document.createElement("script");
              script.textContent = "document.title = 'reached'";
              document.head.append(script);
            })"""
        )
        assert refused.startswith("script-src") and page.title() != "reached"
    context.close()


WIDE, PHONE = {}, {"viewport": {"width": 390, "height": 844}, "has_touch": True, "is_mobile": True}


@pytest.mark.parametrize(("screen", "by"), [(WIDE, "mouse"), (WIDE, "keyboard"), (PHONE, "touch"), (PHONE, "keyboard")])
def test_code_is_written_and_run_with_mouse_touch_and_keyboard(visit, screen, by):
    """The keyboard indents by itself; nothing is wider than the screen; the counterexample answers to each pose."""
    page = visit("yours.html", live=False, **screen)
    page.wait_for_function("() => !document.querySelector('.run').disabled", timeout=LIVE)
    editor, run = page.locator("textarea"), page.locator(".run")
    if by == "keyboard":
        editor.focus()
        page.keyboard.press("Control+a")
        page.keyboard.type("def collide(a, b):\nreturn max(p[0] for p in a) >= min(p[0] for p in b)")
        assert editor.input_value() == "def collide(a, b):\n    return max(p[0] for p in a) >= min(p[0] for p in b)"
        page.keyboard.press("Control+Enter")
    else:
        editor.fill("def collide(a, b):\n    return max(p[0] for p in a) >= min(p[0] for p in b)")
        (run.tap if by == "touch" else run.click)()
    page.locator(".yours.wrong").wait_for(timeout=LIVE)
    assert page.evaluate("document.documentElement.scrollWidth") <= page.viewport_size["width"]
    moved, sentence = page.locator('.found [data-handle="B-move"]'), page.locator(".found .sv-sentence").inner_text()
    moved.scroll_into_view_if_needed()
    if by == "keyboard":
        moved.focus()
        for _ in range(40):
            page.keyboard.press("Shift+ArrowRight")
            page.keyboard.press("Shift+ArrowUp")
    else:
        box = moved.bounding_box()
        x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
        drag(page, by, (x, y), (x - 60, y - 60))
    page.wait_for_function("was => document.querySelector('.found .sv-sentence').innerText !== was", arg=sentence)
    page.wait_for_function(
        "() => /^[✓✗] Your function says: (no )?hit/.test(document.querySelector('.yours').textContent)"
    )


@pytest.mark.parametrize(
    "screen", [WIDE, PHONE, {"viewport": {"width": 900, "height": 700}}], ids=["wide", "phone", "tablet"]
)
def test_the_result_is_visible_after_run_without_scrolling(visit, screen):
    """On a wide screen it stands beside the editor, which stays in sight; else the page scrolls to it."""
    page = visit("yours.html", live=False, **screen)
    page.wait_for_function("() => !document.querySelector('.run').disabled", timeout=LIVE)
    for code in "def collide(a, b):\n    return 1 > 0\n", "def collide(a, b:\n", "return":
        page.evaluate("scrollTo(0, 0)")
        run_code(page, code=code)
        page.wait_for_function(
            """() => {
              const { top, bottom } = document.querySelector(".check-status").getBoundingClientRect();
              return -1 < top && bottom < innerHeight + 1;
            }"""
        )
        if screen is WIDE:
            assert page.locator("textarea").first.evaluate("(editor) => editor.getBoundingClientRect().top") > 0
            assert page.evaluate("scrollY") == 0


def drag(page, by, start, end):
    """Drag with the mouse or with a finger, in eight steps."""
    steps = [tuple(p + (q - p) * i / 8 for p, q in zip(start, end, strict=True)) for i in range(9)]
    if by == "mouse":
        page.mouse.move(*steps[0])
        page.mouse.down()
        for step in steps[1:]:
            page.mouse.move(*step)
        page.mouse.up()
        return
    finger = page.context.new_cdp_session(page)
    for kind, at in [("touchStart", steps[0]), *(("touchMove", step) for step in steps[1:]), ("touchEnd", None)]:
        points = [{"x": at[0], "y": at[1]}] if at else []
        finger.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})


def test_the_check_page_has_no_accessibility_fault(check_page, axe_core):
    run_code(check_page)
    check_page.locator(".yours").wait_for()
    assert accessibility_faults(axe_core, check_page) == []


def test_a_program_of_a_chapter_is_opened_and_corrected_without_replacing_the_readers_own(check_page):
    editor, program = check_page.get_by_role("textbox", name="Your function"), check_page.get_by_label("Program")
    editor.fill("# mine")
    check_page.evaluate("() => { location.hash = '#collide_2'; }")
    check_page.wait_for_function("() => document.querySelector('[name=program]').value === 'collide_2'")
    assert "def collide_2(a, b):" in editor.input_value()
    assert run_code(check_page).startswith("Wrong. Your function says hit. The right answer: apart.")
    before, _ = editor.input_value().split("        if a0 <= b1")
    mended = before + "        if a1 < b0 or b1 < a0:\n            return False\n    return True\n"
    assert run_code(check_page, code=mended).startswith("Right on all")
    program.select_option("your own")
    assert editor.input_value() == "# mine"
    program.select_option("collide_2")
    assert editor.input_value() == mended
    check_page.locator(".forget").click()
    assert "if a0 <= b1 and b0 <= a1:" in editor.input_value() and check_page.evaluate("() => localStorage.length") == 0


def test_a_program_of_a_chapter_has_the_same_mistake_in_both_languages(check_page):
    editor, program = check_page.get_by_role("textbox", name="Your function"), check_page.get_by_label("Program")
    names = program.locator("option").evaluate_all("(all) => all.map((o) => o.value).filter(Boolean)")
    said = {}
    for language in "python", "javascript":
        check_page.locator(f'[value="{language}"]').check()
        for name in names:
            program.select_option(name)
            assert f"{'def' if language == 'python' else 'function'} {name}(a, b)" in editor.input_value()
            said[language, name] = run_code(check_page, language)
    assert len(said) >= 10
    for name in names:
        assert "It behaves like" in said["python", name] and said["python", name] == said["javascript", name]


@pytest.mark.parametrize(
    ("language", "code", "printed"),
    [
        ("python", "print(1)\ndef collide(a, b):\n    print(2, 'x')\n    return False\n", "printed:\n1\n2 x\n"),
        (
            "javascript",
            "console.log(1);\nfunction collide(a, b) { console.log(2, 'x'); return false; }",
            "printed:\n1\n2 x\n",
        ),
    ],
)
def test_the_output_of_the_code_for_the_scene_stands_beside_it(check_page, language, code, printed):
    run_code(check_page, language, code)
    check_page.locator(".yours").wait_for()
    assert check_page.locator(".printed").text_content() == printed


def test_an_error_in_javascript_is_reported_with_its_line(check_page):
    said = run_code(check_page, "javascript", "function collide(a, b) {\n  return true;\n}".replace("true", "c.x"))
    assert said == "Your function raises ReferenceError in line 2: c is not defined. The line: return c.x;"


CALLS = "function collide(a, b) { %s }"
OUT = "answers with something that cannot be sent"


@pytest.mark.parametrize(
    ("language", "code", "line"),
    [
        ("python", "def collide(a, b):\n    raise KeyboardInterrupt\n", "raises KeyboardInterrupt in line 2"),
        ("python", "raise KeyboardInterrupt\n", "The code raises KeyboardInterrupt in line 1."),
        ("python", "import os\ndef collide(a, b):\n    os._exit(3)\n", "ends the program by itself"),
        ("python", "import os\nos._exit(3)\n", "The code ends the program by itself."),
        ("python", "import js\ndef collide(a, b):\n    js.close()\n", "the function ends the program by itself"),
        ("python", "import builtins\ndef collide(a, b):\n    builtins.len = None\n", "ends the program by itself"),
        ("python", "def collide(a, b):\n    return float('nan'), 0\n", "returns (nan, 0): expected True or False"),
        ("python", "def collide(a, b):\n    return collide\n", "returns <function collide at"),
        ("javascript", CALLS % "return 'x'.repeat(1e6);", "answers with more than 20000 letters"),
        ("javascript", CALLS % "self.close(); return true;", "the function ends the program by itself"),
        (
            "javascript",
            CALLS % "for (;;) postMessage('{');",
            "raises ReferenceError in line 1: postMessage is not defined",
        ),
        ("javascript", CALLS % "return [NaN, 1n];", "returns (NaN, 1n): expected True or False"),
        ("javascript", CALLS % "return Symbol('x');", "returns Symbol(x): expected True or False"),
        ("javascript", CALLS % "return { overlap: 1 };", "returns {overlap}: expected True or False"),
        ("javascript", CALLS % "return Array(1e6).fill(1);", "returns a long or deep list: expected"),
        ("javascript", CALLS % "const x = []; x.push(x); return x;", "returns (((a long or deep list,),),): expected"),
        ("javascript", "async " + CALLS % "return true;", "returns a value of type Promise: expected"),
        ("javascript", CALLS % "return { get x() { throw new Error('mine'); } };", "raises Error in line 1: mine"),
        ("javascript", CALLS % "throw new Proxy({}, { get() { throw 1; } });", OUT),
        ("javascript", "JSON.stringify = () => Symbol('x');\n" + CALLS % "return true;", OUT),
        ("javascript", "JSON.stringify = () => '{';\n" + CALLS % "return true;", "message that is not an outcome"),
        ("javascript", CALLS % "return true;" + "})(); throw 5; (() => {", "The code raises 5 in line 1."),
        ("javascript", CALLS % "return true;" + " /* open", "The code raises SyntaxError"),
        ("javascript", CALLS % "const f = () => Promise.resolve().then(f); f();", "an endless loop?"),
        ("javascript", CALLS % "for (;;) console.error(a);", "an endless loop?"),
    ],
)
def test_an_answer_of_a_wrong_type_is_reported_and_the_page_goes_on(check_page, language, code, line):
    assert line in run_code(check_page, language, code)
    assert run_code(check_page, "javascript", "function collide(a, b) { return 1; }").startswith("Wrong.")


def test_a_symptom_links_to_the_mistakes_that_cause_it(check_page):
    check_page.get_by_text("It falls through", exact=False).click()
    check_page.get_by_role("link", name="the centers are far apart, so the shapes are").click()
    check_page.wait_for_url("**/scene.html#far-centers")
