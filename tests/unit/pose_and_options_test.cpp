// SPDX-License-Identifier: BSD-3-Clause
// What collide(), locate() and the influence areas refuse, what the text says, and that a refusal changes nothing.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include "pair/certificate.h"
#include "polygon/cache_access.h"
#include "random.h"
#include "refusal.h"
#include "shapes.h"
#include "strategies.h"
#include "tricover/collide.h"
#include "tricover/contacts.h"
#include "tricover/distance.h"
#include "tricover/least_distance.h"
#include "tricover/locate.h"
#include "tricover/paper.h"
#include "tricover/penetration.h"
#include "tricover/ray.h"
#include "tricover/scene.h"

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
  poses[7].linear() *= 1 + kRigidTolerance;
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

/// Options in braces keep their meaning.
TEST(Options, GrowOnlyAtTheirEnd) {
  const auto allowed = Touching::Allowed;
  const CollideOptions collide{1, 2, allowed};
  EXPECT_EQ(std::tuple(collide.margin, collide.tolerance, collide.touching), std::tuple(1, 2, allowed));
  const CrossingOptions crossing{1, allowed};
  EXPECT_EQ(std::tuple(crossing.margin, crossing.touching), std::tuple(1, allowed));
  const ContactOptions contact{1, 2, ContactDetail::Points, allowed};
  EXPECT_EQ(std::tuple(contact.margin, contact.most, contact.detail, contact.touching),
            std::tuple(1, 2u, ContactDetail::Points, allowed));
  const DistanceOptions distance{1, 2, 3};
  EXPECT_EQ(std::tuple(distance.margin, distance.relative_error, distance.absolute_error), std::tuple(1, 2, 3));
  const PenetrationOptions penetration{1, allowed};
  EXPECT_EQ(std::tuple(penetration.margin, penetration.touching), std::tuple(1, allowed));
  const ImpactOptions impact{1, 2, true};
  EXPECT_EQ(std::tuple(impact.margin, impact.time_error, impact.ignore_initial), std::tuple(1, 2, true));
  const LeastDistanceOptions least{1, 2};
  EXPECT_EQ(std::tuple(least.margin, least.absolute_error), std::tuple(1, 2));
  const BodyOptions body{1, 2, 3, allowed};
  EXPECT_EQ(std::tuple(body.margin, body.category, body.mask, body.touching), std::tuple(1, 2u, 3u, allowed));
  EXPECT_EQ(CoverOptions{1}.margin + RayOptions{1}.margin, 2);
}

TEST(Options, AreOfTheirEnumeration) {
  const Polygon polygon({rectangle(0, 0, 1, 1)});
  ContactOptions options;
  options.detail = static_cast<ContactDetail>(9);
  EXPECT_EQ(refusal([&] { contacts(polygon, Pose::Identity(), polygon, Pose::Identity(), options); }),
            "tricover: detail: not a ContactDetail");
}

