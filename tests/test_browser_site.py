"""The site in a real browser, from a server of its own: drag without waiting for anything from elsewhere."""

import shutil
import threading
from contextlib import contextmanager

import pytest
from browser import missing, shut_out

import satviz as sv
from satviz.disk import write
from satviz.scenes.link import Shown, fragment
from satviz.site.build import site
from satviz.site.serving import server

pytestmark = pytest.mark.slow

LIVE = 30_000  # milliseconds that Python may take to start here


@pytest.fixture(scope="session")
def built(tmp_path_factory):
    """The site with Python in its pages, made once."""
    found, lacks = site()
    if lacks:
        missing(lacks[0])
    folder = tmp_path_factory.mktemp("site")
    for path, data in found:
        write(folder / path, data)
    return folder


@contextmanager
def served(folder):
    with server(folder) as serving:
        thread = threading.Thread(target=serving.serve_forever, daemon=True)
        thread.start()
        yield f"http://127.0.0.1:{serving.server_address[1]}/"
        serving.shutdown()
        thread.join()


@pytest.fixture(scope="module")
def url(built):
    with served(built) as found:
        yield found


@pytest.fixture
def visit(browser, errors, url):
    """Open a page of the site; no error and no request to anywhere else."""
    contexts = []

    def opened(path, *, at=url, live=True, **more):
        context = browser.new_context(**{"viewport": {"width": 1280, "height": 800}, **more})
        contexts.append(context)
        page = context.new_page()
        page.on("pageerror", lambda error: errors.append(str(error)))
        page.on("console", lambda message: errors.append(message.text) if message.type == "error" else None)
        page.on("request", lambda request: None if request.url.startswith(at) else errors.append(request.url))
        page.goto(at + path)
        if live:
            page.locator(".live.ready").first.wait_for(timeout=LIVE)
        return page

    yield opened
    for context in contexts:
        context.close()


def middle(page, part):
    box = page.locator(f'.live [data-id="{part}"]').first.bounding_box()
    return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2


def said(page):
    return page.locator(".live .sv-sentence").inner_text()


def says(page, word):
    page.wait_for_function(f"() => document.querySelector('.live .sv-sentence').textContent.includes({word!r})")


def test_a_triangle_is_dragged_with_the_mouse(visit):
    page = visit("")
    assert said(page) == sv.scene("triangles").record().sentence
    (ax, ay), (bx, by) = middle(page, "A.outline"), middle(page, "B.outline")
    page.mouse.move(bx, by)
    page.mouse.down()
    for i in range(1, 21):
        page.mouse.move(bx + (ax - bx) * i / 20, by + (ay - by) * i / 20)
    page.mouse.up()
    says(page, "overlap")
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
    says(page, "overlap")


def test_a_triangle_is_moved_with_the_keyboard(visit):
    page = visit("")
    page.locator('[data-handle="B-move"]').focus()
    for _ in range(24):
        page.keyboard.press("ArrowLeft")
    says(page, "overlap")


@pytest.mark.parametrize("more", [{"color_scheme": "dark"}, {"reduced_motion": "reduce"}])
@pytest.mark.parametrize("width", [390, 1280])
def test_no_page_is_wider_than_its_window(visit, built, width, more):
    page = visit("", viewport={"width": width, "height": 844}, **more)
    for path in ["", *sorted(path.name for path in built.glob("*.html"))]:
        page.goto(page.url.rpartition("/")[0] + "/" + path)
        assert page.evaluate("document.documentElement.scrollWidth") <= width, path


@pytest.mark.parametrize("path", ["", "gallery.html", "challenges.html", "2-sat.html", "scene.html#far-centers"])
@pytest.mark.parametrize(
    "more", [{"color_scheme": "dark"}, {"viewport": {"width": 390, "height": 844}}], ids=["dark", "phone"]
)
def test_no_page_shuts_anyone_out(visit, axe_core, path, more):
    page = visit(path, live=path not in ("gallery.html", "challenges.html"), **more)
    assert shut_out(axe_core, page) == []


def test_python_starts_from_the_memory_that_was_kept(visit):
    assert visit("").locator(".live").get_attribute("data-from") == "memory"


def test_the_live_scene_takes_the_room_of_the_still_one(visit):
    """So that nothing jumps under the reader's eyes when Python is ready."""
    still = visit("", live=False, java_script_enabled=False).locator(".live .picture").bounding_box()
    live = visit("").locator(".live svg.sv-picture").first.bounding_box()
    assert [live[k] for k in ("x", "width", "height")] == pytest.approx(
        [still[k] for k in ("x", "width", "height")], abs=2
    )
    assert live["y"] == pytest.approx(still["y"], abs=40)  # words about the scene may stand above it


def test_without_javascript_every_page_is_there(visit):
    page = visit("", live=False, java_script_enabled=False)
    assert page.locator(".live svg.picture").is_visible() and "gap of 1.213" in page.locator(".live").inner_text()
    page.goto(page.url + "2-sat.html")
    assert page.locator("svg.picture").count() > 8 and page.locator(".player .still svg").is_visible()
    page.get_by_text("step by step, in words").first.click()
    assert page.locator(".player li").count() > 15
    page.locator("summary", has_text="Solution").first.click()
    assert page.locator("details[open] pre.code").last.is_visible()


