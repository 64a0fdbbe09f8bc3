"""Pictures as the bytes of files: SVG, PNG, PDF and GIF; the same each time, each with its words inside."""

import io
import warnings
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from threading import RLock
from typing import TYPE_CHECKING, Any
from xml.sax.saxutils import escape

import matplotlib
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from ..engine import describe
from ..pictures import LIGHT, Picture, Theme
from ..pictures.caption import reading_time_ms
from ..safe_write import MADE_BY
from .fonts import families
from .pen import Pen

if TYPE_CHECKING:
    from matplotlib.typing import RcKeyType

MAKER = f"{MADE_BY} with matplotlib {matplotlib.__version__}"
FORMATS = ("svg", "png", "pdf")
DPI = 144  # of PNG and GIF: twice the canvas's points
LAST = 2000  # milliseconds more that the end of a GIF stays

_LOCK = RLock()
_STYLE: "dict[RcKeyType, Any]" = {
    "svg.fonttype": "none",
    "font.family": ["sans-serif"],
    # the first ships with matplotlib; the others have its widths, for browsers without it
    "font.sans-serif": ["DejaVu Sans", "Bitstream Vera Sans", "Verdana"],
    "pdf.fonttype": 42,
    "pdf.compression": 6,
    "path.simplify": False,
}


def canvas(size: tuple[float, float], theme: Theme = LIGHT) -> tuple[Figure, Pen]:
    """A Figure of that size in points and a pen on it (no pyplot, nothing global)."""
    fig = Figure(figsize=(size[0] / 72, size[1] / 72), dpi=DPI)
    FigureCanvasAgg(fig)
    fig.set_facecolor(theme.paper)
    ax = fig.add_axes((0, 0, 1, 1))
    pen = Pen(ax, theme)
    ax.set_axis_off()
    return fig, pen


@contextmanager
def styled(more: "dict[RcKeyType, Any] | None" = None) -> Iterator[None]:
    """matplotlib's settings are the whole process's: one thread at a time changes and restores them."""
    with _LOCK, matplotlib.rc_context({**_STYLE, **(more or {})}), warnings.catch_warnings():
        # said once, by name, before drawing
        warnings.filterwarnings("ignore", "Glyph .* missing")
        yield


def encode(picture: Picture, form: str, theme: Theme = LIGHT, *, stem: str = "picture") -> bytes:
    """The file of a picture: form "svg", "png" or "pdf"; `stem` seeds the ids in an SVG."""

    fonts = [] if form == "svg" else families(picture.texts, form)

    def drawn() -> Figure:
        fig, pen = canvas(picture.size, theme)
        pen.draw(picture)
        pen.write_in(fonts)
        return fig

    return encode_figure(drawn, form, stem=stem, title=picture.title or picture.sentence, sentence=picture.sentence)


def encode_figure(drawn: Callable[[], Figure], form: str, *, stem: str, title: str, sentence: str) -> bytes:
    """The file of a matplotlib Figure, with its words inside; `drawn` makes it under the files' own settings."""
    title = describe.printable(title)
    out = io.BytesIO()
    with styled({"svg.hashsalt": stem}):
        fig = drawn()
        if form == "png":
            words = {"Title": title, "Description": sentence, "Software": MAKER}
            fig.savefig(out, format="png", dpi=DPI, metadata=words)
        elif form == "pdf":
            about = {"Title": title, "Subject": sentence, "Creator": MAKER, "CreationDate": None}
            fig.savefig(out, format="pdf", metadata=about)
        elif form == "svg":
            fig.savefig(out, format="svg", metadata={"Title": title, "Creator": MAKER, "Date": None})
            return _described(out.getvalue().decode(), stem, title, sentence).encode()
        else:
            raise ValueError(f"unknown format {form!r}: choose one of {', '.join(FORMATS)}")
    return out.getvalue()


def inline_svg(picture: Picture, theme: Theme = LIGHT, *, stem: str) -> str:
    """The picture as an SVG element, for a page or a notebook."""
    return bare(encode(picture, "svg", theme, stem=stem))


def bare(file: bytes) -> str:
    """The SVG element of a file alone, without the XML head and the note of its maker."""
    svg = file.decode()
    before, _, rest = svg[svg.index("<svg") :].partition(" <metadata>")
    return before + rest.partition("</metadata>\n")[2] if rest else before


def _described(svg: str, stem: str, title: str, sentence: str) -> str:
    """The SVG with a description after its title, and both named as what a screen reader says."""
    head = f"<title>{escape(title)}</title>"
    before, found, after = svg.partition(head)
    if not found:
        raise AssertionError("matplotlib wrote no title")
    ids = f"{stem}-title", f"{stem}-desc"
    before = before.replace("<svg ", f'<svg role="img" aria-labelledby="{ids[0]} {ids[1]}" ', 1)
    words = f'<title id="{ids[0]}">{escape(title)}</title>\n <desc id="{ids[1]}">{escape(sentence)}</desc>'
    return "\n".join(line.rstrip() for line in f"{before}{words}{after}".split("\n"))


def animate(pictures: Sequence[Picture], theme: Theme = LIGHT) -> bytes:
    """All pictures as one GIF, each as long as its words take to read."""
    from PIL import Image

    frames = []
    fonts = families([text for picture in pictures for text in picture.texts], "gif")
    with styled():
        fig, pen = canvas(pictures[0].size, theme)
        agg: Any = fig.canvas  # matplotlib gives Agg's own methods no types
        for picture in pictures:
            pen.draw(picture)
            pen.write_in(fonts)
            agg.draw()
            size = agg.get_width_height()
            frame = Image.frombuffer("RGBA", size, agg.buffer_rgba(), "raw", "RGBA", 0, 1)
            frames.append(frame.convert("RGB").quantize(128, dither=Image.Dither.NONE))
    out = io.BytesIO()
    times = [reading_time_ms(picture.sentence) for picture in pictures]
    times[-1] += LAST
    comment = f"{MADE_BY}. {pictures[-1].sentence}".encode()
    frames[0].save(
        out, "GIF", save_all=True, append_images=frames[1:], duration=times, loop=0, comment=comment, optimize=False
    )
    return out.getvalue()
