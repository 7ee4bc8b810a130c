"""Exact collision detection between 2D polygons.

Poses: one is an array (3,) of x, y and heading in radians, or (3, 3), a homogeneous matrix, which may mirror; many are
(n, 3) or (n, 3, 3). Of the shape (3, 3), three rows are one matrix if they are a rigid one, and otherwise three poses.
Where one of two poses is one and the other many, the one is used for all. Many poses are asked on `threads` threads, 0
for all processors, while other Python threads run; errors name the pose. Lengths are the world's. Wrong arguments raise
ValueError, edges and bodies that aren't there IndexError. The C++ reference says more of each function.
"""
from typing import Dict, List, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

class FillRule:
    EVEN_ODD: FillRule
    NON_ZERO: FillRule

class Location:
    OUTSIDE: Location
    BOUNDARY: Location
    INSIDE: Location

class ContactDetail:
    """What of a contact is worked out: each costs more than the one before."""
    POINTS: ContactDetail
    LOCAL_DEPTH: ContactDetail
    WAY_OUT: ContactDetail

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
    def origin(self) -> NDArray[np.float64]: ...
    @property
    def radius(self) -> float: ...
    def edge(self, edge: int) -> NDArray[np.float64]:
        """Its two ends, (2, 2)."""

def point(p: ArrayLike) -> Polygon:
    """A polygon that is a point: with a margin, a disc."""

def segment(p: ArrayLike, q: ArrayLike) -> Polygon:
    """A polygon that is a segment: with a margin, a stadium."""

def outline(cells: ArrayLike, resolution: float = 1.0, origin: ArrayLike = (0, 0)) -> Optional[Polygon]:
    """The cells (height, width) that aren't 0, the lowest row first, as one polygon with holes; None without any."""

def read_occupancy_map(yaml: str) -> Tuple[NDArray[np.int8], float, NDArray[np.float64]]:
    """A map of ROS's map_server: cells, resolution, and the pose of its frame, a matrix."""

class Motion:
    """A planar rigid motion from time 0 to time 1."""
    @staticmethod
    def still(pose: ArrayLike) -> Motion: ...
    @staticmethod
    def translation(start: ArrayLike, shift: ArrayLike) -> Motion: ...
    @staticmethod
    def between(start: ArrayLike, end: ArrayLike, pivot: ArrayLike = (0, 0)) -> Motion: ...
    @staticmethod
    def spline(begin: ArrayLike, begin_velocity: ArrayLike, end: ArrayLike, end_velocity: ArrayLike,
               pivot: ArrayLike = (0, 0)) -> Motion:
        """The cubic Hermite spline; each argument is x, y and heading, or their velocities."""
    def at(self, time: float) -> NDArray[np.float64]:
        """The pose at a time, a matrix."""

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
    point: NDArray[np.float64]
    normal: NDArray[np.float64]
    depth: float
    edge_a: int
    edge_b: int

class Impact(NamedTuple):
    time: float
    point: NDArray[np.float64]
    normal: NDArray[np.float64]
    edge_a: int
    edge_b: int

class RayHit(NamedTuple):
    fraction: float
    point: NDArray[np.float64]
    normal: NDArray[np.float64]
    edge: int

def collide(a: Polygon, pose_a: ArrayLike, b: Polygon, pose_b: ArrayLike, margin: float = 0.0, tolerance: float = 0.0,
            threads: int = 0) -> Union[bool, NDArray[np.bool_]]: ...
def distance(a: Polygon, pose_a: ArrayLike, b: Polygon, pose_b: ArrayLike, margin: float = 0.0,
             threads: int = 0) -> Distance: ...
def penetration(a: Polygon, pose_a: ArrayLike, b: Polygon, pose_b: ArrayLike, margin: float = 0.0,
                depth_error: float = 0.0, threads: int = 0) -> Union[Optional[Penetration], List[Optional[Penetration]]]: ...
def contacts(a: Polygon, pose_a: ArrayLike, b: Polygon, pose_b: ArrayLike, margin: float = 0.0,
             most: Optional[int] = None, detail: ContactDetail = ContactDetail.WAY_OUT,
             threads: int = 0) -> Union[List[Contact], List[List[Contact]]]: ...
def time_of_impact(a: Polygon, motion_a: Motion, b: Polygon, motion_b: Motion, margin: float = 0.0,
                   time_error: float = 1e-6) -> Optional[Impact]: ...
def cast_ray(polygon: Polygon, pose: ArrayLike, from_point: ArrayLike, to_point: ArrayLike,
             margin: float = 0.0) -> Optional[RayHit]: ...
def locate(polygon: Polygon, points: ArrayLike, threads: int = 0) -> Union[Location, NDArray[np.int8]]:
    """Of one point (2,) in the polygon's frame a Location, of many (n, 2) the numbers of theirs: 0, 1, 2."""

class Scene:
    """Many polygons under poses of their own, and what collides among them. `mask` asks for bodies with a category of
    its bits, `ignored` for all but that body."""
    def __init__(self) -> None: ...
    def __copy__(self) -> Scene: ...
    def __deepcopy__(self, memo: Dict[int, object]) -> Scene: ...
    def __len__(self) -> int: ...
    def __contains__(self, body: int) -> bool: ...
    def add(self, polygon: Polygon, pose: ArrayLike, margin: float = 0.0, category: int = 1,
            mask: int = 0xFFFFFFFF) -> int: ...
    def remove(self, body: int) -> None: ...
    def move(self, body: int, pose: ArrayLike) -> None: ...
    @property
    def bodies(self) -> List[int]: ...
    def polygon(self, body: int) -> Polygon: ...
    def pose(self, body: int) -> NDArray[np.float64]: ...
    def collisions(self, threads: int = 1) -> List[Tuple[int, int]]: ...
    @property
    def began(self) -> List[Tuple[int, int]]: ...
    @property
    def ended(self) -> List[Tuple[int, int]]: ...
    def collides(self, polygon: Polygon, pose: ArrayLike, margin: float = 0.0, tolerance: float = 0.0,
                 mask: int = 0xFFFFFFFF, ignored: Optional[int] = None,
                 threads: int = 0) -> Union[bool, NDArray[np.bool_]]: ...
    def colliding(self, polygon: Polygon, pose: ArrayLike, margin: float = 0.0, mask: int = 0xFFFFFFFF,
                  ignored: Optional[int] = None) -> List[int]: ...
    def nearest(self, polygon: Polygon, pose: ArrayLike, mask: int = 0xFFFFFFFF,
                ignored: Optional[int] = None) -> Optional[Tuple[int, Distance]]: ...
    def first_impact(self, polygon: Polygon, motion: Motion, margin: float = 0.0, time_error: float = 1e-6,
                     mask: int = 0xFFFFFFFF, ignored: Optional[int] = None) -> Optional[Tuple[int, Impact]]: ...
    def impacts(self, motions: Sequence[Tuple[int, Motion]], margin: float = 0.0, time_error: float = 1e-6,
                threads: int = 0) -> List[Tuple[int, int, Impact]]: ...
    def cast_ray(self, from_point: ArrayLike, to_point: ArrayLike, margin: float = 0.0, mask: int = 0xFFFFFFFF,
                 ignored: Optional[int] = None) -> Optional[Tuple[int, RayHit]]: ...
