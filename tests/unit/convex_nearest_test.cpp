// SPDX-License-Identifier: BSD-3-Clause
// The short way to the distance of small convex polygons: the same bits as all pairs of edges give, on all lanes.
#include "distance/convex_nearest.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "distance/distance_search.h"
#include "exact_reference.h"
#include "families.h"
#include "hierarchy/simd.h"
#include "pair/posed_pair.h"
#include "random.h"
#include "reproduction.h"
#include "shapes.h"
#include "test_scale.h"
#include "tricover/collide.h"
#include "tricover/distance.h"

namespace tricover::support {
namespace {

using namespace detail;

/// Vertices on a circle or an ellipse at random angles: sharp corners, short edges, seldom more than 16 of them.
Polygon convexPolygon(Random& random, double size) {
  const int n = random.integer(3, random.oneIn(8) ? 60 : 16);
  std::vector<double> angles;
  for (int i = 0; i < n; ++i) angles.push_back(2 * 3.14159265358979 * (i + random.real(0, 0.9)) / n);
  const double flat = random.oneIn(3) ? random.real(0.01, 1) : 1;
  const Vec2 center = random.oneIn(4) ? Vec2(3 * size, -2 * size) : Vec2(0, 0);
  Ring ring;
  for (const double angle : angles) ring.push_back(center + size * Vec2(std::cos(angle), flat * std::sin(angle)));
  if (random.coin()) std::reverse(ring.begin(), ring.end());
  return Polygon({ring});
}

/// Two of them that are apart by anything from far to a last bit, sides that face each other included.
Case convexPair(Random& random) {
  const double size = std::pow(10, random.real(-3, 3));
  Case c{convexPolygon(random, size), Pose::Identity(), convexPolygon(random, size * random.real(0.1, 1)),
         Pose::Identity()};
  if (random.oneIn(4)) c.b = c.a;
  c.pose_a = randomPose(random, size);
  c.pose_b = randomPose(random, size);
  if (random.oneIn(3)) c.pose_b.linear() = c.pose_a.linear();
  if (random.oneIn(4)) c.pose_b = mirrored(c.pose_b);
  const double angle = random.oneIn(4) ? 0 : random.real(-4, 4);
  const Vec2 away(std::cos(angle), std::sin(angle));
  const auto [near, far] = contactOnWay(c, away, 64 * size, random.integer(0, 50));
  c.pose_b.translation() = c.pose_a.translation() + (random.oneIn(8) ? near : far) * away;
  return c;
}

int edgesThatMeet(const PosedPair& pair) {
  int count = 0;
  for (std::size_t k = 0; k + 1 < pair.a.path.size(); ++k)
    for (std::size_t l = 0; l + 1 < pair.b.path.size(); ++l) count += edgesMeet(pair, k, l);
  return count;
}

/// As distance() asks; Unknown unless both are strictly convex.
ConvexNearest nearestOf(const PosedPair& pair, const ConvexFeatures& tried = {}) {
  ConvexNearest found;
  if (hierarchyOf(pair.a).strictly_convex && hierarchyOf(pair.b).strictly_convex)
    nearestOfConvex(PlainWays(pair.a, pair.pose_a, pair.b, pair.pose_b), tried, {}, found);
  return found;
}

double leastDistance(const PosedPair& pair, const ConvexNearest& found) {
  if (found.is_unique) return found.nearest.distance;
  const EdgeDistances edges(pair.a, pair.pose_a, pair.b, pair.pose_b);
  const DistanceOptions options;
  DistanceSearch search(edges, options);
  const std::size_t count_a = pair.a.path.size() - 1, count_b = pair.b.path.size() - 1;
  for (std::uint32_t k = 0; k < found.edges_a.count; ++k)
    for (std::uint32_t l = 0; l < found.edges_b.count; ++l)
      search.showNear(static_cast<std::uint32_t>((found.edges_a.first + k) % count_a),
                      static_cast<std::uint32_t>((found.edges_b.first + l) % count_b));
  search.finish();
  return search.best().distance;
}

bool crosses(const ConvexNearest& found) { return found.features.kind == ConvexFeatures::kCrossing; }

TEST(ConvexNearest, GivesTheSameBitsAsAllPairsOfEdges) {
  int shown = 0, unique = 0, meeting = 0, near = 0, of_one_shape = 0, proven = 0, proven_by_chance = 0;
  int crossing_found = 0, crossing_proven = 0, containment_found = 0;
  const int count = scaledCount(20000);
  for (int i = 0; i < count; ++i) {
    Random random(static_cast<std::uint64_t>(i) + 77);
    const Case c = convexPair(random);
    const bool ordered = c.a.radius() >= c.b.radius();
    const PosedPair pair = ordered ? PosedPair(c.a.data(), c.pose_a, c.b.data(), c.pose_b)
                                   : PosedPair(c.b.data(), c.pose_b, c.a.data(), c.pose_a);
    const ConvexNearest found = nearestOf(pair);
    {
      usePortableLanes(true);
      const ConvexNearest portable = nearestOf(pair);
      usePortableLanes(false);
      ASSERT_EQ(portable.meeting, found.meeting) << reproduction(c);
      ASSERT_EQ(portable.features.kind, found.features.kind) << reproduction(c);
      ASSERT_EQ(portable.features.edge_a, found.features.edge_a) << reproduction(c);
      ASSERT_EQ(portable.is_unique, found.is_unique) << reproduction(c);
      ASSERT_EQ(leastDistance(pair, portable), leastDistance(pair, found)) << reproduction(c);
    }
    if (found.meeting == Meeting::Unknown) continue;
    ASSERT_EQ(found.meeting == Meeting::Meet, collide(c.a, c.pose_a, c.b, c.pose_b)) << reproduction(c);
    if (found.meeting == Meeting::Meet) {
      ++meeting;
      const bool cross = edgesThatMeet(pair) > 0;
      ASSERT_FALSE(cross && found.isInside()) << reproduction(c);
      ASSERT_TRUE(!crosses(found) || edgesMeet(pair, found.features.edge_a, found.features.edge_b)) << reproduction(c);
      (cross ? crossing_found : containment_found) += crosses(found) || found.isInside();
      if (!crosses(found)) continue;
      const ConvexNearest again = nearestOf(pair, found.features);
      ASSERT_EQ(again.meeting, Meeting::Meet) << reproduction(c);
      crossing_proven += again.is_proven;
      continue;
    }
    const EdgeDistances edges(pair.a, pair.pose_a, pair.b, pair.pose_b);
    const DistanceOptions options;
    DistanceSearch all(edges, options);
    for (std::uint32_t k = 0; k + 1 < pair.a.path.size(); ++k)
      for (std::uint32_t l = 0; l + 1 < pair.b.path.size(); ++l) ASSERT_TRUE(all.show(k, l)) << reproduction(c);
    all.finish();
    ASSERT_EQ(leastDistance(pair, found), all.best().distance) << reproduction(c);
    // Features to try first: those that were found, and some near them.
    const auto beside = [&](std::uint32_t edge, const PolygonData& polygon) {
      return (edge + static_cast<std::uint32_t>(random.integer(0, 2))) %
             static_cast<std::uint32_t>(polygon.path.size() - 1);
    };
    const auto kind = static_cast<ConvexFeatures::Kind>(random.integer(1, 3));
    const ConvexFeatures& features = found.features;
    for (const ConvexFeatures& tried :
         {features, ConvexFeatures{kind, beside(features.edge_a, pair.a), beside(features.edge_b, pair.b)}}) {
      const bool is_known =
          tried.kind == features.kind && tried.edge_a == features.edge_a && tried.edge_b == features.edge_b;
      const ConvexNearest hinted = nearestOf(pair, tried);
      ASSERT_EQ(hinted.meeting, Meeting::Apart) << reproduction(c);
      ASSERT_EQ(leastDistance(pair, hinted), all.best().distance) << reproduction(c);
      (is_known ? proven : proven_by_chance) += hinted.is_proven;
    }
    unique += found.is_unique;
    ++shown;
    near += all.best().distance < 1e-3 * pair.b.radius;
    of_one_shape += c.a.id() == c.b.id();
  }
  EXPECT_GT(shown, 0.5 * count);
  EXPECT_GT(unique, 0.5 * shown);
  EXPECT_LT(unique, 0.99 * shown);
  EXPECT_GE(proven, shown);
  EXPECT_GT(proven_by_chance, 0.01 * count);
  EXPECT_LT(proven_by_chance, 0.5 * count);
  EXPECT_GT(meeting, 0.02 * count);
  EXPECT_GT(crossing_found + containment_found, 0.9 * meeting);
  EXPECT_GT(crossing_found, 0.2 * meeting);
  EXPECT_GT(crossing_proven, 0.5 * crossing_found);
  EXPECT_GT(containment_found, 0);
  EXPECT_LT(shown + meeting, count) << "some are too near to tell";
  EXPECT_GT(near, 0.05 * count);
  EXPECT_GT(of_one_shape, 0.1 * count);
}

/// Corners on edges but for the last bits: where plain doubles say that edges cross, they do.
TEST(ConvexNearest, SeesCrossingsThatAreCertain) {
  Random random(9);
  int seen = 0, meeting = 0;
  const int count = scaledCount(2000);
  for (int i = 0; i < count; ++i) {
    const Pose at_a = randomPose(random, 1), at_b = randomPose(random, 1);
    const double x = random.real(-1, 1), beyond = random.coin() ? 0.1 : std::ldexp(1.0, -random.integer(40, 53));
    const Vec2 tip = at_b.inverse() * (at_a * Vec2(x, random.coin() ? beyond : -beyond));
    const Vec2 from = at_b.inverse() * (at_a * Vec2(x + 0.5, -1));
    const Polygon a({{{-1, 0}, {1, 0}, {0, 5}}}), b({{from, tip, from + Vec2(0.1, 0.1)}});
    const PosedPair pair(a.data(), at_a, b.data(), at_b);
    const bool meets = edgesMeet(pair, 0, 0);
    const auto point = EdgeDistances(a.data(), at_a, b.data(), at_b).crossing(0, 0);
    ASSERT_TRUE(!point || meets) << reproduction({a, at_a, b, at_b});
    seen += point.has_value();
    meeting += meets;
  }
  EXPECT_GT(seen, 0.1 * count);
  EXPECT_GT(meeting, seen);
  EXPECT_LT(meeting, 0.9 * count);
}

/// Doubles see what floats don't: on which side of a corner an edge leads out, and a corner that is hardly outside.
TEST(ConvexNearest, ProvesWhereTheyMeet) {
  const Polygon square({rectangle(-1, -1, 1, 1)});
  int found = 0;
  Random random(5);
  const auto check = [&](Ring ring) {  // as it is in the world
    const Pose at_a = Pose::Identity(), at_b = randomPose(random, 1);
    for (Vec2& p : ring) p = at_b.inverse() * p;
    const Polygon b({ring});
    const PosedPair pair(square.data(), at_a, b.data(), at_b);
    const ConvexNearest nearest = nearestOf(pair);
    found += crosses(nearest);
    EXPECT_TRUE(!crosses(nearest) || edgesMeet(pair, nearest.features.edge_a, nearest.features.edge_b))
        << reproduction({square, at_a, b, at_b});
    EXPECT_FALSE(nearest.isInside() && edgesThatMeet(pair) > 0) << reproduction({square, at_a, b, at_b});
  };
  for (int i = 0; i < 200; ++i) {
    const double beside = random.coin() ? 1e-9 : -1e-9;
    check({{0, 0}, {1.25, 1.25 + beside}, {-0.5, 1.25}});
    check({{-0.5, -0.5}, {1 + 1e-9, -0.5}, {random.real(-0.5, 0.5), 0.5}});
  }
  EXPECT_GT(found, 50);
}

/// Features that are still foremost, but for a little: the nearest point of a is on an edge that ends at one of them,
/// and begins too far back to be one.
TEST(ConvexNearest, LooksAtEdgesBeforeAndBehindAVertex) {
  const Ring below = {{-1, -1}, {1, -1}, {1, -0.006}, {0, 0}, {-1, -0.5}};
  const Ring above = {{0, 0.0008}, {0.05, 0.0001}, {1.2, 1}, {-1, 1}};
  for (const double side : {1.0, -1.0}) {
    Ring rings[] = {below, above};
    for (Ring& ring : rings)
      for (Vec2& p : ring) p.x() *= side;
    const Polygon a({rings[0]}), b({rings[1]});
    const Pose still = Pose::Identity();
    Pose turned = pose(0.3 * side, 0, 0);  // so that two vertices are the nearest
    turned.translation() = above[0] - turned * above[0];
    PairCache cache;
    EXPECT_NEAR(distance(a, still, b, turned, cache).distance, 0.0008, 1e-12);
    const double d = distance(a, still, b, still, cache).distance;
    EXPECT_NEAR(d, 0.0001 + 0.05 * 0.006, 1e-7);
    EXPECT_EQ(d, distance(a, still, b, still).distance);
  }
}

TEST(ConvexNearest, LeavesToOthersWhatIsNotStrictlyConvexOrNotApart) {
  const Polygon square({rectangle(0, 0, 1, 1)}), many({regular(17, 1)}), notched({{{0, 0}, {2, 0}, {1, 0.5}, {0, 2}}});
  const Polygon straight({{{0, 0}, {1, 0}, {1, 1}, {0.5, 1}, {0, 1}}}), flat({{{0, 0}, {1, 0}, {1, 1e-6}, {0, 1e-6}}});
  const auto shows = [](const Polygon& a, const Polygon& b, const Vec2& shift) {
    const Pose at_a = Pose::Identity(), at_b = pose(0, shift.x(), shift.y());
    return nearestOf(PosedPair(a.data(), at_a, b.data(), at_b)).meeting;
  };
  constexpr Meeting kApart = Meeting::Apart, kUnknown = Meeting::Unknown;
  EXPECT_EQ(shows(square, square, {3, 0.25}), kApart);
  EXPECT_EQ(shows(square, square, {3, 0}), kApart) << "sides that face each other";
  EXPECT_EQ(shows(square, square, {3, 3}), kApart) << "corners";
  EXPECT_EQ(shows(square, square, {1, 0}), kUnknown) << "a touch";
  EXPECT_EQ(shows(square, square, {0.5, 0.25}), Meeting::Meet);
  EXPECT_EQ(shows(many, square, {3, 0.25}), kApart);
  EXPECT_EQ(shows(many, square, {0.5, 0.25}), kUnknown) << "many vertices, and they meet";
  EXPECT_EQ(shows(flat, flat, {0, 1e-5}), kApart) << "thin ones";
  EXPECT_EQ(shows(straight, square, {3, 0.25}), kUnknown);
  EXPECT_EQ(shows(notched, square, {3, 0.25}), kUnknown);
  EXPECT_EQ(shows(square, square, {1e4, 0}), kApart);
  EXPECT_EQ(shows(square, square, {1e15, 0}), kUnknown) << "an axis in doubles leads past the features";
}

}  // namespace
}  // namespace tricover::support
