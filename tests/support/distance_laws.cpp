// SPDX-License-Identifier: BSD-3-Clause
#include "distance_laws.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "exact_reference.h"
#include "reproduction.h"
#include "tricover/collide.h"
#include "tricover/depth.h"
#include "tricover/polygon.h"
#include "tricover/signed_distance.h"

namespace tricover::support {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kLargest = std::numeric_limits<double>::max();

/// A bound of what rounding makes of a posed vertex's coordinates.
double rounding(const Case& c) {
  const auto size = [](const Polygon& polygon, const Pose& pose) {
    double most = 0;
    for (const Ring& ring : polygon.rings())
      for (const Vec2& p : ring) most = std::max(most, std::abs(0.25 * p.x()) + std::abs(0.25 * p.y()));
    return most + 0.25 * std::abs(pose.translation().x()) + 0.25 * std::abs(pose.translation().y());
  };
  return 64 * 0x1p-53 * (size(c.a, c.pose_a) + size(c.b, c.pose_b)) + 0x1p-1070;
}

/// The world's edge, rounded.
std::pair<Vec2, Vec2> posedEdge(const Polygon& polygon, const Pose& pose, std::ptrdiff_t edge) {
  const auto at = [&](const Vec2& p) { return Vec2(pose.linear() * p + pose.translation()); };
  return {at(polygon.edgeStart(edge)), at(polygon.edgeEnd(edge))};
}

}  // namespace

bool isRootOf(double distance, const mpq_class& squared) {
  if (sgn(squared) == 0 || distance == 0) return sgn(squared) == 0 && distance == 0;
  const mpq_class error("1/100000000000000"), smallest(0x1p-1074);
  if (distance == kInfinity) return mpq_class(kLargest) * kLargest <= squared * (1 + error) * (1 + error);
  const mpq_class exact(distance), low = (exact - smallest) * (1 - error), high = (exact + smallest) * (1 + error);
  return (sgn(low) <= 0 || low * low <= squared) && squared <= high * high;
}

std::string wrongPoints(const Case& c, const DistanceResult& r) {
  // A common point is found by doubles alone.
  const double error = (r.distance == 0 ? 10 : 1) * rounding(c);
  const auto isOn = [&](const Polygon& polygon, const Pose& pose, std::ptrdiff_t edge, const Vec2& point) {
    const auto [v, w] = posedEdge(polygon, pose, edge);
    if (!v.allFinite() || !w.allFinite()) return true;
    return exact::within(exact::distanceSquared(point, v, w), mpq_class(error));
  };
  if (r.distance == 0 && (r.edge_a < 0) != (r.edge_b < 0)) {
    // The vertex as a polygon of its own.
    const bool in_a = r.edge_a < 0;
    const Polygon &holder = in_a ? c.a : c.b, &other = in_a ? c.b : c.a;
    const Pose &holder_pose = in_a ? c.pose_a : c.pose_b, &other_pose = in_a ? c.pose_b : c.pose_a;
    const EdgeIndex edge = in_a ? r.edge_b : r.edge_a;
    const Polygon vertex({Ring(3, other.edgeStart(edge))});
    return exact::collide(holder, holder_pose, vertex, other_pose) ? "" : "the vertex isn't contained";
  }
  if (r.edge_a < 0 || r.edge_b < 0) return "edges are missing";
  if (!r.point_a.allFinite() || !r.point_b.allFinite()) {
    for (const Vec2* p : {&r.point_a, &r.point_b})
      if (std::isnan(p->x()) || std::isnan(p->y())) return "a point is NaN";
    return {};
  }
  if (!isOn(c.a, c.pose_a, r.edge_a, r.point_a)) return "a's point isn't on its edge";
  if (!isOn(c.b, c.pose_b, r.edge_b, r.point_b)) return "b's point isn't on its edge";
  if (r.distance == 0) return r.point_a == r.point_b ? "" : "there are two common points";
  const mpq_class squared = exact::distanceSquared(r.point_a, r.point_b, r.point_b);
  const mpq_class high = mpq_class(std::min(r.distance, kLargest)) + 4 * mpq_class(error);
  const mpq_class low = mpq_class(std::min(r.distance, kLargest)) - 4 * mpq_class(error);
  const bool apart = (r.distance == kInfinity || squared <= high * high) && (sgn(low) <= 0 || low * low <= squared);
  return apart ? "" : "the points are not as far apart as the distance says";
}

std::string wrongDistance(double found, const LimitedOptions& options, const mpq_class& squared) {
  const double below = std::min(exact::distanceBelow(squared), kLargest);
  const bool within = exact::within(squared, mpq_class(options.margin));
  if ((found == 0) != within) return "zero or not";
  if (found > options.limit && found < kInfinity) return "above the limit";
  if (found == kInfinity) {
    // Where the distance overflows, or by the sum of limit and margin, rounded down to a double.
    const mpq_class sum = mpq_class(std::min(options.limit, kLargest)) + mpq_class(options.margin);
    return below < kLargest * (1 - 1e-14) && exact::within(squared, mpq_class(sum.get_d())) ? "not found" : "";
  }
  if (within) return "";
  // Of the distance and the margin together.
  const mpq_class slack = (mpq_class(below) + options.margin) * mpq_class("15/1000000000000000") + 0x1p-1073;
  const mpq_class result(found), margin(options.margin), most = result + margin + slack;
  if (squared > most * most) return "below the truth";
  const mpq_class least =
      (result - mpq_class(options.absolute_error)) / (1 + mpq_class(options.relative_error)) + margin - slack;
  return sgn(least) > 0 && least * least > squared ? "more than the options allow" : "";
}

