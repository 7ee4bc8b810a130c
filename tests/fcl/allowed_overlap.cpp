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
#include "tricover/segment.h"

namespace tricover_fcl::test {
namespace {

using tricover::CollideOptions;
using tricover::Touching;
using tricover::support::anyConvex;

Shape<double> withMargin(const tricover::Polygon& polygon, double margin) {
  return std::make_shared<PolygonShaped>(polygon, PolygonOptions{margin, 0, 0});
}

const fcl::Transform3d kHere = fcl::Transform3d::Identity();

/// With contacts and without, one and many, in both orders.
bool meetBy(const CollideOptions& options, const fcl::CollisionGeometryd& a, const fcl::Transform3d& tf_a,
            const fcl::CollisionGeometryd& b, const fcl::Transform3d& tf_b) {
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
    const tricover::Polygon a({anyConvex(random, 1)}), b({anyConvex(random, 1)});
    const tricover::Pose pose_a = randomPose(random, 1), pose_b = randomPose(random, 1);
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
  const auto disc = withMargin(tricover::point({0, 0}), 0.5);
  const fcl::Sphered ball(0.5);
  const auto square = withMargin(tricover::Polygon({rectangle(-1, -1, 1, 1)}), 0);
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
  const tricover::Polygon unit({rectangle(0, 0, 1, 1)});
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
  const auto u = withMargin(tricover::Polygon({{{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}}}), 0);
  const auto bar = withMargin(tricover::Polygon({rectangle(1, 2, 2.5, 2.5)}), 0);
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
std::shared_ptr<fcl::OcTree<double>> octreeOf(const std::vector<tricover::Vec2>& middles) {
  const auto tree = std::make_shared<octomap::OcTree>(0.25);
  for (const tricover::Vec2& m : middles) {
    for (const float z : {0.125f, 0.375f})
      tree->updateNode(octomap::point3d(static_cast<float>(m.x()), static_cast<float>(m.y()), z), true);
  }
  return std::make_shared<fcl::OcTree<double>>(std::shared_ptr<const octomap::OcTree>(tree));
}

/// Their section, each cell grown by a length; with the cells of a half on top.
tricover::Polygon sectionOf(const std::vector<tricover::Vec2>& middles, double by) {
  std::vector<tricover::Ring> rings;
  const auto add = [&](const tricover::Vec2& m, double half) {
    rings.push_back(rectangle(m.x() - half - by, m.y() - half - by, m.x() + half + by, m.y() + half + by));
  };
  std::map<std::pair<double, double>, int> halves;
  for (const tricover::Vec2& m : middles) {
    const tricover::Vec2 around((std::floor(2 * m.x()) + 0.5) / 2, (std::floor(2 * m.y()) + 0.5) / 2);
    if (++halves[{around.x(), around.y()}] == 4) add(around, 0.25);
  }
  for (const tricover::Vec2& m : middles) add(m, 0.125);
  return tricover::Polygon(rings, tricover::FillRule::NonZero);
}

TEST(AllowedOverlap, besideCellsIsThatOfAllThatIsThere) {
  const fcl::Transform3d raised = lifted(0, 0, 0, 0.125);
  // A bar between two cells: each alone is half as wide as both.
  const auto two = octreeOf({{1.875, -0.125}, {1.875, 0.125}});
  const auto bar = [](double margin) { return withMargin(tricover::Polygon({rectangle(0, -0.05, 2, 0.05)}), margin); };
  EXPECT_TRUE(meetBy({}, *bar(-0.12), raised, *two, kHere));
  EXPECT_TRUE(meetBy({-0.12}, *bar(0), raised, *two, kHere));
  EXPECT_FALSE(meetBy({}, *bar(-0.4), raised, *two, kHere));

  Random random(82);
  int hits = 0, count = 0;
  for (int i = 0; i < std::max(20, scaledCount(30)); ++i) {
    std::vector<tricover::Vec2> middles;
    for (double x = -0.875; x < 1; x += 0.25)
      for (double y = -0.875; y < 1; y += 0.25)
        if (!random.oneIn(6)) middles.emplace_back(x, y);
    tricover::Ring ring;
    for (int k = 0; k < 3; ++k) ring.emplace_back(random.real(-1.5, 1.5), random.real(-1.5, 1.5));
    const tricover::Polygon triangle({ring}), exact = sectionOf(middles, 0), larger = sectionOf(middles, 1e-9);
    const double margin = -random.real(0.01, 0.5);
    const auto truth = [&](const tricover::Polygon& section, double m) {
      return tricover::collide(triangle, flat(kHere), section, flat(kHere), {m});
    };
    // Neighbours may be joined or parted by a rounding: only where that leaves no doubt.
    const bool expected = truth(exact, margin - 1e-8);
    if (truth(exact, margin + 1e-8) != expected || truth(larger, margin - 1e-8) != expected ||
        truth(larger, margin + 1e-8) != expected)
      continue;
    const auto octree = octreeOf(middles);
    ASSERT_EQ(meetBy({}, *withMargin(triangle, margin), raised, *octree, kHere), expected) << i;
    const fcl::Transform3d turn = lifted(randomPose(random, 9));
    ASSERT_EQ(meetBy({}, *withMargin(triangle, margin), turn * raised, *octree, turn), expected) << i;
    hits += expected;
    ++count;
  }
  EXPECT_GT(hits, count / 10);
  EXPECT_LT(hits, count * 19 / 20);
}

TEST(AllowedOverlap, besideAHalfspaceIsThatOfAllOfIt) {
  const tricover::Polygon triangle({{{0, 0}, {2, 0}, {0, 2}}});
  EXPECT_TRUE(meetBy({}, *withMargin(triangle, -0.95), kHere, fcl::Halfspaced({1, 0, 0}, 1.05), kHere));
  EXPECT_FALSE(meetBy({}, *withMargin(triangle, -1.1), kHere, fcl::Halfspaced({1, 0, 0}, 1.05), kHere));
  Random random(83);
  for (int i = 0; i < scaledCount(200); ++i) {
    const tricover::Polygon polygon({anyConvex(random, 1)});
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

/// A class of its own around one of FCL's, whose bound is that one's.
template <class Inner>
class Handing : public fcl::MotionBase<double> {
 public:
  explicit Handing(const Inner& inner) : inner_(inner) {}
  double computeMotionBound(const fcl::BVMotionBoundVisitor<double>& visitor) const override {
    return visitor.visit(inner_);
  }
  double computeMotionBound(const fcl::TriangleMotionBoundVisitor<double>&) const override { return 1e9; }
  void getTaylorModel(fcl::TMatrix3<double>&, fcl::TVector3<double>&) const override {}
  bool integrate(double time) const override { return inner_.integrate(time) && ++asked > 0; }
  void getCurrentTransform(fcl::Transform3d& pose) const override { inner_.getCurrentTransform(pose); }

  mutable int asked = 0;

 private:
  Inner inner_;
};

TEST(AllowedOverlap, isReachedOnTimeByAMotionOfOnesOwn) {
  const tricover::Polygon unit({rectangle(-0.5, -0.5, 0.5, 0.5)});
  const Handing moves(fcl::TranslationMotiond(lifted(0, -3, 0), lifted(0, 3, 0)));
  const Handing slides(fcl::TranslationMotiond(lifted(0, -3, 0.76), lifted(0, 3, 0.76)));
  const fcl::TranslationMotiond rests(kHere, kHere);
  const fcl::Boxd box(1, 1, 1);
  for (const double error : {1e-3, 1e-6, 1e-9}) {
    const auto ask = [&](const fcl::CollisionGeometryd& a, const fcl::MotionBase<double>& motion_a,
                         const fcl::CollisionGeometryd& b, const fcl::MotionBase<double>& motion_b) {
      fcl::ContinuousCollisionResultd result;
      const double time = fcl::continuousCollide<double>(&a, &motion_a, &b, &motion_b, advancing(error), result);
      return result.is_collide ? time : 2;
    };
    const auto shape = withMargin(unit, -0.25), other = withMargin(unit, 0), wide = withMargin(unit, 0.5),
               less = withMargin(unit, -0.75);
    for (const double time : {ask(*shape, moves, *other, rests), ask(*other, rests, *shape, moves),
                              ask(*less, moves, *wide, rests), ask(*shape, moves, box, rests)}) {
      EXPECT_LE(time, 2.25 / 6 + 1e-12);
      EXPECT_GE(time, 2.25 / 6 - error - 1e-12);
    }
    // It rests on the other one, a little less deep than is allowed, and slides along it.
    slides.asked = 0;
    EXPECT_EQ(ask(*shape, slides, *other, rests), 2);
    EXPECT_EQ(ask(*other, rests, *shape, slides), 2);
    EXPECT_LT(slides.asked, 400);
  }
  // It leaves an area, by as much as is allowed, and its own corner turns out of it.
  const auto outside = withMargin(tricover::Polygon({rectangle(-2, -2, 2, 2)}).complement(), -0.25);
  fcl::ContinuousCollisionResultd result;
  const Handing leaves(fcl::TranslationMotiond(kHere, lifted(0, 8, 0)));
  const double time = tricover_fcl::continuousCollide<double>(shapeOf(unit).get(), &leaves, outside.get(), &rests,
                                                              advancing(1e-6), result);
  EXPECT_TRUE(result.is_collide);
  EXPECT_LE(time, 1.75 / 8 + 1e-12);
  EXPECT_GE(time, 1.75 / 8 - 1e-6 - 1e-12);
}

/// The same motion by FCL's class, which is known, and by one that is asked for its bounds alone.
TEST(AllowedOverlap, ofMotionsOfOnesOwnIsThatOfFcls) {
  Random random(84);
  const int cases = std::max(40, scaledCount(200));
  int hits = 0;
  for (int i = 0; i < cases; ++i) {
    SCOPED_TRACE(i);
    const auto pose = [&] { return lifted(randomPose(random, 4)); };
    const auto inner = [&] {
      const fcl::Transform3d from = pose(), to = pose();
      return fcl::InterpMotion<double>(from.linear(), from.translation(), to.linear(), to.translation(),
                                       fcl::Vector3d(random.real(-2, 2), random.real(-2, 2), 0));
    };
    const auto a = withMargin(tricover::Polygon({anyConvex(random, 2)}), -random.real(0, 0.5)),
               b = withMargin(tricover::Polygon({anyConvex(random, 2)}), 0.01);
    const auto inner_a = inner(), inner_b = inner();
    const Handing motion_a(inner_a), motion_b(inner_b);
    fcl::ContinuousCollisionResultd result, known;
    const double time = fcl::continuousCollide<double>(a.get(), &motion_a, b.get(), &motion_b, advancing(1e-5), result);
    const double expected =
        fcl::continuousCollide<double>(a.get(), &inner_a, b.get(), &inner_b, advancing(1e-7), known);
    if (result.is_collide != known.is_collide) {
      ASSERT_GT(std::min(time, expected), 1 - 1e-5);
    }
    ASSERT_LE(time, expected + 1e-6);
    ASSERT_GE(time, expected - 1.2e-5);
    hits += result.is_collide && time > 0;
  }
  EXPECT_GT(hits, cases / 10);
  EXPECT_LT(hits, cases * 9 / 10);
}

}  // namespace
}  // namespace tricover_fcl::test
