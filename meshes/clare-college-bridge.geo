// Clare College Bridge, Cambridge (1640): elevation of the facade, stone by stone.
//
//   three segmental arches on two river piers and two abutments; x [m] to the east, y [m] up,
//   x = 0 at the crown of the central arch, y = 0 at the springing of the central arch.
//   One plane surface = one stone = one block. Neighbours share the points and curves of their
//   common border, so nodes coincide and one curve lies between each pair of T-junctions.
//
// Sources     [published] Mihai and Ainsworth, Comput. Methods Appl. Mech. Eng. (2009): central span,
//             voussoir length, facade 0.20 m thick (out of plane: set in the scene, not here);
//             21 ft side arches and 75 ft over arches and piers are published dimensions too.
//             [derived] follows from published figures. [assumed] is ours; meshes/README.md has the table.
//
// How it is laid
//   1 levels    beds n = 0, 1, ... are horizontal, course n lies between bed n and bed n + 1; bed "datum" is
//               the top of the springers. A bed that meets the extrados steeply ends on it; where
//               the meeting would be sharper than min_angle the bed stops at a vertical joint while
//               there are still min_height between it and the extrados. The road is treated alike.
//   2 heads     head joints of all courses lie on one lattice, shifted by half a stone from course to course
//               (running bond); a stone shorter than `remnant` is joined with its neighbour.
//   3 points    on beds, extrados and road, sorted by x, so that every T-junction is known to both sides.
//   4 stones    each walks its border: bottom, right, top, left.
// The deformed state moves the points (macro NewPoint) and changes nothing else.

// ------------------------------------------------------------------------------------------ parameters
DefineConstant[
  // mesh
  element_size      = {0.125, Name "element_size"},      // [m] wanted edge of a cell: 0.25 (one cell across a voussoir) to 0.03
  recombine         = {0,     Name "recombine"},         // [-] 0 triangles, 1 quadrilaterals (triangles where none fits)
  // arches
  span_central      = {6.72,  Name "span_central"},      // [m] [published]
  span_side         = {6.40,  Name "span_side"},         // [m] [published] 21 ft
  length_over_piers = {22.86, Name "length_over_piers"}, // [m] [published] 75 ft over three arches and two piers
  rise_central      = {2.00,  Name "rise_central"},      // [m] [assumed] intrados above springing
  rise_side         = {1.90,  Name "rise_side"},         // [m] [assumed] slightly lower than the central arch
  ring_depth        = {0.40,  Name "ring_depth"},        // [m] [assumed]
  voussoir_length   = {0.25,  Name "voussoir_length"},   // [m] [published] along the intrados; the odd number of voussoirs follows
  // piers, abutments, road
  pier_height       = {2.00,  Name "pier_height"},       // [m] [assumed] springing to foundation, rounded to whole courses
  pier_batter       = {0.04,  Name "pier_batter"},       // [-] [assumed] widening of each face per height, below the springers
  abutment_height   = {1.40,  Name "abutment_height"},   // [m] [assumed] springing to foundation, rounded to whole courses
  abutment_length   = {2.00,  Name "abutment_length"},   // [m] [assumed] behind the springing
  springer_tail     = {0.20,  Name "springer_tail"},     // [m] [assumed] flat top of the springer (skewback stone) behind the ring
  cover             = {0.50,  Name "cover"},             // [m] [assumed] road above the extrados at the central crown
  road_fall         = {0.40,  Name "road_fall"},         // [m] [assumed] fall of the parabolic road from the middle to either end
  // bond
  course_height     = {0.20,  Name "course_height"},     // [m] [assumed]
  stone_length      = {0.45,  Name "stone_length"},      // [m] [assumed] rounded so that both piers have the same bond
  // rules against slivers
  min_angle         = {30,    Name "min_angle"},         // [deg] [assumed] sharpest meeting of a bed with the extrados
  min_height        = {0.10,  Name "min_height"},        // [m] [assumed] least height of a stone below road or above extrados
  remnant           = {0.20,  Name "remnant"},           // [m] [assumed] ashlar shorter than this is joined with its neighbour
  stagger           = {0.11,  Name "stagger"},           // [m] [assumed] least distance of head joints of two courses along their bed
  snap              = {0.07,  Name "snap"},              // [m] [assumed] least distance of a T-junction from a ring joint, else they meet
  // today's state: 0 as built, 1 deformed; a fraction is a fraction of the movement
  deformed          = {0,     Name "deformed"},          // [-]
  pier_settlement   = {0.05,  Name "pier_settlement"},   // [m] [assumed] west pier, down
  pier_tilt         = {1.0,   Name "pier_tilt"},         // [deg] [assumed] west pier about its foundation, top to the west
  abutment_shift    = {0.08,  Name "abutment_shift"},    // [m] [assumed] west abutment, to the west
  crown_drop        = {0.10,  Name "crown_drop"},        // [m] [assumed] crown of the central arch, down
  crown_drop_west   = {0.08,  Name "crown_drop_west"}    // [m] [assumed] crown of the west arch, down
];

