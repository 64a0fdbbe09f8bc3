"""The table of notations: what a name before a bracket, or a key in an object, means.  A new notation is one row.

Names are compared without case, and by their end: `new SAT.Vector` is found as "vector", and `Bodies.rectangle`
before "rectangle" because the longer ending comes first.
"""

import re
from typing import NamedTuple

from .tree import parts_of


class Kind:
    """What a row of the table is: a shape, several of them, what moves one, or what is not read."""

    POINT, RING, CIRCLE, BOX, MANY, MOVE, ARC = "point", "ring", "circle", "box", "many", "move", "arc"
    ELLIPSE, OTHER_SHAPE, ON_THE_GLOBE, TABLE = "ellipse", "other", "globe", "table"


class Form:
    """How numbers are meant, in the words of `--as`: first the four numbers of a box."""

    CORNER_SIZE, CORNER_CORNER, CENTER_SIZE, CENTER_HALF = "corner-size", "corner-corner", "center-size", "center-half"
    X_THEN_Y, SIZE_CORNER = "x-then-y", "size-corner"
    DEGREES, RADIANS, RADIUS, DIAMETER = "degrees", "radians", "radius", "diameter"
    Y_UP, Y_DOWN, WIDTH_FIRST, HEIGHT_FIRST = "y-up", "y-down", "width-first", "height-first"
    EACH_VALUE, LAST_VALUE = "each-value", "last-value"
    RELATIVE, ABSOLUTE, UNTURNED = "relative", "absolute", "unturned"
    DECIMAL_COMMAS, SEPARATORS = "decimal-commas", "separators"
    AROUND_CENTER, AROUND_CORNER, AROUND_ORIGIN = "around-center", "around-corner", "around-origin"
    LEAVE_OUT = "leave-out"  # the shapes stand without what was not understood
    TAKE_IN = "take-in"  # what may be a shape is one


class Ask:
    """What can be asked."""

    BOX_FORM, ANGLE, TURN, ORDER, PIVOT, CORNERS = "box", "angle", "turn", "order", "pivot", "corners"
    ROUND, TWICE, COMMAS = "round", "twice", "commas"


class Notation(NamedTuple):
    """One row: what the names mean; of a box its form, or () where it is asked; of an angle its unit, or ""."""

    names: str
    kind: str
    form: str = ""
    ask: tuple[str, ...] = ()
    unit: str = ""
    keyed: str = ""  # the form of a box with the keys x, y, width and height
    alone: bool = False  # a box or circle given by its size has its corner, not its center, at the position of its body


ANY_BOX = (Form.CORNER_SIZE, Form.CORNER_CORNER, Form.CENTER_SIZE, Form.CENTER_HALF)
CORNER_OR_CENTER = (Form.CORNER_SIZE, Form.CENTER_SIZE)

