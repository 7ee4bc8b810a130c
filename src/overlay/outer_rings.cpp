// SPDX-License-Identifier: BSD-3-Clause
#include "overlay/outer_rings.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <queue>

#include "hierarchy/inclusion.h"
#include "hierarchy/simd.h"
#include "numbers/errors.h"
#include "numbers/segment.h"
#include "overlay/edge_sides.h"
#include "polygon/simplified.h"

namespace tricover {
namespace detail {
namespace {

/// A triangle that isn't flat, counter-clockwise.
struct Triangle {
  /// Whether a segment has points inside. If not, a side's line or the segment's own parts them.
  bool isEnteredBy(const Vec2& v, const Vec2& w) const {
    for (int i = 0; i < 3; ++i)
      if (orientation(at(i), at(i + 1), v) <= 0 && orientation(at(i), at(i + 1), w) <= 0) return false;
    const int p = orientation(v, w, corner[0]), q = orientation(v, w, corner[1]), r = orientation(v, w, corner[2]);
    return std::min({p, q, r}) < 0 && std::max({p, q, r}) > 0;
  }

  /// Whether the region holds a point inside of it, exactly (2 p + q + r) / 4; or may, where that isn't exact.
  bool holdsInside(const PolygonData& polygon) const {
    const Vec2 &p = corner[0], &q = corner[1], &r = corner[2], middle = 0.5 * p + (0.25 * q + 0.25 * r);
    if (2 * (0.5 * p) != p || 4 * (0.25 * q) != q || 4 * (0.25 * r) != r) return true;
    Pose sum = Pose::Identity();
    sum.matrix().topRows<2>() << 0.25 * q, 0.25 * r, 0.5 * p;
    const double error = 4 * kUnitRoundoff * (p.lpNorm<1>() + q.lpNorm<1>() + r.lpNorm<1>()) + kTiny;
    return locateInPolygon(polygon, {nullptr, {middle.x(), middle.y(), error}, {&sum, Vec2(1, 1)}}) !=
           Location::Outside;
  }

  const Vec2& at(int i) const { return corner[i % 3]; }
  Vec2 corner[3];
};

/// Leaves corners out, those first that cost least (as progressive hulls do: Sander et al., Silhouette Clipping, 2000):
/// one between two others, whose triangle is filled; or an edge, whose neighbours are lengthened until they meet. Old
/// edges and new ones are a loop, and what the loops wind around is all that changes.
///
/// The new region covers the old one where
/// - no loop winds around a point of the old region's interior: there the rings wind as they did;
/// - no old edge is left out that is bare, without the inside beside it somewhere: any other point of an edge is next
///   to the interior, and the new region is closed.
///
/// It is within the tolerance of the old one where, for each edge pq of a ring, p and q are within it of places on old
/// edges, their feet; the old vertices from one foot to the other are within it of pq; and pq is longer than the lines
/// from p and q to their feet. With these the chain from foot to foot and pq are a loop; all such loops together are
/// what changes. Let x be a point that one winds around, or on pq:
/// - Beside pq, the line from x straight away from pq meets the chain, in reach; or a line to a foot, between which and
///   pq nothing is farther from the foot than its corner.
/// - Beyond p, the line from x straight away from p meets the chain, no farther from x than from p; or it is p's line
///   to its foot, and x on it. It doesn't meet q's line, which doesn't come so far.
class RingCover {
 public:
  RingCover(const PolygonData& polygon, double tolerance)
      : polygon_(polygon), tolerance_(std::min(tolerance, polygon.unit)), near_(polygon, tolerance_) {}

  Ring cover(std::size_t ring) {
    begin_ = polygon_.edgeBegin(ring);
    count_ = left_ = polygon_.edgeEnd(ring) - begin_;
    corners_.clear();
    for (std::size_t i = 0; i < count_; ++i)
      corners_.push_back({vertex(i), i, 1, 0, (i + count_ - 1) % count_, (i + 1) % count_, 0});
    for (std::size_t i = 0; i < count_; ++i) propose(i);
    std::size_t last = 0;
    while (!proposals_.empty() && left_ > 1) {
      const Proposal proposal = proposals_.top();
      proposals_.pop();
      if (isStale(proposal)) continue;
      if (proposal.edge ? removeEdge(proposal.corner) : removeCorner(proposal.corner))
        last = at(proposal.corner).previous;
    }
    proposals_ = {};
    Ring rest;
    for (std::size_t i = 0, corner = last; i < left_; ++i, corner = at(corner).next) rest.push_back(at(corner).place);
    while (rest.size() < 3) rest.push_back(rest.back());  // as rings are written
    return rest;
  }

 private:
  struct Corner {
    bool isNew() const { return offset > 0; }

    Vec2 place;
    std::size_t foot;   ///< the old edge that it is near; of an old vertex the one that begins there
    std::size_t chain;  ///< how many old vertices there are from its foot to the next one's
    double offset;      ///< to the foot, in units, rounded up; 0 for an old vertex
    std::size_t previous, next;
    std::uint64_t changed;  ///< when
  };

