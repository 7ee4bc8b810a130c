// SPDX-License-Identifier: BSD-3-Clause
// The time of impact by vertices that come to edges, of polygons with few edges, against the search through
// hierarchies, which takes the same polygons with each vertex repeated; and the edges that it looks at.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "hierarchy/simd.h"
#include "impact/impact_solvers.h"
#include "numbers/segment.h"
#include "portable_lanes.h"
#include "random.h"
#include "shapes.h"
#include "test_scale.h"
#include "tricover/polygon.h"
#include "tricover/time_of_impact.h"

namespace tricover::support {
namespace {

using namespace detail;

/// At most 16 vertices: a star, crossing itself or not; a plate with a hole; a comb; a spike; two parts.
std::vector<Ring> anyRings(Random& random, double size) {
  const Vec2 center = random.oneIn(4) ? Vec2(3, -2) : Vec2(0, 0);
  std::vector<Ring> rings = {star(random, random.integer(3, 16), 0.2, 1, center)};
  const int kind = random.integer(0, 7);
  if (kind == 0) std::swap(rings[0].front(), rings[0].back());
  if (kind == 1) rings = {star(random, 8, 0.8, 1, center), star(random, random.integer(3, 8), 0.1, 0.5, center)};
  if (kind == 2) rings = {scaled(comb(3, 0.4, 0.1, 0.8), 1)};
  if (kind == 3) rings = {wedge(random, direction(random.real(-3, 3)), 1)};
  if (kind == 4) rings = {star(random, 5, 0.1, 0.3, center), star(random, 4, 0.1, 0.3, center + Vec2(0.7, 0))};
  for (Ring& ring : rings) ring = scaled(ring, size);
  return rings;
}

TEST(VertexImpact, IsTheSearchsWithinTheTimeError) {
  int few = 0, asked = 0, answered = 0, hits = 0, misses = 0;
  const int count = scaledCount(8000);
  for (int i = 0; i < count; ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const double size = std::pow(10, random.real(-3, 3)), other = size * random.real(0.05, 1);
    const std::vector<Ring> rings_a = anyRings(random, size), rings_b = anyRings(random, other);
    const bool is_segment = random.oneIn(8);
    const Polygon a(rings_a), b = is_segment ? Polygon::segment(Vec2(0, other), Vec2(other, 0)) : Polygon(rings_b);
    const Polygon b_repeated = is_segment ? b : goneRoundOften(rings_b);
    const Motion motion_a = randomMotion(random, a, size), motion_b = randomMotion(random, b, size);
    const double time_error = std::pow(10, random.integer(-12, -1));
    const ImpactOptions options{random.oneIn(3) ? size * random.real(0, 0.5) : 0, time_error};
    const std::optional<Impact> impact = timeOfImpact(a, motion_a, b, motion_b, options);
    const std::optional<Impact> truth = timeOfImpact(goneRoundOften(rings_a), motion_a, b_repeated, motion_b, options);
    ASSERT_EQ(impact.has_value(), truth.has_value()) << i;
    if (truth && truth->time == 0) {
      EXPECT_EQ(impact->time, 0) << i;
      continue;
    }
    const bool swaps = b.radius() > a.radius();
    MovingPair pair = swaps ? MovingPair(detail::dataOf(b), motion_b, detail::dataOf(a), motion_a, options.margin)
                            : MovingPair(detail::dataOf(a), motion_a, detail::dataOf(b), motion_b, options.margin);
    pair.prepare();
    ++asked;
    if (haveFewVertices(pair)) {
      ++few;
      const FirstContact found = followVertices(pair, 0, time_error);
      answered += found.verdict != FirstContact::Verdict::Unknown;
      EXPECT_LE(found.time, (truth ? truth->time : 1) + time_error + 1e-11) << i;
      EXPECT_NE(found.verdict, truth ? FirstContact::Verdict::Never : FirstContact::Verdict::Touch) << i;
      if (found.verdict == FirstContact::Verdict::Touch) {
        EXPECT_NEAR(found.time, truth->time, time_error + 1e-11) << i;
      }
    }
    ++(impact ? hits : misses);
    if (impact) {
      EXPECT_GT(impact->time, 0) << i;
      EXPECT_NEAR(impact->time, truth->time, time_error + 1e-11) << i;
    }
  }
  EXPECT_GE(few, 0.9 * asked);
  EXPECT_GE(answered, 0.97 * few);
  EXPECT_GE(hits, 0.1 * count);
  EXPECT_GE(misses, 0.2 * count);
}

/// Of two segments, 0 where they cross.
double apart(const Vec2& p, const Vec2& q, const Vec2& v, const Vec2& w) {
  const auto sides = [](const Vec2& s, const Vec2& t, const Vec2& m, const Vec2& n) {
    return cross(t - s, m - s) * cross(t - s, n - s) < 0;
  };
  const auto off = [](const Vec2& m, const Vec2& s, const Vec2& t) { return (nearestOnSegment(m, s, t) - m).norm(); };
  if (sides(p, q, v, w) && sides(v, w, p, q)) return 0;
  return std::min({off(p, v, w), off(q, v, w), off(v, p, q), off(w, p, q)});
}

/// No edge that a point comes within its reach of is left out; where it only must not be met, few others are shown.
TEST(VertexImpact, LooksAtTheEdgesInReach) {
  int reached = 0, met = 0, shown = 0;
  for (int i = 0; i < scaledCount(4000); ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const auto anyPoint = [&](double size) { return Vec2(size * random.real(-1, 1), size * random.real(-1, 1)); };
    const int count = random.integer(1, SmallPolygon::kMost);
    const auto made = emptySmallPolygon(count > kLanes ? SmallPolygon::kMost : kLanes);
    SmallPolygon& edges = *made;
    StraightPaths ways{};
    edges.count = count;
    edges.edges = (1u << edges.count) - 1;
    std::vector<Vec2> begin, end;
    for (int e = 0; e < edges.count; ++e) {
      const Vec2 v = anyPoint(1), u = anyPoint(random.oneIn(9) ? 1e-8 : 1), middle = v + 0.5 * u;
      const Vec2 normal = Vec2(u.y(), -u.x()).normalized() * (random.coin() ? 1 : -1);
      begin.push_back(v);
      end.push_back(v + u);
      edges.nx[e] = static_cast<float>(normal.x());
      edges.ny[e] = static_cast<float>(normal.y());
      edges.d[e] = static_cast<float>(normal.dot(v));
      edges.middle[e] = static_cast<float>(cross(normal, middle));
      edges.half[e] = static_cast<float>(0.5 * u.norm());
    }
    ways.count = random.integer(1, SmallPolygon::kMost);
    for (int k = 0; k < ways.count; ++k) {
      const Vec2 p = anyPoint(2), q = random.oneIn(9) ? p : Vec2(p + anyPoint(random.oneIn(9) ? 1e6 : 1));
      ways.x[k] = static_cast<float>(p.x());
      ways.y[k] = static_cast<float>(p.y());
      ways.to_x[k] = static_cast<float>(q.x());
      ways.to_y[k] = static_cast<float>(q.y());
      ways.reach[k] = random.oneIn(3) ? 0 : static_cast<float>(random.real(0, 0.5));
    }
    unsigned near[SmallPolygon::kMost], portable[SmallPolygon::kMost];
    findEdgesOnPaths(edges, ways, near);
    onPortableLanes([&] { findEdgesOnPaths(edges, ways, portable); });
    for (int k = 0; k < ways.count; ++k) {
      ASSERT_EQ(near[k], portable[k]);
      const Vec2 p(ways.x[k], ways.y[k]), q(ways.to_x[k], ways.to_y[k]);
      for (int e = 0; e < edges.count; ++e) {
        const Vec2 &v = begin[static_cast<std::size_t>(e)], &w = end[static_cast<std::size_t>(e)];
        const double distance = apart(p, q, v, w);
        const double reach = static_cast<double>(ways.reach[k]);
        const bool is_shown = (near[k] >> e & 1) != 0;
        ASSERT_TRUE(is_shown || distance > reach) << i << " " << k << " " << e;
        reached += distance <= reach;
        if (reach > 0 || (w - v).norm() < 1e-6) continue;
        met += distance <= 1e-3 * (1 + p.norm() + q.norm());
        shown += is_shown;
      }
      ASSERT_EQ(near[k] >> edges.count, 0u);
    }
  }
  EXPECT_GE(reached, scaledCount(4000));
  EXPECT_GE(met, scaledCount(1000));
  EXPECT_LE(shown, met);
}

}  // namespace
}  // namespace tricover::support
