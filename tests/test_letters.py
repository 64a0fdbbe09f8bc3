"""The tables of letter widths are the font's own, and labels are as wide as the pen draws them."""

import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from refresh_widths import FACES, TABLES, table, widths

from satviz.pictures import letters, theme
from satviz.pictures.letters import text_size
from satviz.render.files import styled

WORDS = ["A", "B", "overlapping", "this axis shows no gap", "B [-0.832, 4.715]", "gap +1.213", "Ångström ≤ 45°, Ω → ∞"]


@pytest.mark.parametrize("face", FACES)
def test_the_committed_tables_are_made_from_the_font(face):
    """If they are not, run python tests/refresh_widths.py."""
    assert (TABLES / f"{face}.txt").read_text(encoding="ascii") == table(face)
    assert {path.stem for path in TABLES.iterdir()} == set(FACES)


@pytest.mark.parametrize("face", FACES)
def test_every_letter_is_as_wide_as_in_the_font_and_a_missing_one_a_full_square(face):
    known = widths(face)
    bold = face.endswith("Bold")
    for code in range(0x20000):
        assert letters.text_width(chr(code), bold=bold) == known.get(code, 2048) / 2048, hex(code)


def test_the_tables_stay_small():
    assert sum(path.stat().st_size for path in TABLES.iterdir()) < 60_000


@pytest.mark.parametrize("weight", ["plain", "title"])
@pytest.mark.parametrize("words", WORDS)
def test_a_label_has_the_size_that_the_pen_draws(words, weight):
    with styled():
        figure = Figure(figsize=(6, 1), dpi=720)  # fine enough that no letter snaps to the dots
        FigureCanvasAgg(figure)
        look = theme.style_of("label", "ink", weight)
        text = figure.text(0, 0, words, size=look.size, weight="bold" if look.bold else "normal")
        drawn = text.get_window_extent().width / 10
    assert text_size(words, weight)[0] == pytest.approx(drawn, rel=0.03, abs=1.0)
