"""The article's twenty figures: for each its scene, and the step or view that draws it.

They differ from the article in four places: figure 4 gives the axis and the line their
right names, figure 5 shows the turned pair that the article's caption only mentions,
figure 12 calls the overlap of two ranges no collision, and figure 15 runs SAT with one axis.
"""

from collections.abc import Callable
from functools import cache
from typing import Any, NamedTuple

from ..engine.trace import Trace
from ..scenes.named import scene
from . import views
from .layout import NARROW_SIZE_PT
from .marks import Picture
from .stages import Stage, Step
from .step_picture import picture


class Figure(NamedTuple):
    """A numbered figure: its file name, its title, the name of its scene, and the function that draws it."""

    number: int
    name: str
    title: str
    scene: str
    draw: Callable[[Trace, str], Picture]

    @property
    def stem(self) -> str:
        """Return the file name without its suffix: "01-aabb-apart"."""
        return f"{self.number:02}-{self.name}"

    def picture(self) -> Picture:
        """Draw the figure; every number comes from the recorded trace."""
        return self.draw(recorded_trace(self.scene), self.title)


@cache
def recorded_trace(name: str) -> Trace:
    """Return the trace of a built-in scene, recorded once for all its figures."""
    return scene(name).record()


def from_step(stage: Stage, test: int) -> Callable[[Trace, str], Picture]:
    """Return a function of (trace, title) that draws one stage of the test with the index `test`."""
    return lambda trace, title: picture(trace, Step(stage, test), title=title, largest=NARROW_SIZE_PT)


def from_view(draw: Callable[..., Picture], **options: Any) -> Callable[[Trace, str], Picture]:
    """Return a function of (trace, title) that calls `draw`, a function of `views`, with these options."""
    return lambda trace, title: draw(trace, title=title, **options)


_FIGURE_ROWS = (
    ("aabb-apart", "Two upright boxes and the world axes", "aabb", from_view(views.world_axes)),
    ("aabb-project-y", "Projected on y, the ranges overlap", "aabb", from_step(Stage.GAP, 0)),
    ("aabb-project-x", "Projected on x, a gap: no collision", "aabb", from_step(Stage.GAP, 1)),
    ("aabb-separating-line", "The separating axis and the separating line", "aabb", from_view(views.separation)),
    (
        "aabb-rotated-fails",
        "Turned boxes: both world axes overlap, yet apart",
        "aabb-rotated",
        from_view(views.all_tests),
    ),
    ("sat-normals", "Every edge has a normal", "triangles", from_view(views.all_normals)),
    ("sat-edge", "One edge of B", "triangles", from_step(Stage.EDGE, 0)),
    ("sat-normal", "The normal of that edge", "triangles", from_view(views.quarter_turn, number=0)),
    ("sat-axis-apart", "The normal moved clear: an axis", "triangles", from_step(Stage.AXIS, 0)),
    ("sat-project-b", "B's vertices dropped onto the axis", "triangles", from_step(Stage.DROPS, 0)),
    ("sat-range-b", "B's range on the axis", "triangles", from_step(Stage.RANGE, 0)),
    ("sat-ranges-overlap", "The two ranges overlap on this axis", "triangles", from_step(Stage.GAP, 0)),
    ("sat-next-normal", "The next normal and its axis", "triangles", from_step(Stage.AXIS, 1)),
    ("sat-ranges-gap", "A gap: this axis separates", "triangles", from_step(Stage.GAP, 1)),
    ("circle-circle", "Two circles: one axis, through the centers", "circles", from_view(views.radii)),
    ("circle-polygon", "A triangle's normals as axes", "circle-polygon", from_view(views.panels_of_tests)),
    (
        "circle-parts",
        "A circle: its center and radius",
        "circle-polygon",
        from_view(views.single_circle, number=1, role="B", extremes=False),
    ),
    (
        "circle-extremes",
        "The circle's extremes along an axis",
        "circle-polygon",
        from_view(views.single_circle, number=1, role="B", extremes=True),
    ),
    (
        "concave-fails",
        "No axis tested separates them, yet they are apart",
        "concave-outline",
        from_view(views.failed_axes),
    ),
    ("concave-parts", "Split into convex parts, each is apart from A", "concave", from_view(views.convex_parts)),
)
FIGURES = tuple(Figure(i, *row) for i, row in enumerate(_FIGURE_ROWS, 1))
STRIP_NUMBERS = range(6, 15)


def _strip(trace: Trace, title: str) -> Picture:
    """Draw the figures of the article's pair of triangles as one picture of small multiples, in their order."""
    figures = [figure for figure in FIGURES if figure.number in STRIP_NUMBERS]
    return views.strip([(f"{f.number} {f.title}", f.draw(trace, "")) for f in figures], title=title)


STRIP = Figure(21, "sat-strip", "SAT on two triangles, step by step", "triangles", _strip)
"""Not one of the article's figures: figures 6 to 14 in one picture, made only where it is asked for."""
