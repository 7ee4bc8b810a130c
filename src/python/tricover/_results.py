# SPDX-License-Identifier: BSD-3-Clause
"""Results: named tuples of numbers, or of arrays where many poses were asked about at once.

Lengths and points are the world's. An edge is its number, and -1 is none. Of many answers, each field is an array: numbers
have the shape (n,), points and normals (n, 2). Where there is no answer, numbers are NaN, edges -1 and bodies NO_BODY, and
`found` is False.
"""
import re
from typing import Any, NamedTuple, TypeVar, Union

import numpy as np
from numpy.typing import NDArray

from ._enums import SelfCrossingKind

Floats = Union[float, NDArray[np.float64]]
Ints = Union[int, NDArray[np.int64]]
Bools = Union[bool, NDArray[np.bool_]]
Vectors = NDArray[np.float64]
__all__ = ["Body", "Conflict", "Contact", "CoveringTriangle", "Crossing", "Depth", "Distance", "Excess", "Exit", "Impact",
           "LeastDistance", "Penetration", "RayHit", "RayInterval", "SelfCrossing", "SignedDistance"]
_Type = TypeVar("_Type", bound=type)


class Body(int):
    """A handle of a body in a Scene. An int of its value serves as well. No handle is a mask.

    >>> scene = tc.Scene()
    >>> scene.add(tc.Polygon.box(1, 1), (0, 0, 0))
    Body(0)
    """
    __slots__ = ()

    def __repr__(self) -> str:
        return f"Body({int(self)})"

    def __str__(self) -> str:
        return str(int(self))


def _equal(self: Any, other: object) -> Any:
    if not isinstance(other, tuple):
        return NotImplemented
    return len(self) == len(other) and all(
        np.array_equal(p, q, equal_nan=True) if isinstance(p, (float, np.ndarray)) else bool(np.all(p == q))
        for p, q in zip(self, other))


def _key(value: Any) -> Any:
    return ((value + 0.0).tobytes() if value.dtype.kind == "f" else value.tobytes()) if isinstance(value, np.ndarray) else value


def _documented(cls: _Type) -> _Type:
    """Gives each field the text that the docstring has."""
    texts = dict(re.findall(r"^    (\w+): ((?:.+\n(?:        .+\n)*))", cls.__doc__ or "", re.M))
    for field in getattr(cls, "_fields"):
        getattr(cls, field).__doc__ = " ".join(texts[field].split())
    return cls


def _result(cls: _Type) -> _Type:
    """Makes it compare by its arrays' items."""
    setattr(cls, "__eq__", _equal)
    setattr(cls, "__ne__", lambda self, other: NotImplemented if (same := _equal(self, other)) is NotImplemented else not same)
    setattr(cls, "__hash__", lambda self: hash(tuple(_key(value) for value in self)))
    setattr(cls, "__module__", "tricover")
    return _documented(cls)


@_result
class Distance(NamedTuple):
    """How far two regions are from each other, and where.

    distance: A length, less the margin; 0 where they collide.
    point_a: The point of a nearest to b.
    point_b: The point of b nearest to a.
    edge_a: The edge of a that point_a lies on; -1 where b lies inside a.
    edge_b: The edge of b that point_b lies on; -1 where a lies inside b.

    >>> square = tc.Polygon.box(2, 2)
    >>> gap = tc.distance(square, (0, 0, 0), square, [(5, 0, 0), (0, 9, 0)])
    >>> gap.distance
    array([3., 7.])
    """
    distance: Floats
    point_a: Vectors
    point_b: Vectors
    edge_a: Ints
    edge_b: Ints

    @property
    def found(self) -> Any:
        """Whether there is an answer: where distance_within() has none, it is False.

        >>> square = tc.Polygon.box(2, 2)
        >>> tc.distance_within(square, (0, 0, 0), square, [(5, 0, 0), (0, 9, 0)], limit=4).found
        array([ True, False])
        """
        return ~np.isnan(self.distance)


