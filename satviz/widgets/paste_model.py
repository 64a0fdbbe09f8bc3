"""The paste box without its page: the reply to a text has its shapes, the diagnosis, and forms to copy or save."""

from typing import Any

from ..engine.geometry import InvalidScene, Vec
from ..pictures import picture
from ..pictures.outlines import outlines_picture
from ..scenes.link import fragment
from ..scenes.minimal_test import LANGUAGES
from ..scenes.paste.exact import crossing
from ..scenes.paste.pair_findings import AnsweredPair
from ..scenes.paste.pasted import Pasted, paste
from ..scenes.scenefile import Scene
from ..scenes.strictjson import require_type

MAX_DRAWN_CORNERS = 60  # corners of a refused outline that are drawn, at most


def read_paste(content: dict[str, Any]) -> tuple[Scene | None, dict[str, Any]]:
    """Return (scene, reply): the scene of the pair that a message asks for, and all that a page shows as JSON values.

    `content`: the "text", and perhaps the readings that were chosen ("as") and the pair's number ("pair").  The scene
    is None if the text has no pair of shapes.  The function raises nothing: the reply to a text that cannot be read
    has the reason, "why".
    """
    try:
        text = require_type(content.get("text"), "the text", str)
        chosen = [
            require_type(word, "a reading", str) for word in require_type(content.get("as", []), "the readings", list)
        ]
        number = require_type(content.get("pair", 0), "the pair", int)
        found = paste(text, chosen)
    except InvalidScene as error:
        return None, {"why": f"{str(error).rstrip('.')}."}
    data = found.data() | {"chosen": list(found.chosen), "wkt": found.wkt, "json": found.to_json()}
    if drawn := _refused(found):
        data["refused"] = drawn
    if not found.pairs:
        return None, data
    number = number if 0 <= number < len(found.pairs) else 0
    scene = found.scene(number)
    tests = {language: found.test(language, number) for language in LANGUAGES}
    pair = found.pairs[number]
    if (pair.a.name, pair.b.name) != ("A", "B"):
        data["note"] = f"The picture calls {pair.a.name} A, and {pair.b.name} B."
    return scene, data | {
        "pair": number,
        "tests": tests,
        "scene": scene.to_json(),
        "link": fragment(scene),
        "picture": _drawn(pair),
    }


def _drawn(pair: AnsweredPair) -> dict[str, Any] | None:
    """Return the picture of a pair as JSON values; None for coordinates that no canvas holds."""
    try:
        return picture(pair.trace, -1).data()
    except (ValueError, OverflowError):
        return None


def _refused(found: Pasted) -> dict[str, Any] | None:
    """Return as JSON values the picture of the first outline that is refused, with its crossing and the order meant.

    None if no outline of at most 60 corners is refused, or no canvas holds it.
    """
    bad = [r for r in found.readings if not r.shape and not r.read.is_circle and len(r.vertices) <= MAX_DRAWN_CORNERS]
    if not bad:
        return None
    each = bad[0]
    met = crossing(each.read.points)
    at = Vec(*map(float, met.point)) if met else None
    ring = [Vec(x, y) for x, y in each.vertices]
    meant = [Vec(*v) for v in each.meant.corners] if each.meant else []
    try:
        return outlines_picture(each.name, ring, at, meant, each.refused).data()
    except (ValueError, OverflowError):  # coordinates that no canvas holds
        return None
