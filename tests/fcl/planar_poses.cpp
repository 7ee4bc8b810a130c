// SPDX-License-Identifier: BSD-3-Clause
// Which poses queries take: what the plane's tolerance lets through, and how a pose that isn't taken is named.
#include <cmath>

#include "mixed_scene.h"
#include "tricover/polygon.h"

namespace tricover_fcl::test {
namespace {

const Shape<double> kSquare = rectangular(0, 0, 1, 1);

bool squaresMeet(const Transform& tf1, const Transform& tf2) { return collides(kSquare, tf1, kSquare, tf2); }

std::string refusal(const Transform& tf1, const Transform& tf2) {
  return thrownBy([&] { squaresMeet(tf1, tf2); });
}

Transform rotated(double angle, const Vec3& axis) { return placed({0, 0, 0}, turned(angle, axis)); }

TEST(PlanarPoses, heightIsComparedExactly) {
  const auto at = [](double z) { return lifted(0, 0, 0, z); };
  EXPECT_TRUE(squaresMeet(at(0.1), at(0.1)));
  EXPECT_FALSE(squaresMeet(at(0.1), at(0.1 + 0x1p-56)));
  EXPECT_FALSE(squaresMeet(kHere, at(5e-324)));
  EXPECT_TRUE(squaresMeet(kHere, at(-0.0)));
}

TEST(PlanarPoses, tiltAndHeightAreRefusedByName) {
  for (const double z : {kNaN, kInfinity}) {
    const Transform nowhere = lifted(0, 0, 0, z);
    EXPECT_EQ(refusal(nowhere, nowhere), "tricover: pose_a: translation(2) is not finite");
  }
  const Transform tilted = rotated(0.01, {1, 2, 0});
  EXPECT_EQ(refusal(tilted, kHere).find("tricover: pose_a: it leaves the plane"), 0u) << refusal(tilted, kHere);
  EXPECT_EQ(refusal(kHere, tilted).find("tricover: pose_b: it leaves the plane"), 0u) << refusal(kHere, tilted);
  EXPECT_NE(refusal(tilted, kHere).find("within 1e-6"), std::string::npos) << refusal(tilted, kHere);
  EXPECT_NE(refusal(rotated(M_PI / 2, {1, 0, 0}), kHere), "");
  EXPECT_NE(refusal(rotated(2e-6, {0, 1, 0}), kHere), "");
  // That of rounding size is not.
  EXPECT_TRUE(squaresMeet(rotated(1e-7, {1, 2, 0}), kHere));
  EXPECT_TRUE(squaresMeet(rotated(-9e-7, {0, 1, 0}), kHere));
}

/// A scale is not a tilt; nor is what floats leave of products of rotations refused.
TEST(PlanarPoses, scalesAreNamedByThemselves) {
  for (const double scale : {1e-3, 0.999, 1.001, 1000.0}) {
    Transform scaled = rotated(1e-7, {1, 2, 3});
    scaled.linear() *= scale;
    const std::string text = refusal(scaled, kHere);
    EXPECT_EQ(text.find("tricover: pose_a: linear() is off rigid by "), 0u) << text;
    EXPECT_NE(text.find("more than 0.0001 (tricover::kRigidTolerance)"), std::string::npos) << text;
  }
  Transform tall = kHere;
  tall.matrix()(2, 2) = 2;
  EXPECT_EQ(refusal(kHere, tall).find("tricover: pose_b: linear() is off rigid by 3, "), 0u);
  Transform turned_and_scaled = rotated(0.01, {1, 2, 0});
  turned_and_scaled.linear() *= 2;
  EXPECT_NE(refusal(kHere, turned_and_scaled).find("pose_b: it leaves the plane"), std::string::npos);
}

TEST(PlanarPoses, productsOfFloatQuaternionsAreNotRefused) {
  Random random(4);
  const fcl::Boxf box(1, 1, 1);
  const Shape<float> square = rectangular<float>(0, 0, 1, 1);
  for (int i = 0; i < 20000; ++i) {
    fcl::Quaternionf product(1, 0, 0, 0);
    for (int k = 0; k < 4; ++k)
      product = product * fcl::Quaternionf(fcl::AngleAxis<float>(static_cast<float>(random.real(-3.15, 3.15)),
                                                                 fcl::Vector3f::UnitZ()));
    fcl::Transform3f pose = fcl::Transform3f::Identity();
    pose.linear() = product.toRotationMatrix();
    ASSERT_NO_THROW(collides(square, pose, square, pose)) << i;
    ASSERT_NO_THROW(collides(square, pose, box, pose)) << i;
  }
}

TEST(PlanarPoses, halfTurnsAboutAnAxisInThePlaneMirror) {
  // About x: the square lies below the x axis.
  const Transform below = rotated(M_PI, {1, 0, 0});
  EXPECT_TRUE(squaresMeet(below, kHere));  // both hold the x axis, up to cos and sin of a rounded pi
  EXPECT_TRUE(squaresMeet(below, lifted(0, 0, -0.5)));
  EXPECT_FALSE(squaresMeet(below, lifted(0, 0, 0.5)));
  // A mirror that is no rotation of space is one in the plane all the same.
  EXPECT_FALSE(squaresMeet(lifted(mirrored(Pose::Identity())), lifted(0, 2, 2)));
}

/// Of any kernel, of either of the two in either order, by collide and distance, however far apart: discs, level balls
/// and prisms are placed without a look at their whole poses.
TEST(PlanarPoses, areCheckedEntryByEntryAndNamed) {
  struct Pair {
    const char* what;
    Geometry<double> a, b;
    bool is_planar;  ///< of polygons, which may tilt by kTilt
  };
  constexpr double kTilt = 1e-6;
  const Shape<double> disc = shapeOf(tricover::Polygon::point({0, 0}), {1, -1, 1}),
                      prism = rectangular(-1, -1, 1, 1, {0, -1, 1});
  const Pair pairs[] = {{"squares", kSquare, kSquare, true},
                        {"discs", disc, disc, true},
                        {"prism and ball", prism, std::make_shared<fcl::Sphered>(1), false},
                        {"square and box", kSquare, std::make_shared<fcl::Boxd>(1, 1, 1), false}};
  for (const Pair& pair : pairs) {
    for (const bool is_other : {false, true}) {
      for (const double z : {0.0, 3.0, 100.0}) {
        SCOPED_TRACE(testing::Message() << pair.what << is_other << ", " << z);
        const Geometry<double>&bad_one = is_other ? pair.b : pair.a, &good_one = is_other ? pair.a : pair.b;
        const Transform good = lifted(1, 5, 0, z);
        /// How many of the four name it, and say this.
        const auto refusals = [&](const Transform& bad, const std::string& reason) {
          int named = 0;
          const auto ask = [&](const char* name, const auto& query) {
            const std::string text = thrownBy(query);
            named += text.find(name) != std::string::npos && text.find(reason) != std::string::npos;
          };
          ask("pose_a: ", [&] { collides(bad_one, bad, good_one, good); });
          ask("pose_b: ", [&] { collides(good_one, good, bad_one, bad); });
          ask("pose_a: ", [&] { distanceOf(fcl::GST_LIBCCD, false, bad_one, bad, good_one, good); });
          ask("pose_b: ", [&] { distanceOf(fcl::GST_LIBCCD, false, good_one, good, bad_one, bad); });
          return named;
        };
        for (int row = 0; row < 3; ++row) {
          for (int column = 0; column < 4; ++column) {
            const auto with = [&](double off) {
              Transform bad = kHere;
              bad.matrix()(row, column) += off;
              return bad;
            };
            const std::string entry = column < 3 ? "linear(" + std::to_string(row) + ", " + std::to_string(column) + ")"
                                                 : "translation(" + std::to_string(row) + ")";
            for (const double bad : {kNaN, kInfinity}) EXPECT_EQ(refusals(with(bad), entry + " is not finite"), 4);
            if (column == 3) continue;
            const bool tilts = pair.is_planar && (row == 2) != (column == 2);
            const double limit = tilts ? kTilt : tricover::kRigidTolerance;
            for (const double off : {1.1 * limit, 3 * limit, 0.5})
              EXPECT_EQ(refusals(with(off), pair.is_planar ? "" : "linear() is off rigid by "), 4) << entry << off;
            EXPECT_EQ(refusals(with(0.3 * limit), ""), 0) << entry;
          }
        }
        Transform all = kHere;
        all.matrix().block<1, 2>(2, 0).setConstant(9e-7);
        all.matrix().block<2, 1>(0, 2).setConstant(-9e-7);
        EXPECT_EQ(refusals(all, ""), 0);
      }
    }
  }
}

}  // namespace
}  // namespace tricover_fcl::test
