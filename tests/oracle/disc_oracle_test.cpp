// SPDX-License-Identifier: BSD-3-Clause
// Points and segments with margins (discs and stadiums) against exact distances: beside polygons of all families and
// beside each other, at margins of exactly their distance and an ulp either side of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#include "exact_reference.h"
#include "families.h"
#include "random.h"
#include "reproduction.h"
#include "shapes.h"
#include "stages.h"
#include "test_scale.h"
#include "tricover/collide.h"
#include "tricover/distance.h"
#include "tricover/paper.h"
#include "tricover/segment.h"

namespace tricover::support {
namespace {

constexpr int kCases = 150;
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
      return 0.25 * v + 0.75 * polygon.origin();
    case 4:
      return polygon.origin();
    default: {
      const Vec2 p = polygon.origin() + size * Vec2(random.real(-2, 2), random.real(-2, 2));
      return p.allFinite() ? p : v;
    }
  }
}

/// One operand, or both, replaced by a point or a segment near the other.
Case withDegenerate(Random& random, const Case& c) {
  const auto degenerateNear = [&](const Polygon& polygon) {
    const Vec2 p = placeNear(random, polygon);
    return random.coin() ? point(p) : segment(p, random.coin() ? placeNear(random, polygon) : nudged(random, p, 3));
  };
  const Polygon degenerate = degenerateNear(c.a);
  const Pose& pose = random.coin() ? c.pose_a : c.pose_b;
  if (random.oneIn(4)) return {degenerateNear(c.a), c.pose_a, degenerate, pose};
  return random.coin() ? Case{c.a, c.pose_a, degenerate, pose} : Case{degenerate, pose, c.a, c.pose_a};
}

std::vector<double> marginsAround(Random& random, const mpq_class& squared, double size) {
  const double below = std::min(exact::distanceBelow(squared), nudged(kLargest, -4));
  std::vector<double> margins = {0, below, nudged(below, 1), below * (1 + 1e-7), size * random.unit()};
  if (below > 0) margins.insert(margins.end(), {nudged(below, -1), below * (1 - 1e-7), below / 2});
  for (double& margin : margins) margin = std::min(margin, kLargest);
  return margins;
}

/// Empty if everything is right.
std::string wrongCollide(const Case& c, const mpq_class& squared, double margin, PairCache& cache, Random& random) {
  CollideOptions options;
  options.margin = margin;
  const bool truth = exact::within(squared, mpq_class(margin));
  {
    const UpTo edges(detail::Stages::Edges);
    if (collide(afresh(c.a), c.pose_a, afresh(c.b), c.pose_b, options) != truth) return "collide by edges alone";
  }
  if (collide(c.a, c.pose_a, c.b, c.pose_b, options) != truth) return "collide";
  if (collide(c.b, c.pose_b, c.a, c.pose_a, options) != truth) return "collide, swapped";
  if (collide(c.a, c.pose_a, c.b, c.pose_b, cache, options) != truth) return "collide, cached";
  if (paper::collide(c.a, c.pose_a, c.b, c.pose_b, options) != truth) return "collide, Paper";
  options.tolerance = margin * random.unit();
  const bool answer = collide(c.a, c.pose_a, c.b, c.pose_b, cache, options);
  if (truth && !answer) return "tolerance: a miss";
  if (answer && !exact::within(squared, mpq_class(margin) + mpq_class(options.tolerance))) return "tolerance: too far";
  return {};
}

std::string wrongDistance(const Case& c, const mpq_class& squared, double margin, PairCache& cache) {
  DistanceOptions options;
  options.margin = margin;
  const bool within = exact::within(squared, mpq_class(margin));
  const DistanceResult cold = distance(c.a, c.pose_a, c.b, c.pose_b, options);
  if (distance(c.b, c.pose_b, c.a, c.pose_a, options).distance != cold.distance) return "distance, swapped";
  if (distance(c.a, c.pose_a, c.b, c.pose_b, cache, options).distance != cold.distance) return "distance, cached";
  if ((cold.distance == 0) != within) return "distance: zero or not";
  if (!within && cold.distance <= kLargest) {
    const mpq_class whole = mpq_class(cold.distance) + mpq_class(margin);
    const mpq_class slack = whole / mpq_class("100000000000000") + 0x1p-1073, low = whole - slack, high = whole + slack;
    if ((sgn(low) > 0 && squared < low * low) || squared > high * high) return "distance";
  }
  // Points are where the edges say, as far apart as the distance.
  const mpq_class apart = exact::distanceSquared(cold.point_a, cold.point_b, cold.point_b);
  const double size = std::max({c.a.radius() + c.a.origin().norm() + c.pose_a.translation().norm(),
                                c.b.radius() + c.b.origin().norm() + c.pose_b.translation().norm()});
  if (!(size < 1e300) || !(size > 1e-290)) return {};
  const mpq_class rounding = mpq_class(size) * 0x1p-46, truth = mpq_class(exact::distanceBelow(squared));
  const mpq_class high = truth + rounding, low = truth - rounding;
  if (apart > high * high || (sgn(low) > 0 && apart < low * low)) return "points";
  if (cold.edge_a < 0 && cold.edge_b < 0) return "edges";
  return {};
}

class DiscOracle : public testing::TestWithParam<Family> {};

TEST_P(DiscOracle, AgreesWithExactRationals) {
  int queries = 0, hits = 0, touches = 0, disagreements = 0;
  PairCache old;
  PairCache old_distance;
  for (int i = 0; i < scaledCount(kCases); ++i) {
    const auto seed = static_cast<std::uint64_t>(i) + 31000000;
    Random random(~seed);
    const Case c = withDegenerate(random, GetParam().make(seed));
    const mpq_class squared = exact::distanceSquared(c.a, c.pose_a, c.b, c.pose_b);
    touches += sgn(squared) == 0;
    PairCache fresh;
    PairCache fresh_distance;
    const bool is_old = random.coin();
    const double size = std::min(std::max(c.a.radius(), c.b.radius()), kLargest);
    for (const double margin : marginsAround(random, squared, size)) {
      ++queries;
      hits += exact::within(squared, mpq_class(margin));
      std::string wrong = wrongCollide(c, squared, margin, is_old ? old : fresh, random);
      if (wrong.empty()) wrong = wrongDistance(c, squared, margin, is_old ? old_distance : fresh_distance);
      if (wrong.empty()) continue;
      if (++disagreements <= 3)
        ADD_FAILURE() << GetParam().name << " seed " << seed << ": " << wrong << ", margin " << hex(margin)
                      << ", distance above " << hex(exact::distanceBelow(squared)) << "\n"
                      << reproduction(c);
      break;
    }
  }
  std::printf("%-22s %6d queries %6d hits %6d touches %4d disagreements\n", GetParam().name, queries, hits, touches,
              disagreements);
  EXPECT_EQ(disagreements, 0);
  if (queries < 100) return;
  EXPECT_GE(hits, 0.3 * queries);
  EXPECT_LE(hits, 0.95 * queries);
}

std::string familyName(const testing::TestParamInfo<Family>& family) { return family.param.name; }

INSTANTIATE_TEST_SUITE_P(Families, DiscOracle, testing::ValuesIn(families()), familyName);

}  // namespace
}  // namespace tricover::support
