// Dry stone walls on rigid ground, the walls 1, 2, 3, 5 and 6 of M. C. Ferris, F. Tin-Loi, Limit analysis of frictional block
// assemblies as a mathematical program with complementarity constraints, Int. J. Mech. Sci. 43 (2001) 209-224.
//
// A course is a list of widths in half stones, from the left to the right: 2 is a stone, 1 half a stone, -2 an opening
// as wide as a stone; 0 ends the course. Courses follow each other from the bottom to the top.
// One plane surface = one stone = one block. Curves are half a stone long, so that courses share them.

DefineConstant[
  wall      = {1,     Name "wall"},         // [-] 1, 2, 3, 5 or 6
  length    = {0.4,   Name "length"},       // [m] of a stone
  height    = {0.175, Name "height"},       // [m]
  cells     = {1,     Name "cells"},        // [-] along half a stone, and up a stone
  recombine = {0,     Name "recombine"}     // [-] 1: quadrilaterals
];

If (wall == 1 || wall == 2)
  h() = {1, 2, 2, 2, 2, 1, 0};
  f() = {2, 2, 2, 2, 2, 0};
  courses() = {h(), f(), h(), f(), h(), f()};
  If (wall == 2)
    courses() = {courses(), h(), f(), h(), f()};
  EndIf
ElseIf (wall == 3)
  a() = {2, 2, 2, 2, 0};
  b() = {1, 2, 2, 2, 1, 0};
  w() = {1, 2, -2, 2, 1, 0};
  v() = {2, 1, -2, 1, 2, 0};
  courses() = {a(), b(), a(), w(), v(), w(), v(), w(), a(), b(), a()};
ElseIf (wall == 5)
  e() = {1, 2, 2, 1, 0};
  u() = {2, 2, 2, 0};
  w() = {2, -2, 2, 0};
  v() = {1, 1, -2, 1, 1, 0};
  courses() = {e(), u(), e(), w(), v(), w(), v(), w(), e(), u(), e(), w(), v(), w(), v(), w(), e(), u(), e()};
ElseIf (wall == 6)
  e() = {1, 2, 2, 2, 2, 2, 2, 1, 0};
  u() = {2, 2, 2, 2, 2, 2, 2, 0};
  w() = {1, 2, -2, 2, 2, -2, 2, 1, 0};
  v() = {2, 1, -2, 1, 2, 1, -2, 1, 2, 0};
  courses() = {e(), u(), e(), u(), w(), v(), w(), v(), w(), u(), e(), u(), w(), v(), w(), v(), w(), u(), e(), u(), e()};
Else
  Error("wall = %g: there are the walls 1, 2, 3, 5 and 6", wall);
  Abort;
EndIf

// Width and height of the lattice of points, in half stones and courses.
across = 0;
up = 0;
For k In {0 : #courses() - 1}
  If (up == 0)
    across += Fabs(courses(k));
  EndIf
  If (courses(k) == 0)
    up += 1;
  EndIf
EndFor

// Points and curves are made when a stone first needs them: tags by place, 0 while they are missing.
points() = {};
beds() = {};
heads() = {};
For k In {0 : (across + 1) * (up + 1) - 1}
  points() += 0;
  beds() += 0;
  heads() += 0;
EndFor

Macro Point_
  at = j * (across + 1) + i;
  If (points(at) == 0)
    tag = newp;
    Point(tag) = {i * length / 2, j * height, 0};
    points(at) = tag;
  EndIf
  point = points(at);
Return

// The bed from (i, j) to (i + 1, j), and the head from (i, j) to (i, j + 1).
Macro Bed
  Call Point_;
  from = point;
  bed_at = at;
  i += 1;
  Call Point_;
  i -= 1;
  If (beds(bed_at) == 0)
    tag = newl;
    Line(tag) = {from, point};
    Transfinite Curve{tag} = cells + 1;
    beds(bed_at) = tag;
  EndIf
  curve = beds(bed_at);
Return

Macro Head
  Call Point_;
  from = point;
  head_at = at;
  j += 1;
  Call Point_;
  j -= 1;
  If (heads(head_at) == 0)
    tag = newl;
    Line(tag) = {from, point};
    Transfinite Curve{tag} = cells + 1;
    heads(head_at) = tag;
  EndIf
  curve = heads(head_at);
Return

stones() = {};
ground_top() = {};
column = 0;
course = 0;
For k In {0 : #courses() - 1}
  width = courses(k);
  If (width > 0)
    border() = {};
    j = course;
    For m In {0 : width - 1}
      i = column + m;
      Call Bed;
      border() += curve;
      If (course == 0)
        ground_top() += curve;
      EndIf
    EndFor
    i = column + width;
    Call Head;
    border() += curve;
    j = course + 1;
    For m In {0 : width - 1}
      i = column + width - 1 - m;
      Call Bed;
      border() += -curve;
    EndFor
    i = column;
    j = course;
    Call Head;
    border() += -curve;
    loop = newll;
    Curve Loop(loop) = border();
    stone = news;
    Plane Surface(stone) = {loop};
    low = course * (across + 1) + column;
    high = low + across + 1;
    Transfinite Surface{stone} = {points(low), points(low + width), points(high + width), points(high)};
    stones() += stone;
  EndIf
  column += Fabs(width);
  If (width == 0)
    column = 0;
    course += 1;
  EndIf
EndFor

// The ground: a slab under the whole wall, held from below.
left = newp;
Point(left) = {0, -height, 0};
right = newp;
Point(right) = {across * length / 2, -height, 0};
down = newl;
Line(down) = {points(0), left};
base = newl;
Line(base) = {left, right};
rise = newl;
Line(rise) = {right, points(across)};
Transfinite Curve{down, rise} = 2;
Transfinite Curve{base} = across * cells + 1;
border() = {down, base, rise};
For m In {1 : #ground_top()}
  border() += -ground_top(#ground_top() - m);
EndFor
loop = newll;
Curve Loop(loop) = border();
ground = news;
Plane Surface(ground) = {loop};
Transfinite Surface{ground} = {left, right, points(across), points(0)};

If (recombine)
  Recombine Surface{stones(), ground};
EndIf
Physical Surface("stones") = stones();
Physical Surface("ground") = {ground};
Physical Curve("base") = {base};
