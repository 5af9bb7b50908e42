// A block on an inclined bed. Everything is turned by the slope about the origin, the lower corner of the joint:
// bed -margin .. width + margin along the slope and `depth` deep, block 0 .. width and `height` high.
DefineConstant[
  element_size = 0.1,  // [m]
  recombine = 0,
  slope = {0.5, Name "tangent of the angle of the incline [-]"},
  width = {1.0, Name "length of the block along the incline [m]"},
  height = {0.5, Name "height of the block [m]"},
  margin = {0.2, Name "bed beyond either end of the block [m]"},
  depth = {0.2, Name "depth of the bed [m]"}
];
c = 1 / Sqrt(1 + slope^2);
s = slope * c;
// Corners along the slope, which falls towards -x: u along it upwards, v away from it.
U() = {-margin, 0, width, width + margin, width + margin, width, 0, -margin, width, 0};
V() = {-depth, -depth, -depth, -depth, 0, 0, 0, 0, height, height};
For i In {0:9}
  Point(i + 1) = {U(i) * c - V(i) * s, U(i) * s + V(i) * c, 0};
EndFor
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 6};
Line(6) = {6, 7};   // the joint
Line(7) = {7, 8};
Line(8) = {8, 1};
Line(9) = {6, 9};
Line(10) = {9, 10};
Line(11) = {10, 7};
Curve Loop(1) = {1, 2, 3, 4, 5, 6, 7, 8};
Curve Loop(2) = {-6, 9, 10, 11};
Plane Surface(1) = {1};
Plane Surface(2) = {2};
Transfinite Curve{2, 6, 10} = Round(width / element_size) + 1;
Transfinite Curve{1, 3, 5, 7} = Ceil(margin / element_size) + 1;
Transfinite Curve{4, 8} = Ceil(depth / element_size) + 1;
Transfinite Curve{9, 11} = Round(height / element_size) + 1;
Transfinite Surface{2};
If(recombine)
  Recombine Surface{1, 2};
EndIf
Physical Surface("bed", 1) = {1};
Physical Surface("block", 2) = {2};
Physical Curve("ground", 3) = {1, 2, 3};
