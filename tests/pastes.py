"""Texts as they stand in trackers, logs and files, in notations of many libraries, with what they mean, by hand.

`bounds`: the bounding box of each shape (x0, y0, x1, y1), in the order of the text.  `as_`: the reading to take, for a
text that can mean several things.  `says`: words of a finding, for a text with a part that must be named instead.
`asks`: a question is right.
A name with `#` is that of a public thread (facts only: retyped numbers and notation).
"""

from typing import NamedTuple

Box = tuple[float, float, float, float]


class Paste(NamedTuple):
    """A text, the bounds of its shapes, the reading to take, words of a finding, and whether a question is right."""

    name: str
    text: str
    bounds: tuple[Box, ...]
    as_: str = ""
    says: str = ""
    asks: bool = False


PASTES = (
    # -- of public threads
    Paste(
        "alexbol99/flatten-js#42",
        """const { polygon } = require('@flatten-js/core');
const item1 = polygon([
  [0, 30],
  [30, 30],
  [30, 0],
  [0, 0],
  [0, 30],
]);

const item2 = polygon([
  [10, 20],
  [20, 20],
  [20, 10],
  [10, 10],
  [10, 20],
]);
const intersection = intersect(item1, item2);""",
        ((0, 0, 30, 30), (10, 10, 20, 20)),
    ),
    Paste(
        "alexbol99/flatten-js#42 (as it prints)",
        """item1
<path stroke="black" stroke-width="1" fill="lightcyan" fill-rule="evenodd" fill-opacity="1"   d="
M0,30 L30,30 L30,0 L0,0 L0,30 L0,30 z" >
</path>
item2
<path stroke="black" stroke-width="1" fill="lightcyan" fill-rule="evenodd" fill-opacity="1"   d="
M10,20 L20,20 L20,10 L10,10 L10,20 L10,20 z" >
</path>""",
        ((0, 0, 30, 30), (10, 10, 20, 20)),
    ),
    Paste(
        "alexbol99/flatten-js#50",
        """  let a = new Polygon([
    point(10,10),
    point(10, 100),
    point(100, 100),
    point(100, 10),
  ]);
  let b = new Polygon([
    point(90,50),
    point(120, 10),
    point(120, 100)
  ]);
  let stage = d3.select(DOM.svg(400, 400));""",
        ((10, 10, 100, 100), (90, 10, 120, 100)),
    ),
    Paste(
        "alexbol99/flatten-js#171",
        """const polygon = new Flatten.Polygon();
polygon.addFace([ point(90, 10), point(100, 10), point(100, 50), point(90, 50) ]);
polygon.addFace([ point(100, 0), point(120, 0), point(120, 10), point(100, 10) ]);
let contains = ray_shoot(polygon, point(85, 10)); // should be OUTSIDE, returns INSIDE instead""",
        ((90, 10, 100, 50), (100, 0, 120, 10)),
        says="ray_shoot",
    ),
    Paste(
        "AngusJohnson/Clipper2#771",
        """    Rect64 rcClip = { 0, 0, 100, 100 };

    Path64 phClip = {
        { -50, 50 },
        { 50, 50 },
        { -50, 60 }
    };""",
        ((0, 0, 100, 100), (-50, 50, 50, 60)),
        as_="corner-corner",
    ),
    Paste(
        "AngusJohnson/Clipper2#1095",
        """    clipper::Rect64 rect(19669914, -390330085, 24669914, -385330085);

    clipper::Paths64 polygon;
    polygon.push_back(
        {{8821540, -379573701},
         {27274660, -333900624},
         {72947737, -352353745},
         {54494616, -398026821}}
    );""",
        ((19669914, -390330085, 24669914, -385330085), (8821540, -398026821, 72947737, -333900624)),
    ),
    Paste(
        "AngusJohnson/Clipper2#470",
        """subj.Add(Clipper.MakePath(new double[] { 2217.08, -44400.32, 2217.08, -44385.16, 1992.08, -44385.16,
    1992.08, -44403.69 }));

clip.Add(Clipper.MakePath(new double[] { 2217.08, -44208.84, 1992.08, -44208.84, 1992.08, -44468.84,
    2217.08, -44468.84 }));""",
        ((1992.08, -44403.69, 2217.08, -44385.16), (1992.08, -44468.84, 2217.08, -44208.84)),
    ),
    Paste(
        "AngusJohnson/Clipper2#828",
        """var rect = new Rect64(l: 0, t: 0, r: 19000, b: 27700);

var polyline = new Path64
([
        new (0    , 0     ), new (0    , 27700 ), new (19000, 27700 ), new (19000, 0     ),
]);""",
        ((0, 0, 19000, 27700), (0, 0, 19000, 27700)),
    ),
    Paste(
        "AngusJohnson/Clipper2#807",
        """     List<PointD> ps = new List<PointD>();
     ps.Add(new PointD(200, 1000));
     ps.Add(new PointD(3300, 1000));
     ps.Add(new PointD(3300, 600));
     ps.Add(new PointD(200, 600));
     ps.Add(new PointD(200, 1000));
     List<PointD> qs = new List<PointD>();
     qs.Add(new PointD(0, 0));
     qs.Add(new PointD(500, 0));
     qs.Add(new PointD(500, 1520));
     qs.Add(new PointD(0, 1520));""",
        ((200, 600, 3300, 1000), (0, 0, 500, 1520)),
    ),
    Paste(
        "schteppe/p2.js#373",
        """    function triangle(a, b, c) {
        var shape = new p2.Convex({ vertices: [a, b, c] });
        var body = new p2.Body({ mass: 1 });
        body.addShape(shape)
    }
    triangle([0, 2], [-1, 0], [1, 0])
    triangle([-1.5, 1.5], [-2, 1], [-1, 1]).velocity = [0.3, 0]""",
        ((-1, 0, 1, 2), (-2, 1, -1, 1.5)),
    ),
    Paste(
        "raysan5/raylib#3742",
        """    std::vector<Vector2> vertices_b = {
        { 668.678406, 60.9284592 },
        { 629.318420, 53.7983131 },
        { 622.188721, 93.1581116 },
        { 661.548462, 100.287857 }
    };
    std::vector<Vector2> vertices_a = {
        { 600, 40 }, { 640, 40 }, { 640, 80 }, { 600, 80 }
    };""",
        ((622.188721, 53.7983131, 668.678406, 100.287857), (600, 40, 640, 80)),
    ),
    Paste(
        "kikito/bump.lua#33",
        """- blue rectangle is at (0,32) and is 16x16
- red rectangle is at (16,0) and is 32x32""",
        ((0, 32, 16, 48), (16, 0, 48, 32)),
        as_="corner-size",
    ),
    Paste(
        "godotengine/godot#32159",
        """     var t = new Rect2(0, 0, 16f, 16f);
    var t1 = new Rect2(16f, 16f, 16f, 16f);
    var intersects = t.Intersects(t1); // True but should be false""",
        ((0, 0, 16, 16), (16, 16, 32, 32)),
    ),
    Paste(
        "FNA-XNA/FNA#748 (as it prints)",
        """it returns `{X:831 Y:831 Width:1142 Height:514}`, which is incorrect.
then the result is correct: `{X:476 Y:831 Width:1497 Height:514}`""",
        ((831, 831, 1973, 1345), (476, 831, 1973, 1345)),
        as_="corner-size",
    ),
    Paste(
        "tidwall/geojson#14",
        """    exterior := make([]geometry.Point, 5)
    exterior[0] = geometry.Point{X: 0, Y: 0}
    exterior[1] = geometry.Point{X: 6000, Y: 0}
    exterior[2] = geometry.Point{X: 10, Y: 10.1}
    exterior[3] = geometry.Point{X: 0, Y: 10}
    exterior[4] = geometry.Point{X: 0, Y: 0}

    polygon := geometry.NewPoly(exterior, nil, nil)
    rectangle := geometry.Rect{
        Min: geometry.Point{X: 2560, Y: 0},
        Max: geometry.Point{X: 5120, Y: 2560},
    }""",
        ((0, 0, 6000, 10.1), (2560, 0, 5120, 2560)),
    ),
    Paste(
        "faiface/pixel#277",
        """    r1 := pixel.R(0, 0, 10, 10)
    r2 := pixel.R(10, 10, 20, 20)     // No real overlap, just corners touching.
    fmt.Println(r1.Intersect(r2))     // Output Rect(0, 0, 0, 0)""",
        ((0, 0, 10, 10), (10, 10, 20, 20)),
        as_="corner-corner",
    ),
    Paste(
        "fabricjs/fabric.js#112",
        """this.getCoords() = [
    {
        "x": 184.3121256194882,
        "y": 240.11726225449226
    },
    {
        "x": 118.66702533880131,
        "y": 163.35971663753963
    },
    {
        "x": 142.22627201331153,
        "y": 143.21122051178426
    }
]

t.getCoords() = [
    {
        "x": -40.478773405749614,
        "y": -22.726386584929344
    },
    {
        "x": -106.12387368643653,
        "y": -99.48393220188196
    },
    {
        "x": -82.56462701192632,
        "y": -119.63242832763734
    }
]""",
        (
            (118.66702533880131, 143.21122051178426, 184.3121256194882, 240.11726225449226),
            (-106.12387368643653, -119.63242832763734, -40.478773405749614, -22.726386584929344),
        ),
    ),
    Paste(
        "alexbol99/flatten-boolean-op#6",
        """    let polygon1 = new Polygon();
    polygon1.addFace([point(0.0594, 0.1436), point(0.1011, 0.0883),
    point(0.1091, 0.0943), point(0.0674, 0.1497)]);

    let circle1 = new Polygon();
    circle1.addFace([arc(point(0.06444813, 0.1461997), 0.01, 0, 2*Math.PI, false)]);""",
        ((0.0594, 0.0883, 0.1091, 0.1497),),
        says="arc",
    ),
    # -- keys that change a shape
    Paste(
        "scale in an object",
        """{"type": "rect", "x": 0, "y": 0, "width": 10, "height": 10, "scaleX": 2, "scaleY": 2}
circle((15, 5), 1)""",
        ((0, 0, 10, 10), (14, 4, 16, 6)),
        as_="corner-size",
        says="scaleX",
    ),
    Paste(
        "offset of a circle collider",
        """a = {position: {x: 0, y: 0}, offset: {x: 5, y: 0}, radius: 1}
b = circle((5, 0), 1)""",
        ((4, -1, 6, 1), (4, -1, 6, 1)),
    ),
    Paste(
        "offset of a polygon",
        """{"vertices": [[0,0],[4,0],[0,3]], "offset": [10, 0]}
circle((0, 0), 1)""",
        ((10, 0, 14, 3), (-1, -1, 1, 1)),
        as_="relative",
    ),
    Paste(
        "transform in an SVG rect",
        """<rect x="0" y="0" width="10" height="10" transform="translate(20, 5)"/>
<circle cx="5" cy="5" r="3"/>""",
        ((20, 5, 30, 15), (2, 2, 8, 8)),
    ),
    Paste(
        "a matrix in an SVG rect",
        """<rect x="0" y="0" width="10" height="10" transform="matrix(2 0.3 -0.2 3 4 5)"/>
<circle cx="5" cy="5" r="3"/>""",
        ((2, 5, 24, 38), (2, 2, 8, 8)),
    ),
    Paste(
        "originX of Fabric",
        """new fabric.Rect({ left: 100, top: 100, originX: 'center', originY: 'center', width: 20, height: 20 })
new fabric.Circle({ left: 0, top: 0, radius: 5 })""",
        ((90, 90, 110, 110), (0, 0, 10, 10)),
    ),
    Paste(
        "diameter",
        """{"center": [0, 0], "diameter": 10}
{"center": [9, 0], "diameter": 10}""",
        ((-5, -5, 5, 5), (4, -5, 14, 5)),
    ),
    Paste(
        "scale of a polygon",
        """poly = Polygon(points=[(0,0),(4,0),(0,3)], scale=2)
circle((5, 0), 1)""",
        ((0, 0, 4, 3), (4, -1, 6, 1)),
        says="scale",
    ),
    Paste(
        "Phaser's ellipse circle and origin",
        """this.add.circle(100, 100, 40)
this.add.rectangle(150, 100, 40, 20).setOrigin(0, 0)""",
        ((60, 60, 140, 140),),
        says="setOrigin",
    ),
    # -- x and y apart
    Paste(
        "Java's arrays",
        """int[] xa = {0, 10, 10, 0};
int[] ya = {0, 0, 10, 10};
Polygon a = new Polygon(xa, ya, 4);
int[] xb = {10, 20, 20, 10};
int[] yb = {0, 0, 5, 5};
Polygon b = new Polygon(xb, yb, 4);""",
        ((0, 0, 10, 10), (10, 0, 20, 5)),
    ),
    Paste(
        "Java's arrays in the call",
        """new Polygon(new int[]{0, 10, 10, 0}, new int[]{0, 0, 10, 10}, 4)
new Polygon(new int[]{30, 40, 40}, new int[]{0, 0, 10}, 3)""",
        ((0, 0, 10, 10), (30, 0, 40, 10)),
    ),
    Paste(
        "x and y lists in Python",
        """x1 = [0, 4, 4, 0]
y1 = [0, 0, 4, 4]
x2 = [5, 9, 9, 5, 5]
y2 = [0, 0, 4, 4, 2]""",
        ((0, 0, 4, 4), (5, 0, 9, 4)),
    ),
    Paste(
        "MATLAB's polyshape",
        """poly1 = polyshape([0 0 1 1],[1 0 0 1]);
poly2 = polyshape([0.75 1.25 1.25 0.75],[0.25 0.25 0.75 0.75]);""",
        ((0, 0, 1, 1), (0.75, 0.25, 1.25, 0.75)),
    ),
    Paste(
        "xs and ys as keys",
        """{"xs": [0, 4, 4], "ys": [0, 0, 4]}
{"xs": [3, 9, 9], "ys": [0, 0, 4]}""",
        ((0, 0, 4, 4), (3, 0, 9, 4)),
    ),
    # -- indices
    Paste(
        "a missing index",
        """v[0] = Vec2(0, 0);
v[1] = Vec2(4, 0);
v[3] = Vec2(0, 4);
circle((9, 9), 1)""",
        ((8, 8, 10, 10),),
        says="v[2]",
    ),
    Paste(
        "indices from 1",
        """v[1] = Vec2(0, 0)
v[2] = Vec2(4, 0)
v[3] = Vec2(0, 4)
circle((9, 9), 1)""",
        ((0, 0, 4, 4), (8, 8, 10, 10)),
    ),
    # -- text around shapes
    Paste(
        "timestamps",
        """[2023-10-05 12:13:14.123] INFO polygon A: [(0,0), (4,0), (4,4), (0,4)]
[2023-10-05 12:13:14.125] INFO polygon B: [(5,0), (9,0), (9,4), (5,4)]""",
        ((0, 0, 4, 4), (5, 0, 9, 4)),
    ),
    Paste(
        "timestamps without brackets",
        """2023-10-05T12:13:14.123Z DEBUG a = (0,0), (4,0), (4,4), (0,4)
2023-10-05T12:13:14.125Z DEBUG b = (5,0), (9,0), (9,4), (5,4)""",
        ((0, 0, 4, 4), (5, 0, 9, 4)),
    ),
    Paste(
        "a log prefix with a thread",
        """12:00:01 [main/INFO]: box 1: Rect(0, 0, 10, 10)
12:00:02 [main/INFO]: box 2: Rect(10, 0, 10, 10)""",
        ((0, 0, 10, 10), (10, 0, 20, 10)),
        as_="corner-size",
    ),
    Paste(
        "text after a bracket",
        """[(0,0), (4,0), (4,4), (0,4)] is the first polygon (4 corners)
[(5,0), (9,0), (9,4), (5,4)] is the second one, 1 away""",
        ((0, 0, 4, 4), (5, 0, 9, 4)),
        says="1",
    ),
    Paste(
        "numbered lines",
        """1: (0,0) (4,0) (4,4) (0,4)
2: (5,0) (9,0) (9,4) (5,4)""",
        ((0, 0, 4, 4), (5, 0, 9, 4)),
    ),
    Paste(
        "numbered list",
        """1. (0,0), (4,0), (4,4), (0,4)
2. (5,0), (9,0), (9,4), (5,4)""",
        ((0, 0, 4, 4), (5, 0, 9, 4)),
    ),
    # -- two lists on one line
    Paste("vs", "[(0,0), (4,0), (0,3)] vs [(5,0), (9,0), (9,4)]", ((0, 0, 4, 3), (5, 0, 9, 4))),
    Paste("and", "(0,0) (4,0) (0,3) and (5,0) (9,0) (9,4)", ((0, 0, 4, 3), (5, 0, 9, 4))),
    Paste("an arrow", "[0,0,4,0,0,3] -> [5,0,9,0,9,4]", ((0, 0, 4, 3), (5, 0, 9, 4))),
    Paste("a semicolon", "0,0 4,0 0,3; 5,0 9,0 9,4", ((0, 0, 4, 3), (5, 0, 9, 4))),
    Paste("vs without brackets", "0,0 4,0 0,3 vs 5,0 9,0 9,4", ((0, 0, 4, 3), (5, 0, 9, 4))),
    Paste("and between points", "(0,0), (4,0), (0,3) and (5,0), (9,0), (9,4)", ((0, 0, 4, 3), (5, 0, 9, 4))),
    Paste(
        "with",
        "polygon (0,0), (4,0), (0,3) collides with polygon (5,0), (9,0), (9,4)",
        ((0, 0, 4, 3), (5, 0, 9, 4)),
    ),
    # -- languages and libraries
    Paste(
        "C++ declarations",
        """sf::Vector2f a1(0, 0), a2(4, 0), a3(0, 3);
sf::CircleShape c(2.f);
c.setPosition(10, 10);""",
        ((10, 10, 14, 14),),
        says="a1",
    ),
    Paste(
        "C++ variables",
        """Circle c(Vec2(0, 0), 2.0f);
Rect r{1, 1, 4, 4};""",
        ((-2, -2, 2, 2), (1, 1, 5, 5)),
        as_="corner-size",
    ),
    Paste(
        "SFML",
        """sf::RectangleShape rect(sf::Vector2f(120.f, 50.f));
rect.setPosition(10.f, 20.f);
sf::RectangleShape rect2(sf::Vector2f(20.f, 50.f));
rect2.setPosition(sf::Vector2f(130.f, 20.f));""",
        ((10, 20, 130, 70), (130, 20, 150, 70)),
    ),
    Paste(
        "SFML's circle",
        """sf::CircleShape c(10.f);
c.setPosition(0.f, 0.f);
sf::FloatRect r(18, 18, 5, 5);""",
        ((0, 0, 20, 20), (18, 18, 23, 23)),
    ),
    Paste(
        "XNA",
        """Rectangle player = new Rectangle(100, 100, 32, 48);
Rectangle wall = new Rectangle(132, 100, 64, 64);""",
        ((100, 100, 132, 148), (132, 100, 196, 164)),
    ),
    Paste(
        "Unity's Bounds",
        """var a = new Bounds(new Vector3(0, 0, 0), new Vector3(2, 2, 0));
var b = new Bounds(new Vector3(2, 0, 0), new Vector3(2, 2, 0));""",
        ((-1, -1, 1, 1), (1, -1, 3, 1)),
    ),
    Paste(
        "Unity's Bounds as printed",
        """Center: (0.0, 0.0, 0.0), Extents: (1.0, 1.0, 0.0)
Center: (2.0, 0.0, 0.0), Extents: (1.0, 1.0, 0.0)""",
        ((-1, -1, 1, 1), (1, -1, 3, 1)),
    ),
    Paste(
        "Unity's Rect",
        """new Rect(0, 0, 10, 10).Overlaps(new Rect(10, 0, 10, 10))""",
        ((0, 0, 10, 10), (10, 0, 20, 10)),
        as_="corner-size",
    ),
    Paste(
        "Unity's Rect as printed",
        """(x:0.00, y:0.00, width:10.00, height:10.00)
(x:5.00, y:0.00, width:10.00, height:10.00)""",
        ((0, 0, 10, 10), (5, 0, 15, 10)),
        as_="corner-size",
    ),
    Paste(
        "Unity's colliders",
        """collider.points = new Vector2[] { new Vector2(0, 0), new Vector2(4, 0), new Vector2(0, 3) };
collider.offset = new Vector2(10, 0);
other.points = new Vector2[] { new Vector2(0, 0), new Vector2(4, 0), new Vector2(0, 3) };""",
        ((10, 0, 14, 3), (0, 0, 4, 3)),
        as_="relative",
    ),
    Paste(
        "Godot's prints",
        """[P: (0, 0), S: (10, 10)]
[P: (10, 0), S: (5, 5)]""",
        ((0, 0, 10, 10), (10, 0, 15, 5)),
        as_="corner-size",
    ),
    Paste(
        "Godot's Transform2D",
        """var t = Transform2D(0, Vector2(10, 0))
var a = PackedVector2Array([Vector2(0, 0), Vector2(4, 0), Vector2(0, 3)])
var b = PackedVector2Array([Vector2(10, 0), Vector2(14, 0), Vector2(10, 3)])
print(t * a)""",
        ((0, 0, 4, 3), (10, 0, 14, 3)),
        says="Transform2D",
    ),
    Paste(
        "Godot's scene file",
        """[node name="A" type="CollisionPolygon2D" parent="."]
position = Vector2(100, 0)
polygon = PackedVector2Array(0, 0, 10, 0, 10, 10, 0, 10)

[node name="B" type="CollisionPolygon2D" parent="."]
polygon = PackedVector2Array(0, 0, 10, 0, 10, 10, 0, 10)""",
        ((100, 0, 110, 10), (0, 0, 10, 10)),
        as_="relative",
    ),
    Paste(
        "Godot's shapes",
        """var s = RectangleShape2D.new()
s.size = Vector2(20, 10)
var c = CircleShape2D.new()
c.radius = 5""",
        ((-10, -5, 10, 5), (-5, -5, 5, 5)),
    ),
    Paste(
        "CSV with a header",
        """id,x,y,w,h
a,0,0,10,10
b,10,0,10,10""",
        ((0, 0, 10, 10), (10, 0, 20, 10)),
        as_="corner-size",
    ),
    Paste(
        "CSV of corners",
        """shape,x,y
A,0,0
A,4,0
A,0,3
B,5,0
B,9,0
B,9,4""",
        ((0, 0, 4, 3), (5, 0, 9, 4)),
    ),
    Paste(
        "CSV of circles",
        """x,y,radius
0,0,5
10,0,5""",
        ((-5, -5, 5, 5), (5, -5, 15, 5)),
    ),
    Paste(
        "a Markdown table",
        """| name | x | y | width | height |
|------|---|---|-------|--------|
| a | 0 | 0 | 10 | 10 |
| b | 10 | 0 | 10 | 10 |""",
        ((0, 0, 10, 10), (10, 0, 20, 10)),
        as_="corner-size",
    ),
    Paste(
        "a Markdown table of corners",
        """| A | B |
|---|---|
| (0, 0) | (5, 0) |
| (4, 0) | (9, 0) |
| (0, 3) | (9, 4) |""",
        ((0, 0, 4, 3), (5, 0, 9, 4)),
    ),
    Paste(
        "a table with spaces",
        """x    y    w    h
0    0    10   10
10   0    10   10""",
        ((0, 0, 10, 10), (10, 0, 20, 10)),
        as_="corner-size",
    ),
    Paste(
        "SVG",
        """<svg viewBox="0 0 100 100">
  <circle cx="50" cy="50" r="10" fill="red"/>
  <rect x="60" y="40" width="20" height="20"/>
  <polygon points="0,0 10,0 10,10"/>
  <ellipse cx="5" cy="5" rx="3" ry="2"/>
</svg>""",
        ((40, 40, 60, 60), (60, 40, 80, 60), (0, 0, 10, 10)),
        says="ellipse",
    ),
    Paste(
        "an SVG path, relative",
        """<path d="M 10 10 h 10 v 10 h -10 z"/>
<path d="m 30,10 10,0 0,10 z"/>""",
        ((10, 10, 20, 20), (30, 10, 40, 20)),
    ),
    Paste(
        "an SVG path with curves",
        """<path d="M 10 10 C 20 20, 40 20, 50 10 z"/>
<circle cx="50" cy="50" r="10"/>""",
        ((40, 40, 60, 60),),
        says="curve",
    ),
    Paste(
        "paths in a script",
        """const a = new Path2D("M0 0 L10 0 L10 10 Z");
const b = new Path2D("M5 5 H15 V15 Z");""",
        ((0, 0, 10, 10), (5, 5, 15, 15)),
    ),
    Paste(
        "GeoJSON strings",
        r"""SELECT ST_AsGeoJSON(a): "{\"type\":\"Polygon\",\"coordinates\":[[[0,0],[4,0],[0,3],[0,0]]]}"
b: '{"type":"Polygon","coordinates":[[[5,0],[9,0],[9,4],[5,0]]]}'""",
        ((0, 0, 4, 3), (5, 0, 9, 4)),
    ),
    Paste(
        "raylib",
        """Rectangle a = { 0, 0, 10, 10 };
Rectangle b = { 10, 0, 10, 10 };
bool hit = CheckCollisionRecs(a, b);""",
        ((0, 0, 10, 10), (10, 0, 20, 10)),
        as_="corner-size",
    ),
    Paste(
        "raylib's circle",
        """CheckCollisionCircleRec((Vector2){ 5, 5 }, 2.0f, (Rectangle){ 7, 0, 10, 10 })""",
        ((3, 3, 7, 7), (7, 0, 17, 10)),
        as_="corner-size",
    ),
    Paste(
        "raylib's circles",
        """CheckCollisionCircles((Vector2){0, 0}, 5, (Vector2){9, 0}, 5);""",
        ((-5, -5, 5, 5), (4, -5, 14, 5)),
    ),
    Paste(
        "p2.js",
        """var box = new p2.Box({ width: 2, height: 1 });
var body = new p2.Body({ mass: 1, position: [3, 4] });
body.addShape(box);
var circle = new p2.Circle({ radius: 1 });
var body2 = new p2.Body({ mass: 1, position: [5, 4] });
body2.addShape(circle);""",
        ((2, 3.5, 4, 4.5), (4, 3, 6, 5)),
    ),
    Paste(
        "planck.js",
        """const a = world.createBody({ position: Vec2(0, 10) });
a.createFixture(planck.Box(2, 1), { density: 1 });
const b = world.createBody(Vec2(5, 10));
b.createFixture(planck.Circle(1), 1.0);""",
        ((-2, 9, 2, 11), (4, 9, 6, 11)),
    ),
    Paste(
        "planck.js with a center",
        """pl.Box(2, 1, Vec2(10, 0), 0)
pl.Circle(Vec2(13, 0), 1)""",
        ((8, -1, 12, 1), (12, -1, 14, 1)),
    ),
    Paste(
        "pymunk",
        """body = pymunk.Body(1, 100)
body.position = (50, 60)
shape = pymunk.Poly.create_box(body, (20, 10))
body2 = pymunk.Body(1, 100)
body2.position = (70, 60)
shape2 = pymunk.Circle(body2, 10)""",
        ((40, 55, 60, 65), (60, 50, 80, 70)),
    ),
    Paste(
        "pymunk's prints",
        """BB(left=0.0, bottom=0.0, right=10.0, top=10.0)
BB(left=10.0, bottom=0.0, right=20.0, top=10.0)""",
        ((0, 0, 10, 10), (10, 0, 20, 10)),
    ),
    Paste(
        "a body of Matter.js as printed",
        """{
  "id": 3, "type": "body", "label": "Rectangle Body", "angle": 0,
  "vertices": [
    {"x": 0, "y": 0, "index": 0, "isInternal": false},
    {"x": 40, "y": 0, "index": 1, "isInternal": false},
    {"x": 40, "y": 40, "index": 2, "isInternal": false},
    {"x": 0, "y": 40, "index": 3, "isInternal": false}
  ],
  "position": {"x": 20, "y": 20},
  "velocity": {"x": 0, "y": 0}, "mass": 1.6, "density": 0.001,
  "bounds": {"min": {"x": 0, "y": 0}, "max": {"x": 40, "y": 40}}
}
{
  "id": 4, "type": "body", "label": "Rectangle Body", "angle": 0,
  "vertices": [
    {"x": 40, "y": 0, "index": 0, "isInternal": false},
    {"x": 80, "y": 0, "index": 1, "isInternal": false},
    {"x": 80, "y": 40, "index": 2, "isInternal": false},
    {"x": 40, "y": 40, "index": 3, "isInternal": false}
  ],
  "position": {"x": 60, "y": 20},
  "velocity": {"x": 0, "y": 0}, "mass": 1.6, "density": 0.001,
  "bounds": {"min": {"x": 40, "y": 0}, "max": {"x": 80, "y": 40}}
}""",
        ((0, 0, 40, 40), (40, 0, 80, 40)),
        as_="absolute",
    ),
    Paste(
        "Matter.js",
        """Bodies.circle(100, 100, 20)
Bodies.polygon(140, 100, 6, 20)
Bodies.rectangle(100, 140, 40, 40, { angle: 0 })""",
        ((80, 80, 120, 120), (80, 120, 120, 160)),
        says="Bodies.polygon",
    ),
    Paste(
        "Box2D",
        """b2PolygonShape box;
box.SetAsBox(1.0f, 2.0f, b2Vec2(5, 5), 0);
b2CircleShape circle;
circle.m_p.Set(7, 5);
circle.m_radius = 1.0f;""",
        ((4, 3, 6, 7), (6, 4, 8, 6)),
    ),
    Paste(
        "Box2D's bodies",
        """bodyDef.position.Set(0.0f, 10.0f);
b2PolygonShape box;
box.SetAsBox(1.0f, 2.0f);
circle((1.5, 10), 1)""",
        ((-1, -2, 1, 2), (0.5, 9, 2.5, 11)),
        says="bodyDef.position",
    ),
    Paste(
        "Processing",
        """rect(10, 10, 50, 50);
ellipse(60, 35, 20, 20);
circle(200, 200, 30);""",
        ((10, 10, 60, 60), (50, 25, 70, 45), (185, 185, 215, 215)),
    ),
    Paste(
        "p5.js with rectMode",
        """rectMode(CENTER);
rect(50, 50, 20, 20);
rect(75, 50, 20, 20);""",
        ((40, 40, 60, 60), (65, 40, 85, 60)),
    ),
    Paste(
        "Processing's triangle and quad",
        """triangle(30, 75, 58, 20, 86, 75);
quad(38, 31, 86, 20, 69, 63, 30, 76);""",
        ((30, 20, 86, 75), (30, 20, 86, 76)),
    ),
    Paste(
        "Processing's shapes",
        """beginShape();
vertex(0, 0);
vertex(40, 0);
vertex(0, 30);
endShape(CLOSE);
beginShape();
vertex(50, 0);
vertex(90, 0);
vertex(90, 40);
endShape(CLOSE);""",
        ((0, 0, 40, 30), (50, 0, 90, 40)),
    ),
    Paste(
        "a canvas",
        """ctx.beginPath();
ctx.moveTo(0, 0);
ctx.lineTo(40, 0);
ctx.lineTo(0, 30);
ctx.closePath();
ctx.beginPath();
ctx.arc(100, 75, 50, 0, 2 * Math.PI);
ctx.fillRect(10, 10, 5, 5);""",
        ((0, 0, 40, 30), (50, 25, 150, 125), (10, 10, 15, 15)),
    ),
    Paste(
        "line by line, boxes",
        """x1 = 0; y1 = 0; w1 = 10; h1 = 10
x2 = 10; y2 = 0; w2 = 10; h2 = 10""",
        ((0, 0, 10, 10), (10, 0, 20, 10)),
        as_="corner-size",
    ),
    Paste(
        "line by line, circles",
        """x1 = 0
y1 = 0
r1 = 5
x2 = 9
y2 = 0
r2 = 5""",
        ((-5, -5, 5, 5), (4, -5, 14, 5)),
    ),
    Paste(
        "line by line, fields",
        """a.x = 0; a.y = 0; a.width = 10; a.height = 10;
b.x = 10; b.y = 0; b.width = 10; b.height = 10;""",
        ((0, 0, 10, 10), (10, 0, 20, 10)),
        as_="corner-size",
    ),
    Paste(
        "line by line, corners",
        """ax = 0; ay = 0; bx = 4; by = 0; cx = 0; cy = 3;
circle((9, 9), 1)""",
        ((8, 8, 10, 10),),
        says="ax 0; ay 0",
    ),
    Paste(
        "Kotlin and Android",
        """val a = Rect(0, 0, 10, 10)
val b = RectF(10f, 0f, 20f, 10f)""",
        ((0, 0, 10, 10), (10, 0, 20, 10)),
        as_="corner-corner",
    ),
    Paste(
        "Swift",
        """let a = CGRect(x: 0, y: 0, width: 10, height: 10)
let b = CGRect(origin: CGPoint(x: 10, y: 0), size: CGSize(width: 5, height: 5))""",
        ((0, 0, 10, 10), (10, 0, 15, 5)),
    ),
    Paste(
        "Flutter",
        """Rect.fromLTWH(0, 0, 10, 10).overlaps(Rect.fromLTRB(10, 0, 20, 10))
Rect.fromCenter(center: Offset(5, 5), width: 2, height: 2)""",
        ((0, 0, 10, 10), (10, 0, 20, 10), (4, 4, 6, 6)),
    ),
    Paste(
        "Go",
        """a := image.Rect(0, 0, 10, 10)
b := image.Rect(10, 0, 20, 10)
fmt.Println(a.Overlaps(b))""",
        ((0, 0, 10, 10), (10, 0, 20, 10)),
    ),
    Paste(
        "Go as printed",
        """(0,0)-(10,10) overlaps (10,0)-(20,10)""",
        ((0, 0, 10, 10), (10, 0, 20, 10)),
        as_="corner-corner",
    ),
    Paste(
        "three.js",
        """new THREE.Box2(new THREE.Vector2(0, 0), new THREE.Vector2(10, 10))
new THREE.Box2(new THREE.Vector2(10, 0), new THREE.Vector2(20, 10))""",
        ((0, 0, 10, 10), (10, 0, 20, 10)),
        as_="corner-corner",
    ),
    Paste(
        "Pixi",
        """new PIXI.Circle(0, 0, 5)
new PIXI.Rectangle(5, -5, 10, 10)
new PIXI.Polygon(0, 0, 4, 0, 0, 3)""",
        ((-5, -5, 5, 5), (5, -5, 15, 5), (0, 0, 4, 3)),
    ),
    Paste(
        "Konva",
        """new Konva.Rect({ x: 0, y: 0, width: 10, height: 10, offsetX: 5, offsetY: 5 })
new Konva.Circle({ x: 10, y: 0, radius: 5 })""",
        ((0, 0, 10, 10), (5, -5, 15, 5)),
        as_="corner-size",
        says="offsetX",
    ),
    Paste(
        "Kaboom",
        """add([rect(20, 40), pos(100, 50), area()])
add([rect(20, 40), pos(120, 50), area()])""",
        (),
        says="not a corner",
    ),
    Paste(
        "macroquad",
        """let a = Rect::new(0.0, 0.0, 10.0, 10.0);
let b = Rect { x: 10.0, y: 0.0, w: 10.0, h: 10.0 };
assert!(!a.overlaps(&b));""",
        ((0, 0, 10, 10), (10, 0, 20, 10)),
        as_="corner-size",
    ),
    Paste(
        "Rust's debug prints",
        """Rect { min: Vec2(0.0, 0.0), max: Vec2(10.0, 10.0) }
Polygon { exterior: LineString([Coord { x: 0.0, y: 0.0 },
    Coord { x: 4.0, y: 0.0 }, Coord { x: 0.0, y: 3.0 }]), interiors: [] }""",
        ((0, 0, 10, 10), (0, 0, 4, 3)),
    ),
    Paste(
        "Rapier",
        """ColliderBuilder::cuboid(1.0, 2.0).translation(vector![5.0, 5.0])
ColliderBuilder::ball(1.0).translation(vector![7.0, 5.0])""",
        ((4, 3, 6, 7), (6, 4, 8, 6)),
    ),
    Paste(
        "a scaled shape in shapely",
        """a = affinity.scale(Polygon([(0, 0), (4, 0), (0, 3)]), 2, 2)
b = Point(5, 0).buffer(1)""",
        ((0, 0, 4, 3),),
        says="scale",
    ),
    Paste(
        "shapely's prints",
        """<POLYGON ((0 0, 4 0, 0 3, 0 0))>
<POLYGON ((5 0, 9 0, 9 4, 5 0))>""",
        ((0, 0, 4, 3), (5, 0, 9, 4)),
    ),
    Paste(
        "LÖVE",
        """love.graphics.polygon("fill", 0, 0, 40, 0, 0, 30)
love.graphics.rectangle("line", 40, 0, 10, 10)
love.graphics.circle("fill", 60, 5, 5)""",
        ((0, 0, 40, 30), (40, 0, 50, 10), (55, 0, 65, 10)),
    ),
    Paste(
        "bump.lua",
        """world:add(A, 0, 0, 64, 256)
world:add("B", 64, 0, 32, 32)""",
        ((0, 0, 64, 256), (64, 0, 96, 32)),
    ),
    Paste(
        "bump.lua, moved",
        """world:add(A, 0, 0, 64, 256)
world:add(B, 64, 0, 32, 32)
world:move(B, 0, 64)""",
        ((0, 0, 64, 256), (64, 0, 96, 32)),
        says="move",
    ),
    Paste(
        "three.js, boxes of points",
        """const pts = [new THREE.Vector2(0, 0), new THREE.Vector2(4, 1), new THREE.Vector2(2, 4)];
const a = new THREE.Box2().setFromPoints(pts);
const b = new THREE.Box2();
b.setFromPoints([new THREE.Vector2(3, 0), new THREE.Vector2(7, 4)]);
const c = new THREE.Box2().setFromCenterAndSize(new THREE.Vector2(3, 0), new THREE.Vector2(8, 4));
const d = new THREE.Box2();
d.set(new THREE.Vector2(3, 0), new THREE.Vector2(7, 4));""",
        ((0, 0, 4, 4), (3, 0, 7, 4), (-1, -2, 7, 2), (3, 0, 7, 4)),
    ),
    Paste(
        "turf.bboxPolygon",
        """const bbox = [0, 0, 4, 4];
const a = turf.bboxPolygon(bbox);
const b = turf.bboxPolygon([3, 0, 7, 4]);""",
        ((0, 0, 4, 4), (3, 0, 7, 4)),
    ),
    Paste(
        "paper.js",
        """var a = new paper.Path.Rectangle({ from: new Point(0, 0), to: new Point(4, 4), strokeColor: 'black' });
var b = new Path.Rectangle({point: [3, 3], size: [4, 4]});
var c = new Path.Circle(new Point(3, 3), 2);""",
        ((0, 0, 4, 4), (3, 3, 7, 7), (1, 1, 5, 5)),
    ),
    Paste(
        "YAML",
        """a:
  x: 0
  y: 0
  radius: 5
b:
  x: 9
  y: 0
  radius: 5""",
        ((-5, -5, 5, 5), (4, -5, 14, 5)),
    ),
    Paste(
        "YAML lists",
        """- x: 0
  y: 0
  width: 10
  height: 10
- x: 10
  y: 0
  width: 10
  height: 10""",
        ((0, 0, 10, 10), (10, 0, 20, 10)),
        as_="corner-size",
    ),
    Paste(
        "YOLO labels",
        """0 0.5 0.5 0.2 0.2
0 0.6 0.5 0.2 0.2""",
        (),
        says="five",
    ),
    Paste(
        "DOMRect",
        """DOMRect {x: 8, y: 8, width: 100, height: 50, top: 8, right: 108, bottom: 58, left: 8}
DOMRect {x: 108, y: 8, width: 100, height: 50, top: 8, right: 208, bottom: 58, left: 108}""",
        ((8, 8, 108, 58), (108, 8, 208, 58)),
    ),
    Paste(
        "boxes of a detector",
        """xmin=0, ymin=0, xmax=10, ymax=10
xmin=10, ymin=0, xmax=20, ymax=10""",
        ((0, 0, 10, 10), (10, 0, 20, 10)),
    ),
    Paste(
        "a wider box",
        """box1 = {'x1': 0, 'x2': 10, 'y1': 0, 'y2': 10}
box2 = {'x1': 10, 'x2': 20, 'y1': 0, 'y2': 10}""",
        ((0, 0, 10, 10), (10, 0, 20, 10)),
    ),
    Paste(
        "decimal commas",
        """(0,5; 0,5) (4,5; 0,5) (0,5; 3,5)
(5,5; 0,5) (9,5; 0,5) (9,5; 4,5)""",
        ((0.5, 0.5, 4.5, 3.5), (5.5, 0.5, 9.5, 4.5)),
        as_="decimal-commas",
    ),
    Paste(
        "words around numbers",
        """circle 1 at (0, 0) with radius 5
circle 2 at (9, 0) with radius 5""",
        ((-5, -5, 5, 5), (4, -5, 14, 5)),
    ),
    Paste(
        "words without brackets",
        """Circle A: center 0, 0 radius 5
Circle B: center 9, 0 radius 5""",
        ((-5, -5, 5, 5), (4, -5, 14, 5)),
    ),
    # -- the second collection: none of it was seen while the reader was changed for the first
    Paste(
        "love2d/love#622",
        """shape = love.physics.newPolygonShape(0, 0, 10, 0, 10, 10, 0, 10)

shape2 = love.physics.newRectangleShape(10, 10)

body = love.physics.newBody(world, 0, 0, "dynamic")""",
        ((0, 0, 10, 10), (-5, -5, 5, 5)),
        says="newBody 0, 0",
    ),
    Paste(
        "w8r/martinez#6",
        """Test case: rectangle with a trapezoid, with one edge overlapping:
[ [ 0, 3.5 ], [ 0, 0 ], [ 21, 0 ], [ 21, 3.5 ], [ 0, 3.5 ] ] (rectangle)
[ [ 21, 7 ], [ 0, 7 ], [ 7, 0 ], [ 14, 0 ], [ 21, 7 ] ] (trapezoid)""",
        ((0, 0, 21, 3.5), (0, 0, 21, 7)),
    ),
    Paste(
        "w8r/martinez#90",
        "martinez.union([[ [0,0],[10,0],[10,10],[0,10] ]], [[ [9,10],[21,9],[21,21],[9,21]   ]])",
        ((0, 0, 10, 10), (9, 9, 21, 21)),
    ),
    Paste(
        "w8r/martinez#97",
        """const poly1 = [[
    [0, 0],
    [1, 0],
    [1, 1],
    [0, 1],
    [0, 0]
]];

const poly2 = [[
    [0.5, 0.0],
    [0.6, 0.5],
    [0.7, 0.5],
    [0.5, 0.0]
]];
const intersectionPolygon = martinezPolygonClipping.intersection(poly1, poly2);""",
        ((0, 0, 1, 1), (0.5, 0, 0.7, 0.5)),
    ),
    Paste(
        "mfogel/polygon-clipping#78 (rounded)",
        """const poly = [[
    [-82.5, -143.1],
    [-39.9, -30.1],
    [82.4, -8.0],
    [162.3, -98.8],
    [16.4, 28.1]
], [
    [63.8, 190.5],
    [1.4, 213.0],
    [-111.9, 192.4],
    [-162.9, 149.5],
    [-15.0, -25.7]
]]""",
        ((-82.5, -143.1, 162.3, 28.1), (-162.9, -25.7, 63.8, 213)),
    ),
    Paste(
        "paperjs/paper.js#870 (rounded)",
        """var path1 = new Path({
    segments: [
        [388.92, 223.32, 0, 0, 120.27, -2.24],
        [597.61, 242.94, 0, 0, 0, 0],
        [628.03, 243.03, 0, 0, -0.03, 10.68],
        [419.27, 364.27, 0, 0]
    ],
    closed: true
});
new Path.Circle(new Point(400, 300), 10)""",
        ((390, 290, 410, 310),),
        says="segments",
    ),
    Paste(
        "paperjs/paper.js#1647 (shortened)",
        """var pathA = PathItem.create("M0,0h60v60h-60z");
var pathB = PathItem.create("M60,47c-0.89,-0.001 -1.72,0.49 -2.17,1.25l-12.12,21z");""",
        ((0, 0, 60, 60),),
        says="curve",
    ),
    Paste(
        "paperjs/paper.js#1923",
        """        const rect = new Path.Rectangle(0, 0, 300, 200)
        rect.fillColor = 'black'
        const circ = new Path.Circle(new Point(150, 100), 100)
        circ.fillColor = 'red'
        console.log(circ.isInside(rect))""",
        ((0, 0, 300, 200), (50, 0, 250, 200)),
    ),
    Paste(
        "facebookresearch/detectron2#1207",
        """boxes1 = torch.tensor([[160.0, 153.0, 230.0,  23.0, -37.0]], device='cuda')
boxes2 = torch.tensor([[190.0, 127.0,  80.0,  21.0, -46.0]], device='cuda')
print(pairwise_iou_rotated(RotatedBoxes(boxes1), RotatedBoxes(boxes2)))""",
        (
            (61.236043578312774, 74.60696397197057, 258.7639564216872, 231.39303602802943),
            (154.66059727808428, 90.93249509663448, 225.33940272191572, 163.06750490336552),
        ),
        as_="y-down width-first",
        says="RotatedBoxes",
    ),
    Paste(
        "facebookresearch/detectron2#4961",
        """box1 = torch.tensor([1010.5, 860.00012207, 12.20655537, 48.82622528, 55.00798035],
    dtype=torch.float32)[None, :]
box2 = torch.tensor([1022, 870.49993896, 10.81665134, 43.26660919, 56.30992889], dtype=torch.float32)[None, :]

iou = pairwise_iou_rotated(box1, box2)""",
        (
            (986.9999988303772, 841.0001215208896, 1034.0000011696227, 879.0001226191104),
            (1001.0000037029782, 853.9999407522608, 1042.9999962970219, 886.9999371677392),
        ),
        as_="y-down width-first",
    ),
    Paste(
        "mjq11302010044/RRPN#44",
        """b1 = np.array([[46.83, 44.03, 3.9, 1.63, 0]], dtype=np.float32)
b2 = np.array([[46.83, 44.03, 1.63, 3.9, 1.45]], dtype=np.float32)
rbbox_overlaps(b1, b2) = 1.35""",
        (
            (44.879999999999995, 43.215, 48.78, 44.845),
            (44.7959999104423, 42.985958512038, 48.8640000895577, 45.074041487962),
        ),
        as_="radians y-down",
        says="1.35",
    ),
    Paste(
        "openlayers/openlayers#9175",
        """    var o = [-11187597.46284663, 4524022.231466765, -11186622.98660283, 4523917.644560398]
    var p = new ol.geom.Polygon.fromExtent(o)
    var n = [o[0] - 10, o[1] - 10, o[2] + 10, o[3] - 10]
    if (p.intersectsExtent(n)) {""",
        ((-11187597.46284663, 4523917.644560398, -11186622.98660283, 4524022.231466765),),
        as_="corner-corner",
        says="not evaluated",
    ),
    Paste(
        "DanielJDufour/geo-extent#11",
        """{
    "min": {
        "x": 2409321.727264079,
        "y": -965489.1535151823
    },
    "max": {
        "x": 2577147.829325225,
        "y": -835571.8532756742
    }
}
{"min": {"x": 0, "y": 0}, "max": {"x": 1, "y": 1}}""",
        ((2409321.727264079, -965489.1535151823, 2577147.829325225, -835571.8532756742), (0, 0, 1, 1)),
    ),
    Paste(
        "shapely/shapely#1767 (shortened)",
        """>>> import shapely

>>> p1 = shapely.from_geojson(
...     '{"type": "Polygon", "coordinates": [[[-0.05, 43.06], [-0.02, 43.2], [0.009, 43.05], [-0.05, 43.06]]]}'
... )
>>>
>>> p2 = shapely.from_geojson(
...     '{"type": "Polygon", "coordinates": [[[2.99, 42.62], [3.0, 42.67], [3.04, 42.83], [2.99, 42.62]]]}'
... )""",
        ((-0.05, 43.05, 0.009, 43.2), (2.99, 42.62, 3.04, 42.83)),
    ),
    Paste(
        "flame-engine/flame#2827",
        """    final points = [
      Vector2(0.9, 0.1),
      Vector2(0.2, -0.8),
      Vector2(-0.7, 0.2),
      Vector2(0.1, 0.6),
    ];
    hitbox = PolygonHitbox.relative(points, parentSize: Vector2(300, 300));
    circle((0, 0), 0.1)""",
        ((-0.7, -0.8, 0.9, 0.6), (-0.1, -0.1, 0.1, 0.1)),
        says="PolygonHitbox.relative",
    ),
    Paste(
        "schteppe/p2.js#310",
        """var circleShape = new p2.Circle({radius: pxmi(50)});
    this.circleBody = new p2.Body({
      mass: 1,
      position: [
        pxm(200),
        pxm(200)
      ],
      angularVelocity: 1
    });
let boxShape = new p2.Box({width: pxm(25), height: pxm(25)});""",
        (),
        says="pxm",
    ),
    Paste(
        "SAT translate",
        """new SAT.Box(new SAT.Vector(0, 0), 10, 10).toPolygon().translate(5, 5)
new SAT.Circle(new SAT.Vector(20, 10), 5)""",
        ((5, 5, 15, 15), (15, 5, 25, 15)),
        as_="corner-size",
    ),
    Paste(
        "NetTopologySuite/NetTopologySuite#122 (shortened)",
        """string r1 = "0.0 -6.1, 3.8 -5.7, 7.9 -5.4, 0.0 9";
string r2 = "5 0, 9 0, 9 4";""",
        ((0, -6.1, 7.9, 9), (5, 0, 9, 4)),
    ),
    Paste(
        "cyrilmottier/Polaris2#4",
        """When one of LatLngBounds contain longitude -180, intersects returns wrong value.
E.g.: longitude from (170 to -160) and (-170 to -150).""",
        (),
        says="no shape",
    ),
    Paste(
        "arcade",
        "arcade.are_polygons_intersecting([(0,0),(4,0),(0,3)], [(5,0),(9,0),(9,4)])",
        ((0, 0, 4, 3), (5, 0, 9, 4)),
    ),
    Paste(
        "boundingBox",
        """await box.boundingBox() // { x: 8, y: 8, width: 100, height: 50 }
A = { x: 8, y: 8, width: 100, height: 50 }
B = { x: 108, y: 8, width: 10, height: 50 }""",
        ((8, 8, 108, 58), (108, 8, 118, 58)),
        as_="corner-size",
    ),
    Paste(
        "Tiled",
        """<object id="1" x="32" y="64" width="16" height="16"/>
<object id="2" x="48" y="64">
 <polygon points="0,0 16,0 16,16"/>
</object>""",
        ((32, 64, 48, 80), (48, 64, 64, 80)),
        as_="corner-size",
    ),
    Paste(
        "TexturePacker",
        """{"filename": "a.png", "frame": {"x":0,"y":0,"w":32,"h":32}, "rotated": false}
{"filename": "b.png", "frame": {"x":32,"y":0,"w":32,"h":32}, "rotated": false}""",
        ((0, 0, 32, 32), (32, 0, 64, 32)),
        as_="corner-size",
    ),
    Paste(
        "COCO",
        """[{"id": 1, "category_id": 3, "bbox": [10, 20, 30, 40], "area": 1200, "iscrowd": 0},
{"id": 2, "category_id": 3, "bbox": [40, 20, 30, 40], "area": 1200}]""",
        ((10, 20, 40, 60), (40, 20, 70, 60)),
        as_="corner-size width-first",
    ),
    Paste(
        "labelme",
        """{"shapes": [
 {"label": "a", "points": [[0,0],[4,0],[0,3]], "group_id": null, "shape_type": "polygon", "flags": {}},
 {"label": "b", "points": [[5,0],[9,4]], "group_id": null, "shape_type": "rectangle", "flags": {}}],
 "imageHeight": 100, "imageWidth": 200}""",
        ((0, 0, 4, 3), (5, 0, 9, 4)),
    ),
    Paste(
        "labelme circle",
        """[{"label": "a", "points": [[0,0],[4,0],[0,3]], "shape_type": "polygon"},
 {"label": "b", "points": [[5,0],[9,3]], "shape_type": "circle"}]""",
        ((0, 0, 4, 3),),
        says="circle",
    ),
    Paste(
        "parry Aabb",
        """Aabb { mins: [0.0, 0.0], maxs: [1.0, 1.0] }
Aabb { mins: [1.0, 0.0], maxs: [2.0, 1.0] }""",
        ((0, 0, 1, 1), (1, 0, 2, 1)),
    ),
    Paste(
        "AABB::new points",
        """let a = Aabb::new(point![0.0, 0.0], point![1.0, 1.0]);
let b = Aabb::new(point![1.0, 0.0], point![2.0, 1.0]);""",
        ((0, 0, 1, 1), (1, 0, 2, 1)),
        as_="corner-corner",
    ),
    Paste(
        "java.awt print",
        """java.awt.Rectangle[x=0,y=0,width=10,height=10]
java.awt.Rectangle[x=10,y=0,width=5,height=10]""",
        ((0, 0, 10, 10), (10, 0, 15, 10)),
    ),
    Paste(
        "WinForms",
        "{X=0,Y=0,Width=10,Height=10} intersects {X=10,Y=0,Width=5,Height=5}",
        ((0, 0, 10, 10), (10, 0, 15, 5)),
        as_="corner-size",
    ),
    Paste(
        "Qt print",
        """QRectF(0,0 10x10)
QRectF(10,0 5x10)""",
        ((0, 0, 10, 10), (10, 0, 15, 10)),
    ),
    Paste(
        "Qt polygon",
        """QPolygonF(QPointF(0,0)QPointF(4,0)QPointF(0,3))
QPolygonF(QPointF(5,0)QPointF(9,0)QPointF(9,4))""",
        ((0, 0, 4, 3), (5, 0, 9, 4)),
    ),
    Paste(
        "CSS",
        """.a { position: absolute; left: 10px; top: 20px; width: 30px; height: 40px; }
.b { position: absolute; left: 40px; top: 20px; width: 30px; height: 40px; }""",
        ((10, 20, 40, 60), (40, 20, 70, 60)),
    ),
    Paste(
        "dataclass",
        """Rect(x=0, y=0, w=10, h=10)
Circle(x=15, y=5, r=5)""",
        ((0, 0, 10, 10), (10, 0, 20, 10)),
        as_="corner-size",
    ),
    Paste(
        "numpy 2",
        """[(np.float64(0.0), np.float64(0.0)), (np.float64(4.0), np.float64(0.0)), (np.float64(0.0), np.float64(3.0))]
[(np.float64(5.0), np.float64(0.0)), (np.float64(9.0), np.float64(0.0)), (np.float64(9.0), np.float64(4.0))]""",
        ((0, 0, 4, 3), (5, 0, 9, 4)),
    ),
    Paste(
        "tensor",
        """tensor([[0., 0.], [4., 0.], [0., 3.]])
tensor([[5., 0.], [9., 0.], [9., 4.]], dtype=torch.float64)""",
        ((0, 0, 4, 3), (5, 0, 9, 4)),
    ),
    Paste(
        "dict of arrays",
        """{'center': array([0., 0.]), 'radius': 1.0}
{'center': array([2., 0.]), 'radius': 1.0}""",
        ((-1, -1, 1, 1), (1, -1, 3, 1)),
    ),
    Paste(
        "OCaml",
        """let a = [(0.0,0.0);(4.0,0.0);(0.0,3.0)]
let b = [(5.0,0.0);(9.0,0.0);(9.0,4.0)]""",
        ((0, 0, 4, 3), (5, 0, 9, 4)),
    ),
    Paste(
        "R",
        """a <- rbind(c(0,0), c(4,0), c(0,3))
b <- st_polygon(list(rbind(c(5,0), c(9,0), c(9,4), c(5,0))))""",
        ((0, 0, 4, 3), (5, 0, 9, 4)),
    ),
    Paste(
        "R matrix",
        """a <- matrix(c(0,4,0, 0,0,3), ncol=2)
b <- matrix(c(5,9,9, 0,0,4), ncol=2)""",
        ((0, 0, 4, 3), (5, 0, 9, 4)),
    ),
    Paste(
        "MATLAB",
        """A = [0 0; 4 0; 0 3];
B = [5 0; 9 0; 9 4];""",
        ((0, 0, 4, 3), (5, 0, 9, 4)),
    ),
    Paste(
        "Julia",
        """a = Polygon(Point2f[(0, 0), (4, 0), (0, 3)])
b = [5 0; 9 0; 9 4]""",
        ((0, 0, 4, 3), (5, 0, 9, 4)),
    ),
    Paste(
        "Mathematica",
        """Polygon[{{0, 0}, {4, 0}, {0, 3}}]
Disk[{9, 0}, 5]
Rectangle[{1, 1}, {3, 4}]""",
        ((0, 0, 4, 3), (4, -5, 14, 5), (1, 1, 3, 4)),
    ),
    Paste(
        "TikZ",
        r"""\draw (1,1) rectangle (4,3);
\draw (6,2) circle (2);""",
        ((1, 1, 4, 3), (4, 0, 8, 4)),
    ),
    Paste(
        "Scala case classes",
        """List(Vector2(0.0,0.0), Vector2(4.0,0.0), Vector2(0.0,3.0))
Circle(Vector2(9.0,0.0),5.0)""",
        ((0, 0, 4, 3), (4, -5, 14, 5)),
    ),
    Paste(
        "Clojure",
        """{:x 0 :y 0 :w 10 :h 10}
{:x 10 :y 0 :w 10 :h 10}""",
        ((0, 0, 10, 10), (10, 0, 20, 10)),
        as_="corner-size",
    ),
    Paste(
        "Elixir",
        """%{x: 0, y: 0, r: 5}
%{x: 9, y: 0, r: 5}""",
        ((-5, -5, 5, 5), (4, -5, 14, 5)),
    ),
    Paste(
        "Nim/Odin",
        """Rect{0, 0, 10, 10}
Rect{10, 0, 10, 10}""",
        ((0, 0, 10, 10), (10, 0, 20, 10)),
        as_="corner-size",
    ),
    Paste(
        "C struct fields",
        """r1.x = 0; r1.y = 0; r1.w = 10; r1.h = 10;
r2.x = 10; r2.y = 0; r2.w = 10; r2.h = 10;
SDL_HasIntersection(&r1, &r2);""",
        ((0, 0, 10, 10), (10, 0, 20, 10)),
        as_="corner-size",
    ),
    Paste(
        "gdb",
        """$1 = {x = 0, y = 0, width = 10, height = 10}
$2 = {x = 10, y = 0, width = 10, height = 10}""",
        ((0, 0, 10, 10), (10, 0, 20, 10)),
        as_="corner-size",
    ),
    Paste(
        "gdb vector",
        """$1 = std::vector of length 3, capacity 4 = {{x = 0, y = 0}, {x = 4, y = 0}, {x = 0, y = 3}}
$2 = std::vector of length 3, capacity 4 = {{x = 5, y = 0}, {x = 9, y = 0}, {x = 9, y = 4}}""",
        ((0, 0, 4, 3), (5, 0, 9, 4)),
    ),
    Paste(
        "lldb",
        """(CGRect) $0 = (origin = (x = 0, y = 0), size = (width = 10, height = 10))
(CGRect) $1 = (origin = (x = 10, y = 0), size = (width = 5, height = 5))""",
        ((0, 0, 10, 10), (10, 0, 15, 5)),
    ),
    Paste(
        "Chrome console",
        """(3) [{…}, {…}, {…}]
0: {x: 0, y: 0}
1: {x: 4, y: 0}
2: {x: 0, y: 3}
length: 3
circle((9,0),5)""",
        ((0, 0, 4, 3), (4, -5, 14, 5)),
    ),
    Paste(
        "assert message",
        """E   expected Circle(center=(0.0, 0.0), radius=5.0) to overlap Circle(center=(9.0, 0.0), radius=5.0)""",
        ((-5, -5, 5, 5), (4, -5, 14, 5)),
    ),
    Paste(
        "rotated rect OpenCV C++",
        """cv::RotatedRect a(cv::Point2f(0, 0), cv::Size2f(4, 2), 90);
cv::RotatedRect b(cv::Point2f(3, 0), cv::Size2f(2, 2), 0);""",
        ((-1, -2, 1, 2), (2, -1, 4, 1)),
    ),
    Paste(
        "scaled geometry",
        """const a = turf.transformScale(turf.polygon([[[0,0],[4,0],[0,3],[0,0]]]), 2);
const b = turf.polygon([[[5,0],[9,0],[9,4],[5,0]]]);""",
        ((0, 0, 4, 3), (5, 0, 9, 4)),
        says="transformScale",
    ),
    Paste(
        "turf circle",
        """turf.circle([0, 0], 5, {steps: 64, units: 'kilometers'})
turf.polygon([[[5,0],[9,0],[9,4],[5,0]]])""",
        ((5, 0, 9, 4),),
        says="is in degrees and its radius is not",
    ),
    Paste(
        "Box2D polygon radius",
        """b2MakeRoundedBox(1.0f, 2.0f, 0.25f)
b2MakeBox(1.0f, 2.0f)""",
        ((-1, -2, 1, 2),),
        says="b2MakeRoundedBox",
    ),
    Paste(
        "Box2D v3",
        """b2Circle c = {{0.0f, 0.0f}, 0.5f};
b2Polygon p = b2MakeOffsetBox(1.0f, 1.0f, (b2Vec2){1.5f, 0.0f}, b2MakeRot(0.0f));""",
        ((-0.5, -0.5, 0.5, 0.5), (0.5, -1, 2.5, 1)),
    ),
    Paste(
        "capsule",
        """b2Capsule a = {{-1.0f, 0.0f}, {1.0f, 0.0f}, 0.25f};
circle((0, 0), 1)""",
        ((-1, -1, 1, 1),),
        says="apsule",
    ),
    Paste(
        "Bevy transform",
        """Transform::from_xyz(10.0, 0.0, 0.0), Collider::cuboid(1.0, 2.0)
Transform::from_xyz(12.0, 0.0, 0.0), Collider::ball(1.0)""",
        ((-1, -2, 1, 2), (-1, -1, 1, 1)),
        says="from_xyz",
    ),
    Paste(
        "scale in a log",
        """poly A scale=2.0 verts=[(0,0),(4,0),(0,3)]
poly B scale=1.0 verts=[(5,0),(9,0),(9,4)]""",
        ((0, 0, 4, 3), (5, 0, 9, 4)),
        says="scale",
    ),
    Paste(
        "positions in a log",
        """A pos=(10, 0) verts=[(0,0),(4,0),(0,3)]
B pos=(0, 0) verts=[(5,0),(9,0),(9,4)]""",
        ((10, 0, 14, 3), (5, 0, 9, 4)),
        as_="relative",
    ),
    Paste(
        "center and extent words",
        """box A center (0, 0) half extents (1, 2)
box B center (3, 0) half extents (1, 1)""",
        (),
        says="no shape",
    ),
    Paste(
        "inline comments",
        """Rect a(0, 0, 10, 10); // was 20 wide
Rect b(10, 0, 10, 10); /* 5, 5 */""",
        ((0, 0, 10, 10), (10, 0, 20, 10)),
        as_="corner-size",
    ),
    Paste(
        "units",
        """circle((0 mm, 0 mm), 5 mm)
circle((9 mm, 0 mm), 5 mm)""",
        ((-5, -5, 5, 5), (4, -5, 14, 5)),
    ),
    Paste(
        "percent",
        """<circle cx="50%" cy="50%" r="10"/>
<circle cx="5" cy="5" r="1"/>""",
        ((4, 4, 6, 6),),
        says="50%",
    ),
    Paste(
        "lat first",
        """[{"lat": 0, "lng": 0}, {"lat": 0, "lng": 4}, {"lat": 3, "lng": 0}]
[{"lat": 0, "lng": 5}, {"lat": 0, "lng": 9}, {"lat": 4, "lng": 9}]""",
        ((0, 0, 4, 3), (5, 0, 9, 4)),
    ),
    Paste(
        "y before x",
        """[{"y": 0, "x": 0}, {"y": 0, "x": 4}, {"y": 3, "x": 0}]
[{"y": 0, "x": 5}, {"y": 0, "x": 9}, {"y": 4, "x": 9}]""",
        ((0, 0, 4, 3), (5, 0, 9, 4)),
    ),
    Paste(
        "edges",
        """edges: (0,0)-(4,0), (4,0)-(0,3), (0,3)-(0,0)
circle((9,0),5)""",
        ((0, 0, 4, 3), (4, -5, 14, 5)),
    ),
    Paste(
        "sides by name",
        """{bottom: 0, left: 0, top: 10, right: 10}
{bottom: 0, left: 10, top: 10, right: 20}""",
        ((0, 0, 10, 10), (10, 0, 20, 10)),
    ),
    Paste(
        "tuple assignment",
        """x, y, r = 0, 0, 5
x2, y2, r2 = 9, 0, 5""",
        (),
        says="no shape",
    ),
    Paste(
        "keyword then comment",
        """a = dict(x=0, y=0, w=10, h=10)
b = dict(x=10, y=0, w=10, h=10)""",
        ((0, 0, 10, 10), (10, 0, 20, 10)),
        as_="corner-size",
    ),
    Paste(
        "json lines",
        '{"level":"info","ts":1699999999.123,"a":{"x":0,"y":0,"r":5},"b":{"x":9,"y":0,"r":5},"hit":false}',
        ((-5, -5, 5, 5), (4, -5, 14, 5)),
    ),
    Paste(
        "printf",
        """poly[0] = (0.000, 0.000)
poly[1] = (4.000, 0.000)
poly[2] = (0.000, 3.000)
other[0] = (5.000, 0.000)
other[1] = (9.000, 0.000)
other[2] = (9.000, 4.000)""",
        ((0, 0, 4, 3), (5, 0, 9, 4)),
    ),
    Paste(
        "printf v0",
        """v0: 0 0
v1: 4 0
v2: 0 3

v0: 5 0
v1: 9 0
v2: 9 4""",
        ((0, 0, 4, 3), (5, 0, 9, 4)),
    ),
    Paste(
        "vertex N",
        """Vertex 0: (0, 0)
Vertex 1: (4, 0)
Vertex 2: (0, 3)
circle((9,0),5)""",
        ((0, 0, 4, 3), (4, -5, 14, 5)),
    ),
    Paste(
        "width x height",
        """box A: 10x10 at (0, 0)
box B: 10x10 at (10, 0)""",
        (),
        says="no shape",
    ),
    # -- changes in code, transforms, other shapes, and files of annotations
    Paste(
        "a field set afterwards",
        """r1 = pygame.Rect(0, 0, 10, 10)
r1.x = 20
r2 = pygame.Rect(5, 0, 10, 10)""",
        ((0, 0, 10, 10), (5, 0, 15, 10)),
        says="r1.x 20",
    ),
    Paste(
        "field plus",
        """r1 = pygame.Rect(0, 0, 10, 10)
r1.x += 20
r2 = pygame.Rect(5, 0, 10, 10)""",
        ((0, 0, 10, 10), (5, 0, 15, 10)),
        says="20",
    ),
    Paste(
        "topleft",
        """r1 = pygame.Rect(0, 0, 10, 10)
r1.topleft = (20, 0)
r2 = pygame.Rect(5, 0, 10, 10)""",
        ((20, 0, 30, 10), (5, 0, 15, 10)),
    ),
    Paste(
        "move_ip",
        """r1 = pygame.Rect(0, 0, 10, 10)
r1.move_ip(20, 0)
r2 = pygame.Rect(5, 0, 10, 10)""",
        ((20, 0, 30, 10), (5, 0, 15, 10)),
    ),
    Paste(
        "inflate",
        """r1 = pygame.Rect(0, 0, 10, 10).inflate(4, 4)
r2 = pygame.Rect(5, 0, 10, 10)""",
        ((5, 0, 15, 10),),
        says="inflate",
    ),
    Paste(
        "setRadius",
        """CircleShape c(2.f);
c.setRadius(5.f);
Rect r(3, 0, 4, 4);""",
        ((-2, -2, 2, 2), (3, 0, 7, 4)),
        as_="corner-size",
        says="setRadius",
    ),
    Paste(
        "ctx translate",
        """ctx.translate(100, 0);
ctx.fillRect(0, 0, 10, 10);
ctx.fillRect(5, 5, 10, 10);""",
        ((0, 0, 10, 10), (5, 5, 15, 15)),
        says="translate",
    ),
    Paste(
        "ctx scale",
        """ctx.scale(2, 2);
ctx.fillRect(0, 0, 10, 10);
ctx.fillRect(5, 5, 10, 10);""",
        ((0, 0, 10, 10), (5, 5, 15, 15)),
        says="scale",
    ),
    Paste(
        "processing translate",
        """noStroke();
translate(100, 0);
rect(0, 0, 10, 10);
rotate(PI/4);
rect(5, 5, 10, 10);""",
        ((0, 0, 10, 10), (5, 5, 15, 15)),
        says="translate",
    ),
    Paste(
        "svg g",
        """<g transform="translate(100 0)"><rect x="0" y="0" width="10" height="10"/></g>
<rect x="5" y="5" width="10" height="10"/>""",
        ((100, 0, 110, 10), (5, 5, 15, 15)),
    ),
    Paste(
        "matter setPosition",
        """const a = Bodies.rectangle(0, 0, 10, 10);
Body.setPosition(a, {x: 100, y: 0});
const b = Bodies.circle(0, 0, 5);""",
        ((-5, -5, 5, 5), (-5, -5, 5, 5)),
        says="setPosition",
    ),
    Paste(
        "matter translate",
        """const a = Bodies.rectangle(0, 0, 10, 10);
Body.translate(a, {x: 100, y: 0});
const b = Bodies.circle(0, 0, 5);""",
        ((-5, -5, 5, 5), (-5, -5, 5, 5)),
        says="translate",
    ),
    Paste(
        "matter rotate",
        """const a = Bodies.rectangle(0, 0, 10, 10);
Body.rotate(a, Math.PI/4);
const b = Bodies.circle(0, 0, 5);""",
        ((-5, -5, 5, 5), (-5, -5, 5, 5)),
        says="rotate",
    ),
    Paste(
        "matter angle option",
        """Bodies.rectangle(0, 0, 10, 10, { angle: Math.PI/4 })
Bodies.circle(0, 0, 5)""",
        ((-7.0710678118654755, -7.0710678118654755, 7.0710678118654755, 7.0710678118654755), (-5, -5, 5, 5)),
    ),
    Paste(
        "planck setTransform",
        """a.setTransform(Vec2(10, 0), 0.5);
a.createFixture(planck.Circle(1));
planck.Circle(Vec2(0, 0), 1)""",
        ((-1, -1, 1, 1), (-1, -1, 1, 1)),
        says="setTransform",
    ),
    Paste(
        "bodyDef",
        """bodyDef.angle = 0.5;
b2PolygonShape s; s.SetAsBox(1, 1);
circle((0,0),1)""",
        ((-1, -1, 1, 1), (-1, -1, 1, 1)),
        says="angle",
    ),
    Paste(
        "unity scale",
        """collider.size = new Vector2(2, 2);
collider.offset = new Vector2(1, 0);
transform.localScale = new Vector3(2, 2, 1);
new Bounds(new Vector3(0,0,0), new Vector3(1,1,0))""",
        ((-0.5, -0.5, 0.5, 0.5),),
        says="localScale",
    ),
    Paste(
        "alias",
        """a = [(0,0),(4,0),(0,3)]
b = a
c = [(5,0),(9,0),(9,4)]""",
        ((0, 0, 4, 3), (5, 0, 9, 4)),
    ),
    Paste(
        "comprehension",
        """a = [(0,0),(4,0),(0,3)]
b = [(x + 5, y) for x, y in a]
c = [(5,0),(9,0),(9,4)]""",
        ((0, 0, 4, 3), (5, 0, 9, 4)),
        says="x + 5",
    ),
    Paste(
        "numpy times",
        """a = np.array([(0,0),(4,0),(0,3)]) * 2
b = [(5,0),(9,0),(9,4)]""",
        ((5, 0, 9, 4),),
        says="not evaluated",
    ),
    Paste(
        "numpy plus",
        """a = np.array([(0,0),(4,0),(0,3)]) + np.array([5, 0])
b = [(5,0),(9,0),(9,4)]""",
        ((5, 0, 9, 4),),
        says="not evaluated",
    ),
    Paste(
        "translate fn",
        """a = Polygon([(0,0),(4,0),(0,3)])
b = translate(a, xoff=5)
c = Polygon([(5,0),(9,0),(9,4)])""",
        ((0, 0, 4, 3), (5, 0, 9, 4)),
        says="xoff",
    ),
    Paste(
        "affinity rotate",
        """a = affinity.rotate(Polygon([(0,0),(4,0),(0,3)]), 45)
b = Polygon([(5,0),(9,0),(9,4)])""",
        ((0, 0, 4, 3), (5, 0, 9, 4)),
        says="rotate",
    ),
    Paste(
        "buffer",
        """a = Polygon([(0,0),(4,0),(0,3)]).buffer(2)
b = Polygon([(5,0),(9,0),(9,4)])""",
        ((5, 0, 9, 4),),
        says="buffer",
    ),
    Paste(
        "loop",
        """for i in range(3):
    v[i] = (i * 2, 0)
a = [(0,0),(4,0),(0,3)]
b = [(5,0),(9,0),(9,4)]""",
        ((0, 0, 4, 3), (5, 0, 9, 4)),
        says="i * 2",
    ),
    Paste(
        "chain",
        """a = b = Rect(0, 0, 10, 10)
c = Rect(5, 0, 10, 10)""",
        ((0, 0, 10, 10), (5, 0, 15, 10)),
        as_="corner-size",
    ),
    Paste(
        "reassigned",
        """a = [(0,0),(4,0),(0,3)]
a = [(5,0),(9,0),(9,4)]""",
        ((0, 0, 4, 3), (5, 0, 9, 4)),
        as_="each-value",
    ),
    Paste(
        "negative spaced",
        """[(- 4, 0), (4, 0), (0, 3)]
[(5,0),(9,0),(9,4)]""",
        ((-4, 0, 4, 3), (5, 0, 9, 4)),
    ),
    Paste(
        "unary",
        """[(-4, -0), (+4, 0), (0, 3)]
[(5,0),(9,0),(9,4)]""",
        ((-4, 0, 4, 3), (5, 0, 9, 4)),
    ),
    Paste(
        "thousands",
        """[(1,000, 0), (4, 0), (0, 3)]
[(5,0),(9,0),(9,4)]""",
        ((5, 0, 9, 4),),
        says="item 0",
    ),
    Paste(
        "thousand apostrophes",
        """[(1'000, 0), (4'000, 0), (0, 3'000)]
[(5'000, 0), (9'000, 0), (9'000, 4'000)]""",
        ((0, 0, 4000, 3000), (5000, 0, 9000, 4000)),
    ),
    Paste(
        "scientific",
        """[(1e1, 0), (4.0E+1, 0), (0, 3e1)]
[(5,0),(9,0),(9,4)]""",
        ((0, 0, 40, 30), (5, 0, 9, 4)),
    ),
    Paste(
        "fraction",
        """[(1/2, 0), (4, 0), (0, 3)]
[(5,0),(9,0),(9,4)]""",
        ((5, 0, 9, 4),),
        says="1/2",
    ),
    Paste(
        "fraction call",
        """[(Fraction(1, 2), 0), (4, 0), (0, 3)]
[(5,0),(9,0),(9,4)]""",
        ((5, 0, 9, 4),),
        says="Fraction",
    ),
    Paste(
        "complex",
        """[0+0j, 4+0j, 0+3j]
[(5,0),(9,0),(9,4)]""",
        ((5, 0, 9, 4),),
        says="not",
    ),
    Paste(
        "degrees sign",
        """((0, 0), (4, 2), 30°)
[(5,0),(9,0),(9,4)]""",
        ((-2.232050807568877, -1.8660254037844386, 2.232050807568877, 1.8660254037844386), (5, 0, 9, 4)),
        as_="y-up",
    ),
    Paste(
        "rounded rect",
        """new RoundRectangle2D.Double(0, 0, 10, 10, 4, 4)
new Rectangle2D.Double(9, 9, 5, 5)""",
        ((9, 9, 14, 14),),
        says="RoundRectangle2D",
    ),
    Paste(
        "css radius",
        """.a { left: 0; top: 0; width: 10px; height: 10px; border-radius: 5px; }
.b { left: 9px; top: 9px; width: 5px; height: 5px; }""",
        ((0, 0, 10, 10), (9, 9, 14, 14)),
        says="radius",
    ),
    Paste(
        "css transform",
        """.a { left: 0; top: 0; width: 10px; height: 10px; transform: translate(5px, 5px); }
.b { left: 9px; top: 9px; width: 5px; height: 5px; }""",
        ((0, 0, 10, 10), (9, 9, 14, 14)),
        says="translate",
    ),
    Paste(
        "stroke width",
        """<rect x="0" y="0" width="10" height="10" stroke-width="4"/>
<rect x="9" y="9" width="5" height="5"/>""",
        ((0, 0, 10, 10), (9, 9, 14, 14)),
    ),
    Paste(
        "skin",
        """b2Polygon p = {.vertices = {{0,0},{4,0},{0,3}}, .count = 3, .radius = 0.5};
[(5,0),(9,0),(9,4)]""",
        ((0, 0, 4, 3), (5, 0, 9, 4)),
        says="radius",
    ),
    Paste(
        "poly with radius pymunk",
        """pymunk.Poly(body, [(0,0),(4,0),(0,3)], radius=1)
pymunk.Circle(body, 2, (6, 0))""",
        ((0, 0, 4, 3), (4, -2, 8, 2)),
        says="radius",
    ),
    Paste(
        "pymunk transform",
        """pymunk.Poly(None, [(0,0),(4,0),(0,3)], transform=pymunk.Transform(tx=5))
pymunk.Poly(None, [(5,0),(9,0),(9,4)])""",
        ((0, 0, 4, 3), (5, 0, 9, 4)),
        says="tx",
    ),
    Paste(
        "pymunk moment",
        """body = pymunk.Body(10, pymunk.moment_for_circle(10, 0, 25))
body.position = 100, 100
shape = pymunk.Circle(body, 25)
box = pymunk.BB(120, 90, 200, 110)""",
        ((75, 75, 125, 125), (120, 90, 200, 110)),
    ),
    Paste(
        "circle offset pymunk",
        """body.position = 10, 0
c = pymunk.Circle(body, 2, (1, 0))
d = pymunk.Circle(body2, 2, (14, 0))""",
        ((9, -2, 13, 2), (12, -2, 16, 2)),
    ),
    Paste(
        "closed false",
        """Polygon(exterior=[(0,0),(4,0),(0,3)], interiors=[[(1,1),(2,1),(1,2)]])
[(5,0),(9,0),(9,4)]""",
        ((0, 0, 4, 3), (5, 0, 9, 4)),
        says="interiors",
    ),
    Paste(
        "geojson holes",
        """{"type":"Polygon","coordinates":[[[0,0],[9,0],[9,9],[0,0]],[[1,1],[2,1],[2,2],[1,1]]]}
[(5,0),(9,0),(9,4)]""",
        ((5, 0, 9, 4),),
        says="holes",
    ),
    Paste(
        "multi polygon",
        '{"type":"MultiPolygon","coordinates":[[[[0,0],[4,0],[0,3],[0,0]]],[[[5,0],[9,0],[9,4],[5,0]]]]}',
        ((0, 0, 4, 3), (5, 0, 9, 4)),
    ),
    Paste(
        "topojson",
        """{"type":"Topology","transform":{"scale":[0.1,0.1],"translate":[5,5]},"arcs":[[[0,0],[40,0],[0,30]]]}
[(5,0),(9,0),(9,4)]""",
        ((0, 0, 40, 30), (5, 0, 9, 4)),
        says="scale",
    ),
    Paste(
        "world file",
        """poly: 0 0 4 0 0 3
origin: 100 200
pixel size: 0.5
poly: 5 0 9 0 9 4""",
        ((0, 0, 4, 3), (5, 0, 9, 4)),
        says="origin",
    ),
    Paste(
        "screen y",
        """height = 600
a = [(0,0),(4,0),(0,3)]
b = [(5,0),(9,0),(9,4)]""",
        ((0, 0, 4, 3), (5, 0, 9, 4)),
        says="600",
    ),
    Paste(
        "three shapes one point",
        "Point(1, 1) in [(0,0),(4,0),(0,3)] and [(5,0),(9,0),(9,4)]",
        ((5, 0, 9, 4),),
        says="Point(1, 1)",
    ),
    Paste(
        "point test",
        """pt = (1, 1)
a = [(0,0),(4,0),(0,3)]
b = [(5,0),(9,0),(9,4)]""",
        ((0, 0, 4, 3), (5, 0, 9, 4)),
        says="1, 1",
    ),
    Paste(
        "moved later",
        """a.position = (10, 0)
a.vertices = [(0,0),(4,0),(0,3)]
a.position = (20, 0)
b = [(5,0),(9,0),(9,4)]""",
        ((20, 0, 24, 3), (5, 0, 9, 4)),
        as_="relative",
        says="position",
    ),
    Paste(
        "update loop",
        """circle1 = {x: 0, y: 0, r: 5}
circle2 = {x: 20, y: 0, r: 5}
circle1.x += 12""",
        ((-5, -5, 5, 5), (15, -5, 25, 5)),
        says="12",
    ),
    Paste(
        "vel",
        """a = {x: 0, y: 0, r: 5, vx: 3, vy: 4}
b = {x: 20, y: 0, r: 5, dx: 1, dy: 1}""",
        ((-5, -5, 5, 5), (15, -5, 25, 5)),
        says="dx 1",
    ),
    Paste(
        "hitbox inset",
        """a = {x: 0, y: 0, w: 10, h: 10, inset: 2}
b = {x: 8, y: 0, w: 10, h: 10}""",
        ((0, 0, 10, 10), (8, 0, 18, 10)),
        as_="corner-size",
        says="inset",
    ),
    Paste(
        "margin",
        """a = {x: 0, y: 0, w: 10, h: 10, marginLeft: 2}
b = {x: 8, y: 0, w: 10, h: 10}""",
        ((0, 0, 10, 10), (8, 0, 18, 10)),
        as_="corner-size",
        says="marginLeft",
    ),
    Paste(
        "three d",
        """{x: 0, y: 0, z: 9, r: 5}
{x: 9, y: 0, z: 0, r: 5}""",
        ((-5, -5, 5, 5), (4, -5, 14, 5)),
        says="z 9",
    ),
    Paste(
        "ellipse radii",
        """{cx: 0, cy: 0, rx: 5, ry: 2}
{cx: 9, cy: 0, rx: 5, ry: 5}""",
        (),
        says="no shape",
    ),
    Paste(
        "sector",
        """{x: 0, y: 0, r: 5, startAngle: 0, endAngle: 1.57}
{x: 9, y: 0, r: 5}""",
        ((-5, -5, 5, 5), (4, -5, 14, 5)),
        says="endAngle",
    ),
    Paste(
        "annulus",
        """{x: 0, y: 0, r: 5, innerRadius: 3}
{x: 1, y: 0, r: 1}""",
        ((-5, -5, 5, 5), (0, -1, 2, 1)),
        says="innerRadius",
    ),
    Paste(
        "regular",
        """{x: 0, y: 0, sides: 6, radius: 5}
{x: 9, y: 0, r: 5}""",
        ((4, -5, 14, 5),),
        says="sides",
    ),
    Paste(
        "star",
        """new Konva.Star({x: 0, y: 0, numPoints: 5, innerRadius: 2, outerRadius: 5})
new Konva.Circle({x: 9, y: 0, radius: 5})""",
        ((4, -5, 14, 5),),
        says="Star",
    ),
    Paste(
        "wedge",
        """new Konva.RegularPolygon({x: 0, y: 0, sides: 3, radius: 5})
new Konva.Circle({x: 9, y: 0, radius: 5})""",
        ((4, -5, 14, 5),),
        says="sides",
    ),
    Paste(
        "rhombus",
        """Diamond(0, 0, 5)
circle((9,0),5)
circle((0,0),1)""",
        ((4, -5, 14, 5), (-1, -1, 1, 1)),
        says="Diamond",
    ),
    Paste(
        "anchor phaser",
        """this.add.rectangle(0, 0, 10, 10)
this.add.circle(6, 0, 2)""",
        ((-5, -5, 5, 5), (4, -2, 8, 2)),
    ),
    Paste(
        "phaser geom",
        """new Phaser.Geom.Rectangle(0, 0, 10, 10)
new Phaser.Geom.Circle(12, 0, 2)""",
        ((0, 0, 10, 10), (10, -2, 14, 2)),
    ),
    Paste(
        "arcade sprite",
        """SpriteSolidColor(50, 50, center_x=50, center_y=0)
SpriteSolidColor(50, 50, center_x=100, center_y=0)""",
        (),
        says="no shape",
    ),
    Paste(
        "kivy",
        """Rectangle(pos=(0, 0), size=(10, 10))
Ellipse(pos=(5, 5), size=(10, 10))""",
        ((0, 0, 10, 10),),
        says="ellipse",
    ),
    Paste(
        "tk",
        """canvas.create_rectangle(0, 0, 10, 10)
canvas.create_oval(10, 0, 20, 10)
canvas.create_polygon(0, 0, 4, 0, 0, 3)""",
        ((0, 0, 10, 10), (0, 0, 4, 3)),
        says="create_oval",
    ),
    Paste(
        "pil",
        """draw.rectangle((0, 0, 10, 10))
draw.rectangle([10, 0, 20, 10])""",
        ((0, 0, 10, 10), (10, 0, 20, 10)),
        as_="corner-corner",
    ),
    Paste(
        "matplotlib",
        """plt.Rectangle((0, 0), 10, 10)
plt.Circle((12, 0), 2)
Rectangle((0, 0), 10, 10, angle=45)""",
        ((0, 0, 10, 10), (10, -2, 14, 2), (-7.0710678118654755, 0, 7.0710678118654755, 14.142135623730951)),
        as_="around-corner degrees y-up corner-size",
    ),
    Paste(
        "cv rect",
        """cv2.rectangle(img, (0, 0), (10, 10), (255, 0, 0), 2)
cv2.circle(img, (12, 0), 2, (0, 0, 255), -1)""",
        ((0, 0, 10, 10), (10, -2, 14, 2)),
    ),
    Paste(
        "contours",
        """np.array([[[0, 0]], [[4, 0]], [[0, 3]]], dtype=int32)
np.array([[[5, 0]], [[9, 0]], [[9, 4]]], dtype=int32)""",
        ((0, 0, 4, 3), (5, 0, 9, 4)),
    ),
    Paste(
        "flat xyxyxyxy",
        """[0,0,4,0,4,4,0,4]
[5,0,9,0,9,4,5,4]""",
        ((0, 0, 4, 4), (5, 0, 9, 4)),
    ),
    Paste(
        "dota",
        """0.0 0.0 4.0 0.0 4.0 4.0 0.0 4.0 plane 0
5.0 0.0 9.0 0.0 9.0 4.0 5.0 4.0 ship 1""",
        (),
        says="no shape",
    ),
    Paste(
        "pascal voc",
        """<bndbox><xmin>0</xmin><ymin>0</ymin><xmax>10</xmax><ymax>10</ymax></bndbox>
<bndbox><xmin>10</xmin><ymin>0</ymin><xmax>20</xmax><ymax>10</ymax></bndbox>""",
        ((0, 0, 10, 10), (10, 0, 20, 10)),
    ),
    Paste(
        "kml",
        """<coordinates>0,0 4,0 0,3 0,0</coordinates>
<coordinates>5,0 9,0 9,4 5,0</coordinates>""",
        ((0, 0, 4, 3), (5, 0, 9, 4)),
    ),
    Paste(
        "gml",
        """<gml:posList>0 0 4 0 0 3 0 0</gml:posList>
<gml:posList>5 0 9 0 9 4 5 0</gml:posList>""",
        ((0, 0, 4, 3), (5, 0, 9, 4)),
    ),
    # -- of more libraries
    Paste(
        "jmoenig/morphic.js#34",
        "new Rectangle(10,10,20,20).intersect(new Rectangle(15,25,19,25))",
        ((10, 10, 20, 20), (15, 25, 19, 25)),
        as_="corner-corner",
    ),
    Paste(
        "jmoenig/morphic.js#34 (as it prints)",
        """  origin: Point
    x: 15
    y: 25
  corner: Point
    x: 19
    y: 20
circle((0,0),1)""",
        ((-1, -1, 1, 1),),
        says="x",
    ),
    Paste(
        "raysan5/raylib#680",
        r"""    float paddleWidth = 10;
    float paddleHeight = 50;
    float paddleX = 780;
    float paddleY = 275;
    float ballRadius = 10.0;
    float ballX = 400;
    float ballY = 300;
        if( CheckCollisionCircleRec( (Vector2){ballX, ballY}, ballRadius,
            (Rectangle){ paddleWidth, paddleHeight, paddleX, paddleY } ) )
        {
            std::cout << "Collided 1\n";
        }""",
        ((390, 290, 410, 310), (10, 50, 790, 325)),
        as_="corner-size",
    ),
    Paste(
        "llnl/Tribol#229",
        """  const double xA[3] = {0.0, 4.0, 0.0};
  const double yA[3] = {0.0, 0.0, 3.0};
  const double xB[3] = {5.0, 9.0, 9.0};
  const double yB[3] = {0.0, 0.0, 4.0};
  std::cout << signedArea(xA, yA, 3);""",
        ((0, 0, 4, 3), (5, 0, 9, 4)),
    ),
    Paste(
        "nenjack/check2d#25 (the answer)",
        """const s = new System();
s.createCircle({"x":13.3338,"y":0}, 50);
s.createCircle({"x":-86.6663,"y":0}, 50);
s.update()""",
        ((-36.6662, -50, 63.3338, 50), (-136.6663, -50, -36.6663, 50)),
    ),
    Paste(
        "UBC-Thunderbots/Software#1159",
        """    EXPECT_THROW(ConvexPolygon({{-3.0f, 0.0f},
                                {-3.0f, 3.0f},
                                {3.0f, 3.0f},
                                {3.0f, 0.0f}}),
                 std::invalid_argument);
    ConvexPolygon b({{5, 0}, {9, 0}, {9, 4}});""",
        ((-3, 0, 3, 3), (5, 0, 9, 4)),
    ),
    Paste(
        "macroquad#483",
        """let c = Circle::new(5.0, 5.0, 2.0);
let r = Rect::new(6.5, 6.5, 4.0, 4.0);
assert!(c.overlaps_rect(&r));""",
        ((3, 3, 7, 7), (6.5, 6.5, 10.5, 10.5)),
        as_="corner-size",
    ),
    Paste(
        "cocos",
        """CCRect a = CCRectMake(0, 0, 10, 10);
CCRect b = CCRectMake(10, 0, -5, 10);
a.intersectsRect(b);""",
        ((0, 0, 10, 10), (5, 0, 10, 10)),
    ),
    Paste(
        "Nez",
        """var r = new RectangleF(0, 0, 10, 10);
var c = new Circle(5f) { position = new Vector2(12, 5) };""",
        ((0, 0, 10, 10), (-5, -5, 5, 5)),
        says="c.position 12, 5",
    ),
    Paste(
        "libgdx circle",
        """Circle c = new Circle(5f, 5f, 2f);
Rectangle r = new Rectangle(7f, 0f, 10f, 10f);
Intersector.overlaps(c, r);""",
        ((3, 3, 7, 7), (7, 0, 17, 10)),
    ),
    Paste(
        "libgdx polygon transform",
        """Polygon p = new Polygon(new float[]{0,0,4,0,0,3});
p.setPosition(5, 0);
p.setRotation(90);
p.setScale(2, 2);
Polygon q = new Polygon(new float[]{5,0,9,0,9,4});""",
        ((2, 0, 5, 4), (5, 0, 9, 4)),
        as_="degrees y-up",
        says="setScale",
    ),
    Paste(
        "jbox2d",
        """PolygonShape s = new PolygonShape();
s.setAsBox(1, 2, new Vec2(5, 5), 0);
CircleShape c = new CircleShape();
c.m_p.set(7, 5);
c.m_radius = 1;""",
        ((4, 3, 6, 7), (6, 4, 8, 6)),
    ),
    Paste(
        "dyn4j",
        """Rectangle r = new Rectangle(2.0, 1.0);
r.translate(5.0, 0.0);
Circle c = new Circle(1.0);
c.translate(7.0, 0.0);""",
        ((4, -0.5, 6, 0.5), (6, -1, 8, 1)),
    ),
    Paste(
        "chipmunk",
        """cpShape *a = cpCircleShapeNew(body, 5, cpv(0, 0));
cpShape *b = cpBoxShapeNew2(body2, cpBBNew(4, -5, 14, 5), 0);""",
        ((-5, -5, 5, 5), (4, -5, 14, 5)),
        says="cpBoxShapeNew2",
    ),
    Paste(
        "Farseer",
        """var a = PolygonTools.CreateRectangle(1f, 2f);
var b = new CircleShape(1f, 1f);""",
        ((-1, -1, 1, 1),),
        says="CreateRectangle",
    ),
    Paste(
        "ncollide",
        """let cuboid = Cuboid::new(Vector2::new(1.0, 1.0));
let ball = Ball::new(1.0);
let cuboid_pos = Isometry2::identity();
let ball_pos = Isometry2::translation(1.5, 0.0);
query::contact(&ball_pos, &ball, &cuboid_pos, &cuboid, 0.0)""",
        ((0.5, -1, 2.5, 1), (-1, -1, 1, 1)),
    ),
    Paste(
        "bevy_xpbd",
        """Collider::rectangle(2.0, 2.0), Transform::from_xyz(0.0, 0.0, 0.0)
Collider::circle(1.0), Transform::from_xyz(1.5, 0.0, 0.0)""",
        ((-1, -1, 1, 1), (-1, -1, 1, 1)),
        says="from_xyz",
    ),
    Paste(
        "p5 collide2D",
        """collideRectCircle(0, 0, 10, 10, 12, 5, 6)
collidePolyPoly([createVector(0,0), createVector(4,0), createVector(0,3)],
    [createVector(5,0), createVector(9,0), createVector(9,4)], true)""",
        ((0, 0, 10, 10), (9, 2, 15, 8), (0, 0, 4, 3), (5, 0, 9, 4)),
    ),
    Paste(
        "Excalibur",
        """ex.Shape.Box(10, 10)
ex.Shape.Circle(5, ex.vec(12, 0))""",
        ((-5, -5, 5, 5), (7, -5, 17, 5)),
    ),
    Paste(
        "melonJS",
        """new me.Rect(0, 0, 10, 10)
new me.Ellipse(12, 5, 6, 6)
new me.Polygon(0, 0, [{x:0,y:0},{x:4,y:0},{x:0,y:3}])""",
        ((0, 0, 10, 10), (9, 2, 15, 8), (0, 0, 4, 3)),
        as_="corner-size",
    ),
    Paste(
        "collider2d",
        """new Box(new Vector(0, 0), 10, 10).toPolygon()
new Circle(new Vector(12, 5), 3)""",
        ((0, 0, 10, 10), (9, 2, 15, 8)),
        as_="corner-size",
    ),
    Paste(
        "detect-collisions",
        """system.createBox({x: 0, y: 0}, 10, 10, {angle: 0.5})
system.createCircle({x: 12, y: 5}, 3)""",
        ((0, 0, 10, 10), (9, 2, 15, 8)),
        as_="corner-size radians",
        says="angle 0.5",
    ),
    Paste(
        "geometric",
        "geometric.polygonIntersectsPolygon([[0,0],[4,0],[0,3]], [[5,0],[9,0],[9,4]])",
        ((0, 0, 4, 3), (5, 0, 9, 4)),
    ),
    Paste(
        "rbush",
        """{minX: 0, minY: 0, maxX: 10, maxY: 10}
{minX: 10, minY: 0, maxX: 20, maxY: 10}""",
        ((0, 0, 10, 10), (10, 0, 20, 10)),
    ),
    Paste(
        "d3 quadtree extent",
        """[[0, 0], [10, 10]]
[[10, 0], [20, 10]]""",
        ((0, 0, 10, 10), (10, 0, 20, 10)),
        as_="corner-corner",
    ),
    Paste(
        "mapbox bounds",
        """new LngLatBounds([0, 0], [10, 10])
new LngLatBounds([10, 0], [20, 10])""",
        ((0, 0, 10, 10), (10, 0, 20, 10)),
        as_="corner-corner",
    ),
    Paste(
        "leaflet bounds",
        """L.latLngBounds([[0, 5], [10, 15]])
L.latLngBounds([[0, 0], [10, 5]])""",
        ((0, 5, 10, 15), (0, 0, 10, 5)),
        as_="corner-corner",
    ),
    Paste(
        "google bounds",
        """{south: 0, west: 0, north: 10, east: 10}
{south: 0, west: 10, north: 10, east: 20}""",
        ((0, 0, 10, 10), (10, 0, 20, 10)),
    ),
    Paste(
        "wkt with numbers",
        """1 | POLYGON((0 0, 4 0, 0 3, 0 0)) | 12.5
2 | POLYGON((5 0, 9 0, 9 4, 5 0)) | 7""",
        ((0, 0, 4, 3), (5, 0, 9, 4)),
        says="12.5",
    ),
    Paste(
        "psql",
        """ id | geom
----+---------------------------------
  1 | POLYGON((0 0,4 0,0 3,0 0))
  2 | POLYGON((5 0,9 0,9 4,5 0))
(2 rows)""",
        ((0, 0, 4, 3), (5, 0, 9, 4)),
    ),
    Paste(
        "ewkt",
        """SRID=3857;POLYGON((0 0, 4 0, 0 3, 0 0))
SRID=4326;POLYGON((5 0, 9 0, 9 4, 5 0))""",
        ((0, 0, 4, 3), (5, 0, 9, 4)),
    ),
    Paste(
        "email quote",
        """> a = [(0,0),(4,0),(0,3)]
> b = [(5,0),(9,0),(9,4)]
I think so too.""",
        ((0, 0, 4, 3), (5, 0, 9, 4)),
    ),
    Paste(
        "diff",
        """-    Rect(0, 0, 5, 5),
+    Rect(0, 0, 10, 10),
     Rect(10, 0, 10, 10),""",
        ((0, 0, 10, 10), (10, 0, 20, 10)),
        as_="corner-size",
        says="a change removes",
    ),
    Paste(
        "code fence",
        """```js
const a = [[0,0],[4,0],[0,3]];
```
```js
const b = [[5,0],[9,0],[9,4]];
```""",
        ((0, 0, 4, 3), (5, 0, 9, 4)),
    ),
    Paste(
        "html escaped",
        """[{&quot;x&quot;:0,&quot;y&quot;:0},{&quot;x&quot;:4,&quot;y&quot;:0},{&quot;x&quot;:0,&quot;y&quot;:3}]
[(5,0),(9,0),(9,4)]""",
        ((0, 0, 4, 3), (5, 0, 9, 4)),
    ),
    Paste(
        "scale before points",
        """scale: 2
points: [(0,0),(4,0),(0,3)]
circle((20, 0), 1)""",
        ((0, 0, 4, 3), (19, -1, 21, 1)),
        says="scale 2",
    ),
    Paste(
        "transform after",
        """points: [(0,0),(4,0),(0,3)]
rotation: 45
circle((20, 0), 1)""",
        ((-2.121320343559643, 0, 2.8284271247461903, 2.8284271247461903), (19, -1, 21, 1)),
        as_="y-up degrees",
    ),
    Paste(
        "unity polygon print",
        """(0.00, 0.00)
(4.00, 0.00)
(0.00, 3.00)

(5.00, 0.00)
(9.00, 0.00)
(9.00, 4.00)""",
        ((0, 0, 4, 3), (5, 0, 9, 4)),
    ),
    # -- whole bodies as printed
    Paste(
        "a body of p2 as JSON",
        """{"mass":1,"position":[3,4],"angle":0,"shapes":[{"type":8,"width":2,"height":1,"position":[0,0],"angle":0}]}
{"mass":1,"position":[5,4],"angle":0,"shapes":[{"type":1,"radius":1,"position":[0,0],"angle":0}]}""",
        ((2, 3.5, 4, 4.5), (4, 3, 6, 5)),
        as_="center-size",
    ),
    Paste(
        "a body of planck as JSON",
        """{"type":"dynamic","position":{"x":3,"y":4},"angle":0,
 "fixtures":[{"density":1,"shape":{"type":"polygon","vertices":[{"x":-1,"y":-1},{"x":1,"y":-1},{"x":1,"y":1}]}}]}
{"type":"static","position":{"x":0,"y":0},"angle":0,
 "fixtures":[{"shape":{"type":"circle","p":{"x":0,"y":0},"radius":1}}]}""",
        ((2, 3, 4, 5), (-1, -1, 1, 1)),
        says="density",
    ),
    Paste(
        "a body with an angle",
        """{"position":{"x":3,"y":4},"angle":90,
 "fixtures":[{"shape":{"type":"polygon","vertices":[{"x":-1,"y":-1},{"x":2,"y":-1},{"x":2,"y":1}]}}]}
circle((0,0),1)""",
        ((2, 3, 4, 6), (-1, -1, 1, 1)),
        as_="degrees y-up",
    ),
    Paste(
        "quoted words that begin with M",
        """{"shape": "mast", "math": "mlh", "x": 0, "y": 0, "radius": 5, "mass": 3}
{"shape": 'Mat', "x": 9, "y": 0, "radius": 5, "mass": 3}""",
        ((-5, -5, 5, 5), (4, -5, 14, 5)),
        says="math",
    ),
    # -- found later: lost fields, prints, and forms of lists
    Paste(
        "rectMode inside a function",
        """function draw() {
  rectMode(CENTER);
  rect(100, 100, 50, 50);
  ellipse(140, 100, 20, 20);
}""",
        ((75, 75, 125, 125), (130, 90, 150, 110)),
    ),
    Paste(
        "ellipseMode",
        """ellipseMode(CORNER);
ellipse(9, 9, 4, 4);
rect(0, 0, 5, 5);""",
        ((0, 0, 5, 5),),
        says="ellipseMode",
    ),
    Paste(
        "center of a pygame Rect",
        """a = pygame.Rect(0, 0, 10, 10)
b = pygame.Rect(0, 0, 4, 4)
b.center = (12, 5)
print(a.colliderect(b))""",
        ((0, 0, 10, 10), (10, 3, 14, 7)),
    ),
    Paste(
        "setPosition of shapes with a place",
        """r = new Rectangle(5, 5, 10, 10); r.setPosition(20, 0);
c = new Circle(0, 0, 3); c.setPosition(9, 9);""",
        ((20, 0, 30, 10), (6, 6, 12, 12)),
    ),
    Paste(
        "translate of a box",
        """r = new Rectangle(5, 5, 10, 10); r.translate(20, 0);
c = new Circle(9, 9, 3);""",
        ((25, 5, 35, 15), (6, 6, 12, 12)),
    ),
    Paste(
        "setAngle of a box with a place",
        """b = new SAT.Box(new SAT.Vector(100, 100), 100, 100).toPolygon();
b.setAngle(90);
c = new SAT.Circle(new SAT.Vector(220, 150), 30);""",
        ((100, 100, 200, 200), (190, 120, 250, 180)),
        as_="corner-size around-center degrees",
    ),
    Paste(
        "setAngle of a polygon with a place",
        """b = new SAT.Polygon(new SAT.Vector(100, 100), [new SAT.Vector(0,0), new SAT.Vector(10,0),
  new SAT.Vector(10,10)]);
b.setAngle(90);
c = new SAT.Circle(new SAT.Vector(220, 150), 30);""",
        ((90, 100, 100, 110), (190, 120, 250, 180)),
        as_="degrees",
    ),
    Paste(
        "pandas with an index and another column",
        """   xmin  ymin  xmax  ymax  score
0     0     0    10    10   0.91
1     8     8    18    18   0.88""",
        ((0, 0, 10, 10), (8, 8, 18, 18)),
        says="score",
    ),
    Paste(
        "sf matrix col",
        """p1 <- st_polygon(list(matrix(c(0,4,4,0,0, 0,0,4,4,0), ncol = 2)))
p2 <- st_polygon(list(matrix(c(5,9,9,5,5, 0,0,4,4,0), ncol = 2)))
st_disjoint(p1, p2)""",
        ((0, 0, 4, 4), (5, 0, 9, 4)),
    ),
    Paste(
        "sf structure dput",
        """structure(list(structure(c(0, 4, 4, 0, 0, 0, 0, 4, 4, 0), dim = c(5L, 2L))),
  class = c("XY", "POLYGON", "sfg"))
structure(list(structure(c(5, 9, 9, 5, 5, 0, 0, 4, 4, 0), dim = c(5L, 2L))),
  class = c("XY", "POLYGON", "sfg"))""",
        ((0, 0, 4, 4), (5, 0, 9, 4)),
    ),
    Paste(
        "a matrix of R by rows",
        """p <- matrix(c(0,0, 4,0, 4,4, 0,4), ncol = 2, byrow = TRUE)""",
        ((0, 0, 4, 4),),
    ),
    Paste(
        "a matrix of R with three columns",
        """p <- matrix(c(0,0,1, 4,0,1, 4,4,1), ncol = 3)""",
        (),
        says="two columns",
    ),
    Paste(
        "points in lines of YAML",
        """colliders:
  - name: player
    shape: circle
    center: [0, 0]
    radius: 2
  - name: wall
    shape: polygon
    points:
      - [2, -1]
      - [4, -1]
      - [4, 1]
      - [2, 1]""",
        ((-2, -2, 2, 2), (2, -1, 4, 1)),
    ),
    Paste(
        "xml tiled ellipse",
        """<object id="1" x="0" y="0" width="32" height="32"><ellipse/></object>
<object id="2" x="30" y="30" width="10" height="10"/>""",
        ((0, 0, 32, 32), (30, 30, 40, 40)),
        as_="corner-size",
        says="id",
    ),
    Paste(
        "Tiled with a rotation",
        """<object id="2" x="100" y="100" rotation="45"><polygon points="0,0 32,0 32,32"/></object>""",
        (),
        says="tiled-rotation",
    ),
    Paste(
        "two systems of coordinates in one query",
        """SELECT ST_Intersects('SRID=3857;POLYGON((0 0,4 0,4 4,0 4,0 0))'::geometry,
  ST_MakeEnvelope(4, 0, 8, 4, 4326));""",
        ((0, 0, 4, 4), (4, 0, 8, 4)),
        says="3857",
    ),
    Paste(
        "ST_MakeEnvelope with an SRID",
        """SELECT ST_Intersects('SRID=4326;POLYGON((0 0,4 0,4 4,0 4,0 0))'::geometry,
  ST_MakeEnvelope(4, 0, 8, 4, 4326));""",
        ((0, 0, 4, 4), (4, 0, 8, 4)),
        says="4326",
    ),
    Paste(
        "JTS new Envelope",
        """Envelope a = new Envelope(0, 10, 0, 20);
Envelope b = new Envelope(12, 15, 0, 20);
a.intersects(b)""",
        ((0, 0, 10, 20), (12, 0, 15, 20)),
        as_="x-then-y",
    ),
    Paste(
        "JTS Envelope (as it prints)",
        """Env[0.0 : 10.0, 0.0 : 20.0]
Env[5.0 : 15.0, 30.0 : 40.0]""",
        ((0, 0, 10, 20), (5, 30, 15, 40)),
    ),
    Paste(
        "leaflet circle meters",
        """L.circle([51.508, -0.11], {radius: 500}).addTo(map);
L.circle([51.6, -0.11], { radius: 500 }).addTo(map);""",
        (),
        says="is in degrees and its radius is not",
    ),
    Paste(
        "a DOMRect with all its keys",
        """DOMRect { x: 8, y: 8, width: 100, height: 50, top: 8, right: 108, bottom: 58, left: 8 }
DOMRect { x: 100, y: 8, width: 50, height: 50, top: 8, right: 150, bottom: 58, left: 100 }""",
        ((8, 8, 108, 58), (100, 8, 150, 58)),
    ),
    Paste(
        "pygame Rect (as it prints)",
        """>>> a
<rect(0, 0, 10, 10)>
>>> b
<rect(5, 5, 10, 10)>
>>> a.colliderect(b)
1""",
        ((0, 0, 10, 10), (5, 5, 15, 15)),
        says="",
    ),
    Paste(
        "Android Rect (as it prints)",
        """D/Hit: player=Rect(0, 0 - 100, 50) wall=Rect(90, 0 - 160, 50) intersects=true""",
        ((0, 0, 100, 50), (90, 0, 160, 50)),
    ),
    Paste(
        "Go (as it prints)",
        """got (0,0)-(10,10) and (12,0)-(20,10), want no overlap""",
        ((0, 0, 10, 10), (12, 0, 20, 10)),
    ),
    Paste(
        "OpenCV Rect (as it prints)",
        """[10 x 10 from (0, 0)]
[5 x 5 from (10, 0)]""",
        ((0, 0, 10, 10), (10, 0, 15, 5)),
    ),
    Paste(
        "euclid Rect (as it prints)",
        """Rect(10.0x10.0 at (0.0, 0.0))
Rect(5.0x5.0 at (10.0, 0.0))""",
        ((0, 0, 10, 10), (10, 0, 15, 5)),
    ),
    Paste(
        "egui Rect (as it prints)",
        """[[0.0 0.0] - [10.0 10.0]]
[[10.0 0.0] - [20.0 10.0]]""",
        ((0, 0, 10, 10), (10, 0, 20, 10)),
    ),
    Paste(
        "RECT of Windows",
        """RECT a = { 0, 0, 100, 50 };
RECT b = { 90, 0, 200, 50 };
RECT out; IntersectRect(&out, &a, &b);""",
        ((0, 0, 100, 50), (90, 0, 200, 50)),
    ),
    Paste(
        "a name and a colon before keys",
        """GetWindowRect: left=0 top=0 right=100 bottom=50
GetWindowRect: left=100 top=0 right=200 bottom=50""",
        ((0, 0, 100, 50), (100, 0, 200, 50)),
    ),
    Paste(
        "bbox_left of GameMaker",
        """inst_a: bbox_left = 0, bbox_top = 0, bbox_right = 31, bbox_bottom = 31
inst_b: bbox_left = 32, bbox_top = 0, bbox_right = 63, bbox_bottom = 31""",
        ((0, 0, 31, 31), (32, 0, 63, 31)),
    ),
    Paste(
        "matplotlib Rectangle with a style",
        """ax.add_patch(patches.Rectangle((0, 0), 4, 2, linewidth=1, edgecolor='r', facecolor='none'))
ax.add_patch(patches.Circle((5, 1), 1))""",
        ((0, 0, 4, 2), (4, 0, 6, 2)),
        says="linewidth",
    ),
    Paste(
        "matplotlib Rectangle by names",
        """Rectangle(xy=(0, 0), width=3, height=2, angle=0)
Rectangle(xy=(4, 0), width=2, height=2, angle=90)""",
        ((0, 0, 3, 2), (2, 0, 4, 2)),
        as_="around-corner y-up",
    ),
    Paste(
        "Phaser with a color",
        """this.r1 = this.add.rectangle(100, 100, 100, 50, 0xff0000);
this.r2 = this.add.rectangle(200, 100, 100, 50, 0x00ff00);
// Phaser.Geom.Intersects.RectangleToRectangle(r1.getBounds(), r2.getBounds())""",
        ((50, 75, 150, 125), (150, 75, 250, 125)),
    ),
    Paste(
        "rapier js",
        """const a = RAPIER.ColliderDesc.cuboid(1.0, 1.0);
const b = RAPIER.ColliderDesc.ball(1.0).setTranslation(2.5, 0.0);""",
        ((-1, -1, 1, 1), (1.5, -1, 3.5, 1)),
    ),
    Paste(
        "Bevy bounding volumes",
        """let a = Aabb2d::new(Vec2::ZERO, Vec2::new(1.0, 1.0));
let b = Aabb2d::new(Vec2::new(2.5, 0.0), Vec2::splat(1.0));
let c = BoundingCircle::new(Vec2::new(5., 0.), 1.);""",
        ((-1, -1, 1, 1), (4, -1, 6, 1)),
        says="splat",
    ),
    Paste(
        "Bevy Rect",
        """let a = Rect::from_center_size(Vec2::new(0.0, 0.0), Vec2::new(2.0, 2.0));
let b = Rect::from_corners(Vec2::new(1.0, 0.0), Vec2::new(3.0, 2.0));
let c = Rect::new(5.0, 0.0, 6.0, 2.0);""",
        ((-1, -1, 1, 1), (1, 0, 3, 2), (5, 0, 6, 2)),
        as_="corner-corner",
    ),
    Paste(
        "QPolygonF with <<",
        """QPolygonF poly;
poly << QPointF(0, 0) << QPointF(4, 0) << QPointF(0, 4);
QRectF r(1, 1, 2, 2);
poly.intersects(QPolygonF(r));""",
        ((0, 0, 4, 4), (1, 1, 3, 3)),
    ),
    Paste(
        "Ellipse2D.Double",
        """Ellipse2D e = new Ellipse2D.Double(0, 0, 10, 10);
Rectangle2D r = new Rectangle2D.Double(9, 9, 2, 2);
e.intersects(r)""",
        ((0, 0, 10, 10), (9, 9, 11, 11)),
    ),
    Paste(
        "Haskell with a negative number",
        """let a = [(0,0),(4,0),(4,4),(0,4)]
    b = [(5.0,0.0),(7.0,0.0),(6.0,(-1.0))]
in intersects a b""",
        ((0, 0, 4, 4), (5, -1, 7, 0)),
    ),
    Paste(
        "OCaml arrays",
        """let a = [| (0., 0.); (4., 0.); (4., 4.); (0., 4.) |]
let b = [| (4., 0.); (6., 0.); (5., -1.) |]""",
        ((0, 0, 4, 4), (4, -1, 6, 0)),
    ),
    Paste(
        "Fortran with d0",
        """real :: a(2,4) = reshape([0.,0., 4.,0., 4.,4., 0.,4.], [2,4])
real :: b(2,3) = reshape([3.0d0,3.0d0, 6.0d0,3.0d0, 6.0d0,6.0d0], [2,3])""",
        ((0, 0, 4, 4), (3, 3, 6, 6)),
        says="reshape 2, 4",
    ),
    Paste(
        "AngusJohnson/Clipper2#711 (three corners of four)",
        """Paths64 subPaths{ { {0LL, 10LL}, {-10LL, 0LL}, {10LL, 0LL} } };
Paths64 clipPaths{ {{10LL, 5LL}, {-5LL, 5LL}, {-5LL, -5LL} } };""",
        ((-10, 0, 10, 10), (-5, -5, 10, 5)),
    ),
    Paste(
        "CSS by id",
        """#a { position: absolute; left: 0px; top: 0px; width: 100px; height: 50px; }
#b { position: absolute; left: 100px; top: 0px; width: 50px; height: 50px; }""",
        ((0, 0, 100, 50), (100, 0, 150, 50)),
    ),
    Paste(
        "SVG with rounded corners",
        """<svg viewBox="0 0 100 100"><circle cx="20" cy="20" r="10" stroke-width="2"/>
<rect x="30" y="10" width="20" height="20" rx="4" /></svg>""",
        ((10, 10, 30, 30), (30, 10, 50, 30)),
        says="svg.rect.rx 4",
    ),
    Paste(
        "Leaflet latLngBounds",
        """var a = L.latLngBounds([40.712, -74.227], [40.774, -74.125]);
var b = L.latLngBounds([40.774, -74.125], [40.8, -74.1]);
a.overlaps(b)""",
        ((40.712, -74.227, 40.774, -74.125), (40.774, -74.125, 40.8, -74.1)),
    ),
    Paste(
        "three Box3",
        """const a = new THREE.Box3(new THREE.Vector3(0, 0, 0), new THREE.Vector3(10, 10, 10));
const b = new THREE.Box3(new THREE.Vector3(5, 5, 20), new THREE.Vector3(20, 10, 30));""",
        (),
        says="THREE.Box3",
    ),
    Paste(
        "godotengine/godot#1731",
        """Rect2::intersects() says true
```GDScript
var r1 = Rect2(0,0,2,2)
var r2 = Rect2(2,2,2,2)
print(r1.intersects(r2)) # true
```""",
        ((0, 0, 2, 2), (2, 2, 4, 4)),
    ),
    Paste(
        "liabru/matter-js#12",
        """Matter.World.add(engine.world, Matter.Bodies.rectangle(285.5, 323.5, 102, 102,
  { isStatic: true, density: 1.0, friction: 0.0, restitution: 1.0 }));
Matter.World.add(engine.world, Matter.Bodies.rectangle(380.5, 25.5, 102, 102,
  { isStatic: false, density: 1.0, friction: 0.0, restitution: 1.0 }));""",
        ((234.5, 272.5, 336.5, 374.5), (329.5, -25.5, 431.5, 76.5)),
        says="density",
    ),
    Paste(
        "a choice is for the boxes that are asked about",
        """Rect.fromLTRB(5, 5, 10, 10)
Rect(12, 0, 4, 4)""",
        ((5, 5, 10, 10), (12, 0, 16, 4)),
        as_="corner-size",
    ),
    Paste(
        "names before keys in lines of a log",
        """ball: x=0 y=0 r=5
paddle: x=5, y=0, w=10, h=2""",
        ((-5, -5, 5, 5), (5, 0, 15, 2)),
        as_="corner-size",
    ),
    Paste(
        "calls before an equals sign",
        """Rect.fromLTRB(0.0, 0.0, 10.0, 10.0) overlaps Rect.fromLTRB(10.0, 0.0, 20.0, 10.0) = false""",
        ((0, 0, 10, 10), (10, 0, 20, 10)),
    ),
    Paste(
        "a table with two shapes in a row",
        """ frame  player_x  player_y  enemy_x  enemy_y  r
    10       0.0       0.0      3.0      0.0  1""",
        (),
        says="the names of the columns fit no shape",
    ),
    Paste(
        "Offset of a box",
        """var a = new Rectangle(0, 0, 10, 10);
a.Offset(20, 0);
var b = new Rectangle(12, 0, 5, 5);""",
        ((20, 0, 30, 10), (12, 0, 17, 5)),
    ),
    Paste(
        "setBounds",
        """Rectangle r1 = new Rectangle();
r1.setBounds(0, 0, 10, 10);
Rectangle r2 = new Rectangle();
r2.setBounds(20, 0, 10, 10);""",
        ((0, 0, 10, 10), (20, 0, 30, 10)),
        as_="corner-size",
    ),
    Paste(
        "x and y in two lists of an object",
        """{"polygonA": {"x": [0, 4, 4], "y": [0, 0, 4]}, "polygonB": {"x": [5, 6, 6], "y": [0, 0, 4]}}""",
        ((0, 0, 4, 4), (5, 0, 6, 4)),
    ),
    Paste(
        "fields of an object as arguments",
        """var p = {x: 0, y: 0};
var a = new Circle(p.x, p.y, 2);
var b = new Circle(3, p.y, 2);""",
        ((-2, -2, 2, 2), (1, -2, 5, 2)),
    ),
    Paste(
        "names as arguments of a circle",
        """c = new Circle(x, y, 10); d = new Circle(0, 0, 5);""",
        ((-5, -5, 5, 5),),
        says="x is a name",
    ),
    Paste(
        "a name as the center of a circle",
        """c = new Circle(this.pos, 10); d = new Circle(0, 0, 5);""",
        ((-5, -5, 5, 5),),
        says="this.pos is a name",
    ),
    Paste(
        "names as arguments of a box",
        """c = new Rect(player.x, player.y, 10, 10); d = new Circle(0, 0, 5);""",
        ((-5, -5, 5, 5),),
        says="player.x is a name",
    ),
    Paste(
        "Rectangle of two points",
        """a = Rectangle(Point(0, 0), Point(10, 10))
b = Rectangle(Point(12, 0), Point(20, 10))""",
        ((0, 0, 10, 10), (12, 0, 20, 10)),
        as_="corner-corner",
    ),
    Paste(
        "Rectangle in square brackets",
        """Rectangle[0,0,10,10]
Rectangle[12,0,5,5]""",
        ((0, 0, 10, 10), (12, 0, 17, 5)),
        as_="corner-size",
    ),
    Paste(
        "IntersectsWith",
        """Assert.False(new Rect(0,0,10,10).IntersectsWith(new Rect(new Point(10,0), new Point(20,10))));""",
        ((0, 0, 10, 10), (10, 0, 20, 10)),
        as_="corner-corner",
    ),
    Paste(
        "Square",
        """Square(0, 0, 10) Square(12, 0, 5)""",
        ((0, 0, 10, 10), (12, 0, 17, 5)),
        as_="corner-size",
    ),
    Paste(
        "Triangle (as Rust prints it)",
        """Triangle { a: Vec2(0.0, 0.0), b: Vec2(4.0, 0.0), c: Vec2(0.0, 4.0) }
Triangle { a: Vec2(5.0, 0.0), b: Vec2(9.0, 0.0), c: Vec2(5.0, 4.0) }""",
        ((0, 0, 4, 4), (5, 0, 9, 4)),
    ),
    Paste(
        "a centroid beside corners",
        """b2Polygon { vertices: [(0,0),(4,0),(0,4)], normals: [(0,-1),(0.7,0.7),(-1,0)], centroid: (1.3,1.3) }
b2Circle { center: (5, 5), radius: 1 }""",
        ((0, 0, 4, 4), (4, 4, 6, 6)),
        says="normals",
    ),
    Paste(
        "intervals",
        """[0, 10] x [0, 10]
x in [12, 20], y in [0, 10]""",
        ((0, 0, 10, 10), (12, 0, 20, 10)),
    ),
    Paste(
        "a change in place",
        """a = Circle(0, 0, 5)
b = Circle(9, 0, 5)
b.radius *= 2""",
        ((-5, -5, 5, 5), (4, -5, 14, 5)),
        says="b.radius *= 2",
    ),
    Paste(
        "a change in place of a field",
        """a.x = 5; a.y = 0; a.r = 5; a.x += 20
b.x = 9; b.y = 0; b.r = 5""",
        ((0, -5, 10, 5), (4, -5, 14, 5)),
        says="a.x += 20",
    ),
    Paste(
        "shapes in lines of words",
        """rect 0 0 10 10
circle 12 0 5""",
        ((0, 0, 10, 10), (7, -5, 17, 5)),
        as_="corner-size",
    ),
    Paste(
        "top-left and bottom-right",
        """rect1: top-left = (0, 0), bottom-right = (10, 10)
B.topLeft = {12, 10}; B.bottomRight = {20, 0};""",
        ((0, 0, 10, 10), (12, 0, 20, 10)),
    ),
    Paste(
        "collide2D of p5",
        """collideCircleCircle(0, 0, 10, 8, 0, 10)
collideRectRect(0, 0, 10, 10, 20, 0, 5, 5)""",
        ((-5, -5, 5, 5), (3, -5, 13, 5), (0, 0, 10, 10), (20, 0, 25, 5)),
    ),
    Paste(
        "rectangle_in_rectangle of GameMaker",
        """rectangle_in_rectangle(0, 0, 10, 10, 8, 0, 20, 10)""",
        ((0, 0, 10, 10), (8, 0, 20, 10)),
    ),
    Paste(
        "labels that are keys",
        """position: x=0, y=0, z=0
scale: x=2, y=2, z=1
size: x=10, y=10, z=0""",
        (),
        says="no shape",
    ),
    Paste(
        "YOLO with a header",
        """class x_center y_center width height
0 0.5 0.5 0.2 0.2
1 0.7 0.5 0.2 0.2""",
        ((0.4, 0.4, 0.6, 0.6), (0.6, 0.4, 0.8, 0.6)),
        says="class 0, 1",
    ),
    Paste(
        "center_x of Arcade",
        """a.center_x = 0; a.center_y = 0; a.width = 10; a.height = 10
b.center_x = 9; b.center_y = 0; b.width = 10; b.height = 10""",
        ((-5, -5, 5, 5), (4, -5, 14, 5)),
    ),
    Paste(
        "plot of x and y",
        """plt.plot([0, 4, 4, 0, 0], [0, 0, 4, 4, 0], 'r-'); plt.fill([5, 9, 9, 5], [0, 0, 4, 0], 'b-')""",
        ((0, 0, 4, 4), (5, 0, 9, 4)),
    ),
    Paste(
        "Ellipse of PIXI",
        """new PIXI.Ellipse(20, 5, 5, 5); new PIXI.Circle(12, 5, 5);""",
        ((15, 0, 25, 10), (7, 0, 17, 10)),
        as_="radius",
    ),
    Paste(
        "drawRect",
        """g.drawRect(0, 0, 10, 10); g.drawCircle(20, 5, 5);""",
        ((0, 0, 10, 10), (15, 0, 25, 10)),
        as_="corner-size",
    ),
    Paste(
        "DrawRectanglePro of raylib",
        """DrawRectanglePro((Rectangle){100, 100, 50, 20}, (Vector2){25, 10}, 45.0f, RED);
DrawCircle(140, 100, 5.0f, RED);""",
        ((135, 95, 145, 105),),
        says="DrawRectanglePro is not read: satviz takes",
    ),
    Paste(
        "newRect of Solar2D",
        """display.newRect(0, 0, 10, 10); display.newCircle(9, 0, 5)""",
        ((-5, -5, 5, 5), (4, -5, 14, 5)),
    ),
    Paste(
        "square of OpenSCAD",
        """square([10, 10]); circle(r = 5);""",
        ((0, 0, 10, 10), (-5, -5, 5, 5)),
        as_="corner-size",
    ),
    Paste(
        "Zig lists",
        """const a = [_]Vec2{ .{ .x = 0, .y = 0 }, .{ .x = 4, .y = 0 }, .{ .x = 4, .y = 4 } };
const b = [_][2]f32{ .{ 5, 0 }, .{ 6, 0 }, .{ 6, 1 } };""",
        ((0, 0, 4, 4), (5, 0, 6, 1)),
        says="b 2",
    ),
    Paste(
        "a function that is called circle",
        """function circle(x, y, r) { return {x: x, y: y, r: r}; }
const a = circle(0, 0, 5); const b = circle(9, 0, 5);""",
        ((-5, -5, 5, 5), (4, -5, 14, 5)),
        as_="radius",
        says="x is a name",
    ),
    Paste(
        "a key in brackets",
        """a = {}; a['x'] = 0; a['y'] = 0; a['r'] = 5
b = {'x': 9, 'y': 0, 'r': 5}
b['x'] = 20""",
        ((-5, -5, 5, 5), (4, -5, 14, 5)),
        says="b.x 20",
    ),
    # -- notations that came later
    Paste(
        "print_r of PHP",
        """Array
(
    [0] => Array
        (
            [x] => 0
            [y] => 0
        )

    [1] => Array
        (
            [x] => 4
            [y] => 0
        )

    [2] => Array
        (
            [x] => 4
            [y] => 3
        )

)""",
        ((0, 0, 4, 3),),
    ),
    Paste(
        "var_export of PHP",
        """array (
  0 =>
  array (
    'x' => 1,
    'y' => 2,
  ),
  1 =>
  array (
    'x' => 4,
    'y' => 2,
  ),
  2 =>
  array (
    'x' => 4,
    'y' => -3,
  ),
)""",
        ((1, -3, 4, 2),),
    ),
    Paste(
        "V2 of Haskell",
        """a = [V2 0 0, V2 4 0, V2 4 3]
b = [V2 (-1) 0, V2 4 0, V2 4 3]""",
        ((0, 0, 4, 3), (-1, 0, 4, 3)),
    ),
    Paste(
        "vectors of Clojure",
        """(def a [[0 0] [4 0] [4 3]])
(def b [[1 1] [5 1] [5 4]])""",
        ((0, 0, 4, 3), (1, 1, 5, 4)),
    ),
    Paste(
        "points of Unity in YAML",
        """m_Points:
- {x: 0, y: 0}
- {x: 4, y: 0}
- {x: 4, y: 3}
circle((5, 5), 1)""",
        ((0, 0, 4, 3), (4, 4, 6, 6)),
    ),
    Paste(
        "a scene file of Godot",
        """[node name="A" type="CollisionPolygon2D" parent="."]
polygon = PackedVector2Array(0, 0, 4, 0, 4, 4)

[node name="B" type="CollisionPolygon2D" parent="."]
polygon = PackedVector2Array(1, 1, 5, 1, 5, 5)""",
        ((0, 0, 4, 4), (1, 1, 5, 5)),
    ),
    Paste(
        "an angle in terms of pi",
        """boxA.SetAsBox(1, 1, b2Vec2(3, 0), 0.5f * b2_pi);
boxB.SetAsBox(2, 1, b2Vec2(5, 0), -Math.PI / 2);""",
        ((2, -1, 4, 1), (4, -2, 6, 2)),
    ),
    Paste(
        "path data in lines",
        """m 0 0 l 10 0 l 0 10 z
M 5 5 h 10 v 10 z""",
        ((0, 0, 10, 10), (5, 5, 15, 15)),
    ),
    Paste(
        "TikZ",
        """\\filldraw[fill=red!20] (0,0) -- (3,0) -- (3,2) -- cycle;
\\draw (2,1) circle (1);""",
        ((0, 0, 3, 2), (1, 0, 3, 2)),
    ),
    Paste(
        "a box of Kivy's language",
        """Rectangle:
    pos: 10, 20
    size: 30, 40""",
        (),
        says="no shape",
    ),
    Paste("decimal commas in lines", "A: 0,5 1,5; 2,5 1,5; 2,5 3,5", (), says="no shape"),
    # -- signs and words around points
    Paste(
        "points with semicolons on two lines", "(0,0); (4,0); (4,4)\n(1,1);(5,1);(5,5)", ((0, 0, 4, 4), (1, 1, 5, 5))
    ),
    Paste(
        "points as XNA prints them",
        "{X:1 Y:2}\n{X:3 Y:2}\n{X:3 Y:5}\n\n{X:2 Y:2}\n{X:4 Y:2}\n{X:4 Y:5}",
        ((1, 2, 3, 5), (2, 2, 4, 5)),
    ),
    Paste(
        "polygons in sentences",
        "Polygon 1 has 3 points (0,0), (4,0), (4,4). The second polygon is at (1,1), (5,1), (5,5).\nUsing Tool 3.8.1"
        " on Windows 11. They share 1 point.",
        ((0, 0, 4, 4), (1, 1, 5, 5)),
    ),
    Paste(
        "circles in a sentence", "2 circles at (0, 0), (4, 0), (0, 3)\n[0,0,4,0,4,4]", ((0, 0, 4, 4),), says="at 0, 0"
    ),
    Paste(
        "metres",
        "circle at (3 m, 4 m) radius 2 m\nCircle(x = 0 m, y = 4 m, r = 1 m)\nThey are 0.5 m apart.",
        ((1, 2, 5, 6), (-1, 3, 1, 5)),
    ),
    Paste(
        "two units", "Circle(0 m, 4 m, 2 m)\nCircle(0 cm, 4 cm, 2 cm)", ((-2, 2, 2, 6),), says="all of them in one unit"
    ),
    Paste(
        "a log of Android",
        "08-14 10:22:31.120 D/Collide: a=Rect(0, 0 - 4, 4) b=Rect(1, 1 - 5, 5)",
        ((0, 0, 4, 4), (1, 1, 5, 5)),
    ),
    # -- numbers beside a list of corners
    Paste(
        "Chipmunk",
        """cpVect verts[] = { cpv(0, 0), cpv(0, 4), cpv(4, 4) };
cpShape *a = cpPolyShapeNew(body, 3, verts, cpvzero);
cpShape *b = cpCircleShapeNew(body, 1, cpv(5, 0));""",
        ((0, 0, 4, 4), (4, -1, 6, 1)),
    ),
    Paste(
        "Box2D, third version",
        """b2Vec2 points[3] = {{0, 0}, {4, 0}, {4, 4}};
b2Hull hull = b2ComputeHull(points, 3);
b2Polygon a = b2MakePolygon(&hull, 0.0f);
b2Circle b = {{5, 0}, 1};""",
        ((0, 0, 4, 4), (4, -1, 6, 1)),
    ),
    Paste(
        "Box2D, third version, with a radius",
        "b2Vec2 points[3] = {{0, 0}, {4, 0}, {4, 4}};\nb2Polygon a = b2MakePolygon(&hull, 0.5f);\n(9,9), (8,9), (8,8)",
        ((0, 0, 4, 4), (8, 8, 9, 9)),
        says="b2MakePolygon 0.5f",
    ),
    # -- whole files
    Paste(
        "DXF",
        "".join(
            f"  0\nLWPOLYLINE\n  8\nwalls\n 90\n3\n 10\n{x}.0\n 20\n0\n 42\n0.0\n 10\n4.0\n 20\n0\n 10\n4.0\n 20\n4\n"
            for x in (0, 1)
        ),
        ((0, 0, 4, 4), (1, 0, 4, 4)),
    ),
    Paste(
        "DXF with an arc",
        "LWPOLYLINE\n 10\n0\n 20\n0\n 42\n0.5\n 10\n4\n 20\n4\n[0,0,4,0,4,4]",
        ((0, 0, 4, 4),),
        says="42",
    ),
    Paste(
        "an image map",
        """<area shape="rect" coords="0,0,4,4" href="a.htm">
<area shape="circle" coords="5,1,2"><area shape="poly" coords="1,1,5,1,5,5">""",
        ((0, 0, 4, 4), (3, -1, 7, 3), (1, 1, 5, 5)),
    ),
    Paste(
        "COCO",
        """[{"id": 1, "segmentation": [[0, 0, 4, 0, 4, 4]], "area": 8, "bbox": [0, 0, 4, 4]},
{"id": 2, "segmentation": [[1, 1, 5, 1, 5, 5]], "area": 8, "bbox": [1, 1, 4, 4]}]""",
        ((0, 0, 4, 4), (1, 1, 5, 5)),
    ),
    Paste(
        "PostScript, and a sentence",
        "newpath 0 0 moveto 4 0 lineto 4 4 lineto closepath stroke\nand a rectangle from (1, 1) to (5, 5)",
        ((0, 0, 4, 4), (1, 1, 5, 5)),
    ),
    Paste(
        "points as Unreal prints them",
        "A: X=0.0 Y=0.0, X=4.0 Y=0.0, X=4.0 Y=4.0\nB: X=1.0 Y=1.0, X=5.0 Y=1.0, X=5.0 Y=5.0",
        ((0, 0, 4, 4), (1, 1, 5, 5)),
    ),
    Paste(
        "KML with heights",
        "".join(f"<coordinates>{x},0,9 4,0,9 4,4,9 {x},0,9</coordinates>\n" for x in (0, 1)),
        ((0, 0, 4, 4), (1, 0, 4, 4)),
    ),
    Paste("commas and spaces", "0,0 4 0,4\n[0,0,4,0,4,4]", ((0, 0, 4, 4),), says="which are x and y"),
    Paste(
        "fields of XML on one line",
        "".join(f"<box><xmin>{x}</xmin><ymin>0</ymin><xmax>4</xmax><ymax>4</ymax></box>\n" for x in (0, 1)),
        ((0, 0, 4, 4), (1, 0, 4, 4)),
    ),
    Paste(
        "resolv",
        "a := resolv.NewConvexPolygon(0, 0, []float64{0, 0, 4, 0, 4, 4})\nb := resolv.NewCircle(5, 0, 1)",
        ((0, 0, 4, 4), (4, -1, 6, 1)),
    ),
    # -- calls with names of their own, and named arguments
    Paste(
        "a box of a call of one's own",
        "MyRect((1, 2), 3, 4)\nMyRect((0, 0), 3, 4)",
        ((1, 2, 4, 6), (0, 0, 3, 4)),
        as_="corner-size",
    ),
    Paste("a named radius", "Circle((0, 0), radius=3)\nCircle((5, 0), radius=3)", ((-3, -3, 3, 3), (2, -3, 8, 3))),
    Paste(
        "a center that is no point",
        '{"center": [1, 2, 3, 4], "radius": 2}\n{"center": [1, 2], "radius": 2}',
        ((-1, 0, 3, 4),),
        says="is not a point",
    ),
    Paste(
        "a named argument that is no corner",
        "Polygon([(0, 0), (4, 0), (4, 4)], foo=(3, 4))",
        ((0, 0, 4, 4),),
        says="foo 3, 4",
    ),
    # -- logs, debuggers, changes
    Paste(
        "syslog",
        """Nov 27 11:06:25 host game[1234]: circle((0, 0), 5)
Nov  3 11:06:26 my.host physics: circle((3, 0), 5)""",
        ((-5, -5, 5, 5), (-2, -5, 8, 5)),
    ),
    Paste(
        "syslog of RFC 5424",
        """<34>1 2003-10-11T22:14:15.003Z machine app 123 ID47 - circle((0, 0), 5)
<34>1 2003-10-11T22:14:15.004Z machine app 123 ID47 - circle((3, 0), 5)""",
        ((-5, -5, 5, 5), (-2, -5, 8, 5)),
    ),
    Paste(
        "glog",
        """I0512 10:11:12.123456 1234 main.cc:33] QRect(0, 0, 4, 4)
W0512 10:11:12.123456 1234 main.cc:34] QRect(3, 0, 4, 4)""",
        ((0, 0, 4, 4), (3, 0, 7, 4)),
    ),
    Paste(
        "a log with seconds since 1970",
        """[1715500000.123] QRect(0, 0, 4, 4)
[1715500000.456] QRect(3, 0, 4, 4)""",
        ((0, 0, 4, 4), (3, 0, 7, 4)),
    ),
    Paste(
        "a watch window of Visual Studio",
        """-\t\ta\t{ size=3 }\tstd::vector<sf::Vector2<float>,std::allocator<sf::Vector2<float>>>
\t\t[capacity]\t3\tunsigned __int64
\t\t[allocator]\tallocator\tstd::_Compressed_pair<...>
+\t\t[0]\t{x=0.00000000 y=0.00000000 }\tsf::Vector2<float>
+\t\t[1]\t{x=4.00000000 y=0.00000000 }\tsf::Vector2<float>
+\t\t[2]\t{x=0.00000000 y=3.00000000 }\tsf::Vector2<float>
-\t\tb\t{ size=3 }\tstd::vector<Vec2>
\t\t[0]\t{x=1.00000000 y=1.00000000 }\tVec2
\t\t[1]\t{x=5.00000000 y=1.00000000 }\tVec2
\t\t[2]\t{x=1.00000000 y=4.00000000 }\tVec2""",
        ((0, 0, 4, 3), (1, 1, 5, 4)),
    ),
    Paste(
        "a watch window with structs and an array",
        """a\t{x=0.0 y=0.0 r=5.0}\tCircle
verts\t0x00f3fa4c {{x=0.0 y=0.0}, {x=4.0 y=0.0}, {x=0.0 y=3.0}}\tVec2[3]""",
        ((-5, -5, 5, 5), (0, 0, 4, 3)),
    ),
    Paste(
        "words after a struct", "{x=0 y=0 r=5}\tmoved 4\n{x=3 y=0 r=5}", ((-5, -5, 5, 5), (-2, -5, 8, 5)), says="moved"
    ),
    Paste(
        "gdb",
        """$1 = std::vector of length 3, capacity 4 = {{x = 0, y = 0}, {x = 4, y = 0}, {x = 0, y = 3}}
(gdb) p box
$2 = {min = {x = 1, y = 1}, max = {x = 5, y = 4}}""",
        ((0, 0, 4, 3), (1, 1, 5, 4)),
    ),
    Paste(
        "lldb",
        """(std::vector<Vec2>) a = size=3 {
  [0] = (x = 0, y = 0)
  [1] = (x = 4, y = 0)
  [2] = (x = 0, y = 3)
}
(CGRect) $R1 = (origin = (x = 3, y = 0), size = (width = 4, height = 4))""",
        ((0, 0, 4, 3), (3, 0, 7, 4)),
    ),
    Paste(
        "diff of a CSV file",
        """--- a/shapes.csv
+++ b/shapes.csv
@@ -1,8 +1,8 @@
 shape,x,y
 a,0,0
 a,4,0
-a,0,2
+a,0,3
 b,1,1
 b,5,1
 b,1,4""",
        ((0, 0, 4, 3), (1, 1, 5, 4)),
    ),
    Paste(
        "diff of a CSV file with sizes",
        """@@ -1,3 +1,3 @@
 x,y,r
-0,0,4
+1,1,4
 3,0,4""",
        ((-3, -3, 5, 5), (-1, -4, 7, 4)),
    ),
    # -- what is no shape, or may be none
    Paste(
        "GDScript, exported variables that instances set",
        """class_name Hitbox
extends Resource
@export var rect = Rect2(0, 0, 4, 4)

var a = Hitbox.new()
a.rect = Rect2(1, 1, 4, 4)
var b = Hitbox.new()
b.rect = Rect2(3, 1, 4, 4)""",
        ((1, 1, 5, 5), (3, 1, 7, 5)),
    ),
    Paste(
        "GDScript, exported variables beside shapes",
        """extends Area2D
class_name Hitbox
@export var x = 0
@export var y = 0
@export_range(0, 10) var width = 4
@export var height = 3

var a = Rect2(0, 0, 4, 4)
var b = Rect2(3, 0, 4, 4)""",
        ((0, 0, 4, 4), (3, 0, 7, 4)),
        says="what a class begins with",
    ),
    Paste(
        "GDScript of Godot 3, exported variables alone",
        """extends KinematicBody2D
export(int) var radius = 5
export var center = Vector2(10, 10)""",
        ((5, 5, 15, 15),),
    ),
    *(
        Paste(
            f"circles beside {line!r}",
            f"circle((0, 0), 5)\ncircle((3, 0), 5)\n{line}",
            ((-5, -5, 5, 5), (-2, -5, 8, 5)),
            says="something else" if any(c in line for c in "[(") or line[0] == "1" else line[:3],
        )
        for line in (
            "Edit: with (0, 0, 5, 5) it works",
            "EDIT 2: [0, 0, 5, 5] too",
            "Update: circle((9, 9), 5)",
            "I tried box(0, 0, 5, 5)",
            "phone: (0, 30, 123, 4567)",
            "VERSION = [1, 2, 3, 4]",
            "__version__ = (3, 12, 1, 0)",
            "color = [1, 0, 0, 1]",
            "12, 5, 2024, 10",
        )
    ),
    Paste(
        "a shape that may be none, taken in",
        "circle((0, 0), 5)\ncircle((3, 0), 5)\nEdit: circle((9, 9), 5)",
        ((-5, -5, 5, 5), (-2, -5, 8, 5), (4, 4, 14, 14)),
        as_="take-in",
    ),
    Paste(
        "shapes in a sentence that says that they work",
        "[(0, 0), (4, 0), (0, 3)] works, [(1, 1), (5, 1), (1, 4)] not",
        ((0, 0, 4, 3), (1, 1, 5, 4)),
    ),
    # -- files of engines
    Paste(
        "colliders of Unity",
        """--- !u!61 &1234567
BoxCollider2D:
  m_Enabled: 1
  m_Offset: {x: 1, y: 2}
  serializedVersion: 2
  m_Size: {x: 4, y: 4}
  m_EdgeRadius: 0
--- !u!58 &1234568
CircleCollider2D:
  m_Offset: {x: 7, y: 0}
  m_Radius: 5
--- !u!60 &1234569
PolygonCollider2D:
  m_Offset: {x: 1, y: 0}
  m_Points:
    m_Paths:
    - - {x: 0, y: 0}
      - {x: 4, y: 0}
      - {x: 0, y: 3}
EdgeCollider2D:
  m_Points:
  - {x: 1, y: 1}
  - {x: 5, y: 1}
  - {x: 1, y: 4}""",
        ((-1, 0, 3, 4), (2, -5, 12, 5), (1, 0, 5, 3), (1, 1, 5, 4)),
    ),
    Paste(
        "a collider of Unity with a transform",
        """Transform:
  m_LocalPosition: {x: 10, y: 0, z: 0}
  m_LocalScale: {x: 2, y: 2, z: 1}
BoxCollider2D:
  m_Size: {x: 4, y: 4}
CapsuleCollider2D:
  m_Size: {x: 4, y: 8}""",
        ((-2, -2, 2, 2),),
        says="CapsuleCollider2D is not read",
    ),
    Paste(
        "a scene of Godot with resources",
        """[gd_scene load_steps=2 format=3 uid="uid://abc"]

[sub_resource type="RectangleShape2D" id="1"]
size = Vector2(4, 2)

[sub_resource type="CircleShape2D" id="2_x"]
radius = 5.0

[node name="Player" type="Area2D" parent="."]
position = Vector2(10, 20)

[node name="A" type="CollisionShape2D" parent="Player"]
position = Vector2(1, 1)
shape = SubResource("1")

[node name="B" type="CollisionShape2D" parent="."]
position = Vector2(5, 1)
rotation = 1.5
shape = SubResource("2_x")

[node name="C" type="CollisionPolygon2D" parent="."]
position = Vector2(1, 1)
polygon = PackedVector2Array(0, 0, 4, 0, 0, 3)""",
        ((9, 20, 13, 22), (0, -4, 10, 6), (1, 1, 5, 4)),
    ),
    Paste(
        "a scene of Godot 3 with extents and a scale",
        """[sub_resource type="RectangleShape2D" id=1]
extents = Vector2( 4, 4 )

[node name="A" type="CollisionShape2D" parent="."]
position = Vector2( 1, 1 )
shape = SubResource( 1 )

[node name="B" type="CollisionShape2D" parent="."]
position = Vector2( 5, 1 )
scale = Vector2( 2, 2 )
shape = SubResource( 1 )""",
        ((-3, -3, 5, 5), (1, -3, 9, 5)),
        says="scale 2, 2",
    ),
    Paste(
        "a scene of Godot with a capsule",
        """[sub_resource type="CapsuleShape2D" id="1"]
radius = 5.0
height = 20.0

[sub_resource type="CircleShape2D" id="2"]
radius = 5.0""",
        ((-5, -5, 5, 5),),
        says="CapsuleShape2D is not read",
    ),
    Paste(
        "blocks of YAML with other keys between the numbers",
        """a:
  x: 0
  y: 0
  visible: true
  radius: 5
b:
  x: 9
  enabled: true
  y: 0
  radius: 5""",
        ((-5, -5, 5, 5), (4, -5, 14, 5)),
    ),
    # -- what an outsider found
    Paste(
        "OpenCV draws a box by two corners",
        """cv2.rectangle(img, (10, 10), (50, 30), (0, 255, 0), 2)
cv2.circle(img, (60, 20), 10, (0, 0, 255), -1)""",
        ((10, 10, 50, 30), (50, 10, 70, 30)),
    ),
    Paste(
        "Matter.js prints corners that are absolute and turned",
        """{"position":{"x":100,"y":100},"angle":0.7853981633974483,"vertices":[{"x":100,"y":71.7157},{"x":128.2843,"y":100},{"x":100,"y":128.2843},{"x":71.7157,"y":100}]}
{"position":{"x":150,"y":100},"angle":0,"vertices":[{"x":140,"y":90},{"x":160,"y":90},{"x":160,"y":110},{"x":140,"y":110}]}""",
        ((71.7157, 71.7157, 128.2843, 128.2843), (140, 90, 160, 110)),
    ),
    Paste(
        "a hole in GeoJSON order",
        """const a = [[[0,0],[10,0],[10,10],[0,10],[0,0]], [[2,2],[8,2],[8,8],[2,8],[2,2]]];
const b = [[[4,4],[6,4],[6,6],[4,6],[4,4]]];""",
        ((0, 0, 10, 10), (4, 4, 6, 6)),
        says="a hole of the first",
    ),
    Paste(
        "rings of Esri JSON",
        """{"rings":[[[0,0],[0,10],[10,10],[10,0],[0,0]],[[2,2],[8,2],[8,8],[2,8],[2,2]]]}
{"rings":[[[4,4],[4,6],[6,6],[6,4],[4,4]]]}""",
        ((0, 0, 10, 10), (4, 4, 6, 6)),
        says="a hole of the first",
    ),
    Paste(
        "Phaser 2 gives a circle its diameter",
        """var a = new Phaser.Circle(100, 100, 50);
var b = new Phaser.Geom.Circle(160, 100, 50);""",
        ((75, 75, 125, 125), (110, 50, 210, 150)),
    ),
    *(
        Paste(f"points of a test, {name}", f"{name}({points})", (), says="does not say what its points are")
        for name, points in (
            (
                "collide_aabb::collide",
                "Vec3::new(160.0, 275.0, 0.0), Vec2::new(80.0, 50.0), Vec3::new(232.0, 294.0, 0.0)",
            ),
            ("Geometry2D.segment_intersects_segment", "Vector2(0, 0), Vector2(4, 4), Vector2(0, 4), Vector2(4, 0)"),
            ("hit = collide", "Vec2(5, 5), Vec2(10, 10), Vec2(20, 5), Vec2(10, 10)"),
        )
    ),
    Paste(
        "a rectangle with a position and no size",
        "rectangle position (10, 10), circle position (50, 20), radius 4",
        ((46, 16, 54, 24),),
        says="rectangle position 10, 10",
    ),
    Paste(
        "words before pairs of numbers",
        """player: pos (0, 0) vel (5, 0) size (10, 10)
wall: pos (10, 0) vel (0, 0) size (10, 10)""",
        ((0, 0, 10, 10), (10, 0, 20, 10)),
    ),
    Paste(
        "words before pairs of numbers, with a center",
        """ball: center (0, 0) velocity (5, 0) size (10, 10)
wall: center (10, 0) velocity (0, 0) size (10, 10)""",
        ((-5, -5, 5, 5), (5, -5, 15, 5)),
    ),
    Paste(
        "centers and sizes in a test of boxes",
        "collide_aabb::collide(Vec3::new(160.0, 275.0, 0.0), Vec2::new(80.0, 50.0), Vec3::new(232.0, 294.0, 0.0), "
        "Vec2::new(20.0, 20.0))",
        ((120, 250, 200, 300), (222, 284, 242, 304)),
        as_="center-size",
        says="A third coordinate was left out",
        asks=True,
    ),
    Paste(
        "opposite corners in a test of boxes",
        "aabbOverlap(vec2(0,0), vec2(4,4), vec2(4,1), vec2(6,3))",
        ((0, 0, 4, 4), (4, 1, 6, 3)),
        as_="corner-corner",
        asks=True,
    ),
    Paste(
        "six corners in a test of triangles",
        "trianglesOverlap(vec2(0,0), vec2(4,0), vec2(0,4), vec2(3,3), vec2(6,3), vec2(3,6))",
        ((0, 0, 4, 4), (3, 3, 6, 6)),
    ),
    Paste(
        "two holes in a call of turf",
        """var a = turf.polygon([[[0,0],[20,0],[20,10],[0,10],[0,0]], [[2,2],[8,2],[8,8]],
  [[12,2],[18,2],[18,8]]]);
var b = turf.polygon([[[4,4],[6,4],[6,6],[4,6],[4,4]]]);""",
        ((0, 0, 20, 10), (4, 4, 6, 6)),
        says="[[12,2],[18,2],[18,8]]: a shape of its own, or a hole of the first",
    ),
    Paste(
        "one outline within another in a list of shapes",
        "polygons = [[(0,0),(10,0),(10,10),(0,10)],[(2,2),(8,2),(8,8)]]",
        ((0, 0, 10, 10), (2, 2, 8, 8)),
    ),
    Paste(
        "one outline within another in a call with two",
        "intersects([[0,0],[10,0],[10,10],[0,10]], [[2,2],[8,2],[8,8]])",
        ((0, 0, 10, 10), (2, 2, 8, 8)),
    ),
    Paste(
        "corners that are absolute and turned, and a position that is not their center",
        """{"position": [10, 0], "angle": 90, "points": [[10, 0], [12, 0], [12, 1], [10, 1]]}
circle((11, 3), 1)""",
        ((10, 0, 12, 1), (10, 2, 12, 4)),
        as_="absolute, degrees",
        asks=True,
    ),
    Paste(
        "corners that are absolute and still to be turned",
        """{"position": [10, 0], "angle": 90, "points": [[10, 0], [12, 0], [12, 1], [10, 1]]}
circle((11, 3), 1)""",
        ((9, 0, 10, 2), (10, 2, 12, 4)),
        as_="unturned, degrees",
        asks=True,
    ),
    Paste(
        "rows of x, y and r under the name of circles",
        "circles = [(0, 0, 5), (10, 0, 5)]",
        ((-5, -5, 5, 5), (5, -5, 15, 5)),
    ),
    Paste(
        "three numbers that are indices",
        """vertices = [(0,0),(4,0),(4,4),(0,4)]
triangles = [(0,1,2),(0,2,3)]
circle((9, 9), 1)""",
        ((0, 0, 4, 4), (8, 8, 10, 10)),
        says="corners in the place of indices",
    ),
    Paste(
        "a polygon of two corners",
        """new SAT.Polygon(new SAT.V(50,50), [new SAT.V(0,0), new SAT.V(10,0)])
new SAT.Circle(new SAT.V(0,0), 10)""",
        ((-10, -10, 10, 10),),
        says="two corners are a segment",
    ),
    Paste(
        "triangles in space",
        """ConvexPolygon((Point(0, 0, 0), Point(4, 0, 190), Point(0, 4, 190)))
ConvexPolygon((Point(9, 0, 0), Point(13, 0, 190), Point(9, 4, 190)))""",
        ((0, 0, 4, 4), (9, 0, 13, 4)),
        says="The third coordinates differ and were left out",
    ),
    *(
        Paste(f"flat lists of {name}", f"{name} = [0, 0, 4, 4, 2, 2, 6, 6]", (), says="in one list")
        for name in ("boxes", "aabbs", "rectangles")
    ),
    # -- transforms of SVG
    Paste(
        "SVG groups with transforms",
        """<svg viewBox="0 0 100 100">
 <g transform="translate(10 5) scale(2)">
  <circle cx="0" cy="0" r="4"/>
  <g transform="translate(1)" fill="red"><polygon points="0,0 4,0 0,3"/></g>
  <g><rect width="1" height="2"/></g>
 </g>
 <rect x="12" y="0" width="4" height="4"/>
</svg>""",
        ((2, -3, 18, 13), (12, 5, 20, 11), (10, 5, 12, 9), (12, 0, 16, 4)),
    ),
    Paste(
        "SVG elements with transforms",
        """<rect width="4" height="4" transform="scale(2, .5)"/>
<rect x="12" width="4" height="4" transform="matrix(1 0 0 1 5 5)"/>
<rect width="4" height="2" transform="translate(3 4) rotate(90)"/>
<rect x="12" width="4" height="4" transform="rotate(45, 14 2)"/>
<circle cx="12" r="4" transform="matrix(3 4 -4 3 0 0)"/>""",
        (
            (0, 0, 8, 2),
            (17, 5, 21, 9),
            (1, 4, 3, 8),
            (11.171572875, -0.828427125, 16.828427125, 4.828427125),
            (16, 28, 56, 68),
        ),
    ),
    *(
        Paste(
            f"SVG with {transform}",
            f'<circle r="4" {transform}/>\n<circle cx="7" r="4"/>\n<rect width="1" height="1"/>',
            ((3, -4, 11, 4), (0, 0, 1, 1)),
            says=says,
        )
        for transform, says in (
            ('transform="skewX(30)"', "'skewX(30)' is not applied"),
            ('transform="scale(2, 1)"', "turns a circle into an ellipse"),
            ('transform="scale(k)"', "'scale(k)' is not applied"),
            ('transform="rotate(1 2)"', "'rotate(1 2)' is not applied"),
            ('transform="rotate(5)" transform-origin="2 2"', "'2 2' is not applied"),
        )
    ),
    *(
        Paste(
            f"an SVG group with {transform}",
            f'<g {transform}><circle r="4"/></g>\n<circle cx="7" r="4"/>',
            ((-4, -4, 4, 4), (3, -4, 11, 4)),
            says=says,
        )
        for transform, says in (
            ('transform="skewX(30)"', "skewX"),
            ('transform="rotate(5)" transform-origin="2 2"', "rotate"),
            ("transform={at}", "circle"),
            ('style="transform: scale(2)"', "scale 2"),
        )
    ),
    # -- code that does not change the numbers
    Paste(
        "names of shapes with numbers",
        "Rect1(0, 0, 10, 10), Circle2(0, 11, 10)",
        ((0, 0, 10, 10), (-10, 1, 10, 21)),
        as_="corner-size radius",
    ),
    Paste(
        "numbers in the wrapper of an exact type",
        """std::vector<Pt> a = { Pt(FT(192),FT(768)), Pt(FT(128),FT(688)), Pt(FT(160),FT(688)) };
std::vector<Pt> b = { Pt(FT(160),FT(656)), Pt(FT(192),FT(608)), Pt(FT(320),FT(608)) };""",
        ((128, 688, 192, 768), (160, 608, 320, 656)),
    ),
    Paste(
        "arrows before boxes",
        """[zones] P33 bbox -> (110, 106.5)-(196.5, 168.5)
[zones] P18 bbox -> (116.3, 117)-(134.5, 173.5)""",
        ((110, 106.5, 196.5, 168.5), (116.3, 117, 134.5, 173.5)),
    ),
    Paste(
        "a type of Rust with a length",
        """pub const A: [(f64, f64); 3] = [(0.0, 0.0), (4.0, 0.0), (0.0, 4.0)];
pub const B: [(f64, f64); 3] = [(1.0, 1.0), (5.0, 1.0), (1.0, 5.0)];""",
        ((0, 0, 4, 4), (1, 1, 5, 5)),
    ),
    Paste(
        "a verbatim text of C#",
        """var a = reader.Read(@"POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))");
var b = reader.Read(@"POLYGON ((5 5, 6 5, 6 6, 5 5))");""",
        ((0, 0, 4, 4), (5, 5, 6, 6)),
    ),
    Paste(
        "iterators of C++",
        """std::vector<P> u; u.emplace_back(0, 0); u.emplace_back(4, 0); u.emplace_back(0, 4);
Polygon_2 pu(u.begin(), u.end());
circle((9, 9), 1)""",
        ((0, 0, 4, 4), (8, 8, 10, 10)),
    ),
    Paste(
        "objects as pairs",
        """const a = [{x: 0, y: 0}, {x: 4, y: 0}, {x: 0, y: 4}];
const b = [{x: 1, y: 1}, {x: 5, y: 1}, {x: 1, y: 5}];
const pa = polygon(a.map(p => [p.x, p.y]));
const pb = polygon(b.map(({x, y}) => [x, y]));""",
        ((0, 0, 4, 4), (1, 1, 5, 5)),
    ),
    Paste(
        "objects with other pairs",
        """const a = [{x: 0, y: 0}, {x: 4, y: 0}, {x: 0, y: 4}];
const pa = polygon(a.map(p => [p.y, p.x]));""",
        ((0, 0, 4, 4),),
        says="a.map",
    ),
    Paste("a table with the column d", "cx,cy,d\n0,0,10\n12,0,10", ((-5, -5, 5, 5), (7, -5, 17, 5))),
    Paste(
        "a circle and an outline within it in one list",
        "[((0, 0), 5), [(1, 1), (2, 1), (1, 2)]]",
        ((-5, -5, 5, 5), (1, 1, 2, 2)),
    ),
    Paste(
        "two outlines of a call",
        "polygonClipping.intersection([[0, 0], [9, 0], [0, 9]], [[1, 1], [2, 1], [1, 2]])",
        ((0, 0, 9, 9), (1, 1, 2, 2)),
    ),
    # -- boxes by the names of their calls, and what stands beside shapes
    Paste(
        "boxes of Skia, MFC, egui, Unity and arcade",
        """auto a = SkRect::MakeLTRB(0, 0, 4, 4);
auto b = SkRect::MakeXYWH(4, 1, 2, 2);
CRect c(4, 1, 6, 3);
let d = Rect::from_two_pos(pos2(4.0, 1.0), pos2(6.0, 3.0));
let e = Rect::from_min_size(pos2(0.0, 0.0), vec2(4.0, 4.0));
var f = Rect.MinMaxRect(0, 0, 4, 4);
g = arcade.LRBT(10, 60, 20, 40)
arcade.draw_rectangle_filled(35, 25, 50, 30, arcade.color.RED)""",
        (
            (0, 0, 4, 4),
            (4, 1, 6, 3),
            (4, 1, 6, 3),
            (4, 1, 6, 3),
            (0, 0, 4, 4),
            (0, 0, 4, 4),
            (10, 20, 60, 40),
            (10, 10, 60, 40),
        ),
    ),
    Paste(
        "circles in a list by that name",
        "circles = [(0, 0, 5), (10, 0, 5), (20, 0, 5)]",
        ((-5, -5, 5, 5), (5, -5, 15, 5), (15, -5, 25, 5)),
    ),
    Paste(
        "a list of points with three numbers", "items = [(0, 0, 5), (10, 0, 5), (20, 9, 5)]", (), says="three numbers"
    ),
    Paste(
        "half sizes in JSON",
        '[{"x":0,"y":0,"halfWidth":5,"halfHeight":5},{"x":10,"y":0,"halfWidth":5,"halfHeight":5}]',
        ((-5, -5, 5, 5), (5, -5, 15, 5)),
    ),
    Paste(
        "variables min and max",
        """let min = Point2::new(1.5, 3.0);
let max = Point2::new(7.0, 11.0);
let c = Circle::new(Point2::new(0.0, 0.0), 1.0);""",
        ((1.5, 3, 7, 11), (-1, -1, 1, 1)),
    ),
    Paste(
        "the polyline of an object of Tiled",
        '{"polyline": [{"x":0,"y":0},{"x":4,"y":0},{"x":0,"y":3}], "x":32, "y":24}',
        ((32, 24, 36, 27),),
    ),
    Paste(
        "what a test gives",
        """a = Circle(0, 0, 5)
b = Circle(3, 0, 5)
let toi = query::time_of_impact(&a, &b);
overlaps(a, b) = 1.35""",
        ((-5, -5, 5, 5), (-2, -5, 8, 5)),
    ),
    Paste(
        "numbers in a sentence",
        "[[0,0],[4,0],[0,4]]\n[[5,5],[9,5],[5,9]]\nthe result should only be 1 polygon, not 2",
        ((0, 0, 4, 4), (5, 5, 9, 9)),
    ),
    Paste(
        "a polygon of three points with three numbers",
        "a = Polygon(Vec3(0, 0, 1), Vec3(4, 0, 1), Vec3(0, 4, 1))",
        ((0, 0, 4, 4),),
    ),
    Paste(
        "a box that is not understood",
        "bbox: (110, 106) if c else d\ncircle((0, 0), 5)",
        ((-5, -5, 5, 5),),
        says="bbox 110, 106",
    ),
)