@_result
class SignedDistance(NamedTuple):
    """The distance of two regions, or minus the depth of their overlap.

    distance: A length, less the margin; below 0 where the regions overlap.
    normal: A unit vector from a to b: moving b along it increases the distance.
    point_a: The point of a nearest to b or, where they overlap, the one of depth().
    point_b: The same point of b.
    edge_a: The edge of a that point_a lies on, or -1.
    edge_b: The edge of b that point_b lies on, or -1.

    >>> square = tc.Polygon.box(2, 2)
    >>> tc.signed_distance(square, (0, 0, 0), square, [(5, 0, 0), (1.5, 0, 0)]).distance
    array([ 3. , -0.5])
    """
    distance: Floats
    normal: Vectors
    point_a: Vectors
    point_b: Vectors
    edge_a: Ints
    edge_b: Ints


@_result
class Penetration(NamedTuple):
    """The shortest translation of b that separates two overlapping regions.

    depth: The length of the translation; an upper bound of it if it isn't `optimal`.
    normal: A unit vector, from a towards where b leaves it.
    lower_bound: No shorter translation separates the regions.
    optimal: Whether depth and lower_bound agree to the precision of penetration().
    translation: After this translation of b they are proven to be apart.
    point_a: The point on a's outline that separates last.
    point_b: The same point on b's outline.
    edge_a: The edge of a that point_a lies on.
    edge_b: The edge of b that point_b lies on.

    >>> square = tc.Polygon.box(2, 2)
    >>> tc.penetration(square, (0, 0, 0), square, (1.5, 0, 0)).depth
    0.5
    """
    depth: Floats
    normal: Vectors
    lower_bound: Floats
    optimal: Bools
    translation: Vectors
    point_a: Vectors
    point_b: Vectors
    edge_a: Ints
    edge_b: Ints

    @property
    def found(self) -> Any:
        """Whether the regions overlap.

        >>> square = tc.Polygon.box(2, 2)
        >>> tc.penetration(square, (0, 0, 0), square, [(1.5, 0, 0), (9, 0, 0)]).found
        array([ True, False])
        """
        return ~np.isnan(self.depth)


@_result
class Depth(NamedTuple):
    """The deepest point of two overlapping regions.

    depth: A length; 0 for regions that only touch or are apart.
    normal: A unit vector along which moving b makes the depth smaller at first.
    point_a: A point of a, `depth` away from point_b.
    point_b: A point of b.
    edge_a: The edge of a that point_a lies on, or -1.
    edge_b: The edge of b that point_b lies on, or -1.
    is_point_of_a: Whether point_a is the deepest point, inside of b; otherwise point_b is, inside of a.
    upper_bound: No point is deeper.

    >>> square = tc.Polygon.box(2, 2)
    >>> tc.depth(square, (0, 0, 0), square, (1.5, 0, 0)).depth
    0.5
    """
    depth: Floats
    normal: Vectors
    point_a: Vectors
    point_b: Vectors
    edge_a: Ints
    edge_b: Ints
    is_point_of_a: Bools
    upper_bound: Floats


@_result
class Excess(NamedTuple):
    """The point of a part that is farthest from an area.

    distance: A length; 0 if the area covers the part.
    point: The farthest point of the part.
    nearest: The point of the area nearest to it.
    edge: The edge of the part that `point` lies on, or -1.
    nearest_edge: The edge of the area that `nearest` lies on, or -1.
    upper_bound: No point is farther.

    >>> square = tc.Polygon.box(2, 2)
    >>> tc.excess(square, (0.5, 0, 0), square, (0, 0, 0)).distance
    0.5
    """
    distance: Floats
    point: Vectors
    nearest: Vectors
    edge: Ints
    nearest_edge: Ints
    upper_bound: Floats


