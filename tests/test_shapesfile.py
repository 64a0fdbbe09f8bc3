"""Tests of files of many shapes: contents are checked before they are unpacked, and errors name the array."""

import io
import zipfile

import numpy as np
import pytest

import satviz as sv
from satviz.advice import shapesfile
from satviz.advice.shapesfile import load_shapes
from satviz.cli import main


@pytest.fixture
def saved(tmp_path):
    """Save arrays as a file; its path."""

    def save(**arrays):
        path = tmp_path / "shapes.npz"
        np.savez(path, **arrays)
        return path

    return save


TWO = np.array([(0, 0), (1, 0), (1, 1), (0, 1)] * 2, float)
WHOLE = {
    "coords": TWO,
    "offsets": np.array([0, 4, 8]),
    "centers": np.array([(0, 0), (3, 0), (6, 0)], float),
    "radii": np.ones(3),
    "pairs": np.array([(0, 1), (2, 4)]),
}


def with_one(array, at, value):
    changed = array.copy()
    changed[at] = value
    return changed


def of_another_kind(array):
    """Yield arrays that hold no numbers, no real (or whole) numbers, or other columns."""
    yield from (array.astype(kind) for kind in (complex, str, bool, "m8[s]", "V8"))
    if array.dtype.kind == "i":
        yield array.astype(float)
    yield from (array[None], array[0], array.ravel() if array.ndim == 2 else np.stack([array] * 3, axis=1))
    if array.ndim == 2:
        yield np.hstack([array, array[:, :1]])


@pytest.mark.parametrize("name", WHOLE)
def test_an_array_of_the_wrong_kind_is_named_as_the_file_names_it(name, saved, monkeypatch):
    """It is named before any array is unpacked."""
    assert len(load_shapes(saved(**WHOLE))[0]) == 5
    monkeypatch.setattr(shapesfile, "_array", lambda *_: pytest.fail("unpacked"))
    for wrong in of_another_kind(WHOLE[name]):
        path = saved(**WHOLE | {name: wrong})
        with pytest.raises(sv.InvalidScene) as error:
            load_shapes(path)
        assert str(error.value).startswith(f"{path}: {name} is {wrong.dtype} of the shape {wrong.shape}: expected (")


BAD_NUMBERS = [
    ("coords", with_one(TWO, (5, 1), np.nan), "coords: polygon 1: vertex 1.y is nan"),
    ("coords", with_one(TWO.astype(int), (0, 0), 2**53 + 1), "coords: polygon 0: vertex 0.x is 9007199254740993"),
    ("coords", with_one(TWO, [5, 6], TWO[[6, 5]]), "coords: polygon 1: edges "),
    ("offsets", np.array([0, 2, 8]), "coords: polygon 0: 2 distinct vertices"),
    (
        "offsets",
        np.array([0, 4, 9]),
        "offsets ends with 9: offsets must rise from 0 to the number of rows of coords, 8",
    ),
    ("offsets", np.array([0, 5, 4, 8]), "offsets falls from 5 to 4"),
    ("offsets", np.array([1, 4, 8]), "offsets begins with 1"),
    ("offsets", np.array([0, 4, 2**63], np.uint64), "offsets holds 9223372036854775808"),
    ("centers", with_one(WHOLE["centers"], (1, 0), np.inf), "centers: circle 1: center.x is inf"),
    ("radii", np.array([1, -1, 1]), "radii: circle 1: radius is -1"),
    ("radii", np.array([1, 1, np.nan]), "radii: circle 2: radius is nan"),
    ("radii", np.ones(2), "radii has the shape (2,): expected (3,), one radius for each row of centers"),
    ("pairs", np.array([(0, 5)]), "pairs[0] is (0, 5): expected (i, j) with 0 <= i < 5 and 0 <= j < 5"),
    ("pairs", np.array([(-1, 0)]), "pairs[0] is (-1, 0): expected (i, j) with 0 <= i < 5 and 0 <= j < 5"),
]


@pytest.mark.parametrize(("name", "array", "says"), BAD_NUMBERS, ids=range(len(BAD_NUMBERS)))
def test_an_invalid_number_is_named_by_the_array_of_the_file(name, array, says, saved, capsys):
    path = saved(**WHOLE | {name: array})
    assert main(["advise", str(path)]) == 2
    err = capsys.readouterr().err
    assert err.startswith(f"satviz: {path}: {says}") and err.count("\n") == 1 and "vertices " not in err[:60]


