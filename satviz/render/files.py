"""Pictures as the bytes of files in each of `FORMATS`.

The same picture gives the same bytes each time, and each file holds its words.
"""

import logging
import warnings
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from threading import RLock
from typing import TYPE_CHECKING, Any

import matplotlib
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from ..engine import describe
from ..pictures import LIGHT, Picture, Theme
from ..pictures.caption import reading_time_ms
from ..safe_write import MADE_BY
from .fonts import families
from .formats import DPI, FORMATS, Format, Words
from .pen import Pen

if TYPE_CHECKING:
    from matplotlib.typing import RcKeyType

MAKER = f"{MADE_BY} with matplotlib {matplotlib.__version__}"

_LOCK = RLock()
_FONT_LOG = logging.getLogger("matplotlib.font_manager")
_STYLE: "dict[RcKeyType, Any]" = {
    "svg.fonttype": "none",
    "font.family": ["sans-serif"],
    # The first font ships with matplotlib; the letters of the others are as wide, for browsers without it.
    "font.sans-serif": ["DejaVu Sans", "Bitstream Vera Sans", "Verdana"],
    "text.hinting": "none",  # hinted letters are up to 7 % wider than the layout measured them
    "pdf.fonttype": 42,
    "pdf.compression": 6,
    "path.simplify": False,
}


def canvas(size: tuple[float, float], theme: Theme = LIGHT) -> tuple[Figure, Pen]:
    """Return a new Figure of `size` (width, height) in points, made without pyplot, and a pen on it."""
    fig = Figure(figsize=(size[0] / 72, size[1] / 72), dpi=DPI)
    FigureCanvasAgg(fig)
    fig.set_facecolor(theme.paper)
    ax = fig.add_axes((0, 0, 1, 1))
    pen = Pen(ax, theme)
    ax.set_axis_off()
    return fig, pen


@contextmanager
def styled(more: "dict[RcKeyType, Any] | None" = None) -> Iterator[None]:
    """Give matplotlib the settings of satviz's files for a with block, and restore the old ones after it.

    `more`: further settings.  matplotlib has one set for the whole process, so only one thread at a time is inside.
    """
    with _LOCK, matplotlib.rc_context({**_STYLE, **(more or {})}), warnings.catch_warnings():
        # `families` has warned of missing letters already, by name
        warnings.filterwarnings("ignore", "Glyph .* missing")
        level = _FONT_LOG.level
        _FONT_LOG.setLevel(logging.ERROR)  # a font that has such a letter may have no bold one
        try:
            yield
        finally:
            _FONT_LOG.setLevel(level)


def encode(picture: Picture, form: str, theme: Theme = LIGHT, *, stem: str = "picture") -> bytes:
    """Return a picture as the bytes of a file in the format `form`; `stem` begins the ids in an SVG."""
    return encode_frames([picture], form, theme, stem=stem)


def encode_frames(
    pictures: Sequence[Picture],
    form: str,
    theme: Theme = LIGHT,
    *,
    stem: str = "picture",
    times: Sequence[int] | None = None,
) -> bytes:
    """Return the pictures as the bytes of one file; only an animated format takes more than one.

    `times`: the milliseconds for which each is shown, by default as long as its sentence takes to read.
    """
    times = [reading_time_ms(picture.sentence) for picture in pictures] if times is None else times
    fonts: Sequence[str] = ()
    if _format(form).embeds_fonts:
        fonts = families([text for picture in pictures for text in picture.texts], form)

    def draw_frames() -> Iterator[Figure]:
        """Yield the same Figure once for each picture, with that picture drawn on it."""
        fig, pen = canvas(pictures[0].size, theme)
        for picture in pictures:
            pen.draw(picture)
            pen.set_fonts(fonts)
            yield fig

    words = [
        _words(picture.title or picture.sentence, picture.sentence, stem)._replace(ms=ms)
        for picture, ms in zip(pictures, times, strict=True)
    ]
    return _encode(draw_frames(), form, words)


def encode_figure(make: Callable[[], Figure], form: str, *, stem: str, title: str, sentence: str) -> bytes:
    """Return as the bytes of a file the Figure that `make` draws under the settings of satviz's files."""
    return _encode((draw() for draw in [make]), form, [_words(title, sentence, stem)])


def _encode(figures: Iterator[Figure], form: str, words: Sequence[Words]) -> bytes:
    """Return the Figures as the bytes of one file; they are drawn while satviz's settings apply."""
    with styled({"svg.hashsalt": words[0].stem}):
        return _format(form).encode(figures, words)


def _words(title: str, sentence: str, stem: str) -> Words:
    """Return the title (without control characters), sentence, id stem and maker that a file holds."""
    return Words(describe.printable(title), sentence, stem, MAKER)


def _format(name: str) -> Format:
    """Return the format of that name; ValueError lists the names."""
    if name not in FORMATS:
        raise ValueError(f"unknown format {name!r}: choose one of {', '.join(FORMATS)}")
    return FORMATS[name]


def inline_svg(picture: Picture, theme: Theme = LIGHT, *, stem: str) -> str:
    """Return the picture as an SVG element, for a page or a notebook."""
    return svg_without_header(encode(picture, "svg", theme, stem=stem))


def svg_without_header(file: bytes) -> str:
    """Return the SVG element of a file, without its XML declaration and its metadata (which name the maker)."""
    svg = file.decode()
    before, _, rest = svg[svg.index("<svg") :].partition(" <metadata>")
    return before + rest.partition("</metadata>\n")[2] if rest else before
