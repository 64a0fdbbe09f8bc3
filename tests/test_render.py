"""Tests of the matplotlib pen and of the files it writes."""

import copy
import errno
import gc
import io
import pickle
import re
import subprocess
import sys
import warnings
import weakref
import xml.etree.ElementTree as ET
from concurrent.futures import ThreadPoolExecutor
from itertools import combinations
from pathlib import Path

import matplotlib
import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.font_manager import FontManager, FontProperties, findfont
from matplotlib.ft2font import FT2Font
from PIL import Image

import satviz as sv
from satviz.pictures import DARK, LIGHT, Stage, Step, Theme, letters
from satviz.pictures.figures import FIGURES
from satviz.render import fonts
from satviz.render.files import encode, encode_frames, styled
from satviz.render.formats import FORMATS, STILL_FORMATS
from satviz.render.pen import Pen
from satviz.safe_write import MADE_BY, check, write
from satviz.scenes.shape_tools import box

COMMITTED = Path(__file__).parent.parent / "figures"
TRIANGLES = sv.scene("triangles").record()
SVG = "{http://www.w3.org/2000/svg}"
OURS = b"<svg><dc:title>made by satviz"


def axes_of(size=(6.9, 5.3)):
    fig = Figure(figsize=size, dpi=100)
    FigureCanvasAgg(fig)
    return fig.add_axes((0, 0, 1, 1))


def pixels(fig):
    fig.canvas.draw()
    return np.asarray(fig.canvas.buffer_rgba()).copy()


def test_the_pen_draws_every_mark_and_returns_its_artist_by_id():
    for i in range(len(sv.steps(TRIANGLES))):
        picture = sv.picture(TRIANGLES, i)
        artists = Pen(axes_of()).draw(picture)
        assert set(artists) == {mark.id for mark in picture.marks}


def test_labels_stand_where_the_picture_puts_them():
    picture = sv.picture(TRIANGLES, 14)
    artists = Pen(axes_of()).draw(picture)
    for mark in picture.marks:
        if mark.kind == "label":
            assert artists[mark.id].get_text() == mark.text
            assert artists[mark.id].get_position() == pytest.approx(mark.points[0])


def test_a_picture_drawn_over_another_looks_like_one_drawn_afresh():
    ax = axes_of()
    pen = Pen(ax)
    for i in (15, 3, 14, 0, 7):
        pen.draw(sv.picture(TRIANGLES, i))
        again = pixels(ax.figure)
        fresh = axes_of()
        Pen(fresh).draw(sv.picture(TRIANGLES, i))
        assert np.array_equal(again, pixels(fresh.figure)), i


def test_the_pen_reuses_its_artists_for_every_step():
    ax = axes_of()
    pen = Pen(ax)
    most = 0
    for i in range(len(sv.steps(TRIANGLES))):
        pen.draw(sv.picture(TRIANGLES, i))
        most = max(most, len(sv.picture(TRIANGLES, i).texts))
    assert len(ax.collections) == 3 and len(ax.texts) == most and not ax.lines and not ax.patches


def test_colours_by_role_reach_the_canvas():
    for theme in (LIGHT, DARK):
        ax = axes_of()
        Pen(ax, theme).draw(sv.picture(TRIANGLES, Step(Stage.GAP, 1)))
        seen = {tuple(p) for p in pixels(ax.figure)[::1, ::1, :3].reshape(-1, 3)}
        for colour in (theme.paper, theme.roles["A"], theme.roles["B"], theme.roles["gap"]):
            assert tuple(int(colour[i : i + 2], 16) for i in (1, 3, 5)) in seen, colour


def test_draw_gives_a_figure_or_draws_on_given_axes():
    assert isinstance(sv.draw(TRIANGLES, 3), Figure)
    fig = Figure(figsize=(8, 4))
    left, right = fig.subplots(1, 2)
    artists = sv.draw(TRIANGLES, 14, ax=left)
    sv.draw(TRIANGLES, 15, ax=right, theme="dark")
    assert "A.outline" in artists and len(left.collections) == 3
    with pytest.raises(ValueError, match="unknown theme"):
        sv.draw(TRIANGLES, theme="sepia")