std::string wrongDistances(const Case& c, const LimitedOptions& options, const mpq_class& squared, PairCache& cache) {
  const DistanceResult cold = distance(c.a, c.pose_a, c.b, c.pose_b, options),
                       turned = swapped(distance(c.b, c.pose_b, c.a, c.pose_a, options)),
                       cached = distance(c.a, c.pose_a, c.b, c.pose_b, cache, options);
  const auto described = [&](const std::string& wrong, const char* way, double found) {
    return wrong.empty() ? wrong
                         : "distance" + std::string(way) + ": " + wrong + ": " + hex(found) + ", margin " +
                               hex(options.margin) + ", errors " + hex(options.relative_error) + " and " +
                               hex(options.absolute_error) + ", limit " + hex(options.limit);
  };
  std::string wrong = described(wrongDistance(cold.distance, options, squared), "", cold.distance);
  if (!wrong.empty()) return wrong;
  if (!same(cold, turned)) return described("another", ", swapped", turned.distance);
  wrong = wrongDistance(cached.distance, options, squared);
  const bool is_exact = options.relative_error == 0 && options.absolute_error == 0;
  if (wrong.empty() && is_exact && cached.distance != cold.distance) wrong = "another";
  if (!wrong.empty() || cold.distance == kInfinity) return described(wrong, ", with a cache", cached.distance);
  // Points are where the edges say, as far apart as the distance without a margin, whatever the margin leaves.
  if (!is_exact || options.limit < kInfinity) return "";
  const double apart = sgn(squared) == 0 ? 0 : std::max(exact::distanceBelow(squared), 0x1p-1074);
  const DistanceResult points{apart, cold.point_a, cold.point_b, cold.edge_a, cold.edge_b};
  return described(wrongPoints(c, points), "", cold.distance);
}

std::string wrongSignedDistance(const Case& c, double margin) {
  DistanceOptions options;
  options.margin = margin;
  const SignedDistance s = signedDistance(c.a, c.pose_a, c.b, c.pose_b, options),
                       turned = signedDistance(c.b, c.pose_b, c.a, c.pose_a, options);
  const DistanceResult found{s.distance, s.point_a, s.point_b, s.edge_a, s.edge_b};
  const DistanceResult other{turned.distance, turned.point_a, turned.point_b, turned.edge_a, turned.edge_b};
  if (!isOneTwice(c) && !(same(found, swapped(other)) && s.normal == -turned.normal)) return "signed, swapped";
  if ((s.distance > 0) == collide(c.a, c.pose_a, c.b, c.pose_b, {margin})) return "signed: sign";
  if (!(std::abs(s.normal.norm() - 1) <= 1e-12)) return "signed: no unit vector";
  const Depth d = depth(c.a, c.pose_a, c.b, c.pose_b);
  if (d.depth > 0) {
    const DistanceResult deep{-d.upper_bound - margin, d.point_a, d.point_b, d.edge_a, d.edge_b};
    return same(found, deep) && s.normal == d.normal ? "" : "signed: depth";
  }
  const DistanceResult apart = distance(c.a, c.pose_a, c.b, c.pose_b);
  if (apart.distance == 0) {
    // A touch, as contacts() has it: the edges are those that face each other, or that go straight on to the point.
    if (s.distance != 0 - margin || !(s.point_a == s.point_b)) return "signed: a touch";
    const double error = 10 * rounding(c) + 0x1p-1048;
    for (const auto& [polygon, pose, edge] :
         {std::tuple(&c.a, &c.pose_a, s.edge_a), std::tuple(&c.b, &c.pose_b, s.edge_b)}) {
      if (!s.point_a.allFinite() || edge < 0) continue;
      const auto [v, w] = posedEdge(*polygon, *pose, edge);
      const Vec2 way = (w - v).stableNormalized(), off = s.point_a - v;
      if (way.allFinite() && (w - v).stableNorm() > error &&
          !(std::abs(way.x() * off.y() - way.y() * off.x()) <= error))
        return "signed: the touch isn't where the edge leads";
      if (!(exact::distanceSquared(*polygon, *pose, Polygon::point(s.point_a), Pose::Identity()) <=
            mpq_class(error) * error))
        return "signed: the touch isn't at the polygon";
    }
    return "";
  }
  const DistanceResult left = distance(c.a, c.pose_a, c.b, c.pose_b, options);
  const double wanted = left.distance > 0 ? left.distance : std::min(apart.distance - margin, 0.0);
  if (!same(found, {wanted, left.point_a, left.point_b, left.edge_a, left.edge_b})) return "signed: distance";
  const Vec2 off = s.point_b - s.point_a - apart.distance * s.normal;
  const bool leads = !off.allFinite() || off.stableNorm() <= 256 * rounding(c) + 1e-12 * apart.distance + 0x1p-1000;
  return leads ? "" : "signed: the normal doesn't lead from point to point";
}

bool same(const DistanceResult& p, const DistanceResult& q) {
  const auto alike = [](const Vec2& s, const Vec2& t) { return s == t || !s.allFinite(); };
  return p.distance == q.distance && alike(p.point_a, q.point_a) && alike(p.point_b, q.point_b) &&
         p.edge_a == q.edge_a && p.edge_b == q.edge_b;
}

DistanceResult swapped(const DistanceResult& r) { return {r.distance, r.point_b, r.point_a, r.edge_b, r.edge_a}; }

}  // namespace tricover::support
