// SPDX-License-Identifier: BSD-3-Clause
// Margins that add up to less than nothing: an overlap that is allowed. And sums of margins of either sign.
#include <fcl/geometry/octree/octree.h>
#include <fcl/math/motion/interp_motion.h>
#include <fcl/math/motion/translation_motion.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/continuous_collision.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "mixed_scene.h"
#include "tricover/collide.h"
#include "tricover/polygon.h"

namespace tricover_fcl::test {
namespace {

using tricover::CollideOptions;
using tricover::Touching;
using tricover::support::anyConvex;

/// With contacts and without, one and many, in both orders.
bool meetBy(const CollideOptions& options, const Body& a, const Transform& tf_a, const Body& b, const Transform& tf_b) {
  bool answers[6];
  int k = 0;
  for (const bool swapped : {false, true}) {
    for (const auto& request :
         {fcl::CollisionRequestd(), fcl::CollisionRequestd(1, true), fcl::CollisionRequestd(9, true)}) {
      fcl::CollisionResultd result;
      answers[k] = (swapped ? tricover_fcl::collide(&b, tf_b, &a, tf_a, request, options, result)
                            : tricover_fcl::collide(&a, tf_a, &b, tf_b, request, options, result)) > 0;
      ++k;
    }
  }
  EXPECT_EQ(std::count(answers, answers + 6, answers[0]), 6) << answers[0] << answers[1] << answers[2] << answers[3];
  return answers[0];
}

TEST(AllowedOverlap, theSumOfAllMarginsDecides) {
  Random random(81);
  int hits = 0, negative = 0;
  const int count = std::max(100, scaledCount(300));
  for (int i = 0; i < count; ++i) {
    const Polygon a({anyConvex(random, 1)}), b({anyConvex(random, 1)});
    const Pose pose_a = randomPose(random, 1), pose_b = randomPose(random, 1);
    const double of_a = random.real(-1, 1) / 4, of_b = random.real(-1, 1) / 4, of_query = random.real(-2, 1) / 4;
    const double sum = of_query + (of_a + of_b);
    const bool expected = tricover::collide(a, pose_a, b, pose_b, {sum});
    const Shape<double> shape_a = withMargin(a, of_a), shape_b = withMargin(b, of_b);
    ASSERT_EQ(meetBy({of_query}, *shape_a, lifted(pose_a), *shape_b, lifted(pose_b)), expected) << i;
    const Shape<double> all = withMargin(a, sum), none = withMargin(b, 0);
    ASSERT_EQ(meetBy({}, *all, lifted(pose_a), *none, lifted(pose_b)), expected) << i;
    hits += expected;
    negative += expected && sum < 0;
  }
  EXPECT_GT(hits, count / 5);
  EXPECT_LT(hits, count * 19 / 20);
  EXPECT_GT(negative, count / 10);
}

/// The test of discs around the shapes' origins says nothing else.
TEST(AllowedOverlap, ofDiscsAndOfShapesFarApart) {
  const auto disc = withMargin(tricover::Polygon::point({0, 0}), 0.5);
  const fcl::Sphered ball(0.5);
  const auto square = withMargin(Polygon({rectangle(-1, -1, 1, 1)}), 0);
  for (const double margin : {-0.25, -0.75, -3.0, -40.0}) {
    for (double x = 0; x <= 3; x += 0.125) {
      const bool discs_meet = x <= 1 + margin;
      EXPECT_EQ(meetBy({margin}, *disc, kHere, *disc, lifted(0, x, 0)), discs_meet) << margin << ", " << x;
      EXPECT_EQ(meetBy({margin}, *disc, kHere, ball, lifted(0, x, 0)), discs_meet) << margin << ", " << x;
    }
    for (const double x : {0.0, 1.0, 1.9, 2.1, 39.0, 81.0})
      EXPECT_EQ(meetBy({margin}, *square, kHere, *square, lifted(0, x, 0)),
                tricover::collide(square->polygon(), flat(kHere), square->polygon(), flat(lifted(0, x, 0)), {margin}));
  }
}

TEST(AllowedOverlap, touchingIsFreeWhereThatIsAllowed) {
  const CollideOptions allowed{0, 0, Touching::Allowed};
  const Polygon unit({rectangle(0, 0, 1, 1)});
  const auto square = withMargin(unit, 0), wide = withMargin(unit, 0.25), small = withMargin(unit, -0.25);
  const fcl::Boxd box(1, 1, 1);
  const fcl::Sphered ball(0.5);
  const auto at = [](double x, double y = 0) { return lifted(0, x, y); };
  for (const double deep : {0.0, 1e-9}) {
    EXPECT_EQ(meetBy(allowed, *square, at(0), *square, at(1 - deep)), deep > 0);
    EXPECT_EQ(meetBy(allowed, *square, at(0), box, at(1.5 - deep, 0.5)), deep > 0);
    EXPECT_EQ(meetBy(allowed, *square, at(0), ball, at(1.5 - deep, 0.5)), deep > 0);
    EXPECT_EQ(meetBy(allowed, *wide, at(0), *square, at(1.25 - deep)), deep > 0);
    EXPECT_EQ(meetBy(allowed, *wide, at(0), *small, at(1 - deep)), deep > 0);
    EXPECT_EQ(meetBy({0.5, 0, Touching::Allowed}, *wide, at(0), *square, at(1.75 - deep)), deep > 0);
    EXPECT_EQ(meetBy({0.5, 0, Touching::Collides}, *wide, at(0), *square, at(1.75 - deep)), true);
  }
  // Only what overlaps leaves contacts: U and a bar that touches one of its arms.
  const auto u = withMargin(Polygon({{{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}}}), 0);
  const auto bar = withMargin(Polygon({rectangle(1, 2, 2.5, 2.5)}), 0);
  fcl::CollisionResultd result;
  EXPECT_GE(tricover_fcl::collide<double>(u.get(), kHere, bar.get(), kHere, {9, true}, allowed, result), 1U);
  for (std::size_t k = 0; k < result.numContacts(); ++k) EXPECT_GE(result.getContact(k).pos.x(), 1.5);
  EXPECT_NE(
      thrownBy<std::invalid_argument>([&] {
        tricover_fcl::collide<double>(u.get(), kHere, bar.get(), at(99), {}, {0, 0, static_cast<Touching>(7)}, result);
      }).find("touching"),
      std::string::npos);
}

/// An octree of these columns of two cells of a quarter each, four of which may be one cell of a half.
std::shared_ptr<fcl::OcTree<double>> octreeOf(const std::vector<Vec2>& middles) {
  const auto tree = std::make_shared<octomap::OcTree>(0.25);
  for (const Vec2& m : middles) {
    for (const float z : {0.125f, 0.375f})
      tree->updateNode(octomap::point3d(static_cast<float>(m.x()), static_cast<float>(m.y()), z), true);
  }
  return std::make_shared<fcl::OcTree<double>>(std::shared_ptr<const octomap::OcTree>(tree));
}

/// Their section, each cell grown by a length; with the cells of a half on top.
Polygon sectionOf(const std::vector<Vec2>& middles, double by) {
  std::vector<Ring> rings;
  const auto add = [&](const Vec2& m, double half) {
    rings.push_back(rectangle(m.x() - half - by, m.y() - half - by, m.x() + half + by, m.y() + half + by));
  };
  std::map<std::pair<double, double>, int> halves;
  for (const Vec2& m : middles) {
    const Vec2 around((std::floor(2 * m.x()) + 0.5) / 2, (std::floor(2 * m.y()) + 0.5) / 2);
    if (++halves[{around.x(), around.y()}] == 4) add(around, 0.25);
  }
  for (const Vec2& m : middles) add(m, 0.125);
  return Polygon(rings, tricover::FillRule::NonZero);
}

TEST(AllowedOverlap, besideCellsIsThatOfAllThatIsThere) {
  const Transform raised = lifted(0, 0, 0, 0.125);
  // A bar between two cells: each alone is half as wide as both.
  const auto two = octreeOf({{1.875, -0.125}, {1.875, 0.125}});
  const auto bar = [](double margin) { return withMargin(Polygon({rectangle(0, -0.05, 2, 0.05)}), margin); };
  EXPECT_TRUE(meetBy({}, *bar(-0.12), raised, *two, kHere));
  EXPECT_TRUE(meetBy({-0.12}, *bar(0), raised, *two, kHere));
  EXPECT_FALSE(meetBy({}, *bar(-0.4), raised, *two, kHere));

  Random random(82);
  int hits = 0, count = 0;
  for (int i = 0; i < std::max(20, scaledCount(30)); ++i) {
    std::vector<Vec2> middles;
    for (double x = -0.875; x < 1; x += 0.25)
      for (double y = -0.875; y < 1; y += 0.25)
        if (!random.oneIn(6)) middles.emplace_back(x, y);
    Ring ring;
    for (int k = 0; k < 3; ++k) ring.emplace_back(random.real(-1.5, 1.5), random.real(-1.5, 1.5));
    const Polygon triangle({ring}), exact = sectionOf(middles, 0), larger = sectionOf(middles, 1e-9);
    const double margin = -random.real(0.01, 0.5);
    const auto truth = [&](const Polygon& section, double m) {
      return tricover::collide(triangle, flat(kHere), section, flat(kHere), {m});
    };
    // Neighbours may be joined or parted by a rounding: only where that leaves no doubt.
    const bool expected = truth(exact, margin - 1e-8);
    if (truth(exact, margin + 1e-8) != expected || truth(larger, margin - 1e-8) != expected ||
        truth(larger, margin + 1e-8) != expected)
      continue;
    const auto octree = octreeOf(middles);
    ASSERT_EQ(meetBy({}, *withMargin(triangle, margin), raised, *octree, kHere), expected) << i;
    const Transform turn = lifted(randomPose(random, 9));
    ASSERT_EQ(meetBy({}, *withMargin(triangle, margin), turn * raised, *octree, turn), expected) << i;
    hits += expected;
    ++count;
  }
  EXPECT_GT(hits, count / 10);
  EXPECT_LT(hits, count * 19 / 20);
}

TEST(AllowedOverlap, besideAHalfspaceIsThatOfAllOfIt) {
  const Polygon triangle({{{0, 0}, {2, 0}, {0, 2}}});
  EXPECT_TRUE(meetBy({}, *withMargin(triangle, -0.95), kHere, fcl::Halfspaced({1, 0, 0}, 1.05), kHere));
  EXPECT_FALSE(meetBy({}, *withMargin(triangle, -1.1), kHere, fcl::Halfspaced({1, 0, 0}, 1.05), kHere));
  Random random(83);
  for (int i = 0; i < scaledCount(200); ++i) {
    const Polygon polygon({anyConvex(random, 1)});
    const double allowed = random.real(0.01, 1), off = random.real(-1, 2);
    // How deep the polygon reaches.
    double depth = -1e9;
    for (tricover::EdgeIndex e = 0; e < polygon.edgeCount(); ++e)
      depth = std::max(depth, off - polygon.edgeStart(e).x());
    if (std::abs(depth - allowed) < 1e-6) continue;
    const fcl::Halfspaced halfspace({1, 0, 0}, off);
    const auto shape = withMargin(polygon, -allowed);
    ASSERT_EQ(meetBy({}, *shape, kHere, halfspace, kHere), depth >= allowed) << i;
    if (depth < allowed) continue;
    const auto found = contactsOf(*shape, kHere, halfspace, kHere, 9);
    ASSERT_NEAR(found.at(0).penetration_depth, depth - allowed, 1e-9) << i;
  }
}

}  // namespace
}  // namespace tricover_fcl::test