def test_a_failing_scenes_link_opens_it(visit):
    page = visit("scene.html#far-centers")
    assert "Claim: the centers are far apart" in page.locator(".sv-heading").inner_text()
    page.goto(page.url.replace("far-centers", "aabb-turned"))  # another link in the same page
    page.wait_for_function("() => document.querySelector('.sv-heading')?.textContent.includes('bounding boxes')")


def test_a_link_opens_the_same_state_and_the_address_follows_the_hand(visit):
    mine = sv.Scene("mine", sv.Polygon([(0, 0), (4, 0), (0, 4)]), sv.Circle((5, 5), 1))
    page = visit(f"scene.html#{fragment(mine, Shown(free=40.0, way_out=True))}")
    assert "at 40 degrees" in said(page) and page.get_by_label("free axis").is_checked()
    assert page.get_by_label("way out").is_checked() and not page.get_by_role("checkbox", name="B − A").is_checked()
    page.locator('[data-handle="axis"]').focus()
    page.keyboard.press("[")
    says(page, "at 45 degrees")
    page.wait_for_function("() => location.hash.includes('free=45')")
    page.reload()
    page.locator(".live.ready").wait_for(timeout=LIVE)
    assert "at 45 degrees" in said(page)


def test_a_link_to_a_step_opens_the_player(visit):
    page = visit("scene.html#triangles&step=14&predict=1")
    assert page.get_by_label("predict").is_checked() and page.locator(".sv-question").is_visible()
    page = visit("scene.html#triangles&step=14")
    assert page.locator(".sv-count").inner_text() == "15 / 16"


def test_the_link_that_is_copied_opens_the_same(visit):
    page = visit("scene.html#far-centers&view=truth")
    page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    page.locator(".sv-menu summary").click()
    page.get_by_role("button", name="copy link").click()
    assert page.evaluate("navigator.clipboard.readText()") == page.url
    page = visit("2-sat.html")
    page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    player = page.locator(".player")
    player.get_by_role("button", name="copy link").click()
    page.goto(page.evaluate("navigator.clipboard.readText()"))
    page.locator(".live.ready").wait_for(timeout=LIVE)
    assert page.get_by_label("predict").is_checked() and page.locator(".sv-count").inner_text().startswith("1")


def test_a_link_of_a_stranger_runs_nothing_and_says_why(visit):
    page = visit("scene.html#<img src=x onerror=alert(1)>&free=1", live=False)
    page.get_by_text("This link cannot be opened").wait_for(timeout=LIVE)
    assert page.locator(".live .picture").is_visible() and not page.locator("main img").count()


def test_a_chapter_plays_and_explores(visit):
    page = visit("2-sat.html")
    player = page.locator(".player")
    player.get_by_role("button", name="last step").click()
    assert player.locator(".sv-question").is_visible()  # this one asks before it shows
    before = page.locator(".open a").last.get_attribute("href")
    page.locator(".live.ready").last.locator('[data-handle="B-move"]').focus()
    page.keyboard.press("ArrowLeft")
    page.wait_for_function(
        "before => [...document.querySelectorAll('.open a')].at(-1).getAttribute('href') !== before", arg=before
    )


@pytest.mark.parametrize("harm", ["gone", "not gzip", "of another build"])
def test_where_the_kept_memory_does_not_load_python_starts_anew(built, visit, tmp_path, harm):
    folder = tmp_path / "site"
    shutil.copytree(built, folder)
    memory = folder / "python" / "memory.bin"
    if harm == "gone":
        memory.unlink()
    elif harm == "not gzip":
        memory.write_bytes(b"nothing that unpacks" * 1000)
    else:
        memory.write_bytes((folder / "python" / "library.bin").read_bytes())
    with served(folder) as at:
        page = visit("", at=at, live=False)
        page.locator(".live.ready").wait_for(timeout=2 * LIVE)
        assert page.locator(".live").get_attribute("data-from") == "nothing"
        page.locator('[data-handle="B-move"]').focus()
        for _ in range(24):
            page.keyboard.press("ArrowLeft")
        says(page, "overlap")
        page.context.close()


def test_a_site_without_python_says_so_and_has_its_pictures(visit, tmp_path):
    for path, data in site(live=False)[0]:
        write(tmp_path / path, data)
    with served(tmp_path) as at:
        page = visit("", at=at, live=False)
        page.get_by_text("no Python in it").wait_for()
        assert page.locator(".live .picture").is_visible()
        page.context.close()


def test_what_was_read_once_is_there_without_a_server(built, visit):
    with served(built) as at:
        page = visit("", at=at)
        page.evaluate("navigator.serviceWorker.ready")
        page.reload()
        page.locator(".live.ready").wait_for(timeout=LIVE)
        page.wait_for_timeout(500)
    page.reload()
    page.locator(".live.ready").wait_for(timeout=LIVE)


def test_a_challenge_is_met_by_hand_and_judged_by_the_engine(visit):
    page = visit("scene.html#aabb&goal=touch")
    goal = page.locator(".goal")
    assert "apart: gap +2" in goal.inner_text()
    page.locator('[data-handle="B-move"]').focus()
    for _ in range(60):
        before = goal.inner_text()
        page.keyboard.press("ArrowLeft")
        page.wait_for_function("before => document.querySelector('.goal').innerText !== before", arg=before)
        if "met" in goal.get_attribute("class"):
            break
    assert "They touch, exactly." in goal.inner_text()
    page.wait_for_function("() => location.hash.endsWith('&goal=touch')")
    page.goto(page.url.partition("#")[0] + "#far-centers")
    page.locator(".sv-heading").wait_for()
    assert not goal.is_visible()
