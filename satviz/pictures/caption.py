"""Pictures with their sentence below them, for places where no alternative text is read."""

from collections.abc import Sequence

from ..engine.geometry import Vec
from .letters import text_size, wrap_text
from .marks import Mark, Picture

MARGIN_PT = 12.0  # space at both sides of a caption and below it
MIN_STEP_MS, MS_PER_LETTER = 600, 7  # time of a step at speed 1, where a reader can stop and go back
# time of a caption in an animation: that of a move, then 20 letters a second
MIN_CAPTION_MS, MS_PER_CAPTION_LETTER = 300, 50


def add_captions(pictures: Sequence[Picture], *, brief: bool = False) -> list[Picture]:
    """Return the pictures with their sentences as captions; all grow by the height of the tallest caption.

    With `brief` the caption is the picture's `caption`, a few words, where it has one.
    """
    words = [(brief and picture.caption) or picture.sentence for picture in pictures]
    texts = [wrap_text(text, picture.size[0] - 2 * MARGIN_PT) for text, picture in zip(words, pictures, strict=True)]
    space = max((text_size(text)[1] for text in texts), default=0.0) + MARGIN_PT
    return [_with_caption(picture, text, space) for picture, text in zip(pictures, texts, strict=True)]


def reading_time_ms(sentence: str) -> int:
    """Return the milliseconds for which a picture with this sentence is shown in a playback at speed 1."""
    return MIN_STEP_MS + MS_PER_LETTER * len(sentence)


def caption_time_ms(picture: Picture) -> int:
    """Return the milliseconds for which an animation shows a picture at speed 1: by its caption, else its sentence."""
    if not picture.caption:
        return reading_time_ms(picture.sentence)
    return MIN_CAPTION_MS + MS_PER_CAPTION_LETTER * len(picture.caption)


def with_words_below(picture: Picture, words: str) -> Picture:
    """Return the picture with `words` as a caption, broken into lines; there is space for two."""
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
