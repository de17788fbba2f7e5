// The ground of examples/borehole_in_situ with 8 elements along a quarter of the rim.
rim = 8;
Include "../../examples/borehole_in_situ/borehole.geo";
