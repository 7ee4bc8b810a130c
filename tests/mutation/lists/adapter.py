# SPDX-License-Identifier: BSD-3-Clause
# (file, text as it stands there once, replacement, what it breaks): see ../run.py.
MUTATIONS = [
    ("fcl_adapter/src/broadphase/footprint.cpp", "print.region->margin += 2 * aside * reach;", "print.region->margin += 0;", "footprint: a tilt within the tolerance moves high prisms"),
    ("fcl_adapter/src/broadphase/footprint.cpp", "return is_rigid ? footprintOfBox(object, nullptr) : kAnywhere;", "return footprintOfBox(object, nullptr);", "footprint: a pose that isn't rigid"),
    ("fcl_adapter/src/shape/planar_pose.h", "return largest + (sum - sum);", "return largest;", "rigid: a NaN that a maximum passes over"),
    ("fcl_adapter/src/polygons/disc_pair.h", "constexpr double kSquares = 0x1p-50;", "constexpr double kSquares = 0;", "discs: rounding decides"),
    ("fcl_adapter/src/polygons/disc_pair.h", "distance * (1 - 0x1p-40) > reach", "distance > reach", "discs: a touch up to rounding is apart"),
    ("fcl_adapter/src/shadow/shadow.cpp", "return with(polygon, margin + rounding_).collide();", "return with(polygon, margin).collide();", "shadow: rounding parts what meets"),
    ("fcl_adapter/src/shape/planar_pair.h", "on_b = way.point_b - pair.margin_b * out;", "on_b = way.point_b + pair.margin_b * out;", "depth: grown inwards"),
    ("fcl_adapter/src/shape/planar_pair.h", "(pair.margin_a - pair.margin_b) / 2 * contact.normal", "(pair.margin_b - pair.margin_a) / 2 * contact.normal", "contact: in the middle of polygons, not of grown ones"),
    ("fcl_adapter/src/shadow/slab_cut.h", "return {slab.low - by, slab.high + by};", "return slab;", "cut: rounding at the slab"),
    ("fcl_adapter/src/shadow/smooth_distance.cpp", "found.lower = std::max(found.lower, outer.distance", "found.lower = std::max(found.lower, 2 * outer.distance", "round: a lower bound above the truth"),
    ("fcl_adapter/src/shape/course.cpp", "largest / std::cos(M_PI / kDirections) * (1 + 4 * tricover::kRigidTolerance)", "largest * 0.9", "own motion: slower than it is"),
    ("fcl_adapter/src/shape/course.cpp", "beyond.margin = options.margin;", "", "own motion: margins"),
    ("fcl_adapter/src/shape/heights.h", "return tricover::detail::twoSum(of_pose, of_shape).low;", "return 0;", "heights: what rounding left is lost"),
    ("fcl_adapter/src/shape/motion_in_plane.h", "return static_cast<double>(rounded) <= time ? rounded : std::nextafter(rounded, S(0));", "return std::nextafter(rounded, S(1));", "advancement: rounded upwards"),
    ("fcl_adapter/src/shape/planar_pose.h", "size(1, 2) <= kTiltTolerance", "true", "planar pose: an entry of the third column unchecked"),
    ("fcl_adapter/src/shape/planar_pose.h", "size(2, 0) <= kTiltTolerance &&", "", "planar pose: an entry of the third row unchecked"),
    ("fcl_adapter/src/shape/planar_pose.h", "(std::abs(size(2, 2) - 1) + ", "(0 + ", "planar pose: any scale of z"),
    ("fcl_adapter/src/shape/polygon_shape.cpp", "const double grown = pad + margin;", "const double grown = margin;", "box: without what FCL drops of a tiny rotation"),
    ("fcl_adapter/src/shape/polygon_shape.cpp", "if (static_cast<double>(rounded) >= value) return rounded;", "return rounded;", "box: rounded to float inwards"),
    ("fcl_adapter/src/shape/polygon_shape.cpp", "+ 0x1p-47 * reach +", "+", "tight box: without rounding"),
]
