// Two stones side by side that share a curve: west 0 .. width, east width .. width + 1, both 1 m high.
DefineConstant[
  element_size = 0.5,  // [m]
  recombine = 0,
  width = {1, Name "width of the stone in the west"}
];
Point(1) = {0, 0, 0, element_size};
Point(2) = {width, 0, 0, element_size};
Point(3) = {width + 1, 0, 0, element_size};
Point(4) = {width + 1, 1, 0, element_size};
Point(5) = {width, 1, 0, element_size};
Point(6) = {0, 1, 0, element_size};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 6};
Line(6) = {6, 1};
Line(7) = {2, 5};
Curve Loop(1) = {1, 7, 5, 6};
Curve Loop(2) = {2, 3, 4, -7};
Plane Surface(17) = {1};
Plane Surface(4) = {2};
If(recombine)
  Recombine Surface{17, 4};
EndIf
Physical Surface("west", 2) = {17};
Physical Surface(7) = {4};
Physical Surface("both", 9) = {17, 4};
Physical Curve("base", 1) = {1, 2};
Physical Curve("joint", 5) = {7};
