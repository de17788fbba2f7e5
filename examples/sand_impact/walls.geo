// The two walls of a wedge of thirty degrees, from just off the axis. They are two blocks far larger than the bed, so that no
// contact point of their own faces lies in it: grains feel the plane with their own points alone, and slide without bumps.
R = 0.120; bottom = -0.060; top = 0.020; start = 0.0002; t = 0.030; half = Pi / 12;
volumes[] = {};
For side In {0:1}
  sign = 2 * side - 1; c = Cos(half); s = sign * Sin(half);
  q = newp;
  Point(q) = {start * c, start * s, bottom}; Point(q + 1) = {R * c, R * s, bottom};
  Point(q + 2) = {R * c, R * s, top}; Point(q + 3) = {start * c, start * s, top};
  l = newc;
  Line(l) = {q, q + 1}; Line(l + 1) = {q + 1, q + 2}; Line(l + 2) = {q + 2, q + 3}; Line(l + 3) = {q + 3, q};
  Transfinite Curve {l:l + 3} = 2;
  f = news;
  Curve Loop(f) = {l, l + 1, l + 2, l + 3};
  Plane Surface(f) = {f};
  Transfinite Surface {f};
  block[] = Extrude {-t * s * sign, t * sign * c, 0} { Surface{f}; Layers{2}; };
  volumes[] += {block[1]};
EndFor
Physical Volume("walls") = {volumes[]};
