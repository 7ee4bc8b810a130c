from typing import Any, Dict, List, Mapping, Optional, Sequence, Tuple, Union, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._enums import ContactDetail, FillRule, Location, Simplify, Touching
from ._results import (Body, Contact, Crossing, Conflict, Depth, Distance, Excess, Exit, Impact, LeastDistance, Penetration, RayHit,
                       RayInterval, SelfCrossing, SignedDistance)
from ._scene_results import (BodyDistance, BodyImpact, BodyLeastDistance, BodyOptions, BodyPair, BodyRayHit, BodyRayInterval,
                             PairConflict, PairContact, PairImpact)

_PosesLike = Union[Poses, Sequence[Poses], ArrayLike]
_Answers = Union[bool, NDArray[np.bool_]]
_AnyMotion = Union[Motion, Sequence[Motion], Trajectory, Sequence[Trajectory], _PosesLike]
_BodyMotions = Union[Sequence[Tuple[int, Motion]], Sequence[Tuple[int, Trajectory]], Mapping[int, Motion], Mapping[int, Trajectory]]

__version__: str
NO_BODY: int
EVERY_CATEGORY: int
RIGID_TOLERANCE: float

class Polygon:
    """A closed region of the plane: every point that the fill rule calls inside, and every point of an edge.

    A polygon never changes. It compares by its rings. Make one once and use it for many queries: what speeds them up is kept
    with it. Any object with __geo_interface__, as Shapely's, GeoPandas' and Fiona's have, is taken for rings.

    >>> tc.Polygon([(0, 0), (4, 0), (4, 3)]).area
    6.0
    """
    def __init__(self, rings: Any, fill_rule: FillRule = FillRule.EVEN_ODD) -> None:
        """Makes a polygon from one ring, (n, 2), or from a sequence of rings, or from a geometry.

        Rings aren't closed: the last vertex is joined to the first. By default, a ring within a ring is a hole.

        >>> frame = tc.Polygon([[(0, 0), (4, 0), (4, 4), (0, 4)], [(1, 1), (3, 1), (3, 3), (1, 3)]])
        >>> frame.area
        12.0
        """
    @staticmethod
    def box(width: float, height: float) -> Polygon:
        """Returns the rectangle of that width, along x, and height, around the origin of its frame.

        >>> tc.Polygon.box(4, 2).bounds
        array([[-2., -1.],
               [ 2.,  1.]])
        """
    @staticmethod
    def point(p: ArrayLike) -> Polygon:
        """Returns the polygon that is a point, (2,). With a margin of r it is an exact disc of radius r.

        >>> tc.collide(tc.Polygon.point((0, 0)), (0, 0, 0), tc.Polygon.point((5, 0)), (0, 0, 0), margin=5)
        True
        """
    @staticmethod
    def segment(p: ArrayLike, q: ArrayLike) -> Polygon:
        """Returns the polygon that is the segment from p to q, each (2,). With a margin it is an exact capsule.

        >>> tc.distance(tc.Polygon.segment((0, 0), (4, 0)), (0, 0, 0), tc.Polygon.point((2, 3)), (0, 0, 0)).distance
        3.0
        """
    @staticmethod
    def from_geo(geometry: Any) -> Polygon:
        """Returns the region of an object with __geo_interface__, or of such a dictionary.

        Polygon, MultiPolygon, Feature, FeatureCollection and GeometryCollection are read. Parts that overlap are one region:
        their overlap is no hole. A third coordinate is dropped.

        >>> tc.Polygon.from_geo({"type": "Polygon", "coordinates": [[(0, 0), (2, 0), (2, 2), (0, 2), (0, 0)]]}).area
        4.0
        """
    @property
    def __geo_interface__(self) -> Dict[str, Any]:
        """The region as a dictionary: a Polygon or a MultiPolygon of tuples, with closed rings and holes in their parts.

        Shapely, GeoPandas and json.dumps() take it. A region that GeoJSON can't say is a ValueError: a complement, and rings
        that cross.

        >>> tc.Polygon([(0, 0), (2, 0), (0, 2)]).__geo_interface__
        {'type': 'Polygon', 'coordinates': (((0.0, 0.0), (2.0, 0.0), (0.0, 2.0), (0.0, 0.0)),)}
        """
    @property
    def rings(self) -> List[NDArray[np.float64]]:
        """The rings as they were given, each (n, 2).

        >>> tc.Polygon([(0, 0), (2, 0), (0, 2)]).rings
        [array([[0., 0.],
               [2., 0.],
               [0., 2.]])]
        """
    @property
    def fill_rule(self) -> FillRule:
        """The fill rule as it was given.

        >>> tc.Polygon.box(1, 1).fill_rule == tc.FillRule.EVEN_ODD
        True
        """
    @property
    def id(self) -> int:
        """A number that tells polygons apart while the process lives. Copies share it.

        >>> tc.Polygon.box(1, 1).id == tc.Polygon.box(1, 1).id
        False
        """
    @property
    def vertex_count(self) -> int:
        """How many vertices all rings have.

        >>> tc.Polygon.box(1, 1).vertex_count
        4
        """
    @property
    def edge_count(self) -> int:
        """How many edges there are: their numbers are below it.

        >>> tc.Polygon.box(1, 1).edge_count
        4
        """
    @property
    def is_complement(self) -> bool:
        """Whether complement() made it, and its region is unbounded.

        >>> tc.Polygon.box(1, 1).complement().is_complement
        True
        """
    @property
    def is_convex(self) -> bool:
        """Whether it is one convex ring that has an area. Exact.

        >>> tc.Polygon.box(1, 1).is_convex
        True
        """
    @property
    def covering_origin(self) -> NDArray[np.float64]:
        """A point near the centroid, (2,), from which `radius` is measured.

        >>> tc.Polygon.box(1, 1).covering_origin
        array([0., 0.])
        """
    @property
    def radius(self) -> float:
        """The radius of a disc around covering_origin that holds all vertices, rounded up.

        >>> round(tc.Polygon.box(6, 8).radius, 6)
        5.0
        """
    @property
    def area(self) -> float:
        """The area of the region, by its fill rule; infinity for a complement.

        >>> tc.Polygon.box(4, 2).area
        8.0
        """
    @property
    def centroid(self) -> NDArray[np.float64]:
        """The region's centre of gravity, (2,).

        >>> tc.Polygon([(0, 0), (4, 0), (4, 2), (0, 2)]).centroid
        array([2., 1.])
        """
    @property
    def bounds(self) -> NDArray[np.float64]:
        """The lowest and the highest x and y, (2, 2), in its frame. Exact.

        >>> tc.Polygon([(0, 0), (4, 0), (4, 2)]).bounds
        array([[0., 0.],
               [4., 2.]])
        """
    def bounds_at(self, pose: _PosesLike) -> NDArray[np.float64]:
        """Returns bounds in the world under a pose, (2, 2), or under each of many poses, (n, 2, 2).

        >>> tc.Polygon.box(4, 2).bounds_at((10, 0, 0))
        array([[ 8., -1.],
               [12.,  1.]])
        """
    def complement(self) -> Polygon:
        """Returns the closure of what is outside of the region, which is unbounded.

        Every query takes it but penetration(), and contacts() with GLOBAL_DEPTH.

        >>> tc.collide(tc.Polygon.box(9, 9).complement(), (0, 0, 0), tc.Polygon.box(1, 1), (0, 0, 0))
        False
        """
    def translated(self, by: ArrayLike) -> Polygon:
        """Returns the polygon with every vertex moved by a vector, (2,), rounded.

        >>> tc.Polygon.box(2, 2).translated((5, 0)).centroid
        array([5., 0.])
        """
    def scaled(self, factor: float) -> Polygon:
        """Returns the polygon larger or smaller about the origin of its frame, rounded.

        >>> tc.Polygon.box(2, 2).scaled(3).area
        36.0
        """
    def transformed(self, pose: _PosesLike) -> Polygon:
        """Returns the polygon that this one is under one pose, rounded.

        >>> tc.Polygon.box(2, 2).transformed((5, 0, 0)).centroid
        array([5., 0.])
        """
    def simplified(self, tolerance: float, side: Simplify = Simplify.BOTH) -> Polygon:
        """Returns a polygon with fewer vertices. Neither region is farther than the tolerance from the other.

        With Simplify.OUTWARDS the result covers this polygon.

        >>> tc.Polygon([(0, 0), (2, 0.001), (4, 0), (4, 4), (0, 4)]).simplified(0.01).vertex_count
        4
        """
    def edge(self, edge: int) -> NDArray[np.float64]:
        """Returns the two ends of an edge, (2, 2). Edges are numbered through the rings, from 0.

        >>> tc.Polygon([(0, 0), (2, 0), (0, 2)]).edge(1)
        array([[2., 0.],
               [0., 2.]])
        """
    def edge_start(self, edge: int) -> NDArray[np.float64]:
        """Returns where an edge starts, (2,).

        >>> tc.Polygon([(0, 0), (2, 0), (0, 2)]).edge_start(1)
        array([2., 0.])
        """
    def edge_end(self, edge: int) -> NDArray[np.float64]:
        """Returns where an edge ends, (2,).

        >>> tc.Polygon([(0, 0), (2, 0), (0, 2)]).edge_end(1)
        array([0., 2.])
        """
    def __copy__(self) -> Polygon: ...
    def __deepcopy__(self, memo: Dict[Any, Any]) -> Polygon: ...
    def __hash__(self) -> int: ...

