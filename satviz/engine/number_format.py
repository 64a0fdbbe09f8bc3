"""Numbers as text: the gap decides how many digits are printed, one unit for a whole scene, a real minus sign."""

from collections.abc import Sequence
from fractions import Fraction
from math import floor, inf, isclose, log10, ulp
from typing import NamedTuple

from .geometry import Vec
from .sat import AxisTest
from .shapes import Shape

MINUS = "\u2212"
PLAIN_SIZES = 1e-2, 1e6  # scenes of these sizes are printed as they are, others in units of a power of a thousand
FAR_LANDING = 1e6  # units; landings beyond it are printed relative to an origin near them
MAX_DECIMALS = 9  # decimals; a finer gap is printed beside the end from which it is measured
MAX_NARROW_DECIMALS = 6  # decimals that a narrow range, or a gap by itself, may ask for
MAX_WHOLE_NUMBER = 1e15  # whole numbers beyond lose digits in float64


class Digits(NamedTuple):
    """The format of a scene's printed numbers: decimals, a unit of 10**power, and landings relative to `origin`.

    `origin` is in those units.  `fine` means: the gap is so small that ranges with these decimals cannot show it.
    `padded`: every number has all decimals, zeros at its end too, so that its width does not change in a drag.
    """

    decimals: int = 3
    power: int = 0
    origin: int = 0
    fine: bool = False
    padded: bool = False

    @property
    def unit(self) -> str:
        """Return the text that follows each number, such as "e9"; "" where the unit is 1."""
        return f"e{self.power}".replace("-", MINUS) if self.power else ""

    def number(self, value: float) -> str:
        """Return a number as text: all decimals where digits were cut, else as few as it has; "0" stands only for 0.

        A padded format has all decimals always, so a small number may become "0.00".
        """
        text = self.bare(value)
        return _scientific(value) if "e" in text else f"{text}{self.unit}" if value else text

    def gap(self, value: float) -> str:
        """Return the size of a gap as text without its sign, with three or more significant digits (padded: one)."""
        digits = self._with_decimals_for(value)
        return digits.number(abs(value)) if digits.shows(value) else _scientific(abs(value))

    def signed(self, value: float) -> str:
        """Return a gap as text with its sign; "0" only for exactly 0."""
        return f"{'+' if value > 0 else MINUS if value else ''}{self.gap(value)}"

    def vector(self, value: Vec) -> str:
        """Return a vector as text: "(x, y)"."""
        return f"({self.number(value.x)}, {self.number(value.y)})"

    def landing(self, value: float) -> str:
        """Return a coordinate on an axis as text; far from the origin as a whole number plus the rest."""
        return self._from_origin(self._rest(value)) if self.origin else self.number(value)

    def ranges(self, test: AxisTest) -> tuple[str, str]:
        """Return both ranges of a test as text; the difference of their facing ends is the printed gap."""
        a, b = test.a.interval, test.b.interval
        left, right = (a, b) if b.lo - a.hi >= a.lo - b.hi else (b, a)
        end, start = self._rest(left.hi), self._rest(right.lo)
        if not test.gap:
            start = end
        elif self.fine:
            fine, size = self._with_decimals_for(test.gap), abs(test.gap)
            text = fine.bare(size) if fine.shows(size) else _scientific(size / 10.0**self.power)
            start = f"{end} {'+' if test.gap > 0 else MINUS} {text}"
        printed = f"[{self._rest(left.lo)}, {end}]", f"[{start}, {self._rest(right.hi)}]"
        one, other = map(self._from_origin, printed)
        return (one, other) if left is a else (other, one)

    def interval(self, lo: float, hi: float) -> str:
        """Return a range as text: "[from, to]"."""
        return self._from_origin(f"[{self._rest(lo)}, {self._rest(hi)}]")

    def _with_decimals_for(self, gap: float) -> "Digits":
        """Return this format, with enough decimals to show three significant digits of the gap unless it is padded."""
        if self.padded:
            return self
        decimals = _needed_decimals(abs(gap) / 10.0**self.power, 3)
        return self._replace(decimals=decimals) if self.decimals < decimals <= MAX_NARROW_DECIMALS else self

    def shows(self, gap: float) -> bool:
        """Return whether this format's decimals show three significant digits of the gap, or one if it is padded."""
        return _needed_decimals(abs(gap) / 10.0**self.power, 1 if self.padded else 3) <= self.decimals

    def _from_origin(self, text: str) -> str:
        """Return the text with the origin before it, if there is one, and the unit after it: "(2000 + 2.5)e9"."""
        if not self.origin:
            return f"{text}{self.unit}"
        whole = f"{self.origin} + {text}".replace("-", MINUS)
        return f"({whole}){self.unit}" if self.power else whole

    def _rest(self, value: float) -> str:
        """Return a landing minus the origin, as text without a unit; computed exactly."""
        if self.origin:
            value = float(Fraction(value) - self.origin * Fraction(10) ** self.power)
        return self.bare(value)

    def bare(self, value: float) -> str:
        """Return a number without its unit as text, in scientific notation where the decimals cannot show it."""
        scaled = value / 10.0**self.power
        text = f"{scaled + 0.0:.{self.decimals}f}"
        if abs(scaled) >= MAX_WHOLE_NUMBER or (scaled and float(text) == 0 and not self.padded):
            return _scientific(scaled)
        if float(text) == 0:
            text = text.removeprefix("-")
        # a change of unit may cost the last bit
        exact = isclose(float(text), scaled, rel_tol=1e-15 if self.power else 0.0)
        if exact and "." in text and not self.padded:
            text = text.rstrip("0").rstrip(".")
        return text.replace("-", MINUS)


