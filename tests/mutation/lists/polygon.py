# SPDX-License-Identifier: BSD-3-Clause
# (file, text as it stands there once, replacement, what it breaks): see ../run.py.
MUTATIONS = [
    ("src/polygon/covering.cpp", "(d_v != 0 && d_w != 0 ? 2 * g : g)", "2 * g", "Algorithm 1: rays count twice"),
    ("src/polygon/covering.cpp", "const int side = g * sign(v, w);", "const int side = sign(v, w);", "Algorithm 1: sign of the triangle"),
    ("src/polygon/covering.cpp", "on_boundary_ = side == 0;", "", "Algorithm 1: boundary"),
    ("src/polygon/covering.cpp", "return on_boundary_ = sign(v, w) == 0 && between(v, w), !on_boundary_;", "return true;", "repair 5: edges collinear with S"),
    ("src/polygon/covering.cpp", "if (isOff(s_, near)) return;", "return;", "the point at or near S"),
    ("src/polygon/covering.h", "winding % 2 != 0 : winding != 0", "winding == 1 : winding == 1", "repair 4: winding +1 only"),
    ("src/polygon/covering.h", "winding % 2 != 0 : winding != 0", "winding % 2 != 0 : winding % 2 != 0", "fill rule ignored"),
    ("src/polygon/covering.h", "polygon.radius + 2 * p.error", "polygon.radius", "disc: error of the point"),
    ("src/polygon/influence.cpp", "length * std::sqrt(ux * ux + uy * uy) * (1 + 8 * kUnitRoundoff)", "0.999 * length * std::sqrt(ux * ux + uy * uy)", "influence area: too narrow"),
    ("src/polygon/influence.cpp", "<= 0 && detail::inExtendedArea", ">= 0 && detail::inExtendedArea", "repair 3: one-sided area on the wrong side"),
    ("src/polygon/polygon.cpp", "square = larger(dx * dx + dy * dy, square);", "square = smaller(dx * dx + dy * dy, square + 1e-3);", "bounding radius too small"),
    ("src/polygon/convexity.cpp", "(at <= along && at < way.squaredNorm() ? low : high) = middle;", "high = middle;", "divided sides: the first edge"),
    ("src/polygon/convexity.cpp", "const bool is_corner = turn != 0 || !isBetween(p, q, r);", "const bool is_corner = turn != 0;", "convex: a spike's tip is straight"),
    ("src/polygon/polygon.cpp", "reduced->origin = origin;", "", "corners alone: from another S"),
    ("src/polygon/area.cpp", "if (w.y() < v.y()) edges.push_back({w, v, 1});", "if (w.y() < v.y()) edges.push_back({w, v, -1});", "area: winding of edges that fall"),
    ("src/polygon/area.cpp", "std::swap(sides_[left], sides_[left + 1]);", "std::swap(sides_[left].top, sides_[left + 1].top);", "area: crossed sides stay where they were"),
    ("src/polygon/simplified.cpp", "if (all_are_near && !tolerance_.holds(distance, polygon_.path[i], v, w)) all_are_near = false;", "if (i == chain.begin + 1 && !tolerance_.holds(distance, polygon_.path[i], v, w)) all_are_near = false;", "simplified: one vertex asked of a chain"),
    ("src/polygon/simplified.cpp", "std::clamp(from.dot(way) / square, 0.0, 1.0)", "from.dot(way) / square", "simplified: the chord's line"),
    ("src/polygon/simplified.cpp", "if (polygon_.fitsUnit() && distance < most - error) return true;", "if (polygon_.fitsUnit() && distance < most + error) return true;", "simplified: rounding of distances"),
]
