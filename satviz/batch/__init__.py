"""Many pairs at once: exact like satviz.relate, near the machine's speed (loads NumPy)."""

from .arrays import Shapes
from .broad_phase import broad_phase_of, candidate_pairs
from .collide import colliding_pairs, stream_colliding_pairs
from .constructors import Circles, Polygons, concat, from_padded, from_shapely
from .moving import move, place
from .narrow_phase import hits, relate

__all__ = [
    "Circles",
    "Polygons",
    "Shapes",
    "broad_phase_of",
    "candidate_pairs",
    "colliding_pairs",
    "concat",
    "from_padded",
    "from_shapely",
    "hits",
    "move",
    "place",
    "relate",
    "stream_colliding_pairs",
]
