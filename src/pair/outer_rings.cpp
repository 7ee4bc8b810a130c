// SPDX-License-Identifier: BSD-3-Clause
#include "pair/outer_rings.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <queue>

#include "numbers/segment.h"
#include "pair/edge_sides.h"
#include "pair/interiors.h"
#include "polygon/simplified.h"

namespace tricover {
namespace detail {
namespace {

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
/// to
///   its foot, and x on it. It doesn't meet q's line, which doesn't come so far.
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
    if (!isOutside({at(a).place, at(b).place, at(c).place})) return false;
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
    if (!isOutside({at(a).place, corner.place, at(d).place, at(c).place, at(b).place})) return false;
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

  /// Whether the inside is missing beside an old edge. An edge that stands for several was tested before.
  bool isBare(std::size_t corner) {
    if (at(corner).chain != 1 || at(corner).isNew() || at(at(corner).next).isNew()) return false;
    return EdgeSides(itself_, itself_, EdgeSides::A, begin_ + at(corner).foot).isBare();
  }

  bool isOutside(const Ring& loop) const {
    const Polygon wound({loop}, FillRule::NonZero);
    return !interiorsMeet(polygon_, here_, wound.data(), here_);
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
  const Pose here_ = Pose::Identity();
  const PosedPair itself_{polygon_, here_, polygon_, here_};
  std::size_t begin_ = 0, count_ = 0, left_ = 0;  ///< of the ring: its first position, its vertices, corners
  std::vector<Corner> corners_;
  std::priority_queue<Proposal> proposals_;
  std::uint64_t now_ = 0;
};

}  // namespace

std::vector<Ring> outerRings(const PolygonData& polygon, double tolerance) {
  // The same region without the vertices on straight chains, each of which would look along all of its chain.
  const Polygon same(simplifiedRings(polygon, 0), polygon.fill);
  RingCover rings(same.data(), tolerance);
  std::vector<Ring> cover;
  for (std::size_t r = 0; r < polygon.ringCount(); ++r) cover.push_back(rings.cover(r));
  return cover;
}

}  // namespace detail

Polygon Polygon::simplified(double tolerance, Simplify side) const {
  detail::requireFiniteNotNegative(tolerance, "tolerance");
  const auto rings =
      side == Simplify::Outwards ? detail::outerRings(*data_, tolerance) : detail::simplifiedRings(*data_, tolerance);
  return Polygon(rings, data_->fill);
}

}  // namespace tricover
