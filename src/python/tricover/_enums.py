# SPDX-License-Identifier: BSD-3-Clause
"""Enumerations. They are ints, so that arrays of their numbers compare with members."""
from enum import IntEnum

__all__ = ["ContactDetail", "FillRule", "InfluenceKind", "Location", "SelfCrossingKind", "Simplify", "Touching"]


class ContactDetail(IntEnum):
    """How much of a contact is computed. Each level costs more than the one before.

    POINTS: where the outlines meet; depth and normal are 0.
    LOCAL_DEPTH: also the depth and the normal of each component of the overlap, as a simulation needs them.
    GLOBAL_DEPTH: also, if the overlap is one component, the shortest translation that separates the regions.

    >>> square = tc.Polygon.box(2, 2)
    >>> tc.contacts(square, (0, 0, 0), square, (1.5, 0, 0), detail=tc.ContactDetail.LOCAL_DEPTH)[0].depth
    0.5
    """
    POINTS = 0
    LOCAL_DEPTH = 1
    GLOBAL_DEPTH = 2


class FillRule(IntEnum):
    """Which points the rings of a polygon call inside, by how often they wind around the point.

    EVEN_ODD: where the winding number is odd.
    NON_ZERO: where the winding number isn't 0.

    >>> twice = [[(0, 0), (2, 0), (2, 2), (0, 2)], [(0, 0), (1, 0), (1, 1), (0, 1)]]
    >>> tc.Polygon(twice).area, tc.Polygon(twice, tc.FillRule.NON_ZERO).area
    (3.0, 4.0)
    """
    EVEN_ODD = 0
    NON_ZERO = 1


class InfluenceKind(IntEnum):
    """The influence areas of an edge, from the paper that tricover.paper is about.

    ONE_SIDED: from the edge's line to its parallel on the outer side.
    EXTENDED: within the length of the edge's line, on both sides.
    BOUNDED: EXTENDED, cut at the length beyond the edge's ends.

    >>> tc.InfluenceKind.BOUNDED.name
    'BOUNDED'
    """
    ONE_SIDED = 0
    EXTENDED = 1
    BOUNDED = 2


class Location(IntEnum):
    """Where a point is. locate() of many points returns an array of these numbers, which compares with them.

    >>> tc.locate(tc.Polygon.box(2, 2), [(0, 0), (1, 0), (5, 0)]) == tc.Location.INSIDE
    array([ True, False, False])
    """
    OUTSIDE = 0
    BOUNDARY = 1
    INSIDE = 2


class SelfCrossingKind(IntEnum):
    """What self_crossings() finds.

    CROSSING: Two edges cross at a point that is an end of neither.
    CROSSING_AT_VERTEX: Rings cross where a vertex is on another edge, or equal to another vertex.
    OVERLAP: Two edges run along each other for more than a point.
    REPEATED_RING: Two rings have the same vertices in the same cyclic order, forwards or backwards.
    NO_AREA: All vertices of a ring are on one line, or equal.
    HOLE_OUTSIDE: A ring runs the way that holes run, but the region is inside of it.

    >>> tc.self_crossings(tc.Polygon([(0, 0), (1, 0), (2, 0)]))[0].kind == tc.SelfCrossingKind.NO_AREA
    True
    """
    CROSSING = 0
    CROSSING_AT_VERTEX = 1
    OVERLAP = 2
    REPEATED_RING = 3
    NO_AREA = 4
    HOLE_OUTSIDE = 5


class Simplify(IntEnum):
    """On which side of its outline a simplified polygon may differ from the original.

    BOTH: on either side, by at most the tolerance.
    OUTWARDS: only outside; the simplified region covers the original.

    >>> disc = tc.Polygon([(np.cos(t), np.sin(t)) for t in np.arange(0, 6.28, 0.01)])
    >>> tc.covers(disc.simplified(0.01, tc.Simplify.OUTWARDS), (0, 0, 0), disc, (0, 0, 0))
    True
    """
    BOTH = 0
    OUTWARDS = 1


class Touching(IntEnum):
    """Whether regions that only touch collide.

    COLLIDES: yes, the regions are closed.
    ALLOWED: no, they collide if their interiors meet.

    >>> square = tc.Polygon.box(2, 2)
    >>> tc.collide(square, (0, 0, 0), square, (2, 0, 0), touching=tc.Touching.ALLOWED)
    False
    """
    COLLIDES = 0
    ALLOWED = 1


for _name in __all__:
    globals()[_name].__module__ = "tricover"
