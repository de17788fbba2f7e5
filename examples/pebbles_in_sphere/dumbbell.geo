// Two balls joined by a bar, at the first site of the raster.
SetFactory("OpenCASCADE");
Sphere(1) = {-0.0215, -0.018, -0.018, 0.0026};
Sphere(2) = {-0.0145, -0.018, -0.018, 0.0026};
Cylinder(3) = {-0.0215, -0.018, -0.018, 0.007, 0, 0, 0.0014};
BooleanUnion(4) = { Volume{1}; Delete; }{ Volume{2, 3}; Delete; };
Physical Volume("dumbbell") = {4};
