"""Words and signs that are known to change no shape, and those that do.  What is on no list is asked about."""

import re


def listed(text: str) -> frozenset[str]:
    """Return the words of a text that has spaces or line ends between them."""
    return frozenset(text.split())


PUNCTUATION = frozenset("'\u2018\u2019\"`\u00b7\u2026\u3002\u202a\u202b\u202c\u202d\u202e$\\#")

# Calls that test, print, draw or hold shapes, by the words of their names.
CALLS = listed(
    """
    c dict structure matrix tensor false true is are has have does do get
    inside hit hits print println printf log console assert existing errorf fatalf dump pairs ipairs enumerate
    expect echo puts debug info warn error write writeln draw stroke fill render add push append insert emplace new
    make create parse load read main describe it should equal equals distance dist separated separating sat gjk epa
    area centroid perimeter len size str repr format fmt display show plot run solve select where crosses covers
    relate manifold contact contacts contour cout trace report out in addshape body static fixture figure
    subplots from text wkt geojson json loads vs compare against detect detection query raycast cast throw return if
    while switch and or not sfc valid simple empty require emit call given when then
    """
)
# Words in the name of a call that give another shape than those in its brackets.
CHANGING_CALLS = listed(
    """
    rotate rotated rotation scale scaled scaling translate translated translation move moved shift shifted transform
    transformed mirror mirrored flip flipped skew shear reflect union unite merge subtract difference xor clip clipped
    buffer offset inflate deflate expand expanded erode dilate grow grown shrink shrunk pad padded inset simplify
    transpose transposed multiply mul divide div mod sum minus plus negate neg resize stretch swap swapped sorted
    reverse reversed project projected normalize normalized round rounded floor ceil trunc abs clamp map mapped filter
    slice lerp interpolate convert degrees radians deg rad double half invert affine apply eval times envelope hull
    minkowski dissolve symmetric snap cross dot zip repeat
    """
)
# Chained methods that leave a shape unchanged.
METHODS = listed(
    """
    topolygon unwrap into tovec to_vec clone copy deepcopy dup duplicate
    tolist to_owned as_ref expect isvalid is_valid toarray asarray build
    collect iter read close closepath endfill toimmutable freeze wkt reshape intersects intersect colliderect
    intersectsrect overlaps contains touches within disjoint equals intersection relate crosses covers almostequals
    intersectswith intersects_with collideswith collides distance done tobe toequal tostrictequal tobecloseto
    """
)
# Methods that give another shape, which is not read.
PRODUCERS = listed(
    """
    union merge unite difference symmetric_difference buffer convex_hull envelope
    """
)
# Chained calls that the reader passes over.
HARMLESS = METHODS | {"union", "merge", "normalize", "normalise", "astype"}
# Keys beside the numbers of a shape whose values change nothing.
KEYS = listed(
    """
    name id type label kind class color colour fill stroke style opacity alpha visible layer category mask group
    static dynamic body sensor trigger tag tags title description comment note index key material texture sprite image
    density friction restitution mass velocity crs srid properties features satviz version expected relation hit area
    length count closed isclosed convex isconvex collides collision overlap overlaps intersects result shape_type flags
    line width linewidth edgecolor facecolor zindex z_index dtype x y z enabled active selected hover url user
    created updated lvl filename axes every_axis device rotated internal isinternal level iscrowd byrow bbox
    fillstyle strokestyle linejoin linecap geometry shape shapes fillcolor strokecolor valid
    """
)
# Words among the numbers of a shape that change nothing.
INSIDE = listed(
    """
    null none nil undefined nullptr true false void self this world space body context ctx screen canvas surface game
    scene renderer window red green blue black white yellow gray grey orange purple pink cyan magenta brown lime color
    colors maroon navy gold skyblue darkblue darkgreen static dynamic kinematic float int double long char var let
    const new float32 float64 np numpy auto val mut final ref out in std vector array list tuple vec f32 f64 i32 i64
    number def setq define defvar defparameter fill line img cuda ax zero identity tensor string byte short unsigned
    polygon circle rect rectangle box point multipolygon feature featurecollection geometrycollection z zm m struct
    frame
    """
)
# Keys outside of brackets that change a shape whatever their value is.
CHANGING_KEYS = listed(
    """
    transform matrix rotate rotation scale scaling flip flipx flipy mirror mirrored skew shear origin pivot anchor
    """
)
# Words of a sentence about a shape that change it.
CHANGING_WORDS = listed(
    """
    rotated turned scaled mirrored flipped shifted moved offset translated twice half halved doubled inflated skewed
    stretched transposed squared
    """
)
# Words in a key, or in the name of a call, whose numbers change a shape.
CHANGING_NUMBERS = listed(
    """
    scale scaling zoom offset transform transform2d matrix mat3 affine origin originx originy anchor pivot skew shear
    flip mirror rotate rotation rot angle orientation degrees radians translate translation position pos move shift
    displacement center centre radius diameter skin margin rounding roundness rx ry size extents width height holes
    interiors thickness buffer inflate grow shrink pad padding unit units ratio factor ppm isometry pose sides
    """
)
# Words in a key, or in the name of a call, whose numbers are none of a shape.
OTHER_NUMBERS = listed(
    """
    velocity vel speed axes force torque gravity mass inertia density friction restitution color colour fill stroke
    alpha opacity window canvas screen viewport viewbox svg area count length index id label layer category mask group
    time timestamp step size_t sleep stiffness damping damp slop constraint render print printf println log assert
    prev previous impulse motion tolerance epsilon eps expected distance dist camera image version line error warn info
    background strokeweight fps framerate type srid iscrowd score ts bbox rows capacity make satviz contact vx vy vz
    fixture moment linewidth zindex elasticity bounce text font style figsize dpi xlim ylim mtv normal depth penetration
    overlap wkid fn
    """
)
# A line with one of these words can describe a shape relative to another shape.
DIFFERENCES = listed("left right up down above below larger smaller bigger wider taller narrower times same")
# Words that change a shape on the line of one, and say nothing on another line: double k = 2, the sum of the radii
_NEEDS_A_SHAPE = listed(
    "double sum dot cross zip map mapped filter slice convert eval apply repeat project projected normalize normalized"
)
ANY_CHANGE = (CHANGING_CALLS | CHANGING_WORDS | CHANGING_KEYS | CHANGING_NUMBERS | DIFFERENCES) - _NEEDS_A_SHAPE
# Words before a name that gets a value.
DECLARES = frozenset(["def", "setq", "define", "defvar", "defparameter"])
# Parts of the names of calls that test shapes: with one of these, `rotated` in a name is no change.
TESTS = re.compile(
    r"intersect|overlap|colli[ds]|test|check|(?<![a-z])iou(?![a-z])|disjoint|touch|contain|within|impact", re.IGNORECASE
)
ADJECTIVES = listed("rotated scaled translated transformed moved rounded")
# Words of calls that draw or print a shape, whose other numbers change none.
SAYS = listed("assert print printf println log expect echo puts cout import console")
COMPARING = listed("return if elif while for")
DRAWS = frozenset(["draw", "fill", "stroke", "plot", "print", "printf", "show", "render", "cv2.drawContours"])
# Types around one number: np.float64(0.5) is 0.5.
CASTS = frozenset(
    [
        "FT",
        "RT",
        "Fraction",
        "Float64",
        "np.float64",
        "np.float32",
        "np.int64",
        "np.int32",
        "numpy.float64",
        "Decimal",
        "double",
        "b2MakeRot",
    ]
)
# Words before and after a number that counts or names something.
LABELS = listed(
    """
    circle polygon box rect rectangle shape triangle version length capacity object obj line step
    """
)
COUNTED = listed(
    """
    rows row corner corners point points vertex vertices verts pts edge edges shapes polygons circles boxes ms fps
    times people users rectangles triangles pixel pixels bodies
    """
)
# Words that say that the numbers after them hold only sometimes, or several times.
FLOW = frozenset(["else", "elif", "for", "while", "foreach", "case", "switch", "repeat", "until", "lambda", "map"])


def words(name: str) -> frozenset[str]:
    """Return the words of a name, without case: rigidBody.maxSpeed has rigid, body, max, speed."""
    parts = re.split(r"[^A-Za-z0-9]+", name)
    camel = (word for part in parts for word in re.findall(r"[A-Z]?[a-z]+|[A-Z]+(?![a-z])|[0-9]+", part))
    return frozenset(word.lower() for word in (*parts, *camel) if word)
