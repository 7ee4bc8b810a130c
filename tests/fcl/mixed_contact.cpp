// SPDX-License-Identifier: BSD-3-Clause
// What a hit of a polygon and one of FCL's own geometries leaves in the result.
#include <fcl/narrowphase/collision.h>

#include <cmath>

#include "mixed_scene.h"

namespace tricover_fcl::test {
namespace {

const Shape<double> kSquare = rectangular(-1, -1, 1, 1);
const Transform kMoved = placed({5, -6, 7}, turned(1, Vec3(1, 2, 3)));

TEST(MixedContact, isTheWayOutInThePolygonsPlane) {
  // Each reaches 0.25 into the square's right side, in any plane of the world.
  const std::vector<std::pair<Geometry<double>, Transform>> others = {
      {std::make_shared<fcl::Boxd>(2, 1, 4), shifted(1.75, 0, 0.5)},
      {std::make_shared<fcl::Sphered>(2), shifted(1 + std::sqrt(3.0) - 0.25, 0, 1)},
      {std::make_shared<fcl::Cylinderd>(1, 3), shifted(1.75, 0, 1)},
      {std::make_shared<fcl::Halfspaced>(-1, 0, 0, -0.75), kHere},
      {boxMesh<fcl::OBBRSSd>({1, 0.5, 2}), shifted(1.75, 0, 0)},
  };
  for (const auto& [other, pose] : others) {
    SCOPED_TRACE(other->getNodeType());
    for (const std::size_t most : {1u, 10u}) {
      const Transform tf_other = kMoved * pose;
      const auto found = contactsOf(kSquare, kMoved, *other, tf_other, most);
      ASSERT_TRUE(found.size() == 1 || (most > 1 && found.size() == 2));
      EXPECT_EQ(found[0].o1, other->getObjectType() == fcl::OT_BVH ? other.get() : kSquare.get());
      const double side =
          found[0].o1 == kSquare.get() ? 1 : -1;  // FCL hands a mesh's row the mesh first, and leaves it so
      EXPECT_LT((found[0].normal - side * kMoved.linear() * Vec3::UnitX()).norm(), 1e-3);
      EXPECT_NEAR((kMoved.inverse() * found[0].pos).z(), 0, 1e-12);
      if (other->getObjectType() != fcl::OT_BVH || most == 1) {
        EXPECT_NEAR(found[0].penetration_depth, 0.25, 3e-6);
        EXPECT_NEAR((kMoved.inverse() * found[0].pos).x(), 0.875, 1e-5);
      }
      // The square's right side, or an edge that shares a corner with it.
      const auto isThere = [](std::ptrdiff_t edge) { return edge >= 0 && edge <= 2; };
      EXPECT_TRUE(isThere(side > 0 ? found[0].b1 : found[0].b2));

      const auto swapped = contactsOf(*other, tf_other, kSquare, kMoved, most);
      ASSERT_EQ(swapped.size(), found.size());
      EXPECT_EQ(swapped[0].o1, other.get());
      EXPECT_LT((swapped[0].normal + kMoved.linear() * Vec3::UnitX()).norm(), 1e-3);
      EXPECT_TRUE(isThere(swapped[0].b2));
    }
  }
}

/// A prism beside each geometry: the contact lies in the middle of the heights that both share.
TEST(MixedContact, liesInSharedHeights) {
  const Polygon& square = kSquare->polygon();
  struct Case {
    Geometry<double> geometry;
    fcl::Matrix3d rotation;
    double low, high;  ///< of its heights around its own origin
  };
  const fcl::Matrix3d upright = fcl::Matrix3d::Identity(), lying = turned(M_PI / 2, Vec3::UnitY()),
                      leaning = turned(M_PI / 4, Vec3::UnitY());
  const double root = std::sqrt(2.0);
  const std::vector<Case> cases = {
      {std::make_shared<fcl::Boxd>(1, 1, 1), upright, -0.5, 0.5},
      {std::make_shared<fcl::Boxd>(1, 1, 1), leaning, -root / 2, root / 2},
      {std::make_shared<fcl::Sphered>(0.5), upright, -0.5, 0.5},
      {std::make_shared<fcl::Ellipsoidd>(0.5, 0.5, 0.75), upright, -0.75, 0.75},
      {std::make_shared<fcl::Capsuled>(0.5, 1), upright, -1, 1},
      {std::make_shared<fcl::Capsuled>(0.5, 1), lying, -0.5, 0.5},
      {std::make_shared<fcl::Cylinderd>(0.5, 1), upright, -0.5, 0.5},
      {std::make_shared<fcl::Cylinderd>(0.5, 1), lying, -0.5, 0.5},
      {std::make_shared<fcl::Coned>(0.5, 1), upright, -0.5, 0.5},
      {boxMesh<fcl::OBBRSSd>({0.5, 0.5, 0.5}), upright, -0.5, 0.5},
      {tetrahedron<double>(1, 1, 1), upright, 0, 1},
  };
  for (const Case& c : cases) {
    SCOPED_TRACE(c.geometry->getNodeType());
    for (const double z : {0.5, 9.75, 10.2, -0.2}) {
      const Transform there = placed({0.95, 0, z}, c.rotation);
      if (z + c.high < 0 || z + c.low > 10) continue;
      const double middle = (std::max(0.0, z + c.low) + std::min(10.0, z + c.high)) / 2;
      for (const auto& options : {PolygonOptions{0, 0, 10}, PolygonOptions::atAllHeights()}) {
        const PolygonShaped prism(square, options);
        const double expected = prism.isAtAllHeights() ? z + (c.low + c.high) / 2 : middle;
        for (const std::size_t most : {1u, 10u}) {
          for (const Transform& by : {kHere, kMoved}) {
            const auto found = contactsOf(prism, by, *c.geometry, by * there, most);
            const auto swapped = contactsOf(*c.geometry, by * there, prism, by, most);
            ASSERT_FALSE(found.empty() || swapped.empty());
            EXPECT_NEAR((by.inverse() * found[0].pos).z(), expected, 1e-9) << z;
            EXPECT_NEAR((by.inverse() * swapped[0].pos).z(), expected, 1e-9) << z;
          }
        }
      }
    }
  }
  const PolygonShaped prism(square, PolygonOptions{0, 0, 10});
  const auto z = [&](const Body& other) { return contactsOf(prism, kHere, other, kHere, 1)[0].pos.z(); };
  EXPECT_NEAR(z(fcl::Halfspaced(0, 0, 1, 2)), 1, 1e-12);     // below z = 2
  EXPECT_NEAR(z(fcl::Halfspaced(1, 0, 0, -0.5)), 5, 1e-12);  // all heights
}

TEST(MixedContact, isOnePerPartOfTheOverlapDeepestFirst) {
  // Two teeth into a wall: 1 and 2 long.
  const PolygonShaped fork(
      Polygon({{{0, 0}, {5, 0}, {5, 1}, {4, 1}, {4, 3}, {3, 3}, {3, 1}, {2, 1}, {2, 2}, {1, 2}, {1, 1}, {0, 1}}}));
  const fcl::Boxd wall(20, 10, 1);
  const Transform at = shifted(0, 6.5, 0);  // its lower side at y = 1.5
  const auto found = contactsOf(fork, kHere, wall, at, 10);
  ASSERT_EQ(found.size(), 4u);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(std::abs(found[k].pos.x() - (k < 2 ? 3.5 : 1.5)), 0.5, 1e-9);  // both ends of each
    EXPECT_NEAR(found[k].penetration_depth, k < 2 ? found[0].penetration_depth : 0.5, 1e-9);
  }
  EXPECT_GE(found[0].penetration_depth, 0.5);
  EXPECT_EQ(contactsOf(fork, kHere, wall, at, 1).size(), 1u);
  EXPECT_NEAR(contactsOf(fork, kHere, wall, at, 1)[0].penetration_depth, 1.5, 1e-9);  // of the whole
}

/// As of two polygons: of many the part's own way, of one the way out.
TEST(MixedContact, ofManyAreLocalAndTheOnlyOneIsTheWayOut) {
  const PolygonShaped slot(Polygon({{{-5, -5}, {5, -5}, {5, 5}, {1, 5}, {1, 0}, {-1, 0}, {-1, 5}, {-5, 5}}}));
  const std::vector<std::pair<Geometry<double>, Transform>> pegs = {
      {std::make_shared<fcl::Boxd>(2.5, 6, 2), shifted(0, 6, 0)},
      {std::make_shared<fcl::Ellipsoidd>(1.25, 4, 3), shifted(0, 4.2, 0)},
      {std::make_shared<fcl::Sphered>(1.25), shifted(0, 2, 0)}};
  for (const auto& [peg, pose] : pegs) {
    SCOPED_TRACE(peg->getNodeType());
    const auto parts = contactsOf(slot, kHere, *peg, pose, 9);
    ASSERT_EQ(parts.size(), peg->getNodeType() == fcl::GEOM_BOX ? 4u : 2u);
    for (const fcl::Contactd& part : parts) {
      EXPECT_NEAR(part.penetration_depth, 0.25, 1e-5);
      EXPECT_LT((part.normal - Vec3(part.pos.x() > 0 ? -1 : 1, 0, 0)).norm(), 1e-2);
    }
    EXPECT_LT(parts.front().pos.x() * parts.back().pos.x(), 0);
    const auto whole = contactsOf(slot, kHere, *peg, pose, 1);
    ASSERT_EQ(whole.size(), 1u);
    EXPECT_GT(whole[0].penetration_depth, 1);
    EXPECT_LT((whole[0].normal - Vec3::UnitY()).norm(), 1e-3);
    // What is there already takes room, and changes nothing else.
    fcl::CollisionResultd result;
    for (int time = 0; time < 2; ++time)
      fcl::collide(&slot, kHere, peg.get(), pose, fcl::CollisionRequestd(3, true), result);
    ASSERT_EQ(result.numContacts(), 3u);
    EXPECT_NEAR(result.getContact(2).penetration_depth, 0.25, 1e-5);
  }
}

TEST(MixedContact, namesTrianglesAndCells) {
  const auto mesh = boxMesh<fcl::OBBRSSd>({1, 1, 1});
  const auto of_mesh = contactsOf(*mesh, shifted(1.5, 0, 0), kSquare, kHere, 1);
  ASSERT_EQ(of_mesh.size(), 1u);
  EXPECT_EQ(of_mesh[0].o1, mesh.get());
  ASSERT_GE(of_mesh[0].b1, 0);
  ASSERT_LT(of_mesh[0].b1, 12);

  const auto tree = octree<double>();
  const auto of_tree = contactsOf(*tree, shifted(-2.25, -1.25, -0.25), kSquare, kHere, 1);
  ASSERT_EQ(of_tree.size(), 1u);
  EXPECT_NE(of_tree[0].b1, int{fcl::Contactd::NONE});
  const auto both = contactsOf(*tree, shifted(-2.25, -1.25, -0.25), kSquare, kHere, 3);
  EXPECT_EQ(both.size(), 2u);
  // As FCL's own row names the cell.
  const fcl::Boxd box(2, 2, 1);
  const auto of_box = contactsOf(*tree, shifted(-2.25, -1.25, -0.25), box, kHere, 1);
  ASSERT_EQ(of_box.size(), 1u);
  EXPECT_EQ(of_tree[0].b1, of_box[0].b1);
}

/// Numbers that are no number aren't looked at.
struct Row {
  const char* what;
  Geometry<double> a;
  Transform tf_a;
  Geometry<double> b;
  Transform tf_b;
  Vec3 normal;
  double depth, error;
  Vec3 pos = Vec3::Constant(kNaN);
};

TEST(MixedContact, hasNormalDepthAndPlace) {
  const auto halfspace = std::make_shared<fcl::Halfspaced>(0, 0, 1, 0);
  const auto plane = [](double z) { return std::make_shared<fcl::Planed>(0, 0, 1, z); };
  const auto sphere = [](double radius) { return std::make_shared<fcl::Sphered>(radius); };
  const auto prism = shapeOf(kSquare->polygon(), {0, -1, 3});
  const auto needle = shapeOf(Polygon({{{0, 0}, {1, -1.25}, {0.3, -0.375}, {0.7, -0.875}, {0.1, -0.125}}}));
  const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ(), any = Vec3::Constant(kNaN);
  // Two sheets in the plane: from the right one the way to the left is shorter, but there is the other one.
  const auto sheets = std::make_shared<fcl::BVHModel<fcl::OBBRSSd>>();
  sheets->beginModel();
  for (const auto& [low, high] : {std::pair(0.5, 1.5), std::pair(-2.5, -1.2)}) {
    const Vec3 corners[] = {{low, -9, 0}, {high, -9, 0}, {high, 9, 0}, {low, 9, 0}};
    sheets->addTriangle(corners[0], corners[1], corners[2]);
    sheets->addTriangle(corners[0], corners[2], corners[3]);
  }
  sheets->endModel();
  std::vector<Row> rows = {
      {"a plane parallel to the polygon", kSquare, shifted(3, 4, -0.25), halfspace, kHere, -z, 0.25, 1e-12},
      {"a plane is left on the shorter way", prism, kHere, plane(-0.75), kHere, -z, 0.25, 1e-12},
      {"or on the other one", prism, kHere, plane(2.5), kHere, z, 0.5, 1e-12},
      {"touching an edge", kSquare, kHere, sphere(1), shifted(2, 0, 0), x, 0, 0},
      {"at a corner", kSquare, kHere, sphere(0.5), shifted(1.3, 1.4, 0), {0.6, 0.8, 0}, kNaN, 0},
      {"the centre on an edge", kSquare, kHere, sphere(0.25), shifted(0.5, -1, 0), -y, 0.25, 0, {0.5, -0.875, 0}},
      {"from within", kSquare, kHere, sphere(0.5), shifted(0.75, 0.5, 0), x, 0.75, 0, {0.625, 0.5, 0}},
      {"many ways are as short", needle, kHere, std::make_shared<fcl::Ellipsoidd>(0.75, 0.75, 0.5), kHere, any, 0.75,
       1e-4 * 0.75},
      {"two sheets", sheets, kHere, kSquare, kHere, any, 2.5, 1e-9}};
  for (const double size : {1e-200, 1.0, 1e200}) {
    rows.push_back({"at any scale", rectangular(-size, -size, size, size), kHere, sphere(0.5 * size),
                    shifted(0.5 * size, 0.75 * size, 0), y, 0.75 * size, 4e-16 * size});
  }
  for (const Row& row : rows) {
    SCOPED_TRACE(row.what);
    for (const bool swapped : {false, true}) {
      const auto found =
          swapped ? contactsOf(row.b, row.tf_b, row.a, row.tf_a, 1) : contactsOf(row.a, row.tf_a, row.b, row.tf_b, 1);
      ASSERT_EQ(found.size(), 1u);
      const fcl::Contactd& contact = found[0];
      EXPECT_NEAR(contact.normal.norm(), 1, 1e-12);
      if (!row.normal.hasNaN()) {
        EXPECT_LE((contact.normal - (swapped ? -row.normal : row.normal)).norm(), 1e-12) << contact.normal.transpose();
      }
      if (!std::isnan(row.depth)) {
        EXPECT_NEAR(contact.penetration_depth, row.depth, row.error);
      }
      EXPECT_TRUE(contact.pos.allFinite());
      if (!row.pos.hasNaN()) {
        EXPECT_LE((contact.pos - row.pos).norm(), row.error) << contact.pos.transpose();
      }
    }
  }
  const auto many = contactsOf(kSquare, shifted(3, 4, -0.25), halfspace, kHere, 10),
             swapped = contactsOf(halfspace, kHere, kSquare, shifted(3, 4, -0.25), 10);
  ASSERT_TRUE(many.size() == 1 && swapped.size() == 1);
  EXPECT_LT((many[0].normal + z).norm() + (swapped[0].normal - z).norm(), 1e-12);
  EXPECT_NEAR(many[0].penetration_depth, 0.25, 1e-12);
  // The centre is at a corner, where either edge will do.
  const Vec3 at_corner = contactsOf(kSquare, kHere, sphere(0.25), shifted(1, 1, 0), 1).at(0).normal;
  EXPECT_TRUE((at_corner - x).norm() < 1e-12 || (at_corner - y).norm() < 1e-12);
}

TEST(MixedContact, touchingHasNoDepth) {
  const fcl::Boxd box(2, 2, 2);
  const auto found = contactsOf(kSquare, kHere, box, shifted(2, 0, 0), 10);
  ASSERT_EQ(found.size(), 2u);
  for (const fcl::Contactd& end : found) {
    EXPECT_NEAR(end.penetration_depth, 0, 1e-13);
    EXPECT_NEAR(end.normal.norm(), 1, 1e-12);
    EXPECT_NEAR(end.pos.x(), 1, 1e-12);
  }
  EXPECT_NEAR(std::abs(found[0].pos.y() - found[1].pos.y()), 2, 1e-12);
}

TEST(MixedContact, hasNoDetailsUnlessAskedForAndHonoursOccupancyAndCost) {
  fcl::Boxd box(2, 2, 2);
  fcl::CollisionResultd result;
  EXPECT_EQ(fcl::collide(kSquare.get(), kHere, &box, shifted(1, 0, 0), fcl::CollisionRequestd(), result), 1u);
  EXPECT_EQ(result.getContact(0).o1, kSquare.get());
  EXPECT_EQ(result.getContact(0).o2, &box);
  EXPECT_EQ(result.getContact(0).b1, int{fcl::Contactd::NONE});

  box.cost_density = 0.5;  // uncertain: costs, but no contact
  fcl::CollisionResultd costs;
  EXPECT_EQ(
      fcl::collide(kSquare.get(), kHere, &box, shifted(1, 0, 0), fcl::CollisionRequestd(1, false, 3, true), costs), 0u);
  std::vector<fcl::CostSourced> sources;
  costs.getCostSources(sources);
  ASSERT_EQ(sources.size(), 1u);
  EXPECT_NEAR(sources[0].total_cost, 0.5 * 1 * 2 * 1, 1e-12);  // 1 x 2 in the plane, 1 thick
}

TEST(MixedContact, marginsCount) {
  const Shape<double> wide = shapeOf(kSquare->polygon(), {0.5, 0, 0});
  for (const auto& other : {Geometry<double>(std::make_shared<fcl::Boxd>(2, 2, 2)),
                            Geometry<double>(std::make_shared<fcl::Sphered>(1)), boxMesh<fcl::OBBRSSd>({1, 1, 1})}) {
    EXPECT_TRUE(contactsOf(kSquare, kHere, *other, shifted(2.01, 0, 0), 1).empty());
    const auto found = contactsOf(wide, kHere, *other, shifted(2.5 - 1e-8, 0, 0), 1);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0].penetration_depth, 1e-8, 1e-14);
    EXPECT_NEAR(found[0].pos.x(), 1.5, 1e-7);
    EXPECT_TRUE(contactsOf(wide, kHere, *other, shifted(2.5 + 1e-8, 0, 0), 1).empty());
  }
}

}  // namespace
}  // namespace tricover_fcl::test
