// A quarter of a plate of 40 x 40 m with a hole of 1 m radius, meshed together with the rock that
// will be taken out of it. `rim`: elements along the quarter of the rim.
DefineConstant[ rim = {16, Name "elements along a quarter of the rim"} ];
a = 1; b = 20;
core = 1.5707963 / rim;
Point(1) = {0, 0, 0, 4 * core};
Point(2) = {a, 0, 0, core};
Point(3) = {0, a, 0, core};
Point(4) = {b, 0, 0, 40 * core};
Point(5) = {b, b, 0, 40 * core};
Point(6) = {0, b, 0, 40 * core};
Circle(1) = {2, 1, 3};
Line(2) = {1, 2};
Line(3) = {3, 1};
Line(4) = {2, 4};
Line(5) = {4, 5};
Line(6) = {5, 6};
Line(7) = {6, 3};
Transfinite Curve {1} = rim + 1;
Curve Loop(1) = {2, 1, 3};
Plane Surface(1) = {1};
Curve Loop(2) = {4, 5, 6, 7, -1};
Plane Surface(2) = {2};
Physical Surface("hole") = {1};
Physical Surface("rock") = {2};
Physical Curve("far") = {5, 6};