@pytest.mark.parametrize("name", WHOLE)
@pytest.mark.parametrize("ending", [".npy", ""])
@pytest.mark.filterwarnings("ignore:Duplicate name")
def test_two_members_of_one_name_are_refused(name, ending, saved):
    path = saved(**WHOLE)
    with zipfile.ZipFile(path, "a") as made:
        made.writestr(f"{name}{ending}", made.read(f"{name}.npy"))
    with pytest.raises(sv.InvalidScene, match=f"has the array '{name}' 2 times: keep one of them$"):
        load_shapes(path)


@pytest.mark.parametrize(
    ("names", "verb", "says"),
    [("coords", "holds", "16"), ("offsets", "holds", "3"), ("centers and radii", "hold", "9"), ("pairs", "holds", "4")],
)
def test_too_many_numbers_are_refused_before_they_are_unpacked(names, verb, says, saved, monkeypatch):
    path, unpacked, real = saved(**WHOLE), [], shapesfile._array
    monkeypatch.setattr(shapesfile, "_array", lambda *what: unpacked.append(what) or real(*what))
    only = tuple(names.split(" and "))
    monkeypatch.setattr(shapesfile, "LIMITED", (only,))
    monkeypatch.setattr(shapesfile, "MAX_NUMBERS", int(says) - 1)
    with pytest.raises(sv.InvalidScene) as error:
        load_shapes(path)
    limit = f"the limit is {int(says) - 1}; put fewer into one file"
    assert str(error.value) == f"{path}: {names} {verb} {says} numbers: {limit}" and not unpacked
    monkeypatch.setattr(shapesfile, "MAX_NUMBERS", int(says))
    assert len(load_shapes(path)[0]) == len(unpacked) == 5


@pytest.mark.parametrize("name", WHOLE)
def test_of_every_array_there_may_be_as_many_numbers_as_the_limit_says(name, tmp_path):
    """A header that promises more needs no data after it to be refused."""
    assert {*WHOLE} == {name for together in shapesfile.LIMITED for name in together}
    path, array = tmp_path / "large.npz", WHOLE[name]
    rows = shapesfile.MAX_NUMBERS // array[0].size + 1
    header = {"descr": array.dtype.str, "fortran_order": False, "shape": (rows, *array.shape[1:])}
    for version, size in (b"\x01\x00", 2), (b"\x02\x00", 4):
        with zipfile.ZipFile(path, "w") as made:
            for other, there in WHOLE.items():
                if other != name:
                    out = io.BytesIO()
                    np.save(out, there)
                    made.writestr(f"{other}.npy", out.getvalue())
            text = repr(header).encode()
            made.writestr(f"{name}.npy", b"\x93NUMPY" + version + len(text).to_bytes(size, "little") + text)
        with pytest.raises(sv.InvalidScene, match="the limit is 4,000,000"):
            load_shapes(path)


def test_a_member_that_numpy_would_not_write_so_is_not_unpacked(tmp_path):
    """The first byte of bzip2 may cost gigabytes, and a header the length that it claims."""
    path, out = tmp_path / "odd.npz", io.BytesIO()
    np.save(out, WHOLE["radii"])
    for how, radii, says in (
        (zipfile.ZIP_BZIP2, out.getvalue(), "radii has a compression that numpy does not use"),
        (zipfile.ZIP_LZMA, out.getvalue(), "radii has a compression that numpy does not use"),
        (zipfile.ZIP_DEFLATED, b"\x93NUMPY\x02\x00" + (10**9).to_bytes(4, "little") + b" " * 10**5, "not an .npz"),
        (zipfile.ZIP_DEFLATED, b"\x93NUMPY\x03\x00" + out.getvalue()[8:], "not an .npz of plain"),
    ):
        np.savez(path, centers=WHOLE["centers"])
        with zipfile.ZipFile(path, "a", how) as made:
            made.writestr("radii.npy", radii)
        with pytest.raises(sv.InvalidScene, match=says):
            load_shapes(path)


def test_corners_of_concave_polygons_are_counted_before_they_are_split(tmp_path, monkeypatch):
    notched, square = [(0, 0), (4, 0), (4, 4), (2, 1), (0, 4)], [(0, 0), (1, 0), (1, 1), (0, 1)]
    path = tmp_path / "notched.npz"
    np.savez(path, coords=np.array(notched + square + notched, float), offsets=[0, 5, 9, 14])
    monkeypatch.setattr(shapesfile, "MAX_CONCAVE_CORNERS", 10)
    assert len(shapesfile.load_shapes(path)[0]) == 3
    monkeypatch.setattr(shapesfile, "MAX_CONCAVE_CORNERS", 9)
    monkeypatch.setattr(shapesfile.batch, "Polygons", lambda *args, **kwargs: pytest.fail("split"))
    with pytest.raises(sv.InvalidScene, match=r"coords holds 10 corners of concave .*: the limit is 9; split"):
        shapesfile.load_shapes(path)
