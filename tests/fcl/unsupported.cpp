// SPDX-License-Identifier: BSD-3-Clause
// What isn't supported says so, by throwing; FCL would print a warning and answer "free".
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/octree/octree.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/continuous_collision.h>
#include <fcl/narrowphase/distance.h>

#include <utility>

#include "scene.h"

namespace tricover_fcl::test {
namespace {

using Geometry = std::shared_ptr<fcl::CollisionGeometryd>;
using Named = std::pair<std::string, Geometry>;

const std::vector<fcl::Vector3d> kCorners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

template <typename BV>
Geometry mesh() {
  const auto model = std::make_shared<fcl::BVHModel<BV>>();
  model->beginModel();
  model->addSubModel(kCorners, {fcl::Triangle(0, 1, 2), fcl::Triangle(0, 1, 3)});
  model->endModel();
  return model;
}

/// Of no type that FCL knows: BV_UNKNOWN.
class Unknown : public fcl::CollisionGeometryd {
  void computeLocalAABB() override {}
};

std::shared_ptr<fcl::OcTree<double>> occupiedOctree() {
  const auto tree = std::make_shared<octomap::OcTree>(0.5);
  tree->updateNode(octomap::point3d(0.1f, 0.1f, 0), true);
  return std::make_shared<fcl::OcTree<double>>(std::shared_ptr<const octomap::OcTree>(tree));
}

std::vector<Named> otherGeometries() {
  const auto corners = std::make_shared<const std::vector<fcl::Vector3d>>(kCorners);
  const auto faces =
      std::make_shared<const std::vector<int>>(std::vector<int>{3, 0, 2, 1, 3, 0, 1, 3, 3, 0, 3, 2, 3, 1, 2, 3});
  return {{"GEOM_BOX", std::make_shared<fcl::Boxd>(1, 1, 1)},
          {"GEOM_SPHERE", std::make_shared<fcl::Sphered>(1)},
          {"GEOM_ELLIPSOID", std::make_shared<fcl::Ellipsoidd>(1, 2, 3)},
          {"GEOM_CAPSULE", std::make_shared<fcl::Capsuled>(1, 1)},
          {"GEOM_CONE", std::make_shared<fcl::Coned>(1, 1)},
          {"GEOM_CYLINDER", std::make_shared<fcl::Cylinderd>(1, 1)},
          {"GEOM_CONVEX", std::make_shared<fcl::Convexd>(corners, 4, faces)},
          {"GEOM_PLANE", std::make_shared<fcl::Planed>(fcl::Vector3d::UnitX(), 0)},
          {"GEOM_HALFSPACE", std::make_shared<fcl::Halfspaced>(fcl::Vector3d::UnitX(), 0)},
          {"GEOM_TRIANGLE", std::make_shared<fcl::TrianglePd>(kCorners[0], kCorners[1], kCorners[2])},
          {"BV_AABB", mesh<fcl::AABBd>()},
          {"BV_OBB", mesh<fcl::OBBd>()},
          {"BV_RSS", mesh<fcl::RSSd>()},
          {"BV_kIOS", mesh<fcl::kIOSd>()},
          {"BV_OBBRSS", mesh<fcl::OBBRSSd>()},
          {"BV_KDOP16", mesh<fcl::KDOP<double, 16>>()},
          {"BV_KDOP18", mesh<fcl::KDOP<double, 18>>()},
          {"BV_KDOP24", mesh<fcl::KDOP<double, 24>>()},
          {"GEOM_OCTREE", occupiedOctree()},
          {"BV_UNKNOWN", std::make_shared<Unknown>()}};
}

/// Asks every entry point about the pair; each must throw and name the operation and `name`.
void expectRefused(const fcl::CollisionGeometryd& a, const fcl::CollisionGeometryd& b, const std::string& name) {
  const fcl::Transform3d pose = fcl::Transform3d::Identity();
  const auto expectThrown = [&name](const std::string& operation, const auto& query) {
    const std::string text = thrownBy<std::logic_error>(query);
    EXPECT_NE(text.find(operation), std::string::npos) << operation << ": " << text;
    EXPECT_NE(text.find(name), std::string::npos) << operation << ": " << text;
    EXPECT_NE(text.find("; make"), std::string::npos) << "doesn't say what to do instead: " << text;
  };
  for (const fcl::GJKSolverType solver : {fcl::GST_LIBCCD, fcl::GST_INDEP}) {
    fcl::CollisionRequestd request;
    request.gjk_solver_type = solver;
    fcl::CollisionResultd result;
    expectThrown("collide", [&] { fcl::collide(&a, pose, &b, pose, request, result); });
    expectThrown("collide", [&] { tricover_fcl::collide(&a, pose, &b, pose, request, result); });
    EXPECT_FALSE(result.isCollision());
    fcl::DistanceRequestd distance_request;
    distance_request.gjk_solver_type = solver;
    fcl::DistanceResultd distance_result;
    expectThrown("distance", [&] { fcl::distance(&a, pose, &b, pose, distance_request, distance_result); });

    fcl::ContinuousCollisionRequestd continuous_request;
    continuous_request.ccd_solver_type = fcl::CCDC_CONSERVATIVE_ADVANCEMENT;
    continuous_request.gjk_solver_type = solver;
    fcl::ContinuousCollisionResultd continuous_result;
    expectThrown("conservative advancement", [&] {
      fcl::continuousCollide(&a, pose, pose, &b, pose, pose, continuous_request, continuous_result);
    });
  }
}

const Shape<double> kPolygon = rectangular(0, 0, 1, 1);

TEST(Unsupported, fclsOwnTriangleAndUnknownGeometriesInBothOrders) {
  const std::vector<Named> others = otherGeometries();
  EXPECT_EQ(others.size(), std::size_t{fcl::NODE_COUNT});
  for (const auto& [name, other] : others) {
    SCOPED_TRACE(name);
    if (name != "GEOM_TRIANGLE" && name != "BV_UNKNOWN") continue;
    const std::string class_name = name == "GEOM_TRIANGLE" ? "fcl::TriangleP<double>" : "Unknown";
    expectRefused(*kPolygon, *other, class_name);
    expectRefused(*other, *kPolygon, class_name);
    expectRefused(*kPolygon, *other, "tricover_fcl::PolygonShape<double>");
  }
}

TEST(Unsupported, fclsOwnTriangleIsAnsweredAsByFcl) {
  for (const auto& [name, other] : otherGeometries()) {
    SCOPED_TRACE(name);
    const fcl::TrianglePd triangle(kCorners[0], kCorners[1], kCorners[2]);
    fcl::CollisionResultd result;
    const fcl::Transform3d pose = fcl::Transform3d::Identity();
    ::testing::internal::CaptureStderr();
    EXPECT_EQ(fcl::collide<double>(&triangle, pose, other.get(), pose, fcl::CollisionRequestd(), result), 0u);
    EXPECT_EQ(::testing::internal::GetCapturedStderr().find("Warning: collision function between node type "), 0u);
    fcl::DistanceResultd distance;
    ::testing::internal::CaptureStderr();
    EXPECT_EQ(fcl::distance<double>(&triangle, pose, other.get(), pose, fcl::DistanceRequestd(), distance),
              std::numeric_limits<double>::max());
    EXPECT_EQ(::testing::internal::GetCapturedStderr().find("Warning: distance function between node type "), 0u);
    fcl::ContinuousCollisionRequestd advancing;
    advancing.ccd_solver_type = fcl::CCDC_CONSERVATIVE_ADVANCEMENT;
    fcl::ContinuousCollisionResultd passing;
    ::testing::internal::CaptureStderr();
    fcl::continuousCollide<double>(&triangle, pose, pose, other.get(), pose, pose, advancing, passing);
    EXPECT_FALSE(passing.is_collide);
    EXPECT_EQ(::testing::internal::GetCapturedStderr().find("Warning: collision function between node type "), 0u);
  }
}

TEST(Unsupported, fclsOtherPairsAnswerAsBefore) {
  // The tables that replace libfcl's hold its rows, too.
  const fcl::Boxd box(1, 1, 1);
  const fcl::Sphered sphere(1);
  fcl::Transform3d pose = fcl::Transform3d::Identity();
  for (const double x : {1.4, 1.6}) {
    pose.translation().x() = x;
    fcl::CollisionResultd result;
    EXPECT_EQ(fcl::collide(&box, fcl::Transform3d::Identity(), &sphere, pose, fcl::CollisionRequestd(), result),
              std::size_t{x < 1.5});
    fcl::DistanceResultd distance;
    const double answer =
        fcl::distance(&box, fcl::Transform3d::Identity(), &sphere, pose, fcl::DistanceRequestd(), distance);
    EXPECT_NEAR(answer, x < 1.5 ? -1 : 0.1, 1e-6);
  }
}

}  // namespace
}  // namespace tricover_fcl::test
