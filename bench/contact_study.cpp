// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "methods.h"
#include "rivals/box2d.h"
#include "studies.h"
#include "tricover/collide.h"
#include "tricover/contacts.h"
#include "tricover/penetration.h"
#include "workloads.h"

namespace tricover::bench {
namespace {

constexpr std::size_t kSteps = 100;
/// Of polygons of 100 units: how deep the body sinks in where it begins, and how far a step takes it.
constexpr double kDepth = 0.2, kStep = 0.1;

/// From a pose where they overlap by `kDepth`, to and fro by less than a thousandth of a step, or on along the surface.
std::vector<Pose> walk(const Polygon& fixed, const Polygon& moving, bool slides) {
  for (Pose pose : workloads::contactPoses(fixed, moving, 7)) {
    const auto deep = penetration(fixed, Pose::Identity(), moving, pose);
    if (!deep || !(deep->depth > 2 * kDepth)) continue;
    pose.translation() += (1 - kDepth / deep->depth) * deep->translation;
    const Vec2 along(-deep->normal.y(), deep->normal.x());
    std::vector<Pose> poses(kSteps, pose);
    bool overlaps = true;
    for (std::size_t i = 0; i < kSteps; ++i) {
      const auto step = static_cast<double>(i);
      poses[i].translation() += kStep * (slides ? step : 1e-3 * std::sin(step)) * along;
      overlaps = overlaps && collide(fixed, Pose::Identity(), moving, poses[i]);
    }
    if (overlaps) return poses;
  }
  throw std::runtime_error("contact study: no pose found");
}

class Core {
 public:
  Core(Polygon fixed, Polygon moving, bool cached)
      : fixed_(std::move(fixed)), moving_(std::move(moving)), cached_(cached) {}
  void prepare(const std::vector<Pose>& poses) { poses_ = poses.data(); }
  bool collide(std::size_t i) {
    return !(cached_ ? contacts(fixed_, Pose::Identity(), moving_, poses_[i], cache_)
                     : contacts(fixed_, Pose::Identity(), moving_, poses_[i]))
                .empty();
  }

 private:
  Polygon fixed_, moving_;
  bool cached_;
  PairCache cache_;
  const Pose* poses_ = nullptr;
};

Result measureWalk(workloads::Kind kind, std::size_t vertices, bool slides, const Settings& settings) {
  const Polygon fixed = workloads::makePolygon(kind, vertices, 1), moving = workloads::makePolygon(kind, vertices, 2);
  MethodTable<Hits> table;
  table.add("cold", Role::Ours, true, std::make_shared<Core>(fixed, moving, false));
  table.add("cached", Role::Ours, true, std::make_shared<Core>(fixed, moving, true));
  if (box2dTakes(fixed) && box2dTakes(moving))
    table.add("Box2D manifold", Role::Box2d, true, std::make_shared<Box2dManifold>(fixed, moving));
  const std::vector<Pose> poses = walk(fixed, moving, slides);
  const char* name = slides ? "sliding contact" : "resting contact";
  return measure({"contacts", workloads::name(kind), name, vertices, vertices, kSteps, 1}, table.on(poses), settings);
}

}  // namespace

std::vector<Result> measureContacts(const Settings& settings) {
  std::vector<Result> results;
  for (const auto& [kind, vertices] : {std::pair(workloads::Kind::Convex, std::size_t{8}),
                                       {workloads::Kind::Convex, 64},
                                       {workloads::Kind::Contour, 64}})
    for (const bool slides : {false, true}) results.push_back(measureWalk(kind, vertices, slides, settings));
  return results;
}

}  // namespace tricover::bench
