"""The options of a scene in a frame of another page, as the query of its address, which stands before the #.

scene.html?embed&steps=3-8&theme=dark#triangles
"""

import re
from collections.abc import Iterable
from typing import NamedTuple
from urllib.parse import parse_qs

from ..engine.geometry import InvalidScene
from ..engine.polygon_validation import short_repr
from .link import GOALS

EMBED = "embed"
THEMES = "light", "dark"
VIEW_PARTS = TOOLS, TABLE = "tools", "table"  # parts of an explorer or a player, beside the picture and its sentence
STEPS = re.compile(r"([0-9]{1,6})-([0-9]{1,6})")


class EmbedOptions(NamedTuple):
    """The options of an embedded scene; by default it has two shapes to drag, with a sentence below them.

    `play` steps through the run; `predict` asks the reader for the result of each test before it is shown.
    `steps`: the first and the last step that are played, counted from 0; None plays all.
    `challenge` is one of GOALS, or "" for the one that fits the scene; None sets no challenge.
    `theme` is one of THEMES, or None for that of the reader's system; `show`: those of VIEW_PARTS that are shown too.
    """

    play: bool = False
    predict: bool = False
    steps: tuple[int, int] | None = None
    challenge: str | None = None
    theme: str | None = None
    show: tuple[str, ...] = ()

    @property
    def plays(self) -> bool:
        """Return whether the scene is shown step by step, and not dragged."""
        return self.play or self.predict or self.steps is not None


def query(options: EmbedOptions) -> str:
    """Return the query of an address, without its "?"; InvalidScene for options that cannot be read again."""
    words = [EMBED, *(name for name in ("play", "predict") if getattr(options, name))]
    if options.steps:
        words.append("steps={}-{}".format(*options.steps))
    if options.challenge is not None:
        words.append(f"challenge={options.challenge}".rstrip("="))
    if options.theme is not None:
        words.append(f"theme={options.theme}")
    if options.show:
        words.append(f"show={','.join(options.show)}")
    made = "&".join(words)
    if parse_query(made)._replace(steps=None) != options._replace(steps=None):
        raise InvalidScene(f"an address cannot hold these options: {short_repr(made)}; correct their values")
    return made


def parse_query(text: str) -> EmbedOptions:
    """Return the options in the query of an address; InvalidScene for a bad value.

    Unknown keys are ignored, since other programs add their own to an address.
    """
    values = parse_qs(text[:2000], keep_blank_values=True)
    for key in (EMBED, *EmbedOptions._fields):
        if len(values.get(key, ())) > 1:
            raise InvalidScene(f"the link has the option {key} {len(values[key])} times: give it once")
    found = {key: said for key, (said, *_) in values.items()}
    for key in (EMBED, "play", "predict"):
        if found.get(key, "") not in ("", "1"):
            raise InvalidScene(
                f"the link has {key}={short_repr(found[key])}: write {key} without a value, or leave it out"
            )
    theme = _one_of("theme", found["theme"], THEMES) if "theme" in found else None
    show = tuple(_one_of("show", part, VIEW_PARTS) for part in found.get("show", "").split(",") if part)
    goal = found.get("challenge")
    if goal:
        _one_of("challenge", goal, GOALS)
    options = EmbedOptions("play" in found, "predict" in found, _steps(found.get("steps")), goal, theme, show)
    if options.plays and goal is not None:
        raise InvalidScene("the link has a challenge and steps: a challenge has no steps, so leave out one of them")
    return options


def _steps(text: str | None) -> tuple[int, int] | None:
    """Return the first and the last step of a text such as "3-8"; None for None, InvalidScene for another text."""
    if text is None:
        return None
    match = STEPS.fullmatch(text)
    if not match or int(match[1]) > int(match[2]):
        raise InvalidScene(f"the link has steps={text[:40]!r}: write the first and the last step, such as 3-8")
    return int(match[1]), int(match[2])


def _one_of(key: str, text: str, choices: Iterable[str]) -> str:
    """Return the value of the option `key` if it is one of the choices; otherwise InvalidScene lists them."""
    if text not in choices:
        raise InvalidScene(f"the link has {key}={short_repr(text)}: choose one of {', '.join(choices)}")
    return text
