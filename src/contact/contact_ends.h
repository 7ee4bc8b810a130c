// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "numbers/segment.h"
#include "pair/world_frame.h"
#include "polygon/edge_walk.h"
#include "tricover/contacts.h"

namespace tricover::detail {

/// A contact with one point, in the world.
Contact contactAt(const Vec2& point, const Vec2& normal, double depth, EdgeIndex edge_a, EdgeIndex edge_b);

/// A straight piece of an outline at a contact: heights along the normal over places across it, from the contact's
/// point.
struct Slope {
  Slope(const Vec2& v, const Vec2& w)
      : low(std::min(v.x(), w.x())),
        high(std::max(v.x(), w.x())),
        low_height(v.x() <= w.x() ? v.y() : w.y()),
        high_height(v.x() <= w.x() ? w.y() : v.y()) {}
  Slope(const WorldFrame::Ends& piece, const Vec2& point, const Vec2& normal)
      : Slope(across(piece.v - point, normal), across(piece.w - point, normal)) {}

  double at(double place) const {
    const double t = (place - low) / (high - low);
    return t < 0.5 ? low_height + t * (high_height - low_height) : high_height + (t - 1) * (high_height - low_height);
  }

  double low, high, low_height, high_height;

 private:
  static Vec2 across(const Vec2& way, const Vec2& normal) { return {cross(normal, way), normal.dot(way)}; }
};

/// The incident edge, clipped to the face: the ends of the interval where two pieces face each other and overlap by no
/// more than the depth, the deeper one first, from the contact's point. The normal leads from the lower piece to the
/// upper one. Both ends are between the two by the same share as that point, and in the middle where only the margin
/// makes the pieces overlap. False if the interval is a point, an end of it isn't in contact, or neither is as deep
/// as the contact. `depth` is with the margin, and lengths are off by `error`.
struct ContactEnd {
  double place, height, depth;
};
using ContactEnds = std::array<ContactEnd, 2>;
bool contactEnds(const Slope& lower, const Slope& upper, double depth, double margin, double error, ContactEnds& ends);

/// Gives the contact both ends, if there are two, by two pieces and its point in the WorldFrame.
void addEnds(Contact& contact, const WorldFrame& frame, const WorldFrame::Ends& of_a, const WorldFrame::Ends& of_b,
             const Vec2& point, double margin);

/// Places along a unit vector.
struct Extent {
  Vec2 along;
  double low = -std::numeric_limits<double>::infinity(), high = -low;
};

/// The straight piece of an outline (side 0: a's, 1: b's) that an edge is part of, but for rounding, up to the first
/// vertices beyond the extent. In the WorldFrame.
WorldFrame::Ends straightPiece(const PosedPair& pair, const WorldFrame& frame, int side, EdgePosition edge,
                               const Extent& extent);

}  // namespace tricover::detail