def test_drawing_needs_no_pyplot_and_changes_no_setting():
    code = (
        "import sys, matplotlib as m; before = m.rcParams.copy()\n"
        "import satviz as sv; t = sv.scene('aabb').record(); sv.draw(t, 3)\n"
        "from satviz.render.files import encode; from satviz.render.formats import STILL_FORMATS\n"
        "for form in STILL_FORMATS: encode(sv.picture(t), form)\n"
        "assert 'matplotlib.pyplot' not in sys.modules and m.rcParams.copy() == before"
    )
    subprocess.run([sys.executable, "-c", code], check=True)


@pytest.mark.parametrize("form", STILL_FORMATS)
@pytest.mark.slow
def test_files_are_the_same_bytes_in_another_process_with_another_hash_seed(form, tmp_path):
    code = (
        "import sys, satviz as sv; from satviz.render.files import encode\n"
        f"sys.stdout.buffer.write(encode(sv.picture(sv.scene('concave').record()), {form!r}, stem='x'))"
    )
    runs = [
        subprocess.run(
            [sys.executable, "-c", code], env={"PYTHONHASHSEED": seed, "PATH": ""}, check=True, capture_output=True
        ).stdout
        for seed in ("1", "77")
    ]
    assert runs[0] == runs[1] and len(runs[0]) > 1000


def test_every_format_carries_its_words_and_its_maker():
    picture = sv.picture(TRIANGLES, Step(Stage.GAP, 1), title="A gap <&> a line")
    svg = encode(picture, "svg").decode()
    root = ET.fromstring(svg)
    assert root.find(f"{SVG}title").text == "A gap <&> a line" and root.find(f"{SVG}desc").text == picture.sentence
    assert root.get("role") == "img" and root.get("aria-labelledby").split() == ["picture-title", "picture-desc"]
    info = Image.open(io.BytesIO(encode(picture, "png"))).info
    assert info["Title"] == "A gap <&> a line" and info["Description"] == picture.sentence
    pdf = encode(picture, "pdf")
    assert b"/Title (A gap <&> a line)" in pdf
    for data in (svg.encode(), encode(picture, "png"), pdf, encode_frames([picture], "gif")):
        assert MADE_BY.encode() in data


def test_an_svg_keeps_text_as_text_and_labels_as_text_only():
    odd = sv.Polygon([(0, 0), (2, 0), (0, 2)], labels=["$x^2$", "<script>&", "\x00日本"])
    root = ET.fromstring(encode(sv.picture(sv.record(odd, box(3, 3, 4, 4)), 0), "svg").decode())
    texts = {t.text for t in root.iter(f"{SVG}text")}
    assert {"$x^2$", "<script>&", "\ufffd日本", "A", "B"} <= texts
    assert not list(root.iter(f"{SVG}script"))


def labelled(label):
    return sv.picture(sv.record(sv.Polygon([(0, 0), (2, 0), (0, 2)], labels=[label, "q", "r"]), box(3, 3, 4, 4)), 0)


@pytest.mark.parametrize("form", ["png", "pdf"])
def test_a_warning_names_a_letter_that_no_font_has(form, monkeypatch):
    monkeypatch.setattr(fonts, "fontManager", FontManager.__new__(FontManager))
    monkeypatch.setattr(fonts.fontManager, "ttflist", [], raising=False)
    fonts._family_with.cache_clear()
    with pytest.warns(UserWarning, match=f"no font here has 日, 本.*{form.upper()}"):
        encode(labelled("日本"), form)
    fonts._family_with.cache_clear()


def test_a_letter_that_dejavu_lacks_comes_from_a_font_that_has_it():
    """The font is one that matplotlib brings along, so that the result is the same everywhere."""
    there = FT2Font(findfont("STIXGeneral")).get_charmap()
    rare = next(chr(c) for c in sorted(there) if letters.missing_letters(chr(c)) and fonts._family_with(chr(c)))
    family = fonts._family_with(rare)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert family.replace(" ", "").encode() in encode(labelled(rare), "pdf").replace(b"-", b"")
        encode(labelled(rare), "png")
    assert family.encode() not in encode(labelled(rare), "svg")  # the reader's own font shows it


