"""`sv.check`: call a function on pairs of shapes, the smallest first, and find the smallest scene where it is wrong."""

from collections.abc import Callable, Sequence
from typing import Any

from ..engine.polygon_validation import short_repr
from .asking import Asker, CalledHere, CalledInProcess, ask_all, form_named
from .checked import Checked
from .forms import Form
from .options import Options
from .steps import steps


def check(
    fn: Callable[[Any, Any], Any],
    *,
    form: str | Form = "points",
    returns: str | None = Options.returns,
    kinds: str | Sequence[str] = Options.kinds,
    touching: str = Options.touching,
    tolerance: float = Options.tolerance,
    whole_numbers: bool = Options.whole_numbers,
    clockwise: bool = Options.clockwise,
    seed: int = Options.seed,
    seconds: float = Options.seconds,
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
    `seed`: of the random pairs.  `seconds`: the time after which no new pairs are asked.  `call_seconds`: run `fn` in a
    process of its own, and end it where a call takes longer than this; without it an endless loop never ends.

    What is true is decided by the exact engine.  TypeError if `fn` is no function; ValueError for an option that is not
    one of those above.
    """
    if isinstance(fn, str):
        raise TypeError(
            f"fn is the text {short_repr(fn)}, not a function: import the function and pass it, or run "
            "satviz check FILE:NAME"
        )
    if not callable(fn):
        raise TypeError(f"fn is a {type(fn).__name__}: pass a function of two shapes")
    asker: Asker = (
        CalledHere(fn, form_named(form))
        if call_seconds is None
        else CalledInProcess(fn, form_named(form), call_seconds)
    )
    options = Options(
        returns=returns, kinds=kinds, touching=touching, tolerance=tolerance,
        whole_numbers=whole_numbers, clockwise=clockwise, seed=seed, seconds=seconds,
    )  # fmt: skip
    return check_asker(asker, options)


def check_asker(asker: Asker, options: Options) -> Checked:
    """Check the function that `asker` calls, and close the asker at the end."""
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
