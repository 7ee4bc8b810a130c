"""Exact collision detection between 2D polygons.

A pose is an array (3,) of x, y and heading in radians; many are (n, 3). Homogeneous matrices, which may mirror, are
given as Poses.from_matrices(), and never as plain arrays: three poses and a matrix have one shape. A plain array (3, 3)
whose last row is 0, 0, 1 may be either and is refused; Poses() makes three poses of it.
Where one of two poses is one and the other many, the one is used for all. Many poses are asked on `threads` threads, 0
for all processors, while other Python threads run; errors name the pose. Lengths are the world's. Wrong arguments raise
ValueError, edges and bodies that aren't there IndexError. The C++ reference says more of each function.
"""
from enum import IntEnum
from typing import Dict, List, NamedTuple, Optional, Sequence, Tuple, TypeVar, Union, overload

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

class Simplify:
    """On which side of its outline a simplified polygon may differ from the original."""
    BOTH: Simplify
    OUTWARDS: Simplify


class FillRule:
    EVEN_ODD: FillRule
    NON_ZERO: FillRule

class Location(IntEnum):
    """An int, which the arrays of locate() compare with."""
    OUTSIDE = 0
    BOUNDARY = 1
    INSIDE = 2

class ContactDetail:
    """What of a contact is worked out: each costs more than the one before."""
    POINTS: ContactDetail
    LOCAL_DEPTH: ContactDetail
    GLOBAL_DEPTH: ContactDetail

class Touching:
    """Whether regions that only touch collide; ALLOWED asks whether the interiors meet."""
    COLLIDES: Touching
    ALLOWED: Touching

class Polygon:
    """A closed planar region of rings, arrays (n, 2), or of one. It never changes."""
    def __init__(self, rings: Union[ArrayLike, Sequence[ArrayLike]], fill_rule: FillRule = FillRule.EVEN_ODD) -> None: ...
    @property
    def rings(self) -> List[NDArray[np.float64]]: ...
    @property
    def fill_rule(self) -> FillRule: ...
    @property
    def vertex_count(self) -> int: ...
    @property
    def is_complement(self) -> bool: ...
    def complement(self) -> Polygon:
        """The closure of what is outside, unbounded."""
    @property
    def origin(self) -> NDArray[np.float64]: ...
    @property
    def radius(self) -> float: ...
    @property
    def area(self) -> float: ...
    @property
    def centroid(self) -> NDArray[np.float64]: ...
    @property
    def bounds(self) -> NDArray[np.float64]:
        """The lowest and the highest x and y, (2, 2)."""
    @property
    def is_convex(self) -> bool: ...
    def translated(self, by: ArrayLike) -> Polygon: ...
    def scaled(self, factor: float) -> Polygon: ...
    def transformed(self, pose: PosesLike) -> Polygon: ...
    def bounds_at(self, pose: PosesLike) -> NDArray[np.float64]:
        """The bounds of its region under a pose, (2, 2)."""
    def simplified(self, tolerance: float, side: Simplify = Simplify.BOTH) -> Polygon:
        """Of fewer vertices; neither region is farther from the other than the tolerance. Outwards: it covers this one."""
    def edge(self, edge: int) -> NDArray[np.float64]:
        """Its two ends, (2, 2)."""

class Poses:
    """One pose or many. numpy.asarray() gives their matrices, (3, 3) or (n, 3, 3)."""
    def __init__(self, poses: ArrayLike) -> None:
        """From x, y and heading, (3,) or (n, 3)."""
    @staticmethod
    def from_matrices(matrices: ArrayLike) -> Poses:
        """From homogeneous matrices, (3, 3) or (n, 3, 3)."""
    def __array__(self, dtype: Optional[DTypeLike] = None, copy: Optional[bool] = None) -> NDArray[np.float64]: ...

def pose(x: float, y: float, heading: float = 0.0) -> Poses:
    """One pose."""

PosesLike = Union[Poses, ArrayLike]

def point(p: ArrayLike) -> Polygon:
    """A polygon that is a point: with a margin, a disc."""

def segment(p: ArrayLike, q: ArrayLike) -> Polygon:
    """A polygon that is a segment: with a margin, a stadium."""

