// SPDX-License-Identifier: BSD-3-Clause
// Shapes of complements, which have no end, and negative margins: overlap that is allowed.
#include <fcl/broadphase/broadphase_SaP.h>
#include <fcl/broadphase/broadphase_bruteforce.h>
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/broadphase/default_broadphase_callbacks.h>
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/cone.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/ellipsoid.h>
#include <fcl/geometry/shape/halfspace.h>
#include <fcl/geometry/shape/plane.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/math/motion/translation_motion.h>

#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "ask.h"
#include "tricover/segment.h"
#include "tricover_fcl/polygon_object.h"
#include "tricover_fcl/scene_manager.h"

namespace tricover_fcl::test {
namespace {

const tricover::Polygon kRoom({rectangle(-5, -5, 5, 5), rectangle(2, 2, 3, 3)});

template <typename S = double>
Shape<S> shapeWith(const tricover::Polygon& polygon, double margin) {
  return std::make_shared<PolygonShape<S>>(polygon, PolygonOptions{margin, 0, 0});
}

TEST(Complement, holdsWhatIsInside) {
  const Shape<double> outside = shapeOf(kRoom.complement()), vehicle = rectangular(-0.5, -0.5, 0.5, 0.5);
  const auto still = lifted(0, 0, 0);
  EXPECT_FALSE(meet(outside, still, vehicle, lifted(0.3, 0, 0)));
  EXPECT_TRUE(meet(outside, still, vehicle, lifted(0, 4.5, 0)));
  EXPECT_FALSE(meet(outside, still, vehicle, lifted(0, tricover::support::nudged(4.5, -1), 0)));
  EXPECT_TRUE(meet(outside, still, vehicle, lifted(0, 2.5, 2.5)));
  EXPECT_TRUE(meet(outside, still, vehicle, lifted(0, 1e15, -1e15)));
  EXPECT_TRUE(meet(outside, lifted(1, 100, 0), vehicle, still));
  EXPECT_TRUE(meet(outside, still, outside, lifted(0.5, 1, 1)));
  EXPECT_FALSE(meet(outside, still, vehicle, lifted(0, 4.5, 0, 1)));  // above it
  EXPECT_TRUE(meet(shapeWith(kRoom.complement(), 0.5), still, vehicle, lifted(0, 4, 0)));
  EXPECT_FALSE(meet(shapeWith(kRoom.complement(), 0.5), still, vehicle, lifted(0, 3.9, 0)));
  EXPECT_TRUE(meet(shapeOf<float>(kRoom.complement()), lifted<float>(0, 0, 0), shapeWith<float>(tricover::box(1, 1), 0),
                   lifted<float>(0, 4.5, 0)));
}

TEST(Complement, distancesContactsAndImpacts) {
  const Shape<double> outside = shapeOf(kRoom.complement()), vehicle = rectangular(-0.5, -0.5, 0.5, 0.5);
  const auto still = lifted(0, 0, 0);
  for (const fcl::GJKSolverType solver : kSolvers) {
    EXPECT_EQ(distanceOf<double>(solver, false, *outside, still, *vehicle, lifted(0, 3.5, -1)).min_distance, 1);
    EXPECT_EQ(distanceOf<double>(solver, true, *vehicle, lifted(0, -3.5, -1), *outside, still).min_distance, 1);
    EXPECT_EQ(distanceOf<double>(solver, false, *outside, still, *vehicle, lifted(0, 4.5, 0)).min_distance, 0);
    EXPECT_EQ(distanceOf<double>(solver, false, *outside, still, *vehicle, lifted(0, 4.75, 0)).min_distance, -1);
    EXPECT_THROW(distanceOf<double>(solver, true, *outside, still, *vehicle, lifted(0, 4.75, 0)),
                 std::invalid_argument);
  }
  for (const std::size_t most : {std::size_t{1}, std::size_t{4}}) {
    const auto contacts = contactsOf(*outside, still, *vehicle, lifted(0, 4.75, 0), most);
    ASSERT_GE(contacts.size(), 1u);
    EXPECT_NEAR(contacts[0].penetration_depth, 0.25, 1e-12);
    EXPECT_NEAR(contacts[0].normal.x(), -1, 1e-12);
  }
  const fcl::TranslationMotion<double> rests(still, still), drives(lifted(0, -4, 0), lifted(0, 6, 0));
  fcl::ContinuousCollisionResultd result;
  EXPECT_NEAR(fcl::continuousCollide(outside.get(), &rests, vehicle.get(), &drives, advancing(1e-9), result), 0.85,
              2e-9);
  EXPECT_TRUE(result.is_collide);
}

TEST(Complement, besideOtherGeometries) {
  const Shape<double> outside = shapeOf(kRoom.complement());
  const fcl::Sphered ball(0.5);
  const auto still = lifted(0, 0, 0);
  EXPECT_FALSE(meet<double>(*outside, still, ball, lifted(0, 4.4, 0)));
  EXPECT_TRUE(meet<double>(*outside, still, ball, lifted(0, 4.6, 0)));
  EXPECT_TRUE(meet<double>(*outside, still, ball, lifted(0, 1e9, 0)));
  const auto contacts = contactsOf(*outside, still, ball, lifted(0, 4.6, 0), 4);
  ASSERT_EQ(contacts.size(), 1u);
  EXPECT_NEAR(contacts[0].penetration_depth, 0.1, 1e-12);
  EXPECT_NEAR(contacts[0].normal.x(), -1, 1e-12);
  fcl::CollisionRequestd request(1, false, 4, true);
  fcl::CollisionResultd result;
  fcl::collide<double>(outside.get(), still, &ball, lifted(0, 4.6, 0), request, result);
  EXPECT_EQ(result.numCostSources(), 1u);
}

/// Every geometry that has no exact region in the plane is refused by its name, in all queries, with what to do.
TEST(Complement, namesTheGeometriesThatItDoesNotMeet) {
  const Shape<double> outside = shapeOf(kRoom.complement());
  const auto still = lifted(0, 0, 0), here = lifted(0, 1, 0);
  const auto tilted = [&] {
    fcl::Transform3d pose = here;
    pose.linear() = fcl::AngleAxis<double>(1, fcl::Vector3d::UnitX()).toRotationMatrix();
    return pose;
  }();
  const fcl::Boxd box(1, 1, 1);
  const fcl::Coned cone(1, 1);
  const fcl::Ellipsoidd ellipsoid(1, 1, 1);
  const fcl::Halfspaced halfspace(fcl::Vector3d(0, 1, 0), 0);
  const fcl::Planed plane(fcl::Vector3d(0, 1, 0), 0);
  const fcl::Cylinderd cylinder(1, 1);
  const fcl::Sphered ball(0.5);
  fcl::BVHModel<fcl::OBBRSSd> mesh;
  mesh.beginModel();
  mesh.addTriangle({0, 0, -1}, {1, 0, 0}, {0, 1, 1});
  mesh.endModel();
  struct Case {
    const fcl::CollisionGeometryd& other;
    fcl::Transform3d pose;
    const char* name;
  };
  const Case cases[] = {{box, here, "fcl::Box<double>"},        {cone, here, "fcl::Cone<double>"},
                        {ellipsoid, here, "fcl::Ellipsoid<"},   {halfspace, here, "fcl::Halfspace<double>"},
                        {plane, here, "fcl::Plane<double>"},    {cylinder, tilted, "fcl::Cylinder<double>"},
                        {mesh, here, "fcl::BVHModel<fcl::OBB"}, {ball, lifted(0, 1, 0, 3), "fcl::Sphere<double>"}};
  for (const Case& c : cases) {
    SCOPED_TRACE(c.name);
    const auto expectRefused = [&](const auto& query) {
      const std::string text = thrownBy<std::logic_error>(query);
      EXPECT_NE(text.find(std::string("a complement does not meet ") + c.name), std::string::npos) << text;
      EXPECT_NE(text.find("make the other geometry a PolygonShape"), std::string::npos) << text;
    };
    expectRefused([&] { distanceOf<double>(fcl::GST_LIBCCD, false, *outside, still, c.other, c.pose); });
    if (&c.other == &ball) continue;  // above it: the two do not collide, but how far are they?
    for (const bool swaps : {false, true})
      expectRefused([&] {
        swaps ? collides<double>(c.other, c.pose, *outside, still) : collides<double>(*outside, still, c.other, c.pose);
      });
    const fcl::TranslationMotiond rests(still, still), comes(c.pose, c.pose);
    fcl::ContinuousCollisionResultd result;
    expectRefused([&] { fcl::continuousCollide(outside.get(), &rests, &c.other, &comes, advancing(1e-6), result); });
  }
}

/// As many pairs as brute force sees.
TEST(Complement, inManagers) {
  const Shape<double> outside = shapeOf(kRoom.complement()), vehicle = rectangular(-0.5, -0.5, 0.5, 0.5);
  fcl::DynamicAABBTreeCollisionManagerd tree;
  fcl::SaPCollisionManagerd sweep;
  fcl::NaiveCollisionManagerd naive;
  SceneManager<double> scene;
  std::vector<std::unique_ptr<fcl::CollisionObjectd>> objects;
  objects.push_back(std::make_unique<fcl::CollisionObjectd>(outside, lifted(0.5, 1, 0)));
  for (int i = 0; i < 40; ++i)
    objects.push_back(std::make_unique<fcl::CollisionObjectd>(vehicle, lifted(0.1 * i, 4.0 * i - 80, 0.7 * i - 14)));
  std::vector<fcl::CollisionObjectd*> all;
  for (const auto& object : objects) all.push_back(object.get());
  for (fcl::BroadPhaseCollisionManagerd* manager :
       std::initializer_list<fcl::BroadPhaseCollisionManagerd*>{&tree, &sweep, &naive, &scene})
    manager->registerObjects(all);
  const auto hitsOf = [](fcl::BroadPhaseCollisionManagerd& manager) {
    manager.setup();
    fcl::DefaultCollisionData<double> data;
    data.request = fcl::CollisionRequestd(1000);
    manager.collide(&data, fcl::DefaultCollisionFunction<double>);
    return data.result.numContacts();
  };
  const std::size_t truth = hitsOf(naive);
  EXPECT_GT(truth, 30u);
  EXPECT_LT(truth, 40u);
  EXPECT_EQ(hitsOf(tree), truth);
  EXPECT_EQ(hitsOf(sweep), truth);
  EXPECT_EQ(hitsOf(scene), truth);
  const PolygonObject<double> tight(outside, lifted(0.5, 1, 0));
  EXPECT_TRUE(tight.getAABB().overlap(objects.back()->getAABB()));
}

TEST(NegativeMargin, allowsOverlap) {
  const tricover::Polygon square({rectangle(0, 0, 1, 1)});
  const Shape<double> plain = shapeOf(square), allowing = shapeWith(square, -0.25);
  const auto still = lifted(0, 0, 0);
  EXPECT_FALSE(meet(plain, still, allowing, lifted(0, 0.875, 0)));
  EXPECT_TRUE(meet(plain, still, allowing, lifted(0, 0.625, 0)));
  EXPECT_TRUE(meet(shapeWith(square, 0.25), still, allowing, lifted(0, 1, 0)));  // the sum counts
  const auto contacts = contactsOf(*plain, still, *allowing, lifted(0, 0.625, 0), 1);
  ASSERT_EQ(contacts.size(), 1u);
  EXPECT_NEAR(contacts[0].penetration_depth, 0.125, 1e-12);
  EXPECT_THROW(distanceOf<double>(fcl::GST_LIBCCD, false, *plain, still, *allowing, lifted(0, 3, 0)),
               std::invalid_argument);
  // Discs, whose shapes are decided by their margins.
  const Shape<double> dot = shapeWith(tricover::point({0, 0}), -0.5);
  EXPECT_FALSE(meet(dot, still, dot, lifted(0, 0.125, 0)));
  const fcl::TranslationMotion<double> rests(still, still), comes(lifted(0, 3, 0), lifted(0, -1, 0)),
      slides(lifted(0, -3, 1), lifted(0, 3, 1));
  fcl::ContinuousCollisionResultd result;
  EXPECT_NEAR(fcl::continuousCollide(plain.get(), &rests, allowing.get(), &comes, advancing(1e-6), result), 2.25 / 4,
              2e-6);
  EXPECT_EQ(fcl::continuousCollide(plain.get(), &rests, allowing.get(), &slides, advancing(1e-6), result), 1);
  EXPECT_FALSE(result.is_collide);
}

}  // namespace
}  // namespace tricover_fcl::test
