"""Where the walkthrough's notebooks are."""

from pathlib import Path


def shipped() -> list[Path]:
    """The walkthrough's notebooks, installed or in a checkout."""
    root = Path(__file__).parent.parent
    return sorted((root / "notebooks").glob("*.ipynb")) or sorted((root.parent / "notebooks").glob("*.ipynb"))