def box(width: float, height: float) -> Polygon:
    """The rectangle around the origin of its frame."""

def outline(cells: ArrayLike, resolution: float = 1.0, origin: ArrayLike = (0, 0)) -> Optional[Polygon]:
    """The cells (height, width) that aren't 0, the lowest row first, as one polygon with holes; None without any. Of any
    numbers: 0.9 isn't 0, nor is NaN."""

def read_occupancy_map(yaml: str) -> Tuple[NDArray[np.int8], float, Poses]:
    """Reads a map of ROS's map_server: cells, resolution, and the pose of its frame, at which outline(cells, resolution) lies
    in the world."""

class Motion:
    """A planar rigid motion from time 0 to time 1."""
    @staticmethod
    def still(pose: PosesLike) -> Motion: ...
    @staticmethod
    def translation(start: PosesLike, shift: ArrayLike) -> Motion: ...
    @staticmethod
    def between(start: PosesLike, end: PosesLike, pivot: ArrayLike = (0, 0)) -> Motion: ...
    @staticmethod
    def spline(begin: ArrayLike, begin_velocity: ArrayLike, end: ArrayLike, end_velocity: ArrayLike,
               pivot: ArrayLike = (0, 0)) -> Motion:
        """The cubic Hermite spline; each argument is x, y and heading, or their velocities."""
    def at(self, time: float) -> Poses:
        """The pose at a time."""
    def part(self, from_time: float, until: float) -> Motion:
        """From one time to another, which are its 0 and 1."""

class Trajectory:
    """Motions one after the other, each from its begin to its end by a clock; before and after them it rests, unless it
    appears or vanishes. Of a pose: it always rests."""
    @overload
    def __init__(self, legs: Sequence[Tuple[float, float, Motion]]) -> None: ...
    @overload
    def __init__(self, pose: Poses) -> None: ...
    def appearing(self) -> Trajectory:
        """The same of a body that is absent before it begins."""
    def vanishing(self) -> Trajectory:
        """The same of a body that is absent after it ends."""
    @property
    def appears(self) -> bool: ...
    @property
    def vanishes(self) -> bool: ...
    @property
    def rests(self) -> bool: ...
    def is_there(self, time: float) -> bool: ...
    @staticmethod
    def through(times: ArrayLike, waypoints: ArrayLike, pivot: ArrayLike = (0, 0)) -> Trajectory:
        """From waypoint to waypoint: times (n,), x, y and heading (n, 3), which it rotates by. It waits where two are the same."""
    @staticmethod
    def spline(times: ArrayLike, places: ArrayLike, velocities: ArrayLike, pivot: ArrayLike = (0, 0)) -> Trajectory:
        """The cubic Hermite spline from knot to knot: times (n,), places and their rates (n, 3)."""
    @property
    def legs(self) -> List[Tuple[float, float, Motion]]: ...
    @property
    def begin(self) -> float: ...
    @property
    def end(self) -> float: ...
    def at(self, time: float) -> Poses:
        """The pose at a time."""
    def part(self, from_time: float, until: float) -> Motion:
        """Of times between which no leg ends."""

class Distance(NamedTuple):
    """Of many poses, each field is an array."""
    distance: Union[float, NDArray[np.float64]]
    point_a: NDArray[np.float64]
    point_b: NDArray[np.float64]
    edge_a: Union[int, NDArray[np.int64]]
    edge_b: Union[int, NDArray[np.int64]]

class Penetration(NamedTuple):
    depth: float
    normal: NDArray[np.float64]
    lower_bound: float
    optimal: bool
    translation: NDArray[np.float64]
    point_a: NDArray[np.float64]
    point_b: NDArray[np.float64]
    edge_a: int
    edge_b: int

class Contact(NamedTuple):
    """points, (1, 2) or (2, 2), are the ends of a stretch where edges face each other, and depths those there."""
    point: NDArray[np.float64]
    normal: NDArray[np.float64]
    depth: float
    edge_a: int
    edge_b: int
    points: NDArray[np.float64]
    depths: NDArray[np.float64]

class Impact(NamedTuple):
    time: float
    point: NDArray[np.float64]
    normal: NDArray[np.float64]
    edge_a: int
    edge_b: int
    budget_ended: bool
    """Whether the search ended early: before `time` the polygons are apart, whether they meet then is unknown."""

