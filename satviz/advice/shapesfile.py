"""Read many shapes from a file: an .npz of plain arrays, of which no code is run.

In the functions below `held` is the open file; `path` is only named in error messages.
"""

import zipfile
from collections import Counter
from io import BytesIO
from math import prod
from pathlib import Path
from stat import S_ISREG
from typing import Any, NamedTuple

import numpy as np
from numpy.lib import format as npy
from numpy.typing import NDArray

from .. import batch
from ..batch import validation
from ..batch.outlines import convex_rings
from ..batch.ragged import RaggedRings
from ..engine.geometry import InvalidScene, InvalidShape
from ..engine.polygon_validation import short_repr

MAX_NUMBERS = 4_000_000  # 2,000,000 circles or corners: `sv.advise` takes some 10 s and 0.8 GB
MAX_CONCAVE_CORNERS = 50_000  # split into convex parts one outline at a time, in some 10 s
HEADER_BYTES = 1 << 14  # NumPy itself reads no header longer than 10,000


class Kind(NamedTuple):
    """Describe what an array of the file must be: kinds of dtype, shape of a row, and both in words."""

    dtypes: str
    row: tuple[int, ...]
    words: str


KINDS = {
    "coords": Kind("fiu", (2,), "(M, 2) real numbers, the vertices of all polygons"),
    "offsets": Kind("iu", (), "(N + 1,) integers, where each polygon starts in coords and the last one ends"),
    "centers": Kind("fiu", (2,), "(K, 2) real numbers, the centers of all circles"),
    "radii": Kind("fiu", (), "(K,) real numbers, one radius for each row of centers"),
    "pairs": Kind("iu", (2,), "(P, 2) integers, the numbers of the two shapes of each pair"),
}
# the two ways in which numpy packs a file: savez and savez_compressed
PACKED = zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED
LIMITED = ("coords",), ("offsets",), ("centers", "radii"), ("pairs",)  # each group has MAX_NUMBERS in all, at most


def load_shapes(path: Path) -> tuple[batch.Shapes, NDArray[Any] | None]:
    """Return (shapes, pairs) of a file, None for pairs if it has none; InvalidScene for a file of another form.

    `coords` (M, 2) and `offsets` (N + 1,): polygons one after another, concave ones split; `centers` (K, 2) and
    `radii` (K,): circles, numbered after the polygons; `pairs` (P, 2): the numbers of the two shapes of each.
    A few kilobytes can unpack to gigabytes, so names, kinds and sizes are checked before anything is unpacked.
    """
    try:
        if not S_ISREG(path.stat().st_mode):  # as scenefile.load
            raise InvalidScene(f"cannot read {path}: it is not a regular file; give the path of one")
        with zipfile.ZipFile(path) as held:
            members = _members(path, held)
            _check(path, {name: _header(held, member) for name, member in members.items()})
            arrays = {name: _array(held, member) for name, member in members.items()}
    except InvalidScene:
        raise
    except OSError as error:
        raise InvalidScene(f"cannot read {path}: {error.strerror or error}") from None
    except Exception as error:  # damaged arrays raise errors of zlib, of a tokenizer or of an allocation
        reason = str(error).splitlines()[:1] or [type(error).__name__]
        raise InvalidScene(f"{path} is not an .npz of plain arrays: {reason[0]}; use numpy.savez") from None
    return _shapes(path, arrays), arrays.get("pairs")


def _members(path: Path, held: zipfile.ZipFile) -> dict[str, zipfile.ZipInfo]:
    """Return the zip members by array name; InvalidScene for unknown, repeated or missing names and compressions."""
    listed = [(member.filename.removesuffix(".npy"), member) for member in held.infolist()]
    names = Counter(name for name, _ in listed)
    if twice := next((name for name, count in names.items() if count > 1), None):
        raise InvalidScene(f"{path} has the array {short_repr(twice)} {names[twice]} times: keep one of them")
    if unknown := sorted(names.keys() - KINDS.keys()):
        raise InvalidScene(f"{path} has the unknown array {short_repr(unknown[0])}; use {', '.join(sorted(KINDS))}")
    for one, other in ("coords", "offsets"), ("centers", "radii"):
        if (one in names) != (other in names):
            raise InvalidScene(f"{path} lacks {other if one in names else one!r}: save both {one} and {other}")
    if not names.keys() & {"coords", "centers"}:
        raise InvalidScene(f"{path} has no shapes: it needs coords and offsets, or centers and radii")
    # others may unpack gigabytes for the first byte
    if odd := next((name for name, member in listed if member.compress_type not in PACKED), None):
        raise InvalidScene(
            f"{path}: {odd} has a compression that numpy does not use: save the arrays with numpy.savez_compressed"
        )
    return dict(listed)


