// Three irregular stones that fill a rectangle of 2 m x 1.5 m, turned by `angle` about the origin.
// The lower stone carries two; their joint leans. Normals of joints are at most 14 degrees off the axes.
DefineConstant[
  element_size = 0.25, // [m]
  recombine = 0,
  angle = {0, Name "rotation of the whole, in degrees"},
  structured = {0, Name "1: the same cells whatever the angle"}
];
c = Cos(angle * Pi / 180);
s = Sin(angle * Pi / 180);
x() = {0, 2, 2, 0.9, 0, 0, 1.1, 2};
y() = {0, 0, 0.8, 0.69, 0.6, 1.5, 1.5, 1.5};
For k In {0:7}
  Point(k + 1) = {c * x(k) - s * y(k), s * x(k) + c * y(k), 0, element_size};
EndFor
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 1};
Line(6) = {5, 6};
Line(7) = {6, 7};
Line(8) = {7, 4};
Line(9) = {3, 8};
Line(10) = {8, 7};
Curve Loop(1) = {1, 2, 3, 4, 5};
Curve Loop(2) = {-4, -8, -7, -6};
Curve Loop(3) = {-3, 9, 10, 8};
Plane Surface(1) = {1};
Plane Surface(2) = {2};
Plane Surface(3) = {3};
If(structured)
  Transfinite Curve{1} = 9;
  Transfinite Curve{2, 3, 4, 5, 6, 7, 8, 9, 10} = 5;
  Transfinite Surface{1} = {1, 2, 3, 5};
  Transfinite Surface{2} = {5, 4, 7, 6};
  Transfinite Surface{3} = {4, 3, 8, 7};
EndIf
If(recombine)
  Recombine Surface{1, 2, 3};
EndIf
Physical Curve("bottom") = {1};
Physical Curve("right") = {2, 9};
Physical Curve("top") = {7, 10};
Physical Curve("left") = {5, 6};
