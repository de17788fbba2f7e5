// A ring, 600 mm wide inside, of which the inside matters only.
Point(1) = {0, 0, 0};
For k In {0:3}
  Point(2 + k) = {0.3 * Cos(k * Pi / 2), 0.3 * Sin(k * Pi / 2), 0};
  Point(6 + k) = {0.32 * Cos(k * Pi / 2), 0.32 * Sin(k * Pi / 2), 0};
EndFor
Circle(1) = {2, 1, 3}; Circle(2) = {3, 1, 4}; Circle(3) = {4, 1, 5}; Circle(4) = {5, 1, 2};
Circle(5) = {6, 1, 7}; Circle(6) = {7, 1, 8}; Circle(7) = {8, 1, 9}; Circle(8) = {9, 1, 6};
Curve Loop(1) = {5:8}; Curve Loop(2) = {1:4};
Plane Surface(1) = {1, 2};
Physical Surface("container") = {1};
