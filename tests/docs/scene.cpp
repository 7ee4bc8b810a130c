// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/scene.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <thread>
#include <vector>

namespace {

TEST(Documentation, Scene) {
  //! [scene]
  const tricover::Polygon robot({{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}}), rack({{{0, 0}, {9, 0}, {9, 1}, {0, 1}}});
  const auto at = [](double x, double y) {
    tricover::Pose pose = tricover::Pose::Identity();
    pose.translation() << x, y;
    return pose;
  };
  tricover::Scene scene;
  const tricover::Scene::Body first = scene.add(robot, at(0, 0)), second = scene.add(robot, at(5, 0));
  scene.add(rack, at(0, 3));

  // One against many.
  EXPECT_FALSE(scene.collides(robot, at(2.5, -3)));
  EXPECT_EQ(scene.nearest(robot, at(2.5, -3))->result.distance, 1.118033988749895);

  // Many against many, frame by frame.
  EXPECT_TRUE(scene.collisions().empty());
  scene.move(second, at(2, 0));
  EXPECT_EQ(scene.collisions().size(), 1u);  // they touch
  EXPECT_EQ(scene.began().front(), (tricover::BodyPair{first, second}));

  // When will whom meet?
  const auto impacts = scene.impacts({{first, tricover::Motion::translation(at(0, 0), {0, 4})}});
  EXPECT_EQ(impacts.size(), 2u);
  EXPECT_EQ(impacts[0].impact.time, 0);  // the other robot, at once
  EXPECT_NEAR(impacts[1].impact.time, 0.5, 1e-6);
  const auto conflicts = scene.conflicts({{first, tricover::Motion::translation(at(0, 0), {0, 4})}});
  EXPECT_NEAR(conflicts[0].conflict.end, 0.5, 1e-6);  // and until when
  //! [scene]
}

TEST(Documentation, SceneTrajectories) {
  //! [scene trajectories]
  const tricover::Polygon robot({{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}}), rack({{{0, 0}, {9, 0}, {9, 1}, {0, 1}}});
  const auto at = [](double x, double y) {
    tricover::Pose pose = tricover::Pose::Identity();
    pose.translation() << x, y;
    return pose;
  };
  tricover::Scene scene;
  scene.add(rack, at(0, 3));
  const auto first = scene.add(robot, at(-10, 0)), second = scene.add(robot, at(0, -10));

  // Seconds: one robot waits on the crossing from 10 to 20; the other one passes there, and comes back.
  const auto waits = tricover::Trajectory::through({{0, at(-10, 0)}, {10, at(0, 0)}, {20, at(0, 0)}, {30, at(10, 0)}});
  const auto passes = tricover::Trajectory::through({{6, at(0, -10)}, {16, at(0, 0)}, {26, at(0, -10)}});
  const auto meet = scene.impacts({{first, waits}, {second, passes}});
  ASSERT_EQ(meet.size(), 1u);
  EXPECT_EQ(meet[0].pair, (tricover::BodyPair{first, second}));
  EXPECT_NEAR(meet[0].impact.time, 14, 1e-5);
  const auto spans = scene.conflicts({{first, waits}, {second, passes}});
  ASSERT_EQ(spans.size(), 1u);
  EXPECT_NEAR(spans[0].conflict.end, 18, 1e-5);

  // One that isn't in the scene, too high for the rack, goes on through it after it has been there for a second.
  tricover::ImpactOptions options;
  options.ignore_initial = true;
  const auto goes_up = tricover::Trajectory::through({{0, at(0, 3)}, {1, at(0, 3)}, {11, at(0, 13)}});
  EXPECT_FALSE(scene.firstImpact(robot, goes_up, options));
  //! [scene trajectories]
}

TEST(Documentation, SceneTouching) {
  //! [scene touching]
  const tricover::Polygon brick({{{0, 0}, {2, 0}, {2, 1}, {0, 1}}});
  const auto at = [](double x, double y) {
    tricover::Pose pose = tricover::Pose::Identity();
    pose.translation() << x, y;
    return pose;
  };
  tricover::BodyOptions laid;
  laid.touching = tricover::Touching::Allowed;
  tricover::Scene wall;
  wall.add(brick, at(0, 0), laid);
  wall.add(brick, at(2, 0), laid);
  const tricover::Scene::Body upper = wall.add(brick, at(1, 1), laid);
  EXPECT_TRUE(wall.collisions().empty());  // they lie on each other, and touch
  wall.move(upper, at(1, 0.999));
  EXPECT_EQ(wall.collisions().size(), 2u);
  //! [scene touching]
}

TEST(Documentation, SceneHandles) {
  //! [scene handles]
  const tricover::Polygon square({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}});
  tricover::Scene scene;
  const tricover::Scene::Body first = scene.add(square, tricover::Pose::Identity());
  scene.remove(first);
  const tricover::Scene::Body second = scene.add(square, tricover::Pose::Identity());
  EXPECT_NE(second, first);  // though it has the same slot,
  EXPECT_EQ(tricover::Scene::indexOf(second), tricover::Scene::indexOf(first));
  EXPECT_THROW(scene.remove(first), std::out_of_range);  // so that a stale handle is an error

