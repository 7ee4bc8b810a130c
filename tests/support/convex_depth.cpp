// SPDX-License-Identifier: BSD-3-Clause
#include "convex_depth.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace tricover::support {
namespace {

constexpr long double kEpsilon = std::numeric_limits<long double>::epsilon();
constexpr long double kInfinity = std::numeric_limits<long double>::infinity();

struct Point {
  long double x, y;
};

struct Ring2 {
  std::vector<Point> points;  ///< counter-clockwise
  long double error = 0;      ///< of each coordinate
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
  const Point& s = ring.points[0];
  for (std::size_t i = 0; i < ring.points.size(); ++i) {
    const Point &p = ring.points[i], &q = ring.points[(i + 1) % ring.points.size()];
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
    const Point &v = of.points[i], &w = of.points[(i + 1) % of.points.size()];
    const long double dx = w.x - v.x, dy = w.y - v.y, length = std::sqrt(dx * dx + dy * dy);
    long double deepest = -kInfinity, error = 0;
    for (const Point& r : other.points) {
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
