# SPDX-License-Identifier: BSD-3-Clause
"""Exact collision detection between 2D polygons.

A Polygon is a region in a frame of its own, and a pose puts it into the world: x, y and heading in radians, as an array (3,).
Many poses are (n, 3). Every query of two posed polygons, and of a Scene, takes one pose or many. Where one operand is one and
another is many, the one serves for all.

>>> import numpy as np
>>> import tricover as tc
>>> robot, crate = tc.Polygon.box(2, 1), tc.Polygon([(0, 0), (4, 0), (0, 4)])
>>> tc.collide(robot, [(0, 0, 0), (-2, 0, 0)], crate, (0, 0, 0))
array([ True, False])

Many poses are asked about on `threads` threads, 0 for all processors, while other Python threads run. Lengths are the world's.
A wrong value is a ValueError that names the argument and the row, a wrong type a TypeError, an edge or a body that isn't there
an IndexError.

A homogeneous matrix, which may mirror, is given as Poses.from_matrices(matrix), and never as a plain array: three poses and a
matrix have one shape. An array (3, 3) whose last row is 0, 0, 1 may be either, and is refused.
"""
from . import paper
from ._enums import *
from ._geo import *
from ._results import *
from ._scene_results import *
from ._tricover import *
from ._tricover import __version__


def _trajectory(*state):
    """A Trajectory of its pickle, which names this function: those of the compiled module can't be named."""
    return _tricover._trajectory(*state)


__all__ = [name for name in globals() if not name.startswith("_") and name != "paper"] + ["__version__", "paper"]
