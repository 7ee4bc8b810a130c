// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/recording.h"

#include <gtest/gtest.h>

#include <string>

#include "own_folder.h"

namespace {

TEST(Documentation, RecordingOfFrames) {
  //! [frames]
  tricover::Scene scene;
  const auto wall = scene.add(tricover::Polygon::box(1, 8), tricover::poseAt(5, 0));
  const auto crate = scene.add(tricover::Polygon::box(2, 2), tricover::poseAt(0, 0));
  tricover::SceneRecording recording("A crate slides into a wall");
  for (int i = 0; i <= 50; ++i) {
    scene.move(crate, tricover::poseAt(0.1 * i, 0, 0.02 * i));
    recording.frame(0.1 * i, scene, scene.collisions());  // seconds
    const auto distance =
        tricover::distance(scene.polygon(wall), scene.pose(wall), scene.polygon(crate), scene.pose(crate));
    if (distance.distance > 0)
      recording.nearest(distance);
    else
      recording.contacts(
          tricover::contacts(scene.polygon(wall), scene.pose(wall), scene.polygon(crate), scene.pose(crate)));
    recording.ray({-3, 3}, {9, 3}, scene.castRay({-3, 3}, {9, 3}));
  }
  recording.text({0, 4}, "the first second", tricover::TimeInterval{0, 1});
  const std::string page = recording.str();  // to be written to a file, by save()
  EXPECT_EQ(page.rfind("<!DOCTYPE html>", 0), 0u);
  //! [frames]
}

TEST(Documentation, RecordingOfTrajectories) {
  const tricover::support::OwnFolder own;
  const std::string folder = own.path();
  //! [trajectories]
  tricover::Scene scene;
  const auto robot = tricover::Polygon::box(1, 1);
  const auto one = scene.add(robot, tricover::poseAt(-5, 0)), other = scene.add(robot, tricover::poseAt(0, -5));
  const std::vector<tricover::BodyTrajectory> plans = {
      {one, tricover::Trajectory::through({{0, tricover::poseAt(-5, 0)}, {10, tricover::poseAt(5, 0)}})},
      {other, tricover::Trajectory::through({{0, tricover::poseAt(0, -5)}, {10, tricover::poseAt(0, 5)}})}};
  tricover::SceneRecording recording("Two robots cross");
  recording.trajectories(scene, plans);
  recording.conflicts(scene.conflicts(plans));
  recording.impacts(scene.impacts(plans));
  recording.name(one, "forklift");
  recording.save(folder + "crossing.html");
  //! [trajectories]
}

TEST(Documentation, RecordingOfALeastDistance) {
  //! [least distance]
  tricover::Scene scene;
  const auto robot = tricover::Polygon::box(1, 1);
  const auto body = scene.add(robot, tricover::poseAt(-5, 0));
  scene.add(robot, tricover::poseAt(0, 3));
  const auto way = tricover::Trajectory::through({{0, tricover::poseAt(-5, 0)}, {10, tricover::poseAt(5, 0)}});
  tricover::SceneRecording recording;
  recording.trajectories(scene, {{body, way}});
  recording.nearest(tricover::leastDistance(robot, way, robot, tricover::poseAt(0, 3)));
  EXPECT_NE(recording.str().find("</html>"), std::string::npos);
  //! [least distance]
}

}  // namespace
