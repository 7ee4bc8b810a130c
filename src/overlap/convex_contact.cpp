// SPDX-License-Identifier: BSD-3-Clause
// Rotating hulls give the faces' depths. From the best face and the vertex deepest behind it both boundaries are
// followed, to either side, to where they cross.
//
// Why there is nothing else: two pairs of edges are proven to cross properly, one at either end of a chain of vertices
// of one polygon that are proven to be inside the other, and of a chain of the other one's likewise. The two chains
// with their ends are in both regions and on their own one's boundary, so on that of the overlap, which is convex; they
// meet at their ends alone. They are a closed curve on a closed curve, so all of it.
#include "overlap/convex_contact.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

#include "overlap/convex_outline.h"
#include "overlap/convex_ring.h"
#include "overlap/frame_of_a.h"
#include "overlap/part_middle.h"
#include "pair/world_frame.h"

namespace tricover::detail {
namespace {

/// How an area, the product of two differences of vertices, errs: in either coordinate a vertex is at most r =
/// (1 + 1e-5) size, and errs by at most e = error, which is at least 16U size; a difference d is at most 2 r, and errs
/// by 2 e and its own U d.
///   the differences' roundings       two in each of two products     4U (2 r)^2
///   the products', their difference                                  4U (2 r)^2
///   what the vertices are off by     two for each of four factors    8 e 2 r
/// which is 32U r^2 + 16 e r and terms of second order: 18 e r with all of them.
template <typename Frame>
double doubtfulArea(const Frame& frame) {
  return 20 * frame.error() * frame.size();
}
static_assert(WorldFrame::kPointError >= 16 * kUnitRoundoff && kMappingError >= 16 * kUnitRoundoff);

/// A face and the vertex of the other polygon that is deepest behind it.
struct Face {
  bool of_a;
  std::size_t edge, deepest;
  double square;  ///< of the depth
};

/// Where two edges cross: an edge of the face's polygon and one of the other.
struct Meeting {
  std::size_t own, other;
  std::size_t own_passed, other_passed;  ///< vertices on the way there
};

/// In one of the frames that are there for it, counter-clockwise there.
template <typename Frame>
class ConvexPair {
 public:
  ConvexPair(const PosedPair& pair, int turn_a, int turn_b)
      : frame_(pair),
        doubtful_(doubtfulArea(frame_)),
        a_(pair.a, turn_a, [this](const Vec2& p) { return frame_.fromA(p); }),
        b_(pair.b, turn_b, [this](const Vec2& p) { return frame_.fromB(p); }) {}

  ConvexContact contact() {
    using Verdict = ConvexContact::Verdict;
    if (!lookBehindFaces(true) || !lookBehindFaces(false)) return {is_apart_ ? Verdict::Apart : Verdict::Unsure, {}};
    // Less may be a touch.
    if (!(least_ > 64 * frame_.error())) return {Verdict::Unsure, {}};
    const Face face = bestFace();
    const ConvexRing &own = face.of_a ? a_ : b_, &other = face.of_a ? b_ : a_;
    Meeting left, right;
    if (!findMeeting(own, other, face, true, left) || !findMeeting(own, other, face, false, right))
      return {Verdict::Unsure, {}};
    const std::size_t own_passed = left.own_passed + right.own_passed,
                      other_passed = left.other_passed + right.other_passed + 1;
    if (own_passed >= own.size() || other_passed >= other.size()) return {Verdict::Unsure, {}};
    PointList<36> part(own_passed + other_passed + 2);
    part.add(pointOf(face, left));
    if (!addChain(other, other.after(left.other), other_passed, own, part)) return {Verdict::Unsure, {}};
    part.add(pointOf(face, right));
    if (!addChain(own, own.after(right.own), own_passed, other, part)) return {Verdict::Unsure, {}};
    const Vec2 up = normalOf(face);
    const Vec2 middle = partMiddle(part, part, up, 4 * frame_.error()).middle;
    return {Verdict::Overlap, contactOf(face, up, middle)};
  }

 private:
  static constexpr std::size_t kMostBest = 8;

