// SPDX-License-Identifier: BSD-3-Clause
// From the best face and the vertex deepest behind it both boundaries are followed, to either side, to where they
// cross.
//
// Why there is nothing else: two pairs of edges are proven to cross properly, one at either end of a chain of vertices
// of one polygon that are proven to be inside the other, and of a chain of the other one's likewise. The two chains
// with their ends are in both regions and on their own one's boundary, so on that of the overlap, which is convex; they
// meet at their ends alone. They are a closed curve on a closed curve, so all of it.
#include "contact/convex_contact.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>
#include <vector>

#include "contact/part_middle.h"
#include "numbers/segment.h"

namespace tricover::detail {
namespace {

/// So many points need no memory but the stack's.
template <std::size_t kFew>
class PointList {
 public:
  explicit PointList(std::size_t most) {
    if (most <= kFew) return;
    many_.resize(most);
    points_ = many_.data();
  }
  PointList(const PointList&) = delete;
  PointList& operator=(const PointList&) = delete;

  void add(const Vec2& p) { points_[size_++] = p; }
  std::size_t size() const { return size_; }
  const Vec2& operator[](std::size_t k) const { return points_[k]; }

 private:
  std::array<Vec2, kFew> few_;
  std::vector<Vec2> many_;
  Vec2* points_ = few_.data();
  std::size_t size_ = 0;
};

/// An outline as a's frame sees it, counter-clockwise there.
class RingInA {
 public:
  RingInA(const AxisSide& side, const AxisSide& a)
      : side_(side), a_(a), n_(side.ring.size()), mirrored_(side.mirrors != a.mirrors) {}

  std::uint32_t size() const { return n_; }
  std::uint32_t after(std::uint32_t k) const { return k + 1 < n_ ? k + 1 : 0; }
  std::uint32_t before(std::uint32_t k) const { return k > 0 ? k - 1 : n_ - 1; }

  /// In its polygon's own frame.
  const Vec2& corner(std::uint32_t k) const { return side_.corner(mirrored_ ? n_ - k : k); }
  Vec2 vertex(std::uint32_t k) const { return &side_ == &a_ ? corner(k) : a_.fromOther(corner(k)); }
  Vec2 end(std::uint32_t k) const { return vertex(k + 1); }
  /// Between the outline's numbers of corners and of edges and those here, either way.
  std::uint32_t cornerNumber(std::uint32_t k) const { return mirrored_ && k > 0 ? n_ - k : k; }
  std::uint32_t edgeNumber(std::uint32_t k) const { return mirrored_ ? n_ - 1 - k : k; }

 private:
  const AxisSide &side_, &a_;
  std::uint32_t n_;
  bool mirrored_;
};

/// Whether p, in an outline's own frame, is inside for certain, areas of up to `doubtful` being in doubt. O(log n).
bool holds(const AxisSide& side, const Vec2& p, double doubtful) {
  const Vec2 corner = side.corner(0);
  const Vec2 way = p - corner;
  // Between the ways from a corner to corners `low` and `high`.
  std::size_t low = 1, high = side.ring.size() - 1;
  if (!(cross(side.corner(1) - corner, way) > doubtful && cross(side.corner(high) - corner, way) < -doubtful))
    return false;
  while (high - low > 1) {
    const std::size_t middle = low + (high - low) / 2;
    const double turn = cross(side.corner(middle) - corner, way);
    if (!(turn > doubtful || turn < -doubtful)) break;
    (turn > 0 ? low : high) = middle;
  }
  for (std::size_t k = low; k < high; ++k)
    if (!(cross(side.corner(k + 1) - side.corner(k), p - side.corner(k)) > doubtful)) return false;
  return true;
}

/// Where two edges cross: an edge of the face's polygon and one of the other.
struct Crossing {
  std::uint32_t own = 0, other = 0;
  std::uint32_t own_passed = 0, other_passed = 0;  ///< vertices on the way there
  Vec2 point = Vec2::Zero();                       ///< on b's edge
};

class ConvexPair {
 public:
  explicit ConvexPair(const PosedPair& pair, const SeparatingAxes& axes)
      : pair_(pair), axes_(axes), a_(axes_.side(true), axes_.side(true)), b_(axes_.side(false), axes_.side(true)) {
    // In either coordinate a corner is at most r = kUnitRows size, and errs by at most e = error, which is at least
    // 16U size; a difference d of two is at most 2 r, and errs by 2 e and its own U d. An area, the product of two:
    //   the differences' roundings       two in each of two products     4U (2 r)^2
    //   the products', their difference                                  4U (2 r)^2
    //   what the corners are off by      two for each of four factors    8 e 2 r
    // which is 32U r^2 + 16 e r and terms of second order: 18 e r with all of them.
    doubtful_ = 20 * axes_.error() * (axes_.error() / kMappingError);
  }