NOTATIONS = (
    Notation(
        "vector vector2 vector2f vector2d vector2i vec vec2 vec2f dvec2 point point2 point2d pointf point2f "
        "dpoint coord coordinate position c2v b2vec2 cpv v2 v pt xy float2 double2 make_point make_float2 pvector "
        "vector.create cgpoint qpoint qpointf offset latlng vector3 vector3f vec3 point3d cgsize qsize qsizef "
        "size size2 vertex ccp point64 pointd intpoint pointsingle corner pvec2 makepoint st_point st_makepoint p "
        "point_2 fvector2d pos2",
        Kind.POINT,
    ),
    # polygons, and the lists that hold their points
    Notation(
        "polygon polygon2d poly convexpolygon simplepolygon convex_polygon polygonshape path2d linestring "
        "linearring line_string list vec! array asarray tuple list.of arrays.aslist listof arrayof floatarrayof "
        "doublearrayof packedvector2array poolvector2array float double int long f32 f64 createpolygon convexhull "
        "convex_hull_shape from_convex_hull c2poly vertices points shape geometry svg.path svg.polyline makepath "
        "path64 pathd paths64 pathsd addface polyshape triangle quad addpolygon simplepolygon2d "
        "collisionpolygon2d convexpolygonshape2d convexpolygon2d plt.plot ax.plot plt.fill ax.fill patch "
        "fillpolygon drawpolygon zip column_stack rbind cbind newpolygonshape edgecollider polygoncollider2d addpoly "
        "seq set z zm tensor double[][] float32array float64array makepolygon fromvertices create_polygon convex "
        "newpolygon newconvexpolygon polygon_2 cppolyshapenew b2computehull b2makepolygon polygonhull arraybuffer",
        Kind.RING,
    ),
    Notation(
        "circle circle2d ball disc disk createcircle circleshape boundingcircle addcircle drawcircle "
        "newcirclecollider c2circle newcircle circleimpl circlef circleshape2d newcircleshape "
        "circlecollider2d makecircle create_circle b2circle cpcircleshapenew arc ellipse2d draw_circle_filled "
        "draw_circle_outline",
        Kind.CIRCLE,
    ),
    # boxes
    Notation(
        "bodies.rectangle add.rectangle bodies.rect boxshape2d centered_rect rotatedrect p2.box p2.rectangle "
        "create_box rect::from_center_size display.newrect newrectangleshape rect.fromcenter "
        "rectangleshape2d boxcollider2d setfromcenterandsize "
        "draw_rectangle_filled draw_rectangle_outline",
        Kind.BOX,
        Form.CENTER_SIZE,
    ),
    Notation(
        "rectangle rectanglef rect2 rect2i newrect qrect qrectf cgrect cgrectmake sf::rect floatrect intrect "
        "pygame.rect frect ccrectmake ccrect svg.rect rect.fromltwh makerect rectmake fillrect strokerect "
        "drawrectangle newrectanglecollider sdl_rect setrect sdl_frect domrect rectangle2d.double "
        "rectangle2d.float recti rectint cv.rect ofrectangle makexywh lbwh from_min_size",
        Kind.BOX,
        Form.CORNER_SIZE,
    ),
    Notation(
        "shapely.box geometry.box st_makeenvelope makeenvelope bbox boundingbox ltrb pixel.r image.rect rect64 "
        "rectd rect.fromltrb rect.frompoints rect::from_corners create_rectangle RECT RECTL lnglatbounds "
        "latlngbounds cpbbnew rectf BOX iso_rectangle_2 bb box2.new three.box2 fbox2d bboxpolygon setfrompoints "
        "boundingrect minmaxrect from_two_pos from_min_max crect makeltrb",
        Kind.BOX,
        Form.CORNER_CORNER,
    ),
    Notation("cv2.rectangle cv.rectangle imagedraw.rectangle", Kind.BOX, Form.CORNER_CORNER),
    Notation("phaser.circle", Kind.CIRCLE, Form.DIAMETER),
    Notation("bounds", Kind.BOX, Form.CENTER_SIZE, keyed=Form.CORNER_SIZE),
    Notation("envelope referencedenvelope", Kind.BOX, ask=(Form.X_THEN_Y, Form.CORNER_CORNER)),
    Notation("jts.env lrbt", Kind.BOX, Form.X_THEN_Y),
    Notation("size.at", Kind.BOX, Form.SIZE_CORNER),
    Notation("c2aabb aabb aabb2d aabb2 box2 box2d b2aabb extent", Kind.BOX, ask=(Form.CORNER_CORNER, Form.CENTER_HALF)),
    Notation(
        "aabb2d::new rect::from_center_half_size cuboid b2makebox setasbox b2makeoffsetbox b2makesquare pl.box "
        "planck.box hyperrectangle",
        Kind.BOX,
        Form.CENTER_HALF,
    ),
    Notation("rect", Kind.BOX, ask=ANY_BOX, keyed=Form.CORNER_SIZE),
    Notation("box createbox obb orientedbox", Kind.BOX, ask=ANY_BOX),
    Notation("rectangleshape", Kind.BOX, Form.CORNER_SIZE, alone=True),
    Notation("sf::circleshape", Kind.CIRCLE, alone=True),
    Notation("ellipse", Kind.ELLIPSE),
    Notation("ellipse2d.double ellipse2d.float filloval drawoval tiled.ellipse", Kind.ELLIPSE, Form.CORNER_SIZE),
    Notation(
        "capsule b2capsule capsule2d capsuleshape2d segment b2segment linesegment line ray edge roundedrect "
        "roundedbox b2makeroundedbox makeroundedbox stadium matrix roundrectangle2d.double roundrectangle2d.float "
        "roundrect rrect drawrectanglepro drawpoly box3 box3d aabb3d cube sphere bodies.polygon bodies.trapezoid "
        "create_oval oval rhombus star wedge ring arcshape regularpolygon capsulecollider2d compositecollider2d "
        "segmentshape2d worldboundaryshape2d separationrayshape2d pentagon hexagon heptagon octagon ngon diamond pill",
        Kind.OTHER_SHAPE,
    ),
    Notation("setbounds drawrect", Kind.BOX, ask=(Form.CORNER_SIZE, Form.CORNER_CORNER)),
    Notation("unknown.table", Kind.TABLE),
    Notation("turf.circle l.circle maps.circle", Kind.ON_THE_GLOBE),
    Notation("square", Kind.BOX, ask=(Form.CORNER_SIZE, Form.CENTER_SIZE)),
    # what moves the next shape
    Notation(
        "isometry::new isometry2::new translation translation2 isometry::identity isometry2::identity transform",
        Kind.MOVE,
        unit=Form.RADIANS,
    ),
    # many shapes in one
    Notation("circularstring", Kind.ARC),
    Notation("multipolygon geometrycollection featurecollection scene world", Kind.MANY),
)
NAMES = {name: row for row in NOTATIONS for name in row.names.split()}
MAX_WORDS = max(len(re.split(r"\.|::|->", name)) for name in NAMES)

