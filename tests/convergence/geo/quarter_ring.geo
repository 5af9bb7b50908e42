// A quarter of a ring of three stones, inner radius 1 m, outer radius 2 m: inside the first quadrant, symmetric about
// both axes. `element_size` is the radial size of a cell.
DefineConstant[
  element_size = 0.25, // [m]
  recombine = 0
];
n = Round(1 / element_size);
Point(100) = {0, 0, 0};
For k In {0:3}
  a = k * Pi / 6;
  Point(k + 1) = {Cos(a), Sin(a), 0};
  Point(k + 11) = {2 * Cos(a), 2 * Sin(a), 0};
  Line(k + 1) = {k + 1, k + 11};
  Transfinite Curve{k + 1} = n + 1;
EndFor
For k In {0:2}
  Circle(k + 11) = {k + 1, 100, k + 2};
  Circle(k + 21) = {k + 11, 100, k + 12};
  Transfinite Curve{k + 11, k + 21} = n + 1;
  Curve Loop(k + 1) = {k + 1, k + 21, -(k + 2), -(k + 11)};
  Plane Surface(k + 1) = {k + 1};
  Transfinite Surface{k + 1};
EndFor
If(recombine)
  Recombine Surface{1, 2, 3};
EndIf
Physical Curve("on x axis") = {1};
Physical Curve("on y axis") = {4};
Physical Curve("inside") = {11, 12, 13};
