// SPDX-License-Identifier: BSD-3-Clause
// Every broadphase manager, FCL's and ours, with FCL's own callbacks finds the pairs that brute force finds.
#include <algorithm>
#include <functional>
#include <limits>

#include "managers.h"
#include "mixed_scene.h"
#include "tricover_fcl/polygon_object.h"

/// For LeakSanitizer: what FCL's interval trees leave behind at each setup() is not ours.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
  return "leak:fcl::IntervalTreeCollisionManager\n"
         "leak:fcl::DynamicAABBTreeCollisionManager_Array\n"
         "leak:fcl::detail::implementation_array::HierarchyTree\n";
}

namespace tricover_fcl::test {
namespace {

/// Each with a geometry of its own.
struct Scene : Objects<double> {
  void add(const Polygon& polygon, const Pose& pose, double z = 0, const PolygonOptions& options = {}) {
    push_back(std::make_unique<fcl::CollisionObjectd>(shapeOf(polygon, options), lifted(pose, z)));
  }

  /// By their geometries.
  Pairs pairs() const {
    Pairs found;
    for (std::size_t i = 0; i < size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (hit(*at(i), *at(j)))
          found.insert(pairOf(at(i)->collisionGeometry().get(), at(j)->collisionGeometry().get()));
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
  for (std::size_t i = 0; i < data.result.numContacts(); ++i)
    found.insert(pairOf(data.result.getContact(i).o1, data.result.getContact(i).o2));
  EXPECT_EQ(found.size(), data.result.numContacts());
  return found;
}

/// All managers on the scene, before and after `move`; how many pairs meet at first.
std::size_t expectAgreement(const Scene& scene, int frames, const std::function<void()>& move) {
  const auto objects = pointers(scene);
  std::vector<Manager> all = managersOfEveryKind();
  for (const Manager& m : all) {
    // All at once: SaP's registerObject overlooks a box that spans the new one (its own bug, with any shapes).
    m.manager->registerObjects(objects);
    m.manager->setup();
  }
  const std::size_t at_first = scene.pairs().size();
  for (int frame = 0; frame < frames; ++frame) {
    const Pairs expected = scene.pairs();
    for (const Manager& m : all) {
      SCOPED_TRACE(std::string(m.name) + ", frame " + std::to_string(frame));
      EXPECT_EQ(pairsFoundBy(*m.manager, fcl::GST_LIBCCD, fcl::DefaultCollisionFunction<double>), expected);
      EXPECT_EQ(pairsFoundBy(*m.manager, fcl::GST_INDEP, fcl::DefaultCollisionFunction<double>), expected);
      EXPECT_EQ(pairsFoundBy(*m.manager, fcl::GST_LIBCCD, defaultCollisionFunction<double>), expected);
    }
    if (frame + 1 == frames) break;
    move();
    for (const auto& object : scene) object->computeAABB();
    for (const Manager& m : all) {
      // SaP's update corrupts its lists where a box grows both ways, as boxes do when a rotation starts.
      if (dynamic_cast<fcl::SaPCollisionManagerd*>(m.manager.get())) {
        m.manager->clear();
        m.manager->registerObjects(objects);
      }
      m.manager->update();
    }
  }
  return at_first;
}

TEST(Broadphase, randomScene) {
  Random random(21);
  Scene scene;
  for (int i = 0; i < 60; ++i) {
    const double angle = random.oneIn(3) ? 0 : random.real(0, 6);
    scene.add(randomPolygon(random, random.real(1, 5)),
              turnedAndMoved(angle, random.real(-15, 15), random.real(-15, 15)), random.oneIn(8) ? 0.5 : 0);
  }
  std::size_t boxes = 0;
  for (const auto& p : scene)
    for (const auto& q : scene) boxes += p < q && p->getAABB().overlap(q->getAABB());
  const std::size_t hits = expectAgreement(scene, 3, [&] {
    for (const auto& object : scene) object->setTransform(lifted(randomPose(random, 15), object->getTranslation().z()));
  });
  EXPECT_GT(hits, boxes * 3 / 10);  // of the pairs that reach the narrowphase, many collide and many don't
  EXPECT_LT(hits, boxes * 7 / 10);
}

TEST(Broadphase, touchingGrid) {
  // Boxes that share their bounds exactly: what a manager that sorts end points has to break ties over.
  Scene scene;
  for (int i = 0; i < 36; ++i) scene.add(Polygon({rectangle(0, 0, 1, 1)}), turnedAndMoved(0, i / 6, i % 6));
  const std::size_t hits = expectAgreement(scene, 3, [&] {
    for (const auto& object : scene) object->setTranslation(2 * object->getTranslation());
  });
  EXPECT_EQ(hits, 2u * 6 * 5 + 2 * 5 * 5);
}

TEST(Broadphase, tinyRotationsCountToo) {
  // The rotation that FCL's box leaves out lifts the bar's tip into the square above it.
  Scene scene;
  scene.add(Polygon({rectangle(0, 0, 1e6, 1)}), turnedAndMoved(0.9e-12, 0, 0));
  scene.add(Polygon({rectangle(0, 0, 1, 1)}), turnedAndMoved(0, 1e6 - 1, 1 + 8e-7));
  EXPECT_EQ(expectAgreement(scene, 3, [&] { scene[0]->setRotation(fcl::Matrix3d::Identity()); }), 1u);
  EXPECT_EQ(scene.pairs().size(), 0u);
}

TEST(Broadphase, extremeSizesAndOffsets) {
  // Up to 1e150: FCL's trees square the boxes' extents and crash where that overflows.
  for (const auto& [size, place] : {std::pair(1e-300, 0.0),
                                    {1e-150, 0.0},
                                    {1e-6, 0.0},
                                    {1e6, 0.0},
                                    {1e150, 0.0},
                                    {1.0, 1e12},
                                    {1.0, 1e14},
                                    {1.0, 1e15}}) {
    SCOPED_TRACE(testing::Message() << size << " " << place);
    Random random(place > 0 ? 23 : 22);
    Scene scene;
    for (int i = 0; i < 14; ++i) {
      Pose there = randomPose(random, 2 * size);
      there.translation().array() += place;
      scene.add(randomPolygon(random, size), there);
    }
    const std::size_t hits = expectAgreement(scene, 3, [&, size = size, place = place] {
      if (place > 0)
        scene[0]->setRotation(fcl::Matrix3d::Identity());
      else
        scene[0]->setTransform(lifted(randomPose(random, size)));
    });
    EXPECT_GT(hits, 10u);
    EXPECT_LT(hits, 80u);  // of 91
  }
}

/// Prisms of few heights, which touch; and all heights, some turned, some not, at slightly different z.
TEST(Broadphase, heights) {
  Random random(32);
  std::size_t hits = 0, scenes = static_cast<std::size_t>(scaledCount(40));
  for (std::size_t k = 0; k <= scenes; ++k) {
    SCOPED_TRACE(k);
    const bool at_all = k == scenes;
    Scene scene;
    for (int i = 0; i < (at_all ? 60 : 12); ++i) {
      const double low = random.integer(-2, 2) * 0.1, high = low + random.integer(0, 3) * 0.1;
      Pose place = randomPose(random, at_all ? 5 : 1.5);
      if (random.coin()) place.linear().setIdentity();
      scene.add(randomPolygon(random, 1), place, at_all ? random.real(-0.5, 0.5) : random.integer(-4, 4) * 0.1,
                at_all ? PolygonOptions::atAllHeights(0.1) : PolygonOptions{0, low, high});
      EXPECT_LT(scene.back()->collisionGeometry()->aabb_radius, 2);
    }
    const std::size_t found = expectAgreement(scene, 1, [] {});
    if (at_all) {
      EXPECT_GT(found, 60u * 59 / 2 / 50);
      EXPECT_LT(found, 60u * 59 / 2 / 2);
    } else {
      hits += found;
    }
  }
  EXPECT_GT(hits, scenes * 66 / 10);
  EXPECT_LT(hits, scenes * 66 * 9 / 10);
}

TEST(Broadphase, complement) {
  Scene scene;
  scene.add(Polygon({rectangle(-5, -5, 5, 5), rectangle(2, 2, 3, 3)}).complement(), turnedAndMoved(0.5, 1, 0));
  for (int i = 0; i < 40; ++i)
    scene.add(Polygon({rectangle(-0.5, -0.5, 0.5, 0.5)}), turnedAndMoved(0.1 * i, 4.0 * i - 80, 0.7 * i - 14));
  const std::size_t hits = expectAgreement(scene, 1, [] {});
  EXPECT_GT(hits, 30u);
  EXPECT_LT(hits, 40u);
  const auto outside =
      std::static_pointer_cast<PolygonShaped>(std::const_pointer_cast<Body>(scene[0]->collisionGeometry()));
  EXPECT_TRUE(PolygonObject<double>(outside, lifted(0.5, 1, 0)).getAABB().overlap(scene.back()->getAABB()));
}

TEST(Broadphase, octree) {
  // FCL hands the callback boxes of its own for the tree's cells.
  for (const auto& [name, manager] : managersOfEveryKind()) {
    SCOPED_TRACE(name);
    Scene polygons;
    for (const double x : {-10.0, -2.9, 1.25, 2.2})
      polygons.add(Polygon({rectangle(-0.2, -0.2, 0.2, 0.2)}), turnedAndMoved(0, x, x), 0.25);
    manager->registerObjects(pointers(polygons));
    manager->setup();
    fcl::CollisionObjectd tree(test::octree());
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

TEST(Broadphase, leastDistances) {
  Random random(72);
  const int scenes = std::max(10, scaledCount(60));
  int apart = 0;
  for (int k = 0; k < scenes; ++k) {
    SCOPED_TRACE(k);
    const double spread = random.coin() ? 6 : 18;
    Scene scene;
    for (int i = 0; i < 12; ++i) {
      const PolygonOptions options{random.oneIn(3) ? 0.3 : 0, 0, random.oneIn(3) ? 0.5 : 0};
      scene.add(randomPolygon(random, random.real(0.5, 1.5)), randomPose(random, spread), random.oneIn(4) ? 1 : 0,
                options);
    }
    auto registered = pointers(scene);
    fcl::CollisionObjectd* const probe = registered.back();
    registered.pop_back();
    const fcl::GJKSolverType solver = kSolvers[k % 2];
    const double all = leastDistance(registered, registered, solver),
                 of_probe = leastDistance(registered, {probe}, solver);
    for (const auto& [name, manager] : managersOfEveryKind()) {
      SCOPED_TRACE(name);
      manager->registerObjects(registered);
      manager->setup();
      for (const auto callback : {fcl::DefaultDistanceFunction<double>, defaultDistanceFunction<double>}) {
        for (const bool asks_probe : {false, true}) {
          fcl::DefaultDistanceData<double> data;
          data.request.gjk_solver_type = solver;
          asks_probe ? manager->distance(probe, &data, callback) : manager->distance(&data, callback);
          const double expected = asks_probe ? of_probe : all, found = data.result.min_distance;
          EXPECT_TRUE(expected > 0 ? found == expected : found <= 0) << found;  // of contacts, any may be found first
        }
      }
    }
    apart += all > 0;
  }
  EXPECT_GT(apart, scenes / 10);
  EXPECT_LT(apart, scenes * 9 / 10);
}

TEST(Broadphase, callbackStopsAsFclsDoes) {
  Scene scene;
  for (int i = 0; i < 5; ++i) scene.add(Polygon({rectangle(0, 0, 1, 1)}), turnedAndMoved(0, 0.1 * i, 0));
  fcl::NaiveCollisionManagerd manager;
  manager.registerObjects(pointers(scene));
  manager.setup();
  for (const auto callback : {fcl::DefaultCollisionFunction<double>, defaultCollisionFunction<double>}) {
    fcl::DefaultCollisionData<double> data;
    data.request.num_max_contacts = 3;
    manager.collide(&data, callback);
    EXPECT_TRUE(data.done);
    EXPECT_EQ(data.result.numContacts(), 3u);
    EXPECT_TRUE(callback(scene[0].get(), scene[1].get(), &data));
    EXPECT_EQ(data.result.numContacts(), 3u);
  }
}

}  // namespace
}  // namespace tricover_fcl::test
