// SPDX-License-Identifier: BSD-3-Clause
#include <geos/algorithm/distance/DiscreteHausdorffDistance.h>

#include <string>

#include "asked.h"
#include "rivals/geos.h"
#include "tricover/collide.h"
#include "tricover/contacts.h"
#include "tricover/depth.h"
#include "tricover/penetration.h"
#include "workloads.h"

namespace tricover::bench {
namespace {

using workloads::Kind;

constexpr int kRounds = 5;
constexpr std::size_t kPoses = 20;

std::vector<Pose> overlaps(const Polygon& fixed, const Polygon& moving, bool deep) {
  std::vector<Pose> poses;
  for (const Pose& pose :
       deep ? workloads::overlapPoses(fixed, moving, 3) : workloads::contactPoses(fixed, moving, 3)) {
    if (poses.size() == kPoses) break;
    if (collide(fixed, Pose::Identity(), moving, pose)) poses.push_back(pose);
  }
  return poses;
}

Result measured(Kind kind, std::size_t n, bool deep) {
  const Polygon fixed = workloads::makePolygon(kind, n, 1), moving = workloads::makePolygon(kind, n, 2);
  const std::vector<Pose> poses = overlaps(fixed, moving, deep);
  const Pose still = Pose::Identity();
  const auto region = geosRegion(fixed);
  GeosMoved moved(moving);
  std::vector<double> found(poses.size());
  const auto task = [&](const char* name, auto ask, Role role = Role::Ours) {
    return taskOf(name, role, found, [&, ask](std::size_t i) { return ask(poses[i]); });
  };
  std::vector<double> depths;
  for (const Pose& pose : poses) depths.push_back(depth(fixed, still, moving, pose).depth);
  const auto allowing = [&](const char* name, double share) {
    return taskOf(name, Role::Ours, found,
                  [&, share](std::size_t i) { return collide(fixed, still, moving, poses[i], {-share * depths[i]}); });
  };
  const auto askContacts = [&](ContactDetail detail) {
    return [&, detail](const Pose& pose) {
      ContactOptions options;
      options.detail = detail;
      return contacts(fixed, still, moving, pose, options).size();
    };
  };
  const std::vector<Task> tasks = {
      task("crossings", [&](const Pose& pose) { return crossings(fixed, still, moving, pose).size(); }),
      task("points", askContacts(ContactDetail::Points)),
      task("local depths", askContacts(ContactDetail::LocalDepth)),
      task("contacts", askContacts(ContactDetail::GlobalDepth)),
      task("depth", [&](const Pose& pose) { return depth(fixed, still, moving, pose).depth; }),
      allowing("a smaller overlap allowed", 0.5),
      allowing("a larger overlap allowed", 1.5),
      task("penetration", [&](const Pose& pose) { return penetration(fixed, still, moving, pose).has_value(); }),
      task(
          "GEOS overlay", [&](const Pose& pose) { return region->intersection(moved.at(pose))->getNumPoints(); },
          Role::Rival)};
  return measureInTurn({"detail", workloads::name(kind), deep ? "deep" : "shallow", n, n, poses.size()}, tasks,
                       kRounds);
}

/// The Hausdorff distance of two outlines, beside GEOS's of their boundaries, whose edges are cut into pieces of a
/// hundredth each.
Result measuredApart(std::size_t n) {
  const Polygon fixed = workloads::makePolygon(Kind::Contour, n, 1),
                moving = workloads::makePolygon(Kind::Contour, n, 2);
  const std::vector<Pose> poses = overlaps(fixed, moving, true);
  const auto region = geosRegion(fixed);
  const auto boundary = region->getBoundary();
  GeosMoved moved(moving);
  std::vector<double> found(poses.size());
  const std::vector<Task> tasks = {
      taskOf("tricover", Role::Ours, found,
             [&](std::size_t i) { return hausdorffDistance(fixed, Pose::Identity(), moving, poses[i]); }),
      taskOf("GEOS, densified by 0.01", Role::Rival, found, [&](std::size_t i) {
        using geos::algorithm::distance::DiscreteHausdorffDistance;
        return DiscreteHausdorffDistance::distance(*boundary, *moved.at(poses[i])->getBoundary(), 0.01);
      })};
  return measureInTurn({"excess", workloads::name(Kind::Contour), "Hausdorff distance", n, n, poses.size()}, tasks, 1);
}

}  // namespace

std::vector<Result> measureContactCosts() {
  std::vector<Result> results = {measured(Kind::Convex, 8, true), measured(Kind::Slim, 8, true)};
  for (const std::size_t n : {8u, 24u, 64u, 512u})
    for (const bool deep : {false, true}) results.push_back(measured(Kind::Contour, n, deep));
  for (const std::size_t n : {64u, 1024u}) results.push_back(measuredApart(n));
  return results;
}

}  // namespace tricover::bench