class Poses:
    """One pose, or many: where polygons are. numpy.asarray() gives their homogeneous matrices, (3, 3) or (n, 3, 3).

    >>> tc.Poses([(0, 0, 0), (1, 2, 0)]).positions
    array([[0., 0.],
           [1., 2.]])
    """
    def __init__(self, poses: _PosesLike) -> None:
        """Makes poses from x, y and heading in radians, (3,) or (n, 3), or joins a list of Poses.

        >>> len(tc.Poses([tc.pose_at(0, 0), tc.pose_at(1, 2)]))
        2
        """
    @staticmethod
    def from_matrices(matrices: ArrayLike) -> Poses:
        """Makes poses from homogeneous matrices, (3, 3) or (n, 3, 3). They may mirror, and must keep lengths.

        >>> mirror = tc.Poses.from_matrices(np.diag([-1, 1, 1]))
        >>> tc.Polygon([(1, 0), (2, 0), (2, 1)]).transformed(mirror).centroid[0] < 0
        True
        """
    @staticmethod
    def nearest_rigid(matrices: ArrayLike) -> Poses:
        """Returns the poses nearest to matrices, (3, 3) or (n, 3, 3): a scale and a shear are dropped.

        >>> tc.Poses.nearest_rigid(np.diag([2, 2, 1])) == tc.pose_at(0, 0)
        True
        """
    @property
    def is_one(self) -> bool:
        """Whether it is one pose, which has no length and no items.

        >>> tc.pose_at(1, 2).is_one
        True
        """
    @property
    def matrices(self) -> NDArray[np.float64]:
        """The homogeneous matrices, (3, 3) or (n, 3, 3).

        >>> tc.pose_at(1, 2).matrices[:, 2]
        array([1., 2., 1.])
        """
    @property
    def positions(self) -> NDArray[np.float64]:
        """Where the origins of the frames are, (2,) or (n, 2).

        >>> tc.pose_at(1, 2).positions
        array([1., 2.])
        """
    @property
    def headings(self) -> Union[float, NDArray[np.float64]]:
        """The headings of the frames' x axes in radians, one or (n,).

        >>> tc.pose_at(1, 2, 0.5).headings
        0.5
        """
    def __len__(self) -> int: ...
    @overload
    def __getitem__(self, index: int) -> Poses: ...
    @overload
    def __getitem__(self, index: slice) -> Poses: ...
    def __array__(self, dtype: Any = None, copy: Any = None) -> NDArray[np.float64]: ...
    def __hash__(self) -> int: ...

def pose_at(x: float, y: float, heading: float = 0.0) -> Poses:
    """Returns the pose of a body at (x, y) whose frame is rotated by `heading`, in radians, counter-clockwise.

    A heading within rounding of a quarter turn gives exact zeros and ones. Arrays of x, y and heading do the same.

    >>> tc.pose_at(0, 0, np.pi / 2).matrices[0, 0]
    0.0
    """

class Motion:
    """A planar rigid motion from time 0 to time 1. The polygon rotates about a pivot, and the pivot moves.

    >>> tc.Motion.translation((0, 0, 0), (4, 0)).at(0.5)
    pose_at(2.0, 0.0, 0.0)
    """
    def __init__(self, start: _PosesLike, shift: ArrayLike = (0, 0), angle: float = 0.0, pivot: ArrayLike = (0, 0),
                 shift_2: ArrayLike = (0, 0), shift_3: ArrayLike = (0, 0), angle_2: float = 0.0, angle_3: float = 0.0) -> None:
        """Makes a motion from its terms: `shift` and `angle` times t, the others times t squared and t cubed.

        >>> tc.Motion((0, 0, 0), shift=(4, 0), shift_2=(0, 4)).at(0.5)
        pose_at(2.0, 1.0, 0.0)
        """
    @staticmethod
    def still(pose: _PosesLike) -> Motion:
        """Returns a motion that stays at a pose.

        >>> tc.Motion.still((1, 2, 0)).at(1)
        pose_at(1.0, 2.0, 0.0)
        """
    @staticmethod
    def translation(start: _PosesLike, shift: ArrayLike) -> Motion:
        """Returns a translation by a vector, (2,), without a rotation.

        >>> tc.Motion.translation((0, 0, 0), (4, 0)).at(1)
        pose_at(4.0, 0.0, 0.0)
        """
    @staticmethod
    def arc(start: _PosesLike, centre: ArrayLike, angle: float) -> Motion:
        """Returns a rotation about a point of the world, (2,), by an angle in radians, counter-clockwise.

        >>> tc.Motion.arc((2, 0, 0), (0, 0), np.pi).at(1).positions.round(9)
        array([-2.,  0.])
        """
    @staticmethod
    def between(start: _PosesLike, end: _PosesLike, pivot: ArrayLike = (0, 0)) -> Motion:
        """Returns a motion from pose to pose by the shorter rotation. The pivot moves on a straight line.

        >>> tc.Motion.between((0, 0, 0), (4, 0, 1)).at(0.5)
        pose_at(2.0, 0.0, 0.5)
        """
    @staticmethod
    def spline(begin: ArrayLike, begin_velocity: ArrayLike, end: ArrayLike, end_velocity: ArrayLike,
               pivot: ArrayLike = (0, 0)) -> Motion:
        """Returns the cubic Hermite spline. Each argument is x, y and heading, or their velocities, (3,).

        >>> tc.Motion.spline((0, 0, 0), (4, 0, 0), (4, 0, 0), (4, 0, 0)).at(0.5)
        pose_at(2.0, 0.0, 0.0)
        """
    @staticmethod
    def b_spline(positions: ArrayLike, angles: ArrayLike, pivot: ArrayLike = (0, 0)) -> Motion:
        """Returns one segment of a uniform cubic B-spline, by four control points, (4, 2), and angles, (4,).

        >>> tc.Motion.b_spline([(0, 0), (1, 0), (2, 0), (3, 0)], [0, 0, 0, 0]).at(0.5).positions.round(9)
        array([1.5, 0. ])
        """
    @property
    def start(self) -> Poses:
        """The pose at time 0.

        >>> tc.Motion.still((1, 2, 0)).start
        pose_at(1.0, 2.0, 0.0)
        """
    @property
    def shift(self) -> NDArray[np.float64]:
        """How far the pivot moves by the linear term, (2,).

        >>> tc.Motion.translation((0, 0, 0), (4, 0)).shift
        array([4., 0.])
        """
    @property
    def angle(self) -> float:
        """How far the polygon rotates by the linear term, in radians.

        >>> tc.Motion.arc((2, 0, 0), (0, 0), 0.5).angle
        0.5
        """
    @property
    def pivot(self) -> NDArray[np.float64]:
        """The pivot in the polygon's frame, (2,).

        >>> tc.Motion.arc((2, 0, 0), (0, 0), 0.5).pivot
        array([-2.,  0.])
        """
    @property
    def shift_2(self) -> NDArray[np.float64]:
        """The factor of t squared in the pivot's translation, (2,).

        >>> tc.Motion((0, 0, 0), shift_2=(1, 0)).shift_2
        array([1., 0.])
        """
    @property
    def shift_3(self) -> NDArray[np.float64]:
        """The factor of t cubed in the pivot's translation, (2,).

        >>> tc.Motion((0, 0, 0), shift_3=(1, 0)).shift_3
        array([1., 0.])
        """
    @property
    def angle_2(self) -> float:
        """The factor of t squared in the rotation, in radians.

        >>> tc.Motion((0, 0, 0), angle_2=0.5).angle_2
        0.5
        """
    @property
    def angle_3(self) -> float:
        """The factor of t cubed in the rotation, in radians.

        >>> tc.Motion((0, 0, 0), angle_3=0.5).angle_3
        0.5
        """
    def at(self, time: ArrayLike) -> Poses:
        """Returns the pose at a time, or the poses at many times, (n,).

        >>> tc.Motion.translation((0, 0, 0), (4, 0)).at([0, 0.5, 1]).positions[:, 0]
        array([0., 2., 4.])
        """
    def part(self, from_time: float, until: float) -> Motion:
        """Returns the same motion from one time to another, which are its 0 and 1.

        >>> tc.Motion.translation((0, 0, 0), (4, 0)).part(0.5, 1).at(0)
        pose_at(2.0, 0.0, 0.0)
        """
    def __hash__(self) -> int: ...

