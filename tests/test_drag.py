"""Poses sent faster than Python answers: none is lost, the outline is at once there, the kernel does not grow.

Bounds that a busy machine keeps; tests/benchmarks/drag.py prints the figures.
"""

import pytest
from benchmarks.drag import drag_b, kernel_bytes, open_explorer, run_in_kernel
from browser import jupyterlab

pytestmark = pytest.mark.slow

IDLE = "() => jupyterapp.shell.currentWidget.sessionContext.session.kernel.status === 'idle'"

KEYS = """async () => {
  const handle = document.querySelector("[data-handle='B-move']");
  for (let i = 0; i < 10; i += 1) {
    handle.dispatchEvent(new KeyboardEvent('keydown', {key: 'ArrowLeft', bubbles: true}));
    await new Promise(done => setTimeout(done, 15));
  }
}"""


@pytest.fixture(scope="module")
def page(browser, tmp_path_factory):
    with jupyterlab(tmp_path_factory.mktemp("drag")) as lab:
        found = open_explorer(browser, lab)
        yield found
        found.close()


def test_a_drag_is_followed_at_once_and_answered_soon(page):
    drag_b(page)  # what is made once
    before = kernel_bytes(page)
    drag = drag_b(page, moves=500)
    assert drag.followed == drag.moves
    assert drag.rate >= 5 and drag.age(0.5) < 500
    assert drag.switches < len(drag.ages) / 10  # the kernel is shown as busy until the drag ends,
    page.wait_for_function(IDLE)  # and no longer
    assert kernel_bytes(page) - before < 5e6


def test_keys_pressed_faster_than_python_answers_all_count(page):
    page.evaluate(KEYS)
    for _ in range(100):
        moved = float(run_in_kernel(page, "print(sv.scene('triangles').b.vertices[0].x - w.scene.b.vertices[0].x)"))
        if moved == pytest.approx(1):
            break
        page.wait_for_timeout(50)
    assert moved == pytest.approx(1)  # ten steps of 0.1
