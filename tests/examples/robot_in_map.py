#!/usr/bin/env python3
"""A robot in a ROS map: at which of 10,000 poses it is free, drawn. usage: robot_in_map.py [map.yaml [picture.svg]]"""
import sys

import numpy as np
import tricover as tc

yaml, picture = (sys.argv[1:] + ["maps/yard.yaml", "robot_in_map.svg"][len(sys.argv) - 1:])[:2]
walls = tc.read_occupancy_map(yaml).outline()  # one polygon with holes, in the world; what is unknown is in the way
robot = tc.Polygon([(-0.5, -0.3), (0.6, -0.3), (0.6, -0.2), (0, -0.2), (0, 0.2), (0.6, 0.2), (0.6, 0.3), (-0.5, 0.3)])
low, high = walls.bounds
poses = np.random.default_rng(1).uniform([*low, -np.pi], [*high, np.pi], (10_000, 3))  # x, y and heading
hits = tc.collide(walls, (0, 0, 0), robot, poses, margin=0.1)  # on all processors
print(f"free at {np.count_nonzero(~hits)} of {len(poses)} poses")

nearest = tc.distance(walls, (0, 0, 0), robot, poses[~hits])  # an array in each field
print(f"the farthest from the walls is {nearest.distance.max():.2f} m away from them")

drawing = tc.SvgDrawing()
drawing.polygon(walls, (0, 0, 0), "#a8a29e")
for pose in poses[~hits][:100]:
    drawing.polygon(robot, pose, "none", "#16a34a")
drawing.save(picture)
