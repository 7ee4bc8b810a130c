// SPDX-License-Identifier: BSD-3-Clause
#include <string>

#include "asked.h"
#include "rivals/geos.h"
#include "tricover/collide.h"
#include "tricover/contacts.h"
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
  const auto region = geosRegion(fixed);
  GeosMoved moved(moving);
  const Pose still = Pose::Identity();
  std::vector<double> found(poses.size());
  const auto task = [&](const char* name, auto ask, Role role = Role::Ours) {
    return taskOf(name, role, found, [&, ask](std::size_t i) { return ask(poses[i]); });
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
      task("penetration", [&](const Pose& pose) { return penetration(fixed, still, moving, pose).has_value(); }),
      task(
          "GEOS overlay", [&](const Pose& pose) { return region->intersection(moved.at(pose))->getNumPoints(); },
          Role::Rival)};
  return measureInTurn({"detail", workloads::name(kind), deep ? "deep" : "shallow", n, n, poses.size()}, tasks,
                       kRounds);
}

}  // namespace

std::vector<Result> measureContactCosts() {
  std::vector<Result> results = {measured(Kind::Convex, 8, true), measured(Kind::Slim, 8, true)};
  for (const std::size_t n : {8u, 24u, 64u, 512u})
    for (const bool deep : {false, true}) results.push_back(measured(Kind::Contour, n, deep));
  return results;
}

}  // namespace tricover::bench