class Trajectory:
    """Motions one after the other, by a clock of yours: seconds, say.

    Before its begin a body rests where it begins, unless it appears then. After its end it rests where it ends, unless it
    vanishes then.

    >>> tc.Trajectory.through([0, 10, 20], [(0, 0, 0), (5, 0, 0), (5, 5, 0)]).at(15)
    pose_at(5.0, 2.5, 0.0)
    """
    def __init__(self, legs: Union[Sequence[Tuple[float, float, Motion]], Poses]) -> None:
        """Makes a trajectory from legs (begin, end, motion), or from one pose as Poses, where a body always rests.

        >>> tc.Trajectory([(10, 20, tc.Motion.translation((0, 0, 0), (4, 0)))]).at(15)
        pose_at(2.0, 0.0, 0.0)
        """
    @staticmethod
    def through(times: ArrayLike, waypoints: _PosesLike, pivot: ArrayLike = (0, 0)) -> Trajectory:
        """Returns the trajectory on straight lines from waypoint to waypoint, at times (n,) that increase.

        Waypoints (n, 3) are x, y and heading; it rotates by the headings given, and 0 to 6 is nearly a full turn. Poses are
        joined by the shorter rotation. It waits where two waypoints are the same.

        >>> tc.Trajectory.through([0, 10], [(0, 0, 0), (5, 0, 6)]).at(5)
        pose_at(2.5, 0.0, 3.0)
        """
    @staticmethod
    def spline(times: ArrayLike, places: ArrayLike, velocities: ArrayLike, pivot: ArrayLike = (0, 0)) -> Trajectory:
        """Returns the cubic Hermite spline from knot to knot: times (n,), places and their rates by the clock (n, 3).

        >>> tc.Trajectory.spline([0, 2], [(0, 0, 0), (2, 0, 0)], [(1, 0, 0), (1, 0, 0)]).at(1)
        pose_at(1.0, 0.0, 0.0)
        """
    def appearing(self) -> Trajectory:
        """Returns the same trajectory of a body that is absent before it begins, and meets nothing then.

        >>> tc.Trajectory.through([10, 20], [(0, 0, 0), (5, 0, 0)]).appearing().is_there(5)
        False
        """
    def vanishing(self) -> Trajectory:
        """Returns the same trajectory of a body that is absent after it ends, and meets nothing then.

        >>> tc.Trajectory.through([10, 20], [(0, 0, 0), (5, 0, 0)]).vanishing().is_there(25)
        False
        """
    @property
    def legs(self) -> List[Tuple[float, float, Motion]]:
        """The legs (begin, end, motion) in order.

        >>> [leg[:2] for leg in tc.Trajectory.through([0, 1, 3], [(0, 0, 0), (5, 0, 0), (6, 0, 0)]).legs]
        [(0.0, 1.0), (1.0, 3.0)]
        """
    @property
    def begin(self) -> float:
        """When it begins; minus infinity where the body always rests.

        >>> tc.Trajectory.through([10, 20], [(0, 0, 0), (5, 0, 0)]).begin
        10.0
        """
    @property
    def end(self) -> float:
        """When it ends; infinity where the body always rests.

        >>> tc.Trajectory.through([10, 20], [(0, 0, 0), (5, 0, 0)]).end
        20.0
        """
    @property
    def appears(self) -> bool:
        """Whether the body is absent before the begin.

        >>> tc.Trajectory.through([10, 20], [(0, 0, 0), (5, 0, 0)]).appears
        False
        """
    @property
    def vanishes(self) -> bool:
        """Whether the body is absent after the end.

        >>> tc.Trajectory.through([10, 20], [(0, 0, 0), (5, 0, 0)]).vanishing().vanishes
        True
        """
    @property
    def rests(self) -> bool:
        """Whether it was made of a pose.

        >>> tc.Trajectory(tc.pose_at(1, 2)).rests
        True
        """
    def is_there(self, time: ArrayLike) -> _Answers:
        """Returns whether the body is there at a time, or at each of many, (n,).

        >>> tc.Trajectory.through([10, 20], [(0, 0, 0), (5, 0, 0)]).appearing().is_there([5, 15, 25])
        array([False,  True,  True])
        """
    def at(self, time: ArrayLike) -> Poses:
        """Returns the pose at a time, or the poses at many times, (n,). Infinity is a time, too.

        >>> tc.Trajectory.through([10, 20], [(0, 0, 0), (5, 0, 0)]).at([0, 15, 99]).positions[:, 0]
        array([0. , 2.5, 5. ])
        """
    def part(self, from_time: float, until: float) -> Motion:
        """Returns the motion from one time to a later one, between which no leg ends.

        >>> tc.Trajectory.through([10, 20], [(0, 0, 0), (4, 0, 0)]).part(15, 20).at(0)
        pose_at(2.0, 0.0, 0.0)
        """
    def __hash__(self) -> int: ...

def prepare(polygon: Polygon) -> None:
    """Builds all that speeds up queries of a polygon now. Otherwise queries build it when it pays; no answer changes.

    >>> tc.prepare(tc.Polygon.box(1, 1))
    """

def collide(a: Polygon, pose_a: _PosesLike, b: Polygon, pose_b: _PosesLike, margin: float = 0.0, tolerance: float = 0.0,
            touching: Touching = Touching.COLLIDES, threads: int = 0) -> _Answers:
    """Returns whether two regions share a point or, with a margin, are no farther apart than the margin. Exact.

    A margin below 0 allows an overlap. With a tolerance, the answer for a distance between margin and margin + tolerance may be
    either, and comes faster. Of many poses, an array of bool, (n,).

    >>> square = tc.Polygon.box(2, 2)
    >>> tc.collide(square, (0, 0, 0), square, [(1, 0, 0), (2, 0, 0), (3, 0, 0)])
    array([ True,  True, False])
    """

