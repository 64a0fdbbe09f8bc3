"""`sv.check`: call a function on pairs of shapes, the smallest first, and find the smallest scene where it is wrong."""

from collections.abc import Callable, Sequence
from typing import Any

from ..engine.polygon_validation import short_repr
from .answers import EXPECTED, TOUCHING_AS
from .asking import Asker, CalledHere, CalledInProcess, ask_all, form_named
from .checked import Checked
from .forms import Form
from .pairs import DEFAULT_KINDS, KINDS
from .steps import Options, steps


def check(
    fn: Callable[[Any, Any], Any],
    *,
    returns: str | None = None,
    form: str | Form = "points",
    kinds: str | Sequence[str] = DEFAULT_KINDS,
    touching: str = "hit",
    tolerance: float = 0.0,
    whole_numbers: bool = False,
    clockwise: bool = True,
    seed: int = 1,
    seconds: float = 5.0,
    call_seconds: float | None = None,
) -> Checked:
    """Check a collision function, and find the smallest scene where it is wrong and the mistake it behaves like.

    `fn` is called with two shapes.  `form` says how they look: "points" (a polygon as a list of (x, y), a circle as
    ((x, y), radius)), "dicts", "xy", "shapes", or a function that turns a Polygon or Circle into its argument.

    `returns`: "hit", "relation", "depth", "mtv" or "hit and mtv"; None finds it out from the first answers.
    `kinds`: the pairs to ask about, of "boxes", "convex", "concave", "circles", "circle and polygon" and "repeated",
    or "all".  `touching`: what a verdict must say of shapes that touch: "hit", "miss", or "either".  `tolerance`, in
    scene units: verdicts nearer to touching than this are not judged.  `whole_numbers=True` leaves out the pairs in
    rounded numbers, which measure where floats fail.  `clockwise=False` gives all vertices in counter-clockwise order.
    `seconds`: the time after which no new pairs are asked.  `call_seconds`: run `fn` in a process of its own, and end
    it where a call takes longer than this; without it an endless loop never ends.

    What is true is decided by the exact engine.  ValueError for an option that is none of those above.
    """
    asker: Asker = (
        CalledHere(fn, form_named(form))
        if call_seconds is None
        else CalledInProcess(fn, form_named(form), call_seconds)
    )
    return check_asker(asker, options(returns, kinds, touching, tolerance, whole_numbers, clockwise, seed, seconds))


def options(
    returns: str | None = None,
    kinds: str | Sequence[str] = DEFAULT_KINDS,
    touching: str = "hit",
    tolerance: float = 0.0,
    whole_numbers: bool = False,
    clockwise: bool = True,
    seed: int = 1,
    seconds: float = 5.0,
) -> Options:
    """Return the options of a check, after checking them; ValueError names the one that is wrong."""
    named = tuple(KINDS) if kinds == "all" else (kinds,) if isinstance(kinds, str) else tuple(kinds)
    for name in named:
        if name not in KINDS:
            raise ValueError(f"unknown kind {short_repr(name)}: choose of {', '.join(KINDS)}, or all")
    if not named:
        raise ValueError(f"kinds is empty: choose of {', '.join(KINDS)}, or all")
    if returns is not None and returns not in EXPECTED:
        raise ValueError(f"unknown returns {short_repr(returns)}: choose one of {', '.join(EXPECTED)}")
    if touching not in TOUCHING_AS:
        raise ValueError(f"unknown touching {short_repr(touching)}: choose one of {', '.join(TOUCHING_AS)}")
    if not tolerance >= 0:
        raise ValueError(f"the tolerance is {tolerance}: it must be 0 or more")
    return Options(returns, named, touching, tolerance, whole_numbers, clockwise, seed, seconds)


def check_asker(asker: Asker, options: Options) -> Checked:
    """Run the steps of a check against whoever answers, and end what was started for it."""
    running = steps(options)
    try:
        asked = next(running)
        while True:
            asked = running.send(ask_all(asker, asked))
    except StopIteration as stop:
        checked: Checked = stop.value
        return checked
    finally:
        asker.close()
