// SPDX-License-Identifier: BSD-3-Clause
// What a hit leaves in FCL's result.
#include <algorithm>
#include <cmath>

#include "ask.h"
#include "tricover/contacts.h"

namespace tricover_fcl::test {
namespace {

class Contact : public ::testing::Test {
 protected:
  std::size_t collide(double x, const fcl::CollisionRequestd& request, double z = 0) {
    return fcl::collide(square_.get(), kHere, other_.get(), lifted(0, x, 0, z), request, result_);
  }

  Shape<double> square_ = rectangular(0, 0, 2, 2);
  Shape<double> other_ = rectangular(0, 0.5, 2, 1.5);
  fcl::CollisionResultd result_;
};

TEST_F(Contact, hasPlaceNormalDepthAndEdgesInTheWorld) {
  for (const std::size_t most : {1U, 9U}) {
    const auto found = contactsOf(*square_, lifted(0, 10, 20, 5), *other_, lifted(0, 11.5, 20, 5), most);
    ASSERT_EQ(found.size(), std::min<std::size_t>(most, 2));
    for (const fcl::Contactd& contact : found) {
      EXPECT_EQ(contact.o1, square_.get());
      EXPECT_EQ(contact.o2, other_.get());
      EXPECT_TRUE(contact.normal.isApprox(Vec3::UnitX()));
      EXPECT_NEAR(contact.penetration_depth, 0.5, 1e-12);
      EXPECT_NEAR(contact.pos.x(), 11.75, 1e-12);
      EXPECT_GE(contact.pos.y(), 20 - 1e-12);
      EXPECT_LE(contact.pos.y(), 22 + 1e-12);
      EXPECT_EQ(contact.pos.z(), 5);
      // The edges that part last: on square_'s right side and other_'s left one.
      expectOnEdge(*square_, contact.b1, {2, contact.pos.y() - 20});
      expectOnEdge(*other_, contact.b2, {0, contact.pos.y() - 20});
    }
  }
}

/// Of random pairs: the order of the two only changes sides; the only contact is the shortest way out; and a step of a
/// simulation, which goes by all parts at once, again and again, parts the two.
TEST_F(Contact, partsPolygonsInEitherOrder) {
  Random random(41);
  int hits = 0, parted = 0;
  const int count = scaledCount(300);
  for (int i = 0; i < count; ++i) {
    SCOPED_TRACE(i);
    const Shape<double> a = shapeOf(randomPolygon(random, 1)), b = shapeOf(randomPolygon(random, 1));
    const Transform tf_a = lifted(randomPose(random, 1.5)), tf_b = lifted(randomPose(random, 1.5));
    fcl::CollisionRequestd in_other_order(100, true);
    in_other_order.gjk_solver_type = fcl::GST_INDEP;
    for (const std::size_t most : {1U, 100U}) {
      in_other_order.num_max_contacts = most;
      const auto found = contactsOf(a, tf_a, b, tf_b, most);
      fcl::CollisionResultd swapped;
      ASSERT_EQ(fcl::collide<double>(b.get(), tf_b, a.get(), tf_a, in_other_order, swapped), found.size());
      for (std::size_t k = 0; k < found.size(); ++k) {
        const fcl::Contactd& other = swapped.getContact(k);
        ASSERT_EQ(found[k].penetration_depth, other.penetration_depth);
        ASSERT_EQ(found[k].normal, -other.normal);
        ASSERT_EQ(found[k].pos, other.pos);
        ASSERT_EQ(found[k].b1, other.b2);
        ASSERT_EQ(found[k].b2, other.b1);
        ASSERT_EQ(other.o1, b.get());
      }
      if (found.empty() || most > 1) continue;
      ++hits;
      ASSERT_NEAR(found[0].normal.norm(), 1, 1e-12);
      const auto beyond = [&](double more) {
        return Transform(Eigen::Translation3d((found[0].penetration_depth + more) * found[0].normal) * tf_b);
      };
      EXPECT_FALSE(meet(a, tf_a, b, beyond(1e-9)));
      EXPECT_TRUE(meet(a, tf_a, b, beyond(-1e-9)));
    }
    Transform moved = tf_b;
    for (int step = 0; step <= 100; ++step) {
      const auto parts = contactsOf(a, tf_a, b, moved, 100);
      if (parts.empty()) {
        parted += step > 0;
        break;
      }
      for (const fcl::Contactd& part : parts) {
        ASSERT_NEAR(part.normal.norm(), 1, 1e-12);
        ASSERT_GE(part.penetration_depth, 0);
        moved.pretranslate(Vec3((part.penetration_depth + 1e-9) * part.normal));
      }
    }
  }
  EXPECT_GT(hits, count * 3 / 10);
  EXPECT_LT(hits, count * 9 / 10);
  EXPECT_GE(parted, hits * 9 / 10);
}

TEST_F(Contact, ofEachPartOfTheOverlapDeepestFirst) {
  // A comb's teeth, each deeper than the one before, in a bar.
  std::vector<Vec2> teeth = {{0, 2}};
  for (int i = 0; i < 5; ++i) {
    teeth.emplace_back(2 * i, 0.5);
    teeth.emplace_back(2 * i + 0.25, -0.1 * (i + 1));
    teeth.emplace_back(2 * i + 0.5, 0.5);
    teeth.emplace_back(2 * i + 1, 1);
  }
  teeth.emplace_back(10, 2);
  const Shape<double> comb = shapeOf(Polygon({teeth}));
  const Shape<double> bar = rectangular(-1, -5, 11, 0);
  for (const std::size_t most : {2U, 3U, 5U, 100U}) {
    fcl::CollisionResultd result;
    fcl::collide(bar.get(), kHere, comb.get(), kHere, fcl::CollisionRequestd(most, true), result);
    ASSERT_EQ(result.numContacts(), std::min<std::size_t>(most, 5));
    for (std::size_t k = 0; k < result.numContacts(); ++k) {
      const fcl::Contactd& contact = result.getContact(k);
      EXPECT_NEAR(contact.penetration_depth, 0.1 * static_cast<double>(5 - k), 1e-12);
      EXPECT_TRUE(contact.normal.isApprox(Vec3::UnitY()));
      EXPECT_NEAR(contact.pos.x(), 2 * static_cast<double>(4 - k) + 0.25, 1e-12);
    }
    // What is there already takes room.
    fcl::collide(bar.get(), kHere, comb.get(), kHere, fcl::CollisionRequestd(most + 1, true), result);
    EXPECT_EQ(result.numContacts(), std::min<std::size_t>(most + 1, 10));
  }
}

/// A peg that is wider than its slot: the way out is up, each wall's own is across it.
TEST_F(Contact, ofManyAreLocalAndTheOnlyOneIsTheWayOut) {
  const Shape<double> slot = shapeOf(Polygon({{{-5, -5}, {5, -5}, {5, 5}, {1, 5}, {1, 0}, {-1, 0}, {-1, 5}, {-5, 5}}}));
  const Shape<double> peg = rectangular(-1.25, 3, 1.25, 9);
  const auto contacts = [](const Shape<double>& a, const Shape<double>& b, std::size_t most) {
    return contactsOf(a, kHere, b, kHere, most);
  };
  const auto only = contacts(slot, peg, 1), swapped = contacts(peg, slot, 1);
  ASSERT_EQ(only.size(), 1u);
  ASSERT_EQ(swapped.size(), 1u);
  EXPECT_NEAR(only[0].penetration_depth, 2, 1e-9);
  EXPECT_TRUE(only[0].normal.isApprox(Vec3::UnitY()));
  EXPECT_TRUE(swapped[0].normal.isApprox(-Vec3::UnitY()));
  for (const std::size_t most : {2U, 9U}) {
    for (const double side : {1.0, -1.0}) {
      const auto parts = side > 0 ? contacts(slot, peg, most) : contacts(peg, slot, most);
      ASSERT_EQ(parts.size(), most == 2 ? 2u : 4u);
      for (const fcl::Contactd& part : parts) {
        const double right = part.pos.x() > 0 ? 1 : -1;  // the wall that it is in
        EXPECT_NEAR(part.penetration_depth, 0.25, 1e-9);
        EXPECT_TRUE(part.normal.isApprox(-side * right * Vec3::UnitX()));
        EXPECT_NEAR(part.pos.x(), 1.125 * right, 0.126);
      }
      EXPECT_LT(parts.front().pos.x() * parts.back().pos.x(), 0);
    }
  }

  // In one part, too: there is no room for the step that it takes.
  const Shape<double> tight = rectangular(-0.95, 3, 1.1, 9);
  const auto local = contacts(slot, tight, 9);
  ASSERT_EQ(local.size(), 2u);
  for (const fcl::Contactd& end : local) {
    EXPECT_NEAR(end.penetration_depth, 0.1, 1e-9);
    EXPECT_TRUE(end.normal.isApprox(-Vec3::UnitX()));
  }
  EXPECT_NEAR(std::abs(local[0].pos.y() - local[1].pos.y()), 2, 1e-9);
  EXPECT_NEAR(contacts(slot, tight, 1).at(0).penetration_depth, 2, 1e-9);
}

TEST_F(Contact, ofContainmentHasDepth) {
  const Shape<double> small = rectangular(0.5, 0.75, 1, 1);
  for (const std::size_t most : {1U, 9U}) {
    const auto found = contactsOf(*square_, kHere, *small, kHere, most);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NEAR(found[0].penetration_depth, 1, 1e-9);
    EXPECT_NEAR(std::abs(found[0].normal.x() + found[0].normal.y()), 1, 1e-9);
  }
}

/// A crate on a floor: the faces lie upon each other from x = 1.5 to 2.5, whatever comes first. Of one contact that is
/// the middle, of two both ends.
TEST_F(Contact, ofFacesIsInTheirMiddleOrAtBothEnds) {
  const auto shapes = [](const Ring& ring) {
    std::vector<Shape<double>> all;
    for (std::size_t first = 0; first < ring.size(); ++first) {
      Ring turned = ring;
      std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(first), turned.end());
      all.push_back(shapeOf(Polygon({turned})));
      std::reverse(turned.begin(), turned.end());
      all.push_back(shapeOf(Polygon({turned})));
    }
    return all;
  };
  const auto floors = shapes({{-10, -0.5}, {10, -0.5}, {10, 0.5}, {3, 0.5}, {2.2, 0.5}, {-10, 0.5}}),
             crates = shapes({{-0.5, -0.5}, {0.1, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}),
             notched = shapes({{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {0, 0.25}, {-0.5, 0.5}});  // not convex
  const Transform there = lifted(0, 2, 0.99);
  for (const auto& floor : floors)
    for (const auto* kind : {&crates, &notched})
      for (const auto& crate : *kind)
        for (const std::size_t most : {1U, 2U})
          for (const auto& found :
               {contactsOf(*floor, kHere, *crate, there, most), contactsOf(*crate, there, *floor, kHere, most)}) {
            ASSERT_EQ(found.size(), most);
            Vec3 middle = Vec3::Zero();
            for (const fcl::Contactd& contact : found) {
              middle += contact.pos / static_cast<double>(most);
              EXPECT_NEAR(contact.penetration_depth, 0.01, 1e-12);
              EXPECT_NEAR(std::abs(contact.pos.x() - 2), most == 1 ? 0 : 0.5, 1e-12);
            }
            EXPECT_LT((middle - Vec3(2, 0.495, 0)).norm(), 1e-12) << middle.transpose();
          }
}

/// The deepest first, and one of each component's as deep as the component: of flat ones, too, whose ends may be less
/// deep.
TEST_F(Contact, ofFacesAreInOrderAndAsDeepAsTheirComponents) {
  Random random(44);
  int flat_ones = 0;
  const auto check = [&](const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b) {
    const auto parts = tricover::contacts(a, pose_a, b, pose_b, {0, 99, tricover::ContactDetail::LocalDepth});
    for (const std::size_t most : {2U, 3U, 4U, 99U}) {
      const auto found = contactsOf(*shapeOf(a), lifted(pose_a), *shapeOf(b), lifted(pose_b), most);
      ASSERT_GE(found.size(), std::min<std::size_t>(most, parts.size()));
      ASSERT_LE(found.size(), most);
      for (std::size_t k = 1; k < found.size(); ++k)
        ASSERT_GE(found[k - 1].penetration_depth, found[k].penetration_depth);
      for (std::size_t k = 0; k < std::min(most, parts.size()); ++k) {
        ASSERT_TRUE(std::any_of(found.begin(), found.end(), [&](const fcl::Contactd& contact) {
          return contact.penetration_depth == parts[k].depth && contact.b1 == parts[k].edge_a;
        })) << k;
        if (most < 99 || parts[k].count < 2) continue;
        ++flat_ones;
        EXPECT_NEAR(parts[k].points[0].depth, parts[k].depth, 1e-9);
        for (const tricover::ContactPoint& end : parts[k].points)
          ASSERT_TRUE(std::any_of(found.begin(), found.end(), [&](const fcl::Contactd& contact) {
            return (contact.pos.head<2>() - end.point).norm() < 1e-9;
          })) << k;
      }
    }
  };
  const Pose here = flat(kHere);
  check(Polygon({{{-2, 0}, {2, 0}, {2, 2}, {1, 2}, {1, 1}, {-1, 1}, {-1, 2}, {-2, 2}}}), here,
        Polygon({{{-1.25, 0.5}, {-1, 1.25}, {1, 1}, {2, 1.25}}}), here);
  const auto onGrid = [&](int corners) {
    Ring ring;
    for (int k = 0; k < corners; ++k) ring.emplace_back(random.integer(-8, 8) / 4.0, random.integer(-8, 8) / 4.0);
    return ring;
  };
  for (int i = 0; i < std::max(100, scaledCount(300)); ++i) {
    SCOPED_TRACE(i);
    check(Polygon({onGrid(8)}), here, Polygon({onGrid(random.integer(3, 6))}), here);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(flat_ones, 20);
}

TEST_F(Contact, ofATouchHasDepthZero) {
  for (const std::size_t most : {1U, 9U}) {
    const auto found = contactsOf(*square_, kHere, *other_, lifted(0, 2, 0), most);
    ASSERT_EQ(found.size(), std::min<std::size_t>(most, 2));
    EXPECT_EQ(found[0].penetration_depth, 0);
    EXPECT_TRUE(found[0].normal.isApprox(Vec3::UnitX()));
    EXPECT_NEAR(found[0].pos.x(), 2, 1e-12);
  }
}

TEST_F(Contact, ofHugePolygonsIsFinite) {
  const Shape<double> huge = rectangular(-1e300, -1e300, 1e300, 1e300);
  for (const std::size_t most : {1U, 9U}) {
    const auto found = contactsOf(*huge, lifted(0, -9e299, 0), *huge, lifted(0, 9e299, 0), most);
    ASSERT_EQ(found.size(), std::min<std::size_t>(most, 2));
    EXPECT_TRUE(found[0].normal.isApprox(Vec3::UnitX()));
    EXPECT_TRUE(found[0].pos.allFinite());
    EXPECT_NEAR(found[0].penetration_depth, 2e299, 1e288);
  }
}

TEST_F(Contact, accumulatesUpToTheNumberAskedFor) {
  const fcl::CollisionRequestd request(2);
  EXPECT_EQ(collide(1, request), 1u);
  EXPECT_EQ(collide(9, request), 1u);  // a miss takes nothing away
  EXPECT_EQ(collide(1, request), 2u);
  EXPECT_EQ(collide(1, request), 2u);
}

TEST_F(Contact, costIsTheOverlapTimesTheDensities) {
  fcl::CollisionRequestd request(1, false, 3, true);
  other_->cost_density = 0.5;
  EXPECT_EQ(collide(1.5, request), 0u);
  ASSERT_EQ(result_.numCostSources(), 1u);
  std::vector<fcl::CostSourced> costs;
  result_.getCostSources(costs);
  EXPECT_EQ(costs[0].total_cost, 0.5 * 1 * 1 * 0.5);  // 0.5 x 1 in the plane, 1 thick, densities 1 and 0.5
  EXPECT_EQ(collide(9, request), 0u);
  EXPECT_EQ(result_.numCostSources(), 1u);

  other_->cost_density = 1;
  EXPECT_EQ(collide(1.5, request), 1u);
  EXPECT_EQ(collide(1.5, request), 1u);  // no room for a second contact; the same cost source is one
  EXPECT_EQ(result_.numCostSources(), 2u);
}

}  // namespace
}  // namespace tricover_fcl::test
