// SPDX-License-Identifier: BSD-3-Clause
#include <fcl/narrowphase/collision.h>

#include <cmath>
#include <limits>

#include "scene.h"

namespace tricover_fcl::test {
namespace {

constexpr double kPi = 3.14159265358979323846;
const Shape<double> kSquare = rectangular(0, 0, 1, 1);

bool collide(const fcl::Transform3d& tf1, const fcl::Transform3d& tf2) {
  fcl::CollisionResultd result;
  return fcl::collide(kSquare.get(), tf1, kSquare.get(), tf2, fcl::CollisionRequestd(), result) > 0;
}

std::string refusal(const fcl::Transform3d& tf1, const fcl::Transform3d& tf2) {
  return thrownBy<std::invalid_argument>([&] { collide(tf1, tf2); });
}

fcl::Transform3d turned(double angle, const fcl::Vector3d& axis) {
  return fcl::Transform3d(fcl::AngleAxis<double>(angle, axis.normalized()));
}

const fcl::Transform3d kIdentity = fcl::Transform3d::Identity();

TEST(PlanarPoses, heightIsComparedExactly) {
  EXPECT_TRUE(collide(lifted(tricover::Pose::Identity(), 0.1), lifted(tricover::Pose::Identity(), 0.1)));
  EXPECT_FALSE(collide(lifted(tricover::Pose::Identity(), 0.1), lifted(tricover::Pose::Identity(), 0.1 + 0x1p-56)));
  EXPECT_FALSE(collide(kIdentity, lifted(tricover::Pose::Identity(), 5e-324)));
  EXPECT_TRUE(collide(kIdentity, lifted(tricover::Pose::Identity(), -0.0)));
}

TEST(PlanarPoses, tiltIsRefusedByName) {
  const fcl::Transform3d tilted = turned(0.01, {1, 2, 0});
  EXPECT_EQ(refusal(tilted, kIdentity).find("tricover: pose_a: it leaves the plane"), 0u) << refusal(tilted, kIdentity);
  EXPECT_EQ(refusal(kIdentity, tilted).find("tricover: pose_b: it leaves the plane"), 0u) << refusal(kIdentity, tilted);
  EXPECT_NE(refusal(tilted, kIdentity).find("within 1e-6"), std::string::npos) << refusal(tilted, kIdentity);
  EXPECT_NE(refusal(turned(kPi / 2, {1, 0, 0}), kIdentity), "");
  EXPECT_NE(refusal(turned(2e-6, {0, 1, 0}), kIdentity), "");
}

TEST(PlanarPoses, tiltOfRoundingSizeIsNot) {
  EXPECT_TRUE(collide(turned(1e-7, {1, 2, 0}), kIdentity));
  EXPECT_TRUE(collide(turned(-9e-7, {0, 1, 0}), kIdentity));
}

/// A scale is not a tilt; nor is what floats leave of products of rotations refused.
TEST(PlanarPoses, scalesAreNamedByThemselves) {
  for (const double scale : {1e-3, 0.999, 1.001, 1000.0}) {
    fcl::Transform3d scaled = turned(1e-7, {1, 2, 3});
    scaled.linear() *= scale;
    const std::string text = refusal(scaled, kIdentity);
    EXPECT_EQ(text.find("tricover: pose_a: linear() is off rigid by "), 0u) << text;
    EXPECT_NE(text.find("more than 0.0001 (tricover::kRigidTolerance)"), std::string::npos) << text;
  }
  fcl::Transform3d tall = kIdentity;
  tall.matrix()(2, 2) = 2;
  EXPECT_EQ(refusal(kIdentity, tall).find("tricover: pose_b: linear() is off rigid by 3, "), 0u);
  fcl::Transform3d turned_and_scaled = turned(0.01, {1, 2, 0});
  turned_and_scaled.linear() *= 2;
  EXPECT_NE(refusal(kIdentity, turned_and_scaled).find("pose_b: it leaves the plane"), std::string::npos);
}

TEST(PlanarPoses, productsOfFloatQuaternionsAreNotRefused) {
  Random random(4);
  const fcl::Boxf box(1, 1, 1);
  const auto square = shapeOf<float>(tricover::Polygon({rectangle(0, 0, 1, 1)}));
  for (int i = 0; i < 20000; ++i) {
    fcl::Quaternionf product(1, 0, 0, 0);
    for (int k = 0; k < 4; ++k)
      product = product * fcl::Quaternionf(fcl::AngleAxis<float>(static_cast<float>(random.real(-3.15, 3.15)),
                                                                 fcl::Vector3f::UnitZ()));
    fcl::Transform3f pose = fcl::Transform3f::Identity();
    pose.linear() = product.toRotationMatrix();
    fcl::CollisionResultf result;
    ASSERT_NO_THROW(tricover_fcl::collide<float>(square.get(), pose, square.get(), pose, {}, result)) << i;
    ASSERT_NO_THROW(tricover_fcl::collide<float>(square.get(), pose, &box, pose, {}, result)) << i;
  }
}

TEST(PlanarPoses, halfTurnsAboutAnAxisInThePlaneMirror) {
  // About x: the square lies below the x axis.
  const fcl::Transform3d below = turned(kPi, {1, 0, 0});
  EXPECT_TRUE(collide(below, kIdentity));  // both hold the x axis, up to cos and sin of a rounded pi
  EXPECT_TRUE(collide(below, lifted(0, 0, -0.5)));
  EXPECT_FALSE(collide(below, lifted(0, 0, 0.5)));
  // A mirror that is no rotation of space is one in the plane all the same.
  EXPECT_FALSE(collide(lifted(mirrored(tricover::Pose::Identity())), lifted(0, 2, 2)));
}

TEST(PlanarPoses, whatIsNotRigidOrFiniteIsRefusedAtAnyHeight) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for (const double z : {0.0, 3.0}) {
    fcl::Transform3d scaled = lifted(tricover::Pose::Identity(), z);
    scaled.matrix()(0, 0) = 1.1;
    EXPECT_NE(refusal(scaled, kIdentity).find("pose_a"), std::string::npos) << refusal(scaled, kIdentity);
    EXPECT_NE(refusal(kIdentity, scaled).find("pose_b"), std::string::npos) << refusal(kIdentity, scaled);
    fcl::Transform3d far = lifted(tricover::Pose::Identity(), z);
    far.translation().x() = infinity;
    EXPECT_NE(refusal(kIdentity, far).find("pose_b"), std::string::npos) << refusal(kIdentity, far);
    fcl::Transform3d turned_nan = lifted(tricover::Pose::Identity(), z);
    turned_nan.matrix()(0, 1) = nan;
    EXPECT_NE(refusal(turned_nan, kIdentity).find("pose_a"), std::string::npos) << refusal(turned_nan, kIdentity);
  }
  for (const double z : {nan, infinity}) {
    const fcl::Transform3d nowhere = lifted(tricover::Pose::Identity(), z);
    EXPECT_EQ(refusal(nowhere, nowhere), "tricover: pose_a: translation(2) is not finite");
  }
}

TEST(PlanarPoses, anEntryThatIsNotFiniteIsNamed) {
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      fcl::Transform3d bad = kIdentity;
      bad.matrix()(row, column) = std::numeric_limits<double>::quiet_NaN();
      const std::string entry = column < 3 ? "linear(" + std::to_string(row) + ", " + std::to_string(column) + ")"
                                           : "translation(" + std::to_string(row) + ")";
      EXPECT_EQ(refusal(bad, kIdentity), "tricover: pose_a: " + entry + " is not finite");
      EXPECT_EQ(refusal(kIdentity, bad), "tricover: pose_b: " + entry + " is not finite");
    }
  }
}

}  // namespace
}  // namespace tricover_fcl::test
