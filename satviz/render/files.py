"""Pictures as the bytes of files in each of `FORMATS`.

The same picture gives the same bytes each time, and each file holds its words.
"""

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
from ..safe_write import MADE_BY
from .fonts import families
from .formats import DPI, FORMATS, Format, Words
from .pen import Pen

if TYPE_CHECKING:
    from matplotlib.typing import RcKeyType

MAKER = f"{MADE_BY} with matplotlib {matplotlib.__version__}"

_LOCK = RLock()
_STYLE: "dict[RcKeyType, Any]" = {
    "svg.fonttype": "none",
    "font.family": ["sans-serif"],
    # The first font ships with matplotlib; the letters of the others are as wide, for browsers without it.
    "font.sans-serif": ["DejaVu Sans", "Bitstream Vera Sans", "Verdana"],
    "pdf.fonttype": 42,
    "pdf.compression": 6,
    "path.simplify": False,
}


def canvas(size: tuple[float, float], theme: Theme = LIGHT) -> tuple[Figure, Pen]:
    """Return a new Figure of that size in points and a pen on it, without pyplot."""
    fig = Figure(figsize=(size[0] / 72, size[1] / 72), dpi=DPI)
    FigureCanvasAgg(fig)
    fig.set_facecolor(theme.paper)
    ax = fig.add_axes((0, 0, 1, 1))
    pen = Pen(ax, theme)
    ax.set_axis_off()
    return fig, pen


@contextmanager
def styled(more: "dict[RcKeyType, Any] | None" = None) -> Iterator[None]:
    """Give matplotlib the settings of satviz's files, and restore its own ones afterwards.

    matplotlib has one set of settings for the whole process, so only one thread at a time is inside.
    """
    with _LOCK, matplotlib.rc_context({**_STYLE, **(more or {})}), warnings.catch_warnings():
        # `families` has warned of missing letters already, by name
        warnings.filterwarnings("ignore", "Glyph .* missing")
        yield


def encode(picture: Picture, form: str, theme: Theme = LIGHT, *, stem: str = "picture") -> bytes:
    """Return the file of a picture in one of `FORMATS`; `stem` is the beginning of the ids in an SVG."""
    return encode_frames([picture], form, theme, stem=stem)


def encode_frames(pictures: Sequence[Picture], form: str, theme: Theme = LIGHT, *, stem: str = "picture") -> bytes:
    """Return all pictures as one file; only an animated format takes more than one picture."""
    fonts: Sequence[str] = ()
    if _format(form).embeds_fonts:
        fonts = families([text for picture in pictures for text in picture.texts], form)

    def draw_frames() -> Iterator[Figure]:
        """Yield one Figure again and again, with the next picture on it."""
        fig, pen = canvas(pictures[0].size, theme)
        for picture in pictures:
            pen.draw(picture)
            pen.set_fonts(fonts)
            yield fig

    words = [_words(picture.title or picture.sentence, picture.sentence, stem) for picture in pictures]
    return _encode(draw_frames(), form, words)


def encode_figure(make: Callable[[], Figure], form: str, *, stem: str, title: str, sentence: str) -> bytes:
    """Return the file of a matplotlib Figure, which `make` draws under the settings of satviz's files."""
    return _encode((draw() for draw in [make]), form, [_words(title, sentence, stem)])


def _encode(figures: Iterator[Figure], form: str, words: Sequence[Words]) -> bytes:
    """Return the file of these Figures, which are drawn while matplotlib has the settings of satviz's files."""
    with styled({"svg.hashsalt": words[0].stem}):
        return _format(form).encode(figures, words)


def _words(title: str, sentence: str, stem: str) -> Words:
    """Return the words inside a file, the title without control characters."""
    return Words(describe.printable(title), sentence, stem, MAKER)


def _format(name: str) -> Format:
    """Return the format of that name; ValueError lists the names."""
    if name not in FORMATS:
        raise ValueError(f"unknown format {name!r}: choose one of {', '.join(FORMATS)}")
    return FORMATS[name]


def inline_svg(picture: Picture, theme: Theme = LIGHT, *, stem: str) -> str:
    """Return the picture as an SVG element, for a page or a notebook."""
    return bare(encode(picture, "svg", theme, stem=stem))


def bare(file: bytes) -> str:
    """Return the SVG element of an SVG file, without the XML declaration and the metadata, which name the maker."""
    svg = file.decode()
    before, _, rest = svg[svg.index("<svg") :].partition(" <metadata>")
    return before + rest.partition("</metadata>\n")[2] if rest else before
