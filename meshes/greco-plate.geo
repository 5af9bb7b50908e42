// Half of a square plate on a rigid base: plate 0 .. size x 0 .. size, base below it. x = size is the axis of symmetry.
DefineConstant[
  element_size = 0.00125,  // [m]
  recombine = 0,
  size = {0.04, Name "width of half the plate and its height [m]"},
  base = {0.0025, Name "depth of the base [m]"}
];
Point(1) = {0, -base, 0};
Point(2) = {size, -base, 0};
Point(3) = {size, 0, 0};
Point(4) = {size, size, 0};
Point(5) = {0, size, 0};
Point(6) = {0, 0, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 6};   // the joint
Line(4) = {6, 1};
Line(5) = {3, 4};
Line(6) = {4, 5};
Line(7) = {5, 6};
Curve Loop(1) = {1, 2, 3, 4};
Curve Loop(2) = {-3, 5, 6, 7};
Plane Surface(1) = {1};
Plane Surface(2) = {2};
Transfinite Curve{1, 3, 5, 6, 7} = Round(size / element_size) + 1;
Transfinite Curve{2, 4} = Round(base / element_size) + 1;
Transfinite Surface{1, 2};
If(recombine)
  Recombine Surface{1, 2};
EndIf
Physical Surface("base", 1) = {1};
Physical Surface("plate", 2) = {2};
Physical Curve("ground", 3) = {1};
Physical Curve("symmetry", 4) = {5};
Physical Curve("top", 5) = {6};
Physical Curve("side", 6) = {7};
