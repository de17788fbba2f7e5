// A quarter of a ring from 1 to 2 m.
Point(1) = {1, 0, 0};
Point(2) = {2, 0, 0};
Point(3) = {0, 2, 0};
Point(4) = {0, 1, 0};
Point(5) = {0, 0, 0};
Line(1) = {1, 2};
Circle(2) = {2, 5, 3};
Line(3) = {3, 4};
Circle(4) = {4, 5, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Physical Surface("ring") = {1};
Physical Curve("inside") = {4};
