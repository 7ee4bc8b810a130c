// SPDX-License-Identifier: BSD-3-Clause
#include "ray_laws.h"

#include <algorithm>
#include <cmath>

#include "shapes.h"

namespace tricover::support {
namespace {

/// A point of the world on or about an edge or a vertex, or near S.
Vec2 nearPoint(Random& random, const Polygon& polygon, const Pose& pose) {
  const EdgeIndex edge = anyEdge(random, polygon);
  const Vec2 v = pose * polygon.edgeStart(edge), w = pose * polygon.edgeEnd(edge), s = pose * polygon.coveringOrigin();
  switch (random.integer(0, 4)) {
    case 0:
      return v;
    case 1:
      return v + random.integer(1, 7) / 8.0 * (w - v);
    case 2:
      return {v.x(), w.y()};
    case 3:
      return s + random.unit() * (v - s) + random.unit() * (w - s);
    default:
      return s;
  }
}

/// Of length 1.
Vec2 direction(const Vec2& v, const Vec2& w) {
  const bool overflows = !(w - v).allFinite();
  const Vec2 u = overflows ? Vec2(w / 2 - v / 2) : Vec2(w - v);
  return (u / u.lpNorm<Eigen::Infinity>()).normalized();
}

}  // namespace

EdgeIndex namedEdge(const Polygon& polygon, EdgeIndex edge) {
  EdgeIndex begin = 0;
  for (const Ring& ring : polygon.rings()) {
    const auto size = static_cast<EdgeIndex>(ring.size());
    if (edge >= begin && edge < begin + size)
      for (EdgeIndex k = 0; k < size; ++k) {
        const EdgeIndex next = begin + (edge - begin + k) % size;
        if (polygon.edgeStart(next) != polygon.edgeEnd(next)) return next;
      }
    begin += size;
  }
  return edge;
}

Ray anyRay(Random& random, const Polygon& polygon, const Pose& pose) {
  const EdgeIndex edge = anyEdge(random, polygon);
  const Vec2 v = pose * polygon.edgeStart(edge), w = pose * polygon.edgeEnd(edge);
  const double before = random.integer(0, 12) / 4.0, after = random.integer(-2, 12) / 4.0;
  const int ulps = random.oneIn(3) ? random.integer(1, 2) : 0;
  const Vec2 p = nearPoint(random, polygon, pose), q = random.coin() ? v : nearPoint(random, polygon, pose);
  const Vec2 outwards = v - pose * polygon.coveringOrigin();
  switch (random.integer(0, 5)) {
    case 0:  // along an edge
      return {v - before * (w - v), v + after * (w - v)};
    case 1:  // past a vertex, about at right angles to the way from S
      return {nudged(random, v + before * Vec2(-outwards.y(), outwards.x()), ulps),
              nudged(random, v - after * Vec2(-outwards.y(), outwards.x()), ulps)};
    case 2:  // a point, or as good as one
      return {p, nudged(random, p, ulps)};
    case 3:  // parallel to an axis
      return {random.coin() ? Vec2(p.x() - 4 * before * outwards.norm(), p.y())
                            : Vec2(p.x(), p.y() + 4 * before * outwards.norm()),
              p};
    case 4: {  // from far away, or far beyond
      const Vec2 far = (1 + before) * std::pow(10.0, random.integer(0, 12)) * outwards;
      if (random.coin()) return {nudged(random, q + far, ulps), p};
      return {q + before * outwards, nudged(random, p - far, ulps)};
    }
    default:
      return {nudged(random, q + before * (q - p), ulps), nudged(random, p - after * (q - p), ulps)};
  }
}

std::string wrongHit(const Polygon& polygon, const Pose& pose, const Ray& ray, const RayHit& hit,
                     const exact::FirstHit& truth) {
  if (hit.edge != namedEdge(polygon, static_cast<EdgeIndex>(truth.edge))) return "edge";
  if (!(hit.fraction >= 0 && hit.fraction <= 1) || abs(mpq_class(hit.fraction) - truth.fraction) > mpq_class(1e-14))
    return "fraction";
  const double size = 2 * polygon.radius() + (pose * polygon.coveringOrigin() - ray.from).stableNorm();
  const double length = (ray.to - ray.from).stableNorm();
  const bool finite = std::isfinite(length) && std::isfinite(size);
  const bool known = finite && length > 1e-290 && size > 1e-10 * ray.from.stableNorm();  // of doubles
  if (known && mpq_class(length) * abs(mpq_class(hit.fraction) - truth.fraction) > mpq_class(1e-13) * mpq_class(size))
    return "fraction of a long ray";
  if (!hit.point.allFinite() || !hit.normal.allFinite()) return "not finite";
  for (int axis = 0; axis < 2; ++axis) {
    const mpq_class from(ray.from[axis]), way = mpq_class(ray.to[axis]) - from;
    const mpq_class off = abs(mpq_class(hit.point[axis]) - (from + truth.fraction * way));
    const double largest = std::max(std::abs(ray.from[axis]), std::abs(ray.to[axis]));
    if (off > mpq_class(1e-14) * abs(way) + mpq_class(0x1p-51) * mpq_class(largest) + mpq_class(0x1p-1074))
      return "point";
  }
  if (ray.from == ray.to) return hit.normal == Vec2::Zero() ? "" : "normal of a point";
  if (std::abs(hit.normal.norm() - 1) > 1e-14) return "normal's length";
  const Vec2 way = direction(ray.from, ray.to);
  if (hit.normal.dot(way) > 1e-9) return "normal along the ray";
  if (hit.edge < 0 || hit.normal.dot(way) < -1 + 1e-14) return "";
  const Vec2 along = pose.linear() * direction(polygon.edgeStart(hit.edge), polygon.edgeEnd(hit.edge));
  return std::abs(hit.normal.dot(along)) > 1e-14 ? "normal along the edge" : "";
}

std::string wrongIntervals(const Polygon& polygon, const Pose& pose, const Ray& ray,
                           const std::vector<RayInterval>& intervals, const std::vector<exact::RayPart>& truth) {
  if (intervals.size() != truth.size()) return "number of intervals";
  const auto hit = castRay(polygon, pose, ray.from, ray.to);
  if (hit.has_value() == intervals.empty()) return "castRay: hit or not";
  if (!hit) return "";
  const RayHit& first = intervals.front().begin;
  if (hit->fraction != first.fraction || hit->point != first.point || hit->normal != first.normal ||
      hit->edge != first.edge)
    return "castRay: the first begin";
  const auto back = castRayAll(polygon, pose, ray.to, ray.from);
  if (back.size() != intervals.size()) return "number of intervals on the way back";
  double fraction = 0;
  for (std::size_t i = 0; i < intervals.size(); ++i) {
    const RayHit &begin = intervals[i].begin, &end = intervals[i].end;
    if (!(fraction <= begin.fraction && begin.fraction <= end.fraction)) return "order";
    fraction = end.fraction;
    std::string wrong = wrongHit(polygon, pose, ray, begin, truth[i].begin);
    if (!wrong.empty()) return "begin: " + wrong;
    wrong = wrongHit(polygon, pose, ray, {end.fraction, end.point, -end.normal, end.edge}, truth[i].end);
    if (!wrong.empty()) return "end: " + wrong;
    const RayInterval& opposite = back[back.size() - 1 - i];
    if (opposite.begin.edge != end.edge || opposite.end.edge != begin.edge) return "edges on the way back";
    if (opposite.begin.normal != end.normal || opposite.end.normal != begin.normal) return "normals on the way back";
  }
  return "";
}

}  // namespace tricover::support
