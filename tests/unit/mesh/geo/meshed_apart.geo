// Two stones one upon the other with points and curves of their own: equal divisions, no shared nodes.
// The upper one is drawn clockwise.
Point(1) = {0, 0, 0};
Point(2) = {0.7, 0, 0};
Point(3) = {0.7, 0.3, 0};
Point(4) = {0, 0.3, 0};
Point(11) = {0, 0.30000000001, 0};
Point(12) = {0.7, 0.3, 0};
Point(13) = {0.7, 0.6, 0};
Point(14) = {0, 0.6, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Line(11) = {11, 12};
Line(12) = {12, 13};
Line(13) = {13, 14};
Line(14) = {14, 11};
Curve Loop(1) = {1, 2, 3, 4};
Curve Loop(2) = {-14, -13, -12, -11};
Plane Surface(1) = {1};
Plane Surface(2) = {2};
Transfinite Curve{1, 3, 11, 13} = 6;
Transfinite Curve{2, 4, 12, 14} = 3;
Transfinite Surface{1, 2};
Physical Curve("bed", 1) = {11};
