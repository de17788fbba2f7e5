// Half of two steel bars with a disc of granite between them, cut at z = 0. Lengths in m.
SetFactory("OpenCASCADE");
L = 1;         // of the incident bar
M = 0.4;       // of the transmission bar
R = 0.025;     // of bars and disc
T = 0.025;     // thickness of the disc
fine = 0.003;  // elements of the disc
coarse = 0.014;
Cylinder(1) = {-R - L, 0, 0, L, 0, 0, R};
Cylinder(2) = {R, 0, 0, M, 0, 0, R};
Box(10) = {-2 * L, -2 * R, 0, 4 * L, 4 * R, 2 * R};
incident() = BooleanIntersection{ Volume{1}; Delete; }{ Volume{10}; };
transmission() = BooleanIntersection{ Volume{2}; Delete; }{ Volume{10}; Delete; };

// The disc of four arcs, so that nodes lie where the bars touch it.
Point(1000) = {0, 0, 0};
Point(1001) = {R, 0, 0};
Point(1002) = {0, R, 0};
Point(1003) = {-R, 0, 0};
Point(1004) = {0, -R, 0};
Circle(1001) = {1001, 1000, 1002};
Circle(1002) = {1002, 1000, 1003};
Circle(1003) = {1003, 1000, 1004};
Circle(1004) = {1004, 1000, 1001};
Curve Loop(1001) = {1001, 1002, 1003, 1004};
Plane Surface(1001) = {1001};
disc() = Extrude {0, 0, T / 2} { Surface{1001}; };

Physical Volume("incident bar") = {incident()};
Physical Volume("transmission bar") = {transmission()};
Physical Volume("disc") = {disc(1)};

Field[1] = Box;
Field[1].XMin = -0.95 * R; Field[1].XMax = 0.95 * R;
Field[1].YMin = -R; Field[1].YMax = R;
Field[1].ZMin = -R; Field[1].ZMax = R;
Field[1].VIn = fine; Field[1].VOut = coarse; Field[1].Thickness = 0.06;
Background Field = 1;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Mesh.Algorithm = 1;  // surfaces without rows of triangles
