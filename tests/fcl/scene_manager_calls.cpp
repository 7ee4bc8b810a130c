// SPDX-License-Identifier: BSD-3-Clause
// SceneManager where FCL's managers stop, crash or lose objects: callbacks that end queries, objects that come twice or
// not at all, boxes without bounds, poses that no query takes.
#include <functional>

#include "managers.h"
#include "mixed_scene.h"

namespace tricover_fcl::test {
namespace {

/// Callbacks that count, of collide and distance, which end the query or don't.
template <bool kEnds>
bool counts(fcl::CollisionObjectd*, fcl::CollisionObjectd*, void* data) {
  ++*static_cast<int*>(data);
  return kEnds;
}

template <bool kEnds>
bool countsDistance(fcl::CollisionObjectd*, fcl::CollisionObjectd*, void* data, double&) {
  return counts<kEnds>(nullptr, nullptr, data);
}

constexpr auto count = counts<false>, countAndStop = counts<true>;
constexpr auto countOnly = countsDistance<false>, countDistanceAndStop = countsDistance<true>;

int calls(const std::function<void(void*)>& query) {
  int number = 0;
  query(&number);
  return number;
}

/// Squares of 1, two by two in touch, and a halfspace that is everywhere.
Objects<double> fourSquaresAndAHalfspace() {
  Objects<double> objects;
  const Shape<double> square = rectangular(0, 0, 1, 1);
  for (const double x : {0.0, 1.0, 5.0, 6.0})
    objects.push_back(std::make_unique<fcl::CollisionObjectd>(square, shifted(x, 0, 0)));
  objects.push_back(std::make_unique<fcl::CollisionObjectd>(std::make_shared<fcl::Halfspaced>(Vec3(1, 0, 0), -100)));
  return objects;
}

TEST(SceneManager, callbacksEndQueries) {
  const Objects<double> objects = fourSquaresAndAHalfspace();
  SceneManagerd manager, partner;
  manager.registerObjects(pointers(objects));
  partner.registerObjects(pointers(objects));
  fcl::CollisionObjectd& query = *objects[0];
  const fcl::CollisionObjectd wide(rectangular(0, 0, 9, 1));
  fcl::CollisionObjectd given = wide;
  EXPECT_EQ(calls([&](void* data) { manager.collide(data, count); }), 2 + 4);
  EXPECT_EQ(calls([&](void* data) { manager.collide(data, countAndStop); }), 1);
  EXPECT_EQ(calls([&](void* data) { manager.collide(&query, data, count); }), 1 + 1);
  EXPECT_EQ(calls([&](void* data) { manager.collide(&query, data, countAndStop); }), 1);
  EXPECT_EQ(calls([&](void* data) { manager.collide(&given, data, count); }), 5);
  EXPECT_EQ(calls([&](void* data) { manager.collide(&given, data, countAndStop); }), 1);
  EXPECT_EQ(calls([&](void* data) { manager.collide(&partner, data, countAndStop); }), 1);
  // A pair that is ignored is shown by none, until one of the two comes anew.
  manager.setIgnored(objects[1].get(), &query);
  manager.setIgnored(&query, objects[1].get());
  EXPECT_EQ(calls([&](void* data) { manager.collide(data, count); }), 1 + 4);
  EXPECT_EQ(calls([&](void* data) { manager.collide(&query, data, count); }), 1);
  EXPECT_EQ(calls([&](void* data) { manager.distance(data, countOnly); }), 9);
  EXPECT_EQ(calls([&](void* data) { manager.distance(&query, data, countOnly); }), 3);
  EXPECT_EQ(calls([&](void* data) { manager.collide(&given, data, count); }), 5);
  EXPECT_THROW(manager.setIgnored(&query, &query), std::invalid_argument);
  EXPECT_THROW(manager.setIgnored(&query, &wide), std::invalid_argument);
  manager.setIgnored(objects[1].get(), &query, false);
  EXPECT_EQ(calls([&](void* data) { manager.collide(data, count); }), 2 + 4);
  manager.setIgnored(objects[1].get(), &query);
  manager.unregisterObject(objects[1].get());
  manager.registerObject(objects[1].get());
  // A callback that reports no distance is shown all.
  EXPECT_EQ(calls([&](void* data) { manager.distance(data, countOnly); }), 10);
  EXPECT_EQ(calls([&](void* data) { manager.distance(&query, data, countOnly); }), 4);
  EXPECT_EQ(calls([&](void* data) { manager.distance(&given, data, countOnly); }), 5);
  EXPECT_EQ(calls([&](void* data) { manager.distance(&partner, data, countOnly); }), 20);
  EXPECT_EQ(calls([&](void* data) { manager.distance(data, countDistanceAndStop); }), 1);
  EXPECT_EQ(calls([&](void* data) { manager.distance(&given, data, countDistanceAndStop); }), 1);
  EXPECT_EQ(calls([&](void* data) { manager.distance(&partner, data, countDistanceAndStop); }), 1);
}

TEST(SceneManager, objectsComeOnceAndGoAtAnyTime) {
  Objects<double> objects = fourSquaresAndAHalfspace();
  SceneManagerd manager;
  EXPECT_TRUE(manager.empty());
  EXPECT_EQ(calls([&](void* data) { manager.collide(data, count); }), 0);
  EXPECT_EQ(calls([&](void* data) { manager.collide(objects[0].get(), data, count); }), 0);
  EXPECT_EQ(calls([&](void* data) { manager.distance(data, countOnly); }), 0);
  EXPECT_EQ(calls([&](void* data) { manager.distance(objects[0].get(), data, countOnly); }), 0);
  manager.update();
  manager.update(objects[0].get());
  manager.unregisterObject(objects[0].get());

  manager.registerObjects(pointers(objects));
  manager.registerObjects(pointers(objects));
  EXPECT_EQ(manager.size(), 5u);
  std::vector<fcl::CollisionObjectd*> held{nullptr};
  manager.getObjects(held);
  EXPECT_EQ(held, pointers(objects));

  fcl::CollisionObjectd* const gone = objects[1].get();
  objects.erase(objects.begin() + 1);
  manager.unregisterObject(gone);  // which isn't looked at
  manager.unregisterObject(gone);
  EXPECT_EQ(manager.size(), 4u);
  EXPECT_EQ(calls([&](void* data) { manager.collide(data, count); }), 1 + 3);
  manager.clear();
  EXPECT_TRUE(manager.empty());
  EXPECT_EQ(calls([&](void* data) { manager.collide(data, count); }), 0);
  manager.registerObject(objects[0].get());
  EXPECT_EQ(manager.size(), 1u);
}

TEST(SceneManager, namesWhatIsMissing) {
  SceneManagerd manager;
  fcl::CollisionObjectd bare(nullptr), *const no_object = nullptr;
  SceneManagerd* const no_manager = nullptr;
  int number = 0;
  expectRefused({"object"}, [&] { manager.registerObject(nullptr); });
  expectRefused({"object"}, [&] { manager.registerObject(&bare); });
  expectRefused({"object"}, [&] { manager.collide(no_object, &number, count); });
  expectRefused({"object"}, [&] { manager.distance(&bare, &number, countOnly); });
  expectRefused({"manager"}, [&] { manager.collide(no_manager, &number, count); });
  expectRefused({"manager"}, [&] { manager.distance(no_manager, &number, countOnly); });
  EXPECT_TRUE(manager.empty());
}

TEST(SceneManager, whatNoQueryTakesIsShownSoThatItIsRefused) {
  Objects<double> objects = fourSquaresAndAHalfspace();
  objects.pop_back();
  SceneManagerd manager;
  manager.registerObjects(pointers(objects));
  const auto ask = [&] {
    Seen<double> seen;
    manager.collide(&seen, see<double>);
  };
  EXPECT_NO_THROW(ask());
  for (const double wrong : {kNaN, 2.0}) {
    Transform pose = shifted(300, 0, 0);
    pose.linear() *= wrong;
    objects[2]->setTransform(pose);
    objects[2]->computeAABB();
    manager.update();
    EXPECT_THROW(ask(), std::invalid_argument);
  }
  // One that leaves the plane is shown where its box is met.
  objects[2]->setTransform(placed({300, 0, 0}, turned(1, {1, 0, 0})));
  objects[2]->computeAABB();
  manager.update();
  EXPECT_NO_THROW(ask());
  objects[2]->setTranslation({0.5, 0, 0});
  objects[2]->computeAABB();
  manager.update();
  EXPECT_THROW(ask(), std::invalid_argument);
  fcl::CollisionObjectd ball(std::make_shared<fcl::Sphered>(0.1), shifted(0.7, 0.2, 0.4));
  Seen<double> seen;
  manager.collide(&ball, &seen, see<double>);  // it meets the tilted one
  EXPECT_EQ(seen.shown.size(), 1u);

  objects[2]->setTransform(shifted(0.5, 0, 0));
  manager.update(objects[2].get());
  EXPECT_NO_THROW(ask());
}

TEST(SceneManager, boxesFollowWhatTurns) {
  const Shape<double> square = rectangular(1, -0.5, 2, 0.5);
  fcl::CollisionObjectd bar(std::make_shared<fcl::Boxd>(1, 4, 1)), wall(square);
  SceneManagerd manager;
  manager.registerObjects({&bar, &wall});
  const auto shownAt = [&](double angle) {
    bar.setTransform(placed({0, 0, 0}, turned(angle, Vec3::UnitZ())));
    bar.computeAABB();
    manager.update();
    Seen<double> seen;
    manager.collide(&seen, see<double>);
    EXPECT_EQ(seen.hits, hitsOf<double>({&bar}, {&wall}));
    return seen.calls;
  };
  EXPECT_EQ(shownAt(0), 0u);
  EXPECT_EQ(shownAt(1.5), 1u);
  EXPECT_EQ(shownAt(0), 0u);
}

TEST(SceneManager, hugeAndTinyBoxes) {
  // Where FCL's trees crash.
  for (const double size : {1e-300, 1e300}) {
    const Shape<double> square = rectangular(0, 0, size, size);
    fcl::CollisionObjectd p(square), q(square, shifted(size, 0, 0)), r(square, shifted(3 * size, 0, 0));
    fcl::CollisionObjectd ball(std::make_shared<fcl::Sphered>(size));
    SceneManagerd manager;
    manager.registerObjects({&p, &q, &r});
    EXPECT_EQ(calls([&](void* data) { manager.collide(data, count); }), 1);
    EXPECT_GE(calls([&](void* data) { manager.collide(&ball, data, count); }), 2);
  }
}

TEST(SceneManager, aTiltWithinTheToleranceMovesHighPrisms) {
  // To the ball the prism leans; to polygons it doesn't.
  Transform pose = kHere;
  pose.linear() = turned(9e-7, Vec3::UnitY());
  const auto tower = shapeOf(Polygon({rectangle(0, 0, 1, 1)}), {0, 0, 1e6});
  fcl::CollisionObjectd prism(tower);
  fcl::CollisionObjectd ball(std::make_shared<fcl::Sphered>(0.1), shifted(1.5, 0.5, 9e5));
  fcl::CollisionObjectd flat(rectangular(1.2, 0, 2, 1), shifted(0, 0, 9e5));
  SceneManagerd manager;
  manager.registerObjects({&prism, &ball, &flat});
  Seen<double> upright;
  manager.collide(&upright, see<double>);
  EXPECT_EQ(upright.shown.size(), 1u);  // the ball and the flat one
  prism.setTransform(pose);
  prism.computeAABB();
  manager.update();
  Seen<double> seen;
  manager.collide(&seen, see<double>);
  EXPECT_TRUE(hit(prism, ball));
  EXPECT_FALSE(hit(prism, flat));
  EXPECT_EQ(seen.hits, hitsOf<double>({&prism, &ball, &flat}, {&prism, &ball, &flat}));
}

}  // namespace
}  // namespace tricover_fcl::test
