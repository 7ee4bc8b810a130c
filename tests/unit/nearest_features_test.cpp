// SPDX-License-Identifier: BSD-3-Clause
// The short way to the distance of convex polygons: the same bits as all pairs of edges give; and a lower bound
// of it.
#include "convex/nearest_features.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "distance/distance_hint.h"
#include "distance/distance_search.h"
#include "distance/distance_solvers.h"
#include "families.h"
#include "hierarchy/simd.h"
#include "pair/posed_pair.h"
#include "polygon/cache_access.h"
#include "polygon/convexity.h"
#include "random.h"
#include "reproduction.h"
#include "shapes.h"
#include "test_scale.h"
#include "tricover/collide.h"
#include "tricover/distance.h"

namespace tricover::support {
namespace {

using namespace detail;

/// Around the origin or beside it.
Polygon convexPolygon(Random& random, double size) {
  const Vec2 center = random.oneIn(4) ? Vec2(3 * size, -2 * size) : Vec2(0, 0);
  return Polygon({eitherWay(random, shifted(anyConvex(random, size, 60, 0.01), center))});
}

/// Two of them that are apart by anything from far to a last bit, sides that face each other included.
Case convexPair(Random& random) {
  const double size = std::pow(10, random.oneIn(8) ? random.integer(-140, 140) : random.real(-3, 3));
  Case c{convexPolygon(random, size), Pose::Identity(), convexPolygon(random, size * random.real(0.1, 1)),
         Pose::Identity()};
  if (random.oneIn(4)) c.b = c.a;
  c.pose_a = randomPose(random, size);
  c.pose_b = randomPose(random, size);
  if (random.oneIn(3)) c.pose_b.linear() = c.pose_a.linear();
  if (random.oneIn(4)) c.pose_b = mirrored(c.pose_b);
  if (random.oneIn(4)) c.pose_b = distorted(random, c.pose_b);
  const double angle = random.oneIn(4) ? 0 : random.real(-4, 4);
  const Vec2 away(std::cos(angle), std::sin(angle));
  const auto [near, far] = contactOnWay(c, away, 64 * size, random.integer(0, 50));
  c.pose_b.translation() = c.pose_a.translation() + (random.oneIn(8) ? near : far) * away;
  return c;
}

int edgesThatMeet(const PosedPair& pair) {
  int count = 0;
  for (detail::EdgePosition k = 0; k + 1 < pair.a.path.size(); ++k)
    for (detail::EdgePosition l = 0; l + 1 < pair.b.path.size(); ++l) count += edgesMeet(pair, k, l);
  return count;
}

/// What distance() finds; Unknown unless both are convex without straight vertices.
struct Found : NearestFeatures {
  Meeting meeting = Meeting::Unknown;
  DistanceResult meet{};  ///< where they do

