// SPDX-License-Identifier: BSD-3-Clause
// What isn't supported says so, by throwing; FCL would print a warning and answer "free". And FCL's own pairs go to
// FCL.
#include <limits>
#include <set>
#include <utility>

#include "mixed_scene.h"

namespace tricover_fcl::test {
namespace {

/// Of no type that FCL knows: BV_UNKNOWN.
class Unknown : public Body {
  void computeLocalAABB() override {}
};

/// One of each type.
std::vector<Geometry<double>> otherGeometries() {
  std::vector<Geometry<double>> all = {std::make_shared<fcl::TrianglePd>(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)),
                                       std::make_shared<Unknown>()};
  std::set<fcl::NODE_TYPE> types;
  for (const Known<double>& known : knownGeometries<double>())
    if (types.insert(known.geometry->getNodeType()).second) all.push_back(known.geometry);
  EXPECT_EQ(all.size(), std::size_t{fcl::NODE_COUNT});
  return all;
}

/// Asks every entry point about the pair; each must throw and name the operation, `name`, and what to do instead.
void expectRefusedEverywhere(const Body& a, const Body& b, const std::string& name) {
  const auto expect = [&name](const std::string& operation, const auto& query) {
    expectRefused<std::logic_error>({operation, name, "; make"}, query);
  };
  for (const fcl::GJKSolverType solver : kSolvers) {
    fcl::CollisionRequestd request;
    request.gjk_solver_type = solver;
    fcl::CollisionResultd result;
    expect("collide", [&] { fcl::collide(&a, kHere, &b, kHere, request, result); });
    expect("collide", [&] { tricover_fcl::collide(&a, kHere, &b, kHere, request, result); });
    EXPECT_FALSE(result.isCollision());
    expect("distance", [&] { distanceOf(solver, false, a, kHere, b, kHere); });
    Impact impact;
    expect("conservative advancement", [&] {
      fcl::continuousCollide(&a, kHere, kHere, &b, kHere, kHere, advancing(1e-4, fcl::CCDM_TRANS, solver), impact);
    });
  }
}

TEST(Unsupported, fclsOwnTriangleAndUnknownGeometriesInBothOrders) {
  const Shape<double> polygon = rectangular(0, 0, 1, 1);
  const auto others = otherGeometries();
  for (const auto& [other, name] : {std::pair(others[0], "fcl::TriangleP<double>"), {others[1], "Unknown"}}) {
    SCOPED_TRACE(name);
    expectRefusedEverywhere(*polygon, *other, name);
    expectRefusedEverywhere(*other, *polygon, name);
    expectRefusedEverywhere(*polygon, *other, "tricover_fcl::PolygonShape<double>");
  }
}

TEST(Unsupported, fclsOwnTriangleIsAnsweredAsByFcl) {
  const auto others = otherGeometries();
  const Body& triangle = *others[0];
  for (const auto& other : others) {
    SCOPED_TRACE(other->getNodeType());
    const auto expectWarning = [](const std::string& operation, const auto& query) {
      ::testing::internal::CaptureStderr();
      query();
      const std::string text = ::testing::internal::GetCapturedStderr();
      EXPECT_EQ(text.find("Warning: " + operation + " function between node type "), 0u) << text;
    };
    expectWarning("collision", [&] { EXPECT_FALSE(collides(triangle, kHere, other, kHere)); });
    expectWarning("distance", [&] {
      EXPECT_EQ(distanceOf(fcl::GST_LIBCCD, false, triangle, kHere, other, kHere).min_distance,
                std::numeric_limits<double>::max());
    });
    expectWarning("collision", [&] {
      Impact impact;
      fcl::continuousCollide<double>(&triangle, kHere, kHere, other.get(), kHere, kHere, advancing(1e-4), impact);
      EXPECT_FALSE(impact.is_collide);
    });
  }
}

template <typename S>
void expectFclsAnswers() {
  const fcl::Sphere<S> ball(1);
  const auto here = fcl::Transform3<S>::Identity(), near = lifted<S>(0, 1.5, 0), far = lifted<S>(0, 5, 0);
  for (const auto& there : {here, near, far}) {
    fcl::CollisionResult<S> result;
    EXPECT_EQ(tricover_fcl::collide<S>(&ball, here, &ball, there, fcl::CollisionRequest<S>(), result),
              std::size_t{there.translation().x() < 2});
    fcl::DistanceResult<S> distance;
    const S found = tricover_fcl::distance<S>(&ball, here, &ball, there, fcl::DistanceRequest<S>(), distance);
    EXPECT_NEAR(found, there.translation().x() < 2 ? -1 : 3, 1e-6);
  }
}

TEST(Unsupported, fclsOtherPairsAnswerAsBefore) {
  expectFclsAnswers<double>();
  expectFclsAnswers<float>();
  const auto ball = std::make_shared<fcl::Sphered>(1);
  const fcl::CollisionObjectd near(ball), far(ball, fcl::Matrix3d::Identity(), Vec3(5, 0, 0));
  fcl::CollisionResultd hit, miss, by_options;
  EXPECT_EQ(tricover_fcl::collide(&near, &near, fcl::CollisionRequestd(), hit), 1u);
  EXPECT_EQ(tricover_fcl::collide(&near, &far, fcl::CollisionRequestd(), miss), 0u);
  fcl::DistanceResultd distance;
  EXPECT_NEAR(tricover_fcl::distance(&near, &far, fcl::DistanceRequestd(), distance), 3, 1e-6);
  const Impact impact = impactOf(ball, lifted(0, -5, 0), lifted(0, 5, 0), ball, kHere, kHere,
                                 advancing(1e-9, fcl::CCDM_LINEAR));  // which asks tricover's function
  EXPECT_TRUE(impact.is_collide);
  EXPECT_NEAR(impact.time_of_contact, 0.3, 1e-2);
  EXPECT_THROW(
      tricover_fcl::collide<double>(ball.get(), kHere, ball.get(), kHere, {}, tricover::CollideOptions{}, by_options),
      std::logic_error);
  // The tables that replace libfcl's hold its rows, too.
  for (const double x : {1.4, 1.6}) {
    const fcl::Boxd box(1, 1, 1);
    EXPECT_EQ(collides(box, kHere, ball, shifted(x, 0, 0)), x < 1.5);
    EXPECT_NEAR(distanceOf(fcl::GST_LIBCCD, false, box, kHere, ball, shifted(x, 0, 0)).min_distance, x < 1.5 ? -1 : 0.1,
                1e-6);
  }
}

}  // namespace
}  // namespace tricover_fcl::test