def covers(area: Polygon, pose_area: _PosesLike, part: Polygon, pose_part: _PosesLike, margin: float = 0.0,
           threads: int = 0) -> _Answers:
    """Returns whether an area holds all of a part, inflated by the margin. Exact. Of many poses, (n,).

    With a margin below 0 the part may stick out by so much.

    >>> tc.covers(tc.Polygon.box(9, 9), (0, 0, 0), tc.Polygon.box(1, 1), [(4, 0, 0), (5, 0, 0)])
    array([ True, False])
    """

@overload
def locate(polygon: Polygon, points: ArrayLike, threads: int = 0) -> Union[Location, NDArray[np.int8]]:
    """Returns where points lie: a Location of one, (2,), and the numbers of many, (n, 2). Exact.

    Points are in the polygon's frame or, with a pose before them, in the world. Either may be one for many.

    >>> square = tc.Polygon.box(2, 2)
    >>> tc.locate(square, (0, 0)).name
    'INSIDE'
    >>> tc.locate(square, (10, 0, 0), [(0, 0), (10, 0)]) == tc.Location.INSIDE
    array([False,  True])
    """
@overload
def locate(polygon: Polygon, pose: _PosesLike, points: ArrayLike, threads: int = 0) -> Union[Location, NDArray[np.int8]]: ...

def distance(a: Polygon, pose_a: _PosesLike, b: Polygon, pose_b: _PosesLike, margin: float = 0.0, relative_error: float = 0.0,
             absolute_error: float = 0.0, threads: int = 0) -> Distance:
    """Returns the distance of two regions, less the margin, and where it is. It is 0 exactly where collide() is true.

    The distance may be more than the truth by the errors that are allowed. Of many poses, a Distance of arrays.

    >>> square = tc.Polygon.box(2, 2)
    >>> tc.distance(square, (0, 0, 0), square, (5, 0, 0)).distance
    3.0
    """

def distance_within(a: Polygon, pose_a: _PosesLike, b: Polygon, pose_b: _PosesLike, limit: float, margin: float = 0.0,
                    relative_error: float = 0.0, absolute_error: float = 0.0, threads: int = 0) -> Optional[Distance]:
    """Returns the distance where it is at most `limit`, and None where it is more. Of many poses, `found` tells.

    >>> square = tc.Polygon.box(2, 2)
    >>> tc.distance_within(square, (0, 0, 0), square, (5, 0, 0), limit=1) is None
    True
    """

def signed_distance(a: Polygon, pose_a: _PosesLike, b: Polygon, pose_b: _PosesLike, margin: float = 0.0,
                    relative_error: float = 0.0, absolute_error: float = 0.0, threads: int = 0) -> SignedDistance:
    """Returns the distance of two regions, or minus their depth() where they overlap; less the margin.

    >>> square = tc.Polygon.box(2, 2)
    >>> tc.signed_distance(square, (0, 0, 0), square, (1.5, 0, 0)).distance
    -0.5
    """

def penetration(a: Polygon, pose_a: _PosesLike, b: Polygon, pose_b: _PosesLike, margin: float = 0.0,
                touching: Touching = Touching.COLLIDES, threads: int = 0) -> Optional[Penetration]:
    """Returns the shortest translation of b that separates two overlapping regions; None if they are apart.

    With a margin the translation separates them by more than the margin. Of many poses, a Penetration of arrays; `found` tells
    which overlap.

    >>> square = tc.Polygon.box(2, 2)
    >>> tc.penetration(square, (0, 0, 0), square, (1.5, 0, 0)).normal
    array([1., 0.])
    """

def depth(a: Polygon, pose_a: _PosesLike, b: Polygon, pose_b: _PosesLike, threads: int = 0) -> Depth:
    """Returns the largest depth of a point of either region in the other one. 0 where they touch or are apart.

    >>> bar = tc.Polygon.box(9, 1)
    >>> round(tc.depth(bar, (0, 0, 0), bar, (0, 0, np.pi / 2)).depth, 9)
    0.5
    """

def excess(part: Polygon, pose_part: _PosesLike, area: Polygon, pose_area: _PosesLike, threads: int = 0) -> Excess:
    """Returns how far a part sticks out of an area: the directed Hausdorff distance of the regions.

    >>> tc.excess(tc.Polygon.box(1, 1), [(0, 0, 0), (5, 0, 0)], tc.Polygon.box(9, 9), (0, 0, 0)).distance
    array([0., 1.])
    """

def hausdorff_distance(a: Polygon, pose_a: _PosesLike, b: Polygon, pose_b: _PosesLike,
                       threads: int = 0) -> Union[float, NDArray[np.float64]]:
    """Returns the Hausdorff distance of two regions, a length.

    >>> square = tc.Polygon.box(2, 2)
    >>> tc.hausdorff_distance(square, (0, 0, 0), square, (0.5, 0, 0))
    0.5
    """

def contacts(a: Polygon, pose_a: _PosesLike, b: Polygon, pose_b: _PosesLike, margin: float = 0.0, most: Optional[int] = None,
             detail: ContactDetail = ContactDetail.LOCAL_DEPTH, touching: Touching = Touching.COLLIDES,
             threads: int = 0) -> Union[List[Contact], List[List[Contact]]]:
    """Returns one contact for each connected component of the overlap, the `most` deepest first. Of many poses, lists.

    With a margin, regions that are apart by less have one contact, where they are nearest.

    >>> square = tc.Polygon.box(2, 2)
    >>> [contact.depth for contact in tc.contacts(square, (0, 0, 0), square, (1.5, 0, 0))]
    [0.5]
    """

def crossings(a: Polygon, pose_a: _PosesLike, b: Polygon, pose_b: _PosesLike, margin: float = 0.0,
              touching: Touching = Touching.COLLIDES, threads: int = 0) -> Union[Crossing, List[Crossing]]:
    """Returns all pairs of edges that are no farther apart than the margin, as arrays. Of many poses, a list.

    >>> square = tc.Polygon.box(2, 2)
    >>> sorted(tc.crossings(square, (0, 0, 0), square, (1, 1, 0)).edge_a.tolist())
    [1, 2]
    """

def cast_ray(polygon: Polygon, pose: _PosesLike, from_point: ArrayLike, to_point: ArrayLike, margin: float = 0.0,
             threads: int = 0) -> Optional[RayHit]:
    """Returns where the segment from one point of the world to another first meets the region; None if it doesn't.

    Poses and points, (2,) or (n, 2), may be many: then a RayHit of arrays, and `found` tells. The margin inflates the region.

    >>> tc.cast_ray(tc.Polygon.box(2, 2), (0, 0, 0), (-3, 0), (3, 0)).point
    array([-1.,  0.])
    """

def cast_ray_all(polygon: Polygon, pose: _PosesLike, from_point: ArrayLike, to_point: ArrayLike, margin: float = 0.0,
                 threads: int = 0) -> Union[List[RayInterval], List[List[RayInterval]]]:
    """Returns all parts of a segment that are in the region, in order. Of many, lists.

    >>> [part.end.fraction for part in tc.cast_ray_all(tc.Polygon.box(2, 2), (0, 0, 0), (-2, 0), (2, 0))]
    [0.75]
    """

def time_of_impact(a: Polygon, motion_a: _AnyMotion, b: Polygon, motion_b: _AnyMotion, margin: float = 0.0,
                   time_error: float = 1e-6, ignore_initial: bool = False, threads: int = 0) -> Optional[Impact]:
    """Returns the first contact of two moving bodies, or None. No contact is missed.

    Each way is a Motion, a Trajectory or a pose where a body stays; a list of motions or of trajectories gives an Impact of
    arrays. The time is at most `time_error` early. `ignore_initial`: bodies that meet at the start count once they have parted.

    >>> square = tc.Polygon.box(2, 2)
    >>> drive = tc.Trajectory.through([0, 10], [(-6, 0, 0), (4, 0, 0)])
    >>> round(tc.time_of_impact(square, (0, 0, 0), square, drive).time, 5)
    4.0
    """