def test_a_letter_of_a_font_without_a_bold_one_prints_nothing(caplog):
    with styled():
        findfont(FontProperties(family="STIXSizeOneSym", weight=900), rebuild_if_missing=False)
    assert not caplog.records
    findfont(FontProperties(family="STIXSizeTwoSym", weight=900), rebuild_if_missing=False)
    assert "font weight" in caplog.text  # and elsewhere matplotlib still says so


def test_a_gif_is_the_whole_run_and_the_same_each_time():
    pictures = [sv.picture(TRIANGLES, i) for i in (0, 3, 7, 15)]
    data = encode_frames(pictures, "gif")
    assert data == encode_frames(pictures, "gif")
    image = Image.open(io.BytesIO(data))
    assert image.n_frames == 4 and image.info["loop"] == 0
    assert pictures[-1].sentence.encode() in data


def test_a_frame_with_more_words_is_shown_longer():
    pictures = [sv.picture(TRIANGLES, i) for i in (0, 7, 15)]
    image = Image.open(io.BytesIO(encode_frames(pictures, "gif")))
    for i, picture in enumerate(pictures):
        image.seek(i)
        assert image.info["duration"] >= 500 + 5 * len(picture.sentence)


def test_a_file_somebody_else_made_is_left_alone(tmp_path):
    path = tmp_path / "a.svg"
    path.write_text("<svg/>")
    with pytest.raises(FileExistsError, match="--force"):
        write(path, b"made by satviz")
    assert path.read_text() == "<svg/>"
    path.write_text("notes on files made by satviz")  # saying so is not enough
    with pytest.raises(FileExistsError):
        check(path)
    ours = encode(sv.picture(TRIANGLES, 0), "svg")
    write(path, ours, force=True)
    write(path, ours)
    assert path.read_bytes() == ours
    for form in FORMATS:
        write(tmp_path / f"a.{form}", encode(sv.picture(TRIANGLES, 0), form), force=form == "svg")
        check(tmp_path / f"a.{form}")
    with pytest.raises(FileExistsError):
        check(tmp_path)


def test_an_interrupted_write_leaves_nothing(tmp_path, monkeypatch):
    def stop(*_):
        raise KeyboardInterrupt

    monkeypatch.setattr("os.replace", stop)
    with pytest.raises(KeyboardInterrupt):
        write(tmp_path / "a.svg", b"data")
    assert list(tmp_path.iterdir()) == []


def test_a_full_disk_leaves_the_old_file_whole_and_names_the_file(tmp_path, monkeypatch):
    path = tmp_path / "a.svg"
    write(path, OURS)

    def full(*_):
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr("os.replace", full)
    with pytest.raises(OSError, match="No space left") as failed:
        write(path, OURS * 2)
    assert failed.value.filename == str(path) and path.read_bytes() == OURS and list(tmp_path.iterdir()) == [path]


@pytest.mark.parametrize("there", ["a stranger's file", "our file", "nothing"])
def test_nothing_is_written_through_a_link(tmp_path, there):
    target, path = tmp_path / "elsewhere.svg", tmp_path / "a.svg"
    if there != "nothing":
        target.write_bytes(OURS if there == "our file" else b"mine")
    path.symlink_to(target)
    before = target.read_bytes() if target.exists() else None
    with pytest.raises(FileExistsError, match="is a symbolic link"):
        write(path, OURS)
    write(path, OURS, force=True)
    assert not path.is_symlink() and path.read_bytes() == OURS
    assert (target.read_bytes() if target.exists() else None) == before


@pytest.mark.parametrize("end", [*FORMATS, "html", "csv", "json", "md", "txt"])
def test_a_file_that_only_mentions_satviz_is_not_overwritten(tmp_path, end):
    path = tmp_path / f"notes.{end}"
    path.write_text("my notes on files made by satviz, and more\n")
    with pytest.raises(FileExistsError, match="--force"):
        write(path, b"")


