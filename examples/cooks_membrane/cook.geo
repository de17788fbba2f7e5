// Cook's membrane: 17 points along a side, 512 triangles; as composites 1089 nodes. The diagonals
// are the ones that simple triangles find worst.
Point(1) = {0, 0, 0};
Point(2) = {0.048, 0.044, 0};
Point(3) = {0.048, 0.060, 0};
Point(4) = {0, 0.044, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Transfinite Curve {1, 2, 3, 4} = 17;
Transfinite Surface {1} Right;
Physical Surface("membrane") = {1};
Physical Curve("end") = {2};
Physical Curve("wall") = {4};
