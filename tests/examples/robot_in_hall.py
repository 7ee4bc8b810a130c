#!/usr/bin/env python3
"""A robot among racks: where it is free, what is near, when it hits what. PYTHONPATH is where `tricover` was built."""
import argparse
import sys

import numpy as np
import tricover as tc

parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("picture", nargs="?", help="where to draw it, if there is matplotlib")
picture = parser.parse_args().picture

ROBOT = tc.Polygon([(-0.5, -0.3), (0.6, -0.3), (0.6, -0.2), (0, -0.2), (0, 0.2), (0.6, 0.2), (0.6, 0.3), (-0.5, 0.3)])
RACK = tc.Polygon([(0, 0), (6, 0), (6, 0.8), (0, 0.8)])

hall = tc.Scene()
walls = hall.add(tc.Polygon([[(0, 0), (14, 0), (14, 10), (0, 10)], [(0.2, 0.2), (13.8, 0.2), (13.8, 9.8), (0.2, 9.8)]]), (0, 0, 0))
racks = [hall.add(RACK, (x, y, 0.05)) for y in (2, 4.5, 7) for x in (0.8, 7.2)]
column = hall.add(tc.Polygon.point((0, 0)), (7, 6.2, 0), margin=0.3)  # a disc

# 200 x 140 places at once, on all processors.
x, y = np.meshgrid(np.linspace(0, 14, 200), np.linspace(0, 10, 140))
poses = np.column_stack([x.ravel(), y.ravel(), np.full(x.size, 0.3)])
is_free = ~hall.collides(ROBOT, poses, margin=0.1).reshape(x.shape)
print(f"free at {is_free.mean():.0%} of {is_free.size} places")

body, gap = hall.nearest(ROBOT, (7, 3.7, 0.3))
print(f"{gap.distance:.3f} m from body {body}, between {gap.point_a.round(3)} and {gap.point_b.round(3)}")

way = tc.Motion.spline(begin=(1, 1.2, 0), begin_velocity=(6, 0, 0), end=(8, 9.2, 0.5), end_velocity=(0, 9, 0))
hit = hall.first_impact(ROBOT, way)
if hit:
    print(f"meets body {hit.body} at time {hit.impact.time:.4f}, at {hit.impact.point.round(3)}")

overlap = tc.penetration(RACK, (0, 0, 0), ROBOT, (3, 0.9, 0.3))
print(f"{overlap.depth:.3f} m deep, out by {overlap.translation.round(3)}")

if picture:
    try:
        import matplotlib
    except ImportError:
        sys.exit("example.py: a picture needs matplotlib (python3-matplotlib)")
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    def draw(polygon, pose, **how):
        for ring in polygon.rings:
            world = np.column_stack([ring, np.ones(len(ring))]) @ np.asarray(pose).T
            plt.fill(world[:, 0], world[:, 1], **how)

    plt.figure(figsize=(10, 7))
    plt.pcolormesh(x, y, is_free, cmap="Greens", vmax=3)
    for rack in racks:
        draw(hall.polygon(rack), hall.pose(rack), color="#57534e")
    for t in np.linspace(0, hit.impact.time if hit else 1, 9):
        draw(ROBOT, way.at(t), fill=False, edgecolor="#1d4ed8")
    if hit:
        plt.plot(*hit.impact.point, "o", color="#dc2626")
    plt.axis("equal")
    try:
        plt.savefig(picture)
    except OSError as error:
        sys.exit(f"error: can't write {picture}: {error.strerror}")
    print(f"drawn: {picture}", file=sys.stderr)