  tricover::BodyOptions options;
  options.margin = 0.5;
  scene.setOptions(second, options);
  EXPECT_EQ(scene.options(second).margin, 0.5);
  //! [scene handles]
}

TEST(Documentation, SceneBodies) {
  //! [scene bodies]
  const tricover::Polygon square({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}});
  tricover::Pose pose = tricover::Pose::Identity();
  tricover::BodyOptions options;
  options.margin = 0.5;  // the body is the square grown by that
  options.category = 2;  // what it is,
  options.mask = 1 | 4;  // and what it meets
  tricover::Scene scene;
  const tricover::Scene::Body body = scene.add(square, pose, options);
  pose.translation() << 3, 0;
  scene.move(body, pose);
  EXPECT_EQ(scene.size(), 1u);
  EXPECT_EQ(scene.polygon(body).id(), square.id());
  EXPECT_EQ(scene.pose(body).translation().x(), 3);
  EXPECT_EQ(scene.options(body).margin, 0.5);
  scene.remove(body);
  EXPECT_FALSE(scene.contains(body));

  std::vector<tricover::BodyPlacement> map;
  for (int i = 0; i < 100; ++i) {
    pose.translation().x() = 2 * i;
    map.push_back({square, pose, {}});
  }
  const std::vector<tricover::Scene::Body> bodies = scene.add(map);
  EXPECT_EQ(scene.pose(bodies[7]).translation().x(), 14);
  for (const tricover::Scene::Body one : scene.bodies()) EXPECT_EQ(scene.polygon(one).id(), square.id());
  //! [scene bodies]
}

TEST(Documentation, SceneFrames) {
  //! [scene frames]
  const tricover::Polygon square({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}});
  tricover::Pose pose = tricover::Pose::Identity();
  tricover::Scene scene;
  scene.add(square, pose);
  const tricover::Scene::Body other = scene.add(square, pose);
  for (int frame = 0; frame < 3; ++frame) {
    pose.translation().x() = 0.6 * frame;
    scene.move(other, pose);
    EXPECT_EQ(scene.collisions().size(), frame < 2 ? 1u : 0u);
    EXPECT_EQ(scene.began().size(), frame == 0 ? 1u : 0u);
    EXPECT_EQ(scene.ended().size(), frame == 2 ? 1u : 0u);
  }
  const tricover::Scene now(scene);  // a copy, to go back to
  scene.move({{0, pose}, {other, pose}});
  EXPECT_EQ(scene.collisions().size(), 1u);
  scene = now;
  EXPECT_EQ(scene.collisions().size(), 0u);
  //! [scene frames]
}

TEST(Documentation, SceneContacts) {
  //! [scene contacts]
  const tricover::Polygon crate = tricover::Polygon::box(2, 2), floor = tricover::Polygon::box(20, 2);
  tricover::Scene scene;
  const auto lower = scene.add(floor, tricover::poseAt(0, 0)), upper = scene.add(crate, tricover::poseAt(3, 1.75));
  for (const auto& [pair, contact] : scene.contacts()) {
    EXPECT_EQ(pair, (tricover::BodyPair{lower, upper}));
    EXPECT_EQ(contact.depth, 0.25);
    EXPECT_EQ(contact.normal, tricover::Vec2(0, 1));  // from the floor to the crate
  }
  //! [scene contacts]
  EXPECT_EQ(scene.contacts().size(), 1u);
}

TEST(Documentation, SceneIgnored) {
  //! [scene ignored]
  const tricover::Polygon box = tricover::Polygon::box(1, 1);
  tricover::Scene scene;
  const auto gripper = scene.add(box, tricover::poseAt(0, 0)), part = scene.add(box, tricover::poseAt(1, 0));
  EXPECT_EQ(scene.collisions().size(), 1u);
  scene.setIgnored(gripper, part);  // it has gripped the part
  EXPECT_TRUE(scene.collisions().empty());
  EXPECT_TRUE(scene.isIgnored(part, gripper));
  scene.setIgnored(gripper, part, false);  // and lets go
  EXPECT_EQ(scene.collisions().size(), 1u);
  //! [scene ignored]
}