eps = 1e-6;                                              // [m] two coordinates closer than this are one
pier_width = (length_over_piers - span_central - 2 * span_side) / 2; // [m] [derived] 1.67 at the springing

// Arches j = 0 west, 1 central, 2 east. All springers end at one level, `springer_top`, so side
// arches spring a little above or below the central one when their angles differ (by 1 mm here).
x_pier = (span_central + pier_width) / 2;                // [m] [derived] pier centres at -x_pier, x_pier
x_side = span_central / 2 + pier_width + span_side / 2;  // [m] [derived] crowns of the side arches
x_back = length_over_piers / 2 + abutment_length;        // [m] [derived] rear faces at -x_back, x_back
XC() = {-x_side, 0, x_side};                             // crown and centre, x
SPAN() = {span_side, span_central, span_side};
RISE() = {rise_side, rise_central, rise_side};
YC() = {}; YS() = {}; RI() = {}; RE() = {}; HALF() = {}; NV() = {};
For j In {0:2}
  RI(j) = (SPAN(j)^2 / 4 + RISE(j)^2) / (2 * RISE(j));   // radius of the intrados
  RE(j) = RI(j) + ring_depth;                            // radius of the extrados
  HALF(j) = Asin(SPAN(j) / 2 / RI(j));                   // half the opening angle
  NV(j) = 2 * Floor(RI(j) * HALF(j) / voussoir_length) + 1; // nearest odd number of voussoirs
  If (RISE(j) >= SPAN(j) / 2)
    Error("rise must be less than half the span: the arches are segments of a circle");
    Abort;
  EndIf
EndFor
springer_top = RE(1) * Cos(HALF(1)) - RI(1) * Cos(HALF(1));
For j In {0:2}
  YC(j) = springer_top - RE(j) * Cos(HALF(j));
  YS(j) = YC(j) + RI(j) * Cos(HALF(j));
EndFor
road_top = rise_central + ring_depth + cover;            // [m] road at x = 0

// Road level at x: road_top - road_fall (x / x_back)^2. Both crowns must carry two courses.
If (road_top - road_fall * (x_side / x_back)^2 - YC(0) - RE(0) < course_height + 2 * min_height || cover < course_height + 2 * min_height)
  Error("cover above a crown is less than course_height + 2 min_height: raise cover or lower road_fall");
  Abort;
EndIf

// ------------------------------------------------------------------------------------------ 1 levels
n_springer = Ceil((springer_top - YS(1)) / course_height + 0.5);      // courses a springer takes up
n_pier = Round((pier_height + springer_top) / course_height);         // courses below the datum
n_abutment = Round((abutment_height + springer_top) / course_height);
datum = n_pier;
If (n_abutment > n_pier)
  datum = n_abutment;
EndIf
NF() = {datum - n_abutment, datum - n_pier, datum - n_pier, datum - n_abutment}; // lowest bed west to east
springer_bed = datum - n_springer;                                    // underside of the springers
pitch = (span_central + pier_width) / Round((span_central + pier_width) / stone_length); // [m] [derived] stone length
// Topmost course: the bed below it is at least three half stones long on either side of x = 0.
top = datum + Floor((road_top - min_height - road_fall * (1.5 * pitch / x_back)^2 - springer_top) / course_height);