/// A certificate that pays for any motion, of this pair in either order, of another one, or none.
TEST(PoseCheck, NamesThePoseWhateverACacheHolds) {
  const Polygon a({rectangle(0, 0, 1, 1)}), b({rectangle(0, 0, 1, 2)});
  const Pose here = Pose::Identity(), far = turnedAndMoved(0, 1e6, 0);
  PairCache of_pair, of_another;
  detail::remember(detail::contentsOf(of_pair).collision, detail::dataOf(a), here, detail::dataOf(b), far, false, 9e5);
  detail::remember(detail::contentsOf(of_another).collision, detail::dataOf(a), here, detail::dataOf(a), far, false,
                   9e5);
  ASSERT_FALSE(collide(a, here, b, far, of_pair));
  ASSERT_EQ(detail::contentsOf(of_pair).collision.uses, 1u);
  for (const PairCache& given : {of_pair, of_another, PairCache()}) {
    for (const Pose& bad : badPoses()) {
      PairCache cache = given;
      EXPECT_TRUE(names(refusal([&] { collide(a, here, b, bad, cache); }), "tricover: pose_b"));
      EXPECT_TRUE(names(refusal([&] { collide(b, far, a, bad, cache); }), "tricover: pose_b"));
      EXPECT_TRUE(names(refusal([&] { collide(a, bad, b, far, cache); }), "tricover: pose_a"));
      EXPECT_TRUE(names(refusal([&] { collide(b, bad, a, here, cache); }), "tricover: pose_a"));
      EXPECT_EQ(detail::contentsOf(cache).collision.uses, detail::contentsOf(given).collision.uses);
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
  const std::string start = "tricover: mine: linear() is off rigid by ",
                    end =
                        ", more than 0.0001 (tricover::kRigidTolerance); a pose only turns, mirrors and moves: "
                        "tricover::nearestRigid() drops the rest";
  EXPECT_EQ(refusalOf(large), start + "inf" + end);
  EXPECT_EQ(refusalOf(badPoses()[0]), start + "0.002" + end);
  EXPECT_EQ(refusalOf(badPoses()[6]), start + "1" + end);
}

TEST(PoseCheck, TakesRotationsMirrorsAndFloatRounding) {
  for (int i = 0; i < 100; ++i) {
    const Pose turned = turnedAndMoved(0.0628 * i, i, -i);
    EXPECT_NO_THROW(checkPose(turned));
    EXPECT_NO_THROW(checkPose(throughFloat(turned)));
    EXPECT_NO_THROW(checkPose(mirrored(throughFloat(turned))));
  }
  EXPECT_NO_THROW(checkPose(turnedAndMoved(0, 1e308, -1e308)));
}

/// The largest entry of R^T R - I.
double defectOf(const Pose& pose) {
  const Eigen::Matrix2d r = pose.linear();
  return (r.transpose() * r - Eigen::Matrix2d::Identity()).cwiseAbs().maxCoeff();
}

TEST(PoseCheck, TakesAllThatQuaternionsOfFloatMakeOfRotations) {
  Random random(20);
  const auto turn = [&] {
    return Eigen::Quaternionf(
        Eigen::AngleAxisf(static_cast<float>(random.real(-3.15, 3.15)), Eigen::Vector3f::UnitZ()));
  };
  int refused = 0, beyond_a_rounding = 0;
  for (int i = 0; i < 1000000; ++i) {
    const Eigen::Quaternionf product = turn() * turn() * turn() * turn();
    Pose pose = Pose::Identity();
    pose.linear() = product.toRotationMatrix().topLeftCorner<2, 2>().cast<double>();
    refused += !refusal([&] { checkPose(pose); }).empty();
    beyond_a_rounding += defectOf(pose) > 1e-6;
  }
  EXPECT_EQ(refused, 0);
  EXPECT_GE(beyond_a_rounding, 100) << "which were refused once";
}

/// A thousand times the same factor, whose own rounding adds up; or a hundred times as many different ones.
TEST(PoseCheck, TakesLongProductsOfFloats) {
  Random random(21);
  const auto factor = [&] {
    Eigen::Isometry2f pose = Eigen::Isometry2f::Identity();
    pose.rotate(static_cast<float>(random.real(-3.15, 3.15)));
    return pose;
  };
  double farthest = 0;
  for (int i = 0; i < 200; ++i) {
    const Eigen::Isometry2f same = factor();
    Eigen::Isometry2f repeated = same;
    for (int k = 1; k < 1000; ++k) repeated = repeated * same;
    farthest = std::max(farthest, defectOf(Pose(repeated.cast<double>())));
    EXPECT_NO_THROW(checkPose(Pose(repeated.cast<double>())));
  }
  EXPECT_GE(farthest, 2e-5);
  Eigen::Isometry2f product = factor();
  for (int k = 1; k < 100000; ++k) {
    product = product * factor();
    ASSERT_NO_THROW(checkPose(Pose(product.cast<double>()))) << k;
  }
}

/// By every entry of R^T R alone, a little inside and a little outside.
TEST(PoseCheck, HoldsAtItsLimit) {
  const auto stretched = [](double xx, double xy, double yy) {
    Pose result = turnedAndMoved(0.7, 1, 2);
    Eigen::Matrix2d root;  // the square root of I + (xx, xy; xy, yy), but for third powers
    root << xx / 2 - (xx * xx + xy * xy) / 8, xy / 2 - xy * (xx + yy) / 8, 0, yy / 2 - (yy * yy + xy * xy) / 8;
    root(1, 0) = root(0, 1);
    result.linear() = result.linear() * (Eigen::Matrix2d::Identity() + root);
    return result;
  };
  const double inside = kRigidTolerance * (1 - 1e-6), outside = kRigidTolerance * (1 + 1e-6);
  const Polygon square({rectangle(0, 0, 1, 1)});
  for (const double sign : {-1.0, 1.0})
    for (const Vec2& other : {Vec2(0, 0), Vec2(inside, inside), Vec2(-inside, inside)}) {
      const double in = sign * inside, out = sign * outside, x = other.x(), y = other.y();
      for (const Pose& good : {stretched(in, x, y), stretched(x, in, y), stretched(x, y, in)}) {
        EXPECT_NO_THROW(checkPose(good));
        EXPECT_NO_THROW(collide(square, good, square, mirrored(good)));
      }
      for (const Pose& bad : {stretched(out, x, y), stretched(x, out, y), stretched(x, y, out)}) {
        EXPECT_THROW(checkPose(bad), std::invalid_argument);
        EXPECT_THROW(collide(square, Pose::Identity(), square, mirrored(bad)), std::invalid_argument);
      }
    }
}

double distanceBetween(const Pose& p, const Pose& q) { return (p.linear() - q.linear()).norm(); }

TEST(NearestRigid, IsRigidToARoundingAndNoRigidMapIsNearer) {
  Random random(22);
  for (int i = 0; i < 2000; ++i) {
    Pose given = i % 2 ? randomPose(random, 3) : mirrored(randomPose(random, 3));
    const double size = std::ldexp(1, i % 3 ? 0 : random.integer(-400, 400));
    for (int k = 0; k < 4; ++k) given.linear()(k / 2, k % 2) += random.real(-0.3, 0.3);
    given.linear() *= size;
    const double det = (given.linear() / size).determinant();
    if (std::abs(det) < 0.01) continue;
    const Pose rigid = nearestRigid(given);
    EXPECT_LE(defectOf(rigid), 1e-15);
    EXPECT_EQ(rigid.linear().determinant() < 0, det < 0) << "mirrored stays mirrored";
    EXPECT_EQ(rigid.translation(), given.translation());
    Pose scaled = given;
    scaled.linear() /= size;
    const double least = distanceBetween(rigid, scaled);
    for (int k = 0; k < 20; ++k) {
      const double way = k % 2 ? random.real(-3.15, 3.15) : random.real(-1e-2, 1e-2);
      Pose other = rigid;
      other.linear() = Eigen::Rotation2Dd(way).toRotationMatrix() * rigid.linear();
      EXPECT_GE(distanceBetween(other, scaled), least - 1e-14);
    }
  }
}

TEST(NearestRigid, KeepsWhatIsRigidAndMendsWhatFloatsDrifted) {
  EXPECT_TRUE(nearestRigid(Pose::Identity()).isApprox(Pose::Identity(), 0));
  const Pose turned = mirrored(turnedAndMoved(2.5, 1e10, -4));
  EXPECT_LE(distanceBetween(nearestRigid(turned), turned), 1e-15);
  Eigen::Isometry2f product = Eigen::Isometry2f::Identity();
  for (int k = 0; k < 100000; ++k) product.rotate(0.01f);
  const Pose drifted(product.cast<double>());
  EXPECT_THROW(checkPose(drifted), std::invalid_argument);
  EXPECT_NO_THROW(checkPose(nearestRigid(drifted)));
}

TEST(NearestRigid, RefusesWhatIsNoPose) {
  Pose flat = Pose::Identity();
  flat.linear() << 1, 2, 3, 6;
  for (const Pose& bad : {flat, badPoses()[6], badPoses()[8]})
    EXPECT_EQ(refusal([&] { nearestRigid(bad, "mine"); }),
              "tricover: mine: linear() takes the plane to a line or a point; no rigid map is nearest to that");
  EXPECT_EQ(refusal([&] { nearestRigid(badPoses()[2]); }), "tricover: pose: linear(0, 0) is not finite");
  EXPECT_EQ(refusal([&] { nearestRigid(badPoses()[5]); }), "tricover: pose: translation(1) is not finite");
}

TEST(CollideOptions, NegativeOrNotFiniteLengthsAreRefusedByName) {
  const Polygon polygon({rectangle(0, 0, 1, 1)});
  for (const double bad : {-1.0, -5e-324, kNaN, kInfinity}) {
    for (const Strategy strategy : {Strategy::Hierarchy, Strategy::Paper}) {
      const auto ask = [&](const CollideOptions& options) {
        return refusal([&] { collide(strategy, polygon, Pose::Identity(), polygon, Pose::Identity(), options); });
      };
      // A negative margin is an overlap that is allowed, which the paper does not know.
      EXPECT_EQ(names(ask({bad}), "tricover: margin: "), !(bad < 0) || strategy == Strategy::Paper);
      EXPECT_TRUE(names(ask({0, bad}), "tricover: tolerance: "));
    }
  }
}

TEST(Refusal, LeavesTheCachesAsTheyWere) {
  const Polygon a({rectangle(0, 0, 1, 1)}), b({rectangle(0, 0, 1, 2)});
  for (const Strategy strategy : {Strategy::Hierarchy, Strategy::Paper}) {
    StrategyCaches caches;
    collide(strategy, a, Pose::Identity(), b, turnedAndMoved(0, 1.5, 0), caches);
    const StrategyCaches copy = caches;
    for (const Pose& bad : badPoses())
      EXPECT_THROW(collide(strategy, a, Pose::Identity(), b, bad, caches), std::invalid_argument);
    EXPECT_THROW(collide(strategy, b, Pose::Identity(), b, Pose::Identity(), caches, {kNaN}), std::invalid_argument);
    const detail::Certificate &cache = detail::contentsOf(caches.of_pair).collision,
                              &before = detail::contentsOf(copy.of_pair).collision;
    const auto told = [](const detail::Certificate& c) {
      return std::tuple(c.first_id, c.second_id, c.clearance, c.overlapping, c.uses);
    };
    EXPECT_EQ(told(cache), told(before));
    EXPECT_TRUE(std::equal(cache.first_pose, cache.first_pose + 6, before.first_pose));
    EXPECT_TRUE(std::equal(cache.second_pose, cache.second_pose + 6, before.second_pose));
    EXPECT_EQ(detail::contentsOf(caches.of_mask), detail::contentsOf(copy.of_mask));
  }
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

TEST(Options, ATouchingThatThereIsntIsRefused) {
  const Polygon square({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}});
  const Pose here = Pose::Identity();
  const auto none = static_cast<Touching>(7);
  const CollideOptions options{0, 0, none};
  PairCache cache;
  Scene scene;
  EXPECT_THROW(collide(square, here, square, here, options), std::invalid_argument);
  EXPECT_THROW(collide(square, here, square, here, cache, options), std::invalid_argument);
  EXPECT_THROW(scene.collides(square, here, options), std::invalid_argument);
  EXPECT_THROW(scene.add(square, here, {0, 1, kEveryCategory, none}), std::invalid_argument);
}

}  // namespace
}  // namespace tricover::support
