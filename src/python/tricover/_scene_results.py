# SPDX-License-Identifier: BSD-3-Clause
"""Results of a Scene's queries: tuples of bodies and of what _results.py has."""
from typing import Any, NamedTuple

from ._enums import Touching
from ._results import Body, Conflict, Contact, Distance, Impact, LeastDistance, RayHit, RayInterval, _result

__all__ = ["BodyDistance", "BodyImpact", "BodyLeastDistance", "BodyOptions", "BodyPair", "BodyRayHit", "BodyRayInterval",
           "PairConflict", "PairContact", "PairImpact"]


@_result
class BodyOptions(NamedTuple):
    """The properties of a body beside its polygon and pose.

    margin: A length by which every query inflates the body; below 0, an overlap that is allowed.
    category: Bits: the categories of the body.
    mask: Bits: the categories that the body meets.
    touching: Whether a body that only touches this one collides with it.

    >>> scene = tc.Scene()
    >>> body = scene.add(tc.Polygon.box(1, 1), (0, 0, 0), margin=0.5)
    >>> scene.options(body).margin
    0.5
    """
    margin: float
    category: int
    mask: int
    touching: Touching


@_result
class BodyDistance(NamedTuple):
    """A body of a Scene, and how far a polygon is from it.

    body: The body, or NO_BODY in an array.
    result: A Distance: a is the query's polygon, b the body.

    >>> scene = tc.Scene()
    >>> body = scene.add(tc.Polygon.box(2, 2), (0, 0, 0))
    >>> scene.nearest(tc.Polygon.box(2, 2), (5, 0, 0)).result.distance
    3.0
    """
    body: Any
    result: Distance


@_result
class BodyLeastDistance(NamedTuple):
    """The body of a Scene that a moving polygon comes nearest to.

    body: The body, or NO_BODY in an array.
    least: A LeastDistance: a is the query's polygon, b the body.

    >>> scene = tc.Scene()
    >>> body = scene.add(tc.Polygon.box(2, 2), (0, 0, 0))
    >>> drive = tc.Motion.translation((-6, 5, 0), (8, 0))
    >>> round(scene.least_distance(tc.Polygon.box(2, 2), drive).least.distance, 5)
    3.0
    """
    body: Any
    least: LeastDistance


@_result
class BodyImpact(NamedTuple):
    """The body of a Scene that a moving polygon meets first.

    body: The body, or NO_BODY in an array.
    impact: An Impact: a is the query's polygon, b the body.

    >>> scene = tc.Scene()
    >>> body = scene.add(tc.Polygon.box(2, 2), (0, 0, 0))
    >>> scene.first_impact(tc.Polygon.box(2, 2), tc.Motion.translation((-6, 0, 0), (8, 0))).body == body
    True
    """
    body: Any
    impact: Impact


@_result
class BodyRayHit(NamedTuple):
    """The body of a Scene that a ray meets first.

    body: The body, or NO_BODY in an array.
    hit: A RayHit.

    >>> scene = tc.Scene()
    >>> body = scene.add(tc.Polygon.box(2, 2), (0, 0, 0))
    >>> scene.cast_ray((-3, 0), (1, 0)).hit.fraction
    0.5
    """
    body: Any
    hit: RayHit


@_result
class BodyRayInterval(NamedTuple):
    """A part of a ray that is in a body of a Scene.

    body: The body.
    interval: A RayInterval.

    >>> scene = tc.Scene()
    >>> body = scene.add(tc.Polygon.box(2, 2), (0, 0, 0))
    >>> [(part.body == body, part.interval.end.fraction) for part in scene.cast_ray_all((-3, 0), (1, 0))]
    [(True, 1.0)]
    """
    body: Body
    interval: RayInterval


@_result
class BodyPair(NamedTuple):
    """Two bodies of a Scene.

    first: The lower handle.
    second: The higher handle.

    >>> scene = tc.Scene()
    >>> bodies = scene.add(tc.Polygon.box(2, 2), [(0, 0, 0), (1, 0, 0)])
    >>> scene.collisions()
    [BodyPair(first=Body(0), second=Body(1))]
    """
    first: Body
    second: Body


@_result
class PairContact(NamedTuple):
    """A contact of two bodies of a Scene.

    pair: A BodyPair.
    contact: A Contact: a is pair.first, b is pair.second.

    >>> scene = tc.Scene()
    >>> bodies = scene.add(tc.Polygon.box(2, 2), [(0, 0, 0), (1.5, 0, 0)])
    >>> [found.contact.depth for found in scene.contacts()]
    [0.5]
    """
    pair: BodyPair
    contact: Contact


@_result
class PairImpact(NamedTuple):
    """The impact of two bodies of a Scene.

    pair: A BodyPair.
    impact: An Impact: a is pair.first, b is pair.second.

    >>> scene = tc.Scene()
    >>> one, other = scene.add(tc.Polygon.box(2, 2), [(0, 0, 0), (9, 0, 0)])
    >>> [found.pair == (one, other) for found in scene.impacts([(one, tc.Motion.translation((0, 0, 0), (9, 0)))])]
    [True]
    """
    pair: BodyPair
    impact: Impact


@_result
class PairConflict(NamedTuple):
    """An interval of time in which two bodies of a Scene meet.

    pair: A BodyPair.
    conflict: A Conflict: a is pair.first, b is pair.second.

    >>> scene = tc.Scene()
    >>> one, other = scene.add(tc.Polygon.box(2, 2), [(0, 0, 0), (9, 0, 0)])
    >>> drive = tc.Trajectory.through([0, 18], [(0, 0, 0), (18, 0, 0)])
    >>> [round(found.conflict.end, 3) for found in scene.conflicts([(one, drive)])]
    [11.0]
    """
    pair: BodyPair
    conflict: Conflict
