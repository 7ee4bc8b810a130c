// SPDX-License-Identifier: BSD-3-Clause
// Every broadphase manager, FCL's and ours, with FCL's own callback finds the pairs that brute force finds.
#include <fcl/broadphase/default_broadphase_callbacks.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <set>
#include <utility>

#include "managers.h"
#include "scene.h"
#include "tricover/collide.h"

/// For LeakSanitizer: what FCL's interval trees leave behind at each setup() is not ours.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
  return "leak:fcl::IntervalTreeCollisionManager\n"
         "leak:fcl::DynamicAABBTreeCollisionManager_Array\n"
         "leak:fcl::detail::implementation_array::HierarchyTree\n";
}

namespace tricover_fcl::test {
namespace {

using Pairs = std::set<std::pair<const fcl::CollisionGeometryd*, const fcl::CollisionGeometryd*>>;

struct Scene {
  std::vector<std::unique_ptr<fcl::CollisionObjectd>> objects;

  void add(const tricover::Polygon& polygon, const tricover::Pose& pose, double z = 0) {
    objects.push_back(std::make_unique<fcl::CollisionObjectd>(shapeOf(polygon), lifted(pose, z)));
  }

  Pairs pairs() const {
    Pairs found;
    for (std::size_t i = 0; i < objects.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const auto& a = static_cast<const PolygonShaped&>(*objects[i]->collisionGeometry());
        const auto& b = static_cast<const PolygonShaped&>(*objects[j]->collisionGeometry());
        const fcl::Transform3d &tf_a = objects[i]->getTransform(), &tf_b = objects[j]->getTransform();
        if (tf_a.translation().z() == tf_b.translation().z() &&
            tricover::collide(a.polygon(), flat(tf_a), b.polygon(), flat(tf_b))) {
          found.insert(std::minmax<const fcl::CollisionGeometryd*>(&a, &b));
        }
      }
    }
    return found;
  }
};

Pairs pairsFoundBy(fcl::BroadPhaseCollisionManagerd& manager, fcl::GJKSolverType solver,
                   fcl::CollisionCallBack<double> callback) {
  fcl::DefaultCollisionData<double> data;
  data.request.num_max_contacts = std::numeric_limits<std::size_t>::max();
  data.request.gjk_solver_type = solver;
  manager.collide(&data, callback);
  Pairs found;
  for (std::size_t i = 0; i < data.result.numContacts(); ++i) {
    const fcl::Contactd& contact = data.result.getContact(i);
    found.insert(std::minmax(contact.o1, contact.o2));
  }
  return found;
}

/// All managers on the scene, before and after `move`.
void expectAgreement(Scene& scene, const std::function<void()>& move) {
  std::vector<fcl::CollisionObjectd*> objects;
  for (const auto& object : scene.objects) objects.push_back(object.get());
  std::vector<Manager> all = managersOfEveryKind();
  for (const Manager& m : all) {
    // All at once: SaP's registerObject overlooks a box that spans the new one (its own bug, with any shapes).
    m.manager->registerObjects(objects);
    m.manager->setup();
  }
  for (int frame = 0; frame < 3; ++frame) {
    const Pairs expected = scene.pairs();
    for (const Manager& m : all) {
      SCOPED_TRACE(std::string(m.name) + ", frame " + std::to_string(frame));
      EXPECT_EQ(pairsFoundBy(*m.manager, fcl::GST_LIBCCD, fcl::DefaultCollisionFunction<double>), expected);
      EXPECT_EQ(pairsFoundBy(*m.manager, fcl::GST_INDEP, fcl::DefaultCollisionFunction<double>), expected);
      EXPECT_EQ(pairsFoundBy(*m.manager, fcl::GST_LIBCCD, defaultCollisionFunction<double>), expected);
    }
    move();
    for (const auto& object : scene.objects) object->computeAABB();
    for (const Manager& m : all) {
      // SaP's update corrupts its lists where a box grows both ways, as boxes do when a rotation starts.
      if (dynamic_cast<fcl::SaPCollisionManagerd*>(m.manager.get())) {
        m.manager->clear();
        m.manager->registerObjects(objects);
      }
      m.manager->update();
    }
  }
}

TEST(Broadphase, randomScene) {
  Random random(21);
  Scene scene;
  for (int i = 0; i < 60; ++i) {
    const double angle = random.oneIn(3) ? 0 : random.real(0, 6);
    scene.add(randomPolygon(random, random.real(1, 5)),
              tricover::support::turnedAndMoved(angle, random.real(-15, 15), random.real(-15, 15)),
              random.oneIn(8) ? 0.5 : 0);
  }
  const std::size_t hits = scene.pairs().size();
  std::size_t boxes = 0;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) boxes += scene.objects[i]->getAABB().overlap(scene.objects[j]->getAABB());
  }
  EXPECT_GT(hits, boxes * 3 / 10);  // of the pairs that reach the narrowphase, many collide and many don't
  EXPECT_LT(hits, boxes * 7 / 10);
  expectAgreement(scene, [&] {
    for (const auto& object : scene.objects) {
      object->setTransform(lifted(randomPose(random, 15), object->getTranslation().z()));
    }
  });
}

