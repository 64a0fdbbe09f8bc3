"""Where the walkthrough's notebooks and the figures are."""

from pathlib import Path


def shipped_folder(name: str) -> Path:
    """Return the folder `notebooks` or `figures`: inside the installed package, else in the checkout."""
    package = Path(__file__).parent.parent
    return package / name if (package / name).is_dir() else package.parent / name


def shipped_notebooks() -> list[Path]:
    """Return the walkthrough's notebooks in the order of the chapters."""
    return sorted(shipped_folder("notebooks").glob("*.ipynb"))
