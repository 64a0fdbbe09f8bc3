"""Dragging in JupyterLab: the outline at once, pictures in time, a kernel that does not grow.

Bounds that a busy machine keeps; tests/benchmarks/drag.py prints the figures.
"""

from benchmarks.drag import dragged, kernel_bytes, opened
from browser import jupyterlab

IDLE = "() => jupyterapp.shell.currentWidget.sessionContext.session.kernel.status === 'idle'"


def test_a_drag_is_followed_at_once_and_answered_soon(browser, tmp_path):
    with jupyterlab(tmp_path) as lab:
        page = opened(browser, lab)
        dragged(page)  # what is made once
        before = kernel_bytes(page)
        drag = dragged(page, moves=500)
        assert drag.followed == drag.moves
        assert drag.rate >= 5 and drag.age(0.5) < 500
        assert drag.switches < len(drag.ages) / 10  # the kernel is shown as busy until the drag ends,
        page.wait_for_function(IDLE)  # and no longer
        assert kernel_bytes(page) - before < 5e6
        page.close()
