"""Runs the notebook `grading.ipynb` in a folder of its own; an exception in it ends this with an error.

With a folder as argument, it also writes the manual's pictures there: the output of a cell whose metadata has ``picture`` goes to the
file of that name.
"""

from __future__ import annotations

import base64
import re
import sys
import tempfile
from pathlib import Path

import nbformat
from nbclient import NotebookClient

HERE = Path(__file__).parent


def main() -> None:
    """Execute the notebook, and take its pictures."""
    notebook = nbformat.read(HERE / "grading.ipynb", as_version=4)  # type: ignore[no-untyped-call]
    if any(cell.get("outputs") or cell.get("execution_count") for cell in notebook.cells):
        sys.exit("grading.ipynb is kept without outputs: clear them")
    with tempfile.TemporaryDirectory() as folder:
        NotebookClient(notebook, timeout=300, resources={"metadata": {"path": folder}}).execute()
    pictures = {name: cell for cell in notebook.cells if (name := cell.metadata.get("picture"))}
    for name, cell in pictures.items():
        data = picture(cell)
        print(f"{name}: {len(data)} bytes")
        if len(sys.argv) > 1:
            (Path(sys.argv[1]) / name).write_bytes(data)
    print(f"the notebook ran: {len(notebook.cells)} cells")


def picture(cell: nbformat.NotebookNode) -> bytes:
    """The first picture that a cell shows: a PNG, or what its HTML holds."""
    for output in cell.outputs:
        data = output.get("data", {})
        if "image/png" in data:
            return base64.b64decode(data["image/png"])
        held = re.search(r'src="data:image/\w+;base64,([^"]+)"', data.get("text/html", ""))
        if held:
            return base64.b64decode(held[1])
    sys.exit(f"the cell of {cell.metadata['picture']} shows no picture")


if __name__ == "__main__":
    main()
