// SPDX-License-Identifier: BSD-3-Clause
#include "touching_laws.h"

#include <vector>

#include "collide_laws.h"
#include "exact_depth.h"
#include "exact_reference.h"
#include "tricover/collide.h"
#include "tricover/scene.h"

namespace tricover::support {
namespace {

CollideOptions closed() { return {}; }
CollideOptions open() { return {0, 0, Touching::Allowed}; }

}  // namespace

Overlap overlapOf(const Case& c) {
  return {exact::collide(c.a, c.pose_a, c.b, c.pose_b), exact::reachInto(c.a, c.pose_a, c.b, c.pose_b)};
}

std::string wrongTouching(const Case& c, const Overlap& truth, StrategyCaches& old, Random& random) {
  const std::string wrong = wrongCollide(c, open(), {truth.overlap, truth.overlap}, old, random);
  if (!wrong.empty()) return wrong;
  for (const Strategy strategy : {Strategy::Hierarchy, Strategy::Paper}) {
    StrategyCaches fresh;
    for (int i = 0; i < 3; ++i) {
      if (collide(strategy, c.a, c.pose_a, c.b, c.pose_b, fresh, open()) != truth.overlap)
        return "open, of a cache that saw it closed";
      if (collide(strategy, c.a, c.pose_a, c.b, c.pose_b, fresh, closed()) != truth.meet)
        return "closed, of a cache that saw it open";
    }
  }
  return {};
}

std::string wrongTouchingInScene(const Case& c, const Overlap& truth) {
  for (const Touching of_body : {Touching::Collides, Touching::Allowed}) {
    Scene scene;
    BodyOptions body;
    body.touching = of_body;
    const auto first = scene.add(c.a, c.pose_a, body);
    const bool closed_answer = of_body == Touching::Allowed ? truth.overlap : truth.meet;
    for (int i = 0; i < 3; ++i) {
      if (scene.collides(c.b, c.pose_b, open()) != truth.overlap) return "scene";
      if (scene.collides(c.b, c.pose_b) != closed_answer) return "scene, closed";
      if (scene.colliding(c.b, c.pose_b, open()).empty() == truth.overlap) return "colliding";
      if (scene.anyColliding(c.b, c.pose_b).has_value() != closed_answer) return "anyColliding, closed";
    }
    if (scene.collides(c.b, {c.pose_b, c.pose_b}, open()) != std::vector<bool>(2, truth.overlap)) return "many poses";
    const auto second = scene.add(c.b, c.pose_b);
    Pose aside = c.pose_a;
    aside.translation().x() += c.a.radius();
    if (!aside.translation().allFinite()) aside = c.pose_a;
    for (int i = 0; i < 3; ++i) {
      if (scene.collisions().empty() == closed_answer) return "frame " + std::to_string(i);
      scene.move(second, aside);
      if (i == 0) scene.collisions();
      scene.move(second, c.pose_b);
      scene.move(first, c.pose_a);
    }
  }
  return {};
}

}  // namespace tricover::support
