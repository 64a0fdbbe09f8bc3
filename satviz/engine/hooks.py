"""The one door upward: what values of the engine ask of the floors above, when they are asked and not before."""

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .trace import Trace


def bundle(what: Any) -> dict[str, str]:
    """What a notebook shows of a shape, a scene, a trace or a picture: its text and its picture."""
    from ..render import notebook

    return notebook.bundle(what)


def to_json(trace: "Trace", indent: int | None) -> str:
    """A trace as the text of a trace file."""
    from ..scenes import tracefile

    return tracefile.dump(trace, indent)


def from_json(text: str) -> "Trace":
    """The trace in the text of a trace file."""
    from ..scenes import tracefile

    return tracefile.load(text)