class Conflict(NamedTuple):
    """A span of time in which two bodies meet: from impact.time to end."""
    impact: Impact
    end: float
    budget_ended: bool

class BodyOptions(NamedTuple):
    margin: float
    category: int
    mask: int
    touching: Touching

class RayHit(NamedTuple):
    fraction: float
    point: NDArray[np.float64]
    normal: NDArray[np.float64]
    edge: int

class RayInterval(NamedTuple):
    """A part of a ray in a region: where it enters, and where it leaves."""
    begin: RayHit
    end: RayHit

class SignedDistance(NamedTuple):
    """The distance, or minus the depth of the overlap; the normal points from a to b."""
    distance: float
    normal: NDArray[np.float64]
    point_a: NDArray[np.float64]
    point_b: NDArray[np.float64]
    edge_a: int
    edge_b: int

class LeastDistance(NamedTuple):
    """The least distance on the way, when it is and where."""
    distance: float
    lower_bound: float
    time: float
    point_a: NDArray[np.float64]
    point_b: NDArray[np.float64]
    edge_a: int
    edge_b: int
    budget_ended: bool

Way = TypeVar("Way", Motion, Trajectory)

def collide(a: Polygon, pose_a: PosesLike, b: Polygon, pose_b: PosesLike, margin: float = 0.0, tolerance: float = 0.0,
            touching: Touching = Touching.COLLIDES, threads: int = 0) -> Union[bool, NDArray[np.bool_]]: ...
def covers(area: Polygon, pose_area: PosesLike, part: Polygon, pose_part: PosesLike, margin: float = 0.0,
           threads: int = 0) -> Union[bool, NDArray[np.bool_]]:
    """Whether the area holds all of the part, inflated by the margin."""

def distance(a: Polygon, pose_a: PosesLike, b: Polygon, pose_b: PosesLike, margin: float = 0.0,
             threads: int = 0) -> Distance: ...
def signed_distance(a: Polygon, pose_a: PosesLike, b: Polygon, pose_b: PosesLike, margin: float = 0.0,
                    threads: int = 0) -> Union[SignedDistance, List[SignedDistance]]: ...
def penetration(a: Polygon, pose_a: PosesLike, b: Polygon, pose_b: PosesLike, margin: float = 0.0,
                touching: Touching = Touching.COLLIDES,
                threads: int = 0) -> Union[Optional[Penetration], List[Optional[Penetration]]]: ...
def contacts(a: Polygon, pose_a: PosesLike, b: Polygon, pose_b: PosesLike, margin: float = 0.0,
             most: Optional[int] = None, detail: ContactDetail = ContactDetail.LOCAL_DEPTH,
             touching: Touching = Touching.COLLIDES, threads: int = 0) -> Union[List[Contact], List[List[Contact]]]: ...
def time_of_impact(a: Polygon, motion_a: Way, b: Polygon, motion_b: Way, margin: float = 0.0, time_error: float = 1e-6,
                   ignore_initial: bool = False) -> Optional[Impact]:
    """Of two motions, or of two trajectories, by whose clock times then are. `ignore_initial`: what meets at the start
    counts only once it has parted."""

def conflicts(a: Polygon, motion_a: Way, b: Polygon, motion_b: Way, margin: float = 0.0, time_error: float = 1e-6,
              ignore_initial: bool = False) -> List[Conflict]:
    """All spans of time in which they meet, likewise."""

def least_distance(a: Polygon, motion_a: Way, b: Polygon, motion_b: Way, margin: float = 0.0, error: float = 1e-6) -> LeastDistance:
    """Of two motions, or of two trajectories."""

def cast_ray(polygon: Polygon, pose: PosesLike, from_point: ArrayLike, to_point: ArrayLike,
             margin: float = 0.0) -> Optional[RayHit]: ...
def cast_ray_all(polygon: Polygon, pose: PosesLike, from_point: ArrayLike, to_point: ArrayLike,
                 margin: float = 0.0) -> List[RayInterval]: ...
