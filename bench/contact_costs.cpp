// SPDX-License-Identifier: BSD-3-Clause
#include "contact_costs.h"

#include <functional>

#include "measure.h"
#include "rivals/geos_moved.h"
#include "rivals/geos_region.h"
#include "tricover/collide.h"
#include "tricover/contacts.h"
#include "tricover/penetration.h"
#include "workloads.h"

namespace tricover::bench {
namespace {

using workloads::Kind;

constexpr int kRounds = 5;
constexpr std::size_t kPoses = 20;

/// Overlapping poses, of which `wanted` says by the number of crossings whether they are asked.
std::vector<Pose> overlaps(const Polygon& fixed, const Polygon& moving, bool deep, bool (*wanted)(std::size_t count)) {
  std::vector<Pose> poses;
  for (const Pose& pose :
       deep ? workloads::overlapPoses(fixed, moving, 3) : workloads::contactPoses(fixed, moving, 3)) {
    if (poses.size() == kPoses) break;
    if (!collide(fixed, Pose::Identity(), moving, pose)) continue;
    if (wanted(crossings(fixed, Pose::Identity(), moving, pose).size())) poses.push_back(pose);
  }
  return poses;
}

ContactCost measured(const std::string& polygons, const std::string& name, const Polygon& fixed, const Polygon& moving,
                     const std::vector<Pose>& poses) {
  const auto region = geosRegion(fixed);
  GeosMoved moved(moving);
  const Pose still = Pose::Identity();
  std::size_t found = 0;  // so that nothing is left out
  const auto each = [&](auto ask) {
    return [&, ask] {
      for (const Pose& pose : poses) found += ask(pose);
    };
  };
  const std::vector<std::function<void()>> tasks = {
      each([&](const Pose& pose) { return crossings(fixed, still, moving, pose).size(); }),
      each([&](const Pose& pose) { return contacts(fixed, still, moving, pose).size(); }),
      each([&](const Pose& pose) { return std::size_t{penetration(fixed, still, moving, pose).has_value()}; }),
      each([&](const Pose& pose) { return region->intersection(moved.at(pose))->getNumPoints(); })};
  ContactCost cost{polygons, name, {}};
  for (const double seconds : secondsInTurn(tasks, kRounds, threadSeconds))
    cost.ns.push_back(1e9 * seconds / static_cast<double>(poses.size()));
  return cost;
}

const char *const kTwice = "crossing twice", *const kOften = "crossing more often";

}  // namespace

const std::vector<std::string>& contactQuestions() {
  static const std::vector<std::string> questions = {"crossings", "contacts", "penetration", "GEOS overlay"};
  return questions;
}

std::vector<ContactCost> measureContactCosts() {
  std::vector<ContactCost> costs;
  const auto measureAt = [&](Kind kind, std::size_t n, const char* poses, bool deep, bool (*wanted)(std::size_t)) {
    const Polygon fixed = workloads::makePolygon(kind, n, 1), moving = workloads::makePolygon(kind, n, 2);
    costs.push_back(measured(workloads::name(kind) + " " + std::to_string(n), poses, fixed, moving,
                             overlaps(fixed, moving, deep, wanted)));
  };
  for (const Kind kind : {Kind::Convex, Kind::Slim}) {
    measureAt(kind, 8, kTwice, true, [](std::size_t count) { return count == 2; });
    measureAt(kind, 8, kOften, true, [](std::size_t count) { return count > 2; });
  }
  for (const std::size_t n : {8u, 24u, 64u}) {
    measureAt(Kind::Contour, n, "shallow", false, [](std::size_t) { return true; });
    measureAt(Kind::Contour, n, "deep", true, [](std::size_t) { return true; });
  }
  return costs;
}

std::vector<Target> judgeContactCosts(const std::vector<ContactCost>& costs) {
  std::vector<Figure> figures;
  for (const ContactCost& twice : costs)
    for (const ContactCost& often : costs)
      if (twice.polygons == often.polygons && twice.poses == kTwice && often.poses == kOften)
        figures.push_back({often.ns[1] / twice.ns[1], often.polygons});
  return {judged("contacts of convex pairs", "crossing more often / crossing twice", figures, {false, 1.5})};
}

}  // namespace tricover::bench