  bool crosses() const { return meeting == Meeting::Meet && meet.edge_a >= 0 && meet.edge_b >= 0; }
  bool isInside() const { return meeting == Meeting::Meet && !crosses(); }
  std::uint32_t edgeA() const { return static_cast<std::uint32_t>(meet.edge_a); }
  std::uint32_t edgeB() const { return static_cast<std::uint32_t>(meet.edge_b); }
};

Found nearestOf(const PosedPair& pair, const FeaturePair& tried = {}) {
  Found found;
  if (cornersOf(pair.a) != &pair.a || cornersOf(pair.b) != &pair.b) return found;
  const PosedVertices in_order(pair);
  static_cast<NearestFeatures&>(found) = findNearestFeatures(in_order, tried);
  DistanceHint hint;
  claim(hint, in_order);
  hint.kind = tried.kind;
  hint.edge_a = tried.edge_a;
  hint.edge_b = tried.edge_b;
  if (found.are_apart) found.meeting = Meeting::Apart;
  if (!found.seem_to_meet || !convexDistance(in_order, &hint, {}, found.meet)) return found;
  found.meeting = Meeting::Meet;
  EXPECT_FALSE(found.are_apart);
  EXPECT_EQ(found.meet.distance, 0);
  return found;
}

double leastDistance(const PosedPair& pair, const Found& found) {
  if (found.is_unique) {
    DistanceResult result;
    EXPECT_TRUE(convexDistance(PosedVertices(pair), nullptr, {}, result));
    return result.distance;
  }
  const EdgeDistances edges{PosedVertices(pair)};
  const DistanceQuery options;
  DistanceSearch search(edges, options);
  const std::size_t count_a = pair.a.path.size() - 1, count_b = pair.b.path.size() - 1;
  for (std::uint32_t k = 0; k < found.edges_a.count; ++k)
    for (std::uint32_t l = 0; l < found.edges_b.count; ++l)
      search.show(static_cast<std::uint32_t>((found.edges_a.first + k) % count_a),
                  static_cast<std::uint32_t>((found.edges_b.first + l) % count_b));
  search.finish();
  return search.best().distance;
}

/// Two boxes whose sides face each other: no feature alone is the nearest.
Case sideBySide(Random& random) {
  const Polygon box({rectangle(0, 0, 2, 2)});
  const Pose at = turnedAndMoved(random.real(0, 6.3), random.real(-1, 1), 0);
  return {box, at, box, at * turnedAndMoved(0, 2 + random.real(0, 1), random.real(-1.5, 1.5))};
}

/// What is said to meet does, where it is said to.
void expectToMeet(const PosedPair& pair, const Found& found) {
  EXPECT_FALSE(found.isInside() && edgesThatMeet(pair) > 0);
  EXPECT_TRUE(!found.crosses() || edgesMeet(pair, found.edgeA(), found.edgeB()));
}

/// The edge so many behind one of them.
std::uint32_t behind(const PolygonData& polygon, std::uint32_t edge, std::uint32_t step) {
  return (edge + step) % static_cast<std::uint32_t>(polygon.path.size() - 1);
}

TEST(NearestFeatures, GivesTheSameBitsAsAllPairsOfEdges) {
  int shown = 0, unique = 0, meeting = 0, near = 0, of_one_shape = 0, proven = 0, proven_by_chance = 0;
  int crossings = 0, containments = 0;
  const int count = scaledCount(20000, 1500);
  for (int i = 0; i < count && !testing::Test::HasFailure(); ++i) {
    Random random(static_cast<std::uint64_t>(i) + 77);
    Case c = random.oneIn(32) ? sideBySide(random) : convexPair(random);
    if (c.a.radius() < c.b.radius()) c = {c.b, c.pose_b, c.a, c.pose_a};
    SCOPED_TRACE(i);
    const PosedPair pair(detail::dataOf(c.a), c.pose_a, detail::dataOf(c.b), c.pose_b);
    const Found found = nearestOf(pair);
    if (found.meeting == Meeting::Unknown) continue;
    ASSERT_EQ(found.meeting == Meeting::Meet, collide(c.a, c.pose_a, c.b, c.pose_b));
    if (found.meeting == Meeting::Meet) {
      ++meeting;
      expectToMeet(pair, found);
      crossings += found.crosses();
      containments += found.isInside();
      if (!found.crosses()) continue;
      // A vertex of one that is in the other, beside an edge of that: nothing is apart.
      for (const auto kind : {FeaturePair::kEdgeOfA, FeaturePair::kEdgeOfB, FeaturePair::kVertices})
        for (const std::uint32_t step : {0u, 1u})
          ASSERT_EQ(
              nearestOf(pair, {kind, behind(pair.a, found.edgeA(), step), behind(pair.b, found.edgeB(), step)}).meeting,
              Meeting::Meet);
      continue;
    }
    const EdgeDistances edges{PosedVertices(pair)};
    const DistanceQuery options;
    DistanceSearch all(edges, options);
    for (std::uint32_t k = 0; k + 1 < pair.a.path.size(); ++k)
      for (std::uint32_t l = 0; l + 1 < pair.b.path.size(); ++l) ASSERT_TRUE(all.show(k, l));
    all.finish();
    ASSERT_EQ(leastDistance(pair, found), all.best().distance);
    // Features to try first: those that were found, some near them, and any.
    const auto step = [&](int most) { return static_cast<std::uint32_t>(random.integer(0, most)); };
    const auto kind = static_cast<FeaturePair::Kind>(random.integer(1, 3));
    const FeaturePair& known = found.features;
    for (const FeaturePair& tried :
         {known, FeaturePair{kind, behind(pair.a, known.edge_a, step(2)), behind(pair.b, known.edge_b, step(2))},
          FeaturePair{kind, behind(pair.a, 0, step(1000)), behind(pair.b, 0, step(1000))}}) {
      const Found hinted = nearestOf(pair, tried);
      ASSERT_EQ(hinted.meeting, Meeting::Apart);
      ASSERT_EQ(leastDistance(pair, hinted), all.best().distance);
      const bool is_known = tried.kind == known.kind && tried.edge_a == known.edge_a && tried.edge_b == known.edge_b;
      (is_known ? proven : proven_by_chance) += hinted.were_tried;
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
  EXPECT_GT(crossings + containments, 0.9 * meeting);
  EXPECT_GT(crossings, 0.2 * meeting);
  EXPECT_GT(containments, 0);
  EXPECT_LT(shown + meeting, count) << "some are too near to tell";
  EXPECT_GT(near, 0.05 * count);
  EXPECT_GT(of_one_shape, 0.1 * count);
}

/// Corners on edges but for the last bits: where plain doubles say that edges cross, they do.
TEST(NearestFeatures, SeesCrossingsThatAreCertain) {
  Random random(9);
  int seen = 0, meeting = 0;
  const int count = scaledCount(2000);
  const Polygon a({{{-1, 0}, {1, 0}, {0, 5}}});
  for (int i = 0; i < count; ++i) {
    const Pose at_a = randomPose(random, 1), at_b = randomPose(random, 1), to_b = at_b.inverse() * at_a;
    const double x = random.real(-1, 1), beyond = random.coin() ? 0.1 : std::ldexp(1.0, -random.integer(40, 53));
    const Vec2 tip = to_b * Vec2(x, random.coin() ? beyond : -beyond), from = to_b * Vec2(x + 0.5, -1);
    const Polygon b({{from, tip, from + Vec2(0.1, 0.1)}});
    const PosedPair pair(detail::dataOf(a), at_a, detail::dataOf(b), at_b);
    EdgeDistance point;
    const bool meets = edgesMeet(pair, 0, 0), is_seen = EdgeDistances::cross(PosedVertices(pair), 0, 0, point);
    ASSERT_TRUE(!is_seen || meets) << reproduction({a, at_a, b, at_b});
    seen += is_seen;
    meeting += meets;
  }
  EXPECT_GT(seen, 0.1 * count);
  EXPECT_GT(meeting, seen);
  EXPECT_LT(meeting, 0.9 * count);
}

/// Doubles see what floats don't: on which side of a corner an edge leads out, and a corner that is hardly outside.
TEST(NearestFeatures, ProvesWhereTheyMeet) {
  const Polygon square({rectangle(-1, -1, 1, 1)});
  int found = 0;
  Random random(5);
  const Pose here = Pose::Identity();
  for (int i = 0; i < 200; ++i) {
    const double beside = random.coin() ? 1e-9 : -1e-9;
    for (Ring ring : {Ring{{0, 0}, {1.25, 1.25 + beside}, {-0.5, 1.25}},
                      Ring{{-0.5, -0.5}, {1 + 1e-9, -0.5}, {random.real(-0.5, 0.5), 0.5}}}) {
      const Pose at_b = randomPose(random, 1);
      for (Vec2& p : ring) p = at_b.inverse() * p;
      const Polygon b({ring});
      const PosedPair pair(detail::dataOf(square), here, detail::dataOf(b), at_b);
      const Found nearest = nearestOf(pair);
      found += nearest.crosses();
      expectToMeet(pair, nearest);
    }
  }
  EXPECT_GT(found, 50);
}

/// Features that are still the support features, but for a little: the nearest point of a is on an edge that ends at
/// one of them, and begins too far back to be one.
TEST(NearestFeatures, LooksAtEdgesBeforeAndBehindAVertex) {
  const Ring below = {{-1, -1}, {1, -1}, {1, -0.006}, {0, 0}, {-1, -0.5}};
  const Ring above = {{0, 0.0008}, {0.05, 0.0001}, {1.2, 1}, {-1, 1}};
  for (const double side : {1.0, -1.0}) {
    Ring rings[] = {below, above};
    for (Ring& ring : rings)
      for (Vec2& p : ring) p.x() *= side;
    const Polygon a({rings[0]}), b({rings[1]});
    const Pose still = Pose::Identity();
    Pose turned = turnedAndMoved(0.3 * side, 0, 0);  // so that two vertices are the nearest
    turned.translation() = above[0] - turned * above[0];
    PairCache cache;
    EXPECT_NEAR(distance(a, still, b, turned, cache).distance, 0.0008, 1e-12);
    const double d = distance(a, still, b, still, cache).distance;
    EXPECT_NEAR(d, 0.0001 + 0.05 * 0.006, 1e-7);
    EXPECT_EQ(d, distance(a, still, b, still).distance);
  }
}

TEST(NearestFeatures, LeavesToOthersWhatIsNotStrictlyConvexOrNotApart) {
  const Polygon square({rectangle(0, 0, 1, 1)}), many({regular(17, 1)}), notched({{{0, 0}, {2, 0}, {1, 0.5}, {0, 2}}});
  const Polygon straight({{{0, 0}, {1, 0}, {1, 1}, {0.5, 1}, {0, 1}}}), flat({{{0, 0}, {1, 0}, {1, 1e-6}, {0, 1e-6}}});
  const struct {
    const char* name;
    const Polygon &a, &b;
    Vec2 shift;
    Meeting meeting;
  } table[] = {{"apart", square, square, {3, 0.25}, Meeting::Apart},
               {"sides that face each other", square, square, {3, 0}, Meeting::Apart},
               {"corners", square, square, {3, 3}, Meeting::Apart},
               {"a touch, of edges that meet", square, square, {1, 0}, Meeting::Meet},
               {"an overlap", square, square, {0.5, 0.25}, Meeting::Meet},
               {"many vertices", many, square, {3, 0.25}, Meeting::Apart},
               {"many vertices, and they meet", many, square, {0.5, 0.25}, Meeting::Unknown},
               {"thin ones", flat, flat, {0, 1e-5}, Meeting::Apart},
               {"a straight vertex", straight, square, {3, 0.25}, Meeting::Unknown},
               {"a notch", notched, square, {3, 0.25}, Meeting::Unknown},
               {"far away", square, square, {1e4, 0}, Meeting::Apart},
               {"an axis in doubles leads past the features", square, square, {1e15, 0}, Meeting::Unknown}};
  const Pose here = Pose::Identity();
  for (const auto& [name, a, b, shift, meeting] : table) {
    const Pose there = turnedAndMoved(0, shift.x(), shift.y());
    EXPECT_EQ(nearestOf(PosedPair(detail::dataOf(a), here, detail::dataOf(b), there)).meeting, meeting) << name;
  }
}

/// A neighbour that is behind by enough of the distance, but by too little of the way there, may hold it too.
TEST(NearestFeatures, AreUniqueWhereBothNeighboursFallAwaySteeplyEnough) {
  const Polygon b({{{0, 0.5}, {1, 3}, {-1, 3}}});
  const Pose still = Pose::Identity();
  for (const double before : {0x1p-17, 0x1p-23})
    for (const double after : {0x1p-17, 0x1p-23}) {
      const Polygon a({{{-1, -4}, {1, -4}, {1, -before}, {0, 0}, {-1, -after}}});
      const Found nearest = nearestOf(PosedPair(detail::dataOf(a), still, detail::dataOf(b), still));
      ASSERT_TRUE(nearest.are_apart);
      EXPECT_EQ(nearest.is_unique, before > 0x1p-20 && after > 0x1p-20) << before << ", " << after;
    }
}

TEST(NearestFeatures, GoesOnAlongBothOutlines) {
  // A round one slides along a side, a hundredth above it: what is nearest is found from where it was before.
  const Polygon floor({rectangle(-100, -1, 100, 0)}), wheel({regular(64, 1)});
  FeaturePair tried;
  int were_tried = 0;
  for (int i = 0; i < 200; ++i) {
    const Pose here = Pose::Identity(), there = turnedAndMoved(-0.013 * i, -1.0 + 0.01 * i, 1.01);
    const PosedVertices vertices(PosedPair(detail::dataOf(floor), here, detail::dataOf(wheel), there));
    const NearestFeatures nearest = findNearestFeatures(vertices, tried);
    ASSERT_TRUE(nearest.are_apart) << i;
    EXPECT_NEAR(nearest.foot.distance, distance(floor, here, wheel, there).distance, 1e-9) << i;
    were_tried += nearest.were_tried;
    tried = nearest.features;
  }
  EXPECT_GT(were_tried, 190);
}

}  // namespace
}  // namespace tricover::support
