"""Pictures with their sentence below them, for places where no alternative text is read."""

from collections.abc import Sequence

from ..engine.geometry import Vec
from .letters import text_size, wrap_text
from .marks import Mark, Picture

MARGIN_PT = 12.0  # at both sides of a caption and below it
MIN_STEP_MS, MS_PER_LETTER = 600, 7  # at speed 1; the article's triangles take less than 20 s


def add_captions(pictures: Sequence[Picture]) -> list[Picture]:
    """Return the pictures with their sentences as captions; all grow by the height of the tallest caption."""
    texts = [wrap_text(picture.sentence, picture.size[0] - 2 * MARGIN_PT) for picture in pictures]
    space = max((text_size(text)[1] for text in texts), default=0.0) + MARGIN_PT
    return [_with_caption(picture, text, space) for picture, text in zip(pictures, texts, strict=True)]


def reading_time_ms(sentence: str) -> int:
    """Return the milliseconds for which a picture with this sentence is shown in a playback at speed 1."""
    return MIN_STEP_MS + MS_PER_LETTER * len(sentence)


def with_words_below(picture: Picture, words: str) -> Picture:
    """Return the picture with a caption of its own, in as many lines as fit it, on space for two lines."""
    text = wrap_text(words, picture.size[0] - 2 * MARGIN_PT)
    return _with_caption(picture, text, text_size("\n")[1] + MARGIN_PT)


def _with_caption(picture: Picture, text: str, space: float) -> Picture:
    """Return the picture made `space` points taller at the bottom, with the text there as a label."""
    x0, y0, x1, y1 = picture.limits
    middle = Vec((x0 + x1) / 2, y0 - text_size(text)[1] / 2 / picture.scale)
    label = Mark("caption", "label", "ink", (middle,), text=text)
    size = picture.size[0], round(picture.size[1] + space)
    limits = x0, y1 - size[1] / picture.scale, x1, y1
    return picture._replace(marks=(*picture.marks, label), limits=limits, size=size)
