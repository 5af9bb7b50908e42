// A circular arch of equal voussoirs between two abutments, which are blocks too: its springings are joints.

DefineConstant[
  radius    = {10,    Name "radius"},     // [m] of the middle line
  thickness = {1.5,   Name "thickness"},  // [m] radial
  embrace   = {157.5, Name "embrace"},    // [degree]
  voussoirs = {7,     Name "voussoirs"},
  radial    = {2,     Name "radial"},     // [-] cells through the thickness
  along     = {4,     Name "along"},      // [-] cells along a voussoir
  depth     = {0.5,   Name "depth"},      // [m] of the abutments, away from the arch
  recombine = {0,     Name "recombine"}   // [-] 1: quadrilaterals
];

// Joints from the right springing to the left one: a point at the intrados, one at the extrados, a curve between.
centre = newp;
Point(centre) = {0, 0, 0};
intrados() = {};
extrados() = {};
joints() = {};
For k In {0 : voussoirs}
  angle = Pi / 2 + (k / voussoirs - 0.5) * embrace * Pi / 180;
  For side In {0 : 1}
    r = radius + (side - 0.5) * thickness;
    tag = newp;
    Point(tag) = {r * Cos(angle), r * Sin(angle), 0};
    If (side == 0)
      intrados() += tag;
    Else
      extrados() += tag;
    EndIf
  EndFor
  curve = newl;
  Line(curve) = {intrados(k), extrados(k)};
  Transfinite Curve{curve} = radial + 1;
  joints() += curve;
EndFor

ring() = {};
outside() = {};
For k In {0 : voussoirs - 1}
  inner = newl;
  Circle(inner) = {intrados(k), centre, intrados(k + 1)};
  outer = newl;
  Circle(outer) = {extrados(k), centre, extrados(k + 1)};
  Transfinite Curve{inner, outer} = along + 1;
  loop = newll;
  Curve Loop(loop) = {joints(k), outer, -joints(k + 1), -inner};
  stone = news;
  Plane Surface(stone) = {loop};
  Transfinite Surface{stone} = {intrados(k), extrados(k), extrados(k + 1), intrados(k + 1)};
  ring() += stone;
  outside() += outer;
EndFor

// Abutments: from the springings away, at right angles to them.
abutments() = {};
ground() = {};
For end In {0 : 1}
  k = end * voussoirs;
  way = 2 * end - 1;
  angle = Pi / 2 + (k / voussoirs - 0.5) * embrace * Pi / 180;
  dx = -way * Sin(angle) * depth;
  dy = way * Cos(angle) * depth;
  far() = {};
  For side In {0 : 1}
    r = radius + (side - 0.5) * thickness;
    tag = newp;
    Point(tag) = {r * Cos(angle) + dx, r * Sin(angle) + dy, 0};
    far() += tag;
  EndFor
  below = newl;
  Line(below) = {intrados(k), far(0)};
  held = newl;
  Line(held) = {far(0), far(1)};
  above = newl;
  Line(above) = {far(1), extrados(k)};
  Transfinite Curve{below, above} = 2;
  Transfinite Curve{held} = radial + 1;
  loop = newll;
  Curve Loop(loop) = {below, held, above, -joints(k)};
  stone = news;
  Plane Surface(stone) = {loop};
  Transfinite Surface{stone} = {intrados(k), far(0), far(1), extrados(k)};
  abutments() += stone;
  ground() += held;
EndFor

If (recombine)
  Recombine Surface{ring(), abutments()};
EndIf
Physical Surface("ring") = ring();
Physical Surface("abutments") = abutments();
Physical Curve("ground") = ground();
Physical Curve("extrados") = outside();
