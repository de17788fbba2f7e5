#!/usr/bin/env python3
"""First arrivals in the mountain without waves: shortest travel times over a grid of points (Moser 1991).

A piece of a path takes its length over the group velocity, along the piece, of the quasi-P wave of the layer it runs
through; the group velocity is the gradient of the phase velocity that Christoffel's equation gives (VERIFICATION V-021,
V-023). arrivals.py [--isotropic] prints the times of the sensors of the scene in ms. Needs Python 3.11 and numpy.
"""
import argparse
import math
import pathlib
import tomllib

import numpy

DENSITY = 2420.0  # kg/m3
SCALE = (1.0, 0.8, 1.3, 1.0)
TILT = (0.0, 20.0, -30.0, 45.0)  # degrees, of the axis of symmetry from the vertical, anticlockwise
SHALE = {"c11": 31.3e9, "c33": 22.5e9, "c13": 3.4e9, "c44": 6.5e9}  # Pa
YOUNG, POISSON = 21.55e9, 0.2436  # of the mean over all directions (Voigt), Pa
WIDTH, HEIGHT, SLOPE = 200.0, 120.0, math.tan(math.radians(20))
DIPS = ((34.0, 76.5), (16.0, 56.0), (6.0, 32.0))  # heights of the ends of the faces between layers, m
CAVITY, RADIUS = numpy.array([100.0, 45.5]), 2.5  # m


def isotropic():
    modulus = YOUNG * (1 - POISSON) / ((1 + POISSON) * (1 - 2 * POISSON))
    shear = YOUNG / (2 * (1 + POISSON))
    return {"c11": modulus, "c33": modulus, "c13": modulus - 2 * shear, "c44": shear}


def phase_speed(c, angle):
    """Quasi-P, m/s, along a direction at `angle` from the axis of symmetry."""
    s, o = numpy.sin(angle), numpy.cos(angle)
    a, b = c["c11"] * s**2 + c["c44"] * o**2, c["c44"] * s**2 + c["c33"] * o**2
    beside = (c["c13"] + c["c44"]) * s * o
    return numpy.sqrt((0.5 * (a + b) + numpy.hypot(0.5 * (a - b), beside)) / DENSITY)


class Layer:
    """Group speed along every direction of the section."""

    def __init__(self, c, scale, tilt):
        n = 20000
        angle = numpy.linspace(0, 2 * math.pi, n, endpoint=False)  # of the wave's normal, from the axis
        v = math.sqrt(scale) * phase_speed(c, angle)
        slope = (numpy.roll(v, -1) - numpy.roll(v, 1)) / (2 * (angle[1] - angle[0]))
        ray = angle + numpy.arctan2(slope, v)  # of the energy: v n + dv/d(angle) n'
        # from the axis clockwise, as (sin, cos), to anticlockwise from x
        world = numpy.mod(0.5 * math.pi + math.radians(tilt) - ray, 2 * math.pi)
        order = numpy.argsort(world)
        self.angle, self.speed = world[order], numpy.hypot(v, slope)[order]

    def __call__(self, direction):
        return numpy.interp(numpy.mod(direction, 2 * math.pi), self.angle, self.speed, period=2 * math.pi)


def layer_at(x, y):
    """0 at the top to 3."""
    below = [y < left + (right - left) * x / WIDTH for left, right in DIPS]
    return below[0].astype(int) + below[1] + below[2]


def inside(x, y):
    return (x > -1e-9) & (x < WIDTH + 1e-9) & (y > -1e-9) & (y < HEIGHT - (WIDTH - x) * SLOPE + 1e-9)


def travel(layers, start, step, pieces=12):
    """Time along straight lines from the points `start` by the vector `step`, s: the sum over the layers."""
    direction, length = math.atan2(step[1], step[0]), math.hypot(*step)
    slowness = numpy.array([1 / layer(direction) for layer in layers])
    time = 0
    for k in range(pieces):
        at = (k + 0.5) / pieces
        time = time + slowness[layer_at(start[0] + at * step[0], start[1] + at * step[1])]
    return time * length / pieces


def from_cavity(layers, x, y):
    """Times near the cavity, whose wall moves all at once; layer 2 only."""
    best = numpy.full(x.shape, numpy.inf)
    for a in numpy.linspace(0, 2 * math.pi, 720, endpoint=False):
        dx = x - CAVITY[0] - RADIUS * math.cos(a)
        dy = y - CAVITY[1] - RADIUS * math.sin(a)
        best = numpy.minimum(best, numpy.hypot(dx, dy) / layers[1](numpy.arctan2(dy, dx)))
    return best


def first_arrivals(layers, reach=9):
    """Grid points and times: Bellman and Ford, all points at once, pieces to all neighbours up to `reach` m."""
    x, y = numpy.meshgrid(numpy.arange(WIDTH + 1), numpy.arange(HEIGHT + 1), indexing="ij")
    rock = inside(x, y)
    near = numpy.hypot(x - CAVITY[0], y - CAVITY[1]) < 8
    time = numpy.where(rock, numpy.inf, numpy.nan)
    time[near] = from_cavity(layers, x[near], y[near])
    steps = [(i, j) for i in range(-reach, reach + 1) for j in range(-reach, reach + 1) if math.gcd(i, j) == 1]
    cost = {s: travel(layers, (x, y), s) for s in steps}
    while True:
        before = numpy.nan_to_num(time, posinf=1e9)
        for (i, j), take in cost.items():
            to = (slice(max(i, 0), x.shape[0] + min(i, 0)), slice(max(j, 0), x.shape[1] + min(j, 0)))
            of = (slice(max(-i, 0), x.shape[0] + min(-i, 0)), slice(max(-j, 0), x.shape[1] + min(-j, 0)))
            ok = rock[to] & rock[of]
            time[to] = numpy.where(ok, numpy.fmin(time[to], time[of] + take[of]), time[to])
        if numpy.array_equal(before, numpy.nan_to_num(time, posinf=1e9)):
            return x, y, time


def at_point(layers, grid, place, reach=9):
    x, y, time = grid
    near = (numpy.hypot(x - place[0], y - place[1]) < reach) & numpy.isfinite(time)
    return min(
        time[i] + travel(layers, (numpy.array(x[i]), numpy.array(y[i])), (place[0] - x[i], place[1] - y[i]), 24)
        for i in map(tuple, numpy.argwhere(near))
    )


def layers_of(isotropy):
    if isotropy:
        return [Layer(isotropic(), s, 0) for s in SCALE]
    return [Layer(SHALE, s, t) for s, t in zip(SCALE, TILT)]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--isotropic", action="store_true")
    options = parser.parse_args()
    scene = tomllib.loads((pathlib.Path(__file__).parent / "scene.toml").read_text())
    layers = layers_of(options.isotropic)
    grid = first_arrivals(layers)
    for sensor in scene["sensor"]:
        print(f"{sensor['name']:4} {1e3 * at_point(layers, grid, sensor['point']):7.3f} ms")


if __name__ == "__main__":
    main()