  /// What is proven of a pair that meets.
  std::optional<Contact> contact() const {
    // Less may be a touch.
    if (!(axes_.leastDepth() > 64 * axes_.error())) return {};
    const FaceDepth face = bestFace();
    const RingInA &own = face.of_a ? a_ : b_, &other = face.of_a ? b_ : a_;
    Crossing left, right;
    if (!findCrossing<true>(own, other, face, left) || !findCrossing<false>(own, other, face, right)) return {};
    const std::uint32_t own_passed = left.own_passed + right.own_passed,
                        other_passed = left.other_passed + right.other_passed + 1;
    if (own_passed >= own.size() || other_passed >= other.size()) return {};
    PointList<36> part(own_passed + other_passed + 2);
    part.add(inWorld(left.point));
    if (!addChain(other, !face.of_a, other.after(left.other), other_passed, part)) return {};
    part.add(inWorld(right.point));
    if (!addChain(own, face.of_a, own.after(right.own), own_passed, part)) return {};
    // Outwards from the face.
    const Vec2 up = axes_.side(face.of_a).normalOf(face.edge);
    const Vec2 middle = partMiddle(part, part, up, 4 * axes_.error()).middle;
    return contactOf(face, up, middle + pair_.pose_a.translation());
  }

 private:
  /// Less a's translation.
  Vec2 inWorld(const Vec2& p) const { return axes_.side(true).inWorld(p); }

  /// Of those that are equally deep but for rounding, the one that leads b's S away from a's.
  FaceDepth bestFace() const {
    if (axes_.end() - axes_.begin() == 1) return *axes_.begin();
    const Vec2 towards_b = inWorld(Vec2(pair_.center_x, pair_.center_y) - pair_.a.origin);
    const auto along = [&](const FaceDepth& face) {
      return (face.of_a ? 1 : -1) * axes_.side(face.of_a).normalOf(face.edge).dot(towards_b);
    };
    const FaceDepth* best = nullptr;
    for (const FaceDepth& face : axes_)
      if (face.depth <= axes_.leastDepth() + axes_.tie() && (best == nullptr || along(face) > along(*best)))
        best = &face;
    return *best;
  }

