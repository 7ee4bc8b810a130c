// SPDX-License-Identifier: BSD-3-Clause
// What a hit of a polygon and one of FCL's own geometries leaves in the result.
#include <fcl/narrowphase/collision.h>

#include <cmath>

#include "mixed_scene.h"

namespace tricover_fcl::test {
namespace {

using Vec3 = fcl::Vector3<double>;

class MixedContact : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { registerNarrowphase(); }

  const PolygonShaped square_{tricover::Polygon({rectangle(-1, -1, 1, 1)})};
  const fcl::Transform3d here_ = fcl::Transform3d::Identity();
};

TEST_F(MixedContact, isTheWayOutInThePolygonsPlane) {
  // Each reaches 0.25 into the square's right side, in any plane of the world.
  const std::vector<std::pair<Geometry<double>, fcl::Transform3d>> others = {
      {std::make_shared<fcl::Boxd>(2, 1, 4), shifted<double>(1.75, 0, 0.5)},
      {std::make_shared<fcl::Sphered>(2), shifted<double>(1 + std::sqrt(3.0) - 0.25, 0, 1)},
      {std::make_shared<fcl::Cylinderd>(1, 3), shifted<double>(1.75, 0, 1)},
      {std::make_shared<fcl::Halfspaced>(-1, 0, 0, -0.75), here_},
      {boxMesh<fcl::OBBRSSd>({1, 0.5, 2}), shifted<double>(1.75, 0, 0)},
  };
  const fcl::Transform3d moved = placed<double>({5, -6, 7}, turned(1, Vec3(1, 2, 3)));
  for (const auto& [other, pose] : others) {
    SCOPED_TRACE(other->getNodeType());
    for (const std::size_t most : {1u, 10u}) {
      const fcl::Transform3d tf_other = moved * pose;
      const auto found = contactsOf(square_, moved, *other, tf_other, most);
      ASSERT_TRUE(found.size() == 1 || (most > 1 && found.size() == 2));
      EXPECT_EQ(found[0].o1, other->getObjectType() == fcl::OT_BVH ? other.get() : &square_);
      const double side = found[0].o1 == &square_ ? 1 : -1;  // FCL hands a mesh's row the mesh first, and leaves it so
      EXPECT_LT((found[0].normal - side * moved.linear() * Vec3::UnitX()).norm(), 1e-3);
      EXPECT_NEAR((moved.inverse() * found[0].pos).z(), 0, 1e-12);
      if (other->getObjectType() != fcl::OT_BVH || most == 1) {
        EXPECT_NEAR(found[0].penetration_depth, 0.25, 3e-6);
        EXPECT_NEAR((moved.inverse() * found[0].pos).x(), 0.875, 1e-5);
      }
      // The square's right side, or an edge that shares a corner with it.
      const auto isThere = [](std::ptrdiff_t edge) { return edge >= 0 && edge <= 2; };
      EXPECT_TRUE(isThere(side > 0 ? found[0].b1 : found[0].b2));

      const auto swapped = contactsOf(*other, tf_other, square_, moved, most);
      ASSERT_EQ(swapped.size(), found.size());
      EXPECT_EQ(swapped[0].o1, other.get());
      EXPECT_LT((swapped[0].normal + moved.linear() * Vec3::UnitX()).norm(), 1e-3);
      EXPECT_TRUE(isThere(swapped[0].b2));
    }
  }
}

/// A prism beside each geometry: the contact lies in the middle of the heights that both share.
TEST_F(MixedContact, liesInSharedHeights) {
  const tricover::Polygon& square = square_.polygon();
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
  const fcl::Transform3d moved = placed<double>({5, -6, 7}, turned(1, Vec3(1, 2, 3)));
  for (const Case& c : cases) {
    SCOPED_TRACE(c.geometry->getNodeType());
    for (const double z : {0.5, 9.75, 10.2, -0.2}) {
      const fcl::Transform3d there = placed<double>({0.95, 0, z}, c.rotation);
      if (z + c.high < 0 || z + c.low > 10) continue;
      const double middle = (std::max(0.0, z + c.low) + std::min(10.0, z + c.high)) / 2;
      for (const auto& options : {PolygonOptions{0, 0, 10}, PolygonOptions::atAllHeights()}) {
        const PolygonShaped prism(square, options);
        const double expected = prism.isAtAllHeights() ? z + (c.low + c.high) / 2 : middle;
        for (const std::size_t most : {1u, 10u}) {
          for (const fcl::Transform3d& by : {here_, moved}) {
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
  const auto z = [&](const fcl::CollisionGeometryd& other) {
    return contactsOf(prism, here_, other, here_, 1)[0].pos.z();
  };
  EXPECT_NEAR(z(fcl::Halfspaced(0, 0, 1, 2)), 1, 1e-12);     // below z = 2
  EXPECT_NEAR(z(fcl::Halfspaced(1, 0, 0, -0.5)), 5, 1e-12);  // all heights
}

TEST_F(MixedContact, isOnePerPartOfTheOverlapDeepestFirst) {
  // Two teeth into a wall: 1 and 2 long.
  const PolygonShaped fork(tricover::Polygon(
      {{{0, 0}, {5, 0}, {5, 1}, {4, 1}, {4, 3}, {3, 3}, {3, 1}, {2, 1}, {2, 2}, {1, 2}, {1, 1}, {0, 1}}}));
  const fcl::Boxd wall(20, 10, 1);
  const fcl::Transform3d at = shifted<double>(0, 6.5, 0);  // its lower side at y = 1.5
  const auto found = contactsOf(fork, here_, wall, at, 10);
  ASSERT_EQ(found.size(), 4u);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(std::abs(found[k].pos.x() - (k < 2 ? 3.5 : 1.5)), 0.5, 1e-9);  // both ends of each
    EXPECT_NEAR(found[k].penetration_depth, k < 2 ? found[0].penetration_depth : 0.5, 1e-9);
  }
  EXPECT_GE(found[0].penetration_depth, 0.5);
  EXPECT_EQ(contactsOf(fork, here_, wall, at, 1).size(), 1u);
  EXPECT_NEAR(contactsOf(fork, here_, wall, at, 1)[0].penetration_depth, 1.5, 1e-9);  // of the whole
}

/// As of two polygons: of many the part's own way, of one the way out.
TEST_F(MixedContact, ofManyAreLocalAndTheOnlyOneIsTheWayOut) {
  const PolygonShaped slot(tricover::Polygon({{{-5, -5}, {5, -5}, {5, 5}, {1, 5}, {1, 0}, {-1, 0}, {-1, 5}, {-5, 5}}}));
  const std::vector<std::pair<Geometry<double>, fcl::Transform3d>> pegs = {
      {std::make_shared<fcl::Boxd>(2.5, 6, 2), shifted<double>(0, 6, 0)},
      {std::make_shared<fcl::Ellipsoidd>(1.25, 4, 3), shifted<double>(0, 4.2, 0)},
      {std::make_shared<fcl::Sphered>(1.25), shifted<double>(0, 2, 0)}};
  for (const auto& [peg, pose] : pegs) {
    SCOPED_TRACE(peg->getNodeType());
    const auto parts = contactsOf(slot, here_, *peg, pose, 9);
    ASSERT_EQ(parts.size(), peg->getNodeType() == fcl::GEOM_BOX ? 4u : 2u);
    for (const fcl::Contactd& part : parts) {
      EXPECT_NEAR(part.penetration_depth, 0.25, 1e-5);
      EXPECT_LT((part.normal - Vec3(part.pos.x() > 0 ? -1 : 1, 0, 0)).norm(), 1e-2);
    }
    EXPECT_LT(parts.front().pos.x() * parts.back().pos.x(), 0);
    const auto whole = contactsOf(slot, here_, *peg, pose, 1);
    ASSERT_EQ(whole.size(), 1u);
    EXPECT_GT(whole[0].penetration_depth, 1);
    EXPECT_LT((whole[0].normal - Vec3::UnitY()).norm(), 1e-3);
    // What is there already takes room, and changes nothing else.
    fcl::CollisionResultd result;
    for (int time = 0; time < 2; ++time)
      fcl::collide(&slot, here_, peg.get(), pose, fcl::CollisionRequestd(3, true), result);
    ASSERT_EQ(result.numContacts(), 3u);
    EXPECT_NEAR(result.getContact(2).penetration_depth, 0.25, 1e-5);
  }
}

TEST_F(MixedContact, namesTrianglesAndCells) {
  const auto mesh = boxMesh<fcl::OBBRSSd>({1, 1, 1});
  const auto of_mesh = contactsOf(*mesh, shifted<double>(1.5, 0, 0), square_, here_, 1);
  ASSERT_EQ(of_mesh.size(), 1u);
  EXPECT_EQ(of_mesh[0].o1, mesh.get());
  ASSERT_GE(of_mesh[0].b1, 0);
  ASSERT_LT(of_mesh[0].b1, 12);

  const auto tree = octree<double>();
  const auto of_tree = contactsOf(*tree, shifted<double>(-2.25, -1.25, -0.25), square_, here_, 1);
  ASSERT_EQ(of_tree.size(), 1u);
  EXPECT_NE(of_tree[0].b1, int{fcl::Contactd::NONE});
  const auto both = contactsOf(*tree, shifted<double>(-2.25, -1.25, -0.25), square_, here_, 3);
  EXPECT_EQ(both.size(), 2u);
  // As FCL's own row names the cell.
  const fcl::Boxd box(2, 2, 1);
  const auto of_box = contactsOf(*tree, shifted<double>(-2.25, -1.25, -0.25), box, here_, 1);
  ASSERT_EQ(of_box.size(), 1u);
  EXPECT_EQ(of_tree[0].b1, of_box[0].b1);
}

TEST_F(MixedContact, ofAPlaneParallelToThePolygonIsAlongItsNormal) {
  const fcl::Halfspaced ground(0, 0, 1, 0);
  const auto found = contactsOf(square_, shifted<double>(3, 4, -0.25), ground, here_, 10);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_LT((found[0].normal + Vec3::UnitZ()).norm(), 1e-12);
  EXPECT_NEAR(found[0].penetration_depth, 0.25, 1e-12);
  const auto swapped = contactsOf(ground, here_, square_, shifted<double>(3, 4, -0.25), 10);
  ASSERT_EQ(swapped.size(), 1u);
  EXPECT_LT((swapped[0].normal - Vec3::UnitZ()).norm(), 1e-12);
}

TEST_F(MixedContact, ofAPlaneIsLeftOnTheShorterWay) {
  const PolygonShaped prism(square_.polygon(), PolygonOptions{0, -1, 3});
  for (const double z : {-0.75, 2.5}) {
    const auto found = contactsOf(prism, here_, fcl::Planed(0, 0, 1, z), here_, 1);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_LT((found[0].normal - (z > 0 ? 1 : -1) * Vec3::UnitZ()).norm(), 1e-12);
    EXPECT_NEAR(found[0].penetration_depth, z > 0 ? 0.5 : 0.25, 1e-12);
  }
}

TEST_F(MixedContact, touchingHasNoDepth) {
  const fcl::Boxd box(2, 2, 2);
  const auto found = contactsOf(square_, here_, box, shifted<double>(2, 0, 0), 10);
  ASSERT_EQ(found.size(), 2u);
  for (const fcl::Contactd& end : found) {
    EXPECT_NEAR(end.penetration_depth, 0, 1e-13);
    EXPECT_NEAR(end.normal.norm(), 1, 1e-12);
    EXPECT_NEAR(end.pos.x(), 1, 1e-12);
  }
  EXPECT_NEAR(std::abs(found[0].pos.y() - found[1].pos.y()), 2, 1e-12);
}

TEST_F(MixedContact, hasNoDetailsUnlessAskedForAndHonoursOccupancyAndCost) {
  fcl::Boxd box(2, 2, 2);
  fcl::CollisionResultd result;
  EXPECT_EQ(fcl::collide(&square_, here_, &box, shifted<double>(1, 0, 0), fcl::CollisionRequestd(), result), 1u);
  EXPECT_EQ(result.getContact(0).o1, &square_);
  EXPECT_EQ(result.getContact(0).o2, &box);
  EXPECT_EQ(result.getContact(0).b1, int{fcl::Contactd::NONE});

  box.cost_density = 0.5;  // uncertain: costs, but no contact
  fcl::CollisionResultd costs;
  EXPECT_EQ(
      fcl::collide(&square_, here_, &box, shifted<double>(1, 0, 0), fcl::CollisionRequestd(1, false, 3, true), costs),
      0u);
  std::vector<fcl::CostSourced> sources;
  costs.getCostSources(sources);
  ASSERT_EQ(sources.size(), 1u);
  EXPECT_NEAR(sources[0].total_cost, 0.5 * 1 * 2 * 1, 1e-12);  // 1 x 2 in the plane, 1 thick
}

TEST_F(MixedContact, marginsCount) {
  PolygonOptions options;
  options.margin = 0.5;
  const PolygonShaped wide(square_.polygon(), options);
  for (const auto& other : {Geometry<double>(std::make_shared<fcl::Boxd>(2, 2, 2)),
                            Geometry<double>(std::make_shared<fcl::Sphered>(1)), boxMesh<fcl::OBBRSSd>({1, 1, 1})}) {
    EXPECT_TRUE(contactsOf(square_, here_, *other, shifted<double>(2.01, 0, 0), 1).empty());
    const auto found = contactsOf(wide, here_, *other, shifted<double>(2.5 - 1e-8, 0, 0), 1);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0].penetration_depth, 1e-8, 1e-14);
    EXPECT_NEAR(found[0].pos.x(), 1.5, 1e-7);
    EXPECT_TRUE(contactsOf(wide, here_, *other, shifted<double>(2.5 + 1e-8, 0, 0), 1).empty());
  }
}

/// Of a mesh alone what is beside the polygon need be looked at, unless the way out of it is asked for.
TEST_F(MixedContact, ofAMeshSeesWhatIsThere) {
  PolygonOptions options;
  options.margin = 0.5;
  const PolygonShaped wide(square_.polygon(), options);
  const auto cube = boxMesh<fcl::OBBRSSd>({1, 1, 1});
  for (const tricover::Vec2& way : {tricover::Vec2(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
    for (const double more : {-1e-8, 1e-8}) {
      const fcl::Transform3d at = shifted<double>((2.5 + more) * way.x(), (2.5 + more) * way.y(), 0);
      EXPECT_EQ(meet<double>(wide, here_, *cube, at), more < 0) << way.transpose();
    }
  }

  // Two sheets in the plane: from the right one the way to the left is shorter, but there is the other one.
  auto sheets = std::make_shared<fcl::BVHModel<fcl::OBBRSSd>>();
  sheets->beginModel();
  for (const auto& [low, high] : {std::pair(0.5, 1.5), std::pair(-2.5, -1.2)}) {
    const Vec3 corners[] = {{low, -9, 0}, {high, -9, 0}, {high, 9, 0}, {low, 9, 0}};
    sheets->addTriangle(corners[0], corners[1], corners[2]);
    sheets->addTriangle(corners[0], corners[2], corners[3]);
  }
  sheets->endModel();
  const auto found = contactsOf(*sheets, here_, square_, here_, 1);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].penetration_depth, 2.5, 1e-9);
}

}  // namespace
}  // namespace tricover_fcl::test
