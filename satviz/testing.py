"""Assertions for tests about shapes: a failure shows the sentence, the data, and the path of a picture."""

import os
import tempfile
from collections.abc import Callable, Iterable
from getpass import getuser
from hashlib import sha256
from pathlib import Path
from typing import Any

from . import safe_write
from .checking.answers import HIT, RELATION, Rules, Truth, UnreadableAnswer, in_words, is_right, plain, read
from .checking.asking import form_named
from .checking.forms import Form, pasteable
from .engine.geometry import Relation
from .engine.relate import relate
from .engine.shapes import Circle, Polygon, Shape
from .engine.trace import record
from .scenes.scenefile import Scene

__all__ = ["assert_apart", "assert_overlapping", "assert_same_relation", "assert_touching"]


def assert_apart(a: Any, b: Any) -> None:
    """Assert that two shapes share no point.

    `a`, `b`: a Polygon, a Circle, or the vertices of a polygon.  The AssertionError shows the sentence of the test,
    both shapes as code, and the path of an SVG in pytest's temporary folder.
    """
    _assert_relation(a, b, Relation.APART)


def assert_touching(a: Any, b: Any) -> None:
    """Assert that two shapes touch, exactly; see `assert_apart`."""
    _assert_relation(a, b, Relation.TOUCHING)


def assert_overlapping(a: Any, b: Any) -> None:
    """Assert that the interiors of two shapes share a point; see `assert_apart`."""
    _assert_relation(a, b, Relation.OVERLAPPING)


def assert_same_relation(
    fn: Callable[[Any, Any], Any],
    pairs: Iterable[tuple[Any, Any]],
    *,
    form: str | Form = "points",
    touching: str = "hit",
) -> None:
    """Assert that a function gives the exact relation, or the exact verdict, for each pair of shapes.

    `fn` is called as by `sv.check`, with shapes in the same `form`; it returns True or False, or a relation.
    `touching`: the right verdict for shapes that touch: "hit", "miss" or "either".
    """
    make = form_named(form)
    for i, (a, b) in enumerate(pairs):
        a, b = _shape(a), _shape(b)
        value = plain(fn(make(a), make(b)))
        kind = HIT if isinstance(value, bool) else RELATION
        truth = Truth(relate(a, b), None)
        try:
            answer = read(value, kind)
        except UnreadableAnswer as error:
            raise _failure(a, b, f"pair {i}: the function {error}") from None
        if not is_right(answer, a, b, truth, Rules(kind, touching)):
            raise _failure(a, b, f"pair {i}: the function says {in_words(answer, kind)}")


def _shape(what: Any) -> Shape:
    """Return a shape as it is, and vertices as a Polygon."""
    return what if isinstance(what, Polygon | Circle) else Polygon(what)


def _assert_relation(a: Any, b: Any, expected: Relation) -> None:
    """Raise AssertionError unless the shapes have the expected relation."""
    a, b = _shape(a), _shape(b)
    if relate(a, b) is not expected:
        raise _failure(a, b, f"the shapes are not {expected}")


def _failure(a: Shape, b: Shape, why: str) -> AssertionError:
    """Return the error of a failed assertion: why, the sentence, the data, and where the picture is."""
    lines = [why, record(a, b).sentence, f"a = {pasteable(a)}", f"b = {pasteable(b)}"]
    try:
        lines.append(f"picture: {_picture_file(a, b)}")
    except (ImportError, OSError, ValueError) as error:
        lines.append(f"no picture: {error}")
    return AssertionError("\n".join(lines))


def _picture_file(a: Shape, b: Shape) -> Path:
    """Write the picture of two shapes as SVG and return its path; its name is made from the shapes."""
    from .pictures import picture
    from .render.files import encode

    scene = Scene("scene", a, b)
    stem = f"satviz-{sha256(scene.to_json().encode()).hexdigest()[:12]}"
    path = _temporary_folder() / f"{stem}.svg"
    safe_write.write(path, encode(picture(scene), "svg", stem=stem), force=True)
    return path


def _temporary_folder() -> Path:
    """Return pytest's temporary folder of this run, or outside of pytest a new folder."""
    root = Path(os.environ.get("PYTEST_DEBUG_TEMPROOT") or tempfile.gettempdir())
    folder = root / f"pytest-of-{getuser()}" / "pytest-current"
    if "PYTEST_CURRENT_TEST" in os.environ and folder.is_dir():
        return folder.resolve()
    return Path(tempfile.mkdtemp(prefix="satviz-"))
