from typing import Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._enums import InfluenceKind as InfluenceKind, Touching
from ._results import CoveringTriangle
from ._tricover import Polygon, _PosesLike

__all__ = ["InfluenceKind", "bounded_influence_area", "collide", "covering", "in_influence_area", "influence_mask"]

def covering(polygon: Polygon) -> CoveringTriangle:
    """Returns the covering: one triangle an edge, from Polygon.covering_origin, as arrays.

    >>> triangles = tricover.paper.covering(tc.Polygon.box(2, 2))
    >>> triangles.v.shape
    (4, 2)
    """

def in_influence_area(polygon: Polygon, edge: int, point: ArrayLike, length: float,
                      kind: InfluenceKind) -> Union[bool, NDArray[np.bool_]]:
    """Returns whether a point, (2,), or each of many, (n, 2), lies in an edge's influence area for a length.

    Points are in the polygon's frame.

    >>> tricover.paper.in_influence_area(tc.Polygon.box(2, 2), 0, (0, -1.5), 1, tc.InfluenceKind.BOUNDED)
    True
    """

def influence_mask(polygon: Polygon, point: ArrayLike, length: float) -> NDArray[np.bool_]:
    """Returns for each edge whether a point, (2,) in the polygon's frame, is in its bounded area.

    >>> tricover.paper.influence_mask(tc.Polygon.box(2, 2), (0, -5), 1).any()
    False
    """

def bounded_influence_area(polygon: Polygon, edge: int, length: float) -> NDArray[np.float64]:
    """Returns the corners of an edge's bounded area, (4, 2), rounded.

    >>> tricover.paper.bounded_influence_area(tc.Polygon.box(2, 2), 0, 1).shape
    (4, 2)
    """

def collide(a: Polygon, pose_a: _PosesLike, b: Polygon, pose_b: _PosesLike, margin: float = 0.0, tolerance: float = 0.0,
            touching: Touching = Touching.COLLIDES, threads: int = 0) -> Union[bool, NDArray[np.bool_]]:
    """Returns what tricover.collide() does, by Algorithm 3, in O(n m).

    >>> square = tc.Polygon.box(2, 2)
    >>> tricover.paper.collide(square, (0, 0, 0), square, (1, 0, 0))
    True
    """
