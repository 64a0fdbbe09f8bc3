"""All collisions among millions of mixed polygons in a mapped file: seconds, and memory beyond the mapping.

Run: python tests/benchmarks/millions.py [MILLIONS]   (ten by default: a file of 1.3 GB in the temporary folder)
"""

import resource
import sys
import tempfile
import threading
from pathlib import Path
from time import perf_counter

import numpy as np

from satviz import batch
from satviz.study.workloads.generators import mixed_polygons

PART_POLYGONS = 250_000  # polygons generated at a time


def write_polygons(path: Path, n: int) -> None:
    """Write n polygons of 3 to 8 corners (the last repeated), spread evenly: about 1.5 collisions each."""
    rng = np.random.default_rng(1)
    file = np.lib.format.open_memmap(path, "w+", np.float64, (n, 8, 2))
    for start in range(0, n, PART_POLYGONS):
        rings = mixed_polygons(rng, min(PART_POLYGONS, n - start), 0.0)
        file[start : start + PART_POLYGONS] = rings + rng.uniform(0, np.sqrt(n) * 1.5, (len(rings), 1, 2))
    file.flush()


def own_memory() -> int:
    """Return the memory of this process in bytes, without pages of files."""
    fields = dict(line.split(":") for line in Path("/proc/self/status").read_text().splitlines())
    return int(fields["RssAnon"].split()[0]) * 1024


def main(millions: float) -> None:
    """Print the seconds and the peak memory of finding all collisions."""
    n = round(millions * 1e6)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "polygons.npy")
        write_polygons(path, n)
        batch.colliding_pairs(batch.Polygons(np.load(path, mmap_mode="r")[:1000]))  # kernels loaded
        before, most, done = own_memory(), [0], threading.Event()

        def watch() -> None:
            while not done.wait(0.02):
                most[0] = max(most[0], own_memory())

        threading.Thread(target=watch, daemon=True).start()
        start, found = perf_counter(), 0
        for pairs in batch.stream_colliding_pairs(np.load(path, mmap_mode="r")):
            found += len(pairs)
        seconds = perf_counter() - start
        done.set()
        size = path.stat().st_size
    print(f"{n:,} polygons, {size / 1e9:.2f} GB: {found:,} collisions in {seconds:.0f} s")
    print(f"memory beyond the mapping: {(most[0] - before) / 1e9:.2f} GB at the peak (before: {before / 1e9:.2f} GB)")
    print(f"with the mapped pages: {resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e6:.2f} GB")


if __name__ == "__main__":
    main(float(sys.argv[1]) if len(sys.argv) > 1 else 10)
