"""Python has everything that the public headers declare, but for what stands below with its reason.

Names are Python's: nearestRigid() is nearest_rigid(). Fails, too, for an exception that the headers or Python have made needless.
"""
import pathlib
import re
import sys
import unittest

import tricover as tc

HEADERS = pathlib.Path(__file__).resolve().parents[2] / "include/tricover"
ARGUMENTS = "its fields are arguments in Python"
TUPLE = "a tuple or an argument in Python"
EXCEPTIONS = {
    "BodyFilter": "mask= and ignored= are arguments in Python", "BodyMotion": TUPLE, "BodyPlacement": TUPLE, "BodyPose": TUPLE,
    "BodyTrajectory": TUPLE, "CollideOptions": ARGUMENTS, 
    "ContactOptions": ARGUMENTS, "ContactPoint": "Contact.points and Contact.depths", "CoverOptions": ARGUMENTS,
    "CrossingOptions": ARGUMENTS, "DistanceOptions": ARGUMENTS, "DistanceResult": "Distance, which has its fields",
    "GeoOptions": ARGUMENTS, "ImpactOptions": ARGUMENTS, "Leg": "a tuple of Trajectory.legs",
    "LeastDistanceOptions": ARGUMENTS, "MaskCache": "a cache's life would show in a query without one",
    "OccupancyGrid": "OccupancyMap has its fields; outline() takes a plain array", "OccupancyMap.grid": "its fields are OccupancyMap's",
    "PairCache": "a cache for loops of C++, faster than a call from Python", "PenetrationOptions": ARGUMENTS,
    "Polygon.Vertex": "a point is an array", "RayOptions": ARGUMENTS, "Scene.contains": "`in`", "Scene.size": "len()",
    "Scene.visitColliding": "colliding() returns the list; a call of Python's for each body costs more",
    "SceneRecording.str": "str()", "SplineEnd": "x, y and heading, and their velocities", "SvgDrawing.str": "str()",
    "TimeInterval": TUPLE, "TimedKnot": TUPLE, "TimedPose": TUPLE, "Waypoint": TUPLE, "checkMotion": "every Motion is checked",
    "checkPose": "every pose is checked", "nearestRigid": "Poses.nearest_rigid", "version": "__version__"}

FUNCTION = re.compile(r"^TRICOVER_EXPORT[^;{]*?\b(\w+)\(", re.M)
TYPE = re.compile(r"^(struct|class|enum class) (?:TRICOVER_EXPORT )?(\w+)[^;{]*\{((?:[^\n]*\};$)|.*?^\};)", re.M | re.S)
MEMBER = re.compile(r"^  (?:[\w:&*<>, ]+[ &*>])?(\w+)\((?:[^;{}]|\{\})*\)(?: const| noexcept)*(?:;| \{)", re.M)
FIELD = re.compile(r"^  (?:const )?[\w:<>, ]+ (\w+)(?:\[\d\])?(?: = [^;]*)?;", re.M)


def snake(name):
    return re.sub(r"(?<=[a-z])(?=[A-Z])", "_", name).lower()


def declared():
    """Names of functions and types, and of types' public members, as C++ has them."""
    for path in sorted(HEADERS.glob("*.h")):
        text = re.sub(r"//[^\n]*|/\*.*?\*/", "", path.read_text(), flags=re.S)
        text = re.sub(r"^namespace detail \{.*?^\}", "", text, flags=re.M | re.S)
        yield from FUNCTION.findall(text)
        for kind, name, body in TYPE.findall(text):
            yield name
            if kind == "enum class":
                continue
            public = body.split(" private:")[0]
            members = set(MEMBER.findall(public)) - {name, "operator"}
            if kind == "struct":
                members |= set(FIELD.findall(public))
            yield from (f"{name}.{member}" for member in members)


def is_there(name):
    owner, _, member = name.rpartition(".")
    if owner:
        return hasattr(getattr(tc, owner, getattr(tc.paper, owner, None)), snake(member))
    places = (tc, tc.paper)
    return any(hasattr(place, name if name[0].isupper() else snake(name)) for place in places)


class Symbols(unittest.TestCase):
    def test_python_has_them(self):
        names = set(declared())
        self.assertGreater(len(names), 250)
        for known in ("collide", "hausdorffDistance", "Location", "Scene.nearestK", "Motion.arc", "DistanceResult.point_a",
                      "Trajectory.through", "SceneRecording.ray", "parseGeoJson", "Impact.budget_ended", "Polygon.simplified"):
            self.assertIn(known, names)
        missing = sorted(name for name in names if not is_there(name) and not {name, name.split(".")[0]} & EXCEPTIONS.keys())
        self.assertEqual(missing, [])
        needless = sorted(name for name in EXCEPTIONS if name not in names or is_there(name))
        self.assertEqual(needless, [])


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