def test_a_folder_is_not_overwritten_even_with_force(tmp_path):
    (tmp_path / "a.svg").mkdir()
    with pytest.raises(FileExistsError, match="is a folder"):
        write(tmp_path / "a.svg", OURS, force=True)
    (tmp_path / "file").write_text("")
    (tmp_path / "link").symlink_to(tmp_path / "nowhere")
    for name in ("file", "link"):
        with pytest.raises(NotADirectoryError, match="not a folder"):
            write(tmp_path / name / "a.svg", OURS)


def words_and_numbers(svg):
    """Return the texts of a picture and the points of its paths, in points of the canvas."""
    root = ET.fromstring(svg)
    texts = [t.text for t in root.iter(f"{SVG}text")]
    numbers = []
    for group in root.iter(f"{SVG}g"):
        if (group.get("id") or "").startswith("PathCollection"):
            for path in group.iter(f"{SVG}path"):
                numbers += [float(n) for n in re.findall(r"-?\d+\.?\d*(?:e-?\d+)?", path.get("d"))]
    return [*texts, root.find(f"{SVG}title").text, root.find(f"{SVG}desc").text], numbers


@pytest.mark.parametrize("theme", [LIGHT, DARK], ids=["light", "dark"])
@pytest.mark.parametrize("figure", FIGURES, ids=[f.stem for f in FIGURES])
def test_the_committed_figures_are_what_the_code_draws(figure, theme: Theme):
    stem = figure.stem + ("" if theme is LIGHT else "-dark")
    committed = (COMMITTED / f"{stem}.svg").read_text(encoding="utf-8")
    drawn = encode(figure.picture(), "svg", theme, stem=stem).decode()
    if f"with matplotlib {matplotlib.__version__}<" in committed:
        assert drawn == committed
    words, numbers = words_and_numbers(drawn)
    committed_words, committed_numbers = words_and_numbers(committed)
    assert words == committed_words and len(numbers) > 20
    assert numbers == pytest.approx(committed_numbers, abs=0.05)


CHARTS = "speed-against-accuracy", "decision-table", "pose-error", "bench", "frames"


def test_there_are_twenty_figures_and_beside_them_only_the_charts_of_the_readme_with_their_numbers():
    files = {f"{f.stem}{end}.svg" for f in FIGURES for end in ("", "-dark")}
    charts = {f"{stem}{end}.svg" for stem in CHARTS for end in ("", "-dark")} | {"bench.json", "frames.json"}
    assert len(FIGURES) == 20 and {p.name for p in COMMITTED.iterdir()} == files | charts


@pytest.mark.parametrize(
    "what",
    [
        TRIANGLES,
        sv.picture(TRIANGLES, 3),
        sv.scene("concave"),
        sv.Polygon([(0, 0), (1, 0), (0, 1)], ["<b>", "$y$", ""]),
        sv.Circle((0, 0), 1),
    ],
    ids=["trace", "picture", "scene", "polygon", "circle"],
)
def test_shapes_scenes_and_traces_have_a_display_in_a_notebook(what):
    shown = what._repr_mimebundle_()
    root = ET.fromstring(shown["image/svg+xml"])
    assert root.tag == f"{SVG}svg" and shown["text/plain"]
    assert "<b>" not in shown["image/svg+xml"]


@pytest.mark.parametrize("name", ["triangles", "concave", "unit-normals"])
def test_a_run_shows_its_table_in_a_notebook(name):
    trace = sv.scene(name).record()
    table = ET.fromstring(trace._repr_mimebundle_()["text/html"].partition("</svg>")[2].strip().partition("\n<p>")[0])
    rows = [["".join(cell.itertext()) for cell in row] for row in table.iter("tr")]
    assert rows[0] == ["", "axis", "direction", *trace.names, "gap"]
    tests = [test for run in trace.pairs or [trace] for test in run.tests]
    assert len([row for row in rows[1:] if row[0].isdigit()]) == len(tests)
    words = trace._repr_mimebundle_()["text/plain"].replace("-", "\u2212")
    for row in rows[1:]:
        assert row[1 if len(row) > 1 else 0].replace("-", "\u2212") in words


def test_markup_in_a_table_is_shown_as_text():
    a = sv.Polygon([(0, 0), (1, 0), (0, 1)], ["<b>x</b>", "y", "z"])
    assert "<b>" not in sv.record(a, sv.Circle((3, 3), 1))._repr_mimebundle_()["text/html"]