def conflicts(a: Polygon, motion_a: _AnyMotion, b: Polygon, motion_b: _AnyMotion, margin: float = 0.0, time_error: float = 1e-6,
              ignore_initial: bool = False, threads: int = 0) -> Union[List[Conflict], List[List[Conflict]]]:
    """Returns all intervals of time in which two moving bodies meet. Ways are those of time_of_impact().

    >>> square = tc.Polygon.box(2, 2)
    >>> drive = tc.Trajectory.through([0, 10], [(-6, 0, 0), (4, 0, 0)])
    >>> [round(conflict.end, 5) for conflict in tc.conflicts(square, (0, 0, 0), square, drive)]
    [8.0]
    """

def least_distance(a: Polygon, motion_a: _AnyMotion, b: Polygon, motion_b: _AnyMotion, margin: float = 0.0,
                   absolute_error: float = 1e-6, threads: int = 0) -> LeastDistance:
    """Returns the least distance of two moving bodies, with when and where it is. Ways are those of time_of_impact().

    The distance is at most `absolute_error`, a length, more than the least one.

    >>> square = tc.Polygon.box(2, 2)
    >>> drive = tc.Trajectory.through([0, 10], [(-6, 5, 0), (4, 5, 0)])
    >>> round(tc.least_distance(square, (0, 0, 0), square, drive).distance, 5)
    3.0
    """

class OccupancyMap:
    """A grid of square cells, as ROS's map_server and nav2 keep it, and where it is in the world.

    >>> grid = tc.OccupancyMap(np.array([[0, 100], [0, -1]], np.int8), resolution=0.5, pose=(10, 0, 0))
    >>> grid.outline().centroid
    array([10.75,  0.5 ])
    """
    def __init__(self, cells: ArrayLike, resolution: float = 1.0, pose: _PosesLike = (0, 0, 0), origin: ArrayLike = (0, 0)) -> None:
        """Makes a map from cells, (height, width) of int8, the lowest row first: 0 is free, 100 occupied, -1 unknown.

        `resolution` is the side of a cell. `pose` takes the grid's frame to the world, and `origin` is the corner of the first
        cell in that frame.

        >>> tc.OccupancyMap(np.zeros((2, 3), np.int8), resolution=0.5)
        <tricover.OccupancyMap of 2 x 3 cells of 0.5 at pose_at(0.0, 0.0, 0.0)>
        """
    @property
    def cells(self) -> NDArray[np.int8]:
        """The values of the cells, (height, width), the lowest row first.

        >>> tc.OccupancyMap(np.array([[0, 100]], np.int8)).cells
        array([[  0, 100]], dtype=int8)
        """
    @property
    def resolution(self) -> float:
        """The side of a cell, a length.

        >>> tc.OccupancyMap(np.zeros((2, 3), np.int8), resolution=0.5).resolution
        0.5
        """
    @property
    def pose(self) -> Poses:
        """From the grid's frame to the world.

        >>> tc.OccupancyMap(np.zeros((2, 3), np.int8), pose=(1, 2, 0)).pose
        pose_at(1.0, 2.0, 0.0)
        """
    @property
    def origin(self) -> NDArray[np.float64]:
        """The lower left corner of the first cell in the grid's frame, (2,).

        >>> tc.OccupancyMap(np.zeros((2, 3), np.int8)).origin
        array([0., 0.])
        """
    def outline(self, occupied: Optional[ArrayLike] = None) -> Optional[Polygon]:
        """Returns the occupied cells as one polygon with holes, in the world; None without any.

        By default all cells but 0 are occupied, unknown ones, too. `occupied`, (height, width), says otherwise.

        >>> grid = tc.OccupancyMap(np.array([[0, 100], [0, -1]], np.int8))
        >>> grid.outline().area, grid.outline(grid.cells == 100).area
        (2.0, 1.0)
        """

def outline(cells: ArrayLike, resolution: float = 1.0, origin: ArrayLike = (0, 0)) -> Optional[Polygon]:
    """Returns the cells that aren't 0, (height, width), the lowest row first, as one polygon with holes; None without any.

    Any numbers serve: 0.9 isn't 0, nor is NaN. `origin` is the corner of the first cell, (2,).

    >>> tc.outline([[0, 1, 1]], resolution=0.5, origin=(10, 0)).bounds
    array([[10.5,  0. ],
           [11.5,  0.5]])
    """

def read_occupancy_map(yaml: str) -> OccupancyMap:
    """Reads a map of ROS's map_server or nav2: the YAML file's path. Its outline() is where the map is in the world.

    >>> tc.read_occupancy_map("nowhere.yaml")
    Traceback (most recent call last):
    RuntimeError: ...
    """

def write_occupancy_map(map: OccupancyMap, yaml: str, image: str = "") -> None:
    """Writes a map's YAML file and its image, which read_occupancy_map() reads again. `image` ends in .pgm or .png.

    >>> tc.write_occupancy_map(tc.OccupancyMap(np.zeros((2, 2), np.int8)), "/nowhere/map.yaml")
    Traceback (most recent call last):
    RuntimeError: ...
    """

def rasterize(polygon: Polygon, pose: _PosesLike, map: OccupancyMap, margin: float = 0.0, tolerance: float = 0.0,
              touching: Touching = Touching.COLLIDES) -> NDArray[np.int64]:
    """Returns the cells of a map that a polygon at one pose meets, as indices into cells.ravel(), in ascending order.

    >>> hall = tc.OccupancyMap(np.zeros((2, 3), np.int8))
    >>> tc.rasterize(tc.Polygon.box(0.5, 0.5), (1.5, 0.5, 0), hall)
    array([1])
    """

def to_wkt(polygon: Polygon) -> str:
    """Returns a polygon in WKT: a POLYGON if it has one shell, otherwise a MULTIPOLYGON.

    >>> tc.to_wkt(tc.Polygon([(0, 0), (2, 0), (0, 2)]))
    'POLYGON ((0 0, 2 0, 0 2, 0 0))'
    """

def self_crossings(polygon: Polygon, most: int = 18446744073709551615) -> List[SelfCrossing]:
    """Returns where rings cross themselves or each other, repeat each other, or have no area; `most` places at most.

    Such a polygon is legal in every query, by its fill rule. Files for other programs need valid ones.

    >>> tc.self_crossings(tc.Polygon.box(2, 2))
    []
    """

