"""The picture formats that satviz writes, one row of `FORMATS` each.

The command line, the save menus of the widgets and `render/files.py` take their formats from this table.
Importing it loads no matplotlib, so that `satviz --help` stays quick.
A new format is a function and a row here, and in `safe_write.py` the place where its files name their maker.
"""

import io
from collections.abc import Callable, Iterable, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple
from xml.sax.saxutils import escape

from ..safe_write import MADE_BY

if TYPE_CHECKING:
    from matplotlib.figure import Figure

DPI = 144  # resolution of PNG and GIF: two pixels for each of the canvas's points (1/72 inch)
LAST_FRAME_MS = 2000  # added to the time that the last frame of an animation takes to read


class Words(NamedTuple):
    """The words inside the file of a picture."""

    title: str
    sentence: str  # a description for readers who cannot see the picture
    stem: str  # the beginning of the ids in an SVG
    maker: str
    ms: int = 0  # milliseconds for which a picture of an animation is shown


Encoder = Callable[["Iterable[Figure]", Sequence[Words]], bytes]


class Format(NamedTuple):
    """One picture format: its name, what its files are, and how they are made."""

    name: str  # on the command line and as the ending of a file
    about: str
    mime: str
    encode: Encoder  # from Figures and the words of each; a format that is not animated gets one of each
    animated: bool = False  # does one file hold all steps of a run?
    embeds_fonts: bool = True  # else the letters are drawn in the reader's own fonts
    in_save_menu: bool = False  # do the widgets offer it?


def _save(figures: "Iterable[Figure]", name: str, metadata: dict[str, str | None], **options: Any) -> bytes:
    """Return the bytes that matplotlib writes in the format `name`; `figures` holds exactly one Figure."""
    (figure,) = figures
    out = io.BytesIO()
    figure.savefig(out, format=name, metadata=metadata, **options)
    return out.getvalue()


def _encode_svg(figures: "Iterable[Figure]", words: Sequence[Words]) -> bytes:
    """Return an SVG file with a description after its title, both marked as labels for screen readers."""
    ((title, sentence, stem, maker, _),) = words
    svg = _save(figures, "svg", {"Title": title, "Creator": maker, "Date": None}).decode()
    before, found, after = svg.partition(f"<title>{escape(title)}</title>")
    if not found:
        raise AssertionError("matplotlib wrote no title")
    ids = f"{stem}-title", f"{stem}-desc"
    before = before.replace("<svg ", f'<svg role="img" aria-labelledby="{ids[0]} {ids[1]}" ', 1)
    described = f'<title id="{ids[0]}">{escape(title)}</title>\n <desc id="{ids[1]}">{escape(sentence)}</desc>'
    return "\n".join(line.rstrip() for line in f"{before}{described}{after}".split("\n")).encode()


def _encode_png(figures: "Iterable[Figure]", words: Sequence[Words]) -> bytes:
    """Return a PNG file that holds the words as metadata."""
    ((title, sentence, _, maker, _),) = words
    return _save(figures, "png", {"Title": title, "Description": sentence, "Software": maker}, dpi=DPI)


def _encode_pdf(figures: "Iterable[Figure]", words: Sequence[Words]) -> bytes:
    """Return a PDF file without a date, so that the same picture gives the same bytes."""
    ((title, sentence, _, maker, _),) = words
    return _save(figures, "pdf", {"Title": title, "Subject": sentence, "Creator": maker, "CreationDate": None})


def _encode_gif(figures: "Iterable[Figure]", words: Sequence[Words]) -> bytes:
    """Return an animated GIF that shows each Figure for the milliseconds of its words, and the last one longer."""
    from PIL import Image

    frames = []
    for figure in figures:
        canvas: Any = figure.canvas  # matplotlib gives the methods of its Agg canvas no types
        canvas.draw()
        size = canvas.get_width_height()
        frame = Image.frombuffer("RGBA", size, canvas.buffer_rgba(), "raw", "RGBA", 0, 1)
        frames.append(frame.convert("RGB").quantize(128, dither=Image.Dither.NONE))
    times = [each.ms for each in words]
    times[-1] += LAST_FRAME_MS
    comment = f"{MADE_BY}. {words[-1].sentence}".encode()
    out = io.BytesIO()
    frames[0].save(
        out, "GIF", save_all=True, append_images=frames[1:], duration=times, loop=0, comment=comment, optimize=False
    )
    return out.getvalue()


FORMATS = {
    each.name: each
    for each in (
        Format("svg", "a picture", "image/svg+xml", _encode_svg, embeds_fonts=False, in_save_menu=True),
        Format("png", "a picture", "image/png", _encode_png, in_save_menu=True),
        Format("pdf", "a picture", "application/pdf", _encode_pdf),
        Format("gif", "all steps as an animation", "image/gif", _encode_gif, animated=True, in_save_menu=True),
    )
}
STILL_FORMATS = [name for name, each in FORMATS.items() if not each.animated]
