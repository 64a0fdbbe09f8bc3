"""Speed against accuracy: collision tests measured together, and their answers checked by rational arithmetic.

`workloads` makes pairs of shapes, `methods` answers them, `truth` gives the exact relations, and each module of
`sections` measures one question and draws its charts, with the tools of `harness`.
"""