  /// From the face on counter-clockwise and from the vertex deepest behind it back, or (not kForward) the other way
  /// round: the edges that cross first. False where that isn't certain.
  template <bool kForward>
  bool findCrossing(const RingInA& own, const RingInA& other, const FaceDepth& face, Crossing& crossing) const {
    const std::uint32_t deepest = other.cornerNumber(face.deepest);
    std::uint32_t i = own.edgeNumber(face.edge), j = kForward ? other.before(deepest) : deepest;
    std::uint32_t own_passed = 0, other_passed = 0;
    // Of both edges, from here to there.
    Vec2 own_from = kForward ? own.vertex(i) : own.end(i), own_to = kForward ? own.end(i) : own.vertex(i);
    Vec2 other_from = kForward ? other.end(j) : other.vertex(j), other_to = kForward ? other.vertex(j) : other.end(j);
    while (own_passed + other_passed < own.size() + other.size()) {
      const Vec2 own_way = kForward ? own_to - own_from : own_from - own_to,
                 other_way = kForward ? other_from - other_to : other_to - other_from;
      const double own_in = cross(other_way, own_to - other_to), other_in = cross(own_way, other_to - own_to);
      if (own_in < 0 && other_in < 0) {
        const double own_out = cross(other_way, own_from - other_to), other_out = cross(own_way, other_from - own_to);
        crossing = {i, j, own_passed, other_passed,
                    face.of_a ? crossingPoint(other_from, other_to, other_out, other_in)
                              : crossingPoint(own_from, own_to, own_out, own_in)};
        return own_in < -doubtful_ && other_in < -doubtful_ && own_out > doubtful_ && other_out > doubtful_;
      }
      // One that leaves the other one's edge has to wait for it; or else the one that is ahead.
      const double ahead = (own_way - other_way).dot(own_to - other_to);
      const bool own_waits = own_in < 0 || (other_in >= 0 && (kForward ? ahead > 0 : ahead < 0));
      if (own_waits) {
        j = kForward ? other.before(j) : other.after(j);
        other_from = std::exchange(other_to, kForward ? other.vertex(j) : other.end(j));
        ++other_passed;
      } else {
        i = kForward ? own.after(i) : own.before(i);
        own_from = std::exchange(own_to, kForward ? own.end(i) : own.vertex(i));
        ++own_passed;
      }
    }
    return false;
  }

  /// The point of a way where it crosses another edge, by the areas that its ends span with that.
  static Vec2 crossingPoint(const Vec2& from, const Vec2& to, double from_area, double to_area) {
    const double t = from_area / (from_area - to_area);
    return t < 0.5 ? Vec2(from + t * (to - from)) : Vec2(to + (t - 1) * (to - from));
  }

  /// Vertices in a row; false unless they are inside the other for certain.
  bool addChain(const RingInA& ring, bool of_a, std::uint32_t first, std::uint32_t count, PointList<36>& points) const {
    const AxisSide& other = axes_.side(!of_a);
    for (std::uint32_t v = first; count > 0; --count, v = ring.after(v)) {
      if (!holds(other, other.fromOther(ring.corner(v)), doubtful_)) return false;
      points.add(inWorld(ring.vertex(v)));
    }
    return true;
  }

  /// Of the path's edges at a corner the one that is more across `up`.
  std::size_t flatterEdge(const AxisSide& side, std::uint32_t corner, const Vec2& up) const {
    const auto slope = [&](std::uint32_t edge) {
      const Vec2 way = side.inWorld(side.corner(edge + 1) - side.corner(edge));
      const double along = up.dot(way);
      return along * along / way.squaredNorm();
    };
    const std::uint32_t before = side.ring.previous(corner);
    const bool forward = side.outline.forward;
    const bool arriving = slope(forward ? before : corner) < slope(forward ? corner : before);
    return arriving ? pathEdgeTo(side.seen.a, side.outline, corner) : side.outline.corners[corner];
  }

  Contact contactOf(const FaceDepth& face, const Vec2& up, const Vec2& point) const {
    const AxisSide &own = axes_.side(face.of_a), &other = axes_.side(!face.of_a);
    const Vec2 deepest = own.fromOther(other.corner(face.deepest));
    // One ring: positions are numbers.
    const auto own_edge = static_cast<std::ptrdiff_t>(pathEdge(own.seen.a, own.outline, face.edge, deepest)),
               other_edge = static_cast<std::ptrdiff_t>(flatterEdge(other, face.deepest, up));
    assert(face.depth > 0 && std::abs(up.norm() - 1) < 0x1p-40);
    return {point, face.of_a ? up : Vec2(-up), face.depth, face.of_a ? own_edge : other_edge,
            face.of_a ? other_edge : own_edge};
  }

  const PosedPair& pair_;
  const SeparatingAxes& axes_;
  const RingInA a_, b_;
  double doubtful_;  ///< areas of corners, up to this
};

}  // namespace

std::optional<Contact> convexContact(const PosedPair& pair, const SeparatingAxes& axes) {
  return ConvexPair(pair, axes).contact();
}

}  // namespace tricover::detail
