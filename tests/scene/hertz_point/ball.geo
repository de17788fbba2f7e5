// A quarter of the lower half of a ball, 10 mm in radius, that touches z = 0 and has elements of 18 um there.
SetFactory("OpenCASCADE");
Sphere(1) = {0, 0, 0.01, 0.01};
Box(2) = {0, 0, 0, 0.01, 0.01, 0.01};
BooleanIntersection(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
Physical Volume("ball") = {3};
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Mesh.MeshSizeFromCurvature = 0;
Field[1] = MathEval;
Field[1].F = "0.000018 + 0.1*(sqrt(x^2+y^2+z^2) - 0.00032 + abs(sqrt(x^2+y^2+z^2) - 0.00032))";
Background Field = 1;
