// The ground of examples/borehole_in_situ with 16 elements along a quarter of the rim.
rim = 16;
Include "../../examples/borehole_in_situ/borehole.geo";
