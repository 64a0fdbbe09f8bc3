"""The article's twenty figures, each a scene, a test in its trace, and how far the test is drawn.

Where we leave the article: figure 4 names the axis and the line by their right
names, figure 5 shows the turned pair its caption does not, figure 12's overlap is
one of two ranges and no collision, and figure 15 is SAT too, with one axis.
"""

from collections.abc import Callable
from functools import cache
from typing import Any, NamedTuple

from ..engine.trace import Trace
from ..scenes.named import scene
from . import views
from .marks import Picture
from .stages import Stage, Step, picture


class Figure(NamedTuple):
    """A numbered figure: its file name, its title, the scene it is drawn from, and how."""

    number: int
    name: str
    title: str
    scene: str
    draw: Callable[[Trace, str], Picture]

    @property
    def stem(self) -> str:
        """The file name without its ending: "01-aabb-apart"."""
        return f"{self.number:02}-{self.name}"

    def picture(self) -> Picture:
        """The picture, every number of it from the recorded trace."""
        return self.draw(recorded(self.scene), self.title)


@cache
def recorded(name: str) -> Trace:
    """A built-in scene's trace, recorded once for all its figures."""
    return scene(name).record()


def at(stage: Stage, test: int) -> Callable[[Trace, str], Picture]:
    """One stage of one test."""
    return lambda trace, title: picture(trace, Step(stage, test), title=title, by_itself=True)


def view(draw: Callable[..., Picture], **options: Any) -> Callable[[Trace, str], Picture]:
    """A picture that is no single step."""
    return lambda trace, title: draw(trace, title=title, **options)


_ALL = (
    ("aabb-apart", "Two upright boxes and the world axes", "aabb", view(views.world)),
    ("aabb-project-y", "Projected on y, the ranges overlap", "aabb", at(Stage.GAP, 0)),
    ("aabb-project-x", "Projected on x, a gap: no collision", "aabb", at(Stage.GAP, 1)),
    ("aabb-separating-line", "The separating axis and the separating line", "aabb", view(views.separation)),
    ("aabb-rotated-fails", "Turned boxes: both world axes overlap, yet apart", "aabb-rotated", view(views.at_once)),
    ("sat-normals", "Every edge has a normal", "triangles", view(views.normals)),
    ("sat-edge", "One edge of B", "triangles", at(Stage.EDGE, 0)),
    ("sat-normal", "The normal of that edge", "triangles", at(Stage.NORMAL, 0)),
    ("sat-axis-apart", "The normal moved clear: an axis", "triangles", at(Stage.AXIS, 0)),
    ("sat-project-b", "B's vertices dropped onto the axis", "triangles", at(Stage.DROPS, 0)),
    ("sat-range-b", "B's range on the axis", "triangles", at(Stage.RANGE, 0)),
    ("sat-ranges-overlap", "The two ranges overlap on this axis", "triangles", at(Stage.GAP, 0)),
    ("sat-next-normal", "The next normal and its axis", "triangles", at(Stage.AXIS, 1)),
    ("sat-ranges-gap", "A gap: this axis separates", "triangles", at(Stage.GAP, 1)),
    ("circle-circle", "Two circles: one axis, through the centers", "circles", view(views.radii)),
    ("circle-polygon", "A triangle's normals as axes", "circle-polygon", view(views.each_axis)),
    (
        "circle-parts",
        "A circle: its center and radius",
        "circle-polygon",
        view(views.circle_alone, number=1, role="B", extremes=False),
    ),
    (
        "circle-extremes",
        "The circle's extremes along an axis",
        "circle-polygon",
        view(views.circle_alone, number=1, role="B", extremes=True),
    ),
    ("concave-fails", "No axis tested separates them, yet they are apart", "concave-outline", view(views.failed_axes)),
    ("concave-parts", "Split into convex parts, each is apart from A", "concave", view(views.convex_parts)),
)
FIGURES = tuple(Figure(i, *row) for i, row in enumerate(_ALL, 1))
