// SPDX-License-Identifier: BSD-3-Clause
// SceneManager shows its callbacks what brute force finds, whatever it is asked.
#include <algorithm>
#include <cmath>
#include <set>
#include <thread>
#include <utility>

#include "managers.h"
#include "mixed_scene.h"

namespace tricover_fcl::test {
namespace {

template <typename S>
Shape<S> randomShape(Random& random, double size) {
  PolygonOptions options;
  if (random.oneIn(3)) options = PolygonOptions::atAllHeights();
  if (random.oneIn(3)) options.z_low = random.real(-1, 0), options.z_high = random.real(0, 1);
  if (random.oneIn(3)) options.margin = random.real(0, 0.2) * size;
  return shapeOf<S>(randomPolygon(random, size), options);
}

/// In the plane, now and then upside down; others anyhow.
template <typename S>
fcl::Transform3<S> randomPlace(Random& random, const Object<S>& object, double width) {
  const double z = random.oneIn(3) ? random.real(-1, 1) : 0;
  fcl::Transform3<S> pose = lifted<S>(randomPose(random, width), z);
  if (!isPolygon(object))
    pose.linear() = turned(random.real(0, 6), {1, random.real(-1, 1), random.real(-1, 1)}).template cast<S>();
  else if (random.oneIn(5))
    pose.linear() = pose.linear() * fcl::Vector3<S>(1, -1, -1).asDiagonal();
  return pose;
}

/// Two thirds are polygons, half of them PolygonObjects.
template <typename S>
std::unique_ptr<Object<S>> randomObject(Random& random, double size, double width) {
  const bool polygon = !random.oneIn(3);
  const Geometry<S> geometry = polygon ? Geometry<S>(randomShape<S>(random, size))
                                       : solid<S>(random.integer(0, 6), [&] { return size * random.real(0.3, 1); });
  auto object = std::make_unique<Object<S>>(geometry);
  object->setTransform(randomPlace(random, *object, width));
  object->computeAABB();
  return object;
}

template <typename S>
Objects<S> randomObjects(Random& random, int count, double size, double width) {
  Objects<S> objects;
  for (int i = 0; i < count; ++i) objects.push_back(randomObject<S>(random, random.real(0.3, 1) * size, width));
  return objects;
}

/// A step, a turn, a jump or nothing.
template <typename S>
bool moveSomehow(Random& random, Object<S>& object, double width) {
  if (random.oneIn(3)) return false;
  if (random.oneIn(6)) {
    object.setTransform(randomPlace(random, object, width));
  } else {
    fcl::Transform3<S> pose = object.getTransform();
    const double angle = random.oneIn(3) ? 0 : random.real(-0.2, 0.2);
    pose.linear() = turned(angle, Vec3::UnitZ()).template cast<S>() * pose.linear();
    pose.translation() +=
        fcl::Vector3<S>(static_cast<S>(random.real(-0.3, 0.3)), static_cast<S>(random.real(-0.3, 0.3)), 0);
    object.setTransform(pose);
  }
  object.computeAABB();
  return true;
}

template <typename S>
void expectFramesAsByBruteForce() {
  Random random(51);
  Objects<S> objects = randomObjects<S>(random, 40, 2, 10), others = randomObjects<S>(random, 12, 2, 10);
  SceneManager<S> manager;
  std::set<Object<S>*> registered;
  const auto add = [&](Object<S>* object) {
    manager.registerObject(object);
    registered.insert(object);
  };
  for (const auto& object : objects) add(object.get());
  manager.setup();
  const int frames = scaledCount(100);
  std::size_t hits = 0, pairs = 0;
  for (int frame = 0; frame < frames; ++frame) {
    SCOPED_TRACE(frame);
    const std::vector<Object<S>*> now(registered.begin(), registered.end());
    ASSERT_EQ(manager.size(), now.size());
    const Pairs expected = hitsOf(now, now);
    expectSeen<S>(expected, [&](auto* seen) { manager.collide(seen, see<S>); });
    hits += expected.size();
    pairs += now.size() * (now.size() - 1) / 2;
    std::vector<Object<S>*> queries = pointers(others);
    queries.push_back(now.front());  // one of the manager's
    for (Object<S>* query : queries)
      expectSeen<S>(hitsOf(now, {query}), [&](auto* seen) { manager.collide(query, seen, see<S>); });

    std::vector<Object<S>*> moved;
    for (const auto& object : objects) {
      if (moveSomehow(random, *object, 10)) moved.push_back(object.get());
    }
    switch (frame % 3) {
      case 0:
        manager.update();
        break;
      case 1:
        manager.update(moved);
        break;
      default:
        for (Object<S>* object : moved) manager.update(object);
    }
    Object<S>* const some = objects[static_cast<std::size_t>(random.integer(0, 39))].get();
    if (registered.erase(some) > 0)
      manager.unregisterObject(some);
    else
      add(some);
  }
  EXPECT_GT(hits, pairs / 50);
  EXPECT_LT(hits, pairs / 3);
}

TEST(SceneManager, framesAsByBruteForce) { expectFramesAsByBruteForce<double>(); }

TEST(SceneManager, floatFramesAsByBruteForce) { expectFramesAsByBruteForce<float>(); }

TEST(SceneManager, anyManagerIsAPartner) {
  Random random(52);
  const Objects<double> mine = randomObjects<double>(random, 25, 2, 8),
                        theirs = randomObjects<double>(random, 20, 2, 8);
  std::vector<fcl::CollisionObjectd*> others = pointers(theirs);
  others.push_back(mine[3].get());  // in both
  SceneManagerd manager;
  manager.registerObjects(pointers(mine));
  manager.setup();
  const Pairs expected = hitsOf(pointers(mine), others);
  EXPECT_GT(expected.size(), 10u);
  for (const auto& [name, partner] : managersOfEveryKind()) {
    SCOPED_TRACE(name);
    Seen<double> before;
    manager.collide(partner.get(), &before, see<double>);
    EXPECT_EQ(before.calls, 0u);  // empty
    partner->registerObjects(others);
    partner->setup();
    Seen<double> seen;
    manager.collide(partner.get(), &seen, see<double>);
    EXPECT_EQ(seen.hits, expected);
    EXPECT_EQ(seen.in_vain, 0u);
    fcl::DefaultDistanceData<double> data;
    manager.distance(partner.get(), &data, defaultDistanceFunction<double>);
    EXPECT_LE(data.result.min_distance, 0);  // they overlap
  }
  expectSeen(hitsOf(pointers(mine), pointers(mine)), [&](auto* seen) { manager.collide(&manager, seen, see<double>); });
}

/// Objects in cells of their own: most of them apart.
template <typename S>
Objects<S> sparseObjects(Random& random, int side, double cell, bool polygons_only, double off) {
  Objects<S> objects;
  for (int i = 0; i < side * side; ++i) {
    do {
      auto object = randomObject<S>(random, cell / 4, 0);
      if (polygons_only && !isPolygon(*object)) continue;
      fcl::Transform3<S> pose = object->getTransform();
      pose.translation().template head<2>() << static_cast<S>(off + cell * (i % side) + random.real(-0.1, 0.1)),
          static_cast<S>(off + cell * (i / side) + random.real(-0.1, 0.1));
      object->setTransform(pose);
      object->computeAABB();
      objects.push_back(std::move(object));
    } while (objects.size() <= static_cast<std::size_t>(i));
  }
  return objects;
}

template <typename S>
void expectDistancesAsByBruteForce(bool polygons_only, double precision) {
  Random random(53);
  for (int i = 0; i < scaledCount(30); ++i) {
    SCOPED_TRACE(i);
    const Objects<S> mine = sparseObjects<S>(random, 5, 3, polygons_only, 0);
    const Objects<S> theirs = sparseObjects<S>(random, 3, 3, polygons_only, random.coin() ? 40 : 1.5);
    SceneManager<S> manager, partner;
    manager.registerObjects(pointers(mine));
    partner.registerObjects(pointers(theirs));
    const auto expectLeast = [&](const std::vector<Object<S>*>& others, const auto& query) {
      fcl::DefaultDistanceData<S> data;
      query(&data);
      const double expected = leastDistance(pointers(mine), others);
      EXPECT_NEAR(static_cast<double>(data.result.min_distance), expected, precision * std::abs(expected));
    };
    constexpr auto distance = defaultDistanceFunction<S>;
    expectLeast(pointers(mine), [&](auto* data) { manager.distance(data, distance); });
    expectLeast(pointers(theirs), [&](auto* data) { manager.distance(&partner, data, distance); });
    expectLeast(pointers(mine), [&](auto* data) { manager.distance(&manager, data, distance); });
    for (Object<S>* query : {theirs[0].get(), theirs[4].get(), mine[7].get()})
      expectLeast({query}, [&](auto* data) { manager.distance(query, data, distance); });
  }
}

TEST(SceneManager, distancesAsByBruteForce) { expectDistancesAsByBruteForce<double>(true, 1e-13); }

// FCL's solvers answer for pairs of its own geometries, to 1e-6.
TEST(SceneManager, distancesOfOtherGeometriesAsByBruteForce) { expectDistancesAsByBruteForce<double>(false, 1e-4); }

TEST(SceneManager, floatDistancesAsByBruteForce) { expectDistancesAsByBruteForce<float>(true, 1e-6); }

struct CountedDistance : fcl::DefaultDistanceData<double> {
  int calls = 0;
};

bool countDistance(fcl::CollisionObjectd* o1, fcl::CollisionObjectd* o2, void* data, double& least) {
  auto& counted = *static_cast<CountedDistance*>(data);
  ++counted.calls;
  return defaultDistanceFunction<double>(o1, o2, static_cast<fcl::DefaultDistanceData<double>*>(&counted), least);
}

TEST(SceneManager, distanceShowsTheNearestFirst) {
  Random random(54);
  const Objects<double> objects = sparseObjects<double>(random, 6, 3, true, 0);
  SceneManagerd manager;
  manager.registerObjects(pointers(objects));
  fcl::CollisionObjectd query(rectangular(0, 0, 1, 1), shifted(7, 30, 0));
  CountedDistance of_query, of_all;
  manager.distance(&query, &of_query, countDistance);
  EXPECT_LE(of_query.calls, 6);  // of 36; what lies at other heights is nearer in the plane than in space
  EXPECT_EQ(of_query.result.min_distance, leastDistance(pointers(objects), {&query}));
  manager.distance(&of_all, countDistance);
  EXPECT_LE(of_all.calls, 18);  // of 630
  EXPECT_EQ(of_all.result.min_distance, leastDistance(pointers(objects), pointers(objects)));
}

TEST(SceneManager, threadsMayAskAtOnce) {
  Random random(55);
  const Objects<double> objects = randomObjects<double>(random, 40, 2, 10);
  const Objects<double> queries = randomObjects<double>(random, 8, 2, 10);
  SceneManagerd manager;
  manager.registerObjects(pointers(objects));
  const Pairs expected = hitsOf(pointers(objects), pointers(objects));
  std::vector<Seen<double>> self(4), given(4);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < 4; ++i) {
    threads.emplace_back([&, i] {
      for (const auto& query : queries) manager.collide(query.get(), &given[i], see<double>);
      manager.collide(&self[i], see<double>);
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (std::size_t i = 0; i < 4; ++i) {
    expectSeen(expected, [&](auto* seen) { *seen = self[i]; });
    EXPECT_EQ(given[i].hits, hitsOf(pointers(objects), pointers(queries)));
  }
}

}  // namespace
}  // namespace tricover_fcl::test