class Scene:
    """Many polygons under poses of their own, and what collides among them.

    Margins of two bodies, and of a body and a query, add up. `mask` asks about the bodies with a category of its bits, `ignored`
    about all but that body. A copy, by copy.copy(), is an independent scene with the same handles.

    >>> scene = tc.Scene()
    >>> shelves = scene.add(tc.Polygon.box(4, 1), [(0, 0, 0), (0, 3, 0)])
    >>> scene.collides(tc.Polygon.box(1, 1), [(0, 1.5, 0), (0, 2.5, 0)])
    array([False,  True])
    """
    def __init__(self) -> None:
        """Makes a scene without bodies.

        >>> len(tc.Scene())
        0
        """
    def add(self, polygon: Union[Polygon, Sequence[Polygon]], pose: _PosesLike, margin: float = 0.0, category: int = 1,
            mask: int = 0xFFFFFFFF, touching: Touching = Touching.COLLIDES) -> Any:
        """Adds a body, and returns its handle; or adds many, and returns a list of handles.

        Many poses, (n, 3), or a list of polygons make many bodies. Two bodies meet if each has a category of the other's mask.

        >>> scene = tc.Scene()
        >>> scene.add(tc.Polygon.box(1, 1), [(0, 0, 0), (5, 0, 0)], margin=0.1)
        [Body(0), Body(1)]
        """
    def set_options(self, body: int, margin: float = 0.0, category: int = 1, mask: int = 0xFFFFFFFF,
                    touching: Touching = Touching.COLLIDES) -> None:
        """Replaces all options of a body.

        >>> scene = tc.Scene()
        >>> body = scene.add(tc.Polygon.box(1, 1), (0, 0, 0))
        >>> scene.set_options(body, margin=0.5)
        """
    def options(self, body: int) -> BodyOptions:
        """Returns a body's options as they were given.

        >>> scene = tc.Scene()
        >>> scene.options(scene.add(tc.Polygon.box(1, 1), (0, 0, 0), category=2)).category
        2
        """
    def set_ignored(self, a: int, b: int, ignored: bool = True) -> None:
        """Lets two bodies touch and overlap, as a gripper and its part, or no longer.

        >>> scene = tc.Scene()
        >>> gripper, part = scene.add(tc.Polygon.box(2, 2), [(0, 0, 0), (1, 0, 0)])
        >>> scene.set_ignored(gripper, part)
        >>> scene.collisions()
        []
        """
    def is_ignored(self, a: int, b: int) -> bool:
        """Returns whether a pair may touch and overlap.

        >>> scene = tc.Scene()
        >>> scene.is_ignored(*scene.add(tc.Polygon.box(2, 2), [(0, 0, 0), (1, 0, 0)]))
        False
        """
    def remove(self, body: int) -> None:
        """Removes a body.

        >>> scene = tc.Scene()
        >>> scene.remove(scene.add(tc.Polygon.box(1, 1), (0, 0, 0)))
        """
    def move(self, body: Union[int, ArrayLike], pose: _PosesLike, threads: int = 0) -> None:
        """Moves a body to a pose; or many bodies, a list of handles, to as many poses.

        >>> scene = tc.Scene()
        >>> bodies = scene.add(tc.Polygon.box(1, 1), [(0, 0, 0), (5, 0, 0)])
        >>> scene.move(bodies, [(1, 0, 0), (6, 0, 0)])
        """
    @property
    def bodies(self) -> List[Body]:
        """All handles, sorted.

        >>> tc.Scene().bodies
        []
        """
    def polygon(self, body: int) -> Polygon:
        """Returns a body's polygon.

        >>> scene = tc.Scene()
        >>> scene.polygon(scene.add(tc.Polygon.box(4, 1), (0, 0, 0))).area
        4.0
        """
    def pose(self, body: int) -> Poses:
        """Returns a body's pose.

        >>> scene = tc.Scene()
        >>> scene.pose(scene.add(tc.Polygon.box(4, 1), (1, 2, 0)))
        pose_at(1.0, 2.0, 0.0)
        """
    @staticmethod
    def index_of(body: int) -> int:
        """Returns an index for arrays of yours: no two bodies of a scene have the same at once.

        >>> tc.Scene.index_of(tc.Scene().add(tc.Polygon.box(4, 1), (1, 2, 0)))
        0
        """
    def collisions(self, threads: int = 1) -> List[BodyPair]:
        """Returns the pairs that collide now, sorted. A call costs what moved since the last one.

        >>> scene = tc.Scene()
        >>> bodies = scene.add(tc.Polygon.box(2, 2), [(0, 0, 0), (1, 0, 0)])
        >>> len(scene.collisions())
        1
        """
    def contacts(self, detail: ContactDetail = ContactDetail.LOCAL_DEPTH, threads: int = 1) -> List[PairContact]:
        """Calls collisions() and returns all contacts of each pair in it: by pairs, then the deepest first.

        >>> scene = tc.Scene()
        >>> bodies = scene.add(tc.Polygon.box(2, 2), [(0, 0, 0), (1.5, 0, 0)])
        >>> [(found.pair == tuple(bodies), found.contact.depth) for found in scene.contacts()]
        [(True, 0.5)]
        """
    @property
    def began(self) -> List[BodyPair]:
        """The pairs that the last collisions() returned, and the call before did not.

        >>> tc.Scene().began
        []
        """
    @property
    def ended(self) -> List[BodyPair]:
        """The pairs that the last collisions() did not return, and the call before did.

        >>> tc.Scene().ended
        []
        """
    def collides(self, polygon: Polygon, pose: _PosesLike, margin: float = 0.0, tolerance: float = 0.0, mask: int = 0xFFFFFFFF,
                 ignored: Optional[int] = None, touching: Touching = Touching.COLLIDES, threads: int = 0) -> _Answers:
        """Returns whether a polygon at a pose collides with a body. Of many poses, (n,).

        >>> scene = tc.Scene()
        >>> body = scene.add(tc.Polygon.box(2, 2), (0, 0, 0))
        >>> scene.collides(tc.Polygon.box(2, 2), [(1, 0, 0), (9, 0, 0)])
        array([ True, False])
        """
    def any_colliding(self, polygon: Polygon, pose: _PosesLike, margin: float = 0.0, tolerance: float = 0.0,
                      mask: int = 0xFFFFFFFF, ignored: Optional[int] = None, touching: Touching = Touching.COLLIDES,
                      threads: int = 0) -> Any:
        """Returns a body that collides with a polygon, or None. Of many poses, an array of handles, NO_BODY for none.

        >>> scene = tc.Scene()
        >>> body = scene.add(tc.Polygon.box(2, 2), (0, 0, 0))
        >>> scene.any_colliding(tc.Polygon.box(2, 2), [(1, 0, 0), (9, 0, 0)]) == tc.NO_BODY
        array([False,  True])
        """
    def colliding(self, polygon: Polygon, pose: _PosesLike, margin: float = 0.0, tolerance: float = 0.0, mask: int = 0xFFFFFFFF,
                  ignored: Optional[int] = None, touching: Touching = Touching.COLLIDES,
                  threads: int = 0) -> Union[List[Body], List[List[Body]]]:
        """Returns all bodies that collide with a polygon, sorted. Of many poses, a list of lists.

        >>> scene = tc.Scene()
        >>> bodies = scene.add(tc.Polygon.box(2, 2), [(0, 0, 0), (1, 0, 0)])
        >>> scene.colliding(tc.Polygon.box(2, 2), (2.5, 0, 0)) == bodies[1:]
        True
        """
    def covers(self, polygon: Polygon, pose: _PosesLike, margin: float = 0.0, mask: int = 0xFFFFFFFF,
               ignored: Optional[int] = None, threads: int = 0) -> _Answers:
        """Returns whether the union of the bodies holds all of a polygon. Of many poses, (n,).

        >>> scene = tc.Scene()
        >>> lanes = scene.add(tc.Polygon.box(2, 2), [(0, 0, 0), (2, 0, 0)])
        >>> scene.covers(tc.Polygon.box(1, 1), [(1, 0, 0), (3, 0, 0)])
        array([ True, False])
        """
    def first_exit(self, polygon: Polygon, motion: _AnyMotion, margin: float = 0.0, mask: int = 0xFFFFFFFF,
                   ignored: Optional[int] = None, threads: int = 0) -> Optional[Exit]:
        """Returns the first time at which covers() is false of a moving polygon, or None. It is never late.

        >>> scene = tc.Scene()
        >>> lane = scene.add(tc.Polygon.box(10, 3), (0, 0, 0))
        >>> round(scene.first_exit(tc.Polygon.box(2, 1), tc.Motion.translation((0, 0, 0), (8, 0))).time, 5)
        0.5
        """
    def nearest(self, polygon: Polygon, pose: _PosesLike, margin: float = 0.0, relative_error: float = 0.0,
                absolute_error: float = 0.0, mask: int = 0xFFFFFFFF, ignored: Optional[int] = None,
                threads: int = 0) -> Optional[BodyDistance]:
        """Returns the body nearest to a polygon and how far it is; None without bodies. Of many poses, arrays.

        >>> scene = tc.Scene()
        >>> bodies = scene.add(tc.Polygon.box(2, 2), [(0, 0, 0), (9, 0, 0)])
        >>> body, gap = scene.nearest(tc.Polygon.box(2, 2), (3, 0, 0))
        >>> body == bodies[0], gap.distance
        (True, 1.0)
        """
    def nearest_within(self, polygon: Polygon, pose: _PosesLike, limit: float, margin: float = 0.0, relative_error: float = 0.0,
                       absolute_error: float = 0.0, mask: int = 0xFFFFFFFF, ignored: Optional[int] = None,
                       threads: int = 0) -> Optional[BodyDistance]:
        """Returns the nearest body if it is no farther away than `limit`, or None. Of many poses, arrays.

        >>> scene = tc.Scene()
        >>> body = scene.add(tc.Polygon.box(2, 2), (0, 0, 0))
        >>> scene.nearest_within(tc.Polygon.box(2, 2), [(3, 0, 0), (9, 0, 0)], limit=2).result.found
        array([ True, False])
        """
    def nearest_k(self, polygon: Polygon, pose: _PosesLike, most: int, limit: float = float("inf"), margin: float = 0.0,
                  relative_error: float = 0.0, absolute_error: float = 0.0, mask: int = 0xFFFFFFFF,
                  ignored: Optional[int] = None, threads: int = 0) -> Union[List[BodyDistance], List[List[BodyDistance]]]:
        """Returns the `most` nearest bodies no farther away than `limit`, the nearest first. Of many poses, lists.

        >>> scene = tc.Scene()
        >>> bodies = scene.add(tc.Polygon.box(2, 2), [(0, 0, 0), (9, 0, 0), (99, 0, 0)])
        >>> [near.result.distance for near in scene.nearest_k(tc.Polygon.box(2, 2), (3, 0, 0), most=2)]
        [1.0, 4.0]
        """
    def least_distance(self, polygon: Polygon, motion: _AnyMotion, margin: float = 0.0, absolute_error: float = 1e-6,
                       mask: int = 0xFFFFFFFF, ignored: Optional[int] = None, threads: int = 0) -> Optional[BodyLeastDistance]:
        """Returns the body that a moving polygon comes nearest to, and when, or None without bodies. Of many ways, arrays.

        >>> scene = tc.Scene()
        >>> body = scene.add(tc.Polygon.box(2, 2), (0, 0, 0))
        >>> nearest, least = scene.least_distance(tc.Polygon.box(2, 2), tc.Motion.translation((-6, 5, 0), (12, 0)))
        >>> nearest == body, round(least.distance, 5)
        (True, 3.0)
        """
    def first_impact(self, polygon: Polygon, motion: _AnyMotion, margin: float = 0.0, time_error: float = 1e-6,
                     mask: int = 0xFFFFFFFF, ignored: Optional[int] = None, ignore_initial: bool = False,
                     threads: int = 0) -> Optional[BodyImpact]:
        """Returns the body that a moving polygon meets first while all bodies rest, or None. Of many ways, arrays.

        >>> scene = tc.Scene()
        >>> body = scene.add(tc.Polygon.box(2, 2), (0, 0, 0))
        >>> met, impact = scene.first_impact(tc.Polygon.box(2, 2), tc.Motion.translation((-6, 0, 0), (8, 0)))
        >>> met == body, round(impact.time, 5)
        (True, 0.5)
        """
    def impacts(self, motions: _BodyMotions, margin: float = 0.0, time_error: float = 1e-6, ignore_initial: bool = False,
                threads: int = 0) -> List[PairImpact]:
        """Returns all pairs that meet while some bodies move and the others rest, each at its first time.

        `motions` are pairs (body, motion), or a dictionary; all of them Motions, or all Trajectories.

        >>> scene = tc.Scene()
        >>> one, other = scene.add(tc.Polygon.box(2, 2), [(0, 0, 0), (6, 0, 0)])
        >>> [round(found.impact.time, 5) for found in scene.impacts({one: tc.Motion.translation((0, 0, 0), (8, 0))})]
        [0.5]
        """
    def conflicts(self, motions: _BodyMotions, margin: float = 0.0, time_error: float = 1e-6, ignore_initial: bool = False,
                  threads: int = 0) -> List[PairConflict]:
        """Returns all intervals of time in which any two bodies meet, the earliest first. Arguments are those of impacts().

        >>> scene = tc.Scene()
        >>> one, other = scene.add(tc.Polygon.box(2, 2), [(0, 0, 0), (6, 0, 0)])
        >>> drive = tc.Trajectory.through([0, 16], [(0, 0, 0), (16, 0, 0)])
        >>> [round(found.conflict.end, 5) for found in scene.conflicts({one: drive})]
        [8.0]
        """
    def cast_ray(self, from_point: ArrayLike, to_point: ArrayLike, margin: float = 0.0, mask: int = 0xFFFFFFFF,
                 ignored: Optional[int] = None, threads: int = 0) -> Optional[BodyRayHit]:
        """Returns the body that a ray meets first, and where; or None. Of many points, (n, 2), arrays.

        >>> scene = tc.Scene()
        >>> body = scene.add(tc.Polygon.box(2, 2), (0, 0, 0))
        >>> scene.cast_ray((-3, 0), [(3, 0), (-3, 3)]).hit.found
        array([ True, False])
        """
    def cast_ray_all(self, from_point: ArrayLike, to_point: ArrayLike, margin: float = 0.0, mask: int = 0xFFFFFFFF,
                     ignored: Optional[int] = None,
                     threads: int = 0) -> Union[List[BodyRayInterval], List[List[BodyRayInterval]]]:
        """Returns all parts of a ray that are in bodies, in the order of their begins. Of many, lists.

        >>> scene = tc.Scene()
        >>> body = scene.add(tc.Polygon.box(2, 2), (0, 0, 0))
        >>> len(scene.cast_ray_all((-3, 0), (3, 0)))
        1
        """
    def __len__(self) -> int: ...
    def __contains__(self, body: int) -> bool: ...
    def __copy__(self) -> Scene: ...
    def __deepcopy__(self, memo: Dict[Any, Any]) -> Scene: ...

