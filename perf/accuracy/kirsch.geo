// A quarter of a plate of 40 x 40 m with a hole of 1 m radius; the scene gives the sizes.
Point(1) = {1, 0, 0};
Point(2) = {20, 0, 0};
Point(3) = {20, 20, 0};
Point(4) = {0, 20, 0};
Point(5) = {0, 1, 0};
Point(6) = {0, 0, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Circle(5) = {5, 6, 1};
Curve Loop(1) = {1, 2, 3, 4, 5};
Plane Surface(1) = {1};
Physical Surface("plate") = {1};
