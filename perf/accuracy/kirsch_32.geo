// The ground of examples/borehole_in_situ with 32 elements along a quarter of the rim.
rim = 32;
Include "../../examples/borehole_in_situ/borehole.geo";
