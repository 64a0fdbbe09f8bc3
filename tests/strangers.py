"""Texts as users write them who never read the reader's code: code around the shapes, prints, tests, prose.

`bounds`: the bounding box of each shape, worked out by hand.  `asks`: a question is right, and `as_` answers it; every
other text must be answered at once.  A text without `bounds` is refused in words.
"""

from pastes import Paste

TEXTS = (
    Paste(
        "corners in a sentence",
        """The first has corners (0, 0), (10, 0), (10, 10), and (0, 10).
The second has corners (10, 5), (20, 5) and (20, 15).
They should touch.""",
        ((0, 0, 10, 10), (10, 5, 20, 15)),
    ),
    Paste(
        "a test that is negated",
        "if (!overlaps(new Rectangle(0, 0, 4, 4), new Circle(6, 6, 1))) return;",
        ((0, 0, 4, 4), (5, 5, 7, 7)),
    ),
    Paste(
        "martinez#6 js",
        """I have a case where the intersection gives incorrect results.

The polygons used:
`var p0_x = [
   [
    [0,0],
    [0,1],
    [1,1],
    [1,0],
    [0,0]
  ]
];`
`var p1_x = [
  [
    [0, 0.5],
    [0, 1.5],
    [1, 1.5],
    [1, 0.5],
    [0, 0.5]
  ]
];`

const result = martinez.intersection(p0_x, p1_x);
console.log(result);""",
        ((0, 0, 1, 1), (0, 0.5, 1, 1.5)),
    ),
    Paste(
        "boost#1439 c++",
        """typedef boost::geometry::model::d2::point_xy<double> BgPoint;
typedef boost::geometry::model::polygon<BgPoint> BgPolygon;

BgPolygon p1 = createPolygon({
    BgPoint(-2.4708, -86.0305),
    BgPoint(-1.1619, 146.3030),
    BgPoint(3.4022, 145.8628),
    BgPoint(1.2080, -86.0406),
    BgPoint(-2.4708, -86.0305)
});

BgPolygon p2 = createPolygon({
    BgPoint(-6.2132, -88.0185),
    BgPoint(-6.2053, -86.0140),
    BgPoint(-2.4708, -86.0243),
    BgPoint(-2.4761, -88.0331),
    BgPoint(-6.2132, -88.0185)
});

std::vector<BgPolygon> out;
boost::geometry::intersection(p1, p2, out);
double area = out.empty() ? 0.0 : boost::geometry::area(out[0]);
std::cout << "area = " << area << std::endl;""",
        ((-2.4708, -86.0406, 3.4022, 146.303), (-6.2132, -88.0331, -2.4708, -86.014)),
    ),
    Paste(
        "boost wkt",
        """using point = boost::geometry::model::d2::point_xy<double>;
using polygon = boost::geometry::model::polygon<point>;
polygon green, blue;
boost::geometry::read_wkt("POLYGON((2 1.3,2.4 1.7,2.8 1.8,3.4 1.2,3.7 1.6,3.4 2,4.1 3,2 1.3))", green);
boost::geometry::read_wkt("POLYGON((4.0 -0.5 , 3.5 1.0 , 2.0 1.5 , 4.0 -0.5))", blue);
std::deque<polygon> output;
boost::geometry::intersection(green, blue, output);
int i = 0;
BOOST_FOREACH(polygon const& p, output)
{
    std::cout << i++ << ": " << boost::geometry::area(p) << std::endl;
}""",
        ((2, 1.2, 4.1, 3), (2, -0.5, 4, 1.5)),
    ),
    Paste(
        "geos rust test",
        """```rust
#[test]
fn test_touches() -> Result<(), Box<dyn Error>> {
    const WKT1: &str = "POLYGON ((0 -90, 0 0, 180 0, 180 -90, 0 -90))";
    const WKT2: &str = "POLYGON ((-180 -90, -180 90, 180 90, 180 -90, -180 -90))";

    let g1 = Geometry::new_from_wkt(WKT1)?;
    let g2 = Geometry::new_from_wkt(WKT2)?;

    assert!(g1.touches(&g2)?);

    Ok(())
}
```""",
        ((0, -90, 180, 0), (-180, -90, 180, 90)),
    ),
    Paste(
        "geo rust Coord",
        """use geo::{BooleanOps, Polygon, LineString, Coord};

fn main() {
   let poly1 = Polygon::new(
        LineString::new(vec![
            Coord {
                x: -10339459.5,
                y: 3672178.75,
            },
            Coord {
                x: -10172502.5,
                y: 3169028.5,
            },
            Coord {
                x: -10002503.5,
                y: 3498113.25,
            },
        ]),
        vec![],
    );
    let poly2 = Polygon::new(
        LineString::new(vec![
            Coord {
                x: -10644125.0,
                y: 3510000.0,
            },
            Coord {
                x: -10010375.25,
                y: 3502179.5,
            },
            Coord {
                x: -10320063.5,
                y: 3765929.75,
            }
        ]),
        vec![],
    );
    poly2.union(&poly1);
}""",
        ((-10339459.5, 3169028.5, -10002503.5, 3672178.75), (-10644125, 3502179.5, -10010375.25, 3765929.75)),
    ),
    Paste(
        "geo rust debug print",
        """thread 'main' panicked at 'assertion failed'
a = Polygon { exterior: LineString([Coord { x: 0.0, y: 0.0 }, Coord { x: 2.0, y: 0.0 }, Coord { x: 2.0, y: 2.0 }, Coord { x: 0.0, y: 0.0 }]), interiors: [] }
b = Polygon { exterior: LineString([Coord { x: 3.0, y: 0.0 }, Coord { x: 5.0, y: 0.0 }, Coord { x: 5.0, y: 2.0 }, Coord { x: 3.0, y: 0.0 }]), interiors: [] }
note: run with `RUST_BACKTRACE=1` environment variable to display a backtrace""",
        ((0, 0, 2, 2), (3, 0, 5, 2)),
    ),
    Paste(
        "parry aabb test",
        """#[test]
fn test_contact_example() {
    let contact = query::contact(
        &Isometry::translation(1.0, 1.0),
        &Ball::new(1.0),
        &Isometry::identity(),
        &Cuboid::new(Vector2::new(1.0, 1.0)),
        1.0,
    )
    .unwrap()
    .unwrap();

    assert!(contact.dist < 0.0);
}""",
        ((0, 0, 2, 2), (-1, -1, 1, 1)),
    ),
    Paste(
        "parry aabb mins",
        """let a = Aabb {
    mins: Vector::new(40.0, -50.0),
    maxs: Vector::new(60.0, 150.0),
};
let b = Aabb {
    mins: Vector::new(60.0, 0.0),
    maxs: Vector::new(70.0, 10.0),
};
assert!(!a.intersects(&b)); // fails""",
        ((40, -50, 60, 150), (60, 0, 70, 10)),
    ),
    Paste(
        "c2 circle",
        """c2Circle circle = {0};
circle.p = c2V(10.0f, 5.0f);
circle.r = 5.0f;
c2AABB box;
box.min = c2V(14, 0);
box.max = c2V(20, 10);
if (c2CircletoAABB(circle, box)) { puts("hit"); }""",
        ((5, 0, 15, 10), (14, 0, 20, 10)),
    ),
    Paste(
        "box2d v2",
        """b2PolygonShape polyA;
b2Vec2 vertsA[4];
vertsA[0].Set(-1.0f, -1.0f);
vertsA[1].Set( 1.0f, -1.0f);
vertsA[2].Set( 1.0f,  1.0f);
vertsA[3].Set(-1.0f,  1.0f);
polyA.Set(vertsA, 4);

b2PolygonShape polyB;
b2Vec2 vertsB[3];
vertsB[0].Set(0.5f, 0.0f);
vertsB[1].Set(2.0f, 0.0f);
vertsB[2].Set(2.0f, 1.0f);
polyB.Set(vertsB, 3);

b2Transform identity;
identity.SetIdentity();
b2Manifold manifold;
b2CollidePolygons(&manifold, &polyA, identity, &polyB, identity);""",
        ((-1, -1, 1, 1), (0.5, 0, 2, 1)),
    ),
    Paste(
        "box2d v3",
        """b2Polygon boxA = b2MakeBox(1.0f, 0.5f);
b2Transform xfA = {{0.0f, 0.0f}, b2Rot_identity};
b2Circle circleB = {{1.5f, 0.0f}, 0.5f};
b2Manifold m = b2CollidePolygonAndCircle(&boxA, xfA, &circleB, xfA);
ENSURE(m.pointCount == 1);""",
        ((-1, -0.5, 1, 0.5), (1, -0.5, 2, 0.5)),
    ),
    Paste(
        "box2d-py log",
        """bodyA fixture vertices: [(-10, -1), (10, -1), (10, 1), (-10, 1)]
bodyB fixture vertices: [(9.5, 0.5), (12, 0.5), (12, 3)]
contact.touching = False""",
        ((-10, -1, 10, 1), (9.5, 0.5, 12, 3)),
    ),
    Paste(
        "godot polygon print",
        """# Godot 4.2
extends Node2D
func _ready():
    var a = PackedVector2Array([Vector2(0, 0), Vector2(64, 0), Vector2(64, 64), Vector2(0, 64)])
    var b = PackedVector2Array([Vector2(64, 10), Vector2(128, 10), Vector2(128, 40)])
    print(Geometry2D.intersect_polygons(a, b))""",
        ((0, 0, 64, 64), (64, 10, 128, 40)),
    ),
    Paste(
        "godot console",
        """polygon A: [(0, 0), (64, 0), (64, 64), (0, 64)]
polygon B: [(32.5, 10), (128, 10), (128, 40)]
overlaps: true  frame 120""",
        ((0, 0, 64, 64), (32.5, 10, 128, 40)),
    ),
    Paste(
        "godot rect2 print",
        """var a := Rect2(Vector2(10, 10), Vector2(20, 20))
var b := Rect2(Vector2(30, 10), Vector2(5, 5))
print(a.intersects(b))        # false
print(a.intersects(b, true))  # true""",
        ((10, 10, 30, 30), (30, 10, 35, 15)),
    ),
    Paste(
        "godot rect2 log",
        """player: [P: (10, 10), S: (20, 20)]
wall:   [P: (30, 10), S: (5, 5)]""",
        ((10, 10, 30, 30), (30, 10, 35, 15)),
    ),
    Paste(
        "godot tscn",
        """[sub_resource type="CircleShape2D" id="CircleShape2D_abc"]
radius = 16.0

[node name="Player" type="Area2D" parent="."]
position = Vector2(100, 50)

[node name="CollisionShape2D" type="CollisionShape2D" parent="Player"]
shape = SubResource("CircleShape2D_abc")

[node name="Wall" type="CollisionPolygon2D" parent="."]
polygon = PackedVector2Array(110, 40, 150, 40, 150, 80, 110, 80)""",
        ((84, 34, 116, 66), (110, 40, 150, 80)),
    ),
    Paste(
        "unity bounds log",
        """playerCollider.bounds: Center: (1.00, 2.00, 0.00), Extents: (0.50, 0.50, 0.00)
wallCollider.bounds: Center: (2.00, 2.00, 0.00), Extents: (0.50, 1.50, 0.00)
UnityEngine.Debug:Log (object)""",
        ((0.5, 1.5, 1.5, 2.5), (1.5, 0.5, 2.5, 3.5)),
    ),
    Paste(
        "unity poly",
        """public class Test : MonoBehaviour
{
    void Start()
    {
        Vector2[] polyA = new Vector2[] { new Vector2(0f, 0f), new Vector2(1f, 0f), new Vector2(1f, 1f), new Vector2(0f, 1f) };
        Vector2[] polyB = { new Vector2(1.5f, 0f), new Vector2(2.5f, 0f), new Vector2(2.5f, 1f) };
        Debug.Log(SatTest.Overlaps(polyA, polyB)); // prints True??
    }
}""",
        ((0, 0, 1, 1), (1.5, 0, 2.5, 1)),
    ),
    Paste(
        "unity rect print",
        """rectA = (x:0.00, y:0.00, width:100.00, height:50.00)
rectB = (x:100.00, y:0.00, width:20.00, height:20.00)
rectA.Overlaps(rectB) = False""",
        ((0, 0, 100, 50), (100, 0, 120, 20)),
    ),
    Paste(
        "three box2",
        """const a = new THREE.Box2(new THREE.Vector2(0, 0), new THREE.Vector2(4, 4));
const b = new THREE.Box2(new THREE.Vector2(4, 1), new THREE.Vector2(8, 3));
console.log(a.intersectsBox(b)); // true""",
        ((0, 0, 4, 4), (4, 1, 8, 3)),
    ),
    Paste(
        "three shape",
        """const shape = new THREE.Shape();
shape.moveTo( 0, 0 );
shape.lineTo( 10, 0 );
shape.lineTo( 10, 10 );
shape.lineTo( 0, 10 );
shape.closePath();

const other = new THREE.Shape();
other.moveTo( 5, 5 );
other.lineTo( 15, 5 );
other.lineTo( 15, 15 );
other.closePath();""",
        ((0, 0, 10, 10), (5, 5, 15, 15)),
    ),
    Paste(
        "three box2 json log",
        """Box2 {isBox2: true, min: Vector2 {x: -1, y: -1}, max: Vector2 {x: 1, y: 1}}
Box2 {isBox2: true, min: Vector2 {x: 2, y: -1}, max: Vector2 {x: 3, y: 1}}""",
        ((-1, -1, 1, 1), (2, -1, 3, 1)),
    ),
    Paste(
        "p5 collide2d",
        """let poly = [];
function setup() {
  createCanvas(windowWidth, windowHeight);
  poly[0] = createVector(123, 231);
  poly[1] = createVector(10, 111);
  poly[2] = createVector(20, 23);
  poly[3] = createVector(390, 33);
}
function draw() {
  background(255);
  let hit = collideCirclePoly(45, 100, 30, poly);
  print(hit);
}""",
        ((10, 23, 390, 231), (30, 85, 60, 115)),
    ),
    Paste(
        "p5 rects",
        """function setup() {
  createCanvas(400, 400);
}
function draw() {
  background(220);
  rect(50, 50, 100, 80);
  rect(140, 120, 60, 60);
}""",
        ((50, 50, 150, 130), (140, 120, 200, 180)),
    ),
    Paste(
        "processing",
        """int cx = 0;
void setup() {
  size(600, 400);
  noStroke();
}
void draw() {
  fill(0, 150);
  ellipse(200, 100, 60, 60);
  fill(200, 100, 0);
  rect(215, 100, 40, 40);
}""",
        ((170, 70, 230, 130), (215, 100, 255, 140)),
        as_="corner-size diameter leave-out",
        asks=True,
    ),
    Paste(
        "svg file",
        """<?xml version="1.0" encoding="UTF-8"?>
<svg xmlns="http://www.w3.org/2000/svg" width="200" height="200" viewBox="0 0 200 200">
  <g id="layer1" fill="none" stroke="#000">
    <polygon points="10,10 60,10 60,60 10,60" class="a"/>
    <polygon points="50,50 90,50 90,90" class="b" style="stroke-width:2"/>
  </g>
</svg>""",
        ((10, 10, 60, 60), (50, 50, 90, 90)),
    ),
    Paste(
        "svg path rel",
        """<svg height="210" width="400">
  <path d="M150 0 L75 200 L225 200 Z" style="fill:none;stroke:green;stroke-width:3" />
  <circle r="45" cx="50" cy="50" fill="red" />
  Sorry, your browser does not support inline SVG.
</svg>""",
        ((75, 0, 225, 200), (5, 5, 95, 95)),
    ),
    Paste(
        "geojson features",
        """{
  "type": "FeatureCollection",
  "name": "test",
  "crs": { "type": "name", "properties": { "name": "urn:ogc:def:crs:OGC:1.3:CRS84" } },
  "features": [
    { "type": "Feature", "id": 1, "properties": { "name": "A", "pop": 12000 }, "geometry": { "type": "Polygon", "coordinates": [ [ [ 24.6038, 59.3136 ], [ 24.8393, 59.3136 ], [ 24.8393, 59.4772 ], [ 24.6038, 59.4772 ], [ 24.6038, 59.3136 ] ] ] } },
    { "type": "Feature", "id": 2, "properties": { "name": "B", "pop": 3 }, "geometry": { "type": "Polygon", "coordinates": [ [ [ 24.5673, 8.2291 ], [ 23.8058, 8.6663 ], [ 23.4590, 8.9542 ], [ 24.5673, 8.2291 ] ] ] } }
  ]
}""",
        ((24.6038, 59.3136, 24.8393, 59.4772), (23.459, 8.2291, 24.5673, 8.9542)),
    ),
    Paste(
        "turf",
        """const poly1 = turf.polygon([[
  [-122.801742, 45.48565],
  [-122.801742, 45.60491],
  [-122.584762, 45.60491],
  [-122.584762, 45.48565],
  [-122.801742, 45.48565]
]]);
const poly2 = turf.polygon([[
  [-122.520217, 45.535693],
  [-122.64038, 45.553967],
  [-122.720031, 45.526554],
  [-122.520217, 45.535693]
]]);
console.log(turf.booleanOverlap(poly1, poly2), turf.intersect(turf.featureCollection([poly1, poly2])));""",
        ((-122.801742, 45.48565, -122.584762, 45.60491), (-122.720031, 45.526554, -122.520217, 45.553967)),
    ),
    Paste(
        "shapely session",
        """In [5]: from shapely.geometry import Polygon

In [6]: p1 = Polygon([(-97.8835, 42.2624), (-97.8835, 42.2610), (-97.8811, 42.2598), (-97.8835, 42.2624)])

In [7]: p2 = Polygon([(-97.8811, 42.2598), (-97.8700, 42.2598), (-97.8700, 42.2700)])

In [8]: p1.overlaps(p2)
Out[8]: True

In [9]: p1.relate(p2)
Out[9]: '212101212'""",
        ((-97.8835, 42.2598, -97.8811, 42.2624), (-97.8811, 42.2598, -97.87, 42.27)),
    ),
    Paste(
        "shapely wkt vars",
        """wkt2 = 'POLYGON ((120.1729 28.8911, 120.1730 28.9131, 120.1949 28.9131, 120.1949 28.8911, 120.1729 28.8911))'
wkt3 = 'POLYGON ((120.1684 28.8940, 120.1684 28.9160, 120.1904 28.9160, 120.1904 28.8940, 120.1684 28.8940))'
from shapely import wkt
a = wkt.loads(wkt2)
b = wkt.loads(wkt3)
print(a.intersects(b), a.intersection(b).area)""",
        ((120.1729, 28.8911, 120.1949, 28.9131), (120.1684, 28.894, 120.1904, 28.916)),
    ),
    Paste(
        "numpy print labelled",
        """>>> print(verts_a)
[[ 0.    0.  ]
 [ 1.5   0.25]
 [ 0.75  2.  ]]
>>> print(verts_b)
[[ 1.    1.  ]
 [ 3.    1.  ]
 [ 3.    4.25]]
>>> sat(verts_a, verts_b)
True""",
        ((0, 0, 1.5, 2), (1, 1, 3, 4.25)),
    ),
    Paste(
        "numpy repr",
        """a
array([[0.   , 0.   ],
       [1.   , 0.   ],
       [1.   , 1.   ],
       [0.   , 1.   ]], dtype=float32)
b
array([[2.5, 0. ],
       [3.5, 0. ],
       [3.5, 1. ]], dtype=float32)""",
        ((0, 0, 1, 1), (2.5, 0, 3.5, 1)),
    ),
    Paste(
        "pymunk",
        """import pymunk
space = pymunk.Space()
space.gravity = 0, -981

body = pymunk.Body(10, 100)
body.position = (50, 100)
poly = pymunk.Poly.create_box(body, (20, 20))
space.add(body, poly)

ball_body = pymunk.Body(1, 1)
ball_body.position = (70, 100)
ball = pymunk.Circle(ball_body, 10)
ball.elasticity = 0.95
space.add(ball_body, ball)
for _ in range(10):
    space.step(1 / 60.0)
print(poly.shapes_collide(ball))""",
        ((40, 90, 60, 110), (60, 90, 80, 110)),
    ),
    Paste(
        "pymunk poly",
        """b0 = space.static_body
p1 = pymunk.Poly(b0, [(0, 0), (10, 0), (10, 10), (0, 10)])
p2 = pymunk.Poly(b0, [(10, 0), (20, 0), (20, 10)])
p1.friction = 0.7
contacts = p1.shapes_collide(p2)
assert len(contacts.points) == 0, contacts""",
        ((0, 0, 10, 10), (10, 0, 20, 10)),
    ),
    Paste(
        "pygame",
        """import pygame
pygame.init()
screen = pygame.display.set_mode((640, 480))
player = pygame.Rect(100, 100, 50, 50)
enemy = pygame.Rect(150, 100, 50, 50)
print(player.colliderect(enemy))""",
        ((100, 100, 150, 150), (150, 100, 200, 150)),
    ),
    Paste(
        "pygame print",
        """player <rect(100, 100, 50, 50)>
enemy <rect(149, 100, 50, 50)>
colliderect -> 1""",
        ((100, 100, 150, 150), (149, 100, 199, 150)),
    ),
    Paste(
        "java awt",
        """Polygon p = new Polygon();
p.addPoint(0, 0);
p.addPoint(10, 0);
p.addPoint(10, 10);
Rectangle r = new Rectangle(9, 0, 5, 5);
Area a = new Area(p);
a.intersect(new Area(r));
System.out.println(a.isEmpty());""",
        ((0, 0, 10, 10), (9, 0, 14, 5)),
    ),
    Paste(
        "jts",
        """GeometryFactory gf = new GeometryFactory();
Coordinate[] c1 = new Coordinate[] {
    new Coordinate(0, 0), new Coordinate(10, 0), new Coordinate(10, 10), new Coordinate(0, 10), new Coordinate(0, 0) };
Coordinate[] c2 = new Coordinate[] {
    new Coordinate(10, 10), new Coordinate(20, 10), new Coordinate(20, 20), new Coordinate(10, 10) };
Polygon a = gf.createPolygon(c1);
Polygon b = gf.createPolygon(c2);
assertTrue(a.touches(b));""",
        ((0, 0, 10, 10), (10, 10, 20, 20)),
    ),
    Paste(
        "jts prep",
        """WKTReader reader = new WKTReader(new GeometryFactory(new PrecisionModel(1000)));
Geometry g1 = reader.read("POLYGON ((0 0, 0 100, 100 100, 100 0, 0 0))");
Geometry g2 = reader.read("POLYGON ((100 50, 200 50, 200 70, 100 50))");
System.out.println("touches: " + g1.touches(g2));
System.out.println("DE-9IM: " + g1.relate(g2));""",
        ((0, 0, 100, 100), (100, 50, 200, 70)),
    ),
    Paste(
        "libgdx",
        """Rectangle r1 = new Rectangle(0f, 0f, 32f, 32f);
Circle c1 = new Circle(48f, 16f, 16f);
boolean hit = Intersector.overlaps(c1, r1);
Gdx.app.log("TEST", "hit = " + hit);""",
        ((0, 0, 32, 32), (32, 0, 64, 32)),
    ),
    Paste(
        "libgdx toString",
        """[0.0,0.0,32.0,32.0]
[31.5,10.0,16.0,16.0]
overlaps=true""",
        ((0, 0, 32, 32), (31.5, 10, 47.5, 26)),
        as_="corner-size",
        asks=True,
    ),
    Paste(
        "love2d lua",
        """-- main.lua
function love.load()
    world = love.physics.newWorld(0, 9.81 * 64, true)
    a = {x = 100, y = 100, w = 50, h = 40}
    b = {x = 150, y = 120, w = 30, h = 30}
end

function checkCollision(a, b)
    return a.x < b.x + b.w and b.x < a.x + a.w and a.y < b.y + b.h and b.y < a.y + a.h
end

print(checkCollision(a, b))""",
        ((100, 100, 150, 140), (150, 120, 180, 150)),
        as_="corner-size leave-out",
        asks=True,
    ),
    Paste(
        "lua HC",
        """local HC = require 'HC'
local rect = HC.rectangle(200, 400, 400, 20)
local ball = HC.circle(400, 390, 10)
for shape, delta in pairs(HC.collisions(ball)) do
    print(delta.x, delta.y)
end""",
        ((200, 400, 600, 420), (390, 380, 410, 400)),
    ),
    Paste(
        "lua polygon",
        """local polyA = { 0,0, 50,0, 50,50, 0,50 }
local polyB = { 25,25, 75,25, 75,75 }
print("SAT:", sat(polyA, polyB))  --> SAT: false""",
        ((0, 0, 50, 50), (25, 25, 75, 75)),
    ),
    Paste(
        "c struct",
        """#include <stdio.h>
#include "sat.h"

typedef struct { float x, y; } vec2;

int main(void) {
    vec2 a[] = {{0.0f, 0.0f}, {2.0f, 0.0f}, {2.0f, 2.0f}, {0.0f, 2.0f}};
    vec2 b[] = {{1.0f, 1.0f}, {3.0f, 1.0f}, {3.0f, 3.0f}, {1.0f, 3.0f}};
    int n = sizeof(a) / sizeof(a[0]);
    printf("%d\\n", sat_overlap(a, n, b, n));
    return 0;
}""",
        ((0, 0, 2, 2), (1, 1, 3, 3)),
    ),
    Paste(
        "c printf log",
        """poly A (4 verts):
  0: (0.000000, 0.000000)
  1: (2.000000, 0.000000)
  2: (2.000000, 2.000000)
  3: (0.000000, 2.000000)
poly B (3 verts):
  0: (1.000000, 1.000000)
  1: (3.000000, 1.000000)
  2: (3.000000, 3.000000)
overlap = 1""",
        ((0, 0, 2, 2), (1, 1, 3, 3)),
    ),
    Paste(
        "raylib",
        """Rectangle boxA = { 10, GetScreenHeight()/2.0f - 50, 200, 100 };
Rectangle boxB = { 190, 200, 60, 60 };
bool collision = CheckCollisionRecs(boxA, boxB);""",
        ((190, 200, 250, 260),),
        as_="leave-out",
        asks=True,
    ),
    Paste(
        "raylib ok",
        """Rectangle boxA = { 10.0f, 175.0f, 200.0f, 100.0f };
Rectangle boxB = { 190.0f, 200.0f, 60.0f, 60.0f };
bool collision = CheckCollisionRecs(boxA, boxB);
if (collision) DrawText("COLLISION!", 10, 10, 20, RED);
DrawRectangleRec(boxA, GOLD);
DrawRectangleRec(boxB, BLUE);""",
        ((10, 175, 210, 275), (190, 200, 250, 260)),
    ),
    Paste(
        "sfml",
        """sf::RectangleShape rect(sf::Vector2f(120.f, 50.f));
rect.setPosition(100.f, 100.f);
rect.setFillColor(sf::Color::Green);
sf::CircleShape circle(50.f);
circle.setPosition(220.f, 100.f);
circle.setFillColor(sf::Color(100, 250, 50));
bool hit = rect.getGlobalBounds().intersects(circle.getGlobalBounds());""",
        ((100, 100, 220, 150), (220, 100, 320, 200)),
    ),
    Paste(
        "sdl",
        """SDL_Rect a = { 0, 0, 32, 32 };
SDL_Rect b = { .x = 32, .y = 0, .w = 32, .h = 32 };
SDL_bool hit = SDL_HasIntersection(&a, &b);
SDL_Log("hit=%d", hit);""",
        ((0, 0, 32, 32), (32, 0, 64, 32)),
    ),
    Paste(
        "monogame",
        """var bounds1 = new Rectangle(0, 0, 64, 64);
var bounds2 = new Rectangle(63, 63, 64, 64);
Assert.IsTrue(bounds1.Intersects(bounds2));
// prints: {X:0 Y:0 Width:64 Height:64}""",
        ((0, 0, 64, 64), (63, 63, 127, 127)),
    ),
    Paste(
        "monogame print",
        """{X:0 Y:0 Width:64 Height:64}
{X:63 Y:63 Width:64 Height:64}""",
        ((0, 0, 64, 64), (63, 63, 127, 127)),
    ),
    Paste(
        "sat.js",
        """var V = SAT.Vector;
var P = SAT.Polygon;
var C = SAT.Circle;
var circle = new C(new V(100,100), 20);
var polygon = new P(new V(), [new V(0,0), new V(90,0), new V(90,90)]);
var response = new SAT.Response();
var collided = SAT.testPolygonCircle(polygon, circle, response);
console.log(collided, response.overlap, response.overlapV);""",
        ((80, 80, 120, 120), (0, 0, 90, 90)),
    ),
    Paste(
        "matter",
        """const Engine = Matter.Engine, Bodies = Matter.Bodies;
const engine = Engine.create();
const boxA = Bodies.rectangle(400, 200, 80, 80);
const ground = Bodies.rectangle(400, 610, 810, 60, { isStatic: true });
Composite.add(engine.world, [boxA, ground]);
console.log(Matter.Collision.collides(boxA, ground));""",
        ((360, 160, 440, 240), (-5, 580, 805, 640)),
    ),
    Paste(
        "phaser geom",
        """const r1 = new Phaser.Geom.Rectangle(100, 100, 256, 256);
const c1 = new Phaser.Geom.Circle(400, 200, 60);
if (Phaser.Geom.Intersects.CircleToRectangle(c1, r1)) {
    graphics.lineStyle(2, 0xff0000);
}""",
        ((100, 100, 356, 356), (340, 140, 460, 260)),
    ),
    Paste(
        "phaser add",
        """this.player = this.add.rectangle(100, 450, 32, 48, 0x00ff00);
this.star = this.add.circle(130, 450, 14, 0xffff00);
this.physics.add.existing(this.player);
this.physics.add.overlap(this.player, this.star, () => console.log('hit'));""",
        ((84, 426, 116, 474), (116, 436, 144, 464)),
    ),
    Paste(
        "flatten-js",
        """const {point, circle, segment, polygon, Box} = Flatten;
let c = circle(point(200, 110), 50);
let p = new Polygon([[150, 110], [250, 110], [250, 200]]);
console.log(p.intersect(c));""",
        ((150, 60, 250, 160), (150, 110, 250, 200)),
    ),
    Paste(
        "detect-collisions",
        """import { System } from "detect-collisions";
const physics = new System();
const box = physics.createBox({ x: 100, y: 100 }, 40, 20);
const poly = physics.createPolygon({ x: 120, y: 110 }, [{ x: 0, y: 0 }, { x: 30, y: 0 }, { x: 0, y: 30 }]);
const ball = physics.createCircle({ x: 300, y: 300 }, 5);
physics.checkCollision(box, poly);""",
        ((100, 100, 140, 120), (120, 110, 150, 140), (295, 295, 305, 305)),
        as_="corner-size",
        asks=True,
    ),
    Paste(
        "kotlin compose",
        """val a = Rect(left = 0f, top = 0f, right = 100f, bottom = 100f)
val b = Rect(Offset(100f, 50f), Size(20f, 20f))
println(a.overlaps(b))""",
        ((0, 0, 100, 100), (100, 50, 120, 70)),
        as_="corner-size",
        asks=True,
    ),
    Paste(
        "swift",
        """let a = CGRect(x: 0, y: 0, width: 100, height: 100)
let b = CGRect(x: 100, y: 0, width: 50, height: 50)
print(a.intersects(b)) // false
print(a.union(b).width)""",
        ((0, 0, 100, 100), (100, 0, 150, 50)),
    ),
    Paste(
        "flutter",
        """final a = Rect.fromLTWH(0, 0, 10, 10);
final b = Rect.fromLTRB(10.0, 0.0, 20.0, 10.0);
print(a.overlaps(b)); // false""",
        ((0, 0, 10, 10), (10, 0, 20, 10)),
    ),
    Paste(
        "postgis",
        """SELECT ST_Intersects(
  'POLYGON((0 0, 0 1, 1 1, 1 0, 0 0))'::geometry,
  'POLYGON((1 1, 1 2, 2 2, 2 1, 1 1))'::geometry
);
 st_intersects
---------------
 t
(1 row)""",
        ((0, 0, 1, 1), (1, 1, 2, 2)),
    ),
    Paste(
        "postgis ewkt",
        """SELECT ST_Touches(ST_GeomFromText('POLYGON((0 0,4 0,4 4,0 4,0 0))', 4326), ST_GeomFromText('POLYGON((4 0,8 0,8 4,4 4,4 0))', 4326));""",
        ((0, 0, 4, 4), (4, 0, 8, 4)),
    ),
    Paste(
        "mysql",
        """SET @g1 = ST_GeomFromText('Polygon((0 0,0 3,3 3,3 0,0 0))');
SET @g2 = ST_GeomFromText('Polygon((1 1,1 2,2 2,2 1,1 1))');
SELECT MBRContains(@g1,@g2), MBRWithin(@g2,@g1);""",
        ((0, 0, 3, 3), (1, 1, 2, 2)),
    ),
    Paste(
        "R sf",
        """library(sf)
p1 <- st_polygon(list(rbind(c(0,0), c(4,0), c(4,4), c(0,4), c(0,0))))
p2 <- st_polygon(list(rbind(c(4,0), c(8,0), c(8,4), c(4,0))))
st_intersects(p1, p2, sparse = FALSE)""",
        ((0, 0, 4, 4), (4, 0, 8, 4)),
    ),
    Paste(
        "matlab",
        """p1 = polyshape([0 0 4 4],[0 4 4 0]);
p2 = polyshape([5 5 9 9],[0 4 4 0]);
overlaps(p1, p2)""",
        ((0, 0, 4, 4), (5, 0, 9, 4)),
    ),
    Paste(
        "julia",
        """using LazySets
P = VPolygon([[0.0, 0.0], [2.0, 0.0], [1.0, 2.0]])
Q = VPolygon([[1.5, 0.5], [3.5, 0.5], [2.5, 2.5]])
isdisjoint(P, Q)""",
        ((0, 0, 2, 2), (1.5, 0.5, 3.5, 2.5)),
    ),
    Paste(
        "yolo boxes",
        """box1 = [100, 100, 200, 200]  # x1, y1, x2, y2
box2 = [150, 150, 250, 250]
iou = bbox_iou(box1, box2)
print(f"IoU: {iou:.4f}")""",
        ((100, 100, 200, 200), (150, 150, 250, 250)),
        as_="corner-corner",
    ),
    Paste(
        "opencv contour",
        """cnt1 = np.array([[[10, 10]], [[100, 10]], [[100, 100]], [[10, 100]]], dtype=np.int32)
cnt2 = np.array([[[90, 90]], [[150, 90]], [[150, 150]]], dtype=np.int32)
mask = np.zeros((200, 200), dtype=np.uint8)
cv2.drawContours(mask, [cnt1], -1, 255, -1)""",
        ((10, 10, 100, 100), (90, 90, 150, 150)),
    ),
    Paste(
        "opencv rotatedrect",
        """r1 = ((50.0, 50.0), (40.0, 20.0), 45.0)
r2 = ((80.0, 50.0), (40.0, 20.0), 0.0)
ret, pts = cv2.rotatedRectangleIntersection(r1, r2)""",
        ((28.7868, 28.7868, 71.2132, 71.2132), (60, 40, 100, 60)),
    ),
    Paste(
        "csv annotations",
        """id,label,xmin,ymin,xmax,ymax
1,car,10,20,110,80
2,person,100,30,130,120""",
        ((10, 20, 110, 80), (100, 30, 130, 120)),
    ),
    Paste(
        "console.table",
        """┌─────────┬─────┬─────┬───────┬────────┐
│ (index) │  x  │  y  │ width │ height │
├─────────┼─────┼─────┼───────┼────────┤
│    0    │  0  │  0  │  100  │   50   │
│    1    │ 100 │ 20  │  10   │   10   │
└─────────┴─────┴─────┴───────┴────────┘""",
        ((0, 0, 100, 50), (100, 20, 110, 30)),
        as_="corner-size leave-out",
        asks=True,
    ),
    Paste(
        "DOMRect",
        """DOMRect {x: 8, y: 8, width: 200, height: 100, top: 8, right: 208, bottom: 108, left: 8}
DOMRect {x: 208, y: 50, width: 20, height: 20, top: 50, right: 228, bottom: 70, left: 208}""",
        ((8, 8, 208, 108), (208, 50, 228, 70)),
    ),
    Paste(
        "qt",
        """QPolygonF a;
a << QPointF(0, 0) << QPointF(10, 0) << QPointF(10, 10) << QPointF(0, 10);
QPolygonF b;
b << QPointF(10, 0) << QPointF(20, 0) << QPointF(20, 10);
qDebug() << a.intersects(b);""",
        ((0, 0, 10, 10), (10, 0, 20, 10)),
    ),
    Paste(
        "qdebug print",
        """QPolygonF(QPointF(0,0)QPointF(10,0)QPointF(10,10)QPointF(0,10))
QPolygonF(QPointF(10,0)QPointF(20,0)QPointF(20,10))
false""",
        ((0, 0, 10, 10), (10, 0, 20, 10)),
    ),
    Paste(
        "cgal",
        """Polygon_2 P;
P.push_back (Point (-1, 1));
P.push_back (Point (0, -1));
P.push_back (Point (1, 1));
Polygon_2 Q;
Q.push_back(Point (-1, -1));
Q.push_back(Point (1, -1));
Q.push_back(Point (0, 1));
if ((CGAL::do_intersect (P, Q)))
  std::cout << "The two polygons intersect." << std::endl;
else
  std::cout << "The two polygons do not intersect." << std::endl;""",
        ((-1, -1, 1, 1), (-1, -1, 1, 1)),
    ),
    Paste(
        "go geom",
        """a := geom.NewPolygon(geom.XY).MustSetCoords([][]geom.Coord{{{0, 0}, {4, 0}, {4, 4}, {0, 0}}})
b := geom.NewPolygon(geom.XY).MustSetCoords([][]geom.Coord{{{5, 0}, {9, 0}, {9, 4}, {5, 0}}})
fmt.Println(a.Area(), b.Area())""",
        (),
    ),
    Paste(
        "go image",
        """r1 := image.Rect(0, 0, 10, 10)
r2 := image.Rect(10, 0, 20, 10)
if r1.Overlaps(r2) {
	t.Errorf("%v overlaps %v", r1, r2)
}""",
        ((0, 0, 10, 10), (10, 0, 20, 10)),
    ),
    Paste(
        "bevy",
        """let a = Aabb2d::new(Vec2::new(0.0, 0.0), Vec2::new(1.0, 1.0));
let b = BoundingCircle::new(Vec2::new(1.5, 0.0), 0.5);
assert!(a.intersects(&b));""",
        ((-1, -1, 1, 1), (1, -0.5, 2, 0.5)),
    ),
    Paste(
        "pixi",
        """const r = new PIXI.Rectangle(0, 0, 100, 100);
const c = new PIXI.Circle(110, 50, 10);
const poly = new PIXI.Polygon([0, 0, 50, 0, 50, 50]);
console.log(r.contains(100, 50));""",
        ((0, 0, 100, 100), (100, 40, 120, 60), (0, 0, 50, 50)),
    ),
    Paste(
        "planck",
        """const a = planck.Polygon([Vec2(-1, 0), Vec2(1, 0), Vec2(0, 2)]);
const b = planck.Circle(Vec2(0, 3), 1);
const output = planck.Distance(input);""",
        ((-1, 0, 1, 2), (-1, 2, 1, 4)),
    ),
    Paste(
        "yaml",
        """shapes:
  - name: floor
    type: box
    center: [0, -1]
    size: [10, 2]
  - name: ball
    type: circle
    center: [0, 0.5]
    radius: 0.5""",
        ((-5, -2, 5, 0), (-0.5, 0, 0.5, 1)),
    ),
    Paste(
        "toml",
        """[player]
x = 10
y = 20
radius = 5

[wall]
x = 15
y = 0
width = 10
height = 40""",
        ((5, 15, 15, 25), (15, 0, 25, 40)),
        as_="corner-size",
        asks=True,
    ),
    Paste(
        "clojure",
        """(def a {:x 0 :y 0 :w 10 :h 10})
(def b {:x 10 :y 0 :w 5 :h 5})
(overlap? a b) ;; => false""",
        ((0, 0, 10, 10), (10, 0, 15, 5)),
        as_="corner-size",
        asks=True,
    ),
    Paste(
        "haskell",
        """a = [V2 0 0, V2 4 0, V2 4 4]
b = [V2 4 0, V2 8 0, V2 8 4]
main = print (intersects a b)""",
        ((0, 0, 4, 4), (4, 0, 8, 4)),
    ),
    Paste(
        "stackoverflow prose",
        """I'm implementing SAT in C# and it fails for these two shapes:

Polygon 1: (0,0), (0,10), (10,10), (10,0)
Polygon 2: (5,5), (5,15), (15,15), (15,5)

It returns no collision, but clearly they overlap. What am I doing wrong?""",
        ((0, 0, 10, 10), (5, 5, 15, 15)),
    ),
    Paste(
        "so prose circles",
        """Circle A: center = (3, 4), radius = 5
Circle B: center = (14, 4), radius = 6
Expected: touching. Got: false. I use distance < r1 + r2.""",
        ((-2, -1, 8, 9), (8, -2, 20, 10)),
    ),
    Paste(
        "so aabb text",
        """The first box has its min at (0, 0) and max at (2, 2), the second has min at (2, 2) and max at (3, 5).""",
        ((0, 0, 2, 2), (2, 2, 3, 5)),
    ),
    Paste(
        "javafx",
        """Polygon poly = new Polygon(0.0, 0.0, 20.0, 10.0, 10.0, 20.0);
Circle c = new Circle(25.0, 10.0, 6.0, Color.RED);
boolean b = Shape.intersect(poly, c).getBoundsInLocal().getWidth() != -1;""",
        ((0, 0, 20, 20), (19, 4, 31, 16)),
    ),
    Paste(
        "ruby",
        """rect1 = { x: 0, y: 0, w: 16, h: 16 }
rect2 = { x: 16, y: 0, w: 16, h: 16 }
puts args.geometry.intersect_rect?(rect1, rect2)""",
        ((0, 0, 16, 16), (16, 0, 32, 16)),
        as_="corner-size",
    ),
    Paste(
        "dart flame",
        """final p1 = PolygonComponent([Vector2(0, 0), Vector2(10, 0), Vector2(10, 10)]);
final p2 = PolygonComponent([Vector2(9, 0), Vector2(19, 0), Vector2(19, 10)]);
expect(p1.containsPoint(Vector2(1, 1)), isFalse);""",
        ((0, 0, 10, 10), (9, 0, 19, 10)),
    ),
    Paste(
        "log structured",
        """2024-03-11 09:12:44.120 [physics] INFO  collide(Circle(x=12.5, y=3.0, r=2.5), Circle(x=17.5, y=3.0, r=2.5)) -> false (expected true)""",
        ((10, 0.5, 15, 5.5), (15, 0.5, 20, 5.5)),
    ),
    Paste(
        "jest fail",
        """  ● polygons that share an edge touch

    expect(received).toBe(expected) // Object.is equality

    Expected: true
    Received: false

      12 |   const a = [{ x: 0, y: 0 }, { x: 2, y: 0 }, { x: 2, y: 2 }, { x: 0, y: 2 }];
      13 |   const b = [{ x: 2, y: 0 }, { x: 4, y: 0 }, { x: 4, y: 2 }, { x: 2, y: 2 }];
    > 14 |   expect(collides(a, b)).toBe(true);
         |                          ^""",
        ((0, 0, 2, 2), (2, 0, 4, 2)),
    ),
    Paste(
        "dotnet nts",
        """var a = wktReader.Read("POLYGON((0 0, 10 0, 10 10, 0 10, 0 0))");
var b = wktReader.Read("POLYGON((10 0, 20 0, 20 10, 10 10, 10 0))");
Console.WriteLine($"{a.Intersects(b)} {a.Overlaps(b)} {a.Touches(b)}");""",
        ((0, 0, 10, 10), (10, 0, 20, 10)),
    ),
    Paste(
        "clipper2 cs",
        """Paths64 subj = new Paths64();
Paths64 clip = new Paths64();
subj.Add(Clipper.MakePath(new int[] { 100, 50, 10, 79, 65, 2 }));
clip.Add(Clipper.MakePath(new int[] { 98, 63, 4, 68, 77, 8 }));
Paths64 solution = Clipper.Intersect(subj, clip, FillRule.NonZero);""",
        ((10, 2, 100, 79), (4, 8, 98, 68)),
    ),
    Paste(
        "c# record print",
        """A = Polygon { Vertices = [<0, 0>, <4, 0>, <4, 4>] }
B = Polygon { Vertices = [<5, 0>, <9, 0>, <9, 4>] }""",
        ((0, 0, 4, 4), (5, 0, 9, 4)),
    ),
    Paste(
        "glm print",
        """A: vec2(0.000000, 0.000000), vec2(4.000000, 0.000000), vec2(4.000000, 4.000000)
B: vec2(3.000000, 1.000000), vec2(7.000000, 1.000000), vec2(7.000000, 5.000000)""",
        ((0, 0, 4, 4), (3, 1, 7, 5)),
    ),
    Paste(
        "eigen",
        """Eigen::MatrixXd A(3, 2);
A << 0, 0,
     4, 0,
     4, 3;
Eigen::MatrixXd B(3, 2);
B << 5, 0,
     9, 0,
     9, 3;""",
        ((0, 0, 4, 3), (5, 0, 9, 3)),
    ),
    Paste(
        "php",
        """$a = [[0, 0], [4, 0], [4, 4]];
$b = [[4, 0], [8, 0], [8, 4]];
var_dump(intersects($a, $b)); // bool(false)""",
        ((0, 0, 4, 4), (4, 0, 8, 4)),
    ),
    Paste(
        "ts interface",
        """interface Rect { x: number; y: number; w: number; h: number }
const a: Rect = { x: 0, y: 0, w: 10, h: 10 };
const b: Rect = { x: 10, y: 10, w: 5, h: 5 };
export function overlaps(p: Rect, q: Rect): boolean {
  return p.x < q.x + q.w && p.x + p.w > q.x && p.y < q.y + q.h && p.y + p.h > q.y;
}""",
        ((0, 0, 10, 10), (10, 10, 15, 15)),
        as_="corner-size",
        asks=True,
    ),
    Paste(
        "log with numbered bodies",
        """[2024-05-03T12:11:09.123Z] WARN physics: contact lost tick=4411
body#17 {"shape":"poly","verts":[[0.1,0.2],[0.4,0.2],[0.4,0.5],[0.1,0.5]]}
body#23 {"shape":"circle","c":[0.7,0.35],"r":0.25}""",
        ((0.1, 0.2, 0.4, 0.5), (0.45, 0.1, 0.95, 0.6)),
    ),
    Paste(
        "shapes numbered with a hash",
        """Polygon #1: (0, 0), (4, 0), (0, 4)
Polygon 2: (1, 1), (5, 1), (1, 5)
rect = pygame.Rect(4, 0, 4, 4)  #3: the player
other = pygame.Rect(8, 0, 4, 4) #4 (the enemy)""",
        ((0, 0, 4, 4), (1, 1, 5, 5), (4, 0, 8, 4), (8, 0, 12, 4)),
    ),
    Paste(
        "number of an issue before a name",
        """A: [[0, 0], [1, 0], [0, 1]]
issue #17 B: [[2, 0], [3, 0], [2, 1]]""",
        ((0, 0, 1, 1), (2, 0, 3, 1)),
    ),
    Paste(
        "kotlin data class",
        """data class Circle(val cx: Double, val cy: Double, val r: Double)
val spieler = Circle(cx = 0.0, cy = 0.0, r = 1.0)
val wand = Circle(cx = 3.0, cy = 0.0, r = 2.0)""",
        ((-1, -1, 1, 1), (1, -2, 5, 2)),
    ),
    Paste(
        "rust struct",
        """struct Circle { x: f64, y: f64, r: f64 }
let a = Circle { x: 0.0, y: 0.0, r: 1.0 };
let b = Circle { x: 5.0, y: 0.0, r: 1.0 };""",
        ((-1, -1, 1, 1), (4, -1, 6, 1)),
    ),
    Paste(
        "rust macroquad",
        """let player = Rect::new(10.0, 10.0, 32.0, 32.0);
let coin = Circle::new(50.0, 26.0, 8.0);
if coin.overlaps_rect(&player) {
    score += 10;
    draw_text("HIT", 20.0, 20.0, 30.0, WHITE);
}""",
        ((10, 10, 42, 42), (42, 18, 58, 34)),
        as_="corner-size",
        asks=True,
    ),
    Paste(
        "rust rapier",
        """let mut collider_set = ColliderSet::new();
let collider = ColliderBuilder::cuboid(10.0, 0.1).build();
collider_set.insert(collider);
let ball = ColliderBuilder::ball(0.5).translation(vector![0.0, 0.5]).restitution(0.7).build();
collider_set.insert(ball);
for _ in 0..200 {
    physics_pipeline.step(&gravity, &integration_parameters);
}""",
        ((-10, -0.1, 10, 0.1), (-0.5, 0, 0.5, 1)),
    ),
    Paste(
        "c# unity sat",
        """using UnityEngine;
public static class Program {
    public static void Main() {
        var a = new List<Vector2> { new Vector2(0, 0), new Vector2(3, 0), new Vector2(3, 3) };
        var b = new List<Vector2> { new Vector2(4, 0), new Vector2(6, 0), new Vector2(6, 2) };
        for (int i = 0; i < a.Count; i++) {
            var p1 = a[i];
            var p2 = a[(i + 1) % a.Count];
        }
        Debug.Log($"overlap: {Sat.Overlap(a, b)}");
    }
}""",
        ((0, 0, 3, 3), (4, 0, 6, 2)),
    ),
    Paste(
        "js function",
        """function doPolygonsIntersect (a, b) {
    var polygons = [a, b];
    var minA, maxA, projected, i, i1, j, minB, maxB;
    for (i = 0; i < polygons.length; i++) {
        var polygon = polygons[i];
    }
    return true;
}
const a = [{x: 0, y: 0}, {x: 10, y: 0}, {x: 10, y: 10}];
const b = [{x: 20, y: 0}, {x: 30, y: 0}, {x: 30, y: 10}];
console.log(doPolygonsIntersect(a, b)); // expected false, got true""",
        ((0, 0, 10, 10), (20, 0, 30, 10)),
    ),
    Paste(
        "py function",
        """def overlap(r1, r2):
    return not (r1[0] + r1[2] < r2[0] or r2[0] + r2[2] < r1[0])

import numpy as np
p1 = np.array([[1, 1], [5, 1], [5, 4]], dtype=float)
p2 = np.array([[4.5, 3], [8, 3], [8, 6]], dtype=float)
normals = [np.array([-(b - a)[1], (b - a)[0]]) for a, b in zip(p1, np.roll(p1, -1, axis=0))]
print(sat(p1, p2))""",
        ((1, 1, 5, 4), (4.5, 3, 8, 6)),
        as_="leave-out",
        asks=True,
    ),
    Paste(
        "pytest",
        """def test_touching():
    a = Polygon([(0, 0), (1, 0), (1, 1), (0, 1)])
    b = Polygon([(1, 0), (2, 0), (2, 1), (1, 1)])
    assert a.touches(b)
    assert not a.overlaps(b)
    assert a.distance(b) == pytest.approx(0.0, abs=1e-9)""",
        ((0, 0, 1, 1), (1, 0, 2, 1)),
    ),
    Paste(
        "pytest out",
        """E       AssertionError: assert False
E        +  where False = <bound method BaseGeometry.overlaps of <POLYGON ((0 0, 1 0, 1 1, 0 0))>>(<POLYGON ((0.5 0, 2 0, 2 1, 0.5 0))>)
tests/test_geom.py:42: AssertionError""",
        ((0, 0, 1, 1), (0.5, 0, 2, 1)),
    ),
    Paste(
        "java swing",
        """public class Game extends JPanel {
    private Rectangle player = new Rectangle(50, 50, 30, 30);
    private Rectangle wall = new Rectangle(80, 40, 10, 100);
    private int speed = 5;
    @Override
    protected void paintComponent(Graphics g) {
        super.paintComponent(g);
        g.setColor(Color.RED);
        g.fillRect(player.x, player.y, player.width, player.height);
    }
    boolean hit() { return player.intersects(wall); }
}""",
        ((50, 50, 80, 80), (80, 40, 90, 140)),
    ),
    Paste(
        "java println",
        """Rect1: java.awt.Rectangle[x=50,y=50,width=30,height=30]
Rect2: java.awt.Rectangle[x=80,y=40,width=10,height=100]
intersects: false""",
        ((50, 50, 80, 80), (80, 40, 90, 140)),
    ),
    Paste(
        "jts print",
        """Exception in thread "main" TopologyException: found non-noded intersection between LINESTRING and LINESTRING [ (5.0, 5.0, NaN) ]
g1: POLYGON ((0 0, 10 0, 10 10, 0 10, 0 0))
g2: POLYGON ((5 5, 15 5, 15 15, 5 5))""",
        ((0, 0, 10, 10), (5, 5, 15, 15)),
    ),
    Paste(
        "lua table",
        """local shapes = {
  { type = "circle", x = 100, y = 100, r = 20 },
  { type = "circle", x = 130, y = 100, r = 10 },
}
for i, s in ipairs(shapes) do
  love.graphics.circle("line", s.x, s.y, s.r)
end""",
        ((80, 80, 120, 120), (120, 90, 140, 110)),
    ),
    Paste(
        "bump lua",
        """local bump = require 'bump'
local world = bump.newWorld(50)
local A = {name="A", x=0, y=0, w=64, h=64}
local B = {name="B", x=64, y=0, w=32, h=32}
world:add(A, A.x, A.y, A.w, A.h)
world:add(B, B.x, B.y, B.w, B.h)
local cols, len = world:check(A)
assert(len == 0)""",
        ((0, 0, 64, 64), (64, 0, 96, 32)),
        as_="corner-size",
        asks=True,
    ),
    Paste(
        "godot area print",
        """Player global_position (120, 80) shape radius 16
Enemy global_position (150, 80) shape radius 14""",
        ((104, 64, 136, 96), (136, 66, 164, 94)),
    ),
    Paste(
        "unity polygoncollider yaml",
        """PolygonCollider2D:
  m_Density: 1
  m_IsTrigger: 0
  m_Offset: {x: 0, y: 0}
  m_Points:
    m_Paths:
    - - {x: 0, y: 0}
      - {x: 2, y: 0}
      - {x: 2, y: 2}
    - - {x: 5, y: 0}
      - {x: 7, y: 0}
      - {x: 7, y: 2}""",
        ((0, 0, 2, 2),),
        as_="leave-out",
        asks=True,
    ),
    Paste(
        "unity log vec",
        """A verts: (0.00, 0.00) (1.00, 0.00) (1.00, 1.00) (0.00, 1.00)
B verts: (0.50, 0.50) (2.00, 0.50) (2.00, 2.00)
Overlap? False
UnityEngine.Debug:Log(Object)
SatTest:Start() (at Assets/SatTest.cs:23)""",
        ((0, 0, 1, 1), (0.5, 0.5, 2, 2)),
    ),
    Paste(
        "threejs 2",
        """import * as THREE from 'three';
const geo = new THREE.Shape([new THREE.Vector2(0, 0), new THREE.Vector2(5, 0), new THREE.Vector2(5, 5)]);
const geo2 = new THREE.Shape([new THREE.Vector2(5, 5), new THREE.Vector2(9, 5), new THREE.Vector2(9, 9)]);
const mesh = new THREE.Mesh(new THREE.ShapeGeometry(geo), material);
scene.add(mesh);
camera.position.z = 5;""",
        ((0, 0, 5, 5), (5, 5, 9, 9)),
    ),
    Paste(
        "canvas",
        """const ctx = canvas.getContext('2d');
ctx.fillStyle = '#ff0000';
ctx.fillRect(10, 10, 100, 50);
ctx.beginPath();
ctx.arc(130, 35, 20, 0, Math.PI * 2);
ctx.fill();""",
        ((10, 10, 110, 60), (110, 15, 150, 55)),
    ),
    Paste(
        "konva",
        """const rect1 = new Konva.Rect({ x: 20, y: 20, width: 100, height: 50, fill: 'green', stroke: 'black', strokeWidth: 4 });
const circle = new Konva.Circle({ x: 140, y: 45, radius: 20, fill: 'red' });
layer.add(rect1); layer.add(circle);
console.log(Konva.Util.haveIntersection(rect1.getClientRect(), circle.getClientRect()));""",
        ((20, 20, 120, 70), (120, 25, 160, 65)),
    ),
    Paste(
        "d3 polygon",
        """var hull = [[0,0],[100,0],[100,100],[0,100]];
var other = [[100,100],[200,100],[200,200]];
d3.polygonContains(hull, [100, 100]); // false?""",
        ((0, 0, 100, 100), (100, 100, 200, 200)),
        as_="leave-out",
        asks=True,
    ),
    Paste(
        "leaflet",
        """var bounds1 = L.latLngBounds(L.latLng(40.712, -74.227), L.latLng(40.774, -74.125));
var bounds2 = L.latLngBounds(L.latLng(40.774, -74.125), L.latLng(40.8, -74.0));
bounds1.intersects(bounds2); // true, expected false""",
        ((40.712, -74.227, 40.774, -74.125), (40.774, -74.125, 40.8, -74)),
    ),
    Paste(
        "mapbox log",
        """Feature {type: 'Feature', properties: {id: 4}, geometry: {type: 'Polygon', coordinates: [[[0,0],[3,0],[3,3],[0,0]]]}}
Feature {type: 'Feature', properties: {id: 5}, geometry: {type: 'Polygon', coordinates: [[[3,3],[6,3],[6,6],[3,3]]]}}""",
        ((0, 0, 3, 3), (3, 3, 6, 6)),
    ),
    Paste(
        "svg circle group",
        """<g stroke="black" stroke-width="0.5" font-size="12">
  <circle cx="10" cy="10" r="5" data-id="17"/>
  <rect x="14" y="5" width="10" height="10" rx="0"/>
  <text x="3" y="30">overlap?</text>
</g>""",
        ((5, 5, 15, 15), (14, 5, 24, 15)),
    ),
    Paste(
        "c sdl",
        """SDL_FRect r1 = { 10.5f, 20.0f, 30.0f, 40.0f };
SDL_FRect r2 = { 40.5f, 20.0f, 5.0f, 5.0f };
if (SDL_HasRectIntersectionFloat(&r1, &r2)) {
    printf("hit at frame %d (tick %u)\\n", 312, SDL_GetTicks());
}""",
        ((10.5, 20, 40.5, 60), (40.5, 20, 45.5, 25)),
    ),
    Paste(
        "c array float",
        """static const float poly_a[8] = { 0.f, 0.f, 4.f, 0.f, 4.f, 4.f, 0.f, 4.f };
static const float poly_b[6] = { 4.f, 2.f, 8.f, 2.f, 8.f, 6.f };
int r = poly_overlap(poly_a, 4, poly_b, 3);
assert(r == 1);""",
        ((0, 0, 4, 4), (4, 2, 8, 6)),
    ),
    Paste(
        "clipper log",
        """subject: (0,0) (100,0) (100,100) (0,100)
clip: (50,50) (150,50) (150,150) (50,150)
solution area: 2500.0
elapsed 0.3 ms""",
        ((0, 0, 100, 100), (50, 50, 150, 150)),
    ),
    Paste(
        "geos c",
        """GEOSGeometry *a = GEOSGeomFromWKT("POLYGON((0 0,2 0,2 2,0 2,0 0))");
GEOSGeometry *b = GEOSGeomFromWKT("POLYGON((2 0,4 0,4 2,2 2,2 0))");
char r = GEOSTouches(a, b);
printf("%d\\n", r); /* 1 */""",
        ((0, 0, 2, 2), (2, 0, 4, 2)),
    ),
    Paste(
        "cgal wkt",
        """CGAL::Polygon_2<K> with 4 vertices: 0 0 1 0 1 1 0 1
CGAL::Polygon_2<K> with 3 vertices: 1 1 2 1 2 2""",
        ((0, 0, 1, 1), (1, 1, 2, 2)),
    ),
    Paste(
        "matplotlib",
        """import matplotlib.pyplot as plt
from matplotlib.patches import Rectangle, Circle
fig, ax = plt.subplots(figsize=(6, 4), dpi=150)
ax.add_patch(Rectangle((0.1, 0.1), 0.5, 0.6, alpha=0.1))
ax.add_patch(Circle((0.7, 0.4), 0.1, color='r'))
ax.set_xlim(0, 1); ax.set_ylim(0, 1)
plt.show()""",
        ((0.1, 0.1, 0.6, 0.7), (0.6, 0.3, 0.8, 0.5)),
    ),
    Paste(
        "geopandas",
        """   id                                           geometry
0   1  POLYGON ((0.00000 0.00000, 1.00000 0.00000, 1.00000 1.00000, 0.00000 0.00000))
1   2  POLYGON ((2.00000 0.00000, 3.00000 0.00000, 3.00000 1.00000, 2.00000 0.00000))""",
        ((0, 0, 1, 1), (2, 0, 3, 1)),
    ),
    Paste(
        "sql server",
        """DECLARE @g geometry = geometry::STGeomFromText('POLYGON((0 0, 150 0, 150 150, 0 150, 0 0))', 0);
DECLARE @h geometry = geometry::STGeomFromText('POLYGON((150 0, 300 0, 300 150, 150 0))', 0);
SELECT @g.STIntersects(@h), @g.STTouches(@h);""",
        ((0, 0, 150, 150), (150, 0, 300, 150)),
    ),
    Paste(
        "elixir",
        """a = [{0, 0}, {4, 0}, {4, 4}]
b = [{4, 0}, {8, 0}, {8, 4}]
iex> Collision.detect(a, b)
{:ok, 0.0}""",
        ((0, 0, 4, 4), (4, 0, 8, 4)),
    ),
    Paste(
        "swift skphysics",
        """let path1 = CGMutablePath()
path1.move(to: CGPoint(x: 0, y: 0))
path1.addLine(to: CGPoint(x: 50, y: 0))
path1.addLine(to: CGPoint(x: 50, y: 50))
path1.closeSubpath()""",
        (),
    ),
    Paste(
        "so question py",
        """I have two rectangles: R1 = [7, 8, 10, 11] and R2 = [9, 10, 13, 14], given as [x1, y1, x2, y2].
My function returns 0 but I expect them to overlap by 1. I use Python 3.10.""",
        ((7, 8, 10, 11), (9, 10, 13, 14)),
        as_="corner-corner",
    ),
    Paste(
        "so circles",
        """c1: x=10, y=10, r=5
c2: x=19, y=10, r=4
dist = 9, sum of radii = 9 -> should be touching""",
        ((5, 5, 15, 15), (15, 6, 23, 14)),
    ),
    Paste(
        "github md",
        """**Describe the bug**
`intersects` returns `true` for these polygons.

**To Reproduce**
1. Create polygon A with points (0, 0), (10, 0), (10, 10)
2. Create polygon B with points (11, 0), (20, 0), (20, 10)
3. Call `A.intersects(B)`

**Version:** 2.3.1, Node 18, macOS 13.4""",
        ((0, 0, 10, 10), (11, 0, 20, 10)),
    ),
    Paste(
        "npm version",
        """"sat": "^0.9.0"
Node v18.12.1
const a = new SAT.Box(new SAT.Vector(0, 0), 20, 20).toPolygon();
const b = new SAT.Box(new SAT.Vector(20, 0), 20, 20).toPolygon();
SAT.testPolygonPolygon(a, b) // true""",
        ((0, 0, 20, 20), (20, 0, 40, 20)),
        as_="corner-size",
    ),
    Paste(
        "ocaml",
        """let a = [| (0., 0.); (4., 0.); (4., 4.) |]
let b = [| (5., 0.); (9., 0.); (9., 4.) |]
let () = Printf.printf "%b\\n" (intersects a b)""",
        ((0, 0, 4, 4), (5, 0, 9, 4)),
    ),
    Paste(
        "box2d testbed",
        """b2Vec2 verts1[4];
verts1[0].Set(-1.0f, -1.0f);
verts1[1].Set(1.0f, -1.0f);
verts1[2].Set(1.0f, 1.0f);
verts1[3].Set(-1.0f, 1.0f);
b2PolygonShape shapeA;
shapeA.Set(verts1, 4);
b2CircleShape shapeB;
shapeB.m_p.Set(1.5f, 0.0f);
shapeB.m_radius = 0.5f;
// b2TestOverlap(&shapeA, 0, &shapeB, 0, xfA, xfB) returns true""",
        ((-1, -1, 1, 1), (1, -0.5, 2, 0.5)),
    ),
    Paste(
        "p5 sketch",
        """function draw() {
  background(220);
  rect(50, 50, 100, 80);
  circle(170, 90, 40);
  let hit = collideRectCircle(50, 50, 100, 80, 170, 90, 40);
  print(hit);
}""",
        ((50, 50, 150, 130), (150, 70, 190, 110)),
    ),
    Paste(
        "phaser rectangles",
        """var r1 = new Phaser.Geom.Rectangle(100, 100, 50, 50);
var r2 = new Phaser.Geom.Rectangle(150, 120, 50, 50);
console.log(Phaser.Geom.Intersects.RectangleToRectangle(r1, r2)); // false?""",
        ((100, 100, 150, 150), (150, 120, 200, 170)),
    ),
    Paste(
        "phaser circle triangle",
        """const tri = new Phaser.Geom.Triangle(0, 0, 60, 0, 30, 50);
const circ = new Phaser.Geom.Circle(80, 20, 25);
expect(Phaser.Geom.Intersects.TriangleToCircle(tri, circ)).toBe(true);""",
        ((0, 0, 60, 50), (55, -5, 105, 45)),
    ),
    Paste(
        "unity polygon",
        """var a = new Vector2[] { new Vector2(0f, 0f), new Vector2(2.5f, 0f), new Vector2(2.5f, 1.25f) };
var b = new Vector2[] { new Vector2(2f, 1f), new Vector2(4f, 1f), new Vector2(3f, 3f) };
Debug.Log(PolygonsOverlap(a, b));
// Output: False""",
        ((0, 0, 2.5, 1.25), (2, 1, 4, 3)),
    ),
    Paste(
        "unity bounds ctor",
        """Bounds a = new Bounds(new Vector3(0, 0, 0), new Vector3(2, 2, 0));
Bounds b = new Bounds(new Vector3(2, 0, 0), new Vector3(2, 2, 0));
Debug.Log(a.Intersects(b)); // True, but they only touch""",
        ((-1, -1, 1, 1), (1, -1, 3, 1)),
    ),
    Paste(
        "godot convex",
        """var p1 := PackedVector2Array([Vector2(0, 0), Vector2(64, 0), Vector2(64, 64), Vector2(0, 64)])
var p2 := PackedVector2Array([Vector2(64, 32), Vector2(128, 32), Vector2(96, 96)])
print(Geometry2D.intersect_polygons(p1, p2))  # prints []""",
        ((0, 0, 64, 64), (64, 32, 128, 96)),
    ),
    Paste(
        "godot rect2 position",
        """a = Rect2(Vector2(16, 16), Vector2(32, 32))
b = Rect2(Vector2(48, 16), Vector2(32, 32))
assert(a.intersects(b))""",
        ((16, 16, 48, 48), (48, 16, 80, 48)),
    ),
    Paste(
        "pygame rects",
        """player = pygame.Rect(100, 100, 32, 32)
wall = pygame.Rect((132, 90), (20, 60))
if player.colliderect(wall):
    print("hit")
# never prints hit""",
        ((100, 100, 132, 132), (132, 90, 152, 150)),
    ),
    Paste(
        "pygame draw",
        """pygame.draw.polygon(screen, (255, 0, 0), [(100, 100), (200, 100), (150, 180)])
pygame.draw.circle(screen, (0, 255, 0), (150, 200), 25)
pygame.display.flip()""",
        ((100, 100, 200, 180), (125, 175, 175, 225)),
    ),
    Paste(
        "pygame float rect",
        """a = pygame.FRect(0.5, 0.5, 10, 10)
b = pygame.FRect(10.4, 0, 5, 5)
a.colliderect(b) -> False""",
        ((0.5, 0.5, 10.5, 10.5), (10.4, 0, 15.4, 5)),
    ),
    Paste(
        "matter vertices",
        """const a = Bodies.fromVertices(0, 0, [[{ x: -10, y: -10 }, { x: 10, y: -10 }, { x: 10, y: 10 }, { x: -10, y: 10 }]]);
const b = Bodies.circle(18, 0, 8);
Matter.Collision.collides(a, b) // null""",
        ((-10, -10, 10, 10), (10, -8, 26, 8)),
    ),
    Paste(
        "matter bounds print",
        """{ min: { x: 390, y: 190 }, max: { x: 410, y: 210 } }
{ min: { x: 410, y: 150 }, max: { x: 470, y: 200 } }
Bounds.overlaps gives true""",
        ((390, 190, 410, 210), (410, 150, 470, 200)),
    ),
    Paste(
        "shapely repl",
        """>>> from shapely.geometry import Polygon
>>> p = Polygon([(0, 0), (1, 0), (1, 1), (0, 1)])
>>> q = Polygon([(0.5, 0.5), (1.5, 0.5), (1.5, 1.5), (0.5, 1.5)])
>>> p.touches(q)
False
>>> p.intersection(q).area
0.25""",
        ((0, 0, 1, 1), (0.5, 0.5, 1.5, 1.5)),
    ),
    Paste(
        "shapely wkt loads",
        """g1 = wkt.loads('POLYGON ((30 10, 40 40, 20 40, 10 20, 30 10))')
g2 = wkt.loads('POLYGON ((35 10, 45 45, 15 40, 10 20, 35 10))')
g1.equals(g2), g1.overlaps(g2)
(False, True)""",
        ((10, 10, 40, 40), (10, 10, 45, 45)),
    ),
    Paste(
        "cgal points",
        """Polygon_2 P;
P.push_back(Point_2(-1, 1));
P.push_back(Point_2(0, -1));
P.push_back(Point_2(1, 1));
Polygon_2 Q;
Q.push_back(Point_2(-1, -1));
Q.push_back(Point_2(1, -1));
Q.push_back(Point_2(0, 1));
if (CGAL::do_intersect(P, Q)) std::cout << "The two polygons intersect." << std::endl;""",
        ((-1, -1, 1, 1), (-1, -1, 1, 1)),
    ),
    Paste(
        "cgal array init",
        """Point points[] = { Point(0,0), Point(5.1,0), Point(1,1), Point(0.5,6) };
Polygon_2 pgn(points, points+4);
Point points2[] = { Point(5,0), Point(7,0), Point(6,2) };
Polygon_2 pgn2(points2, points2+3);""",
        ((0, 0, 5.1, 6), (5, 0, 7, 2)),
    ),
    Paste(
        "parry shapes",
        """let ball = Ball::new(1.0);
let cuboid = Cuboid::new(vector![1.0, 1.0]);
let ball_pos = Isometry::translation(2.0, 0.0);
let cuboid_pos = Isometry::identity();
assert!(query::intersection_test(&ball_pos, &ball, &cuboid_pos, &cuboid).unwrap());""",
        ((1, -1, 3, 1), (-1, -1, 1, 1)),
    ),
    Paste(
        "parry hull",
        """let a = ConvexPolygon::from_convex_hull(&[point![0.0, 0.0], point![2.0, 0.0], point![2.0, 2.0], point![0.0, 2.0]]).unwrap();
let b = ConvexPolygon::from_convex_hull(&[point![2.0, 1.0], point![4.0, 1.0], point![3.0, 3.0]]).unwrap();""",
        ((0, 0, 2, 2), (2, 1, 4, 3)),
    ),
    Paste(
        "love polygon",
        """local t1 = {100, 100, 200, 100, 150, 200}
local t2 = {150, 150, 250, 150, 200, 250}
love.graphics.polygon("fill", t1)
love.graphics.polygon("fill", t2)""",
        ((100, 100, 200, 200), (150, 150, 250, 250)),
    ),
    Paste(
        "love hc",
        """local HC = require 'HC'
rect = HC.rectangle(200, 400, 400, 20)
mouse = HC.circle(400, 390, 20)
for shape, delta in pairs(HC.collisions(mouse)) do print(delta.x, delta.y) end""",
        ((200, 400, 600, 420), (380, 370, 420, 410)),
    ),
    Paste(
        "defold",
        """local a = {x = 0, y = 0, w = 16, h = 16}
local b = {x = 15.9999, y = 0, w = 16, h = 16}
print(a.x < b.x + b.w and b.x < a.x + a.w)""",
        ((0, 0, 16, 16), (15.9999, 0, 31.9999, 16)),
    ),
    Paste(
        "processing (report)",
        """void setup() {
  size(640, 360);
}
void draw() {
  ellipse(100, 100, 50, 50);
  rect(120, 90, 40, 40);
  // I expect a hit here
}""",
        ((75, 75, 125, 125), (120, 90, 160, 130)),
    ),
    Paste(
        "processing pshape",
        """PShape s = createShape();
s.beginShape();
s.vertex(0, 0);
s.vertex(80, 0);
s.vertex(80, 40);
s.endShape(CLOSE);
ellipse(90, 40, 30, 30);""",
        ((0, 0, 80, 40), (75, 25, 105, 55)),
    ),
    Paste(
        "sfml rects",
        """sf::FloatRect box1({10.f, 10.f}, {50.f, 50.f});
sf::FloatRect box2({60.f, 10.f}, {20.f, 20.f});
std::cout << box1.findIntersection(box2).has_value();""",
        ((10, 10, 60, 60), (60, 10, 80, 30)),
    ),
    Paste(
        "sfml convex",
        """sf::ConvexShape convex;
convex.setPointCount(3);
convex.setPoint(0, sf::Vector2f(0.f, 0.f));
convex.setPoint(1, sf::Vector2f(150.f, 10.f));
convex.setPoint(2, sf::Vector2f(120.f, 90.f));
sf::FloatRect r(100.f, 80.f, 40.f, 40.f);""",
        ((0, 0, 150, 90), (100, 80, 140, 120)),
    ),
    Paste(
        "monogame (report)",
        """Rectangle a = new Rectangle(0, 0, 100, 100);
Rectangle b = new Rectangle(100, 0, 50, 50);
Console.WriteLine(a.Intersects(b)); // False
Console.WriteLine(a.Contains(b)); // False""",
        ((0, 0, 100, 100), (100, 0, 150, 50)),
    ),
    Paste(
        "pandas geometry",
        """       name                                           geometry
0  building  POLYGON ((0.00000 0.00000, 10.00000 0.00000, 10.00000 10.00000, 0.00000 10.00000, 0.00000 0.00000))
1      road  POLYGON ((10.00000 4.00000, 30.00000 4.00000, 30.00000 6.00000, 10.00000 6.00000, 10.00000 4.00000))""",
        ((0, 0, 10, 10), (10, 4, 30, 6)),
    ),
    Paste(
        "jest",
        """expect(received).toBe(expected)
Expected: true
Received: false
  const a = { pos: { x: 0, y: 0 }, r: 10 }
  const b = { pos: { x: 12, y: 16 }, r: 10 }
  expect(testCircleCircle(a, b)).toBe(true)""",
        ((-10, -10, 10, 10), (2, 6, 22, 26)),
    ),
    Paste(
        "sat.js (report)",
        """var V = SAT.Vector; var P = SAT.Polygon; var B = SAT.Box;
var box1 = new B(new V(0, 0), 20, 20).toPolygon();
var box2 = new B(new V(20, 20), 20, 20).toPolygon();
SAT.testPolygonPolygon(box1, box2); // true""",
        ((0, 0, 20, 20), (20, 20, 40, 40)),
    ),
    Paste(
        "sat.js rotated",
        """var p = new SAT.Polygon(new SAT.Vector(0,0), [new SAT.Vector(0,0), new SAT.Vector(40,0), new SAT.Vector(40,40), new SAT.Vector(0,40)]);
p.setAngle(Math.PI / 4);
var c = new SAT.Circle(new SAT.Vector(60,0), 20);""",
        ((-28.2843, 0, 28.2843, 56.5685), (40, -20, 80, 20)),
        as_="y-up",
        asks=True,
    ),
    Paste(
        "collider2d",
        """const circle = new Circle(new Vector(0, 0), 20);
const circle2 = new Circle(new Vector(30, 0), 20);
collider2D.testCircleCircle(circle, circle2, true); // true""",
        ((-20, -20, 20, 20), (10, -20, 50, 20)),
    ),
    Paste(
        "planck (report)",
        """const shapeA = pl.Polygon([Vec2(-1, 0), Vec2(1, 0), Vec2(0, 2)]);
const shapeB = pl.Circle(Vec2(0.0, 3.0), 1.0);
testOverlap(shapeA, 0, shapeB, 0, xf, xf)""",
        ((-1, 0, 1, 2), (-1, 2, 1, 4)),
    ),
    Paste(
        "nape haxe",
        """var poly = new Polygon([Vec2.get(0, 0), Vec2.get(20, 0), Vec2.get(20, 10)]);
var circ = new Circle(5, Vec2.get(25, 5));""",
        ((0, 0, 20, 10), (20, 0, 30, 10)),
    ),
    Paste(
        "geojson feature text",
        """{"type":"Feature","properties":{"id":7},"geometry":{"type":"Polygon","coordinates":[[[0,0],[3,0],[3,3],[0,3],[0,0]]]}}
{"type":"Feature","properties":{"id":8},"geometry":{"type":"Polygon","coordinates":[[[3,1],[5,1],[5,2],[3,2],[3,1]]]}}""",
        ((0, 0, 3, 3), (3, 1, 5, 2)),
    ),
    Paste(
        "swift cgrect",
        """let a = CGRect(x: 0, y: 0, width: 44, height: 44)
let b = CGRect(origin: CGPoint(x: 44, y: 0), size: CGSize(width: 10, height: 10))
a.intersects(b) // false""",
        ((0, 0, 44, 44), (44, 0, 54, 10)),
    ),
    Paste(
        "java jts code",
        """GeometryFactory gf = new GeometryFactory();
Polygon a = gf.createPolygon(new Coordinate[]{new Coordinate(0, 0), new Coordinate(10, 0), new Coordinate(10, 10), new Coordinate(0, 0)});
Polygon b = gf.createPolygon(new Coordinate[]{new Coordinate(5, 0), new Coordinate(15, -5), new Coordinate(15, 0), new Coordinate(5, 0)});
System.out.println(a.touches(b)); // expected true""",
        ((0, 0, 10, 10), (5, -5, 15, 0)),
    ),
    Paste(
        "turf (report)",
        """const poly1 = turf.polygon([[[0, 0], [0, 4], [4, 4], [4, 0], [0, 0]]]);
const poly2 = turf.polygon([[[4, 2], [6, 2], [6, 6], [4, 6], [4, 2]]]);
turf.booleanOverlap(poly1, poly2); // false""",
        ((0, 0, 4, 4), (4, 2, 6, 6)),
    ),
    Paste(
        "gdb watch",
        """(gdb) p a
$1 = {min = {x = -1.5, y = -1.5}, max = {x = 1.5, y = 1.5}}
(gdb) p b
$2 = {min = {x = 1.5, y = 0}, max = {x = 3, y = 2}}""",
        ((-1.5, -1.5, 1.5, 1.5), (1.5, 0, 3, 2)),
    ),
    Paste(
        "unreal",
        """FBox2D A(FVector2D(0.f, 0.f), FVector2D(100.f, 100.f));
FBox2D B(FVector2D(100.f, 50.f), FVector2D(200.f, 150.f));
UE_LOG(LogTemp, Warning, TEXT("%d"), A.Intersect(B));""",
        ((0, 0, 100, 100), (100, 50, 200, 150)),
    ),
    Paste(
        "two units in a sentence",
        "circle at (10 cm, 20 cm) radius 5 cm and circle at (150 mm, 200 mm) radius 30 mm",
        ((5, 15, 15, 25),),
        as_="leave-out",
        asks=True,
    ),
    Paste(
        "one unit in a sentence",
        "All in mm: circle at (0, 0) with radius 2 mm and circle at (5, 0) with radius 3",
        ((-2, -2, 2, 2), (2, -3, 8, 3)),
    ),
    Paste(
        "a unit before each outline",
        "Polygon A in mm: (0,0), (40,0), (40,30). Polygon B in cm: (3,1), (7,1), (7,5).",
        ((0, 0, 40, 30),),
        as_="leave-out",
        asks=True,
    ),
    Paste(
        "two units in svg",
        """<rect x="1cm" y="0cm" width="2cm" height="1cm"/>
<circle cx="30mm" cy="10mm" r="5mm"/>""",
        ((1, 0, 3, 1),),
        as_="leave-out",
        asks=True,
    ),
    Paste(
        "a style that moves",
        """<polygon points="0,0 4,0 4,4"/>
<polygon points="3,0 7,0 7,4" style="transform: translateX(10px)"/>""",
        ((0, 0, 4, 4),),
        as_="leave-out",
        asks=True,
    ),
    Paste(
        "decimal commas after names",
        """name;x;y;radius
ball;1,5;2,5;0,5
peg;2,5;2,5;0,75""",
        ((1, 2, 2, 3), (1.75, 1.75, 3.25, 3.25)),
        as_="decimal-commas",
        asks=True,
    ),
    Paste(
        "decimal commas without a header",
        """ball;1,5;2,7;0,5
peg;2,5;2,6;0,75""",
        ((0, 5, 2, 7), (0, 5, 2, 75)),
        as_="separators",
        asks=True,
    ),
    Paste(
        "arrays of c with both lengths",
        """static const double a[][2] = {{0, 0}, {4, 0}, {4, 4}};
static const double b[3][2] = {{3, 1}, {7, 1}, {7, 5}};""",
        ((0, 0, 4, 4), (3, 1, 7, 5)),
    ),
    Paste(
        "a table with numbered rows",
        """| # | shape | x | y | r |
|---|-------|---|---|---|
| 1 | ball  | 0 | 0 | 4 |
| 2 | peg   | 3 | 3 | 2 |""",
        ((-4, -4, 4, 4), (1, 1, 5, 5)),
    ),
    Paste(
        "a picture in a picture",
        """<svg x="0" y="0"><circle cx="3" cy="1" r="1"/><svg x="10" y="0"><rect x="0" y="0" width="4" height="4"/></svg></svg>""",
        ((2, 0, 4, 2), (0, 0, 4, 4)),
        as_="leave-out",
        asks=True,
    ),
    Paste(
        "moved after a turn",
        """const b = new SAT.Polygon(new SAT.Vector(5, 0), [new SAT.Vector(0, 0), new SAT.Vector(4, 0), new SAT.Vector(4, 4)]);
b.rotate(Math.PI);
b.translate(1, 0);
const c = new SAT.Circle(new SAT.Vector(7, 2), 1);""",
        ((6, 1, 8, 3),),
        as_="leave-out",
        asks=True,
    ),
    Paste(
        "a corner deleted",
        """p = [(0, 0), (4, 0), (4, 4), (0, 4)]
del p[0]""",
        ((0, 0, 4, 4),),
        as_="leave-out",
        asks=True,
    ),
    Paste(
        "a part of a list",
        """p = [(0, 0), (4, 0), (4, 4), (0, 4)]
q = Polygon(p[1:])""",
        ((0, 0, 4, 4),),
        as_="leave-out",
        asks=True,
    ),
    Paste(
        "numpy shortened",
        """[[0 0]
 [4 0]
 ...
 [4 4]
 [0 4]]""",
        (),
    ),
    Paste(
        "numbers given anew",
        """Rectangle r = new Rectangle(0, 0, 4, 4);
r.setBounds(10, 10, 4, 4);
Rectangle s = new Rectangle(11, 11, 4, 4);""",
        ((10, 10, 14, 14), (11, 11, 15, 15)),
    ),
    Paste(
        "a change with its heads",
        """--- a/t.js
+++ b/t.js
@@ -1,2 +1,2 @@
-const a = new SAT.Circle(new SAT.Vector(0, 0), 5);
+const a = new SAT.Circle(new SAT.Vector(1, 0), 5);
 const b = new SAT.Circle(new SAT.Vector(9, 0), 5);""",
        ((-4, -5, 6, 5), (4, -5, 14, 5)),
    ),
    Paste(
        "a change of a corner",
        """ pts = [
   (0, 0),
-  (4, 0),
+  (5, 0),
   (0, 3),
 ]
circle((9, 9), 1)""",
        ((0, 0, 5, 3), (8, 8, 10, 10)),
    ),
    Paste(
        "corners with signs",
        """-1 -1
+1 -1
+1 +1

-2 0
+2 0
+2 +2""",
        ((-1, -1, 1, 1), (-2, 0, 2, 2)),
    ),
    Paste(
        "bullets with two signs",
        """- circle((0, 0), 5)
- circle((7, 0), 5)
+ circle((9, 0), 5)""",
        ((-5, -5, 5, 5), (2, -5, 12, 5), (4, -5, 14, 5)),
    ),
    Paste(
        "a merge that is not finished",
        """<<<<<<< HEAD
a = Circle((0, 0), 5)
=======
a = Circle((1, 0), 5)
>>>>>>> feature
b = Circle((9, 0), 5)""",
        (),
    ),
    Paste(
        "a group that a style moves",
        """<g style="translate: 5px"><circle cx="0" cy="0" r="2"/></g><circle cx="9" cy="0" r="2"/>""",
        ((-2, -2, 2, 2), (7, -2, 11, 2)),
        as_="leave-out",
        asks=True,
    ),
    Paste(
        "px in svg",
        """<rect x="10px" y="5" width="20" height="20"/><circle cx="5" cy="5" r="3px"/>""",
        ((10, 5, 30, 25), (2, 2, 8, 8)),
    ),
    Paste(
        "a bare number among px",
        """a: { left: 10px; top: 5; width: 20px; height: 20px }
b: { left: 30px; top: 5px; width: 20px; height: 20px }""",
        ((10, 5, 30, 25), (30, 5, 50, 25)),
        as_="leave-out",
        asks=True,
    ),
    Paste(
        "a column cut off",
        """(0, 0)
(4, 0)
(4, 4)
... and 12 more

circle((9, 9), 1)""",
        ((0, 0, 4, 4), (8, 8, 10, 10)),
        as_="leave-out",
        asks=True,
    ),
    Paste(
        "code left out between statements",
        """const a = new Circle(0, 0, 5);
...
const b = new Circle(7, 0, 5);""",
        ((-5, -5, 5, 5), (2, -5, 12, 5)),
    ),
    Paste(
        "a polygon rotated",
        """a = Polygon([(10, 0), (14, 0), (14, 2), (10, 2)])
a.rotate(90)
b = Circle((12, 4), 1)""",
        ((11, -1, 13, 3), (11, 3, 13, 5)),
        as_="around-center degrees",
        asks=True,
    ),
    Paste(
        "a circle rotated",
        """c = Circle((10, 0), 4)
c.rotate(90)
d = Circle((2, 12), 3)""",
        ((-4, 6, 4, 14), (-1, 9, 5, 15)),
        as_="around-origin degrees y-up",
        asks=True,
    ),
    Paste(
        "a sketch that tests what it draws",
        """ellipse(200, 100, 45, 45);
hit = collideCirclePoly(200, 100, 45, poly);
poly = [{x: 0, y: 0}, {x: 180, y: 0}, {x: 180, y: 120}];""",
        ((177.5, 77.5, 222.5, 122.5), (0, 0, 180, 120)),
    ),
    Paste(
        "a name that a session prints",
        """>>> a = pygame.Rect(0, 0, 10, 10)
>>> b = pygame.Rect(10, 0, 10, 10)
>>> a
<rect(0, 0, 10, 10)>""",
        ((0, 0, 10, 10), (10, 0, 20, 10)),
    ),
    Paste(
        "a body of LÖVE at its place",
        """body = love.physics.newBody(world, 100, 100, "dynamic")
shape = love.physics.newRectangleShape(50, 100)
circle((100, 180), 31)""",
        ((-25, -50, 25, 50), (69, 149, 131, 211)),
        as_="leave-out",
        asks=True,
    ),
    Paste(
        "numbers of lines in brackets",
        """(1) Circle(0, 0, 2)
(2) Circle(3, 0, 2)""",
        ((-2, -2, 2, 2), (1, -2, 5, 2)),
    ),
    Paste(
        "a logical answer of matlab",
        """p = polyshape([0 4 0], [0 0 3]);
q = polyshape([1 5 5], [1 1 5]);
>> overlaps(p, q)

ans =

  logical

   1""",
        ((0, 0, 4, 3), (1, 1, 5, 5)),
    ),
    Paste(
        "columns of R",
        """a <- cbind(c(0, 4, 4, 3, 2, 0), c(0, 0, 4, 6, 6, 4))
b <- cbind(x = c(1, 5, 5, 1), y = c(1, 1, 5, 5))""",
        ((0, 0, 4, 6), (1, 1, 5, 5)),
    ),
    Paste(
        "a class of python",
        """class Circle:
    def __init__(self, x: float, y: float = 3, r: float = 1):
        self.x = x
        self.y = y

a = Circle(0, 0, 5)
b = Circle(7, 0, 5)""",
        ((-5, -5, 5, 5), (2, -5, 12, 5)),
    ),
    Paste(
        "a data class",
        """@dataclass
class Circle:
    x: float
    y: float
    r: float

a = Circle(0, 0, 5)
b = Circle(7, 0, 5)""",
        ((-5, -5, 5, 5), (2, -5, 12, 5)),
    ),
    Paste(
        "a class of javascript",
        """class Circle {
  constructor(x, y, r) {
    this.x = x;
    this.y = y;
    this.r = r;
  }
}
const a = new Circle(0, 0, 5);
const b = new Circle(7, 0, 5);""",
        ((-5, -5, 5, 5), (2, -5, 12, 5)),
    ),
    Paste(
        "a class of java",
        """public class Circle {
    public Circle(double x, double y, double r) {
        this.x = x;
    }
}
Circle a = new Circle(0, 0, 5);
Circle b = new Circle(7, 0, 5);""",
        ((-5, -5, 5, 5), (2, -5, 12, 5)),
    ),
    Paste(
        "segments of a circle of LÖVE",
        """love.graphics.circle("fill", 100, 100, 50, 32)
love.graphics.rectangle("line", 140, 50, 60, 120)""",
        ((50, 50, 150, 150), (140, 50, 200, 170)),
    ),
    Paste(
        "the width of a line of pygame",
        """pygame.draw.circle(screen, RED, (100, 100), 50, 2)
pygame.draw.circle(screen, RED, (180, 100), 50, 2)""",
        ((50, 50, 150, 150), (130, 50, 230, 150)),
    ),
    Paste(
        "matrices as R prints them",
        """> a
     [,1] [,2]
[1,]    0    0
[2,]    4    0
[3,]    0    3
> b
     x y
[1,] 1 1
[2,] 5 1
[3,] 5 5""",
        ((0, 0, 4, 3), (1, 1, 5, 5)),
    ),
    Paste(
        "circles at the origin",
        "A circle of radius 5 at the origin, and a circle at the origin with radius 3",
        ((-5, -5, 5, 5), (-3, -3, 3, 3)),
    ),
    Paste(
        "ranges",
        """A: x 0..4, y 0..4
B: x: 3.5..7, y: -3..7""",
        ((0, 0, 4, 4), (3.5, -3, 7, 7)),
    ),
    Paste(
        "numbered circles",
        """Circle #1 (0, 0, 2)
Circle #2: (3, 0, 2)
Circle 3 (6, 0, 2)""",
        ((-2, -2, 2, 2), (1, -2, 5, 2), (4, -2, 8, 2)),
    ),
    Paste(
        "keys without signs",
        """player: x 10 y 20 w 16 h 16
ball: x 20, y 30, r 16""",
        ((10, 20, 26, 36), (4, 14, 36, 46)),
        as_="corner-size",
    ),
    Paste(
        "two keys with points",
        """a center (0.0, 0.0) extents (1.0, 1.0)
b center (2.0, 0.0) extents (1.0, 1.0)""",
        ((-1, -1, 1, 1), (1, -1, 3, 1)),
    ),
    Paste(
        "arrays of fortran",
        """real :: x(4) = (/ 0.0, 4.0, 4.0, 0.0 /)
real :: y(4) = (/ 0.0, 0.0, 4.0, 4.0 /)
xb = (/ 1.0d0, 5.0d0, 5.0d0 /)
yb = (/ 1.0d0, 1.0d0, 5.0d0 /)""",
        ((0, 0, 4, 4), (1, 1, 5, 5)),
    ),
    Paste(
        "the form of an issue",
        """**To Reproduce**
1. rect A: x=0, y=0, w=10, h=10
2. rect B: x=10, y=0, w=10, h=10
3. call `collides(A, B)` -> true

**Environment** v2.3.1, Windows 11, Chrome 118""",
        ((0, 0, 10, 10), (10, 0, 20, 10)),
    ),
    Paste(
        "a reader of JTS",
        """Geometry a = new WKTReader().read("POLYGON ((0 0, 4 0, 4 4, 0 0))");
Geometry b = new WKTReader().read("POLYGON ((4 0, 8 0, 8 4, 4 0))");""",
        ((0, 0, 4, 4), (4, 0, 8, 4)),
    ),
    Paste(
        "a position of unity",
        """Rectangle a = new Rectangle(0, 0, 10, 10);
Rectangle b = new Rectangle(10, 0, 10, 10);
a.position = new Vector2(1, 0);""",
        ((1, 0, 11, 10), (10, 0, 20, 10)),
    ),
    Paste(
        "a method of lua",
        """rect = HC.rectangle(200, 400, 400, 20)
mouse = HC.circle(400, 300, 20)
mouse:moveTo(400, 390)""",
        ((200, 400, 600, 420), (380, 370, 420, 410)),
    ),
    Paste(
        "two of one type",
        "sf::FloatRect a(0, 0, 10, 10), b(5, 5, 10, 10);",
        ((0, 0, 10, 10), (5, 5, 15, 15)),
    ),
    Paste(
        "a test with the numbers of two boxes",
        "print(CheckCollision(0, 0, 10, 10, 10, 0, 10, 10))",
        ((0, 0, 10, 10), (10, 0, 20, 10)),
    ),
    Paste(
        "a square and a turned box",
        """b2Polygon a = b2MakeOffsetBox(1.0f, 2.0f, (b2Vec2){3.0f, 0.0f}, b2MakeRot(0.0f));
b2Polygon b = b2MakeSquare(1.0f);""",
        ((2, -2, 4, 2), (-1, -1, 1, 1)),
    ),
    Paste(
        "csharp class defaults",
        """class Ball {
    public float X = 0;
    public float Y = 0;
    public float R = 1;
}
var a = new Ball { X = 10, Y = 10, R = 5 };
var b = new Ball { X = 17, Y = 10, R = 2 };""",
        ((5, 5, 15, 15), (15, 8, 19, 12)),
    ),
    Paste(
        "csharp class circle",
        """public class Circle {
    public float Radius = 1f;
    public Vector2 Center = new Vector2(0, 0);
}
Circle a = new Circle { Center = new Vector2(3, 4), Radius = 5 };
Circle b = new Circle { Center = new Vector2(13, 4), Radius = 5 };""",
        ((-2, -1, 8, 9), (8, -1, 18, 9)),
    ),
    Paste(
        "kotlin defaults",
        """data class Circle(val x: Float = 0f, val y: Float = 0f, val r: Float = 1f)
val a = Circle(0f, 0f, 5f)
val b = Circle(r = 2f, x = 7f, y = 0f)""",
        ((-5, -5, 5, 5), (5, -2, 9, 2)),
    ),
    Paste(
        "cpp struct defaults",
        """struct Circle {
    float x = 0.f, y = 0.f;
    float r = 1.f;
};
Circle a{0, 0, 5};
Circle b{7, 0, 2};
bool hit = overlaps(a, b);""",
        ((-5, -5, 5, 5), (5, -2, 9, 2)),
    ),
    Paste(
        "matter vertices console",
        """body 12 vertices:
0: {x: 10, y: 10, index: 0, body: {…}, isInternal: false}
1: {x: 50, y: 10, index: 1, body: {…}, isInternal: false}
2: {x: 50, y: 50, index: 2, body: {…}, isInternal: false}
body 13 vertices:
0: {x: 40, y: 40, index: 0, body: {…}, isInternal: false}
1: {x: 90, y: 40, index: 1, body: {…}, isInternal: false}
2: {x: 90, y: 90, index: 2, body: {…}, isInternal: false}""",
        ((10, 10, 50, 50), (40, 40, 90, 90)),
    ),
    Paste(
        "GEOS hex",
        """geosop -a "POLYGON ((0 0, 10 0, 10 10, 0 10, 0 0))" -b "POLYGON ((10 0, 20 0, 20 10, 10 10, 10 0))" touches
true""",
        ((0, 0, 10, 10), (10, 0, 20, 10)),
    ),
    Paste(
        "unity rectint",
        """RectInt a = new RectInt(0, 0, 3, 3);
RectInt b = new RectInt(new Vector2Int(3, 0), new Vector2Int(3, 3));
print(a.Overlaps(b));""",
        ((0, 0, 3, 3), (3, 0, 6, 3)),
    ),
    Paste(
        "opencv contour print",
        """cnt0:
[[[ 10  10]]

 [[ 90  10]]

 [[ 90  80]]

 [[ 10  80]]]
cnt1:
[[[ 85  40]]

 [[150  40]]

 [[150 120]]]""",
        ((10, 10, 90, 80), (85, 40, 150, 120)),
    ),
    Paste(
        "monogame watch",
        """Name	Value	Type
player.Bounds	{X:100 Y:200 Width:32 Height:32}	Microsoft.Xna.Framework.Rectangle
enemy.Bounds	{X:131 Y:200 Width:32 Height:32}	Microsoft.Xna.Framework.Rectangle""",
        ((100, 200, 132, 232), (131, 200, 163, 232)),
    ),
    Paste(
        "d3 hull",
        """const hullA = d3.polygonHull([[0, 0], [40, 0], [40, 40], [20, 20], [0, 40]]);
const hullB = d3.polygonHull([[40, 10], [80, 10], [80, 50]]);""",
        ((0, 0, 40, 40), (40, 10, 80, 50)),
    ),
    Paste(
        "psql expanded",
        """-[ RECORD 1 ]-----------------------
id   | 7
geom | POLYGON((0 0,4 0,4 4,0 4,0 0))
-[ RECORD 2 ]-----------------------
id   | 12
geom | POLYGON((4 1,6 1,6 3,4 3,4 1))""",
        ((0, 0, 4, 4), (4, 1, 6, 3)),
    ),
    Paste(
        "so ask rects",
        """rectangle 1: top left (2, 7), bottom right (9, 3)
rectangle 2: top left (9, 5), bottom right (12, 1)""",
        ((2, 3, 9, 7), (9, 1, 12, 5)),
    ),
    Paste(
        "java fields and ctor",
        """public class Circle {
    double x = 0, y = 0, r = 1;
    Circle(double x, double y, double r) { this.x = x; this.y = y; this.r = r; }
}
Circle a = new Circle(0, 0, 5);
Circle b = new Circle(7, 0, 2);""",
        ((-5, -5, 5, 5), (5, -2, 9, 2)),
    ),
    Paste(
        "csharp autoprops",
        """public class Circle {
    public float X { get; set; } = 0;
    public float Y { get; set; } = 0;
    public float R { get; set; } = 1;
}
var a = new Circle { X = 0, Y = 0, R = 5 };
var b = new Circle { X = 7, Y = 0, R = 2 };""",
        ((-5, -5, 5, 5), (5, -2, 9, 2)),
    ),
    Paste(
        "python dataclass defaults",
        """@dataclass
class Circle:
    x: float = 0
    y: float = 0
    r: float = 1

    def area(self):
        return 3.14 * self.r ** 2

a = Circle(0, 0, 5)
b = Circle(7, 0, 2)""",
        ((-5, -5, 5, 5), (5, -2, 9, 2)),
    ),
    Paste(
        "swift struct methods",
        """struct Circle {
    var x = 0.0
    var y = 0.0
    var r = 1.0
    func overlaps(_ o: Circle) -> Bool {
        return hypot(x - o.x, y - o.y) < r + o.r
    }
}
let a = Circle(x: 0, y: 0, r: 5)
let b = Circle(x: 7, y: 0, r: 2)""",
        ((-5, -5, 5, 5), (5, -2, 9, 2)),
    ),
    Paste(
        "ts class fields",
        """class Rect {
  x = 0;
  y = 0;
  w = 10;
  h = 10;
}
const a = { x: 5, y: 5, w: 20, h: 20 };
const b = { x: 25, y: 5, w: 20, h: 20 };""",
        ((5, 5, 25, 25), (25, 5, 45, 25)),
        as_="corner-size leave-out",
        asks=True,
    ),
    Paste(
        "intersection printed",
        """>>> a = Polygon([(0, 0), (4, 0), (4, 4), (0, 4)])
>>> b = Polygon([(3, 3), (6, 3), (6, 6), (3, 6)])
>>> a.intersection(b)
<POLYGON ((3 4, 4 4, 4 3, 3 3, 3 4))>""",
        ((0, 0, 4, 4), (3, 3, 6, 6)),
        as_="leave-out",
        asks=True,
    ),
    Paste(
        "output below fence",
        """```python
a = Polygon([(0, 0), (4, 0), (4, 4), (0, 4)])
b = Polygon([(3, 3), (6, 3), (6, 6), (3, 6)])
print(a.intersection(b))
```
Output:
```
POLYGON ((3 4, 4 4, 4 3, 3 3, 3 4))
```""",
        ((0, 0, 4, 4), (3, 3, 6, 6)),
        as_="leave-out",
        asks=True,
    ),
    Paste(
        "bounding boxes beside",
        """A: POLYGON((0 0, 4 0, 4 4, 0 0)), bbox [0, 0, 4, 4]
B: POLYGON((4 4, 8 4, 8 8, 4 4)), bbox [4, 4, 8, 8]""",
        ((0, 0, 4, 4), (4, 4, 8, 8)),
        as_="leave-out",
        asks=True,
    ),
    Paste(
        "aabb beside",
        """A vertices: (0, 0), (4, 0), (4, 4); AABB min (0, 0) max (4, 4)
B vertices: (4, 4), (8, 4), (8, 8); AABB min (4, 4) max (8, 8)""",
        ((0, 0, 4, 4), (4, 4, 8, 8)),
        as_="leave-out",
        asks=True,
    ),
    Paste(
        "axes listed",
        """poly1 = [(0,0),(4,0),(4,4)]
poly2 = [(4,4),(8,4),(8,8)]
axes = [(0,1),(1,0),(0.7,-0.7)]""",
        ((0, 0, 4, 4), (4, 4, 8, 8)),
    ),
    Paste(
        "simplex",
        """A = [(0,0),(4,0),(4,4)]
B = [(4,4),(8,4),(8,8)]
simplex = [(-4, 0), (0, 4), (1, 1)]""",
        ((0, 0, 4, 4), (4, 4, 8, 8)),
        as_="leave-out",
        asks=True,
    ),
    Paste(
        "minkowski",
        """A = [(0,0),(4,0),(4,4)]
B = [(4,4),(8,4),(8,8)]
Minkowski difference: (-8,-8), (0,-4), (0, 0), (-4, 0)""",
        ((0, 0, 4, 4), (4, 4, 8, 8)),
        as_="leave-out",
        asks=True,
    ),
    Paste(
        "numbered prose",
        """1) Box A spans from (0,0) to (2,2).
2) Box B spans from (2,1) to (4,3).
Then A.intersects(B) returns true in 3.1 but false in 3.0.""",
        ((0, 0, 2, 2), (2, 1, 4, 3)),
    ),
    Paste(
        "android logcat",
        """03-11 09:12:44.120  1234  1250 D Collision: a=RectF(0.0, 0.0, 10.0, 10.0) b=RectF(10.0, 0.0, 20.0, 10.0)""",
        ((0, 0, 10, 10), (10, 0, 20, 10)),
    ),
    Paste(
        "json lines log",
        """{"t":1710000000.123,"lvl":"info","a":{"x":0,"y":0,"r":2},"b":{"x":4,"y":0,"r":2}}""",
        ((-2, -2, 2, 2), (2, -2, 6, 2)),
        as_="leave-out",
        asks=True,
    ),
    Paste(
        "other keys between those of a circle",
        """a: pos=(0, 0) mass=3 r=10
b: pos=(15, 0), vel=(1, 0), r=6""",
        ((-10, -10, 10, 10), (9, -6, 21, 6)),
    ),
    Paste(
        "speeds between the keys of a circle",
        """10:15:01 entity 7: x=0 y=0 vx=3 vy=1 r=10
10:15:01 entity 9: x=15 y=0 vx=-3 vy=1 r=6""",
        ((-10, -10, 10, 10), (9, -6, 21, 6)),
    ),
    Paste(
        "two circles with keys on one line",
        "c1: x=0 y=0 r=10, c2: x=15 y=0 r=6. dist=15 < 16 so it should hit",
        ((-10, -10, 10, 10), (9, -6, 21, 6)),
    ),
    Paste(
        "a circle as a point and a number",
        "poly (0,0), (4,0), (4,4); circle (5,2), 1.\ncircle [7, 2] r=2",
        ((0, 0, 4, 4), (4, 1, 6, 3), (5, 0, 9, 4)),
    ),
    Paste(
        "a sentence that ends with a radius",
        "One circle is at (3, 4) with a radius of 2 and one is centered at (6, 4) with radius 1.5. They should hit.",
        ((1, 2, 5, 6), (4.5, 2.5, 7.5, 5.5)),
    ),
    Paste(
        "keys in Spanish and French",
        "A: centro=(3, 4), radio=2\nB: centre=(6, 4), rayon=1.5",
        ((1, 2, 5, 6), (4.5, 2.5, 7.5, 5.5)),
    ),
    Paste(
        "flixel",
        "player (x: 10 | y: 10 | w: 16 | h: 16)\ncrate (x: 25 | y: 12 | w: 16 | h: 16)",
        ((10, 10, 26, 26), (25, 12, 41, 28)),
    ),
    Paste(
        "qgis",
        "<QgsRectangle: 0 0, 10 10>\n<QgsRectangle: 8 8, 20 20>",
        ((0, 0, 10, 10), (8, 8, 20, 20)),
    ),
    Paste(
        "postgis",
        """ gid |      box2d
-----+-----------------
   1 | BOX(0 0,10 10)
   2 | BOX(8 8,20 20)
(2 rows)
SELECT 'SRID=4326;POLYGON((4 4, 9 4, 9 9, 4 4))'::geometry;""",
        ((0, 0, 10, 10), (8, 8, 20, 20), (4, 4, 9, 9)),
    ),
    Paste(
        "uikit",
        """<UIView: 0x7f8b2a40; frame = (0 0; 44 44); layer = <CALayer: 0x60000>>
<UIView: 0x7f8b2b80; frame = (40 10; 20 20); layer = <CALayer: 0x60001>>""",
        ((0, 0, 44, 44), (40, 10, 60, 30)),
    ),
    Paste(
        "autocad",
        """                  CIRCLE    Layer: "0"
                   Handle = 1f4
            center point, X=   5.0000  Y=   5.0000  Z=   0.0000
            radius    2.0000
                  CIRCLE    Layer: "0"
                   Handle = 1f5
            center point, X=   8.0000  Y=   5.0000  Z=   0.0000
            radius    1.5000""",
        ((3, 3, 7, 7), (6.5, 3.5, 9.5, 6.5)),
    ),
    Paste(
        "a table with a column of polygons",
        "poly,idx,x,y\nA,0,0,0\nA,1,4,0\nA,2,4,4\nB,0,3,1\nB,1,8,1\nB,2,8,6",
        ((0, 0, 4, 4), (3, 1, 8, 6)),
    ),
    Paste(
        "mathematica",
        "In[3]:= RegionDisjoint[Polygon[{{0, 0}, {4, 0}, {4, 4}}], Disk[{5, 2}, 1]]\nOut[3]= False",
        ((0, 0, 4, 4), (4, 1, 6, 3)),
    ),
    Paste(
        "gdb with pointers",
        """$1 = {center = {x = 1, y = 2}, radius = 3}
$2 = {center = {x = 4, y = 2}, radius = 0.5}
#0  circle_hit (a=0x7fffffffe0a0, b=0x7fffffffe0b0) at collide.c:88""",
        ((-2, -1, 4, 5), (3.5, 1.5, 4.5, 2.5)),
    ),
    Paste(
        "vectors of edges",
        "A edges: (4,0) (0,4) (-4,0) (0,-4)\nA: (2,2) (6,2) (6,6) (2,6)\nB: (3,3) (6,3) (6,6)",
        ((2, 2, 6, 6), (3, 3, 6, 6)),
        as_="leave-out",
        asks=True,
    ),
    Paste(
        "squares in a chat",
        "square from 0,0 to 2,2 and another one from 2,0 to 4,2",
        ((0, 0, 2, 2), (2, 0, 4, 2)),
    ),
    Paste(
        "a shape at a point is not the point",
        "a 3x3 square at the origin and a 2x2 square at (1, 1)",
        (),
    ),
    Paste(
        "a remainder in a call",
        "b2MakeSquare(1.0f % 2)\nb2MakeSquare(2.0f)\nb2MakeBox(1, 1)",
        ((-2, -2, 2, 2), (-1, -1, 1, 1)),
        asks=True,
        as_="leave-out",
    ),
    Paste(
        "entities with numbers",
        """[physics-3] entity#4012 circle pos=(12.5, 8.0) r=2.0 vel=(1.5, 0.0)
[physics-3] entity#4077 circle pos=(15.75, 8.0) r=1.5 vel=(-0.5, 0.0)""",
        ((10.5, 6, 14.5, 10), (14.25, 6.5, 17.25, 9.5)),
    ),
    Paste(
        "rules of css with hyphens",
        """.box-a { left: 10px; top: 20px; width: 100px; height: 50px; }
.box-b { left: 105px; top: 30px; width: 40px; height: 40px; }""",
        ((10, 20, 110, 70), (105, 30, 145, 70)),
    ),
    Paste(
        "a test of GoogleTest",
        """TEST(Aabb, Touch) {
  Circle a{{0, 0}, 2};
  Circle b{{2, 0}, 4};
  EXPECT_TRUE(a.overlaps(b));
}""",
        ((-2, -2, 2, 2), (-2, -4, 6, 4)),
    ),
    Paste(
        "corners of yaml below their key",
        """robot:
  footprint:
    - {x: 0.0, y: 0.0}
    - {x: 4.0, y: 0.0}
    - {x: 4.0, y: 4.0}
wall:
  - [3, 1]
  - [9, 1]
  - [9, 5]""",
        ((0, 0, 4, 4), (3, 1, 9, 5)),
    ),
    Paste(
        "envelopes of postgis",
        "select ST_Overlaps(ST_MakeEnvelope(0, 0, 10, 10, 3857), ST_MakeEnvelope(8, 8, 20, 20, 3857));",
        ((0, 0, 10, 10), (8, 8, 20, 20)),
    ),
    Paste(
        "OpenSCAD, centered",
        "square([4,2], center=true);\ntranslate([2,0]) square([4,2], center=true);",
        ((-2, -1, 2, 1), (0, -1, 4, 1)),
    ),
    Paste(
        "OpenSCAD, one in another module",
        "module a() { polygon([[0,0],[4,0],[4,4]]); }\nmodule b() { translate([3,1,0]) circle(r=2, $fn=64); }",
        ((0, 0, 4, 4), (1, -1, 5, 3)),
    ),
    Paste(
        "OpenSCAD, turned before it is moved",
        "square(2);\ntranslate([5,0]) rotate(90) polygon([[0,0],[4,0],[4,2]]);",
        ((0, 0, 2, 2), (3, 0, 5, 4)),
        as_="corner-size around-origin y-up",
    ),
    Paste(
        "KML in one line",
        "<Polygon><outerBoundaryIs><LinearRing><coordinates>0,0 4,0 4,4 0,0</coordinates></LinearRing></outerBoundaryIs>"
        "</Polygon>\n<Polygon><outerBoundaryIs><LinearRing><coordinates>2,2 6,2 6,6 2,2</coordinates></LinearRing>"
        "</outerBoundaryIs></Polygon>",
        ((0, 0, 4, 4), (2, 2, 6, 6)),
    ),
    Paste(
        "GML with lists of corners",
        '<gml:Polygon><gml:exterior><gml:LinearRing><gml:posList srsDimension="2">0 0 4 0 4 4 0 0</gml:posList>'
        "</gml:LinearRing></gml:exterior></gml:Polygon>\n<gml:Polygon><gml:exterior><gml:LinearRing>"
        "<gml:posList>2 2 6 2 6 6 2 2</gml:posList></gml:LinearRing></gml:exterior></gml:Polygon>",
        ((0, 0, 4, 4), (2, 2, 6, 6)),
    ),
    Paste(
        "GML with an element for each corner",
        "<gml:LinearRing><gml:pos>0 0</gml:pos><gml:pos>4 0</gml:pos><gml:pos>4 4</gml:pos></gml:LinearRing>\n"
        "<gml:LinearRing><gml:pos>2 2</gml:pos><gml:pos>6 2</gml:pos><gml:pos>6 6</gml:pos></gml:LinearRing>",
        (),
    ),
)
