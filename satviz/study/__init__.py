"""Speed against accuracy: collision tests measured beside each other, their answers checked by rational arithmetic.

`workloads` makes pairs of shapes, `methods` answers them, `truth` gives the exact relations, and each module of
`sections` measures one question and draws its charts, with the tools of `harness`.
"""
