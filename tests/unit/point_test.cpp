// SPDX-License-Identifier: BSD-3-Clause
// A point beside a polygon, by the ways that are for points alone: alike bit by bit for every instruction set, and what
// they say is so on exact rationals.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "distance/distance_solvers.h"
#include "distance_laws.h"
#include "exact_reference.h"
#include "families.h"
#include "hierarchy/simd.h"
#include "pair/certificate.h"
#include "pair/collide_by_hierarchy.h"
#include "pair/root_box.h"
#include "polygon/cache_access.h"
#include "portable_lanes.h"
#include "random.h"
#include "reproduction.h"
#include "shapes.h"
#include "test_scale.h"
#include "tricover/collide.h"
#include "tricover/distance.h"
#include "tricover/polygon.h"

namespace tricover::support {
namespace {

using detail::defectOf;
using detail::Outcome;
using detail::PosedPair;

const Pose kStill = Pose::Identity();

/// A family's polygon and a point on it, just beside it, or anywhere around.
Case besidePoint(Random& random, const Case& c) {
  const Polygon& polygon = random.coin() ? c.a : c.b;
  const EdgeIndex edge = anyEdge(random, polygon);
  const Vec2 on_edge = 0.5 * polygon.edgeStart(edge) + 0.5 * polygon.edgeEnd(edge);
  const double size = std::min(polygon.radius(), 1e300);
  const double reach = random.oneIn(4) ? 3000 : 2;  // far away, floats round by more than boxes are padded
  const Vec2 around = on_edge + size * Vec2(random.real(-reach, reach), random.real(-reach, reach));
  const int place = random.integer(0, 3);
  const Vec2 p = place == 0 ? polygon.edgeStart(edge) : place == 1 ? nudged(random, on_edge, 2) : around;
  const Pose& pose = random.coin() ? c.pose_a : c.pose_b;
  return {polygon, c.pose_a, Polygon::point(p.allFinite() ? p : on_edge), random.oneIn(4) ? pose : c.pose_a};
}

/// What the nearest edges say, where they are a way to tell.
std::optional<DistanceResult> byEdges(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b) {
  const detail::PosedVertices pair(PosedPair(detail::dataOf(a), pose_a, detail::dataOf(b), pose_b));
  DistanceResult result;
  return pointDistance(pair, {}, result) ? std::optional(result) : std::nullopt;
}

/// Whether it is wrong by more than is documented, or elsewhere. `squared` is the distance's of the regions.
std::string wrongEdge(const Case& c, const DistanceResult& nearest, const mpq_class& squared) {
  const mpq_class d(nearest.distance), error = d * 0x1p-47 + mpq_class(0x1p-1073), high = d + error;
  const mpq_class low = d > error ? mpq_class(d - error) : mpq_class(0);
  if ((sgn(d) == 0) != (sgn(squared) == 0)) return "inside or outside";
  if (sgn(d) == 0) return nearest.edge_a == -1 ? "" : "an edge";
  const Polygon alone = Polygon::segment(c.a.edgeStart(nearest.edge_a), c.a.edgeEnd(nearest.edge_a));
  const mpq_class of_edge = exact::distanceSquared(alone, c.pose_a, c.b, c.pose_b);
  if (of_edge < low * low || of_edge > high * high) return "distance";
  return squared < low * low ? "another edge is nearer" : "";
}

/// What hits, clearances and nearest edges say is so, on all lanes. That collide() and distance() are right is a law.
TEST(Point, IsAsFarAsTheNearestEdge) {
  int asked = 0, hits = 0;
  for (const Family& family : families())
    for (int i = 0; i < scaledCount(150, 8); ++i) {
      const auto seed = static_cast<std::uint64_t>(i) + 47000000;
      Random random(~seed);
      const Case c = besidePoint(random, family.make(seed));
      const detail::PolygonData &a = detail::dataOf(c.a), &b = detail::dataOf(c.b);
      if (a.isDegenerate() || a.isPoint()) continue;
      const mpq_class squared = exact::distanceSquared(c.a, c.pose_a, c.b, c.pose_b);
      const auto nearest = byEdges(c.a, c.pose_a, c.b, c.pose_b);
      const auto alike = onPortableLanes([&] { return byEdges(c.a, c.pose_a, c.b, c.pose_b); });
      ASSERT_EQ(alike.has_value(), nearest.has_value()) << reproduction(c);
      if (nearest) {
        ASSERT_EQ(wrongEdge(c, *nearest, squared), "") << reproduction(c);
        ASSERT_TRUE(same(*alike, *nearest)) << reproduction(c);
      }
      const double below = std::min(exact::distanceBelow(squared), 1e308);
      const double margins[] = {below * random.real(0, 2), below * random.real(0, 2), below, nudged(below, 1), 0};
      CollideOptions options;
      options.margin = margins[random.integer(0, 4)];
      if (!std::isfinite(options.margin)) continue;
      const bool truth = exact::within(squared, mpq_class(options.margin));
      ++asked, hits += truth;
      ASSERT_EQ(collide(c.a, c.pose_a, c.b, c.pose_b, options), truth) << options.margin << "\n" << reproduction(c);
      const PosedPair pair(a, c.pose_a, b, c.pose_b);
      const Outcome outcome = collideByHierarchy(pair, options, below, detail::Wanted::Clearance);
      ASSERT_EQ(outcome.collides, truth) << options.margin << "\n" << reproduction(c);
      const mpq_class clearance = mpq_class(outcome.clearance);
      ASSERT_TRUE(truth || squared >= clearance * clearance) << options.margin << "\n" << reproduction(c);
    }
  EXPECT_GE(hits, 0.2 * asked);
  EXPECT_LE(hits, 0.95 * asked);
}

/// A margin makes a hit last, but not the overlap that the certificate is about.
TEST(Point, ThatIsDeepKeepsAFactWithoutTheMargin) {
  Ring ring;  // a bar of more edges than are asked at once
  for (int i = 0; i < 40; ++i) ring.push_back({i - 20.0, -4});
  for (int i = 0; i < 40; ++i) ring.push_back({20.0 - i, 4});
  const Polygon bar({ring}), dot = Polygon::point({0, 0});
  PairCache cache;
  CollideOptions options;
  options.margin = 5;
  // Beside the largest disc inside, in another one.
  const Pose here = Pose::Identity(), beside = turnedAndMoved(0, 10, 0);
  const detail::Outcome certificate = detail::findCertificate(detail::dataOf(bar), here, detail::dataOf(dot), beside,
                                                              detail::defectOf(here, beside), options, {10, true});
  EXPECT_TRUE(certificate.collides);
  EXPECT_GT(certificate.clearance, 1);
  EXPECT_LE(certificate.clearance, 4);
  // Discs are sooner asked than certificates; this one is kept nevertheless.
  detail::remember(detail::contentsOf(cache).collision, detail::dataOf(bar), here, detail::dataOf(dot), beside, true,
                   certificate.clearance);
  EXPECT_FALSE(collide(bar, turnedAndMoved(0, 0, 0), dot, turnedAndMoved(0, 10, 6), cache));
}

/// Coordinates that cancel leave plain doubles less than what is promised.
TEST(Point, WhoseCoordinatesCancel) {
  int plain = 0;
  const int asked = scaledCount(400);
  for (int i = 0; i < asked; ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const double size = std::pow(10, random.real(-3, 6));
    const Polygon a = Polygon::point({size, 0}), b = Polygon::point({-size, 0});
    const Pose pose_a = randomPose(random, 1);
    Pose pose_b = randomPose(random, 1);
    pose_b.translation() += pose_a.linear() * Vec2(size, 0) - pose_b.linear() * Vec2(-size, 0);
    const auto nearest = byEdges(a, pose_a, b, pose_b);
    const double d = nearest ? nearest->distance : -1;
    plain += d > 0;
    for (const double found : {d, distance(a, pose_a, b, pose_b).distance}) {
      if (!(found > 0)) continue;
      const mpq_class squared = exact::distanceSquared(a, pose_a, b, pose_b), truth(found), error = truth * 0x1p-47;
      ASSERT_TRUE((truth - error) * (truth - error) <= squared && squared <= (truth + error) * (truth + error)) << i;
    }
  }
  EXPECT_GE(plain, 0.1 * asked);
  EXPECT_LE(plain, 0.9 * asked);
}

/// Most distances of things that aren't far from the origin, or large beside their distance, are found so.
TEST(Point, IsMostlyPlain) {
  Random random(5);
  int plain = 0;
  const int asked = scaledCount(400);
  for (int i = 0; i < asked; ++i) {
    const Polygon a({regular(random.integer(3, 100), 50)});
    const Vec2 at = random.real(75, 200) * direction(random.real(-3, 3));
    const auto nearest = byEdges(a, kStill, Polygon::point({0, 0}), turnedAndMoved(random.real(-3, 3), at.x(), at.y()));
    plain += nearest.has_value();
    EXPECT_FALSE(nearest && nearest->distance == 0);
  }
  EXPECT_GE(plain, 0.9 * asked);
  // Nearly touching is no matter for plain doubles, but for two-fold numbers.
  const Polygon square({rectangle(-1, -1, 1, 1)});
  const auto near = byEdges(square, kStill, Polygon::point({1 + 1e-12, 0}), kStill);
  ASSERT_TRUE(near);
  const double gap = (1 + 1e-12) - 1;
  EXPECT_NEAR(near->distance, gap, gap * 0x1p-47);
}

/// A box's axis is a pair of floats, longer or shorter than 1 by some 1e-8: a distance may be off by that share of it.
TEST(Point, IsNoFartherFromTheRootThanFromWhatItHolds) {
  Random random(6);
  int tight = 0, longer = 0;
  const int asked = scaledCount(1000);
  for (int i = 0; i < asked; ++i) {
    const double angle = random.real(-3, 3), far = std::ldexp(1.0, random.integer(0, 60));
    const auto ux = static_cast<float>(std::cos(angle)), uy = static_cast<float>(std::sin(angle));
    const detail::Box root{0.25f, -0.5f, ux, uy, 0.75f, 0.125f};
    const detail::Place place{random.real(-far, far), random.real(-far, far), 0};
    // Lengths along the axis are those of the plane times its own.
    const mpq_class dx = mpq_class(place.x) - root.x, dy = mpq_class(place.y) - root.y, x(ux), y(uy);
    const mpq_class along = abs(mpq_class(dx * x + dy * y)) - root.along;
    const mpq_class across = abs(mpq_class(dy * x - dx * y)) - root.across;
    const mpq_class a = sgn(along) > 0 ? along : mpq_class(0), b = sgn(across) > 0 ? across : mpq_class(0);
    const mpq_class axis = x * x + y * y, squared = (a * a + b * b) / axis;
    const double bound = distanceFromRoot(root, place);
    if (bound > 0) {
      ASSERT_LE(mpq_class(bound) * bound, squared) << angle << " " << far;
    }
    tight += bound > 0 && mpq_class(bound) * bound > 0.99 * squared;
    longer += axis > 1 && bound > 0;
  }
  EXPECT_GE(tight, 0.7 * asked);
  EXPECT_GE(longer, 0.3 * asked);
}

}  // namespace
}  // namespace tricover::support
