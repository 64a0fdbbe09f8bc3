"""The folder of a site for any host: sub-path, missing pages, previews, sitemap, and the archive for a platform."""

import io
import re
import threading
import urllib.error
import urllib.request
from html import unescape
from xml.etree import ElementTree
from zipfile import ZipFile

import pytest
from browser import SITE_URL as URL
from PIL import Image

from satviz.cli import main
from satviz.pictures.drag import all_marks_fit

pytest.importorskip("markdown_it", reason="a site needs markdown-it-py: python -m pip install '.[site]'")

from satviz.lessons import chapter_text as chapters
from satviz.site import guides, hosting
from satviz.site import pages as pages_of_site
from satviz.site.serving import server


@pytest.fixture(scope="module")
def files(still_files):
    return still_files


@pytest.fixture(scope="module")
def pages(files):
    return {path: data.decode() for path, data in files.items() if path.endswith(".html") and "/" not in path}


@pytest.fixture(scope="module")
def unknown():
    """Return the SiteInfo of a site whose address is not known."""
    return pages_of_site.SiteInfo(chapters.chapters(), guides.guides(), "v1", False, False)


def meta(page, key):
    return unescape(re.search(rf'<meta (?:name|property)="{key}" content="([^"]*)">', page)[1])


@pytest.mark.slow
def test_every_page_has_a_description_and_a_picture(files, pages):
    of_page = {}
    for path, page in pages.items():
        if path == hosting.NOT_FOUND:
            assert meta(page, "robots") == "noindex" and "og:image" not in page
            continue
        assert meta(page, "description") == meta(page, "og:description"), path
        assert of_page.setdefault(meta(page, "description"), path) == path
        assert meta(page, "og:title") == unescape(re.search("<title>(.*?)</title>", page)[1])
        assert f'<link rel="canonical" href="{meta(page, "og:url")}">' in page
        with Image.open(io.BytesIO(files[meta(page, "og:image").removeprefix(URL)])) as card:
            assert card.size == (1200, 630), path
    assert meta(pages["index.html"], "og:url") == URL
    for path, data in files.items():
        if path.startswith("reference/") and path.endswith(".html"):
            assert '<meta name="description" content="The reference of satviz' in data.decode()


def test_a_site_that_does_not_know_its_address_names_none(unknown):
    front = pages_of_site.front_page(unknown).decode()
    assert meta(front, "og:image") == "pictures/triangles-card.png"
    assert "canonical" not in front and "og:url" not in front
    assert hosting.robots_txt("").decode().splitlines() == ["# made by satviz", "User-agent: *", "Allow: /"]
    assert 'href="index.html"' in pages_of_site.not_found_page(unknown).decode()


def test_a_chapters_picture_is_of_its_own_scene():
    known = chapters.chapters()
    scenes = [hosting.scene_of_page(chapter.path, known) for chapter in known]
    assert "circle" in scenes[2] and len(set(scenes)) > 3


@pytest.mark.parametrize("name", ["triangles", "far-centers", "aabb-turned", "no-nearest-vertex"])
def test_the_picture_for_social_networks_has_its_size_and_is_not_cut(name):
    card = hosting.social_card(name)
    assert card.size == hosting.CARD_PT and all_marks_fit(card)


@pytest.mark.slow
def test_the_sitemap_lists_every_page_and_robots_txt_names_the_sitemap(files, pages):
    places = [each.text for each in ElementTree.fromstring(files["sitemap.xml"]).iter(f"{{{hosting.SITEMAPS}}}loc")]
    listed = {place.removeprefix(URL) or "index.html" for place in places}
    assert listed == pages.keys() - {hosting.NOT_FOUND} and len(places) == len(listed)
    assert files["robots.txt"].decode().endswith(f"Sitemap: {URL}sitemap.xml\n")


@pytest.mark.slow
def test_the_page_of_a_missing_address_finds_the_site_from_any_depth(files, pages):
    links = re.findall(r'(?:href|src)="([^"]+)"', pages[hosting.NOT_FOUND])
    assert len(links) > 8 and all(to.startswith(("/a/satviz/", "#")) for to in links)
    for to in links:
        assert to.startswith("#") or re.sub("[?#].*", "", to).removeprefix("/a/satviz/") in files, to


@pytest.mark.slow
def test_the_server_sends_the_sites_own_page_with_the_status_404(files, tmp_path):
    (tmp_path / hosting.NOT_FOUND).write_bytes(files[hosting.NOT_FOUND])
    with server(tmp_path) as serving:
        thread = threading.Thread(target=serving.serve_forever, daemon=True)
        thread.start()
        with pytest.raises(urllib.error.HTTPError) as error:
            urllib.request.urlopen(f"http://127.0.0.1:{serving.server_address[1]}/nothing/here.html")
        assert error.value.code == 404 and error.value.read() == files[hosting.NOT_FOUND]
        serving.shutdown()
        thread.join()


@pytest.mark.slow
def test_the_archive_is_a_package_whose_items_and_files_are_there(files):
    made = hosting.archive(files, chapters.chapters())
    with ZipFile(io.BytesIO(made)) as found:
        assert found.testzip() is None and {*files, hosting.MANIFEST} == set(found.namelist())
        assert {info.date_time for info in found.infolist()} == {(1980, 1, 1, 0, 0, 0)}  # the same bytes each time
        manifest = ElementTree.fromstring(found.read(hosting.MANIFEST))
    resources = {each.get("identifier"): each for each in manifest.iter() if each.tag.endswith("}resource")}
    items = [each for each in manifest.iter() if each.tag.endswith("}item")]
    shown = [resources[item.get("identifierref")].get("href") for item in items]
    assert shown[:3] == ["index.html", "1-aabb.html", "2-sat.html"] and len(shown) == len(set(shown)) == len(resources)
    assert "Do they collide? The Separating Axis Theorem, made visible" in [item[0].text for item in items]
    assert {each.get("href") for each in resources["page-0"]} == set(files)
    assert all("asset" in each.attrib.values() for each in resources.values())


@pytest.mark.slow
def test_zip_overwrites_an_archive_that_it_made_and_nothing_else(tmp_path, capsys, files, monkeypatch):
    monkeypatch.setattr("satviz.site.build.site", lambda **_: (iter(files.items()), []))
    for _ in range(2):
        assert main(["site", str(tmp_path / "course"), "--still", "--zip"]) == 0
    assert [path.name for path in tmp_path.iterdir()] == ["course.zip"] and "course.zip" in capsys.readouterr().out
    with ZipFile(tmp_path / "course.zip", "w") as mine:
        mine.writestr("mine.svg", files["icon.svg"])
    assert main(["site", str(tmp_path / "course"), "--still", "--zip"]) == 2
    assert "was not made by satviz" in capsys.readouterr().err
