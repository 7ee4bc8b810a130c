// SPDX-License-Identifier: BSD-3-Clause
// collide() and distance() with margins around the exact distance, and tolerances: of every family, of points and
// segments beside it, and of points far from their origins.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "collide_laws.h"
#include "distance_laws.h"
#include "exact_reference.h"
#include "families.h"
#include "law.h"
#include "pairs.h"
#include "reproduction.h"
#include "shapes.h"
#include "strategies.h"
#include "tricover/collide.h"
#include "tricover/polygon.h"

namespace tricover::laws {
namespace {

using namespace support;

constexpr double kLargest = std::numeric_limits<double>::max();

/// A place that is likely to be degenerate: a vertex, on an edge, beside either, deep inside, or anywhere.
Vec2 placeNear(Random& random, const Polygon& polygon) {
  const EdgeIndex edge = anyEdge(random, polygon);
  const Vec2 v = polygon.edgeStart(edge), w = polygon.edgeEnd(edge);
  const double size = std::min(polygon.radius(), kLargest / 4);
  switch (random.integer(0, 5)) {
    case 0:
      return v;
    case 1:
      return 0.5 * v + 0.5 * w;
    case 2:
      return nudged(random, 0.5 * v + 0.5 * w, 2);
    case 3:
      return 0.25 * v + 0.75 * polygon.coveringOrigin();
    case 4:
      return polygon.coveringOrigin();
    default: {
      const Vec2 p = polygon.coveringOrigin() + size * Vec2(random.real(-2, 2), random.real(-2, 2));
      return p.allFinite() ? p : v;
    }
  }
}

/// One operand, or both, replaced by a point or a segment near the other.
Case withDegenerate(Random& random, const Case& c) {
  const auto degenerateNear = [&](const Polygon& polygon) {
    const Vec2 p = placeNear(random, polygon);
    return random.coin() ? Polygon::point(p)
                         : Polygon::segment(p, random.coin() ? placeNear(random, polygon) : nudged(random, p, 3));
  };
  const Polygon degenerate = degenerateNear(c.a);
  const Pose& pose = random.coin() ? c.pose_a : c.pose_b;
  if (random.oneIn(4)) return {degenerateNear(c.a), c.pose_a, degenerate, pose};
  return random.coin() ? Case{c.a, c.pose_a, degenerate, pose} : Case{degenerate, pose, c.a, c.pose_a};
}

std::vector<double> lengthsAround(Random& random, const mpq_class& squared, double size) {
  const double below = std::min(exact::distanceBelow(squared), nudged(kLargest, -4));
  std::vector<double> lengths = {0,
                                 below,
                                 nudged(below, 1),
                                 nudged(below, 2),
                                 below * (1 + 1e-12),
                                 below * (1 + 1e-7),
                                 below * 2,
                                 size * random.unit()};
  if (below > 0) lengths.insert(lengths.end(), {nudged(below, -1), below * (1 - 1e-12), below * (1 - 1e-7), below / 2});
  for (double& length : lengths) length = std::min(length, kLargest);
  return lengths;
}

/// Of collide() and distance(); empty if everything is right.
std::string wrongAt(const Case& c, const mpq_class& squared, double length, StrategyCaches& caches, Random& random) {
  const auto within = [&](double margin, double tolerance) {
    return exact::within(squared, mpq_class(margin) + mpq_class(tolerance));
  };
  std::string wrong = wrongCollide(c, {length}, {within(length, 0), within(length, 0)}, caches, random);
  const CollideOptions tolerant{random.coin() ? 0 : length / 2, random.coin() ? length : length * random.unit()};
  if (wrong.empty())
    wrong = wrongCollide(c, tolerant, {within(tolerant.margin, 0), within(tolerant.margin, tolerant.tolerance)}, caches,
                         random);
  LimitedOptions options, limited;
  options.margin = limited.limit = length;
  if (wrong.empty()) wrong = wrongDistances(c, options, squared, caches.of_pair);
  return wrong.empty() ? wrongDistances(c, limited, squared, caches.of_pair) : wrong;
}

std::string wrongAround(Random& random, Tally& tally, const Case& c, double size) {
  const mpq_class squared = exact::distanceSquared(c.a, c.pose_a, c.b, c.pose_b);
  StrategyCaches caches = random.coin() ? cachesOfOthers(random) : StrategyCaches();
  for (const double length : lengthsAround(random, squared, size)) {
    tally.count("hits", exact::within(squared, mpq_class(length)));
    const std::string wrong = wrongAt(c, squared, length, caches, random);
    if (!wrong.empty())
      return wrong + ", length " + hex(length) + ", distance above " + hex(exact::distanceBelow(squared));
  }
  return {};
}

std::string wrong(Random& random, Tally& tally, Case& c) {
  if (random.coin()) {
    c = withDegenerate(random, c);
  } else if (random.coin()) {
    const double size = std::min(smallerRadius(c), kLargest);
    const Vec2 apart = c.pose_b.translation() + size * Vec2(random.real(-2, 2), random.real(-2, 2));
    if (apart.allFinite()) c.pose_b.translation() = apart;
  }
  return wrongAround(random, tally, c, std::min(std::max(c.a.radius(), c.b.radius()), kLargest));
}

/// The discs around points have no radius that would make up for how far off their centres are.
Case farPoints(Random& random) {
  const auto farPoint = [&] { return Vec2(random.real(-1e6, 1e6), random.real(-1e6, 1e6)); };
  const Vec2 p = farPoint(), q = farPoint();
  Case c{Polygon::point(p), randomPose(random, 1e6), Polygon::point(q), randomPose(random, 1)};
  c.pose_b.translation() += c.pose_a * p - c.pose_b.linear() * q;
  return c;
}

std::string wrongOfPoints(Random& random, Tally& tally, Case& c) { return wrongAround(random, tally, c, 1); }

/// A point beside a polygon of many edges: what doubles find is a last bit above the truth here and there.
Case pointBesideMany(Random& random) {
  Case c{Polygon({regular(40, 1)}), turnedAndMoved(random.real(-3, 3), 0, 0), Polygon::point({6, 5}),
         turnedAndMoved(random.real(-3, 3), 0, 0)};
  const Vec2 at(random.real(2, 3), random.real(2, 3));
  c.pose_b.translation() = at - c.pose_b * c.b.coveringOrigin();
  return c;
}

Laws marginsLaws() {
  Laws laws;
  add(laws, families(), 300, wrong, {{"hits", 0.3, 0.95}});
  add(laws, {family("far_points", farPoints)}, 300, wrongOfPoints, {{"hits", 0.2, 0.95}});
  add(laws, {family("point_beside_many", pointBesideMany)}, 440, wrongOfPoints, {{"hits", 0.2, 0.95}});
  return laws;
}

const Register registered("margins", marginsLaws);

}  // namespace
}  // namespace tricover::laws
