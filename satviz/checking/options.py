"""The options of `sv.check`: their defaults, and which values are valid."""

from collections.abc import Sequence
from dataclasses import dataclass

from ..engine.polygon_validation import short_repr
from .answers import EXPECTED, TOUCHING_AS
from .pairs import DEFAULT_KINDS, KINDS


@dataclass(frozen=True, kw_only=True)
class Options:
    """The options of a check; `sv.check` says what each means.  ValueError names the one that is wrong."""

    returns: str | None = None
    kinds: str | Sequence[str] = DEFAULT_KINDS
    touching: str = "hit"
    tolerance: float = 0.0
    whole_numbers: bool = False
    clockwise: bool = True
    seed: int = 1
    seconds: float = 5.0

    def __post_init__(self) -> None:
        for name in self.named_kinds:
            if name not in KINDS:
                raise ValueError(f"unknown kind {short_repr(name)}: choose one of {', '.join(KINDS)}, or all")
        if not self.named_kinds:
            raise ValueError(f"kinds is empty: choose one of {', '.join(KINDS)}, or all")
        if self.returns is not None and self.returns not in EXPECTED:
            raise ValueError(f"returns is {short_repr(self.returns)}: choose one of {', '.join(EXPECTED)}")
        if self.touching not in TOUCHING_AS:
            raise ValueError(f"touching is {short_repr(self.touching)}: choose one of {', '.join(TOUCHING_AS)}")
        if not self.tolerance >= 0:
            raise ValueError(f"the tolerance is {self.tolerance}: it must be 0 or more")

    @property
    def named_kinds(self) -> tuple[str, ...]:
        """Return the kinds of pairs one by one, all of them for "all"."""
        if self.kinds == "all":
            return tuple(KINDS)
        return (self.kinds,) if isinstance(self.kinds, str) else tuple(self.kinds)
