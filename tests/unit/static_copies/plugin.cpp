// SPDX-License-Identifier: BSD-3-Clause
#include <tricover/tricover.h>

#include <cstdio>

namespace {

using tricover::Polygon;
using tricover::Pose;

Polygon square(double half) { return Polygon({{{-half, -half}, {half, -half}, {half, half}, {-half, half}}}); }

Pose at(double x) {
  Pose pose = Pose::Identity();
  pose.translation().x() = x;
  return pose;
}

bool is_right = true;
void expect(bool answer, const char* what) {
  if (!answer) std::printf("%s is wrong\n", what);
  is_right = is_right && answer;
}

}  // namespace

/// The first polygon of this copy of tricover.
extern "C" __attribute__((visibility("default"))) const void* makeFirst(double half) {
  static const Polygon first = square(half);
  return &first;
}

/// Squares of half sides 0.5 and 2, of either copy, beside one of this copy that only the large square meets.
extern "C" __attribute__((visibility("default"))) bool askAboutBoth(const void* of_one, const void* of_other) {
  const Polygon &small = *static_cast<const Polygon*>(of_one), &large = *static_cast<const Polygon*>(of_other);
  expect(small.id() != large.id(), "an id");

  const Polygon beside = square(0.5);
  tricover::PairCache of_hits, of_distances;
  for (int i = 0; i < 3; ++i) {
    for (const bool is_large : {false, true}) {
      const Polygon& asked = is_large ? large : small;
      expect(tricover::collide(asked, at(0), beside, at(2), of_hits) == is_large, "collide with a cache");
      const double distance = tricover::distance(asked, at(0), beside, at(2), of_distances).distance;
      expect(distance == (is_large ? 0 : 1), "distance with a cache");
    }
  }

  tricover::Scene scene;
  scene.add(small, at(0));
  scene.add(large, at(10));
  for (const double x : {2.0, 12.0, 2.0}) {
    for (const bool is_large : {false, true}) {
      const bool is_hit = is_large || x == 12;
      expect(scene.collides(is_large ? large : small, at(x)) == is_hit, "a query of a scene");
    }
  }
  const auto body = scene.add(beside, at(2));
  expect(scene.collisions().empty(), "a scene without collisions");
  scene.move(body, at(12));
  expect(scene.collisions().size() == 1, "a collision of a scene");
  scene.move(body, at(2));
  expect(scene.collisions().empty(), "a scene without collisions again");
  return is_right;
}