USUAL_DIGITS = Digits()  # the format if no scene decides it: three decimals, or more where three would show 0
number, vector = USUAL_DIGITS.number, USUAL_DIGITS.vector


def _scientific(value: float) -> str:
    """Return a number as text with a power of ten and four significant digits."""
    mantissa, _, power = f"{value:.3e}".partition("e")
    return f"{mantissa}e{int(power)}".replace("-", MINUS)


def ascii_minus(text: str) -> str:
    """Return the text with "-" in place of each typographic minus sign, as files and terminals need it."""
    return text.replace(MINUS, "-")


def digits_for_shapes(*shapes: Shape) -> Digits:
    """Return the Digits that fit the size of some shapes: unit 1, else a fitting power of a thousand."""
    boxes = [shape.bounds for shape in shapes]
    size = max(max(box[i + 2] for box in boxes) - min(box[i] for box in boxes) for i in (0, 1))
    if PLAIN_SIZES[0] <= size < PLAIN_SIZES[1]:
        return USUAL_DIGITS
    # the size may be infinite: beyond float64
    return Digits(power=max(-300, min(300, 3 * floor(log10(min(size, 1e300)) / 3))))


def steady_digits(shapes: Sequence[Shape], tests: Sequence[AxisTest], least_length: float) -> Digits:
    """Return Digits for a drag, whose decimals depend on the least length that can be seen, not on the gap.

    Every number has the same decimals then.  Where they would hide a gap that is not 0, or where the numbers lie far
    from the origin, the result is that of `digits_for_tests`.
    """
    usual = digits_for_tests(shapes, tests)
    decimals = max(0, min(_needed_decimals(least_length / 10.0**usual.power, 1), MAX_NARROW_DECIMALS))
    steady = usual._replace(decimals=decimals, padded=True)
    hidden = any(t.gap and not steady.shows(t.gap) for t in tests)
    return usual if usual.fine or usual.origin or hidden else steady


def digits_for_tests(shapes: Sequence[Shape], tests: Sequence[AxisTest]) -> Digits:
    """Return the Digits that show the smallest gap of these tests to three digits, and every range's width."""
    digits = digits_for_shapes(*shapes)
    unit = 10.0**digits.power
    ranges = [side.interval for t in tests for side in (t.a, t.b)]
    if not ranges:
        return digits
    lo, hi = min(r.lo for r in ranges) / unit, max(r.hi for r in ranges) / unit
    most = max(-lo, hi)
    # decimals that float64 resolves at this distance from the origin
    held = min(MAX_DECIMALS, floor(-log10(8 * ulp(most))))
    gap = max(_needed_decimals(abs(t.gap) / unit, 3) for t in tests)
    width = min(max(_needed_decimals(r.hi / unit - r.lo / unit, 2) for r in ranges), held, MAX_NARROW_DECIMALS)
    least = max(0, min(held, 3), width)
    fine = gap > held
    origin = 0
    if most >= FAR_LANDING and hi - lo < most / 100:
        step = 10 ** max(0, floor(log10(max(hi - lo, 1.0))) + 1)
        origin = floor(lo / step) * step
    return Digits(least if fine else max(least, gap), digits.power, origin, fine)


def _needed_decimals(size: float, digits: int) -> int:
    """Return how many decimals show `digits` significant digits of a size, negative for large ones; 0 for 0 and inf."""
    return digits - 1 - floor(log10(size)) if 0 < size < inf else 0
