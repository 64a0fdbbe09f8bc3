"""Examples of the reference by public name: the page shows the code, what it prints, and its last value."""

TWO = """a = sv.Polygon([(0, 1), (3, 2), (1, 5)])
b = sv.Polygon([(5, 5), (8, 3), (4, 1)], labels=["v1", "v2", "v3"])"""

EXAMPLES = {
    "satviz.Polygon": 'sv.Polygon([(5, 5), (8, 3), (4, 1)], labels=["v1", "v2", "v3"])',
    "satviz.Circle": "sv.Circle((2, 2), 1)",
    "satviz.relate": f"{TWO}\nsv.relate(a, b)",
    "satviz.record": f"{TWO}\nsv.record(a, b)",
    "satviz.Trace": f"{TWO}\ntrace = sv.record(a, b)\nprint(trace.sentence)\ntrace.certificate",
    "satviz.axis_tests": f"{TWO}\n[test.gap for test in sv.axis_tests(a, b, sv.axes.world(a, b).axes)]",
    "satviz.Shortcut": f"{TWO}\nonly_y = sv.Shortcut('only y', 'y is enough', sv.axes.directions((0, 1)))\n"
    "sv.picture(sv.record(a, b, axes=only_y))",
    "satviz.parts": "ell = sv.Polygon([(0, 0), (4, 0), (4, 2), (2, 2), (2, 4), (0, 4)])\nsv.parts(ell)",
    "satviz.scene": 'sv.scene("circle-polygon")',
    "satviz.scenes": "[scene.name for scene in sv.scenes()][:6]",
    "satviz.link": 'sv.link("triangles", free=30.0, site="https://example.org/satviz")',
    "satviz.embed": 'print(sv.embed("triangles", site="https://example.org/satviz", steps=(3, 8))[:180])\n"..."',
    "satviz.handout": 'print(sv.handout("triangles")[:160])\n"..."',
    "satviz.steps": 'sv.steps(sv.scene("triangles").record())[:4]',
    "satviz.picture": 'sv.picture(sv.scene("triangles").record(), 5)',
    "satviz.draw": 'figure = sv.draw(sv.scene("triangles").record(), step=-1)\n'
    'sv.picture(sv.scene("triangles").record(), -1)  # the same picture, as this page shows it',
    "satviz.sheet": 'sv.sheet(sv.scene("triangles").record())',
    "satviz.difference": f"{TWO}\nsv.difference(sv.record(a, b))",
    "satviz.difference_steps": 'sv.difference_steps("triangles")[-3]',
    "satviz.gap_curve": f"{TWO}\nsv.gap_curve(a, b)",
    "satviz.sweep": 'sv.sweep("triangles")[20]',
    "satviz.engine.axes.needed": f"{TWO}\nsv.record(a, b, axes=sv.axes.needed)",
    "satviz.engine.axes.world": f"{TWO}\nsv.record(a, b, axes=sv.axes.world)",
    "satviz.engine.axes.directions": f"{TWO}\nsv.record(a, b, axes=sv.axes.directions((4, -1)))",
    "satviz.batch.Polygons": "sv.batch.Polygons([[(0, 0), (2, 0), (0, 2)], [(1, 1), (3, 1), (3, 3), (1, 3)]])",
    "satviz.batch.Circles": "sv.batch.Circles([(0, 0), (3, 0), (6, 0)], 1.5)",
    "satviz.batch.relate": "coins = sv.batch.Circles([(0, 0), (3, 0), (7, 0)], 1.5)\nsv.batch.relate(coins[0], coins)",
    "satviz.batch.colliding_pairs": "coins = sv.batch.Circles([(0, 0), (3, 0), (7, 0)], 1.5)\n"
    "sv.batch.colliding_pairs(coins)",
}
