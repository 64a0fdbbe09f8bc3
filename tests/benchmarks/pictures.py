"""Measure the milliseconds to make a picture, to update and redraw a figure, and to draw a figure afresh.

Run: python tests/benchmarks/pictures.py.  The ways are taken in turn within a round
over every step of the article's triangles; medians over all steps and rounds.
"""

import statistics
from time import perf_counter

import satviz as sv
from satviz.pictures import LIGHT
from satviz.render.files import canvas

ROUNDS = 7


def main():
    """Measure and print the medians."""
    trace = sv.scene("triangles").record()
    count = len(sv.steps(trace))
    fig, pen = canvas(sv.picture(trace, 0).size, LIGHT)
    fig.set_dpi(100)
    times = {"picture made": [], "updated and redrawn": [], "drawn afresh": []}

    def timed(name, work):
        """Run the work, note its milliseconds under the name, and return its result."""
        start = perf_counter()
        result = work()
        times[name].append((perf_counter() - start) * 1e3)
        return result

    def redraw(picture):
        """Update the kept figure and draw it."""
        pen.draw(picture)
        fig.canvas.draw()

    def draw_afresh(picture):
        """Draw a figure made for this picture alone."""
        new, other = canvas(picture.size, LIGHT)
        new.set_dpi(100)
        other.draw(picture)
        new.canvas.draw()

    for _ in range(ROUNDS):
        for i in range(count):
            picture = timed("picture made", lambda i=i: sv.picture(trace, i))
            timed("updated and redrawn", lambda p=picture: redraw(p))
            timed("drawn afresh", lambda p=picture: draw_afresh(p))
    for name, values in times.items():
        print(f"{name:20} {statistics.median(values):6.1f} ms")


if __name__ == "__main__":
    main()