@_result
class Contact(NamedTuple):
    """One connected component of an overlap.

    point: A point of this component.
    normal: A unit vector, from a towards where b leaves it.
    depth: How far along the normal b must move to leave this component.
    edge_a: The edge of a that separates last, or -1.
    edge_b: The edge of b that separates last, or -1.
    points: The ends of the interval where edges face each other, (2, 2), or one point, (1, 2).
    depths: The depths along the normal at `points`, (2,) or (1,).

    >>> square = tc.Polygon.box(2, 2)
    >>> tc.contacts(square, (0, 0, 0), square, (1.5, 0, 0))[0].normal
    array([1., 0.])
    """
    point: Vectors
    normal: Vectors
    depth: float
    edge_a: int
    edge_b: int
    points: Vectors
    depths: NDArray[np.float64]


@_result
class Crossing(NamedTuple):
    """Pairs of edges that meet, as arrays.

    edge_a: Edges of a.
    edge_b: Edges of b.
    point: A common point of both, rounded; the middle between them where they are apart.

    >>> square = tc.Polygon.box(2, 2)
    >>> len(tc.crossings(square, (0, 0, 0), square, (1, 1, 0)).point)
    2
    """
    edge_a: Ints
    edge_b: Ints
    point: Vectors


@_result
class Impact(NamedTuple):
    """The first contact of two moving bodies.

    time: When: never later than the first contact.
    point: Where they meet.
    normal: A unit vector from a to b.
    edge_a: The edge of a that meets b's, or -1.
    edge_b: The edge of b that meets a's, or -1.
    budget_ended: Whether the search ended early: contact before `time` is excluded, and later is unknown.

    >>> square = tc.Polygon.box(2, 2)
    >>> drive = tc.Motion.translation((-6, 0, 0), (8, 0))
    >>> round(tc.time_of_impact(square, (0, 0, 0), square, drive).time, 5)
    0.5
    """
    time: Floats
    point: Vectors
    normal: Vectors
    edge_a: Ints
    edge_b: Ints
    budget_ended: Bools

    @property
    def found(self) -> Any:
        """Whether there is an impact.

        >>> square = tc.Polygon.box(2, 2)
        >>> drives = [tc.Motion.translation((-6, y, 0), (8, 0)) for y in (0, 5)]
        >>> tc.time_of_impact(square, (0, 0, 0), square, drives).found
        array([ True, False])
        """
        return ~np.isnan(self.time)


@_result
class Conflict(NamedTuple):
    """An interval of time in which two moving bodies meet.

    impact: Its begin, an Impact.
    end: When they are apart again, or when time ends.
    budget_ended: Whether a search ended early within this interval.
    meets_at_end: Whether they still meet at the end.

    >>> square = tc.Polygon.box(2, 2)
    >>> drive = tc.Motion.translation((-6, 0, 0), (16, 0))
    >>> conflict, = tc.conflicts(square, (0, 0, 0), square, drive)
    >>> round(conflict.impact.time, 5), round(conflict.end, 5)
    (0.25, 0.5)
    """
    impact: Impact
    end: float
    budget_ended: bool
    meets_at_end: bool


@_result
class LeastDistance(NamedTuple):
    """The least distance of two moving bodies.

    distance: A length at that time, less the margin; 0 if they meet.
    lower_bound: No distance on the way is less.
    time: When.
    point_a: The point of a nearest to b then.
    point_b: The point of b nearest to a then.
    edge_a: The edge of a that point_a lies on, or -1.
    edge_b: The edge of b that point_b lies on, or -1.
    budget_ended: Whether a search ended early.

    >>> square = tc.Polygon.box(2, 2)
    >>> drive = tc.Motion.translation((-6, 5, 0), (8, 0))
    >>> round(tc.least_distance(square, (0, 0, 0), square, drive).distance, 5)
    3.0
    """
    distance: Floats
    lower_bound: Floats
    time: Floats
    point_a: Vectors
    point_b: Vectors
    edge_a: Ints
    edge_b: Ints
    budget_ended: Bools


