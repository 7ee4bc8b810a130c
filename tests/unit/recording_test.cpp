// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/recording.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <string>

#include "own_folder.h"

namespace tricover {
namespace {

/// Bodies on circles, each frame somewhere else and rotated.
SceneRecording circling(int frames, int bodies) {
  Scene scene;
  std::vector<Scene::Body> all;
  for (int i = 0; i < bodies; ++i) all.push_back(scene.add(Polygon::box(1, 2), poseAt(0, 0)));
  SceneRecording recording("circles");
  for (int frame = 0; frame < frames; ++frame) {
    for (int i = 0; i < bodies; ++i)
      scene.move(all[static_cast<std::size_t>(i)],
                 poseAt(1e6 + 3 * i * std::cos(0.01 * frame), 3 * i * std::sin(0.01 * frame), 0.1 * frame + i));
    recording.frame(frame, scene, scene.collisions());
  }
  return recording;
}

TEST(Recording, IsSmall) { EXPECT_LT(circling(1000, 100).str().size(), 5e6); }

TEST(Recording, KeepsShapesAndBodiesThatRestOnce) {
  Ring ring;
  for (int i = 0; i < 1000; ++i) ring.push_back(Vec2(std::cos(0.006 * i), std::sin(0.006 * i)));
  Scene scene;
  const Polygon shape(ring);
  for (int i = 0; i < 20; ++i) scene.add(shape, poseAt(3 * i, 0));
  SceneRecording recording;
  recording.frame(0, scene);
  const std::size_t one = recording.str().size();
  for (int i = 1; i < 1000; ++i) recording.frame(i, scene);
  EXPECT_LT(recording.str().size(), one + 12000);
}

TEST(Recording, AnHourOfTrajectoriesIsSmall) {
  Scene scene;
  const Scene::Body body = scene.add(Polygon::box(1, 1), poseAt(0, 0));
  std::vector<TimedPose> poses;
  for (int i = 0; i <= 720; ++i) poses.push_back({5.0 * i, poseAt(std::sin(i), std::cos(3 * i), 0.5 * i)});
  SceneRecording none, recording;
  none.trajectories(scene, {});
  recording.trajectories(scene, {{body, Trajectory::through(poses)}});
  EXPECT_LT(recording.str().size(), none.str().size() + 720 * 60);
}

TEST(Recording, EscapesNames) {
  Scene scene;
  const Scene::Body body = scene.add(Polygon::box(1, 1), poseAt(0, 0));
  SceneRecording recording("</title></script>");
  recording.frame(0, scene);
  recording.name(body, "</script><b>\"\\\n");
  const std::string page = recording.str();
  EXPECT_EQ(page.find("</script><b>"), std::string::npos);
  EXPECT_EQ(page.find("</title></script>"), std::string::npos);
  EXPECT_NE(page.find("\\u003c/script>\\u003cb>\\\"\\\\\\u000a"), std::string::npos);
}

TEST(Recording, IsTheSameEachTime) {
  EXPECT_EQ(circling(20, 5).str(), circling(20, 5).str());
  const SceneRecording recording = circling(20, 5);
  SceneRecording copy("other");
  copy = recording;
  EXPECT_EQ(SceneRecording(copy).str(), recording.str());
}

TEST(Recording, SavesAllOrNothing) {
  const support::OwnFolder folder;
  const std::string path = folder.path() + "page.html";
  const SceneRecording recording = circling(3, 2);
  recording.save(path);
  std::ifstream file(path, std::ios::binary);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(file), {}), recording.str());
  EXPECT_FALSE(std::ifstream(path + ".part").good());
  EXPECT_EQ(std::remove(path.c_str()), 0);
  try {
    recording.save("/no/such/folder/page.html");
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("/no/such/folder/page.html"), std::string::npos);
  }
}

TEST(Recording, TakesWhatIsHugeTinyAndComesAndGoes) {
  Scene scene;
  scene.add(Polygon::box(1e300, 1e300), poseAt(0, 0));
  scene.add(Polygon::box(1e-300, 1e-300).complement(), poseAt(0, 0));
  const Scene::Body goes = scene.add(Polygon::point({1e6, 0}), poseAt(0, 0));
  SceneRecording recording;
  recording.frame(-1e9, scene);
  scene.remove(goes);
  scene.add(Polygon::segment({0, 0}, {1, 1}), Pose(Eigen::Scaling(Vec2(-1, 1))), {0.5});
  recording.frame(1e9, scene, {});
  const std::string page = recording.str();
  EXPECT_NE(page.find("</html>"), std::string::npos);
}

}  // namespace
}  // namespace tricover