TEST(Broadphase, touchingGrid) {
  // Boxes that share their bounds exactly: what a manager that sorts end points has to break ties over.
  Scene scene;
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) {
      scene.add(tricover::Polygon({rectangle(0, 0, 1, 1)}), tricover::support::turnedAndMoved(0, i, j));
    }
  }
  EXPECT_EQ(scene.pairs().size(), 2u * 6 * 5 + 2 * 5 * 5);
  expectAgreement(scene, [&] {
    for (const auto& object : scene.objects) object->setTranslation(2 * object->getTranslation());
  });
}

TEST(Broadphase, tinyRotationsCountToo) {
  // The rotation that FCL's box leaves out lifts the bar's tip into the square above it.
  Scene scene;
  scene.add(tricover::Polygon({rectangle(0, 0, 1e6, 1)}), tricover::support::turnedAndMoved(0.9e-12, 0, 0));
  scene.add(tricover::Polygon({rectangle(0, 0, 1, 1)}), tricover::support::turnedAndMoved(0, 1e6 - 1, 1 + 8e-7));
  EXPECT_EQ(scene.pairs().size(), 1u);
  expectAgreement(scene, [&] { scene.objects[0]->setRotation(fcl::Matrix3d::Identity()); });
  EXPECT_EQ(scene.pairs().size(), 0u);
}

TEST(Broadphase, extremeSizesAndOffsets) {
  // Up to 1e150: FCL's trees square the boxes' extents and crash where that overflows.
  for (const double size : {1e-300, 1e-150, 1e-6, 1e6, 1e150}) {
    SCOPED_TRACE(size);
    Random random(22);
    Scene scene;
    for (int i = 0; i < 14; ++i) {
      scene.add(randomPolygon(random, size), randomPose(random, 2 * size));
    }
    const std::size_t hits = scene.pairs().size();
    EXPECT_GT(hits, 10u);
    EXPECT_LT(hits, 80u);  // of 91
    expectAgreement(scene, [&] { scene.objects[0]->setTransform(lifted(randomPose(random, size))); });
  }
  for (const double place : {1e12, 1e14, 1e15}) {
    SCOPED_TRACE(place);
    Random random(23);
    Scene scene;
    for (int i = 0; i < 14; ++i) {
      tricover::Pose pose = randomPose(random, 2);
      pose.translation().array() += place;
      scene.add(randomPolygon(random, 1), pose);
    }
    const std::size_t hits = scene.pairs().size();
    EXPECT_GT(hits, 10u);
    EXPECT_LT(hits, 80u);
    expectAgreement(scene, [&] { scene.objects[0]->setRotation(fcl::Matrix3d::Identity()); });
  }
}

TEST(Broadphase, callbackStopsAsFclsDoes) {
  Scene scene;
  for (int i = 0; i < 5; ++i) {
    scene.add(tricover::Polygon({rectangle(0, 0, 1, 1)}), tricover::support::turnedAndMoved(0, 0.1 * i, 0));
  }
  fcl::NaiveCollisionManagerd manager;
  for (const auto& object : scene.objects) manager.registerObject(object.get());
  manager.setup();
  for (const auto callback : {fcl::DefaultCollisionFunction<double>, defaultCollisionFunction<double>}) {
    fcl::DefaultCollisionData<double> data;
    data.request.num_max_contacts = 3;
    manager.collide(&data, callback);
    EXPECT_TRUE(data.done);
    EXPECT_EQ(data.result.numContacts(), 3u);
    EXPECT_TRUE(callback(scene.objects[0].get(), scene.objects[1].get(), &data));
    EXPECT_EQ(data.result.numContacts(), 3u);
  }
}

}  // namespace
}  // namespace tricover_fcl::test
