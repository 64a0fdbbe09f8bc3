"""JSON read strictly: finite numbers, no key twice, bounded size and nesting, exactly the keys that are expected.

The argument `where` names a value in error lines, such as "trace.axes".
"""

import json
import re
from collections import Counter
from collections.abc import Set
from typing import Any

from ..engine.geometry import InvalidScene
from ..engine.polygon_validation import short_repr

MAX_DEPTH = 12
# commas, opening brackets and quotes: no value goes without one, so memory is bounded by them
MAX_PUNCTUATION = 1 << 23
STRING = re.compile(r'"(?:[^"\\]|\\.)*+(?:"|$)', re.DOTALL)  # an unended one runs to the end, once


def refuse_large(text: str, max_chars: int) -> None:
    """Raise InvalidScene for a text too large to be read; only its length and its punctuation are counted."""
    if len(text) > max_chars:
        raise InvalidScene(f"the text has {len(text):,} characters: the limit is {max_chars:,}; give fewer vertices")
    if (count := sum(map(text.count, ',[{"'))) > MAX_PUNCTUATION:
        raise InvalidScene(
            f"the text has {count:,} commas, brackets and quotes: the limit is {MAX_PUNCTUATION:,}; give fewer vertices"
        )


def parse(text: str, max_chars: int) -> Any:
    """Return the value of a JSON text; InvalidScene names what is wrong.  Size and depth are checked before parsing."""
    if not isinstance(text, str):
        raise TypeError(f"expected the text of a file, not {type(text).__name__}")
    refuse_large(text, max_chars)
    depth = 0
    for bracket in re.finditer(r"[\[\]{}]", STRING.sub("", text)):
        depth += 1 if bracket[0] in "[{" else -1
        if depth > MAX_DEPTH:
            raise InvalidScene(f"the text has brackets nested deeper than {MAX_DEPTH} levels: remove some")
        if depth < 0:
            break  # this is not JSON, and the parser will report it
    try:
        return json.loads(
            text,
            object_pairs_hook=_object_without_duplicates,
            parse_constant=_refuse_constant,
            parse_float=_parse_finite,
            parse_int=_parse_whole,
        )
    except json.JSONDecodeError as error:
        raise InvalidScene(f"this is not JSON: {error}; correct it there") from None


def require_keys(data: Any, where: str, required: Set[str], optional: Set[str] = frozenset()) -> dict[str, Any]:
    """Return `data` if it is an object with all required keys, and only optional ones besides; else InvalidScene.

    `where` names the object in the error line.
    """
    if not isinstance(data, dict):
        raise InvalidScene(f"{where} must be a JSON object, not {json_type_name(data)}")
    if missing := sorted(required - data.keys()):
        raise InvalidScene(f"{where} lacks {_quoted(missing)}")
    if unknown := sorted(data.keys() - required - optional):
        raise InvalidScene(
            f"{where} has the unknown key {_quoted(unknown)}; it may have {_quoted(sorted(required | optional))}"
        )
    return data


def require_type(value: Any, where: str, wanted: type) -> Any:
    """Return the value if its type is `wanted`, with 3.0 as the integer 3; otherwise InvalidScene.

    A bool is not a number.
    """
    if wanted is int and isinstance(value, float) and value.is_integer():
        return int(value)
    if not isinstance(value, wanted) or (isinstance(value, bool) and wanted is not bool):
        expected = "a whole number" if wanted is int else _NAMES[wanted]
        raise InvalidScene(f"{where} must be {expected}, not {json_type_name(value)}")
    return value


def json_type_name(value: Any) -> str:
    """Return the name of a value's JSON type for error lines, such as "a list" or "null"."""
    return "null" if value is None else _NAMES.get(type(value), type(value).__name__)


_NAMES = {str: "text", list: "a list", dict: "an object", bool: "true or false", int: "a number", float: "a number"}


def _object_without_duplicates(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    """Return a dict of the (key, value) pairs; InvalidScene if a key occurs twice."""
    found = dict(pairs)
    if len(found) < len(pairs):
        twice = next(key for key, times in Counter(key for key, _ in pairs).items() if times > 1)
        raise InvalidScene(f"the key {_quoted([twice])} is given twice in one object: keep one of them")
    return found


def _refuse_constant(name: str) -> float:
    """Raise InvalidScene for NaN or Infinity, which Python would read."""
    raise InvalidScene(f"{name} is not allowed in a scene: numbers must be finite")


def _parse_finite(text: str) -> float:
    """Return the float that the text stands for; InvalidScene if it is too large for float64."""
    value = float(text)
    if abs(value) == float("inf"):
        raise InvalidScene(f"{short_repr(text)} is too large for float64: scale the scene down")
    return value


def _parse_whole(text: str) -> int:
    """Return the integer that the text stands for; InvalidScene if it has over 400 letters."""
    if len(text) > 400:  # no float64 is longer; int() of a million digits takes seconds
        raise InvalidScene(f"a number of {len(text)} digits is too large for float64: scale the scene down")
    return int(text)


def _quoted(names: list[str]) -> str:
    """Return the names in quotes, joined by commas; at most 20 names of 60 letters each are shown."""
    found = ", ".join(json.dumps(name if len(name) <= 60 else f"{name[:60]}...") for name in names[:20])
    return found if len(names) <= 20 else f"{found}, and {len(names) - 20:,} more"
