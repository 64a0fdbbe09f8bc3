"""The sum behind a landing: how a point's coordinate on an axis is computed, in pieces of text."""

from math import sqrt

from .number_format import Digits, ascii_minus, number
from .sat import AxisTest

AXIS, POINT, PLAIN = "axis", "point", ""


def landing_sum(digits: Digits, test: AxisTest, role: str, i: int) -> list[tuple[str, str]]:
    """Return the sum of the landing of point `i` of role "A" or "B" in pieces: "2", "\u00b7", "8" ... " = 6.934".

    A piece is (text, whose number it is: AXIS, POINT or PLAIN).  `digits`: how the test's numbers are printed.
    The list is empty where a number would not be printed in full, and where a shortcut measures something else than
    this sum.
    """
    side = (test.a, test.b)["AB".index(role)]
    (nx, ny), (x, y) = test.axis.normal, side.points[i]
    if digits.origin or digits.power or digits.fine or not all(map(_is_printed_in_full, (nx, ny, x, y))):
        return []
    total, square = nx * x + ny * y, nx * nx + ny * ny
    landing = side.landings[i]
    if not (_is_printed_in_full(total) and _is_printed_in_full(square)):
        return []
    root = sqrt(square)
    if abs(total / root - landing) > 1e-9 * max(1.0, abs(landing)):
        return []
    u, v, p, q = (number(value) if value >= 0 else f"({number(value)})" for value in (nx, ny, x, y))
    pieces = [(u, AXIS), ("\u00b7", PLAIN), (p, POINT), (" + ", PLAIN), (v, AXIS), ("\u00b7", PLAIN), (q, POINT)]
    if root == 1:
        return [*pieces, (f" = {number(total)}", PLAIN)]
    length = number(root) if root.is_integer() else f"\u221a{number(square)}"
    pieces.append((f" = {number(total)};  {number(total)} / ", PLAIN))
    return [*pieces, (length, AXIS), (f" = {digits.landing(landing)}", PLAIN)]


def _is_printed_in_full(value: float) -> bool:
    """Check whether the printed number is exactly the value."""
    return float(ascii_minus(number(value))) == value