Y() = {};
For n In {0:top + 1}
  Y(n) = springer_top + (n - datum) * course_height;
EndFor

// x of a point of extrados ej, moved to a ring joint or to `snap` from it when closer than that.
Macro SnapToRing
  ring_step = 2 * HALF(ej) / NV(ej);
  ring_at = (Asin((ex - XC(ej)) / RE(ej)) + HALF(ej)) / ring_step;
  ring_off = (ring_at - Round(ring_at)) * ring_step * RE(ej);         // [m] along the extrados
  If (Fabs(ring_off) < snap)
    ring_to = 0;
    If (ring_off > snap / 2)
      ring_to = snap;
    ElseIf (ring_off < -snap / 2)
      ring_to = -snap;
    EndIf
    ex = XC(ej) + RE(ej) * Sin(-HALF(ej) + Round(ring_at) * ring_step + ring_to / RE(ej));
  EndIf
Return

// What interrupts bed n at arch j, index 3 n + j: OPEN 1 if anything does, EL and ER the ends of the bed
// to the left and right of the gap, FLAT 1 if it stops at a vertical joint above the extrados.
OPEN() = {}; EL() = {}; ER() = {}; FLAT() = {};
SB() = {};                                                            // backs of the springers, two per arch
For j In {0:2}
  SB(2 * j) = XC(j) - RE(j) * Sin(HALF(j)) - springer_tail;
  SB(2 * j + 1) = XC(j) + RE(j) * Sin(HALF(j)) + springer_tail;
EndFor
For n In {0:top + 1}
  For j In {0:2}
    OPEN(3 * n + j) = 1;
    FLAT(3 * n + j) = 0;
    half_gap = RE(j) * Sin(HALF(j));                                  // the datum bed ends at the ring
    above = Y(n) - YC(j);
    If (n > datum)
      If (above > RE(j) + 0.8 * min_height)                           // 0.8: no gap shorter than a stone
        OPEN(3 * n + j) = 0;
      Else
        ej = j;
        If (above < RE(j) * Cos(min_angle * Pi / 180))
          ex = XC(j) + Sqrt(RE(j)^2 - above^2);
        Else
          FLAT(3 * n + j) = 1;
          ex = XC(j) + Sqrt(RE(j)^2 - (above - min_height)^2);
        EndIf
        Call SnapToRing;
        half_gap = ex - XC(j);
      EndIf
    ElseIf (n < datum && n > springer_bed)
      half_gap = SB(2 * j + 1) - XC(j);
    ElseIf (n <= springer_bed)
      half_gap = SPAN(j) / 2;
    EndIf
    EL(3 * n + j) = XC(j) - half_gap;
    ER(3 * n + j) = XC(j) + half_gap;
    If (n < springer_bed)                                             // only piers have a batter
      If (j > 0)
        EL(3 * n + j) += pier_batter * (Y(springer_bed) - Y(n));
      EndIf
      If (j < 2)
        ER(3 * n + j) -= pier_batter * (Y(springer_bed) - Y(n));
      EndIf
    EndIf
  EndFor
EndFor

// ------------------------------------------------------------------------------------------ 2 heads
// Stones of course n: SL, SR their ends along the top, SLB, SRB along the bottom, SG the body between
// two arches they stand in (0 west abutment .. 3 east abutment). H: head joints. WE, EE: ends of bed n.
WE() = {-x_back}; EE() = {x_back};

