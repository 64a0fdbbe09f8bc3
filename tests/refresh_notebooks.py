"""Run the walkthrough's notebooks in place and keep only what should be committed.

    python tests/refresh_notebooks.py            # all chapters
    python tests/refresh_notebooks.py 2 5        # chapters 2 and 5

Each runs from the top in a fresh kernel.  Kept of an output are its text and its picture; dropped are
widget state, HTML, timings and anything else that differs from run to run or machine to machine.
"""

import sys
from pathlib import Path

import nbformat
from nbclient import NotebookClient

NOTEBOOKS = Path(__file__).parent.parent / "notebooks"
DROPPED = "application/vnd.jupyter.widget-view+json"  # its model is gone when the kernel is
KERNEL = {"display_name": "Python 3", "language": "python", "name": "python3"}


def refresh(path: Path) -> None:
    """Execute one notebook and write it back, stripped; an error in a cell is raised and nothing is written."""
    notebook = nbformat.read(path, as_version=4)
    for cell in notebook.cells:
        if cell.cell_type == "code":
            cell.outputs, cell.execution_count = [], None
    client = NotebookClient(
        notebook,
        timeout=60,
        kernel_name="python3",
        resources={"metadata": {"path": str(path.parent)}},
        store_widget_state=False,
        record_timing=False,
        coalesce_streams=True,  # how a text is cut into pieces depends on how busy the machine is
    )
    client.execute()
    notebook.metadata = nbformat.from_dict({"kernelspec": KERNEL})
    for cell in notebook.cells:
        tags = cell.metadata.get("tags")
        cell.metadata = nbformat.from_dict({"tags": tags} if tags else {})
        for output in [*cell.get("outputs", ())]:
            if output.get("data", {}).pop(DROPPED, None) and set(output.data) == {"text/plain"}:
                cell.outputs.remove(output)  # a widget that has no picture
    nbformat.validate(notebook)
    nbformat.write(notebook, path)


def main(chapters: list[str]) -> None:
    found = [path for path in sorted(NOTEBOOKS.glob("*.ipynb")) if not chapters or path.name[0] in chapters]
    for path in found:
        refresh(path)
        print(f"{path.name}: {path.stat().st_size / 1000:.0f} kB")


if __name__ == "__main__":
    main(sys.argv[1:])
