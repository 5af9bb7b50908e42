// The shear wall of T. M. J. Raijmakers, A. Th. Vermeltfoort, TU Eindhoven (1992): sixteen courses of four bricks and a half
// between two courses that are clamped in steel beams. Joints have no thickness: a stone is a brick with half of the mortar
// around it. The beams are stones without joints that stand for the clamped courses. Lengths in metres.
DefineConstant[
  recombine = 0,                               // [-] 1: quadrilaterals
  courses = {16, Name "courses"},              // [-]
  bricks  = {4,  Name "bricks of a course"},   // [-] beside the half one
  length  = {0.22, Name "length"},             // [m] of a brick with a head joint
  height  = {0.0625, Name "height of course"}, // [m] of a brick with a bed joint
  cells   = {4, Name "cells along half a brick"},
  cells_up = {2, Name "cells over its height"}
];
across = 2 * bricks + 1;  // halves of a brick

// Points and curves of a lattice of half bricks: beds from left to right, heads upwards; i + j x (number of columns).
For j In {0:courses}
  For i In {0:across}
    Point(1 + i + j * (across + 1)) = {i * length / 2, j * height, 0};
  EndFor
  For i In {0:across - 1}
    Line(1000 + i + j * (across + 1)) = {1 + i + j * (across + 1), 2 + i + j * (across + 1)};
    Transfinite Curve{1000 + i + j * (across + 1)} = cells + 1;
  EndFor
EndFor
stones() = {};
For j In {0:courses - 1}
  // Odd courses begin with a half brick, the others end with one: heads at odd places, or at even ones.
  heads() = {0};
  For i In {1:across - 1}
    If(i % 2 == j % 2)
      heads() += i;
    EndIf
  EndFor
  heads() += across;
  For k In {0:#heads() - 1}
    i = heads(k);
    Line(5000 + i + j * (across + 1)) = {1 + i + j * (across + 1), 1 + i + (j + 1) * (across + 1)};
    Transfinite Curve{5000 + i + j * (across + 1)} = cells_up + 1;
  EndFor
  For k In {1:#heads() - 1}
    a = heads(k - 1);
    b = heads(k);
    border() = {};
    For i In {a:b - 1}
      border() += 1000 + i + j * (across + 1);
    EndFor
    border() += 5000 + b + j * (across + 1);
    For i In {1:b - a}
      border() += -(1000 + b - i + (j + 1) * (across + 1));
    EndFor
    border() += -(5000 + a + j * (across + 1));
    stone = 1 + #stones();
    Curve Loop(stone) = border();
    Plane Surface(stone) = {stone};
    low = 1 + j * (across + 1);
    high = low + across + 1;
    Transfinite Surface{stone} = {low + a, low + b, high + b, high + a};
    stones() += stone;
  EndFor
EndFor

// Beams below and above.
For k In {0:1}
  y = k * courses * height;
  first = 1 + k * courses * (across + 1);
  Point(9000 + 2 * k) = {0, y + (2 * k - 1) * height, 0};
  Point(9001 + 2 * k) = {across * length / 2, y + (2 * k - 1) * height, 0};
  Line(9100 + 3 * k) = {9000 + 2 * k, 9001 + 2 * k};
  Line(9101 + 3 * k) = {9001 + 2 * k, first + across};
  Line(9102 + 3 * k) = {first, 9000 + 2 * k};
  Transfinite Curve{9100 + 3 * k} = across * cells + 1;
  Transfinite Curve{9101 + 3 * k, 9102 + 3 * k} = cells_up + 1;
  border() = {9100 + 3 * k, 9101 + 3 * k};
  For i In {1:across}
    border() += -(1000 + across - i + k * courses * (across + 1));
  EndFor
  border() += 9102 + 3 * k;
  beam = 1001 + k;
  Curve Loop(beam) = border();
  Plane Surface(beam) = {beam};
  Transfinite Surface{beam} = {9000 + 2 * k, 9001 + 2 * k, first + across, first};
EndFor
If(recombine)
  Recombine Surface{stones(), 1001, 1002};
EndIf
Physical Surface("bricks") = stones();
Physical Surface("lower beam") = {1001};
Physical Surface("upper beam") = {1002};
Physical Curve("base") = {9100};
Physical Curve("top") = {9103};
