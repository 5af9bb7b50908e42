// Two stones one upon the other, each width x height, turned by `angle` about the origin.
DefineConstant[
  element_size = 0.25, // [m]
  recombine = 1,
  width = 1, // [m]
  height = 1, // [m] of each
  angle = {0, Name "rotation of the whole, in degrees"}
];
c = Cos(angle * Pi / 180);
s = Sin(angle * Pi / 180);
For k In {0:2}
  Point(2 * k + 1) = {-s * k * height, c * k * height, 0};
  Point(2 * k + 2) = {c * width - s * k * height, s * width + c * k * height, 0};
  Line(k + 1) = {2 * k + 1, 2 * k + 2};
  Transfinite Curve{k + 1} = Round(width / element_size) + 1;
EndFor
For k In {0:1}
  Line(2 * k + 11) = {2 * k + 1, 2 * k + 3};
  Line(2 * k + 12) = {2 * k + 2, 2 * k + 4};
  Transfinite Curve{2 * k + 11, 2 * k + 12} = Round(height / element_size) + 1;
  Curve Loop(k + 1) = {k + 1, 2 * k + 12, -(k + 2), -(2 * k + 11)};
  Plane Surface(k + 1) = {k + 1};
  Transfinite Surface{k + 1};
EndFor
If(recombine)
  Recombine Surface{1, 2};
EndIf
Physical Curve("bottom") = {1};
Physical Curve("top") = {3};