  /// To leave a corner out, or the edge that begins at it.
  struct Proposal {
    double cost;
    std::size_t corner;
    bool edge;
    std::uint64_t made;
    /// Corners before edges: what zigzags is smooth before its spikes are lengthened. Equal ones from all of the ring,
    /// so that chains grow alike.
    bool operator<(const Proposal& other) const {
      if (edge != other.edge) return edge;
      if (cost != other.cost) return cost > other.cost;
      return made != other.made ? made > other.made : corner > other.corner;
    }
  };

  Corner& at(std::size_t corner) { return corners_[corner]; }
  const Vec2& vertex(std::size_t number) const { return polygon_.path[begin_ + number % count_]; }

  void propose(std::size_t b) {
    const std::size_t a = at(b).previous, c = at(b).next, d = at(c).next;
    push(near_.distance(at(b).place, at(a).place, at(c).place), b, false);
    if (left_ > 3) push(near_.distance(meet(a, b, c, d), at(b).place, at(c).place), b, true);
  }
  void push(double cost, std::size_t corner, bool edge) {
    if (cost <= tolerance_ * polygon_.inverse_unit * (1 + 1e-9)) proposals_.push({cost, corner, edge, now_});
  }

  bool isStale(const Proposal& proposal) {
    const Corner& b = at(proposal.corner);
    const std::uint64_t changed = std::max({b.changed, at(b.previous).changed, at(b.next).changed});
    return std::max(changed, at(at(b.next).next).changed) > proposal.made;
  }

  /// Where the lines from a to b and from d to c meet, beyond b and c, and a little farther out, for what is rounded;
  /// NaN where they don't.
  Vec2 meet(std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
    const Vec2 &p = at(b).place, &q = at(c).place;
    const double inverse = polygon_.inverse_unit;
    const Vec2 u = (p - at(a).place) * inverse, w = (q - at(d).place) * inverse, way = (q - p) * inverse;
    const double area = cross(u, w), t = cross(way, w) / area, s = cross(way, u) / area;
    const Vec2 corner = p + t * (p - at(a).place), out = corner - (0.5 * p + 0.5 * q);
    if (t > 0 && s > 0) return corner + 0x1p-50 * polygon_.extent * out.normalized();
    return Vec2::Constant(std::numeric_limits<double>::quiet_NaN());
  }

  bool removeCorner(std::size_t b) {
    const std::size_t a = at(b).previous, c = at(b).next, chain = at(a).chain + at(b).chain;
    if (!isInReach(at(a), chain, at(c)) || isBare(a) || isBare(b)) return false;
    if (!isOutside(at(a).place, at(b).place, at(c).place)) return false;
    at(a).chain = chain;
    join(a, c);
    at(b).changed = ~std::uint64_t{0};
    at(b).previous = a;
    return true;
  }

  bool removeEdge(std::size_t b) {
    const std::size_t a = at(b).previous, c = at(b).next, d = at(c).next;
    Corner corner = at(b);
    corner.place = meet(a, b, c, d);
    const std::size_t before = findFoot(corner), after = at(b).chain + at(c).chain - before;
    corner.chain = after;
    if (!near_.holds(corner.place, vertex(corner.foot), vertex(corner.foot + 1))) return false;
    if (!isInReach(at(a), at(a).chain + before, corner) || !isInReach(corner, after, at(d))) return false;
    if (isBare(a) || isBare(b) || isBare(c)) return false;
    const Vec2 &p = at(b).place, &q = at(c).place;
    if (!isOutside(p, corner.place, q) || !isOutside(at(a).place, corner.place, p) ||
        !isOutside(q, corner.place, at(d).place))
      return false;
    at(c).changed = ~std::uint64_t{0};
    at(a).chain += before;
    at(b) = corner;
    join(b, d);
    return true;
  }

  /// Sets the foot of a corner that takes another one's place, at or after that one's foot. Returns how many edges
  /// after.
  std::size_t findFoot(Corner& corner) const {
    const std::size_t first = corner.foot;
    std::size_t steps = 0;
    corner.offset = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i <= corner.chain; ++i) {
      const double way = near_.distance(corner.place, vertex(first + i), vertex(first + i + 1));
      if (way < corner.offset) corner.offset = way, steps = i;
    }
    corner.offset = corner.offset * (1 + 1e-9) + 0x1p-44;
    corner.foot = (first + steps) % count_;
    return steps;
  }

  /// Whether what the edge between two corners stands for is within the tolerance, as above.
  bool isInReach(const Corner& p, std::size_t chain, const Corner& q) const {
    const double length = near_.distance(p.place, q.place, q.place), way = std::max(p.offset, q.offset);
    if (way > 0 && !(way < length * (1 - 1e-9))) return false;
    for (std::size_t i = 1; i <= chain; ++i)
      if (!near_.holds(vertex(p.foot + i), p.place, q.place)) return false;
    return true;
  }