class SvgDrawing:
    """A drawing in world coordinates, y upwards, scaled to fit. It shows itself in a notebook. Colours are SVG's.

    >>> drawing = tc.SvgDrawing()
    >>> drawing.polygon(tc.Polygon.box(2, 1), (0, 0, 0.3), fill="#1d4ed8")
    >>> str(drawing)[:4]
    '<svg'
    """
    def __init__(self, width_px: float = 800.0) -> None:
        """Makes an empty drawing, so many pixels wide.

        >>> drawing = tc.SvgDrawing(400)
        """
    def polygon(self, polygon: Polygon, pose: _PosesLike, fill: str, stroke: str = "#333", margin: float = 0.0) -> None:
        """Draws a polygon at a pose, or at each of many. What is within the margin gets a paler fill.

        >>> tc.SvgDrawing().polygon(tc.Polygon.box(2, 1), [(0, 0, 0), (3, 0, 0)], fill="none")
        """
    def scene(self, scene: Scene, fill: str = "#e7e5e4", stroke: str = "#333") -> None:
        """Draws all bodies of a scene with their margins.

        >>> tc.SvgDrawing().scene(tc.Scene())
        """
    def polyline(self, points: ArrayLike, stroke: str) -> None:
        """Draws an open line through points, (n, 2).

        >>> tc.SvgDrawing().polyline([(0, 0), (1, 1)], "red")
        """
    def text(self, position: ArrayLike, text: str) -> None:
        """Writes a line of text centred at a position, (2,).

        >>> tc.SvgDrawing().text((0, 0), "here")
        """
    def covering(self, polygon: Polygon, pose: _PosesLike) -> None:
        """Draws the triangles of a polygon's covering.

        >>> tc.SvgDrawing().covering(tc.Polygon.box(2, 1), (0, 0, 0))
        """
    def influence_areas(self, polygon: Polygon, pose: _PosesLike, length: float, fill: str = "#f59e0b") -> None:
        """Draws the bounded influence areas of all edges for a length.

        >>> tc.SvgDrawing().influence_areas(tc.Polygon.box(2, 1), (0, 0, 0), 0.1)
        """
    def boxes(self, polygon: Polygon, pose: _PosesLike, level: int, stroke: str = "#7c3aed") -> None:
        """Draws the boxes of a polygon's hierarchy on one level; 0 is the box around all.

        >>> tc.SvgDrawing().boxes(tc.Polygon.box(2, 1), (0, 0, 0), 0)
        """
    def inner_discs(self, polygon: Polygon, pose: _PosesLike, fill: str = "#16a34a") -> None:
        """Draws the discs that are known to lie in the region.

        >>> tc.SvgDrawing().inner_discs(tc.Polygon.box(2, 1), (0, 0, 0))
        """
    def hits(self, a: Polygon, pose_a: _PosesLike, b: Polygon, pose_b: _PosesLike) -> None:
        """Draws the edges of each polygon that meet an edge of the other.

        >>> tc.SvgDrawing().hits(tc.Polygon.box(2, 1), (0, 0, 0), tc.Polygon.box(2, 1), (1, 0, 0))
        """
    def nearest(self, result: Distance) -> None:
        """Draws the nearest points of a Distance, and the line between them.

        >>> square = tc.Polygon.box(2, 2)
        >>> tc.SvgDrawing().nearest(tc.distance(square, (0, 0, 0), square, (5, 0, 0)))
        """
    def contacts(self, contacts: Sequence[Contact]) -> None:
        """Draws contacts: each point, an arrow along the normal, and the translation by the depth.

        >>> square = tc.Polygon.box(2, 2)
        >>> tc.SvgDrawing().contacts(tc.contacts(square, (0, 0, 0), square, (1.5, 0, 0)))
        """
    def impact(self, impact: Impact, stroke: str = "#dc2626") -> None:
        """Draws the point of an Impact and an arrow along its normal.

        >>> square = tc.Polygon.box(2, 2)
        >>> drive = tc.Motion.translation((-6, 0, 0), (8, 0))
        >>> tc.SvgDrawing().impact(tc.time_of_impact(square, (0, 0, 0), square, drive))
        """
    def motions(self, a: Polygon, motion_a: Motion, b: Polygon, motion_b: Motion, impact: Impact) -> None:
        """Draws both polygons at the start and at an impact, with its point and an arrow.

        >>> square, still, drive = tc.Polygon.box(2, 2), tc.Motion.still((0, 0, 0)), tc.Motion.translation((-6, 0, 0), (8, 0))
        >>> tc.SvgDrawing().motions(square, still, square, drive, tc.time_of_impact(square, still, square, drive))
        """
    def save(self, path: str) -> None:
        """Writes the drawing to a file, which it replaces.

        >>> drawing = tc.SvgDrawing()
        >>> drawing.text((0, 0), "here")
        >>> drawing.save("/nowhere/drawing.svg")
        Traceback (most recent call last):
        RuntimeError: ...
        """
    def _repr_svg_(self) -> str: ...

