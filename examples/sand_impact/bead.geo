// The thirty degrees of a ball that are in the wedge, without the part around the axis, where no grain is: a profile
// in the wall at -15 degrees, turned by 30 degrees in layers.
r = 3.15e-3; i = 0.9e-3; z = 3.5e-3; n = 5; a = Acos(i / r);
For k In {0:n}
  p = -a + 2 * a * k / n;
  Point(k + 1) = {r * Cos(p) * Cos(Pi/12), -r * Cos(p) * Sin(Pi/12), z + r * Sin(p)};
EndFor
For k In {1:n}
  Line(k) = {k, k + 1};
EndFor
Line(n + 1) = {n + 1, 1};
Curve Loop(1) = {1:n+1};
Plane Surface(1) = {1};
Transfinite Curve {1:n} = 2;
Transfinite Curve {n + 1} = n;
ball[] = Extrude {{0, 0, 1}, {0, 0, 0}, Pi/6} { Surface{1}; Layers{1}; };
Physical Volume("bead") = {ball[1]};