  /// Behind the faces of one of them. False if one of them parts the regions, or the deepest vertex is in doubt.
  bool lookBehindFaces(bool of_a) {
    const ConvexRing &ring = of_a ? a_ : b_, &body = of_a ? b_ : a_;
    std::size_t at = 0;
    for (std::size_t v = 1; v < body.size(); ++v)
      if (cross(ring.edge(0), body.vertex(v) - body.vertex(at)) > 0) at = v;
    const auto isClimbedTo = [&](std::size_t v) { return cross(ring.edge(0), body.edge(body.before(v))) > doubtful_; };
    if (!isClimbedTo(at)) at = body.before(at);
    if (!isClimbedTo(at)) return false;
    std::size_t steps = 2 * (ring.size() + body.size());
    const Vec2 *vertices = body.vertices(), *edges = body.edges();
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Vec2 way = ring.edge(k);
      double climb = cross(way, edges[at]);
      while (climb > doubtful_) {
        if (steps-- == 0) return false;
        at = body.after(at);
        climb = cross(way, edges[at]);
      }
      // Of a convex polygon what is next is less deep all around once it is for certain.
      std::size_t deepest = at;
      if (!(climb < -doubtful_)) {
        // An edge along the face.
        const std::size_t next = body.after(at);
        if (!(cross(way, edges[next]) < -doubtful_)) return false;
        if (climb > 0) deepest = next;
      }
      const double area = cross(way, vertices[deepest] - ring.vertex(k));
      if (area < -doubtful_) {
        is_apart_ = isBeyond(ring, k, body);
        return false;
      }
      const double positive = std::max(area, 0.0), square = way.squaredNorm();
      if (!(positive * positive > limit_ * square) && !keep({of_a, k, deepest, positive * positive / square}))
        return false;
    }
    return true;
  }

  bool isBeyond(const ConvexRing& ring, std::size_t k, const ConvexRing& body) const {
    for (std::size_t v = 0; v < body.size(); ++v)
      if (!(ring.leftOf(k, body.vertex(v)) < -doubtful_)) return false;
    return true;
  }

  /// Among the best, if it is: those that aren't deeper than the least one by more than rounding.
  bool keep(const Face& face) {
    if (face.square < least_ * least_) {
      least_ = std::sqrt(face.square);
      const double reach = least_ + 4 * frame_.error();
      limit_ = reach * reach;
      const auto end = std::remove_if(best_.begin(), best_.begin() + best_count_,
                                      [this](const Face& f) { return f.square > limit_; });
      best_count_ = end - best_.begin();
    }
    if (best_count_ == static_cast<std::ptrdiff_t>(best_.size())) return false;
    best_[static_cast<std::size_t>(best_count_++)] = face;
    return face.square >= 0;
  }

  /// Outwards.
  Vec2 normalOf(const Face& face) const {
    const Vec2& way = (face.of_a ? a_ : b_).edge(face.edge);
    return Vec2(way.y(), -way.x()).normalized();
  }

  /// Of those that are equally deep but for rounding, the one that leads b's origin away from a's.
  Face bestFace() const {
    const auto towardsB = [this](const Face& face) {
      return (face.of_a ? -1 : 1) * normalOf(face).dot(frame_.originOfA());
    };
    Face best = best_[0];
    for (std::ptrdiff_t k = 1; k < best_count_; ++k)
      if (towardsB(best_[static_cast<std::size_t>(k)]) > towardsB(best)) best = best_[static_cast<std::size_t>(k)];
    return best;
  }

  /// From the face on counter-clockwise and from the vertex deepest behind it back, or (not forward) the other way
  /// round: the edges that cross first. False where that isn't certain.
  bool findMeeting(const ConvexRing& own, const ConvexRing& other, const Face& face, bool forward,
                   Meeting& meeting) const {
    std::size_t i = face.edge, j = forward ? other.before(face.deepest) : face.deepest;
    std::size_t own_passed = 0, other_passed = 0;
    while (own_passed + other_passed < own.size() + other.size()) {
      const Vec2 &own_end = forward ? own.end(i) : own.vertex(i), &other_end = forward ? other.vertex(j) : other.end(j);
      const double own_in = other.leftOf(j, own_end), other_in = own.leftOf(i, other_end);
      if (own_in < 0 && other_in < 0) {
        meeting = {i, j, own_passed, other_passed};
        const Vec2 &own_start = forward ? own.vertex(i) : own.end(i),
                   &other_start = forward ? other.end(j) : other.vertex(j);
        return own_in < -doubtful_ && other_in < -doubtful_ && other.leftOf(j, own_start) > doubtful_ &&
               own.leftOf(i, other_start) > doubtful_;
      }
      // One that leaves the other one's edge has to wait for it; or else the one that is ahead.
      const bool own_waits = own_in < 0 || (other_in >= 0 && isAhead(own, i, own_end, other, j, other_end, forward));
      if (own_waits) {
        j = forward ? other.before(j) : other.after(j);
        ++other_passed;
      } else {
        i = forward ? own.after(i) : own.before(i);
        ++own_passed;
      }
    }
    return false;
  }

