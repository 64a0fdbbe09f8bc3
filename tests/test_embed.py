"""A scene in a frame: what its address says, and what a reader without scripts gets."""

import json
import re
from base64 import b64decode
from html import unescape

import pytest

import satviz as sv
from satviz.engine.geometry import InvalidScene
from satviz.render.embed import embed
from satviz.scenes.embedding import EmbedOptions, parse_query, query
from satviz.site import live

SITE = "https://example.org/satviz"


def address(html):
    return unescape(re.search(r'<iframe src="([^"]+)"', html)[1])


def opened(html):
    """Return what the page of a frame's address opens."""
    asked, _, fragment = address(html).partition("?")[2].partition("#")
    return json.loads(live.answer("frame", json.dumps({"kind": "open", "hash": fragment, "query": asked})))


@pytest.mark.parametrize(
    "options",
    [
        EmbedOptions(),
        EmbedOptions(play=True, theme="dark", show=("tools", "table")),
        EmbedOptions(predict=True, steps=(0, 0)),
        EmbedOptions(challenge="", theme="light"),
        EmbedOptions(challenge="one-axis"),
    ],
)
def test_a_query_is_read_as_it_was_written(options):
    assert parse_query(query(options)) == options


@pytest.mark.parametrize(
    "text",
    ["embed&theme=pink", "embed&show=table,menu", "embed&challenge=win", "steps=8-3", "steps=3", "steps=-1-2",
     "steps=1e3-2000", "play&challenge", "play=no", "predict=0", "embed&embed", "theme=dark&theme=light",
     "steps=1-2&steps=3-8", f"steps=1-{'9' * 1900}"],
)  # fmt: skip
def test_an_invalid_query_is_refused_and_the_page_says_why(text):
    with pytest.raises(InvalidScene, match="the link"):
        parse_query(text)
    reply = json.loads(live.answer("frame", json.dumps({"kind": "open", "hash": "triangles", "query": text})))
    assert reply["kind"] == "refused" and reply["why"]


@pytest.mark.parametrize("options", [EmbedOptions(theme="dark&play"), EmbedOptions(show=("tools,table",))])
def test_options_that_would_be_read_as_others_are_refused(options):
    with pytest.raises(InvalidScene, match="an address cannot hold these options"):
        query(options)


def test_keys_that_other_programs_add_to_an_address_change_nothing():
    assert parse_query("embed&utm_source=x&fbclid=%3Cb%3E&utm_source=y&") == EmbedOptions()
    assert parse_query("embed=1&play=1") == EmbedOptions(play=True)


def test_a_frame_opens_with_the_options_that_were_passed():
    assert "first" in opened(embed("triangles", site=SITE))
    assert opened(embed("triangles", site=SITE, play=True))["step"] == 0
    assert opened(embed("triangles", site=SITE, play=True, step=5))["step"] == 5
    part = opened(embed("triangles", site=SITE, steps=(3, 8), show=["table"]))
    assert (part["range"], part["step"], part["predict"]) == ([3, 8], 3, False)
    asks = opened(embed("far-centers", site=SITE, predict=True))
    assert asks["predict"] and asks["shows"][0]["asks"] and asks["range"] is None
    free = opened(embed(sv.Circle((0, 0), 2), sv.Circle((3, 1), 1), site=SITE, free=30.0, theme="dark"))
    assert free["pose"]["degree"] == 30


@pytest.mark.parametrize("name", [scene.name for scene in map(sv.scene, ("triangles", "circles", "far-centers"))])
def test_the_default_challenge_fits_the_scene_and_is_not_met_yet(name):
    goal = opened(embed(name, site=SITE, challenge=""))["first"]["goal"]
    assert goal["goal"] == ("break" if sv.scene(name).record().shortcut else "touch") and not goal["met"]


def test_a_frame_whose_challenge_the_scene_cannot_have_is_not_made():
    with pytest.raises(InvalidScene, match="no shortcut"):
        embed("triangles", site=SITE, challenge="break")
    assert opened(embed("far-centers", site=SITE, challenge="break"))["first"]["goal"]["goal"] == "break"


def test_without_scripts_a_frame_has_the_picture_and_its_sentence():
    html = embed("triangles", site=SITE)
    (still,) = re.findall(r"<noscript>(.*)</noscript>", html)
    svg = b64decode(re.search(r"base64,([^\"]+)", still)[1]).decode()
    sentence = sv.scene("triangles").record().sentence
    assert sentence in unescape(still) and sentence in unescape(svg) and svg.startswith("<?xml")
    assert "\n\n" not in html  # Markdown ends a block of HTML at an empty line


def test_a_frame_with_predict_does_not_give_the_answer_away():
    html = unescape(embed("triangles", site=SITE, predict=True))
    svg = b64decode(re.search(r"base64,([^\"]+)", html)[1]).decode()
    for word in "apart", "gap":
        assert word not in html.partition("<script>")[0].replace("triangles", "") and word not in svg


def test_a_title_and_a_label_are_text_in_the_frame():
    shapes = sv.Polygon([(0, 0), (4, 0), (0, 4)], ["<b>", '"', "&"]), sv.Circle((5, 5), 1)
    html = embed(*shapes, site=SITE)
    assert "<b>" not in html and html.count("<iframe") == html.count("</iframe>") == 1
    assert opened(html)["first"]["a"]["labels"] == ["<b>", '"', "&"]


def test_a_frame_that_nobody_could_open_is_refused():
    for wrong in {"site": ""}, {"theme": "pink"}, {"steps": (8, 3)}, {"challenge": "win"}, {"view": "other"}:
        with pytest.raises(InvalidScene):
            embed("triangles", **{"site": SITE, **wrong})
    for beyond in {"steps": (3, 99)}, {"play": True, "step": 99}:
        with pytest.raises(InvalidScene, match="its steps are 0 to 15"):
            embed("triangles", site=SITE, **beyond)
    with pytest.raises(InvalidScene, match="no-area is refused"):
        embed("no-area", site=SITE)
    with pytest.raises(InvalidScene, match="has no step 99"):
        raise InvalidScene(opened(embed("triangles", site=SITE).replace("embed#", "embed&steps=3-99#"))["why"])
