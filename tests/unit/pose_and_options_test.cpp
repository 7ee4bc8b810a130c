// SPDX-License-Identifier: BSD-3-Clause
// What collide(), locate() and the influence areas refuse, what the text says, and that a refusal changes nothing.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

#include "polygon/cache_access.h"
#include "refusal.h"
#include "shapes.h"
#include "strategies.h"
#include "tricover/collide.h"
#include "tricover/contacts.h"
#include "tricover/locate.h"
#include "tricover/paper.h"

namespace tricover::support {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool names(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::vector<Pose> badPoses() {
  std::vector<Pose> poses(11, Pose::Identity());
  poses[0].linear() *= 1.001;
  poses[1].linear()(0, 1) = 1e-3;
  poses[2].linear()(0, 0) = kNaN;
  poses[3].linear()(1, 0) = kInfinity;
  poses[4].translation().x() = kNaN;
  poses[5].translation().y() = -kInfinity;
  poses[6].linear().setZero();
  poses[7].linear() *= 1 + 2e-6;
  poses[8].linear() << 1, 1, 0, 0;
  poses[9].linear()(0, 0) = 2;
  poses[10].linear()(1, 1) = 2;
  return poses;
}

TEST(PoseCheck, NamesThePoseAndTheField) {
  const Polygon polygon({rectangle(0, 0, 1, 1)});
  for (const Pose& bad : badPoses()) {
    const std::string first = refusal([&] { collide(polygon, bad, polygon, Pose::Identity()); });
    const std::string second = refusal([&] { collide(polygon, Pose::Identity(), polygon, bad); });
    const std::string field = bad.translation().allFinite() ? "linear(" : "translation(";
    EXPECT_TRUE(names(first, "pose_a") && names(first, field)) << first;
    EXPECT_TRUE(names(second, "pose_b") && names(second, field)) << second;
    EXPECT_TRUE(names(refusal([&] { contacts(polygon, bad, polygon, Pose::Identity()); }), "pose_a"));
    EXPECT_TRUE(names(refusal([&] { checkPose(bad, "mine"); }), "mine"));
  }
}

/// A fact that pays for any motion, of this pair in either order, of another one, or none.
TEST(PoseCheck, NamesThePoseWhateverACacheHolds) {
  const Polygon a({rectangle(0, 0, 1, 1)}), b({rectangle(0, 0, 1, 2)});
  const Pose here = Pose::Identity(), far = pose(0, 1e6, 0);
  PairCache of_pair, of_another;
  collide(a, here, b, far, of_pair);
  collide(a, here, a, far, of_another);
  ASSERT_GT(detail::factsIn(of_pair).collision.clearance, 9e5);
  for (const PairCache& given : {of_pair, of_another, PairCache()}) {
    for (const Pose& bad : badPoses()) {
      PairCache cache = given;
      EXPECT_TRUE(names(refusal([&] { collide(a, here, b, bad, cache); }), "tricover: pose_b"));
      EXPECT_TRUE(names(refusal([&] { collide(b, far, a, bad, cache); }), "tricover: pose_b"));
      EXPECT_TRUE(names(refusal([&] { collide(a, bad, b, far, cache); }), "tricover: pose_a"));
      EXPECT_TRUE(names(refusal([&] { collide(b, bad, a, here, cache); }), "tricover: pose_a"));
      EXPECT_EQ(detail::factsIn(cache).collision.uses, detail::factsIn(given).collision.uses);
    }
  }
}

/// An entry that is no number is named, rather than said to be not rigid.
TEST(PoseCheck, NamesTheEntryThatIsNotFinite) {
  const auto refusalOf = [](const Pose& bad) { return refusal([&] { checkPose(bad, "mine"); }); };
  for (const double bad : {kNaN, kInfinity, -kInfinity})
    for (int row : {0, 1})
      for (int column : {0, 1, 2}) {
        Pose pose = Pose::Identity();
        pose.matrix()(row, column) = bad;
        const std::string place = column == 2 ? "translation(" + std::to_string(row)
                                              : "linear(" + std::to_string(row) + ", " + std::to_string(column);
        EXPECT_EQ(refusalOf(pose), "tricover: mine: " + place + ") is not finite");
      }
  Pose large = Pose::Identity();
  large.linear()(0, 1) = 1e200;
  for (const Pose& bad : {large, badPoses()[0], badPoses()[6]})
    EXPECT_TRUE(names(refusalOf(bad), "tricover: mine: linear() is not rigid within 1e-6; ")) << refusalOf(bad);
}

TEST(PoseCheck, TakesRotationsMirrorsAndFloatRounding) {
  for (int i = 0; i < 100; ++i) {
    const Pose turned = pose(0.0628 * i, i, -i);
    EXPECT_NO_THROW(checkPose(turned));
    EXPECT_NO_THROW(checkPose(throughFloat(turned)));
    EXPECT_NO_THROW(checkPose(mirrored(throughFloat(turned))));
  }
  EXPECT_NO_THROW(checkPose(pose(0, 1e308, -1e308)));
}

TEST(CollideOptions, NegativeOrNotFiniteLengthsAreRefusedByName) {
  const Polygon polygon({rectangle(0, 0, 1, 1)});
  for (const double bad : {-1.0, -5e-324, kNaN, kInfinity}) {
    for (const Strategy strategy : {Strategy::Hierarchy, Strategy::Paper}) {
      const auto ask = [&](const CollideOptions& options) {
        return refusal([&] { collide(strategy, polygon, Pose::Identity(), polygon, Pose::Identity(), options); });
      };
      EXPECT_TRUE(names(ask({bad}), "tricover: margin: "));
      EXPECT_TRUE(names(ask({0, bad}), "tricover: tolerance: "));
    }
  }
}

/// A box over two rings is thin, but they don't span it: the tolerance doesn't fill what lies between them.
TEST(CollideOptions, ToleranceLeavesTheSpaceBetweenRingsFree) {
  const Polygon apart({rectangle(-10, 0, -9.99, 0.01), rectangle(9.99, 0, 10, 0.01)}),
      between({rectangle(0, 0, 0.01, 0.01)});
  CollideOptions options;
  options.tolerance = 0.1;
  EXPECT_FALSE(collide(apart, Pose::Identity(), between, Pose::Identity(), options));
  EXPECT_TRUE(collide(apart, Pose::Identity(), between, pose(0, 9.99, 0), options));
}

TEST(Refusal, LeavesTheCachesAsTheyWere) {
  const Polygon a({rectangle(0, 0, 1, 1)}), b({rectangle(0, 0, 1, 2)});
  for (const Strategy strategy : {Strategy::Hierarchy, Strategy::Paper}) {
    StrategyCaches caches;
    collide(strategy, a, Pose::Identity(), b, pose(0, 1.5, 0), caches);
    const StrategyCaches copy = caches;
    for (const Pose& bad : badPoses())
      EXPECT_THROW(collide(strategy, a, Pose::Identity(), b, bad, caches), std::invalid_argument);
    EXPECT_THROW(collide(strategy, b, Pose::Identity(), b, Pose::Identity(), caches, {-1}), std::invalid_argument);
    const detail::CollisionFact &cache = detail::factsIn(caches.of_pair).collision,
                                &before = detail::factsIn(copy.of_pair).collision;
    EXPECT_EQ(cache.first_id, before.first_id);
    EXPECT_EQ(cache.second_id, before.second_id);
    EXPECT_EQ(cache.clearance, before.clearance);
    EXPECT_EQ(cache.overlapping, before.overlapping);
    EXPECT_EQ(cache.uses, before.uses);
    EXPECT_TRUE(std::equal(cache.first_pose, cache.first_pose + 6, before.first_pose));
    EXPECT_TRUE(std::equal(cache.second_pose, cache.second_pose + 6, before.second_pose));
    const auto &mask = detail::factsIn(caches.of_mask), &mask_before = detail::factsIn(copy.of_mask);
    EXPECT_EQ(mask.first_id, mask_before.first_id);
    EXPECT_EQ(mask.second_id, mask_before.second_id);
    EXPECT_EQ(mask.mask, mask_before.mask);
  }
  PointCache cache;
  locate(a, {0.5, 0.5}, cache);
  EXPECT_THROW(locate(b, {kNaN, 0}, cache), std::invalid_argument);
  EXPECT_EQ(detail::factsIn(cache).polygon_id, a.id());
  EXPECT_EQ(detail::factsIn(cache).location, Location::Inside);
}

TEST(Refusal, OfPointsAndLengths) {
  const Polygon polygon({rectangle(0, 0, 1, 1)});
  for (const Vec2& bad : {Vec2(kNaN, 0), Vec2(0, kInfinity)}) {
    EXPECT_TRUE(names(refusal([&] { locate(polygon, bad); }), "tricover: point: "));
    EXPECT_TRUE(names(refusal([&] { paper::influenceMask(polygon, bad, 1); }), "tricover: point: "));
    EXPECT_TRUE(
        names(refusal([&] { paper::inInfluenceArea(polygon, 0, bad, 1, paper::InfluenceKind::Bounded); }), "point"));
  }
  for (const double bad : {-1.0, kNaN}) {
    EXPECT_TRUE(names(refusal([&] { paper::influenceMask(polygon, {0, 0}, bad); }), "tricover: length: "));
    EXPECT_TRUE(names(refusal([&] { paper::boundedInfluenceArea(polygon, 0, bad); }), "length"));
  }
  EXPECT_THROW(paper::inInfluenceArea(polygon, 4, {0, 0}, 1, paper::InfluenceKind::Extended), std::out_of_range);
  EXPECT_THROW(paper::boundedInfluenceArea(polygon, 4, 1), std::out_of_range);
}

}  // namespace
}  // namespace tricover::support
