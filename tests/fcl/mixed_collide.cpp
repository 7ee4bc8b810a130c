// SPDX-License-Identifier: BSD-3-Clause
// Where a polygon meets FCL's geometries, beyond the table of mixed.cpp: at edges that matter to one kind of them.
#include <cmath>
#include <string>

#include "mixed_scene.h"

namespace tricover_fcl::test {
namespace {

const Shape<double> kSquare = rectangular(-1, -1, 1, 1);

template <typename Other>
bool squareMeets(const Other& other, const Transform& pose) {
  return meet(kSquare, kHere, other, pose);
}

/// They meet where the other one is at one pose, and don't where it is at the other pose.
template <typename Other>
void expectEnd(const char* what, const Shape<double>& shape, const Other& other, const Transform& meets,
               const Transform& misses) {
  EXPECT_TRUE(meet(shape, kHere, other, meets)) << what;
  EXPECT_FALSE(meet(shape, kHere, other, misses)) << what;
}

TEST(MixedCollide, containmentCountsOfSolidsAndNotOfSurfaces) {
  const Shape<double> small = rectangular(-0.1, -0.1, 0.1, 0.1);
  const auto mesh = boxMesh<fcl::OBBRSSd>({0.5, 0.5, 0.5});
  EXPECT_TRUE(meet(small, kHere, fcl::Boxd(1, 1, 1), kHere));
  EXPECT_TRUE(meet(small, kHere, fcl::Sphered(1), kHere));
  EXPECT_TRUE(meet(small, kHere, tetrahedron<double>(1, 1, 1), kHere));
  EXPECT_FALSE(meet(small, kHere, mesh, kHere));
  // The other way round a surface within the polygon meets it.
  EXPECT_TRUE(squareMeets(mesh, kHere));
  EXPECT_TRUE(squareMeets(fcl::Sphered(0.1), kHere));

  const Shape<double> frame = shapeOf(Polygon({rectangle(-3, -3, 3, 3), rectangle(-1, -1, 1, 1)}));
  for (const double step : {1e-3, 1e-8, -1e-3, -1e-8}) {  // holes let bodies through
    EXPECT_EQ(meet(frame, kHere, fcl::Sphered(1 + step), kHere), step > 0);
    EXPECT_EQ(meet(frame, kHere, fcl::Cylinderd(1 + step, 1), kHere), step > 0);
    EXPECT_EQ(meet(frame, kHere, fcl::Boxd(2 + step, 1, 1), kHere), step > 0);
  }
}

TEST(MixedCollide, planesInOrParallelToThePolygon) {
  const fcl::Planed ground(0, 0, 1, 0);
  for (const double z : {-1.0, -1e-9, 0.0, 1e-9, 1.0}) {
    EXPECT_EQ(squareMeets(ground, shifted(0, 0, z)), z == 0) << z;
    EXPECT_EQ(squareMeets(fcl::Halfspaced(0, 0, 1, 0), shifted(0, 0, z)), z >= 0) << z;
    EXPECT_EQ(squareMeets(fcl::Halfspaced(0, 0, -1, 0), shifted(0, 0, z)), z <= 0) << z;
  }
  const auto tilt = turned(1e-9, Vec3::UnitY());
  expectEnd("the line of intersection is far away", kSquare, ground, placed({0, 0, 1e-10}, tilt),
            placed({0, 0, 1e-8}, tilt));
  for (const double step : {1e-3, 1e-12}) {  // upright, a line through the corner
    const double corner = std::sqrt(2.0) * std::sqrt(2.0);
    EXPECT_FALSE(squareMeets(fcl::Planed(1, 1, 0, corner + step), kHere));
    EXPECT_TRUE(squareMeets(fcl::Planed(1, 1, 0, corner - step), kHere));
    EXPECT_TRUE(squareMeets(fcl::Planed(1, 1, 0, step - corner), kHere));
  }
  // At all heights what leans is met anywhere.
  const Shape<double> high = shapeOf(kSquare->polygon(), PolygonOptions::atAllHeights());
  for (const double lean : {-1.0, -1e-3, 1e-3, 1.0}) {
    for (const double x : {-1e6, 0.0, 1e6}) {
      EXPECT_TRUE(meet(high, shifted(x, 0, 0), fcl::Halfspaced(1, 0, lean, 0), kHere)) << lean << " " << x;
      EXPECT_TRUE(meet(high, shifted(x, 0, 0), fcl::Planed(1, 0, lean, 0), kHere)) << lean << " " << x;
    }
  }
  expectEnd("upright", high, fcl::Halfspaced(1, 0, 0, 0), shifted(-0.5, 0, 0), shifted(-2, 0, 0));
  EXPECT_FALSE(meet(high, shifted(2, 0, 0), fcl::Planed(1, 0, 0, 0), kHere));
}

TEST(MixedCollide, touchingCountsAndRoundingNeverPartsWhatTouches) {
  for (const double size : {1e-300, 1e-150, 1.0, 1e150, 1e300}) {
    SCOPED_TRACE(size);
    const Shape<double> square = rectangular(-size, -size, size, size);
    const auto at = [size](double x) { return shifted(x * size, 0, 0); };
    expectEnd("box", square, fcl::Boxd(size, size, size), at(1.5), at(1.5 + 1e-8));
    expectEnd("sphere", square, fcl::Sphered(size), at(2), at(2 + 1e-8));
    expectEnd("cylinder", square, fcl::Cylinderd(size, size), at(2), at(2 + 1e-8));
    expectEnd("mesh", square, boxMesh<fcl::AABBd>({size, size, size}), at(2), at(2 + 1e-8));
    EXPECT_TRUE(meet(square, kHere, fcl::Halfspaced(1, 0, 0, -size), kHere));
    EXPECT_FALSE(meet(square, kHere, fcl::Halfspaced(1, 0, 0, -size * (1 + 1e-8)), kHere));
  }
  // Far from the world's origin, with poses that are exact there.
  for (const double place : {1e6, 1e12, 1e15}) {
    for (const double radius : {2.0, 1.75}) {
      const Transform there = shifted(place + 3, place, place);
      EXPECT_EQ(meet(kSquare, shifted(place, place, place), fcl::Sphered(radius), there), radius == 2);
    }
  }
  // The polygon's point that is nearest to the middle of a tiny cylinder's shadow rounds to that, without being it: no
  // way leads there.
  const Shape<double> needle = shapeOf(Polygon({{{-0x1.7926829de359p-1, 0x1.4a02014a2183bp-1},
                                                 {0x1.f6de037d2f216p-3, -0x1.b802ac62d75a4p-3},
                                                 {0x1.f6de037d2f216p-1, -0x1.b802ac62d75a4p-1}}}),
                                       PolygonOptions::atAllHeights());
  const fcl::Cylinderd cylinder(0x1.13cae9b42da9p-35, 0x1.df71f2447fd87p-35);
  Transform there = kHere, leaning = kHere;
  there.linear().topLeftCorner<2, 2>() << -0x1.d8868afea61bep-1, -0x1.8a46ec4aed5acp-2, -0x1.8a46ec4aed5acp-2,
      0x1.d8868afea61bep-1;
  there.linear()(2, 2) = -1;
  leaning.linear() << 0x1.f9609f900737ep-1, 0x1.47154aa3b3825p-3, 0x1.c9e246808e1cdp-7, -0x1.45270f06d177dp-3,
      0x1.f8c61c5f90922p-1, -0x1.b31f6eaea2adcp-5, -0x1.6cb24a5871ad6p-6, 0x1.9b520d2bd6dbp-5, 0x1.ff3a28eab1e36p-1;
  there.translation() = leaning.translation() = Vec3(-0x1.442c77ba80f16p+2, 0x1.c023f0f8d381p+0, 0);
  EXPECT_TRUE(meet(needle, there, cylinder, leaning));
}

TEST(MixedCollide, randomTouchesOfTurnedBoxesAreHits) {
  // A corner of the box is put on the polygon's edge, as far as doubles can: answers are hits, and misses from 1e-12
  // on.
  Random random(62);
  const Shape<double> wall = rectangular(-1, -9, 1, 9);
  const fcl::Boxd box(1, 2, 3);
  for (int i = 0; i < 300; ++i) {
    const Vec3 axis = anyPoint(random, 1);
    const fcl::Matrix3d rotation = turned(random.real(0, 6), axis);
    // In the plane z = 0 the box reaches farthest to the left in a point of an edge or corner: find it by cutting.
    double left = kInfinity;
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
      const Transform pose = placed(center + Vec3(1 - left + step, 0, 0), rotation);
      EXPECT_EQ(meet(wall, kHere, box, pose), step <= 0) << i << " " << step;
    }
  }
}

TEST(MixedCollide, atEndsOfSections) {
  // The edge from below the plane to its right is the last one of either face that has it.
  const auto pyramid = [] {
    const std::vector<Vec3> corners = {{0, 0, -1}, {1, 0, 1}, {-1, 1, 1}, {-1, -1, 1}};
    const std::vector<int> faces = {3, 1, 2, 0, 3, 0, 3, 1, 3, 0, 2, 3, 3, 1, 3, 2};
    return fcl::Convexd(std::make_shared<const std::vector<Vec3>>(corners), 4,
                        std::make_shared<const std::vector<int>>(faces));
  }();
  // Its corner is at x = 0.5, the square's at -1.
  expectEnd("edges that close faces are cut", kSquare, pyramid, shifted(-1.5 + 1e-9, 0, 0), shifted(-1.5 - 1e-9, 0, 0));
  // A cylinder that leans by more than rounding has the section of one that leans.
  const Shape<double> half = rectangular(0, -1, 1, 1);
  const fcl::Cylinderd cylinder(1, 10);
  const double lean = 0.1, reach = 1 / std::cos(lean);
  const auto at = [&](double x, double by) { return placed({x, 0, 0}, turned(by, Vec3::UnitY())); };
  expectEnd("upright", half, cylinder, at(-1, 0), at(-1 - 1e-8, 0));
  expectEnd("leaning", half, cylinder, at(-reach, lean), at(-reach - 1e-6, lean));
  EXPECT_TRUE(meet(half, kHere, cylinder, at(-1, 1e-13)));
  // All around a margin that meets a mesh.
  const Shape<double> wide = shapeOf(kSquare->polygon(), {0.5, 0, 0});
  for (const Vec3& way : {Vec3(1, 0, 0), {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}}) {
    const auto beside = [&](double by) { return placed(by * way, kHere.linear()); };
    expectEnd("margin", wide, boxMesh<fcl::OBBRSSd>({1, 1, 1}), beside(2.5 - 1e-8), beside(2.5 + 1e-8));
  }
}

TEST(MixedCollide, ofOctreesOnlyOccupiedCellsAreThere) {
  EXPECT_TRUE(squareMeets(octree(), shifted(-1.25, -1.25, -0.25)));
  EXPECT_TRUE(squareMeets(octree(), shifted(2.75, 2.75, -0.25)));
  EXPECT_FALSE(squareMeets(octree(), shifted(-4, -1.25, -0.25)));         // unknown
  EXPECT_FALSE(squareMeets(octree(), shifted(-2.6, 0.2, -0.25)));         // free, and the occupied cell is left of it
  EXPECT_FALSE(squareMeets(octree(), shifted(-1.25, -1.25, 0.25)));       // below
  EXPECT_FALSE(squareMeets(fcl::OcTree<double>(0.1), shifted(0, 0, 0)));  // nothing
}

TEST(MixedCollide, heightsReachAboveAndBelow) {
  const Shape<double> prism = shapeOf(kSquare->polygon(), {0, 1, 3});
  const fcl::Sphered sphere(0.5);
  const auto at = [](double x, double z) { return shifted(x, 0, z); };
  for (const double x : {0.0, 1.0}) {
    expectEnd("below", prism, sphere, at(x, 0.5 + 1e-8), at(x, 0.5 - 1e-8));
    expectEnd("above", prism, sphere, at(x, 3.5 - 1e-8), at(x, 3.5 + 1e-8));
  }
  expectEnd("aside", prism, sphere, at(1.5 - 1e-8, 2), at(1.5 + 1e-8, 2));
  const double rim = 1 + std::sqrt(0.25 - 0.09);  // beside the upper edge the nearest is on the rim
  expectEnd("rim", prism, sphere, at(rim - 1e-8, 3.3), at(rim + 1e-8, 3.3));
  expectEnd("halfspace", prism, fcl::Halfspaced(0, 0, 1, 0), at(0, 1), at(0, 1 - 1e-9));
  expectEnd("plane", prism, fcl::Planed(0, 0, 1, 0), at(0, 2), at(0, 3 + 1e-9));
  expectEnd("octree", prism, octree(), at(-1.2, 0.6), at(-1.2, 0.4));
  EXPECT_TRUE(meet(prism, kHere, boxMesh<fcl::RSSd>({0.5, 0.5, 5}), kHere));  // its sides pass through
  // Upside down they reach the other way.
  const Transform upside_down = placed({0, 0, 0}, Vec3(1, -1, -1).asDiagonal());
  const Shape<double> deep = shapeOf(kSquare->polygon(), {0, -1, 3});
  expectEnd("upright", deep, sphere, at(0, 3.25), at(0, -3.25));
  EXPECT_TRUE(meet(deep, upside_down, sphere, at(0, -3.25)));
  EXPECT_FALSE(meet(deep, upside_down, sphere, at(0, 3.25)));
}

TEST(MixedCollide, geometriesThatAreNotFiniteAreRefusedByVertex) {
  const auto expectNamed = [](const Body& geometry, const std::string& name) {
    const std::string text = thrownBy([&] { squareMeets(geometry, kHere); });
    EXPECT_EQ(text.find("tricover: " + name), 0u) << name << ": " << text;
    EXPECT_NE(text.find("not finite"), std::string::npos) << text;
  };
  expectRefused({"mesh"}, [&] { squareMeets(fcl::BVHModel<fcl::OBBd>(), kHere); });
  for (const double bad : {kNaN, kInfinity}) {
    expectNamed(fcl::Boxd(1, bad, 1), "fcl::Box: vertex 0: ");
    for (const int vertex : {0, 2}) {
      std::vector<Vec3> corners = {{0, 0, -1}, {1, 0, -1}, {0, 1, -1}, {0, 0, 1}};
      corners[static_cast<std::size_t>(vertex)].y() = bad;
      expectNamed(*tetrahedron<double>(corners), "fcl::Convex: vertex " + std::to_string(vertex) + ": ");
      fcl::BVHModel<fcl::AABBd> mesh;
      mesh.beginModel();
      mesh.addTriangle(corners[0], corners[1], corners[2]);
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

}  // namespace
}  // namespace tricover_fcl::test
