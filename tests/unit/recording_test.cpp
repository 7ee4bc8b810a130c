// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/recording.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>

#include "own_folder.h"
#include "refusal.h"
#include "tricover/contacts.h"

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

/// Returns the text of a call's exception, and checks that the recording stays as it was.
template <typename Error, typename Call>
std::string refused(const SceneRecording& recording, const Call& call) {
  const std::string before = recording.str(), text = support::refusal<Error>(call);
  EXPECT_NE(text, "");
  EXPECT_EQ(recording.str(), before);
  return text;
}

TEST(Recording, RefusesWhatItCannotShowAndStaysAsItWas) {
  using Invalid = std::invalid_argument;
  using Unknown = std::out_of_range;
  const double nan = std::nan("");
  Scene scene, other;
  const Scene::Body one = scene.add(Polygon::box(1, 1), poseAt(0, 0));
  const Scene::Body two = scene.add(Polygon::box(1, 1), poseAt(3, 0));
  const Scene::Body gone = scene.add(Polygon::box(1, 1), poseAt(3, 0));
  scene.remove(gone);
  other.add(Polygon::box(2, 2), poseAt(0, 0));
  SceneRecording r;
  r.trajectories(scene, {{two, Trajectory(poseAt(3, 0))}});
  const Contact contact = contacts(Polygon::box(1, 1), poseAt(0, 0), Polygon::box(1, 1), poseAt(0.9, 0)).at(0);
  EXPECT_EQ(refused<Invalid>(r, [&] { r.contacts({contact}); }),
            "tricover: when: there is no frame yet; record a frame first, or give a time interval");
  r.frame(5, scene);
  EXPECT_EQ(refused<Invalid>(r, [&] { r.frame(5, scene); }),
            "tricover: time: it is not later than the last frame's; give frames times that increase");
  EXPECT_EQ(refused<Invalid>(r, [&] { r.frame(nan, scene); }), "tricover: time: it is not finite");
  EXPECT_EQ(refused<Invalid>(r, [&] { r.frame(6, other); }),
            "tricover: scene: body 0 has another polygon than before; record one scene a recording");
  EXPECT_EQ(refused<Invalid>(r, [&] { r.trajectories(other, {}); }),
            "tricover: scene: body 0 has another polygon than before; record one scene a recording");
  EXPECT_EQ(refused<Unknown>(r,
                             [&] {
                               r.frame(6, scene, {{one, gone}});
                             }),
            "tricover: meeting: body 2 is not recorded; give pairs of bodies of the scene");
  EXPECT_EQ(refused<Unknown>(r,
                             [&] {
                               r.trajectories(scene, {{gone, Trajectory(poseAt(0, 0))}});
                             }),
            "tricover: trajectories: body 2 is not recorded; give bodies of the scene");
  EXPECT_EQ(refused<Invalid>(r,
                             [&] {
                               r.trajectories(scene, {{two, Trajectory(poseAt(0, 0))}});
                             }),
            "tricover: trajectories: body 1 has a trajectory already; join them to one");
  EXPECT_EQ(refused<Unknown>(r, [&] { r.name(gone, "gone"); }),
            "tricover: body: body 2 is not recorded; record a frame or a trajectory of it first");
  Contact bad = contact;
  bad.depth = nan;
  EXPECT_EQ(refused<Invalid>(r, [&] { r.contacts({contact, bad}); }), "tricover: length: it is not finite");
  EXPECT_EQ(refused<Invalid>(r,
                             [&] {
                               r.text({0, 0}, "text", TimeInterval{2, 1});
                             }),
            "tricover: when.end: it is before when.begin");
  PairImpact impact{{one, two}, {1, {0, 0}, {1, 0}, 0, 0}};
  PairConflict conflict{{one, two}, {impact.impact, 0.5, false}};
  EXPECT_EQ(refused<Invalid>(r, [&] { r.conflicts({conflict}); }), "tricover: conflicts.end: it is before impact.time");
  conflict.pair.second = impact.pair.second = gone;
  refused<Unknown>(r, [&] { r.conflicts({conflict}); });
  refused<Unknown>(r, [&] { r.impacts({impact}); });
  impact.pair.second = two;
  impact.impact.time = nan;
  EXPECT_EQ(refused<Invalid>(r, [&] { r.impacts({impact}); }), "tricover: impacts.time: it is not finite");
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
