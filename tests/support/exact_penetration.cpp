// SPDX-License-Identifier: BSD-3-Clause
#include "exact_penetration.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "exact_reference.h"

namespace tricover::exact {
namespace {

struct Point {
  mpq_class x, y;
};

struct Segment {
  Point v, w;
};

Point operator-(const Point& p, const Point& q) { return {p.x - q.x, p.y - q.y}; }
mpq_class cross(const Point& p, const Point& q) { return p.x * q.y - p.y * q.x; }
mpq_class dot(const Point& p, const Point& q) { return p.x * q.x + p.y * q.y; }
Vec2 rounded(const Point& p) { return {p.x.get_d(), p.y.get_d()}; }

using Rings = std::vector<std::vector<Point>>;

Rings posed(const Polygon& polygon, const Pose& pose) {
  mpq_class m[2][3];
  for (int row = 0; row < 2; ++row)
    for (int column = 0; column < 3; ++column) m[row][column] = pose.matrix()(row, column);
  Rings rings;
  for (const Ring& ring : polygon.rings()) {
    auto& out = rings.emplace_back();
    for (const Vec2& vertex : ring) {
      const mpq_class x = vertex.x(), y = vertex.y();
      out.push_back({m[0][0] * x + m[0][1] * y + m[0][2], m[1][0] * x + m[1][1] * y + m[1][2]});
    }
  }
  return rings;
}

template <typename Visit>
void forEachEdge(const Rings& rings, Visit visit) {
  for (const auto& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) visit(ring[i], ring[(i + 1) % ring.size()]);
}

std::vector<Segment> convolution(const Rings& a, const Rings& b) {
  std::vector<Segment> segments;
  forEachEdge(a, [&](const Point& p, const Point& q) {
    forEachEdge(b, [&](const Point& r, const Point& s) {
      segments.push_back({p - r, p - s});
      segments.push_back({p - r, q - r});
    });
  });
  return segments;
}

/// 0's nearest point on a segment.
Point projection(const Segment& s) {
  const Point u = s.w - s.v;
  const mpq_class square = dot(u, u), along = -dot(s.v, u);
  if (along <= 0) return s.v;
  if (along >= square) return s.w;
  const mpq_class k = along / square;
  return {s.v.x + k * u.x, s.v.y + k * u.y};
}

bool mayCross(const Segment& s, const Segment& t) {
  return std::max(s.v.x, s.w.x) >= std::min(t.v.x, t.w.x) && std::max(t.v.x, t.w.x) >= std::min(s.v.x, s.w.x) &&
         std::max(s.v.y, s.w.y) >= std::min(t.v.y, t.w.y) && std::max(t.v.y, t.w.y) >= std::min(s.v.y, s.w.y);
}

double distance(const Vec2& p, const Vec2& v, const Vec2& w) {
  const Vec2 u = w - v;
  const double square = u.squaredNorm();
  const double k = square > 0 ? std::clamp((p - v).dot(u) / square, 0.0, 1.0) : 0;
  return (p - v - k * u).norm();
}

/// Whether some translation beside p is free: as far from it as the lines that don't pass it allow, so that it isn't
/// one of another face.
bool isFreeBeside(const Vec2& p, const std::vector<std::pair<Vec2, Vec2>>& segments, double size, const Polygon& a,
                  const Pose& pose_a, const Polygon& b, const Pose& pose_b) {
  std::vector<double> rays;
  double room = 1e-9 * size;
  for (const auto& [v, w] : segments) {
    if (const double apart = distance(p, v, w); apart > 1e-12 * size) {
      room = std::min(room, apart / 4);
      continue;
    }
    for (const Vec2& end : {v, w})
      if ((end - p).norm() > 1e-12 * size) rays.push_back(std::atan2(end.y() - p.y(), end.x() - p.x()));
  }
  if (rays.empty()) rays.push_back(0);
  std::sort(rays.begin(), rays.end());
  rays.push_back(rays.front() + 2 * M_PI);
  for (std::size_t i = 0; i + 1 < rays.size(); ++i) {
    if (rays[i + 1] - rays[i] < 1e-5) continue;
    const double middle = (rays[i] + rays[i + 1]) / 2;
    Pose moved = pose_b;
    moved.translation() += p + room * Vec2(std::cos(middle), std::sin(middle));
    if (!collide(a, pose_a, b, moved)) return true;
  }
  return false;
}

}  // namespace

double penetrationDepth(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b, double known) {
  const std::vector<Segment> segments = convolution(posed(a, pose_a), posed(b, pose_b));
  std::vector<Vec2> candidates;
  const auto offer = [&](const Point& p) {
    const Vec2 candidate = rounded(p);
    if (candidate.norm() < known) candidates.push_back(candidate);
  };
  std::vector<std::pair<Vec2, Vec2>> lines;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Segment& s = segments[i];
    lines.emplace_back(rounded(s.v), rounded(s.w));
    offer(projection(s));
    offer(s.v);
    offer(s.w);
    for (std::size_t j = 0; j < i; ++j) {
      const Segment& t = segments[j];
      if (!mayCross(s, t)) continue;
      const Point u = s.w - s.v, w = t.w - t.v, from = t.v - s.v;
      const mpq_class area = cross(u, w);
      if (area == 0) continue;
      const mpq_class k = cross(from, w) / area, l = cross(from, u) / area;
      if (k >= 0 && k <= 1 && l >= 0 && l <= 1) offer({s.v.x + k * u.x, s.v.y + k * u.y});
    }
  }
  std::sort(candidates.begin(), candidates.end(), [](const Vec2& p, const Vec2& q) {
    const double pp = p.squaredNorm(), qq = q.squaredNorm();
    return pp != qq ? pp < qq : std::lexicographical_compare(p.data(), p.data() + 2, q.data(), q.data() + 2);
  });
  candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
  const double size = a.radius() + b.radius();
  for (const Vec2& p : candidates)
    if (isFreeBeside(p, lines, size, a, pose_a, b, pose_b)) return p.norm();
  return known;
}

