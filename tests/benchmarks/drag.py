"""Dragging sv.explore in JupyterLab: does the outline follow, how old is the picture, does the kernel grow?

Run: python tests/benchmarks/drag.py.  A run drags a triangle round an ellipse for three seconds at 60 Hz, in headless
Chromium with the server as it comes.  A picture's age is the time from the pointer's move to the picture that
follows from it.
"""

import sys
import tempfile
from pathlib import Path
from typing import NamedTuple

RUNS = 4
DRAGS = 500

# A pose that is sent is remembered with the time of the move that made it.
WATCH = """() => {
  const [send, decoder] = [WebSocket.prototype.send, new TextDecoder()];
  window.poses = [];
  WebSocket.prototype.send = function (data) {
    const text = typeof data === 'string' ? data : decoder.decode(data);
    if (text.includes('"kind":"pose"')) window.poses.push(window.moved);
    return send.call(this, data);
  };
}"""

# Answers come in the order of the poses, and each drawing sets the label once.
DRAG = """async ([x, y, moves]) => {
  const svg = document.querySelector('.satviz .sv-picture');
  const outline = () => svg.querySelector("[data-layer='2'] [data-id='B.outline']").getAttribute('d');
  const context = jupyterapp.shell.currentWidget.sessionContext;
  const ages = [];
  const seen = new MutationObserver(drawn => drawn.forEach(() => ages.push(performance.now() - window.poses.shift())));
  const count = () => { switches += 1; };
  let [n, followed, switches] = [0, 0, 0];
  window.poses = [];
  seen.observe(svg, {attributes: true, attributeFilter: ['aria-label']});
  context.statusChanged.connect(count);
  const start = performance.now();
  await new Promise(done => {
    const timer = setInterval(() => {
      if (n === moves) return done(clearInterval(timer));
      n += 1;
      const [before, angle] = [outline(), n / 24];
      const at = {clientX: x - 60 + 60 * Math.cos(angle), clientY: y + 30 * Math.sin(angle)};
      window.moved = performance.now();
      svg.dispatchEvent(new PointerEvent('pointermove', {...at, bubbles: true}));
      followed += outline() !== before;
    }, 1000 / 60);
  });
  const seconds = (performance.now() - start) / 1000;
  seen.disconnect();
  context.statusChanged.disconnect(count);
  return {moves, followed, ages, seconds, switches};
}"""

ASK = """async code => {
  let out = '';
  const asked = jupyterapp.shell.currentWidget.sessionContext.session.kernel.requestExecute({code});
  asked.onIOPub = message => { out += message.content.text ?? ''; };
  await asked.done;
  return out.trim();
}"""


class Drag(NamedTuple):
    """What was measured during a drag.

    `followed`: the moves that the outline followed in the same event; `ages`: of the pictures, in milliseconds;
    `switches`: how often the kernel was shown as busy or idle.
    """

    moves: int
    followed: int
    ages: list[float]
    seconds: float
    switches: int

    @property
    def rate(self) -> float:
        """Return the pictures a second."""
        return len(self.ages) / self.seconds

    def age(self, part: float) -> float:
        """Return the age in milliseconds that this part (0 to 1) of the pictures does not exceed."""
        return sorted(self.ages)[min(int(len(self.ages) * part), len(self.ages) - 1)]


def open_explorer(browser, lab):
    """Return a page with a notebook that shows an explorer."""
    page = browser.new_page(viewport={"width": 1400, "height": 1500})
    page.add_init_script(f"({WATCH})()")
    lab.notebook("drag.ipynb", "import satviz as sv\nw = sv.explore('triangles')\nw")
    lab.open(page, "drag.ipynb")
    lab.run_all(page)
    page.locator(".satviz [data-handle]").first.wait_for(timeout=60_000)
    page.wait_for_timeout(1500)
    return page


def press_on_b(page):
    """Move the pointer to B and press; return where."""
    box = page.locator("[data-handle='B-move']").bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    page.mouse.move(x, y)
    page.mouse.down()
    return x, y


def drag_b(page, moves=180) -> Drag:
    """Drag B by so many moves at 60 Hz, then reset the explorer; return what was measured."""
    found = page.evaluate(DRAG, [*press_on_b(page), moves])
    page.mouse.up()
    page.get_by_role("button", name="reset").click()
    page.wait_for_timeout(500)
    return Drag(**found)


def run_in_kernel(page, code):
    """Run code in the kernel and return what it prints."""
    return page.evaluate(ASK, code)


def kernel_bytes(page):
    """Return the bytes of memory that the kernel takes."""
    return int(run_in_kernel(page, "import gc, psutil; gc.collect(); print(psutil.Process().memory_info().rss)"))


def main():
    """Drag in a real JupyterLab and print the measurements."""
    sys.path.insert(0, str(Path(__file__).parents[1]))
    from browser import chromium, jupyterlab

    with tempfile.TemporaryDirectory() as folder, jupyterlab(Path(folder)) as lab, chromium() as browser:
        page = open_explorer(browser, lab)
        print("run  moves  followed  pictures/s  age p50    p90    max ms  busy or idle")
        for i in range(RUNS):
            drag = drag_b(page)
            ages = f"{drag.age(0.5):7.1f}{drag.age(0.9):7.1f}{drag.age(1):7.1f}"
            print(f"{i + 1:3}{drag.moves:7}{drag.followed:10}{drag.rate:12.1f}  {ages}{drag.switches:17}")
        before = kernel_bytes(page)
        for _ in range(DRAGS):
            x, y = press_on_b(page)
            page.mouse.move(x - 40, y)
            page.mouse.move(x, y)
            page.mouse.up()
        page.wait_for_timeout(1000)
        print(f"{DRAGS} drags more: the kernel grew by {(kernel_bytes(page) - before) / 1e6:.2f} MB")


if __name__ == "__main__":
    main()
