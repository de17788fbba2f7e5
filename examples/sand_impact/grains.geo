// Two layers of grains in the wedge: blocks in rings around the axis, of the same pitch along it, around it and
// outwards, of which 0.725^3 = 0.38 is solid. The rings of the layer "second" are half a pitch further out.
R = 0.017; p = 1.2e-3; share = 0.725; half = Pi / 12;
For layer In {0:1}
  volumes[] = {};
  z = -(layer + 0.5 + share / 2) * p;
  inside = 0.8e-3 + layer * p / 2;
  rings = Floor((R - inside - share * p) / p) + 1;
  For i In {0:rings - 1}
    ri = inside + i * p; ro = ri + share * p;
    n = Round(half * (ri + ro) / p);
    If (n < 1)
      n = 1;
    EndIf
    w = 2 * half / n;
    For j In {0:n - 1}
      a = -half + (j + (1 - share) / 2) * w; b = a + share * w;
      q = newp;
      Point(q) = {ri * Cos(a), ri * Sin(a), z}; Point(q + 1) = {ro * Cos(a), ro * Sin(a), z};
      Point(q + 2) = {ro * Cos(b), ro * Sin(b), z}; Point(q + 3) = {ri * Cos(b), ri * Sin(b), z};
      c = newc;
      Line(c) = {q, q + 1}; Line(c + 1) = {q + 1, q + 2}; Line(c + 2) = {q + 2, q + 3}; Line(c + 3) = {q + 3, q};
      Transfinite Curve {c:c + 3} = 2;
      f = news;
      Curve Loop(f) = {c, c + 1, c + 2, c + 3};
      Plane Surface(f) = {f};
      Transfinite Surface {f};
      block[] = Extrude {0, 0, share * p} { Surface{f}; Layers{1}; };
      volumes[] += {block[1]};
    EndFor
  EndFor
  If (layer == 0)
    Physical Volume("first") = {volumes[]};
  Else
    Physical Volume("second") = {volumes[]};
  EndIf
EndFor
