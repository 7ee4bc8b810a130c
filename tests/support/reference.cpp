// SPDX-License-Identifier: BSD-3-Clause
#include "reference.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "exact_reference.h"

namespace tricover::support {
namespace {

/// Twice the unit roundoff. Terms of second order are below what the bounds leave over.
constexpr long double kEpsilon = std::numeric_limits<long double>::epsilon();
/// What underflow loses of a sum of products.
constexpr long double kTiny = 16 * std::numeric_limits<long double>::min();

Polygon edgeOf(const Polygon& polygon, std::size_t position) {
  const auto edge = static_cast<EdgeIndex>(position);
  return Polygon({{polygon.edgeStart(edge), polygon.edgeEnd(edge), polygon.edgeEnd(edge)}});
}

Polygon vertexOf(const Polygon& polygon, std::size_t position) {
  return Polygon({Ring(3, polygon.edgeStart(static_cast<EdgeIndex>(position)))});
}

}  // namespace

/// m00 x + m01 y + t errs by at most 3 roundoffs of its terms' sizes.
Reference::Posed::Posed(const Polygon& polygon, const Pose& pose) : fill(polygon.fillRule()) {
  const auto& m = pose.matrix();
  long double size = 0;
  const auto place = [&](const Vec2& p) {
    const long double x = p.x(), y = p.y();
    Point result;
    for (const int row : {0, 1}) {
      const long double terms[] = {m(row, 0) * x, m(row, 1) * y, m(row, 2)};
      (row == 0 ? result.x : result.y) = terms[0] + terms[1] + terms[2];
      size = std::max(size, std::abs(terms[0]) + std::abs(terms[1]) + std::abs(terms[2]));
    }
    return result;
  };
  for (const Ring& ring : polygon.rings()) {
    starts.push_back(edges.size());
    for (const Vec2& p : ring) edges.push_back({place(p), {}, {}, {}});
    for (std::size_t i = starts.back(); i < edges.size(); ++i) {
      Edge& e = edges[i];
      e.w = edges[i + 1 < edges.size() ? i + 1 : starts.back()].v;
      e.low = {std::min(e.v.x, e.w.x), std::min(e.v.y, e.w.y)};
      e.high = {std::max(e.v.x, e.w.x), std::max(e.v.y, e.w.y)};
    }
  }
  error = 2 * kEpsilon * size + kTiny;
}

/// The side of p q that r is on, 0 where that is in doubt. With d = q - p, e = r - p, whose coordinates are off by s
/// and t: the cross product is off by s |e|_1 + t |d|_1 + 2 s t, and rounding adds 4 roundoffs of its products (a
/// difference is off by one roundoff of itself, too).
int Reference::side(const Point& p, const Point& q, const Point& r, long double error_pq, long double error_r) {
  const long double dx = q.x - p.x, dy = q.y - p.y, ex = r.x - p.x, ey = r.y - p.y;
  const long double left = dx * ey, right = dy * ex, cross = left - right;
  const long double s = 2 * error_pq, t = error_pq + error_r;
  const long double bound = s * (std::abs(ex) + std::abs(ey)) + t * (std::abs(dx) + std::abs(dy)) + 2 * s * t +
                            4 * kEpsilon * (std::abs(left) + std::abs(right)) + kTiny;
  return cross > bound ? 1 : -cross > bound ? -1 : 0;
}

Reference::Answer Reference::meet(const Edge& e, const Edge& f) const {
  const long double error = 2 * (a_.error + b_.error);
  if (e.low.x - f.high.x > error || f.low.x - e.high.x > error || e.low.y - f.high.y > error ||
      f.low.y - e.high.y > error)
    return Answer::No;
  const int f_v = side(e.v, e.w, f.v, a_.error, b_.error), f_w = side(e.v, e.w, f.w, a_.error, b_.error);
  if (f_v * f_w > 0) return Answer::No;
  const int e_v = side(f.v, f.w, e.v, b_.error, a_.error), e_w = side(f.v, f.w, e.w, b_.error, a_.error);
  if (e_v * e_w > 0) return Answer::No;
  return f_v * f_w < 0 && e_v * e_w < 0 ? Answer::Yes : Answer::Doubt;
}

bool Reference::meetExactly(std::size_t i, std::size_t j) const {
  return exact::collide(edgeOf(case_.a, i), case_.pose_a, edgeOf(case_.b, j), case_.pose_b);
}

/// By the winding number along a ray to the right, half-open in y.
bool Reference::Posed::holds(const Point& p, long double p_error, bool& in_doubt) const {
  const long double most = 2 * (error + p_error);
  int winding = 0;
  for (const Edge& e : edges) {
    if (e.low.y - p.y > most || p.y - e.high.y > most || p.x - e.high.x > most) continue;
    const bool v_near = !(std::abs(e.v.y - p.y) > most), w_near = !(std::abs(e.w.y - p.y) > most);
    const int on_side = v_near || w_near ? 0 : side(e.v, e.w, p, error, p_error);
    if (on_side == 0) return in_doubt = true;
    const bool up = e.v.y < e.w.y;
    if (up && on_side > 0) ++winding;
    if (!up && on_side < 0) --winding;
  }
  return fill == FillRule::EvenOdd ? winding % 2 != 0 : winding != 0;
}

Location Reference::locate(const Polygon& polygon, const Vec2& point) {
  bool in_doubt = false;
  const bool holds = Posed(polygon, Pose::Identity()).holds({point.x(), point.y()}, 0, in_doubt);
  return in_doubt ? exact::locate(polygon, point) : holds ? Location::Inside : Location::Outside;
}

/// Where no edges meet: whether a (or b) holds a ring of the other one.
bool Reference::holdsRing(bool in_a) const {
  const Posed &holder = in_a ? a_ : b_, &held = in_a ? b_ : a_;
  for (const std::size_t start : held.starts) {
    bool in_doubt = false;
    const bool holds = holder.holds(held.edges[start].v, held.error, in_doubt);
    if (!in_doubt && holds) return true;
    if (!in_doubt) continue;
    const Polygon vertex = vertexOf(in_a ? case_.b : case_.a, start);
    if (exact::collide(in_a ? case_.a : case_.b, in_a ? case_.pose_a : case_.pose_b, vertex,
                       in_a ? case_.pose_b : case_.pose_a))
      return true;
  }
  return false;
}

Reference::Reference(const Case& c) : case_(c), a_(c.a, c.pose_a), b_(c.b, c.pose_b) {}

bool Reference::collide() const {
  if (collides_) return *collides_;
  std::vector<std::pair<std::size_t, std::size_t>> doubtful;
  for (std::size_t i = 0; i < a_.edges.size(); ++i)
    for (std::size_t j = 0; j < b_.edges.size(); ++j) {
      const Answer answer = meet(a_.edges[i], b_.edges[j]);
      if (answer == Answer::Yes) return *(collides_ = true);
      if (answer == Answer::Doubt) doubtful.emplace_back(i, j);
    }
  for (const auto& [i, j] : doubtful)
    if (meetExactly(i, j)) return *(collides_ = true);
  return *(collides_ = holdsRing(true) || holdsRing(false));
}

std::vector<std::pair<EdgeIndex, EdgeIndex>> Reference::meetingEdges() const {
  const std::vector<bool> cross_a = exact::edgesOfCrossings(case_.a), cross_b = exact::edgesOfCrossings(case_.b);
  std::vector<std::pair<EdgeIndex, EdgeIndex>> result;
  for (std::size_t i = 0; i < a_.edges.size(); ++i)
    for (std::size_t j = 0; j < b_.edges.size(); ++j) {
      if (!cross_a[i] || !cross_b[j]) continue;
      const Answer answer = meet(a_.edges[i], b_.edges[j]);
      if (answer == Answer::Yes || (answer == Answer::Doubt && meetExactly(i, j))) result.emplace_back(i, j);
    }
  return result;
}

/// Of the nearest points of two edges that don't meet. A vertex's place errs by twice its coordinates' error at most,
/// and a distance by what its ends do; the rest is rounding, relative to the way from the vertex to the edge's ends.
Reference::Bounds Reference::apart(const Edge& e, const Edge& f) const {
  Bounds least{std::numeric_limits<long double>::infinity(), std::numeric_limits<long double>::infinity()};
  const auto offer = [&](const Point& p, const Point& v, const Point& w) {
    const long double dx = w.x - v.x, dy = w.y - v.y, px = p.x - v.x, py = p.y - v.y;
    const long double along = dx * px + dy * py, square = dx * dx + dy * dy;
    const long double qx = p.x - w.x, qy = p.y - w.y, from_v = std::sqrt(px * px + py * py);
    const long double distance = along <= 0        ? from_v
                                 : along >= square ? std::sqrt(qx * qx + qy * qy)
                                                   : std::abs(dx * py - dy * px) / std::sqrt(square);
    const long double error = 4 * (a_.error + b_.error) + 16 * kEpsilon * (from_v + distance) + kTiny;
    least.low = std::min(least.low, error < least.high ? distance - error : 0);
    least.high = std::min(least.high, distance + error);
  };
  offer(e.v, f.v, f.w);
  offer(e.w, f.v, f.w);
  offer(f.v, e.v, e.w);
  offer(f.w, e.v, e.w);
  return least;
}

Reference::Bounds Reference::distance() const {
  if (collide()) return {0, 0};
  Bounds least{std::numeric_limits<long double>::infinity(), std::numeric_limits<long double>::infinity()};
  for (const Edge& e : a_.edges)
    for (const Edge& f : b_.edges) {
      const Bounds bounds = apart(e, f);
      least = {std::min(least.low, bounds.low), std::min(least.high, bounds.high)};
    }
  return {std::max(least.low, 0.0L), least.high};
}

mpq_class Reference::distanceSquared() const {
  if (collide()) return 0;
  const Bounds all = distance();
  std::optional<mpq_class> least;
  for (std::size_t i = 0; i < a_.edges.size(); ++i)
    for (std::size_t j = 0; j < b_.edges.size(); ++j) {
      if (apart(a_.edges[i], b_.edges[j]).low > all.high) continue;
      const mpq_class squared =
          exact::distanceSquared(edgeOf(case_.a, i), case_.pose_a, edgeOf(case_.b, j), case_.pose_b);
      if (!least || squared < *least) least = squared;
    }
  return *least;
}

bool Reference::within(double margin) const {
  const Bounds bounds = distance();
  if (bounds.high <= margin) return true;
  if (bounds.low > margin) return false;
  return exact::within(distanceSquared(), mpq_class(margin));
}

namespace {

constexpr long double kInfinity = std::numeric_limits<long double>::infinity();

struct Spot {
  long double x, y;
};

struct Ring2 {
  std::vector<Spot> points;  ///< counter-clockwise
  long double error = 0;     ///< of each coordinate
};

/// Products and sums of m00 x + m01 y + t round by 3 roundoffs of their sizes.
Ring2 posed(const Polygon& polygon, const Pose& pose) {
  const auto& m = pose.matrix();
  Ring2 ring;
  long double size = 0, area = 0;
  for (const Vec2& p : polygon.rings()[0]) {
    const long double x = p.x(), y = p.y();
    const long double xs[] = {m(0, 0) * x, m(0, 1) * y, m(0, 2)}, ys[] = {m(1, 0) * x, m(1, 1) * y, m(1, 2)};
    ring.points.push_back({xs[0] + xs[1] + xs[2], ys[0] + ys[1] + ys[2]});
    size = std::max({size, std::abs(xs[0]) + std::abs(xs[1]) + std::abs(xs[2]),
                     std::abs(ys[0]) + std::abs(ys[1]) + std::abs(ys[2])});
  }
  ring.error = 2 * kEpsilon * size;
  const Spot& s = ring.points[0];
  for (std::size_t i = 0; i < ring.points.size(); ++i) {
    const Spot &p = ring.points[i], &q = ring.points[(i + 1) % ring.points.size()];
    area += (p.x - s.x) * (q.y - s.y) - (p.y - s.y) * (q.x - s.x);
  }
  if (area < 0) std::reverse(ring.points.begin(), ring.points.end());
  return ring;
}

/// Over the faces of `of`. For an edge d and r - v = e: the cross product errs by s |e|_1 + t |d|_1 + 2 s t and 4
/// roundoffs of its products, where d's coordinates are off by s and e's by t; |d| by 2 s.
Reference::Bounds leastGap(const Ring2& of, const Ring2& other) {
  Reference::Bounds least{kInfinity, kInfinity};
  const long double s = 2 * of.error, t = of.error + other.error;
  for (std::size_t i = 0; i < of.points.size(); ++i) {
    const Spot &v = of.points[i], &w = of.points[(i + 1) % of.points.size()];
    const long double dx = w.x - v.x, dy = w.y - v.y, length = std::sqrt(dx * dx + dy * dy);
    long double deepest = -kInfinity, error = 0;
    for (const Spot& r : other.points) {
      const long double ex = r.x - v.x, ey = r.y - v.y, left = dx * ey, right = dy * ex;
      const long double depth = (left - right) / length;
      deepest = std::max(deepest, depth);
      error = std::max(error, (s * (std::abs(ex) + std::abs(ey)) + t * (std::abs(dx) + std::abs(dy)) + 2 * s * t +
                               4 * kEpsilon * (std::abs(left) + std::abs(right))) /
                                      length +
                                  std::abs(depth) * (2 * s / length + 4 * kEpsilon));
    }
    const bool is_known = 100 * s < length;
    least.low = std::min(least.low, is_known ? deepest - 2 * error : 0);
    least.high = std::min(least.high, is_known ? deepest + 2 * error : kInfinity);
  }
  return least;
}

}  // namespace

bool isStrictlyConvex(const Polygon& polygon) {
  if (polygon.rings().size() != 1) return false;
  const Ring& ring = polygon.rings()[0];
  int side = 0, changes = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 &p = ring[i], &q = ring[(i + 1) % ring.size()], &r = ring[(i + 2) % ring.size()];
    const long double dx = static_cast<long double>(q.x()) - p.x(), dy = static_cast<long double>(q.y()) - p.y(),
                      ex = static_cast<long double>(r.x()) - q.x(), ey = static_cast<long double>(r.y()) - q.y();
    const long double left = dx * ey, right = dy * ex, turn = left - right;
    if (!(std::abs(turn) > 4 * kEpsilon * (std::abs(left) + std::abs(right)))) return false;
    if (side != 0 && (turn > 0) != (side > 0)) return false;
    side = turn > 0 ? 1 : -1;
    changes += (dx > 0) != (ex > 0);
  }
  return changes == 2;
}

Reference::Bounds convexDepth(const Case& c) {
  const Ring2 a = posed(c.a, c.pose_a), b = posed(c.b, c.pose_b);
  const Reference::Bounds by_a = leastGap(a, b), by_b = leastGap(b, a);
  return {std::max(std::min(by_a.low, by_b.low), 0.0L), std::min(by_a.high, by_b.high)};
}

}  // namespace tricover::support