class SceneRecording:
    """A scene in motion, as one HTML file that a browser plays without a network. It shows itself in a notebook.

    What is drawn beside the bodies is shown for a time interval `when`, (2,), and otherwise as long as the last frame is.

    >>> scene, recording = tc.Scene(), tc.SceneRecording("A robot")
    >>> robot = scene.add(tc.Polygon.box(2, 1), (0, 0, 0))
    >>> recording.trajectories(scene, {robot: tc.Trajectory.through([0, 9], [(0, 0, 0), (9, 0, 0)])})
    >>> str(recording)[:15]
    '<!DOCTYPE html>'
    """
    def __init__(self, title: str = "Recording") -> None:
        """Makes an empty recording.

        >>> recording = tc.SceneRecording("A robot")
        """
    def frame(self, time: float, scene: Scene, meeting: Sequence[Tuple[int, int]] = ()) -> None:
        """Records where all bodies are, and which pairs meet, as collisions() says.

        >>> scene, recording = tc.Scene(), tc.SceneRecording()
        >>> robot = scene.add(tc.Polygon.box(2, 1), (0, 0, 0))
        >>> recording.frame(0, scene, scene.collisions())
        """
    def trajectories(self, scene: Scene, trajectories: Union[Sequence[Tuple[int, Trajectory]], Mapping[int, Trajectory]]) -> None:
        """Records how bodies move: pairs (body, Trajectory), or a dictionary. Other bodies rest.

        >>> scene, recording = tc.Scene(), tc.SceneRecording()
        >>> robot = scene.add(tc.Polygon.box(2, 1), (0, 0, 0))
        >>> recording.trajectories(scene, {robot: tc.Trajectory.through([0, 9], [(0, 0, 0), (9, 0, 0)])})
        """
    def name(self, body: int, name: str) -> None:
        """Names a body that is recorded.

        >>> scene, recording = tc.Scene(), tc.SceneRecording()
        >>> robot = scene.add(tc.Polygon.box(2, 1), (0, 0, 0))
        >>> recording.frame(0, scene)
        >>> recording.name(robot, "robot")
        """
    def conflicts(self, conflicts: Sequence[PairConflict]) -> None:
        """Marks conflicts of Scene.conflicts() on the time line.

        >>> tc.SceneRecording().conflicts([])
        """
    def impacts(self, impacts: Sequence[PairImpact]) -> None:
        """Marks impacts of Scene.impacts() on the time line.

        >>> tc.SceneRecording().impacts([])
        """
    def contacts(self, contacts: Sequence[Contact], when: Optional[ArrayLike] = None) -> None:
        """Draws contacts: each point, an arrow along the normal, and the translation by the depth.

        >>> square = tc.Polygon.box(2, 2)
        >>> tc.SceneRecording().contacts(tc.contacts(square, (0, 0, 0), square, (1.5, 0, 0)), when=(0, 1))
        """
    def nearest(self, result: Union[Distance, LeastDistance], when: Optional[ArrayLike] = None) -> None:
        """Draws the nearest points of a Distance, or of a LeastDistance at its time, which takes no `when`.

        >>> square = tc.Polygon.box(2, 2)
        >>> tc.SceneRecording().nearest(tc.distance(square, (0, 0, 0), square, (5, 0, 0)), when=(0, 1))
        """
    def ray(self, from_point: ArrayLike, to_point: ArrayLike, hit: Optional[BodyRayHit] = None,
            when: Optional[ArrayLike] = None) -> None:
        """Draws a ray: to its hit of Scene.cast_ray(), and faintly from there on.

        >>> tc.SceneRecording().ray((0, 0), (1, 1), when=(0, 1))
        """
    def text(self, position: ArrayLike, text: str, when: Optional[ArrayLike] = None) -> None:
        """Writes a line of text centred at a position, (2,).

        >>> tc.SceneRecording().text((0, 0), "here", when=(0, 1))
        """
    def save(self, path: str) -> None:
        """Writes the page to a file, which it replaces.

        >>> scene, recording = tc.Scene(), tc.SceneRecording()
        >>> robot = scene.add(tc.Polygon.box(2, 1), (0, 0, 0))
        >>> recording.frame(0, scene)
        >>> recording.save("/nowhere/robot.html")
        Traceback (most recent call last):
        RuntimeError: ...
        """
    def __copy__(self) -> SceneRecording: ...
    def _repr_html_(self) -> str: ...