  static bool isAhead(const ConvexRing& own, std::size_t i, const Vec2& own_end, const ConvexRing& other, std::size_t j,
                      const Vec2& other_end, bool forward) {
    const Vec2 way = own.edge(i) - other.edge(j);
    const double ahead = way.dot(own_end - other_end);
    return forward ? ahead > 0 : ahead < 0;
  }

  /// On b's edge.
  Vec2 pointOf(const Face& face, const Meeting& meeting) const {
    const std::size_t i = face.of_a ? meeting.own : meeting.other, j = face.of_a ? meeting.other : meeting.own;
    const double from = a_.leftOf(i, b_.vertex(j)), to = a_.leftOf(i, b_.end(j));
    const double t = from / (from - to);
    return t < 0.5 ? Vec2(b_.vertex(j) + t * b_.edge(j)) : Vec2(b_.end(j) + (t - 1) * b_.edge(j));
  }

  /// Vertices in a row; false unless they are inside the other for certain.
  template <typename Points>
  bool addChain(const ConvexRing& ring, std::size_t first, std::size_t count, const ConvexRing& other,
                Points& points) const {
    for (std::size_t v = first; count > 0; --count, v = ring.after(v)) {
      if (!other.holds(ring.vertex(v), doubtful_)) return false;
      points.add(ring.vertex(v));
    }
    return true;
  }

  Contact contactOf(const Face& face, const Vec2& up, const Vec2& point) const {
    const ConvexRing &own = face.of_a ? a_ : b_, &other = face.of_a ? b_ : a_;
    const auto own_edge = static_cast<std::ptrdiff_t>(own.position(face.edge));
    // Of the vertex' edges the one that is more across the normal.
    const std::size_t leaving = other.leaving(face.deepest), arriving = other.arriving(face.deepest);
    const auto slope = [&](std::size_t edge) {
      const double along = up.dot(other.edge(edge));
      return along * along / other.edge(edge).squaredNorm();
    };
    const auto other_edge =
        static_cast<std::ptrdiff_t>(other.position(slope(arriving) < slope(leaving) ? arriving : leaving));
    const double depth = own.leftOf(face.edge, other.vertex(face.deepest)) / own.edge(face.edge).norm();
    assert(depth > 0 && std::abs(up.norm() - 1) < 0x1p-40);
    // One ring: positions are numbers.
    return {frame_.toWorld(point), frame_.directionToWorld(face.of_a ? up : Vec2(-up)), depth * frame_.unit(),
            face.of_a ? own_edge : other_edge, face.of_a ? other_edge : own_edge};
  }

  const Frame frame_;
  const double doubtful_;
  const ConvexRing a_, b_;
  bool is_apart_ = false;
  /// The least depth behind a face so far, and the square of what counts as equal.
  double least_ = std::numeric_limits<double>::infinity(), limit_ = least_;
  std::array<Face, kMostBest> best_;
  std::ptrdiff_t best_count_ = 0;
};

}  // namespace

ConvexContact convexContact(const PosedPair& pair) {
  const int turn_a = convexOutlineOf(pair.a).turn, turn_b = convexOutlineOf(pair.b).turn;
  if (turn_a == 0 || turn_b == 0) return {ConvexContact::Unsure, {}};
  const auto mirrors = [](const Pose& pose) { return pose.linear().determinant() < 0; };
  const bool mirrors_a = mirrors(pair.pose_a), mirrors_b = mirrors(pair.pose_b);
  if (FrameOfA::fits(pair))
    return ConvexPair<FrameOfA>(pair, turn_a, mirrors_a != mirrors_b ? -turn_b : turn_b).contact();
  return ConvexPair<WorldFrame>(pair, mirrors_a ? -turn_a : turn_a, mirrors_b ? -turn_b : turn_b).contact();
}

}  // namespace tricover::detail
