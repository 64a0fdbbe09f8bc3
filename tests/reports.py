"""Reports of wrong collisions from public trackers: numbers and notation, retyped, with a pointer to the thread.

`relation` is that of the two shapes as `as_` reads them; None where a shape is refused.  `finding` is the main finding.
`meant` is the relation of an outline that crosses itself once its corners are in convex order.
"""

from typing import NamedTuple


class Report(NamedTuple):
    """A report: where it stands, in which notation, the text, and what is expected of it."""

    thread: str
    notation: str
    text: str
    relation: str | None
    finding: str
    as_: str = ""
    kinds: str = "polygon polygon"
    meant: str = ""
    asks: str = ""


REPORTS = (
    Report(
        "libgdx/libgdx#1635",
        "Java float[]",
        """Intersector.overlapConvexPolygons(
            new float[]{100.0f, 750.0f, 200.0f, 750.0f, 100.0f, 150.0f, 200.0f, 150.0f},
            new float[]{77.0f, 695.0f, 91.0f, 695.0f, 84.0f, 681.0f},
            null);""",
        None,
        "crossing-outline",
        kinds="refused polygon",
        meant="apart",
    ),
    Report(
        "libgdx/libgdx#5171",
        "Java float[]",
        """float[] vertices = new float[] {1, 1, 3, 1, 2, 2};
Polygon p1 = new Polygon(vertices);
float[] vertices2 = new float[] {1, 1, 3, 1, 2, 3};
Polygon p3 = new Polygon(vertices2);
System.out.println(Intersector.intersectPolygons(p1, p3, new Polygon()));""",
        "overlapping",
        "containment",
    ),
    Report(
        "libgdx/libgdx#7228",
        "Java float[]",
        """var clip = new Polygon(new float[] {94.5f, 0.0f, 94.5f, 63.0f, 189.0f, 63.0f, 189.0f, 0.0f});
var toClip = new Polygon(new float[] {0.0f, 0.0f, 0.0f, 200.0f, 310.0f, 200.0f, 310.0f, 0.0f, 210.0f, 0.0f, 210.0f, 100.0f,
    100.0f, 100.0f, 100.0f, 0.0f});
var intersect = new Polygon();
Intersector.intersectPolygons(toClip, clip, intersect);""",
        "overlapping",
        "clear",
    ),
    Report(
        "libgdx/libgdx#6679",
        "Java float[]",
        """float[] vertices1 = new float[]{-50, 0, 50, 0, 50, 50, -50, 50};
float[] vertices2 = new float[]{-10, -100, 10, -100, 10, 100, -10, 100};
Polygon poly1 = new Polygon(vertices1);
Polygon poly2 = new Polygon(vertices2);
boolean b1 = Intersector.intersectPolygons(poly1, poly2, null);""",
        "overlapping",
        "clear",
    ),
    Report(
        "libgdx/libgdx#7408",
        "Java float[]",
        """Polygon p1 = new Polygon(new float[]{1,-1,2,-1,2,-2,1,-2});
Polygon p2 = new Polygon(new float[]{0.5f,-1.5f,1.5f,-1.5f,1.5f,-2.5f});""",
        "overlapping",
        "clear",
    ),
    Report(
        "libgdx/libgdx#6986",
        "Java float[]",
        """Polygon p1 = new Polygon(new float[]{3018.6086f, 304.13184f, 2983.5085f, 263.56183f, 2903.8853f, 253.33517f,
    2857.1885f, 283.38184f, 2863.5386f, 328.83517f, 2913.5886f, 357.0285f, 2981.1785f, 353.03516f});
Polygon p2 = new Polygon(new float[]{2996.0f, 277.0f, 2996.0f, 278.0f, 2997.0f, 278.0f, 2997.0f, 277.0f});""",
        "overlapping",
        "near-touch",
    ),
    Report(
        "libgdx/libgdx#7454",
        "numbers in prose",
        """When initializing `trapezoid` with `-2.8626027, -3.054608, 0.09345288, 14.654785, 18.01647, 4.9480224, 4.8018613,
-7.2055407` and `square` with `-8.879811, -14.852028, -8.879811, 5.1479716, 11.120189, 5.1479716, 11.120189, -14.852028`""",
        "overlapping",
        "clear",
    ),
    Report(
        "RandyGaul/cute_headers#366",
        "C lines",
        """    c2Poly poly_world;
    poly_world.count = 4;
    poly_world.verts[0] = c2V(-1.0, -1.0);
    poly_world.verts[1] = c2V(1.0, -1.0);
    poly_world.verts[2] = c2V(1.0, 1.0);
    poly_world.verts[3] = c2V(-1.0, 1.0);

    c2Poly poly_car;
    poly_car.count = 4;
    poly_car.verts[0] = c2V(-0.05, -1.04);
    poly_car.verts[1] = c2V(0.05, -1.04);
    poly_car.verts[2] = c2V(0.05, -0.94);
    poly_car.verts[3] = c2V(-0.05, -0.94);

    int res = c2PolytoPoly(&poly_car, NULL, &poly_world, NULL);
    printf("res: %d\\n", res);

    c2Manifold m;
    c2PolytoPolyManifold(&poly_car, NULL, &poly_world, NULL, &m);
    printf("m.count: %d\\n", m.count);
```

Result:
```
gcc main.c -lm && ./a.out
res: 1
m.count: 0
```""",
        "overlapping",
        "clear",
    ),
    Report(
        "RandyGaul/cute_headers#160",
        "C initialiser",
        """{
    c2v p0[] = {
        { -568.0f, 928.0f },
        { -568.0f, 1056.0f },
        { -848.0f, 1056.0f },
        { -848.0f, 928.0f }
    };
    c2v p1[] = {
        { -688.0f, 736.0f },
        { -688.0f, 1184.0f },
        { -912.0f, 1184.0f },
        { -912.0f, 736.0f }
    };
    c2Poly poly0;
    poly0.count = 4;
    memcpy_s(poly0.verts, 8 * sizeof(c2v), p0, 4 * sizeof(c2v));
}""",
        "overlapping",
        "left-out",
        as_="leave-out",
    ),
    Report(
        "RandyGaul/cute_headers#252",
        "C lines",
        """c2Poly poly;
poly.verts[0] = c2V(2.0f, 39.0f);
poly.verts[1] = c2V(2.0f, 40.0f);
poly.verts[2] = c2V(1.0f, 40.0f);
poly.verts[3] = c2V(1.0f, 39.0f);
poly.count = 4;
c2MakePoly(&poly);

c2Circle circle;
circle.p = c2V(2.34812546f,40.4136238f);
circle.r = 0.5f;""",
        "apart",
        "clear",
        kinds="polygon circle",
    ),
    Report(
        "RandyGaul/cute_headers#133",
        "C lines",
        """c2Circle circle;
circle.p = c2V(0, 500);
circle.r = 50;

c2AABB aabb;
aabb.min = c2V(1260, 0);
aabb.max = c2V(1280, 720);""",
        "apart",
        "clear",
        kinds="circle polygon",
    ),
    Report(
        "RandyGaul/cute_headers#92",
        "C lines",
        """c2AABB ba;
ba.min = c2V( -50.0f, -200.0f );
ba.max = c2V( 50.0f, -100.0f );
c2AABB bb;
bb.min = c2V( -10.0f, -225.0f );
bb.max = c2V( 49.0f, -200.0f );
c2Manifold m;
c2AABBtoAABBManifold(ba, bb, &m);
printf("count %d depth %f", m.count, m.depths[0]);""",
        "touching",
        "touching",
    ),
    Report(
        "jriecken/sat-js#55",
        "JavaScript constructors",
        """var V = SAT.Vector;
var C = SAT.Circle;
var B = SAT.Box;
var circle = new C(new V(50,50), 20);
var polygon = new B(new V(1000,1000), 20, 0).toPolygon();
var collided = SAT.testPolygonCircle(polygon, circle, response);""",
        None,
        "zero-area",
        kinds="circle refused",
        asks="box",
    ),
    Report(
        "robertcorponoi/collider2d#12",
        "TypeScript constructors",
        """const ballCircle: Circle = new Circle(new Vector(0, 0), 0.115);
const goalLinePolygon: Polygon = new Polygon(new Vector(0, 0),
    [
        new Vector(1.56, -0.04),
        new Vector(1.56, 0.04),
        new Vector(-1.56, 0.04),
        new Vector(-1.56, -0.04),
    ]);""",
        "overlapping",
        "clear",
        kinds="circle polygon",
    ),
    Report(
        "robertcorponoi/collider2d#12 (the second pair)",
        "TypeScript constructors",
        """const ballCircle: Circle = new Circle(new Vector(0, -55), 0.115);
const goalLinePolygon: Polygon = new Polygon(new Vector(0, -55),
    [
        new Vector(1.56, -54.96),
        new Vector(1.56, -55.04),
        new Vector(-1.56, -55.04),
        new Vector(-1.56, -54.96),
    ]);""",
        "apart",
        "position-twice",
        kinds="circle polygon",
    ),
    Report(
        "nenjack/check2d#25",
        "JSON and words",
        'first is `{"x":13.3338,"y":0} radius: 50` and second is `{"x":-86.6663,"y":0} radius: 50`',
        "apart",
        "whole-numbers",
        kinds="circle circle",
    ),
    Report(
        "nenjack/check2d#52",
        "TypeScript constructors",
        """const box1 = new Box({ x: 115, y: 152 }, 100, 100);
const circle1 = new Circle({ x: 100, y: 100 }, 50);
system.insert(box1);
system.insert(circle1);""",
        "apart",
        "corner-for-center",
        as_="corner-size",
        kinds="polygon circle",
    ),
    Report(
        "Sinova/Collisions#4",
        "JavaScript calls",
        """this.collisions.createPolygon(382.5, 255, [[-62.5, -5], [-62.5, 5], [62.5, 5], [62.5, -5]]);
this.collisions.createPolygon(507.5, 255, [[-62.5, -5], [-62.5, 5], [62.5, 5], [62.5, -5]]);""",
        "touching",
        "touching",
    ),
    Report(
        "HarryStevens/geometric#29",
        "JavaScript lists",
        """Polygon A)
[
  [3, 3],
  [3, 4],
  [4, 4],
  [4, 3]
]
Polygon B)
[
  [1, 1],
  [1, 4],
  [2, 4],
  [2, 2],
  [5, 2],
  [5, 4],
  [6, 4],
  [6, 1]
]""",
        "apart",
        "concave",
    ),
    Report(
        "DudaGod/polygons-intersect#4",
        "JSON objects",
        """[{"x":903,"y":429},{"x":1184,"y":429},{"x":1184,"y":621},{"x":903,"y":621}]
[{"x":902,"y":441},{"x":1185,"y":441},{"x":1185,"y":631},{"x":902,"y":631}]""",
        "overlapping",
        "clear",
    ),
    Report(
        "mathigon/euclid.js#151",
        "TypeScript constructors",
        """intersections(
    new Circle( new Point(2, 3), 1),
    new Polygon( new Point(2, 3), new Point(3, 3), new Point(3, 4), new Point(2, 4)
);""",
        "overlapping",
        "clear",
        kinds="circle polygon",
    ),
    Report(
        "liabru/matter-js#12",
        "JavaScript calls",
        """Matter.World.add(engine.world, Matter.Bodies.rectangle(380.5, 25.5, 102, 102, { isStatic: false, density: 1.0 }));
Matter.World.add(engine.world, Matter.Bodies.rectangle(193.5, 25.5, 102, 102, { isStatic: false, density: 1.0 }));""",
        "apart",
        "clear",
    ),
    Report(
        "corehtml5canvas/code#11 (with the box of the picture)",
        "JavaScript constructors",
        """[ new Point(25.5, 100), new Point(200.5, 200),
        new Point(400.5, 200), new Point(600.5, 160),
        new Point(600.5, 300), new Point(16.5, 300) ]
[ new Point(300, 120), new Point(340, 120), new Point(340, 160), new Point(300, 160) ]""",
        "apart",
        "concave",
    ),
    Report(
        "georust/geo#419",
        "Rust structs",
        """let a = Rect { min: Coordinate { x: 9.228515625, y: 46.83013364044739 },
    max: Coordinate { x: 9.2724609375, y: 46.86019101567026 } };
let b = Rect { min: Coordinate { x: 9.17953, y: 46.82018 }, max: Coordinate { x: 9.26309, y: 46.88099 } };""",
        "overlapping",
        "clear",
    ),
    Report(
        "dimforge/parry#34",
        "Rust calls",
        """let contact = query::contact(
    &Isometry::translation(1.0, 1.0),
    &Ball::new(1.0),
    &Isometry::identity(),
    &Cuboid::new(Vector2::new(1.0, 1.0)),
    1.0,
)
.unwrap()
.unwrap();
assert!(contact.dist < 0.0);""",
        "overlapping",
        "clear",
        kinds="circle polygon",
    ),
    Report(
        "godotengine/godot#82305",
        "GDScript",
        """var half_plane_1 = PackedVector2Array([
    Vector2(50, 50),
    Vector2(50, 1130),
    Vector2(1268.352295, 1130),
    Vector2(1105.720703, 50),
])
var half_plane_2 = PackedVector2Array([
    Vector2(1268.352295, 1130),
    Vector2(1970, 1130),
    Vector2(1970, 50),
    Vector2(1105.720703, 50),
])""",
        "touching",
        "touching",
    ),
    Report(
        "godotengine/godot#86548",
        "GDScript",
        """var dataClockwise:PackedVector2Array = [Vector2(50,50), Vector2(50,400), Vector2(250,400), Vector2(250,50)]
var dataCC:PackedVector2Array = [Vector2(50,50), Vector2(50,250), Vector2(250,400), Vector2(400,50)]""",
        "overlapping",
        "clear",
    ),
    Report(
        "godotengine/godot#45283",
        "GDScript",
        """var r1 := Rect2(2, 2, -2, -2)
var r2 := Rect2(3, 3, -2, -2)
assert(r1.abs().intersects(r2.abs()))
assert(r1.intersects(r2))""",
        "overlapping",
        "negative-size",
        as_="leave-out",
    ),
    Report(
        "godotengine/godot#25829",
        "GDScript",
        """var rectA = Rect2(0, 0, 8, 8)
var rectC = Rect2(10, 10, -8, -8) # Equivalent to rectB
var overlap_AC_wrong = rectA.clip(rectC)""",
        "overlapping",
        "negative-size",
        as_="leave-out",
    ),
    Report(
        "SFML/SFML#219",
        "C++ calls",
        "sf::Rect(0,0,10,10) does not properly intersect with sf::Rect(15,15,-10,-10)",
        "overlapping",
        "negative-size",
        as_="corner-size",
    ),
    Report(
        "libsdl-org/SDL#12767",
        "C designated initialiser",
        """SDL_FRect a{
    .x = 0, .y = 0, .w = 32, .h = 32
};
SDL_FRect b{
    .x = 32, .y = 0, .w = 32, .h = 32
};
SDL_FRect c{ 0 };""",
        "touching",
        "touching",
    ),
    Report(
        "MonoGame/MonoGame#468",
        "C# constructors",
        """Rectangle rect1 = new Rectangle(0,0,32,32);
Rectangle rect2 = new Rectangle(32,0,32,32);
Console.WriteLine("Intersection : " + rect1.Intersects(rect2));""",
        "touching",
        "touching",
    ),
    Report(
        "FNA-XNA/FNA#748",
        "C# constructors",
        """var r1 = new Rectangle(0, 831, 1990, 514);
var r2 = new Rectangle(476, 831, 1497, 2520);
var r = Rectangle.Intersect(r1, r2);""",
        "overlapping",
        "clear",
    ),
    Report(
        "PixelVision8/PixelVision8#299",
        "Lua",
        """a = NewRect(8, 0, 8, 16)
b = NewRect(9, 9, 8, 16)
print(a:Contains(b))""",
        "overlapping",
        "clear",
    ),
    Report(
        "pygame/pygame#215",
        "Python session",
        """>>> r1 = Rect((0.1,0),(10,10))
>>> r2 = Rect((10,0),(10,10))
>>> r1.colliderect(r2)
0""",
        "overlapping",
        "whole-numbers",
        as_="corner-size",
    ),
    Report(
        "pygame/pygame#1198",
        "Python",
        """sized_rect = pygame.Rect(0, 0, 10, 10)
neg_rect = pygame.Rect(1, 1, -1, -1)""",
        "overlapping",
        "negative-size",
    ),
    Report(
        "pygame/pygame#2246",
        "Python",
        """r1 = pygame.Rect(50, 0, 0, 50)
r2 = pygame.Rect(0, 25, 50, 0)""",
        None,
        "zero-area",
        kinds="refused refused",
    ),
    Report(
        "opencv/opencv#23546",
        "Python tuples",
        """res, points = cv.rotatedRectangleIntersection(
    ((824.6421183672817, 280.28737007069833), (565.0, 140.0), -177.80506896972656),
    ((567.3310438828003, 270.42527355719545), (275.0, 50.0), 92.19493103027344),
)""",
        "overlapping",
        "clear",
    ),
    Report(
        "opencv/opencv#18520",
        "Python tuples",
        """r1 = ((2, 2), (0, 0), 0)
r2 = ((50, 50) , (4, 4), 0)
res =  cv2.rotatedRectangleIntersection(r1, r2)""",
        None,
        "zero-area",
        kinds="refused polygon",
    ),
    Report(
        "opencv/opencv#5909",
        "Python tuples",
        """r1 = ((122.5, 239.5), (5, 5), 0)
r2 = ((122, 239) , (4, 4), 0)""",
        "overlapping",
        "containment",
    ),
    Report(
        "DetectionTeamUCAS/RRPN_Faster-RCNN_Tensorflow#2",
        "Python lists",
        "boxes1 = [ [200,200,100,100, -45]]; boxes2 = [[150,150,100,100, -45]]",
        "overlapping",
        "clear",
    ),
    Report(
        "shapely/shapely#289",
        "Python session",
        """>>> p1 = Polygon(((0, 0), (1,0), (1,-1), (0,0)))
>>> p3 = Polygon(((0.5, -0.5), (0.5, 0.5), (1,1), (1,-1)))
>>> p1.intersects(p3)
True""",
        "overlapping",
        "clear",
    ),
    Report(
        "shapely/shapely#1341",
        "WKT",
        """wkt1 = 'POLYGON ((120.190141394875 28.9034429291254,120.190135552365 28.9034518317502 ,120.190135552365 28.9034518317502 ,
120.190141394875 28.9034429291254 ,120.190141394875 28.9034429291254 ))'
wkt3 = 'POLYGON ((120.1684570312500000 28.8940429687500000, 120.1684570312500000 28.9160156250000000,
120.1904296875000000 28.9160156250000000, 120.1904296875000000 28.8940429687500000, 120.1684570312500000 28.8940429687500000))'""",
        None,
        "zero-area",
        kinds="refused polygon",
    ),
    Report(
        "bjornharrtell/jsts#446",
        "WKT in JavaScript",
        """var jstsPoly1 = reader.read('POLYGON((106.57322276 29.57264283, 106.57165706 29.56381264, 106.5678092 29.55092201,
106.55788218 29.54906528, 106.55742723 29.55457311, 106.55433217 29.55804952, 106.54840393 29.56658392,
106.54690398 29.56642771, 106.54852212 29.56999239, 106.55107361 29.57285701, 106.56458456 29.5744905,
106.57322276 29.57264283))')
var jstsPoly2= reader.read('POLYGON((106.57108465 29.56290442, 106.558 29.5637, 106.55790005 29.55760945,
106.56319913 29.55733367, 106.56881362 29.55661661, 106.57108465 29.56290442))')""",
        "overlapping",
        "containment",
    ),
    Report(
        "bjornharrtell/jsts#175",
        "WKT in JavaScript",
        """var geo1 = wktReader.read('POLYGON ((0 7,3 7,3 10,0 10,0 7))');
var geo2 = wktReader.read('POLYGON ((0 0,10 0,10 10,0 0))');
console.log('geo1.intersects(geo2):', geo1.intersects(geo2));""",
        "apart",
        "clear",
    ),
    Report(
        "locationtech/jts#119",
        "WKT",
        """`POLYGON ((3.166572116932842 48.5390194687463, 3.166572116932842 50.470470727186765, 4.180930086918854 50.470470727186765,
4.180930086918854 48.5390194687463, 3.166572116932842 48.5390194687463))`
`POLYGON ((2.152214146946829 50.470470727186765, 18.381941666723034 19.567250592139274, 2.390837642830135 49.228045261718165,
2.152214146946829 50.470470727186765))`""",
        "apart",
        "near-touch",
    ),
    Report(
        "open-mmlab/mmdetection#1745",
        "WKT",
        "POLYGON ((331 31, 495 35, 158 24, 670 9, 331 31)) POLYGON ((497 44, 497 16, 629 16, 629 44, 497 44))",
        None,
        "crossing-outline",
        kinds="refused polygon",
    ),
    Report(
        "boostorg/geometry#837",
        "WKT in C++",
        """boost::geometry::read_wkt("MULTIPOLYGON(((1992 3240,1992 1440,3792 1800,3792 3240,1992 3240)))", polygonA);
boost::geometry::read_wkt("MULTIPOLYGON(((1941 2066,2055 2066,2055 2166,1941 2166,1941 2066)))", polygonB);
bool const bPolyPoly = boost::geometry::intersects(polygonA, polygonB);""",
        "overlapping",
        "clear",
    ),
    Report(
        "boostorg/geometry#791",
        "WKT in C++",
        """boost::geometry::read_wkt("POLYGON ((112.5323 35.6394, 111.7749 31.7842, 115.6311 31.3255, 116.8506 34.8228,112.5323 35.6394))", poly);
boost::geometry::read_wkt("POLYGON ((115.07 35.16,115.071 35.16,115.071 35.161,115.07 35.161,115.07 35.16))", box);""",
        "apart",
        "clear",
    ),
    Report(
        "boostorg/geometry#566",
        "WKT in C++",
        """boost::geometry::read_wkt("POLYGON((16.8739 0.353458,0 0,0.266003 -12.6988,17.1399 -12.3454,16.8739 0.353458))", first);
boost::geometry::read_wkt("POLYGON((0 0,9.99781 0.209424,10.1459 -6.86009,0.148086 -7.06952,0 0))", second);""",
        "overlapping",
        "containment",
    ),
    Report(
        "boostorg/geometry#1439",
        "C++ constructors",
        """BgPolygon p1 = createPolygon({
    BgPoint(-2.47089026, -86.03059246),
    BgPoint(-1.161944873, 146.3030596),
    BgPoint(3.40221214, 145.8628015),
    BgPoint(3.024695769, 141.949088),
    BgPoint(2.420586453, 111.9554564),
    BgPoint(1.208013978, -86.04069936),
    BgPoint(-2.47089026, -86.03059246)
});
BgPolygon p2 = createPolygon({
    BgPoint(-6.213278056, -88.01851748),
    BgPoint(-6.207382255, -86.51852906),
    BgPoint(-6.20539951, -86.01408604),
    BgPoint(-2.470873099, -86.02434575),
    BgPoint(-2.472221358, -86.53315586),
    BgPoint(-2.476196085, -88.03315059),
    BgPoint(-6.213278056, -88.01851748)
});""",
        "overlapping",
        "near-touch",
    ),
    Report(
        "Turfjs/turf#1333",
        "GeoJSON in JavaScript",
        """const polygon = JSON.parse('{"type":"Feature","properties":{},"geometry":{"type":"Polygon","coordinates":[[
[6.26950853,50.72473626],[6.26953794,50.72468996],[6.2695546,50.7246512],[6.26949169,50.72468741],[6.26948194,50.72469389],
[6.26946154,50.72470787],[6.26949172,50.72474162],[6.26950853,50.72473626]]]}}');
const bbox = JSON.parse('{"type":"Feature","properties":{},"geometry":{"type":"Polygon","coordinates":[[
[6.511887823915231,50.950514414615334],[6.512896634823051,50.53594214902105],[5.98503728350704,50.53594214902105],
[5.98604609441486,50.950514414615334],[6.511887823915231,50.950514414615334]]]}}');""",
        "overlapping",
        "containment",
    ),
    Report(
        "Turfjs/turf#1216",
        "GeoJSON",
        """{
  "type": "FeatureCollection",
  "features": [{
  "type": "Feature",
  "properties": {},
  "geometry": {
    "type": "Polygon",
    "coordinates": [[[6.638240782825051, 46.513552354874435], [6.638240782825051, 46.52452567471025],
      [6.632039186485088, 46.52452567471025], [6.632039186485088, 46.513552354874435],
      [6.638240782825051, 46.513552354874435]]]
  },
  "bbox": [6.632039186485088, 46.513552354874435, 6.638240782825051, 46.52452567471025]
},
{
  "type": "Feature",
  "properties": {},
  "geometry": {
    "type": "Polygon",
    "coordinates": [[[6.645459572232596, 46.51709747623775], [6.645459572232596, 46.52102619404951],
      [6.626132904233913, 46.52102619404951], [6.626132904233913, 46.51709747623775],
      [6.645459572232596, 46.51709747623775]]]
  }
}]}""",
        "overlapping",
        "clear",
    ),
    Report(
        "davisdude/mlib#7",
        "Lua",
        """shape1 = {0, 0, 96, 0, 96, 96, 0, 96}
shape3 = {128, 0, 224, 0, 224, 96, 128, 96}""",
        "apart",
        "clear",
    ),
    Report(
        "liabru/matter-js#1049 (with a box it should meet)",
        "JavaScript constructors",
        """var customShape = Bodies.fromVertices(
    0, 0, [
        Vector.create(0, 0),
        Vector.create(80, 0),
        // Duplicate point: Remove this and it works
        Vector.create(80, 80),
        Vector.create(80, 80),
        // Vector.create(0, 80),
    ],
);
var box = Bodies.rectangle(0, 20, 40, 40);""",
        "overlapping",
        "repeated-corner",
    ),
    Report(
        "erincatto/box2d#296 (with the box of its neighbour)",
        "C++ setters",
        """b2Vec2 vertices[5];
vertices[0].Set( -1.70082211,  -1.43221712 );
vertices[1].Set(  0.5,         -0.5 );
vertices[2].Set(  0.104992867,  0.97400856 );
vertices[3].Set( -0.658002853,  0.926608086 );
vertices[4].Set( -0.994554818,  0.165337861 );
b2Vec2 corner[3];
corner[0].Set(0.5, -0.5);
corner[1].Set(2, -0.5);
corner[2].Set(2, 1);""",
        "touching",
        "touching",
    ),
)