def test_a_scene_that_cannot_be_drawn_still_shows_its_text():
    far = sv.record(box(1e15, 0, 1e15 + 1, 1), box(1e15 + 2, 0, 1e15 + 3, 1))
    shown = far._repr_mimebundle_()
    assert set(shown) == {"text/plain", "text/html"} and "cannot be drawn" in shown["text/html"]


def test_drawing_again_on_given_axes_takes_the_place_of_the_first_picture():
    fig = Figure(facecolor="#123456")
    ax = fig.subplots()
    for theme in ("light", "light", "dark"):
        sv.draw(TRIANGLES, 14, ax=ax, theme=theme)
        assert len(ax.collections) == 3
    assert matplotlib.colors.to_hex(fig.get_facecolor()) == "#123456"


def test_axes_that_were_drawn_on_can_be_freed():
    figures = []
    for _ in range(10):
        fig = Figure()
        sv.draw(TRIANGLES, 14, ax=fig.subplots())
        sv.draw(TRIANGLES, 15, ax=fig.axes[0], theme="dark")
        figures += [weakref.ref(fig), weakref.ref(fig.axes[0])]
    del fig
    gc.collect()
    assert not [ref for ref in figures if ref() is not None]


def test_axes_that_were_cleared_are_drawn_on_afresh():
    ax, fresh = axes_of(), axes_of()
    sv.draw(TRIANGLES, 3, ax=ax)
    ax.clear()
    for axes in (ax, fresh):
        sv.draw(TRIANGLES, 14, ax=axes)
    assert np.array_equal(pixels(ax.figure), pixels(fresh.figure))


def test_a_figure_that_was_drawn_on_can_be_copied_and_drawn_on_again():
    fig = Figure()
    sv.draw(TRIANGLES, 14, ax=fig.subplots())
    for again in (pickle.loads(pickle.dumps(fig)), copy.deepcopy(fig)):
        sv.draw(TRIANGLES, 15, ax=again.axes[0])
        assert len(again.axes[0].collections) == 3


def test_ax_must_be_matplotlib_axes():
    with pytest.raises(TypeError, match="ax is a Figure: pass matplotlib Axes"):
        sv.draw(TRIANGLES, ax=Figure())


@pytest.mark.parametrize("shape", [(2, 2), (2, 3), (4, 1), (1, 6)])
def test_a_picture_on_small_axes_has_sensible_limits(shape):
    ax = np.ravel(Figure().subplots(*shape))[0]
    sv.draw(TRIANGLES, 14, ax=ax)
    (x0, x1), (y0, y1) = ax.get_xlim(), ax.get_ylim()
    assert -40 < x0 < 0 and 8 < x1 < 45 and -20 < y0 < 1 and 5 < y1 < 25


@pytest.mark.parametrize("shape", [(1, 1), (2, 2), (2, 3)])
def test_no_label_runs_over_another_on_small_axes(shape):
    fig = Figure()
    FigureCanvasAgg(fig)
    ax = np.ravel(fig.subplots(*shape))[0]
    sv.draw(TRIANGLES, 14, ax=ax)
    fig.canvas.draw()
    boxes = [text.get_window_extent() for text in ax.texts if text.get_visible()]
    assert not [(p, q) for p, q in combinations(boxes, 2) if p.shrunk(0.98, 0.9).overlaps(q.shrunk(0.98, 0.9))]


def test_threads_draw_the_same_bytes_and_leave_the_settings_alone():
    pictures = [sv.picture(TRIANGLES, i) for i in range(8)]
    before = matplotlib.rcParams.copy()
    with ThreadPoolExecutor(4) as pool:
        together = list(pool.map(lambda i: encode(pictures[i], "svg", stem=str(i)), range(8)))
    assert together == [encode(pictures[i], "svg", stem=str(i)) for i in range(8)]
    assert matplotlib.rcParams.copy() == before


def test_a_title_with_control_characters_gives_a_valid_svg():
    ET.fromstring(encode(sv.picture(TRIANGLES, 0, title="a\x00b\ud800"), "svg").decode())