@_result
class RayHit(NamedTuple):
    """Where a ray first meets a region.

    fraction: The share of the ray before the hit, from 0 to 1.
    point: The point of the hit.
    normal: A unit vector at right angles to the edge, against the ray.
    edge: The edge, or -1 where the ray starts in the region.

    >>> tc.cast_ray(tc.Polygon.box(2, 2), (0, 0, 0), (-3, 0), (1, 0)).fraction
    0.5
    """
    fraction: Floats
    point: Vectors
    normal: Vectors
    edge: Ints

    @property
    def found(self) -> Any:
        """Whether the ray hits.

        >>> tc.cast_ray(tc.Polygon.box(2, 2), (0, 0, 0), (-3, 0), [(1, 0), (-3, 5)]).found
        array([ True, False])
        """
        return ~np.isnan(self.fraction)


@_result
class RayInterval(NamedTuple):
    """A part of a ray that is in a region.

    begin: A RayHit where the ray enters the region.
    end: A RayHit where it leaves.

    >>> inside, = tc.cast_ray_all(tc.Polygon.box(2, 2), (0, 0, 0), (-3, 0), (3, 0))
    >>> inside.begin.point.tolist(), inside.end.point.tolist()
    ([-1.0, 0.0], [1.0, 0.0])
    """
    begin: RayHit
    end: RayHit


@_result
class Exit(NamedTuple):
    """When the bodies of a Scene stop covering a moving polygon.

    time: They cover it until then.
    point: Where the polygon leaves them.
    budget_ended: Whether the search ended early: they may cover it for longer.

    >>> scene = tc.Scene()
    >>> lane = scene.add(tc.Polygon.box(10, 3), (0, 0, 0))
    >>> round(scene.first_exit(tc.Polygon.box(2, 1), tc.Motion.translation((0, 0, 0), (8, 0))).time, 5)
    0.5
    """
    time: Floats
    point: Vectors
    budget_ended: Bools

    @property
    def found(self) -> Any:
        """Whether the polygon leaves at all.

        >>> scene = tc.Scene()
        >>> lane = scene.add(tc.Polygon.box(10, 3), (0, 0, 0))
        >>> ways = [tc.Motion.translation((0, 0, 0), (x, 0)) for x in (1, 8)]
        >>> scene.first_exit(tc.Polygon.box(2, 1), ways).found
        array([False,  True])
        """
        return ~np.isnan(self.time)


@_result
class SelfCrossing(NamedTuple):
    """A place where the rings of a polygon cross or repeat.

    kind: What is there.
    point: Where, in the polygon's frame; rounded for CROSSING, otherwise a vertex.
    ring_a: A ring, by its number in Polygon.rings.
    ring_b: The other ring, or the same one.
    edge_a: The edge of ring_a.
    edge_b: The edge of ring_b.
    text: A sentence in plain words.

    >>> bow = tc.Polygon([(0, 0), (2, 2), (2, 0), (0, 2)])
    >>> tc.self_crossings(bow)[0].kind.name
    'CROSSING'
    """
    kind: SelfCrossingKind
    point: Vectors
    ring_a: int
    ring_b: int
    edge_a: int
    edge_b: int
    text: str


@_result
class CoveringTriangle(NamedTuple):
    """The triangles of a polygon's covering, as arrays, an edge a row.

    s: The covering's origin, (n, 2).
    v: Where the edges start, (n, 2).
    w: Where the edges end, (n, 2).
    sign: The signs of the triangles' areas, (n,).

    >>> tricover.paper.covering(tc.Polygon.box(2, 2)).sign
    array([1, 1, 1, 1], dtype=int32)
    """
    s: Vectors
    v: Vectors
    w: Vectors
    sign: NDArray[np.int32]


Body.__module__ = "tricover"
