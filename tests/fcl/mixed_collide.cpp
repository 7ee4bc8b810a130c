// SPDX-License-Identifier: BSD-3-Clause
// A polygon against every geometry of FCL's own: a body meets a polygon in the polygon's plane.
#include <fcl/broadphase/default_broadphase_callbacks.h>

#include <limits>
#include <stdexcept>
#include <type_traits>

#include "managers.h"
#include "mixed_scene.h"

namespace tricover_fcl::test {
namespace {

using Vec3 = fcl::Vector3<double>;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

template <typename S>
class MixedCollide : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { registerNarrowphase(); }
  /// How near the answers are asked for: below, the poses' own rounding decides.
  static constexpr double kStep = std::is_same_v<S, float> ? 1e-5 : 1e-8;
};

using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(MixedCollide, Scalars);

TYPED_TEST(MixedCollide, endsWhereTheSectionEnds) {
  using S = TypeParam;
  for (const Known<S>& known : knownGeometries<S>()) {
    SCOPED_TRACE(known.name);
    for (const double step : {1.0, 1e-3, this->kStep}) {
      const auto at = [&](double x) { return placed<S>({x, 0, 0}, fcl::Matrix3<double>::Identity()); };
      EXPECT_FALSE(meet<S>(*tip<S>(), at(known.right + step), *known.geometry, known.pose)) << step;
      if (step < 0.1) {
        EXPECT_TRUE(meet<S>(*tip<S>(), at(known.right - step), *known.geometry, known.pose)) << step;
      }
    }
  }
}

TYPED_TEST(MixedCollide, isTheSameAnywhereInSpace) {
  using S = TypeParam;
  Random random(61);
  for (const Known<S>& known : knownGeometries<S>()) {
    SCOPED_TRACE(known.name);
    if (known.grazing && std::is_same_v<S, float>) continue;  // a float pose lifts it off the plane
    const Vec3 at(random.real(-9, 9), random.real(-9, 9), random.real(-9, 9));
    const fcl::Transform3d moved = placed<double>(at, turned(random.real(0, 6), at));
    for (const double side : {-1, 1}) {
      fcl::Transform3d local = fcl::Transform3d::Identity();
      local.translation().x() = known.right + side * 20 * this->kStep;
      const fcl::Transform3<S> tf_tip((moved * local).matrix().template cast<S>());
      const fcl::Transform3<S> tf_other(
          (moved * known.pose.matrix().template cast<double>()).matrix().template cast<S>());
      EXPECT_EQ(meet<S>(*tip<S>(), tf_tip, *known.geometry, tf_other), side < 0);
    }
  }
}

TYPED_TEST(MixedCollide, missesWhatDoesntReachThePlane) {
  using S = TypeParam;
  const Shape<S> large = shapeOf<S>(tricover::Polygon({rectangle(-50, -50, 50, 50)}));
  for (const Known<S>& known : knownGeometries<S>()) {
    SCOPED_TRACE(known.name);
    const fcl::NODE_TYPE type = known.geometry->getNodeType();
    if (type == fcl::GEOM_PLANE || type == fcl::GEOM_HALFSPACE) continue;  // no end
    EXPECT_TRUE(meet<S>(*large, placed<S>({0, 0, 0}, turned(0, Vec3::UnitX())), *known.geometry, known.pose));
    for (const double z : {60.0, -60.0}) {
      EXPECT_FALSE(meet<S>(*large, placed<S>({0, 0, z}, turned(0, Vec3::UnitX())), *known.geometry, known.pose));
    }
  }
}

/// Of identity poses: the square from -1 to 1 and `other`.
bool squareMeets(const fcl::CollisionGeometryd& other, const fcl::Transform3d& pose) {
  const Shape<double> square = rectangular(-1, -1, 1, 1);
  return meet<double>(*square, fcl::Transform3d::Identity(), other, pose);
}

TEST(MixedCollideWhere, containmentCountsOfSolidsAndNotOfSurfaces) {
  const Shape<double> small = rectangular(-0.1, -0.1, 0.1, 0.1);
  const fcl::Transform3d here = fcl::Transform3d::Identity();
  const fcl::Boxd box(1, 1, 1);
  const fcl::Sphered sphere(1);
  EXPECT_TRUE(meet<double>(*small, here, box, here));
  EXPECT_TRUE(meet<double>(*small, here, sphere, here));
  EXPECT_TRUE(meet<double>(*small, here, *tetrahedron<double>(1, 1, 1), here));
  EXPECT_FALSE(meet<double>(*small, here, *boxMesh<fcl::OBBRSSd>({0.5, 0.5, 0.5}), here));
  // The other way round a surface within the polygon meets it.
  EXPECT_TRUE(squareMeets(*boxMesh<fcl::OBBRSSd>({0.5, 0.5, 0.5}), here));
  EXPECT_TRUE(squareMeets(fcl::Sphered(0.1), here));
}

TEST(MixedCollideWhere, holesLetBodiesThrough) {
  const Shape<double> frame = shapeOf(tricover::Polygon({rectangle(-3, -3, 3, 3), rectangle(-1, -1, 1, 1)}));
  const fcl::Transform3d here = fcl::Transform3d::Identity();
  for (const double step : {1e-3, 1e-8}) {
    EXPECT_FALSE(meet<double>(*frame, here, fcl::Sphered(1 - step), here));
    EXPECT_TRUE(meet<double>(*frame, here, fcl::Sphered(1 + step), here));
    EXPECT_FALSE(meet<double>(*frame, here, fcl::Cylinderd(1 - step, 1), here));
    EXPECT_TRUE(meet<double>(*frame, here, fcl::Cylinderd(1 + step, 1), here));
    EXPECT_FALSE(meet<double>(*frame, here, fcl::Boxd(2 - step, 1, 1), here));
    EXPECT_TRUE(meet<double>(*frame, here, fcl::Boxd(2 + step, 1, 1), here));
  }
}

TEST(MixedCollideWhere, planesInOrParallelToThePolygon) {
  const fcl::Transform3d here = fcl::Transform3d::Identity();
  const fcl::Planed ground(0, 0, 1, 0);
  const fcl::Halfspaced below(0, 0, 1, 0), above(0, 0, -1, 0);
  for (const double z : {-1.0, -1e-9, 0.0, 1e-9, 1.0}) {
    EXPECT_EQ(squareMeets(ground, shifted<double>(0, 0, z)), z == 0) << z;
    EXPECT_EQ(squareMeets(below, shifted<double>(0, 0, z)), z >= 0) << z;
    EXPECT_EQ(squareMeets(above, shifted<double>(0, 0, z)), z <= 0) << z;
  }
  // Hardly tilted, the line of intersection is far away.
  const fcl::Matrix3<double> tilt = turned(1e-9, Vec3::UnitY());
  EXPECT_FALSE(squareMeets(ground, placed<double>({0, 0, 1e-8}, tilt)));
  EXPECT_TRUE(squareMeets(ground, placed<double>({0, 0, 1e-10}, tilt)));
  // Upright in any direction: a line through the corner.
  for (const double step : {1e-3, 1e-12}) {
    const double corner = std::sqrt(2.0);
    EXPECT_FALSE(squareMeets(fcl::Planed(1, 1, 0, std::sqrt(2.0) * corner + step), here));
    EXPECT_TRUE(squareMeets(fcl::Planed(1, 1, 0, std::sqrt(2.0) * corner - step), here));
    EXPECT_TRUE(squareMeets(fcl::Planed(1, 1, 0, step - std::sqrt(2.0) * corner), here));
  }
}

TEST(MixedCollideWhere, atAllHeightsWhatLeansIsMetAnywhere) {
  registerNarrowphase();
  const PolygonShaped square(tricover::Polygon({rectangle(-1, -1, 1, 1)}), PolygonOptions::atAllHeights());
  const auto meets = [&](const fcl::CollisionGeometryd& other, double x) {
    fcl::CollisionResultd result;
    const fcl::Transform3d here = fcl::Transform3d::Identity();
    return fcl::collide(&square, shifted<double>(x, 0, 0), &other, here, fcl::CollisionRequestd(), result) > 0;
  };
  for (const double lean : {-1.0, -1e-3, 1e-3, 1.0}) {
    for (const double x : {-1e6, 0.0, 1e6}) {
      EXPECT_TRUE(meets(fcl::Halfspaced(1, 0, lean, 0), x)) << lean << " " << x;
      EXPECT_TRUE(meets(fcl::Planed(1, 0, lean, 0), x)) << lean << " " << x;
    }
  }
  EXPECT_TRUE(meets(fcl::Halfspaced(1, 0, 0, 0), 0.5));
  EXPECT_FALSE(meets(fcl::Halfspaced(1, 0, 0, 0), 2));
  EXPECT_FALSE(meets(fcl::Planed(1, 0, 0, 0), 2));
}

/// The edge from below the plane to its right is the last one of either face that has it.
TEST(MixedCollideWhere, edgesThatCloseFacesAreCut) {
  using Corners = std::vector<Vec3>;
  const auto corners = std::make_shared<const Corners>(Corners{{0, 0, -1}, {1, 0, 1}, {-1, 1, 1}, {-1, -1, 1}});
  const auto faces =
      std::make_shared<const std::vector<int>>(std::vector<int>{3, 1, 2, 0, 3, 0, 3, 1, 3, 0, 2, 3, 3, 1, 3, 2});
  const fcl::Convexd pyramid(corners, 4, faces);
  EXPECT_TRUE(
      squareMeets(pyramid, shifted<double>(-1.5 + 1e-9, 0, 0)));  // its corner is at x = 0.5, the square's at -1
  EXPECT_FALSE(squareMeets(pyramid, shifted<double>(-1.5 - 1e-9, 0, 0)));
}

TEST(MixedCollideWhere, touchingCountsAndRoundingNeverPartsWhatTouches) {
  const fcl::Transform3d here = fcl::Transform3d::Identity();
  for (const double size : {1e-300, 1e-150, 1.0, 1e150, 1e300}) {
    SCOPED_TRACE(size);
    const Shape<double> square = rectangular(-size, -size, size, size);
    const auto at = [size](double x) { return shifted<double>(x * size, 0, 0); };
    const fcl::Boxd box(size, size, size);
    const fcl::Sphered sphere(size);
    const fcl::Cylinderd cylinder(size, size);
    EXPECT_TRUE(meet<double>(*square, here, box, at(1.5)));
    EXPECT_FALSE(meet<double>(*square, here, box, at(1.5 + 1e-8)));
    EXPECT_TRUE(meet<double>(*square, here, sphere, at(2)));
    EXPECT_FALSE(meet<double>(*square, here, sphere, at(2 + 1e-8)));
    EXPECT_TRUE(meet<double>(*square, here, cylinder, at(2)));
    EXPECT_FALSE(meet<double>(*square, here, cylinder, at(2 + 1e-8)));
    EXPECT_TRUE(meet<double>(*square, here, *boxMesh<fcl::AABBd>({size, size, size}), at(2)));
    EXPECT_FALSE(meet<double>(*square, here, *boxMesh<fcl::AABBd>({size, size, size}), at(2 + 1e-8)));
    EXPECT_TRUE(meet<double>(*square, here, fcl::Halfspaced(1, 0, 0, -size), here));
    EXPECT_FALSE(meet<double>(*square, here, fcl::Halfspaced(1, 0, 0, -size * (1 + 1e-8)), here));
  }
  // Far from the world's origin, with poses that are exact there.
  const Shape<double> square = rectangular(-1, -1, 1, 1);
  for (const double place : {1e6, 1e12, 1e15}) {
    EXPECT_TRUE(meet<double>(*square, shifted<double>(place, place, place), fcl::Sphered(2),
                             shifted<double>(place + 3, place, place)));
    EXPECT_FALSE(meet<double>(*square, shifted<double>(place, place, place), fcl::Sphered(1.75),
                              shifted<double>(place + 3, place, place)));
  }
}

TEST(MixedCollideWhere, randomTouchesOfTurnedBoxesAreHits) {
  // A corner of the box is put on the polygon's edge, as far as doubles can: answers are hits, and misses from 1e-12
  // on.
  Random random(62);
  const Shape<double> square = rectangular(-1, -1, 1, 1);
  const fcl::Boxd box(1, 2, 3);
  for (int i = 0; i < 300; ++i) {
    const Vec3 axis(random.real(-1, 1), random.real(-1, 1), random.real(-1, 1));
    const fcl::Matrix3<double> rotation = turned(random.real(0, 6), axis);
    // In the plane z = 0 the box reaches farthest to the left in a point of an edge or corner: find it by cutting.
    double left = std::numeric_limits<double>::infinity();
    const Vec3 center(0, 0, random.real(-0.49, 0.49));  // it reaches the plane
    for (int p = 0; p < 8; ++p) {
      for (int q = p + 1; q < 8; ++q) {
        const auto corner = [&](int c) {
          return Vec3(center + rotation * Vec3(c & 1 ? 0.5 : -0.5, c & 2 ? 1 : -1, c & 4 ? 1.5 : -1.5));
        };
        const Vec3 v = corner(p), w = corner(q);
        if ((v.z() < 0) == (w.z() < 0)) continue;
        left = std::min(left, v.x() + v.z() / (v.z() - w.z()) * (w.x() - v.x()));
      }
    }
    for (const double step : {-1e-6, -1e-12, 0.0, 1e-12, 1e-6}) {
      const fcl::Transform3d pose = placed<double>(center + Vec3(1 - left + step, 0, 0), rotation);
      const Shape<double> wall = rectangular(-1, -9, 1, 9);
      EXPECT_EQ(meet<double>(*wall, fcl::Transform3d::Identity(), box, pose), step <= 0) << i << " " << step;
    }
  }
}

TEST(MixedCollideWhere, posesAreChecked) {
  const Shape<double> square = rectangular(-1, -1, 1, 1);
  const fcl::Boxd box(1, 1, 1);
  fcl::Transform3d scaled = fcl::Transform3d::Identity(), infinite = scaled, nan = scaled;
  scaled.linear() *= 1.1;
  infinite.translation().z() = std::numeric_limits<double>::infinity();
  nan.linear()(1, 2) = kNaN;
  fcl::CollisionResultd result;
  for (const fcl::Transform3d& bad : {scaled, infinite, nan}) {
    const auto text = [&](const fcl::Transform3d& first, const fcl::Transform3d& second) {
      return thrownBy<std::invalid_argument>(
          [&] { fcl::collide(square.get(), first, &box, second, fcl::CollisionRequestd(), result); });
    };
    EXPECT_NE(text(bad, fcl::Transform3d::Identity()).find("pose_a"), std::string::npos);
    EXPECT_NE(text(fcl::Transform3d::Identity(), bad).find("pose_b"), std::string::npos);
    const bool finite = bad.matrix().allFinite();
    EXPECT_NE(text(bad, fcl::Transform3d::Identity()).find(finite ? "linear() is off rigid by " : ") is not finite"),
              std::string::npos)
        << text(bad, fcl::Transform3d::Identity());
  }
  fcl::BVHModel<fcl::OBBd> empty;
  EXPECT_NE(thrownBy<std::invalid_argument>([&] { squareMeets(empty, fcl::Transform3d::Identity()); }).find("mesh"),
            std::string::npos);
}

TEST(MixedCollideWhere, geometriesThatAreNotFiniteAreRefusedByVertex) {
  registerNarrowphase();
  const auto refusal = [](const fcl::CollisionGeometryd& geometry) {
    return thrownBy<std::invalid_argument>([&] { squareMeets(geometry, fcl::Transform3d::Identity()); });
  };
  const auto expectNamed = [&](const fcl::CollisionGeometryd& geometry, const std::string& name) {
    EXPECT_EQ(refusal(geometry).find("tricover: " + name), 0u) << name << ": " << refusal(geometry);
    EXPECT_NE(refusal(geometry).find("not finite"), std::string::npos) << refusal(geometry);
  };
  for (const double bad : {kNaN, std::numeric_limits<double>::infinity()}) {
    expectNamed(fcl::Boxd(1, bad, 1), "fcl::Box: vertex 0: ");
    for (const int vertex : {0, 2}) {
      auto corners =
          std::make_shared<std::vector<Vec3>>(std::vector<Vec3>{{0, 0, -1}, {1, 0, -1}, {0, 1, -1}, {0, 0, 1}});
      (*corners)[static_cast<std::size_t>(vertex)].y() = bad;
      const auto faces =
          std::make_shared<const std::vector<int>>(std::vector<int>{3, 0, 2, 1, 3, 0, 1, 3, 3, 0, 3, 2, 3, 1, 2, 3});
      expectNamed(fcl::Convexd(corners, 4, faces), "fcl::Convex: vertex " + std::to_string(vertex) + ": ");
      fcl::BVHModel<fcl::AABBd> mesh;
      mesh.beginModel();
      mesh.addTriangle((*corners)[0], (*corners)[1], (*corners)[2]);
      mesh.endModel();
      expectNamed(mesh, "fcl::BVHModel: vertex " + std::to_string(vertex) + ": ");
    }
    fcl::Planed plane(Vec3::UnitX(), 0);
    plane.d = bad;
    expectNamed(plane, "fcl::Plane: ");
    fcl::Halfspaced halfspace(Vec3::UnitX(), 0);
    halfspace.n.y() = bad;
    expectNamed(halfspace, "fcl::Halfspace: ");
    expectNamed(fcl::Sphered(bad), "fcl::Sphere<double>: ");
    expectNamed(fcl::Ellipsoidd(1, bad, 1), "fcl::Ellipsoid<double>: ");
    expectNamed(fcl::Capsuled(1, bad), "fcl::Capsule<double>: ");
    expectNamed(fcl::Coned(1, bad), "fcl::Cone<double>: ");
    expectNamed(fcl::Cylinderd(bad, 1), "fcl::Cylinder<double>: ");
  }
}

TEST(MixedCollideOctree, onlyOccupiedCellsAreThere) {
  const auto tree = octree<double>();
  EXPECT_TRUE(squareMeets(*tree, shifted<double>(-1.25, -1.25, -0.25)));
  EXPECT_TRUE(squareMeets(*tree, shifted<double>(2.75, 2.75, -0.25)));
  EXPECT_FALSE(squareMeets(*tree, shifted<double>(-4, -1.25, -0.25)));  // unknown
  EXPECT_FALSE(
      squareMeets(*tree, shifted<double>(-2.6, 0.2, -0.25)));  // free, and the occupied cell left of the square
  EXPECT_FALSE(squareMeets(*tree, shifted<double>(-1.25, -1.25, 0.25)));  // below
  const fcl::OcTree<double> nothing(0.1);
  EXPECT_FALSE(squareMeets(nothing, shifted<double>(0, 0, 0)));
}

TEST(MixedCollideOctree, worksUnderTheBroadphase) {
  // FCL hands the callback boxes of its own for the tree's cells.
  for (const auto& [name, manager] : managersOfEveryKind()) {
    SCOPED_TRACE(name);
    std::vector<std::unique_ptr<fcl::CollisionObjectd>> polygons;
    std::vector<fcl::CollisionObjectd*> pointers;
    for (const double x : {-10.0, -2.9, 1.25, 2.2}) {
      const Shape<double> small = rectangular(-0.2, -0.2, 0.2, 0.2);
      polygons.push_back(std::make_unique<fcl::CollisionObjectd>(small, shifted<double>(x, x, 0.25)));
      pointers.push_back(polygons.back().get());
    }
    manager->registerObjects(pointers);
    manager->setup();
    fcl::CollisionObjectd tree(octree<double>());
    for (const double z : {0.0, 1.0}) {
      tree.setTranslation({0, 0, z});
      tree.computeAABB();
      for (const auto callback : {fcl::DefaultCollisionFunction<double>, defaultCollisionFunction<double>}) {
        fcl::DefaultCollisionData<double> data;
        data.request.num_max_contacts = 100;
        manager->collide(&tree, &data, callback);
        EXPECT_EQ(data.result.numContacts(), z == 0 ? 2u : 0u);
      }
    }
  }
}

}  // namespace
}  // namespace tricover_fcl::test