def _header(held: zipfile.ZipFile, member: zipfile.ZipInfo) -> tuple[tuple[int, ...], np.dtype[Any]]:
    """Return (shape, dtype) of an array from the first bytes of its member; ValueError where they have no header."""
    with held.open(member) as file:
        start = BytesIO(file.read(HEADER_BYTES))
    version = npy.read_magic(start)
    if version == (1, 0):
        shape, _, dtype = npy.read_array_header_1_0(start)
    elif version == (2, 0):
        shape, _, dtype = npy.read_array_header_2_0(start)
    else:
        name = member.filename
        raise ValueError(
            f"{name} has version {version} of the .npy format, but only (1, 0) and (2, 0) are read: save the arrays "
            "again with numpy.savez"
        )
    return shape, dtype


def _check(path: Path, headers: dict[str, tuple[tuple[int, ...], np.dtype[Any]]]) -> None:
    """Raise InvalidScene for the first array of a wrong dtype or shape, or with too many numbers."""
    for name, (shape, dtype) in headers.items():
        kind, empty = KINDS[name], shape == (0,) and dtype.kind in "fiu"  # as a list without a row is saved
        fits = dtype.kind in kind.dtypes and len(shape) == 1 + len(kind.row) and shape[1:] == kind.row
        if not (fits or empty) or min(shape) < 0:
            raise InvalidScene(f"{path}: {name} is {dtype} of the shape {shape}: expected {kind.words}")
    for together in LIMITED:
        if (many := sum(prod(headers[name][0]) for name in together if name in headers)) > MAX_NUMBERS:
            verb = "holds" if len(together) == 1 else "hold"
            raise InvalidScene(
                f"{path}: {' and '.join(together)} {verb} {many:,} numbers: the limit is {MAX_NUMBERS:,}; "
                "put fewer into one file"
            )
    if "centers" in headers and headers["radii"][0] != headers["centers"][0][:1]:
        (many,), (count, *_) = headers["radii"][0], headers["centers"][0]
        raise InvalidScene(
            f"{path}: radii has the shape ({many},): expected ({count},), one radius for each row of centers"
        )


def _array(held: zipfile.ZipFile, member: zipfile.ZipInfo) -> NDArray[Any]:
    """Return the array of a member; pickled objects are refused."""
    with held.open(member) as file:
        found: NDArray[Any] = npy.read_array(file, allow_pickle=False)
    return found


def _shapes(path: Path, arrays: dict[str, NDArray[Any]]) -> batch.Shapes:
    """Return one batch of the polygons, then the circles, in these arrays; InvalidScene for an invalid shape."""
    made: list[batch.Shapes] = []
    try:
        if "coords" in arrays:
            coords = arrays["coords"].reshape(-1, 2)
            _check_concave(path, coords, arrays["offsets"])
            made.append(batch.Polygons(coords, offsets=arrays["offsets"], concave="split"))
        if "centers" in arrays:
            made.append(batch.Circles(arrays["centers"].reshape(-1, 2), arrays["radii"]))
    except InvalidShape as error:
        raise InvalidScene(f"{path}: {_in_the_file(str(error))}") from None
    return made[0] if len(made) == 1 else batch.concat(made)


def _check_concave(path: Path, coords: NDArray[Any], offsets: NDArray[Any]) -> None:
    """Raise InvalidScene for more than MAX_CONCAVE_CORNERS corners of concave polygons."""
    points, start = validation.rings_from_offsets(coords, offsets)
    rings = RaggedRings(points[:, 0], points[:, 1], start)
    corners = np.diff(rings.start)
    _, plain = convex_rings(RaggedRings(rings.x + 0.0, rings.y + 0.0, rings.start))
    if (many := int(corners[~plain].sum())) > MAX_CONCAVE_CORNERS:
        raise InvalidScene(
            f"{path}: coords holds {many:,} corners of concave polygons: the limit is {MAX_CONCAVE_CORNERS:,}; "
            "split them first (satviz.parts), or put fewer into one file"
        )


def _in_the_file(message: str) -> str:
    """Return an error message of `batch`, reworded so that it names the array of the file that is at fault."""
    if message.startswith("polygon"):
        return f"coords: {message}"
    if message.startswith("circle"):
        return f"{'radii' if ': radius' in message else 'centers'}: {message}"
    return message.replace("number of vertices", "number of rows of coords")  # the message names the array offsets too
