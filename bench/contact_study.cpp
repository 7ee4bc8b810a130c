// SPDX-License-Identifier: BSD-3-Clause
#include "contact_study.h"

#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "rivals/box2d.h"
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

Result measureWalk(workloads::Kind kind, std::size_t vertices, bool slides, const Settings& settings) {
  const Polygon fixed = workloads::makePolygon(kind, vertices, 1), moving = workloads::makePolygon(kind, vertices, 2);
  const std::vector<Pose> poses = walk(fixed, moving, slides);
  std::vector<Contender> contenders;
  const auto add = [&](const char* name, Role role, auto isHit) {
    contenders.push_back({name, role, true, [=](const Sampling& sampling, Hits& hits) {
                            forEachSample(sampling, kSteps, [&](std::size_t i) {
                              if (isHit(i)) hits.push_back(static_cast<std::uint32_t>(i));
                            });
                          }});
  };
  add("cold", Role::Ours, [=](std::size_t i) { return !contacts(fixed, Pose::Identity(), moving, poses[i]).empty(); });
  const auto cache = std::make_shared<PairCache>();
  add("cached", Role::Ours,
      [=](std::size_t i) { return !contacts(fixed, Pose::Identity(), moving, poses[i], *cache).empty(); });
  if (box2dTakes(fixed) && box2dTakes(moving)) {
    const auto box2d = std::make_shared<Box2dManifold>(fixed, moving);
    box2d->prepare(poses);
    add("Box2D manifold", Role::Box2d, [=](std::size_t i) { return box2d->collide(i); });
  }
  const char* name = slides ? "sliding contact" : "resting contact";
  return measure({"contacts", workloads::name(kind), name, vertices, vertices, kSteps, 1}, contenders, settings);
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
