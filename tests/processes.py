"""A check of whether a process has ended."""

import time
from pathlib import Path


def ends(pid):
    """Return whether a process ends within some seconds; a zombie counts as ended."""
    state = Path(f"/proc/{pid}/stat")
    for _ in range(100):
        if not state.exists() or state.read_text().split()[2] == "Z":
            return True
        time.sleep(0.05)
    return False
