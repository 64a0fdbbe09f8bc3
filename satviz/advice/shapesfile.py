"""Many shapes as a file: an .npz of plain arrays, read without running anything."""

import zipfile
from pathlib import Path
from stat import S_ISREG
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .. import batch
from ..engine.geometry import InvalidScene, InvalidShape

KEYS = {"coords", "offsets", "centers", "radii", "pairs"}
MOST_BYTES = 1 << 30


def load(path: Path) -> tuple[batch.Shapes, NDArray[Any] | None]:
    """The shapes of a file and which pairs are meant, if it says; InvalidScene in one line for what is no such file.

    `coords` (M, 2) and `offsets` (N + 1,): polygons one after another, concave ones split; `centers` (K, 2) and
    `radii` (K,): circles, numbered after the polygons; `pairs` (P, 2): the numbers of the two shapes of each.
    """
    try:
        if not S_ISREG(path.stat().st_mode):  # as scenefile.load
            raise InvalidScene(f"cannot read {path}: not a regular file")
        with zipfile.ZipFile(path) as held:
            size = sum(member.file_size for member in held.infolist())
        if size > MOST_BYTES:
            raise InvalidScene(f"{path} holds {size:,} bytes: the limit is {MOST_BYTES:,}")
        with np.load(path, allow_pickle=False) as found:
            arrays = {name: found[name] for name in found.files}
    except InvalidScene:
        raise
    except OSError as error:
        raise InvalidScene(f"cannot read {path}: {error.strerror or error}") from None
    except Exception as error:  # bytes that are no arrays raise what zlib, a tokenizer or an allocation has to say
        said = str(error).splitlines()[:1] or [type(error).__name__]
        raise InvalidScene(f"{path} is no .npz of plain arrays: {said[0]}") from None
    return _shapes(path, arrays), arrays.get("pairs")


def _shapes(path: Path, arrays: dict[str, NDArray[Any]]) -> batch.Shapes:
    if unknown := sorted(arrays.keys() - KEYS):
        raise InvalidScene(f"{path} has the unknown array {unknown[0]!r}; known: {', '.join(sorted(KEYS))}")
    for one, other in ("coords", "offsets"), ("centers", "radii"):
        if (one in arrays) != (other in arrays):
            raise InvalidScene(f"{path} lacks {other if one in arrays else one!r}: {one} and {other} go together")
    made: list[batch.Shapes] = []
    try:
        if "coords" in arrays:
            made.append(batch.Polygons(arrays["coords"], offsets=arrays["offsets"], concave="split"))
        if "centers" in arrays:
            made.append(batch.Circles(arrays["centers"], arrays["radii"]))
    except InvalidShape as error:
        raise InvalidScene(f"{path}: {error}") from None
    if not made:
        raise InvalidScene(f"{path} has no shapes: it needs coords and offsets, or centers and radii")
    return made[0] if len(made) == 1 else batch.concat(made)
