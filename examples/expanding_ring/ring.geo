// A ring of 50 mm along its middle line, one cell across: n cells along each quarter, every cell of two triangles.
r = 7.957747e-3; w = 12.5e-6; n = 1000;
Point(1) = {0, 0, 0};
Point(2) = {r + w / 2, 0, 0}; Point(3) = {0, r + w / 2, 0}; Point(4) = {-r - w / 2, 0, 0}; Point(5) = {0, -r - w / 2, 0};
Point(6) = {r - w / 2, 0, 0}; Point(7) = {0, r - w / 2, 0}; Point(8) = {-r + w / 2, 0, 0}; Point(9) = {0, -r + w / 2, 0};
Circle(1) = {2, 1, 3}; Circle(2) = {3, 1, 4}; Circle(3) = {4, 1, 5}; Circle(4) = {5, 1, 2};
Circle(5) = {6, 1, 7}; Circle(6) = {7, 1, 8}; Circle(7) = {8, 1, 9}; Circle(8) = {9, 1, 6};
Line(9) = {6, 2}; Line(10) = {7, 3}; Line(11) = {8, 4}; Line(12) = {9, 5};
Curve Loop(1) = {1, -10, -5, 9}; Curve Loop(2) = {2, -11, -6, 10}; Curve Loop(3) = {3, -12, -7, 11}; Curve Loop(4) = {4, -9, -8, 12};
Plane Surface(1) = {1}; Plane Surface(2) = {2}; Plane Surface(3) = {3}; Plane Surface(4) = {4};
Transfinite Curve {1:8} = n + 1; Transfinite Curve {9:12} = 2;
Transfinite Surface {1:4} Alternate;
