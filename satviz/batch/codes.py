"""Relations in int8 arrays: the values of satviz.Relation, and one for what is not known yet."""

APART, TOUCHING, OVERLAPPING, UNDECIDED = 0, 1, 2, -1
