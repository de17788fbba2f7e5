// A hollow sphere, 100 mm wide inside, of which inside faces matter only.
SetFactory("OpenCASCADE");
Sphere(1) = {0, 0, 0, 0.056};
Sphere(2) = {0, 0, 0, 0.050};
BooleanDifference(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
Physical Volume("container") = {3};