def locate(polygon: Polygon, points: ArrayLike, threads: int = 0) -> Union[Location, NDArray[np.int8]]:
    """Of one point (2,) in the polygon's frame a Location, of many (n, 2) the numbers of theirs: 0, 1, 2."""

class Body(int):
    """A handle of a Scene's body. An int is as good wherever a body is wanted; where a mask is, a Body is a TypeError."""

class Scene:
    """Many polygons under poses of their own, and what collides among them. `mask` asks for bodies with a category of
    its bits, `ignored` for all but that body."""
    def __init__(self) -> None: ...
    def __copy__(self) -> Scene: ...
    def __deepcopy__(self, memo: Dict[int, object]) -> Scene: ...
    def __len__(self) -> int: ...
    def __contains__(self, body: int) -> bool: ...
    def add(self, polygon: Polygon, pose: PosesLike, margin: float = 0.0, category: int = 1,
            mask: int = 0xFFFFFFFF, touching: Touching = Touching.COLLIDES) -> Body: ...
    def set_options(self, body: int, margin: float = 0.0, category: int = 1, mask: int = 0xFFFFFFFF,
                    touching: Touching = Touching.COLLIDES) -> None: ...
    def options(self, body: int) -> BodyOptions: ...
    def remove(self, body: int) -> None: ...
    def move(self, body: int, pose: PosesLike) -> None: ...
    @property
    def bodies(self) -> List[Body]: ...
    def polygon(self, body: int) -> Polygon: ...
    def pose(self, body: int) -> Poses: ...
    def collisions(self, threads: int = 1) -> List[Tuple[Body, Body]]: ...
    @property
    def began(self) -> List[Tuple[Body, Body]]: ...
    @property
    def ended(self) -> List[Tuple[Body, Body]]: ...
    def collides(self, polygon: Polygon, pose: PosesLike, margin: float = 0.0, tolerance: float = 0.0,
                 mask: int = 0xFFFFFFFF, ignored: Optional[int] = None,
                 touching: Touching = Touching.COLLIDES, threads: int = 0) -> Union[bool, NDArray[np.bool_]]: ...
    def covers(self, polygon: Polygon, pose: PosesLike, margin: float = 0.0, mask: int = 0xFFFFFFFF,
               ignored: Optional[int] = None) -> bool:
        """Whether the union of the bodies holds all of it."""
    def colliding(self, polygon: Polygon, pose: PosesLike, margin: float = 0.0, mask: int = 0xFFFFFFFF,
                  ignored: Optional[int] = None, touching: Touching = Touching.COLLIDES) -> List[Body]: ...
    def nearest(self, polygon: Polygon, pose: PosesLike, mask: int = 0xFFFFFFFF,
                ignored: Optional[int] = None) -> Optional[Tuple[Body, Distance]]: ...
    def first_impact(self, polygon: Polygon, motion: Union[Motion, Trajectory], margin: float = 0.0,
                     time_error: float = 1e-6, mask: int = 0xFFFFFFFF, ignored: Optional[int] = None,
                     ignore_initial: bool = False) -> Optional[Tuple[Body, Impact]]: ...
    def impacts(self, motions: Sequence[Tuple[int, Way]], margin: float = 0.0, time_error: float = 1e-6,
                ignore_initial: bool = False,
                threads: int = 0) -> List[Tuple[Body, Body, Impact]]:
        """Of motions, or of trajectories."""
    def conflicts(self, trajectories: Sequence[Tuple[int, Trajectory]], margin: float = 0.0, time_error: float = 1e-6,
                  ignore_initial: bool = False,
                  threads: int = 0) -> List[Tuple[Body, Body, Conflict]]:
        """All spans of time in which any two meet."""
    def cast_ray(self, from_point: ArrayLike, to_point: ArrayLike, margin: float = 0.0, mask: int = 0xFFFFFFFF,
                 ignored: Optional[int] = None) -> Optional[Tuple[Body, RayHit]]: ...
    def cast_ray_all(self, from_point: ArrayLike, to_point: ArrayLike, margin: float = 0.0, mask: int = 0xFFFFFFFF,
                     ignored: Optional[int] = None) -> List[Tuple[Body, RayInterval]]:
        """All of a ray that is in a body, in the order in which the ray enters."""
