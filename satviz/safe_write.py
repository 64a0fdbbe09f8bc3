"""The one way satviz writes a file: whole or not at all, never through a link, never over somebody else's file.

A file is written beside its place and renamed, so neither an interrupt nor a full disk
leaves a half one.  Every format has a place for its maker; a file that does not name
satviz there is somebody else's and is not overwritten unless asked.
"""

import errno
import os
from contextlib import suppress
from pathlib import Path
from threading import get_ident

MADE_BY = "made by satviz"
# where each format names its maker; to speak of satviz elsewhere is not enough
_MAKER_FIELDS = {
    ".svg": f"<dc:title>{MADE_BY}",
    ".png": f"Software\0{MADE_BY}",
    ".pdf": f"/Creator ({MADE_BY}",
    ".gif": f"{MADE_BY}. ",
    ".html": f'content="{MADE_BY}"',
    ".json": f'"made_by": "{MADE_BY}"',
    ".csv": f",{MADE_BY}\n",
    ".js": f"// {MADE_BY}\n",
    ".css": f"/* {MADE_BY} */\n",
    ".bin": f"{MADE_BY}\0",
    ".md": f"\n\n{MADE_BY}: ",
    ".txt": f"# {MADE_BY}\n",
    ".xml": f"<!-- {MADE_BY} -->",
    ".zip": f"{MADE_BY}: a site",
}


def check(path: Path, *, force: bool = False) -> None:
    """Raise FileExistsError for a folder, and unless forced for a link or a file that satviz did not make."""
    if not os.path.lexists(path):
        return
    link = path.is_symlink()
    if path.is_dir() and not link:
        raise FileExistsError(f"{path} is a folder, and satviz writes a file of that name: choose another folder")
    if link and not force:
        raise FileExistsError(
            f"{path} is a symbolic link: choose another folder, or put a file in its place with --force"
        )
    if not force and not (path.is_file() and _is_made_by_satviz(path)):
        raise FileExistsError(f"{path} was not made by satviz: choose another folder, or overwrite it with --force")


def _is_made_by_satviz(path: Path) -> bool:
    """Return whether the file's own field for its maker names satviz."""
    with path.open("rb") as file:
        head = file.read(1 << 16)
        file.seek(max(0, os.fstat(file.fileno()).st_size - (1 << 16)))
        tail = file.read(1 << 16)
    mark = _MAKER_FIELDS.get(path.suffix, "").encode()
    return bool(mark) and (mark in head or mark in tail)


def make_folder(path: Path) -> None:
    """Make the folder if it does not exist; NotADirectoryError if a file has its name."""
    try:
        path.mkdir(parents=True, exist_ok=True)
    except FileExistsError:
        raise NotADirectoryError(errno.ENOTDIR, "not a folder", str(path)) from None


def write(path: Path, data: bytes, *, force: bool = False) -> None:
    """Write the bytes whole or not at all; FileExistsError as in `check`, any other OSError names the file."""
    check(path, force=force)
    make_folder(path.parent)
    beside = path.with_name(f".{path.name}.{os.getpid()}-{get_ident()}.part")
    try:
        with beside.open("xb") as file:
            file.write(data)
        os.replace(beside, path)
    except BaseException as error:
        with suppress(OSError):
            beside.unlink()
        if isinstance(error, OSError):
            raise OSError(error.errno, error.strerror, str(path)) from None
        raise
