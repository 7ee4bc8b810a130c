// SPDX-License-Identifier: BSD-3-Clause
#include "collide_laws.h"

#include <vector>

#include "exact_depth.h"
#include "exact_reference.h"
#include "reproduction.h"
#include "stages.h"
#include "tricover/collide.h"
#include "tricover/prepare.h"
#include "tricover/scene.h"

namespace tricover::support {
namespace {

CollideOptions closed() { return {}; }
CollideOptions open() { return {0, 0, Touching::Allowed}; }

class Asking {
 public:
  Asking(const Case& c, const CollideOptions& options, const CollideTruth& truth)
      : c_(c), options_(options), truth_(truth) {}

  void cold(Strategy strategy, const std::string& way) {
    judge(collide(strategy, c_.a, c_.pose_a, c_.b, c_.pose_b, options_), way);
    judge(collide(strategy, c_.b, c_.pose_b, c_.a, c_.pose_a, options_), way + ", swapped");
  }
  void cached(Strategy strategy, StrategyCaches& caches, const std::string& way) {
    judge(collide(strategy, c_.a, c_.pose_a, c_.b, c_.pose_b, caches, options_), way);
    judge(collide(strategy, c_.b, c_.pose_b, c_.a, c_.pose_a, caches, options_), way + ", swapped");
  }
  const std::string& wrong() const { return wrong_; }

 private:
  void judge(bool answer, const std::string& way) {
    if (wrong_.empty() && (answer ? !truth_.may : truth_.must))
      wrong_ = "collide, " + way + ": " + std::to_string(answer) + ", margin " + hex(options_.margin) + ", tolerance " +
               hex(options_.tolerance);
  }

  const Case& c_;
  const CollideOptions& options_;
  const CollideTruth& truth_;
  std::string wrong_;
};

}  // namespace

std::string wrongCollide(const Case& c, const CollideOptions& options, const CollideTruth& truth, StrategyCaches& old,
                         Random& random) {
  const Case new_one{afresh(c.a), c.pose_a, afresh(c.b), c.pose_b};
  Asking asking(new_one, options, truth);
  for (const auto stages : {detail::Stages::Edges, detail::Stages::Hierarchy, detail::Stages::All}) {
    const UpTo these(stages);
    const std::string name = "up to stage " + std::to_string(static_cast<int>(stages));
    StrategyCaches fresh;
    asking.cold(Strategy::Hierarchy, name);
    asking.cached(Strategy::Hierarchy, fresh, name + ", with a cache");
  }
  for (const Strategy strategy : {Strategy::Hierarchy, Strategy::Paper}) {
    const std::string name = nameOf(strategy);
    asking.cold(strategy, name);
    asking.cached(strategy, old, name + ", cache of other pairs");
    StrategyCaches fresh;
    for (int i = 0; i < 3; ++i)
      collide(strategy, new_one.a, c.pose_a, new_one.b, elsewhere(random, c), fresh,
              random.coin() ? options : CollideOptions());
    asking.cached(strategy, fresh, name + ", cache of other poses");
  }
  // With the discs of those that don't meet, too.
  prepare(new_one.a), prepare(new_one.b);
  asking.cold(Strategy::Hierarchy, "prepared");
  return asking.wrong();
}

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
