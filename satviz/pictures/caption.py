"""Pictures with their sentence below, for where no alt text is read."""

from collections.abc import Sequence

from ..engine.geometry import Vec
from .layout import text_size
from .marks import Mark, Picture

MARGIN = 12.0  # points at the sides and below
SHOWN, LETTER = 1000, 50  # milliseconds that a picture stays to be read: at least, and more a letter


def add_captions(pictures: Sequence[Picture]) -> list[Picture]:
    """The same pictures, all with room for the longest of their sentences under them."""
    texts = [wrap_text(picture.sentence, picture.size[0] - 2 * MARGIN) for picture in pictures]
    room = max((text_size(text)[1] for text in texts), default=0.0) + MARGIN
    return [_with(picture, text, room) for picture, text in zip(pictures, texts, strict=True)]


def reading_time_ms(sentence: str) -> int:
    """The milliseconds that a picture takes to be read with its sentence."""
    return SHOWN + LETTER * len(sentence)


def _with(picture: Picture, text: str, room: float) -> Picture:
    x0, y0, x1, y1 = picture.limits
    middle = Vec((x0 + x1) / 2, y0 - text_size(text)[1] / 2 / picture.scale)
    label = Mark("caption", "label", "ink", (middle,), text=text)
    size = picture.size[0], round(picture.size[1] + room)
    limits = x0, y1 - size[1] / picture.scale, x1, y1
    return picture._replace(marks=(*picture.marks, label), limits=limits, size=size)


def wrap_text(text: str, width: float, weight: str = "plain") -> str:
    """Lines as full as the width allows."""
    lines = [""]
    for word in text.split(" "):
        longer = f"{lines[-1]} {word}".strip()
        if lines[-1] and text_size(longer, weight)[0] > width:
            lines.append(word)
        else:
            lines[-1] = longer
    return "\n".join(lines)