  /// Whether the inside is missing beside an old edge: only where another edge lies along it, as the winding differs by
  /// one from side to side elsewhere. An edge that stands for several was tested before.
  bool isBare(std::size_t corner) {
    if (at(corner).chain != 1 || at(corner).isNew() || at(at(corner).next).isNew()) return false;
    const auto old = static_cast<EdgePosition>(begin_ + at(corner).foot);
    const Vec2 &v = polygon_.path[old], &w = polygon_.path[old + 1];
    const int axis = std::abs(w.x() - v.x()) >= std::abs(w.y() - v.y()) ? 0 : 1;
    bool is_alone = true;
    forEachEdgeNear(polygon_, polygon_.inUnits(v), polygon_.inUnits(w), 0, [&](EdgePosition edge) {
      const Vec2 &p = polygon_.path[edge], &q = polygon_.path[edge + 1];
      if (edge == old || p == q || orientation(v, w, p) != 0 || orientation(v, w, q) != 0) return true;
      const double begin = std::max(std::min(v[axis], w[axis]), std::min(p[axis], q[axis]));
      is_alone = begin >= std::min(std::max(v[axis], w[axis]), std::max(p[axis], q[axis]));
      return is_alone;
    });
    return !is_alone && EdgeSides(itself_, EdgeSides::A, old).hasAny(&EdgeSides::Piece::isBare);
  }

  /// Whether the inside of a triangle shares no point with the region's interior, nor with edges: then it is on one
  /// side of all of them.
  bool isOutside(const Vec2& p, const Vec2& q, const Vec2& r) const {
    const int turn = orientation(p, q, r);
    if (turn == 0) return true;
    const Triangle triangle{{p, turn > 0 ? q : r, turn > 0 ? r : q}};
    int longest = 0;
    for (int i = 1; i < 3; ++i)
      if ((triangle.at(i + 1) - triangle.at(i)).norm() > (triangle.at(longest + 1) - triangle.at(longest)).norm())
        longest = i;
    const Vec2 &from = triangle.at(longest), &to = triangle.at(longest + 1);
    const double reach = near_.distance(triangle.at(longest + 2), from, to);
    bool is_clear = true;
    forEachEdgeNear(polygon_, polygon_.inUnits(from), polygon_.inUnits(to), reach, [&](EdgePosition edge) {
      return is_clear = !triangle.isEnteredBy(polygon_.path[edge], polygon_.path[edge + 1]);
    });
    return is_clear && !triangle.holdsInside(polygon_);
  }

  void join(std::size_t p, std::size_t q) {
    at(p).next = q;
    at(q).previous = p;
    at(p).changed = at(q).changed = ++now_;
    --left_;
    std::size_t corner = at(at(p).previous).previous;
    for (int i = 0; i < 5; ++i, corner = at(corner).next) propose(corner);
  }

  const PolygonData& polygon_;
  const double tolerance_;
  const Tolerance near_;
  const PosedRegions itself_{polygon_};
  std::size_t begin_ = 0, count_ = 0, left_ = 0;  ///< of the ring: its first position, its vertices, corners
  std::vector<Corner> corners_;
  std::priority_queue<Proposal> proposals_;
  std::uint64_t now_ = 0;
};

/// The same ring without the vertices on straight chains, each of which would look along all of its chain.
Ring corners(const Ring& ring) {
  const auto isStraight = [](const Vec2& p, const Vec2& q, const Vec2& r) {
    const auto isBetween = [&](int i) { return std::min(p[i], r[i]) <= q[i] && q[i] <= std::max(p[i], r[i]); };
    return isBetween(0) && isBetween(1) && orientation(p, q, r) == 0;
  };
  Ring left;
  for (const Vec2& vertex : ring) {
    while (left.size() > 1 && isStraight(left.end()[-2], left.back(), vertex)) left.pop_back();
    left.push_back(vertex);
  }
  while (left.size() > 2 && isStraight(left.end()[-2], left.back(), left.front())) left.pop_back();
  if (left.size() > 2 && isStraight(left.back(), left[0], left[1])) left.erase(left.begin());
  while (left.size() < 3) left.push_back(left.back());  // as rings are written
  return left;
}

}  // namespace

std::vector<Ring> outerRings(const PolygonData& polygon, double tolerance) {
  std::vector<Ring> rings_of_corners;
  for (std::size_t r = 0; r < polygon.ringCount(); ++r) rings_of_corners.push_back(corners(polygon.vertices(r)));
  const Polygon same(rings_of_corners, polygon.fill.rule);
  RingCover rings(detail::dataOf(same), tolerance);
  std::vector<Ring> cover;
  for (std::size_t r = 0; r < polygon.ringCount(); ++r) cover.push_back(rings.cover(r));
  return cover;
}

}  // namespace detail

Polygon Polygon::simplified(double tolerance, Simplify side) const {
  detail::requireFiniteNotNegative(tolerance, "tolerance");
  if (side == Simplify::Outwards && isComplement())
    detail::refuse("side", "a complement is not simplified outwards",
                   "use Simplify::Both and a margin of the tolerance");
  const auto rings =
      side == Simplify::Outwards ? detail::outerRings(*data_, tolerance) : detail::simplifiedRings(*data_, tolerance);
  return withRings(rings);
}

}  // namespace tricover
