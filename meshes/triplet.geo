// Three bricks side by side, joined by two mortar joints: the middle one is pushed through. Lengths in metres.
DefineConstant[
  element_size = 0.0105,                     // [m]
  recombine = 0,                             // [-] 1: quadrilaterals
  length = {0.21,  Name "length"},           // [m] of a brick, along the joints
  height = {0.052, Name "height of brick"}   // [m] across the joints
];
For k In {0:3}
  Point(2 * k + 1) = {k * height, 0, 0};
  Point(2 * k + 2) = {k * height, length, 0};
  Line(k + 1) = {2 * k + 1, 2 * k + 2};  // 2 and 3 are the joints
  Transfinite Curve{k + 1} = Round(length / element_size) + 1;
EndFor
For k In {0:2}
  Line(10 + k) = {2 * k + 1, 2 * k + 3};
  Line(20 + k) = {2 * k + 2, 2 * k + 4};
  Transfinite Curve{10 + k, 20 + k} = Round(height / element_size) + 1;
  Curve Loop(k + 1) = {10 + k, k + 2, -(20 + k), -(k + 1)};
  Plane Surface(k + 1) = {k + 1};
  Transfinite Surface{k + 1};
EndFor
If(recombine)
  Recombine Surface{1:3};
EndIf
Physical Curve("left face") = {1};
Physical Curve("right face") = {4};
Physical Curve("feet") = {10, 12};
Physical Curve("head") = {21};
