// Section of a mountain, 200 m wide and 120 m high, under a slope of 20 degrees; four layers that dip
// with it, and a cavity of 2.5 m radius in the second. Elements of 0.5 m.
h = 0.5;
slope = Tan(20 * Pi / 180);
Point(1) = {0, 0, 0, h};
Point(2) = {200, 0, 0, h};
Point(3) = {200, 32, 0, h};
Point(4) = {200, 56, 0, h};
Point(5) = {200, 76.5, 0, h};
Point(6) = {200, 120, 0, h};
Point(7) = {0, 120 - 200 * slope, 0, h};
Point(8) = {0, 34, 0, h};
Point(9) = {0, 16, 0, h};
Point(10) = {0, 6, 0, h};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 6};
Line(6) = {6, 7};
Line(7) = {7, 8};
Line(8) = {8, 9};
Line(9) = {9, 10};
Line(10) = {10, 1};
Line(11) = {10, 3};
Line(12) = {9, 4};
Line(13) = {8, 5};

Point(20) = {100, 45.5, 0};
Point(21) = {102.5, 45.5, 0};
Point(22) = {100, 48, 0};
Point(23) = {97.5, 45.5, 0};
Point(24) = {100, 43, 0};
Circle(20) = {21, 20, 22};
Circle(21) = {22, 20, 23};
Circle(22) = {23, 20, 24};
Circle(23) = {24, 20, 21};

Curve Loop(1) = {5, 6, 7, 13};
Curve Loop(2) = {4, -13, 8, 12};
Curve Loop(3) = {3, -12, 9, 11};
Curve Loop(4) = {1, 2, -11, 10};
Curve Loop(5) = {20, 21, 22, 23};
Plane Surface(1) = {1};
Plane Surface(2) = {2, 5};
Plane Surface(3) = {3};
Plane Surface(4) = {4};

Mesh.CharacteristicLengthMin = h;
Mesh.CharacteristicLengthMax = h;
Mesh.Algorithm = 5;
Mesh.Smoothing = 10;

Physical Surface("layer 1") = {1};
Physical Surface("layer 2") = {2};
Physical Surface("layer 3") = {3};
Physical Surface("layer 4") = {4};
Physical Curve("cavity") = {20, 21, 22, 23};
Physical Curve("slope") = {6};
Physical Curve("sides") = {1, 2, 3, 4, 5, 7, 8, 9, 10};
