// SPDX-License-Identifier: BSD-3-Clause
// What the cells of a field say, beside all edges; and that no answer depends on it.
#include "hierarchy/influence_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "numbers/segment.h"
#include "random.h"
#include "shapes.h"
#include "stages.h"
#include "test_scale.h"
#include "tricover/collide.h"
#include "tricover/distance.h"
#include "tricover/locate.h"
#include "tricover/polygon.h"
#include "tricover/prepare.h"
#include "tricover/time_of_impact.h"

namespace tricover::support {
namespace {

using detail::InfluenceField;
using detail::PolygonData;
using detail::Stages;

/// Islands on a grid, some of which touch, overlap, lie upon each other, or are slits.
std::vector<Ring> islands(Random& random) {
  std::vector<Ring> rings;
  for (int i = 0; i < 30; ++i) {
    const Vec2 at(random.integer(-8, 8), random.integer(-8, 8));
    const double small = random.coin() ? 1 : 0.125;
    const double w = small * random.integer(1, 3), h = random.oneIn(4) ? 0 : small * random.integer(1, 3);
    rings.push_back({at, at + Vec2(w, 0), at + Vec2(w, h), at + Vec2(0, h)});
    if (random.oneIn(8)) rings.push_back(rings.back());
  }
  return rings;
}

Polygon anyOutline(Random& random) {
  const FillRule rule = random.coin() ? FillRule::EvenOdd : FillRule::NonZero;
  std::vector<Ring> rings;
  if (random.coin()) {
    rings = islands(random);
  } else if (random.coin()) {
    rings = {star(random, random.integer(64, 400), random.coin() ? 0.97 : random.real(0.1, 0.9), 1)};
  } else {
    Ring soup;
    for (int n = random.integer(64, 90); n > 0; --n) soup.emplace_back(random.real(-1, 1), random.real(-1, 1));
    rings = {soup};
  }
  if (random.oneIn(4))
    for (Ring& ring : rings)
      for (Vec2& p : ring) p.y() *= std::pow(10, random.real(-6, -5));  // a strip
  return Polygon(rings, rule);
}

double distanceInUnits(const PolygonData& polygon, const Vec2& p) {
  double least = 1e300;
  for (std::size_t r = 0; r < polygon.ringCount(); ++r)
    for (auto e = polygon.edgeBegin(r); e < polygon.edgeEnd(r); ++e)
      least = std::min(least, detail::squaredDistanceToSegment(p, polygon.inUnits(polygon.path[e]),
                                                               polygon.inUnits(polygon.path[e + 1])));
  return std::sqrt(least);
}

TEST(InfluenceField, CellsKnowHowFarTheOutlineIsAndOnWhichSide) {
  int free = 0, inside = 0, near = 0, outside_of_grid = 0;
  for (int i = 0; i < scaledCount(120); ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const double size = random.oneIn(3) ? std::pow(10, random.real(-300, 300)) : 1;
    const Polygon polygon = anyOutline(random).translated({random.real(-9, 9), 0}).scaled(size);
    const PolygonData& data = detail::dataOf(polygon);
    const InfluenceField field(data);
    EXPECT_LE(field.bytes(), 40 * data.path.size() + 4096) << i;
    for (int k = 0; k < 200; ++k) {
      const auto edge = static_cast<std::size_t>(random.integer(0, static_cast<int>(data.path.size()) - 1));
      const double reach = random.oneIn(3) ? 3 : random.coin() ? 1 : 0.3;
      Vec2 p(random.real(-reach, reach), random.real(-reach, reach));
      if (random.coin())
        p = data.inUnits(data.path[edge]) + std::pow(10, random.real(-15, -1)) * direction(random.real(0, 6.3));
      const InfluenceField::Look look = field.at(p.x(), p.y());
      const double distance = distanceInUnits(data, p);
      EXPECT_LE(look.free, distance * (1 + 1e-12) + 1e-12) << i;
      EXPECT_GE(look.near, distance * (1 - 1e-12) - 1e-12) << i;
      const bool is_inside = locate(polygon, polygon.coveringOrigin() + p * data.unit) == Location::Inside;
      if (look.free > 1e-9) {
        EXPECT_EQ(look.inside, is_inside) << i;
      }
      free += look.free > 0, inside += look.free > 1e-9 && look.inside, near += look.near < 0.3;
      outside_of_grid += look.near == InfluenceField::kNone;
    }
  }
  const int few = scaledCount(120);
  EXPECT_GE(free, few);
  EXPECT_GE(inside, few);
  EXPECT_GE(near, few);
  EXPECT_GE(outside_of_grid, few);
}

/// Of 1 x 65/64 with 64 edges: cells are a 32nd wide, and the left side has a vertex at the middle of each row.
TEST(InfluenceField, CountsAVertexAtARowsMiddleOnce) {
  constexpr double kRow = 1.0 / 32, kHigh = 65.0 / 128;
  Ring ring = {{-0.5, -kHigh}, {0.5, -kHigh}};
  for (int k = 29; k >= 0; --k) ring.push_back({0.5, kHigh - (k + 0.5) * kRow});
  ring.insert(ring.end(), {{0.5, kHigh}, {-0.5, kHigh}});
  for (int k = 29; k >= 0; --k) ring.push_back({-0.5, -kHigh + (k + 0.5) * kRow});
  const Polygon polygon({ring});
  const PolygonData& data = detail::dataOf(polygon);
  ASSERT_EQ(data.origin, Vec2(0, 0));
  const InfluenceField field(data);
  ASSERT_EQ(field.side() * data.unit, kRow);
  for (int k = 2; k < 30; ++k) {
    const InfluenceField::Look look = field.at(0, (-kHigh + (k + 0.5) * kRow) / data.unit);
    EXPECT_TRUE(look.inside && look.free > 0) << k;
  }
}

/// The middle of b's box is free and outside, and no disc of b meets the island at its tip.
TEST(InfluenceField, AnIslandAtTheTipOfABodyIsInIt) {
  std::vector<Ring> rings = {scaled(regular(1000, 1), 10)};
  rings.push_back(scaled(rings.front(), 0.9));
  const Ring dust = scaled(regular(3, 1), 1e-4);
  rings.push_back(shifted(dust, {0.97, 0}));
  const Polygon room(rings), tip({{{-1, -0.3}, {1, 0}, {-1, 0.3}}});
  prepare(room);
  prepare(tip);
  EXPECT_TRUE(collide(room, Pose::Identity(), tip, Pose::Identity()));
  EXPECT_FALSE(collide(room, Pose::Identity(), tip, turnedAndMoved(0, -0.04, 0)));
  EXPECT_FALSE(collide(room, Pose::Identity(), tip, turnedAndMoved(0, 5, 0)));
}

/// Each edge that comes into a box is shown.
TEST(InfluenceField, ShowsAllEdgesNearABox) {
  int shown = 0, left_out = 0;
  for (int i = 0; i < scaledCount(100); ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const Polygon polygon = anyOutline(random);
    const PolygonData& data = detail::dataOf(polygon);
    const InfluenceField field(data);
    for (int k = 0; k < 20; ++k) {
      const Vec2 middle(random.real(-1, 1), random.real(-1, 1)), half(random.unit() * 0.2, random.unit() * 0.2);
      std::vector<bool> is_shown(data.path.size());
      field.forEachEdge(middle, half, [&](detail::EdgePosition e) { return is_shown[e] = true; });
      for (std::size_t r = 0; r < data.ringCount(); ++r)
        for (auto e = data.edgeBegin(r); e < data.edgeEnd(r); ++e) {
          const Vec2 v = data.inUnits(data.path[e]), w = data.inUnits(data.path[e + 1]);
          const Vec2 nearest = detail::nearestOnSegment(middle, v, w) - middle;
          (is_shown[e] ? shown : left_out) += 1;
          if ((nearest.cwiseAbs().array() <= half.array()).all()) {
            EXPECT_TRUE(is_shown[e]) << i;
          }
        }
    }
  }
  EXPECT_GE(std::min(shown, left_out), scaledCount(100));
}

/// What is asked of a small body in an outline. Numbers, so that answers compare to the last bit.
struct Answers {
  Answers(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b, double margin, double limit)
      : meet(collide(a, pose_a, b, pose_b, {margin, 0})), location(locate(a, pose_a.inverse() * pose_b.translation())) {
    const DistanceResult found = distance(a, pose_a, b, pose_b, {margin});
    numbers = {found.distance, found.point_a.x(), found.point_a.y(), found.point_b.x(), found.point_b.y()};
    const auto within = distanceWithin(a, pose_a, b, pose_b, limit, {margin});
    numbers.push_back(within ? within->distance : -1);
    const Motion way = Motion::translation(pose_b, {limit, -0.5 * limit});
    const auto impact = timeOfImpact(a, Motion::still(pose_a), b, way, {margin, 1e-6});
    numbers.push_back(impact ? impact->time : -1);
  }
  bool operator==(const Answers& other) const {
    return meet == other.meet && location == other.location && numbers == other.numbers;
  }