// A head joint at hx of course n: near a ring joint it snaps, near a head joint below it moves away.
Macro PlaceHead
  lands = 0;
  If (n >= datum)
    For j2 In {0:2}
      If (OPEN(3 * n + j2) && hx > EL(3 * n + j2) && hx < ER(3 * n + j2))
        lands = 1;
        ej = j2;
        ex = hx;
        Call SnapToRing;
        hx = ex;
      EndIf
    EndFor
  EndIf
  If (!lands)
    For i2 In {0:#below() - 1}
      If (Fabs(hx - below(i2)) < stagger - eps)
        If (hx - below(i2) > eps || (Fabs(hx - below(i2)) <= eps && hx > 0))
          hx = below(i2) + stagger;
        Else
          hx = below(i2) - stagger;
        EndIf
      EndIf
    EndFor
  EndIf
Return

// Cut course n into stones from ia to ib; remnants are measured from iar and ibr, iab and ibb are at the bottom.
Macro CutInterval
  heads() = {};
  last = iar;
  For i In {Ceil((iar + remnant - offset) / pitch - eps):Floor((ibr - remnant - offset) / pitch + eps)}
    hx = offset + i * pitch;
    Call PlaceHead;
    If (hx - last > 0.8 * remnant && ibr - hx > 0.8 * remnant)
      heads() += hx;
      last = hx;
    EndIf
  EndFor
  If (#heads() == 0 && ibr - iar > 1.5 * pitch)
    hx = (iar + ibr) / 2;
    Call PlaceHead;
    heads() += hx;
  EndIf
  H~{n}() += ia;
  SL~{n}() += ia;
  SLB~{n}() += iab;
  For i In {0:#heads() - 1}
    H~{n}() += heads(i);
    SL~{n}() += heads(i);
    SLB~{n}() += heads(i);
    SR~{n}() += heads(i);
    SRB~{n}() += heads(i);
    SG~{n}() += body;
  EndFor
  H~{n}() += ib;
  SR~{n}() += ib;
  SRB~{n}() += ibb;
  SG~{n}() += body;
Return

For n In {0:top}
  H~{n}() = {}; SL~{n}() = {}; SR~{n}() = {}; SLB~{n}() = {}; SRB~{n}() = {}; SG~{n}() = {};
  offset = Fmod(n, 2) * pitch / 2;
  below() = {};
  If (n > 0)
    below() = H~{n - 1}();
  EndIf
  If (n == springer_bed - 1)
    below() += SB();                                                  // the springers above cannot give way
  EndIf

  ia = WE(n); iab = ia; iar = ia;
  For body In {0:3}
    j = body;                                                         // the arch to the east of this body
    m = 3 * n + j;                                                    // its gap in the bed below this course
    t = 3 * (n + 1) + j;                                              // its gap in the bed above
    If (body == 3)
      ib = EE(n); ibb = ib; ibr = ib;
      If (n >= NF(3))
        Call CutInterval;
      EndIf
    ElseIf (n < datum)                                                // pier or abutment, up to its face or the springer
      If (n >= springer_bed)
        ib = SB(2 * j); ibb = ib; ibr = ib;
        next_a = SB(2 * j + 1); next_ab = next_a;
      Else
        ib = EL(t); ibb = EL(m); ibr = EL(t);
        next_a = ER(t); next_ab = ER(m);
      EndIf
      If (n >= NF(body))
        Call CutInterval;
      EndIf
      ia = next_a; iab = next_ab; iar = next_a;
    ElseIf (OPEN(m) && OPEN(t) && FLAT(m))                            // both beds stop short of the extrados
      ib = EL(m); ibb = ib; ibr = ib;
      Call CutInterval;
      ia = EL(m); iab = ia; iar = ia; ib = EL(t); ibb = ib; ibr = ib;
      Call CutInterval;
      ia = ER(t); iab = ia; iar = ia; ib = ER(m); ibb = ib; ibr = ib;
      Call CutInterval;
      ia = ER(m); iab = ia; iar = ia;
    ElseIf (OPEN(m) && OPEN(t))                                       // the course is cut by the extrados
      ib = EL(t); ibb = ib; ibr = EL(m);
      Call CutInterval;
      ia = ER(t); iab = ia; iar = ER(m);
    ElseIf (OPEN(m))                                                  // the course closes over the crown
      ib = EL(m); ibb = ib; ibr = ib;
      Call CutInterval;
      ia = EL(m); iab = ia; iar = ia; ib = ER(m); ibb = ib; ibr = ib;
      Call CutInterval;
      ia = ER(m); iab = ia; iar = ia;
    EndIf
  EndFor

  // Where does the next bed run out under the road? At the outermost head joint with min_height above it.
  WE(n + 1) = -x_back; EE(n + 1) = x_back;
  If (n == top)
    WE(n + 1) = 2 * x_back; EE(n + 1) = -2 * x_back;                  // there is none: the road is above all stones
  ElseIf (road_top - road_fall - min_height < Y(n + 1))
    reach = x_back * Sqrt((road_top - min_height - Y(n + 1)) / road_fall);
    WE(n + 1) = x_back; EE(n + 1) = -x_back;
    For i In {0:#H~{n}() - 1}
      hx = H~{n}(i);
      If (hx >= -reach && hx < WE(n + 1))
        WE(n + 1) = hx;
      EndIf
      If (hx <= reach && hx > EE(n + 1))
        EE(n + 1) = hx;
      EndIf
    EndFor
  EndIf
EndFor

// ------------------------------------------------------------------------------------------ 3 points
// As built: PX, PY, and PT: 0 inside, 1 road, 2 + body underside of a foundation. Point 0 does not exist.
PX() = {0}; PY() = {0}; PT() = {0};

// A new point p at (x, y) as built, of kind pt, moved to where it is today. Rigid: west abutment, west pier
// (turned about the middle of its foundation), everything east of the central arch. Between them an arch takes a
// smooth mean of the movements of its two supports, s = t^2 (3 - 2 t), and a sag b 16 t^2 (1 - t)^2; t runs from 0 to 1
// across the span; s and the sag leave the springings with zero slope.
tilt = deformed * pier_tilt * Pi / 180;
y_turn = Y(NF(1));
Macro NewPoint
  PX() += x; PY() += y; PT() += pt;
  p = #PX() - 1;
  xa = -deformed * abutment_shift; ya = 0;                            // movement of the west abutment
  xp = (x + x_pier) * (Cos(tilt) - 1) - (y - y_turn) * Sin(tilt);     // and of the west pier, both at this point
  yp = (x + x_pier) * Sin(tilt) + (y - y_turn) * (Cos(tilt) - 1) - deformed * pier_settlement;
  xr = 0; yr = 0; dx = 0; dy = 0;                                     // everything east stays
  If (x <= XC(0) - span_side / 2)
    dx = xa; dy = ya;
  ElseIf (x < XC(0) + span_side / 2)
    t = (x - XC(0)) / span_side + 0.5;
    s = t * t * (3 - 2 * t);
    sag = -deformed * crown_drop_west - 0.5 * (span_side / 2 + pier_width / 2) * -Sin(tilt) + 0.5 * deformed * pier_settlement;
    dx = (1 - s) * xa + s * xp;
    dy = (1 - s) * ya + s * yp + sag * 16 * t^2 * (1 - t)^2;
  ElseIf (x <= -span_central / 2)
    dx = xp; dy = yp;
  ElseIf (x < span_central / 2)
    t = x / span_central + 0.5;
    s = t * t * (3 - 2 * t);
    sag = -deformed * crown_drop - 0.5 * x_pier * Sin(tilt) + 0.5 * deformed * pier_settlement;
    dx = (1 - s) * xp + s * xr;
    dy = (1 - s) * yp + s * yr + sag * 16 * t^2 * (1 - t)^2;
  EndIf
  Point(p) = {x + dx, y + dy, 0, element_size};
Return

// sorted(): the numbers of raw() in order, each once.
Macro Sort
  ordered() = Unique[raw()];
  sorted() = {};
  For i In {0:#ordered() - 1}
    If (i == 0)
      sorted() += ordered(i);
    ElseIf (ordered(i) - sorted(#sorted() - 1) > eps)
      sorted() += ordered(i);
    EndIf
  EndFor
Return

// Rings: IP the points of the intrados, joint by joint; RX, RP the extrados with every bed and head that meets it.
pt = 0;
For j In {0:2}
  IP~{j}() = {}; RX~{j}() = {}; RP~{j}() = {}; JX~{j}() = {};
  raw() = {};
  For i In {0:NV(j)}
    a = -HALF(j) + i * 2 * HALF(j) / NV(j);
    x = XC(j) + RI(j) * Sin(a);
    y = YC(j) + RI(j) * Cos(a);
    Call NewPoint;
    IP~{j}() += p;
    raw() += XC(j) + RE(j) * Sin(a);
    JX~{j}() += XC(j) + RE(j) * Sin(a);
  EndFor
  For n In {datum:top}
    If (OPEN(3 * n + j))
      raw() += EL(3 * n + j);
      raw() += ER(3 * n + j);
      For i In {0:#H~{n}() - 1}
        hx = H~{n}(i);
        If (hx > EL(3 * n + j) && hx < ER(3 * n + j))
          raw() += hx;
        EndIf
      EndFor
    EndIf
  EndFor
  Call Sort;
  RX~{j}() = sorted();
  For i In {0:#sorted() - 1}
    x = sorted(i);
    y = YC(j) + Sqrt(RE(j)^2 - (x - XC(j))^2);
    Call NewPoint;
    RP~{j}() += p;
  EndFor
EndFor

// Beds: BX, BP. Ends on an extrados are points of that extrados.
For n In {0:top}
  raw() = {};
  If (n > 0)
    raw() += SL~{n - 1}();
    raw() += SR~{n - 1}();
  EndIf
  raw() += SLB~{n}();
  raw() += SRB~{n}();
  For j In {0:2}
    If (OPEN(3 * n + j))
      If (n >= NF(j))
        raw() += EL(3 * n + j);
      EndIf
      If (n >= NF(j + 1))
        raw() += ER(3 * n + j);
      EndIf
    EndIf
  EndFor
  Call Sort;
  BX~{n}() = {}; BP~{n}() = {};
  For i In {0:#sorted() - 1}
    x = sorted(i);
    y = Y(n);
    inside = x > WE(n) - eps && x < EE(n) + eps;
    pt = 0;
    p = 0;
    body = 0;
    For j In {0:2}
      If (OPEN(3 * n + j))
        If (x > EL(3 * n + j) + eps && x < ER(3 * n + j) - eps)
          inside = 0;
        EndIf
        If (n >= datum && !FLAT(3 * n + j) && (Fabs(x - EL(3 * n + j)) < eps || Fabs(x - ER(3 * n + j)) < eps))
          For k In {0:#RX~{j}() - 1}
            If (Fabs(RX~{j}(k) - x) < eps)
              p = RP~{j}(k);
            EndIf
          EndFor
        EndIf
        If (x > XC(j))
          body = j + 1;
        EndIf
      EndIf
    EndFor
    If (inside)
      If (p == 0)
        If (n == NF(body))
          pt = 2 + body;
        EndIf
        Call NewPoint;
      EndIf
      BX~{n}() += x;
      BP~{n}() += p;
    EndIf
  EndFor
EndFor

// Road: TX, TP. A point is added at the middle of the bridge and of each pier, where the deck groups part, unless a
// joint is near.
raw() = {-x_back, x_back};
For n In {datum:top}
  For i In {0:#H~{n}() - 1}
    hx = H~{n}(i);
    If ((hx < WE(n + 1) + eps || hx > EE(n + 1) - eps) && hx > WE(n) - eps && hx < EE(n) + eps)
      raw() += hx;
    EndIf
  EndFor
EndFor
For k In {-1:1}
  near = 0;
  For i In {0:#raw() - 1}
    near = near || Fabs(raw(i) - k * x_pier) < stagger;
  EndFor
  If (!near)
    raw() += k * x_pier;
  EndIf
EndFor
Call Sort;
TX() = sorted(); TP() = {};
pt = 1;
For i In {0:#TX() - 1}
  x = TX(i);
  y = road_top - road_fall * (x / x_back)^2;
  Call NewPoint;
  TP() += p;
EndFor

// ------------------------------------------------------------------------------------------ 4 stones
// Surfaces of a group: S0..S2 rings, S3..S6 abutments and piers west to east, S7 spandrel.
// Curves of a group: C0..C3 foundations west to east, C4, C5 backs, C6..C8 decks, C9 the western half of the deck.
For i In {0:9}
  S~{i}() = {}; C~{i}() = {};
EndFor
For i In {1:#PX() - 1}
  NB~{i}() = {}; NC~{i}() = {};                                       // higher neighbours of a point, curves to them
EndFor
curves = 0;
stones = 0;

// Curve from point pa to point pb, signed: made once, then found. It is divided by its length as built, so
// that the two states have the same cells.
Macro Edge
  lo = pa; hi = pb; sign = 1;
  If (pa > pb)
    lo = pb; hi = pa; sign = -1;
  EndIf
  e = 0;
  For i In {0:#NB~{lo}() - 1}
    If (NB~{lo}(i) == hi)
      e = NC~{lo}(i);
    EndIf
  EndFor
  If (e == 0)
    curves += 1;
    e = curves;
    Line(e) = {lo, hi};
    cells = Round(Sqrt((PX(hi) - PX(lo))^2 + (PY(hi) - PY(lo))^2) / element_size);
    If (cells < 1)
      cells = 1;
    EndIf
    Transfinite Curve{e} = cells + 1;
    NB~{lo}() += hi;
    NC~{lo}() += e;
    If (PT(lo) == 1 && PT(hi) == 1)
      middle = (PX(lo) + PX(hi)) / 2;
      If (middle < 0)
        C~{9}() += e;
      EndIf
      If (middle < -x_pier)
        C~{6}() += e;
      ElseIf (middle > x_pier)
        C~{8}() += e;
      Else
        C~{7}() += e;
      EndIf
    ElseIf (PT(lo) > 1 && PT(lo) == PT(hi))
      C~{PT(lo) - 2}() += e;
    ElseIf (Fabs(PX(lo) + x_back) < eps && Fabs(PX(hi) + x_back) < eps)
      C~{4}() += e;
    ElseIf (Fabs(PX(lo) - x_back) < eps && Fabs(PX(hi) - x_back) < eps)
      C~{5}() += e;
    EndIf
  EndIf
  e *= sign;
Return

// The points of a border with qa <= cx <= qb, by halving: cx ascends. They are from..to of cp(), none when from > to.
Macro FirstAbove
  first = 0; beyond = #cx();
  For halving In {1:Ceil(Log(#cx() + 1) / Log(2))}
    If (first < beyond)
      middle = Floor((first + beyond) / 2);
      If (cx(middle) > q)
        beyond = middle;
      Else
        first = middle + 1;
      EndIf
    EndIf
  EndFor
Return
Macro Between
  q = qa - eps;
  Call FirstAbove;
  lowest = first; highest = first - 1;
  If (first < #cx())
    If (cx(first) < qb + eps)
      q = qb + eps;
      Call FirstAbove;
      highest = first - 1;
    EndIf
  EndIf
Return

// Append them to the walk around a stone.
Macro Walk
  Call Between;
  If (lowest <= highest)
    walk() += cp({lowest:highest});
  EndIf
Return
Macro WalkBack
  Call Between;
  If (lowest <= highest)
    walk() += cp({highest:lowest});
  EndIf
Return

// The stone around which walk() goes counter-clockwise, as a surface of group g.
Macro NewStone
  loop() = {};
  pa = walk(#walk() - 1);
  For k In {0:#walk() - 1}
    pb = walk(k);
    If (pa != pb)
      Call Edge;
      loop() += e;
    EndIf
    pa = pb;
  EndFor
  stones += 1;
  Curve Loop(stones) = loop();
  Plane Surface(stones) = {stones};
  S~{g}() += stones;
Return

// Voussoirs, west to east.
For j In {0:2}
  g = j;
  For v In {0:NV(j) - 1}
    walk() = {IP~{j}(v), IP~{j}(v + 1)};
    cx() = RX~{j}(); cp() = RP~{j}();
    qa = JX~{j}(v); qb = JX~{j}(v + 1);
    Call WalkBack;
    Call NewStone;
  EndFor
EndFor

// Springers: the stone west and the stone east of each arch.
For j In {0:2}
  m = 3 * springer_bed + j;
  t = 3 * datum + j;
  g = 3 + j;
  walk() = {};
  cx() = BX~{springer_bed}(); cp() = BP~{springer_bed}();
  qa = SB(2 * j); qb = EL(m);
  Call Walk;
  walk() += IP~{j}(0);
  cx() = BX~{datum}(); cp() = BP~{datum}();
  qb = EL(t);
  Call WalkBack;
  qb = qa;
  For n In {datum - 1:springer_bed + 1:-1}
    cx() = BX~{n}(); cp() = BP~{n}();
    Call Walk;
  EndFor
  Call NewStone;

  g = 4 + j;
  walk() = {};
  cx() = BX~{springer_bed}(); cp() = BP~{springer_bed}();
  qa = ER(m); qb = SB(2 * j + 1);
  Call Walk;
  qa = qb;
  For n In {springer_bed + 1:datum - 1}
    cx() = BX~{n}(); cp() = BP~{n}();
    Call Walk;
  EndFor
  cx() = BX~{datum}(); cp() = BP~{datum}();
  qa = ER(t);
  Call WalkBack;
  walk() += IP~{j}(NV(j));
  Call NewStone;
EndFor

// Courses. A head joint may carry the end of the bed below or above it as a T-junction: walked at its place.
For n In {0:top}
  bx() = BX~{n}(); bp() = BP~{n}();
  ux() = {}; up() = {};
  If (n < top)
    ux() = BX~{n + 1}(); up() = BP~{n + 1}();
  EndIf
  For v In {0:#SL~{n}() - 1}
    xl = SL~{n}(v); xr = SR~{n}(v); xlb = SLB~{n}(v); xrb = SRB~{n}(v);
    g = 7;
    If (n < datum)
      g = 3 + SG~{n}(v);
    EndIf
    walk() = {};
    from = xlb;
    cut_left = 0;                                                     // the left end of the bottom is on an extrados
    If (n >= datum)
      For j In {0:2}
        left = EL(3 * n + j); right = ER(3 * n + j);
        If (left < xlb)
          left = xlb;
        EndIf
        If (right > xrb)
          right = xrb;
        EndIf
        If (OPEN(3 * n + j) && right > left + eps)
          If (left > from + eps)
            cx() = bx(); cp() = bp(); qa = from; qb = left;
            Call Walk;
          EndIf
          cx() = RX~{j}(); cp() = RP~{j}(); qa = left; qb = right;
          Call Walk;
          from = right;
        EndIf
      EndFor
    EndIf
    If (xrb > from + eps)
      cx() = bx(); cp() = bp(); qa = from; qb = xrb;
      Call Walk;
    EndIf
    // right side
    cx() = bx(); cp() = bp(); qa = xrb; qb = xrb;
    Call Walk;
    cx() = ux(); cp() = up(); qa = xr; qb = xr;
    Call Walk;
    // top
    If (xl > EE(n + 1) - eps || xr < WE(n + 1) + eps)
      cx() = TX(); cp() = TP();
    EndIf
    qa = xl; qb = xr;
    Call WalkBack;
    // left side
    cx() = ux(); cp() = up(); qa = xl; qb = xl;
    Call Walk;
    cx() = bx(); cp() = bp(); qa = xlb; qb = xlb;
    Call Walk;
    Call NewStone;
  EndFor
EndFor
Printf("Clare College Bridge: %g stones, %g points, %g curves; voussoirs %g + %g + %g", stones, #PX() - 1, curves, NV(0), NV(1), NV(2));

// ------------------------------------------------------------------------------------------ groups, mesh
Physical Surface("ring west", 1) = S~{0}();
Physical Surface("ring central", 2) = S~{1}();
Physical Surface("ring east", 3) = S~{2}();
Physical Surface("abutment west", 4) = S~{3}();
Physical Surface("pier west", 5) = S~{4}();
Physical Surface("pier east", 6) = S~{5}();
Physical Surface("abutment east", 7) = S~{6}();
Physical Surface("spandrel", 8) = S~{7}();
Physical Curve("foundation abutment west", 11) = C~{0}();
Physical Curve("foundation pier west", 12) = C~{1}();
Physical Curve("foundation pier east", 13) = C~{2}();
Physical Curve("foundation abutment east", 14) = C~{3}();
Physical Curve("back west", 15) = C~{4}();
Physical Curve("back east", 16) = C~{5}();
Physical Curve("deck west", 17) = C~{6}();
Physical Curve("deck central", 18) = C~{7}();
Physical Curve("deck east", 19) = C~{8}();
Physical Curve("deck west half", 20) = C~{9}();

If (recombine)
  Recombine Surface{1:stones};
EndIf