# Texts whose shapes cannot be told from their lines: what they are, and what helps.
UNREAD = (
    (
        re.compile(r"<(?:\w+:)?innerBoundaryIs>|<gml:(?:interior|pos|lowerCorner)>|\bsrsDimension=.3"),
        "GML or KML with holes, with a third coordinate or with an element for each corner is not read: "
        "paste each outer ring as POLYGON((x y, ...))",
    ),
    (re.compile(r"^<{7} ", re.MULTILINE), "two versions of a text (<<<<<<<, =======): keep the lines of one of them"),
    (
        re.compile(r"^[ \t]*canvas(?:\.\w+)?:", re.MULTILINE),
        "instructions of Kivy are not read: write each shape on its own line, such as Rectangle(10, 20, 100, 50)",
    ),
    (
        re.compile(r"^[ \t]*(?:shape_type: TYPE_|embedded_collision_shape)", re.MULTILINE),
        "a collision object of Defold is not read: write each shape on its own line, such as box(x, y, width, height)",
    ),
)

# Calls with the numbers of two shapes: the notation of each, and how many numbers it has.
TWO_SHAPES = {
    "colliderectrect": (("qrect", 4), ("qrect", 4)),
    "collidecirclecircle": (("ellipse", 3), ("ellipse", 3)),
    "colliderectcircle": (("qrect", 4), ("ellipse", 3)),
    "colliderectpoly": (("qrect", 4),),
    "collidecirclepoly": (("ellipse", 3),),
    "checkcollision": (("qrect", 4), ("qrect", 4)),
    "rectrect": (("qrect", 4), ("qrect", 4)),
    "circlecircle": (("c2circle", 3), ("c2circle", 3)),
    "circlerect": (("c2circle", 3), ("qrect", 4)),
    "rectangle_in_rectangle": (("rectd", 4), ("rectd", 4)),
}
# Names of tests with the points of two shapes: the notation of each, and how many points it has.
TWO_OF_A_KIND = (
    (re.compile(r"triangle", re.IGNORECASE), "triangle", 3),
    (re.compile(r"aabb|box|rect", re.IGNORECASE), "box", 2),
)

