// SPDX-License-Identifier: BSD-3-Clause
// Shapes of complements, which have no end, and negative margins: overlap that is allowed.
#include <string>

#include "mixed_scene.h"
#include "motions.h"
#include "tricover/polygon.h"

namespace tricover_fcl::test {
namespace {

const Polygon kRoom({rectangle(-5, -5, 5, 5), rectangle(2, 2, 3, 3)});
const Shape<double> kOutside = shapeOf(kRoom.complement()), kVehicle = rectangular(-0.5, -0.5, 0.5, 0.5);

TEST(Complement, holdsWhatIsInside) {
  EXPECT_FALSE(meet(kOutside, kHere, kVehicle, lifted(0.3, 0, 0)));
  EXPECT_TRUE(meet(kOutside, kHere, kVehicle, lifted(0, 4.5, 0)));
  EXPECT_FALSE(meet(kOutside, kHere, kVehicle, lifted(0, nudged(4.5, -1), 0)));
  EXPECT_TRUE(meet(kOutside, kHere, kVehicle, lifted(0, 2.5, 2.5)));
  EXPECT_TRUE(meet(kOutside, kHere, kVehicle, lifted(0, 1e15, -1e15)));
  EXPECT_TRUE(meet(kOutside, lifted(1, 100, 0), kVehicle, kHere));
  EXPECT_TRUE(meet(kOutside, kHere, kOutside, lifted(0.5, 1, 1)));
  EXPECT_FALSE(meet(kOutside, kHere, kVehicle, lifted(0, 4.5, 0, 1)));  // above it
  EXPECT_TRUE(meet(withMargin(kRoom.complement(), 0.5), kHere, kVehicle, lifted(0, 4, 0)));
  EXPECT_FALSE(meet(withMargin(kRoom.complement(), 0.5), kHere, kVehicle, lifted(0, 3.9, 0)));
  EXPECT_TRUE(meet(shapeOf<float>(kRoom.complement()), lifted<float>(0, 0, 0),
                   withMargin<float>(tricover::Polygon::box(1, 1), 0), lifted<float>(0, 4.5, 0)));
}

TEST(Complement, distancesContactsAndImpacts) {
  for (const fcl::GJKSolverType solver : kSolvers) {
    EXPECT_EQ(distanceOf(solver, false, kOutside, kHere, kVehicle, lifted(0, 3.5, -1)).min_distance, 1);
    EXPECT_EQ(distanceOf(solver, true, kVehicle, lifted(0, -3.5, -1), kOutside, kHere).min_distance, 1);
    EXPECT_EQ(distanceOf(solver, false, kOutside, kHere, kVehicle, lifted(0, 4.5, 0)).min_distance, 0);
    EXPECT_EQ(distanceOf(solver, false, kOutside, kHere, kVehicle, lifted(0, 4.75, 0)).min_distance, -1);
    EXPECT_THROW(distanceOf(solver, true, kOutside, kHere, kVehicle, lifted(0, 4.75, 0)), std::invalid_argument);
  }
  for (const std::size_t most : {std::size_t{1}, std::size_t{4}}) {
    const auto contacts = contactsOf(kOutside, kHere, kVehicle, lifted(0, 4.75, 0), most);
    ASSERT_GE(contacts.size(), 1u);
    EXPECT_NEAR(contacts[0].penetration_depth, 0.25, 1e-12);
    EXPECT_NEAR(contacts[0].normal.x(), -1, 1e-12);
  }
  const Impact result = impactOf(kOutside, kRests, kVehicle, Slide(lifted(0, -4, 0), lifted(0, 6, 0)));
  EXPECT_NEAR(result.time_of_contact, 0.85, 2e-9);
  EXPECT_TRUE(result.is_collide);
}

TEST(Complement, besideOtherGeometries) {
  const fcl::Sphered ball(0.5);
  EXPECT_FALSE(meet(kOutside, kHere, ball, lifted(0, 4.4, 0)));
  EXPECT_TRUE(meet(kOutside, kHere, ball, lifted(0, 4.6, 0)));
  EXPECT_TRUE(meet(kOutside, kHere, ball, lifted(0, 1e9, 0)));
  const auto contacts = contactsOf(kOutside, kHere, ball, lifted(0, 4.6, 0), 4);
  ASSERT_EQ(contacts.size(), 1u);
  EXPECT_NEAR(contacts[0].penetration_depth, 0.1, 1e-12);
  EXPECT_NEAR(contacts[0].normal.x(), -1, 1e-12);
  fcl::CollisionRequestd request(1, false, 4, true);
  fcl::CollisionResultd result;
  fcl::collide<double>(kOutside.get(), kHere, &ball, lifted(0, 4.6, 0), request, result);
  EXPECT_EQ(result.numCostSources(), 1u);
}

/// Every geometry that has no exact region in the plane is refused by its name, in all queries, with what to do.
TEST(Complement, namesTheGeometriesThatItDoesNotMeet) {
  const Transform here = lifted(0, 1, 0), tilted = placed({0, 1, 0}, turned(1, Vec3::UnitX()));
  const fcl::Sphered ball(0.5);
  fcl::BVHModel<fcl::OBBRSSd> mesh;
  mesh.beginModel();
  mesh.addTriangle({0, 0, -1}, {1, 0, 0}, {0, 1, 1});
  mesh.endModel();
  struct Case {
    const Body& other;
    Transform pose;
    const char* name;
  };
  const Case cases[] = {{fcl::Boxd(1, 1, 1), here, "fcl::Box<double>"},
                        {fcl::Coned(1, 1), here, "fcl::Cone<double>"},
                        {fcl::Ellipsoidd(1, 1, 1), here, "fcl::Ellipsoid<"},
                        {fcl::Halfspaced(0, 1, 0, 0), here, "fcl::Halfspace<double>"},
                        {fcl::Planed(0, 1, 0, 0), here, "fcl::Plane<double>"},
                        {fcl::Cylinderd(1, 1), tilted, "fcl::Cylinder<double>"},
                        {mesh, here, "fcl::BVHModel<fcl::OBB"},
                        {ball, lifted(0, 1, 0, 3), "fcl::Sphere<double>"}};
  for (const Case& c : cases) {
    SCOPED_TRACE(c.name);
    const auto expectNamed = [&](const auto& query) {
      expectRefused<std::logic_error>(
          {std::string("a complement does not meet ") + c.name, "make the other geometry a PolygonShape"}, query);
    };
    expectNamed([&] { distanceOf(fcl::GST_LIBCCD, false, kOutside, kHere, c.other, c.pose); });
    if (&c.other == &ball) continue;  // above it: the two do not collide, but how far are they?
    expectNamed([&] { collides(kOutside, kHere, c.other, c.pose); });
    expectNamed([&] { collides(c.other, c.pose, kOutside, kHere); });
    expectNamed([&] { impactOf(kOutside, kRests, c.other, Slide(c.pose, c.pose), advancing(1e-6)); });
  }
}

TEST(NegativeMargin, allowsOverlap) {
  const Polygon square({rectangle(0, 0, 1, 1)});
  const Shape<double> plain = shapeOf(square), allowing = withMargin(square, -0.25);
  EXPECT_FALSE(meet(plain, kHere, allowing, lifted(0, 0.875, 0)));
  EXPECT_TRUE(meet(plain, kHere, allowing, lifted(0, 0.625, 0)));
  EXPECT_TRUE(meet(withMargin(square, 0.25), kHere, allowing, lifted(0, 1, 0)));  // the sum counts
  const auto contacts = contactsOf(plain, kHere, allowing, lifted(0, 0.625, 0), 1);
  ASSERT_EQ(contacts.size(), 1u);
  EXPECT_NEAR(contacts[0].penetration_depth, 0.125, 1e-12);
  EXPECT_THROW(distanceOf(fcl::GST_LIBCCD, false, plain, kHere, allowing, lifted(0, 3, 0)), std::invalid_argument);
  // Discs, whose shapes are decided by their margins.
  const Shape<double> dot = withMargin(tricover::Polygon::point({0, 0}), -0.5);
  EXPECT_FALSE(meet(dot, kHere, dot, lifted(0, 0.125, 0)));
  const Slide comes(lifted(0, 3, 0), lifted(0, -1, 0)), slides(lifted(0, -3, 1), lifted(0, 3, 1));
  EXPECT_NEAR(impactOf(plain, kRests, allowing, comes, advancing(1e-6)).time_of_contact, 2.25 / 4, 2e-6);
  EXPECT_FALSE(impactOf(plain, kRests, allowing, slides, advancing(1e-6)).is_collide);
}

}  // namespace
}  // namespace tricover_fcl::test
