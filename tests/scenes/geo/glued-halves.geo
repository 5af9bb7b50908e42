// Two halves of a beam, 1 m long and 0.3 m deep each, that are glued where they meet, with `cells` cells along the joint.
DefineConstant[ cells = 3, recombine = 0 ];
Point(1) = {0, 0, 0};
Point(2) = {1, 0, 0};
Point(3) = {1, 0.3, 0};
Point(4) = {0, 0.3, 0};
Point(5) = {2, 0, 0};
Point(6) = {2, 0.3, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Line(5) = {2, 5};
Line(6) = {5, 6};
Line(7) = {6, 3};
Transfinite Curve{1, 3, 5, 7} = 3 * cells + 1;
Transfinite Curve{2, 4, 6} = cells + 1;
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Transfinite Surface{1} = {1, 2, 3, 4};
Curve Loop(2) = {5, 6, 7, -2};
Plane Surface(2) = {2};
Transfinite Surface{2} = {2, 5, 6, 3};
If(recombine)
  Recombine Surface{1:2};
EndIf
Physical Curve("held") = {4};
Physical Curve("end") = {6};
Physical Surface("inner") = {1};
Physical Surface("outer") = {2};
