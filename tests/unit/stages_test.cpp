// SPDX-License-Identifier: BSD-3-Clause
// What is derived from a polygon, and when it is, which nobody sees in an answer: that is a law of tests/laws. And what
// filters leave to the exact stage.
#include "stages.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

#include "hierarchy/hierarchy.h"
#include "numbers/predicates.h"
#include "pair/posed_pair.h"
#include "pair/ring_starts.h"
#include "polygon/convexity.h"
#include "random.h"
#include "shapes.h"
#include "tricover/tricover.h"

namespace tricover::support {
namespace {

using detail::hierarchyIfBuilt;
using detail::innerDiscsIfBuilt;
using detail::Stages;

const Pose kIdentity = Pose::Identity();

TEST(Stages, ComeWhenQueriesHavePaidForThem) {
  const UpTo paid(Stages::Paid);
  Random random(1);
  const Polygon a({star(random, 64, 0.5, 1)}), b({star(random, 64, 0.5, 1)});
  int by_edges = 0, by_hierarchy = 0;
  for (int i = 0; i < 1000 && innerDiscsIfBuilt(detail::dataOf(a)) == nullptr; ++i) {
    collide(a, kIdentity, b, turnedAndMoved(random.real(0, 6), random.real(0.8, 1.2), 0));
    ++(hierarchyIfBuilt(detail::dataOf(a)) == nullptr ? by_edges : by_hierarchy);
  }
  EXPECT_GE(by_edges, 3);
  EXPECT_LE(by_edges, 100);
  EXPECT_GE(by_hierarchy, 3);
  EXPECT_NE(innerDiscsIfBuilt(detail::dataOf(a)), nullptr);
  EXPECT_NE(innerDiscsIfBuilt(detail::dataOf(b)), nullptr);
}

TEST(Stages, ComeAtOnceWhereEdgesAloneCostMore) {
  const UpTo paid(Stages::Paid);
  Random random(2);
  for (const int n : {1000, 20000}) {
    const Polygon a({star(random, n, 0.9, 1)}), b({star(random, n, 0.9, 1)});
    EXPECT_TRUE(collide(a, kIdentity, b, turnedAndMoved(0, 0.5, 0)));
    EXPECT_EQ(hierarchyIfBuilt(detail::dataOf(a)) != nullptr, n == 20000)
        << "pairs of boxes grow with the square of that";
  }
}

/// A map that is asked about robots that are new each time is worth a hierarchy, sooner than they are.
TEST(Stages, AreOfThePolygonThatIsAskedOften) {
  const UpTo paid(Stages::Paid);
  Random random(2);
  const Polygon map({star(random, 500, 5, 10)});
  for (int i = 0; i < 40; ++i)
    collide(map, kIdentity, Polygon({star(random, 8, 0.5, 1)}),
            turnedAndMoved(0, random.real(4, 8), random.real(-3, 3)));
  EXPECT_NE(hierarchyIfBuilt(detail::dataOf(map)), nullptr);
}

TEST(Stages, WhatDiscsDecideDerivesNothing) {
  const UpTo paid(Stages::Paid);
  const Polygon a({regular(30, 1)}), b({regular(30, 1)});
  for (int i = 0; i < 1000; ++i) EXPECT_FALSE(collide(a, kIdentity, b, turnedAndMoved(0, 2.5, 0)));
  EXPECT_EQ(hierarchyIfBuilt(detail::dataOf(a)), nullptr);
}

TEST(Stages, PrepareBuildsAll) {
  const UpTo paid(Stages::Paid);
  Random random(3);
  std::vector<Ring> rings;
  for (int i = 0; i < 9; ++i) rings.push_back(star(random, 9, 0.2, 0.4, {i % 3, i / 3}));
  const Polygon islands(rings), round({regular(12, 1)});
  for (const Polygon& polygon : {islands, round}) {
    prepare(polygon);
    EXPECT_NE(hierarchyIfBuilt(detail::dataOf(polygon)), nullptr);
    EXPECT_NE(innerDiscsIfBuilt(detail::dataOf(polygon)), nullptr);
    EXPECT_NE(detail::dataOf(polygon).convexity.ifBuilt(), nullptr);
  }
  EXPECT_NE(detail::dataOf(islands).starts.ifBuilt(), nullptr);
  EXPECT_NE(hierarchyIfBuilt(detail::dataOf(islands))->sides.ifBuilt(), nullptr);
  EXPECT_NE(convexityOf(detail::dataOf(round)).outline.ifBuilt(), nullptr);
}

/// What is derived from a polygon; null for what isn't there.
std::vector<const void*> derivedFrom(const Polygon& polygon) {
  const detail::PolygonData& data = detail::dataOf(polygon);
  std::vector<const void*> all = {data.hierarchy.ifBuilt(), data.discs.ifBuilt(), data.convexity.ifBuilt(),
                                  data.starts.ifBuilt()};
  if (const detail::Hierarchy* hierarchy = hierarchyIfBuilt(data))
    all.insert(all.end(), {hierarchy->few_blocks.ifBuilt(), hierarchy->tangles.ifBuilt(), hierarchy->sides.ifBuilt()});
  if (data.convexity.ifBuilt() != nullptr) all.push_back(detail::convexityOf(data).outline.ifBuilt());
  return all;
}

void askAll(const Polygon& a, const Polygon& b, const Pose& pose_b) {
  collide(a, kIdentity, b, pose_b);
  collide(a, kIdentity, b, pose_b, CollideOptions{0.1, 0.1});
  PairCache cache;
  for (int i = 0; i < 3; ++i) collide(a, kIdentity, b, pose_b, cache);
  distance(a, kIdentity, b, pose_b);
  crossings(a, kIdentity, b, pose_b);
  ContactOptions options;
  for (const ContactDetail detail : {ContactDetail::Points, ContactDetail::LocalDepth, ContactDetail::GlobalDepth})
    for (const double margin : {0.0, 0.1}) {
      options.margin = margin, options.detail = detail;
      contacts(a, kIdentity, b, pose_b, options);
    }
  penetration(a, kIdentity, b, pose_b);
  Motion motion = Motion::still(pose_b);
  motion.shift = -1.5 * pose_b.translation();
  motion.angle = 1;
  timeOfImpact(a, Motion::still(kIdentity), b, motion);
  castRay(a, kIdentity, pose_b.translation(), Vec2(0.1, 0.2));
  locate(a, pose_b.translation());
  distance(a, kIdentity, Polygon::point(pose_b.translation()), kIdentity);
  paper::collide(a, kIdentity, b, pose_b);
  Scene scene;
  scene.add(a, kIdentity);
  scene.nearest(b, pose_b);
  scene.collides(b, pose_b);
}

/// Of a polygon that is prepared, whatever is asked of it: convex, with straight vertices, holes, islands, meeting
/// itself, a segment, a point.
TEST(Stages, NothingIsBuiltAfterPrepare) {
  const UpTo paid(Stages::Paid);
  Random random(4);
  std::vector<Ring> islands, meeting;
  for (int i = 0; i < 9; ++i) {
    islands.push_back(star(random, 9, 0.2, 0.4, {i % 3 - 1, i / 3 - 1}));
    meeting.push_back(star(random, 9, 0.6, 0.9, {i % 3 - 1, i / 3 - 1}));
  }
  std::vector<Polygon> polygons = {Polygon::segment({-1, 0}, {1, 0.5}), Polygon::point({0.1, 0})};
  for (const std::vector<Ring>& rings :
       std::initializer_list<std::vector<Ring>>{{regular(8, 1)},
                                                {regular(100, 1)},
                                                {{{-1, -1}, {0, -1}, {1, -1}, {1, 1}, {-1, 1}}},
                                                {star(random, 7, 0.5, 1)},
                                                {star(random, 200, 0.5, 1)},
                                                {regular(20, 1), regular(10, 0.5)},
                                                islands,
                                                meeting})
    polygons.emplace_back(rings);
  std::vector<std::vector<const void*>> derived;  // of each
  for (const Polygon& polygon : polygons) prepare(polygon), derived.push_back(derivedFrom(polygon));
  for (const Polygon& a : polygons)
    for (const Polygon& b : polygons)
      for (const double x : {0.0, 0.3, 0.9, 1.8, 3.0}) askAll(a, b, turnedAndMoved(random.real(0, 6), x, 0.1));
  for (std::size_t i = 0; i < polygons.size(); ++i) EXPECT_EQ(derivedFrom(polygons[i]), derived[i]) << i;
}

/// Each end of either edge, alone, at exactly the margin: the exact stage decides.
TEST(EdgesWithin, HoldsEveryEndAtExactlyTheMargin) {
  const Polygon a({{{0, 0}, {8, 0}, {4, -9}}}), down({{{4, 30}, {4, 5}, {30, 30}}}), up({{{4, 5}, {4, 30}, {30, 30}}});
  const auto within = [&](const Polygon& p, const Polygon& q, double reach) {
    const detail::PosedPair pair(detail::dataOf(p), kIdentity, detail::dataOf(q), kIdentity);
    const std::uint64_t before = detail::exactCalls();
    const bool result = detail::edgesWithin(pair, 0, 0, reach, 0);
    EXPECT_GT(detail::exactCalls(), before);
    return result;
  };
  for (const Polygon& b : {down, up}) {
    EXPECT_TRUE(within(a, b, 5));
    EXPECT_TRUE(within(b, a, 5));
    EXPECT_FALSE(within(a, b, std::nextafter(5.0, 0.0)));
    EXPECT_FALSE(within(b, a, std::nextafter(5.0, 0.0)));
  }
}

TEST(Stages, TheFilterAnswersWhatIsApartOrCrossingAndTheExactStageWhatTouches) {
  Random random(6);
  const Polygon square({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}});
  int hits = 0;
  const std::uint64_t before = detail::exactCalls();
  for (int i = 0; i < 4000; ++i) {
    const Pose pose_a = randomPose(random, 1), pose_b = mirrored(randomPose(random, 1));
    hits += collide(square, pose_a, square, pose_b);
  }
  EXPECT_LE(detail::exactCalls() - before, 4u) << "random poses are not the exact stage's business";
  EXPECT_GT(hits, 1200);
  EXPECT_LT(hits, 3600);
  const std::uint64_t touching = detail::exactCalls();
  EXPECT_TRUE(collide(square, kIdentity, square, turnedAndMoved(0, 1, 0)));
  EXPECT_GT(detail::exactCalls(), touching) << "a touch can't be a filter's answer";
  EXPECT_FALSE(collide(square, kIdentity, square, turnedAndMoved(0, std::nextafter(1.0, 2.0), 0)));
}

}  // namespace
}  // namespace tricover::support