mpq_class convexPenetrationSquared(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b) {
  const Rings rings_a = posed(a, pose_a), rings_b = posed(b, pose_b);
  mpq_class least = -1;
  const auto over = [&](const Rings& of, const Rings& other) {
    forEachEdge(of, [&](const Point& p, const Point& q) {
      Point normal{q.y - p.y, p.x - q.x};
      const mpq_class square = dot(normal, normal);
      if (square == 0) return;
      for (const Point& r : of[0])  // outwards
        if (dot(normal, r - p) > 0) {
          normal = {-normal.x, -normal.y};
          break;
        }
      mpq_class gap = dot(normal, p - other[0][0]);
      for (const Point& r : other[0]) gap = std::max(gap, mpq_class(dot(normal, p - r)));
      const mpq_class squared = gap * gap / square;
      if (least < 0 || squared < least) least = squared;
    });
  };
  over(rings_a, rings_b);
  over(rings_b, rings_a);
  return least;
}

double hullDepth(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b) {
  const auto pointsOf = [](const Polygon& polygon, const Pose& pose) {
    std::vector<Vec2> points;
    for (const Ring& ring : polygon.rings())
      for (const Vec2& p : ring) points.push_back(pose * p);
    return points;
  };
  const std::vector<Vec2> of_a = pointsOf(a, pose_a), of_b = pointsOf(b, pose_b);
  double least = std::numeric_limits<double>::infinity();
  for (const std::vector<Vec2>* points : {&of_a, &of_b})
    for (const Vec2& p : *points)
      for (const Vec2& q : *points) {
        const Vec2 normal = Vec2(q.y() - p.y(), p.x() - q.x()).stableNormalized();
        if (!(normal.norm() > 0.5)) continue;
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (const Vec2& r : of_a) high = std::max(high, normal.dot(r));
        for (const Vec2& r : of_b) low = std::min(low, normal.dot(r));
        least = std::min(least, high - low);
      }
  return least;
}

}  // namespace tricover::exact