# Keys of objects, and what is assigned to a variable's fields, without case, `_` and a leading `m`.
KEYS = {
    name: meaning
    for meaning, names in {
        "points": "vertices verts points corners polygon coords path hull outline pts vertexlist ring exterior poly "
        "pointlist vertex coordinates vertices2d polyline",
        "center": "center centre pos position translation location circle middle mid c p centroid centro mittelpunkt",
        "corner": "corner xy topleft bottomleft upperleft lowerleft start origin",
        "opposite": "bottomright topright lowerright upperright",
        "radius": "radius r radio rayon raggio raio",
        "x": "x posx px cx xc xcenter centerx lon lng longitude",
        "y": "y posy py cy yc ycenter centery lat latitude",
        "width": "width w sx dx",
        "height": "height h sy dy",
        "size": "size dimensions extent wh dims s",
        "offset": "offset",
        "diameter": "diameter diam",
        "half": "halfextents half extents halfsize he halfextent",
        "halfwidth": "hx halfwidth hw",
        "halfheight": "hy halfheight hh",
        "min": "min mins lower lowerbound minimum minpoint southwest",
        "max": "max maxs upper upperbound maximum maxpoint northeast",
        "x0": "x0 xmin minx left l x1of2 west bboxleft",
        "y0": "y0 ymin miny top t south bboxtop",
        "x1": "xmax maxx right east bboxright",
        "y1": "ymax maxy bottom north bboxbottom",
        "angle": "angle turn rotation rot theta orientation yaw heading",
        "degrees": "degrees angledeg rotationdegrees deg angledegrees",
        "radians": "radians anglerad rad angleradians",
    }.items()
    for name in names.split()
}
# Calls that move a shape, and that turn it.
MOVES = frozenset(["translate", "translation", "setposition", "settranslation", "moveto", "setoffset", "set_position"])
# Calls that move what has a place already by so much.
SHIFTS = frozenset(["translate", "offset", "move_ip", "moveby", "move_by"])
TURNS = {
    "rotate": "",
    "setangle": "",
    "rotation": "",
    "setrotation": "",
    "set_rotation": "",
    "set_angle": "",
    "rotatedeg": Form.DEGREES,
    "rotatedegrees": Form.DEGREES,
}
SETTERS = frozenset(["set", "setxy"])
# Chained calls that give an empty box its numbers.
MAKERS = frozenset(["setfrompoints", "setfromcenterandsize"])
# Calls that give a box or a circle all its numbers anew, in the order of the call that made it.
RESETS = frozenset(["set", "setto", "setbounds", "setrect", "setframe", "update"])


# Words in the name of a call that makes a shape, and of one that takes a list of numbers as corners.
SHAPE_WORDS = re.compile(
    r"polygon|circle|ellipse|rect|square(?!d)|box|ball|triangle|quad|capsule|\barc|cuboid|hull|aabb|cylinder|disc|disk",
    re.IGNORECASE,
)
LIST_WORDS = re.compile(
    r"poly|triangle|quad|path|hull|point|vert|shape|convex|outline|contour|coord|ring|geom|array|list|vec|tuple|line|\bc$",
    re.IGNORECASE,
)

# How words begin that name a shape or a list of corners.
_STEMS = (
    "poly tri quad path hull point pt vert shape convex outline contour coord ring geom array list vec tuple circle "
    "ellipse rect box ball capsule arc cuboid obb aabb cylinder disc disk"
)
SHAPE_STEMS = (*_STEMS.split(),)


def notation(name: str) -> Notation | None:
    """Return the row of a name, by its longest ending that the table has; None for an unknown name."""
    if name in NAMES:  # RECT is that of Windows, and Rect is not
        return NAMES[name]
    plain = name.lower().split("<")[0].rstrip("!") if "<" in name else name.lower()
    for ending in ("::new", "::from", ".new", "_t"):
        plain = plain.removesuffix(ending) if plain not in NAMES else plain
    words = parts_of(plain)[-MAX_WORDS:]
    last = words[-1].rstrip("!")
    for candidate in (plain, *(".".join(words[i:]) for i in range(len(words))), last, last.rstrip("0123456789")):
        if candidate in NAMES:
            return NAMES[candidate]
    return None


def key(name: str | int) -> str:
    """Return the meaning of a key, or "" for an unknown one."""
    if isinstance(name, int):
        return ""
    plain = name.lower().replace("_", "").replace("-", "").replace(" ", "")
    member = name[:2] == "m_" or name[1:2].isupper()  # m_radius, mRadius
    return KEYS.get(plain) or (KEYS.get(plain.removeprefix("m"), "") if member else "")