TEST(Documentation, SceneLeastDistance) {
  //! [scene least distance]
  using tricover::poseAt;
  const tricover::Polygon box = tricover::Polygon::box(1, 1);
  tricover::Scene scene;
  scene.add(box, poseAt(5, 3));
  const auto nearer = scene.add(box, poseAt(20, -2));
  const auto least = scene.leastDistance(box, tricover::Motion::translation(poseAt(0, 0), {30, 0}));
  EXPECT_EQ(least->body, nearer);
  EXPECT_NEAR(least->least.distance, 1, 1e-6);
  const auto way =
      tricover::Trajectory::through({{0, poseAt(0, 0)}, {10, poseAt(10, 0)}});  // ten seconds, a part of it
  EXPECT_NEAR(scene.leastDistance(box, way)->least.distance, 2, 1e-6);
  //! [scene least distance]
}

TEST(Documentation, SceneQueries) {
  //! [scene queries]
  const tricover::Polygon square({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}});
  const auto at = [](double x) {
    tricover::Pose pose = tricover::Pose::Identity();
    pose.translation().x() = x;
    return pose;
  };
  tricover::BodyOptions marked;
  marked.category = 2;
  tricover::Scene scene;
  const tricover::Scene::Body left = scene.add(square, at(0)), right = scene.add(square, at(4), marked);

  EXPECT_TRUE(scene.collides(square, at(0.5)));
  EXPECT_FALSE(scene.collides(square, at(0.5), {}, 2));  // of bodies of category 2 alone
  EXPECT_TRUE(scene.collides(square, at(2.5), {0.5}));   // with a margin
  EXPECT_EQ(scene.anyColliding(square, at(0.5)), left);
  EXPECT_EQ(scene.colliding(square, at(2), {1}), (std::vector{left, right}));
  int met = 0;
  scene.visitColliding(square, at(2), [&](tricover::Scene::Body) { return ++met < 5; }, {1});  // until there are five
  EXPECT_EQ(met, 2);
  EXPECT_EQ(scene.nearest(square, at(2.5))->body, right);
  EXPECT_EQ(scene.nearest(square, at(2.5))->result.distance, 0.5);
  EXPECT_FALSE(scene.nearestWithin(square, at(2.5), 0.25));
  EXPECT_EQ(scene.firstImpact(square, tricover::Motion::translation(at(2), {8, 0}))->body, right);
  EXPECT_EQ(scene.castRay({-1, 0.5}, {9, 0.5})->hit.fraction, 0.1);
  EXPECT_EQ(scene.castRayAll({-1, 0.5}, {9, 0.5})[1].interval.end.fraction, 0.6);  // where it leaves the second body
  //! [scene queries]
}

TEST(Documentation, SceneNearest) {
  //! [scene nearest]
  const tricover::Polygon square({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}});
  const auto at = [](double x) {
    tricover::Pose pose = tricover::Pose::Identity();
    pose.translation().x() = x;
    return pose;
  };
  tricover::Scene scene;
  for (int i = 0; i < 10; ++i) scene.add(square, at(3 * i));
  const std::vector<tricover::BodyDistance> few = scene.nearestK(square, at(7.25), 3, 10);
  EXPECT_EQ(few.size(), 3u);
  EXPECT_EQ(few[0].result.distance, 0.25);  // the body at x = 6
  EXPECT_EQ(few[2].result.distance, 3.25);
  // A body of the scene, and what is nearest to it.
  EXPECT_EQ(scene.nearest(square, scene.pose(4), {}, tricover::BodyFilter::allBut(4))->result.distance, 2);
  //! [scene nearest]
}

TEST(Documentation, Parallel) {
  //! [parallel]
  // Two threads. With oneTBB: [](auto n, const auto& task) { tbb::parallel_for(std::size_t{0}, n, task); }
  const tricover::Parallel parallel = [](std::size_t count, const std::function<void(std::size_t)>& task) {
    const auto half = [&](std::size_t first) {
      for (std::size_t i = first; i < count; i += 2) task(i);
    };
    std::thread other([&] { half(1); });
    half(0);
    other.join();
  };
  const tricover::Polygon square({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}});
  tricover::Scene scene;
  scene.add(square, tricover::Pose::Identity());
  std::vector<tricover::Pose> poses(1000, tricover::Pose::Identity());
  for (std::size_t i = 0; i < poses.size(); ++i) poses[i].translation().x() = 0.01 * static_cast<double>(i);
  const std::vector<bool> answers = scene.collides(square, poses, {}, tricover::kEveryCategory, parallel);
  EXPECT_TRUE(answers[100]);  // at x = 1
  EXPECT_FALSE(answers[101]);
  const auto nearest = scene.nearest(square, poses, {}, tricover::kEveryCategory, parallel);
  EXPECT_EQ(nearest[300]->result.distance, 2);  // at x = 3
  //! [parallel]
}

}  // namespace
