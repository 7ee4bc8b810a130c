// SPDX-License-Identifier: BSD-3-Clause
// What a hit leaves in FCL's result.
#include <fcl/narrowphase/collision.h>

#include "scene.h"
#include "tricover/contacts.h"

namespace tricover_fcl::test {
namespace {

class Contact : public ::testing::Test {
 protected:
  std::size_t collide(double x, const fcl::CollisionRequestd& request, double z = 0) {
    return fcl::collide(square_.get(), fcl::Transform3d::Identity(), other_.get(),
                        lifted(tricover::support::pose(0, x, 0), z), request, result_);
  }

  Shape<double> square_ = shapeOf(tricover::Polygon({tricover::support::rectangle(0, 0, 2, 2)}));
  Shape<double> other_ = shapeOf(tricover::Polygon({tricover::support::rectangle(0, 0.5, 2, 1.5)}));
  fcl::CollisionResultd result_;
};

TEST_F(Contact, isAddedWithoutDetailsUnlessAskedFor) {
  EXPECT_EQ(collide(1, fcl::CollisionRequestd()), 1u);
  const fcl::Contactd& contact = result_.getContact(0);
  EXPECT_EQ(contact.o1, square_.get());
  EXPECT_EQ(contact.o2, other_.get());
  EXPECT_EQ(contact.b1, int{fcl::Contactd::NONE});
  EXPECT_EQ(contact.b2, int{fcl::Contactd::NONE});
  EXPECT_EQ(contact.penetration_depth, 0);
}

TEST_F(Contact, hasPlaceEdgesAndNormalInTheWorld) {
  EXPECT_EQ(fcl::collide(square_.get(), lifted(tricover::support::pose(0, 10, 20), 5), other_.get(),
                         lifted(tricover::support::pose(0, 11, 20), 5), fcl::CollisionRequestd(1, true), result_),
            1u);
  const fcl::Contactd& contact = result_.getContact(0);
  EXPECT_EQ(contact.o1, square_.get());
  EXPECT_EQ(contact.o2, other_.get());
  EXPECT_EQ(contact.pos.z(), 5);
  EXPECT_TRUE(contact.normal.isApprox(fcl::Vector3d::UnitX()));
  EXPECT_EQ(contact.penetration_depth, 0);
  // The edges named cross at the place named: other_'s long edges cross square_'s right side.
  EXPECT_EQ(contact.b1, 1);
  EXPECT_TRUE(contact.b2 == 0 || contact.b2 == 2) << contact.b2;
  EXPECT_EQ(contact.pos.x(), 12);
  EXPECT_EQ(contact.pos.y(), contact.b2 == 0 ? 20.5 : 21.5);
}

TEST_F(Contact, swapsWithTheArguments) {
  const fcl::CollisionRequestd request(1, true);
  fcl::CollisionResultd swapped;
  ASSERT_EQ(collide(1, request), 1u);
  ASSERT_EQ(fcl::collide(other_.get(), lifted(tricover::support::pose(0, 1, 0)), square_.get(),
                         fcl::Transform3d::Identity(), request, swapped),
            1u);
  EXPECT_EQ(swapped.getContact(0).o1, other_.get());
  EXPECT_TRUE(swapped.getContact(0).normal.isApprox(-result_.getContact(0).normal));
}

TEST_F(Contact, ofContainmentNamesTheContainedVertex) {
  const Shape<double> small = shapeOf(tricover::Polygon({tricover::support::rectangle(0.5, 0.5, 1, 1)}));
  ASSERT_EQ(fcl::collide(square_.get(), fcl::Transform3d::Identity(), small.get(), fcl::Transform3d::Identity(),
                         fcl::CollisionRequestd(1, true), result_),
            1u);
  const fcl::Contactd& contact = result_.getContact(0);
  EXPECT_EQ(contact.b1, -1);
  ASSERT_GE(contact.b2, 0);
  const tricover::Vec2 vertex = small->polygon().edgeStart(static_cast<std::size_t>(contact.b2));
  EXPECT_EQ(contact.pos, fcl::Vector3d(vertex.x(), vertex.y(), 0));
}

TEST_F(Contact, normalIsAUnitVectorEvenBetweenCoincidingOrigins) {
  ASSERT_EQ(collide(0, fcl::CollisionRequestd(1, true)), 1u);
  EXPECT_EQ(result_.getContact(0).normal, fcl::Vector3d::UnitX());
}

TEST_F(Contact, normalOfHugePolygonsIsFinite) {
  const Shape<double> huge = shapeOf(tricover::Polygon({tricover::support::rectangle(-1e300, -1e300, 1e300, 1e300)}));
  ASSERT_EQ(fcl::collide(huge.get(), lifted(tricover::support::pose(0, -9e299, 0)), huge.get(),
                         lifted(tricover::support::pose(0, 9e299, 0)), fcl::CollisionRequestd(1, true), result_),
            1u);
  EXPECT_TRUE(result_.getContact(0).normal.isApprox(fcl::Vector3d::UnitX()));
  EXPECT_TRUE(result_.getContact(0).pos.allFinite());
}

TEST_F(Contact, accumulatesUpToTheNumberAskedFor) {
  const fcl::CollisionRequestd request(2);
  EXPECT_EQ(collide(1, request), 1u);
  EXPECT_EQ(collide(9, request), 1u);  // a miss takes nothing away
  EXPECT_EQ(collide(1, request), 2u);
  EXPECT_EQ(collide(1, request), 2u);
}

TEST_F(Contact, satisfiedRequestIsLeftAlone) {
  ASSERT_EQ(collide(1, fcl::CollisionRequestd()), 1u);
  fcl::Transform3d bad = fcl::Transform3d::Identity();
  bad.translation().x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(fcl::collide(square_.get(), bad, other_.get(), bad, fcl::CollisionRequestd(), result_), 1u);
}

TEST_F(Contact, needsBothOccupied) {
  other_->cost_density = 0.5;  // uncertain: neither free nor occupied
  ASSERT_TRUE(other_->isUncertain());
  EXPECT_EQ(collide(1, fcl::CollisionRequestd()), 0u);
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