  bool meet;
  Location location;
  std::vector<double> numbers;
};

/// Small bodies of all kinds in it, with margins, under poses that miss orthonormality.
TEST(InfluenceField, NoAnswerDependsOnIt) {
  int hits = 0, misses = 0, fields = 0;
  for (int i = 0; i < scaledCount(150); ++i) {
    Random random(static_cast<std::uint64_t>(i));
    Polygon with = anyOutline(random);
    if (random.oneIn(4)) with = with.scaled(std::pow(10, random.real(-140, 140)));
    const double radius = with.radius();
    if (random.oneIn(4) && with.fillRule() == FillRule::EvenOdd) with = with.complement();
    const Polygon without = afresh(with);
    const double size = radius * std::pow(10, random.real(-3, -1));
    const Ring ring = star(random, random.integer(3, 12), 0.3, 1);
    const Polygon small = random.oneIn(5) ? Polygon::point({0, 0}) : Polygon({scaled(ring, size)});
    const Pose pose_a = turnedAndMoved(random.real(0, 6), radius, -radius);
    for (int k = 0; k < 60; ++k) {
      Pose pose_b = turnedAndMoved(random.real(0, 6), 0, 0);
      if (random.oneIn(4)) pose_b = distorted(random, pose_b);
      const EdgeIndex edge = anyEdge(random, with);
      const Vec2 away = random.coin() ? radius * Vec2(random.real(-1, 1), random.real(-1, 1))
                                      : size * Vec2(random.real(-2, 2), random.real(-2, 2));
      pose_b.translation() = pose_a * (random.coin() ? with.edgeStart(edge) : with.coveringOrigin()) + away;
      const double margin = random.oneIn(3) ? random.unit() * size : 0, limit = 3 * random.unit() * size;
      const auto answers = [&](const Polygon& a) { return Answers(a, pose_a, small, pose_b, margin, limit); };
      const auto expected = [&] {
        const UpTo trees(Stages::Hierarchy);
        return answers(without);
      }();
      EXPECT_TRUE(answers(with) == expected) << i << ", " << k;
      PairCache cache;
      for (int again = 0; again < 3; ++again)
        EXPECT_EQ(collide(with, pose_a, small, pose_b, cache, {margin, 0}), expected.meet) << i << ", " << k;
      ++(expected.meet ? hits : misses);
    }
    fields += detail::topOf(detail::dataOf(with)).field.ifBuilt() != nullptr;
    EXPECT_EQ(detail::topOf(detail::dataOf(without)).field.ifBuilt(), nullptr) << i;
  }
  EXPECT_GE(std::min(hits, misses), scaledCount(150) * 60 / 10);
  EXPECT_GE(fields, scaledCount(150) / 2);
}

}  // namespace
}  // namespace tricover::support
