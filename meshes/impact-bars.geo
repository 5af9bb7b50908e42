// Two bars end to end along x: the left one -left .. 0, the right one 0 .. right, both `height` high.
DefineConstant[
  element_size = 0.02,  // [m] along the bars
  recombine = 1,
  left = {1.0, Name "length of the left bar [m]"},
  right = {1.0, Name "length of the right bar [m]"},
  height = {0.02, Name "height of both bars, one cell [m]"}
];
X() = {-left, 0, right, right, 0, -left};
Y() = {0, 0, 0, height, height, height};
For i In {0:5}
  Point(i + 1) = {X(i), Y(i), 0};
EndFor
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 6};
Line(6) = {6, 1};
Line(7) = {2, 5};  // the joint
Curve Loop(1) = {1, 7, 5, 6};
Curve Loop(2) = {2, 3, 4, -7};
Plane Surface(1) = {1};
Plane Surface(2) = {2};
Transfinite Curve{1, 5} = Round(left / element_size) + 1;
Transfinite Curve{2, 4} = Round(right / element_size) + 1;
Transfinite Curve{3, 6, 7} = 2;
Transfinite Surface{1, 2};
If(recombine)
  Recombine Surface{1, 2};
EndIf
Physical Surface("left bar", 1) = {1};
Physical Surface("right bar", 2) = {2};
Physical Curve("left end", 3) = {6};
Physical Curve("right end", 4) = {3};
Physical Curve("sides", 5) = {1, 2, 4, 5};
Physical Curve("left bar but its face", 6) = {1, 5, 6};
