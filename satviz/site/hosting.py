"""The files and lines of a site for search engines, social networks, web servers and learning platforms."""

import io
import re
from collections.abc import Iterator, Mapping, Sequence
from functools import cache
from html import escape, unescape
from urllib.parse import urlsplit
from zipfile import ZIP_DEFLATED, ZipFile, ZipInfo

from ..lessons.chapter_text import Chapter
from ..pictures import Picture, picture
from ..pictures.layout import limits_around
from ..render.files import encode
from ..safe_write import MADE_BY
from ..scenes.named import names

NOT_FOUND = "404.html"  # GitHub Pages, GitLab Pages and Netlify send it, with the status 404, where there is no file
MANIFEST = "imsmanifest.xml"
SCENE_OF_PAGE = {"gallery.html": "aabb-turned", "challenges.html": "far-centers", "yours.html": "no-nearest-vertex"}
DEFAULT_SCENE = "triangles"
CARD_PT = 600.0, 315.0  # size of the picture that a social network shows: 1200 x 630 pixels
QUOTED = re.compile(r'"([a-z0-9-]+)"')
RELATIVE = re.compile(r'\b(href|src)="(?!#|/|https?:)')
SITEMAPS = "http://www.sitemaps.org/schemas/sitemap/0.9"


def head_lines(chapters: Sequence[Chapter], url: str, path: str, title: str, description: str) -> list[str]:
    """Return the lines of a page's head for social networks; for the page 404.html only one that forbids listing it.

    `url` is the address of the site.  Without it the picture's address is relative, which only some networks read.
    """
    if path == NOT_FOUND:
        return ['<meta name="robots" content="noindex">']
    name = scene_of_page(path, chapters)
    found = {"type": "website", "title": title, "description": description, "image": f"{url}{card_path(name)}"}
    found |= {"image:alt": social_card(name).sentence, "image:width": "1200", "image:height": "630"}
    lines = ['<meta name="twitter:card" content="summary_large_image">']
    if url:
        page = url + path.removesuffix("index.html")
        found["url"] = page
        lines.append(f'<link rel="canonical" href="{escape(page)}">')
    return lines + [f'<meta property="og:{key}" content="{escape(value)}">' for key, value in found.items()]


def scene_of_page(path: str, chapters: Sequence[Chapter]) -> str:
    """Return the name of the scene that stands for a page: of a chapter the first built-in one that it names."""
    for chapter in chapters:
        if chapter.path == path:
            code = "\n".join("".join(cell["source"]) for cell in chapter.cells if cell["cell_type"] == "code")
            return next((name for name in QUOTED.findall(code) if name in names()), DEFAULT_SCENE)
    return SCENE_OF_PAGE.get(path, DEFAULT_SCENE)


def card_path(name: str) -> str:
    """Return the path of the picture with which a scene stands for a page."""
    return f"pictures/{name}-card.png"


@cache
def social_card(name: str) -> Picture:
    """Return a scene's picture in the middle of a canvas of the size that social networks show."""
    drawn = picture(name, largest=CARD_PT)
    (x0, y0, x1, y1), (width, height) = drawn.limits, CARD_PT
    scale = min(drawn.scale, width / (x1 - x0), height / (y1 - y0))
    return drawn._replace(size=CARD_PT, limits=limits_around(((x0 + x1) / 2, (y0 + y1) / 2), CARD_PT, scale))


def social_pictures(chapters: Sequence[Chapter]) -> Iterator[tuple[str, bytes]]:
    """Yield (path, content) of each picture that stands for a page in a social network."""
    paths = [*(chapter.path for chapter in chapters), *SCENE_OF_PAGE, "index.html"]
    for name in dict.fromkeys(scene_of_page(path, chapters) for path in paths):
        yield card_path(name), encode(social_card(name), "png", stem=name)


def not_found_page_with_absolute_links(page: bytes, url: str) -> bytes:
    """Return the page 404.html with absolute links, which work at any depth.

    Where the site's address is unknown ("") they stay relative.
    """
    root = urlsplit(url).path if url else ""
    return RELATIVE.sub(rf'\1="{root}', page.decode()).encode()


def robots_txt(url: str) -> bytes:
    """Return robots.txt, which allows everything; crawlers read it only at the root of a server."""
    lines = [f"# {MADE_BY}", "User-agent: *", "Allow: /", *([f"Sitemap: {url}sitemap.xml"] if url else [])]
    return ("\n".join(lines) + "\n").encode()


def sitemap(url: str, paths: Sequence[str]) -> bytes:
    """Return the sitemap of these pages; the format needs whole addresses."""
    places = (f"<url><loc>{escape(url + path.removesuffix('index.html'))}</loc></url>" for path in paths)
    head = f'<?xml version="1.0" encoding="UTF-8"?>\n<!-- {MADE_BY} -->\n<urlset xmlns="{SITEMAPS}">'
    return "\n".join([head, *places, "</urlset>", ""]).encode()


def archive(files: Mapping[str, bytes], chapters: Sequence[Chapter]) -> bytes:
    """Return the site as a zip for a learning platform, the same bytes each time.

    A manifest makes it an IMS content package and a SCORM 1.2 package, with a page for each item of its contents.
    Its pages are assets: they are shown, and report nothing to the platform.
    """
    shown = ["index.html", *(chapter.path for chapter in chapters), "gallery.html", "challenges.html", "scene.html"]
    out = io.BytesIO()
    with ZipFile(out, "w", ZIP_DEFLATED) as made:
        for path, data in {**files, MANIFEST: _manifest(files, shown)}.items():
            info = ZipInfo(path)
            info.compress_type, info.external_attr = ZIP_DEFLATED, 0o644 << 16
            made.writestr(info, data)
        made.comment = f"{MADE_BY}: a site".encode()
    return out.getvalue()


def _manifest(files: Mapping[str, bytes], shown: Sequence[str]) -> bytes:
    """Return the SCORM 1.2 manifest: an item for each page that is shown; the first one's resource lists every file."""
    items, resources = [], []
    for i, path in enumerate(shown):
        title = unescape(re.findall("<title>(.*?)</title>", files[path].decode())[0])
        items.append(f'<item identifier="item-{i}" identifierref="page-{i}"><title>{escape(title)}</title></item>')
        listed = "".join(f'<file href="{escape(each)}"/>' for each in (files if not i else [path]))
        kind = 'type="webcontent" adlcp:scormtype="asset"'
        resources.append(f'<resource identifier="page-{i}" {kind} href="{path}">{listed}</resource>')
    lines = [
        '<?xml version="1.0" encoding="UTF-8"?>',
        f"<!-- {MADE_BY} -->",
        '<manifest identifier="satviz" version="1.2" xmlns="http://www.imsproject.org/xsd/imscp_rootv1p1p2" '
        'xmlns:adlcp="http://www.adlnet.org/xsd/adlcp_rootv1p2">',
        "<metadata><schema>ADL SCORM</schema><schemaversion>1.2</schemaversion></metadata>",
        '<organizations default="site"><organization identifier="site"><title>Do they collide?</title>',
        *items,
        "</organization></organizations>",
        "<resources>",
        *resources,
        "</resources>",
        "</manifest>",
    ]
    return ("\n".join(lines) + "\n").encode()
